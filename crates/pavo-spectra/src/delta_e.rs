//! Colour differences: CIELAB and CIEDE2000.
//!
//! CIELAB is that of ISO/CIE 11664-4. CIEDE2000 (ISO/CIE 11664-6) follows G. Sharma, W. Wu, and E. N. Dalal, "The
//! CIEDE2000 color-difference formula: implementation notes, supplementary test data, and mathematical observations",
//! Color Research and Application 30, 21 (2005), whose 34 pairs it meets to the four decimals printed. The parametric
//! factors k_L, k_C and k_H are 1.
//!
//! White is the colour space's own (1, 1, 1): a film-free perfect mirror has L* = 100. No exposure is taken out, and no
//! chromatic adaptation is applied.

use crate::colour_space::ColourSpace;
use crate::matrix3::transform;

/// 25^7, where the chroma weights of CIEDE2000 bend.
const TWENTY_FIVE_TO_THE_SEVENTH: f64 = 6_103_515_625.0;

/// The CIEDE2000 difference of two CIELAB colours (L*, a*, b*), at least 0 and symmetric; about 1 is just noticeable.
/// Lightness above 100 and below 0 is allowed; the formula was fitted to differences below about 5.
///
/// The formula itself jumps where two hues lie opposite each other: there, the mean hue changes sides. A pair exactly
/// opposite takes the plain mean of both hue angles, as Sharma, Wu and Dalal do.
///
/// A component that is not finite gives a NaN.
pub fn delta_e_2000(lab1: [f64; 3], lab2: [f64; 3]) -> f64 {
    let [l1, a1, b1] = lab1;
    let [l2, a2, b2] = lab2;

    // Equations 2 to 7: a* stretched near the neutral axis, then chroma C' and hue h'.
    let mean_chroma = (a1.hypot(b1) + a2.hypot(b2)) / 2.0;
    let stretch = 1.0 + 0.5 * (1.0 - chroma_weight(mean_chroma));
    let (a1, a2) = (stretch * a1, stretch * a2);
    let (c1, c2) = (a1.hypot(b1), a2.hypot(b2));
    let (h1, h2) = (hue_degrees(a1, b1), hue_degrees(a2, b2));

    // Equations 8 to 14: differences, and means.
    let delta_l = l2 - l1;
    let delta_c = c2 - c1;
    let mean_l = (l1 + l2) / 2.0;
    let mean_c = (c1 + c2) / 2.0;
    // Without chroma there is no hue, and delta_h is 0: then the mean hue weighs nothing.
    let (delta_h_degrees, mean_h) = if wraps([a1, b1], [a2, b2], h2 - h1) {
        let towards_zero = if h2 > h1 { -360.0 } else { 360.0 };
        let sum = h1 + h2;
        (h2 - h1 + towards_zero, if sum < 360.0 { (sum + 360.0) / 2.0 } else { (sum - 360.0) / 2.0 })
    } else {
        (h2 - h1, (h1 + h2) / 2.0)
    };
    let delta_h = 2.0 * (c1 * c2).sqrt() * (delta_h_degrees / 2.0).to_radians().sin();

    // Equations 15 to 22: the weights, and the rotation that joins chroma and hue in the blue.
    let cos_degrees = |degrees: f64| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos_degrees(mean_h - 30.0)
        + 0.24 * cos_degrees(2.0 * mean_h)
        + 0.32 * cos_degrees(3.0 * mean_h + 6.0)
        - 0.20 * cos_degrees(4.0 * mean_h - 63.0);
    let rotation_degrees = 30.0 * (-((mean_h - 275.0) / 25.0).powi(2)).exp();
    let rotation = -(2.0 * rotation_degrees).to_radians().sin() * 2.0 * chroma_weight(mean_c);
    let lightness_square = (mean_l - 50.0).powi(2);
    let weight_l = 1.0 + 0.015 * lightness_square / (20.0 + lightness_square).sqrt();
    let weight_c = 1.0 + 0.045 * mean_c;
    let weight_h = 1.0 + 0.015 * mean_c * t;

    let (x, y, z) = (delta_l / weight_l, delta_c / weight_c, delta_h / weight_h);
    // The rotation lies within -sqrt(3)..=0, so that the form is positive definite: rounding alone could make it negative.
    let square = x * x + y * y + z * z + rotation * y * z;
    if square < 0.0 { 0.0 } else { square.sqrt() }
}

/// The CIELAB colour (L*, a*, b*) of a linear one, relative to the colour space's own white: (1, 1, 1) is (100, 0, 0).
/// Channels above 1 and below 0 are allowed; for an XYZ below 0 the linear part of CIELAB continues.
pub fn lab_of_linear(rgb: [f64; 3], space: ColourSpace) -> [f64; 3] {
    let matrix = space.rgb_to_xyz();
    let white = transform(&matrix, [1.0; 3]);
    let xyz = transform(&matrix, rgb);
    let [fx, fy, fz] = std::array::from_fn(|i| lightness_response(xyz[i] / white[i]));
    [116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)]
}

/// The CIEDE2000 difference of two linear colours of one colour space: [`delta_e_2000`] of both [`lab_of_linear`].
pub fn delta_e_of_linear(a: [f64; 3], b: [f64; 3], space: ColourSpace) -> f64 {
    delta_e_2000(lab_of_linear(a, space), lab_of_linear(b, space))
}

/// f(t) of CIELAB: the cube root, and below (6/29)^3 the line that meets it with the same slope.
fn lightness_response(t: f64) -> f64 {
    const BEND: f64 = 6.0 / 29.0;
    if t > BEND * BEND * BEND { t.cbrt() } else { t / (3.0 * BEND * BEND) + 4.0 / 29.0 }
}

/// sqrt(C^7 / (C^7 + 25^7)), from 0 at no chroma to 1.
fn chroma_weight(chroma: f64) -> f64 {
    // Divided by C^7: a chroma past 1e44 would overflow its seventh power.
    1.0 / (1.0 + TWENTY_FIVE_TO_THE_SEVENTH * chroma.powi(-7)).sqrt()
}

/// The hue angle in degrees, from 0 up to 360; 0 for no chroma.
fn hue_degrees(a: f64, b: f64) -> f64 {
    let degrees = b.atan2(a).to_degrees();
    if degrees < 0.0 { degrees + 360.0 } else { degrees }
}

/// Whether the shorter way between two hues crosses 0 degrees, that is, whether their angles differ by more than 180. The
/// sign of the cross product decides it: it is exactly 0 for exactly opposite colours, where the angles are rounded. For
/// nearly equal hues rounding may decide it wrongly, which changes nothing: delta_h is then as near 0, and the mean hue
/// weighs only through it.
fn wraps([a1, b1]: [f64; 2], [a2, b2]: [f64; 2], difference_degrees: f64) -> bool {
    let cross = a1 * b2 - a2 * b1;
    cross * difference_degrees < 0.0
}
