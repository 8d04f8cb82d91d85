//! The variant: by which method, and with which options, a colour is computed.

use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// A fit of the sensitivities that the series uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fit {
    /// `xyz-gauss`: the four Gaussians over X, Y and Z of Belcour and Barla 2017.
    XyzGauss,
    /// `xyz-gauss-K`: K Gaussians for each of X, Y and Z.
    XyzGaussians(usize),
    /// `rgb-gauss-K`: K Gaussians for each output channel.
    RgbGaussians(usize),
    /// `shared-gauss-K`: K Gaussians that the channels share.
    SharedGaussians(usize),
}

impl Fit {
    /// The names that are understood, for messages.
    pub const NAMES: [&'static str; 4] = ["xyz-gauss", "xyz-gauss-K", "rgb-gauss-K", "shared-gauss-K"];
    const COUNTS: std::ops::RangeInclusive<usize> = 1..=5;
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fit::XyzGauss => write!(f, "xyz-gauss"),
            Fit::XyzGaussians(count) => write!(f, "xyz-gauss-{count}"),
            Fit::RgbGaussians(count) => write!(f, "rgb-gauss-{count}"),
            Fit::SharedGaussians(count) => write!(f, "shared-gauss-{count}"),
        }
    }
}

/// A method with its options, written `family:option=value,option=value`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variant {
    /// `series:m=M,fit=F`: the series over orders of interference, up to order M.
    Series {
        /// The highest order.
        order: usize,
        /// The sensitivities.
        fit: Fit,
    },
    /// `poles:k=K`: all orders in closed form, with the sensitivities as K complex exponentials.
    Poles {
        /// How many poles.
        count: usize,
    },
    /// `windowed:k=K`: all orders as a Poisson kernel, with the sensitivities as K wave numbers under a window.
    Windowed {
        /// How many wave numbers.
        count: usize,
    },
    /// `cosines:k=K,m=M`: the series up to order M, with the sensitivities as K wave numbers under a window.
    Cosines {
        /// How many wave numbers.
        count: usize,
        /// The highest order.
        order: usize,
    },
    /// `nodes:n=N`: the exact reflectance at N wavelengths whose weights are fitted over the scene's range.
    Nodes {
        /// How many wavelengths.
        count: usize,
    },
    /// `baked:degree=N`: a polynomial of degree N over the angle, for a uniform film.
    Baked {
        /// The degree.
        degree: usize,
    },
    /// `spectral:n=N`: the exact reflectance at N wavelengths from 380 to 780 nm, equally spaced.
    Spectral {
        /// How many wavelengths.
        count: usize,
    },
}

/// A text that is no variant.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{message}")]
pub struct VariantError {
    message: String,
    help: String,
}

impl VariantError {
    /// What would be right.
    pub fn help(&self) -> &str {
        &self.help
    }
}

/// The families with their options: name, smallest and largest number (or the words), default.
struct Family {
    name: &'static str,
    options: &'static [OptionRow],
}

struct OptionRow {
    name: &'static str,
    /// The range of a number; nothing for a fit.
    range: Option<(usize, usize)>,
    default: &'static str,
}

const fn counted(name: &'static str, low: usize, high: usize, default: &'static str) -> OptionRow {
    OptionRow { name, range: Some((low, high)), default }
}

const FAMILIES: [Family; 7] = [
    Family {
        name: "series",
        options: &[counted("m", 1, 32, "3"), OptionRow { name: "fit", range: None, default: "xyz-gauss" }],
    },
    Family { name: "poles", options: &[counted("k", 3, 8, "6")] },
    Family { name: "windowed", options: &[counted("k", 4, 10, "6")] },
    Family { name: "cosines", options: &[counted("k", 4, 10, "6"), counted("m", 1, 8, "1")] },
    Family { name: "nodes", options: &[counted("n", 4, 16, "8")] },
    Family { name: "baked", options: &[counted("degree", 2, 16, "8")] },
    Family { name: "spectral", options: &[counted("n", 2, 512, "81")] },
];

