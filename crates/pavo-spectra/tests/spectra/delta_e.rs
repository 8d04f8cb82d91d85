//! Colour differences against the published pairs, and against an independent code.

use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::{delta_e_2000, delta_e_of_linear, lab_of_linear};

use crate::assert_close;
use crate::random::Random;

#[test]
fn the_pairs_of_sharma_wu_and_dalal_come_out_to_their_four_decimals() {
    let lines = include_str!("../data/ciede2000.csv").lines().filter(|line| !line.starts_with('#'));
    let mut pairs = 0;
    for line in lines.skip(1) {
        let numbers: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        let [l1, a1, b1, l2, a2, b2, expected] = numbers[..] else { panic!("{line}") };
        for (one, other) in [([l1, a1, b1], [l2, a2, b2]), ([l2, a2, b2], [l1, a1, b1])] {
            assert_close(line, delta_e_2000(one, other), expected, 0.500_01e-4);
        }
        pairs += 1;
    }
    assert_eq!(pairs, 34);
}

/// The published pairs do not tell whether a mean hue past 360 degrees is brought back below it; the second pair here does.
#[test]
fn far_colours_agree_with_an_independent_code() {
    for (one, other, expected) in [
        ([50.0, 60.0, -70.0], [62.5, -20.0, 45.0], 74.553_183_560_153_78),
        ([60.0, 40.0, 41.0], [61.0, 125.0, -120.0], 46.993_950_283_104_105),
        ([30.0, 20.0, 60.0], [31.0, 55.0, -30.0], 51.408_146_751_264_965),
        ([140.0, 3.0, 250.0], [-5.0, 90.0, 10.0], 138.497_753_907_028_6),
    ] {
        assert_close(&format!("{one:?}, {other:?}"), delta_e_2000(one, other), expected, 1e-9);
    }
}

#[test]
fn the_difference_is_symmetric_zero_for_equal_colours_and_finite() {
    let mut random = Random::new(20_250_711);
    for case in 0..20_000 {
        let one = [random.between(-20.0, 150.0), random.between(-150.0, 150.0), random.between(-150.0, 150.0)];
        let [l, a, b] = one;
        let other = match case % 4 {
            0 => one,
            1 => [l, -a, -b],
            2 => [l, a * (1.0 + 1e-15), b],
            _ => [random.between(-20.0, 150.0), random.between(-150.0, 150.0), random.between(-150.0, 150.0)],
        };
        let difference = delta_e_2000(one, other);
        let allowed = if case % 4 == 0 || case % 4 == 2 { 0.0..1e-12 } else { 1e-6..1e3 };
        assert!(allowed.contains(&difference), "{one:?}, {other:?}: {difference}");
        assert_eq!(difference, delta_e_2000(other, one), "{one:?}, {other:?}");
    }
    assert!(delta_e_2000([f64::NAN, 0.0, 0.0], [50.0, 0.0, 0.0]).is_nan());
    assert!(delta_e_2000([50.0, f64::INFINITY, 0.0], [50.0, 0.0, 0.0]).is_nan());
}

#[test]
fn linear_colours_have_the_lab_of_an_independent_code() {
    for (space, rgb, expected) in [
        (ColourSpace::LinearSrgb, [0.2, 0.5, 0.9], [73.874_296_378_9, -5.433_326_071, -34.035_902_758_1]),
        (ColourSpace::LinearSrgb, [1.7, 0.05, -0.1], [68.753_113_458_8, 86.412_948_377_8, 198.953_132_216_4]),
        (ColourSpace::LinearSrgb, [0.001, 0.002, 0.003], [1.679_727_617_2, -0.403_181_667_6, -1.550_397_500_3]),
        (ColourSpace::DisplayP3, [0.2, 0.5, 0.9], [73.741_224_002_1, -9.470_436_928, -37.179_254_036_6]),
        (ColourSpace::Rec2020, [0.2, 0.5, 0.9], [72.555_508_465_9, -22.743_811_024_9, -39.675_725_304_7]),
        (ColourSpace::AcesCg, [0.2, 0.5, 0.9], [72.215_607_959_6, -25.552_542_253, -41.163_355_708_8]),
        (ColourSpace::AcesCg, [1.7, 0.05, -0.1], [75.521_197_751_7, 132.794_619_356_7, 300.500_259_300_8]),
    ] {
        let found = lab_of_linear(rgb, space);
        for (component, (found, expected)) in ["L*", "a*", "b*"].into_iter().zip(found.into_iter().zip(expected)) {
            assert_close(&format!("{component} of {rgb:?} in {}", space.name()), found, expected, 1e-9);
        }
    }
}

#[test]
fn white_is_at_lightness_100_in_every_space_and_black_at_0() {
    for space in ColourSpace::ALL {
        for (grey, lightness) in [(0.0, 0.0), (1.0, 100.0), (8.0, 216.0), (-1.0, -24_389.0 / 27.0)] {
            let [l, a, b] = lab_of_linear([grey; 3], space);
            assert_close(&format!("L* of {grey} in {}", space.name()), l, lightness, 1e-9);
            assert!(a.abs() < 1e-9 && b.abs() < 1e-9, "{grey} in {}: a* = {a}, b* = {b}", space.name());
        }
        // Between greys CIEDE2000 is |dL*| over the lightness weight, which at L* = 50 is 1.
        let grey = |lightness: f64| [((lightness + 16.0) / 116.0).powi(3); 3];
        assert_close(space.name(), delta_e_of_linear(grey(49.5), grey(50.5), space), 1.0, 1e-9);
        assert!(delta_e_of_linear([-0.4, 2.5, -0.1], [30.0, -2.0, 0.0], space) > 1.0);
    }
}
