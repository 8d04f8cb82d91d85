//! `pavo export`: the functions as an engine takes them, with what says where they go and whether they work.

mod engines;
mod finishing;
mod list;
mod page;

use super::arguments;
use super::build::test_vectors;
use super::command_line::quoted;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::sources::{Source, refused};
use crate::Emission;
use crate::entries::wrapped;
use crate::inputs::ShadingQuantity;
use crate::scene::{Base, ColourQuantity};
use crate::tuning::{F0Loss, Judge, VariantErrors};
use engines::{Engine, EngineFile, engine, template};
use finishing::{with_highp, written_by};
use pavo_check::judge_text;
use pavo_emit::{Form, Wrapper};
use pavo_shade::Input;
use serde_json::json;
use std::path::{Path, PathBuf};

/// What the names of the functions begin with, so that none is one of an engine's own.
const PREFIX: &str = "pavo_";

/// Exports a scene for an engine, or lists the engines.
pub fn run(arguments: &arguments::Export) -> Result<(), Failure> {
    if arguments.list {
        return list::run(arguments.json, arguments.markdown);
    }
    let (Some(scene), Some(name)) = (&arguments.scene, &arguments.engine) else {
        return Err(Failure::input("a scene and an engine are needed", "write: pavo export SCENE --engine three"));
    };
    let engine = engine(name)?;
    let source = Source::load(scene, arguments.variant.as_deref())?;
    let progress = Progress::start();
    progress.step(format!("measuring the error of {}", source.shading.variant()));
    let judge = Judge::new(source.shading.scene())?;
    let errors = judge.errors(&source.shading)?;
    let loss = if engine.loses.is_empty() { None } else { judge.f0_loss(&source.shading)? };
    progress.step(format!("emitting and judging for {}", engine.title));
    let export = Export { engine: &engine, source: &source, errors: &errors, loss };
    let files = export.files()?;
    drop(progress);
    let folder = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}-{}", source.shading.scene().name, engine.name)));
    output::make_folder(&folder)?;
    for (file, bytes) in &files {
        output::write(&folder.join(file), bytes)?;
    }
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    if arguments.json {
        let folder = folder.display().to_string();
        let report = json!({
            "engine": engine.name, "folder": folder, "files": names, "variant": source.shading.variant().to_string(),
            "errors": errors, "f0_loss": export.loss, "operations": export.operations(), "notes": export.notes(),
        });
        return output::print(&format!("{report:#}\n"));
    }
    let mut text = format!("{}, for {}: {}\n", source.shading.scene().name, engine.title, export.error());
    for note in export.notes() {
        text.push_str(&format!("  {note}\n"));
    }
    for name in names {
        text.push_str(&format!("  {}\n", folder.join(name).display()));
    }
    output::print(&text)
}

/// A scene on its way to an engine.
struct Export<'a> {
    engine: &'a Engine,
    source: &'a Source,
    errors: &'a VariantErrors,
    /// What would be lost of the base in an engine that only has an F0.
    loss: Option<F0Loss>,
}

