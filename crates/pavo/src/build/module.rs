//! The Rust module beside the texts.

use super::file_name;
use crate::emission::{library, prepared_bytes, uniforms};
use crate::shading::Shading;
use pavo_emit::Language;

/// The constants of the texts, the struct of what is uniform and, where it is asked for, the functions for the CPU.
pub fn module(shading: &Shading, targets: &[Language]) -> String {
    let scene = &shading.scene().name;
    let mut text = format!("// {scene} by {}, made by pavo {}.\n", shading.variant(), env!("CARGO_PKG_VERSION"));
    for language in targets {
        if let Some((constant, described)) = constant(*language) {
            let file = file_name(scene, *language);
            text.push_str(&format!(
                "\n/// The functions of the surface in {described}, and the struct of what is uniform.\n\
                 pub const {constant}: &str = include_str!(\"{file}\");\n"
            ));
        }
    }
    let has_functions = targets.contains(&Language::Rust);
    let functions = has_functions.then(|| library(shading, Language::Rust));
    let bytes = if has_functions { prepared_bytes(shading) } else { None };
    for part in [uniforms(shading, Language::Rust), functions, bytes].into_iter().flatten() {
        text.push('\n');
        text.push_str(&part);
    }
    text
}

/// The name of the constant with a text, and its language in words; Rust is no text of the module.
fn constant(language: Language) -> Option<(&'static str, &'static str)> {
    match language {
        Language::Wgsl => Some(("WGSL", "WGSL")),
        Language::Glsl450 => Some(("GLSL_450", "GLSL 4.50")),
        Language::Glsl330 => Some(("GLSL_330", "GLSL 3.30")),
        Language::Essl300 => Some(("ESSL_300", "GLSL ES 3.00")),
        Language::Hlsl => Some(("HLSL", "HLSL")),
        Language::Osl => Some(("OSL", "OSL")),
        Language::Rust => None,
    }
}
