//! The whole surface by hand: what mirrors, what is left for diffuse reflection, microfacets and the light.

mod common;

use common::{Random, at_wavelength, film};
use glam::DVec3;
use pavo_optics::f0::index_from_f0;
use pavo_optics::film::film_reflectance;
use pavo_optics::fitted::fitted_reflectance;
use pavo_optics::fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_schlick, ior_from_reflectance};
use pavo_optics::lambert::lambert;
use pavo_optics::light::punctual_light;
use pavo_optics::metalness::metalness_colors;
use pavo_optics::surface::{shade_surface, surface_brdf, surface_radiance, surface_reflectance};
use pavo_optics::table::table_reflectance;
use pavo_optics::{
    BakedFilm, BaseKind, Directions, Film, Finish, Geometry, Layers, Light, Method, SpectralNode, Specular, Surface,
    VisibilityK,
};
use std::f64::consts::{PI, TAU};

const DIELECTRIC: BaseKind = BaseKind::Dielectric { total_reflection: false };
const KS: [VisibilityK; 3] = [VisibilityK::Punctual, VisibilityK::ImageBased, VisibilityK::Given];

/// Three wavelengths, one a channel.
fn three_wavelengths() -> Method {
    let node = |wavelength_nm, weight| SpectralNode { wavelength_nm, weight, base: None, film: None };
    Method::Spectral {
        nodes: vec![node(610.0, [1.0, 0.0, 0.0]), node(550.0, [0.0, 1.0, 0.0]), node(465.0, [0.0, 0.0, 1.0])],
    }
}

/// Everything that is computed from at one point.
#[derive(Clone, Copy, Debug)]
struct Point {
    geometry: Geometry<f64>,
    layers: Layers<f64>,
    finish: Finish<f64>,
    light: Light<f64>,
}

fn draw(random: &mut Random) -> Point {
    let mut colour = || DVec3::new(random.unit(), random.unit(), random.unit());
    let (base_color, light_color, f0, edge_tint) = (colour(), colour(), colour(), colour());
    Point {
        geometry: Geometry {
            n_dot_l: random.unit(),
            n_dot_v: random.within(1e-3, 1.0),
            n_dot_h: random.unit(),
            cos_theta1: random.unit(),
        },
        layers: Layers {
            thickness_nm: random.within(0.0, 1000.0),
            ambient_ior: 1.0,
            film_ior: random.within(1.0, 2.5),
            base_ior: random.within(1.0, 3.0),
            base_kappa: random.within(0.0, 5.0),
            f0,
            edge_tint,
        },
        finish: Finish {
            roughness: random.within(0.05, 1.0),
            base_color,
            metalness: random.unit(),
            visibility_k: random.within(0.01, 1.0),
        },
        light: Light { light_color, light_intensity: random.within(0.0, 10.0) },
    }
}

/// What reflects, one of each kind.
fn speculars() -> Vec<Specular> {
    let film = |base| film(base, false, three_wavelengths());
    let dispersive = |wavelength_nm, weight, base| SpectralNode { wavelength_nm, weight, base: Some(base), film: None };
    vec![
        Specular::Film(film(DIELECTRIC)),
        Specular::Film(film(BaseKind::Conductor)),
        Specular::FilmOnChannels {
            film: film(BaseKind::Conductor),
            base_ior: [0.2, 0.4, 1.4],
            base_kappa: [3.6, 2.5, 1.9],
        },
        Specular::FilmOnMetalness(film(DIELECTRIC)),
        Specular::FilmOnF0(film(DIELECTRIC)),
        Specular::FilmOnF0(film(BaseKind::Conductor)),
        Specular::Bare(DIELECTRIC),
        Specular::Bare(BaseKind::Conductor),
        Specular::BareSpectral(vec![
            dispersive(600.0, [0.8, 0.3, 0.0], (0.2, 3.6)),
            dispersive(470.0, [0.2, 0.7, 1.0], (1.4, 1.9)),
        ]),
        Specular::BareMetalness { exact: false },
        Specular::BareMetalness { exact: true },
        Specular::BareF0 { base: DIELECTRIC, exact: false },
        Specular::BareF0 { base: DIELECTRIC, exact: true },
        Specular::BareF0 { base: BaseKind::Conductor, exact: true },
        Specular::Baked(BakedFilm {
            coefficients: vec![[0.4, 0.3, 0.5], [-0.2, 0.1, 0.0], [0.1, 0.1, -0.2]],
            denominator: vec![],
        }),
        Specular::Baked(BakedFilm {
            coefficients: vec![[0.4, 0.3, 0.5], [-0.2, 0.1, 0.0], [0.1, 0.1, -0.2]],
            denominator: vec![[0.3, -0.2, 0.1], [0.1, 0.4, -0.3]],
        }),
    ]
}

