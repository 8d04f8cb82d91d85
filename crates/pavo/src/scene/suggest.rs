//! Finding the name that was probably meant.

use super::vocabulary::{ALIASES, OTHERS};

/// The allowed name nearest to `word`, where one is near enough to be meant.
///
/// In this order: the same but for upper and lower case; a word known to be used for it; one that contains it or is
/// contained in it; the smallest edit distance, if that is at most two fifths of the longer length.
pub(super) fn nearest<'a>(word: &str, allowed: &[&'a str]) -> Option<&'a str> {
    // Beyond this length nothing is near, and the edit distance would be slow.
    const LONGEST: usize = 64;
    if word.chars().count() > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    if OTHERS.contains(&word.as_str()) {
        return None;
    }
    let same = allowed.iter().find(|name| name.to_lowercase() == word);
    let alias = || {
        let (_, meant) = ALIASES.iter().find(|(other, meant)| *other == word && allowed.contains(meant))?;
        allowed.iter().find(|name| *name == meant)
    };
    let part = || {
        let contains = |long: &str, short: &str| short.len() >= 3 && long.contains(short);
        allowed.iter().find(|name| contains(&name.to_lowercase(), &word) || contains(&word, &name.to_lowercase()))
    };
    let near = || {
        let (distance, name) =
            allowed.iter().map(|name| (edit_distance(&word, &name.to_lowercase()), name)).min_by_key(|pair| pair.0)?;
        let longer = word.chars().count().max(name.chars().count());
        (distance * 5 <= longer * 2).then_some(name)
    };
    same.or_else(alias).or_else(part).or_else(near).copied()
}

/// The sentence for a name that is not allowed: the nearest one, if any, and all of them.
pub(super) fn did_you_mean(word: &str, allowed: &[&str], all: &str) -> String {
    match nearest(word, allowed) {
        Some(name) if allowed.len() > 1 => format!("did you mean `{name}`? {all}: {}", allowed.join(", ")),
        _ => format!("{all}: {}", allowed.join(", ")),
    }
}

/// The least number of characters to insert, delete, replace or swap with a neighbour that turns `a` into `b`
/// (optimal string alignment: Damerau 1964, Levenshtein 1966).
fn edit_distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().collect();
    let b: Vec<char> = b.chars().collect();
    let mut before_last: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(before_last[j - 2] + 1);
            }
            row.push(best);
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::super::vocabulary::{ILLUMINANTS, METALS, OBSERVERS, SPACES, TABLES, TARGETS};
    use super::{edit_distance, nearest};

    #[test]
    fn edit_distance_counts_single_edits() {
        let cases = [("", "", 0), ("", "film", 4), ("flim", "film", 1), ("film", "films", 1), ("kitten", "sitting", 3)];
        for (a, b, expected) in cases {
            assert_eq!(edit_distance(a, b), expected, "{a} to {b}");
            assert_eq!(edit_distance(b, a), expected, "{b} to {a}");
        }
    }

    #[test]
    fn the_nearest_name_is_the_one_a_reader_would_name() {
        let tables: Vec<&str> = TABLES.iter().map(|(table, _)| *table).collect();
        let cases: &[(&str, &[&str], Option<&str>)] = &[
            ("color", &tables, Some("colour")),
            ("flim", &tables, Some("film")),
            ("substrate", &tables, Some("base")),
            ("au", METALS, Some("Au")),
            ("Gold", METALS, Some("Au")),
            ("unobtainium", METALS, None),
            ("cie1931", OBSERVERS, Some("cie1931-2deg")),
            ("d65", ILLUMINANTS, Some("D65")),
            ("D75", ILLUMINANTS, Some("D65")),
            ("F11", ILLUMINANTS, None),
            ("sRGB", SPACES, Some("linear-srgb")),
            ("rec2100", SPACES, Some("rec2020")),
            ("glsl", TARGETS, Some("glsl450")),
            ("spv", TARGETS, Some("spirv")),
            ("hsl", TARGETS, Some("hlsl")),
            ("msl", TARGETS, None),
            ("", TARGETS, None),
        ];
        for (word, allowed, expected) in cases {
            assert_eq!(nearest(word, allowed), *expected, "{word}");
        }
    }
}
