//! `pavo emit`: one shader.

use super::arguments;
use super::failure::Failure;
use super::output;
use super::sources::Source;
use pavo_emit::Form;

/// Emits one shader, judged, to a file or to standard output.
pub fn run(arguments: &arguments::Emit) -> Result<(), Failure> {
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    let form = arguments.form.map_or(arguments.target.default_form(), Form::from);
    let emitted = source.emit_with(arguments.target, form, arguments.quantity.into(), arguments.source_lines)?;
    output::write_or_print(arguments.output.as_deref(), &emitted.bytes)
}
