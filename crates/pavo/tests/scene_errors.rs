//! What a scene is refused for: each case is a scene with one thing wrong, and what its error must say.

use std::path::Path;

use miette::{GraphicalReportHandler, GraphicalTheme};
use pavo::scene::{Scene, SceneError};

/// A scene in full that is accepted, one key a line, no two lines alike.
const SCENE: &str = r#"name = "test"
[colour]
observer = "cie1931-2deg"
illuminant = "D65"
space = "linear-srgb"
[film]
ior = 1.33
thickness_nm = [0, 1200]
[base]
workflow = "metalness"
[surface]
roughness = [0.05, 1.0]
diffuse = true
base_color = [0.1, 0.5, 0.2]
metalness = [0, 1]
visibility_k = "punctual"
[lights]
punctual = true
[emit]
targets = ["wgsl", "spirv"]
variant = "exact"
prefix = "test_"
"#;

/// One refused scene: the line of [`SCENE`] to replace, given by how it starts; what takes its place; a part of the
/// message; a part of the help; the text that the error points at.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// [`SCENE`] with the line that starts with `line` replaced.
fn edited(line: &str, replacement: &str) -> String {
    let found: Vec<&str> = SCENE.lines().filter(|candidate| candidate.starts_with(line)).collect();
    assert_eq!(found.len(), 1, "`{line}` names one line: {found:?}");
    let lines: Vec<&str> =
        SCENE.lines().map(|candidate| if candidate == found[0] { replacement } else { candidate }).collect();
    lines.join("\n") + "\n"
}

fn refusal(text: &str) -> SceneError {
    match Scene::from_toml("test.toml", text, Path::new("")) {
        Ok(_) => panic!("this scene was accepted:\n{text}"),
        Err(error) => error,
    }
}

fn check_text(text: &str, message: &str, help: &str, at: &str) {
    let error = refusal(text);
    let span = error.span().unwrap_or_else(|| panic!("no span: {error:?}"));
    assert!(error.to_string().contains(message), "`{message}` is not in the message: {error:?}");
    assert!(error.help_text().contains(help), "`{help}` is not in the help: {error:?}");
    assert_eq!(&text[span], at, "{error:?}");
}

fn check(cases: &[Case]) {
    for &(line, replacement, message, help, at) in cases {
        check_text(&edited(line, replacement), message, help, at);
    }
}

#[test]
fn the_scene_that_the_cases_edit_is_accepted() {
    let scene = Scene::from_toml("test.toml", SCENE, Path::new(""));
    assert!(scene.is_ok(), "{scene:?}");
}

#[test]
fn text_that_is_not_toml_is_refused_where_it_breaks() {
    check(&[
        ("ior", "ior =", "the value is missing", "write a value", ""),
        ("ior", "ior = high", "`high` is not a value", "strings are in quotes: \"high\"", "high"),
        ("ior", "ior", "expected `=`", "a line is `key = value`", ""),
        ("[film]", "[film", "expected `]`", "`[table]`", ""),
        ("name", "name = \"test", "expected `\"`", "strings are in quotes", ""),
        ("thickness_nm", "thickness_nm = [0, 1200", "not valid TOML", "a range is [low, high]", ""),
        ("ior", "ior = 1.33\nior = 1.34", "duplicate key", "keep one of the two", "ior"),
        ("[lights]", "[film]", "duplicate key", "keep one of the two", "film"),
    ]);
}

