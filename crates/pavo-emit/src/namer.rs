//! Names that no language takes amiss, each used once in its scope.

use crate::dialect::Dialect;
use std::collections::HashSet;
use std::sync::LazyLock;

/// Reserved words and built-in functions of WGSL, GLSL and Rust, so that a name is the same in each.
static RESERVED: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    let files = [
        include_str!("../data/reserved-wgsl.txt"),
        include_str!("../data/reserved-glsl.txt"),
        include_str!("../data/reserved-rust.txt"),
    ];
    files.into_iter().flat_map(words).collect()
});

/// The words of a file of reserved words.
fn words(text: &'static str) -> impl Iterator<Item = &'static str> {
    text.lines().filter(|line| !line.starts_with('#')).flat_map(str::split_whitespace)
}

/// The names of a scope.
#[derive(Clone)]
pub struct Namer {
    taken: HashSet<String>,
    /// What the language reserves beyond the words of all.
    own: &'static str,
}

impl Namer {
    /// No name is taken yet in a text of this language.
    pub fn of(dialect: &Dialect) -> Self {
        Self { taken: HashSet::new(), own: dialect.reserved }
    }

    fn is_reserved(&self, name: &str) -> bool {
        RESERVED.contains(name) || words(self.own).any(|word| word == name)
    }

    /// A name like the wanted one that is free here, and from now on taken.
    pub fn fresh(&mut self, wanted: &str) -> String {
        let base = legal(wanted);
        let mut name = base.clone();
        let mut count = 1;
        while self.is_reserved(&name) || self.taken.contains(&name) {
            count += 1;
            name = format!("{base}_{count}");
        }
        self.taken.insert(name.clone());
        name
    }
}

/// The name with only what each language allows: letters, digits, single underscores between them.
fn legal(wanted: &str) -> String {
    let mut name = String::new();
    for character in wanted.chars() {
        let kept = if character.is_ascii_alphanumeric() { character } else { '_' };
        if kept != '_' || !name.ends_with('_') {
            name.push(kept);
        }
    }
    let name = name.trim_matches('_');
    match name.chars().next() {
        None => "value".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("value_{name}"),
        Some(_) if name.starts_with("gl_") => format!("value_{name}"),
        Some(_) => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Namer, RESERVED};
    use crate::{Dialect, Language};

    #[test]
    fn names_avoid_reserved_words_and_each_other() {
        let mut namer = Namer::of(Dialect::of(Language::Wgsl));
        let cases = [
            ("opd", "opd"),
            ("opd", "opd_2"),
            ("sample", "sample_2"),
            ("texture", "texture_2"),
            ("a__b_", "a_b"),
            ("gl_x", "value_gl_x"),
            ("2x", "value_2x"),
            ("", "value"),
        ];
        for (wanted, expected) in cases {
            assert_eq!(namer.fresh(wanted), expected, "{wanted:?}");
        }
    }

    #[test]
    fn a_language_may_reserve_words_of_its_own() {
        for (language, wanted, expected) in [
            (Language::Osl, "normal", "normal_2"),
            (Language::Hlsl, "normal", "normal"),
            (Language::Hlsl, "lerp", "lerp_2"),
            (Language::Wgsl, "lerp", "lerp"),
        ] {
            assert_eq!(Namer::of(Dialect::of(language)).fresh(wanted), expected, "{wanted} in {}", language.name());
        }
    }

    #[test]
    fn reserved_words_of_all_languages_are_known() {
        for word in
            ["fn", "let", "override", "varying", "highp", "mix", "normalize", "active", "vec3f", "smoothstep", "dyn"]
        {
            assert!(RESERVED.contains(word), "{word}");
        }
    }
}
