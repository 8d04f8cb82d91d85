//! Numbers as text.

/// The shortest text that reads back as the same `f32`, always with a point or an exponent.
pub fn number(value: f64) -> String {
    // It writes 1e16 and 1e-7 with an exponent and no point; all languages read that as a float.
    format!("{:?}", value as f32)
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_read_back_as_the_same_f32() {
        for value in [0.0, 1.0, -1.0, 0.1, 1.0 / 3.0, 1e-30, 6.02e23, 1e16, 16_777_216.0, f64::from(f32::MAX)] {
            let text = number(value);
            assert_eq!(text.parse::<f32>().ok(), Some(value as f32), "{text}");
            assert!(text.contains(['.', 'e']), "{text} must not read as a whole number");
        }
    }
}
