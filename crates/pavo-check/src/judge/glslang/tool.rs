//! The system's `glslangValidator`, started as a process.

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use tempfile::TempDir;

use super::{Answer, Stage, Task};
use crate::CheckError;
use crate::install::GLSLANG;
use crate::judge::spirv::words_of_bytes;

/// The names of the program, the older one first: later releases call it `glslang` and keep the old name as a link.
const PROGRAMS: [&str; 2] = ["glslangValidator", "glslang"];

/// Settings of the GNU C library for the tool's memory: large pages, and memory from the system in large pieces.
/// glslang builds a symbol table of 40 MB before it reads a GLSL 4.50 text, and a third of that time goes into
/// getting the memory. Other C libraries do not read this.
const MEMORY_TUNABLES: &str = "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=33554432";

/// A process that was started, and the folder with its input and output.
pub(super) struct Pending {
    process: Child,
    folder: TempDir,
    task: Task,
}

/// Writes the text to a folder of its own and starts the tool on it.
pub(super) fn start(text: &str, stage: Stage, task: Task) -> Result<Pending, CheckError> {
    let folder = tempfile::tempdir().map_err(|error| failed(format!("cannot make a temporary folder: {error}")))?;
    let stage_name = match stage {
        Stage::Vertex => "vert",
        Stage::Fragment => "frag",
        Stage::Compute => "comp",
    };
    let input = folder.path().join(format!("shader.{stage_name}"));
    std::fs::File::create(&input)
        .and_then(|mut file| file.write_all(text.as_bytes()))
        .map_err(|error| failed(format!("cannot write {}: {error}", input.display())))?;

    let mut arguments: Vec<&str> = vec!["-v", "-S", stage_name];
    let output = spirv_path(&folder);
    let output = output.to_string_lossy();
    let read_as_version;
    match task {
        Task::Classic => arguments.push("-l"),
        Task::Hlsl { keep_uncalled } => {
            arguments.extend(["-D", "-e", "main", "-V", "--target-env", "vulkan1.1", "-o", &output]);
            if keep_uncalled {
                arguments.push("--keep-uncalled");
            }
        }
        Task::Vulkan { keep_uncalled, read_as } => {
            arguments.extend(["-V", "--target-env", "vulkan1.1", "-o", &output]);
            if keep_uncalled {
                arguments.push("--keep-uncalled");
            }
            if let Some(version) = read_as {
                read_as_version = version.to_string();
                arguments.extend(["--glsl-version", &read_as_version]);
            }
        }
    }
    let process = spawn(&arguments, Some(&input))?;
    Ok(Pending { process, folder, task })
}

impl Pending {
    /// Waits for the tool to end and reads what it wrote.
    pub fn finish(self) -> Result<Answer, CheckError> {
        let output =
            self.process.wait_with_output().map_err(|error| failed(format!("cannot read its output: {error}")))?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        // The tool tells a refusal (2 in compiling, 3 in linking) from a wrong command line or a crash.
        let passed = match output.status.code() {
            Some(0) => true,
            Some(2 | 3) => false,
            _ => {
                let errors = String::from_utf8_lossy(&output.stderr);
                return Err(failed(format!("ended with {}: {}", output.status, format!("{printed}{errors}").trim())));
            }
        };
        let spirv = match self.task {
            Task::Vulkan { .. } | Task::Hlsl { .. } if passed => Some(read_spirv(&spirv_path(&self.folder))?),
            _ => None,
        };
        Ok(Answer { passed, version: version_in(&printed).unwrap_or_default(), log: printed, spirv })
    }
}

/// The version of the tool, as its `--version` prints it; `None` when it is not installed.
pub(crate) fn version() -> Option<String> {
    let output = spawn(&["-v"], None).ok()?.wait_with_output().ok()?;
    version_in(&String::from_utf8_lossy(&output.stdout))
}

fn spirv_path(folder: &TempDir) -> PathBuf {
    folder.path().join("shader.spv")
}

fn spawn(arguments: &[&str], input: Option<&Path>) -> Result<Child, CheckError> {
    for program in PROGRAMS {
        let mut command = Command::new(program);
        command.args(arguments).args(input).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        if std::env::var_os("GLIBC_TUNABLES").is_none() {
            command.env("GLIBC_TUNABLES", MEMORY_TUNABLES);
        }
        match command.spawn() {
            Ok(process) => return Ok(process),
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => return Err(failed(format!("cannot be started: {error}"))),
        }
    }
    Err(CheckError::missing(GLSLANG))
}

fn read_spirv(path: &Path) -> Result<Vec<u32>, CheckError> {
    let bytes = std::fs::read(path).map_err(|error| failed(format!("wrote no SPIR-V: {error}")))?;
    words_of_bytes(&bytes).map_err(|reason| failed(format!("wrote SPIR-V that cannot be read: {reason}")))
}

/// The release in `Glslang Version: 11:12.0.0`, where the number before the colon is that of the generator.
fn version_in(printed: &str) -> Option<String> {
    let version = printed.lines().find_map(|line| line.strip_prefix("Glslang Version: "))?.trim();
    Some(version.split_once(':').map_or(version, |(_, release)| release).to_owned())
}

fn failed(reason: String) -> CheckError {
    CheckError::Tool { tool: GLSLANG.name.to_owned(), reason }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_release_is_read_from_what_the_tool_prints() {
        assert_eq!(version_in("Glslang Version: 11:12.0.0\nESSL Version: 3.20").as_deref(), Some("12.0.0"));
        assert_eq!(version_in("Glslang Version: 7.8.2850").as_deref(), Some("7.8.2850"));
        assert_eq!(version_in("something else"), None);
    }
}
