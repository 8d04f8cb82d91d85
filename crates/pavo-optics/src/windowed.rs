//! Equally spaced wave numbers under a Gaussian window, all orders: the sensitivities are
//! `S_j(D) = g sum_k w_jk e^(i omega_k D)` with `g = e^(-(D / D_c)^2)`.
//!
//! The orders add up as a Poisson kernel. With `h = max(g^2, 0.1)`, `kappa = 1 / h` and `B = b g h`, orders 1 and 2
//! carry their exact damping, and
//!
//! `R_j = 1 - sum_pol Q (1 - kappa) / 2 - sum_pol (kappa Q / 2) sum_k w_jk (1 - |B|^2) / |1 - B e^(i omega_k D)|^2`.
//!
//! With a real `B` the kernel is `1 / (f cos^2(phase / 2) + sin^2(phase / 2) / f)`, `f = (1 - B) / (1 + B)`: it loses no
//! digits where B approaches 1, at grazing angles. Equally spaced phases follow from two of them by a recurrence.

use crate::film::BaseKind;
use crate::precision::Precision;
use crate::relative::{RelativeFilm, RelativeWaves};
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

/// One polarisation of a film on a real base, under the window.
#[shade]
pub struct RealKernel<R: Real> {
    /// `4 r u / Q`, with `r` and `u` the waves in the ambient medium and the base over that in the film.
    pub mean: R,
    /// `f = (1 - B) / (1 + B)`: the kernel runs from `1 / f` at phase 0 to `f` at phase pi.
    pub flatness: R,
}

/// One polarisation of a film on a real base, under the window.
///
/// Source: the Poisson kernel over orders of Belcour and Barla 2017, equation 9.
#[shade]
pub fn real_kernel<R: Real>(
    /// Wave vectors outside the film, over that in the film.
    waves: RelativeWaves<R>,
    /// What is left of a round trip: `g h`, (0, 1].
    damping: R,
) -> RealKernel<R> {
    let straight = 1.0 + waves.ambient * waves.base;
    let crossed = waves.ambient + waves.base;
    let entering = straight + crossed;
    let reflected = damping * (straight - crossed);
    RealKernel { mean: straight * crossed, flatness: (entering - reflected) / (entering + reflected) }
}

/// One polarisation of a film on a complex base, under the window: a node contributes
/// `1 / (offset - cosine cos(phase) - sine sin(phase))`.
#[shade]
pub struct ComplexKernel<R: Real> {
    /// `Q / 4`.
    pub transmittance: R,
    /// `4 (1 + |B|^2) / (kappa Q (1 - |B|^2))`.
    pub offset: R,
    /// `8 Re B / (kappa Q (1 - |B|^2))`.
    pub cosine: R,
    /// `-8 Im B / (kappa Q (1 - |B|^2))`.
    pub sine: R,
}

/// One polarisation of a film on a complex base, under the window.
///
/// Source: the Poisson kernel over orders of Belcour and Barla 2017, equation 9.
#[shade]
pub fn complex_kernel<R: Real>(
    /// Wave vectors outside the film, over that in the film.
    waves: RelativeWaves<R>,
    /// What is left of a round trip: `g h`, (0, 1].
    damping: R,
    /// The square h of the window, held at 0.1 or above.
    window_squared: R,
) -> ComplexKernel<R> {
    // Beyond these the kernel is sharper than its cosines are exact.
    let ambient = waves.ambient.max(2e-3).min(500.0);
    // A base that reflects totally lets nothing in, and the kernel has no height to divide by.
    let base = waves.base.max(1e-12);
    let ambient_sum = 1.0 + ambient * ambient;
    let base_sum = 1.0 + waves.base_squared;
    let entering = ambient * base;
    let mean = base * ambient_sum + ambient * base_sum;
    let transmittance = waves.ambient * base / mean;
    // With B = damping t / s: |s|^2 and |t|^2, which are 4 mean apart.
    let squares = ambient_sum * base_sum + 4.0 * entering;
    let entered = squares + 2.0 * mean;
    let returned = damping * damping * (squares - 2.0 * mean);
    let difference = entered - returned;
    let sum = entered + returned;
    let scale = window_squared / (difference * transmittance);
    let interference = (2.0 - ambient_sum) * (4.0 * damping * scale);
    ComplexKernel {
        transmittance,
        offset: sum * scale,
        cosine: interference * (0.5 - 0.5 * waves.base_squared),
        sine: interference * waves.base_decay,
    }
}

