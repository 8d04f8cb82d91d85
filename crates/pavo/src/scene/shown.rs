//! A user's text and numbers as messages show them.

/// `text` in one short line: control characters escaped, so that none reaches a terminal, and the end left out.
pub(super) fn shown(text: &str) -> String {
    const LONGEST: usize = 60;
    let mut line = String::new();
    for (index, character) in text.chars().enumerate() {
        if index == LONGEST {
            line.push('…');
            break;
        }
        if character.is_control() {
            line.extend(character.escape_default());
        } else {
            line.push(character);
        }
    }
    line
}

/// A number as a person writes it: plain where that is short, else with an exponent.
pub(super) fn shown_number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::{shown, shown_number};

    #[test]
    fn text_is_shown_short_and_without_control_characters() {
        assert_eq!(shown("soap-été"), "soap-été");
        assert_eq!(shown("a\u{1b}[31m\nb"), "a\\u{1b}[31m\\nb");
        assert_eq!(shown(&"x".repeat(60)), "x".repeat(60));
        assert_eq!(shown(&"x".repeat(61)), format!("{}…", "x".repeat(60)));
    }

    #[test]
    fn numbers_are_shown_as_a_person_writes_them() {
        let cases = [
            (0.0, "0"),
            (-1.5, "-1.5"),
            (1e6, "1000000"),
            (1e-4, "0.0001"),
            (1e-5, "1e-5"),
            (1e300, "1e300"),
            (-2e7, "-2e7"),
        ];
        for (value, expected) in cases {
            assert_eq!(shown_number(value), expected);
        }
    }
}
