//! Builds and runs the examples: what each needs, and the commands that run it, as data.

use std::ffi::OsStr;
use std::path::Path;

use crate::command_line::CommandLine;
use crate::console::{list_text, say};
use crate::failure::{Failure, Status};
use crate::steps::Steps;
use crate::workspace::Workspace;

/// An example in the folder `examples`.
struct Example {
    name: &'static str,
    /// What of it is seen.
    shows: &'static str,
    /// A script in its folder, or nothing for `cargo run` there.
    script: Option<&'static str>,
    /// The picture that it draws in its folder.
    picture: Option<&'static str>,
    /// Whether it only runs where it is named: it takes many minutes to compile.
    only_by_name: bool,
}

const EXAMPLES: [Example; 5] = [
    Example {
        name: "own-brdf",
        shows: "a BRDF written in the DSL, judged and run",
        script: None,
        picture: None,
        only_by_name: false,
    },
    Example {
        name: "cpp-engine",
        shows: "emitted GLSL in a C++ program",
        script: Some("run.sh"),
        picture: None,
        only_by_name: false,
    },
    Example {
        name: "wgpu-bubble",
        shows: "a soap bubble with wgpu, checked against the CPU: bubble.png",
        script: None,
        picture: Some("bubble.png"),
        only_by_name: false,
    },
    Example {
        name: "naga-oil",
        shows: "a Bevy material composed by naga_oil",
        script: None,
        picture: None,
        only_by_name: false,
    },
    Example {
        name: "bevy-film",
        shows: "the same material in Bevy: film.png",
        script: None,
        picture: Some("film.png"),
        only_by_name: true,
    },
];

/// Whether there is such an example.
///
/// # Errors
///
/// There is none of this name.
pub fn check_name(name: Option<&OsStr>) -> Result<(), Failure> {
    match name {
        Some(name) if EXAMPLES.iter().all(|example| example.name != name) => Err(Failure::bad_input(format!(
            "there is no example `{}`; the examples are {}",
            name.to_string_lossy(),
            list_text(EXAMPLES.iter().map(|example| example.name)),
        ))),
        _ => Ok(()),
    }
}

/// Builds and runs an example, or all that do not take many minutes.
///
/// # Errors
///
/// An example fails: its exit codes are those of the command `pavo`.
pub fn run(workspace: &Workspace, name: Option<&OsStr>) -> Result<(), Failure> {
    let mut steps = Steps::default();
    let chosen = EXAMPLES.iter().filter(|example| name.map_or(!example.only_by_name, |name| example.name == name));
    let result = chosen.into_iter().try_for_each(|example| {
        say(&format!("\n{}: {}", example.name, example.shows));
        steps.run(workspace, example.name, &command(workspace, example), Status::of_product)
    });
    say(&format!("\n{}", steps.table()));
    for example in EXAMPLES.iter().filter(|example| name.is_none() && example.only_by_name) {
        say(&format!(
            "NOT run: {}, which takes minutes to compile: cargo xtask examples {}",
            example.name, example.name
        ));
    }
    result
}

fn command(workspace: &Workspace, example: &Example) -> CommandLine {
    let folder = Path::new("examples").join(example.name);
    match example.script {
        Some(script) => CommandLine::new("bash").arguments([folder.join(script)]),
        None => {
            let picture = example.picture.map(|picture| folder.join(picture));
            let run = workspace.cargo(&["run", "--quiet", "--manifest-path"]).arguments([folder.join("Cargo.toml")]);
            run.arguments(picture.is_some().then_some("--")).arguments(picture)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_example_has_its_folder_with_a_readme_and_each_folder_is_an_example() {
        let workspace = Workspace::of_this_tool().expect("the workspace is found");
        let entries = std::fs::read_dir(workspace.root.join("examples")).expect("the folder can be read");
        let mut folders: Vec<String> =
            entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        folders.sort();
        let mut names = EXAMPLES.map(|example| example.name);
        names.sort_unstable();
        assert_eq!(folders, names);
        for name in names {
            assert!(workspace.root.join("examples").join(name).join("README.md").is_file(), "{name}");
        }
    }

    #[test]
    fn an_unknown_example_is_refused_with_the_names_of_all() {
        let failure = check_name(Some(OsStr::new("unity"))).expect_err("there is none");
        assert!(failure.message.contains("no example `unity`") && failure.message.contains("wgpu-bubble"));
        assert_eq!(check_name(Some(OsStr::new("own-brdf"))), Ok(()));
    }
}
