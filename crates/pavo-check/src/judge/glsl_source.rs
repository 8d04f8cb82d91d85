//! Reads what a judge must know of a GLSL text before reading it: its version, and whether it has an entry point.
//! Completes a library to a text that a judge reads, and maps the judge's lines back.

use std::fmt;

use pavo_emit::Language;

use super::verdict::Stage;

/// A version of GLSL, as its `#version` line says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct GlslVersion {
    /// The number: 450, 330, 300, ...
    pub number: u32,
    /// Whether it is GLSL ES.
    pub embedded: bool,
}

impl GlslVersion {
    /// The version for Vulkan that libraries are completed to.
    pub const GLSL_450: GlslVersion = GlslVersion { number: 450, embedded: false };

    /// The version of a language of the printer; `None` where it is no GLSL.
    pub fn of_language(language: Language) -> Option<GlslVersion> {
        match language {
            Language::Wgsl | Language::Hlsl | Language::Osl | Language::Rust => None,
            Language::Glsl450 => Some(GlslVersion::GLSL_450),
            Language::Glsl330 => Some(GlslVersion { number: 330, embedded: false }),
            Language::Essl300 => Some(GlslVersion { number: 300, embedded: true }),
        }
    }

    /// Whether texts of this version are judged as Vulkan's GLSL: naga reads them, glslang writes SPIR-V.
    pub fn is_for_vulkan(self) -> bool {
        !self.embedded && self.number >= 440
    }
}

impl fmt::Display for GlslVersion {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let profile = match (self.embedded, self.number) {
            (true, _) => " es",
            (false, 330..440) => " core",
            (false, _) => "",
        };
        write!(formatter, "#version {}{profile}", self.number)
    }
}

/// What stands in a GLSL text, as far as it can be told without parsing it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct GlslSource<'text> {
    /// The text.
    pub text: &'text str,
    /// Its `#version` line, where it has one and it can be read.
    pub version: Option<GlslVersion>,
    /// The line, counted from 1, of the first `#version`, whether or not it can be read.
    pub version_line: Option<u32>,
    /// Whether a function `main` without parameters is defined or declared.
    pub has_main: bool,
    /// The stage that the text seems to be for, told by what only one stage may use.
    pub likely_stage: Stage,
}

impl<'text> GlslSource<'text> {
    /// Looks through `text`. Comments do not count; `#if` is not followed.
    pub fn read(text: &'text str) -> GlslSource<'text> {
        let code = without_comments(text);
        let version_line = code.lines().position(|line| directive(line, "version").is_some());
        let version = version_line
            .and_then(|index| code.lines().nth(index))
            .and_then(|line| directive(line, "version"))
            .and_then(parse_version);
        let likely_stage = if words(&code).any(|word| word.starts_with("local_size_")) {
            Stage::Compute
        } else if words(&code).any(|word| word == "gl_Position") {
            Stage::Vertex
        } else {
            Stage::Fragment
        };
        GlslSource {
            text,
            version,
            version_line: version_line.and_then(|index| u32::try_from(index + 1).ok()),
            has_main: declares_main(&code),
            likely_stage,
        }
    }

    /// The text as it is.
    pub fn unchanged(&self) -> JudgedText {
        JudgedText::between("", self.text, "")
    }

    /// The text with what a library lacks: a `#version` line, the default precisions of ES, and an empty `main`
    /// for `stage`. What the text has stays as it is.
    pub fn completed(&self, version: GlslVersion, stage: Stage) -> JudgedText {
        let mut prefix = String::new();
        if self.version_line.is_none() {
            prefix.push_str(&format!("{version}\n"));
            if version.embedded {
                prefix.push_str("precision highp float;\nprecision highp int;\n");
            }
        }
        let suffix = match (self.has_main, stage) {
            (true, _) => "",
            (false, Stage::Compute) => "\nlayout(local_size_x = 1) in;\nvoid main() {}\n",
            (false, Stage::Vertex | Stage::Fragment) => "\nvoid main() {}\n",
        };
        JudgedText::between(&prefix, self.text, suffix)
    }
}

/// A text as a judge reads it, with the way back to the lines of the caller's own text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct JudgedText {
    /// What the judge reads.
    pub text: String,
    prepended_lines: u32,
    own_lines: u32,
}

impl JudgedText {
    /// A text with something before and after it.
    pub fn between(prefix: &str, text: &str, suffix: &str) -> JudgedText {
        JudgedText {
            text: format!("{prefix}{text}{suffix}"),
            prepended_lines: line_count(prefix),
            own_lines: line_count(text),
        }
    }

    /// The line of the caller's text for a line of the judged text, both counted from 1. What stands before or after
    /// the caller's text counts to its first or last line.
    pub fn own_line(&self, judged_line: u32) -> u32 {
        judged_line.saturating_sub(self.prepended_lines).clamp(1, self.own_lines.max(1))
    }
}

