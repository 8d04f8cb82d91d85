//! A program in parts computes what it computes as a whole, bit for bit, and what is passed is worth it.

mod common;
mod random;

use common::same_number;
use pavo_shade::{
    Expr, Graph, Input, LEAST_SAVED, Program, Rate, Real, Split, Stages, Value, interpret, shade, split, stages,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Values, program};

fn keep(value: f64) -> f64 {
    value
}

/// The outputs of both parts, one after the other.
fn in_two(whole: &Program, split: &Split, point: &[f64]) -> Vec<[f64; 3]> {
    interpret::evaluate(&split.pixel, &split.pixel_point(whole.inputs(), point, keep))
}

/// The outputs of all three parts, one after the other.
fn in_three(whole: &Program, stages: &Stages, point: &[f64]) -> Vec<[f64; 3]> {
    let point = stages.material.pixel_point(whole.inputs(), point, keep);
    in_two(&stages.material.pixel, &stages.vertex, &point)
}

#[test]
fn random_programs_compute_the_same_in_parts() {
    let config = Config { cases: 4000, failure_persistence: None, max_global_rejects: 4000, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let with_rates = (program(), prop::array::uniform3(0_usize..3));
    let outcome = runner.run(&with_rates, |((steps, point), rates)| {
        let rates = rates.map(|rate| Rate::ALL[rate]);
        let graph = Graph::new();
        let x = graph.input(Input::scalar("x", "", -4.0, 4.0, rates[0]));
        let y = graph.input(Input::scalar("y", "", -4.0, 4.0, rates[1]));
        let vector = graph.input(Input { low: -4.0, high: 4.0, ..Input::colour("v", rates[2]) });
        let recorded = Values::<Expr<'_>>::new(x, y, vector).run(&steps);
        recorded.numbers.into_iter().chain(recorded.vectors).for_each(|value| graph.output("value", value));
        let whole = graph.program();
        // The numbers of the point that the program takes.
        let kept: Vec<f64> = [("x", 0..1), ("y", 1..2), ("v", 2..5)]
            .into_iter()
            .filter(|(name, _)| whole.inputs().iter().any(|input| input.name == *name))
            .flat_map(|(_, range)| point[range].to_vec())
            .collect();
        let expected = interpret::evaluate(&whole, &kept);
        // Folding takes values to be finite.
        prop_assume!(expected.iter().flatten().all(|value| value.is_finite()));
        let by_rate = whole.operations_by_rate();
        prop_assert_eq!(by_rate.material + by_rate.vertex + by_rate.pixel, whole.operations());
        let mut found = Vec::new();
        for rate in [Rate::Material, Rate::Vertex] {
            let split = split(&whole, rate);
            found.push(in_two(&whole, &split, &kept));
            found.push(interpret::evaluate(&split.joined, &kept));
            let [before, after] = [&whole, &split.pixel].map(|program| program.operations().weight());
            prop_assert!(before >= after + LEAST_SAVED * split.prepared.len(), "{} to {}", before, after);
        }
        let stages = stages(&whole);
        found.push(in_three(&whole, &stages, &kept));
        found.push(interpret::evaluate(&stages.joined, &kept));
        for found in found {
            prop_assert_eq!(found.len(), expected.len());
            for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                prop_assert!(same_number(*found, *expected), "{:e} in parts, {:e} as a whole", found, expected);
            }
        }
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}

/// Weighs a pixel.
#[shade]
fn weighed<R: Real>(
    /// Of the pixel.
    x: R,
    /// Of the material.
    m: R,
) -> R {
    let width = (m * m + 1.0).sqrt();
    x * width
}

/// The names of what is prepared, and what of the inputs the pixel still takes.
fn names(split: &Split) -> (Vec<&str>, Vec<&str>) {
    let inputs = split.pixel.inputs().iter().map(|input| input.name.as_str());
    (split.prepared.iter().map(|prepared| prepared.name.as_str()).collect(), inputs.collect())
}

/// A program of a material's number `m` and a pixel's number `x`.
fn of_two(record: impl for<'g> Fn(Expr<'g>, Expr<'g>) -> Expr<'g>) -> Split {
    let graph = Graph::new();
    let m = graph.input(Input::scalar("m", "", 1.0, 2.0, Rate::Material));
    let x = graph.input(Input::scalar("x", "", 0.0, 1.0, Rate::Pixel));
    graph.output("value", record(m, x));
    split(&graph.program(), Rate::Material)
}

#[test]
fn a_value_inside_a_function_is_prepared_and_passed_to_it() {
    let split = of_two(|m, x| weighed(x, m));
    assert_eq!(names(&split), (vec!["width"], vec!["x", "width"]));
    let [function] = split.pixel.functions() else { panic!("{:?}", split.pixel) };
    assert_eq!(function.name, "weighed");
    assert_eq!((split.saved.arithmetic, split.saved.roots), (2, 1));
}

#[test]
fn a_function_that_is_called_twice_stays_one_function() {
    let split = of_two(|m, x| weighed(x, m) + weighed(x, m + Expr::lit(1.0)));
    assert_eq!(names(&split), (vec!["width", "width_2"], vec!["x", "width", "width_2"]));
    assert_eq!(split.pixel.functions().len(), 1);
}

#[test]
fn a_chain_is_passed_at_its_last_value() {
    let split = of_two(|m, x| x * (m.sqrt() + Expr::lit(1.0)).exp());
    assert_eq!(split.prepared.len(), 1);
    assert_eq!(split.pixel.operations().weight(), 1);
}

#[test]
fn one_costly_value_is_passed_instead_of_many_cheap_ones_made_of_it() {
    let split = of_two(|m, x| {
        let root = m.sqrt().named("root");
        (2..7).fold(x, |sum, factor| (sum * (root * Expr::lit(f64::from(factor)))).sin())
    });
    assert_eq!(names(&split).0, ["root"]);
}

#[test]
fn what_saves_too_little_is_not_passed() {
    for split in
        [of_two(|m, x| x * (m + Expr::lit(1.0))), of_two(|m, x| x * m), of_two(|m, _| m), of_two(|_, x| x.sin())]
    {
        assert!(split.prepare.is_none() && split.prepared.is_empty(), "{:?}", split.prepared);
        assert_eq!(split.saved.weight(), 0);
    }
}

#[test]
fn the_inputs_of_the_pixel_carry_the_ranges_of_what_is_prepared() {
    let split = of_two(|m, x| weighed(x, m));
    let input = split.pixel.inputs().last().unwrap_or_else(|| panic!("there is one"));
    assert_eq!(input.rate, Rate::Material);
    assert!((input.low - 2.0_f64.sqrt()).abs() < 1e-5 && (input.high - 5.0_f64.sqrt()).abs() < 1e-5, "{input:?}");
}

/// A function that keeps its second argument a parameter.
#[shade]
fn scaled<R: Real>(x: R, #[runtime] factor: R) -> R {
    x * factor.sqrt().exp()
}

#[test]
fn what_is_known_at_build_time_is_not_passed() {
    let split = of_two(|_, x| scaled(x, Expr::lit(3.0)));
    assert!(split.prepare.is_none());
    let split = of_two(|m, x| scaled(x, Expr::lit(3.0)) + scaled(x, m));
    assert!(split.prepare.is_none(), "one function takes both: {:?}", split.prepared);
}

/// The parts of a program of a material's number `m`, a vertex's number `u` and a pixel's number `x`.
fn of_three(record: impl for<'g> Fn([Expr<'g>; 3]) -> Expr<'g>) -> (Program, Stages) {
    let graph = Graph::new();
    let m = graph.input(Input::scalar("m", "", 1.0, 2.0, Rate::Material));
    let u = graph.input(Input::scalar("u", "", 1.0, 2.0, Rate::Vertex));
    let x = graph.input(Input::scalar("x", "", 0.0, 1.0, Rate::Pixel));
    graph.output("value", record([m, u, x]));
    let whole = graph.program();
    let stages = stages(&whole);
    (whole, stages)
}

