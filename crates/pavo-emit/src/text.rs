//! A program as text: header, structs, functions.

use crate::Options;
use crate::dialect::{Dialect, Syntax};
use crate::expression::vector;
use crate::function::{self, Body, Context};
use crate::lines::broken_line;
use crate::namer::Namer;
use crate::passing::structs_passed;
use pavo_shade::{Definition, Program, Table, Type};

/// The width that lines are filled to.
pub const WIDTH: usize = 100;

/// The names that a program has outside of its functions.
pub struct Names {
    pub functions: Vec<String>,
    pub tables: Vec<String>,
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
        let tables = program.tables().iter().map(|table| outer.fresh(&format!("{prefix}{}", table.name))).collect();
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
        Self { functions, tables, structs, outer }
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
    let mut text = header(options);
    if !dialect.preamble.is_empty() {
        text.push('\n');
        text.push_str(dialect.preamble);
    }
    text.push_str(&functions(program, options, &names, Tables::Constants));
    text
}

/// Where a text has its tables.
#[derive(Clone, Copy, Debug)]
pub enum Tables {
    /// In the text.
    Constants,
    /// In storage buffers, one each.
    Buffers {
        /// The binding of the first.
        first_binding: usize,
    },
}

/// The tables, structs and functions of a program.
pub fn functions(program: &Program, options: &Options, names: &Names, tables: Tables) -> String {
    let dialect = Dialect::of(options.language);
    let fields = names.fields();
    let passed = structs_passed(program, &names.structs);
    let context = Context {
        dialect,
        functions: &names.functions,
        tables: &names.tables,
        structs: &names.structs,
        fields: &fields,
        passed: &passed,
        outer: &names.outer,
        source_lines: options.source_lines,
    };
    let mut text = String::new();
    for (index, (table, name)) in program.tables().iter().zip(&names.tables).enumerate() {
        text.push('\n');
        text.push_str(&comment(&Paragraph::of_doc(std::slice::from_ref(&table.doc))));
        text.push_str(&match tables {
            Tables::Constants => rows(dialect, table, name),
            Tables::Buffers { first_binding } => dialect.table_buffer(name, first_binding + index),
        });
    }
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

/// A table, as many rows on a line as fit.
fn rows(dialect: &Dialect, table: &Table, name: &str) -> String {
    let [before, after] = dialect.table(name, table.rows.len());
    let mut text = before;
    let mut column = WIDTH;
    for (index, row) in table.rows.iter().enumerate() {
        let comma = if index + 1 < table.rows.len() { "," } else { "" };
        let entry = vector(dialect, *row) + comma;
        if column + 1 + entry.len() > WIDTH {
            text.push_str("\n    ");
            column = 4;
        } else {
            text.push(' ');
            column += 1;
        }
        column += entry.len();
        text.push_str(&entry);
    }
    text.push('\n');
    text.push_str(&after);
    text.push('\n');
    text
}

fn structure(dialect: &Dialect, made: &Struct) -> String {
    let mut text = format!("struct {} {{\n", made.name);
    for (name, ty, doc) in &made.fields {
        if !doc.is_empty() {
            text.push_str(&indent(&comment(&Paragraph::of_doc(std::slice::from_ref(doc)))));
        }
        let end = if dialect.syntax == Syntax::Wgsl { "," } else { ";" };
        text.push_str(&format!("    {}{end}\n", dialect.typed(dialect.type_name(*ty), name)));
    }
    text.push_str(if dialect.syntax == Syntax::Wgsl { "}\n" } else { "};\n" });
    text
}

fn function(context: &Context<'_>, definition: &Definition, index: usize) -> String {
    let Body { head, statements, results, .. } = function::body(context, definition, index);
    let mut doc = Paragraph::of_doc(&definition.doc);
    let documented: Vec<Paragraph> = head
        .iter()
        .filter(|parameter| !parameter.doc.is_empty())
        .map(|parameter| format!("{}: {}", parameter.name, lower_first(&parameter.doc.replace('`', ""))))
        .map(Paragraph::entry)
        .collect();
    if !doc.is_empty() && !documented.is_empty() {
        doc.push(Paragraph { text: String::new(), hanging: "" });
    }
    doc.extend(documented);
    let (result, value) = match &context.structs[index] {
        Some(made) => (made.name.clone(), construct(&made.name, &results)),
        None => (context.dialect.type_name(definition.results[0].ty).to_owned(), results[0].clone()),
    };
    let mut text = comment(&doc);
    text.push_str(&function::head(context.dialect, &context.functions[index], &head, &result));
    text.push('\n');
    for statement in statements.iter().chain([&format!("return {value};")]) {
        let (code, place) = statement.split_at(statement.find(" // ").unwrap_or(statement.len()));
        text.push_str(&indent(&(broken_line(code, WIDTH - 4) + place)));
    }
    text.push_str("}\n");
    text
}

/// A struct of its fields.
fn construct(name: &str, fields: &[String]) -> String {
    format!("{name}({})", fields.join(", "))
}

/// A paragraph of a comment.
pub struct Paragraph {
    text: String,
    /// What its lines after the first begin with.
    hanging: &'static str,
}

impl Paragraph {
    /// An entry of a list: its further lines stand further in.
    pub fn entry(text: String) -> Self {
        Self { text, hanging: "    " }
    }

    /// The paragraphs of a doc comment: lines up to an empty one belong together. Marks of the documentation are left
    /// out.
    pub fn of_doc(lines: &[String]) -> Vec<Self> {
        let mut paragraphs: Vec<Self> = Vec::new();
        for block in lines.split(|line| line.is_empty()).filter(|block| !block.is_empty()) {
            if !paragraphs.is_empty() {
                paragraphs.push(Self { text: String::new(), hanging: "" });
            }
            paragraphs.push(Self { text: block.join(" ").replace('`', ""), hanging: "" });
        }
        paragraphs
    }
}

/// Paragraphs as a comment, filled to the width of the text; an empty one is an empty line.
pub fn comment(paragraphs: &[Paragraph]) -> String {
    let mut text = String::new();
    for paragraph in paragraphs {
        let mut line = String::from("//");
        for word in paragraph.text.split_whitespace() {
            if line.len() + 1 + word.len() > WIDTH {
                text.push_str(&line);
                text.push('\n');
                line = format!("//{}", paragraph.hanging);
            }
            line.push(' ');
            line.push_str(word);
        }
        text.push_str(&line);
        text.push('\n');
    }
    text
}

/// The comment at the top of a text.
pub fn header(options: &Options) -> String {
    comment(&options.header.iter().cloned().map(Paragraph::entry).collect::<Vec<_>>())
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
