//! naga as a reader of WGSL and GLSL and as a writer of SPIR-V and of the Metal Shading Language.

use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ::naga::back::{PipelineConstants, msl, pipeline_constants, spv};
use ::naga::front::{glsl, wgsl};
use ::naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use ::naga::{Module, Span, WithSpan};

use super::glsl_source::JudgedText;
use super::verdict::{Diagnostic, Judge, Stage, Verdict};

/// The release of naga that is compiled in; a test holds it equal to the lock file.
pub(crate) const NAGA_VERSION: &str = "30.0.1";

/// A module that naga has read and found valid.
pub(super) struct ValidModule {
    pub module: Module,
    info: ModuleInfo,
}

impl ValidModule {
    /// Whether the module has an entry point of `stage`.
    pub fn has_entry_point(&self, stage: Stage) -> bool {
        self.module.entry_points.iter().any(|entry| entry.stage == stage.for_naga())
    }

    /// Writes SPIR-V 1.3, for Vulkan 1.1: names kept, loops as they are written, the vertex positions flipped from
    /// WGSL's upward y axis to Vulkan's downward one. Overrides take their default values.
    pub fn write_spirv(&self) -> Result<Vec<u32>, String> {
        let options = spv::Options {
            lang_version: (1, 3),
            flags: spv::WriterFlags::DEBUG
                | spv::WriterFlags::LABEL_VARYINGS
                | spv::WriterFlags::ADJUST_COORDINATE_SPACE
                | spv::WriterFlags::CLAMP_FRAG_DEPTH,
            force_loop_bounding: false,
            ..spv::Options::default()
        };
        guarded(|| {
            let constants = PipelineConstants::default();
            let (module, info) = pipeline_constants::process_overrides(&self.module, &self.info, None, &constants)
                .map_err(|error| chain(&error))?;
            spv::write_vec(&module, &info, &options, None).map_err(|error| chain(&error))
        })
        .unwrap_or_else(Err)
    }

    /// Writes the functions in the Metal Shading Language 1.2, loops as they are written.
    pub fn write_msl(&self) -> Result<String, String> {
        let options = msl::Options { lang_version: (1, 2), force_loop_bounding: false, ..msl::Options::default() };
        guarded(|| {
            msl::write_string(&self.module, &self.info, &options, &msl::PipelineOptions::default())
                .map(|(text, _)| text)
                .map_err(|error| chain(&error))
        })
        .unwrap_or_else(Err)
    }
}

/// Reads and validates WGSL. `enable f16;` is allowed, other optional features of WebGPU are not.
pub(super) fn read_wgsl(file: &str, text: &str) -> Result<ValidModule, Verdict> {
    let place = Place { file, text, judged: None };
    let module = guarded(|| wgsl::parse_str(text))
        .map_err(|message| place.refusal(vec![place.diagnostic(None, message)]))?
        .map_err(|error| {
            let mut message = error.message().to_owned();
            let first_label = error.labels().next();
            let span = first_label.map(|(span, _)| span);
            // The first label says what is wrong at the span itself, where the message does not already.
            if let Some((_, label)) = first_label
                && !message.contains(label)
            {
                message = format!("{message}: {label}");
            }
            for note in error.notes() {
                message = format!("{message}; {note}");
            }
            place.refusal(vec![place.diagnostic(span, message)])
        })?;
    place.validate(module, Capabilities::default() | Capabilities::SHADER_FLOAT16)
}

/// Reads and validates GLSL 4.40 to 4.60.
pub(super) fn read_glsl(file: &str, judged: &JudgedText, stage: Stage) -> Result<ValidModule, Verdict> {
    let place = Place { file, text: &judged.text, judged: Some(judged) };
    let options = glsl::Options::from(stage.for_naga());
    let module = guarded(|| glsl::Frontend::default().parse(&options, &judged.text))
        .map_err(|message| place.refusal(vec![place.diagnostic(None, message)]))?
        .map_err(|errors| {
            let diagnostics =
                errors.errors.iter().map(|error| place.diagnostic(Some(error.meta), error.kind.to_string()));
            place.refusal(diagnostics.collect())
        })?;
    place.validate(module, Capabilities::all())
}

