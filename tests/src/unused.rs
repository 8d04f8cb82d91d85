//! Names that an emitted text declares and does not use.

use pavo::Shading;
use pavo_emit::Language;

/// The inputs, functions, parameters, local variables and fields that the WGSL of a surface declares and does not use.
pub fn unused_names(shading: &Shading) -> Vec<String> {
    let text = code(&pavo::library(shading, Language::Wgsl));
    let entry = if shading.scene().lights.punctual { "shade_surface" } else { "surface_brdf" };
    let program = shading.program(pavo::library_quantity(shading.scene()));
    let inputs = program.inputs().iter().map(|input| input.name.as_str());
    let idle = inputs.filter(|name| uses(&text, name) < 2);
    unused(&text, entry).into_iter().chain(idle).map(str::to_owned).collect()
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
pub fn code(text: &str) -> String {
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

#[cfg(test)]
mod tests {
    use super::unused;

    #[test]
    fn an_unused_name_is_found() {
        let text = "struct Pair {\n    kept: f32,\n    lost: f32,\n}\n\
                    fn idle(x: f32) -> f32 {\n    return x;\n}\n\
                    struct Rest {\n    y: f32,\n}\n\
                    fn entry(x: f32, y: f32) -> f32 {\n    let pair = Pair(x, x);\n    var z = 1.0;\n    return pair.kept;\n}\n";
        assert_eq!(unused(text, "entry"), ["idle", "y", "z", "lost", "y"]);
    }
}
