//! Many starts over few points, then the best of them over all points.

use super::layout::Layout;
use super::model::Sample;
use super::problem::{Solution, improve, solve_linear_part};
use super::random::Random;
use super::start::start;
use crate::media::Media;
use rayon::prelude::*;

/// How many starts a form gets.
const STARTS: u64 = 16;
/// The rounds of the best starts: how many go on, over every so many-th point, with so many evaluations for each parameter.
const ROUNDS: [Round; 2] = [Round { count: 5, stride: 3, patience: 6 }, Round { count: 2, stride: 1, patience: 6 }];
/// Starts see every so many-th point.
const COARSE_STRIDE: usize = 3;
/// A fit over few points that is this many times further off than what is asked for is given up.
const HOPELESS: f64 = 2.0;
/// Two fits whose errors differ by less than this part are taken for the same.
const SAME: f64 = 1e-3;

struct Round {
    count: usize,
    stride: usize,
    patience: usize,
}

/// The best parameters of a form that are found. The same seed gives the same ones. What is far from the error asked for
/// after the first round does not get there in the next, which takes as long as all before it: it ends there.
pub(super) fn solve(layout: &Layout, media: Media, samples: &[Sample], seed: u64, rms_error: Option<f64>) -> Solution {
    let coarse: Vec<Sample> = samples.iter().copied().step_by(COARSE_STRIDE).collect();
    let first = |index: u64| {
        let mut random = Random::new(seed.wrapping_mul(STARTS).wrapping_add(index));
        let parameters = solve_linear_part(layout, &coarse, start(layout, media, &mut random));
        improve(layout, &coarse, parameters, 1)
    };
    let mut solutions: Vec<Solution> = (0..STARTS).into_par_iter().map(first).collect();
    for round in &ROUNDS {
        solutions.sort_by(|a, b| a.rms.total_cmp(&b.rms));
        solutions.dedup_by(|later, earlier| later.rms - earlier.rms < SAME * earlier.rms);
        solutions.truncate(round.count);
        let chosen: Vec<Sample> = samples.iter().copied().step_by(round.stride).collect();
        let go_on = |solution: Solution| improve(layout, &chosen, solution.parameters, round.patience);
        solutions = solutions.into_par_iter().map(go_on).collect();
        let is_hopeless = |limit: f64| solutions.iter().all(|solution| solution.rms > HOPELESS * limit);
        if rms_error.is_some_and(is_hopeless) {
            break;
        }
    }
    let best = solutions.into_iter().min_by(|a, b| a.rms.total_cmp(&b.rms));
    best.expect("there is at least one start")
}
