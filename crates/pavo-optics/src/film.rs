//! The film between two media: its wave vectors, and its reflectance as a colour by one of the methods.

use crate::airy::{AiryTerms, airy_reflectance, airy_terms};
use crate::cosines::cosines_reflectance;
use crate::grouped::{WindowGroup, channel_base, grouped_reflectance};
use crate::poles::{Pole, poles_reflectance};
use crate::precision::Precision;
use crate::relative::relative_film;
use crate::series::{GaussianFit, series_reflectance};
use crate::spectral::{SpectralNode, dispersive_reflectance, spectral_reflectance};
use crate::tabulated::{TransformTable, tabulated_reflectance};
use crate::wave::{
    NormalComponent, normal_component_absorbing, normal_component_squared, normal_component_squared_above_zero,
    p_component_absorbing,
};
use crate::windowed::{Window, windowed_reflectance};
use core::f64::consts::TAU;
use pavo_shade::{Lanes, Real, Scalar, Value, Vector, shade};

/// What the base is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BaseKind {
    /// A real index.
    Dielectric {
        /// Whether the base may reflect totally: its index may be below that of the ambient medium.
        total_reflection: bool,
    },
    /// A complex index.
    Conductor,
}

impl BaseKind {
    /// Whether the wave in the base is real at every angle: a dielectric that does not reflect totally.
    pub fn is_real(self) -> bool {
        self == BaseKind::Dielectric { total_reflection: false }
    }
}

/// How the reflectance over the spectrum becomes a colour.
#[derive(Clone, Debug, PartialEq)]
pub enum Method {
    /// The series of Belcour and Barla, truncated at an order, with sensitivities as sums of Gaussians.
    Series {
        /// The highest order, at least 1.
        order: usize,
        /// The sensitivities.
        fit: GaussianFit,
    },
    /// The same series with the exact transform of the sensitivities, from tables.
    TabulatedSeries {
        /// The highest order, at least 1.
        order: usize,
        /// The transform.
        transform: TransformTable,
    },
    /// All orders of the series in closed form, with sensitivities as sums of complex exponentials.
    Poles {
        /// The poles.
        poles: Vec<Pole>,
    },
    /// All orders of the series as a Poisson kernel, with sensitivities as wave numbers under a window.
    Windowed {
        /// The wave numbers.
        window: Window,
    },
    /// The same with media that depend on the wavelength: each group of wave numbers has its own indices.
    WindowedGroups {
        /// The wave numbers.
        window: Window,
        /// The groups, which share them out in order.
        groups: Vec<WindowGroup>,
    },
    /// The series truncated at an order, with sensitivities as wave numbers under a window.
    Cosines {
        /// The highest order, at least 1.
        order: usize,
        /// The wave numbers.
        window: Window,
    },
    /// The exact reflectance at several wavelengths.
    Spectral {
        /// The wavelengths with their weights.
        nodes: Vec<SpectralNode>,
    },
}

/// What is known of the film when the code is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// The kind of base.
    pub base: BaseKind,
    /// Whether the film may reflect totally: its index may be below that of the ambient medium.
    pub total_reflection: bool,
    /// The method.
    pub method: Method,
    /// A wavelength for each output channel, in nm, at which the exact reflectance stands for the channel where the
    /// series does not hold: under total internal reflection into the film.
    pub channel_wavelengths_nm: [f64; 3],
    /// What is held in half precision.
    pub precision: Precision,
}

/// The wave in the film.
#[derive(Clone, Copy, Debug)]
pub struct FilmWave<R> {
    /// Square of the normal wave vector component, negative under total internal reflection.
    pub q2_squared: R,
    /// The modulus of the normal wave vector component.
    pub q2: R,
    /// 1 over it.
    pub q2_inverse: R,
}

/// The terms of Airy's closed form for both polarisations.
#[derive(Clone, Copy, Debug)]
pub struct FilmTerms<R: Real> {
    /// Terms for s polarisation.
    pub s: AiryTerms<R>,
    /// Terms for p polarisation.
    pub p: AiryTerms<R>,
}

/// Normal wave vector components in the base for both polarisations (for p over the permittivity).
#[derive(Clone, Copy, Debug)]
pub struct BaseWave<R: Real> {
    /// For s polarisation.
    pub s: NormalComponent<R>,
    /// For p polarisation.
    pub p: NormalComponent<R>,
}

/// The wave in the film. Its normal component is kept away from 0, where the phase vanishes with it.
pub fn film_wave<R: Real>(total_reflection: bool, cos_theta1: R, ambient_ior: R, film_ior: R) -> FilmWave<R> {
    let smallest = R::lit(1e-12);
    let square = normal_component_squared(cos_theta1, ambient_ior, film_ior);
    if total_reflection {
        let q2_squared = R::select(square.abs().less_than(smallest), smallest, square).named("q2_squared");
        FilmWave::new(q2_squared, q2_squared.abs())
    } else {
        let q2_squared = square.max(smallest).named("q2_squared");
        FilmWave::new(q2_squared, q2_squared)
    }
}