/// The reflectance that a surface of this kind has, from the functions for its parts.
fn expected_reflectance(specular: &Specular, point: &Point) -> DVec3 {
    let Layers { thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, f0, edge_tint } = point.layers;
    let cos_theta1 = point.geometry.cos_theta1;
    let Finish { base_color, metalness, .. } = point.finish;
    let colour = 0.04 + (base_color - 0.04) * metalness;
    let with_film = |film: &Film, base_ior, base_kappa| {
        film_reflectance::<f64, f64>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa)
    };
    let by_channel = |base_ior: [f64; 3], base_kappa: [f64; 3], film: &Film| {
        DVec3::from_array(core::array::from_fn(|channel| {
            with_film(film, base_ior[channel], base_kappa[channel])[channel]
        }))
    };
    match specular {
        Specular::Film(film) => with_film(film, base_ior, base_kappa),
        Specular::FilmOnChannels { film, base_ior, base_kappa } => by_channel(*base_ior, *base_kappa, film),
        Specular::FilmOnMetalness(film) => {
            by_channel(colour.to_array().map(|channel| ior_from_reflectance(channel, ambient_ior)), [0.0; 3], film)
        }
        Specular::FilmOnF0(film) => {
            let index: [_; 3] = core::array::from_fn(|channel| index_of(film.base, f0[channel], edge_tint[channel]));
            by_channel(index.map(|[ior, _]| ior), index.map(|[_, kappa]| kappa), film)
        }
        Specular::BareF0 { exact: false, .. } => fresnel_schlick::<f64>(cos_theta1, f0),
        Specular::BareF0 { base, exact: true } => DVec3::from_array(core::array::from_fn(|channel| {
            let [ior, kappa] = index_of(*base, f0[channel], edge_tint[channel]);
            fresnel_conductor(cos_theta1, ambient_ior, ior, kappa)
        })),
        Specular::Bare(BaseKind::Conductor) => {
            DVec3::splat(fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa))
        }
        Specular::Bare(_) => DVec3::splat(fresnel_dielectric(cos_theta1, ambient_ior, base_ior)),
        Specular::BareSpectral(nodes) => nodes
            .iter()
            .map(|node| {
                let (base_ior, base_kappa) = node.base.expect("each has one");
                DVec3::from(node.weight) * fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa)
            })
            .sum(),
        Specular::BareMetalness { exact: false } => fresnel_schlick::<f64>(cos_theta1, colour),
        Specular::BareMetalness { exact: true } => {
            let of = |reflectance| {
                fresnel_dielectric(cos_theta1, ambient_ior, ior_from_reflectance(reflectance, ambient_ior))
            };
            DVec3::from_array(colour.to_array().map(of))
        }
        Specular::Fitted(film) => fitted_reflectance::<f64>(film, cos_theta1, thickness_nm),
        Specular::Table(table) => table_reflectance::<f64>(table, cos_theta1, thickness_nm),
        Specular::Baked(baked) => {
            let t = 2.0 * cos_theta1 - 1.0;
            let sum = |coefficients: &[[f64; 3]], first: i32| -> DVec3 {
                let powers = (first..).zip(coefficients);
                powers.map(|(power, coefficients)| DVec3::from(*coefficients) * t.powi(power)).sum()
            };
            sum(&baked.coefficients, 0) / (1.0 + sum(&baked.denominator, 1))
        }
    }
}

/// The index of a base of this kind by its reflectance under air, and by its edge tint where it is a conductor.
fn index_of(base: BaseKind, f0: f64, edge_tint: f64) -> [f64; 2] {
    match base {
        BaseKind::Conductor => {
            let index = index_from_f0(f0, edge_tint);
            [index.ior, index.kappa]
        }
        BaseKind::Dielectric { .. } => [ior_from_reflectance(f0, 1.0), 0.0],
    }
}

/// Equal but for rounding.
fn check(found: DVec3, expected: DVec3, context: impl std::fmt::Debug) {
    let error = (found - expected).abs().max_element();
    assert!(error <= 1e-12 * expected.abs().max_element().max(1.0), "{context:?}: {found}, not {expected}");
}

