//! What a scene fixes is paid for no more: fixing never makes a surface dearer, saves as much as is promised, and leaves
//! nothing unused in the text.

use pavo_check::static_cost::StaticCompiler;
use pavo_emit::Language;
use pavo_savings::{Case, FAMILY, Pair, Quantity, Saving, cases};
use pavo_tests::{SCENES, starter};

fn all_cases() -> Vec<Case> {
    cases().unwrap_or_else(|error| panic!("{error}"))
}

/// A saving as it is named in a failure; nothing where it is as large as promised.
fn shortfall(pair: &Pair<'_>, unit: &str, saving: Saving) -> Option<String> {
    let Case { what, variant, at_most, .. } = pair.case;
    let ratio = saving.ratio();
    println!("{what}, {variant}: {unit} {} to {}, {ratio:.3}", saving.from, saving.to);
    (ratio > *at_most).then(|| format!("{what}, {variant}: {unit} {saving:?}, {ratio:.3} above {at_most}"))
}

#[test]
fn fixing_never_makes_a_scene_dearer() {
    let compiler = StaticCompiler::open(FAMILY).unwrap_or_else(|error| panic!("{FAMILY}: {error}"));
    let cases = all_cases();
    let mut missed = Vec::new();
    for case in &cases {
        let pair = Pair::new(case).unwrap_or_else(|error| panic!("{}: {error}", case.what));
        let cycles = pair.cycles(&compiler).unwrap_or_else(|error| panic!("{}: {error}", case.what));
        missed.extend(shortfall(&pair, "operations", pair.operations()));
        missed.extend(shortfall(&pair, FAMILY, cycles));
        if let Some([from, to]) = pair.rms {
            let limit = case.max_rms.unwrap_or(from);
            assert!(to <= limit, "{}: an RMS error of {to:.2e}, {limit:.2e} is allowed", case.what);
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn only_the_lobes_are_left_that_a_metalness_has() {
    // A name that the text has where metalness varies, and whether it is left at 0 and at 1.
    let rows = [("diffuse", [true, false]), ("lambert", [true, false]), ("metalness", [false, false])];
    for (end, what) in ["metalness 0", "metalness 1"].into_iter().enumerate() {
        let cases = all_cases();
        let case = cases.iter().find(|case| case.what == what).unwrap_or_else(|| panic!("no case {what}"));
        assert_eq!(case.quantity, Quantity::Surface, "{what}");
        let pair = Pair::new(case).unwrap_or_else(|error| panic!("{what}: {error}"));
        let [from, to] = [&pair.from, &pair.to].map(|shading| code(&pavo::library(shading, Language::Wgsl)));
        for (name, left) in rows {
            assert!(from.contains(name), "{name} is nowhere:\n{from}");
            assert_eq!(to.contains(name), left[end], "{what}, {name}:\n{to}");
        }
    }
}

#[test]
fn the_starter_scenes_declare_nothing_unused() {
    for name in SCENES {
        let shading = starter(name);
        let text = code(&pavo::library(&shading, Language::Wgsl));
        let entry = if shading.scene().lights.punctual { "shade_surface" } else { "surface_brdf" };
        assert_eq!(unused(&text, entry), [""; 0], "{name}:\n{text}");
        for input in shading.program(pavo::library_quantity(shading.scene())).inputs() {
            assert!(uses(&text, &input.name) > 1, "{name}: the input `{}` is not used\n{text}", input.name);
        }
    }
}

#[test]
fn an_unused_name_is_found() {
    let text = "struct Pair {\n    kept: f32,\n    lost: f32,\n}\n\
                fn idle(x: f32) -> f32 {\n    return x;\n}\n\
                struct Rest {\n    y: f32,\n}\n\
                fn entry(x: f32, y: f32) -> f32 {\n    let pair = Pair(x, x);\n    var z = 1.0;\n    return pair.kept;\n}\n";
    assert_eq!(unused(text, "entry"), ["idle", "y", "z", "lost", "y"]);
}

/// The functions, parameters, local variables and fields that a text declares and does not use.
fn unused<'a>(text: &'a str, entry: &str) -> Vec<&'a str> {
    let mut found = Vec::new();
    for function in text.split("fn ").skip(1) {
        // What follows a function may be a struct.
        let function = function.split("\n}").next().unwrap_or_default();
        let declared = function.split('(').next().unwrap_or_default();
        if declared != entry && uses(text, declared) < 2 {
            found.push(declared);
        }
        found.extend(parameters(function).into_iter().chain(locals(function)).filter(|name| uses(function, name) < 2));
    }
    let is_read = |field: &str| text.split('.').skip(1).any(|rest| rest.split(|c| !is_part(c)).next() == Some(field));
    found.extend(fields(text).into_iter().filter(|field| !is_read(field)));
    found
}

/// A text without its comments.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

fn is_part(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

/// How often a name stands in a text, other than as a field of something.
fn uses(text: &str, name: &str) -> usize {
    let found = text.match_indices(name).filter(|(place, _)| {
        let (before, after) = (&text[..*place], &text[place + name.len()..]);
        !before.ends_with(|last: char| is_part(last) || last == '.') && !after.starts_with(is_part)
    });
    found.count()
}

/// The parameters of a function, whose text starts with its name.
fn parameters(function: &str) -> Vec<&str> {
    let list = function.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map_or("", |(list, _)| list);
    list.split(',').filter_map(|parameter| parameter.split_once(':')).map(|(name, _)| name.trim()).collect()
}

/// The local variables of a function.
fn locals(function: &str) -> Vec<&str> {
    let declared = |line: &'_ str| -> Option<usize> {
        let line = line.trim_start();
        ["let ", "var "].into_iter().find(|keyword| line.starts_with(keyword)).map(str::len)
    };
    let name = |line| Some(str::trim_start(line).get(declared(line)?..)?.split([' ', ':', '=']).next()?.trim());
    function.lines().filter_map(name).collect()
}

/// The fields of all structs.
fn fields(text: &str) -> Vec<&str> {
    let bodies = text.split("struct ").skip(1).filter_map(|rest| rest.split_once('{')?.1.split_once('}'));
    bodies.flat_map(|(body, _)| body.split(',')).filter_map(|field| Some(field.split_once(':')?.0.trim())).collect()
}