impl Export<'_> {
    /// The names and contents of all files; the code has passed its judges.
    fn files(&self) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        for file in &self.engine.files {
            let text = self.code(file)?;
            if !file.check.is_empty() {
                let page = page::check(self.source, self.engine, file, &text)?;
                files.push((page::check_file(file)?.to_owned(), page.into_bytes()));
            }
            files.push((file.file.clone(), text.into_bytes()));
        }
        for name in &self.engine.beside {
            let file = name.rsplit('/').next().unwrap_or(name);
            files.push((file.to_owned(), template(name)?.as_bytes().to_vec()));
        }
        files.push(("test-vectors.csv".to_owned(), test_vectors(self.source)));
        files.push((self.scene_file(), self.source.text.clone().into_bytes()));
        let mut names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
        names.sort();
        let error = self.error();
        let readme = page::readme(
            self.source,
            self.engine,
            [&self.scene_file(), &self.command(), &error, &self.cost()],
            self.notes(),
            &names,
        )?;
        files.push(("README.md".to_owned(), readme.into_bytes()));
        Ok(files)
    }

    /// The code of a file, judged.
    fn code(&self, file: &EngineFile) -> Result<String, Failure> {
        let language = file.language()?;
        let inputs = self.inputs();
        let given: Vec<String> =
            inputs.iter().map(|input| self.expression(file, input)).collect::<Result<_, Failure>>()?;
        let signature = template(&file.template)?.replace("{{ signature }}", &file.signature);
        let parameters: Vec<&str> = file.parameters.iter().map(|[name, _]| name.as_str()).collect();
        let wrapper = Wrapper { name: &file.template, template: &signature, given: &given, parameters: &parameters };
        let command = self.command();
        let emission = Emission { language, command: &command, source_lines: false };
        let facts = [format!("Error: {}.", self.error()), format!("Cost: {}.", self.cost())];
        let mut text = wrapped(&self.source.shading, emission, PREFIX, &facts, &wrapper)?;
        if file.writer.is_none() && text.lines().any(|line| line.starts_with("enable ")) {
            return Err(Failure::input(
                format!(
                    "half precision in WGSL needs `enable f16;` above the whole shader, where {} has text of its own",
                    self.engine.title
                ),
                "leave `precision = \"half\"` out of [emit]",
            ));
        }
        if file.highp {
            text = with_highp(&text);
        }
        let judged = file.judged(&text);
        let refusal = |error| refused(&file.file, &judged, error);
        judge_text(language, Form::Library, &file.file, &judged).map_err(refusal)?;
        match file.writer {
            Some(writer) => written_by(writer, &file.file, &judged).map_err(refusal),
            None => Ok(text),
        }
    }

    fn expression(&self, file: &EngineFile, input: &Input) -> Result<String, Failure> {
        file.expression(&input.name).map(str::to_owned).ok_or_else(|| {
            Failure::input(
                format!("{} has no {} for the scene to take at run time", self.engine.title, input.name),
                format!(
                    "fix it in the scene; or let the base follow the engine's colour, by `workflow = \"f0\"` with \
                     `f0 = \"input\"` in [base]; {} has {}",
                    self.engine.title,
                    file.parameters
                        .iter()
                        .map(|[_, inputs]| inputs.replace(' ', " or "))
                        .collect::<Vec<_>>()
                        .join(", ")
                ),
            )
        })
    }

    fn inputs(&self) -> Vec<Input> {
        self.source.shading.program(ShadingQuantity::Reflectance).inputs().to_vec()
    }

    fn error(&self) -> String {
        let VariantErrors { max, rms, mean_delta_e, max_delta_e, .. } = self.errors;
        format!(
            "max {max:.2e}, RMS {rms:.2e}, dE2000 mean {mean_delta_e:.3} and max {max_delta_e:.2}, against the exact \
             spectral reference over the scene"
        )
    }

    fn operations(&self) -> pavo_shade::Operations {
        self.source.shading.program(ShadingQuantity::Reflectance).operations()
    }

    fn cost(&self) -> String {
        format!(
            "{} operations an evaluation, quotients, roots, sines and the like counted as four",
            self.operations().weight()
        )
    }

    fn command(&self) -> String {
        let variant = self.source.shading.variant();
        format!(
            "pavo export {} --engine {} --variant {variant}",
            quoted(Path::new(&self.scene_file())),
            self.engine.name
        )
    }

    fn scene_file(&self) -> String {
        self.source.path.file_name().map_or_else(|| "scene.toml".to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// What becomes of the base, or would, in an engine that only has an F0.
    fn note_of_f0(&self) -> Option<String> {
        let shown = |color: [f64; 3]| format!("[{}]", color.map(|channel| format!("{channel:.3}")).join(", "));
        if let Some(loss) = &self.loss {
            return Some(format!(
                "This scene fixes the base, which loses nothing. Known by its F0 {} alone, the exact colours would be \
                 dE2000 {:.2} off in the mean over the scene; with the edge tint {}, {:.2}: `workflow = \"f0\"` in [base].",
                shown(loss.f0),
                loss.mean_delta_e,
                shown(loss.edge_tint),
                loss.mean_delta_e_with_edge_tint,
            ));
        }
        let Base::F0 { edge_tint, .. } = self.source.shading.scene().base else { return None };
        Some(match edge_tint {
            Some(ColourQuantity::Fixed(edge_tint)) => format!(
                "The engine has no edge tint: that of the scene, {}, is a constant of the code. Each channel has one index.",
                shown(edge_tint)
            ),
            _ => "Without an edge tint in the scene the base is a dielectric in each channel: it has the right colour at \
                  normal incidence, and no phase of a metal."
                .to_owned(),
        })
    }

    /// What the engine gives and the scene does not take, and what the engine loses.
    fn notes(&self) -> Vec<String> {
        let inputs = self.inputs();
        let mut notes = Vec::new();
        if let Some(file) = self.engine.files.first() {
            let ignored: Vec<&str> = file
                .parameters
                .iter()
                .filter(|[_, names]| !inputs.iter().any(|input| names.split(' ').any(|name| name == input.name)))
                .map(|[name, _]| name.as_str())
                .collect();
            if !ignored.is_empty() {
                notes.push(format!("The scene fixes what the engine passes as {}: it is ignored.", ignored.join(", ")));
            }
            let ranged = inputs.iter().filter(|input| file.given.get(&input.name).is_none_or(|text| text != "1.0"));
            let ranges: Vec<String> =
                ranged.map(|input| format!("{} in [{}, {}]", input.name, input.low, input.high)).collect();
            if !ranges.is_empty() {
                notes.push(format!("What is passed is held within the ranges of the scene: {}.", ranges.join(", ")));
            }
        }
        if !self.engine.loses.is_empty() {
            notes.push(self.engine.loses.clone());
            notes.extend(self.note_of_f0());
        }
        notes
    }
}