#[test]
fn an_unknown_key_is_refused_with_the_key_that_was_meant() {
    check(&[
        ("ior", "iro = 1.33", "unknown key `iro` in [film]", "did you mean `ior`? the keys of [film] are", "iro"),
        (
            "thickness_nm",
            "thickness = 1",
            "unknown key `thickness` in [film]",
            "did you mean `thickness_nm`?",
            "thickness",
        ),
        ("roughness", "Roughness = 1", "unknown key `Roughness`", "did you mean `roughness`?", "Roughness"),
        ("base_color", "albedo = 1", "unknown key `albedo` in [surface]", "did you mean `base_color`?", "albedo"),
        ("metalness", "metallic = 1", "unknown key `metallic`", "did you mean `metalness`?", "metallic"),
        (
            "variant",
            "quux = 1",
            "unknown key `quux` in [emit]",
            "the keys of [emit] are: targets, variant, prefix",
            "quux",
        ),
        ("variant", "\"a b\" = 1", "unknown key `\"a b\"`", "targets", "\"a b\""),
        (
            "variant",
            "roughness = 1",
            "unknown key `roughness` in [emit]",
            "`roughness` belongs in [surface]",
            "roughness",
        ),
        ("variant", "film.ior = 1", "unknown key `film` in [emit]", "start it with `[film]`", "film"),
        ("variant", "name = 'x'", "unknown key `name` in [emit]", "to the top of the file", "name"),
        ("name", "name = 'x'\nior = 1", "unknown key `ior`", "`ior` belongs in [ambient], [film] or [base]", "ior"),
        ("name", "title = 'x'", "unknown key `title`", "only `name` stands before the first table", "title"),
        ("name", "nmae = 'x'", "unknown key `nmae`", "did you mean `name`?", "nmae"),
        ("name", "flim = 1", "unknown key `flim`", "did you mean the table `[film]`?", "flim"),
        (
            "name",
            "thickness = 1",
            "unknown key `thickness`",
            "`thickness_nm`? `thickness_nm` belongs in [film]",
            "thickness",
        ),
    ]);
}

#[test]
fn an_unknown_table_is_refused_with_the_table_that_was_meant() {
    check(&[
        ("[colour]", "[color]", "unknown table `[color]`", "did you mean `colour`?", "color"),
        ("[film]", "[coating]", "unknown table `[coating]`", "did you mean `film`?", "coating"),
        (
            "[lights]",
            "[zebra]",
            "unknown table `[zebra]`",
            "colour, ambient, film, base, surface, lights, budget, rates, emit",
            "zebra",
        ),
        ("[lights]", "[film.lights]", "unknown key `lights` in [film]", "start it with `[lights]`", "lights"),
        ("[lights]", "[[lights]]", "`lights` is a list of tables", "write the table once", "[[lights]]"),
        ("name", "name = 'x'\nambient = 1.5", "`ambient` is a number, but it must be a table", "`[ambient]`", "1.5"),
    ]);
}

#[test]
fn a_value_of_the_wrong_type_is_refused() {
    check(&[
        ("name", "name = 3", "`name` is a number, but it must be a string", "in quotes", "3"),
        ("observer", "observer = true", "`colour.observer` is true or false", "in quotes", "true"),
        ("ior", "ior = '1.33'", "`film.ior` is a string, but it must be a number", "remove the quotes: 1.33", "'1.33'"),
        ("ior", "ior = 'water'", "`film.ior` is a string", "one number for a constant", "'water'"),
        ("ior", "ior = 2020-01-01", "`film.ior` is a date or time", "`ior = [low, high]`", "2020-01-01"),
        ("ior", "ior = { low = 1, high = 2 }", "`film.ior` is a table", "`ior = [low, high]`", "{ low = 1, high = 2 }"),
        ("ior", "ior = [1, '2']", "`film.ior[1]` is a string", "remove the quotes: 2", "'2'"),
        ("ior", "ior = [[1], 2]", "`film.ior[0]` is a list", "[low, high]", "[1]"),
        ("diffuse", "diffuse = 'true'", "`surface.diffuse` is a string", "without quotes", "'true'"),
        ("diffuse", "diffuse = 1", "`surface.diffuse` is a number", "`diffuse = true`", "1"),
        ("punctual", "punctual = 1.0", "`lights.punctual` is a number", "`punctual = true`", "1.0"),
        ("base_color", "base_color = 0.5", "`surface.base_color` is a number", "[0.1, 0.5, 0.2]", "0.5"),
        ("base_color", "base_color = '#fff'", "the string `#fff`", "base_color = \"input\"", "'#fff'"),
        ("base_color", "base_color = [1, 1, 'x']", "`surface.base_color[2]` is a string", "[0.1, 0.5, 0.2]", "'x'"),
        ("visibility_k", "visibility_k = true", "`surface.visibility_k` is true or false", "[low, high]", "true"),
        (
            "targets",
            "targets = 'wgsl'",
            "`emit.targets` is a string",
            "write a list even for one: `targets = [\"wgsl\"]`",
            "'wgsl'",
        ),
        ("targets", "targets = 1", "`emit.targets` is a number", "[\"first\", \"second\"]", "1"),
        ("targets", "targets = ['wgsl', 2]", "`emit.targets[1]` is a number", "write strings only", "2"),
        ("variant", "variant = 3", "`emit.variant` is a number", "in quotes", "3"),
    ]);
}

