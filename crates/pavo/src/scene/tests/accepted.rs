//! What a scene's text means.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pavo_shade::Rate;

use crate::scene::{
    Ambient, Base, Budget, Colour, ColourQuantity, Emit, Film, FilmMedium, IlluminantSource, Lights, Precision,
    Quantity, Scene, Surface, VisibilityK,
};

fn read(text: &str) -> Scene {
    Scene::from_toml("test.toml", text, Path::new("folder")).unwrap_or_else(|error| panic!("{error:?}"))
}

fn range(low: f64, high: f64) -> Quantity {
    Quantity::Range { low, high }
}

#[test]
fn a_scene_in_full_is_read_key_by_key() {
    let text = r#"
        name = "Full_1"
        [colour]
        observer = "cie1964-10deg"
        illuminant = "A"
        space = "acescg"
        [ambient]
        ior = [1, 1.5]
        [film]
        ior = [1.3, 2.5]
        thickness_nm = 400
        [base]
        ior = 2.7
        kappa = [0, 3.8]
        [surface]
        roughness = 0.3
        diffuse = true
        base_color = [1, 0.5, 0]
        visibility_k = [0.1, 0.9]
        [lights]
        punctual = false
        [budget]
        max_delta_e = 0.5
        [rates]
        film_ior = "pixel"
        ambient_ior = "vertex"
        visibility_k = "material"
        [emit]
        targets = ["spirv-asm", "glsl330"]
        variant = "exact"
        prefix = "film_2_"
        prepare = true
        vertex = true
    "#;
    let expected = Scene {
        name: "Full_1".to_owned(),
        colour: Colour {
            observer: "cie1964-10deg".into(),
            illuminant: IlluminantSource::Named("A".into()),
            space: "acescg".into(),
        },
        ambient: Ambient { ior: range(1.0, 1.5) },
        film: Some(Film { medium: FilmMedium::Index(range(1.3, 2.5)), thickness_nm: Quantity::Fixed(400.0) }),
        base: Base::Conductor { ior: Quantity::Fixed(2.7), kappa: range(0.0, 3.8) },
        surface: Surface {
            roughness: Quantity::Fixed(0.3),
            diffuse: true,
            base_color: Some(ColourQuantity::Fixed([1.0, 0.5, 0.0])),
            metalness: None,
            visibility_k: VisibilityK::Value(range(0.1, 0.9)),
        },
        lights: Lights { punctual: false },
        budget: Budget { max_delta_e: Some(0.5) },
        rates: BTreeMap::from([
            ("film_ior".to_owned(), Rate::Pixel),
            ("ambient_ior".to_owned(), Rate::Vertex),
            ("visibility_k".to_owned(), Rate::Material),
        ]),
        emit: Emit {
            targets: vec!["spirv-asm".to_owned(), "glsl330".to_owned()],
            variant: "exact".to_owned(),
            prefix: "film_2_".to_owned(),
            prepare: true,
            vertex: true,
            precision: Precision::Full,
        },
    };
    assert_eq!(read(text), expected);
    let again = toml::to_string(&expected).expect("a scene can be written as TOML");
    assert_eq!(Scene::from_toml("again.toml", &again, Path::new("")).expect("it reads back"), expected);
}

#[test]
fn a_scene_of_a_name_and_a_base_has_every_default() {
    let scene = read("name = 'bare'\nbase.ior = 1.5");
    assert_eq!(scene, Scene::new("bare", Base::Dielectric { ior: Quantity::Fixed(1.5) }));
    assert_eq!(scene.colour.observer, "cie1931-2deg");
    assert_eq!(scene.colour.illuminant, IlluminantSource::Named("D65".into()));
    assert_eq!(scene.colour.space, "linear-srgb");
    assert_eq!(scene.ambient.ior, Quantity::Fixed(1.0));
    assert_eq!(scene.film, None);
    assert_eq!(scene.surface.roughness, range(0.05, 1.0));
    assert!(!scene.surface.diffuse);
    assert_eq!(scene.surface.visibility_k, VisibilityK::Punctual);
    assert!(scene.lights.punctual);
    assert_eq!(scene.emit.targets, ["wgsl", "glsl450", "essl300", "spirv"]);
    assert_eq!(scene.emit.variant, "series:m=3,fit=xyz-gauss");
    assert_eq!(scene.emit.prefix, "");
}

