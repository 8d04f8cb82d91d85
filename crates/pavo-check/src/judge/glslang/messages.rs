//! Reads glslang's messages.
//!
//! They look like `ERROR: 0:2: 'y' : undeclared identifier`, where the file is `0` or a name, a column may follow the
//! line, and the linker's messages name neither and may go on in indented lines.

/// One message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Message {
    /// Whether it is an error, otherwise a warning.
    pub is_error: bool,
    /// The line, counted from 1, where one is named.
    pub line: Option<u32>,
    /// The column, counted from 1, where one is named.
    pub column: Option<u32>,
    /// What it says.
    pub text: String,
}

impl Message {
    /// The whole log as one error, for a log in a form that is not known.
    pub fn whole_log(log: &str) -> Message {
        let text = if log.trim().is_empty() { "refused without a message" } else { log.trim() };
        Message { is_error: true, line: None, column: None, text: text.to_owned() }
    }
}

/// The errors and warnings of a log, without those that only count or repeat the others.
pub(super) fn parse(log: &str) -> Vec<Message> {
    let mut messages: Vec<Message> = Vec::new();
    let mut continues = false;
    for line in log.lines() {
        let message = match (line.strip_prefix("ERROR: "), line.strip_prefix("WARNING: ")) {
            (Some(text), _) => Some((true, text)),
            (_, Some(text)) => Some((false, text)),
            _ => None,
        };
        match message {
            Some((_, text)) if is_summary(text) => continues = false,
            Some((is_error, text)) => {
                messages.push(located(is_error, text));
                continues = true;
            }
            None if continues && line.starts_with(' ') => {
                if let Some(last) = messages.last_mut() {
                    last.text = format!("{} {}", last.text, line.trim());
                }
            }
            None => continues = false,
        }
    }
    let compiled = messages.iter().any(|message| message.is_error && message.line.is_some());
    // A text that does not compile does not link either: what the linker says of it follows from the first error.
    messages.retain(|message| !(compiled && message.is_error && message.line.is_none()));
    messages
}

/// Whether a message only says that there were messages.
fn is_summary(text: &str) -> bool {
    text.contains(" compilation errors.")
        || text.ends_with("'' : compilation terminated")
        || text.contains("'' : compilation terminated ")
}

/// Splits `file:line: text` and `file:line:column: text`. The file is skipped over, as it may hold colons itself.
fn located(is_error: bool, text: &str) -> Message {
    for (colon, _) in text.match_indices(':') {
        let Some((line, rest)) = number_and_rest(&text[colon + 1..]) else { continue };
        let (column, rest) = match number_and_rest(rest) {
            Some((column, rest)) => (Some(column), rest),
            None => (None, rest),
        };
        let said = rest.trim();
        // An error that is about no name says so with an empty one.
        let said = said.strip_prefix("'' :").unwrap_or(said).trim();
        return Message { is_error, line: Some(line), column, text: said.to_owned() };
    }
    Message { is_error, line: None, column: None, text: text.trim().to_owned() }
}

/// Splits `12:rest`.
fn number_and_rest(text: &str) -> Option<(u32, &str)> {
    let (number, rest) = text.split_once(':')?;
    Some((number.parse().ok()?, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(log: &str, expected: &[(bool, Option<u32>, Option<u32>, &str)]) {
        let found = parse(log);
        let found: Vec<_> = found
            .iter()
            .map(|message| (message.is_error, message.line, message.column, message.text.as_str()))
            .collect();
        assert_eq!(found, expected, "{log}");
    }

    #[test]
    fn errors_keep_line_and_text_and_lose_the_summary() {
        check(
            "a.comp\nERROR: a.comp:2: 'y' : undeclared identifier \nERROR: a.comp:2: '' : compilation terminated \n\
             ERROR: 2 compilation errors.  No code generated.\n\n\
             ERROR: Linking compute stage: Missing entry point: Each stage requires one entry point\n",
            &[(true, Some(2), None, "'y' : undeclared identifier")],
        );
    }

    #[test]
    fn columns_are_read_where_they_are_given() {
        check("ERROR: 0:7:13: '' :  syntax error\n", &[(true, Some(7), Some(13), "syntax error")]);
    }

    #[test]
    fn file_names_may_hold_colons_and_spaces() {
        check("ERROR: C:\\my files\\a:b.frag:3: 'x' : bad\n", &[(true, Some(3), None, "'x' : bad")]);
    }

    #[test]
    fn the_linker_names_no_line_and_goes_on_in_indented_lines() {
        check(
            "ERROR: Linking compute stage: No function definition (body) found: \n    f(f1;\n\nSPIR-V is not generated\n",
            &[(true, None, None, "Linking compute stage: No function definition (body) found: f(f1;")],
        );
    }

    #[test]
    fn warnings_are_told_from_errors() {
        check(
            "WARNING: 0:2: '#extension' : extension not supported: GL_FOO\n\n",
            &[(false, Some(2), None, "'#extension' : extension not supported: GL_FOO")],
        );
    }

    #[test]
    fn a_log_in_another_form_is_given_as_it_is() {
        assert_eq!(parse("out of luck"), []);
        assert_eq!(Message::whole_log(" out of luck\n").text, "out of luck");
    }
}