#[test]
fn a_list_of_the_wrong_length_is_refused() {
    check(&[
        ("ior", "ior = []", "lists 0 values, but a range has two", "one number for a constant", "[]"),
        ("ior", "ior = [1.33]", "lists 1 value, but a range has two", "one number for a constant", "[1.33]"),
        ("ior", "ior = [1, 2, 3]", "lists 3 values", "`ior = [low, high]`", "[1, 2, 3]"),
        ("base_color", "base_color = [1, 0]", "lists 2 values, but a colour has three", "[0.1, 0.5, 0.2]", "[1, 0]"),
        ("base_color", "base_color = [1, 0, 0, 1]", "lists 4 values", "[0.1, 0.5, 0.2]", "[1, 0, 0, 1]"),
    ]);
}

#[test]
fn a_range_that_is_none_is_refused() {
    check(&[
        (
            "thickness_nm",
            "thickness_nm = [1200, 0]",
            "reversed: it starts at 1200 and ends at 0",
            "`thickness_nm = [0, 1200]`",
            "[1200, 0]",
        ),
        ("ior", "ior = [1.5, 1.25]", "the range of `film.ior` is reversed", "`ior = [1.25, 1.5]`", "[1.5, 1.25]"),
        (
            "thickness_nm",
            "thickness_nm = [300, 300.0]",
            "empty: it starts and ends at 300",
            "`thickness_nm = 300`",
            "[300, 300.0]",
        ),
        (
            "roughness",
            "roughness = [0, -0.0]",
            "the range of `surface.roughness` is empty",
            "becomes a constant",
            "[0, -0.0]",
        ),
        ("metalness", "metalness = [1, 0]", "reversed", "`metalness = [0, 1]`", "[1, 0]"),
        ("visibility_k", "visibility_k = [1, 0]", "reversed", "`visibility_k = [0, 1]`", "[1, 0]"),
    ]);
}

