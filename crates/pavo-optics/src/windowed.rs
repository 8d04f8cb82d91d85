//! Equally spaced wave numbers under a Gaussian window, all orders: the sensitivities are
//! `S_j(D) = g sum_k w_jk e^(i omega_k D)` with `g = e^(-(D / D_c)^2)`.
//!
//! The orders add up as a Poisson kernel. With `h = max(g^2, 0.1)`, `kappa = 1 / h` and `B = b g h`, orders 1 and 2
//! carry their exact damping, and
//!
//! `R_j = 1 - sum_pol Q (1 - kappa) / 2 - sum_pol (kappa Q / 2) sum_k w_jk (1 - |B|^2) / |1 - B e^(i omega_k D)|^2`.
//!
//! With a real `B = t / s` the kernel is `(s^2 - t^2) / ((s - t)^2 + 4 s t sin^2(phase / 2))`: in sums of what is not
//! negative `s - t` loses no digits where B approaches 1, at grazing angles. Both polarisations over one denominator take
//! one quotient a node. Equally spaced phases follow from two of them by a recurrence.

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

/// One polarisation of a film on a real base, under the window: with `x = sin^2(phase / 2)` a node contributes
/// `transmittance sum difference / (difference^2 (1 - x) + sum^2 x)`.
#[shade]
pub struct RealKernel<R: Real> {
    /// `kappa Q / 4`.
    pub transmittance: R,
    /// `s + t`: `s = (1 + r)(1 + u) / 2` of the waves r in the ambient medium and u in the base, `t = B s`.
    pub sum: R,
    /// `s - t`.
    pub difference: R,
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
    /// The square h of the window, held at 0.1 or above.
    window_squared: R,
) -> RealKernel<R> {
    // Beyond these, next to the critical angle, the squares of squares leave the range of f32.
    let ambient = waves.ambient.min(1e4);
    let base = waves.base.min(1e4);
    let entering = ambient * base;
    let straight = 1.0 + entering;
    let crossed = ambient + base;
    let transmittance = entering / (straight * crossed * window_squared);
    // With s = (1 + r)(1 + u) / 2 and t = damping (1 - r)(1 - u) / 2.
    let lost = (0.5 - 0.5 * damping) * (straight - crossed);
    RealKernel { transmittance, sum: straight - lost, difference: crossed + lost }
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

/// One polarisation on a complex base under the window, at one optical path difference.
#[shade]
pub struct NodeTerms<R: Real> {
    /// The mean of the denominator over the phase.
    pub offset: R,
    /// What it loses with `cos(phase)`.
    pub even: R,
    /// What it loses with `sin(phase)`.
    pub odd: R,
}

/// Both polarisations on a real base under the window, at one optical path difference, over one denominator: a node
/// contributes `(top_0 + top_1 x) / (bottom_0 + bottom_1 x + bottom_2 x^2)` with `x = sin^2(phase / 2)`.
#[shade]
pub struct NodeQuotient<R: Real> {
    /// The numerator at phase 0.
    pub top_0: R,
    /// What it gains with x.
    pub top_1: R,
    /// The denominator at phase 0.
    pub bottom_0: R,
    /// What it gains with x.
    pub bottom_1: R,
    /// What it gains with x^2.
    pub bottom_2: R,
}

/// Both polarisations under the window, at one optical path difference: `R_j = rest - sum_k 2 w_jk node_k`.
#[shade]
pub struct WindowedFilm<R: Real> {
    /// What does not depend on the phase: `1 - sum_pol Q (1 - kappa) / 2`.
    pub rest: R,
    /// What the nodes of a channel come to on average over the phase: `sum_pol kappa Q / 2`.
    pub mean: R,
    /// Both polarisations on a real base; 0 on a complex one.
    pub both: NodeQuotient<R>,
    /// s polarisation on a complex base; 0 on a real one.
    pub s: NodeTerms<R>,
    /// p polarisation on a complex base; 0 on a real one.
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
        let damping = lanes((g * g_squared).named("damping"));
        let none = R::lit(0.0);
        let no_terms = NodeTerms { offset: none, even: none, odd: none };
        if base.is_real() {
            let s = real_kernel(film.s, damping, lanes(g_squared)).named("kernel_s");
            let p = real_kernel(film.p, damping, lanes(g_squared)).named("kernel_p");
            let rest = lanes((S::lit(2.0) - S::lit(2.0) * g_squared).named("closed"));
            let transmittance = s.transmittance + p.transmittance;
            let rest = (R::lit(1.0) + transmittance * rest).named("rest");
            let mean = (R::lit(2.0) * transmittance).named("mean");
            Self { rest, mean, both: NodeQuotient::new(s, p), s: no_terms, p: no_terms }
        } else {
            let s = complex_kernel(film.s, damping, lanes(g_squared)).named("kernel_s");
            let p = complex_kernel(film.p, damping, lanes(g_squared)).named("kernel_p");
            let rest = (S::lit(2.0) / g_squared - S::lit(2.0)).named("rest");
            let transmittance = s.transmittance + p.transmittance;
            let rest = R::lit(1.0) + transmittance * lanes(rest);
            let mean = (transmittance * lanes(S::lit(2.0) / g_squared)).named("mean");
            let both = NodeQuotient { top_0: none, top_1: none, bottom_0: none, bottom_1: none, bottom_2: none };
            let terms =
                |kernel: ComplexKernel<R>| NodeTerms { offset: kernel.offset, even: kernel.cosine, odd: kernel.sine };
            Self { rest, mean, both, s: terms(s), p: terms(p) }
        }
    }

    /// Half of what a node of weight 1 contributes, by what its phase gives.
    pub fn node(&self, precision: Precision, phase: Phase<R>) -> R {
        match phase {
            Phase::HalfSineSquared(square) => self.both.at(precision, square),
            Phase::Wave(wave) => node(precision, [self.s, self.p].map(|terms| terms.denominator(wave))),
        }
    }

    /// What the nodes are subtracted from, and what is taken from each node first. In half precision that is their mean:
    /// where the window closes, nodes and rest are several times what is left of them.
    pub(crate) fn rest_and_centre(&self, precision: Precision) -> (R, Option<R>) {
        if precision.sums { ((self.rest - self.mean).named("rest"), Some(self.mean)) } else { (self.rest, None) }
    }
}