#[test]
fn each_kind_of_surface_mirrors_as_its_parts_say() {
    for specular in speculars() {
        let surface = Surface { specular, diffuse: true, visibility_k: VisibilityK::Punctual };
        let mut random = Random::new(60);
        for _ in 0..500 {
            let point = draw(&mut random);
            let Finish { base_color, metalness, .. } = point.finish;
            let cos_theta1 = point.geometry.cos_theta1;
            let found = surface_reflectance::<f64>(&surface, cos_theta1, point.layers, base_color, metalness);
            check(found, expected_reflectance(&surface.specular, &point), (&surface.specular, point));
            assert!(
                found.min_element() >= 0.0 && found.max_element() <= 1.0 + 1e-12,
                "{surface:?}, {point:?}: {found}"
            );
        }
    }
}

/// The BRDF from its formula: `diffuse (1 - F) / pi + F D G / (4 (n.l) (n.v))`.
fn expected_brdf(surface: &Surface, point: &Point) -> DVec3 {
    let Finish { roughness, base_color, metalness, visibility_k } = point.finish;
    let Geometry { n_dot_l, n_dot_v, n_dot_h, .. } = point.geometry;
    let k = match surface.visibility_k {
        VisibilityK::Punctual => (roughness + 1.0).powi(2) / 8.0,
        VisibilityK::ImageBased => roughness * roughness / 2.0,
        VisibilityK::Given => visibility_k,
    };
    let square = roughness.powi(4);
    let distribution = square / (PI * (n_dot_h * n_dot_h * (square - 1.0) + 1.0).powi(2));
    // G1 over its cosine, for light and view.
    let visibility = 1.0 / ((n_dot_l * (1.0 - k) + k) * (n_dot_v * (1.0 - k) + k));
    let mirrored = expected_reflectance(&surface.specular, point);
    let specular = mirrored * (distribution * visibility / 4.0);
    let by_metalness = matches!(surface.specular, Specular::FilmOnMetalness(_) | Specular::BareMetalness { .. });
    let diffuse = if by_metalness { base_color * (1.0 - metalness) } else { base_color };
    if surface.diffuse { diffuse / PI * (1.0 - mirrored) + specular } else { specular }
}

#[test]
fn the_brdf_is_what_microfacets_mirror_and_the_diffuse_part_of_the_rest() {
    for specular in speculars() {
        for diffuse in [true, false] {
            for visibility_k in KS {
                let surface = Surface { specular: specular.clone(), diffuse, visibility_k };
                let mut random = Random::new(61);
                for _ in 0..100 {
                    let mut point = draw(&mut random);
                    // The printed form of GGX cancels on smooth surfaces.
                    point.finish.roughness = point.finish.roughness.max(0.3);
                    let found = surface_brdf::<f64>(&surface, point.geometry, point.layers, point.finish);
                    check(found, expected_brdf(&surface, &point), (&surface, point));
                }
            }
        }
    }
}

#[test]
fn a_surface_that_mirrors_nothing_is_lambertian_and_a_perfect_mirror_has_no_diffuse_part() {
    let film = film(DIELECTRIC, false, at_wavelength(550.0));
    let surface = Surface { specular: Specular::Film(film), diffuse: true, visibility_k: VisibilityK::Punctual };
    let mut random = Random::new(62);
    for _ in 0..200 {
        let mut point = draw(&mut random);
        // No boundary anywhere.
        point.layers = Layers { film_ior: 1.0, base_ior: 1.0, ..point.layers };
        let found = surface_brdf::<f64>(&surface, point.geometry, point.layers, point.finish);
        check(found, point.finish.base_color / PI, point);
        // At grazing incidence all is mirrored, and the base colour does not count.
        point.geometry.cos_theta1 = 0.0;
        point.layers.base_ior = 1.5;
        let coloured = surface_brdf::<f64>(&surface, point.geometry, point.layers, point.finish);
        let finish = Finish { base_color: DVec3::ZERO, ..point.finish };
        check(coloured, surface_brdf::<f64>(&surface, point.geometry, point.layers, finish), point);
    }
}

