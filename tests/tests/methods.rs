//! Each method: what it emits computes on lavapipe what the Rust function computes, a mirror stays white in every colour
//! space and under every illuminant, and an absent film is none.

use pavo::roads::{Road, evaluate};
use pavo::scene::{ILLUMINANTS, OBSERVERS, SPACES, Scene};
use pavo::statistics::Difference;
use pavo::{Fit, Shading, ShadingError, ShadingQuantity, Variant};
use pavo_check::Device;
use std::path::Path;

const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;

/// A film for each kind of method: name, and the tables of its scene.
const FILMS: [(&str, &str); 9] = [
    ("dielectric", "[film]\nior = 1.5\nthickness_nm = [0, 1500]\n[base]\nior = 1.33"),
    ("conductor", "[film]\nior = 2.4\nthickness_nm = [0, 600]\n[base]\nior = 2.7\nkappa = 3.8"),
    ("any-media", "[film]\nior = [1.3, 2.4]\nthickness_nm = [0, 1000]\n[base]\nior = [1.1, 3]\nkappa = [0.1, 4]"),
    ("dispersive", "[film]\nmaterial = 'SiO2'\nthickness_nm = [0, 600]\n[base]\nmetal = 'Au'"),
    (
        "metalness",
        "[film]\nior = 1.5\nthickness_nm = [100, 900]\n[base]\nworkflow = 'metalness'\n[surface]\nbase_color = 'input'",
    ),
    ("f0", "[film]\nior = [1.3, 2]\nthickness_nm = [0, 1200]\n[base]\nworkflow = 'f0'\nf0 = 'input'"),
    (
        "edge-tint",
        "[film]\nior = [1.3, 2]\nthickness_nm = [0, 1200]\n[base]\nworkflow = 'f0'\nf0 = 'input'\nedge_tint = 'input'",
    ),
    (
        "under-water",
        "[ambient]\nior = 1.33\n[film]\nior = 1.5\nthickness_nm = [0, 600]\n[base]\nworkflow = 'f0'\nf0 = [0.05, 0.2, 1]",
    ),
    ("uniform", "[film]\nior = 1.38\nthickness_nm = 250\n[base]\nior = 1.52"),
];

fn scene(name: &str, tables: &str, colour: &str) -> Scene {
    let text = format!("name = '{name}'\n[colour]\n{colour}\n{tables}\n");
    Scene::from_toml("scene.toml", &text, Path::new(".")).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Points over the ranges of a surface's inputs, as `f32` has them.
fn points(shading: &Shading, count: usize, least_cosine: f64) -> Vec<Vec<f32>> {
    let mut inputs = shading.inputs(QUANTITY);
    inputs.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| input.low = least_cosine);
    let points = pavo::points::spread(&inputs, count, 5);
    points.into_iter().map(|point| point.into_iter().map(|number| number as f32).collect()).collect()
}

fn in_f64(colors: Vec<[f32; 3]>) -> Vec<[f64; 3]> {
    colors.into_iter().map(|color| color.map(f64::from)).collect()
}

fn run(device: &Device, road: Road, shading: &Shading, points: &[Vec<f32>]) -> Vec<[f64; 3]> {
    let colors = evaluate(device, road, shading, QUANTITY, points);
    in_f64(colors.unwrap_or_else(|error| panic!("{} of {}: {error}", shading.variant(), shading.scene().name)))
}