/// One polarisation under the window, at one optical path difference.
#[shade]
pub struct NodeTerms<R: Real> {
    /// The denominator at phase 0 on a real base, its mean on a complex one.
    pub offset: R,
    /// What it loses with `sin^2(phase / 2)` on a real base, with `cos(phase)` on a complex one.
    pub even: R,
    /// What it loses with `sin(phase)`; 0 on a real base.
    pub odd: R,
}

/// Both polarisations under the window, at one optical path difference:
/// `R_j = rest - scale sum_k 2 w_jk node_k`.
#[shade]
pub struct WindowedFilm<R: Real> {
    /// What does not depend on the phase: `1 - sum_pol Q (1 - kappa) / 2`.
    pub rest: R,
    /// What the nodes of a channel come to on average over the phase: `sum_pol kappa Q / 2`.
    pub mean: R,
    /// The factor of all nodes; 1 on a complex base.
    pub scale: R,
    /// s polarisation.
    pub s: NodeTerms<R>,
    /// p polarisation.
    pub p: NodeTerms<R>,
}

impl<R: Real> WindowedFilm<R> {
    /// A film under a window of a width, in nm, at the optical path of one pass: half the optical path difference.
    pub fn new<S: Scalar>(width_nm: f64, base: BaseKind, film: RelativeFilm<R>, path_nm: S) -> Self
    where
        R: Lanes<S> + Value<Leaf = S::Leaf>,
    {
        Self::under(closing(width_nm, path_nm), base, film)
    }

    /// A film under a window that has closed to g; with it its square, held at 0.1 or above.
    pub(crate) fn under<S: Scalar>([g, g_squared]: [S; 2], base: BaseKind, film: RelativeFilm<R>) -> Self
    where
        R: Lanes<S> + Value<Leaf = S::Leaf>,
    {
        let lanes = R::from_scalar;
        let damping = (g * g_squared).named("damping");
        if base.is_real() {
            let s = real_kernel(film.s, lanes(damping)).named("kernel_s");
            let p = real_kernel(film.p, lanes(damping)).named("kernel_p");
            let mean_s = (s.mean * film.p_over_s).named("mean_s");
            let one = R::lit(1.0);
            let entering = film.p.ambient * film.p.base;
            let scale = (entering * R::from_scalar(S::lit(1.0) / g_squared)).named("scale");
            let transmittance = one / mean_s + one / p.mean;
            let rest = (one + transmittance * (R::lit(2.0) * scale - R::lit(2.0) * entering)).named("rest");
            let mean = (transmittance * (R::lit(2.0) * scale)).named("mean");
            let terms = |mean: R, flatness: R, name: &str| {
                let offset = (mean * flatness).named(&format!("offset_{name}"));
                NodeTerms { offset, even: (offset - mean / flatness).named(&format!("even_{name}")), odd: R::lit(0.0) }
            };
            Self { rest, mean, scale, s: terms(mean_s, s.flatness, "s"), p: terms(p.mean, p.flatness, "p") }
        } else {
            let s = complex_kernel(film.s, lanes(damping), lanes(g_squared)).named("kernel_s");
            let p = complex_kernel(film.p, lanes(damping), lanes(g_squared)).named("kernel_p");
            let rest = (S::lit(2.0) / g_squared - S::lit(2.0)).named("rest");
            let transmittance = s.transmittance + p.transmittance;
            let rest = R::lit(1.0) + transmittance * R::from_scalar(rest);
            let mean = (transmittance * R::from_scalar(S::lit(2.0) / g_squared)).named("mean");
            let terms =
                |kernel: ComplexKernel<R>| NodeTerms { offset: kernel.offset, even: kernel.cosine, odd: kernel.sine };
            Self { rest, mean, scale: R::lit(1.0), s: terms(s), p: terms(p) }
        }
    }

