//! The formulas of dielectrics, each with its publication and the range that was measured.
//!
//! Indices are relative to air, at the wavelength in air, except those of water, which are relative to a vacuum: that
//! makes 3e-4 of an index. Each is for room temperature, 19 to 24 degrees Celsius.

use super::{DispersionFormula, SumsTo, Term};

const fn squared_index(measured_nm: (f64, f64), constant: f64, terms: &'static [Term]) -> DispersionFormula {
    DispersionFormula { measured_nm, sums_to: SumsTo::SquaredIndex, constant, terms }
}

/// Cauchy's n = a + b / lambda^2, the term with b in um^2.
const fn cauchy(measured_nm: (f64, f64), a: f64, terms: &'static [Term]) -> DispersionFormula {
    DispersionFormula { measured_nm, sums_to: SumsTo::Index, constant: a, terms }
}

/// Water at 20 degrees Celsius: M. Daimon and A. Masumura, "Measurement of the refractive index of distilled water from
/// the near-infrared region to the ultraviolet region", Appl. Opt. 46, 3811 (2007).
pub(crate) const WATER: DispersionFormula = squared_index(
    (182.0, 1129.0),
    1.0,
    &[
        Term::sellmeier_squared(5.684_027_565e-1, 5.101_829_712e-3),
        Term::sellmeier_squared(1.726_177_391e-1, 1.821_153_936e-2),
        Term::sellmeier_squared(2.086_189_578e-2, 2.620_722_293e-2),
        Term::sellmeier_squared(1.130_748_688e-1, 1.069_792_721e1),
    ],
);

/// Fused silica: I. H. Malitson, "Interspecimen comparison of the refractive index of fused silica", J. Opt. Soc. Am. 55,
/// 1205 (1965).
pub(crate) const FUSED_SILICA: DispersionFormula = squared_index(
    (210.0, 3710.0),
    1.0,
    &[
        Term::sellmeier(0.696_166_3, 0.068_404_3),
        Term::sellmeier(0.407_942_6, 0.116_241_4),
        Term::sellmeier(0.897_479_4, 9.896_161),
    ],
);

/// Borosilicate crown glass: SCHOTT optical glass catalogue, N-BK7.
pub(crate) const N_BK7: DispersionFormula = squared_index(
    (300.0, 2500.0),
    1.0,
    &[
        Term::sellmeier_squared(1.039_612_12, 0.006_000_698_67),
        Term::sellmeier_squared(0.231_792_344, 0.020_017_914_4),
        Term::sellmeier_squared(1.010_469_45, 103.560_653),
    ],
);

/// Rutile, the ordinary ray: J. R. DeVore, "Refractive indices of rutile and sphalerite", J. Opt. Soc. Am. 41, 416 (1951).
pub(crate) const RUTILE: DispersionFormula = squared_index((430.0, 1530.0), 5.913, &[Term::pole(0.2441, 0.0803)]);

/// Magnesium fluoride, the ordinary ray: M. J. Dodge, "Refractive properties of magnesium fluoride", Appl. Opt. 23, 1980
/// (1984).
pub(crate) const MAGNESIUM_FLUORIDE: DispersionFormula = squared_index(
    (200.0, 7000.0),
    1.0,
    &[
        Term::sellmeier(0.487_551_08, 0.043_384_08),
        Term::sellmeier(0.398_750_31, 0.094_614_42),
        Term::sellmeier(2.312_035_3, 23.793_604),
    ],
);

/// Synthetic sapphire, the ordinary ray: I. H. Malitson and M. J. Dodge, "Refractive index and birefringence of synthetic
/// sapphire", J. Opt. Soc. Am. 62, 1405 (1972).
pub(crate) const SAPPHIRE: DispersionFormula = squared_index(
    (200.0, 5000.0),
    1.0,
    &[
        Term::sellmeier(1.431_349_3, 0.072_663_1),
        Term::sellmeier(0.650_547_13, 0.119_324_2),
        Term::sellmeier(5.341_402_1, 18.028_251),
    ],
);

/// Poly(methyl methacrylate): the measurements of N. Sultanova, S. Kasarova, and I. Nikolov, "Dispersion properties of
/// optical polymers", Acta Physica Polonica A 116, 585 (2009), by the one-term fit of M. N. Polyanskiy's database of optical
/// constants. One resonance, so that it may be continued; samples differ by 2e-3.
pub(crate) const PMMA: DispersionFormula =
    squared_index((436.8, 1052.0), 1.0, &[Term::sellmeier_squared(1.1819, 0.011_313)]);

/// Stoichiometric silicon nitride: K. Luke, Y. Okawachi, M. R. E. Lamont, A. L. Gaeta, and M. Lipson, "Broadband mid-infrared
/// frequency comb generation in a Si3N4 microresonator", Opt. Lett. 40, 4823 (2015). Films differ by several hundredths.
pub(crate) const SILICON_NITRIDE: DispersionFormula =
    squared_index((310.0, 5504.0), 1.0, &[Term::sellmeier(3.0249, 0.135_340_6), Term::sellmeier(40_314.0, 1239.842)]);

/// Cubic zinc sulfide: M. Debenham, "Refractive indices of zinc sulfide in the 0.405-13-um wavelength range", Appl. Opt. 23,
/// 2238 (1984).
pub(crate) const ZINC_SULFIDE: DispersionFormula = squared_index(
    (405.0, 13_000.0),
    8.393,
    &[Term::pole(0.143_83, 0.2421 * 0.2421), Term::pole(4430.99, 36.71 * 36.71)],
);

/// The chitin of butterfly scales (Graphium sarpedon): H. L. Leertouwer, B. D. Wilts, and D. G. Stavenga, "Refractive index
/// and dispersion of butterfly chitin and bird keratin measured by polarizing interference microscopy", Opt. Express 19,
/// 24061 (2011). The range is that of the indices printed with the formula.
pub(crate) const CHITIN: DispersionFormula = cauchy((400.0, 600.0), 1.517, &[Term::pole(8.80e-3, 0.0)]);

/// The keratin of feather barbules (Anas anas domestica): the same publication as [`CHITIN`].
pub(crate) const KERATIN: DispersionFormula = cauchy((400.0, 600.0), 1.532, &[Term::pole(5.89e-3, 0.0)]);
