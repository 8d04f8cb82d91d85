//! Fits as comma-separated text.
//!
//! Lines beginning with `#` are comments. A fit is a line
//!
//! `fit,FAMILY,COUNT,MAX_OPD_UM,WINDOW_UM,MAX_ERROR,RMS_ERROR` (the window empty where there is none),
//!
//! followed by COUNT lines of a term each:
//!
//! - shared Gaussians: `nu,a,w1,w2,w3`;
//! - Gaussians per channel: `nu1,nu2,nu3,a1,a2,a3,w1,w2,w3`;
//! - poles: `nu,gamma,re1,re2,re3,im1,im2,im3`;
//! - nodes, windowed or not: `nu,w1,w2,w3`.
//!
//! Channels are those of linear sRGB, and X, Y, Z for XYZ Gaussians. Numbers of terms have [`DECIMALS`] decimals.

use std::fmt::Write as _;

use super::{FitFamily, FitTerm, SensitivityFit};
use crate::colour_space::ColourSpace;

/// Decimals of the numbers of a term.
pub const DECIMALS: usize = 7;

/// Text of fits that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {message}")]
pub struct TextError {
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong, and what would be right.
    pub message: String,
}

/// The space whose channels the text of a family holds.
pub fn stored_space(family: FitFamily) -> ColourSpace {
    if family == FitFamily::XyzGaussians { ColourSpace::Xyz } else { ColourSpace::LinearSrgb }
}

/// Writes one fit. Numbers are rounded to [`DECIMALS`] decimals; errors to 4 figures.
pub fn write(fit: &SensitivityFit) -> String {
    let window = fit.window_um.map_or(String::new(), |window| format!("{window:.DECIMALS$}"));
    let (family, count, range) = (fit.family.name(), fit.terms.len(), fit.max_opd_um);
    let mut text = format!("fit,{family},{count},{range},{window},{:.3e},{:.3e}\n", fit.max_error, fit.rms_error);
    for term in &fit.terms {
        let mut numbers = Vec::new();
        let shared = if fit.family.is_shared() { 1 } else { 3 };
        numbers.extend_from_slice(&term.wave_number[..shared]);
        if has_decay(fit.family) {
            numbers.extend_from_slice(&term.decay[..shared]);
        }
        numbers.extend_from_slice(&term.weight_re);
        if fit.family.has_complex_weights() {
            numbers.extend_from_slice(&term.weight_im);
        }
        for (index, number) in numbers.iter().enumerate() {
            let separator = if index == 0 { "" } else { "," };
            let _ = write!(text, "{separator}{}", short(*number));
        }
        text.push('\n');
    }
    text
}

/// Reads every fit of a text.
///
/// # Errors
/// The first line that is none, and what it should be.
pub fn read(text: &str) -> Result<Vec<SensitivityFit>, TextError> {
    let mut fits: Vec<SensitivityFit> = Vec::new();
    let mut missing = 0;
    for (index, content) in text.lines().enumerate() {
        let error = |message: String| TextError { line: index + 1, message };
        if content.starts_with('#') || content.trim().is_empty() {
            continue;
        }
        let cells: Vec<&str> = content.split(',').map(str::trim).collect();
        if cells[0] == "fit" {
            if missing > 0 {
                return Err(error(format!("the fit above lacks {missing} line(s) of terms")));
            }
            let (fit, count) = read_header(&cells).map_err(error)?;
            missing = count;
            fits.push(fit);
            continue;
        }
        let Some(fit) = fits.last_mut().filter(|_| missing > 0) else {
            return Err(error("a line that begins with `fit` belongs here".to_owned()));
        };
        fit.terms.push(read_term(fit.family, &cells).map_err(error)?);
        missing -= 1;
        if missing == 0 {
            fit.close_weights();
        }
    }
    if missing > 0 {
        return Err(TextError {
            line: text.lines().count(),
            message: format!("the text ends where {missing} line(s) of terms belong"),
        });
    }
    Ok(fits)
}

fn has_decay(family: FitFamily) -> bool {
    !matches!(family, FitFamily::Nodes | FitFamily::WindowedNodes)
}

/// A number with [`DECIMALS`] decimals, its trailing zeros cut.
fn short(number: f64) -> String {
    let text = format!("{number:.DECIMALS$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn read_header(cells: &[&str]) -> Result<(SensitivityFit, usize), String> {
    let [_, family, count, range, window, max_error, rms_error] = cells else {
        return Err(format!("a line `fit` has 7 cells; this one has {}", cells.len()));
    };
    let family = FitFamily::from_name(family).map_err(|error| error.to_string())?;
    let count = count.parse().ok().filter(|count| (1..=64).contains(count));
    let count = count.ok_or_else(|| "the count should be a whole number from 1 to 64".to_owned())?;
    let window_um = if window.is_empty() { None } else { Some(read_number(window)?) };
    let [max_opd_um, max_error, rms_error] = [read_number(range)?, read_number(max_error)?, read_number(rms_error)?];
    Ok((SensitivityFit { family, terms: Vec::new(), window_um, max_opd_um, max_error, rms_error }, count))
}

fn read_term(family: FitFamily, cells: &[&str]) -> Result<FitTerm, String> {
    let shared = if family.is_shared() { 1 } else { 3 };
    let (decays, imaginary) = (usize::from(has_decay(family)), usize::from(family.has_complex_weights()));
    let expected = shared * (1 + decays) + 3 * (1 + imaginary);
    if cells.len() != expected {
        return Err(format!("a term of {} has {expected} numbers; this line has {}", family.name(), cells.len()));
    }
    let numbers = cells.iter().map(|cell| read_number(cell)).collect::<Result<Vec<f64>, String>>()?;
    let mut rest = numbers.as_slice();
    let mut take = |count: usize| -> [f64; 3] {
        let (taken, left) = rest.split_at(count);
        rest = left;
        match taken {
            [] => [0.0; 3],
            [one] => [*one; 3],
            several => std::array::from_fn(|channel| several[channel]),
        }
    };
    Ok(FitTerm {
        wave_number: take(shared),
        decay: take(shared * decays),
        weight_re: take(3),
        weight_im: take(3 * imaginary),
    })
}

fn read_number(cell: &str) -> Result<f64, String> {
    let number = cell.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("`{cell}` should be a finite number"))
}