impl<R: Real> NodeQuotient<R> {
    fn new(s: RealKernel<R>, p: RealKernel<R>) -> Self {
        // Values at x = 0 and x = 1 are squares and products of these.
        let differences = (s.difference * p.difference).named("differences");
        let sums = (s.sum * p.sum).named("sums");
        let mixed = [(s.sum * p.difference).named("mixed"), (p.sum * s.difference).named("mixed")];
        let top_0 = (differences * (s.transmittance * mixed[0] + p.transmittance * mixed[1])).named("top_0");
        let top_end = sums * (s.transmittance * mixed[1] + p.transmittance * mixed[0]);
        let bottom_0 = (differences * differences).named("bottom_0");
        let bottom_0_and_1 = (mixed[0] * mixed[0] + (mixed[1] * mixed[1] - bottom_0)).named("bottom_0_and_1");
        Self {
            top_0,
            top_1: (top_end - top_0).named("top_1"),
            bottom_0,
            bottom_1: (bottom_0_and_1 - bottom_0).named("bottom_1"),
            bottom_2: (sums * sums - bottom_0_and_1).named("bottom_2"),
        }
    }

    fn at(&self, precision: Precision, x: R) -> R {
        let bottom = self.bottom_0 + (self.bottom_1 + self.bottom_2 * x) * x;
        precision.node((self.top_0 + self.top_1 * x) / bottom).named("node")
    }
}

impl<R: Real> NodeTerms<R> {
    fn denominator(&self, [cosine, sine]: [R; 2]) -> R {
        self.offset - self.even * cosine - self.odd * sine
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
    nodes: impl IntoIterator<Item = R>,
    weights: &[[f64; 3]],
    (rest, centre): (S::Vec3, Option<R>),
) -> S::Vec3 {
    let nodes = nodes.into_iter().zip(weights);
    if let Some(centre) = centre {
        return nodes.fold(rest, |reflected, (node, weight)| {
            let contribution = precision.sum(R::lit(2.0) * node - centre).named("contribution");
            precision.sum(reflected - precision.weighted::<S>(*weight, contribution.into_vec3())).named("reflected")
        });
    }
    let weighted = nodes.map(|(node, weight)| S::Vec3::lit3(weight.map(|weight| 2.0 * weight)) * node.into_vec3());
    weighted.fold(rest, |reflected, node| (reflected - node).named("reflected"))
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
    color_of_nodes(precision, nodes, &window.weights, (rest, centre))
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
    let waves = waves(&first, path_nm).into_iter().map(|wave| wave.map(R::from_scalar));
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
