//! The one error of this module.

use std::fmt;
use std::ops::Range;

/// Why a scene was refused: what is wrong, where in the file, and what would be right.
///
/// `Display` is the sentence alone. `Debug`, which a build script's `main` prints, is `file:line:column: sentence`, then
/// the line of the scene with a mark below what is wrong, then the help. With the feature `points` it is a diagnostic of
/// miette. (A line too long to be drawn is not; the sentence then names the file, line and column.)
#[derive(Clone)]
pub struct SceneError {
    pub(super) detail: Box<Detail>,
}

#[derive(Clone)]
pub(super) struct Detail {
    pub message: String,
    pub help: String,
    pub key: Option<String>,
    pub labels: Vec<(Range<usize>, String)>,
    pub source: Option<Source>,
    pub drawable: bool,
}

/// The text of a scene, and what it is called.
#[derive(Clone, Debug)]
pub(super) struct Source {
    pub name: String,
    pub text: String,
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
        self.detail.source = Some(Source { name: file_name.to_owned(), text: masked(text) });
        self.detail.drawable = self.detail.labels.iter().all(|(span, _)| is_drawable(span, text));
        if let (false, Some((_, line, column))) = (self.detail.drawable, self.location()) {
            self.detail.message.push_str(&format!(" ({file_name}, line {line}, column {column})"));
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
        let before = source.text.get(..self.span()?.start)?;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line = before.matches('\n').count() + 1;
        Some((&source.name, line, before[line_start..].chars().count() + 1))
    }

    /// The line of the scene at fault, with a mark below what is wrong.
    fn drawn(&self) -> Option<String> {
        let (_, number, column) = self.location().filter(|_| self.detail.drawable)?;
        let line = self.detail.source.as_ref()?.text.lines().nth(number - 1)?;
        let (span, label) = self.detail.labels.first()?;
        let before: String = line.chars().take(column - 1).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
        let at = line.char_indices().nth(column - 1).map_or(line.len(), |(at, _)| at);
        let end = (at + span.len()).min(line.len());
        let marks = "^".repeat(line.get(at..end).unwrap_or_default().chars().count().max(1));
        let number = number.to_string();
        let margin = " ".repeat(number.len());
        Some(format!("  {margin} |\n  {number} | {line}\n  {margin} | {before}{marks} {label}\n"))
    }
}

/// The text with a mark in the place of what a terminal would take for a command, byte for byte: places stay what they are.
fn masked(text: &str) -> String {
    let mut masked = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\n' | '\t' => masked.push(character),
            '\r' => masked.push(' '),
            _ if pavo_files::is_printable(character) => masked.push(character),
            _ => masked.extend(std::iter::repeat_n('?', character.len_utf8())),
        }
    }
    masked
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
        writeln!(formatter, "{}", self.detail.message)?;
        if let Some(drawn) = self.drawn() {
            formatter.write_str(&drawn)?;
        }
        write!(formatter, "  help: {}", self.detail.help)
    }
}

impl std::error::Error for SceneError {}
