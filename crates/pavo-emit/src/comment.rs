//! Comments, filled to the width of the text.

use crate::dialect::{Dialect, Syntax};
use crate::text::WIDTH;

/// A paragraph of a comment.
pub struct Paragraph {
    text: String,
    /// What its lines after the first begin with.
    hanging: &'static str,
}

impl Paragraph {
    /// An entry of a list: its further lines stand further in.
    pub fn entry(text: String) -> Self {
        Self { text, hanging: "    " }
    }

    /// What a parameter means.
    pub fn of_parameter(dialect: &Dialect, name: &str, doc: &str) -> Self {
        match dialect.syntax {
            Syntax::Rust => Self { text: format!("- `{name}`: {}", lower_first(doc)), hanging: "  " },
            _ => Self::entry(format!("{name}: {}", lower_first(&doc.replace('`', "")))),
        }
    }

    /// An empty line.
    pub fn empty() -> Self {
        Self { text: String::new(), hanging: "" }
    }

    /// The paragraphs of a doc comment: lines up to an empty one belong together. Marks of the documentation are left
    /// out where the language has none.
    pub fn of_doc(dialect: &Dialect, lines: &[String]) -> Vec<Self> {
        let mut paragraphs: Vec<Self> = Vec::new();
        for block in lines.split(|line| line.is_empty()).filter(|block| !block.is_empty()) {
            if !paragraphs.is_empty() {
                paragraphs.push(Self::empty());
            }
            let text = block.join(" ");
            let text = if dialect.syntax == Syntax::Rust { text } else { text.replace('`', "") };
            paragraphs.push(Self { text, hanging: "" });
        }
        paragraphs
    }
}

/// A comment on what stands after it; an empty paragraph is an empty line.
pub fn doc_comment(dialect: &Dialect, paragraphs: &[Paragraph]) -> String {
    filled(dialect.doc_comment, paragraphs, dialect.syntax == Syntax::Rust)
}

/// A comment on nothing in particular.
pub fn comment(paragraphs: &[Paragraph]) -> String {
    filled("//", paragraphs, false)
}

fn filled(marker: &str, paragraphs: &[Paragraph], is_markdown: bool) -> String {
    let mut text = String::new();
    for paragraph in paragraphs {
        let mut line = String::from(marker);
        for word in chunks(&paragraph.text, is_markdown) {
            if line.len() + 1 + word.len() > WIDTH {
                text.push_str(&line);
                text.push('\n');
                line = format!("{marker}{}", paragraph.hanging);
            }
            line.push(' ');
            line.push_str(&word);
        }
        text.push_str(&line);
        text.push('\n');
    }
    text
}

/// The words of a text. In Markdown a sign at the start of a line is read as a list or a quotation: it stays behind the
/// word before it.
fn chunks(text: &str, is_markdown: bool) -> Vec<String> {
    let mut chunks: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match chunks.last_mut() {
            Some(last) if is_markdown && begins_a_block(word) => {
                last.push(' ');
                last.push_str(word);
            }
            _ => chunks.push(word.to_owned()),
        }
    }
    chunks
}

fn begins_a_block(word: &str) -> bool {
    let number = word.trim_end_matches(['.', ')']);
    let is_number = number.len() < word.len() && number.bytes().all(|byte| byte.is_ascii_digit());
    word.starts_with(['>', '#', '=', '-', '+', '*', '|']) || is_number
}

fn lower_first(text: &str) -> String {
    let mut characters = text.chars();
    match (characters.next(), characters.next()) {
        (Some(first), Some(second)) if second.is_lowercase() || second == ' ' => {
            first.to_lowercase().collect::<String>() + &text[first.len_utf8()..]
        }
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Paragraph, doc_comment};
    use crate::Language;
    use crate::dialect::Dialect;

    #[test]
    fn no_line_of_a_comment_in_rust_begins_a_list_or_a_quotation() {
        let long =
            "the value of what is described here at some length, in a unit that has a name, nm, which is".to_owned();
        let rust = Dialect::of(Language::Rust);
        let text = doc_comment(rust, &[Paragraph::of_parameter(rust, "x", &(long + " >= 0 - 1."))]);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[1], "///   is >= 0 - 1.");
    }
}
