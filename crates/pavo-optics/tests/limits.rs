//! A film that is not there: without thickness, or of the index of a neighbour, it reflects as the bare surface does.

mod common;

use common::{Random, at_wavelength, film, order_sums, series_at_wavelength};
use pavo_optics::film::film_reflectance;
use pavo_optics::fresnel::{fresnel_conductor, fresnel_dielectric};
use pavo_optics::{BaseKind, Film, Method, SpectralNode};
use pavo_shade::{Scalar, Vector};

/// Angle, thickness and indices: `cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa`.
type Point = [f64; 6];

/// Bases, and code with and without total reflection.
const KINDS: [(BaseKind, bool); 5] = [
    (BaseKind::Dielectric { total_reflection: false }, false),
    (BaseKind::Dielectric { total_reflection: true }, false),
    (BaseKind::Dielectric { total_reflection: true }, true),
    (BaseKind::Conductor, false),
    (BaseKind::Conductor, true),
];

/// The cosines at which each limit is checked.
const COSINES: [f64; 9] = [1.0, 0.97, 0.8, 0.5, 0.25, 0.1, 0.03, 0.01, 1e-3];

/// Points for this code: no total reflection where the code does not provide for it.
fn points(seed: u64, (base, film_total_reflection): (BaseKind, bool)) -> Vec<Point> {
    let mut random = Random::new(seed);
    let mut points = Vec::new();
    for cos_theta1 in COSINES {
        for _ in 0..50 {
            let ambient = random.within(1.0, 1.6);
            let film = random.within(if film_total_reflection { 1.0 } else { ambient }, 2.6);
            let (base_ior, base_kappa) = match base {
                BaseKind::Conductor => (random.within(0.1, 4.0), random.within(0.0, 6.0)),
                BaseKind::Dielectric { total_reflection } => {
                    (random.within(if total_reflection { 1.0 } else { ambient }, 3.0), 0.0)
                }
            };
            points.push([cos_theta1, random.within(0.0, 1500.0), ambient, film, base_ior, base_kappa]);
        }
    }
    points
}

/// The largest distance between the film's reflectance and that of the bare base, over points of each kind.
fn largest_error<S: Scalar + Into<f64>>(seed: u64, method: &Method, limit: impl Fn(Point) -> Option<Point>) -> f64 {
    let mut largest = 0.0_f64;
    let mut checked = 0;
    for kind in KINDS {
        for point in points(seed, kind).into_iter().filter_map(&limit) {
            let (base, total_reflection) = kind;
            // On a complex base the kernel under a window holds the wave in front of the film at 2e-3 of that in it.
            if matches!(method, Method::Windowed { .. }) && !base.is_real() && point[0] < 2e-3 * point[3] {
                continue;
            }
            // The cosine and the indices as the type has them, on both sides.
            let [cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa] = point.map(S::lit);
            let film = film(base, total_reflection, method.clone());
            let with_film =
                film_reflectance::<S, S>(&film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa);
            let bare: f64 = match base {
                BaseKind::Conductor => fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa),
                BaseKind::Dielectric { .. } => fresnel_dielectric(cos_theta1, ambient_ior, base_ior),
            }
            .into();
            for channel in [with_film.x(), with_film.y(), with_film.z()] {
                largest = largest.max((channel.into() - bare).abs());
            }
            checked += 1;
        }
    }
    assert!(checked >= (COSINES.len() - 1) * 50, "{checked} points");
    largest
}

/// Both number types come this near to the bare surface.
fn check(seed: u64, method: &Method, limit: impl Fn(Point) -> Option<Point> + Copy) {
    let [in_f64, in_f32] = [largest_error::<f64>(seed, method, limit), largest_error::<f32>(seed, method, limit)];
    println!("{in_f64:e} in f64, {in_f32:e} in f32");
    let (allowed_in_f64, allowed_in_f32) = match method {
        // A base that reflects totally is taken to let in 1e-12 of what a clear one does; and where the window closes the
        // kernel adds and subtracts ten times the transmittance.
        Method::Windowed { .. } => (1e-11, 5e-6),
        _ => (1e-14, 1e-6),
    };
    assert!(in_f64 <= allowed_in_f64, "{in_f64:e} in f64");
    assert!(in_f32 <= allowed_in_f32, "{in_f32:e} in f32");
}

