//! The worst points as a table that `pavo eval` reads.

use crate::points_table::column_names;
use crate::tuning::WorstPoint;
use pavo_shade::Input;

/// The name of the file.
pub const FILE: &str = "worst-points.csv";

/// The points with the exact reflectance as the columns r, g and b, which `pavo eval` compares with.
pub fn csv(inputs: &[Input], points: &[WorstPoint]) -> String {
    let columns: Vec<String> = inputs.iter().flat_map(column_names).chain(["r", "g", "b"].map(str::to_owned)).collect();
    let mut text = columns.join(",") + "\n";
    for point in points {
        let numbers: Vec<String> = point.inputs.iter().chain(&point.exact).map(f64::to_string).collect();
        text.push_str(&numbers.join(","));
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::csv;
    use crate::tuning::WorstPoint;
    use pavo_shade::{Input, Rate};

    #[test]
    fn no_digit_of_a_point_is_lost() {
        let inputs = [Input::scalar("cos_theta1", "", 0.01, 1.0, Rate::Pixel)];
        let point = WorstPoint { inputs: vec![0.1 + 0.2], exact: [0.25, 1e-7, 1.0], found: [0.0; 3], delta_e: 1.0 };
        assert_eq!(csv(&inputs, &[point]), "cos_theta1,r,g,b\n0.30000000000000004,0.25,0.0000001,1\n");
    }
}
