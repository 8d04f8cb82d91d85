//! The engines with their languages, and how each was verified.

use super::engines::{Engine, engines};
use crate::cli::failure::Failure;
use crate::cli::output;
use serde_json::json;

/// Prints the table of engines, as text, as JSON or as a table in Markdown.
pub fn run(as_json: bool, as_markdown: bool) -> Result<(), Failure> {
    let engines = engines()?;
    if as_json {
        let rows: Vec<_> = engines.iter().map(row).collect();
        return output::print(&format!("{:#}\n", json!(rows)));
    }
    output::print(&if as_markdown { markdown(&engines) } else { engines.iter().map(lines).collect() })
}

fn row(engine: &Engine) -> serde_json::Value {
    let files = engine.files.iter().map(|file| {
        json!({ "file": file.file, "language": file.written_language(), "signature": file.signature,
            "check": !file.check.is_empty() })
    });
    json!({
        "name": engine.name, "title": engine.title, "client": engine.client, "tried": engine.tried,
        "verified": engine.verified, "hook": engine.hook.trim(), "loses": engine.loses,
        "files": files.collect::<Vec<_>>(),
    })
}

fn lines(engine: &Engine) -> String {
    let Engine { name, title, tried, verified, .. } = engine;
    format!("{name:<12} {title} ({}; {tried})\n{:<12} {verified}\n", languages(engine), "")
}

fn languages(engine: &Engine) -> String {
    let languages: Vec<&str> = engine.files.iter().map(|file| file.written_language()).collect();
    languages.join(", ")
}

/// The table of the README.
fn markdown(engines: &[Engine]) -> String {
    let row = |engine: &Engine| {
        let client = match engine.client.as_str() {
            "" => "judged only".to_owned(),
            client => format!("`cargo xtask clients {client}`"),
        };
        format!("| `{}` | {} | {} | {client} |\n", engine.name, engine.title, engine.tried)
    };
    let rows: String = engines.iter().map(row).collect();
    format!("| `--engine` | what | tried with | run by |\n|---|---|---|---|\n{rows}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_the_readme_is_the_one_that_is_printed() {
        let engines = engines().unwrap_or_else(|_| panic!("the table can be read"));
        let readme = include_str!("../../../../../README.md");
        let table = markdown(&engines);
        assert!(readme.contains(&table), "README.md needs what `pavo export --list --markdown` prints:\n{table}");
    }
}