/// The number of lines, a last one without line end included.
fn line_count(text: &str) -> u32 {
    u32::try_from(text.lines().count()).unwrap_or(u32::MAX)
}

/// The text with every comment replaced by spaces, line ends kept.
pub(super) fn without_comments(text: &str) -> String {
    #[derive(PartialEq)]
    enum Within {
        Code,
        LineComment,
        BlockComment,
    }
    let mut within = Within::Code;
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(character) = rest.chars().next() {
        let (taken, kept) = match within {
            Within::Code if rest.starts_with("//") => {
                within = Within::LineComment;
                (2, "  ")
            }
            Within::Code if rest.starts_with("/*") => {
                within = Within::BlockComment;
                (2, "  ")
            }
            Within::BlockComment if rest.starts_with("*/") => {
                within = Within::Code;
                (2, "  ")
            }
            _ if character == '\n' => {
                if within == Within::LineComment {
                    within = Within::Code;
                }
                (1, "\n")
            }
            Within::Code => (character.len_utf8(), &rest[..character.len_utf8()]),
            _ => (character.len_utf8(), " "),
        };
        code.push_str(kept);
        rest = &rest[taken..];
    }
    code
}

/// What follows `#name` on a line that is this directive.
fn directive<'line>(line: &'line str, name: &str) -> Option<&'line str> {
    let after_hash = line.trim_start().strip_prefix('#')?.trim_start();
    let argument = after_hash.strip_prefix(name)?;
    argument.starts_with(char::is_whitespace).then(|| argument.trim())
}

/// The version of what follows `#version`.
fn parse_version(argument: &str) -> Option<GlslVersion> {
    let mut parts = argument.split_whitespace();
    let number = parts.next()?.parse().ok()?;
    Some(GlslVersion { number, embedded: parts.next() == Some("es") })
}

/// The identifiers and numbers of a text.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|character: char| !(character.is_alphanumeric() || character == '_')).filter(|word| !word.is_empty())
}

/// Whether `void main (` stands in the code.
pub(super) fn declares_main(code: &str) -> bool {
    code.match_indices("main").any(|(start, name)| {
        let before = code[..start].trim_end();
        let after = code[start + name.len()..].trim_start();
        before.len() < start
            && after.starts_with('(')
            && words(before).last() == Some("void")
            && before.ends_with("void")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn version(text: &str) -> Option<(u32, bool)> {
        GlslSource::read(text).version.map(|version| (version.number, version.embedded))
    }

    #[test]
    fn the_version_line_is_read_past_comments() {
        assert_eq!(version("#version 450\n"), Some((450, false)));
        assert_eq!(version("// #version 110\n/* #version 120\n */ # version 300 es"), Some((300, true)));
        assert_eq!(version("#version 330 core // #version 450\n"), Some((330, false)));
        assert_eq!(version("#versionless 330\nfloat version;"), None);
        assert_eq!(version("#version four\n"), None);
        assert_eq!(GlslSource::read("\n\n#version four\n").version_line, Some(3));
    }

    #[test]
    fn only_a_function_main_counts_as_an_entry_point() {
        for (text, has_main) in [
            ("void main() {}", true),
            ("void\nmain (void) {}", true),
            ("// void main() {}", false),
            ("/* void main() {} */", false),
            ("void domain() {}", false),
            ("void main_light() {}", false),
            ("float main_x = 1.0;", false),
            ("avoid main();", false),
            ("int main() { return 1; }", false),
        ] {
            assert_eq!(GlslSource::read(text).has_main, has_main, "{text}");
        }
    }

    #[test]
    fn the_stage_is_told_by_what_only_one_stage_uses() {
        for (text, stage) in [
            ("layout(local_size_x = 64) in;", Stage::Compute),
            ("void main() { gl_Position = vec4(0.0); }", Stage::Vertex),
            ("out vec4 color; // gl_Position", Stage::Fragment),
        ] {
            assert_eq!(GlslSource::read(text).likely_stage, stage, "{text}");
        }
    }

    #[test]
    fn lines_map_back_to_the_text_that_was_completed() {
        let text = "float f() {\n    return 1.0;\n}\n";
        let version = GlslVersion { number: 300, embedded: true };
        let completed = GlslSource::read(text).completed(version, Stage::Fragment);
        let judged_line = 1 + completed.text.lines().position(|line| line.contains("return")).unwrap() as u32;
        assert_eq!(completed.own_line(judged_line), 2);
        assert_eq!(completed.own_line(1), 1);
        assert_eq!(completed.own_line(1_000), 3);
        assert!(completed.text.starts_with("#version 300 es\nprecision highp float;\n"));
    }

    #[test]
    fn a_text_with_a_version_line_keeps_its_first_line() {
        let text = "#version 450\nfloat f() { return 1.0; }\n";
        let completed = GlslSource::read(text).completed(GlslVersion::GLSL_450, Stage::Compute);
        assert!(completed.text.starts_with(text));
        assert_eq!(completed.own_line(2), 2);
    }
}
