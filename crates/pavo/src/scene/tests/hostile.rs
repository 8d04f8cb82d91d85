//! No text, however broken, makes the reader or its errors panic.

use std::path::Path;

use miette::{GraphicalReportHandler, GraphicalTheme, NarratableReportHandler};

use crate::scene::{STARTER, Scene};

/// A linear congruential generator (Knuth, MMIX), the upper half of its state being used.
struct Generator(u64);

impl Generator {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % bound
    }
}

/// Reads `text` and, where it is refused, draws the error in both of miette's ways.
fn read_and_draw(text: &str) -> bool {
    let Err(error) = Scene::from_toml("hostile.toml", text, Path::new("")) else { return true };
    assert!(!error.to_string().is_empty() && !error.help_text().is_empty(), "{error:?}");
    let span = error.span();
    if let Some(span) = &span {
        assert!(text.get(span.clone()).is_some(), "{span:?} is no span of {text:?}");
    }
    let mut drawn = String::new();
    let graphical = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor());
    graphical.render_report(&mut drawn, &error).unwrap_or_else(|_| panic!("{error:?} at {span:?} cannot be drawn"));
    NarratableReportHandler::new().render_report(&mut drawn, &error).expect("an error can be told");
    assert!(drawn.contains(error.help_text().split_whitespace().next().unwrap_or_default()));
    false
}

#[test]
fn random_mutations_of_a_scene_never_panic() {
    let mut random = Generator(20_171_104);
    let snippets: [&[u8]; 12] =
        [b"nan", b"-inf", b"[", b"]", b"\"", b"[[film]]", b"\n", b"= ", b"1e999", b"\xc3\xa9", b"\xff", b"{ior=1}"];
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..4000 {
        let mut bytes = STARTER.as_bytes().to_vec();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            match random.below(5) {
                0 => bytes[at] = random.below(256) as u8,
                1 => bytes[at] = b' ' + random.below(95) as u8,
                2 => bytes.truncate(at.max(1)),
                3 => drop(bytes.drain(at..(at + random.below(12)).min(bytes.len()))),
                _ => drop(bytes.splice(at..at, snippets[random.below(snippets.len())].iter().copied())),
            }
            if bytes.is_empty() {
                bytes.push(b'#');
            }
        }
        match read_and_draw(&String::from_utf8_lossy(&bytes)) {
            true => accepted += 1,
            false => refused += 1,
        }
    }
    // Both roads must have been taken for the test to mean anything.
    assert!(accepted > 200 && refused > 200, "{accepted} accepted, {refused} refused");
}

#[test]
fn every_beginning_of_a_scene_is_read_or_refused() {
    let ends = STARTER.char_indices().map(|(at, _)| at);
    let accepted = ends.filter(|end| read_and_draw(&STARTER[..*end])).count();
    assert!(accepted > 0);
}

#[test]
fn shapes_that_break_readers_are_refused() {
    let deep = |open: &str, close: &str| format!("base = {}1{}", open.repeat(5000), close.repeat(5000));
    let cases: Vec<String> = vec![
        String::new(),
        "\n\n\n".to_owned(),
        "\u{feff}".to_owned(),
        "\0".to_owned(),
        "🦚 = 1".to_owned(),
        "name = '🦚'".to_owned(),
        "\"\" = 1".to_owned(),
        "\"a.b\" = 1".to_owned(),
        "name = 'x'\n\"film.ior\" = 1\n[film]\nior = 0".to_owned(),
        "name = '".to_owned(),
        "name = \"\"\"\n".to_owned(),
        format!("name = '{}'", "x".repeat(100_000)),
        format!("{} = 1", "k".repeat(100_000)),
        deep("[", "]"),
        deep("{a=", "}"),
        format!("{}ior = 1", "film.".repeat(5000)),
        format!("name = 'x'\nfilm.ior = {}", "9".repeat(5000)),
        format!("name = 'x'\nfilm.ior = [{}]", "1,".repeat(50_000)),
        format!("name = 'x'\nbase.ior = 1\nemit.targets = [{}]", "'wgsl',".repeat(50_000)),
        "x".repeat(super::super::MAXIMUM_FILE_BYTES + 1),
    ];
    for text in cases {
        assert!(!read_and_draw(&text), "accepted: {}", text.chars().take(60).collect::<String>());
    }
}
