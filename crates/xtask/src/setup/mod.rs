//! Installs what the workspace needs from the system and does not find there.

mod authority;
mod package_manager;
mod plan;
mod probe;
mod requirement;

use std::time::Instant;

use crate::command_line::{CommandLine, end_text};
use crate::console::{complain, duration_text, list_text, say};
use crate::failure::Failure;
use crate::programs::find_program;
use crate::workspace::Workspace;
use authority::Authority;
use package_manager::PACKAGE_MANAGERS;
use plan::{Plan, plan};
use requirement::{OF_EXAMPLES, REQUIREMENTS, Requirement};

/// Looks for what is needed and installs what is missing, having said what it is going to run.
///
/// # Errors
///
/// Something is missing, and it cannot be installed: this system has no `apt-get`, or this user may not install, or
/// the installation fails.
pub fn set_up(workspace: &Workspace) -> Result<(), Failure> {
    provide(workspace, &REQUIREMENTS.each_ref())
}

/// The same with what the examples need beside.
///
/// # Errors
///
/// As [`set_up`].
pub fn set_up_examples(workspace: &Workspace) -> Result<(), Failure> {
    provide(workspace, &REQUIREMENTS.iter().chain(&OF_EXAMPLES).collect::<Vec<_>>())
}

fn provide(workspace: &Workspace, needed: &[&'static Requirement]) -> Result<(), Failure> {
    let missing = missing_of(needed);
    if missing.is_empty() {
        say(&format!("Nothing to install: {} are here.", names(needed)));
        return Ok(());
    }
    let manager = PACKAGE_MANAGERS.iter().find(|manager| find_program(manager.program).is_some());
    match plan(&missing, manager, Authority::of_this_user(workspace)) {
        Plan::Advise(advice) => Err(Failure::missing(format!("missing: {}\n{advice}", names(&missing)))),
        Plan::Install(commands) => {
            say(&format!("Missing: {}.\nGoing to run:", names(&missing)));
            commands.iter().for_each(|command| say(&format!("  {command}")));
            install(workspace, &commands)?;
            let missing = missing_of(needed);
            if missing.is_empty() {
                return Ok(());
            }
            Err(Failure::missing(format!(
                "the packages are installed, but {} cannot be found all the same; look at PATH and at the packages' \
                 files",
                names(&missing)
            )))
        }
    }
}

/// Runs the commands, of which only the last must succeed: fetching the package lists also fails for one broken
/// source among many, and the lists that are there may well do.
fn install(workspace: &Workspace, commands: &[CommandLine]) -> Result<(), Failure> {
    let Some((last, before)) = commands.split_last() else { return Ok(()) };
    for command in before {
        say(&format!("\n$ {command}"));
        let status = command.run(workspace)?;
        if !status.success() {
            complain(&format!(
                "warning: `{command}` failed ({}): the package lists could not all be fetched; going on with those \
                 that are here",
                end_text(status)
            ));
        }
    }
    say(&format!("\n$ {last}"));
    let start = Instant::now();
    let status = last.run(workspace)?;
    if status.success() {
        say(&format!("Installed, {}.", duration_text(start.elapsed())));
        return Ok(());
    }
    Err(Failure::missing(format!(
        "the packages could not be installed ({}).\nIf apt-get says above that it cannot fetch, resolve or locate \
         something, it does not reach its servers: check the network, and the proxy if there is one (http_proxy), then \
         run this again. On Ubuntu the packages are in the component `universe`.",
        end_text(status)
    )))
}

fn missing_of(needed: &[&'static Requirement]) -> Vec<&'static Requirement> {
    needed.iter().copied().filter(|requirement| !probe::is_here(requirement.sign)).collect()
}

fn names(requirements: &[&Requirement]) -> String {
    list_text(requirements.iter().map(|requirement| requirement.name))
}
