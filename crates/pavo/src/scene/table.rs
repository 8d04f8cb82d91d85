//! Typed access to one table of a parsed scene: the shape of each value is checked here, its meaning later.

use toml::de::{DeArray, DeTable, DeValue};

use super::fault::{Checked, Fault};
use super::model::Quantity;
use super::places::key_text;
use super::shown::shown;
use super::suggest::{did_you_mean, nearest};
use super::vocabulary::{TABLES, TOP_KEYS};

/// One table of the file; the top of the file is the one with an empty name.
pub(super) struct Table<'a> {
    name: &'static str,
    entries: &'a DeTable<'a>,
}

impl<'a> Table<'a> {
    /// The top of the file, every table and key of which is one that a scene may have.
    pub(super) fn top(entries: &'a DeTable<'a>) -> Checked<Self> {
        let tables: Vec<&str> = TABLES.iter().map(|(name, _)| *name).collect();
        for (key, value) in entries {
            let key: &str = key.get_ref();
            if !tables.contains(&key) && !TOP_KEYS.contains(&key) {
                return Err(unknown_at_top(key, value.get_ref(), &tables));
            }
        }
        Ok(Table { name: "", entries })
    }

    /// The table `name`, every key of which is one that this table may have, where these are known; `None` where the file has none.
    pub(super) fn table(&self, name: &'static str) -> Checked<Option<Table<'a>>> {
        let Some(value) = self.value(name) else { return Ok(None) };
        let DeValue::Table(entries) = value else {
            let message = format!("`{name}` is {}, but it must be a table", describe(value));
            let help = format!("write the table once as `[{name}]`, with its keys on the lines below it");
            return Err(Fault::at(name, "expected a table", message, help));
        };
        let allowed = TABLES.iter().find(|(table, _)| *table == name).map_or(&[][..], |(_, keys)| keys);
        for (key, _) in entries {
            let key: &str = key.get_ref();
            if !allowed.is_empty() && !allowed.contains(&key) {
                return Err(unknown_in_table(name, key, allowed));
            }
        }
        Ok(Some(Table { name, entries }))
    }

    /// The path of `key`, as messages name it.
    pub(super) fn path(&self, key: &str) -> String {
        if self.name.is_empty() { key.to_owned() } else { format!("{}.{key}", self.name) }
    }

    /// The keys that the file gives.
    pub(super) fn keys(&self) -> impl Iterator<Item = &'a str> {
        self.entries.keys().map(|key| key.get_ref().as_ref())
    }

    /// Whether the file gives `key`.
    pub(super) fn has(&self, key: &str) -> bool {
        self.value(key).is_some()
    }

    /// The value of `key` as it was parsed.
    pub(super) fn value(&self, key: &str) -> Option<&'a DeValue<'a>> {
        self.entries.get(key).map(|value| value.get_ref())
    }

    /// The number or range at `key`.
    pub(super) fn quantity(&self, key: &str) -> Checked<Option<Quantity>> {
        let Some(value) = self.value(key) else { return Ok(None) };
        let path = self.path(key);
        let help = format!("write one number for a constant, or `{key} = [low, high]` for a run-time input");
        let DeValue::Array(pair) = value else {
            return number(value, &path, "a number or a range [low, high]", &help).map(Quantity::Fixed).map(Some);
        };
        let [low, high] = numbers(pair, &path, "a range has two: its lowest and its highest value", &help)?;
        Ok(Some(Quantity::Range { low, high }))
    }

    /// The number or range at `key`, which must be there.
    pub(super) fn required_quantity(&self, key: &str, help: &str) -> Checked<Quantity> {
        self.quantity(key)?.ok_or_else(|| {
            let message = format!("`[{}]` has no `{key}`", self.name);
            Fault::at(self.path(key), format!("`{key}` is missing"), message, help)
        })
    }

    /// The string at `key`.
    pub(super) fn string(&self, key: &str) -> Checked<Option<&'a str>> {
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::String(text)) => Ok(Some(text)),
            Some(other) => {
                let help = format!("write the value in quotes, as in `{key} = \"...\"`");
                Err(wrong_type(other, &self.path(key), "a string", &help))
            }
        }
    }

    /// The strings listed at `key`.
    pub(super) fn strings(&self, key: &str) -> Checked<Option<Vec<&'a str>>> {
        let path = self.path(key);
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::Array(elements)) => {
                let string = |(index, element): (usize, &'a toml::Spanned<DeValue<'a>>)| match element.get_ref() {
                    DeValue::String(text) => Ok(text.as_ref()),
                    other => {
                        let help = format!("write strings only, as in `{key} = [\"first\", \"second\"]`");
                        Err(wrong_type(other, &format!("{path}[{index}]"), "a string", &help))
                    }
                };
                elements.iter().enumerate().map(string).collect::<Checked<Vec<_>>>().map(Some)
            }
            Some(DeValue::String(text)) => {
                let help = format!("write a list even for one: `{key} = [\"{}\"]`", shown(text));
                Err(wrong_type(&DeValue::String(text.clone()), &path, "a list of strings", &help))
            }
            Some(other) => {
                let help = format!("write `{key} = [\"first\", \"second\"]`");
                Err(wrong_type(other, &path, "a list of strings", &help))
            }
        }
    }

    /// The truth value at `key`.
    pub(super) fn boolean(&self, key: &str) -> Checked<Option<bool>> {
        match self.value(key) {
            None => Ok(None),
            Some(DeValue::Boolean(value)) => Ok(Some(*value)),
            Some(other) => {
                let help = format!("write `{key} = true` or `{key} = false`, without quotes");
                Err(wrong_type(other, &self.path(key), "true or false", &help))
            }
        }
    }
}