/// The verdict of naga when it has no objection.
pub(super) fn passed() -> Verdict {
    Verdict { judge: Judge::Naga, version: NAGA_VERSION.to_owned(), passed: true, diagnostics: Vec::new() }
}

/// A text and its file, to say where something is wrong.
struct Place<'text> {
    file: &'text str,
    text: &'text str,
    judged: Option<&'text JudgedText>,
}

impl Place<'_> {
    fn validate(&self, module: Module, capabilities: Capabilities) -> Result<ValidModule, Verdict> {
        let result =
            guarded(|| Validator::new(ValidationFlags::all(), capabilities).validate(&module).map_err(Box::new));
        match result {
            Ok(Ok(info)) => Ok(ValidModule { module, info }),
            Ok(Err(error)) => Err(self.refusal(vec![self.diagnostic(narrowest_span(&error), chain(error.as_inner()))])),
            Err(message) => Err(self.refusal(vec![self.diagnostic(None, message)])),
        }
    }

    fn refusal(&self, diagnostics: Vec<Diagnostic>) -> Verdict {
        Verdict { judge: Judge::Naga, version: NAGA_VERSION.to_owned(), passed: false, diagnostics }
    }

    fn diagnostic(&self, span: Option<Span>, message: String) -> Diagnostic {
        let position = span.and_then(|span| span.to_range()).map(|range| line_and_column(self.text, range.start));
        let line = position.map(|(line, _)| self.judged.map_or(line, |judged| judged.own_line(line)));
        let column = position.map(|(_, column)| column);
        Diagnostic { file: self.file.to_owned(), line, column, message, judge: Judge::Naga }
    }
}

/// The line and the column in bytes, both counted from 1, of a byte offset.
fn line_and_column(text: &str, offset: usize) -> (u32, u32) {
    let before = &text.as_bytes()[..offset.min(text.len())];
    let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let column = before.iter().rev().take_while(|&&byte| byte != b'\n').count() + 1;
    (u32::try_from(line).unwrap_or(u32::MAX), u32::try_from(column).unwrap_or(u32::MAX))
}

/// The shortest span of an error: naga names the function and the expression in it, in no fixed order.
fn narrowest_span<E>(error: &WithSpan<E>) -> Option<Span> {
    error.spans().map(|(span, _)| *span).min_by_key(|span| span.to_range().map_or(usize::MAX, |range| range.len()))
}

/// The message of an error and of all that caused it, in one line.
fn chain(error: &dyn Error) -> String {
    let mut message = error.to_string();
    let mut source = error.source();
    while let Some(cause) = source {
        message = format!("{message}: {cause}");
        source = cause.source();
    }
    message
}

/// Runs naga; a panic inside it, which is a defect of naga, becomes a message.
fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let reason = payload
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| payload.downcast_ref::<&str>().copied())
            .unwrap_or("no reason given");
        format!("naga itself failed on this input: {reason}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_the_one_in_the_lock_file() {
        let lock = include_str!("../../../../Cargo.lock");
        let version = lock.split("[[package]]").find(|package| package.contains("name = \"naga\"\n")).unwrap();
        assert!(version.contains(&format!("version = \"{NAGA_VERSION}\"")), "{version}");
    }

    #[test]
    fn offsets_become_lines_and_columns_in_bytes() {
        let text = "a\nbé c\n";
        assert_eq!(line_and_column(text, 0), (1, 1));
        assert_eq!(line_and_column(text, 2), (2, 1));
        assert_eq!(line_and_column(text, text.find('c').unwrap()), (2, 5));
        assert_eq!(line_and_column(text, 1_000), (3, 1));
    }

    #[test]
    fn a_panic_becomes_a_message() {
        let message = guarded(|| -> () { std::panic::panic_any("broken".to_owned()) }).unwrap_err();
        assert_eq!(message, "naga itself failed on this input: broken");
    }
}
