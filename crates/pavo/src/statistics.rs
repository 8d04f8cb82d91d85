//! Differences between two evaluations of the same points.

/// How far two lists of colours are apart.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Difference {
    /// How many points were compared.
    pub points: usize,
    /// The largest absolute difference in any channel.
    pub max: f64,
    /// The largest difference relative to `max(1, |expected|)`: absolute for what is small, relative for what is large.
    pub max_relative: f64,
    /// The root of the mean square over all points and channels.
    pub rms: f64,
    /// How many values were not finite in one list and finite in the other.
    pub not_finite: usize,
    /// The points with the largest differences, the largest first.
    pub worst: Vec<Worst>,
}

/// A point where two evaluations differ most.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Worst {
    /// Its index in the list.
    pub index: usize,
    /// The largest absolute difference in any of its channels.
    pub difference: f64,
    /// What was found.
    pub found: [f64; 3],
    /// What was expected.
    pub expected: [f64; 3],
}

impl Difference {
    /// Compares what was found with what was expected, and keeps the worst points.
    ///
    /// # Panics
    /// If the lists differ in length.
    pub fn between(found: &[[f64; 3]], expected: &[[f64; 3]], keep: usize) -> Self {
        assert_eq!(found.len(), expected.len(), "the same points are compared");
        let mut squares = 0.0;
        let mut max_relative = 0.0_f64;
        let mut not_finite = 0;
        let mut worst: Vec<Worst> = Vec::new();
        for (index, (&found, &expected)) in found.iter().zip(expected).enumerate() {
            let mut largest = 0.0_f64;
            for channel in 0..3 {
                let difference = (found[channel] - expected[channel]).abs();
                if difference.is_finite() {
                    squares += difference * difference;
                    largest = largest.max(difference);
                    max_relative = max_relative.max(difference / expected[channel].abs().max(1.0));
                } else if found[channel].is_finite() != expected[channel].is_finite() {
                    not_finite += 1;
                    largest = f64::INFINITY;
                    max_relative = f64::INFINITY;
                }
            }
            if worst.len() < keep || worst.last().is_some_and(|last| last.difference < largest) {
                let place = worst.partition_point(|other| other.difference >= largest);
                worst.insert(place, Worst { index, difference: largest, found, expected });
                worst.truncate(keep.max(1));
            }
        }
        let points = found.len();
        Self {
            points,
            max: worst.first().map_or(0.0, |worst| worst.difference),
            max_relative,
            rms: if points == 0 { 0.0 } else { (squares / (3 * points) as f64).sqrt() },
            not_finite,
            worst,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Difference;

    #[test]
    fn the_largest_differences_come_first() {
        let expected = vec![[0.0; 3]; 4];
        let found = [[0.1, 0.0, 0.0], [0.0, -0.4, 0.0], [0.0; 3], [0.0, 0.0, 0.2]];
        let difference = Difference::between(&found, &expected, 2);
        assert_eq!(difference.worst.iter().map(|worst| worst.index).collect::<Vec<_>>(), [1, 3]);
        assert_eq!(difference.max, 0.4);
        assert!((difference.rms - (0.21_f64 / 12.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn a_value_that_is_not_finite_counts_as_infinitely_wrong() {
        let difference = Difference::between(&[[f64::NAN, 0.0, 0.0]], &[[0.0; 3]], 1);
        assert_eq!((difference.not_finite, difference.max), (1, f64::INFINITY));
    }
}
