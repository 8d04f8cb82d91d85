//! Judges a file by its kind.

use std::path::Path;

use super::glsl::{judge, judge_glsl, read, required_version};
use super::glsl_source::GlslVersion;
use super::hlsl::judge_hlsl;
use super::osl::judge_osl;
use super::rust::judge_rust;
use super::spirv::{assemble_spirv, judge_spirv, words_of_bytes};
use super::verdict::{Judge, Stage, Verdict};
use super::wgsl::judge_wgsl;
use crate::CheckError;

/// The extensions of the files that [`judge_file`] reads.
pub const FILE_EXTENSIONS: [&str; 10] = ["wgsl", "glsl", "vert", "frag", "comp", "hlsl", "osl", "spv", "spvasm", "rs"];

/// The largest file that is judged, in bytes: 64 MiB. The largest text that is emitted has some hundred kilobytes.
const MAXIMUM_BYTES: usize = 64 << 20;

/// Judges a file; its extension tells what it is.
///
/// - `.wgsl`: with or without entry points.
/// - `.vert`, `.frag`, `.comp` (also as `.frag.glsl`) and `.glsl`: the `#version` line tells the version. Without a
///   `main` the file is a library and is completed; without a `#version` line as well it is a library of GLSL 4.50.
///   For a plain `.glsl` the stage is told by what the text uses: `local_size_x` is for compute, `gl_Position` for
///   vertex, anything else for fragment shaders.
/// - `.spv`: a SPIR-V module.
/// - `.spvasm`: assembled first.
/// - `.hlsl`: without a `main` a library; with one for compute where it has `numthreads`, else for fragments.
/// - `.osl`: functions, read as HLSL with OSL's names.
/// - `.rs`: a Rust module, by its syntax.
///
/// # Errors
/// [`CheckError::Refused`] when a judge refuses the file, [`CheckError::Unreadable`] and [`CheckError::UnknownKind`]
/// when it cannot be judged, [`CheckError::Missing`] when a tool is not installed.
pub fn judge_file(path: impl AsRef<Path>) -> Result<Vec<Verdict>, CheckError> {
    let path = path.as_ref();
    let file = pavo_files::shown(path);
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    match extension.as_deref() {
        Some("wgsl") => judge_wgsl(None, &file, &read_text(path)?),
        Some("glsl") => {
            let inner = path.file_stem().map(Path::new).and_then(Path::extension).and_then(|inner| inner.to_str());
            judge_glsl_file(inner.and_then(stage_of_extension), &file, &read_text(path)?)
        }
        Some(name) if stage_of_extension(name).is_some() => {
            judge_glsl_file(stage_of_extension(name), &file, &read_text(path)?)
        }
        Some("spv") => {
            let words = words_of_bytes(&read_bytes(path)?).map_err(|reason| CheckError::Refused {
                verdicts: vec![Verdict::refusal(Judge::SpirvVal, "", &file, None, reason)],
            })?;
            judge_spirv(&file, &words).map(|verdict| vec![verdict])
        }
        Some("spvasm") => {
            let words = assemble_spirv(&file, &read_text(path)?)?;
            judge_spirv(&file, &words).map(|verdict| vec![verdict])
        }
        Some("hlsl") => judge_hlsl(None, &file, &read_text(path)?),
        Some("osl") => judge_osl(&file, &read_text(path)?),
        Some("rs") => judge_rust(&file, &read_text(path)?),
        _ => {
            let expected = FILE_EXTENSIONS.map(|name| format!(".{name}")).join(", ");
            Err(CheckError::UnknownKind { path: path.to_owned(), expected })
        }
    }
}

fn judge_glsl_file(stage: Option<Stage>, file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    let source = read(file, text)?;
    let stage = stage.unwrap_or(source.likely_stage);
    if source.has_main {
        return judge_glsl(stage, file, text);
    }
    let version = if source.version_line.is_some() { required_version(&source, file)? } else { GlslVersion::GLSL_450 };
    judge(version, stage, file, &source.completed(version, stage))
}

fn stage_of_extension(extension: &str) -> Option<Stage> {
    match extension {
        "vert" => Some(Stage::Vertex),
        "frag" => Some(Stage::Fragment),
        "comp" => Some(Stage::Compute),
        _ => None,
    }
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, CheckError> {
    pavo_files::read_up_to(path, MAXIMUM_BYTES)
        .map_err(|error| CheckError::Unreadable { path: path.to_owned(), reason: error.to_string() })
}

fn read_text(path: &Path) -> Result<String, CheckError> {
    String::from_utf8(read_bytes(path)?).map_err(|error| CheckError::Unreadable {
        path: path.to_owned(),
        reason: format!("not UTF-8 text: wrong byte at offset {}", error.utf8_error().valid_up_to()),
    })
}
