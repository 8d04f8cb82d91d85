//! Shaders made by a `build.rs`.

mod error;
mod module;

pub use error::BuildError;

use crate::emission::{library, uniforms};
use crate::scene::Scene;
use crate::shading::Shading;
use crate::variant::Variant;
use pavo_emit::{Dialect, Language};
use std::path::{Path, PathBuf};

/// Emits a scene from a `build.rs`: the text of each target, and a Rust module that takes it in.
///
/// ```no_run
/// fn main() -> Result<(), pavo::BuildError> {
///     let build = pavo::Build::scene("scenes/bubble.toml").target(pavo::Language::Wgsl).target(pavo::Language::Rust);
///     build.emit()?;
///     Ok(())
/// }
/// ```
///
/// The module stands in `OUT_DIR` under the name of the scene, and is taken in by
///
/// ```ignore
/// #[allow(dead_code)]
/// mod bubble {
///     include!(concat!(env!("OUT_DIR"), "/bubble.rs"));
/// }
/// ```
///
/// It has the text of each target as a constant (`WGSL`, `GLSL_450`, `GLSL_330`, `ESSL_300`); `SurfaceUniforms`, what is
/// uniform over a material, with the layout of the struct of this name in the text; and, with the target
/// [`Language::Rust`], the functions for the CPU over the vectors of glam.
///
/// Cargo is told to run the script again when the scene or a file that it names changes. With the feature `cli` each text
/// passes its judges here. Without it no judge is built in and the texts are written as they are; `pavo emit` judges the
/// same functions.
#[derive(Clone, Debug)]
pub struct Build {
    source: Source,
    variant: Option<String>,
    targets: Vec<Language>,
    out_dir: Option<PathBuf>,
    import_path: Option<String>,
}

#[derive(Clone, Debug)]
enum Source {
    File(PathBuf),
    Scene(Box<Scene>),
}

/// What was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    /// The Rust module.
    pub module: PathBuf,
    /// The texts, in the order in which their targets were named; that of Rust is in the module.
    pub texts: Vec<PathBuf>,
    /// What should be said of the scene's data, as cargo says it too.
    pub warnings: Vec<String>,
}

impl Build {
    /// A scene from its file; a relative path is one from the folder of the package.
    pub fn scene(path: impl Into<PathBuf>) -> Self {
        Self::new(Source::File(path.into()))
    }

    /// A scene that is made in Rust.
    pub fn of(scene: Scene) -> Self {
        Self::new(Source::Scene(Box::new(scene)))
    }

    fn new(source: Source) -> Self {
        Self { source, variant: None, targets: Vec::new(), out_dir: None, import_path: None }
    }

    /// The variant, such as `windowed:k=6`, in place of that of the scene.
    pub fn variant(self, variant: &str) -> Self {
        Self { variant: Some(variant.to_owned()), ..self }
    }

    /// One more language to emit.
    pub fn target(mut self, language: Language) -> Self {
        if !self.targets.contains(&language) {
            self.targets.push(language);
        }
        self
    }

    /// The folder to write to, in place of cargo's `OUT_DIR`.
    pub fn out_dir(self, folder: impl Into<PathBuf>) -> Self {
        Self { out_dir: Some(folder.into()), ..self }
    }

    /// The path by which WGSL is imported where naga_oil composes it, as Bevy does: `pavo::thin_film`.
    pub fn import_path(self, path: &str) -> Self {
        Self { import_path: Some(path.to_owned()), ..self }
    }

