//! A film as a table over angle and thickness.

use pavo_optics::FilmTable;
use pavo_optics::table::table_reflectance;
use pavo_shade::Table;

/// A table of a function of the root of the cosine and of the thickness.
fn table(thicknesses: usize, function: impl Fn(f64, f64) -> [f64; 3]) -> FilmTable {
    let (angles, thickness_nm) = (9, [100.0, 500.0]);
    let points = FilmTable::points(angles, thicknesses, thickness_nm);
    let rows = points.iter().map(|[cosine, thickness]| function(cosine.sqrt(), *thickness)).collect();
    FilmTable { angles, thicknesses, thickness_nm, colors: Table::new("colors", "", rows) }
}

#[test]
fn what_is_linear_between_the_entries_is_read_exactly() {
    for thicknesses in [1, 2, 17] {
        let depends = if thicknesses == 1 { 0.0 } else { 1e-3 };
        let function = |root: f64, thickness: f64| [root, 0.5 - root, depends * thickness * root];
        let table = table(thicknesses, function);
        for cosine in [0.0_f64, 1e-9, 0.01, 0.3, 0.62, 1.0] {
            for thickness in [100.0, 101.0, 333.3, 499.0, 500.0] {
                let found = table_reflectance::<f64>(&table, cosine, thickness).to_array();
                for (found, expected) in found.into_iter().zip(function(cosine.sqrt(), thickness)) {
                    assert!((found - expected).abs() < 1e-12, "{thicknesses} at {cosine}, {thickness}: {found}");
                }
            }
        }
    }
}

#[test]
fn beyond_its_range_the_table_is_held_at_its_edge() {
    let table = table(5, |root, thickness| [root, thickness, 1.0]);
    for (cosine, thickness, at) in [(-0.5, 50.0, [0.0, 100.0]), (1.0, 900.0, [1.0, 500.0]), (0.25, -3.0, [0.5, 100.0])]
    {
        let found = table_reflectance::<f64>(&table, cosine, thickness);
        assert!((found.x - at[0]).abs() < 1e-12 && (found.y - at[1]).abs() < 1e-9, "{cosine}, {thickness}: {found}");
    }
}
