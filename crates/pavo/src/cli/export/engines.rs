//! The table of engines, and the templates it names.

use crate::cli::failure::Failure;
use crate::target::Target;
use pavo_emit::Language;
use serde::Deserialize;
use std::collections::BTreeMap;

const TABLE: &str = include_str!("../../../../../templates/engines/engines.toml");

macro_rules! templates {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../../../../templates/engines/", $name)))),*]
    };
}

const TEMPLATES: &[(&str, &str)] = templates![
    "README.md",
    "check.html",
    "check-wgsl.html",
    "bevy/module.wgsl",
    "blender/shader.osl",
    "filament/thin_film.mat",
    "function.glsl",
    "function.hlsl",
    "function.wgsl",
    "godot/include.gdshaderinc",
    "materialx/function.glsl",
    "materialx/pavo_thin_film.mtlx",
    "playcanvas/chunk.glsl",
    "playcanvas/chunk.wgsl",
    "slang/module.slang",
    "three-wgsl/thin-film-material.js",
    "three/iridescence_fragment.glsl",
    "unity/function.hlsl",
];

/// The whole table.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Engines {
    engine: Vec<Engine>,
}

/// An engine.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Engine {
    /// Its name on the command line.
    pub name: String,
    /// What it is called.
    pub title: String,
    /// The client of `cargo xtask clients` that runs the export; empty where it is judged only.
    #[serde(default)]
    pub client: String,
    /// With which version it was tried.
    pub tried: String,
    /// How it was verified.
    pub verified: String,
    /// Where the files go.
    pub hook: String,
    /// What is lost of the scene in this engine; empty for nothing.
    #[serde(default)]
    pub loses: String,
    /// Templates that are copied as they are.
    #[serde(default)]
    pub beside: Vec<String>,
    /// The files.
    #[serde(rename = "file")]
    pub files: Vec<EngineFile>,
}

/// A file of code for an engine.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EngineFile {
    /// Its name.
    pub file: String,
    /// The name of its language.
    pub language: String,
    /// The name of its template.
    pub template: String,
    /// The signature of the function that the engine calls.
    pub signature: String,
    /// What the engine has above the text.
    #[serde(default)]
    pub before: String,
    /// Lines that are the engine's own and not the language's.
    #[serde(default)]
    pub engine_syntax: Vec<String>,
    /// The line that opens the block in which the code stands; empty where the file has no blocks.
    #[serde(default)]
    pub block: String,
    /// Whether each declaration says that it is highp.
    #[serde(default)]
    pub highp: bool,
    /// The language that the judged text is then written in.
    pub writer: Option<Writer>,
    /// The parameters of the signature: their names, and the names of the inputs that each may be for.
    pub parameters: Vec<[String; 2]>,
    /// Inputs that the engine has in another way, with the expression for each.
    #[serde(default)]
    pub given: BTreeMap<String, String>,
    /// The function that the check page calls, of WebGL for GLSL and of WebGPU for WGSL; empty where there is no page.
    #[serde(default)]
    pub check: String,
}

/// Who writes a judged text in another language.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Writer {
    /// naga, in the Metal Shading Language.
    Msl,
}

impl EngineFile {
    /// The language.
    pub fn language(&self) -> Result<Language, Failure> {
        match self.language.parse() {
            Ok(Target::Text(language)) => Ok(language),
            _ => Err(broken(format!("`{}` is no language of text", self.language))),
        }
    }

    /// The name of the language that the file is in at last.
    pub fn written_language(&self) -> &str {
        match self.writer {
            Some(Writer::Msl) => "msl",
            None => &self.language,
        }
    }

    /// The parameter that an input is passed by.
    pub fn parameter(&self, input: &str) -> Option<&str> {
        let of = |[_, inputs]: &&[String; 2]| inputs.split(' ').any(|name| name == input);
        self.parameters.iter().find(of).map(|[name, _]| name.as_str())
    }

    /// The expression that an input has in the engine.
    pub fn expression(&self, input: &str) -> Option<&str> {
        self.parameter(input).or_else(|| self.given.get(input).map(String::as_str))
    }

    /// The text as the judges see it: under what the engine has above it, with lines that are the engine's own empty.
    pub fn judged(&self, text: &str) -> String {
        let lines: Vec<&str> = text.lines().collect();
        // A block ends at the last line of the file.
        let opened = lines.iter().position(|line| !self.block.is_empty() && *line == self.block);
        let code = opened.map_or(0..lines.len(), |line| line + 1..lines.len() - 1);
        let mut judged: String = if self.before.is_empty() { String::new() } else { format!("{}\n", self.before) };
        for (index, line) in lines.into_iter().enumerate() {
            if code.contains(&index) && !self.engine_syntax.iter().any(|own| own == line) {
                judged.push_str(line);
            }
            judged.push('\n');
        }
        judged
    }
}

/// All engines.
pub fn engines() -> Result<Vec<Engine>, Failure> {
    let table: Engines = toml::from_str(TABLE).map_err(|error| broken(error.to_string()))?;
    Ok(table.engine)
}

/// The engine of a name.
pub fn engine(name: &str) -> Result<Engine, Failure> {
    let engines = engines()?;
    let names: Vec<String> = engines.iter().map(|engine| engine.name.clone()).collect();
    engines.into_iter().find(|engine| engine.name == name).ok_or_else(|| {
        Failure::input(
            format!("unknown engine `{}`", name.escape_debug()),
            format!("the engines are {}; pavo export --list says more of them", names.join(", ")),
        )
    })
}

/// The template of a name.
pub fn template(name: &str) -> Result<&'static str, Failure> {
    let found = TEMPLATES.iter().find(|(known, _)| *known == name);
    found.map(|(_, text)| *text).ok_or_else(|| broken(format!("there is no template {name}")))
}

fn broken(message: String) -> Failure {
    Failure::check(format!("the table of engines is broken: {message}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_names_a_language_and_a_template() {
        let engines = engines().unwrap_or_else(|_| panic!("the table can be read"));
        for file in engines.iter().flat_map(|engine| &engine.files) {
            assert!(file.language().is_ok(), "{}", file.file);
            assert!(template(&file.template).is_ok(), "{}", file.template);
        }
    }

    #[test]
    fn what_goes_beside_the_code_is_there() {
        let engines = engines().unwrap_or_else(|_| panic!("the table can be read"));
        for name in engines.iter().flat_map(|engine| &engine.beside) {
            assert!(template(name).is_ok(), "{name}");
        }
    }

    #[test]
    fn parameters_stand_in_their_signature() {
        let engines = engines().unwrap_or_else(|_| panic!("the table can be read"));
        for file in engines.iter().flat_map(|engine| &engine.files) {
            for [name, _] in &file.parameters {
                assert!(file.signature.contains(name.as_str()), "{name} is not in {}", file.signature);
            }
        }
    }
}
