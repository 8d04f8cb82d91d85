//! The emitted text of every starter scene in every text language, as a reader of the product sees it.

use pavo::scene::{Base, ColourQuantity, Scene};
use pavo::{Emission, Shading};
use pavo_emit::Language;
use pavo_tests::{SCENES, starter};
use std::collections::BTreeSet;

fn emitted(name: &str, language: Language) -> String {
    let shading = starter(name);
    let command = format!("pavo emit templates/scenes/{name}.toml --target {} --form library", language.name());
    pavo::library(&shading, Emission { language, command: &command, source_lines: false })
}

#[test]
fn the_starter_scenes_are_emitted_as_reviewed() {
    for name in SCENES {
        for language in Language::ALL {
            insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
                insta::assert_snapshot!(format!("{name}.{}", language.name()), emitted(name, language));
            });
        }
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    for name in SCENES {
        for language in Language::ALL {
            assert_eq!(emitted(name, language), emitted(name, language), "{name} in {}", language.name());
        }
    }
}

#[test]
fn no_text_holds_a_name_without_meaning() {
    for name in SCENES {
        for language in Language::ALL {
            let text = emitted(name, language);
            let words = text.split(|character: char| !character.is_alphanumeric() && character != '_');
            let bad: Vec<&str> = words.filter(|word| word.starts_with("_e") || word.contains("__")).collect();
            assert!(bad.is_empty(), "{name} in {}: {bad:?}", language.name());
        }
    }
}

/// The words of a text that end in `_2`.
fn second_names(text: &str) -> BTreeSet<&str> {
    let words = text.split(|character: char| !character.is_alphanumeric() && character != '_');
    words.filter(|word| word.ends_with("_2")).collect()
}

#[test]
fn no_name_but_that_of_the_normal_gives_way_to_a_reserved_word() {
    for name in SCENES {
        let wgsl = emitted(name, Language::Wgsl);
        for language in Language::ALL {
            let text = emitted(name, language);
            let mut renamed: Vec<&str> = second_names(&text).difference(&second_names(&wgsl)).copied().collect();
            // In OSL a normal is a type; everywhere else it is what engines call it.
            renamed.retain(|word| *word != "normal_2" || language != Language::Osl);
            assert!(renamed.is_empty(), "{name} in {}: {renamed:?}", language.name());
        }
    }
}

#[test]
fn the_index_of_a_base_by_its_f0_is_emitted_as_reviewed() {
    let base = Base::f0(ColourQuantity::Input, Some(ColourQuantity::Input));
    let scene = Scene::builder("metal", base).film(1.5, 0.0..=900.0).build().expect("a scene");
    let shading = Shading::new(&scene, &"nodes:n=6".parse().expect("a variant")).expect("a surface");
    for language in [Language::Wgsl, Language::Essl300] {
        let text = pavo::library(&shading, Emission { language, command: "", source_lines: false });
        let start = text.find("// Complex refractive index").expect("the function is there");
        let end = start + text[start..].find("\n}\n").expect("the function ends");
        let function = &text[start..end + 2];
        insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
            insta::assert_snapshot!(format!("index-from-f0.{}", language.name()), function);
        });
    }
}

#[test]
fn in_osl_no_component_is_taken_of_what_has_no_name() {
    // Each channel has an index of its own, and where each is metallic is asked of a vector.
    let base = Base::f0(ColourQuantity::Input, Some(ColourQuantity::Fixed([0.9, 0.6, 0.5])));
    let scene = Scene::builder("metal", base).film(1.5, 0.0..=900.0).build().expect("a scene");
    for variant in ["poles:k=5", "windowed:k=6", "spectral:n=16"] {
        let shading = Shading::new(&scene, &variant.parse().expect("a variant")).expect("a surface");
        let text = pavo::library(&shading, Emission { language: Language::Osl, command: "", source_lines: false });
        assert!(text.contains("is_metallic[0]"), "{variant} chooses by component");
        assert!(!text.contains(")["), "{variant}: {}", text.lines().find(|line| line.contains(")[")).unwrap_or(""));
    }
}
