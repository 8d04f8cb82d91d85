//! Separable least squares: sums of terms that are linear in their weights and not in a few parameters.
//!
//! Variable projection (Golub and Pereyra 1973, "The differentiation of pseudo-inverses and nonlinear least squares
//! problems whose variables separate"): at each value of the parameters the weights are solved for, so that only the
//! parameters are left to iterate on, by Levenberg-Marquardt. With Phi the terms' columns, w the solved weights and P
//! the projection onto the complement of Phi's range, the Jacobian is P (dPhi w) (Kaufman 1975, "A variable projection
//! method for solving separable nonlinear least squares problems").
//!
//! The weights of each channel sum to 1, those of the imaginary columns to 0: the last column of each group is
//! eliminated, which makes both exact.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn, U1};

/// Columns over the nonlinear parameters.
pub(super) trait Basis: Sync {
    /// Number of terms.
    fn count(&self) -> usize;

    /// Whether a second group of as many columns carries the weights' imaginary parts.
    fn has_complex_weights(&self) -> bool;

    /// The columns at these parameters: one per term, then one per term for the imaginary parts.
    fn columns(&self, parameters: &[f64]) -> DMatrix<f64>;

    /// For each parameter, the derivative of the columns times the weights (a column per channel).
    fn slopes(&self, parameters: &[f64], weights: &DMatrix<f64>) -> Vec<DMatrix<f64>>;
}

/// Mean square of the targets' unit that a weight of 1 costs: it keeps weights of near-equal terms from growing against
/// each other.
const RIDGE: f64 = 1e-10;

/// One problem at one value of its parameters.
pub(super) struct Separable<'a, B> {
    basis: &'a B,
    targets: &'a DMatrix<f64>,
    /// Factor of each row's residual, shared by the channels.
    row_scales: &'a DVector<f64>,
    parameters: DVector<f64>,
    solved: Solved,
}

struct Solved {
    weights: DMatrix<f64>,
    residuals: DMatrix<f64>,
    /// Orthonormal columns of the range of the scaled columns.
    range: DMatrix<f64>,
}

impl<'a, B: Basis> Separable<'a, B> {
    /// Solves for the weights at the given parameters.
    pub(super) fn new(
        basis: &'a B,
        targets: &'a DMatrix<f64>,
        row_scales: &'a DVector<f64>,
        parameters: DVector<f64>,
    ) -> Self {
        let solved = solve(basis, targets, row_scales, parameters.as_slice());
        Self { basis, targets, row_scales, parameters, solved }
    }

    /// Iterates on the parameters. `patience` bounds the evaluations to that many per parameter.
    pub(super) fn minimise(self, patience: usize) -> Self {
        let solver = LevenbergMarquardt::new().with_patience(patience).with_ftol(1e-9).with_xtol(1e-9);
        solver.minimize(self).0
    }

    /// The parameters.
    pub(super) fn parameters(&self) -> &DVector<f64> {
        &self.parameters
    }

    /// The weights: a row per column of the basis, a column per channel.
    pub(super) fn weights(&self) -> &DMatrix<f64> {
        &self.solved.weights
    }

    /// The sum of the squares of the scaled residuals.
    pub(super) fn sum_of_squares(&self) -> f64 {
        self.solved.residuals.norm_squared()
    }

    /// The residuals, model minus target, without the rows' factors: a row per row of the targets.
    pub(super) fn unscaled_residuals(&self) -> DMatrix<f64> {
        self.basis.columns(self.parameters.as_slice()) * &self.solved.weights - self.targets
    }
}

fn solve<B: Basis>(basis: &B, targets: &DMatrix<f64>, row_scales: &DVector<f64>, parameters: &[f64]) -> Solved {
    let (rows, count) = (targets.nrows(), basis.count());
    let groups = if basis.has_complex_weights() { 2 } else { 1 };
    let columns = scale_rows(basis.columns(parameters), row_scales);
    let free = groups * (count - 1);
    // Free column c of the reduced system is this column of the basis minus the last one of its group.
    let place = |c: usize| (c / (count - 1) * count + c % (count - 1), (c / (count - 1) + 1) * count - 1);
    let ridge = (RIDGE * row_scales.norm_squared()).sqrt();
    let mut reduced = DMatrix::zeros(rows + free, free);
    for c in 0..free {
        let (column, last) = place(c);
        reduced.view_mut((0, c), (rows, 1)).copy_from(&(columns.column(column) - columns.column(last)));
        reduced[(rows + c, c)] = ridge;
    }
    let mut wanted = DMatrix::zeros(rows + free, targets.ncols());
    let scaled_targets = scale_rows(targets.clone(), row_scales);
    for channel in 0..targets.ncols() {
        let difference = scaled_targets.column(channel) - columns.column(count - 1);
        wanted.view_mut((0, channel), (rows, 1)).copy_from(&difference);
    }
    let mut weights = DMatrix::zeros(groups * count, targets.ncols());
    weights.row_mut(count - 1).fill(1.0);
    if free == 0 {
        return Solved { weights, residuals: -wanted, range: DMatrix::zeros(rows, 0) };
    }
    let decomposition = reduced.clone().qr();
    let range = decomposition.q();
    let projected = range.tr_mul(&wanted);
    let triangle = decomposition.r();
    // The ridge keeps the triangle regular.
    let solution = triangle.solve_upper_triangular(&projected).unwrap_or_else(|| DMatrix::zeros(free, targets.ncols()));
    for c in 0..free {
        let (column, last) = place(c);
        for channel in 0..targets.ncols() {
            weights[(column, channel)] = solution[(c, channel)];
            weights[(last, channel)] -= solution[(c, channel)];
        }
    }
    let residuals = reduced * solution - wanted;
    Solved { weights, residuals, range }
}

fn scale_rows(mut matrix: DMatrix<f64>, scales: &DVector<f64>) -> DMatrix<f64> {
    for mut column in matrix.column_iter_mut() {
        column.component_mul_assign(scales);
    }
    matrix
}

impl<B: Basis> LeastSquaresProblem<f64, Dyn, Dyn> for Separable<'_, B> {
    type ResidualStorage = Owned<f64, Dyn, U1>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn, U1>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters = parameters.clone();
        self.solved = solve(self.basis, self.targets, self.row_scales, parameters.as_slice());
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_column_slice(self.solved.residuals.as_slice()))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let Solved { weights, range, residuals } = &self.solved;
        let (rows, channels) = (self.targets.nrows(), self.targets.ncols());
        let padded_rows = residuals.nrows();
        let slopes = self.basis.slopes(self.parameters.as_slice(), weights);
        let mut jacobian = DMatrix::zeros(padded_rows * channels, slopes.len());
        let in_rows = range.rows(0, rows);
        for (parameter, slope) in slopes.into_iter().enumerate() {
            let slope = scale_rows(slope, self.row_scales);
            let inside = range * in_rows.tr_mul(&slope);
            for channel in 0..channels {
                let mut part = jacobian.view_mut((channel * padded_rows, parameter), (padded_rows, 1));
                part.copy_from(&-inside.column(channel));
                let mut top = part.rows_mut(0, rows);
                top += slope.column(channel);
            }
        }
        Some(jacobian)
    }
}
