//! The emitted text of every starter scene in every text language, as a reader of the product sees it.

use pavo::Emission;
use pavo_emit::Language;
use pavo_tests::{SCENES, starter};

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