impl<R: Real> FilmWave<R> {
    fn new(q2_squared: R, modulus: R) -> Self {
        // The root itself is exact to the last bit, as the phase needs it.
        let q2 = modulus.sqrt().named("q2");
        FilmWave { q2_squared, q2, q2_inverse: (R::lit(1.0) / q2).named("q2_inverse") }
    }
}

/// Normal wave vector components in the base.
pub fn base_wave<R: Real>(base: BaseKind, cos_theta1: R, ambient_ior: R, base_ior: R, base_kappa: R) -> BaseWave<R> {
    let zero = R::lit(0.0);
    match base {
        BaseKind::Conductor => {
            let q3 = normal_component_absorbing(cos_theta1, ambient_ior, base_ior, base_kappa).named("q3");
            BaseWave { s: q3, p: p_component_absorbing(q3, base_ior, base_kappa).named("q3_p") }
        }
        BaseKind::Dielectric { total_reflection } => {
            let square = normal_component_squared(cos_theta1, ambient_ior, base_ior).named("q3_squared");
            // Without total reflection the square is a sum of two that are not negative.
            let re = if total_reflection { square.max(zero) } else { square }.sqrt().named("q3");
            let im = if total_reflection { (-square).max(zero).sqrt().named("q3_decay") } else { zero };
            let modulus = if total_reflection { square.abs() } else { square };
            let scale = (R::lit(1.0) / (base_ior * base_ior)).named("base_scale");
            let p = NormalComponent {
                re: (re * scale).named("q3_p"),
                im: (im * scale).named("q3_p_decay"),
                modulus: (modulus * (scale * scale)).named("q3_p_modulus"),
            };
            BaseWave { s: NormalComponent { re, im, modulus }, p }
        }
    }
}

/// Terms of Airy's closed form for s and p polarisation of the film on its base.
pub fn film_terms<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    total_reflection: bool,
    media: Media<S>,
    wave: FilmWave<S>,
    base: BaseWave<R>,
) -> FilmTerms<R> {
    let lanes = R::from_scalar;
    let scale = media.film_p_scale();
    let q2_p = (wave.q2 * scale).named("q2_p");
    let q2_p_squared = (wave.q2_squared * (scale * scale)).named("q2_p_squared");
    let [q1, q1_p] = [media.q1(), media.q1_p()];
    FilmTerms {
        s: airy_terms(total_reflection, lanes(q1), lanes(wave.q2), lanes(wave.q2_squared), base.s).named("s"),
        p: airy_terms(total_reflection, lanes(q1_p), lanes(q2_p), lanes(q2_p_squared), base.p).named("p"),
    }
}

/// The angle and the indices above the base.
#[derive(Clone, Copy, Debug)]
pub struct Media<S> {
    /// Cosine of the angle of incidence in the ambient medium, [0, 1].
    pub cos_theta1: S,
    /// Refractive index of the ambient medium, > 0.
    pub ambient_ior: S,
    /// Refractive index of the film, > 0.
    pub film_ior: S,
}

impl<S: Scalar> Media<S> {
    /// Normal wave vector component in the ambient medium.
    pub fn q1(self) -> S {
        (self.ambient_ior * self.cos_theta1).named("q1")
    }

    /// The same for p polarisation, over the permittivity.
    pub fn q1_p(self) -> S {
        (self.q1() * (S::lit(1.0) / (self.ambient_ior * self.ambient_ior))).named("q1_p")
    }

    /// What makes a component in the film one for p polarisation: 1 over the permittivity.
    pub fn film_p_scale(self) -> S {
        (S::lit(1.0) / (self.film_ior * self.film_ior)).named("film_scale")
    }

    /// The wave in the film.
    pub fn wave(self, total_reflection: bool) -> FilmWave<S> {
        film_wave(total_reflection, self.cos_theta1, self.ambient_ior, self.film_ior)
    }

    /// The wave in the film, for sums over the orders of interference: without total reflection it takes no guard to keep
    /// the normal component away from 0.
    pub fn wave_of_orders(self, total_reflection: bool) -> FilmWave<S> {
        let Self { cos_theta1, ambient_ior, film_ior } = self;
        if total_reflection {
            return self.wave(true);
        }
        let q2_squared = normal_component_squared_above_zero(cos_theta1, ambient_ior, film_ior).named("q2_squared");
        FilmWave::new(q2_squared, q2_squared)
    }

