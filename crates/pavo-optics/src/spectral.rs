//! The reflectance at several wavelengths, weighted: a plain quadrature over the spectrum.

use crate::airy::airy_reflectance;
use crate::film::{BaseKind, Film, FilmTerms, FilmWave, Media, film_terms};
use crate::precision::Precision;
use core::f64::consts::TAU;
use pavo_shade::{Lanes, Real, Scalar, Value, Vector, shade};

/// A wavelength of the quadrature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralNode {
    /// Wavelength in vacuum, nm.
    pub wavelength_nm: f64,
    /// Weight for each output channel; over all nodes the weights of a channel add up to 1.
    pub weight: [f64; 3],
    /// Refractive index and extinction coefficient of a base that depends on the wavelength.
    pub base: Option<(f64, f64)>,
    /// Refractive index of a film that depends on the wavelength.
    pub film: Option<f64>,
}

impl SpectralNode {
    /// Half the phase of a round trip per nm of the optical path of one pass, radians: 2 pi / wavelength.
    fn wave_number(&self) -> f64 {
        TAU / self.wavelength_nm
    }
}

/// Reflectance of a film whose media do not depend on the wavelength.
pub fn spectral_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    film: &Film,
    nodes: &[SpectralNode],
    terms: FilmTerms<R>,
    wave: FilmWave<S>,
    path_nm: S,
) -> S::Vec3 {
    let q2_squared = R::from_scalar(wave.q2_squared);
    weighted_in(film.precision, nodes, |node| {
        let phase = R::from_scalar(path_nm * S::lit(node.wave_number()));
        airy_reflectance(film.total_reflection, terms.s, terms.p, q2_squared, phase).into_vec3()
    })
}

/// Reflectance of a film where its index, or that of its base, depends on the wavelength.
pub fn dispersive_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    film: &Film,
    nodes: &[SpectralNode],
    media: Media<S>,
    thickness_nm: S,
    path_nm: S,
    base_index: [R; 2],
) -> S::Vec3 {
    let Media { cos_theta1, ambient_ior, film_ior } = media;
    let (total_reflection, base) = (film.total_reflection, film.base);
    weighted_in(film.precision, nodes, |node| {
        let wave_number = S::lit(node.wave_number());
        let [base_ior, base_kappa] = node.base.map_or(base_index, |(ior, kappa)| [R::lit(ior), R::lit(kappa)]);
        let reflectance = match node.film {
            None => {
                let phase = path_nm * wave_number;
                node_reflectance::<S, R>(
                    total_reflection,
                    base,
                    cos_theta1,
                    ambient_ior,
                    film_ior,
                    phase,
                    base_ior,
                    base_kappa,
                )
            }
            Some(film_ior) => film_node_reflectance::<S, R>(
                total_reflection,
                base,
                cos_theta1,
                thickness_nm,
                ambient_ior,
                wave_number,
                S::lit(film_ior),
                base_ior,
                base_kappa,
            ),
        };
        reflectance.into_vec3()
    })
}

/// Reflectance of the film at one wavelength, with the indices that the film and its base have there.
#[shade]
pub fn film_node_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// Whether the film may reflect totally.
    #[constant]
    total_reflection: bool,
    /// The kind of base.
    #[constant]
    base: BaseKind,
    /// Cosine of the angle of incidence in the ambient medium, [0, 1].
    cos_theta1: S,
    /// Thickness of the film, nm, >= 0.
    thickness_nm: S,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: S,
    /// Wave number in vacuum, 2 pi / wavelength, radians per nm.
    #[runtime]
    wave_number: S,
    /// Refractive index of the film at this wavelength, > 0.
    #[runtime]
    film_ior: S,
    /// Refractive index of the base at this wavelength, > 0.
    #[runtime]
    base_ior: R,
    /// Extinction coefficient of the base at this wavelength, >= 0.
    #[runtime]
    base_kappa: R,
) -> R {
    let media = Media { cos_theta1, ambient_ior, film_ior };
    let phase = thickness_nm * media.wave(total_reflection).q2 * wave_number;
    airy_at_node(total_reflection, base, media, phase, base_ior, base_kappa)
}

/// Reflectance at one wavelength for the phase there.
fn airy_at_node<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    total_reflection: bool,
    base: BaseKind,
    media: Media<S>,
    phase: S,
    base_ior: R,
    base_kappa: R,
) -> R {
    let wave = media.wave(total_reflection);
    let terms = film_terms(total_reflection, media, wave, media.base_wave(base, base_ior, base_kappa));
    let lanes = R::from_scalar;
    airy_reflectance(total_reflection, terms.s, terms.p, lanes(wave.q2_squared), lanes(phase))
}

/// Reflectance of the film at one wavelength, with the index that the base has there.
#[shade]
pub fn node_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// Whether the film may reflect totally.
    #[constant]
    total_reflection: bool,
    /// The kind of base.
    #[constant]
    base: BaseKind,
    /// Cosine of the angle of incidence in the ambient medium, [0, 1].
    cos_theta1: S,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: S,
    /// Refractive index of the film, > 0.
    film_ior: S,
    /// Half the phase of one round trip in the film, radians.
    phase: S,
    /// Refractive index of the base at this wavelength, > 0.
    #[runtime]
    base_ior: R,
    /// Extinction coefficient of the base at this wavelength, >= 0.
    #[runtime]
    base_kappa: R,
) -> R {
    let media = Media { cos_theta1, ambient_ior, film_ior };
    airy_at_node(total_reflection, base, media, phase, base_ior, base_kappa)
}

/// The sum of a reflectance over the nodes, each times its weight.
pub fn weighted<V: Vector<S>, S: Real>(nodes: &[SpectralNode], reflectance: impl Fn(&SpectralNode) -> V) -> V {
    weighted_in(Precision::FULL, nodes, reflectance)
}

/// The same, held in half precision where that is asked for.
fn weighted_in<V: Vector<S>, S: Real>(
    precision: Precision,
    nodes: &[SpectralNode],
    reflectance: impl Fn(&SpectralNode) -> V,
) -> V {
    let mut reflected = V::lit(0.0);
    for node in nodes {
        let weighted = precision.sum(precision.sum(reflectance(node)) * precision.sum(V::lit3(node.weight)));
        reflected = precision.sum(reflected + weighted).named("reflected");
    }
    reflected
}
