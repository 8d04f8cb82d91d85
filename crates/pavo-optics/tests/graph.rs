//! Each surface as a graph computes what it computes on `f64`, bit for bit; what varies is an input, the rest is folded.

mod common;

use common::{Random, film, order_sums, wide_fit, window};
use glam::DVec3;
use pavo_optics::surface::shade_surface;
use pavo_optics::{
    BakedFilm, BaseKind, Directions, Film, Finish, Layers, Light, Method, SpectralNode, Specular, Surface, VisibilityK,
    WindowGroup,
};
use pavo_shade::{Expr, Graph, Input, Rate, Real, Scalar, Type, Vector, interpret};

/// Layers and finish as plain numbers, thickness to the parameter k, and which of them are inputs.
struct Parameters {
    numbers: [f64; 8],
    varying: [bool; 8],
}

const NAMES: [&str; 8] =
    ["thickness_nm", "ambient_ior", "film_ior", "base_ior", "base_kappa", "roughness", "metalness", "visibility_k"];

/// The surface under directions and parameters of any number type.
///
/// The colour is that of the base in each workflow: its base colour, or its reflectance and its edge tint.
fn radiance<S: Scalar>(surface: &Surface, vectors: [S::Vec3; 3], color: S::Vec3, numbers: [S; 8]) -> S::Vec3 {
    let [normal, light_direction, view_direction] = vectors;
    let [thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, roughness, metalness, visibility_k] = numbers;
    shade_surface::<S>(
        surface,
        Directions { normal, light_direction, view_direction },
        Layers { thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, f0: color, edge_tint: color },
        Finish { roughness, base_color: color, metalness, visibility_k },
        Light { light_color: S::Vec3::lit3([1.0, 0.9, 0.8]), light_intensity: S::lit(2.0) },
    )
}

/// The same number: the same bits, or both zero.
fn same_number(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a == 0.0 && b == 0.0)
}

/// Native and recorded computation agree at points over the sphere.
fn check(surface: &Surface, parameters: &Parameters, seed: u64) {
    let graph = Graph::new();
    let vector = |name: &str| graph.input(Input { ty: Type::Vec3, ..Input::scalar(name, "", -1.0, 1.0, Rate::Pixel) });
    let vectors = ["normal", "light_direction", "view_direction"].map(vector);
    let color = graph.input(Input::colour("base_color", Rate::Material));
    let numbers: [Expr<'_>; 8] = core::array::from_fn(|index| {
        let number = parameters.numbers[index];
        if !parameters.varying[index] {
            return Expr::lit(number);
        }
        graph.input(Input::scalar(NAMES[index], "", 0.0, 1000.0, Rate::Material))
    });
    graph.output("radiance", radiance::<Expr<'_>>(surface, vectors, color, numbers).as_vec3());
    let program = graph.program();

    let mut random = Random::new(seed);
    for _ in 0..30 {
        let mut unit = || DVec3::from_array(core::array::from_fn(|_| random.within(-1.0, 1.0))).normalize();
        let mut vectors = [unit(), unit(), unit()];
        for index in [1, 2] {
            // Mostly above the horizon.
            if random.unit() < 0.9 {
                vectors[index] *= vectors[0].dot(vectors[index]).signum();
            }
        }
        let color = DVec3::from_array(core::array::from_fn(|_| random.unit()));
        let native = radiance::<f64>(surface, vectors, color, parameters.numbers);

        let value = |input: &Input| match input.name.as_str() {
            "normal" => vectors[0].to_array().to_vec(),
            "light_direction" => vectors[1].to_array().to_vec(),
            "view_direction" => vectors[2].to_array().to_vec(),
            "base_color" => color.to_array().to_vec(),
            name => NAMES.iter().zip(parameters.numbers).filter(|(other, _)| **other == name).map(|(_, x)| x).collect(),
        };
        let point: Vec<f64> = program.inputs().iter().flat_map(value).collect();
        let recorded = interpret::evaluate(&program, &point)[0];
        for (native, recorded) in native.to_array().into_iter().zip(recorded) {
            assert!(same_number(native, recorded), "{surface:?} at {vectors:?}: {native:e} and {recorded:e}");
        }
    }
}

