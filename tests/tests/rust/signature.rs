//! The functions of an emitted module, and how they are called with the numbers of a point.

// Each test file is a crate of its own and uses a part of this.
#![allow(dead_code)]

use pavo_shade::{Input, PREPARED_SURFACE};
use syn::{Expr, ExprLit, FnArg, Item, ItemFn, Lit, Pat, Type};

/// The function that prepares.
const PREPARE: &str = "prepare_surface";
/// The function of the vertices.
const VERTEX: &str = "vertex_surface";

/// Where each field of a struct of numbers and vectors lies, in bytes, and how long it is.
///
/// # Panics
/// If the module has no such struct, or one of other fields.
pub fn layout(text: &str, name: &str) -> (Vec<(String, u32)>, u32) {
    let file = syn::parse_file(text).unwrap_or_else(|error| panic!("{error}"));
    let structure = file.items.into_iter().find_map(|item| match item {
        Item::Struct(structure) if structure.ident == name => Some(structure),
        _ => None,
    });
    let structure = structure.unwrap_or_else(|| panic!("no struct {name} in\n{text}"));
    let mut place = 0;
    let mut fields = Vec::new();
    for field in structure.fields {
        let field_name = field.ident.map_or_else(String::new, |name| name.to_string());
        let numbers: u32 = match &field.ty {
            ty if is_named(ty, "f32") => 1,
            ty if is_named(ty, "Vec3") => 3,
            Type::Array(array) => match &array.len {
                Expr::Lit(ExprLit { lit: Lit::Int(length), .. }) => length.base10_parse().unwrap_or_default(),
                _ => panic!("{field_name} is of no known length"),
            },
            _ => panic!("{field_name} is neither a number nor a vector"),
        };
        if !field_name.starts_with("_padding") {
            fields.push((field_name, place));
        }
        place += 4 * numbers;
    }
    (fields, place)
}

/// A module as syn reads it.
pub struct Module {
    name: String,
    functions: Vec<ItemFn>,
    /// The fields of the struct that is prepared.
    prepared: Vec<String>,
}

impl Module {
    /// Reads a module.
    ///
    /// # Panics
    /// If it is no Rust.
    pub fn new(name: &str, text: &str) -> Self {
        let file = syn::parse_file(text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut module = Self { name: name.to_owned(), functions: Vec::new(), prepared: Vec::new() };
        for item in file.items {
            match item {
                Item::Fn(function) => module.functions.push(function),
                Item::Struct(structure) if structure.ident == PREPARED_SURFACE => {
                    let names = structure.fields.into_iter().filter_map(|field| field.ident);
                    module.prepared = names.map(|name| name.to_string()).collect();
                }
                _ => {}
            }
        }
        module
    }

    /// A call of a function, over the numbers `p` of a point: what is no input is prepared.
    ///
    /// # Panics
    /// If there is no such function.
    pub fn call(&self, name: &str, inputs: &[Input]) -> String {
        let function = self.functions.iter().find(|function| function.sig.ident == name);
        let function = function.unwrap_or_else(|| panic!("{} has no function {name}", self.name));
        let argument = |argument: &FnArg| {
            let FnArg::Typed(typed) = argument else { panic!("{name} takes self") };
            let Pat::Ident(pattern) = &*typed.pat else { panic!("{name}: a parameter without a name") };
            let is_vector = is_named(&typed.ty, "Vec3");
            match place(inputs, &pattern.ident.to_string()) {
                Some(first) if is_vector => {
                    format!("glam::Vec3::new(p[{first}], p[{}], p[{}])", first + 1, first + 2)
                }
                Some(first) => format!("p[{first}]"),
                None if is_named(&typed.ty, "VertexSurface") => self.call(VERTEX, inputs),
                None if is_named(&typed.ty, "PreparedSurface") => self.call(PREPARE, inputs),
                None if name == VERTEX && self.prepared.iter().any(|field| pattern.ident == field) => {
                    format!("{}.{}", self.call(PREPARE, inputs), pattern.ident)
                }
                // What is prepared for functions other than the one that is called.
                None if [PREPARE, VERTEX].contains(&name) && is_vector => "glam::Vec3::splat(0.5)".to_owned(),
                None if [PREPARE, VERTEX].contains(&name) => "0.5".to_owned(),
                // A single prepared value.
                None => self.call(PREPARE, inputs),
            }
        };
        let arguments: Vec<String> = function.sig.inputs.iter().map(argument).collect();
        format!("{}::{name}({})", self.name, arguments.join(", "))
    }
}

fn is_named(ty: &Type, name: &str) -> bool {
    matches!(ty, Type::Path(path) if path.path.is_ident(name))
}

/// Where the numbers of an input begin in a point.
fn place(inputs: &[Input], name: &str) -> Option<usize> {
    let index = inputs.iter().position(|input| input.name == name)?;
    Some(inputs[..index].iter().map(Input::components).sum())
}