    /// Half of what a node of weight 1 contributes, before the scale, by what its phase gives.
    pub fn node(&self, precision: Precision, phase: Phase<R>) -> R {
        node(precision, [self.s, self.p].map(|terms| terms.denominator(phase)))
    }

    /// What the nodes are subtracted from, and what is taken from each node first. In half precision that is their mean:
    /// where the window closes, nodes and rest are several times what is left of them.
    pub(crate) fn rest_and_centre(&self, precision: Precision) -> (R, Option<R>) {
        if precision.sums { ((self.rest - self.mean).named("rest"), Some(self.mean)) } else { (self.rest, None) }
    }
}

impl<R: Real> NodeTerms<R> {
    fn denominator(&self, phase: Phase<R>) -> R {
        match phase {
            Phase::HalfSineSquared(square) => self.offset - self.even * square,
            Phase::Wave([cosine, sine]) => self.offset - self.even * cosine - self.odd * sine,
        }
    }
}

/// A node by the denominators of both polarisations.
fn node<R: Real>(precision: Precision, [s, p]: [R; 2]) -> R {
    let reciprocal = |denominator: R| precision.node(R::lit(1.0) / precision.node(denominator));
    precision.node(reciprocal(s) + reciprocal(p)).named("node")
}

/// What a node needs of its phase.
#[derive(Clone, Copy, Debug)]
pub enum Phase<R> {
    /// `sin^2(phase / 2)`: on a real base.
    HalfSineSquared(R),
    /// Cosine and sine: on a complex base.
    Wave([R; 2]),
}

impl<R> Phase<R> {
    pub(crate) fn map<T>(self, change: impl Fn(R) -> T) -> Phase<T> {
        match self {
            Phase::HalfSineSquared(square) => Phase::HalfSineSquared(change(square)),
            Phase::Wave(wave) => Phase::Wave(wave.map(change)),
        }
    }
}

/// How far a window of a width, in nm, closes at the optical path of one pass: g, and its square, held at 0.1 or above.
pub(crate) fn closing<S: Scalar>(width_nm: f64, path_nm: S) -> [S; 2] {
    let g = (S::lit(-4.0 / (width_nm * width_nm)) * (path_nm * path_nm)).exp().named("window");
    [g, (g * g).max(S::lit(0.1)).named("window_squared")]
}

/// The colour of a film by the nodes of a window: a rest, less what they contribute beyond a centre.
pub(crate) fn color_of_nodes<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    precision: Precision,
    film: WindowedFilm<R>,
    base: BaseKind,
    nodes: impl IntoIterator<Item = R>,
    weights: &[[f64; 3]],
    (rest, centre): (S::Vec3, Option<R>),
) -> S::Vec3 {
    let nodes = nodes.into_iter().zip(weights);
    if let Some(centre) = centre {
        let scale = (R::lit(2.0) * film.scale).named("doubled_scale");
        return nodes.fold(rest, |color, (node, weight)| {
            let contribution = precision.sum(scale * node - centre).named("contribution");
            precision.sum(color - precision.weighted::<S>(*weight, contribution.into_vec3())).named("color")
        });
    }
    let weighted = nodes.map(|(node, weight)| S::Vec3::lit3(weight.map(|weight| 2.0 * weight)) * node.into_vec3());
    if base.is_real() {
        let sum = weighted.reduce(|sum, node| (sum + node).named("interference")).unwrap_or(S::Vec3::lit(0.0));
        (rest - film.scale.into_vec3() * sum).named("color")
    } else {
        weighted.fold(rest, |color, node| (color - node).named("color"))
    }
}

/// Reflectance of the film by equally spaced wave numbers under a window, all orders, at the optical path of one pass.
pub fn windowed_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    precision: Precision,
    window: &Window,
    base: BaseKind,
    film: RelativeFilm<R>,
    path_nm: S,
) -> S::Vec3 {
    let film = WindowedFilm::new(window.width_nm, base, film, path_nm);
    let nodes: Vec<R> = if base.is_real() {
        let phases = phases(window, base, path_nm).into_iter();
        phases.map(|phase| film.node(precision, phase.map(R::from_scalar))).collect()
    } else {
        let s = denominators(window, film.s, path_nm, "denominator_s");
        let p = denominators(window, film.p, path_nm, "denominator_p");
        s.into_iter().zip(p).map(|(s, p)| node(precision, [s, p])).collect()
    };
    let (rest, centre) = film.rest_and_centre(precision);
    let rest = precision.sum(rest.into_vec3());
    color_of_nodes(precision, film, base, nodes, &window.weights, (rest, centre))
}

