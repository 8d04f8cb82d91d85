//! The command that makes a text, as it stands at the text's top.

use crate::inputs::ShadingQuantity;
use crate::target::Target;
use crate::variant::Variant;
use pavo_emit::Form;
use std::path::Path;

/// The command that emits this text.
pub fn emit(scene: &Path, target: Target, variant: &Variant, form: Form, quantity: ShadingQuantity) -> String {
    let scene = quoted(scene);
    let mut command = format!("pavo emit {scene} --target {target} --variant {variant} --form {}", form.name());
    if form == Form::Compute {
        command.push_str(" --quantity ");
        command.push_str(quantity.name());
    }
    command
}

/// A path as a shell reads it. It stands in comments too, so that what would end a line there is escaped.
pub fn quoted(path: &Path) -> String {
    let path = pavo_files::shown(path);
    if path.contains(|character: char| character.is_whitespace() || "'\"\\$".contains(character)) {
        format!("'{}'", path.replace('\'', "'\\''"))
    } else {
        path
    }
}