#[test]
fn every_method_computes_on_lavapipe_what_it_computes_on_the_cpu() {
    let device = Device::lavapipe().expect("lavapipe is needed: cargo xtask setup");
    let mut failures = Vec::new();
    for variant in Variant::candidates() {
        let mut made = 0;
        for (name, tables) in FILMS {
            let shading = match Shading::new(&scene(name, tables, ""), &variant) {
                Err(ShadingError::Variant { .. }) => continue,
                other => other.unwrap_or_else(|error| panic!("{variant} of {name}: {error}")),
            };
            made += 1;
            let points = points(&shading, 2000, 0.05);
            let double: Vec<Vec<f64>> =
                points.iter().map(|point| point.iter().copied().map(f64::from).collect()).collect();
            let cpu_f32 = in_f64(shading.evaluate_each_f32(QUANTITY, &points));
            let cpu_f64 = shading.evaluate_each(QUANTITY, &double);
            // Both roads run the same text in two languages: one film will do for the second.
            let roads = if made == 1 { &[Road::Wgsl, Road::Glsl][..] } else { &[Road::Wgsl] };
            for &road in roads {
                let found = run(&device, road, &shading, &points);
                // The kernel under a window multiplies what it rounds by up to 10.
                let rounding = if matches!(variant, Variant::Windowed { .. }) { 1e-5 } else { 5e-6 };
                for (expected, allowed) in [(&cpu_f32, rounding), (&cpu_f64, 2e-5)] {
                    let difference = Difference::between(&found, expected, 1);
                    if difference.max > allowed || difference.not_finite > 0 {
                        failures.push(format!("{variant} of {name} by {}: {difference:?}", road.name()));
                    }
                }
            }
        }
        assert!(made > 0, "{variant} was made for no film");
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// One variant of each method that serves any media.
fn general() -> Vec<Variant> {
    let texts = [
        "series:m=3,fit=xyz-gauss",
        "series:m=2,fit=xyz-gauss-3",
        "series:m=2,fit=rgb-gauss-3",
        "series:m=2,fit=shared-gauss-4",
        "series:m=3,fit=exact",
        "poles:k=5",
        "windowed:k=6",
        "cosines:k=6,m=1",
        "nodes:n=8",
        "spectral:n=16",
        "spectral:n=81",
    ];
    texts.map(|text| text.parse().expect("a variant")).to_vec()
}

/// A space for which Gaussians for each channel are not built in.
const ON_DEMAND: &str = "observer = 'cie1931-2deg'\nilluminant = 'D65'\nspace = 'display-p3'";

/// Every observer, illuminant and space, as the keys of a scene.
fn colours() -> Vec<String> {
    let mut colours = Vec::new();
    for observer in OBSERVERS {
        for illuminant in ILLUMINANTS {
            for space in SPACES {
                colours.push(format!("observer = '{observer}'\nilluminant = '{illuminant}'\nspace = '{space}'"));
            }
        }
    }
    colours
}

#[test]
fn a_mirror_without_a_film_is_white_in_every_method_space_and_illuminant() {
    let device = Device::lavapipe().expect("lavapipe is needed: cargo xtask setup");
    // Beyond the critical angle of glass, everything is mirrored. The film has the index of the glass: it is none.
    let media = "[ambient]\nior = 1.5\n[film]\nior = 1.5\nthickness_nm = [0, 2000]\n[base]\nior = 1";
    let points: Vec<Vec<f32>> =
        [0.02, 0.2, 0.5, 0.7].iter().flat_map(|&cosine| [0.0, 330.0, 1900.0].map(|nm| vec![cosine, nm])).collect();
    let white = vec![[1.0; 3]; points.len()];
    for colour in colours() {
        let scene = scene("mirror", media, &colour);
        for variant in general() {
            // Gaussians for each channel are built in for linear sRGB; elsewhere each fit takes seconds: one will do.
            let is_rgb = matches!(variant, Variant::Series { fit: Fit::RgbGaussians(_), .. });
            if is_rgb && !colour.contains("linear-srgb") && colour != ON_DEMAND {
                continue;
            }
            // The fit of Belcour and Barla is of the observer of 1931.
            let shading = match Shading::new(&scene, &variant) {
                Err(ShadingError::Variant { .. })
                    if matches!(variant, Variant::Series { fit: Fit::XyzGauss, .. }) && !colour.contains("cie1931") =>
                {
                    continue;
                }
                other => other.unwrap_or_else(|error| panic!("{variant} with {colour}: {error}")),
            };
            // On the CPU for all, and on the device for the default observer.
            let found = in_f64(shading.evaluate_each_f32(QUANTITY, &points));
            let mut all = vec![found];
            if colour.contains("cie1931") && colour.contains("D65") {
                all.push(run(&device, Road::Wgsl, &shading, &points));
            }
            for found in all {
                let difference = Difference::between(&found, &white, 1);
                assert!(difference.max <= 1e-6, "{variant} with {colour}: {difference:?}");
            }
        }
    }
}

#[test]
fn an_absent_film_leaves_the_bare_reflectance() {
    let device = Device::lavapipe().expect("lavapipe is needed: cargo xtask setup");
    let absent = [
        ("index-of-ambient", "[film]\nior = 1\nthickness_nm = [0, 2000]\n[base]\nior = 1.5"),
        ("index-of-base", "[film]\nior = 1.5\nthickness_nm = [0, 2000]\n[base]\nior = 1.5"),
        ("index-of-ambient-on-metal", "[film]\nior = 1\nthickness_nm = [0, 2000]\n[base]\nior = 2.7\nkappa = 3.8"),
        ("no-thickness", "[film]\nior = 1.38\nthickness_nm = [0, 2000]\n[base]\nior = 1.52"),
        ("no-thickness-on-metal", "[film]\nior = 2.4\nthickness_nm = [0, 2000]\n[base]\nior = 2.7\nkappa = 3.8"),
    ];
    for (name, media) in absent {
        let base = media.split("[base]").nth(1).expect("it has a base");
        let bare = Shading::new(&scene("bare", &format!("[base]{base}"), ""), &general()[0]).expect("a bare surface");
        for variant in general() {
            let shading = Shading::new(&scene(name, media, ""), &variant).expect("any media will do");
            let points: Vec<Vec<f32>> = points(&shading, 300, 0.01)
                .into_iter()
                .map(|point| vec![point[0], if name.starts_with("no") { 0.0 } else { point[1] }])
                .collect();
            // A series cut off at an order lacks the orders above it where the film has no thickness.
            let is_truncated = matches!(variant, Variant::Series { .. } | Variant::Cosines { .. });
            if is_truncated && name.starts_with("no") {
                continue;
            }
            let expected: Vec<[f64; 3]> =
                points.iter().map(|point| bare.evaluate(QUANTITY, &[f64::from(point[0])])).collect();
            let found = run(&device, Road::Wgsl, &shading, &points);
            let difference = Difference::between(&found, &expected, 1);
            assert!(difference.max <= 1e-5, "{variant} with {name}: {difference:?}");
        }
    }
}

#[test]
fn a_series_of_a_film_without_thickness_is_grey_and_lacks_the_higher_orders_only() {
    let media = "[film]\nior = 2.4\nthickness_nm = [0, 2000]\n[base]\nior = 2.7\nkappa = 3.8";
    let bare =
        Shading::new(&scene("bare", "[base]\nior = 2.7\nkappa = 3.8", ""), &general()[0]).expect("a bare surface");
    for cosine in [0.1, 0.5, 1.0] {
        let [exact, ..] = bare.evaluate(QUANTITY, &[cosine]);
        let mut previous = f64::INFINITY;
        for order in [2, 4, 8, 16] {
            for fit in [Fit::XyzGauss, Fit::SharedGaussians(4), Fit::Exact] {
                let shading = Shading::new(&scene("film", media, ""), &Variant::Series { order, fit }).expect("a film");
                let [r, g, b] = shading.evaluate(QUANTITY, &[cosine, 0.0]);
                assert!((r - g).abs() < 1e-6 && (g - b).abs() < 1e-6, "{fit} at {cosine}: {r} {g} {b}");
                assert!((r - exact).abs() < previous, "{fit} at {cosine}, order {order}: {r} for {exact}");
            }
            previous = 0.9
                * (Shading::new(&scene("film", media, ""), &Variant::Series { order, fit: Fit::XyzGauss })
                    .expect("a film")
                    .evaluate(QUANTITY, &[cosine, 0.0])[0]
                    - exact)
                    .abs();
        }
    }
}

#[test]
fn a_base_whose_f0_is_that_of_air_mirrors_what_comes_under_glass_beyond_the_critical_angle() {
    let base = "[ambient]\nior = 1.5\n[base]\nworkflow = 'f0'\nf0 = [0, 0.04, 1]";
    let film = "[film]\nior = 1.5\nthickness_nm = [0, 600]";
    for (name, tables, variants) in [
        ("bare", base.to_owned(), vec!["fresnel:form=exact".parse().expect("a variant")]),
        ("film", format!("{base}\n{film}"), general()),
    ] {
        for variant in variants {
            let shading = Shading::new(&scene(name, &tables, ""), &variant).expect("any media will do");
            let point = |cosine: f64| if name == "bare" { vec![cosine] } else { vec![cosine, 330.0] };
            let [red, green, blue] = shading.evaluate(QUANTITY, &point(0.2));
            // Index 1 mirrors, 1.5 is the glass itself, and the largest index nearly mirrors.
            assert!((red - 1.0).abs() < 1e-6 && green.abs() < 1e-6, "{variant}: {red}, {green}");
            assert!((0.99..=1.0 + 1e-6).contains(&blue), "{variant}: {blue}");
            // Below the critical angle nothing mirrors so much.
            assert!(shading.evaluate(QUANTITY, &point(0.9))[0] < 0.2, "{variant}");
        }
    }
}
