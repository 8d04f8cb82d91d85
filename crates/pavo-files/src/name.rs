//! Names of files as messages show them.

use std::path::Path;

/// A path in a message: bytes that are no UTF-8 are replaced, and what a terminal would take for a command or a change of
/// direction is escaped. The path is not shortened.
pub fn shown(path: &Path) -> String {
    shown_text(&path.to_string_lossy())
}

/// A text in a message: what a terminal would take for a command or a change of direction is escaped.
pub fn shown_text(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        if is_printable(character) {
            shown.push(character);
        } else {
            shown.extend(character.escape_default());
        }
    }
    shown
}

/// Whether a terminal shows a character as itself.
pub fn is_printable(character: char) -> bool {
    !character.is_control() && !is_directional(character)
}

/// Line separators and marks of the direction of writing, by which a name can look like another one.
fn is_directional(character: char) -> bool {
    matches!(character, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::shown_text;

    #[test]
    fn control_characters_and_marks_of_direction_are_escaped() {
        let cases = [
            ("été/film.toml", "été/film.toml"),
            ("C:\\films\\a 'b'.toml", "C:\\films\\a 'b'.toml"),
            ("a\u{1b}[31m\nb", "a\\u{1b}[31m\\nb"),
            ("a\u{9b}31m\u{7f}", "a\\u{9b}31m\\u{7f}"),
            ("lmot.\u{202e}toml", "lmot.\\u{202e}toml"),
        ];
        for (text, expected) in cases {
            assert_eq!(shown_text(text), expected);
        }
    }
}