#[test]
fn a_number_out_of_its_limits_is_refused() {
    check(&[
        ("ior", "ior = 0", "`film.ior` is 0, but a refractive index lies between 0.01 and 100", "water 1.33", "0"),
        ("ior", "ior = -1.33", "`film.ior` is -1.33", "water 1.33", "-1.33"),
        ("ior", "ior = [0, 2]", "`film.ior[0]` is 0", "water 1.33", "0"),
        ("ior", "ior = [1, 133]", "`film.ior[1]` is 133", "diamond 2.42", "133"),
        ("ior", "ior = nan", "`film.ior` is not a finite number", "water 1.33", "nan"),
        ("ior", "ior = [1, inf]", "`film.ior[1]` is not a finite number", "water 1.33", "inf"),
        ("ior", "ior = [-inf, 2]", "`film.ior[0]` is not a finite number", "water 1.33", "-inf"),
        ("ior", "ior = 1e999", "`film.ior` is not a finite number", "water 1.33", "1e999"),
        ("[film]", "[ambient]\nior = -1\n[film]", "`ambient.ior` is -1", "air is 1", "-1"),
        (
            "thickness_nm",
            "thickness_nm = -1",
            "`film.thickness_nm` is -1, but a film thickness lies",
            "in nanometres",
            "-1",
        ),
        ("thickness_nm", "thickness_nm = [-5, 5]", "`film.thickness_nm[0]` is -5", "0 is no film", "-5"),
        ("thickness_nm", "thickness_nm = 1000001", "between 0 and 1000000 nm", "in nanometres", "1000001"),
        ("thickness_nm", "thickness_nm = [0, 1e300]", "`film.thickness_nm[1]` is 1e300", "in nanometres", "1e300"),
        (
            "thickness_nm",
            "thickness_nm = 0xffffffffffffffffffffffffffffffffff",
            "too large a number",
            "above a million",
            "0xffffffffffffffffffffffffffffffffff",
        ),
        (
            "roughness",
            "roughness = 30",
            "`surface.roughness` is 30, but a roughness lies between 0 and 1",
            "divided by 100",
            "30",
        ),
        ("roughness", "roughness = [-0.1, 1]", "`surface.roughness[0]` is -0.1", "0 is a mirror", "-0.1"),
        ("metalness", "metalness = 1.5", "`surface.metalness` is 1.5, but a metalness lies", "1 a metal", "1.5"),
        ("metalness", "metalness = nan", "`surface.metalness` is not a finite number", "1 a metal", "nan"),
        (
            "visibility_k",
            "visibility_k = 2",
            "`surface.visibility_k` is 2",
            "\"punctual\" for (roughness + 1)^2 / 8",
            "2",
        ),
        (
            "base_color",
            "base_color = [26, 128, 51]",
            "`surface.base_color[0]` is 26",
            "divide 8-bit values by 255",
            "26",
        ),
        ("base_color", "base_color = [0, 0, -0.5]", "`surface.base_color[2]` is -0.5", "from 0 to 1", "-0.5"),
        (
            "base_color",
            "base_color = [0, nan, 0]",
            "`surface.base_color[1]` is not a finite number",
            "from 0 to 1",
            "nan",
        ),
    ]);
}

#[test]
fn a_name_that_is_not_known_is_refused_with_the_nearest() {
    check(&[
        (
            "observer",
            "observer = 'cie1964'",
            "unknown observer `cie1964`",
            "did you mean `cie1964-10deg`?",
            "'cie1964'",
        ),
        ("illuminant", "illuminant = 'd65'", "unknown illuminant `d65`", "did you mean `D65`?", "'d65'"),
        (
            "illuminant",
            "illuminant = 'F11'",
            "unknown illuminant `F11`",
            "the illuminants are: E, D65, D50, A",
            "'F11'",
        ),
        ("space", "space = 'sRGB'", "unknown colour space `sRGB`", "did you mean `linear-srgb`?", "'sRGB'"),
        (
            "workflow",
            "workflow = 'specular'",
            "unknown workflow `specular`",
            "the workflows are: metalness, f0",
            "'specular'",
        ),
        ("workflow", "metal = 'gold'", "unknown metal `gold`", "did you mean `Au`?", "'gold'"),
        ("workflow", "metal = 'Xx'", "unknown metal `Xx`", "the metals are: Ag, Ag-Rakic, Al, Au", "'Xx'"),
        (
            "visibility_k",
            "visibility_k = 'punktual'",
            "unknown visibility k `punktual`",
            "did you mean `punctual`?",
            "'punktual'",
        ),
        ("targets", "targets = ['wgsl', 'glsl']", "unknown target `glsl`", "did you mean `glsl450`?", "'glsl'"),
        ("targets", "targets = ['msl']", "unknown target `msl`", "the targets are: wgsl, glsl450", "'msl'"),
    ]);
}