impl Variant {
    /// Variants to choose from where nothing says which.
    pub fn candidates() -> Vec<Variant> {
        let belcour_barla = [1, 2, 3, 4, 6, 8].map(|order| Variant::Series { order, fit: Fit::XyzGauss });
        let fitted = [
            (2, Fit::SharedGaussians(3)),
            (3, Fit::SharedGaussians(4)),
            (4, Fit::SharedGaussians(5)),
            (3, Fit::RgbGaussians(3)),
            (3, Fit::XyzGaussians(3)),
        ];
        let fitted = fitted.map(|(order, fit)| Variant::Series { order, fit });
        let poles = [4, 5, 6, 8].map(|count| Variant::Poles { count });
        let windowed = [4, 6, 8].map(|count| Variant::Windowed { count });
        let cosines = [(4, 1), (6, 1), (6, 2)].map(|(count, order)| Variant::Cosines { count, order });
        let nodes = [6, 8, 10, 16].map(|count| Variant::Nodes { count });
        let spectral = [16, 32, 81].map(|count| Variant::Spectral { count });
        let baked = [4, 6, 8, 12].map(|degree| Variant::Baked { degree });
        let families = [&belcour_barla[..], &fitted, &cosines, &windowed, &poles, &nodes, &baked, &spectral];
        families.concat()
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Variant::Series { order, fit } => write!(f, "series:m={order},fit={fit}"),
            Variant::Poles { count } => write!(f, "poles:k={count}"),
            Variant::Windowed { count } => write!(f, "windowed:k={count}"),
            Variant::Cosines { count, order } => write!(f, "cosines:k={count},m={order}"),
            Variant::Nodes { count } => write!(f, "nodes:n={count}"),
            Variant::Baked { degree } => write!(f, "baked:degree={degree}"),
            Variant::Spectral { count } => write!(f, "spectral:n={count}"),
        }
    }
}

impl FromStr for Variant {
    type Err = VariantError;

    fn from_str(text: &str) -> Result<Self, VariantError> {
        let (name, rest) = text.trim().split_once(':').unwrap_or((text.trim(), ""));
        let Some(family) = FAMILIES.iter().find(|family| family.name == name) else {
            let known: Vec<&str> = FAMILIES.iter().map(|family| family.name).collect();
            return Err(VariantError {
                message: format!("unknown method `{}` in the variant `{}`", shown(name), shown(text)),
                help: format!("the methods are {}; for example series:m=3,fit=xyz-gauss", known.join(", ")),
            });
        };
        let given = options(text, family, rest)?;
        let value = |wanted: &str| -> &str {
            let row = family.options.iter().find(|row| row.name == wanted);
            let default = row.map_or("", |row| row.default);
            given.iter().find(|(name, _)| *name == wanted).map_or(default, |(_, value)| value)
        };
        let counted = |name: &str| number(text, family, name, value(name));
        Ok(match family.name {
            "series" => Variant::Series { order: counted("m")?, fit: fit(text, value("fit"))? },
            "poles" => Variant::Poles { count: counted("k")? },
            "windowed" => Variant::Windowed { count: counted("k")? },
            "cosines" => Variant::Cosines { count: counted("k")?, order: counted("m")? },
            "nodes" => Variant::Nodes { count: counted("n")? },
            "baked" => Variant::Baked { degree: counted("degree")? },
            _ => Variant::Spectral { count: counted("n")? },
        })
    }
}

