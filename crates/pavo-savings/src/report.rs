//! What was measured, as a Markdown table.

use crate::cases::{Case, Quantity};
use crate::failure::Failure;
use crate::measure::{FAMILY, Pair, Saving};
use pavo_check::static_cost::StaticCompiler;

/// The Markdown table of all cases.
///
/// # Errors
/// If a case cannot be measured.
pub fn table(cases: &[Case], compiler: &StaticCompiler) -> Result<String, Failure> {
    let mut text = format!(
        "| what is fixed | of | variant | operations | ratio | {FAMILY} | ratio | RMS |\n|---|---|---|---|---|---|---|---|\n"
    );
    for case in cases {
        text.push_str(&row(&Pair::new(case)?, compiler)?);
    }
    Ok(text)
}

fn row(pair: &Pair<'_>, compiler: &StaticCompiler) -> Result<String, Failure> {
    let case = pair.case;
    let of = match case.quantity {
        Quantity::Reflectance => "reflectance",
        Quantity::Surface => "surface",
    };
    let counts = |saving: Saving| format!("{} to {} | {:.2}", saving.from, saving.to, saving.ratio());
    let [from, to] = [&pair.from, &pair.to].map(|shading| format!("`{}`", shading.variant()));
    let variants = if from == to { from } else { format!("{from} to {to}") };
    let rms = pair.rms.map_or("-".to_owned(), |[from, to]| format!("{from:.1e} to {to:.1e}"));
    let (operations, cycles) = (counts(pair.operations()), counts(pair.cycles(compiler)?));
    Ok(format!("| {} | {of} | {variants} | {operations} | {cycles} | {rms} |\n", case.what))
}
