//! Normal components of the wave vectors outside the film, over that in the film: all that interference in the film
//! depends on, besides the phase.
//!
//! With `r` that of the ambient medium and `u` that of the base (complex where it absorbs or reflects totally), one round
//! trip leaves `b = (1 - r)(1 - u) / ((1 + r)(1 + u))`, and the film transmits, averaged over the phase,
//! `Q = 4 r Re u / (Re u (1 + r^2) + r (1 + |u|^2))`: sums of what is not negative, which lose no digits where `b`
//! approaches 1.

use crate::film::{BaseKind, FilmWave, Media};
use crate::wave::{normal_component_absorbing, normal_component_squared, normal_component_squared_above_zero};
use pavo_shade::{Lanes, Real, Scalar, Value, shade};

/// Wave vectors of one polarisation outside the film, their normal components over that in the film; for p polarisation
/// each over its permittivity first.
#[shade]
pub struct RelativeWaves<R: Real> {
    /// In the ambient medium, > 0.
    pub ambient: R,
    /// In the base: the real part, >= 0.
    pub base: R,
    /// In the base: the imaginary part; 0 for a dielectric that does not reflect totally.
    pub base_decay: R,
    /// In the base: the square of the modulus.
    pub base_squared: R,
}

/// Both polarisations.
#[derive(Clone, Copy, Debug)]
pub struct RelativeFilm<R: Real> {
    /// For s polarisation.
    pub s: RelativeWaves<R>,
    /// For p polarisation.
    pub p: RelativeWaves<R>,
}

/// The waves outside a film, over the wave in it.
pub fn relative_film<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    kind: BaseKind,
    media: Media<S>,
    film: FilmWave<S>,
    base_ior: R,
    base_kappa: R,
) -> RelativeFilm<R> {
    let lanes = R::from_scalar;
    let one = S::lit(1.0);
    let ambient_squared = media.ambient_ior * media.ambient_ior;
    let film_squared = (media.film_ior * media.film_ior).named("film_permittivity");
    let q2_inverse = film.q2_inverse;
    let ambient_scale = (film_squared * (one / ambient_squared)).named("ambient_scale");
    let ambient = media.q1() * q2_inverse;
    // At 0 nothing enters. Where nothing may enter the base either, what divides by both is lost.
    let ambient = if kind.is_real() { ambient } else { ambient.max(S::lit(1e-6)) }.named("ambient");
    let ambient_p = lanes((ambient * ambient_scale).named("ambient_p"));
    let (ambient, q2_inverse) = (lanes(ambient), lanes(q2_inverse));
    let (cos_theta1, ambient_ior) = (lanes(media.cos_theta1), lanes(media.ambient_ior));
    match kind {
        BaseKind::Dielectric { total_reflection } => {
            let square = if total_reflection {
                normal_component_squared(cos_theta1, ambient_ior, base_ior)
            } else {
                normal_component_squared_above_zero(cos_theta1, ambient_ior, base_ior)
            }
            .named("q3_squared");
            let zero = R::lit(0.0);
            let q3 = if total_reflection { square.max(zero) } else { square }.sqrt().named("q3");
            let q3_decay = if total_reflection { (-square).max(zero).sqrt().named("q3_decay") } else { zero };
            let base_scale = (lanes(film_squared) / (base_ior * base_ior)).named("base_scale");
            let waves = |ambient: R, base: R, base_decay: R| RelativeWaves {
                ambient,
                base,
                base_decay,
                base_squared: base * base + base_decay * base_decay,
            };
            let (base, decay) = ((q3 * q2_inverse).named("base"), (q3_decay * q2_inverse).named("base_decay"));
            let p = waves(ambient_p, (base * base_scale).named("base_p"), (decay * base_scale).named("base_decay_p"));
            RelativeFilm { s: waves(ambient, base, decay), p }
        }
        BaseKind::Conductor => {
            let q3 = normal_component_absorbing(cos_theta1, ambient_ior, base_ior, base_kappa).named("q3");
            let s = RelativeWaves {
                ambient,
                base: (q3.re * q2_inverse).named("base"),
                base_decay: (q3.im * q2_inverse).named("base_decay"),
                base_squared: (q3.modulus * (q2_inverse * q2_inverse)).named("base_squared"),
            };
            let permittivity_modulus = base_ior * base_ior + base_kappa * base_kappa;
            let base_scale = lanes(film_squared) / (permittivity_modulus * permittivity_modulus);
            let base_scale = base_scale.named("base_scale");
            // q / epsilon = q conj(epsilon) / |epsilon|^2, with epsilon = q^2 + the square of the tangential component.
            let cosine = media.cos_theta1;
            let tangential_squared = lanes((ambient_squared * (one - cosine * cosine)).named("tangential_squared"));
            let re_scale = ((q3.modulus + tangential_squared) * base_scale).named("re_scale");
            let p = RelativeWaves {
                ambient: ambient_p,
                base: (s.base * re_scale).named("base_p"),
                base_decay: (s.base_decay * ((tangential_squared - q3.modulus) * base_scale)).named("base_decay_p"),
                base_squared: (s.base_squared * (lanes(film_squared) * base_scale)).named("base_squared_p"),
            };
            RelativeFilm { s, p }
        }
    }
}
