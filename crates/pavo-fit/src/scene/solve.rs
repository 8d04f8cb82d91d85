//! Many starts over few points, then the best of them over all points.

use super::fresnel::Media;
use super::layout::Layout;
use super::model::Sample;
use super::problem::{Solution, improve, solve_linear_part};
use super::random::Random;
use super::start::start;
use rayon::prelude::*;

/// How many starts a form gets.
const STARTS: u64 = 12;
/// How many of them go on.
const FINALISTS: usize = 3;
/// The starts see every so many-th point.
const COARSE_STRIDE: usize = 3;
/// Evaluations for each parameter that a start gets, and that a finalist gets besides.
const PATIENCE: [usize; 2] = [1, 4];

/// The best parameters of a form that are found. The same seed gives the same ones.
pub(super) fn solve(layout: &Layout, media: Media, samples: &[Sample], seed: u64) -> Solution {
    let coarse: Vec<Sample> = samples.iter().copied().step_by(COARSE_STRIDE).collect();
    let first = |index: u64| {
        let mut random = Random::new(seed.wrapping_mul(STARTS).wrapping_add(index));
        let parameters = solve_linear_part(layout, &coarse, start(layout, media, &mut random));
        improve(layout, &coarse, parameters, PATIENCE[0])
    };
    let mut solutions: Vec<Solution> = (0..STARTS).into_par_iter().map(first).collect();
    solutions.sort_by(|a, b| a.rms.total_cmp(&b.rms));
    solutions.truncate(FINALISTS);
    let go_on = |solution: Solution| improve(layout, samples, solution.parameters, PATIENCE[1]);
    let finals: Vec<Solution> = solutions.into_par_iter().map(go_on).collect();
    let best = finals.into_iter().min_by(|a, b| a.rms.total_cmp(&b.rms));
    best.expect("there is at least one start")
}
