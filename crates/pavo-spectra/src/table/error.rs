//! What may be wrong in a table.

/// What is wrong in a table, and where. Lines count from 1, comments and empty lines included.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TableError {
    /// There is no header line.
    #[error("{table}: the table is empty; it should begin with a header line such as `{example}`")]
    Empty {
        /// Name of the table.
        table: String,
        /// A header that would be right.
        example: String,
    },
    /// Fewer than two lines of values.
    #[error("{table}: the table has {rows} line(s) of values below its header; at least two are needed")]
    TooFewRows {
        /// Name of the table.
        table: String,
        /// Number of lines of values.
        rows: usize,
    },
    /// The header lacks a column.
    #[error("{table}, line {line}: the header has no column {column}; it should read like `{example}`")]
    MissingColumn {
        /// Name of the table.
        table: String,
        /// Line of the header.
        line: usize,
        /// The column, or the columns one of which is needed.
        column: String,
        /// A header that would be right.
        example: String,
    },
    /// The header has a column that means nothing here, or one twice.
    #[error("{table}, line {line}: the column `{column}` is {fault}; the header should read like `{example}`")]
    UnexpectedColumn {
        /// Name of the table.
        table: String,
        /// Line of the header.
        line: usize,
        /// The column.
        column: String,
        /// Why it should not be there.
        fault: &'static str,
        /// A header that would be right.
        example: String,
    },
    /// A line has more or fewer fields than the header.
    #[error("{table}, line {line}: {found} field(s) where the header has {expected}")]
    FieldCount {
        /// Name of the table.
        table: String,
        /// The line.
        line: usize,
        /// Number of columns of the header.
        expected: usize,
        /// Number of fields of the line.
        found: usize,
    },
    /// A field is no finite number.
    #[error("{table}, line {line}: {column} is `{text}`; it should be a finite number, with a point for the decimals")]
    NotANumber {
        /// Name of the table.
        table: String,
        /// The line.
        line: usize,
        /// The column.
        column: String,
        /// The field as it stands.
        text: String,
    },
    /// A number is out of its range.
    #[error("{table}, line {line}: {column} is {value}; it should be {expected}")]
    OutOfRange {
        /// Name of the table.
        table: String,
        /// The line.
        line: usize,
        /// The column.
        column: String,
        /// The number.
        value: f64,
        /// The range in words.
        expected: &'static str,
    },
    /// Two lines have the same wavelength.
    #[error("{table}, line {line}: the wavelength {value} stands on the line before too; each should stand once")]
    DuplicateWavelength {
        /// Name of the table.
        table: String,
        /// The second of the two lines.
        line: usize,
        /// The wavelength in the file's unit.
        value: f64,
    },
    /// A wavelength is below the one before it.
    #[error("{table}, line {line}: the wavelength {value} follows {previous}; wavelengths should ascend")]
    Unsorted {
        /// Name of the table.
        table: String,
        /// The line.
        line: usize,
        /// The wavelength before, in the file's unit.
        previous: f64,
        /// The wavelength in the file's unit.
        value: f64,
    },
    /// No wavelength is visible.
    #[error(
        "{table}: its wavelengths run from {low_nm} to {high_nm} nm, outside the visible 360 to 830 nm; \
         is the header's unit (nm or um) right?"
    )]
    NothingVisible {
        /// Name of the table.
        table: String,
        /// Lowest wavelength in nanometres.
        low_nm: f64,
        /// Highest wavelength in nanometres.
        high_nm: f64,
    },
}
