//! The thickness-dependent part of each form at one point, with its derivatives.
//!
//! Every form is `R_j = P0_j + C - sum_k w_jk t_k`, where `C` and `t_k` depend on the other polynomials' values at the
//! angle, on the logarithm `x` of the window, on the window's exponent, and `t_k` on the phase of its wave.

use super::plan::Form;
use pavo_optics::fitted::LARGEST_LOG_GROWTH;

/// The most polynomials that a form has besides the mean.
pub(super) const MOST_POLYNOMIALS: usize = 6;

/// What a form depends on at one point, but for the phases.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local {
    pub form: Form,
    /// Values of the polynomials.
    pub polynomials: [f64; MOST_POLYNOMIALS],
    /// Logarithm of the window, at most 0.
    pub log_window: f64,
    /// Exponent of the window.
    pub exponent: f64,
}

/// A value with its derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Wave {
    pub value: f64,
    pub by_polynomial: [f64; MOST_POLYNOMIALS],
    pub by_log_window: f64,
    pub by_exponent: f64,
    pub by_phase: f64,
}

impl Local {
    /// The part that is the same for all waves and channels, `C`.
    pub fn constant(&self) -> Wave {
        let mut wave = Wave::default();
        if matches!(self.form, Form::DampedKernel | Form::CorrectedKernel) {
            let amplitude = self.amplitude();
            wave.value = amplitude.value;
            wave.by_polynomial[0] = amplitude.growth;
            wave.by_log_window = amplitude.by_log_window;
            wave.by_exponent = amplitude.by_exponent;
        }
        wave
    }

    /// The part of one wave, `t_k`.
    pub fn wave(&self, phase: f64) -> Wave {
        match self.form {
            Form::AngleOnly => Wave::default(),
            Form::FirstOrder => self.first_order(phase),
            Form::Kernel => self.kernel(phase),
            Form::DampedKernel | Form::CorrectedKernel => self.damped_kernel(phase),
            Form::ThreeOrders => self.three_orders(phase),
        }
    }

    /// `P1 g u`.
    fn first_order(&self, phase: f64) -> Wave {
        let window = self.log_window.exp();
        let mut wave = Wave { value: self.polynomials[0] * window * phase.cos(), ..Wave::default() };
        wave.by_polynomial[0] = window * phase.cos();
        wave.by_log_window = wave.value;
        wave.by_phase = -self.polynomials[0] * window * phase.sin();
        wave
    }

    /// `P1 sqrt(1 - X^2) / (1 - X u)`, `X = P2 g`.
    fn kernel(&self, phase: f64) -> Wave {
        let [contrast, sharpness, ..] = self.polynomials;
        let window = self.log_window.exp();
        let (sine, cosine) = phase.sin_cos();
        let x = sharpness * window;
        let root = (1.0 - x * x).sqrt();
        let inverse = 1.0 / (1.0 - x * cosine);
        let by_x = contrast * (root * cosine * inverse * inverse - x / root * inverse);
        let mut wave = Wave { value: contrast * root * inverse, ..Wave::default() };
        wave.by_polynomial[0] = root * inverse;
        wave.by_polynomial[1] = by_x * window;
        wave.by_log_window = by_x * x;
        wave.by_phase = -contrast * root * inverse * inverse * x * sine;
        wave
    }

    /// `n (1 - B^2) / (1 + B^2 - 2 B u)`, and with a first order of its own `n P3 g^p u` besides.
    fn damped_kernel(&self, phase: f64) -> Wave {
        let [_, round_trip, first_order, ..] = self.polynomials;
        let damping = (self.exponent * self.log_window).exp();
        let amplitude = self.amplitude();
        let (sine, cosine) = phase.sin_cos();
        let trip = round_trip * damping;
        let numerator = 1.0 - trip * trip;
        let inverse = 1.0 / (1.0 + trip * trip - 2.0 * trip * cosine);
        let correction = if self.form == Form::CorrectedKernel { first_order * damping } else { 0.0 };
        let by_amplitude = numerator * inverse + correction * cosine;
        let by_trip = -2.0 * amplitude.value * inverse * (trip + numerator * (trip - cosine) * inverse);
        let by_correction = amplitude.value * cosine;
        let by_damping =
            by_trip * round_trip + if self.form == Form::CorrectedKernel { by_correction * first_order } else { 0.0 };
        let mut wave = Wave { value: amplitude.value * by_amplitude, ..Wave::default() };
        wave.by_polynomial[0] = amplitude.growth * by_amplitude;
        wave.by_polynomial[1] = by_trip * damping;
        wave.by_polynomial[2] = by_correction * damping;
        wave.by_log_window = amplitude.by_log_window * by_amplitude + by_damping * damping * self.exponent;
        wave.by_exponent = amplitude.by_exponent * by_amplitude + by_damping * damping * self.log_window;
        wave.by_phase = -sine * amplitude.value * (2.0 * trip * numerator * inverse * inverse + correction);
        wave
    }

    /// `sum_m g^(m^2) (A_m cos(m phi) + B_m sin(m phi))`.
    fn three_orders(&self, phase: f64) -> Wave {
        let mut wave = Wave::default();
        for order in 0..3 {
            let number = (order + 1) as f64;
            let window = (number * number * self.log_window).exp();
            let (sine, cosine) = (number * phase).sin_cos();
            let [even, odd] = [self.polynomials[order], self.polynomials[order + 3]];
            let term = window * (even * cosine + odd * sine);
            wave.value += term;
            wave.by_polynomial[order] = window * cosine;
            wave.by_polynomial[order + 3] = window * sine;
            wave.by_log_window += number * number * term;
            wave.by_phase += number * window * (odd * cosine - even * sine);
        }
        wave
    }

    /// `n = P1 min(g^(1 - p), 1000)`.
    fn amplitude(&self) -> Amplitude {
        let log_growth = (1.0 - self.exponent) * self.log_window;
        let grows = log_growth < LARGEST_LOG_GROWTH;
        let growth = log_growth.min(LARGEST_LOG_GROWTH).exp();
        let value = self.polynomials[0] * growth;
        let slope = if grows { value } else { 0.0 };
        Amplitude { value, growth, by_log_window: slope * (1.0 - self.exponent), by_exponent: -slope * self.log_window }
    }
}

struct Amplitude {
    value: f64,
    growth: f64,
    by_log_window: f64,
    by_exponent: f64,
}
