//! Single declarations out of a file of shader text, which may be a string within a program of another language.

use thiserror::Error;

/// Why a declaration cannot be taken out of a text.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ExtractError {
    /// No line starts with the marker.
    #[error("no declaration starts with `{0}`")]
    None(String),
    /// More than one line starts with the marker.
    #[error("{count} declarations start with `{marker}`: name more of its words")]
    Several {
        /// The marker.
        marker: String,
        /// How many there are.
        count: usize,
    },
    /// The text ends within the declaration.
    #[error("the declaration that starts with `{0}` does not end")]
    Open(String),
}

/// The declaration that starts with a marker, at the start of a line but for white space.
///
/// It ends with its line where it is a preprocessor's, with a semicolon where it is a constant's or a structure's, and
/// with the brace that closes it where it is a function's. Comments are passed over.
pub fn declaration<'a>(text: &'a str, marker: &str) -> Result<&'a str, ExtractError> {
    let start = only_start(text, marker)?;
    let rest = &text[start..];
    let end = if marker.starts_with('#') {
        rest.find(['\n', '\r']).unwrap_or(rest.len())
    } else {
        end(rest, marker.starts_with("struct")).ok_or_else(|| ExtractError::Open(marker.to_owned()))?
    };
    Ok(&rest[..end])
}

/// The text without the one statement that starts with a marker and ends with its closing brace.
pub fn without(text: &str, marker: &str) -> Result<String, ExtractError> {
    let start = only_start(text, marker)?;
    let end = end(&text[start..], false).ok_or_else(|| ExtractError::Open(marker.to_owned()))?;
    Ok(format!("{}{}", &text[..start], &text[start + end..]))
}

/// Where the one line that starts with the marker has it.
fn only_start(text: &str, marker: &str) -> Result<usize, ExtractError> {
    let starts_line = |&(at, _): &(usize, &str)| {
        let line = text[..at].rsplit('\n').next().unwrap_or("");
        line.trim().is_empty()
    };
    let starts: Vec<usize> = text.match_indices(marker).filter(starts_line).map(|(at, _)| at).collect();
    match starts[..] {
        [start] => Ok(start),
        [] => Err(ExtractError::None(marker.to_owned())),
        _ => Err(ExtractError::Several { marker: marker.to_owned(), count: starts.len() }),
    }
}

/// The length of what starts here and ends outside of brackets, with a semicolon or, unless one is asked for, with the
/// brace that closes the first one.
fn end(text: &str, at_semicolon: bool) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut depth = 0_usize;
    let mut at = 0;
    while at < bytes.len() {
        match &bytes[at..] {
            [b'/', b'/', ..] => at += text[at..].find('\n').unwrap_or(text.len() - at),
            [b'/', b'*', ..] => at += text[at..].find("*/")? + 1,
            [b'(' | b'[' | b'{', ..] => depth += 1,
            [close @ (b')' | b']' | b'}'), ..] => {
                depth = depth.checked_sub(1)?;
                if *close == b'}' && depth == 0 && !at_semicolon {
                    return Some(at + 1);
                }
            }
            [b';', ..] if depth == 0 => return Some(at + 1),
            _ => {}
        }
        at += 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Made up, with what is hard in real files: a string of another language around it, comments with brackets,
    /// functions of one name, calls that look like declarations.
    const TEXT: &str = "\
export default `
#define HALF 0.5
#define HALF_OF_IT 0.25
\tconst vec3 TINTS = vec3(
\t\t1.0, 0.5, 0.25
\t);
    struct Layer // not { closed here
    {
        float depth;
        vec3 tint;
    };
    float twice(float x) { return x + x; }
    vec3 twice(vec3 x) { return x + x; }
    /* vec3 glow(float none) { */
    vec3 glow(Layer layer) {
        if (layer.depth < 0.0) {
            return vec3(1.0); // }
        }
        for (int i = 0; i < 2; ++i) { layer.depth = twice(layer.depth); }
        return /* } */ TINTS * layer.depth;
    }
    vec3 endless(float x) { return vec3(x);
`;";

    #[test]
    fn a_declaration_is_taken_whole() {
        for (marker, first, last) in [
            ("#define HALF ", "#define HALF 0.5", "#define HALF 0.5"),
            ("const vec3 TINTS", "const vec3 TINTS = vec3(", "\t);"),
            ("struct Layer", "struct Layer // not { closed here", "    };"),
            ("float twice(", "float twice(float x) { return x + x; }", "float twice(float x) { return x + x; }"),
            ("vec3 twice(", "vec3 twice(vec3 x) { return x + x; }", "vec3 twice(vec3 x) { return x + x; }"),
            ("vec3 glow(", "vec3 glow(Layer layer) {", "    }"),
        ] {
            let found = declaration(TEXT, marker).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!((found.lines().next(), found.lines().last()), (Some(first), Some(last)), "{marker}");
        }
        let glow = declaration(TEXT, "vec3 glow(").expect("it is there");
        assert!(glow.ends_with("return /* } */ TINTS * layer.depth;\n    }"), "{glow}");
    }

    #[test]
    fn what_is_not_there_once_is_refused() {
        let marker = |text: &str| text.to_owned();
        for (word, expected) in [
            ("vec3 shine(", ExtractError::None(marker("vec3 shine("))),
            // Within a line it is a use.
            ("TINTS", ExtractError::None(marker("TINTS"))),
            ("#define HALF", ExtractError::Several { marker: marker("#define HALF"), count: 2 }),
            ("vec3 endless(", ExtractError::Open(marker("vec3 endless("))),
        ] {
            assert_eq!(declaration(TEXT, word), Err(expected), "{word}");
        }
    }

    #[test]
    fn a_statement_is_left_out_with_its_braces() {
        let glow = declaration(TEXT, "vec3 glow(").expect("it is there");
        let found = without(glow, "if (layer.depth < 0.0)").expect("it is there");
        assert!(!found.contains("vec3(1.0)") && found.contains("for (int i"), "{found}");
        assert_eq!(found.matches('{').count(), glow.matches('{').count() - 1);
        assert_eq!(without(glow, "while"), Err(ExtractError::None("while".to_owned())));
    }
}