fn spectral(bases: [Option<(f64, f64)>; 2]) -> Method {
    Method::Spectral { nodes: nodes(bases) }
}

fn nodes([first, second]: [Option<(f64, f64)>; 2]) -> Vec<SpectralNode> {
    let node = |wavelength_nm, weight, base| SpectralNode { wavelength_nm, weight, base, film: None };
    vec![node(600.0, [0.8, 0.3, 0.0], first), node(470.0, [0.2, 0.7, 1.0], second)]
}

fn grouped([first, second]: [Option<(f64, f64)>; 2], film: Option<f64>) -> Method {
    let group = |nodes, base, film| WindowGroup { nodes, base, film };
    let groups = vec![group(2, first, None), group(3, second, film)];
    Method::WindowedGroups { window: window(2500.0), groups }
}

/// Each kind of surface by each method, with and without total reflection.
fn surfaces() -> Vec<Surface> {
    let dielectric = BaseKind::Dielectric { total_reflection: false };
    let reflecting = BaseKind::Dielectric { total_reflection: true };
    let dispersive = [Some((0.2, 3.6)), Some((1.4, 1.9))];
    let mut speculars = Vec::new();
    for method in order_sums().into_iter().chain([spectral([None; 2])]) {
        for total_reflection in [false, true] {
            let film = |base| -> Film { film(base, total_reflection, method.clone()) };
            speculars.extend([dielectric, reflecting, BaseKind::Conductor].map(|base| Specular::Film(film(base))));
            speculars.push(Specular::FilmOnChannels {
                film: film(BaseKind::Conductor),
                base_ior: [0.2, 0.4, 1.4],
                base_kappa: [3.6, 2.5, 1.9],
            });
            speculars.push(Specular::FilmOnMetalness(film(dielectric)));
            speculars.extend([reflecting, BaseKind::Conductor].map(|base| Specular::FilmOnF0(film(base))));
        }
    }
    for total_reflection in [false, true] {
        speculars.push(Specular::Film(film(BaseKind::Conductor, total_reflection, spectral(dispersive))));
        for film_ior in [None, Some(1.6)] {
            let method = grouped(dispersive, film_ior);
            speculars.push(Specular::Film(film(BaseKind::Conductor, total_reflection, method)));
        }
    }
    speculars.extend([dielectric, BaseKind::Conductor].map(Specular::Bare));
    speculars.extend([Specular::BareSpectral(nodes(dispersive)), Specular::BareMetalness { exact: false }]);
    speculars.extend([dielectric, BaseKind::Conductor].map(|base| Specular::BareF0 { base, exact: true }));
    let coefficients = vec![[0.4, 0.3, 0.5], [-0.2, 0.1, 0.0], [0.1, 0.1, -0.2]];
    for denominator in [vec![], vec![[0.3, -0.2, 0.1], [0.1, 0.4, -0.3]]] {
        speculars.push(Specular::Baked(BakedFilm { coefficients: coefficients.clone(), denominator }));
    }
    let mut surfaces: Vec<Surface> = speculars
        .into_iter()
        .map(|specular| Surface { specular, diffuse: true, visibility_k: VisibilityK::Punctual })
        .collect();
    let first = surfaces[0].clone();
    surfaces.push(Surface { diffuse: false, ..first.clone() });
    surfaces.push(Surface { visibility_k: VisibilityK::ImageBased, ..first.clone() });
    surfaces.push(Surface { visibility_k: VisibilityK::Given, ..first });
    surfaces
}

/// Soap on plastic: no total reflection from air.
const NUMBERS: [f64; 8] = [380.0, 1.0, 1.33, 1.55, 0.3, 0.4, 0.35, 0.2];

