//! What is wrong with a scene, named by key, before it is known whether there is a text to point into.

use super::error::SceneError;
use super::places::{Part, Places};

/// A scene, or a part of one, or the fault in it.
pub(super) type Checked<T> = Result<T, Box<Fault>>;

/// What is wrong, at which key, and what would be right.
#[derive(Debug)]
pub(super) struct Fault {
    message: String,
    help: String,
    marks: Vec<Mark>,
}

/// A key to point at, and what to say there.
#[derive(Debug)]
struct Mark {
    path: String,
    part: Part,
    label: String,
}

impl Fault {
    /// A fault in the value at `path`, or in the nearest table above it that exists.
    pub(super) fn at(
        path: impl Into<String>,
        label: impl Into<String>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Box<Self> {
        let mark = Mark { path: path.into(), part: Part::Value, label: label.into() };
        Box::new(Fault { message: message.into(), help: help.into(), marks: vec![mark] })
    }

    /// The same fault, pointing at the key instead of at its value.
    pub(super) fn in_key(mut self: Box<Self>) -> Box<Self> {
        for mark in &mut self.marks {
            mark.part = Part::Key;
        }
        self
    }

    /// The same fault with one more place to point at.
    pub(super) fn and_at(mut self: Box<Self>, path: impl Into<String>, label: impl Into<String>) -> Box<Self> {
        let part = self.marks[0].part;
        self.marks.push(Mark { path: path.into(), part, label: label.into() });
        self
    }

    /// The error for a scene without a text.
    pub(super) fn into_error(self) -> SceneError {
        let key = self.marks.into_iter().next().map(|mark| mark.path);
        SceneError::without_source(self.message, self.help, key)
    }

    /// The error for a scene read from `text`.
    pub(super) fn into_error_in(self, file_name: &str, text: &str, places: &Places) -> SceneError {
        let labels = self.marks.iter().map(|mark| (places.find(&mark.path, mark.part), mark.label.clone())).collect();
        self.into_error().in_source(file_name, text, labels)
    }
}
