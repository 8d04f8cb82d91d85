//! The two roads from text to a scene: a text in memory, and a file.

use std::io::ErrorKind;
use std::path::Path;

use toml::de::DeTable;

use super::error::SceneError;
use super::fault::{Checked, Fault};
use super::model::{Base, FilmMedium, IlluminantSource, Scene};
use super::places::Places;
use super::read::read;
use super::shown::shown;
use super::validate::check;
use pavo_files::read_up_to;

/// The largest scene file that is read, in bytes: 1 MiB, a thousand times the usual size.
pub const MAXIMUM_FILE_BYTES: usize = 1 << 20;

impl Scene {
    /// The scene that `text` describes. No file is touched.
    ///
    /// `file_name` is what errors call the text; `directory` is what a relative `csv` is joined to.
    ///
    /// # Errors
    /// The first thing wrong with the text: its size, its syntax, its shape or a value.
    pub fn from_toml(file_name: &str, text: &str, directory: &Path) -> Result<Scene, SceneError> {
        parse(file_name, text, directory, |_| Ok(()))
    }

    /// The scene in the file `path`; a relative `csv` in it is joined to the folder of the file.
    ///
    /// # Errors
    /// A file that cannot be read, is larger than [`MAXIMUM_FILE_BYTES`] or is not UTF-8; a `csv` that is not there;
    /// and everything that [`Scene::from_toml`] refuses.
    pub fn load(path: &Path) -> Result<Scene, SceneError> {
        Self::load_with_text(path).map(|(scene, _)| scene)
    }

    /// The same with the text of the file, which may be a pipe that is read once.
    pub(crate) fn load_with_text(path: &Path) -> Result<(Scene, String), SceneError> {
        let file_name = pavo_files::shown(path);
        let bytes = read_file(path, &file_name)?;
        let directory = path.parent().unwrap_or(Path::new(""));
        match String::from_utf8(bytes) {
            Ok(text) => parse(&file_name, &text, directory, check_table_is_a_file).map(|scene| (scene, text)),
            Err(error) => Err(not_utf8(&file_name, error.as_bytes(), error.utf8_error().valid_up_to())),
        }
    }
}

fn parse(
    file_name: &str,
    text: &str,
    directory: &Path,
    check_files: impl Fn(&Scene) -> Checked<()>,
) -> Result<Scene, SceneError> {
    if text.len() > MAXIMUM_FILE_BYTES {
        return Err(too_large(
            file_name,
            &format!("it has {} bytes; the most that are read are {MAXIMUM_FILE_BYTES}", text.len()),
        ));
    }
    let document = DeTable::parse(text).map_err(|error| syntax_error(file_name, text, &error))?;
    let document = document.get_ref();
    let scene = read(document, directory).and_then(|scene| {
        check(&scene)?;
        check_files(&scene)?;
        Ok(scene)
    });
    scene.map_err(|fault| fault.into_error_in(file_name, text, &Places::of(document, text)))
}

fn read_file(path: &Path, file_name: &str) -> Result<Vec<u8>, SceneError> {
    let cannot = |error: std::io::Error| {
        let (message, help) = match error.kind() {
            ErrorKind::FileTooLarge => return too_large(file_name, &error.to_string()),
            ErrorKind::NotFound => (
                format!("there is no scene file `{file_name}`"),
                "check the path, or write a new scene with `pavo new NAME`",
            ),
            ErrorKind::IsADirectory => {
                (format!("`{file_name}` is a folder, not a scene file"), "name a file, such as `soap-bubble.toml`")
            }
            ErrorKind::TimedOut => (
                format!("the scene file `{file_name}` cannot be read: {error}"),
                "name an ordinary file, or a pipe that somebody writes to",
            ),
            _ => (
                format!("the scene file `{file_name}` cannot be read: {error}"),
                "check that the file may be read by this user",
            ),
        };
        SceneError::without_source(message, help.to_owned(), None)
    };
    read_up_to(path, MAXIMUM_FILE_BYTES).map_err(cannot)
}

fn too_large(file_name: &str, size: &str) -> SceneError {
    let message = format!("the scene file `{file_name}` is too large: {size}");
    let help = "a scene has about a kilobyte; optical constants go into a CSV file that `base.csv` names";
    SceneError::without_source(message, help.to_owned(), None)
}

fn not_utf8(file_name: &str, bytes: &[u8], valid: usize) -> SceneError {
    let text = String::from_utf8_lossy(bytes);
    let message = format!("`{file_name}` is not UTF-8: byte {} starts no character", valid + 1);
    let help = "save the file as UTF-8; a scene is text, not a binary file";
    // The replacement character is three bytes long and stands at the first byte that is not UTF-8.
    let label = (valid..valid + char::REPLACEMENT_CHARACTER.len_utf8(), "not UTF-8".to_owned());
    SceneError::without_source(message, help.to_owned(), None).in_source(file_name, &text, vec![label])
}

fn syntax_error(file_name: &str, text: &str, error: &toml::de::Error) -> SceneError {
    let end = text.trim_end().len();
    let span = error.span().filter(|span| span.start < end).unwrap_or(end..end);
    let found = text.get(span.clone()).unwrap_or_default();
    let reason = error.message().trim().replace('\n', "; ");
    // The parser takes whatever is no value for a string without quotes, even where nothing is.
    let bare_word = reason.contains("string values must be quoted");
    let (reason, help) = if bare_word && found.trim().is_empty() {
        ("the value is missing".to_owned(), "write a value after the `=`, such as a number or a range".to_owned())
    } else if bare_word {
        let found = shown(found);
        let help = format!("strings are in quotes: \"{found}\"; truth values are true and false");
        (format!("`{found}` is not a value"), help)
    } else if reason.contains("duplicate key") {
        (reason, "keep one of the two: a key or a table is given once".to_owned())
    } else {
        let help = "a line is `key = value` or `[table]`; strings are in quotes, a range is [low, high], \
                    # starts a comment";
        (reason, help.to_owned())
    };
    let message = format!("the scene is not valid TOML: {reason}");
    SceneError::without_source(message, help, None).in_source(file_name, text, vec![(span, reason)])
}

fn check_table_is_a_file(scene: &Scene) -> Checked<()> {
    let film = match scene.film.as_ref().map(|film| &film.medium) {
        Some(FilmMedium::Table(path)) => Some(("film.csv", path)),
        _ => None,
    };
    let base = match &scene.base {
        Base::Table { path } => Some(("base.csv", path)),
        _ => None,
    };
    let illuminant = match &scene.colour.illuminant {
        IlluminantSource::Table(path) => Some(("colour.illuminant_csv", path)),
        IlluminantSource::Named(_) => None,
    };
    let files = film.into_iter().chain(base).chain(illuminant);
    let Some((key, path)) = files.into_iter().find(|(_, path)| !path.is_file()) else { return Ok(()) };
    let message = format!("`{key}` names `{}`, which is not a file", shown(&path.display().to_string()));
    let help = "the path is taken from the folder of the scene file; \
                the file lists wavelength, n and k, or for an illuminant wavelength and value";
    Err(Fault::at(key, "no such file", message, help))
}
