//! What a scene fixes is paid for no more: fixing never makes a surface dearer, saves as much as is promised, and leaves
//! nothing unused in the text.

use pavo_check::static_cost::StaticCompiler;
use pavo_emit::Language;
use pavo_savings::{Case, FAMILY, Pair, Quantity, Saving, cases};
use pavo_tests::unused::{code, unused_names};
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
        assert_eq!(unused_names(&shading), [""; 0], "{name}");
    }
}
