//! Judges HLSL, and compiles it to SPIR-V, by glslang's front end for it.

use super::glsl::refusal;
use super::glsl_source::{JudgedText, declares_main, without_comments};
use super::glslang::{self, Task};
use super::spirv::spirv_verdict;
use super::verdict::{Stage, Verdict, all_passed};
use crate::CheckError;

/// Judges an HLSL text: glslang compiles it for Vulkan 1.1, and spirv-val validates the SPIR-V that it writes.
///
/// A text without a `main` is a library and is judged with an empty one, all its functions included. `required` is the
/// stage whose entry point it must have; without it a `main` is of the compute stage where `numthreads` stands in the
/// text, and of the fragment stage elsewhere. `file` is the name to use in messages; nothing is read from it.
///
/// # Errors
/// [`CheckError::Refused`] when a judge refuses the text or it has no entry point where one is required,
/// [`CheckError::Missing`] when glslang or spirv-val is not installed.
pub fn judge_hlsl(required: Option<Stage>, file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    let code = read(file, text)?;
    let has_main = declares_main(&code) || code.contains(" main(");
    if required.is_some() && !has_main {
        return Err(refusal(file, None, "no entry point: a function `main` is expected".to_owned()));
    }
    let told = if code.contains("numthreads") { Stage::Compute } else { Stage::Fragment };
    let stage = required.unwrap_or(told);
    let suffix = if has_main { "" } else { "\nvoid main() {}\n" };
    let judged = JudgedText::between("", text, suffix);
    let answer = glslang::start(&judged.text, stage, Task::Hlsl { keep_uncalled: true })?.finish()?;
    let mut verdicts = vec![answer.verdict(file, &judged)];
    if let Some(words) = &answer.spirv {
        verdicts.push(spirv_verdict(file, words)?);
    }
    all_passed(verdicts)
}

/// Compiles a complete HLSL text for Vulkan to SPIR-V 1.3, by glslang. The entry point is `main`; `register(t0)` and
/// `register(u1)` are the bindings 0 and 1 of set 0.
///
/// `file` is the name to use in messages.
///
/// # Errors
/// [`CheckError::Refused`] when glslang refuses the text, [`CheckError::Missing`] when it is not installed.
pub fn hlsl_to_spirv(file: &str, text: &str, stage: Stage) -> Result<Vec<u32>, CheckError> {
    read(file, text)?;
    let judged = JudgedText::between("", text, "");
    let answer = glslang::start(text, stage, Task::Hlsl { keep_uncalled: false })?.finish()?;
    match answer.spirv {
        Some(words) => Ok(words),
        None => Err(CheckError::Refused { verdicts: vec![answer.verdict(file, &judged)] }),
    }
}

/// The text without its comments. One with a NUL byte, where C programs end reading, is refused.
pub(super) fn read(file: &str, text: &str) -> Result<String, CheckError> {
    match text.find('\0') {
        Some(offset) => {
            let line = text[..offset].matches('\n').count() + 1;
            Err(refusal(file, u32::try_from(line).ok(), "a NUL byte, which shaders may not hold".to_owned()))
        }
        None => Ok(without_comments(text)),
    }
}
