//! Fits as the methods of `pavo-optics`, in its units: radians per nm and nm.

use std::f64::consts::PI;

use pavo_optics::{Method, Pole, SpectralNode, Window};
use pavo_spectra::fits::{FitFamily, FitTerm, SensitivityFit};

const NM_PER_UM: f64 = 1000.0;

/// Radians per nm of a wave number in 1/um.
pub(crate) fn angular(wave_number_per_um: f64) -> f64 {
    2.0 * PI * wave_number_per_um / NM_PER_UM
}

/// The window of a fit of windowed nodes.
pub(crate) fn window(fit: &SensitivityFit) -> Window {
    let wave_number = |term: usize| fit.terms.get(term).map_or(0.0, |term| term.wave_number[0]);
    let last = fit.terms.len().saturating_sub(1);
    Window {
        first: angular(wave_number(0)),
        step: angular((wave_number(last) - wave_number(0)) / last.max(1) as f64),
        width_nm: fit.window_um.unwrap_or(f64::INFINITY) * NM_PER_UM,
        weights: fit.terms.iter().map(|term| term.weight_re).collect(),
    }
}

/// The method that a fit gives in closed form; `None` for the families that are used as a series of orders (Gaussians),
/// whose error depends on how many are taken.
pub(crate) fn closed_form(fit: &SensitivityFit) -> Option<Method> {
    match fit.family {
        FitFamily::Poles => {
            let pole = |term: &FitTerm| Pole {
                angular_wave_number: angular(term.wave_number[0]),
                decay: term.decay[0] / NM_PER_UM,
                weight_re: term.weight_re,
                weight_im: term.weight_im,
            };
            Some(Method::Poles { poles: fit.terms.iter().map(pole).collect() })
        }
        FitFamily::WindowedNodes => Some(Method::Windowed { window: window(fit) }),
        FitFamily::Nodes => {
            let node = |term: &FitTerm| SpectralNode {
                wavelength_nm: NM_PER_UM / term.wave_number[0],
                weight: term.weight_re,
                base: None,
                film: None,
            };
            Some(Method::Spectral { nodes: fit.terms.iter().map(node).collect() })
        }
        _ => None,
    }
}
