//! A program as text: header, structs, functions.

use crate::Options;
use crate::dialect::{Dialect, Syntax};
use crate::function::{self, Body, Context};
use crate::namer::Namer;
use pavo_shade::{Definition, Program, Type};

const WIDTH: usize = 100;

/// The names that a program has outside of its functions.
pub struct Names {
    pub functions: Vec<String>,
    /// For each function, the struct that it returns and its fields; nothing where it returns one value.
    pub structs: Vec<Option<Struct>>,
    pub outer: Namer,
}

/// A struct as it is printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Struct {
    pub name: String,
    pub fields: Vec<(String, Type, String)>,
}

impl Names {
    pub fn new(program: &Program, prefix: &str) -> Self {
        let mut outer = Namer::default();
        let functions: Vec<String> =
            program.functions().iter().map(|function| outer.fresh(&format!("{prefix}{}", function.name))).collect();
        let mut known: Vec<Struct> = Vec::new();
        let mut structs = Vec::new();
        for (function, name) in program.functions().iter().zip(&functions) {
            if function.results.len() < 2 {
                structs.push(None);
                continue;
            }
            let mut fields = Namer::default();
            let fields: Vec<(String, Type, String)> = function
                .results
                .iter()
                .map(|result| (fields.fresh(&result.name), result.ty, result.doc.clone()))
                .collect();
            let wanted = match &function.result_type {
                Some(name) => format!("{}{name}", camel_case(prefix)),
                None => format!("{}Result", camel_case(name)),
            };
            let same = known.iter().find(|other| other.fields == fields && other.name.starts_with(&wanted)).cloned();
            let printed = same.unwrap_or_else(|| {
                let made = Struct { name: outer.fresh(&wanted), fields };
                known.push(made.clone());
                made
            });
            structs.push(Some(printed));
        }
        Self { functions, structs, outer }
    }

    /// The fields of the struct that each function returns.
    pub fn fields(&self) -> Vec<Vec<String>> {
        let names = |made: &Struct| made.fields.iter().map(|(name, ..)| name.clone()).collect();
        self.structs.iter().map(|made| made.as_ref().map(names).unwrap_or_default()).collect()
    }
}

/// The functions of a program with a header and no entry point.
pub fn library(program: &Program, options: &Options) -> String {
    let dialect = Dialect::of(options.language);
    let names = Names::new(program, &options.prefix);
    let mut text = comment(&options.header);
    if !dialect.preamble.is_empty() {
        text.push('\n');
        text.push_str(dialect.preamble);
    }
    text.push_str(&functions(program, options, &names));
    text
}

/// The structs and functions of a program.
pub fn functions(program: &Program, options: &Options, names: &Names) -> String {
    let dialect = Dialect::of(options.language);
    let fields = names.fields();
    let context = Context {
        dialect,
        functions: &names.functions,
        structs: &names.structs,
        fields: &fields,
        outer: &names.outer,
        source_lines: options.source_lines,
    };
    let mut text = String::new();
    let mut printed: Vec<&Struct> = Vec::new();
    for (index, definition) in program.functions().iter().enumerate() {
        if let Some(made) = &names.structs[index]
            && !printed.contains(&made)
        {
            text.push('\n');
            text.push_str(&structure(dialect, made));
            printed.push(made);
        }
        text.push('\n');
        text.push_str(&function(&context, definition, index));
    }
    text
}

fn structure(dialect: &Dialect, made: &Struct) -> String {
    let mut text = format!("struct {} {{\n", made.name);
    for (name, ty, doc) in &made.fields {
        if !doc.is_empty() {
            text.push_str(&indent(&comment(&[doc.replace('`', "")])));
        }
        let end = if dialect.syntax == Syntax::Wgsl { "," } else { ";" };
        text.push_str(&format!("    {}{end}\n", dialect.typed(dialect.type_name(*ty), name)));
    }
    text.push_str(if dialect.syntax == Syntax::Wgsl { "}\n" } else { "};\n" });
    text
}

fn function(context: &Context<'_>, definition: &Definition, index: usize) -> String {
    let Body { parameters, statements, results } = function::body(context, definition);
    let mut doc: Vec<String> = definition.doc.iter().map(|line| line.replace('`', "")).collect();
    let documented: Vec<String> = definition
        .parameters
        .iter()
        .zip(&parameters)
        .filter(|(parameter, _)| !parameter.doc.is_empty())
        .map(|(parameter, name)| format!("{name}: {}", lower_first(&parameter.doc.replace('`', ""))))
        .collect();
    if !doc.is_empty() && !documented.is_empty() {
        doc.push(String::new());
    }
    doc.extend(documented);
    let typed: Vec<(String, Type)> =
        parameters.into_iter().zip(definition.parameters.iter().map(|parameter| parameter.ty)).collect();
    let (result, value) = match &context.structs[index] {
        Some(made) => (made.name.clone(), construct(&made.name, &results)),
        None => (context.dialect.type_name(definition.results[0].ty).to_owned(), results[0].clone()),
    };
    let mut text = comment(&doc);
    text.push_str(&function::head(context.dialect, &context.functions[index], &typed, &result));
    text.push('\n');
    for statement in statements.iter().chain([&format!("return {value};")]) {
        text.push_str(&indent(statement));
    }
    text.push_str("}\n");
    text
}

/// A struct of its fields, over several lines when long.
fn construct(name: &str, fields: &[String]) -> String {
    let line = format!("{name}({})", fields.join(", "));
    if line.len() < WIDTH { line } else { format!("{name}(\n    {}\n)", fields.join(",\n    ")) }
}

/// Lines as a comment. Paragraphs, which empty lines end, are filled to the width of the text.
pub fn comment(lines: &[String]) -> String {
    let mut text = String::new();
    let mut pending = String::new();
    let flush = |pending: &mut String, text: &mut String| {
        if !pending.is_empty() {
            text.push_str(&format!("// {pending}\n"));
            pending.clear();
        }
    };
    for line in lines {
        flush(&mut pending, &mut text);
        if line.is_empty() {
            text.push_str("//\n");
            continue;
        }
        for word in line.split_inclusive(' ') {
            if pending.len() + word.trim_end().len() > WIDTH - 3 {
                text.push_str(&format!("// {}\n", pending.trim_end()));
                pending = "    ".to_owned();
            }
            pending.push_str(word);
        }
    }
    flush(&mut pending, &mut text);
    text
}

/// Each line four columns further in, with a line end.
pub fn indent(text: &str) -> String {
    text.lines().map(|line| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") }).collect()
}

fn camel_case(name: &str) -> String {
    let words = name.split('_').filter(|word| !word.is_empty());
    words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
}

fn lower_first(text: &str) -> String {
    let mut characters = text.chars();
    match (characters.next(), characters.next()) {
        (Some(first), Some(second)) if second.is_lowercase() || second == ' ' => {
            first.to_lowercase().collect::<String>() + &text[first.len_utf8()..]
        }
        _ => text.to_owned(),
    }
}
