//! Names under which users ask for what is built in.

/// A name that none of the known ones matches.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} `{given}`; known are {}", .known.join(", "))]
pub struct UnknownName {
    /// What the name was meant to name, such as "observer".
    pub kind: &'static str,
    /// The name as it was given.
    pub given: String,
    /// Every name that would have been right.
    pub known: &'static [&'static str],
}

impl UnknownName {
    pub(crate) fn new(kind: &'static str, given: &str, known: &'static [&'static str]) -> Self {
        Self { kind, given: given.to_owned(), known }
    }
}
