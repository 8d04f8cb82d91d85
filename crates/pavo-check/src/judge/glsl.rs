//! Judges GLSL, and compiles it to SPIR-V.

use super::glsl_source::{GlslSource, GlslVersion, JudgedText};
use super::glslang::{self, Answer, Task};
use super::naga_reader;
use super::spirv::spirv_verdict;
use super::verdict::{Judge, Stage, Verdict, all_passed};
use crate::CheckError;

/// The extension with the types of half precision.
const HALF_PRECISION: &str = "GL_EXT_shader_explicit_arithmetic_types_float16";

/// Judges a complete GLSL text, one with a `#version` line and a `main`.
///
/// Texts of version 4.40 to 4.60 are judged for Vulkan 1.1 by naga and by glslang, and the SPIR-V that glslang writes
/// by spirv-val; other versions by glslang's classic front end. `file` is the name to use in messages; nothing is read
/// from it.
///
/// # Errors
/// [`CheckError::Refused`] when a judge refuses the text or when it has no `#version` line, [`CheckError::Missing`]
/// when glslang or spirv-val is not installed.
pub fn judge_glsl(stage: Stage, file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    let source = read(file, text)?;
    let version = required_version(&source, file)?;
    judge(version, stage, file, &source.unchanged())
}

/// Compiles a complete GLSL text for Vulkan to SPIR-V 1.3, by glslang. The entry point is `main`.
///
/// `file` is the name to use in messages.
///
/// # Errors
/// [`CheckError::Refused`] when glslang refuses the text or when it has no `#version` line, [`CheckError::Missing`]
/// when glslang is not installed.
pub fn glsl_to_spirv(file: &str, text: &str, stage: Stage) -> Result<Vec<u32>, CheckError> {
    let source = read(file, text)?;
    required_version(&source, file)?;
    let judged = source.unchanged();
    let answer = glslang::start(&judged.text, stage, Task::Vulkan { keep_uncalled: false, read_as: None })?.finish()?;
    match answer.spirv {
        Some(words) => Ok(words),
        None => Err(CheckError::Refused { verdicts: vec![answer.verdict(file, &judged)] }),
    }
}

/// Looks through a text. A text with a NUL byte, where C programs end reading, is refused.
pub(super) fn read<'text>(file: &str, text: &'text str) -> Result<GlslSource<'text>, CheckError> {
    if let Some(offset) = text.find('\0') {
        let line = text[..offset].matches('\n').count() + 1;
        return Err(refusal(file, u32::try_from(line).ok(), "a NUL byte, which GLSL does not allow".to_owned()));
    }
    Ok(GlslSource::read(text))
}

/// The version that a text says it is of.
pub(super) fn required_version(source: &GlslSource<'_>, file: &str) -> Result<GlslVersion, CheckError> {
    let version_line = source.version_line;
    source.version.ok_or_else(|| {
        let message = match version_line {
            Some(_) => "this `#version` cannot be read: `#version 450`, `#version 330 core` or `#version 300 es` can",
            None => "no `#version` line: a text with an entry point starts with one, such as `#version 450`",
        };
        refusal(file, version_line.or(Some(1)), message.to_owned())
    })
}

/// Judges a text that is complete, or was completed, as one of `version`.
pub(super) fn judge(
    version: GlslVersion,
    stage: Stage,
    file: &str,
    judged: &JudgedText,
) -> Result<Vec<Verdict>, CheckError> {
    if !version.is_for_vulkan() {
        let answer = glslang::start(&judged.text, stage, Task::Classic)?.finish()?;
        return all_passed(vec![answer.verdict(file, judged)]);
    }
    let mut naga = None;
    let answer = compile_for_vulkan(version, stage, judged, || {
        // naga reads no half precision in GLSL; glslang and spirv-val judge it.
        if !judged.text.contains(HALF_PRECISION) {
            naga = Some(
                naga_reader::read_glsl(file, judged, stage).map_or_else(|refusal| refusal, |_| naga_reader::passed()),
            );
        }
    })?;
    let mut verdicts: Vec<Verdict> = naga.into_iter().collect();
    verdicts.push(answer.verdict(file, judged));
    if let Some(words) = &answer.spirv {
        verdicts.push(spirv_verdict(file, words)?);
    }
    all_passed(verdicts)
}

/// Lets glslang compile a text, and does `meanwhile` while it works.
///
/// For 4.50 glslang builds the tables of the six stages of ray tracing and the two of mesh shading on top of the
/// others before it reads a line; for 4.40 it does not, which halves its time. A text that 4.40 accepts and that
/// depends on no version is accepted by 4.50 with the same meaning, so it is read as 4.40 first. Any refusal is that of
/// its own version.
fn compile_for_vulkan(
    version: GlslVersion,
    stage: Stage,
    judged: &JudgedText,
    meanwhile: impl FnOnce(),
) -> Result<Answer, CheckError> {
    let exact = Task::Vulkan { keep_uncalled: true, read_as: None };
    let faster = Task::Vulkan { keep_uncalled: true, read_as: Some(440) };
    let may_be_faster = version == GlslVersion::GLSL_450 && !depends_on_version(&judged.text);
    let run = glslang::start(&judged.text, stage, if may_be_faster { faster } else { exact })?;
    meanwhile();
    match run.finish() {
        // A tool that does not know the option says so as a wrong command line.
        Ok(Answer { passed: false, .. }) | Err(CheckError::Tool { .. }) if may_be_faster => {
            glslang::start(&judged.text, stage, exact)?.finish()
        }
        answer => answer,
    }
}

/// Whether a text could mean something else in 4.40 than in 4.50: by a directive other than `#version` and `#define`,
/// by asking for the version, or by a name that is a keyword only in 4.50.
fn depends_on_version(text: &str) -> bool {
    let directives = text.lines().filter_map(|line| line.trim_start().strip_prefix('#')).map(str::trim_start);
    directives.into_iter().any(|directive| !(directive.starts_with("version") || directive.starts_with("define")))
        || text.contains("__VERSION__")
        || text.contains("pervertex")
}

pub(super) fn refusal(file: &str, line: Option<u32>, message: String) -> CheckError {
    CheckError::Refused { verdicts: vec![Verdict::refusal(Judge::Glslang, "", file, line, message)] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_texts_that_read_alike_in_both_versions_take_the_faster_way() {
        for (text, depends) in [
            ("#version 450\n#define PI 3.14\nvoid main() {}", false),
            ("#version 450\n  # extension GL_EXT_x : enable\nvoid main() {}", true),
            ("#version 450\n#ifdef GL_EXT_x\n#endif\nvoid main() {}", true),
            ("#version 450\nint v = __VERSION__;", true),
            ("#version 450\nfloat pervertexEXT;", true),
        ] {
            assert_eq!(depends_on_version(text), depends, "{text}");
        }
    }
}
