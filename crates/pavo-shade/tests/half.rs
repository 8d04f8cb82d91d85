//! Half precision: the nearest number of binary16, and operations rounded to it.

use pavo_shade::{Half, Real, Vector};

/// A number of binary16 by its bits, from the definition: sign, exponent with a bias of 15, fraction.
fn number(bits: u16) -> f64 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023));
    let magnitude = match exponent {
        0 => fraction * 2.0_f64.powi(-24),
        _ => (1024.0 + fraction) * 2.0_f64.powi(exponent - 25),
    };
    if bits >> 15 == 1 { -magnitude } else { magnitude }
}

fn rounded(value: f64) -> f64 {
    f64::from(Half::new(value))
}

#[test]
fn each_number_rounds_to_the_nearest() {
    // All numbers but the infinite ones; above the largest is what would be the next.
    for bits in 0..31 << 10 {
        let [here, next] = [bits, bits + 1].map(number);
        let is_last = bits + 1 == 31 << 10;
        let above = if is_last { f64::INFINITY } else { next };
        let middle = 0.5 * (here + next);
        let nudge = middle * 1e-15;
        for sign in [1.0, -1.0] {
            assert_eq!(rounded(sign * here), sign * here);
            assert_eq!(rounded(sign * (middle - nudge)), sign * here, "below the middle after {here}");
            assert_eq!(rounded(sign * (middle + nudge)), sign * above, "above the middle after {here}");
            assert_eq!(rounded(sign * middle), sign * if bits % 2 == 0 { here } else { above }, "after {here}");
        }
    }
}

#[test]
fn what_is_no_number_passes_through() {
    assert!(rounded(f64::NAN).is_nan());
    assert_eq!(
        [f64::INFINITY, f64::NEG_INFINITY, 1e300, 1e-300].map(rounded),
        [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, 0.0]
    );
    assert!(rounded(-0.0).is_sign_negative() && rounded(-1e-300).is_sign_negative());
    assert!(f64::from(Half::lit(-1.0).sqrt()).is_nan());
    assert_eq!(f64::from(Half::lit(0.0).inverse_sqrt()), f64::INFINITY);
}

#[test]
fn each_operation_is_rounded() {
    let lit = Half::lit;
    let cases: [(&str, Half, f64); 12] = [
        ("a literal", lit(0.1), 0.099_975_585_937_5),
        ("a sum", lit(2048.0) + lit(1.0), 2048.0),
        ("a difference", lit(2049.0) - lit(2.0), 2046.0),
        ("a product that is too large", lit(300.0) * lit(300.0), f64::INFINITY),
        ("a product that is too small", lit(1e-4) * lit(1e-4), 0.0),
        ("a quotient", lit(1.0) / lit(3.0), 0.333_251_953_125),
        ("a root", lit(2.0).sqrt(), 1.414_062_5),
        ("1 over a root", lit(3.0).inverse_sqrt(), 0.577_148_437_5),
        ("a sine", lit(1.0).sin(), 0.841_308_593_75),
        ("an exponential", lit(-20.0).exp(), 0.0),
        ("the next whole number below", lit(-1.5).floor(), -2.0),
        (
            "a scalar product",
            pavo_shade::Triple([lit(2048.0), lit(1.0), lit(1.0)]).dot(Vector::splat(lit(1.0))),
            2048.0,
        ),
    ];
    for (name, found, expected) in cases {
        assert_eq!(f64::from(found), expected, "{name}");
    }
}

#[test]
fn single_precision_rounded_to_half_is_half_precision() {
    // Every 61st number beside every 1009th, both signs.
    let some = |step: usize| (0..31_u16 << 10).step_by(step).flat_map(|bits| [number(bits), -number(bits)]);
    for a in some(61) {
        for b in some(1009) {
            let [x, y] = [a as f32, b as f32];
            for (single, half, operator) in [
                (x + y, Half::new(a) + Half::new(b), '+'),
                (x - y, Half::new(a) - Half::new(b), '-'),
                (x * y, Half::new(a) * Half::new(b), '*'),
                (x / y, Half::new(a) / Half::new(b), '/'),
            ] {
                let (single, half) = (single.half(), f64::from(half) as f32);
                assert!(single == half || single.is_nan() && half.is_nan(), "{a} {operator} {b}: {single}, not {half}");
            }
        }
    }
}
