//! Judges Rust: syn reads it. Types are not checked, since that takes the compiler and the crate glam.

use super::verdict::{Diagnostic, Judge, Verdict, all_passed};
use crate::CheckError;

/// The release of syn that is compiled in; a test holds it equal to the lock file.
pub(crate) const SYN_VERSION: &str = "3.0.9";

/// Judges a Rust module: syn reads its syntax, and nothing more.
///
/// `file` is the name to use in messages; nothing is read from it.
///
/// # Errors
/// [`CheckError::Refused`] when the text is no Rust.
pub fn judge_rust(file: &str, text: &str) -> Result<Vec<Verdict>, CheckError> {
    let diagnostic = |error: syn::Error| {
        let start = error.span().start();
        let (line, column) = (u32::try_from(start.line).ok(), u32::try_from(start.column + 1).ok());
        Diagnostic { file: file.to_owned(), line, column, message: error.to_string(), judge: Judge::Syn }
    };
    let diagnostics: Vec<Diagnostic> = match syn::parse_file(text) {
        Ok(_) => Vec::new(),
        Err(error) => error.into_iter().map(diagnostic).collect(),
    };
    let (version, passed) = (SYN_VERSION.to_owned(), diagnostics.is_empty());
    all_passed(vec![Verdict { judge: Judge::Syn, version, passed, diagnostics }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_one_in_the_lock_file() {
        let lock = include_str!("../../../../Cargo.lock");
        let mut packages = lock.split("[[package]]").filter(|package| package.contains("name = \"syn\"\n"));
        assert!(packages.any(|package| package.contains(&format!("version = \"{SYN_VERSION}\""))));
    }
}
