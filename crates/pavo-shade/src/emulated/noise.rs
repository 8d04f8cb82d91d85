//! Errors that look random and are a function of an operation.

/// A number within (-1, 1) for two operands and their exact result, which tells operations apart; the same for the same
/// bits.
///
/// Source: the finaliser of SplitMix64, Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
pub(crate) fn noise(operation: [f32; 3]) -> f64 {
    let mix = |state: u64, number: f32| {
        let sum = state.wrapping_add(u64::from(number.to_bits())).wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (sum ^ (sum >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    };
    let bits = operation.into_iter().fold(0, mix) >> 12;
    // The middle of each of 2^52 parts: neither end is reached.
    (bits as f64 + 0.5) / (1_u64 << 51) as f64 - 1.0
}

/// The distance between neighbouring numbers of `f32` at a number: 0 at 0, which no error moves.
pub(super) fn ulp(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return 0.0;
    }
    let exponent = ((value.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    2.0_f64.powi(exponent.max(f32::MIN_EXP - 1) - (f32::MANTISSA_DIGITS as i32 - 1))
}
