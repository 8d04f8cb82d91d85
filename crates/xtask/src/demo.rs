//! Builds the command and runs it on a scene.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use crate::command_line::CommandLine;
use crate::console::say;
use crate::failure::{Failure, Status};
use crate::steps::Steps;
use crate::workspace::Workspace;

/// The scene that a person names, or the one that the demo has where none is named.
///
/// A path is relative to the current folder; a bare name may also be that of a scene in `templates/scenes`.
///
/// # Errors
///
/// There is no such scene.
pub fn find_scene(workspace: &Workspace, named: Option<&OsStr>) -> Result<PathBuf, Failure> {
    let templates = workspace.root.join("templates/scenes");
    let named = named.unwrap_or(OsStr::new(DEFAULT_SCENE));
    let template = templates.join(named).with_extension("toml");
    if Path::new(named).components().count() == 1 && template.is_file() {
        return Ok(template);
    }
    match std::path::absolute(named) {
        Ok(path) if path.is_file() => Ok(path),
        _ => Err(Failure::bad_input(format!(
            "there is no scene `{}`: name a scene file, or one of {}",
            named.to_string_lossy(),
            scene_names(&templates).join(", "),
        ))),
    }
}

/// Builds the command in release, and builds and previews the scene with it.
///
/// # Errors
///
/// A step fails. The exit codes of the command itself are passed on.
pub fn run(workspace: &Workspace, scene: &Path) -> Result<(), Failure> {
    let name = scene.file_stem().unwrap_or(OsStr::new(DEFAULT_SCENE));
    let output = workspace.target.join("demo").join(name);
    let preview = output.join("sphere.png");
    let program = workspace.target.join("release").join(format!("pavo{}", std::env::consts::EXE_SUFFIX));

    let scene = workspace.relative(scene).as_os_str();
    let pavo = |subcommand: &str, output: &Path| {
        CommandLine::new(&program).shown_as(workspace.relative(&program).to_string_lossy()).arguments([
            OsStr::new(subcommand),
            scene,
            OsStr::new("-o"),
            workspace.relative(output).as_os_str(),
        ])
    };
    let mut steps = Steps::default();
    let compile = workspace.cargo(&["build", "--release", "--package", "pavo"]);
    steps.run(workspace, "compile the command", &compile, |_| Status::CheckFailed)?;
    steps.run(workspace, "build the scene", &pavo("build", &output), Status::of_product)?;
    steps.run(workspace, "preview the scene", &pavo("preview", &preview), Status::of_product)?;

    say(&format!("\n{}", steps.table()));
    say(&format!("\nThe results are in {}:", output.display()));
    for file in file_names(&output) {
        say(&format!("  {file}"));
    }
    Ok(())
}

const DEFAULT_SCENE: &str = "soap-bubble";

/// The names of the scenes in a folder, in alphabetical order.
fn scene_names(folder: &Path) -> Vec<String> {
    file_names(folder).iter().filter_map(|file| file.strip_suffix(".toml")).map(str::to_owned).collect()
}

/// The names of what is in a folder, in alphabetical order. Empty where the folder cannot be read.
fn file_names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .map(|entries| entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect())
        .unwrap_or_default();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_a_file_or_the_name_of_a_template() {
        let workspace = Workspace::of_this_tool().expect("the workspace is found");
        let templates = workspace.root.join("templates/scenes");
        let bubble = templates.join("soap-bubble.toml");
        for (named, expected) in [
            (None, bubble.clone()),
            (Some(OsStr::new("soap-bubble")), bubble.clone()),
            (Some(OsStr::new("soap-bubble.toml")), bubble.clone()),
            (Some(bubble.as_os_str()), bubble.clone()),
            (Some(OsStr::new("oil-on-water")), templates.join("oil-on-water.toml")),
        ] {
            assert_eq!(find_scene(&workspace, named), Ok(expected), "{named:?}");
        }
    }

    #[test]
    fn an_unknown_scene_is_refused_with_the_names_of_the_templates() {
        let workspace = Workspace::of_this_tool().expect("the workspace is found");
        for named in ["soap-bubbel", "no/such/scene.toml", "", "."] {
            let failure = find_scene(&workspace, Some(OsStr::new(named))).expect_err(named);
            assert_eq!(failure.status, Status::BadInput);
            assert!(failure.message.contains(&format!("no scene `{named}`")), "{}", failure.message);
            for name in ["oil-on-water", "soap-bubble"] {
                assert!(failure.message.contains(&format!(", {name}")), "{}", failure.message);
            }
        }
    }
}
