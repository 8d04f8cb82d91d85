//! SPIRV-Tools: validates, assembles and disassembles SPIR-V. The system's tools or, with the feature `bundled`, the
//! library compiled in.

use std::process::Command;
use std::sync::OnceLock;

use spirv_tools::TargetEnv;
use spirv_tools::assembler::{self, Assembler, AssemblerOptions, DisassembleOptions};
use spirv_tools::error::SpirvResult;
use spirv_tools::val::{self, Validator};

use super::verdict::{Diagnostic, Judge, Verdict, all_passed};
use crate::CheckError;
use crate::install::{Requirement, SPIRV_AS, SPIRV_DIS, SPIRV_VAL};

/// The environment that SPIR-V is judged for: Vulkan 1.1, which allows SPIR-V up to 1.3.
const ENVIRONMENT: TargetEnv = TargetEnv::Vulkan_1_1;

/// Judges a SPIR-V module for Vulkan 1.1, by spirv-val. `file` is the name to use in messages.
///
/// The line of a diagnostic is the number of the instruction, counted from 1: its line in a disassembly without header.
///
/// # Errors
/// [`CheckError::Refused`] when the module is not valid, [`CheckError::Missing`] when spirv-val is not installed.
pub fn judge_spirv(file: &str, words: &[u32]) -> Result<Verdict, CheckError> {
    let verdict = spirv_verdict(file, words)?;
    all_passed(vec![verdict.clone()])?;
    Ok(verdict)
}

/// The verdict of spirv-val, whether or not it passes.
pub(super) fn spirv_verdict(file: &str, words: &[u32]) -> Result<Verdict, CheckError> {
    static VERSION: OnceLock<String> = OnceLock::new();
    // The first call asks the tool for its version while the tool validates.
    let result = std::thread::scope(|scope| {
        scope.spawn(|| VERSION.get_or_init(|| tool_version(SPIRV_VAL.name).unwrap_or_default()));
        val::create(Some(ENVIRONMENT)).validate(words, None)
    });
    let version = VERSION.get().cloned().unwrap_or_default();
    let diagnostics = match result {
        Ok(()) => Vec::new(),
        Err(error) => vec![diagnostic(file, error, SPIRV_VAL)?],
    };
    Ok(Verdict { judge: Judge::SpirvVal, version, passed: diagnostics.is_empty(), diagnostics })
}

/// Prints a SPIR-V module as text, with the names that the module carries and the header as comments, without colour.
///
/// # Errors
/// [`CheckError::Refused`] when the words cannot be decoded, [`CheckError::Missing`] when spirv-dis is not installed.
pub fn disassemble(words: &[u32]) -> Result<String, CheckError> {
    let options = DisassembleOptions { comment: false, ..DisassembleOptions::default() };
    match assembler::create(Some(ENVIRONMENT)).disassemble(words, options) {
        Ok(text) => Ok(text.unwrap_or_default()),
        Err(error) => Err(refused("SPIR-V", error, SPIRV_DIS)?),
    }
}

/// Assembles the text form of SPIR-V, as `spirv-dis` prints it. `file` is the name to use in messages.
///
/// # Errors
/// [`CheckError::Refused`] with the line when the text is not SPIR-V assembly, [`CheckError::Missing`] when spirv-as is
/// not installed.
pub fn assemble_spirv(file: &str, text: &str) -> Result<Vec<u32>, CheckError> {
    match assembler::create(Some(ENVIRONMENT)).assemble(text, AssemblerOptions::default()) {
        Ok(binary) => words_of_bytes(binary.as_bytes())
            .map_err(|reason| CheckError::Tool { tool: SPIRV_AS.name.to_owned(), reason }),
        Err(error) => Err(refused(file, error, SPIRV_AS)?),
    }
}

/// The words of a SPIR-V file: whole words of 4 bytes, in the order of this machine or of the file's own magic number.
pub(super) fn words_of_bytes(bytes: &[u8]) -> Result<Vec<u32>, String> {
    let (words, rest) = bytes.as_chunks::<4>();
    if !rest.is_empty() {
        return Err(format!("{} bytes, which is not a whole number of 4-byte words: the file is cut off", bytes.len()));
    }
    Ok(words.iter().map(|word| u32::from_le_bytes(*word)).collect())
}

