//! Judges WGSL, assembles it to SPIR-V, and writes it in the Metal Shading Language.

use super::naga_reader::{self, NAGA_VERSION, ValidModule};
use super::spirv::spirv_verdict;
use super::verdict::{Judge, Stage, Verdict, all_passed};
use crate::CheckError;

/// Judges a WGSL text: naga reads and validates it, and when it has an entry point, spirv-val validates the SPIR-V
/// that naga writes of it.
///
/// `file` is the name to use in messages; nothing is read from it. With `required` the text must have an entry point
/// of that stage.
///
/// # Errors
/// [`CheckError::Refused`] when a judge refuses the text, [`CheckError::Missing`] when spirv-val is not installed.
pub fn judge_wgsl(required: Option<Stage>, file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    let module = read(required, file, text)?;
    let mut verdicts = vec![naga_reader::passed()];
    if !module.module.entry_points.is_empty() {
        verdicts.push(spirv_verdict(file, &write(&module, file)?)?);
    }
    all_passed(verdicts)
}

/// Assembles a WGSL text to SPIR-V 1.3 for Vulkan 1.1, by naga.
///
/// Entry points and other names are kept. Loops get no counter that bounds them. The y axis of vertex positions is
/// flipped, from WGSL's upward to Vulkan's downward. Overrides take their default values. `file` is the name to use in
/// messages.
///
/// # Errors
/// [`CheckError::Refused`] when naga refuses the text, or when it has no entry point: SPIR-V without one is not valid
/// for Vulkan.
pub fn wgsl_to_spirv(file: &str, text: &str) -> Result<Vec<u32>, CheckError> {
    let module = read(None, file, text)?;
    if module.module.entry_points.is_empty() {
        let message =
            "no entry point: SPIR-V for Vulkan needs a `@compute`, `@vertex` or `@fragment` function".to_owned();
        return Err(refused(Verdict::refusal(Judge::Naga, NAGA_VERSION, file, None, message)));
    }
    write(&module, file)
}

/// Writes the functions of a WGSL text in the Metal Shading Language, by naga, which has read and validated them. No
/// compiler of Metal sees what is written.
///
/// Names that end with a digit get an underscore, comments are lost. `file` is the name to use in messages.
///
/// # Errors
/// [`CheckError::Refused`] when naga refuses the text, or cannot write it.
pub fn wgsl_to_msl(file: &str, text: &str) -> Result<String, CheckError> {
    read(None, file, text)?.write_msl().map_err(|message| unwritten("in the Metal Shading Language", message, file))
}

fn read(required: Option<Stage>, file: &str, text: &str) -> Result<ValidModule, CheckError> {
    let module = naga_reader::read_wgsl(file, text).map_err(refused)?;
    match required {
        Some(stage) if !module.has_entry_point(stage) => {
            let message = format!("no entry point for this form: a `@{}` function is expected", stage.name());
            Err(refused(Verdict::refusal(Judge::Naga, NAGA_VERSION, file, None, message)))
        }
        _ => Ok(module),
    }
}

fn write(module: &ValidModule, file: &str) -> Result<Vec<u32>, CheckError> {
    module.write_spirv().map_err(|message| unwritten("as SPIR-V", message, file))
}

fn unwritten(what: &str, message: String, file: &str) -> CheckError {
    let message = format!("naga cannot write this module {what}: {message}");
    refused(Verdict::refusal(Judge::Naga, NAGA_VERSION, file, None, message))
}

fn refused(verdict: Verdict) -> CheckError {
    CheckError::Refused { verdicts: vec![verdict] }
}