#[test]
fn a_base_that_is_no_one_material_is_refused() {
    check(&[
        ("workflow", "", "`[base]` does not say what the material is", "give one of: `ior` (a dielectric)", "[base]"),
        ("workflow", "kappa = 3.8", "`base.kappa` is given without `base.ior`", "`ior = 2.7`", "3.8"),
        ("workflow", "ior = 1\nmetal = 'Au'", "more than once: by `ior`, by `metal`", "keep one of these", "metal"),
        (
            "workflow",
            "metal = 'Au'\nior = 1\nkappa = 2",
            "by `ior` and `kappa`, by `metal`",
            "keep one of these",
            "metal",
        ),
        (
            "workflow",
            "csv = 'x.csv'\nworkflow = 'metalness'",
            "by `csv`, by `workflow`",
            "keep one of these",
            "workflow",
        ),
        ("workflow", "workflow = 'f0'", "the workflow `f0` needs `base.f0`", "`f0 = \"input\"`", "'f0'"),
        (
            "workflow",
            "workflow = 'metalness'\nf0 = 'input'",
            "`base.f0` is given, but the base is not of the workflow `f0`",
            "remove `f0`",
            "f0",
        ),
        ("workflow", "f0 = [1, 1, 1]", "`base.f0` is given, but", "write `workflow = \"f0\"`", "f0"),
        (
            "workflow",
            "ior = 2\nedge_tint = 'input'",
            "`base.edge_tint` is given, but",
            "remove `edge_tint`",
            "edge_tint",
        ),
        ("workflow", "workflow = 'f0'\nf0 = 0.5", "`base.f0` is", "`f0 = [0.1, 0.5, 0.2]`", "0.5"),
        ("workflow", "workflow = 'f0'\nf0 = [0.5, 0.5]", "`base.f0` has", "`f0 = \"input\"`", "[0.5, 0.5]"),
        ("workflow", "workflow = 'f0'\nf0 = [0, 2, 0]", "`base.f0[1]` is 2, but", "divide 8-bit values", "2"),
        (
            "workflow",
            "workflow = 'f0'\nf0 = 'input'\nedge_tint = [0, 0, nan]",
            "`base.edge_tint[2]` is not a finite number",
            "colours are linear",
            "nan",
        ),
        (
            "workflow",
            "ior = 2\nworkflow = 'f0'\nf0 = 'input'",
            "by `ior`, by `workflow`",
            "keep one of these",
            "workflow",
        ),
        ("workflow", "kappa = 1\ncsv = 'x.csv'", "by `kappa`, by `csv`", "keep one of these", "csv"),
        ("workflow", "csv = ' '", "`base.csv` names no file", "`csv = \"nickel.csv\"`", "' '"),
        ("workflow", "ior = 0\nkappa = 1", "`base.ior` is 0, but a refractive index", "glass 1.52", "0"),
        ("workflow", "ior = 1\nkappa = -2", "`base.kappa` is -2, but an absorption index", "kappa positive", "-2"),
        ("workflow", "ior = 1\nkappa = [0, nan]", "`base.kappa[1]` is not a finite number", "kappa positive", "nan"),
        ("workflow", "ior = 1\nkappa = nan", "`base.kappa` is not a finite number", "kappa positive", "nan"),
    ]);
}

#[test]
fn what_must_go_together_is_asked_for() {
    check(&[
        ("ior", "", "`[film]` has no `ior`", "leave `[film]` out", "[film]"),
        ("thickness_nm", "", "`[film]` has no `thickness_nm`", "leave `[film]` out", "[film]"),
        (
            "base_color",
            "",
            "the metalness workflow needs `surface.base_color`",
            "`base_color = \"input\"`",
            "\"metalness\"",
        ),
        ("workflow", "ior = 1.5", "the base is not of the metalness workflow", "remove `metalness`", "[0, 1]"),
    ]);
    let surface = |keys: &str| format!("name = 'x'\n[surface]\n{keys}\n[base]\nior = 1.5");
    check_text(&surface("diffuse = true"), "a diffuse surface needs `surface.base_color`", "add to [surface]", "true");
    let unused = surface("base_color = 'input'");
    check_text(&unused, "`surface.base_color` has no effect here", "set `diffuse = true`", "'input'");
}

