//! Long lines, broken where a person would break them.

/// A statement over several lines where it is longer than the width: broken after a comma or before an operator that
/// stands as little inside parentheses as possible.
pub fn broken_line(statement: &str, width: usize) -> String {
    let mut lines = String::new();
    let mut rest = statement;
    let mut depth = 0;
    let mut room = width;
    while rest.len() > room {
        let Some(place) = best_place(rest, room, depth) else { break };
        depth += depth_change(&rest[..place]);
        lines.push_str(rest[..place].trim_end());
        lines.push_str("\n    ");
        rest = rest[place..].trim_start();
        room = width - 4;
    }
    lines + rest
}

/// Where to break: before an operator, or after a comma where none is as little deep; of the places that fit, the last of
/// those that are least deep.
fn best_place(text: &str, room: usize, outside: i32) -> Option<usize> {
    let mut depth = outside;
    let mut best: Option<((i32, bool), usize)> = None;
    for (index, character) in text.char_indices() {
        if index >= room {
            break;
        }
        depth += depth_change(&text[index..index + character.len_utf8()]);
        let place = match character {
            ',' => Some(index + 1),
            ' ' if [" + ", " - ", " * "].iter().any(|operator| text[index..].starts_with(operator)) => Some(index),
            _ => None,
        };
        if let Some(place) = place.filter(|place| *place > 8)
            && best.is_none_or(|(least, _)| (depth, character == ',') <= least)
        {
            best = Some(((depth, character == ','), place));
        }
    }
    best.map(|(_, place)| place)
}

fn depth_change(text: &str) -> i32 {
    text.chars()
        .map(|character| match character {
            '(' | '[' => 1,
            ')' | ']' => -1,
            _ => 0,
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::broken_line;

    #[test]
    fn long_lines_break_at_the_outermost_place_that_fits() {
        let cases = [
            ("let a = b + c;", "let a = b + c;"),
            ("let total = first(a, b) + second(c, d);", "let total = first(a, b)\n    + second(c, d);"),
            ("let total = function(first, second, third);", "let total = function(first, second,\n    third);"),
            ("let unbreakable_name = another_unbreakable_name;", "let unbreakable_name = another_unbreakable_name;"),
        ];
        for (line, expected) in cases {
            assert_eq!(broken_line(line, 36), expected);
        }
    }
}
