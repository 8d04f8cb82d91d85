//! Judges what the printer writes.

use pavo_emit::{Form, Language};

use super::glsl::{judge, read, refusal, required_version};
use super::glsl_source::GlslVersion;
use super::hlsl::judge_hlsl;
use super::osl::judge_osl;
use super::rust::judge_rust;
use super::verdict::{Stage, Verdict};
use super::wgsl::judge_wgsl;
use crate::CheckError;

/// The stage that a GLSL library is completed to: the one in which derivatives are allowed.
const LIBRARY_STAGE: Stage = Stage::Fragment;

/// Judges a text in one of the printer's languages and forms.
///
/// `file` is the name to use in messages; nothing is read from it. A complete GLSL form must carry the language's own
/// `#version`, a complete WGSL form an entry point of its stage. A GLSL library is judged with a `#version` line, the
/// default precisions of ES, and an empty `main` around it, as far as it lacks them, one of HLSL with an empty `main`;
/// lines are those of `text`.
///
/// # Errors
/// [`CheckError::Refused`] with the verdicts of all judges when one refuses the text, [`CheckError::Missing`] when
/// glslang or spirv-val is not installed.
pub fn judge_text(language: Language, form: Form, file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    if language == Language::Rust {
        return judge_rust(file, text);
    }
    if language == Language::Hlsl {
        return judge_hlsl(Stage::of_form(form), file, text);
    }
    if language == Language::Osl {
        return judge_osl(file, text);
    }
    let Some(expected) = GlslVersion::of_language(language) else {
        return judge_wgsl(Stage::of_form(form), file, text);
    };
    let source = read(file, text)?;
    if source.version_line.is_some() || form != Form::Library {
        let version = required_version(&source, file)?;
        if version != expected {
            let message = format!("`{version}` where `{expected}` is expected");
            return Err(refusal(file, source.version_line, message));
        }
    }
    match Stage::of_form(form) {
        Some(stage) => judge(expected, stage, file, &source.unchanged()),
        None => {
            let stage = if source.has_main { source.likely_stage } else { LIBRARY_STAGE };
            judge(expected, stage, file, &source.completed(expected, stage))
        }
    }
}
