//! Variants as text: `family:option=value,option=value`.

use super::candidates::FITTED_RMS_ERROR;
use super::{Fit, FittedForm, FresnelForm, Variant};
use std::str::FromStr;
use thiserror::Error;

/// A text that is no variant.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{message}")]
pub struct VariantError {
    message: String,
    help: String,
    #[cfg_attr(not(feature = "cli"), allow(dead_code))]
    excess: Option<Excess>,
}

/// A number of a variant that is above its range, and how to tell what it would take.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(feature = "cli"), allow(dead_code))]
pub(crate) struct Excess {
    /// The number that was asked for.
    pub asked: f64,
    /// Two numbers within the range, each with a variant that has it: what they take grows in a straight line.
    pub samples: Samples,
}

/// Numbers with variants that have them; their fits are built in, or they need none.
pub(crate) type Samples = [(usize, &'static str); 2];

impl VariantError {
    /// What would be right.
    pub fn help(&self) -> &str {
        &self.help
    }

    /// What is too large, where that is what is wrong.
    #[cfg(feature = "cli")]
    pub(crate) fn excess(&self) -> Option<&Excess> {
        self.excess.as_ref()
    }
}

/// A family with its options.
struct Family {
    name: &'static str,
    options: &'static [OptionRow],
}

/// An option: its name, what it takes, and what stands for it where it is left out.
struct OptionRow {
    name: &'static str,
    /// The range of a whole number, and what tells the work for more; nothing for words and errors.
    range: Option<(usize, usize, Samples)>,
    /// Empty where leaving it out means something of its own.
    default: &'static str,
}

const fn counted(name: &'static str, low: usize, high: usize, default: &'static str, samples: Samples) -> OptionRow {
    OptionRow { name, range: Some((low, high, samples)), default }
}

const fn worded(name: &'static str, default: &'static str) -> OptionRow {
    OptionRow { name, range: None, default }
}

const ORDERS: Samples = [(2, "series:m=2"), (4, "series:m=4")];
const POLES: Samples = [(5, "poles:k=5"), (6, "poles:k=6")];
const WAVES: Samples = [(6, "windowed:k=6"), (8, "windowed:k=8")];
/// The first order of a form that is fitted to a scene has the terms of cosines of the first order.
const COSINES: Samples = [(4, "cosines:k=4,m=1"), (6, "cosines:k=6,m=1")];
const COSINE_ORDERS: Samples = [(1, "cosines:k=6,m=1"), (2, "cosines:k=6,m=2")];
const NODES: Samples = [(8, "nodes:n=8"), (16, "nodes:n=16")];
const DEGREES: Samples = [(4, "baked:degree=4"), (8, "baked:degree=8")];
const WAVELENGTHS: Samples = [(16, "spectral:n=16"), (32, "spectral:n=32")];
const ENTRIES: Samples = [(64, "table:8x8"), (256, "table:16x16")];

const FAMILIES: [Family; 9] = [
    Family { name: "series", options: &[counted("m", 1, 32, "3", ORDERS), worded("fit", "xyz-gauss")] },
    Family { name: "poles", options: &[counted("k", 3, 8, "6", POLES)] },
    Family { name: "windowed", options: &[counted("k", 4, 10, "6", WAVES), counted("groups", 1, 10, "", WAVES)] },
    Family { name: "cosines", options: &[counted("k", 4, 10, "6", COSINES), counted("m", 1, 8, "1", COSINE_ORDERS)] },
    Family { name: "nodes", options: &[counted("n", 4, 16, "8", NODES)] },
    Family {
        name: "baked",
        options: &[counted("degree", 2, 16, "8", DEGREES), counted("denominator", 0, 8, "0", DEGREES)],
    },
    Family { name: "fitted", options: &[worded("form", ""), counted("k", 1, 12, "", COSINES), worded("rms", "")] },
    Family { name: "fresnel", options: &[worded("form", "exact")] },
    Family { name: "spectral", options: &[counted("n", 2, 512, "81", WAVELENGTHS)] },
];

/// The family that is written by its size instead of options.
const TABLE: &str = "table";

/// The sizes that a table may have, and the most entries: the time that judges take to read a table in GLSL grows with the
/// square of its size.
const TABLE_ANGLES: std::ops::RangeInclusive<usize> = 2..=1024;
const TABLE_THICKNESSES: std::ops::RangeInclusive<usize> = 1..=1024;
const TABLE_ENTRIES: usize = 4096;

impl FromStr for Variant {
    type Err = VariantError;

    fn from_str(text: &str) -> Result<Self, VariantError> {
        let (name, rest) = text.trim().split_once(':').unwrap_or((text.trim(), ""));
        if name == TABLE {
            return table(text, rest);
        }
        let Some(family) = FAMILIES.iter().find(|family| family.name == name) else {
            let known: Vec<&str> = FAMILIES.iter().map(|family| family.name).chain([TABLE]).collect();
            return Err(VariantError {
                message: format!("unknown method `{}` in the variant `{}`", shown(name), shown(text)),
                help: format!("the methods are {}; for example windowed:k=6", known.join(", ")),
                excess: None,
            });
        };
        let given = options(text, family, rest)?;
        let value = |wanted: &str| -> &str {
            let row = family.options.iter().find(|row| row.name == wanted);
            let default = row.map_or("", |row| row.default);
            given.iter().find(|(name, _)| *name == wanted).map_or(default, |(_, value)| value)
        };
        let counted = |name: &str| number(text, family, name, value(name));
        let optional = |name: &str| if value(name).is_empty() { Ok(None) } else { counted(name).map(Some) };
        Ok(match family.name {
            "series" => Variant::Series { order: counted("m")?, fit: fit(text, value("fit"))? },
            "poles" => Variant::Poles { count: counted("k")? },
            "windowed" => windowed(text, counted("k")?, optional("groups")?)?,
            "cosines" => Variant::Cosines { count: counted("k")?, order: counted("m")? },
            "nodes" => Variant::Nodes { count: counted("n")? },
            "baked" => Variant::Baked { degree: counted("degree")?, denominator: counted("denominator")? },
            "fitted" => fitted(text, value("form"), optional("k")?, value("rms"))?,
            "fresnel" => fresnel(text, value("form"))?,
            _ => Variant::Spectral { count: counted("n")? },
        })
    }
}

/// The options of a variant, each known to the family and given once.
fn options<'a>(text: &str, family: &Family, rest: &'a str) -> Result<Vec<(&'a str, &'a str)>, VariantError> {
    let example = |row: &OptionRow| match row.default {
        "" => row.name.to_owned(),
        default => format!("{}={default}", row.name),
    };
    let known: Vec<String> = family.options.iter().map(example).collect();
    let help = format!("{} takes {}", family.name, known.join(","));
    let mut given: Vec<(&str, &str)> = Vec::new();
    for part in rest.split(',').filter(|part| !part.is_empty()) {
        let refuse = |message: String| Err(VariantError { message, help: help.clone(), excess: None });
        let (name, value) = part.split_once('=').unwrap_or((part, ""));
        if value.is_empty() {
            return refuse(format!("the option `{}` in the variant `{}` has no value", shown(name), shown(text)));
        }
        if !family.options.iter().any(|row| row.name == name) {
            return refuse(format!("unknown option `{}` in the variant `{}`", shown(name), shown(text)));
        }
        if given.iter().any(|(other, _)| *other == name) {
            return refuse(format!("the option `{name}` stands twice in the variant `{}`", shown(text)));
        }
        given.push((name, value));
    }
    Ok(given)
}

fn number(text: &str, family: &Family, name: &str, value: &str) -> Result<usize, VariantError> {
    let range = family.options.iter().find(|row| row.name == name).and_then(|row| row.range);
    let (low, high, samples) = range.unwrap_or((0, 0, ENTRIES));
    match value.parse::<usize>() {
        Ok(number) if (low..=high).contains(&number) => Ok(number),
        _ => Err(VariantError {
            message: format!("`{name}={}` in the variant `{}` is out of range", shown(value), shown(text)),
            help: format!("{name} is a whole number from {low} to {high}"),
            excess: whole(value).filter(|asked| *asked > high as f64).map(|asked| Excess { asked, samples }),
        }),
    }
}

/// A whole number that is written in digits, however large.
fn whole(text: &str) -> Option<f64> {
    let is_whole = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_whole { text.parse().ok() } else { None }
}

fn fit(text: &str, value: &str) -> Result<Fit, VariantError> {
    let counted = |prefix: &str| -> Option<usize> {
        value.strip_prefix(prefix)?.parse().ok().filter(|count| (1..=5).contains(count))
    };
    let found = match value {
        "xyz-gauss" => Some(Fit::XyzGauss),
        "exact" => Some(Fit::Exact),
        _ => counted("xyz-gauss-")
            .map(Fit::XyzGaussians)
            .or_else(|| counted("rgb-gauss-").map(Fit::RgbGaussians))
            .or_else(|| counted("shared-gauss-").map(Fit::SharedGaussians)),
    };
    found.ok_or_else(|| VariantError {
        message: format!("unknown fit `{}` in the variant `{}`", shown(value), shown(text)),
        help: "the fits are xyz-gauss, xyz-gauss-K, rgb-gauss-K, shared-gauss-K, with K from 1 to 5, and exact"
            .to_owned(),
        excess: None,
    })
}

fn windowed(text: &str, count: usize, groups: Option<usize>) -> Result<Variant, VariantError> {
    match groups {
        Some(groups) if groups > count => Err(VariantError {
            message: format!("`groups={groups}` in the variant `{}` is more than there are wave numbers", shown(text)),
            help: format!("groups is at most k, here {count}"),
            excess: None,
        }),
        _ => Ok(Variant::Windowed { count, groups }),
    }
}

fn fitted(text: &str, form: &str, count: Option<usize>, rms: &str) -> Result<Variant, VariantError> {
    let named = |candidate: &FittedForm| form == candidate.name() || form == candidate.short_name();
    let form = match (form, FittedForm::ALL.into_iter().find(named)) {
        ("", _) => None,
        (_, Some(form)) => Some(form),
        (_, None) => {
            return Err(VariantError {
                message: format!("unknown form `{}` in the variant `{}`", shown(form), shown(text)),
                help: format!("the forms are {}", FittedForm::ALL.map(FittedForm::name).join(", ")),
                excess: None,
            });
        }
    };
    let rms_error = match rms {
        "" => FITTED_RMS_ERROR,
        _ => rms.parse().ok().filter(|error: &f64| *error > 0.0 && *error <= 1.0).ok_or_else(|| VariantError {
            message: format!("`rms={}` in the variant `{}` is no error", shown(rms), shown(text)),
            help: format!("rms is a number above 0, such as {FITTED_RMS_ERROR}"),
            excess: None,
        })?,
    };
    let count = count.unwrap_or(form.map_or(6, FittedForm::default_count));
    Ok(Variant::Fitted { form, count, rms_error })
}

fn fresnel(text: &str, form: &str) -> Result<Variant, VariantError> {
    match form {
        "schlick" => Ok(Variant::Fresnel { form: FresnelForm::Schlick }),
        "exact" => Ok(Variant::Fresnel { form: FresnelForm::Exact }),
        _ => Err(VariantError {
            message: format!("unknown form `{}` in the variant `{}`", shown(form), shown(text)),
            help: "the forms are exact and schlick".to_owned(),
            excess: None,
        }),
    }
}

fn table(text: &str, size: &str) -> Result<Variant, VariantError> {
    let parsed = size.split_once('x').and_then(|(angles, thicknesses)| {
        let (angles, thicknesses) = (angles.parse::<usize>().ok()?, thicknesses.parse::<usize>().ok()?);
        let fits = TABLE_ANGLES.contains(&angles) && TABLE_THICKNESSES.contains(&thicknesses);
        (fits && angles * thicknesses <= TABLE_ENTRIES).then_some(Variant::Table { angles, thicknesses })
    });
    parsed.ok_or_else(|| VariantError {
        message: format!("`{}` in the variant `{}` is no size of a table", shown(size), shown(text)),
        help: format!(
            "write table:WxH with W angles ({} to {}) and H thicknesses ({} to {}), at most {TABLE_ENTRIES} entries: \
             table:64x64; H is 1 for a film of one thickness",
            TABLE_ANGLES.start(),
            TABLE_ANGLES.end(),
            TABLE_THICKNESSES.start(),
            TABLE_THICKNESSES.end()
        ),
        excess: size
            .split_once('x')
            .and_then(|(angles, thicknesses)| Some(whole(angles)? * whole(thicknesses)?))
            .filter(|asked| *asked > TABLE_ENTRIES as f64)
            .map(|asked| Excess { asked, samples: ENTRIES }),
    })
}

/// User text in a message: short, and without control characters.
fn shown(text: &str) -> String {
    let mut shown: String = text.chars().take(60).flat_map(char::escape_debug).collect();
    if text.chars().count() > 60 {
        shown.push('…');
    }
    shown
}
