//! A program as text: header, structs, functions.

use crate::Options;
use crate::comment::{Paragraph, comment, doc_comment};
use crate::dialect::{Dialect, Syntax};
use crate::expression::vector;
use crate::function::{self, Body, Context};
use crate::lines::broken_line;
use crate::namer::Namer;
use crate::passing::structs_passed;
use crate::rust;
use pavo_shade::{Definition, PREPARED_SURFACE, Program, Table, Type};

/// The width that lines are filled to.
pub const WIDTH: usize = 100;

/// The names that a program has outside of its functions.
pub struct Names {
    pub functions: Vec<String>,
    pub tables: Vec<PrintedTable>,
    /// For each function, the struct that it returns and its fields; nothing where it returns one value.
    pub structs: Vec<Option<Struct>>,
    pub outer: Namer,
}

/// A table as it is printed.
pub struct PrintedTable {
    pub name: String,
    /// How many rows it has.
    pub rows: usize,
}

/// A struct as it is printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Struct {
    pub name: String,
    pub fields: Vec<(String, Type, String)>,
    /// Whether it holds what was prepared, for the pixels to read.
    pub is_prepared: bool,
}

impl Names {
    pub fn new(program: &Program, options: &Options) -> Self {
        let prefix = &options.prefix;
        let dialect = Dialect::of(options.language);
        let mut outer = Namer::of(dialect);
        let functions: Vec<String> =
            program.functions().iter().map(|function| outer.fresh(&format!("{prefix}{}", function.name))).collect();
        let printed_table = |table: &Table| {
            let name = outer.fresh(&dialect.table_name(&format!("{prefix}{}", table.name)));
            PrintedTable { name, rows: table.rows.len() }
        };
        let tables = program.tables().iter().map(printed_table).collect();
        let mut known: Vec<Struct> = Vec::new();
        let mut structs = Vec::new();
        for (function, name) in program.functions().iter().zip(&functions) {
            if function.results.len() < 2 {
                structs.push(None);
                continue;
            }
            let mut fields = Namer::of(dialect);
            let fields: Vec<(String, Type, String)> = function
                .results
                .iter()
                .map(|result| (fields.fresh(&result.name), result.ty, result.doc.clone()))
                .collect();
            let wanted = match &function.result_type {
                Some(name) => struct_name(prefix, name),
                None => format!("{}Result", camel_case(name)),
            };
            let same = known.iter().find(|other| other.fields == fields && other.name.starts_with(&wanted)).cloned();
            let printed = same.unwrap_or_else(|| {
                let is_prepared = function.result_type.as_deref() == Some(PREPARED_SURFACE);
                let made = Struct { name: outer.fresh(&wanted), fields, is_prepared };
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
    let names = Names::new(program, options);
    let mut text = header(options);
    let functions = functions(program, options, &names, Tables::Constants);
    // Rust warns of what is imported for nothing.
    let is_needed = dialect.syntax != Syntax::Rust || functions.contains(dialect.type_name(Type::Vec3));
    if !dialect.preamble.is_empty() && is_needed {
        text.push('\n');
        text.push_str(dialect.preamble);
    }
    text.push_str(&functions);
    // Without a header nothing stands before the first line.
    text.trim_start_matches('\n').to_owned()
}

/// Where a text has its tables.
#[derive(Clone, Copy, Debug)]
pub enum Tables {
    /// In the text.
    Constants,
    /// In storage buffers, one each.
    #[cfg_attr(not(feature = "entry"), allow(dead_code))]
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
    if let Some(half) = dialect.half.as_ref().filter(|half| program.has_half() && !half.directive.is_empty()) {
        text.push('\n');
        text.push_str(half.directive);
    }
    for (index, (table, PrintedTable { name, .. })) in program.tables().iter().zip(&names.tables).enumerate() {
        text.push('\n');
        text.push_str(&doc_comment(dialect, &Paragraph::of_doc(dialect, std::slice::from_ref(&table.doc))));
        text.push_str(&match tables {
            Tables::Constants => {
                let rows = rows(dialect, table, name);
                let before = if dialect.syntax == Syntax::Rust { rust::attributes(0, &rows) } else { String::new() };
                before + &rows
            }
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
        let is_rust = dialect.syntax == Syntax::Rust;
        let comma = if is_rust || index + 1 < table.rows.len() { "," } else { "" };
        let entry = vector(dialect, *row) + comma;
        if is_rust || column + 1 + entry.len() > WIDTH {
            let indentation = if dialect.syntax == Syntax::Osl { 8 } else { 4 };
            text.push('\n');
            text.push_str(&" ".repeat(indentation));
            column = indentation;
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

/// A struct as it is declared.
pub fn structure(dialect: &Dialect, made: &Struct) -> String {
    if dialect.syntax == Syntax::Rust {
        return rust::structure(dialect, made);
    }
    let (end, close) = if dialect.syntax.is_like_c() { (";", "};\n") } else { (",", "}\n") };
    let mut text = format!("struct {} {{\n", made.name);
    for (name, ty, doc) in &made.fields {
        text.push_str(&field_doc(dialect, doc));
        text.push_str(&format!("    {}{end}\n", dialect.typed(dialect.type_name(*ty), name)));
    }
    text + close
}

/// The comment on a field, if there is something to say.
pub fn field_doc(dialect: &Dialect, doc: &String) -> String {
    if doc.is_empty() {
        return String::new();
    }
    indent(&doc_comment(dialect, &Paragraph::of_doc(dialect, std::slice::from_ref(doc))))
}

fn function(context: &Context<'_>, definition: &Definition, index: usize) -> String {
    let Body { head, statements, results, returned, .. } = function::body(context, definition, index);
    let dialect = context.dialect;
    let mut doc = Paragraph::of_doc(dialect, &definition.doc);
    let documented: Vec<Paragraph> = head
        .iter()
        .filter(|parameter| !parameter.doc.is_empty())
        .map(|parameter| Paragraph::of_parameter(dialect, &parameter.name, &parameter.doc))
        .collect();
    if !doc.is_empty() && !documented.is_empty() {
        doc.push(Paragraph::empty());
    }
    doc.extend(documented);
    let made = context.structs[index].as_ref();
    let result = made.map_or(dialect.type_name(definition.results[0].ty), |made| &made.name);
    let mut text = doc_comment(dialect, &doc);
    let statements = finished(dialect, statements, made, results, &returned);
    if dialect.syntax == Syntax::Rust {
        text.push_str(&rust::attributes(head.len(), &statements.join("\n")));
    }
    text.push_str(&function::head(dialect, &context.functions[index], &head, result));
    text.push('\n');
    for statement in statements {
        let (code, place) = split_place(&statement);
        if dialect.syntax == Syntax::Rust {
            text.push_str(&rust::statement(code, place));
        } else {
            text.push_str(&indent(&(broken_line(code, WIDTH - 4) + place)));
        }
    }
    text.push_str("}\n");
    text
}

/// A statement, and the comment on where it was written.
pub fn split_place(statement: &str) -> (&str, &str) {
    statement.split_at(statement.find(" // ").unwrap_or(statement.len()))
}

/// The statements of a function with what it returns.
fn finished(
    dialect: &Dialect,
    mut statements: Vec<String>,
    made: Option<&Struct>,
    mut results: Vec<String>,
    returned: &str,
) -> Vec<String> {
    if dialect.syntax == Syntax::Rust {
        return rust::finished(statements, made, results);
    }
    let value = match made {
        Some(made) if dialect.syntax.fills_by_braces() => {
            statements.push(format!("{} {returned} = {{ {} }};", made.name, results.join(", ")));
            returned.to_owned()
        }
        Some(made) => format!("{}({})", made.name, results.join(", ")),
        None => results.swap_remove(0),
    };
    statements.push(format!("return {value};"));
    statements
}

/// The comment at the top of a text.
pub fn header(options: &Options) -> String {
    comment(&options.header.iter().cloned().map(Paragraph::entry).collect::<Vec<_>>())
}

/// Each line four columns further in, with a line end.
pub fn indent(text: &str) -> String {
    text.lines().map(|line| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") }).collect()
}

/// The name of a struct behind the prefix of all names.
pub fn struct_name(prefix: &str, name: &str) -> String {
    camel_case(prefix) + name
}

fn camel_case(name: &str) -> String {
    let words = name.split('_').filter(|word| !word.is_empty());
    words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
}