/// Under glass: total reflection into a film of air.
const UNDER_GLASS: [f64; 8] = [120.0, 1.5, 1.0, 1.45, 2.3, 0.25, 0.7, 0.15];

#[test]
fn surfaces_of_which_all_varies_agree() {
    for (index, surface) in surfaces().iter().enumerate() {
        check(surface, &Parameters { numbers: NUMBERS, varying: [true; 8] }, index as u64);
    }
}

#[test]
fn surfaces_of_which_nothing_but_directions_and_colour_varies_agree() {
    for (index, surface) in surfaces().iter().enumerate() {
        check(surface, &Parameters { numbers: NUMBERS, varying: [false; 8] }, 100 + index as u64);
    }
}

#[test]
fn surfaces_of_which_the_film_varies_agree() {
    let varying = [true, false, true, false, false, false, false, false];
    for (index, surface) in surfaces().iter().enumerate() {
        check(surface, &Parameters { numbers: NUMBERS, varying }, 200 + index as u64);
    }
}

/// Whether the code of this surface provides for a film below the ambient index.
fn reflects_totally(surface: &Surface) -> bool {
    match &surface.specular {
        Specular::Film(film) => film.total_reflection && film.base != BaseKind::Dielectric { total_reflection: false },
        Specular::FilmOnChannels { film, .. } | Specular::FilmOnF0(film) => film.total_reflection,
        _ => false,
    }
}

#[test]
fn surfaces_under_total_reflection_agree() {
    let surfaces: Vec<Surface> = surfaces().into_iter().filter(reflects_totally).collect();
    assert_eq!(surfaces.len(), 43);
    for (index, surface) in surfaces.iter().enumerate() {
        for varying in [[true; 8], [false; 8]] {
            check(surface, &Parameters { numbers: UNDER_GLASS, varying }, 300 + index as u64);
        }
    }
}

/// The inputs that the program of a surface needs, of all that could vary.
fn needed_inputs(surface: &Surface) -> Vec<String> {
    let graph = Graph::new();
    let numbers = NAMES.map(|name| graph.input(Input::scalar(name, "", 0.0, 1000.0, Rate::Material)));
    let up = Expr::lit3([0.0, 0.0, 1.0]);
    let light = graph.input(Input { ty: Type::Vec3, ..Input::scalar("light_direction", "", -1.0, 1.0, Rate::Pixel) });
    let color = graph.input(Input::colour("base_color", Rate::Material));
    graph.output("radiance", radiance::<Expr<'_>>(surface, [up, light, up], color, numbers));
    graph.program().inputs().iter().map(|input| input.name.clone()).collect()
}

#[test]
fn a_surface_takes_no_input_that_it_does_not_use() {
    let with = |specular| Surface { specular, diffuse: true, visibility_k: VisibilityK::Punctual };
    let dielectric = BaseKind::Dielectric { total_reflection: false };
    let on = |base| Specular::Film(film(base, false, Method::Series { order: 3, fit: wide_fit() }));
    let cases: [(Specular, &[&str]); 6] = [
        (Specular::BareMetalness { exact: false }, &["roughness", "metalness"]),
        (Specular::BareF0 { base: BaseKind::Conductor, exact: true }, &["ambient_ior", "roughness"]),
        (Specular::Bare(dielectric), &["ambient_ior", "base_ior", "roughness"]),
        (Specular::Bare(BaseKind::Conductor), &["ambient_ior", "base_ior", "base_kappa", "roughness"]),
        (on(dielectric), &["thickness_nm", "ambient_ior", "film_ior", "base_ior", "roughness"]),
        (on(BaseKind::Conductor), &["thickness_nm", "ambient_ior", "film_ior", "base_ior", "base_kappa", "roughness"]),
    ];
    for (specular, expected) in cases {
        let surface = with(specular);
        let expected = [expected, &["light_direction", "base_color"]].concat();
        assert_eq!(needed_inputs(&surface), expected, "{surface:?}");
    }
}
