//! What the Fresnel formulas give of a film at one wavelength: where the fits begin.

use nalgebra::Complex;

/// The media at one wavelength.
#[derive(Clone, Copy, Debug)]
pub(super) struct Media {
    pub ambient_ior: f64,
    pub film_ior: f64,
    pub base: Complex<f64>,
}

/// One polarisation: `R = 1 - Q - 2 Q Re sum_m b^m z^m`, with `z` the phase of a round trip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polarisation {
    /// `Q`, the transmittance averaged over the phase.
    pub transmittance: f64,
    /// `b`, the amplitude of a round trip.
    pub round_trip: Complex<f64>,
}

impl Media {
    /// Both polarisations at an angle.
    ///
    /// Source: Belcour and Barla 2017, equations 5 to 7.
    pub fn polarisations(&self, cos_theta1: f64) -> [Polarisation; 2] {
        let q1 = self.ambient_ior * cos_theta1;
        let eps1 = self.ambient_ior * self.ambient_ior;
        let normal = |eps: Complex<f64>| (eps - eps1 + q1 * q1).sqrt();
        let eps2 = Complex::from(self.film_ior * self.film_ior);
        let eps3 = self.base * self.base;
        let (q2, q3) = (normal(eps2), normal(eps3));
        let q1 = Complex::from(q1);
        [[q1, q2, q3], [q1 / eps1, q2 / eps2, q3 / eps3]].map(|[a1, a2, a3]| {
            let r12 = (a1 - a2) / (a1 + a2);
            let r23 = (a2 - a3) / (a2 + a3);
            let (front, back) = (r12.norm_sqr(), r23.norm_sqr());
            Polarisation {
                transmittance: (1.0 - front) * (1.0 - back) / (1.0 - front * back).max(1e-9),
                round_trip: -r12 * r23,
            }
        })
    }
}
