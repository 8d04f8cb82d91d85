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
    /// The variant that comes nearest.
    pub variant: String,
    /// How many times lower its RMS error is.
    pub times_lower: f64,
    /// How many times lower it must be.
    pub least_times_lower: f64,
    /// Its net inverse throughput on navi21 as a multiple of the peer's.
    pub cost: f64,
    /// The most that it may be.
    pub most_cost: f64,
    /// Its net time on lavapipe as a multiple of the peer's.
    pub time: Option<f64>,
    /// The most that it may be, where there is such a bound.
    pub most_time: Option<f64>,
    /// Whether all of it is reached.
    pub is_reached: bool,
}

/// What came of all of them.
pub fn outcomes(classes: &[ClassReport]) -> Vec<Outcome> {
    let outcome = |must: &Must| {
        let rows = &classes.iter().find(|report| report.class == must.class)?.rows;
        let peer = rows.iter().find(|row| row.peer.as_deref() == Some(must.peer))?;
        let all = rows.iter().filter(|row| row.is_pavo).map(|row| must.outcome(row, peer));
        // The most accurate of those that reach everything; where none does, of those that are cheap enough.
        all.max_by(|a, b| {
            let rank = |outcome: &Outcome| (outcome.is_reached, outcome.cost <= outcome.most_cost);
            rank(a).cmp(&rank(b)).then(a.times_lower.total_cmp(&b.times_lower))
        })
    };
    MUSTS.iter().filter_map(outcome).collect()
}

impl Must {
    fn outcome(&self, row: &Row, peer: &Row) -> Outcome {
        let times_lower = peer.errors.rms / row.errors.rms;
        let cost = row.navi21.net.inverse_throughput as f64 / peer.navi21.net.inverse_throughput as f64;
        let time = row.lavapipe.zip(peer.lavapipe).map(|(own, peer)| own.nanoseconds / peer.nanoseconds);
        let is_quick = self.most_time.is_none_or(|most| time.is_some_and(|time| time <= most));
        Outcome {
            class: self.class,
            peer: peer.name.clone(),
            variant: row.name.clone(),
            times_lower,
            least_times_lower: self.times_lower,
            cost,
            most_cost: self.most_cost,
            time,
            most_time: self.most_time,
            is_reached: times_lower >= self.times_lower && cost <= self.most_cost && is_quick,
        }
    }
}

impl Outcome {
    /// A line of the report.
    pub fn line(&self) -> String {
        let Outcome { variant, peer, times_lower, least_times_lower, cost, most_cost, .. } = self;
        let time = match (self.time, self.most_time) {
            (Some(time), Some(most)) => format!(", at {time:.2} of its lavapipe time (at most {most})"),
            (Some(time), None) => format!(", at {time:.2} of its lavapipe time (no bound)"),
            _ => String::new(),
        };
        format!(
            "Must, {}: {variant} has {times_lower:.1} times lower RMS than {peer} (at least {least_times_lower}) at \
             {cost:.2} of its navi21 cost (at most {most_cost}){time}: {}",
            self.class.name(),
            if self.is_reached { "pass" } else { "FAIL" }
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Cost, Errors, Time};
    use pavo_check::static_cost::NetCost;

    fn row(name: &str, peer: Option<&str>, rms: f64, cost: i64, nanoseconds: f64) -> Row {
        let net = NetCost { instructions: cost, inverse_throughput: cost, latency: cost, code_size: cost };
        let cost = Cost { net, net_with_exit: None, vgprs: 8, ratio: 1.0 };
        Row {
            name: name.to_owned(),
            peer: peer.map(str::to_owned),
            is_pavo: peer.is_none(),
            errors: Errors { max: rms, rms, rms_clamped: rms, mean_delta_e: rms },
            navi21: cost.clone(),
            vega10: cost,
            lavapipe: Some(Time { nanoseconds, ratio: 1.0, ratio_lower_quartile: 1.0, ratio_upper_quartile: 1.0 }),
        }
    }

    fn outcome(of_pavo: &[(f64, i64, f64)]) -> Outcome {
        let mut rows = vec![row("peer", Some("three.js"), 0.03, 100, 10.0)];
        let name = |index: usize| format!("variant {index}");
        rows.extend(
            of_pavo.iter().enumerate().map(|(index, (rms, cost, time))| row(&name(index), None, *rms, *cost, *time)),
        );
        let report = ClassReport { class: Class::Dielectric, points: 1, rows };
        outcomes(&[report]).into_iter().next().expect("the peer is there")
    }

    #[test]
    fn the_most_accurate_variant_that_reaches_everything_is_named() {
        let found = outcome(&[(0.0009, 50, 4.0), (0.0005, 65, 5.0), (0.0001, 66, 4.0), (0.0002, 60, 5.1)]);
        assert_eq!((found.variant.as_str(), found.is_reached), ("variant 1", true));
        assert!(found.line().ends_with("pass"), "{}", found.line());
    }

    #[test]
    fn where_none_does_the_most_accurate_that_is_cheap_enough_is_named() {
        let found = outcome(&[(0.002, 50, 4.0), (0.0015, 64, 5.0), (0.0001, 66, 4.0)]);
        assert_eq!((found.variant.as_str(), found.is_reached), ("variant 1", false));
        assert!(found.line().ends_with("FAIL"), "{}", found.line());
    }
}
