//! What stands beside the code: the page that checks it in a browser, and what says where it goes.

use super::engines::{Engine, EngineFile, template};
use crate::cli::build::{vector_points, vector_tolerance};
use crate::cli::failure::Failure;
use crate::cli::sources::Source;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value, context};
use pavo_emit::Language;
use pavo_shade::Type;
use serde_json::json;

/// The name of the page that checks a file, which is that of its template.
pub fn check_file(file: &EngineFile) -> Result<&'static str, Failure> {
    Ok(if file.language()? == Language::Wgsl { "check-wgsl.html" } else { "check.html" })
}

/// The page that runs a file's function in a browser at the test vectors.
pub fn check(source: &Source, engine: &Engine, file: &EngineFile, text: &str) -> Result<String, Failure> {
    let (inputs, rows) = vector_points(source);
    let mut column = 0;
    let mut columns = Vec::new();
    for input in &inputs {
        columns.push((input.name.as_str(), column));
        column += input.components();
    }
    let column_of = |names: &str| {
        let found = columns.iter().find(|(name, _)| names.split(' ').any(|wanted| wanted == *name));
        found.map_or(-1, |(_, column)| i64::try_from(*column).unwrap_or(-1))
    };
    let passed = file.parameters.iter().map(|[name, names]| {
        let is_color =
            [format!("vec3 {name}"), format!("{name}: vec3f")].iter().any(|text| file.signature.contains(text));
        json!({ "uniform": format!("given_{name}"), "type": if is_color { "vec3" } else { "float" },
            "passed": true, "column": column_of(names) })
    });
    // What is a literal needs no uniform.
    let outer = inputs.iter().filter(|input| file.parameter(&input.name).is_none()).filter_map(|input| {
        let expression = file.given.get(&input.name).filter(|text| text.parse::<f64>().is_err())?;
        let kind = if input.ty == Type::Vec3 { "vec3" } else { "float" };
        Some(json!({ "uniform": expression, "type": kind, "passed": false, "column": column_of(&input.name) }))
    });
    let parameters: Vec<_> = passed.chain(outer).collect();
    let vectors: Vec<Vec<f64>> = rows.into_iter().map(|(point, color)| [point, color.to_vec()].concat()).collect();
    let page = check_file(file)?;
    // Of WGSL what the engine has above the text can stand in one piece with it; GLSL has uniforms between the two.
    let judged = file.judged(text);
    let code = if page == "check-wgsl.html" { &judged } else { text };
    let fill = context! {
        scene => source.shading.scene().name.as_str(),
        title => engine.title.as_str(),
        file => file.file.as_str(),
        function => file.check.as_str(),
        code => literal(&json!(code)),
        before => literal(&json!(file.before)),
        parameters => literal(&json!(parameters)),
        vectors => literal(&json!(vectors)),
        tolerance => vector_tolerance(source),
    };
    render(page, fill)
}

/// The text that says where the files go.
pub fn readme(
    source: &Source,
    engine: &Engine,
    [scene_file, command, error, cost]: [&str; 4],
    notes: Vec<String>,
    files: &[String],
) -> Result<String, Failure> {
    let fill = context! {
        scene => source.shading.scene().name.as_str(),
        title => engine.title.as_str(),
        version => env!("CARGO_PKG_VERSION"),
        variant => source.shading.variant().to_string(),
        hook => engine.hook.trim(),
        files => files.join(", "),
        tried => engine.tried.as_str(),
        verified => engine.verified.as_str(),
        scene_file, command, error, cost, notes,
    };
    render("README.md", fill)
}

/// A value as a script writes it; a text in it cannot end the script.
fn literal(value: &serde_json::Value) -> Value {
    Value::from_safe_string(value.to_string().replace('<', "\\u003c"))
}

fn render(name: &str, values: Value) -> Result<String, Failure> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment
        .set_auto_escape_callback(|name| if name.ends_with(".html") { AutoEscape::Html } else { AutoEscape::None });
    let text = environment
        .render_named_str(name, template(name)?, values)
        .map_err(|error| Failure::check(format!("the template {name} cannot be filled: {error:#}")))?;
    Ok(text.trim_end().to_owned() + "\n")
}
