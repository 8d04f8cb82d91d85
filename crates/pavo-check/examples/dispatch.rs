//! Runs a compute kernel on lavapipe at points of a file, and prints three numbers for each.
//!
//! Usage: `dispatch KERNEL.spv ENTRY POINTS`. The kernel is one of [`pavo_check::ComputeShader`] with a workgroup size
//! of 64; the file of points has a point on each line, its numbers divided by spaces. spirv-val judges the kernel first.
//! Exit codes are those of the command `pavo`.

use pavo_check::{CheckError, ComputeShader, Device, judge_spirv};
use std::process::ExitCode;

const USAGE: &str = "usage: dispatch KERNEL.spv ENTRY POINTS";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match dispatched(&arguments) {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            let code = match error {
                CheckError::Input(_) => 2,
                CheckError::Missing { .. } => 3,
                _ => 1,
            };
            say(&error);
            ExitCode::from(code)
        }
    }
}

#[allow(clippy::print_stderr)]
fn say(error: &CheckError) {
    eprintln!("error: {error}");
}

fn dispatched(arguments: &[String]) -> Result<String, CheckError> {
    let [kernel, entry, points] = arguments else { return Err(CheckError::Input(USAGE.to_owned())) };
    let unreadable = |file: &str, why: &dyn std::fmt::Display| CheckError::Input(format!("{file}: {why}"));
    let bytes = std::fs::read(kernel).map_err(|error| unreadable(kernel, &error))?;
    let words: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap_or_default())).collect();
    let text = std::fs::read_to_string(points).map_err(|error| unreadable(points, &error))?;
    let rows: Vec<Vec<f32>> = text
        .lines()
        .map(|line| line.split_whitespace().map(str::parse).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()
        .map_err(|error: std::num::ParseFloatError| unreadable(points, &error))?;
    let width = rows.first().map_or(0, Vec::len);
    if width == 0 || rows.iter().any(|row| row.len() != width) {
        return Err(unreadable(points, &"each line has the same count of numbers, one at least"));
    }
    judge_spirv(kernel, &words)?;
    let shader = ComputeShader { spirv: &words, entry, workgroup_size: 64, tables: &[] };
    let colors = Device::lavapipe()?.evaluate(&shader, &rows.concat(), width, 3)?;
    let line = |color: &[f32]| format!("{} {} {}\n", color[0], color[1], color[2]);
    Ok(colors.chunks_exact(3).map(line).collect())
}
