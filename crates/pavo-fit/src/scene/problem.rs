//! The least squares problem of a form over samples, as the solver takes it.

use super::layout::Layout;
use super::model::{Sample, evaluate, is_admissible};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned, U1};

/// The residual of each channel of each sample where the parameters make no sense: no step leads there.
const INADMISSIBLE: f64 = 1e3;

/// How far a fit came.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub parameters: Vec<f64>,
    /// Root of the mean square over the samples and channels.
    pub rms: f64,
}

struct Problem<'a> {
    layout: &'a Layout,
    samples: &'a [Sample],
    parameters: DVector<f64>,
}

impl Problem<'_> {
    fn residuals(&self) -> DVector<f64> {
        let parameters = self.parameters.as_slice();
        if !is_admissible(self.layout, parameters) {
            return DVector::from_element(3 * self.samples.len(), INADMISSIBLE);
        }
        let residuals = self.samples.iter().flat_map(|sample| {
            let found = evaluate(self.layout, parameters, sample, None);
            core::array::from_fn::<f64, 3, _>(|channel| found[channel] - sample.reflectance[channel])
        });
        DVector::from_iterator(3 * self.samples.len(), residuals)
    }

    fn jacobian(&self) -> DMatrix<f64> {
        // By sample first: its derivatives lie together.
        let mut transposed = DMatrix::zeros(self.layout.count, 3 * self.samples.len());
        for (index, sample) in self.samples.iter().enumerate() {
            let mut derivative = |channel: usize, parameter: usize, value: f64| {
                transposed[(parameter, 3 * index + channel)] = value;
            };
            evaluate(self.layout, self.parameters.as_slice(), sample, Some(&mut derivative));
        }
        transposed.transpose()
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn, U1>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn, U1>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters.copy_from(parameters);
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.residuals())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.jacobian())
    }
}

/// Improves parameters by Levenberg-Marquardt, with at most `patience` evaluations for each parameter.
pub(super) fn improve(layout: &Layout, samples: &[Sample], parameters: Vec<f64>, patience: usize) -> Solution {
    let problem = Problem { layout, samples, parameters: DVector::from_vec(parameters) };
    let solver = LevenbergMarquardt::new().with_patience(patience).with_ftol(1e-5).with_xtol(1e-9);
    let (problem, report) = solver.minimize(problem);
    let rms = (2.0 * report.objective_function / (3 * samples.len()) as f64).sqrt();
    Solution {
        rms: if rms.is_finite() { rms } else { f64::INFINITY },
        parameters: problem.parameters.as_slice().to_vec(),
    }
}

/// Sets the parameters in which the form is linear, the mean and the weights, to their best values for the others.
pub(super) fn solve_linear_part(layout: &Layout, samples: &[Sample], parameters: Vec<f64>) -> Vec<f64> {
    let problem = Problem { layout, samples, parameters: DVector::from_vec(parameters) };
    let residuals = problem.residuals();
    let places: Vec<usize> = layout.mean.clone().chain(layout.weights.clone()).collect();
    let columns = problem.jacobian().select_columns(&places);
    let mut normal = columns.tr_mul(&columns);
    let ridge = 1e-10 * normal.trace() / places.len() as f64;
    for index in 0..places.len() {
        normal[(index, index)] += ridge;
    }
    let mut parameters = problem.parameters.as_slice().to_vec();
    if let Some(factored) = normal.cholesky() {
        let step = factored.solve(&columns.tr_mul(&residuals));
        for (&place, change) in places.iter().zip(step.iter()) {
            parameters[place] -= change;
        }
    }
    parameters
}
