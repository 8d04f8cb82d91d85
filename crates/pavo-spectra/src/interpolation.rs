//! Interpolation of tables: linear, and by a natural cubic spline.

/// The value at `x` of the polyline through (`xs`, `ys`), held constant beyond both ends. `xs` ascends strictly and
/// is not empty; `ys` is as long.
pub(crate) fn linear_held(xs: &[f64], ys: &[f64], x: f64) -> f64 {
    let last = xs.len() - 1;
    if x <= xs[0] {
        return ys[0];
    }
    if x >= xs[last] {
        return ys[last];
    }
    // For a NaN every comparison is false, so that `upper` stays within 1..=last and the NaN reaches the result.
    let upper = xs.partition_point(|&sample| sample <= x).clamp(1, last);
    let lower = upper - 1;
    let fraction = (x - xs[lower]) / (xs[upper] - xs[lower]);
    ys[lower] + fraction * (ys[upper] - ys[lower])
}

/// A natural cubic spline (second derivative zero at both ends) through equispaced samples of three curves.
pub(crate) struct UniformCubicSpline {
    first: f64,
    step: f64,
    values: Vec<[f64; 3]>,
    /// Second derivative at each sample, times step^2 / 6.
    bends: Vec<[f64; 3]>,
}

impl UniformCubicSpline {
    /// The spline through `values` at `first`, `first + step`, ... At least two values are needed.
    pub(crate) fn new(first: f64, step: f64, values: Vec<[f64; 3]>) -> Self {
        let bends = bends(&values);
        Self { first, step, values, bends }
    }

    /// The curves at `x`, zero outside the sampled range.
    pub(crate) fn at(&self, x: f64) -> [f64; 3] {
        let position = (x - self.first) / self.step;
        let last = self.values.len() - 1;
        if position.is_nan() || position < 0.0 || position > last as f64 {
            return [0.0; 3];
        }
        let lower = (position as usize).min(last - 1);
        let b = position - lower as f64;
        let a = 1.0 - b;
        std::array::from_fn(|curve| {
            a * self.values[lower][curve]
                + b * self.values[lower + 1][curve]
                + (a * a * a - a) * self.bends[lower][curve]
                + (b * b * b - b) * self.bends[lower + 1][curve]
        })
    }
}

/// Solves `bend[i - 1] + 4 bend[i] + bend[i + 1] = value[i - 1] - 2 value[i] + value[i + 1]`, with both end bends zero,
/// by Gaussian elimination of the tridiagonal system.
fn bends(values: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let inner = 1..values.len().saturating_sub(1);
    let mut bends = vec![[0.0; 3]; values.len()];
    let mut factors = vec![0.0; values.len()];
    for i in inner.clone() {
        // The row above, divided by its pivot, is taken away; the first row has none above.
        factors[i] = 1.0 / (4.0 - factors[i - 1]);
        bends[i] = std::array::from_fn(|curve| {
            let right = values[i - 1][curve] - 2.0 * values[i][curve] + values[i + 1][curve];
            (right - bends[i - 1][curve]) * factors[i]
        });
    }
    for i in inner.rev() {
        bends[i] = std::array::from_fn(|curve| bends[i][curve] - factors[i] * bends[i + 1][curve]);
    }
    bends
}
