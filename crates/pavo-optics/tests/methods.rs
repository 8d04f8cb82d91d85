//! The other ways to sum over the orders of interference: poles, kernels under a window, and cosines, each against the
//! sum over orders in complex numbers with the sensitivity that it stands for.

mod common;

use common::{Case, DIELECTRIC, colour, film, moderate_cases, poles, window};
use num_complex::Complex64;
use pavo_optics::{BaseKind, Method, Pole, Window, WindowGroup};
use std::f64::consts::TAU;

const KINDS: [(u64, BaseKind); 2] = [(70, DIELECTRIC), (71, BaseKind::Conductor)];

/// Enough orders for what is left of a round trip in these tests: 0.7^120 is 2e-19.
const ALL_ORDERS: u32 = 120;

/// The colour by the method is the sum over this many orders with this sensitivity, a function of the order, the
/// optical path difference and the channel.
fn check(method: &Method, orders: u32, sensitivity: impl Fn(u32, f64, usize) -> Complex64) {
    for (seed, base) in KINDS {
        let film = film(base, false, method.clone());
        let mut largest = 0.0_f64;
        for case in moderate_cases(seed, base, 0.7, 300) {
            for (channel, found) in colour(&film, &case).into_iter().enumerate() {
                let expected = case.sum_over_orders(orders, |m| sensitivity(m, case.opd_nm(), channel));
                let error = (found - expected).abs();
                assert!(error <= 1e-13, "{case:?}, channel {channel}: {found} instead of {expected}");
                largest = largest.max(error);
            }
        }
        println!("{base:?}: largest error {largest:e}, allowed 1e-13");
    }
}

#[test]
fn poles_sum_all_orders() {
    let poles = poles();
    check(&Method::Poles { poles: poles.clone() }, ALL_ORDERS, |m, opd_nm, channel| {
        let path = f64::from(m) * opd_nm;
        let of = |pole: &Pole| {
            let weight = Complex64::new(pole.weight_re[channel], pole.weight_im[channel]);
            weight * Complex64::new(-pole.decay * path, pole.angular_wave_number * path).exp()
        };
        poles.iter().map(of).sum()
    });
}

/// The waves of a window without the window, at a multiple of the optical path difference.
fn waves(window: &Window, path_nm: f64, channel: usize) -> Complex64 {
    let of = |(index, weight): (usize, &[f64; 3])| {
        weight[channel] * Complex64::from_polar(1.0, (window.first + index as f64 * window.step) * path_nm)
    };
    window.weights.iter().enumerate().map(of).sum()
}

#[test]
fn cosines_sum_a_few_orders_under_the_window() {
    let window = window(2500.0);
    for order in 1..=4 {
        check(&Method::Cosines { order, window: window.clone() }, order as u32, |m, opd_nm, channel| {
            let path = f64::from(m) * opd_nm;
            (-(path / window.width_nm).powi(2)).exp() * waves(&window, path, channel)
        });
    }
}

#[test]
fn kernels_sum_all_orders_and_damp_the_first_two_by_the_window() {
    for width_nm in [1e9, 4000.0, 900.0] {
        let window = window(width_nm);
        check(&Method::Windowed { window: window.clone() }, ALL_ORDERS, |m, opd_nm, channel| {
            let g = (-(opd_nm / width_nm).powi(2)).exp();
            let path = f64::from(m) * opd_nm;
            // Held at 0.15, from where on little of any order is left.
            let h = (g * g).max(0.15);
            let damping = (g * h).powi(m as i32) / h;
            if g * g > 0.15 && m <= 2 {
                let exact = (-(path / width_nm).powi(2)).exp();
                assert!((damping - exact).abs() <= 1e-14, "order {m}: {damping} for {exact}");
            }
            damping * waves(&window, path, channel)
        });
    }
}

#[test]
fn groups_of_wave_numbers_have_indices_of_their_own() {
    // Each channel draws on one group alone.
    let weights = vec![[0.4, 0.0, 0.0], [0.6, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.7], [0.0, 0.0, 0.3]];
    let window = Window { weights, ..window(2500.0) };
    let bases = [(0.3, 3.4), (0.6, 2.5), (1.4, 1.8)];
    let films = [1.5, 1.55, 1.62];
    for own_film in [false, true] {
        let group = |index: usize, nodes| WindowGroup {
            nodes,
            base: Some(bases[index]),
            film: own_film.then_some(films[index]),
        };
        let groups = vec![group(0, 2), group(1, 1), group(2, 2)];
        let method = Method::WindowedGroups { window: window.clone(), groups };
        for case in moderate_cases(76, BaseKind::Conductor, 0.98, 200) {
            let found = colour(&film(BaseKind::Conductor, false, method.clone()), &case);
            for channel in 0..3 {
                let (base_ior, base_kappa) = bases[channel];
                let film_ior = if own_film { films[channel] } else { case.film_ior };
                let case = Case { base_ior, base_kappa, film_ior, ..case };
                let plain = film(BaseKind::Conductor, false, Method::Windowed { window: window.clone() });
                let expected = colour(&plain, &case)[channel];
                assert!((found[channel] - expected).abs() <= 1e-12, "{case:?}: {} {expected}", found[channel]);
            }
        }
    }
}

#[test]
fn one_undamped_wave_is_the_exact_reflectance_at_its_wavelength() {
    for (seed, base) in [(72, DIELECTRIC), (73, BaseKind::Conductor)] {
        for case in moderate_cases(seed, base, 0.98, 500) {
            let angular_wave_number = TAU / case.wavelength_nm;
            let pole = Pole { angular_wave_number, decay: 0.0, weight_re: [1.0; 3], weight_im: [0.0; 3] };
            let weights = vec![[1.0; 3]];
            let window = Window { first: angular_wave_number, step: 0.0, width_nm: f64::INFINITY, weights };
            for method in [Method::Poles { poles: vec![pole] }, Method::Windowed { window }] {
                let found = colour(&film(base, false, method.clone()), &case);
                let expected = case.reflectance();
                let error = found.map(|found| (found - expected).abs()).into_iter().fold(0.0, f64::max);
                assert!(error <= 1e-11, "{method:?}, {case:?}: {found:?} instead of {expected}");
            }
        }
    }
}

#[test]
fn a_film_without_thickness_is_none_where_all_orders_are_summed() {
    for (seed, base) in [(74, DIELECTRIC), (75, BaseKind::Conductor)] {
        for case in moderate_cases(seed, base, 0.98, 300) {
            let case = Case { thickness_nm: 0.0, ..case };
            let [s, p] = case.bare_reflectance_by_polarisation();
            for method in [Method::Poles { poles: poles() }, Method::Windowed { window: window(2000.0) }] {
                let found = colour(&film(base, false, method.clone()), &case);
                let error = found.map(|found| (found - 0.5 * (s + p)).abs()).into_iter().fold(0.0, f64::max);
                assert!(error <= 1e-12, "{method:?}, {case:?}: {found:?} instead of {}", 0.5 * (s + p));
            }
        }
    }
}
