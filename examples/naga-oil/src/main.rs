//! Composes the material of the example `bevy-film` as Bevy does, by naga_oil, and has naga validate it.

use naga::valid::{Capabilities, ValidationFlags, Validator};
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

fn main() -> ExitCode {
    match composed() {
        Ok(functions) => {
            println!("film.wgsl with pavo::thin_film: composed by naga_oil, valid for naga, {functions} functions");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn composed() -> Result<usize, String> {
    let mut composer = Composer::default();
    for (path, source) in [("forward_io", BEVY[0]), ("mesh_view_bindings", BEVY[1]), ("pavo", FILM)] {
        let module = ComposableModuleDescriptor { source, file_path: path, ..Default::default() };
        if let Err(error) = composer.add_composable_module(module) {
            return Err(error.emit_to_string(&composer));
        }
    }
    let material = NagaModuleDescriptor {
        source: MATERIAL,
        file_path: "film.wgsl",
        shader_defs: [("MATERIAL_BIND_GROUP".to_owned(), ShaderDefValue::UInt(3))].into(),
        ..Default::default()
    };
    let module = match composer.make_naga_module(material) {
        Ok(module) => module,
        Err(error) => return Err(error.emit_to_string(&composer)),
    };
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
    validator.validate(&module).map_err(|error| error.emit_to_string(""))?;
    Ok(module.functions.len())
}