#[test]
fn a_punctual_light_leaves_pi_times_brdf_times_light_times_cosine() {
    let (brdf, color) = (DVec3::new(0.1, 0.2, 0.7), DVec3::new(1.0, 0.5, 0.25));
    let found = punctual_light::<f64>(brdf, 0.6, color, 3.0);
    check(found, DVec3::new(0.1, 0.1, 0.175) * (PI * 3.0 * 0.6), "by hand");
    // A white Lambertian surface under a light of intensity 1 from above is white.
    check(punctual_light::<f64>(lambert::<f64>(DVec3::ONE), 1.0, DVec3::ONE, 1.0), DVec3::ONE, "white");
    assert_eq!(punctual_light::<f64>(brdf, 0.0, color, 3.0), DVec3::ZERO);
}

#[test]
fn the_radiance_is_the_brdf_under_the_light() {
    for specular in speculars() {
        let surface = Surface { specular, diffuse: true, visibility_k: VisibilityK::Punctual };
        let mut random = Random::new(63);
        for _ in 0..100 {
            let point = draw(&mut random);
            let Point { geometry, layers, finish, light } = point;
            let brdf = surface_brdf::<f64>(&surface, geometry, layers, finish);
            let expected = brdf * light.light_color * (PI * light.light_intensity * geometry.n_dot_l);
            check(surface_radiance::<f64>(&surface, geometry, layers, finish, light), expected, point);
        }
    }
}

#[test]
fn lambert_reflects_the_same_in_all_directions() {
    let colour = DVec3::new(0.2, 0.5, 1.0);
    check(lambert::<f64>(colour), colour / PI, "by hand");
    // Over the hemisphere, each direction times its cosine: the albedo. Midpoint rule over the squared cosine.
    let steps = 100;
    let albedo: DVec3 = (0..steps).map(|_| lambert::<f64>(colour) * PI / f64::from(steps)).sum();
    check(albedo, colour, "albedo");
}

#[test]
fn metalness_moves_the_base_colour_from_diffuse_to_specular() {
    let colour = DVec3::new(0.9, 0.6, 0.2);
    for (metalness, diffuse, specular) in [
        (0.0, colour, DVec3::splat(0.04)),
        (1.0, DVec3::ZERO, colour),
        (0.25, colour * 0.75, DVec3::splat(0.03) + colour * 0.25),
    ] {
        let found = metalness_colors::<f64>(colour, metalness);
        check(found.diffuse_color, diffuse, metalness);
        check(found.specular_color, specular, metalness);
    }
}

/// A direction from its polar angle and its azimuth.
fn direction(theta: f64, phi: f64) -> DVec3 {
    DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
}

#[test]
fn directions_give_the_cosines_between_them() {
    let surface = Surface { specular: speculars().remove(0), diffuse: true, visibility_k: VisibilityK::Punctual };
    let mut random = Random::new(64);
    for _ in 0..500 {
        let mut upper = || direction(1.5 * random.unit(), TAU * random.unit());
        let directions = Directions::<f64> { normal: DVec3::Z, light_direction: upper(), view_direction: upper() };
        let Point { layers, finish, light, .. } = draw(&mut random);
        let half = (directions.light_direction + directions.view_direction).normalize();
        let geometry = Geometry {
            n_dot_l: directions.light_direction.z,
            n_dot_v: directions.view_direction.z,
            n_dot_h: half.z.min(1.0),
            cos_theta1: half.dot(directions.light_direction).min(1.0),
        };
        let found = shade_surface::<f64>(&surface, directions, layers, finish, light);
        check(found, surface_radiance::<f64>(&surface, geometry, layers, finish, light), directions);
    }
}

#[test]
fn light_or_view_below_the_horizon_leave_no_radiance() {
    let mut random = Random::new(65);
    for specular in speculars() {
        let surface = Surface { specular, diffuse: true, visibility_k: VisibilityK::Punctual };
        for _ in 0..100 {
            let Point { layers, finish, light, .. } = draw(&mut random);
            let above = direction(1.5 * random.unit(), TAU * random.unit());
            let below = -direction(1.5 * random.unit(), TAU * random.unit());
            let pairs = [(below, above), (above, below), (below, below * 0.999), (above, -above), (-above, above)];
            for (light_direction, view_direction) in pairs {
                let directions = Directions::<f64> { normal: DVec3::Z, light_direction, view_direction };
                let found = shade_surface::<f64>(&surface, directions, layers, finish, light);
                assert_eq!(found, DVec3::ZERO, "{surface:?}, {directions:?}");
            }
        }
    }
}
