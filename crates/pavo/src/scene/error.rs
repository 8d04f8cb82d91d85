//! The one error of this module.

use std::fmt;
use std::ops::Range;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};

/// Why a scene was refused: what is wrong, where in the file, and what would be right.
///
/// Through [`miette::Diagnostic`] it carries the text of the scene, a label at the offending value and the help.
/// (A line too long to be drawn is not; the sentence then names line and column.) `Display` is the sentence alone; `Debug`, which a build script's `main` prints, is
/// `file:line:column: sentence` with the help on a second line.
#[derive(Clone)]
pub struct SceneError {
    detail: Box<Detail>,
}

#[derive(Clone)]
struct Detail {
    message: String,
    help: String,
    key: Option<String>,
    labels: Vec<(Range<usize>, String)>,
    source: Option<NamedSource<String>>,
    drawable: bool,
}

impl SceneError {
    /// An error that is in no text: a file that cannot be read, or a scene built in Rust.
    pub(super) fn without_source(message: String, help: String, key: Option<String>) -> Self {
        SceneError {
            detail: Box::new(Detail { message, help, key, labels: Vec::new(), source: None, drawable: false }),
        }
    }

    /// The same error in the text `text` of the file `file_name`, the first label being where it is.
    pub(super) fn in_source(mut self, file_name: &str, text: &str, labels: Vec<(Range<usize>, String)>) -> Self {
        self.detail.labels = labels.into_iter().map(|(span, label)| (visible(span, text), label)).collect();
        self.detail.source = Some(NamedSource::new(file_name, text.to_owned()).with_language("toml"));
        self.detail.drawable = self.detail.labels.iter().all(|(span, _)| is_drawable(span, text));
        if let (false, Some((_, line, column))) = (self.detail.drawable, self.location()) {
            self.detail.message.push_str(&format!(" (line {line}, column {column})"));
        }
        self
    }

    /// What would be right.
    pub fn help_text(&self) -> &str {
        &self.detail.help
    }

    /// The key at fault, such as `film.thickness_nm` or `emit.targets[1]`; `None` if it is the file as a whole.
    pub fn key(&self) -> Option<&str> {
        self.detail.key.as_deref()
    }

    /// The bytes of the scene's text at fault; `None` if the scene has no text.
    pub fn span(&self) -> Option<Range<usize>> {
        self.detail.labels.first().map(|(span, _)| span.clone())
    }

    /// The file name, and the line and column of [`SceneError::span`], both from 1, the column in characters.
    pub fn location(&self) -> Option<(&str, usize, usize)> {
        let source = self.detail.source.as_ref()?;
        let before = source.inner().get(..self.span()?.start)?;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line = before.matches('\n').count() + 1;
        Some((source.name(), line, before[line_start..].chars().count() + 1))
    }
}

/// A span that can be drawn: within the text, of whole characters; an empty one at the very end of the text takes in
/// the character before it.
fn visible(span: Range<usize>, text: &str) -> Range<usize> {
    let boundary = |at: usize| (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let start = boundary(span.start);
    let span = start..boundary(span.end).max(start);
    match text.chars().next_back() {
        Some(last) if span.is_empty() && span.end == text.len() => text.len() - last.len_utf8()..text.len(),
        _ => span,
    }
}

/// Whether the lines that `span` is on are short enough to be drawn.
///
/// miette pads with a format width, which panics past column 65,535; a tab of one byte is drawn four columns wide.
fn is_drawable(span: &Range<usize>, text: &str) -> bool {
    const LONGEST_LINE: usize = 4096;
    let start = text[..span.start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[span.end..].find('\n').map_or(text.len(), |at| span.end + at);
    text[start..end].lines().all(|line| line.len() <= LONGEST_LINE)
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.detail.message)
    }
}

impl fmt::Debug for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((file, line, column)) = self.location() {
            write!(formatter, "{file}:{line}:{column}: ")?;
        }
        write!(formatter, "{}\n  help: {}", self.detail.message, self.detail.help)
    }
}

impl std::error::Error for SceneError {}

impl Diagnostic for SceneError {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new("pavo::scene"))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(&self.detail.help))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.detail.source.as_ref().filter(|_| self.detail.drawable).map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        if !self.detail.drawable {
            return None;
        }
        let labels = self.detail.labels.iter().enumerate().map(|(index, (span, label))| {
            let text = Some(label.clone());
            if index == 0 {
                LabeledSpan::new_primary_with_span(text, span.clone())
            } else {
                LabeledSpan::new_with_span(text, span.clone())
            }
        });
        Some(Box::new(labels))
    }
}