#[test]
fn each_kind_of_base_is_told_by_its_keys() {
    let ior = Quantity::Fixed(1.5);
    let cases: &[(&str, Base)] = &[
        ("ior = 1.5", Base::Dielectric { ior }),
        ("ior = 1.5\nkappa = 0", Base::Dielectric { ior }),
        ("ior = 1.5\nkappa = -0.0", Base::Dielectric { ior }),
        ("kappa = 1e-3\nior = 1.5", Base::Conductor { ior, kappa: Quantity::Fixed(0.001) }),
        ("ior = 1.5\nkappa = [0, 1]", Base::Conductor { ior, kappa: range(0.0, 1.0) }),
        ("metal = 'Au'", Base::Metal { name: "Au".to_owned() }),
        ("workflow = 'f0'\nf0 = 'input'", Base::F0 { f0: ColourQuantity::Input, edge_tint: None }),
        (
            "workflow = 'f0'\nf0 = [1, 0.5, 0]\nedge_tint = 'input'",
            Base::F0 { f0: ColourQuantity::Fixed([1.0, 0.5, 0.0]), edge_tint: Some(ColourQuantity::Input) },
        ),
        ("csv = 'data/nickel.csv'", Base::Table { path: PathBuf::from("folder/data/nickel.csv") }),
        ("csv = '/data/nickel.csv'", Base::Table { path: PathBuf::from("/data/nickel.csv") }),
    ];
    for (keys, expected) in cases {
        assert_eq!(read(&format!("name = 'x'\n[base]\n{keys}")).base, *expected, "{keys}");
    }
}

#[test]
fn the_metalness_workflow_has_metalness_as_an_input_unless_it_says_otherwise() {
    let workflow = "name = 'x'\nbase.workflow = 'metalness'\n[surface]\nbase_color = 'input'\n";
    let scene = read(workflow);
    assert_eq!(scene, Scene::new("x", Base::Metalness));
    assert_eq!(scene.surface.metalness, Some(range(0.0, 1.0)));
    assert_eq!(scene.surface.base_color, Some(ColourQuantity::Input));
    assert_eq!(read(&format!("{workflow}metalness = 1")).surface.metalness, Some(Quantity::Fixed(1.0)));
}

#[test]
fn every_form_of_the_visibility_k_is_read() {
    let cases = [
        ("'punctual'", VisibilityK::Punctual),
        ("'ibl'", VisibilityK::ImageBased),
        ("0", VisibilityK::Value(Quantity::Fixed(0.0))),
        ("[0.125, 0.5]", VisibilityK::Value(range(0.125, 0.5))),
    ];
    for (value, expected) in cases {
        let text = format!("name = 'x'\nbase.ior = 1.5\nsurface.visibility_k = {value}");
        assert_eq!(read(&text).surface.visibility_k, expected, "{value}");
    }
}

#[test]
fn numbers_may_be_written_in_every_way_that_toml_has() {
    let cases = [
        ("1_000", 1000.0),
        ("0x64", 100.0),
        ("0b11", 3.0),
        ("0o17", 15.0),
        ("+2.5", 2.5),
        ("1e2", 100.0),
        ("-0.0", 0.0),
    ];
    for (written, expected) in cases {
        let text = format!("name = 'x'\nbase.ior = 1.5\nfilm.ior = 1.3\nfilm.thickness_nm = {written}");
        let film = read(&text).film.expect("the scene has a film");
        assert_eq!(film.thickness_nm, Quantity::Fixed(expected), "{written}");
    }
}

#[test]
fn the_limits_themselves_are_accepted() {
    let cases = [
        "film = { ior = 0.01, thickness_nm = [0, 1e6] }",
        "film = { ior = [0.01, 100], thickness_nm = 1_000_000 }",
        "ambient.ior = 100",
        "surface.roughness = [0, 1]",
        "surface.visibility_k = 1",
    ];
    for keys in cases {
        read(&format!("name = 'x'\nbase.ior = 1.5\n{keys}"));
    }
}

#[test]
fn a_byte_order_mark_and_windows_line_ends_are_accepted() {
    let scene = read("\u{feff}name = 'x'\r\n[base]\r\nior = 1.5\r\n");
    assert_eq!(scene, Scene::new("x", Base::Dielectric { ior: Quantity::Fixed(1.5) }));
}

