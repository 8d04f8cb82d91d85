//! The median of some measurements, and how far they lie apart.

use serde::Serialize;

/// Where measurements lie, in their unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// The least.
    pub least: f64,
    /// A quarter of them lies below.
    pub lower_quartile: f64,
    /// Half of them lies below.
    pub median: f64,
    /// A quarter of them lies above.
    pub upper_quartile: f64,
    /// The greatest.
    pub greatest: f64,
}

impl Spread {
    /// The spread of some measurements; all 0 where there are none.
    pub(super) fn of(mut values: Vec<f64>) -> Spread {
        values.sort_unstable_by(f64::total_cmp);
        let at = |part: f64| {
            let place = part * values.len().saturating_sub(1) as f64;
            let (below, above) = (values.get(place.floor() as usize), values.get(place.ceil() as usize));
            let (below, above) = (below.copied().unwrap_or_default(), above.copied().unwrap_or_default());
            below + (above - below) * place.fract()
        };
        Spread {
            least: at(0.0),
            lower_quartile: at(0.25),
            median: at(0.5),
            upper_quartile: at(0.75),
            greatest: at(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_neighbours() {
        let of = |values: &[f64]| {
            let spread = Spread::of(values.to_vec());
            [spread.least, spread.lower_quartile, spread.median, spread.upper_quartile, spread.greatest]
        };
        assert_eq!(of(&[5.0, 1.0, 3.0, 2.0, 4.0]), [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(of(&[2.0, 1.0]), [1.0, 1.25, 1.5, 1.75, 2.0]);
        assert_eq!(of(&[7.0]), [7.0; 5]);
        assert_eq!(of(&[]), [0.0; 5]);
    }
}
