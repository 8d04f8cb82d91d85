//! The clients that are packages of Python.

use std::path::Path;

use crate::command_line::CommandLine;
use crate::console::complain;
use crate::failure::{Failure, Status};
use crate::measuring::ended;
use crate::programs::find_program;
use crate::workspace::Workspace;

/// A command, and what kind of failure its exit code stands for.
type Step = (CommandLine, fn(Option<i32>) -> Status);

/// A client in Python.
pub struct Client {
    /// Its name, and that of its script in `clients`.
    pub name: &'static str,
    /// The packages of PyPI, at the versions that the export was made for.
    packages: &'static [&'static str],
    /// The programs that it needs: that of Python, and what stands before it on the command line.
    programs: &'static [(&'static str, &'static str)],
    /// What stands before Python on the command line.
    before: &'static [&'static str],
}

/// The clients in Python.
pub const CLIENTS: [Client; 2] = [
    Client {
        name: "materialx",
        packages: &["MaterialX==1.39.5"],
        programs: &[("python3", "python3-venv"), ("xvfb-run", "xvfb"), ("glslangValidator", "glslang-tools")],
        before: &["xvfb-run", "-a"],
    },
    Client {
        name: "blender",
        packages: &["bpy==5.0.1"],
        // The package is for this version of Python alone.
        programs: &[("python3.11", "python3.11-venv")],
        before: &[],
    },
];

/// Installs the packages into an environment of their own below `target/clients`, builds the command, and has the
/// client render its export.
///
/// # Errors
///
/// A program is missing, a package cannot be installed, or the client does not agree with the CPU evaluation.
pub fn run(workspace: &Workspace, client: &Client, json: bool) -> Result<(), Failure> {
    let Client { name, packages, programs, before } = client;
    for (program, package) in *programs {
        if find_program(program).is_none() {
            return Err(Failure::missing(format!(
                "{program} is needed to run the client {name}, and is not here; on Debian, `apt-get install {package}` \
                 brings it. Nothing was rendered"
            )));
        }
    }
    let folder = workspace.target.join("clients");
    let environment = folder.join(format!("python-{name}"));
    let python = environment.join("bin/python");
    let make = CommandLine::new(programs[0].0).arguments(["-m", "venv"]).arguments([workspace.relative(&environment)]);
    let install = CommandLine::new(&python)
        .arguments(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
        .arguments(*packages);
    let build = workspace.cargo(&["build", "--quiet", "--package", "pavo"]);
    let steps: [Step; 3] =
        [(make, |_| Status::Missing), (install, |_| Status::Missing), (build, |_| Status::CheckFailed)];
    for (command, status) in steps {
        complain(&format!("$ {command}"));
        ended(&command, command.run_aside(workspace)?, status)?;
    }
    let pavo = workspace.target.join("debug").join(format!("pavo{}", std::env::consts::EXE_SUFFIX));
    let script = Path::new("clients").join(format!("{name}.py"));
    let render = match before {
        [] => CommandLine::new(&python),
        [first, rest @ ..] => CommandLine::new(first).arguments(rest.iter().copied()).arguments([&python]),
    };
    let render = render
        .arguments([script.as_path(), Path::new("--pavo"), &pavo, Path::new("--folder"), &folder])
        .arguments(json.then_some("--json"));
    complain(&format!("$ {render}"));
    ended(&render, render.run(workspace)?, Status::of_product)
}
