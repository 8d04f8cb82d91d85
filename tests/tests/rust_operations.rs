//! Each operation of the graph, as it is written in Rust: random programs are compiled and run.

#[path = "rust/project.rs"]
mod project;
#[path = "../../crates/pavo-shade/tests/random/mod.rs"]
mod random;
#[path = "rust/signature.rs"]
mod signature;

use pavo_emit::{Language, Options, emit_library};
use pavo_shade::{Graph, Input, Rate, Real, Scalar, Vector, shade};
use project::{Evaluation, Project, difference};
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Step, Values};
use signature::Module;

/// A function of random steps: the sum of all its values.
#[shade]
fn random_color<S: Scalar>(x: S, y: S, v: S::Vec3, #[constant] steps: &[Step]) -> S::Vec3 {
    sum(Values::<S>::new(x, y, v).run(steps))
}

fn sum<S: Scalar>(values: Values<S>) -> S::Vec3 {
    let numbers = values.numbers.into_iter().map(S::Vec3::splat);
    numbers.chain(values.vectors).fold(S::Vec3::lit(0.0), |sum, value| sum + value)
}

/// How many random programs are compiled.
const PROGRAMS: usize = 100;

#[test]
fn each_operation_is_written_as_it_is_computed() {
    let mut runner = TestRunner::new_with_rng(Config::default(), TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let mut next = || random::program().new_tree(&mut runner).unwrap_or_else(|error| panic!("{error}")).current();
    let programs: Vec<Vec<Step>> = (0..PROGRAMS).map(|_| next().0).collect();
    let points: Vec<Vec<f32>> = (0..50).map(|_| next().1.map(|number| number as f32).to_vec()).collect();
    let inputs = [
        Input::scalar("x", "", -4.0, 4.0, Rate::Pixel),
        Input::scalar("y", "", -4.0, 4.0, Rate::Pixel),
        Input { low: -4.0, high: 4.0, ..Input::colour("v", Rate::Pixel) },
    ];
    let options = Options { language: Language::Rust, header: Vec::new(), prefix: String::new(), source_lines: false };
    let mut modules = Vec::new();
    let mut evaluations = Vec::new();
    for (number, steps) in programs.iter().enumerate() {
        let graph = Graph::new();
        let [x, y, v] = inputs.clone().map(|input| graph.input(input));
        graph.output("color", random_color(x, y, v, steps).as_vec3());
        let name = format!("random_{number:03}");
        let text = emit_library(&graph.program(), &options);
        let expression = Module::new(&name, &text).call("random_color", &inputs);
        evaluations.push(Evaluation { expression, points: points.clone() });
        modules.push((name, text));
    }
    let project = Project::new("generated-operations", &modules);
    project.format();
    let results = project.run(&evaluations);
    let mut compared = 0;
    for ((found, steps), (name, text)) in results.iter().zip(&programs).zip(&modules) {
        let native =
            |point: &Vec<f32>| random_color(point[0], point[1], glam::Vec3::from_slice(&point[2..]), steps).to_array();
        let expected: Vec<[f32; 3]> = points.iter().map(native).collect();
        let finite =
            found.iter().zip(&expected).filter(|(_, expected)| expected.iter().all(|number| number.is_finite()));
        let (found, expected): (Vec<[f32; 3]>, Vec<[f32; 3]>) = finite.unzip();
        let different = found
            .iter()
            .zip(&expected)
            .filter(|(found, expected)| difference(&[**found], &[**expected]) > 1e-3)
            .count();
        compared += found.len();
        // A constant that is folded in double precision can lie on the other side of a step.
        assert!(different <= found.len() / 10, "{name}: {different} of {} differ\n{text}", found.len());
    }
    assert!(compared > PROGRAMS * 25, "{compared} points have finite values");
}
