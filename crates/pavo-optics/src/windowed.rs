//! Equally spaced wave numbers under a Gaussian window, all orders: the sensitivities are
//! `S_j(D) = g sum_k w_jk e^(i omega_k D)` with `g = e^(-(D / D_c)^2)`.
//!
//! The orders add up as a Poisson kernel. With `h = max(g^2, 0.1)`, `kappa = 1 / h` and `B = b g h`, orders 1 and 2
//! carry their exact damping, and
//!
//! `R_j = 1 - sum_pol Q (1 - kappa) / 2 - sum_pol (kappa Q / 2) sum_k w_jk (1 - |B|^2) / |1 - B e^(i omega_k D)|^2`.
//!
//! The cosines of equally spaced phases follow from two of them by a recurrence.

use crate::film::{BaseWave, FilmTerms, Media};
use crate::poles::both_series_terms;
use crate::series::SeriesTerms;
use pavo_shade::{Lanes, Real, Scalar, Value, Vector, shade};

/// Equally spaced wave numbers with weights, under a window.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Window {
    /// The first angular wave number, radians per nm.
    pub first: f64,
    /// The step from one to the next, radians per nm.
    pub step: f64,
    /// The width D_c of the window, nm.
    pub width_nm: f64,
    /// Share of each node in each output channel; the shares of a channel add up to 1.
    pub weights: Vec<[f64; 3]>,
}

/// One polarisation under the window: a node contributes `strength / (offset - re cos + im sin)`.
#[shade]
pub struct WindowTerms<R: Real> {
    /// `kappa Q (1 - |B|^2) / 2`.
    pub strength: R,
    /// `1 + |B|^2`.
    pub offset: R,
    /// `2 Re B`.
    pub re: R,
    /// `2 Im B`; 0 for a dielectric base.
    pub im: R,
}

/// One polarisation under the window.
///
/// Source: the Poisson kernel over orders of Belcour and Barla 2017, equation 9.
#[shade]
pub fn window_terms<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// Coefficients of the series.
    terms: SeriesTerms<R>,
    /// The window g at this optical path difference, (0, 1].
    window: S,
    /// Its square, held at 0.1 or above.
    window_squared: S,
) -> WindowTerms<R> {
    let damping = R::from_scalar(window * window_squared);
    let round_trip = terms.round_trip * damping;
    let round_trip_im = terms.round_trip_im * damping;
    let modulus = round_trip * round_trip + round_trip_im * round_trip_im;
    let one = R::lit(1.0);
    let strength = terms.transmittance * R::from_scalar(0.5 / window_squared) * (one - modulus);
    WindowTerms { strength, offset: one + modulus, re: R::lit(2.0) * round_trip, im: R::lit(2.0) * round_trip_im }
}

/// Both polarisations under the window, at one optical path difference: `rest` less what the nodes contribute is the
/// reflectance.
#[shade]
pub struct WindowedFilm<R: Real> {
    /// What does not depend on the phase: `1 - sum_pol Q (1 - kappa) / 2`.
    pub rest: R,
    /// s polarisation.
    pub s: WindowTerms<R>,
    /// p polarisation.
    pub p: WindowTerms<R>,
}

impl<R: Real> WindowedFilm<R> {
    /// A film under a window of a width, in nm, at an optical path difference.
    pub fn new<S: Scalar>(width_nm: f64, series: [SeriesTerms<R>; 2], opd_nm: S) -> Self
    where
        R: Lanes<S> + Value<Leaf = S::Leaf>,
    {
        Self::under(closing(width_nm, opd_nm), series)
    }

    /// A film under a window that has closed to g; with it its square, held at 0.1 or above.
    pub(crate) fn under<S: Scalar>([g, g_squared]: [S; 2], [s, p]: [SeriesTerms<R>; 2]) -> Self
    where
        R: Lanes<S> + Value<Leaf = S::Leaf>,
    {
        let window_s = window_terms::<S, R>(s, g, g_squared).named("window_s");
        let window_p = window_terms::<S, R>(p, g, g_squared).named("window_p");
        // Q (1 - kappa) / 2 over both polarisations.
        let transmittance = s.transmittance + p.transmittance;
        let rest = (S::lit(0.5) - S::lit(0.5) / g_squared).named("rest");
        Self { rest: R::lit(1.0) - transmittance * R::from_scalar(rest), s: window_s, p: window_p }
    }

    /// What a node of weight 1 contributes, by the cosine and sine of its phase.
    pub fn node(&self, cosine: R, sine: R) -> R {
        let contribution = |terms: WindowTerms<R>| {
            let denominator = terms.offset - terms.re * cosine + terms.im * sine;
            terms.strength / denominator.max(R::lit(1e-12))
        };
        contribution(self.s) + contribution(self.p)
    }
}

/// How far a window of a width, in nm, closes at an optical path difference: g, and its square, held at 0.1 or above.
pub(crate) fn closing<S: Scalar>(width_nm: f64, opd_nm: S) -> [S; 2] {
    let spread = (opd_nm * S::lit(1.0 / width_nm)).named("spread");
    let g = (-(spread * spread)).exp().named("window");
    [g, (g * g).max(S::lit(0.1)).named("window_squared")]
}

/// Reflectance of the film by equally spaced wave numbers under a window, all orders.
pub fn windowed_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    window: &Window,
    terms: FilmTerms<R>,
    media: Media<S>,
    q2: S,
    base: BaseWave<R>,
    opd_nm: S,
) -> S::Vec3 {
    let film = WindowedFilm::new(window.width_nm, both_series_terms(terms, media, q2, base), opd_nm);
    let mut color = film.rest.into_vec3();
    for (phase, weight) in phases(window, opd_nm).into_iter().zip(&window.weights) {
        let [cosine, sine] = phase.map(R::from_scalar);
        let node = film.node(cosine, sine).named("node");
        color = (color - S::Vec3::lit3(*weight) * node.into_vec3()).named("color");
    }
    color
}

/// Cosine and sine of the phase at each node, by the recurrence `c_(k+1) = 2 cos(step) c_k - c_(k-1)`.
pub(crate) fn phases<S: Scalar>(window: &Window, opd_nm: S) -> Vec<[S; 2]> {
    let phase_of = |angular_wave_number: f64, name: &str| (S::lit(angular_wave_number) * opd_nm).named(name);
    let (first, second) = (phase_of(window.first, "phase"), phase_of(window.first + window.step, "phase"));
    let doubled = (S::lit(2.0) * phase_of(window.step, "phase_step").cos()).named("doubled_cosine");
    let mut phases = vec![
        [first.cos().named("cosine"), first.sin().named("sine")],
        [second.cos().named("cosine"), second.sin().named("sine")],
    ];
    while phases.len() < window.weights.len() {
        let [before, last] = [phases[phases.len() - 2], phases[phases.len() - 1]];
        let next = |part: usize, name: &str| (doubled * last[part] - before[part]).named(name);
        phases.push([next(0, "cosine"), next(1, "sine")]);
    }
    phases.truncate(window.weights.len());
    phases
}
