//! Equally spaced wave numbers under a Gaussian window, all orders: the sensitivities are
//! `S_j(D) = g sum_k w_jk e^(i omega_k D)` with `g = e^(-(D / D_c)^2)`.
//!
//! The orders add up as a Poisson kernel. With `h = max(g^2, 0.15)`, `kappa = 1 / h` and `B = b g h`, orders 1 and 2
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

/// Both polarisations of a film on a real base, under the window. A node contributes, with `x = sin^2(phase / 2)`,
/// `(top_0 + top_1 x) / ((s_0 + s_1 x) (p_0 + p_1 x))`. A factor for each polarisation keeps the digits that a polynomial
/// of their product would lose where one end is far below the other.
#[shade]
pub struct RealKernel<R: Real> {
    /// `kappa Q / 4`, summed over both polarisations.
    pub transmittance: R,
    /// The numerator at phase 0.
    pub top_0: R,
    /// What it gains with x.
    pub top_1: R,
    /// The denominator of s polarisation at phase 0.
    pub s_0: R,
    /// What it gains with x.
    pub s_1: R,
    /// The denominator of p polarisation at phase 0.
    pub p_0: R,
    /// What it gains with x.
    pub p_1: R,
}

/// Both polarisations of a film on a real base, under the window.
///
/// Source: the Poisson kernel over orders of Belcour and Barla 2017, equation 9.
#[shade]
pub fn real_kernel<R: Real>(
    /// Wave vectors of s polarisation outside the film, over that in the film.
    s: RelativeWaves<R>,
    /// The same for p polarisation.
    p: RelativeWaves<R>,
    /// What is left of a round trip: `g h`, (0, 1].
    damping: R,
    /// The square h of the window, held at 0.15 or above.
    window_squared: R,
) -> RealKernel<R> {
    // With s = (1 + r)(1 + u) / 2 of the waves r in the ambient medium and u in the base, and t = B s.
    let [entering_s, entering_p] = [(s.ambient * s.base).named("entering_s"), (p.ambient * p.base).named("entering_p")];
    let [straight_s, straight_p] = [(entering_s + 1.0).named("straight_s"), (entering_p + 1.0).named("straight_p")];
    let [crossed_s, crossed_p] = [(s.ambient + s.base).named("crossed_s"), (p.ambient + p.base).named("crossed_p")];
    let lost = (0.5 - 0.5 * damping).named("lost");
    let [lost_s, lost_p] = [lost * (straight_s - crossed_s), lost * (straight_p - crossed_p)];
    let [sum_s, sum_p] = [(straight_s - lost_s).named("sum_s"), (straight_p - lost_p).named("sum_p")];
    let [difference_s, difference_p] =
        [(crossed_s + lost_s).named("difference_s"), (crossed_p + lost_p).named("difference_p")];
    let transmittance = |entering: R, straight: R, crossed: R| entering / (straight * crossed * window_squared);
    let transmittance_s = transmittance(entering_s, straight_s, crossed_s).named("transmittance_s");
    let transmittance_p = transmittance(entering_p, straight_p, crossed_p).named("transmittance_p");
    let top_s = (transmittance_s * (sum_s * difference_s)).named("top_s");
    let top_p = (transmittance_p * (sum_p * difference_p)).named("top_p");
    let [s_0, p_0] = [(difference_s * difference_s).named("s_0"), (difference_p * difference_p).named("p_0")];
    let [s_1, p_1] = [(sum_s * sum_s - s_0).named("s_1"), (sum_p * sum_p - p_0).named("p_1")];
    RealKernel {
        transmittance: transmittance_s + transmittance_p,
        top_0: top_s * p_0 + top_p * s_0,
        top_1: top_s * p_1 + top_p * s_1,
        s_0,
        s_1,
        p_0,
        p_1,
    }
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
    /// The square h of the window, held at 0.15 or above.
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

/// Both polarisations under the window, at one optical path difference: `R_j = rest - sum_k 2 w_jk node_k`.
#[shade]
pub struct WindowedFilm<R: Real> {
    /// What does not depend on the phase: `1 - sum_pol Q (1 - kappa) / 2`.
    pub rest: R,
    /// What the nodes of a channel come to on average over the phase: `sum_pol kappa Q / 2`.
    pub mean: R,
    /// Both polarisations on a real base; 0 on a complex one.
    pub both: RealKernel<R>,
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

    /// A film under a window that has closed to g; with it its square, held at 0.15 or above.
    pub(crate) fn under<S: Scalar>([g, g_squared]: [S; 2], base: BaseKind, film: RelativeFilm<R>) -> Self
    where
        R: Lanes<S> + Value<Leaf = S::Leaf>,
    {
        let lanes = R::from_scalar;
        let damping = lanes((g * g_squared).named("damping"));
        let none = R::lit(0.0);
        if base.is_real() {
            let both = real_kernel(film.s, film.p, damping, lanes(g_squared)).named("kernel");
            let rest = lanes((S::lit(2.0) - S::lit(2.0) * g_squared).named("closed"));
            let rest = (R::lit(1.0) + both.transmittance * rest).named("rest");
            let mean = (R::lit(2.0) * both.transmittance).named("mean");
            let no_terms = NodeTerms { offset: none, even: none, odd: none };
            Self { rest, mean, both, s: no_terms, p: no_terms }
        } else {
            let s = complex_kernel(film.s, damping, lanes(g_squared)).named("kernel_s");
            let p = complex_kernel(film.p, damping, lanes(g_squared)).named("kernel_p");
            let rest = (S::lit(2.0) / g_squared - S::lit(2.0)).named("rest");
            let transmittance = s.transmittance + p.transmittance;
            let rest = R::lit(1.0) + transmittance * lanes(rest);
            let mean = (transmittance * lanes(S::lit(2.0) / g_squared)).named("mean");
            let [top_0, top_1] = [none; 2];
            let [s_0, s_1, p_0, p_1] = [none; 4];
            let both = RealKernel { transmittance: none, top_0, top_1, s_0, s_1, p_0, p_1 };
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

impl<R: Real> RealKernel<R> {
    fn at(&self, precision: Precision, x: R) -> R {
        let bottom = (self.s_0 + self.s_1 * x) * (self.p_0 + self.p_1 * x);
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

/// How far a window of a width, in nm, closes at the optical path of one pass: g, and its square, held at 0.15 or above.
pub(crate) fn closing<S: Scalar>(width_nm: f64, path_nm: S) -> [S; 2] {
    let g = (S::lit(-4.0 / (width_nm * width_nm)) * (path_nm * path_nm)).exp().named("window");
    [g, (g * g).max(S::lit(0.15)).named("window_squared")]
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
    let doubled = doubled_cosine(window.step, path_nm);
    let [doubled, rest] = [doubled, (S::lit(2.0) - doubled).named("doubled_rest")].map(R::from_scalar);
    let rest = rest * terms.offset;
    from_the_middle(
        window,
        |angular_wave_number| terms.denominator(wave(angular_wave_number, path_nm).map(R::from_scalar)).named(name),
        |last, before| (doubled * last - before + rest).named(name),
    )
}

/// What equally spaced nodes have of their phases: two in the middle by their wave numbers, radians per nm, and from
/// these outwards each by its two neighbours, the nearer one first. What f32 loses grows by the square of the steps that
/// were taken: from the middle they are half as many as from an end.
fn from_the_middle<T: Copy>(window: &Window, of: impl Fn(f64) -> T, next: impl Fn(T, T) -> T) -> Vec<T> {
    let count = window.weights.len();
    let middle = count.div_ceil(2).saturating_sub(1);
    let known = (middle..count.min(middle + 2)).map(|node| of(window.first + node as f64 * window.step));
    let mut upwards: Vec<T> = known.collect();
    while middle + upwards.len() < count {
        let [before, last] = [upwards[upwards.len() - 2], upwards[upwards.len() - 1]];
        upwards.push(next(last, before));
    }
    let mut downwards: Vec<T> = upwards[..upwards.len().min(2)].iter().rev().copied().collect();
    while downwards.len() < middle + 2 && downwards.len() >= 2 {
        let [before, last] = [downwards[downwards.len() - 2], downwards[downwards.len() - 1]];
        downwards.push(next(last, before));
    }
    downwards.into_iter().skip(2).rev().chain(upwards).collect()
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
    let doubled = doubled_cosine(0.5 * window.step, path_nm);
    let half_phase = |angular_wave_number: f64| (S::lit(angular_wave_number) * path_nm).named("half_phase");
    let sines = from_the_middle(
        window,
        |angular_wave_number| half_phase(angular_wave_number).sin().named("half_sine"),
        |last, before| (doubled * last - before).named("half_sine"),
    );
    sines.into_iter().map(|sine| (sine * sine).named("half_sine_squared")).collect()
}

/// Cosine and sine of the phase at each node, by the recurrence `c_(k+1) = 2 cos(step) c_k - c_(k-1)`.
pub(crate) fn waves<S: Scalar>(window: &Window, path_nm: S) -> Vec<[S; 2]> {
    let doubled = doubled_cosine(window.step, path_nm);
    from_the_middle(
        window,
        |angular_wave_number| wave(angular_wave_number, path_nm),
        |last, before| {
            let next = |part: usize, name: &str| (doubled * last[part] - before[part]).named(name);
            [next(0, "cosine"), next(1, "sine")]
        },
    )
}

/// Cosine and sine of the phase that a wave number has after a round trip.
fn wave<S: Scalar>(angular_wave_number: f64, path_nm: S) -> [S; 2] {
    let phase = (S::lit(2.0 * angular_wave_number) * path_nm).named("phase");
    [phase.cos().named("cosine"), phase.sin().named("sine")]
}

/// Twice the cosine of the phase that a wave number has after a round trip.
fn doubled_cosine<S: Scalar>(angular_wave_number: f64, path_nm: S) -> S {
    let step = (S::lit(2.0 * angular_wave_number) * path_nm).named("phase_step");
    (S::lit(2.0) * step.cos()).named("doubled_cosine")
}
