//! What of a shader is in half precision, and what that costs in errors.

use crate::inputs::ShadingQuantity;
use crate::points::spread;
use crate::scene;
use crate::shading::Shading;
use crate::statistics::Difference;
use pavo_optics::Precision;
use pavo_shade::Operations;
use serde::Serialize;

/// The section `precision` of the manifest.
#[derive(Serialize)]
pub struct PrecisionSection {
    /// What the scene asks for.
    pub asked: scene::Precision,
    /// The parts in half precision; none where the method has no such part.
    pub parts: Vec<&'static str>,
    /// Operations of one evaluation of the reflectance that are in half precision.
    pub operations: Operations,
    /// The languages in which they are; the others compute all in 32 bits.
    pub languages: Vec<&'static str>,
    /// The reflectance, in f64 with these parts rounded, against the same without rounding, over the scene's ranges.
    pub against_full: Option<Difference>,
}

impl PrecisionSection {
    /// The section of a surface, with the errors over this many points.
    pub fn of(shading: &Shading, count: usize) -> Self {
        let quantity = ShadingQuantity::Reflectance;
        let program = shading.program(quantity);
        let has_half = program.has_half();
        let against_full = has_half.then(|| {
            let points = spread(&shading.inputs(quantity), count, 1);
            let full = shading.with_precision(Precision::FULL).evaluate_each(quantity, &points);
            Difference::between(&shading.evaluate_each(quantity, &points), &full, 3)
        });
        let languages = pavo_emit::Language::ALL.into_iter();
        let with_half = languages.filter(|language| has_half && pavo_emit::Dialect::of(*language).half.is_some());
        Self {
            asked: shading.scene().emit.precision,
            parts: if has_half { shading.precision().parts() } else { Vec::new() },
            operations: program.operations_in_half(),
            languages: with_half.map(pavo_emit::Language::name).collect(),
            against_full,
        }
    }

    /// What the report says of it: nothing where all is in 32 bits as asked.
    pub fn report(&self) -> String {
        match (&self.against_full, self.asked) {
            (_, scene::Precision::Full) => String::new(),
            (None, scene::Precision::Half) => {
                "\nNothing is in half precision: this variant has no part that stands it.\n".to_owned()
            }
            (Some(difference), scene::Precision::Half) => format!(
                "\nIn half precision in {}: {}, {} operations. Against 32 bits: max {:.2e}, RMS {:.2e}.\n",
                self.languages.join(", "),
                self.parts.join(", "),
                self.operations.weight(),
                difference.max,
                difference.rms
            ),
        }
    }
}
