//! Intervals enclose what their operations give, in `f64` and in `f32`.

use pavo_shade::emulated::{Emulated, Loose};
use pavo_shade::interval::{Double, Interval, IntervalVec3, Precision, Single};
use pavo_shade::{Mask, Real, Triple, Vector};
use proptest::prelude::*;

/// Operations on three numbers, each defined for all of them.
fn operations<R: Real>([a, b, c]: [R; 3]) -> Vec<(&'static str, R)> {
    let one = R::lit(1.0);
    let mask = a.less_than(b);
    vec![
        ("a", a),
        ("a + b", a + b),
        ("a - b", a - b),
        ("a * b", a * b),
        ("a / (abs(b) + 1)", a / (b.abs() + one)),
        ("a / b", a / b),
        ("-a", -a),
        ("sqrt(abs(a))", a.abs().sqrt()),
        ("sqrt(a)", a.sqrt()),
        ("inverse_sqrt(abs(a) + 1)", (a.abs() + one).inverse_sqrt()),
        ("inverse_sqrt(a)", a.inverse_sqrt()),
        ("sin(a)", a.sin()),
        ("cos(a)", a.cos()),
        ("exp(-abs(a))", (-a.abs()).exp()),
        ("exp(a)", a.exp()),
        ("floor(a)", a.floor()),
        ("fract(a)", a.fract()),
        ("min(a, b)", a.min(b)),
        ("max(a, b)", a.max(b)),
        ("max(sqrt(a), b)", a.sqrt().max(b)),
        ("clamp(a, b, c)", a.clamp(b, c)),
        ("mix(a, b, c)", R::mix(a, b, c)),
        ("mix(a, b, fract(c))", R::mix(a, b, c.fract())),
        ("select(a < b, a, c)", R::select(mask, a, c)),
        ("select(not (a < b), sqrt(a), c)", R::select(mask.not(), a.sqrt(), c)),
        ("select(a < b and b < c, a, 1)", R::select(mask.and(b.less_than(c)), a, one)),
        ("select(a < b or b < c, a, 1)", R::select(mask.or(b.less_than(c)), a, one)),
        ("a^2", a.powi(2)),
        ("a^3", a.powi(3)),
        ("a^4", a.powi(4)),
    ]
}

/// Ranges of three numbers, and a number within each.
fn ranges() -> impl Strategy<Value = [([f64; 2], f64); 3]> {
    let end = prop_oneof![Just(0.0), Just(1.0), -1.0..1.0, -10.0..10.0, -1000.0..1000.0, -1e-9..1e-9];
    let width = prop_oneof![Just(0.0), 0.0..1.0, 0.0..20.0, 0.0..1e-6];
    let range = (end, width, 0.0..=1.0).prop_map(|(low, width, share): (f64, f64, f64)| {
        let high = low + width;
        ([low, high], (low + width * share).clamp(low, high))
    });
    [range.clone(), range.clone(), range]
}