/// The options of a variant, each known to the family and given once.
fn options<'a>(text: &str, family: &Family, rest: &'a str) -> Result<Vec<(&'a str, &'a str)>, VariantError> {
    let known: Vec<String> = family.options.iter().map(|row| format!("{}={}", row.name, row.default)).collect();
    let help = format!("{} takes {}", family.name, known.join(","));
    let mut given: Vec<(&str, &str)> = Vec::new();
    for part in rest.split(',').filter(|part| !part.is_empty()) {
        let refuse = |message: String| Err(VariantError { message, help: help.clone() });
        let Some((name, value)) = part.split_once('=') else {
            return refuse(format!("the option `{}` in the variant `{}` has no value", shown(part), shown(text)));
        };
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
    let (low, high) = range.unwrap_or((0, 0));
    match value.parse::<usize>() {
        Ok(number) if (low..=high).contains(&number) => Ok(number),
        _ => Err(VariantError {
            message: format!("`{name}={}` in the variant `{}` is out of range", shown(value), shown(text)),
            help: format!("{name} is a whole number from {low} to {high}"),
        }),
    }
}

fn fit(text: &str, value: &str) -> Result<Fit, VariantError> {
    let counted = |prefix: &str| -> Option<usize> {
        value.strip_prefix(prefix)?.parse().ok().filter(|count| Fit::COUNTS.contains(count))
    };
    let found = match value {
        "xyz-gauss" => Some(Fit::XyzGauss),
        _ => counted("xyz-gauss-")
            .map(Fit::XyzGaussians)
            .or_else(|| counted("rgb-gauss-").map(Fit::RgbGaussians))
            .or_else(|| counted("shared-gauss-").map(Fit::SharedGaussians)),
    };
    found.ok_or_else(|| VariantError {
        message: format!("unknown fit `{}` in the variant `{}`", shown(value), shown(text)),
        help: format!("the fits are {}, with K from 1 to 5", Fit::NAMES.join(", ")),
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

#[cfg(test)]
mod tests {
    use super::{Fit, Variant};

    #[test]
    fn variants_are_read_and_written_back() {
        let cases = [
            ("series:m=3,fit=xyz-gauss", Variant::Series { order: 3, fit: Fit::XyzGauss }),
            ("series:fit=xyz-gauss,m=5", Variant::Series { order: 5, fit: Fit::XyzGauss }),
            ("series:m=2,fit=shared-gauss-4", Variant::Series { order: 2, fit: Fit::SharedGaussians(4) }),
            ("series:m=2,fit=rgb-gauss-1", Variant::Series { order: 2, fit: Fit::RgbGaussians(1) }),
            ("poles:k=5", Variant::Poles { count: 5 }),
            ("windowed", Variant::Windowed { count: 6 }),
            ("cosines:m=2", Variant::Cosines { count: 6, order: 2 }),
            ("nodes:n=9", Variant::Nodes { count: 9 }),
            ("baked:degree=5", Variant::Baked { degree: 5 }),
            ("series", Variant::Series { order: 3, fit: Fit::XyzGauss }),
            ("spectral:n=16", Variant::Spectral { count: 16 }),
            ("spectral", Variant::Spectral { count: 81 }),
        ];
        for (text, expected) in cases {
            assert_eq!(text.parse(), Ok(expected), "{text}");
            assert_eq!(expected.to_string().parse(), Ok(expected), "{expected}");
        }
    }

    #[test]
    fn what_is_no_variant_is_refused_with_help() {
        let cases = [
            ("", "unknown method ``", "series, poles"),
            ("sereis:m=3", "unknown method `sereis`", "series, poles"),
            ("series:m=0", "`m=0`", "from 1 to 32"),
            ("series:m=33", "`m=33`", "from 1 to 32"),
            ("series:m=-1", "`m=-1`", "from 1 to 32"),
            ("series:m", "`m` in the variant `series:m` has no value", "series takes m=3,fit=xyz-gauss"),
            ("series:k=3", "unknown option `k`", "series takes"),
            ("series:m=3,m=4", "`m` stands twice", "series takes"),
            ("series:fit=rgb", "unknown fit `rgb`", "xyz-gauss"),
            ("series:fit=rgb-gauss-6", "unknown fit `rgb-gauss-6`", "K from 1 to 5"),
            ("series:fit=rgb-gauss-", "unknown fit `rgb-gauss-`", "K from 1 to 5"),
            ("poles:k=2", "`k=2`", "from 3 to 8"),
            ("spectral:n=1", "`n=1`", "from 2 to 512"),
            ("spectral:n=99999999999999999999", "`n=99999999999999999999`", "from 2 to 512"),
        ];
        for (text, message, help) in cases {
            let error = text.parse::<Variant>().expect_err(text);
            assert!(error.to_string().contains(message), "{text}: {error}");
            assert!(error.help().contains(help), "{text}: {}", error.help());
        }
    }

    #[test]
    fn candidates_are_all_readable() {
        for candidate in Variant::candidates() {
            assert_eq!(candidate.to_string().parse(), Ok(candidate));
        }
    }
}
