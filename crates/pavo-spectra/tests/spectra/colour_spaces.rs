//! Colour spaces against the matrices that their standards print.

use pavo_spectra::ColourSpace;
use pavo_spectra::colour_space::srgb_encode;

use crate::assert_close;

type Matrix = [[f64; 3]; 3];

#[track_caller]
fn assert_matrix(what: &str, found: Matrix, expected: Matrix, tolerance: f64) {
    for (row, (found, expected)) in found.into_iter().zip(expected).enumerate() {
        for (column, (found, expected)) in found.into_iter().zip(expected).enumerate() {
            assert_close(&format!("{what} [{row}][{column}]"), found, expected, tolerance);
        }
    }
}

#[test]
fn names_read_back() {
    for space in ColourSpace::ALL {
        assert_eq!(ColourSpace::from_name(space.name()), Ok(space));
    }
    let error = ColourSpace::from_name("srgb").unwrap_err();
    assert_eq!(
        error.to_string(),
        "unknown colour space `srgb`; known are linear-srgb, display-p3, rec2020, acescg, xyz"
    );
}

#[test]
fn rgb_to_xyz_matrices_are_the_published_ones() {
    for (space, expected, tolerance) in [
        (
            // IEC 61966-2-1.
            ColourSpace::LinearSrgb,
            [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]],
            5e-5,
        ),
        (
            // SMPTE EG 432-1 primaries with white D65.
            ColourSpace::DisplayP3,
            [[0.4866, 0.2657, 0.1982], [0.2290, 0.6917, 0.0793], [0.0, 0.0451, 1.0439]],
            5e-5,
        ),
        (
            // ITU-R BT.2087.
            ColourSpace::Rec2020,
            [[0.6370, 0.1446, 0.1689], [0.2627, 0.6780, 0.0593], [0.0, 0.0281, 1.0610]],
            6e-5,
        ),
        (
            // Academy S-2014-004.
            ColourSpace::AcesCg,
            [
                [0.662_454_181_1, 0.134_004_206_5, 0.156_187_687_0],
                [0.272_228_716_8, 0.674_081_765_8, 0.053_689_517_4],
                [-0.005_574_649_5, 0.004_060_733_5, 1.010_339_100_3],
            ],
            5e-10,
        ),
    ] {
        assert_matrix(space.name(), space.rgb_to_xyz(), expected, tolerance);
    }
}

#[test]
fn the_inverse_srgb_matrix_is_the_published_one() {
    // IEC 61966-2-1 prints the inverse of its matrix of four decimals, which moves the fourth decimal of this one.
    let printed = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];
    assert_matrix("linear-srgb", ColourSpace::LinearSrgb.xyz_to_rgb(), printed, 4e-4);
    // CSS Color Module Level 4 prints the exact inverse.
    let exact = [
        [3.240_969_941_9, -1.537_383_177_6, -0.498_610_760_3],
        [-0.969_243_636_3, 1.875_967_501_5, 0.041_555_057_4],
        [0.055_630_079_7, -0.203_976_958_9, 1.056_971_514_2],
    ];
    assert_matrix("linear-srgb", ColourSpace::LinearSrgb.xyz_to_rgb(), exact, 5.1e-11);
}

#[test]
fn matrices_are_inverse_and_carry_white_to_white() {
    for space in ColourSpace::ALL {
        let (forth, back) = (space.rgb_to_xyz(), space.xyz_to_rgb());
        for (row, values) in forth.into_iter().enumerate() {
            for column in 0..3 {
                let product: f64 = values.into_iter().zip(back).map(|(value, of_back)| value * of_back[column]).sum();
                assert_close(space.name(), product, if row == column { 1.0 } else { 0.0 }, 1e-14);
            }
        }
        let [x, y, z] = forth.map(|row| row.iter().sum::<f64>());
        let white = space.white_chromaticity();
        assert_close(space.name(), x / (x + y + z), white[0], 1e-15);
        assert_close(space.name(), y / (x + y + z), white[1], 1e-15);
    }
}

#[test]
fn srgb_encoding_follows_the_standard() {
    for (linear, expected) in [
        (-1.0, 0.0),
        (0.0, 0.0),
        (0.001, 0.012_92),
        (0.003_130_8, 0.040_449_936),
        (0.214_041_140_482, 0.5),
        (0.5, 0.735_356_983),
        (1.0, 1.0),
        (7.0, 1.0),
    ] {
        assert_close(&format!("encoding of {linear}"), srgb_encode(linear), expected, 1e-8);
    }
}
