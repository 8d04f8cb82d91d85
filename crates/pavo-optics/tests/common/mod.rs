//! What the tests of the BRDF share: seeded random numbers, a film, and its reflectance in complex numbers.

// Each test file is a crate of its own and uses a part of this.
#![allow(dead_code)]

use num_complex::Complex64;
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, GaussianFit, GaussianTerm, Method, Pole, Precision, SpectralNode, Window};
use std::f64::consts::TAU;

/// SplitMix64: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
pub struct Random(u64);

impl Random {
    /// A sequence of its own for each seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number within [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number within [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A film between two media, a wavelength and an angle.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Cosine of the angle of incidence in the ambient medium.
    pub cos_theta1: f64,
    /// Thickness, nm.
    pub thickness_nm: f64,
    /// Wavelength in vacuum, nm.
    pub wavelength_nm: f64,
    /// Index of the ambient medium.
    pub ambient_ior: f64,
    /// Index of the film.
    pub film_ior: f64,
    /// Index of the base.
    pub base_ior: f64,
    /// Extinction coefficient of the base.
    pub base_kappa: f64,
}

impl Case {
    /// Square of the normal wave vector component in the film.
    pub fn film_normal_squared(&self) -> f64 {
        let Case { cos_theta1, ambient_ior, film_ior, .. } = *self;
        film_ior * film_ior - ambient_ior * ambient_ior * (1.0 - cos_theta1 * cos_theta1)
    }

    /// Normal wave vector components in the three media, over the permittivity for p polarisation.
    fn normals(&self, p: bool) -> [Complex64; 3] {
        let tangential_squared = self.ambient_ior.powi(2) * (1.0 - self.cos_theta1 * self.cos_theta1);
        let film = Complex64::from(self.film_ior);
        let base = Complex64::new(self.base_ior, self.base_kappa);
        let ambient = Complex64::from(self.ambient_ior);
        let below = |ior: Complex64| (ior, (ior * ior - tangential_squared).sqrt());
        [(ambient, ambient * self.cos_theta1), below(film), below(base)]
            .map(|(ior, normal)| if p { normal / (ior * ior) } else { normal })
    }

    /// Reflectance for s and p polarisation, from the amplitudes r12 and r23 and the phase of a round trip:
    /// `|(r12 + r23 z) / (1 + r12 r23 z)|^2`.
    ///
    /// Source: Yeh 2005, equation 4.1-19; Born and Wolf, section 1.6.4.
    pub fn reflectance_by_polarisation(&self) -> [f64; 2] {
        let film_normal = self.normals(false)[1];
        let cycles = 2.0 * self.thickness_nm / self.wavelength_nm;
        let round_trip = (Complex64::i() * TAU * cycles * film_normal).exp();
        [false, true].map(|p| {
            let [q1, q2, q3] = self.normals(p);
            let (r12, r23) = ((q1 - q2) / (q1 + q2), (q2 - q3) / (q2 + q3));
            ((r12 + r23 * round_trip) / (1.0 + r12 * r23 * round_trip)).norm_sqr()
        })
    }

    /// Reflectance in unpolarised light.
    pub fn reflectance(&self) -> f64 {
        let [s, p] = self.reflectance_by_polarisation();
        0.5 * (s + p)
    }

    /// Reflectance of the base without the film, for s and p polarisation.
    pub fn bare_reflectance_by_polarisation(&self) -> [f64; 2] {
        [false, true].map(|p| {
            let [q1, _, q3] = self.normals(p);
            ((q1 - q3) / (q1 + q3)).norm_sqr()
        })
    }

    /// Optical path difference of one round trip, nm. Not for total reflection into the film.
    pub fn opd_nm(&self) -> f64 {
        2.0 * self.thickness_nm * self.normals(false)[1].re
    }

    /// The series over orders from the complex amplitudes, with the sensitivity of a channel at each multiple of the
    /// optical path difference: the mean over both polarisations of `1 - Q - 2 Q Re sum_(m = 1 .. order) b^m S(m D)`.
    ///
    /// Source: Belcour and Barla 2017, equation 9.
    pub fn sum_over_orders(&self, order: u32, sensitivity: impl Fn(u32) -> Complex64) -> f64 {
        let of = |p: bool| {
            let [q1, q2, q3] = self.normals(p);
            let (r12, r23) = ((q1 - q2) / (q1 + q2), (q2 - q3) / (q2 + q3));
            let (share12, share23) = (r12.norm_sqr(), r23.norm_sqr());
            let average = (1.0 - share12) * (1.0 - share23) / (1.0 - share12 * share23);
            let sum: Complex64 = (1..=order).map(|m| (-r12 * r23).powu(m) * sensitivity(m)).sum();
            1.0 - average - 2.0 * average * sum.re
        };
        0.5 * (of(false) + of(true))
    }

