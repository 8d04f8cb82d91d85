//! Fits of spectral sensitivities.
