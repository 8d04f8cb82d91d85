//! Judges OSL by what is at hand without a renderer: glslang's front end for HLSL, with OSL's names defined.

use super::glsl_source::JudgedText;
use super::glslang::{self, Task};
use super::hlsl::read;
use super::verdict::{Judge, Stage, Verdict, all_passed};
use crate::CheckError;

/// What OSL calls otherwise than HLSL. Structs, functions, whole numbers as truth values and lists in braces are alike.
const PRELUDE: &str = "\
#define vector float3
#define color float3
#define shader void
#define mix lerp
#define inversesqrt rsqrt
#define mod fmod
";

/// Judges a library of OSL functions: glslang reads it as HLSL.
///
/// That holds its syntax and types to rules near those of OSL; it is no OSL compiler, and its verdict says so. Metadata,
/// closures and parameters for output are not read. `file` is the name to use in messages.
///
/// # Errors
/// [`CheckError::Refused`] when glslang refuses the text, [`CheckError::Missing`] when it is not installed.
pub fn judge_osl(file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    read(file, text)?;
    let judged = JudgedText::between(PRELUDE, text, "\nvoid main() {}\n");
    let answer = glslang::start(&judged.text, Stage::Fragment, Task::Hlsl { keep_uncalled: true })?.finish()?;
    all_passed(vec![answer.verdict_of(Judge::GlslangForOsl, file, &judged)])
}