    /// Writes the texts and the module, each whole or not at all.
    ///
    /// # Errors
    /// If the scene or the variant is no good, no target is named, or a file cannot be written. The `Debug` of the error
    /// is the message that a `main` shows: where it is, what is wrong and what would be right.
    pub fn emit(&self) -> Result<Built, BuildError> {
        let scene = match &self.source {
            Source::File(path) => {
                tell_cargo("rerun-if-changed", path.display());
                Scene::load(path)?
            }
            Source::Scene(scene) => {
                scene.validate()?;
                (**scene).clone()
            }
        };
        scene.files().into_iter().for_each(|path| tell_cargo("rerun-if-changed", path.display()));
        let folder = self.folder()?;
        if self.targets.is_empty() {
            let help = "name at least one: `.target(pavo::Language::Wgsl)`";
            return Err(BuildError::new("the build has no target: nothing would be emitted", help));
        }
        if let Some(path) = self.import_path.as_deref().filter(|path| !is_import_path(path)) {
            let help = "names of letters, digits and underscores with `::` between them, such as `pavo::thin_film`";
            return Err(BuildError::new(format!("`{}` is no import path", path.escape_debug()), help));
        }
        let shading = self.shading(&scene).map_err(|error| match &self.source {
            Source::File(path) => error.in_file(path),
            Source::Scene(_) => error,
        })?;
        let warnings = shading.warnings();
        warnings.iter().for_each(|warning| tell_cargo("warning", warning));
        let mut texts = Vec::new();
        for language in self.targets.iter().copied().filter(|language| *language != Language::Rust) {
            let text = self.text(&shading, language);
            #[cfg(feature = "cli")]
            self.judge(language, &scene.name, &text)?;
            let path = folder.join(file_name(&scene.name, language));
            write(&path, &text)?;
            texts.push(path);
        }
        let module = folder.join(format!("{}.rs", scene.name));
        write(&module, &module::module(&shading, &self.targets))?;
        Ok(Built { module, texts, warnings })
    }

    fn shading(&self, scene: &Scene) -> Result<Shading, BuildError> {
        let variant = self.variant.as_deref().unwrap_or(&scene.emit.variant);
        if variant == "auto" {
            let help = "name the one that `pavo tune` picks for the scene, such as `variant = \"windowed:k=6\"`";
            return Err(BuildError::new("the variant `auto` is picked by measuring, which no build script does", help));
        }
        let variant: Variant = variant.parse()?;
        Ok(Shading::new(scene, &variant)?)
    }

    fn folder(&self) -> Result<PathBuf, BuildError> {
        let named = self.out_dir.clone().or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from));
        named.ok_or_else(|| {
            let help = "call it from a build.rs, or name a folder: `.out_dir(\"generated\")`";
            BuildError::new("there is no folder to write to: cargo sets OUT_DIR for build scripts alone", help)
        })
    }

    /// The functions, and the struct of what is uniform.
    fn text(&self, shading: &Shading, language: Language) -> String {
        let mut text = library(shading, language);
        if let Some(uniforms) = uniforms(shading, language) {
            text = format!("{text}\n{uniforms}");
        }
        match &self.import_path {
            Some(path) if language == Language::Wgsl => format!("#define_import_path {path}\n\n{text}"),
            _ => text,
        }
    }

    #[cfg(feature = "cli")]
    fn judge(&self, language: Language, name: &str, text: &str) -> Result<(), BuildError> {
        // The line is for naga_oil, which takes it away.
        let text = text.lines().filter(|line| !line.starts_with("#define_import_path ")).collect::<Vec<_>>().join("\n");
        pavo_check::judge_text(language, pavo_emit::Form::Library, &file_name(name, language), &text)
            .map(|_| ())
            .map_err(|error| BuildError::new(error, "this is a fault of pavo, or a judge is missing: `pavo doctor`"))
    }
}

/// The name of the file with a scene in a language.
fn file_name(scene: &str, language: Language) -> String {
    format!("{scene}.{}", Dialect::of(language).extension)
}

fn is_import_path(path: &str) -> bool {
    path.split("::").all(|name| {
        name.starts_with(|first: char| first.is_ascii_alphabetic())
            && name.chars().all(|character| character.is_ascii_alphanumeric() || character == '_')
    })
}

/// Says something to cargo, where it runs this as a build script.
fn tell_cargo(what: &str, value: impl std::fmt::Display) {
    if std::env::var_os("OUT_DIR").is_some() {
        println!("cargo::{what}={}", value.to_string().replace('\n', " "));
    }
}

/// Writes a file whole or not at all.
fn write(path: &Path, text: &str) -> Result<(), BuildError> {
    pavo_files::write(path, text.as_bytes()).map_err(|error| {
        let help = "name a folder that is there and can be written to";
        BuildError::new(format!("{} cannot be written: {error}", pavo_files::shown(path)), help)
    })
}
