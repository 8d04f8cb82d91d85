//! Installs the engines that pavo exports for, and runs the exports in them.

mod script;

use std::ffi::OsString;
use std::path::Path;

use crate::command_line::CommandLine;
use crate::console::complain;
use crate::failure::{Failure, Status};
use crate::measuring::ended;
use crate::programs::find_program;
use crate::workspace::Workspace;
use script::CLIENTS;

/// The packages of npm, at the versions that the exports were made for.
const PACKAGES: [&str; 4] = ["three@0.187", "@babylonjs/core@9.34", "playcanvas@2.23", "playwright-core@1"];

/// Installs what is asked for and runs it: the clients of the web where none is named, and those with a script by name.
///
/// # Errors
///
/// What [`in_browser`] and [`script::run`] say.
pub fn run(workspace: &Workspace, names: &[OsString], json: bool) -> Result<(), Failure> {
    let (by_script, by_browser): (Vec<OsString>, Vec<OsString>) =
        names.iter().cloned().partition(|name| CLIENTS.iter().any(|client| name == client.name));
    if names.is_empty() || !by_browser.is_empty() {
        in_browser(workspace, &by_browser, json)?;
    }
    for client in CLIENTS.iter().filter(|client| by_script.iter().any(|name| name == client.name)) {
        script::run(workspace, client, json)?;
    }
    Ok(())
}

/// Installs the engines into `target/clients`, builds the command, and has each client render its export on each
/// device: all of them, or those named. Screenshots are left beside the engines.
///
/// # Errors
///
/// npm, node, Chromium or a driver is missing, a package cannot be installed, or a client does not agree with the CPU
/// evaluation.
fn in_browser(workspace: &Workspace, names: &[OsString], json: bool) -> Result<(), Failure> {
    for program in ["npm", "node"] {
        if find_program(program).is_none() {
            return Err(Failure::missing(format!(
                "{program} is needed to run the clients, and is not here; on Debian and Ubuntu, \
                 `apt-get install npm` brings it. Nothing was rendered"
            )));
        }
    }
    let folder = workspace.target.join("clients");
    let shown = workspace.relative(&folder);
    let install = CommandLine::new("npm")
        .arguments(["install", "--no-audit", "--no-fund", "--loglevel=error", "--prefix"])
        .arguments([shown])
        .arguments(PACKAGES);
    let build = workspace.cargo(&["build", "--quiet", "--package", "pavo"]);
    let pavo = workspace.target.join("debug").join(format!("pavo{}", std::env::consts::EXE_SUFFIX));
    let render = CommandLine::new("node")
        .arguments([Path::new("clients/run.mjs"), Path::new("--packages"), shown, Path::new("--pavo"), &pavo])
        .arguments(json.then_some("--json"))
        .arguments(names);
    complain(&format!("$ {install}"));
    ended(&install, install.run_aside(workspace)?, |_| Status::Missing)?;
    complain(&format!("$ {build}"));
    ended(&build, build.run_aside(workspace)?, |_| Status::CheckFailed)?;
    complain(&format!("$ {render}"));
    ended(&render, render.run(workspace)?, Status::of_product)
}
