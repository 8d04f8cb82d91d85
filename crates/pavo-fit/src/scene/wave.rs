//! The thickness-dependent part of each form at one point, with its derivatives.
//!
//! Every form is `R_j = P0_j - sum_k w_jk t_k`, where `t_k` depends on the other polynomials' values at the angle, on the
//! logarithm of the window, on the damping of a round trip, and on the phase of its wave.

use super::plan::Form;

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
    /// Logarithm of what a round trip loses besides.
    pub log_loss: f64,
    /// Logarithm of what the round trip's damping is scaled by, where the first order takes it for its window.
    pub log_taper: f64,
}

/// A value with its derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Wave {
    pub value: f64,
    pub by_polynomial: [f64; MOST_POLYNOMIALS],
    pub by_log_window: f64,
    pub by_exponent: f64,
    pub by_log_loss: f64,
    pub by_log_taper: f64,
    pub by_phase: f64,
}

impl Local {
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

    /// `P1 h (u - B) / (1 + B^2 - 2 B u)`, `B = P2 q`, `q = g^p e^(-s D)`, `h = min(g, t q)`, and with a first order of its
    /// own `P3 h u` besides.
    fn damped_kernel(&self, phase: f64) -> Wave {
        let [contrast, round_trip, first_order, ..] = self.polynomials;
        let log_damping = self.exponent * self.log_window + self.log_loss;
        let tapers = log_damping + self.log_taper < self.log_window;
        let window = self.log_window.min(log_damping + self.log_taper).exp();
        let damping = log_damping.exp();
        let (sine, cosine) = phase.sin_cos();
        let trip = round_trip * damping;
        let inverse = 1.0 / (1.0 + trip * trip - 2.0 * trip * cosine);
        let kernel = (cosine - trip) * inverse;
        // A form without a first order of its own has 0 here.
        let correction = first_order * window;
        let by_trip = contrast * window * (2.0 * kernel * kernel - inverse);
        let mut wave = Wave { value: contrast * window * kernel + correction * cosine, ..Wave::default() };
        wave.by_polynomial[0] = window * kernel;
        wave.by_polynomial[1] = by_trip * damping;
        wave.by_polynomial[2] = window * cosine;
        wave.by_log_taper = if tapers { wave.value } else { 0.0 };
        wave.by_log_loss = wave.by_log_taper + by_trip * trip;
        wave.by_exponent = wave.by_log_loss * self.log_window;
        wave.by_log_window = if tapers { 0.0 } else { wave.value } + wave.by_log_loss * self.exponent;
        wave.by_phase = -sine * (contrast * window * (1.0 - trip * trip) * inverse * inverse + correction);
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
}
