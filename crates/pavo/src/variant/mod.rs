//! The variant: by which method, and with which options, a colour is computed.

mod candidates;
mod grammar;

#[cfg(test)]
mod tests;

#[cfg(feature = "cli")]
pub(crate) use grammar::Excess;
pub use grammar::VariantError;

use std::fmt;

/// The sensitivities that the series uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// `xyz-gauss`: the four Gaussians over X, Y and Z of Belcour and Barla 2017.
    XyzGauss,
    /// `xyz-gauss-K`: K Gaussians for each of X, Y and Z.
    XyzGaussians(usize),
    /// `rgb-gauss-K`: K Gaussians for each output channel.
    RgbGaussians(usize),
    /// `shared-gauss-K`: K Gaussians that the channels share.
    SharedGaussians(usize),
    /// `exact`: their exact transform, from tables.
    Exact,
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fit::XyzGauss => write!(f, "xyz-gauss"),
            Fit::XyzGaussians(count) => write!(f, "xyz-gauss-{count}"),
            Fit::RgbGaussians(count) => write!(f, "rgb-gauss-{count}"),
            Fit::SharedGaussians(count) => write!(f, "shared-gauss-{count}"),
            Fit::Exact => write!(f, "exact"),
        }
    }
}

/// The form of a fit to one scene's reflectance; `pavo_optics::fitted` has the formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FittedForm {
    /// `angle-only`: for a film of one thickness.
    AngleOnly,
    /// `first-order` (or `m1`): the first order of interference, for low contrast.
    FirstOrder,
    /// `kernel` (or `ks`): all orders by one kernel, for low contrast.
    Kernel,
    /// `damped-kernel` (or `k`): all orders, the higher ones damped more, for dielectrics.
    DampedKernel,
    /// `corrected-kernel` (or `l2`): the same with a first order of its own, for dielectrics of high contrast.
    CorrectedKernel,
    /// `three-orders` (or `cm3`): three orders with phases, for bases that absorb.
    ThreeOrders,
}

impl FittedForm {
    /// All forms.
    pub const ALL: [FittedForm; 6] = [
        FittedForm::AngleOnly,
        FittedForm::FirstOrder,
        FittedForm::Kernel,
        FittedForm::DampedKernel,
        FittedForm::CorrectedKernel,
        FittedForm::ThreeOrders,
    ];

    /// The name in a variant.
    pub fn name(self) -> &'static str {
        match self {
            FittedForm::AngleOnly => "angle-only",
            FittedForm::FirstOrder => "first-order",
            FittedForm::Kernel => "kernel",
            FittedForm::DampedKernel => "damped-kernel",
            FittedForm::CorrectedKernel => "corrected-kernel",
            FittedForm::ThreeOrders => "three-orders",
        }
    }

    /// The short name that is read too.
    fn short_name(self) -> &'static str {
        match self {
            FittedForm::AngleOnly => "a",
            FittedForm::FirstOrder => "m1",
            FittedForm::Kernel => "ks",
            FittedForm::DampedKernel => "k",
            FittedForm::CorrectedKernel => "l2",
            FittedForm::ThreeOrders => "cm3",
        }
    }

    /// How many waves serve the form where nothing says how many.
    fn default_count(self) -> usize {
        match self {
            FittedForm::AngleOnly => 1,
            FittedForm::FirstOrder | FittedForm::Kernel => 3,
            FittedForm::DampedKernel | FittedForm::ThreeOrders => 4,
            FittedForm::CorrectedKernel => 6,
        }
    }
}

/// The reflectance of a surface without a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FresnelForm {
    /// `schlick`: Schlick's approximation from the specular colour, as engines have it.
    Schlick,
    /// `exact`: the Fresnel equations.
    Exact,
}

/// A method with its options, written `family:option=value,option=value`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Variant {
    /// `series:m=M,fit=F`: the series over orders of interference, up to order M.
    Series {
        /// The highest order.
        order: usize,
        /// The sensitivities.
        fit: Fit,
    },
    /// `poles:k=K`: all orders in closed form, with the sensitivities as K complex exponentials.
    Poles {
        /// How many poles.
        count: usize,
    },
    /// `windowed:k=K,groups=G`: all orders as a Poisson kernel, with the sensitivities as K wave numbers under a window.
    Windowed {
        /// How many wave numbers.
        count: usize,
        /// Where an index depends on the wavelength: how many groups of wave numbers have one of their own. Without it,
        /// each channel has.
        groups: Option<usize>,
    },
    /// `cosines:k=K,m=M`: the series up to order M, with the sensitivities as K wave numbers under a window.
    Cosines {
        /// How many wave numbers.
        count: usize,
        /// The highest order.
        order: usize,
    },
    /// `nodes:n=N`: the exact reflectance at N wavelengths whose weights are fitted over the scene's range.
    Nodes {
        /// How many wavelengths.
        count: usize,
    },
    /// `baked:degree=N,denominator=M`: a polynomial of degree N over the angle, or a ratio of two, for a uniform film.
    Baked {
        /// The degree.
        degree: usize,
        /// The degree of the denominator; 0 for a polynomial.
        denominator: usize,
    },
    /// `table:WxH`: a table over W angles and H thicknesses, for a film of fixed indices.
    Table {
        /// How many angles.
        angles: usize,
        /// How many thicknesses.
        thicknesses: usize,
    },
    /// `fitted:form=F,k=K,rms=E`: a form fitted to the scene's own reflectance, for a film of fixed indices.
    Fitted {
        /// The form; without one, the cheapest that keeps to the error.
        form: Option<FittedForm>,
        /// How many waves; where the form is left open, how many at most.
        count: usize,
        /// The root of the mean square error that it must keep to.
        rms_error: f64,
    },
    /// `fresnel:form=F`: a surface without a film.
    Fresnel {
        /// The form.
        form: FresnelForm,
    },
    /// `spectral:n=N`: the exact reflectance at N wavelengths from 380 to 780 nm, equally spaced.
    Spectral {
        /// How many wavelengths.
        count: usize,
    },
}

impl Variant {
    /// Whether the emitted code reads a table of many constants.
    pub fn reads_tables(&self) -> bool {
        matches!(self, Variant::Table { .. } | Variant::Series { fit: Fit::Exact, .. })
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Variant::Series { order, fit } => write!(f, "series:m={order},fit={fit}"),
            Variant::Poles { count } => write!(f, "poles:k={count}"),
            Variant::Windowed { count, groups: None } => write!(f, "windowed:k={count}"),
            Variant::Windowed { count, groups: Some(groups) } => write!(f, "windowed:k={count},groups={groups}"),
            Variant::Cosines { count, order } => write!(f, "cosines:k={count},m={order}"),
            Variant::Nodes { count } => write!(f, "nodes:n={count}"),
            Variant::Baked { degree, denominator: 0 } => write!(f, "baked:degree={degree}"),
            Variant::Baked { degree, denominator } => write!(f, "baked:degree={degree},denominator={denominator}"),
            Variant::Table { angles, thicknesses } => write!(f, "table:{angles}x{thicknesses}"),
            Variant::Fitted { form: None, count, rms_error } => write!(f, "fitted:k={count},rms={rms_error}"),
            Variant::Fitted { form: Some(form), count, rms_error } => {
                write!(f, "fitted:form={},k={count},rms={rms_error}", form.name())
            }
            Variant::Fresnel { form: FresnelForm::Schlick } => write!(f, "fresnel:form=schlick"),
            Variant::Fresnel { form: FresnelForm::Exact } => write!(f, "fresnel:form=exact"),
            Variant::Spectral { count } => write!(f, "spectral:n={count}"),
        }
    }
}
