//! From the arguments to a surface, and from a surface to judged shaders.

use super::cache::DiskCache;
use super::command_line;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::tune;
use crate::inputs::ShadingQuantity;
use crate::scene::Scene;
use crate::shading::Shading;
use crate::target::Target;
use crate::tuning::{Budget, CostKind, DEFAULT_MAX_DELTA_E, pick};
use crate::variant::Variant;
use crate::{Emission, compute, fragment, library};
use pavo_check::{CheckError, Verdict, judge_spirv, judge_text, wgsl_to_spirv};
use pavo_emit::{Form, Language};
use std::path::{Path, PathBuf};

/// What stands in place of a variant that is to be chosen.
pub(super) const AUTO: &str = "auto";

/// A scene from its file, with the variant that the arguments or the scene name.
pub struct Source {
    /// Where the scene was read.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
    /// The surface.
    pub shading: Shading,
}

impl Source {
    /// Reads a scene and makes its surface, and says what there is to warn of.
    pub fn load(path: &Path, variant: Option<&str>) -> Result<Self, Failure> {
        let (scene, text) = Scene::load_with_text(path)?;
        let variant = match variant.unwrap_or(&scene.emit.variant) {
            AUTO => picked(&scene)?,
            named => named.parse()?,
        };
        let progress = Progress::start();
        progress.step(format!("preparing {} by {variant}", scene.name));
        let shading = Shading::with_cache(&scene, &variant, &DiskCache::open())?;
        drop(progress);
        for warning in shading.warnings() {
            output::warn(&warning);
        }
        Ok(Self { path: path.to_owned(), text, shading })
    }

    /// Emits one target in a form and has it judged.
    pub fn emit(&self, target: Target, form: Form, quantity: ShadingQuantity) -> Result<Emitted, Failure> {
        self.emit_with(target, form, quantity, false)
    }

    /// The same, where wanted with the line of Rust behind each statement.
    pub fn emit_with(
        &self,
        target: Target,
        form: Form,
        quantity: ShadingQuantity,
        source_lines: bool,
    ) -> Result<Emitted, Failure> {
        let shading = &self.shading;
        let command = command_line::emit(&self.path, target, shading.variant(), form, quantity);
        let scene = &shading.scene().name;
        let suffix = if form == target.default_form() { String::new() } else { format!("-{}", form.name()) };
        let file = format!("{scene}{suffix}.{}", target.extension());
        let emission = |language: Language| Emission { language, command: &command, source_lines };
        let text = |language: Language| match form {
            Form::Library => Ok(library(shading, emission(language))),
            Form::Compute => compute(shading, quantity, emission(language)),
            Form::Fragment => fragment(shading, emission(language)),
        };
        let (bytes, verdicts) = match target {
            Target::Text(language) => {
                let text = text(language)?;
                let verdicts =
                    judge_text(language, form, &file, &text).map_err(|error| refused(&file, &text, error))?;
                (text.into_bytes(), verdicts)
            }
            Target::Spirv | Target::SpirvAssembly if form == Form::Library => {
                return Err(Failure::input(
                    "SPIR-V without an entry point is not valid for Vulkan",
                    "use --form compute or --form fragment; for functions alone use --target wgsl or a GLSL",
                ));
            }
            Target::Spirv | Target::SpirvAssembly => {
                let source = text(Language::Wgsl)?;
                let words = wgsl_to_spirv(&file, &source).map_err(|error| refused(&file, &source, error))?;
                let verdicts = vec![judge_spirv(&file, &words)?];
                let bytes = if target == Target::Spirv {
                    words.iter().flat_map(|word| word.to_le_bytes()).collect()
                } else {
                    let header: String = source
                        .lines()
                        .take_while(|line| line.starts_with("//"))
                        .fold(String::new(), |header, line| header + &line.replacen("//", ";", 1) + "\n");
                    (header + &pavo_check::disassemble(&words)?).into_bytes()
                };
                (bytes, verdicts)
            }
        };
        Ok(Emitted { target, form, file, bytes, verdicts })
    }
}

/// The cheapest variant that keeps to the scene's budget, by operations: they need no driver, and are the same everywhere.
fn picked(scene: &Scene) -> Result<Variant, Failure> {
    let cache = DiskCache::open();
    let tuning = tune::measure(scene, &CostKind::Operations, &cache)?;
    let limit = scene.budget.max_delta_e.unwrap_or(DEFAULT_MAX_DELTA_E);
    Ok(pick(scene, &tuning, Budget::MaxDeltaE(limit), &cache)?.variant.parse()?)
}

/// A shader that passed its judges.
pub struct Emitted {
    /// The target.
    pub target: Target,
    /// The form.
    pub form: Form,
    /// The name of its file.
    pub file: String,
    /// Its content.
    pub bytes: Vec<u8>,
    /// What the judges said.
    pub verdicts: Vec<Verdict>,
}

/// A refusal with the lines of the text that it speaks of.
pub(super) fn refused(file: &str, text: &str, error: CheckError) -> Failure {
    let lines: Vec<String> = error
        .diagnostics()
        .filter_map(|diagnostic| diagnostic.line)
        .filter_map(|line| text.lines().nth(line as usize - 1).map(|content| format!("{file}:{line}: {content}")))
        .collect();
    if lines.is_empty() {
        return error.into();
    }
    Failure::check(format!("{error}\n{}", lines.join("\n")))
}