/// Weights that add up to 1 for each channel, and each channel its own.
fn colouring_spectral() -> Method {
    let node = |wavelength_nm, weight| SpectralNode { wavelength_nm, weight, base: None, film: None };
    Method::Spectral { nodes: vec![node(620.0, [0.75, 0.25, 0.0]), node(460.0, [0.25, 0.75, 1.0])] }
}

/// No thickness.
fn without_thickness([cos_theta1, _, ambient, film, base, kappa]: Point) -> Option<Point> {
    Some([cos_theta1, 0.0, ambient, film, base, kappa])
}

/// The film is of the ambient medium.
fn film_like_ambient([cos_theta1, thickness, ambient, _, base, kappa]: Point) -> Option<Point> {
    Some([cos_theta1, thickness, ambient, ambient, base, kappa])
}

/// The film is of the base's medium. Absorbing bases are out: a film has no extinction.
fn film_like_base([cos_theta1, thickness, ambient, _, base, kappa]: Point) -> Option<Point> {
    (kappa == 0.0 && base >= ambient).then_some([cos_theta1, thickness, ambient, base, base, 0.0])
}

#[test]
fn a_film_without_thickness_is_none_at_one_wavelength() {
    check(20, &at_wavelength(550.0), without_thickness);
}

#[test]
fn a_film_of_the_ambient_index_is_none_at_one_wavelength() {
    check(21, &at_wavelength(550.0), film_like_ambient);
}

#[test]
fn a_film_of_the_index_of_the_base_is_none_at_one_wavelength() {
    check(22, &at_wavelength(550.0), film_like_base);
}

#[test]
fn a_film_without_thickness_is_none_over_the_spectrum() {
    check(23, &colouring_spectral(), without_thickness);
}

#[test]
fn a_film_of_the_ambient_index_is_none_over_the_spectrum() {
    check(24, &colouring_spectral(), film_like_ambient);
}

#[test]
fn a_film_of_the_index_of_the_base_is_none_over_the_spectrum() {
    check(25, &colouring_spectral(), film_like_base);
}

#[test]
fn a_film_of_the_ambient_index_is_none_in_each_sum_over_orders() {
    for method in order_sums() {
        check(26, &method, film_like_ambient);
    }
}

#[test]
fn a_film_of_the_index_of_the_base_is_none_in_each_sum_over_orders() {
    for method in order_sums() {
        check(27, &method, film_like_base);
    }
}

#[test]
fn a_film_without_thickness_is_none_in_the_series_of_many_orders() {
    // Each order takes a part off the rest: b^200 is below 1e-12 for |b| < 0.87.
    let moderate = |point: Point| {
        let [cos_theta1, _, ambient, film, _, _] = point;
        (cos_theta1 >= 0.25 && film <= ambient + 0.6).then(|| without_thickness(point)).flatten()
    };
    check(28, &series_at_wavelength(550.0, 200), moderate);
}

#[test]
fn no_method_colours_a_film_without_thickness() {
    for method in order_sums().into_iter().chain([colouring_spectral()]) {
        for kind in KINDS {
            for point in points(29, kind).into_iter().filter_map(without_thickness) {
                let [cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa] = point;
                let (base, total_reflection) = kind;
                let film: Film = film(base, total_reflection, method.clone());
                let colour = film_reflectance::<f64, f64>(
                    &film,
                    cos_theta1,
                    thickness_nm,
                    ambient_ior,
                    film_ior,
                    base_ior,
                    base_kappa,
                );
                let spread = colour.max_element() - colour.min_element();
                assert!(spread <= 1e-13, "{method:?}, {point:?}: {colour}");
            }
        }
    }
}

#[test]
fn a_mirror_without_a_film_is_white() {
    // A base that reflects nearly all, under a film that is not there.
    for method in order_sums().into_iter().chain([colouring_spectral()]) {
        let film = film(BaseKind::Conductor, false, method);
        let colour = film_reflectance::<f64, f64>(&film, 0.7, 300.0, 1.0, 1.0, 1e-6, 5.0);
        assert!((colour - 1.0).abs().max_element() <= 1e-5, "{colour}");
    }
}