/// The numbers of a list that must have exactly `N`.
pub(super) fn numbers<const N: usize>(list: &DeArray<'_>, path: &str, rule: &str, help: &str) -> Checked<[f64; N]> {
    if list.len() != N {
        let count = list.len();
        let values = if count == 1 { "value" } else { "values" };
        let message = format!("`{path}` lists {count} {values}, but {rule}");
        return Err(Fault::at(path, format!("{count} {values}"), message, help));
    }
    let mut values = [0.0; N];
    for (index, (slot, element)) in values.iter_mut().zip(list.iter()).enumerate() {
        *slot = number(element.get_ref(), &format!("{path}[{index}]"), "a number", help)?;
    }
    Ok(values)
}

/// A number, whole or not; NaN and infinities are numbers here and are refused with the limits.
fn number(value: &DeValue<'_>, path: &str, wanted: &str, help: &str) -> Checked<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().map_err(|_| wrong_type(value, path, wanted, help)),
        DeValue::Integer(integer) => {
            i128::from_str_radix(integer.as_str(), integer.radix()).map(|whole| whole as f64).map_err(|_| {
                let message = format!("`{path}` is too large a number");
                Fault::at(path, "too large", message, "no number of a scene is above a million")
            })
        }
        DeValue::String(text) if text.trim().parse::<f64>().is_ok() => {
            let help = format!("remove the quotes: {}", shown(text.trim()));
            Err(wrong_type(value, path, wanted, &help))
        }
        other => Err(wrong_type(other, path, wanted, help)),
    }
}

/// The fault of a value that is of another type than its key wants.
pub(super) fn wrong_type(value: &DeValue<'_>, path: &str, wanted: &str, help: &str) -> Box<Fault> {
    let message = format!("`{path}` is {}, but it must be {wanted}", describe(value));
    Fault::at(path, format!("expected {wanted}"), message, help)
}

fn describe(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(list) if list.iter().any(|element| element.get_ref().is_table()) => "a list of tables",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

fn unknown_at_top(key: &str, value: &DeValue<'_>, tables: &[&str]) -> Box<Fault> {
    let path = key_text(key);
    if value.is_table() {
        let all = "the tables of a scene are";
        return Fault::at(
            path.clone(),
            "unknown table",
            format!("unknown table `[{}]`", shown(&path)),
            did_you_mean(key, tables, all),
        )
        .in_key();
    }
    let help = belongs_elsewhere(key).unwrap_or_else(|| {
        let keys: Vec<&str> = TABLES.iter().flat_map(|(_, keys)| *keys).copied().collect();
        if let Some(name) = nearest(key, TOP_KEYS) {
            format!("did you mean `{name}`? only `name` stands before the first table")
        } else if let Some(table) = nearest(key, tables) {
            format!("did you mean the table `[{table}]`?")
        } else if let Some((name, place)) = nearest(key, &keys).and_then(|name| Some((name, belongs_elsewhere(name)?)))
        {
            format!("did you mean `{name}`? {place}")
        } else {
            format!("only `name` stands before the first table; the tables are: {}", tables.join(", "))
        }
    });
    Fault::at(path.clone(), "unknown key", format!("unknown key `{}`", shown(&path)), help).in_key()
}

fn unknown_in_table(table: &str, key: &str, allowed: &[&str]) -> Box<Fault> {
    let help = if TOP_KEYS.contains(&key) {
        format!("move `{key}` to the top of the file, before the first table")
    } else if TABLES.iter().any(|(name, _)| *name == key) {
        format!("`{key}` is a table of its own: start it with `[{key}]`")
    } else if let Some(elsewhere) = belongs_elsewhere(key) {
        format!("{elsewhere}; the keys of [{table}] are: {}", allowed.join(", "))
    } else {
        did_you_mean(key, allowed, &format!("the keys of [{table}] are"))
    };
    let key = key_text(key);
    let message = format!("unknown key `{}` in [{table}]", shown(&key));
    Fault::at(format!("{table}.{key}"), "unknown key", message, help).in_key()
}

/// Where a key that is unknown here would be known.
fn belongs_elsewhere(key: &str) -> Option<String> {
    let homes: Vec<String> =
        TABLES.iter().filter(|(_, keys)| keys.contains(&key)).map(|(table, _)| format!("[{table}]")).collect();
    match homes.split_last()? {
        (only, []) => Some(format!("`{key}` belongs in {only}")),
        (last, others) => Some(format!("`{key}` belongs in {} or {last}", others.join(", "))),
    }
}
