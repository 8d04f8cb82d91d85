//! The variant that is chosen by itself keeps to its budget, on points that the choice has not seen.

use pavo::points::spread;
use pavo::scene::Scene;
use pavo::tuning::{Budget, CostKind, DEFAULT_MAX_DELTA_E, TuningError, pick, tune};
use pavo::{NoCache, Shading, ShadingQuantity, Variant};
use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::delta_e_of_linear;
use pavo_tests::unused::unused_names;
use pavo_tests::{SCENES, run, scene_file};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");
const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;

/// The largest dE2000 of a variant over 20,000 points that no other code has seen.
fn largest_delta_e(scene: &Scene, variant: &str) -> f64 {
    let variant: Variant = variant.parse().expect("a variant");
    let shading = Shading::new(scene, &variant).unwrap_or_else(|error| panic!("{variant}: {error}"));
    let mut inputs = shading.inputs(QUANTITY);
    inputs.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| input.low = 0.01);
    let points = spread(&inputs, 20_000, 101);
    let expected = shading.reference_each(QUANTITY, &points).expect("the reference reaches every point");
    let found = shading.evaluate_each(QUANTITY, &points);
    let space = ColourSpace::from_name(&scene.colour.space).expect("a known space");
    found.iter().zip(&expected).map(|(found, expected)| delta_e_of_linear(*found, *expected, space)).fold(0.0, f64::max)
}

#[test]
fn the_pick_for_each_starter_scene_keeps_to_its_budget() {
    for name in SCENES {
        let scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let tuning = tune(&scene, &CostKind::Operations, &NoCache, &|_, _| {}).expect("it can be measured");
        let frontier: Vec<_> = tuning.rows.iter().filter(|row| row.on_frontier).collect();
        assert!(frontier.is_sorted_by(|a, b| a.cost <= b.cost && a.errors.max_delta_e > b.errors.max_delta_e));
        let limit = scene.budget.max_delta_e.unwrap_or(DEFAULT_MAX_DELTA_E);
        let picked = pick(&scene, &tuning, Budget::MaxDeltaE(limit), &NoCache);
        let picked = picked.unwrap_or_else(|error| panic!("{name}: {error}"));
        let largest = largest_delta_e(&scene, &picked.variant);
        println!("{name}: {} has {largest:.3} of {limit}", picked.variant);
        assert!(largest <= limit, "{name}: {} has {largest}, allowed {limit}", picked.variant);
        let variant: Variant = picked.variant.parse().expect("a variant");
        let shading = Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(unused_names(&shading), [""; 0], "{name} by {variant}");
        let refused = pick(&scene, &tuning, Budget::MaxCost(0.5), &NoCache);
        assert!(matches!(refused, Err(TuningError::Budget { .. })), "{name}: {refused:?}");
    }
}

#[test]
fn a_scene_may_leave_the_choice_to_the_budget() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let text = "name = 'lens'\n[film]\nior = 1.38\nthickness_nm = 100\n[base]\nior = 1.52\n[budget]\nmax_delta_e = 0.2\n\
                [emit]\nvariant = 'auto'\n";
    std::fs::write(folder.path().join("lens.toml"), text).expect("the scene can be written");
    let ran = run(PROGRAM, folder.path(), &["emit", "lens.toml", "--target", "wgsl"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    assert!(ran.output.contains("Variant: ") && !ran.output.contains("auto"), "{}", ran.output);
    let ran = run(PROGRAM, folder.path(), &["tune", "lens.toml", "--max-cost", "1"]);
    assert_eq!(ran.status, 1, "{}", ran.errors);
    assert!(ran.errors.contains("keeps to the budget"), "{}", ran.errors);
}
