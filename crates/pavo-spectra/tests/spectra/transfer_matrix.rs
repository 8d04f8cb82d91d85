//! The Airy formula against a transfer-matrix method, which works with fields and 2x2 matrices, and has no reflection
//! amplitudes of single boundaries.
//!
//! Source: M. Born and E. Wolf, "Principles of Optics", section 1.6.2: the characteristic matrix of a layer,
//! [[cos b, -i sin b / p], [-i p sin b, cos b]], carries the tangential fields across it. p is n cos(theta) for s
//! polarisation and cos(theta) / n for p, b the phase across the layer.

use num_complex::Complex64;
use pavo_spectra::{OpticalConstants, Point, Stack};

use crate::random::Random;

const I: Complex64 = Complex64::I;

struct Case {
    ambient: f64,
    film: Complex64,
    base: Complex64,
    cos_theta1: f64,
    thickness_nm: f64,
    wavelength_nm: f64,
}

fn transfer_matrix_reflectance(case: &Case) -> f64 {
    let index = [Complex64::from(case.ambient), case.film, case.base];
    let sine = index[0] * (1.0 - case.cos_theta1 * case.cos_theta1).sqrt();
    let cosine = index.map(|n| {
        let cosine = (1.0 - (sine / n) * (sine / n)).sqrt();
        // The wave in a medium decays away from where it comes.
        if (n * cosine).im < 0.0 { -cosine } else { cosine }
    });
    let phase = 2.0 * std::f64::consts::PI * case.thickness_nm / case.wavelength_nm * index[1] * cosine[1];
    let reflectance = |p: [Complex64; 3]| {
        let matrix = [[phase.cos(), -I * phase.sin() / p[1]], [-I * p[1] * phase.sin(), phase.cos()]];
        let electric = matrix[0][0] + matrix[0][1] * p[2];
        let magnetic = matrix[1][0] + matrix[1][1] * p[2];
        ((p[0] * electric - magnetic) / (p[0] * electric + magnetic)).norm_sqr()
    };
    let s = reflectance(std::array::from_fn(|i| index[i] * cosine[i]));
    let p = reflectance(std::array::from_fn(|i| cosine[i] / index[i]));
    (s + p) / 2.0
}

#[test]
fn random_stacks_agree() {
    type Indices = fn(&mut Random) -> (f64, Complex64, Complex64);
    let dielectric: Indices = |r| (r.between(1.0, 1.6), r.between(1.0, 2.6).into(), r.between(1.0, 3.5).into());
    let conductor: Indices = |r| {
        let base = Complex64::new(r.between(0.05, 4.0), r.between(0.0, 8.0));
        (r.between(1.0, 1.6), r.between(1.0, 2.6).into(), base)
    };
    let absorbing_film: Indices = |r| {
        let film = Complex64::new(r.between(0.1, 2.6), r.between(0.0, 1.0));
        let base = Complex64::new(r.between(0.05, 4.0), r.between(0.0, 8.0));
        (r.between(1.0, 1.6), film, base)
    };
    let total_reflection: Indices = |r| (r.between(1.7, 2.6), r.between(1.0, 1.5).into(), r.between(1.0, 1.5).into());
    for (seed, (name, indices)) in [
        ("dielectric", dielectric),
        ("conductor", conductor),
        ("absorbing film", absorbing_film),
        ("total reflection", total_reflection),
    ]
    .into_iter()
    .enumerate()
    {
        let mut random = Random::new(seed as u64);
        let (mut largest, mut total): (f64, usize) = (0.0, 0);
        for _ in 0..5000 {
            let (ambient, film, base) = indices(&mut random);
            let case = Case {
                ambient,
                film,
                base,
                cos_theta1: random.between(0.001, 1.0),
                thickness_nm: random.between(0.0, 1500.0),
                wavelength_nm: random.between(360.0, 830.0),
            };
            let medium = |index: Complex64| OpticalConstants::constant(index.re, index.im).unwrap();
            let stack = Stack::new(ambient, medium(film), medium(base)).unwrap();
            let point = Point::new(case.cos_theta1, case.thickness_nm);
            let found = stack.reflectance_at(case.wavelength_nm, point);
            largest = largest.max((found - transfer_matrix_reflectance(&case)).abs());
            total += usize::from(found > 1.0 - 1e-12);
        }
        println!("{name}: largest difference {largest:.1e}, {total} of 5000 reflect all");
        assert!(largest < 1e-10, "{name}: off by {largest:e}");
        assert_eq!(total > 500, name == "total reflection", "{name}: {total} of 5000 reflect all");
    }
}