#[test]
fn a_scene_without_its_name_or_base_is_refused_where_they_would_stand() {
    check(&[("name", "", "the scene has no name", "start the file with `name = ", "")]);
    let help = "add a table `[base]`";
    check_text("name = 'x'\n", "does not say what the surface is made of", help, "");
    check_text("name = 'x'", "does not say what the surface is made of", help, "'");
    check_text("", "the scene has no name", "name = \"soap-bubble\"", "");
}

#[test]
fn a_name_or_prefix_that_no_code_could_carry_is_refused() {
    check(&[
        ("name", "name = ''", "the name of the scene is empty", "starts with a letter", "''"),
        ("name", "name = '2-films'", "starts with '2'", "starts with a letter", "'2-films'"),
        ("name", "name = 'soap bubble'", "contains ' '", "digits, - and _", "'soap bubble'"),
        ("name", "name = '../x'", "starts with '.'", "soap-bubble", "'../x'"),
        ("name", "name = 'a/b'", "contains '/'", "soap-bubble", "'a/b'"),
        ("name", "name = 'bulle-de-savon-été'", "contains 'é'", "soap-bubble", "'bulle-de-savon-été'"),
        ("prefix", "prefix = 'Test'", "starts with 'T'", "a letter from a to z", "'Test'"),
        ("prefix", "prefix = '_x'", "starts with '_'", "a letter from a to z", "'_x'"),
        ("prefix", "prefix = 'soap-'", "contains '-'", "single underscores", "'soap-'"),
        ("prefix", "prefix = 'soap__'", "two underscores in a row", "single underscores", "'soap__'"),
        ("prefix", "prefix = 'gl_'", "starts with `gl_`", "soap_", "'gl_'"),
    ]);
    let long = "x".repeat(65);
    let text = edited("name", &format!("name = '{long}'"));
    check_text(&text, "has 65 characters", "at most 64", &format!("'{long}'"));
    let text = edited("prefix", &format!("prefix = '{long}'"));
    check_text(&text, "has 65 characters", "at most 64", &format!("'{long}'"));
}

#[test]
fn rates_are_refused_where_there_is_no_such_input_or_rate() {
    let of_inputs = "the inputs with a rate are: thickness_nm, ambient_ior";
    let fixed_film = "`ior = [low, high]` at `film.ior`";
    let cases = [
        ("opacity = 'pixel'", "unknown input `opacity` in [rates]", of_inputs, "opacity"),
        ("n_dot_l = 'pixel'", "unknown input `n_dot_l`", of_inputs, "n_dot_l"),
        ("thickness = 'pixel'", "unknown input `thickness`", "did you mean `thickness_nm`?", "thickness"),
        ("roughness = 'often'", "unknown rate `often`", "the rates are: material, vertex, pixel", "'often'"),
        ("roughness = 'uniform'", "unknown rate `uniform`", "did you mean `material`?", "'uniform'"),
        ("roughness = 1", "`rates.roughness` is a number", "in quotes", "1"),
        ("film_ior = 'pixel'", "`film_ior` is fixed, so that it has no rate", fixed_film, "'pixel'"),
        ("base_color = 'pixel'", "`base_color` is fixed", "`base_color = \"input\"`", "'pixel'"),
        ("visibility_k = 'pixel'", "`visibility_k` is fixed", "[low, high]", "'pixel'"),
        ("base_kappa = 'pixel'", "this scene has no `base_kappa`", "remove this line", "base_kappa"),
    ];
    for (line, message, help, at) in cases {
        check_text(&edited("[emit]", &format!("[rates]\n{line}\n[emit]")), message, help, at);
    }
    check(&[
        ("[emit]", "rates = 'pixel'\n[emit]", "unknown key `rates` in [lights]", "start it with `[rates]`", "rates"),
        ("prefix", "prepare = 'yes'", "`emit.prepare` is a string", "`prepare = true`", "'yes'"),
    ]);
}

