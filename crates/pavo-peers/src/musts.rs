//! What pavo has to reach beside the peers.

use crate::classes::Class;
use crate::measure::{ClassReport, Row};
use serde::Serialize;

/// A variant that is this much nearer to the exact colours, at no more than this much of the cost.
struct Must {
    class: Class,
    peer: &'static str,
    /// How many times lower the RMS error must be.
    times_lower: f64,
    /// The most of the peer's net inverse throughput on navi21.
    most_cost: f64,
    /// The most of the peer's net time on lavapipe.
    most_time: Option<f64>,
}

const MUSTS: [Must; 4] = [
    Must { class: Class::Dielectric, peer: "three.js", times_lower: 30.0, most_cost: 0.65, most_time: Some(0.5) },
    Must { class: Class::Conductor, peer: "three.js", times_lower: 50.0, most_cost: 0.9, most_time: Some(0.5) },
    Must { class: Class::Dielectric, peer: "MaterialX", times_lower: 10.0, most_cost: 0.4, most_time: None },
    Must { class: Class::Conductor, peer: "MaterialX", times_lower: 7.0, most_cost: 0.5, most_time: None },
];

/// What came of one of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The class of surfaces.
    pub class: Class,
    /// The peer.
    pub peer: String,
    /// How many times lower the RMS error must be.
    pub least_times_lower: f64,
    /// The most of the peer's net inverse throughput on navi21.
    pub most_cost: f64,
    /// The most of the peer's net time on lavapipe, where there is such a bound.
    pub most_time: Option<f64>,
    /// Whether a variant reaches all of it.
    pub is_reached: bool,
    /// The most accurate variant that reaches all of it; where none does, of those that keep the bound of the cost.
    pub best: Option<Figures>,
    /// The cheapest variant that is accurate enough, where none reaches all of it.
    pub cheapest_accurate: Option<Figures>,
}

/// A variant beside a peer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figures {
    /// The variant.
    pub variant: String,
    /// How many times lower its RMS error is.
    pub times_lower: f64,
    /// Its net inverse throughput on navi21 as a multiple of the peer's.
    pub cost: f64,
    /// Its net time on lavapipe as a multiple of the peer's.
    pub time: Option<f64>,
}

/// What came of all of them.
pub fn outcomes(classes: &[ClassReport]) -> Vec<Outcome> {
    let outcome = |must: &Must| {
        let rows = &classes.iter().find(|report| report.class == must.class)?.rows;
        let peer = rows.iter().find(|row| row.peer.as_deref() == Some(must.peer))?;
        let all: Vec<Figures> = rows.iter().filter(|row| row.is_pavo).map(|row| Figures::beside(row, peer)).collect();
        Some(must.outcome(&peer.name, &all))
    };
    MUSTS.iter().filter_map(outcome).collect()
}

impl Must {
    fn outcome(&self, peer: &str, all: &[Figures]) -> Outcome {
        let is_accurate = |figures: &&Figures| figures.times_lower >= self.times_lower;
        let is_cheap = |figures: &&Figures| figures.cost <= self.most_cost;
        let is_quick =
            |figures: &&Figures| self.most_time.is_none_or(|most| figures.time.is_some_and(|time| time <= most));
        let accuracy = |a: &&Figures, b: &&Figures| a.times_lower.total_cmp(&b.times_lower);
        let reached = all.iter().filter(is_accurate).filter(is_cheap).filter(is_quick).max_by(accuracy);
        let best = reached.or_else(|| all.iter().filter(is_cheap).max_by(accuracy));
        let cheapest = all.iter().filter(is_accurate).min_by(|a, b| a.cost.total_cmp(&b.cost));
        Outcome {
            class: self.class,
            peer: peer.to_owned(),
            least_times_lower: self.times_lower,
            most_cost: self.most_cost,
            most_time: self.most_time,
            is_reached: reached.is_some(),
            best: best.cloned(),
            cheapest_accurate: cheapest.filter(|_| reached.is_none()).cloned(),
        }
    }
}

impl Figures {
    fn beside(row: &Row, peer: &Row) -> Figures {
        Figures {
            variant: row.name.trim_start_matches("pavo ").to_owned(),
            times_lower: peer.errors.rms / row.errors.rms,
            cost: row.navi21.ratio / peer.navi21.ratio,
            // Both are multiples of one reference, in the same rounds.
            time: row.lavapipe.zip(peer.lavapipe).map(|(own, peer)| own.ratio / peer.ratio),
        }
    }

    fn text(&self) -> String {
        let Figures { variant, times_lower, cost, time } = self;
        let time = time.map_or("not timed".to_owned(), |time| format!("lavapipe {time:.2}"));
        format!("{variant}: RMS {times_lower:.1} times lower, navi21 {cost:.2}, {time}")
    }
}

impl Outcome {
    /// A line of the report.
    pub fn line(&self) -> String {
        let Outcome { class, peer, least_times_lower, most_cost, .. } = self;
        let time = self.most_time.map(|most| format!(", lavapipe at most {most}")).unwrap_or_default();
        let verdict = if self.is_reached { "pass" } else { "FAIL" };
        let or_none = |figures: &Option<Figures>| figures.as_ref().map_or("none".to_owned(), Figures::text);
        let mut line = format!(
            "Must, {} against {peer}: RMS at least {least_times_lower} times lower, navi21 at most {most_cost}{time}: \
             {verdict}. ",
            class.name()
        );
        line += &if self.is_reached {
            or_none(&self.best)
        } else {
            let (best, cheapest) = (or_none(&self.best), or_none(&self.cheapest_accurate));
            format!("The best at that cost, {best}; the cheapest that is accurate enough, {cheapest}")
        };
        line
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MUST: Must =
        Must { class: Class::Dielectric, peer: "peer", times_lower: 30.0, most_cost: 0.65, most_time: Some(0.5) };

    fn outcome(figures: &[(f64, f64, f64)]) -> Outcome {
        let figures = figures.iter().enumerate().map(|(index, &(times_lower, cost, time))| Figures {
            variant: format!("v{index}"),
            times_lower,
            cost,
            time: Some(time),
        });
        MUST.outcome("peer 1.0", &figures.collect::<Vec<_>>())
    }

    fn variant(figures: &Option<Figures>) -> Option<&str> {
        figures.as_ref().map(|figures| figures.variant.as_str())
    }

    #[test]
    fn the_most_accurate_variant_that_reaches_everything_is_named() {
        let found = outcome(&[(33.0, 0.5, 0.4), (60.0, 0.65, 0.5), (300.0, 0.66, 0.4), (150.0, 0.6, 0.51)]);
        assert_eq!((variant(&found.best), variant(&found.cheapest_accurate)), (Some("v1"), None));
        let line = found.line();
        assert!(line.ends_with("pass. v1: RMS 60.0 times lower, navi21 0.65, lavapipe 0.50"), "{line}");
    }

    #[test]
    fn where_none_does_what_comes_nearest_on_each_side_is_named() {
        let found = outcome(&[(15.0, 0.5, 0.4), (20.0, 0.64, 0.5), (300.0, 0.7, 0.4), (400.0, 0.8, 0.4)]);
        assert_eq!((variant(&found.best), variant(&found.cheapest_accurate)), (Some("v1"), Some("v2")));
        assert!(!found.is_reached && found.line().contains("FAIL"), "{}", found.line());
        assert!(outcome(&[]).line().ends_with("accurate enough, none"));
    }
}
