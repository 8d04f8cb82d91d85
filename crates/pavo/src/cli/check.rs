//! `pavo check`: the judges alone.

use super::arguments;
use super::failure::Failure;
use super::output;
use super::sources::Source;
use crate::inputs::ShadingQuantity;
use crate::target::Target;
use pavo_check::{Verdict, judge_file};
use serde_json::json;
use std::path::Path;

/// Judges the shaders of scenes and shader files.
pub fn run(arguments: &arguments::Check) -> Result<(), Failure> {
    let mut judged: Vec<(String, Vec<Verdict>)> = Vec::new();
    for path in &arguments.files {
        if path.extension().is_some_and(|extension| extension == "toml") {
            judged.extend(judge_scene(path, arguments.variant.as_deref())?);
        } else {
            judged.push((path.display().to_string(), judge_file(path)?));
        }
    }
    if arguments.json {
        let rows: Vec<_> =
            judged.iter().map(|(file, verdicts)| json!({ "file": file, "verdicts": verdicts })).collect();
        return output::print(&format!("{:#}\n", json!(rows)));
    }
    let mut text = String::new();
    for (file, verdicts) in &judged {
        let names: Vec<String> = verdicts.iter().map(|verdict| verdict.judge.described()).collect();
        text.push_str(&format!("{file}: passed by {}\n", names.join(", ")));
        for diagnostic in verdicts.iter().flat_map(|verdict| &verdict.diagnostics) {
            text.push_str(&format!("  {}\n", output::printable(&diagnostic.to_string())));
        }
    }
    output::print(&text)
}

fn judge_scene(path: &Path, variant: Option<&str>) -> Result<Vec<(String, Vec<Verdict>)>, Failure> {
    let source = Source::load(path, variant)?;
    let targets = targets(&source)?;
    let judge = |target: Target| {
        let emitted = source.emit(target, target.default_form(), ShadingQuantity::Reflectance)?;
        Ok((format!("{}: {}", path.display(), emitted.file), emitted.verdicts))
    };
    targets.into_iter().map(judge).collect()
}

/// The targets that a scene names.
pub fn targets(source: &Source) -> Result<Vec<Target>, Failure> {
    let names = source.shading.scene().emit.targets.iter();
    names
        .map(|name| name.parse().map_err(|error: String| Failure::input(error, "see emit.targets of the scene")))
        .collect()
}
