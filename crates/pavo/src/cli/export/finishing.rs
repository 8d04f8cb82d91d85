//! What is done to a text for an engine that takes a language in its own way.

use super::engines::Writer;
use pavo_check::{CheckError, wgsl_to_msl};

/// Each declaration of GLSL ES with `highp`, but those that say how precise they are: for an engine whose default
/// precision is lower, and whose own code goes on with it.
pub fn with_highp(text: &str) -> String {
    text.lines().map(|line| highp_line(line) + "\n").collect()
}

fn highp_line(line: &str) -> String {
    let code = line.find("//").unwrap_or(line.len());
    let mut before = "";
    let mut declared = String::new();
    for word in line[..code].split_inclusive(' ') {
        // A type stands before a space in declarations only.
        let (start, last) = word.split_at(word.rfind('(').map_or(0, |bracket| bracket + 1));
        declared.push_str(start);
        if ["float ", "vec3 "].contains(&last) && before != "mediump " {
            declared.push_str("highp ");
        }
        declared.push_str(last);
        before = last;
    }
    declared + &line[code..]
}

/// A judged text in another language, under the comment at its top.
///
/// # Errors
/// If it cannot be written in that language.
pub fn written_by(writer: Writer, file: &str, judged: &str) -> Result<String, CheckError> {
    let header: String =
        judged.lines().take_while(|line| line.starts_with("//")).map(|line| format!("{line}\n")).collect();
    match writer {
        Writer::Msl => Ok(format!("{header}\n#pragma once\n\n{}", wgsl_to_msl(file, judged)?.trim_start())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_of_numbers_and_vectors_are_highp_and_nothing_else_is() {
        for (line, expected) in [
            ("float f(float x, vec3 y, bool z) {", "highp float f(highp float x, highp vec3 y, bool z) {"),
            ("    vec3 sum = vec3(0.0) + float(1);", "    highp vec3 sum = vec3(0.0) + float(1);"),
            ("const vec3 rows[2] = vec3[2](", "const highp vec3 rows[2] = vec3[2]("),
            ("    mediump float weight = 1.0;", "    mediump float weight = 1.0;"),
            ("    float x = 1.0; // a float and a vec3 here", "    highp float x = 1.0; // a float and a vec3 here"),
            ("    Waves waves = made(x);", "    Waves waves = made(x);"),
            ("float f(mediump vec3 x, float y) {", "highp float f(mediump vec3 x, highp float y) {"),
        ] {
            assert_eq!(with_highp(line), format!("{expected}\n"));
        }
    }
}