    /// Amplitude of one round trip in the film times what it meets outside, `|r12 r23|`, the larger of both
    /// polarisations.
    pub fn round_trip_amplitude(&self) -> f64 {
        let amplitude = |p: bool| {
            let [q1, q2, q3] = self.normals(p);
            ((q1 - q2) / (q1 + q2) * (q2 - q3) / (q2 + q3)).norm()
        };
        amplitude(false).max(amplitude(true))
    }
}

/// The exact reflectance at one wavelength, the same for each channel.
pub fn at_wavelength(wavelength_nm: f64) -> Method {
    Method::Spectral { nodes: vec![SpectralNode { wavelength_nm, weight: [1.0; 3], base: None, film: None }] }
}

/// The series at one wavelength: a Gaussian without width.
pub fn series_at_wavelength(wavelength_nm: f64, order: usize) -> Method {
    let term = GaussianTerm { angular_wave_number: [TAU / wavelength_nm; 3], decay: [0.0; 3], weight: [1.0; 3] };
    Method::Series { order, fit: GaussianFit { terms: vec![term] } }
}

/// A film computed by a method.
pub fn film(base: BaseKind, total_reflection: bool, method: Method) -> Film {
    Film { base, total_reflection, method, channel_wavelengths_nm: [611.0, 549.0, 464.0], precision: Precision::FULL }
}

/// A base that does not reflect totally.
pub const DIELECTRIC: BaseKind = BaseKind::Dielectric { total_reflection: false };

/// The film's colour in a case, of which the wavelength takes no part.
pub fn colour(film: &Film, case: &Case) -> [f64; 3] {
    let Case { cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, .. } = *case;
    film_reflectance::<f64, f64>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa).to_array()
}

/// Two overlapping Gaussians in different shares, and one that is at another place in each channel.
pub fn wide_fit() -> GaussianFit {
    let term = |wavelengths_nm: [f64; 3], deviations: [f64; 3], weight: [f64; 3]| GaussianTerm {
        angular_wave_number: wavelengths_nm.map(|wavelength_nm| TAU / wavelength_nm),
        decay: deviations.map(|deviation| 0.5 * deviation * deviation),
        weight,
    };
    GaussianFit {
        terms: vec![
            term([600.0; 3], [6e-4; 3], [1.0, 0.1, 0.0]),
            term([480.0; 3], [9e-4; 3], [-0.1, 0.5, 1.0]),
            term([620.0, 545.0, 450.0], [5e-4, 7e-4, 8e-4], [0.1, 0.4, 0.0]),
        ],
    }
}

/// A case without total reflection on a base of this kind.
pub fn draw(random: &mut Random, base: BaseKind) -> Case {
    let ambient_ior = random.within(1.0, 1.4);
    let (base_ior, base_kappa) = match base {
        BaseKind::Conductor => (random.within(0.1, 4.0), random.within(0.0, 6.0)),
        BaseKind::Dielectric { .. } => (random.within(ambient_ior, 3.0), 0.0),
    };
    Case {
        cos_theta1: random.within(0.1, 1.0),
        thickness_nm: random.within(0.0, 1200.0),
        wavelength_nm: random.within(380.0, 780.0),
        ambient_ior,
        film_ior: random.within(ambient_ior, 2.7),
        base_ior,
        base_kappa,
    }
}

/// Cases in which a round trip in the film leaves less than this of the amplitude.
pub fn moderate_cases(seed: u64, base: BaseKind, amplitude: f64, count: usize) -> Vec<Case> {
    let mut random = Random::new(seed);
    let draws = std::iter::repeat_with(move || draw(&mut random, base));
    draws.filter(|case| case.round_trip_amplitude() < amplitude).take(count).collect()
}

/// Three poles with complex shares.
pub fn poles() -> Vec<Pole> {
    let pole = |wavelength_nm: f64, decay, weight_re, weight_im| Pole {
        angular_wave_number: TAU / wavelength_nm,
        decay,
        weight_re,
        weight_im,
    };
    vec![
        pole(640.0, 8e-4, [0.9, 0.1, -0.1], [0.2, -0.1, 0.0]),
        pole(540.0, 5e-4, [0.3, 0.8, 0.2], [-0.3, 0.1, 0.05]),
        pole(450.0, 9e-4, [-0.2, 0.1, 0.9], [0.1, 0.0, -0.05]),
    ]
}

/// Five wave numbers under a window of this width.
pub fn window(width_nm: f64) -> Window {
    let weights = vec![[0.6, 0.0, 0.0], [0.5, 0.3, 0.0], [-0.1, 0.6, 0.1], [0.0, 0.2, 0.5], [0.0, -0.1, 0.4]];
    Window { first: TAU / 680.0, step: 1.2e-3, width_nm, weights }
}

/// Each method that sums over the orders of interference, by approximate sensitivities.
pub fn order_sums() -> Vec<Method> {
    let mut methods: Vec<Method> = (1..=3).map(|order| Method::Series { order, fit: wide_fit() }).collect();
    methods.extend((1..=2).map(|order| Method::Cosines { order, window: window(2500.0) }));
    methods.extend([Method::Poles { poles: poles() }, Method::Windowed { window: window(2500.0) }]);
    methods
}
