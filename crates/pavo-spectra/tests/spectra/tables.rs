//! Users' tables: each fault is named with its line, and no text makes the reader panic.

use pavo_spectra::{Illuminant, OpticalConstants};

use crate::random::Random;

#[test]
fn faults_are_named_with_their_line() {
    let header = "should read like `wavelength_nm,n,k`";
    for (text, expected) in [
        ("", "the table is empty; it should begin with a header line such as `wavelength_nm,n,k`".to_owned()),
        (
            "# only a comment\n\n",
            "the table is empty; it should begin with a header line such as `wavelength_nm,n,k`".into(),
        ),
        ("wavelength_nm,n,k\n", "the table has 0 line(s) of values below its header; at least two are needed".into()),
        (
            "wavelength_nm,n\n500,1\n",
            "the table has 1 line(s) of values below its header; at least two are needed".into(),
        ),
        ("n,k\n1,0\n", format!(", line 1: the header has no column `wavelength_nm` or `wavelength_um`; it {header}")),
        ("\n# c\nwavelength_um,k\n1,0\n", format!(", line 3: the header has no column `n`; it {header}")),
        (
            "500,1.5,0\n600,1.5,0\n",
            format!(", line 1: the header has no column `wavelength_nm` or `wavelength_um`; it {header}"),
        ),
        ("wavelength_nm,n,K\n500,1,0\n", format!(", line 1: the column `K` is not known; the header {header}")),
        ("wavelength_nm,n,n\n500,1,0\n", format!(", line 1: the column `n` is there twice; the header {header}")),
        (
            "wavelength_nm,wavelength_um,n\n500,0.5,1\n",
            format!(", line 1: the column `wavelength_um` is there beside `wavelength_nm`; the header {header}"),
        ),
        ("wavelength_nm,n,k\n500,1.5,0\n600,1.5\n", ", line 3: 2 field(s) where the header has 3".into()),
        ("wavelength_nm,n\n500,1.5,0\n", ", line 2: 3 field(s) where the header has 2".into()),
        (
            "wavelength_nm,n,k\n500,NaN,0\n",
            ", line 2: n is `NaN`; it should be a finite number, with a point for the decimals".into(),
        ),
        (
            "wavelength_nm,n,k\n500,1,0\n# c\n\n600,1,inf\n",
            ", line 5: k is `inf`; it should be a finite number, with a point for the decimals".into(),
        ),
        (
            "wavelength_nm,n,k\n500 nm,1,0\n",
            ", line 2: wavelength_nm is `500 nm`; it should be a finite number, with a point for the decimals".into(),
        ),
        (
            "wavelength_nm,n,k\n500,,0\n",
            ", line 2: n is ``; it should be a finite number, with a point for the decimals".into(),
        ),
        ("wavelength_nm,n,k\n500,0,0\n", ", line 2: n is 0; it should be above 0".into()),
        ("wavelength_nm,n,k\n500,-1.5,0\n", ", line 2: n is -1.5; it should be above 0".into()),
        ("wavelength_nm,n,k\n500,1.5,-0.1\n", ", line 2: k is -0.1; it should be 0 or above".into()),
        ("wavelength_um,n\n-0.5,1.5\n", ", line 2: wavelength_um is -0.5; it should be above 0".into()),
        (
            "wavelength_nm,n\n500,1.5\n490,1.5\n",
            ", line 3: the wavelength 490 follows 500; wavelengths should ascend".into(),
        ),
        (
            "wavelength_nm,n\n500,1.5\n500,1.5\n",
            ", line 3: the wavelength 500 stands on the line before too; each should stand once".into(),
        ),
        (
            "wavelength_um,n\n400,1.5\n700,1.5\n",
            "its wavelengths run from 400000 to 700000 nm, outside the visible 360 to 830 nm; \
             is the header's unit (nm or um) right?"
                .into(),
        ),
    ] {
        let expected =
            if expected.starts_with(',') { format!("film.csv{expected}") } else { format!("film.csv: {expected}") };
        let error = OpticalConstants::from_csv("film.csv", text).expect_err(text);
        assert_eq!(error.to_string(), expected, "for {text:?}");
    }
}

#[test]
fn an_illuminants_table_has_a_value_of_zero_or_above() {
    for (text, expected) in [
        (
            "wavelength_nm,power\n400,1\n",
            "lamp, line 1: the header has no column `value`; it should read like `wavelength_nm,value`",
        ),
        ("wavelength_nm,value\n400,-1\n", "lamp, line 2: value is -1; it should be 0 or above"),
    ] {
        assert_eq!(Illuminant::from_csv("lamp", text).unwrap_err().to_string(), expected);
    }
}

#[test]
fn what_spreadsheets_write_is_read() {
    let expected = OpticalConstants::from_csv("film", "wavelength_nm,n,k\n400,1.5,0.25\n700,1.25,0\n").unwrap();
    for text in [
        "\u{feff}wavelength_nm,n,k\r\n400,1.5,0.25\r\n700,1.25,0\r\n",
        "# measured\n  wavelength_um , k , n \n\n 0.4 , 0.25 , 1.5 \n\n# end of the blue\n0.7,0,1.25",
        "\"wavelength_nm\",\"n\",\"k\"\n\"400\",\"1.5\",\"0.25\"\n\"7e2\",\"1.25\",\"0\"\n",
    ] {
        assert_eq!(OpticalConstants::from_csv("film", text), Ok(expected.clone()), "for {text:?}");
    }
    let without_k = OpticalConstants::from_csv("film", "n,wavelength_nm\n1.5,400\n1.25,700\n").unwrap();
    assert_eq!(without_k.at(550.0), Ok((1.375, 0.0)));
}

#[test]
fn no_text_makes_the_reader_panic() {
    let whole = "# gold\nwavelength_nm,n,k\n400,1.5,0.25\n500,1.4,0.2\n700,1.25,0\n";
    let pieces = [",", "\n", "\"", "#", "-", "NaN", "1e999", "é", "\u{feff}", "wavelength_um", "n", " ", "0", "."];
    let mut random = Random::new(1);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let mut characters: Vec<char> = whole.chars().collect();
        for _ in 0..=random.below(3) {
            let place = random.below(characters.len());
            let end = (place + random.below(8)).min(characters.len());
            let piece = pieces[random.below(pieces.len())];
            characters.splice(place..end, piece.chars());
        }
        let text: String = characters.into_iter().collect();
        match OpticalConstants::from_csv("fuzzed", &text) {
            Ok(constants) => {
                let (n, k) = constants.extended_at(random.between(0.0, 2000.0));
                assert!(n.is_finite() && n > 0.0 && k.is_finite() && k >= 0.0, "{text:?} gives {n}, {k}");
                read += 1;
            }
            Err(error) => {
                assert!(error.to_string().starts_with("fuzzed"));
                refused += 1;
            }
        }
    }
    assert!(read > 500 && refused > 500, "{read} read, {refused} refused: the texts should be of both kinds");
}