#[test]
fn targets_and_variant_are_refused_when_empty_or_doubled() {
    check(&[
        ("targets", "targets = []", "nothing would be emitted", "list at least one of: wgsl", "[]"),
        ("targets", "targets = ['spirv', 'wgsl', 'spirv']", "lists `spirv` twice", "keep one of the two", "'spirv'"),
        ("variant", "variant = ''", "`emit.variant` is empty", "series:m=3,fit=xyz-gauss", "''"),
    ]);
    let text = edited("targets", "targets = ['spirv', 'wgsl', 'spirv']");
    assert_eq!(refusal(&text).key(), Some("emit.targets[2]"));
}

#[test]
fn an_error_names_the_line_and_the_column() {
    let error = refusal(&edited("thickness_nm", "thickness_nm = [0, -1]"));
    assert_eq!(error.location(), Some(("test.toml", 8, 20)));
    assert_eq!(error.key(), Some("film.thickness_nm[1]"));
    let plain = format!("{error:?}");
    assert!(plain.starts_with("test.toml:8:20: `film.thickness_nm[1]` is -1, "), "{plain}");
    assert!(plain.contains("\n  help: thickness is in nanometres"), "{plain}");
}

#[test]
fn an_error_in_a_line_too_long_to_be_drawn_names_its_place() {
    let error = refusal(&edited("name", &format!("name = '{}!'", "x".repeat(70_000))));
    assert_eq!(error.to_string(), "the name of the scene contains '!' (test.toml, line 1, column 8)");
    assert_eq!(error.location(), Some(("test.toml", 1, 8)));
    let mut drawn = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor());
    handler.render_report(&mut drawn, &error).expect("an error can be drawn");
    assert!(drawn.contains("(test.toml, line 1, column 8)") && drawn.len() < 1000, "{drawn}");
}

#[test]
fn text_of_the_scene_reaches_a_message_short_and_without_control_characters() {
    let text = edited("space", r#"space = "\u001b[31mred\u001b[0m""#);
    check_text(&text, r"unknown colour space `\u{1b}[31mred\u{1b}[0m`", "linear-srgb", r#""\u001b[31mred\u001b[0m""#);
    let error = refusal(&edited("space", &format!("space = '{}'", "x".repeat(1000))));
    assert!(error.to_string().chars().count() < 100, "{error}");
}

#[test]
fn an_error_is_drawn_with_its_line_its_labels_and_its_help() {
    let text = edited("workflow", "ior = 1.5\nmetal = \"Au\"");
    let mut drawn = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor()).with_width(200);
    handler.render_report(&mut drawn, &refusal(&text)).expect("an error can be drawn");
    let lines: Vec<&str> = drawn.lines().map(str::trim_end).collect();
    let expected = [
        "pavo::scene",
        "",
        "  × `[base]` describes the material more than once: by `ior`, by `metal`",
        "    ╭─[test.toml:11:1]",
        "  9 │ [base]",
        " 10 │ ior = 1.5",
        "    · ─┬─",
        "    ·  ╰── described here",
        " 11 │ metal = \"Au\"",
        "    · ──┬──",
        "    ·   ╰── and again here",
        " 12 │ [surface]",
        "    ╰────",
        "  help: keep one of these: `ior` (a dielectric), `ior` and `kappa` (a conductor), `metal` (such as Au, Al, Ti, Si), \
         `csv` (a file of wavelength, n, k), `workflow = \"metalness\"`, `workflow = \"f0\"` and `f0` (what it reflects at \
         normal incidence)",
    ];
    assert_eq!(lines, expected);
}
