//! What is fitted: a form, with its number of waves and the degrees of its polynomials.

/// A form of the reflectance; `pavo_optics::fitted` has the formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// The angle alone: for a film of one thickness.
    AngleOnly,
    /// The first order of interference: for low contrast.
    FirstOrder,
    /// All orders by one kernel: for low contrast.
    Kernel,
    /// All orders by a kernel whose higher orders are damped more: for dielectrics.
    DampedKernel,
    /// The same with a first order of its own: for dielectrics of high contrast.
    CorrectedKernel,
    /// Three orders with phases: for bases that absorb.
    ThreeOrders,
}

impl Form {
    /// All forms.
    pub const ALL: [Form; 6] =
        [Form::AngleOnly, Form::FirstOrder, Form::Kernel, Form::DampedKernel, Form::CorrectedKernel, Form::ThreeOrders];

    /// The form in words.
    pub fn name(self) -> &'static str {
        match self {
            Form::AngleOnly => "angle-only",
            Form::FirstOrder => "first-order",
            Form::Kernel => "kernel",
            Form::DampedKernel => "damped-kernel",
            Form::CorrectedKernel => "corrected-kernel",
            Form::ThreeOrders => "three-orders",
        }
    }
}

/// A form with its sizes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    pub form: Form,
    /// How many waves.
    pub nodes: usize,
    /// The degree of the mean.
    pub mean_degree: usize,
    /// Whether each channel has a mean of its own.
    pub mean_per_channel: bool,
    /// The degrees of the other polynomials.
    pub degrees: Vec<usize>,
}

impl Plan {
    /// The sizes that serve a form with so many waves: few waves leave an error that higher degrees cannot reduce.
    /// `coloured` is a base or a film whose index depends on the wavelength.
    pub fn new(form: Form, nodes: usize, coloured: bool) -> Self {
        let fine = nodes >= 4;
        let (mean_degree, degrees) = match form {
            Form::AngleOnly => (5, vec![]),
            Form::FirstOrder => (3, vec![3]),
            Form::Kernel if !fine => (3, vec![2, 2]),
            Form::Kernel => (4, vec![3, 3]),
            Form::DampedKernel => (4, vec![4, 3]),
            Form::CorrectedKernel => (4, vec![4, 3, 3]),
            Form::ThreeOrders => (3, vec![3, 3, 2, 3, 3, 2]),
        };
        let nodes = if form == Form::AngleOnly { 0 } else { nodes };
        let mean_per_channel = match form {
            Form::AngleOnly => true,
            _ => coloured,
        };
        Self { form, nodes, mean_degree, mean_per_channel, degrees }
    }

    /// Whether a round trip has a damping of its own.
    pub fn has_damping(&self) -> bool {
        matches!(self.form, Form::DampedKernel | Form::CorrectedKernel)
    }

    /// Whether the waves have phases of their own: an absorbing base turns them, and a few waves under a sharp kernel fit
    /// better with them; more no longer do.
    pub fn has_phases(&self) -> bool {
        match self.form {
            Form::ThreeOrders => true,
            Form::DampedKernel => self.nodes <= 4,
            _ => false,
        }
    }

    /// The polynomial that must stay within -1 and 1, by its place among the others.
    pub fn bounded(&self) -> Option<usize> {
        match self.form {
            Form::Kernel | Form::DampedKernel | Form::CorrectedKernel => Some(1),
            _ => None,
        }
    }

    /// Roughly what an evaluation costs: multiply-and-adds and the like count 1; roots, reciprocals, exponentials, sines and
    /// cosines 4.
    pub fn cost(&self) -> usize {
        let mean = self.mean_degree * if self.mean_per_channel { 3 } else { 1 };
        let polynomials = mean + self.degrees.iter().sum::<usize>();
        // y, D and the logarithm of the window.
        let angle = 1 + 4;
        let path = 3 + 4 + 2;
        // Phase, cosine, three weighted sums.
        let node = 1 + 4 + 3;
        match self.form {
            Form::AngleOnly => angle + polynomials,
            Form::FirstOrder => angle + path + polynomials + 4 + 1 + 3 + node * self.nodes,
            Form::Kernel => angle + path + polynomials + 4 + 1 + 1 + 4 + 1 + 3 + (node + 1 + 4) * self.nodes,
            Form::DampedKernel => angle + path + polynomials + 11 + 4 + 3 + (node + 1 + 1 + 4 + 1) * self.nodes,
            Form::CorrectedKernel => angle + path + polynomials + 11 + 5 + (node + 1 + 1 + 4 + 1 + 2) * self.nodes,
            Form::ThreeOrders => angle + path + polynomials + 4 + 4 + 9 + 3 + (node + 4 + 7) * self.nodes,
        }
    }
}