/// The denominator at each node on a complex base. Like its cosines it follows from two by a recurrence:
/// `d_(k+1) = 2 cos(step) d_k - d_(k-1) + (2 - 2 cos(step)) offset`.
fn denominators<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    window: &Window,
    terms: NodeTerms<R>,
    path_nm: S,
    name: &str,
) -> Vec<R> {
    let count = window.weights.len();
    let first = Window { weights: window.weights[..count.min(2)].to_vec(), ..window.clone() };
    let waves = waves(&first, path_nm).into_iter().map(|wave| Phase::Wave(wave.map(R::from_scalar)));
    let mut denominators: Vec<R> = waves.map(|wave| terms.denominator(wave).named(name)).collect();
    let doubled = doubled_cosine(window.step, path_nm);
    let [doubled, rest] = [doubled, (S::lit(2.0) - doubled).named("doubled_rest")].map(R::from_scalar);
    let rest = rest * terms.offset;
    while denominators.len() < count {
        let [before, last] = [denominators[denominators.len() - 2], denominators[denominators.len() - 1]];
        denominators.push((doubled * last - before + rest).named(name));
    }
    denominators
}

/// What each node needs of its phase, at the optical path of one pass.
pub(crate) fn phases<S: Scalar>(window: &Window, base: BaseKind, path_nm: S) -> Vec<Phase<S>> {
    if base.is_real() {
        half_sines(window, path_nm).into_iter().map(Phase::HalfSineSquared).collect()
    } else {
        waves(window, path_nm).into_iter().map(Phase::Wave).collect()
    }
}

/// `sin^2` of half the phase at each node, by `s_(k+1) = 2 cos(step / 2) s_k - s_(k-1)` for the sine.
fn half_sines<S: Scalar>(window: &Window, path_nm: S) -> Vec<S> {
    let half_phase = |angular_wave_number: f64| (S::lit(angular_wave_number) * path_nm).named("half_phase");
    let mut sines: Vec<S> = [window.first, window.first + window.step]
        .map(|angular_wave_number| half_phase(angular_wave_number).sin().named("half_sine"))
        .to_vec();
    let doubled = doubled_cosine(0.5 * window.step, path_nm);
    while sines.len() < window.weights.len() {
        sines.push((doubled * sines[sines.len() - 1] - sines[sines.len() - 2]).named("half_sine"));
    }
    sines.truncate(window.weights.len());
    sines.into_iter().map(|sine| (sine * sine).named("half_sine_squared")).collect()
}

/// Cosine and sine of the phase at each node, by the recurrence `c_(k+1) = 2 cos(step) c_k - c_(k-1)`.
pub(crate) fn waves<S: Scalar>(window: &Window, path_nm: S) -> Vec<[S; 2]> {
    let mut waves: Vec<[S; 2]> = [window.first, window.first + window.step]
        .map(|angular_wave_number| (S::lit(2.0 * angular_wave_number) * path_nm).named("phase"))
        .map(|phase| [phase.cos().named("cosine"), phase.sin().named("sine")])
        .to_vec();
    let doubled = doubled_cosine(window.step, path_nm);
    while waves.len() < window.weights.len() {
        let [before, last] = [waves[waves.len() - 2], waves[waves.len() - 1]];
        let next = |part: usize, name: &str| (doubled * last[part] - before[part]).named(name);
        waves.push([next(0, "cosine"), next(1, "sine")]);
    }
    waves.truncate(window.weights.len());
    waves
}

/// Twice the cosine of the phase that a wave number has after a round trip.
fn doubled_cosine<S: Scalar>(angular_wave_number: f64, path_nm: S) -> S {
    let step = (S::lit(2.0 * angular_wave_number) * path_nm).named("phase_step");
    (S::lit(2.0) * step.cos()).named("doubled_cosine")
}