#[test]
fn each_value_is_computed_by_the_part_of_its_rate() {
    let (whole, stages) = of_three(|[m, u, x]| {
        let of_material = m.sqrt().exp().named("of_material");
        let of_vertex = (u.sqrt() * of_material).exp().named("of_vertex");
        x * of_vertex + (x * of_material).sin()
    });
    assert_eq!(names(&stages.material), (vec!["of_material"], vec!["u", "x", "of_material"]));
    assert_eq!(names(&stages.vertex), (vec!["of_vertex"], vec!["x", "of_material", "of_vertex"]));
    let called: Vec<&str> = stages.joined.functions().iter().map(|function| function.name.as_str()).collect();
    assert_eq!(called, ["prepare_surface", "vertex_surface"]);
    let by_rate = whole.operations_by_rate();
    assert_eq!((by_rate.material.weight(), by_rate.vertex.weight(), by_rate.pixel.weight()), (8, 9, 7));
}

#[test]
fn what_depends_on_the_material_alone_is_not_passed_by_the_vertices() {
    let graph = Graph::new();
    let m = graph.input(Input::scalar("m", "", 1.0, 2.0, Rate::Material));
    let x = graph.input(Input::scalar("x", "", 0.0, 1.0, Rate::Pixel));
    graph.output("value", x * m.sqrt().exp());
    let split = split(&graph.program(), Rate::Vertex);
    assert!(split.prepare.is_none(), "{:?}", split.prepared);
}
