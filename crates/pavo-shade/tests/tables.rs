//! Tables of constants: read alike on numbers and in the graph, and kept only where they are read.

use pavo_shade::{Expr, Graph, Input, Operations, Rate, Real, Scalar, Table, Vector, interpret, shade};

fn ramp(name: &str, rows: usize) -> Table {
    Table::new(name, "Squares, without a unit.", (0..rows).map(|row| [row as f64, (row * row) as f64, 1.0]).collect())
}

/// The row at `x`, between two rows.
#[shade]
fn between<S: Scalar>(
    /// The table.
    #[constant]
    table: &Table,
    /// The place, [0, 7].
    x: S,
) -> S::Vec3 {
    let row = x.floor().clamp(0.0, 6.0);
    S::Vec3::mix(S::fetch(table, row), S::fetch(table, row + 1.0), S::Vec3::splat(x - row))
}

#[test]
fn the_graph_reads_what_numbers_read() {
    let table = ramp("squares", 8);
    let graph = Graph::new();
    let x = graph.input(Input::scalar("x", "", 0.0, 7.0, Rate::Pixel));
    graph.output("row", between(&table, x));
    let program = graph.program();
    for x in [0.0, 0.25, 3.0, 6.5, 7.0] {
        let expected = between::<f64>(&table, x).to_array();
        assert_eq!(interpret::evaluate(&program, &[x]), [expected], "at {x}");
        assert_eq!(between::<f32>(&table, x as f32).to_array().map(f64::from), expected, "in f32 at {x}");
    }
    assert_eq!(program.operations().fetches, 2);
}

#[test]
fn an_index_beyond_the_rows_is_held_at_the_ends() {
    let table = ramp("squares", 4);
    for (index, row) in [(-1.0, 0.0), (f64::NAN, 0.0), (3.0, 3.0), (1e30, 3.0)] {
        assert_eq!(f64::fetch(&table, index).x, row, "at {index}");
    }
}

#[test]
fn a_table_is_kept_once_and_only_where_it_is_read() {
    let (first, second) = (ramp("first", 8), ramp("second", 9));
    let graph = Graph::new();
    let x = graph.input(Input::scalar("x", "", 0.0, 7.0, Rate::Pixel));
    let unread = between(&first, x);
    graph.output("row", between(&second, x) + between(&ramp("second", 9), x * x));
    graph.output("nothing", unread - unread);
    let program = graph.program();
    assert_eq!(program.tables(), [second]);
    assert_eq!(program.operations().fetches, 4);
    assert_eq!(interpret::evaluate(&program, &[2.0])[0], [2.0 + 4.0, 4.0 + 16.0, 2.0]);
}

#[test]
fn a_row_at_a_known_index_is_a_constant() {
    let table = ramp("squares", 8);
    let graph = Graph::new();
    let x = graph.input(Input::scalar("x", "", 0.0, 7.0, Rate::Pixel));
    graph.output("product", Expr::fetch(&table, Expr::lit(2.0)) * x);
    let program = graph.program();
    assert!(program.tables().is_empty());
    assert_eq!(program.operations(), Operations { arithmetic: 3, ..Operations::default() });
}