/// The release that a tool of SPIRV-Tools prints, such as `2023.1`; `None` when it is not installed.
pub(crate) fn tool_version(tool: &str) -> Option<String> {
    if cfg!(feature = "bundled") {
        return Some("bundled with the crate spirv-tools 0.13".to_owned());
    }
    let output = Command::new(tool).arg("--version").output().ok()?;
    let printed = String::from_utf8_lossy(&output.stdout);
    let release = printed.lines().find_map(|line| line.strip_prefix("SPIRV-Tools "))?.split_whitespace().next()?;
    Some(release.trim_start_matches('v').to_owned())
}

/// The refusal that an error of SPIRV-Tools stands for, or the error that says that a tool is missing.
fn refused(file: &str, error: spirv_tools::Error, tool: Requirement) -> Result<CheckError, CheckError> {
    let mut diagnostics = vec![diagnostic(file, error, tool)?];
    for diagnostic in &mut diagnostics {
        diagnostic.message = format!("{}: {}", tool.name, diagnostic.message);
    }
    let version = tool_version(tool.name).unwrap_or_default();
    let verdict = Verdict { judge: Judge::SpirvVal, version, passed: false, diagnostics };
    Ok(CheckError::Refused { verdicts: vec![verdict] })
}

/// What an error of SPIRV-Tools says, and where.
fn diagnostic(file: &str, error: spirv_tools::Error, tool: Requirement) -> Result<Diagnostic, CheckError> {
    match (error.inner, error.diagnostic) {
        (SpirvResult::Unsupported, _) if cfg!(not(feature = "bundled")) => Err(CheckError::missing(tool)),
        (SpirvResult::EndOfStream, Some(said)) if cfg!(not(feature = "bundled")) => {
            Err(CheckError::Tool { tool: tool.name.to_owned(), reason: said.message })
        }
        (_, Some(said)) => {
            let place = Place::read(&said);
            let notes: String = said.notes.lines().map(|note| format!(" {}", note.trim())).collect();
            let message = format!("{}{}", place.message, notes.trim_end());
            Ok(Diagnostic {
                file: file.to_owned(),
                line: place.line,
                column: place.column,
                message,
                judge: Judge::SpirvVal,
            })
        }
        (result, None) => Ok(Diagnostic {
            file: file.to_owned(),
            line: None,
            column: None,
            message: format!("{result}"),
            judge: Judge::SpirvVal,
        }),
    }
}

/// Where an error of SPIRV-Tools lies, and its message without the place.
struct Place<'said> {
    line: Option<u32>,
    column: Option<u32>,
    message: &'said str,
}

impl Place<'_> {
    /// The tools print `error: line 58: text` for binaries and `error: 2: 1: text` for assembly; the library gives the
    /// numbers by themselves, the lines and columns of texts counted from 0.
    fn read(said: &spirv_tools::error::Diagnostic) -> Place<'_> {
        let message = said.message.strip_prefix("error: ").unwrap_or(&said.message);
        if said.is_text {
            let counted_from_1 = |number: usize| u32::try_from(number + 1).ok();
            return Place { line: counted_from_1(said.line), column: counted_from_1(said.column), message };
        }
        if let Some((line, message)) = message.strip_prefix("line ").and_then(number_and_rest) {
            return Place { line: Some(line).filter(|&line| line > 0), column: None, message };
        }
        if let Some((line, rest)) = number_and_rest(message) {
            let (column, message) = number_and_rest(rest).map_or((None, rest), |(column, rest)| (Some(column), rest));
            return Place { line: Some(line), column, message };
        }
        Place { line: u32::try_from(said.index).ok().filter(|&index| index > 0), column: None, message }
    }
}

/// Splits `12: rest`.
fn number_and_rest(text: &str) -> Option<(u32, &str)> {
    let (number, rest) = text.split_once(": ")?;
    Some((number.parse().ok()?, rest))
}
