//! The built-in materials: one line each.

use super::MaterialKind;
use crate::dispersion::{self, DispersionFormula, LorentzDrude};

/// A built-in material.
pub(super) struct BuiltIn {
    /// The name that users give.
    pub(super) name: &'static str,
    pub(super) kind: MaterialKind,
    /// The publication.
    pub(super) source: &'static str,
    pub(super) data: BuiltInData,
}

/// Where a built-in material's index comes from.
pub(super) enum BuiltInData {
    /// Comma-separated text, compiled in.
    Table(&'static str),
    Formula(&'static DispersionFormula),
    LorentzDrude(&'static LorentzDrude),
}

const JOHNSON_1972: &str = "Johnson and Christy 1972";
const JOHNSON_1974: &str = "Johnson and Christy 1974";
const LEERTOUWER: &str = "Leertouwer, Wilts and Stavenga 2011";
const RAKIC: &str = "Rakic et al. 1998, Lorentz-Drude model";

/// Every built-in material, sorted by name. A metal's plain name stands for measurements where Johnson and Christy made
/// them, and for the Lorentz-Drude model of Rakic et al. otherwise.
pub(super) const BUILT_INS: [BuiltIn; 31] = [
    table("Ag", MaterialKind::Metal, JOHNSON_1972, include_str!("../../data/nk_ag.csv")),
    lorentz_drude("Ag-Rakic", &dispersion::SILVER),
    lorentz_drude("Al", &dispersion::ALUMINIUM),
    formula("Al2O3", "Malitson and Dodge 1972, ordinary ray of sapphire", &dispersion::SAPPHIRE),
    table("Au", MaterialKind::Metal, JOHNSON_1972, include_str!("../../data/nk_au.csv")),
    lorentz_drude("Au-Rakic", &dispersion::GOLD),
    formula("BK7", "SCHOTT optical glass catalogue, N-BK7", &dispersion::N_BK7),
    lorentz_drude("Be", &dispersion::BERYLLIUM),
    table("Cr", MaterialKind::Metal, JOHNSON_1974, include_str!("../../data/nk_cr.csv")),
    lorentz_drude("Cr-Rakic", &dispersion::CHROMIUM),
    table("Cu", MaterialKind::Metal, JOHNSON_1972, include_str!("../../data/nk_cu.csv")),
    lorentz_drude("Cu-Rakic", &dispersion::COPPER),
    table("Fe", MaterialKind::Metal, JOHNSON_1974, include_str!("../../data/nk_fe.csv")),
    formula("MgF2", "Dodge 1984, ordinary ray", &dispersion::MAGNESIUM_FLUORIDE),
    table("Ni", MaterialKind::Metal, JOHNSON_1974, include_str!("../../data/nk_ni.csv")),
    lorentz_drude("Ni-Rakic", &dispersion::NICKEL),
    formula("PMMA", "Sultanova, Kasarova and Nikolov 2009", &dispersion::PMMA),
    table("Pd", MaterialKind::Metal, JOHNSON_1974, include_str!("../../data/nk_pd.csv")),
    lorentz_drude("Pd-Rakic", &dispersion::PALLADIUM),
    lorentz_drude("Pt", &dispersion::PLATINUM),
    table("Si", MaterialKind::Semiconductor, "Aspnes and Studna 1983", include_str!("../../data/nk_si.csv")),
    formula("Si3N4", "Luke et al. 2015", &dispersion::SILICON_NITRIDE),
    formula("SiO2", "Malitson 1965, fused silica", &dispersion::FUSED_SILICA),
    table("Ti", MaterialKind::Metal, JOHNSON_1974, include_str!("../../data/nk_ti.csv")),
    lorentz_drude("Ti-Rakic", &dispersion::TITANIUM),
    formula("TiO2", "Devore 1951, ordinary ray of rutile", &dispersion::RUTILE),
    lorentz_drude("W", &dispersion::TUNGSTEN),
    formula("ZnS", "Debenham 1984, cubic", &dispersion::ZINC_SULFIDE),
    formula("chitin", LEERTOUWER, &dispersion::CHITIN),
    formula("keratin", LEERTOUWER, &dispersion::KERATIN),
    formula("water", "Daimon and Masumura 2007, 20 degrees Celsius", &dispersion::WATER),
];

/// The names of the built-in materials that are dielectrics, or of those that are not, in their order. `COUNT` must be
/// [`count_of`] the same.
pub(super) const fn names_of<const COUNT: usize>(dielectrics: bool) -> [&'static str; COUNT] {
    let mut names = [""; COUNT];
    let (mut from, mut to) = (0, 0);
    while from < BUILT_INS.len() {
        if is_dielectric(from) == dielectrics {
            names[to] = BUILT_INS[from].name;
            to += 1;
        }
        from += 1;
    }
    names
}

/// How many built-in materials are dielectrics, or are not.
pub(super) const fn count_of(dielectrics: bool) -> usize {
    let (mut index, mut count) = (0, 0);
    while index < BUILT_INS.len() {
        if is_dielectric(index) == dielectrics {
            count += 1;
        }
        index += 1;
    }
    count
}

/// The names of every built-in material.
pub(super) const fn names() -> [&'static str; BUILT_INS.len()] {
    let mut names = [""; BUILT_INS.len()];
    let mut index = 0;
    while index < BUILT_INS.len() {
        names[index] = BUILT_INS[index].name;
        index += 1;
    }
    names
}

const fn is_dielectric(index: usize) -> bool {
    matches!(BUILT_INS[index].kind, MaterialKind::Dielectric)
}

const fn table(name: &'static str, kind: MaterialKind, source: &'static str, text: &'static str) -> BuiltIn {
    BuiltIn { name, kind, source, data: BuiltInData::Table(text) }
}

const fn formula(name: &'static str, source: &'static str, formula: &'static DispersionFormula) -> BuiltIn {
    BuiltIn { name, kind: MaterialKind::Dielectric, source, data: BuiltInData::Formula(formula) }
}

const fn lorentz_drude(name: &'static str, model: &'static LorentzDrude) -> BuiltIn {
    BuiltIn { name, kind: MaterialKind::Metal, source: RAKIC, data: BuiltInData::LorentzDrude(model) }
}