#[test]
fn a_quantity_knows_its_ends_and_its_middle() {
    let fixed = Quantity::Fixed(3.0);
    assert_eq!((fixed.fixed(), fixed.low(), fixed.high(), fixed.midpoint()), (Some(3.0), 3.0, 3.0, 3.0));
    assert!(!fixed.is_input());
    let pair = range(1.0, 4.0);
    assert_eq!((pair.fixed(), pair.low(), pair.high(), pair.midpoint()), (None, 1.0, 4.0, 2.5));
    assert!(pair.is_input());
}

#[test]
fn a_scene_built_in_rust_is_held_to_the_same_rules() {
    let glass = Base::Dielectric { ior: Quantity::Fixed(1.5) };
    assert!(Scene::new("glass", glass.clone()).validate().is_ok());
    assert!(Scene::new("engine", Base::Metalness).validate().is_ok());

    let reversed = Film { medium: FilmMedium::Index(Quantity::Fixed(1.3)), thickness_nm: range(500.0, 100.0) };
    let cases: Vec<(Scene, &str)> = vec![
        (Scene::new("9lives", glass.clone()), "name"),
        (Scene { film: Some(reversed), ..Scene::new("x", glass.clone()) }, "film.thickness_nm"),
        (
            Scene { ambient: Ambient { ior: Quantity::Fixed(f64::NAN) }, ..Scene::new("x", glass.clone()) },
            "ambient.ior",
        ),
        (Scene::new("x", Base::Metal { name: "Unobtainium".to_owned() }), "base.metal"),
        (Scene::new("x", Base::Table { path: PathBuf::new() }), "base.csv"),
        (Scene { surface: Surface::default(), ..Scene::new("x", Base::Metalness) }, "base.workflow"),
        (
            Scene {
                surface: Surface { base_color: Some(ColourQuantity::Input), ..Surface::default() },
                ..Scene::new("x", Base::Metalness)
            },
            "surface.metalness",
        ),
        (
            Scene { rates: BTreeMap::from([("opacity".to_owned(), Rate::Pixel)]), ..Scene::new("x", glass.clone()) },
            "rates.opacity",
        ),
        (
            Scene { rates: BTreeMap::from([("base_ior".to_owned(), Rate::Pixel)]), ..Scene::new("x", glass.clone()) },
            "rates.base_ior",
        ),
        (Scene { emit: Emit { vertex: true, ..Emit::default() }, ..Scene::new("x", glass.clone()) }, "emit.vertex"),
        (Scene { emit: Emit { targets: Vec::new(), ..Emit::default() }, ..Scene::new("x", glass) }, "emit.targets"),
    ];
    for (scene, key) in cases {
        let error = scene.validate().expect_err(key);
        assert_eq!(error.key(), Some(key), "{error:?}");
        assert_eq!(error.span(), None);
        assert!(!error.help_text().is_empty());
    }
}

#[test]
fn a_film_is_an_index_a_material_or_a_table() {
    let cases = [
        ("ior = 1.4", FilmMedium::Index(Quantity::Fixed(1.4))),
        ("material = 'SiO2'", FilmMedium::Material("SiO2".to_owned())),
        ("csv = 'film.csv'", FilmMedium::Table(Path::new("folder").join("film.csv"))),
    ];
    for (written, expected) in cases {
        let scene = read(&format!("name = 'x'\nbase.ior = 1.5\n[film]\nthickness_nm = 100\n{written}"));
        assert_eq!(scene.film.map(|film| film.medium), Some(expected), "{written}");
    }
}

#[test]
fn an_illuminant_is_a_name_or_a_file() {
    let scene = |colour: &str| read(&format!("name = 'a'\n[colour]\n{colour}\n[base]\nior = 1.5"));
    let of_file = scene("illuminant_csv = 'lamp.csv'").colour.illuminant;
    assert_eq!(of_file, IlluminantSource::Table(PathBuf::from("folder/lamp.csv")));
    assert_eq!(of_file.to_string(), "lamp.csv");
    assert_eq!(scene("illuminant = 'E'").colour.illuminant, IlluminantSource::Named("E".into()));
}