    /// The wave in a base.
    pub fn base_wave<R: Lanes<S>>(self, base: BaseKind, base_ior: R, base_kappa: R) -> BaseWave<R> {
        base_wave(base, R::from_scalar(self.cos_theta1), R::from_scalar(self.ambient_ior), base_ior, base_kappa)
    }
}

/// Reflectance of a thin film in unpolarised light as a linear colour.
///
/// Source: Belcour and Barla 2017, equation 5, with the film's Airy reflectance in place of Fresnel's.
#[shade]
pub fn film_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// What is known of the film.
    #[constant]
    film: &Film,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
    /// Thickness of the film, nm, >= 0.
    thickness_nm: S,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: S,
    /// Refractive index of the film, > 0.
    film_ior: S,
    /// Refractive index of the base, > 0.
    base_ior: R,
    /// Extinction coefficient of the base, >= 0.
    base_kappa: R,
) -> S::Vec3 {
    let media = Media { cos_theta1, ambient_ior, film_ior };
    let wave = match &film.method {
        Method::Spectral { .. } => media.wave(film.total_reflection),
        _ => media.wave_of_orders(film.total_reflection),
    };
    let path_nm = thickness_nm * wave.q2;
    let opd_nm = 2.0 * path_nm;
    if let Method::Spectral { nodes } = &film.method
        && nodes.iter().any(|node| node.base.is_some() || node.film.is_some())
    {
        let base_index = [base_ior, base_kappa];
        return dispersive_reflectance::<S, R>(film, nodes, media, thickness_nm, path_nm, base_index);
    }
    if let Method::WindowedGroups { window, groups } = &film.method {
        let base_index = [base_ior, base_kappa];
        let grouped = grouped_reflectance::<S, R>(film, window, groups, media, thickness_nm, path_nm, base_index);
        if !film.total_reflection {
            return grouped;
        }
        let [base_ior, base_kappa] = channel_base::<S, R>(window, groups, base_index);
        let terms = film_terms(true, media, wave, media.base_wave(film.base, base_ior, base_kappa));
        let is_total_reflection = wave.q2_squared.less_than(S::lit(FRUSTRATED_BELOW));
        let frustrated = frustrated_reflectance::<S, S::Vec3>(film, terms, wave, path_nm);
        return S::Vec3::choose(is_total_reflection, frustrated, grouped);
    }
    let airy = || film_terms(film.total_reflection, media, wave, media.base_wave(film.base, base_ior, base_kappa));
    if let Method::Spectral { nodes } = &film.method {
        return spectral_reflectance::<S, R>(film, nodes, airy(), wave, path_nm);
    }
    let relative = relative_film(film.base, media, wave, base_ior, base_kappa);
    let precision = film.precision;
    let series = match &film.method {
        Method::WindowedGroups { .. } | Method::Spectral { .. } => unreachable!("they have returned above"),
        Method::Series { order, fit } => series_reflectance::<S, R>(precision, *order, fit, relative, opd_nm),
        Method::TabulatedSeries { order, transform } => {
            tabulated_reflectance::<S, R>(*order, transform, relative, opd_nm)
        }
        Method::Poles { poles } => poles_reflectance::<S, R>(precision, poles, relative, opd_nm),
        Method::Windowed { window } => windowed_reflectance::<S, R>(precision, window, film.base, relative, path_nm),
        Method::Cosines { order, window } => cosines_reflectance::<S, R>(precision, window, *order, relative, path_nm),
    };
    if !film.total_reflection {
        return series;
    }
    let terms = airy();
    let is_total_reflection = wave.q2_squared.less_than(S::lit(FRUSTRATED_BELOW));
    S::Vec3::choose(is_total_reflection, frustrated_reflectance::<S, R>(film, terms, wave, path_nm), series)
}

/// The square of the normal wave vector component in the film below which the exact reflectance at one wavelength a
/// channel takes over. Just above 0 the waves outside dwarf that in the film: sums over orders lose their digits, and the
/// phase hardly depends on the wavelength.
const FRUSTRATED_BELOW: f64 = 1e-4;

/// Under total internal reflection into the film the round trips decay instead of interfering: the exact reflectance
/// at one wavelength a channel is smooth enough.
fn frustrated_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    film: &Film,
    terms: FilmTerms<R>,
    wave: FilmWave<S>,
    path_nm: S,
) -> S::Vec3 {
    let channels = |terms: AiryTerms<R>| AiryTerms {
        transmitted: terms.transmitted.into_vec3(),
        offset: terms.offset.into_vec3(),
        contrast: terms.contrast.into_vec3(),
        absorption: terms.absorption.into_vec3(),
    };
    let wave_numbers = S::Vec3::lit3(film.channel_wavelengths_nm.map(|wavelength| TAU / wavelength));
    let phase = wave_numbers * path_nm;
    airy_reflectance(true, channels(terms.s), channels(terms.p), S::Vec3::splat(wave.q2_squared), phase)
}
