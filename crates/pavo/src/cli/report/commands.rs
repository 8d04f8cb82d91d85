//! The commands that give again what a report says.

use super::figures::Command;
use super::worst;
use crate::cli::command_line::quoted;
use std::path::Path;

/// The commands for a scene's file and the variant that its report is about. `ran` says whether the shaders were run, and
/// `is_renderable` whether lavapipe renders the variant's sphere. The last command is that for the worst points.
pub fn commands(path: &Path, variant: &str, max_delta_e: Option<f64>, ran: bool, is_renderable: bool) -> Vec<Command> {
    let scene = quoted(path);
    let budget = max_delta_e.map(|limit| format!(" --max-delta-e {limit}")).unwrap_or_default();
    let no_run = if ran { "" } else { " --no-run" };
    let mut commands = vec![
        Command { gives: "this report", command: format!("pavo report {scene}{budget}{no_run} -o report") },
        Command { gives: "the table and the pick", command: format!("pavo tune {scene}{budget} --all") },
        Command { gives: "the cycles on navi21", command: format!("pavo tune {scene}{budget} --cost navi21 --all") },
        Command { gives: "the times on lavapipe", command: format!("pavo tune {scene}{budget} --cost lavapipe --all") },
        Command {
            gives: "the code in a folder, judged, run and compared",
            command: format!("pavo build {scene} --variant {variant}"),
        },
    ];
    if is_renderable {
        let command = format!("pavo preview {scene} --variant {variant} -o sphere.png");
        commands.push(Command { gives: "the sphere", command });
    }
    commands.push(Command {
        gives: "the worst points by the variant, compared with the exact colours",
        command: format!("pavo eval {scene} --points {} --on cpu-f64 --variant {variant}", worst::FILE),
    });
    commands
}