fn check<P: Precision>(ranges: [([f64; 2], f64); 3], values: &[(&str, f64)]) -> Result<(), TestCaseError> {
    let intervals = operations(ranges.map(|([low, high], _)| Interval::<P>::new(low, high)));
    for ((name, interval), (_, value)) in intervals.into_iter().zip(values) {
        prop_assert!(interval.contains(*value), "{}: {:e} is outside of {:?}", name, value, interval);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn each_operation_encloses_its_values(ranges in ranges()) {
        let point = ranges.map(|(_, value)| value);
        let in_f64 = operations(point);
        let in_f32 = operations(point.map(|value| value as f32));
        let in_f32: Vec<(&str, f64)> = in_f32.into_iter().map(|(name, value)| (name, f64::from(value))).collect();
        check::<Double>(ranges, &in_f64)?;
        check::<Single>(ranges, &in_f64)?;
        check::<Single>(ranges, &in_f32)?;
    }

    #[test]
    fn bounds_of_single_precision_hold_on_a_device_that_does_what_it_likes(ranges in ranges()) {
        let on_device = operations(ranges.map(|(_, value)| Emulated::<Loose>::lit(value)));
        let on_device: Vec<(&str, f64)> = on_device.into_iter().map(|(name, value)| (name, value.into())).collect();
        check::<Single>(ranges, &on_device)?;
    }

    #[test]
    fn operations_on_vectors_enclose_their_values(ranges in ranges()) {
        let box3 = IntervalVec3(ranges.map(|([low, high], _)| Interval::<Single>::new(low, high)));
        let vector = glam::Vec3::from_array(ranges.map(|(_, value)| value as f32));
        let shifted = Vector::lit3([0.5, -2.0, 3.0]);
        prop_assert!(box3.dot(shifted).contains(f64::from(vector.dot(Vector::lit3([0.5, -2.0, 3.0])))));
        let on_device = Triple(ranges.map(|(_, value)| Emulated::<Loose>::lit(value)));
        prop_assert!(box3.dot(shifted).contains(on_device.dot(Vector::lit3([0.5, -2.0, 3.0])).into()));
        let normalized = Vector::normalize(box3);
        for (interval, value) in normalized.0.into_iter().zip(vector.normalize().to_array()) {
            // What is shorter than the root of the smallest number has no direction in f32.
            prop_assert!(interval.contains(f64::from(value)) || vector.length() < 1e-15, "{value} {interval:?}");
        }
    }
}

/// The bounds that an operation gives, and whether it is defined.
type Bounds = (f64, f64, bool);

#[test]
fn bounds_are_as_close_as_the_operation_allows() {
    let of = |low: f64, high: f64| Interval::<Double>::new(low, high);
    let cases: [(&str, Interval, Bounds); 22] = [
        ("a sum", of(1.0, 2.0) + of(3.0, 5.0), (4.0, 7.0, true)),
        ("a product of both signs", of(-1.0, 2.0) * of(-3.0, 5.0), (-6.0, 10.0, true)),
        ("a square", of(-1.0, 2.0).square(), (0.0, 4.0, true)),
        ("a quotient", of(1.0, 2.0) / of(4.0, 8.0), (0.125, 0.5, true)),
        ("a quotient by what may be 0", of(1.0, 2.0) / of(0.0, 8.0), (f64::NEG_INFINITY, f64::INFINITY, false)),
        (
            "0 times what may be infinite",
            of(0.0, 0.0) * Interval::anything(),
            (f64::NEG_INFINITY, f64::INFINITY, false),
        ),
        ("a root", of(4.0, 9.0).root(), (2.0, 3.0, true)),
        ("a root of what may be negative", of(-4.0, 9.0).root(), (0.0, 3.0, false)),
        ("1 over a root of what may be 0", of(0.0, 4.0).inverse_root(), (0.5, f64::INFINITY, false)),
        ("a sine that rises", of(0.0, 1.0).sine(), (0.0, 0.841_470_984_807_896_5, true)),
        ("a sine over its maximum", of(0.0, 2.0).sine(), (0.0, 1.0, true)),
        ("a sine over its minimum", of(4.0, 5.0).sine(), (-1.0, -0.756_802_495_307_928_2, true)),
        ("a sine far out", of(1000.0, 1000.5).sine(), (0.826_879_540_532_002_6, 0.995_273_957_105_213_5, true)),
        ("a cosine over its maximum", of(-1.0, 0.5).cosine(), (0.540_302_305_868_139_7, 1.0, true)),
        ("a cosine over a turn", of(0.0, 7.0).cosine(), (-1.0, 1.0, true)),
        ("a cosine of what is not bounded", Interval::anything().cosine(), (-1.0, 1.0, false)),
        ("the part after the point", of(2.25, 2.5).fraction(), (0.25, 0.5, true)),
        ("the part after the point over a whole number", of(1.75, 2.5).fraction(), (0.0, 1.0, true)),
        ("the larger of a number and none", of(-4.0, -1.0).root().larger(of(2.0, 3.0)), (2.0, 3.0, true)),
        ("a mix within", Interval::mixed(of(2.0, 3.0), of(4.0, 5.0), of(0.0, 1.0)), (2.0, 5.0, true)),
        (
            "a choice that is decided",
            Interval::chosen(of(0.0, 1.0).is_less(of(2.0, 3.0)), of(1.0, 2.0), Interval::anything()),
            (1.0, 2.0, true),
        ),
        (
            "a choice that is not",
            Interval::chosen(of(0.0, 2.5).is_less(of(2.0, 3.0)), of(1.0, 2.0), of(7.0, 8.0)),
            (1.0, 8.0, true),
        ),
    ];
    for (name, interval, (low, high, defined)) in cases {
        let near = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-12 * (1.0 + a.abs());
        assert!(near(interval.low(), low) && near(interval.high(), high), "{name}: {interval:?}");
        assert_eq!(interval.is_defined(), defined, "{name}: {interval:?}");
    }
}
