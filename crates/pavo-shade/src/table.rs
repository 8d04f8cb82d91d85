//! Tables of constants that a program reads by an index it computes.

/// Rows of three numbers each, with the name that emitted code gives them.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its name in emitted code.
    pub name: String,
    /// What it holds, with units.
    pub doc: String,
    /// The rows; at least one.
    pub rows: Vec<[f64; 3]>,
}

impl Table {
    /// A table.
    ///
    /// # Panics
    /// If there are no rows: then there is nothing to read.
    pub fn new(name: &str, doc: &str, rows: Vec<[f64; 3]>) -> Self {
        assert!(!rows.is_empty(), "a table has at least one row");
        Self { name: name.to_owned(), doc: doc.to_owned(), rows }
    }

    /// The least and the greatest number of each column.
    pub(crate) fn extremes(&self) -> [[f64; 3]; 2] {
        let over = |choose: fn(f64, f64) -> f64| {
            let columns =
                |all: [f64; 3], row: &[f64; 3]| core::array::from_fn(|column| choose(all[column], row[column]));
            self.rows.iter().fold(self.rows[0], columns)
        };
        [over(f64::min), over(f64::max)]
    }

    /// The row of this number, held at the first and the last one.
    pub(crate) fn row(&self, index: f64) -> [f64; 3] {
        // The conversion holds what is negative, and what is not a number, at 0.
        self.rows[(index as usize).min(self.rows.len() - 1)]
    }
}
