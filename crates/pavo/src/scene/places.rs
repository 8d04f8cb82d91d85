//! Where each key of a scene stands in its text.

use std::collections::HashMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// Which part of an entry to point at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// The key, or the name in a table's header.
    Key,
    /// The value, or the header of a table.
    Value,
}

/// The spans of every key and value, by path: `film`, `film.ior`, `film.thickness_nm[0]`.
#[derive(Debug, Default)]
pub(super) struct Places {
    end: usize,
    spans: HashMap<String, (Range<usize>, Range<usize>)>,
}

impl Places {
    /// The places of `root`, which was parsed from `text`.
    ///
    /// Paths are as deep as a scene is: a table, a key, an element of a list.
    pub(super) fn of(root: &DeTable<'_>, text: &str) -> Self {
        let mut places = Places { end: text.trim_end().len(), spans: HashMap::new() };
        for (key, value) in root {
            let path = key_text(key.get_ref());
            places.spans.insert(path.clone(), (key.span(), value.span()));
            match value.get_ref() {
                DeValue::Table(table) => places.add_table(&path, table),
                other => places.add_elements(&path, other),
            }
        }
        places
    }

    fn add_table(&mut self, table_path: &str, table: &DeTable<'_>) {
        for (key, value) in table {
            let path = format!("{table_path}.{}", key_text(key.get_ref()));
            self.add_elements(&path, value.get_ref());
            self.spans.insert(path, (key.span(), value.span()));
        }
    }

    fn add_elements(&mut self, path: &str, value: &DeValue<'_>) {
        if let DeValue::Array(elements) = value {
            for (index, element) in elements.iter().enumerate() {
                self.spans.insert(format!("{path}[{index}]"), (element.span(), element.span()));
            }
        }
    }

    /// The span of `path`, or of what is around it where it is absent.
    ///
    /// What is missing at the top is placed where it would be written: the name at the start of the text, a table
    /// at the end.
    pub(super) fn find(&self, path: &str, part: Part) -> Range<usize> {
        if let Some((key, value)) = self.spans.get(path) {
            return if part == Part::Key { key.clone() } else { value.clone() };
        }
        let around = path.rfind(['.', '[']).map(|at| &path[..at]);
        match around {
            Some(around) => self.find(around, Part::Value),
            None if path == "name" => 0..0,
            None => self.end..self.end,
        }
    }
}

/// A key as it is written: bare where it can be, else in quotes, so that a path means one key only.
pub(super) fn key_text(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(bare) { key.to_owned() } else { format!("{key:?}") }
}
