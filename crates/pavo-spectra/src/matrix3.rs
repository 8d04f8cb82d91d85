//! The little linear algebra that colour spaces need.

/// A matrix by rows.
pub(crate) type Matrix3 = [[f64; 3]; 3];

pub(crate) const IDENTITY: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The product of a matrix and a column vector.
pub(crate) fn transform(m: &Matrix3, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// The matrix with column `j` multiplied by `factors[j]`.
pub(crate) fn scale_columns(m: &Matrix3, factors: [f64; 3]) -> Matrix3 {
    m.map(|row| std::array::from_fn(|column| row[column] * factors[column]))
}

/// The inverse, by cofactors. The caller vouches for a determinant that is not zero.
pub(crate) fn inverse(m: &Matrix3) -> Matrix3 {
    let cofactor = |row: usize, column: usize| {
        let (r1, r2) = ((row + 1) % 3, (row + 2) % 3);
        let (c1, c2) = ((column + 1) % 3, (column + 2) % 3);
        m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
    };
    let determinant: f64 = (0..3).map(|column| m[0][column] * cofactor(0, column)).sum();
    std::array::from_fn(|row| std::array::from_fn(|column| cofactor(column, row) / determinant))
}
