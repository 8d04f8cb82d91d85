//! The files of an examination: all figures, the worst points of each surface, the scenes, and the maps of the error.

use super::picture::Maps;
use super::table::{columns, numbers};
use crate::cli::failure::Failure;
use crate::cli::output;
use crate::cli::plot::png_of;
use crate::stability::{BuiltIn, Finding, Judgement, Placed, Stability};
use std::path::Path;

/// Writes everything into a folder.
pub fn write(
    folder: &Path,
    placed: &[Placed],
    stability: &Stability,
    judgement: &Judgement<'_>,
    scene_file: Option<&Path>,
) -> Result<(), Failure> {
    output::make_folder(folder)?;
    let json = serde_json::to_string_pretty(&judgement.rows)
        .map_err(|error| Failure::check(format!("the findings cannot be written: {error}")))?;
    output::write(&folder.join("stability.json"), (json + "\n").as_bytes())?;
    if scene_file.is_none() {
        for surface in BuiltIn::ALL {
            output::write(&folder.join(format!("{}.toml", surface.name)), surface.text.as_bytes())?;
        }
    }
    for (file, text) in worst_points(placed, &stability.findings) {
        output::write(&folder.join(file), text.as_bytes())?;
    }
    for (variant, _) in &stability.device_points {
        let maps: Vec<_> = stability.maps.iter().filter(|map| map.variant == *variant).collect();
        if !maps.is_empty() {
            let name: String = variant.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
            output::write(&folder.join(format!("map-{name}.png")), &png_of(&Maps { variant, maps })?)?;
        }
    }
    Ok(())
}

/// The worst point of each check of each variant, as a table for each surface and quantity.
fn worst_points(placed: &[Placed], findings: &[Finding]) -> Vec<(String, String)> {
    let mut tables: Vec<(String, String, Vec<&Finding>)> = Vec::new();
    for finding in findings.iter().filter(|finding| !finding.worst.is_empty() && finding.value > 0.0) {
        let file = format!("worst-{}-{}.csv", finding.surface, finding.quantity);
        let place = tables.iter().position(|(other, ..)| *other == file).unwrap_or_else(|| {
            tables.push((file, columns(placed, finding), Vec::new()));
            tables.len() - 1
        });
        let rows = &mut tables[place].2;
        match rows.iter_mut().find(|row| row.variant == finding.variant && row.check == finding.check) {
            Some(row) if row.value < finding.value => *row = finding,
            Some(_) => {}
            None => rows.push(finding),
        }
    }
    let text = |(file, columns, rows): (String, String, Vec<&Finding>)| {
        let mut text = format!("{columns},variant,check,case,evaluator,value\n");
        for row in rows {
            let Finding { variant, check, case, evaluator, value, worst, .. } = row;
            text.push_str(&format!("{},\"{variant}\",{check},{case},\"{evaluator}\",{value:e}\n", numbers(worst)));
        }
        (file, text)
    };
    tables.into_iter().map(text).collect()
}
