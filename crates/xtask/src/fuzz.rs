//! The fuzzing of what reads users' text, guided by coverage.
//!
//! The fuzzer is LLVM's, linked by the crate `libfuzzer-sys`. The counters that guide it are put in by a pass of LLVM, which
//! the stable compiler runs when it is named; nothing here needs a nightly one.

use crate::command_line::CommandLine;
use crate::failure::{Failure, Status};
use crate::programs::find_program;
use crate::steps::Steps;
use crate::workspace::Workspace;

/// The targets: the programs of the package in `fuzz`.
const TARGETS: [&str; 4] = ["scene", "spectrum", "points", "variant"];

const FLAGS: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
                     -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
                     -Cllvm-args=-sanitizer-coverage-trace-compares";

/// The only machine for which it is set up.
const TRIPLE: &str = "x86_64-unknown-linux-gnu";

/// Builds the targets and runs each, from the committed corpus, for a number of seconds. What is found that way is kept
/// below the build folder; an input that fails is written beside it.
///
/// # Errors
///
/// A target fails or takes more than 10 seconds or 2 GiB for an input, or there is no C++ compiler for the fuzzer.
pub fn run(workspace: &Workspace, seconds: u32) -> Result<(), Failure> {
    if find_program("c++").is_none() {
        return Err(Failure::missing(
            "the fuzzer is compiled by `c++`, which is not in PATH; install g++ or clang".to_owned(),
        ));
    }
    let folder = workspace.target.join("fuzz");
    let mut steps = Steps::default();
    let build = ["build", "--release", "--manifest-path", "fuzz/Cargo.toml", "--target", TRIPLE];
    // Without a target the counters would go into build scripts too.
    let build = workspace.cargo(&build).environment("RUSTFLAGS", FLAGS);
    steps.run(workspace, "build of the fuzzer", &build, |_| Status::CheckFailed)?;
    for target in TARGETS {
        let found = folder.join(target);
        std::fs::create_dir_all(&found)
            .map_err(|error| Failure::bad_input(format!("{} cannot be made: {error}", found.display())))?;
        let program = workspace.target.join(TRIPLE).join("release").join(target);
        let fuzz = CommandLine::new(&program)
            .shown_as(workspace.relative(&program).to_string_lossy())
            .arguments([found.as_os_str()])
            .arguments([format!("fuzz/corpus/{target}")])
            .arguments([format!("-max_total_time={seconds}"), format!("-artifact_prefix={}/", folder.display())])
            .arguments(["-timeout=10", "-rss_limit_mb=2048", "-max_len=4096", "-print_final_stats=1"]);
        steps.run(workspace, target, &fuzz, |_| Status::CheckFailed)?;
    }
    crate::console::say(&format!("\n{}", steps.table()));
    Ok(())
}
