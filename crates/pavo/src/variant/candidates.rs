//! Variants to choose from where nothing says which.

use super::{Fit, FittedForm, FresnelForm, Variant};
use crate::scene::{Base, Scene};

/// The error that a fit to a scene keeps to where nothing says another.
pub(super) const FITTED_RMS_ERROR: f64 = 6e-3;

impl Variant {
    /// Variants to choose from for a scene: [`Variant::candidates`], or where there is no film, what a bare surface has.
    pub fn candidates_for(scene: &Scene) -> Vec<Variant> {
        if scene.film.is_some() {
            return Self::candidates();
        }
        let exact = Variant::Fresnel { form: FresnelForm::Exact };
        match scene.base {
            _ if scene.has_schlick_base() => vec![Variant::Fresnel { form: FresnelForm::Schlick }, exact],
            Base::Dielectric { .. } | Base::Conductor { .. } | Base::F0 { .. } | Base::Metalness => vec![exact],
            Base::Metal { .. } | Base::Table { .. } => {
                [8, 16, 32, 81].map(|count| Variant::Spectral { count }).to_vec()
            }
        }
    }

    /// Variants to choose from where nothing says which. Not every one can be made for every scene.
    pub fn candidates() -> Vec<Variant> {
        let belcour_barla = [1, 2, 3, 4, 6, 8].map(|order| Variant::Series { order, fit: Fit::XyzGauss });
        let fitted = [
            (2, Fit::SharedGaussians(3)),
            (3, Fit::SharedGaussians(4)),
            (4, Fit::SharedGaussians(5)),
            (3, Fit::RgbGaussians(3)),
            (3, Fit::XyzGaussians(3)),
            (3, Fit::Exact),
        ];
        let fitted = fitted.map(|(order, fit)| Variant::Series { order, fit });
        let poles = [4, 5, 6, 8].map(|count| Variant::Poles { count });
        let windowed = [(4, None), (6, None), (8, None), (6, Some(2)), (6, Some(3))];
        let windowed = windowed.map(|(count, groups)| Variant::Windowed { count, groups });
        let cosines = [(4, 1), (6, 1), (6, 2)].map(|(count, order)| Variant::Cosines { count, order });
        let nodes = [6, 8, 10, 16].map(|count| Variant::Nodes { count });
        let spectral = [16, 32, 81, 161].map(|count| Variant::Spectral { count });
        let baked = [(4, 0), (6, 0), (8, 0), (10, 0), (12, 0), (5, 4)];
        let baked = baked.map(|(degree, denominator)| Variant::Baked { degree, denominator });
        let tables = [(32, 1), (32, 64), (32, 128)].map(|(angles, thicknesses)| Variant::Table { angles, thicknesses });
        let scene_fits = [
            (FittedForm::AngleOnly, 1),
            (FittedForm::FirstOrder, 3),
            (FittedForm::Kernel, 3),
            (FittedForm::Kernel, 4),
            (FittedForm::Kernel, 5),
            (FittedForm::DampedKernel, 4),
            (FittedForm::DampedKernel, 5),
            (FittedForm::DampedKernel, 6),
            (FittedForm::CorrectedKernel, 6),
            (FittedForm::ThreeOrders, 4),
        ];
        let scene_fits =
            scene_fits.map(|(form, count)| Variant::Fitted { form: Some(form), count, rms_error: FITTED_RMS_ERROR });
        [&belcour_barla[..], &fitted, &cosines, &windowed, &poles, &nodes, &baked, &tables, &scene_fits, &spectral]
            .concat()
    }
}
