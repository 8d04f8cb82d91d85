//! Composes a shader with the functions of a film as Bevy does, by naga_oil, and has naga validate it: the material of
//! the example `bevy-film`, or a shader and a module of yours, which are then written as SPIR-V.

use naga::back::spv;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor, ShaderDefValue};
use std::process::ExitCode;

/// The functions of the film, as the module `pavo::thin_film`.
const FILM: &str = include_str!(concat!(env!("OUT_DIR"), "/film.wgsl"));

const MATERIAL: &str = include_str!("../../bevy-film/assets/film.wgsl");

/// What the material imports of Bevy, as far as it uses it.
const BEVY: [&str; 2] = [
    "#define_import_path bevy_pbr::forward_io
    struct VertexOutput {
        @builtin(position) position: vec4f,
        @location(0) world_position: vec4f,
        @location(1) world_normal: vec3f,
    }",
    "#define_import_path bevy_pbr::mesh_view_bindings
    struct View { world_position: vec3f }
    @group(0) @binding(0) var<uniform> view: View;",
];

const USAGE: &str = "nothing, for the material of bevy-film; or MODULE.wgsl SHADER.wgsl RESULT.spv";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let result = match &arguments[..] {
        [] => composed(FILM, "film.wgsl", MATERIAL)
            .map(|(module, _)| format!("film.wgsl with pavo::thin_film: {}", said(&module))),
        [module, shader, result] => written(module, shader, result),
        _ => Err(format!("too many words or too few: {USAGE}")),
    };
    match result {
        Ok(line) => {
            println!("{line}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn said(module: &naga::Module) -> String {
    format!("composed by naga_oil, valid for naga, {} functions", module.functions.len())
}

/// Composes files, and writes the SPIR-V of the whole.
fn written(module: &str, shader: &str, result: &str) -> Result<String, String> {
    let read = |file: &str| std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"));
    let (composed, info) = composed(&read(module)?, shader, &read(shader)?)?;
    let options = spv::Options { lang_version: (1, 3), ..spv::Options::default() };
    let words = spv::write_vec(&composed, &info, &options, None).map_err(|error| error.to_string())?;
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write(result, bytes).map_err(|error| format!("{result}: {error}"))?;
    Ok(format!("{shader} with {module}: {}", said(&composed)))
}

fn composed(film: &str, name: &str, shader: &str) -> Result<(naga::Module, ModuleInfo), String> {
    let mut composer = Composer::default();
    for (path, source) in [("forward_io", BEVY[0]), ("mesh_view_bindings", BEVY[1]), ("pavo", film)] {
        let module = ComposableModuleDescriptor { source, file_path: path, ..Default::default() };
        if let Err(error) = composer.add_composable_module(module) {
            return Err(error.emit_to_string(&composer));
        }
    }
    let shader = NagaModuleDescriptor {
        source: shader,
        file_path: name,
        shader_defs: [("MATERIAL_BIND_GROUP".to_owned(), ShaderDefValue::UInt(3))].into(),
        ..Default::default()
    };
    let module = match composer.make_naga_module(shader) {
        Ok(module) => module,
        Err(error) => return Err(error.emit_to_string(&composer)),
    };
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(""))?;
    Ok((module, info))
}
