//! Parameters that are passed together: where each call of a function gives it fields of one struct for the leaves of one
//! parameter of the Rust function, the emitted function takes that struct.

use crate::text::Struct;
use pavo_shade::{Definition, Op, Program};

/// A struct among the parameters of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct PassedStruct {
    /// The name of the parameter.
    pub name: String,
    /// Its meaning.
    pub doc: String,
    /// The struct.
    pub type_name: String,
    /// Which leaf parameters it holds, and by which field.
    pub fields: Vec<(usize, String)>,
}

/// For each function of a program, the structs that it takes.
pub fn structs_passed(program: &Program, structs: &[Option<Struct>]) -> Vec<Vec<PassedStruct>> {
    let functions = program.functions().iter().enumerate();
    functions.map(|(index, definition)| of_function(program, structs, index, definition)).collect()
}

fn of_function(
    program: &Program,
    structs: &[Option<Struct>],
    index: usize,
    definition: &Definition,
) -> Vec<PassedStruct> {
    let mut wholes: Vec<&(String, String)> =
        definition.parameters.iter().filter_map(|leaf| leaf.whole.as_ref()).collect();
    wholes.dedup();
    let passed = wholes.into_iter().filter_map(|whole| {
        let leaves: Vec<usize> = (0..definition.parameters.len())
            .filter(|&leaf| definition.parameters[leaf].whole.as_ref() == Some(whole))
            .collect();
        let mut found: Option<PassedStruct> = None;
        for (caller, arguments) in calls_of(program, index as u32) {
            let (made, fields) = fields_of_one_struct(structs, caller, arguments, &leaves)?;
            let (name, doc) = whole.clone();
            let passed = PassedStruct { name, doc, type_name: made.name.clone(), fields };
            if found.as_ref().is_some_and(|other| *other != passed) {
                return None;
            }
            found = Some(passed);
        }
        found.filter(|passed| passed.fields.len() > 1)
    });
    passed.collect()
}

/// All calls of a function, with the function that calls.
fn calls_of(program: &Program, callee: u32) -> impl Iterator<Item = (&Definition, &[u32])> {
    let callers = program.functions().iter().chain([program.body()]);
    callers.flat_map(move |caller| {
        caller.nodes.iter().filter_map(move |node| match node.op {
            Op::Call(called, arguments) if called == callee => {
                Some((caller, caller.calls[arguments as usize].as_slice()))
            }
            _ => None,
        })
    })
}

/// The struct whose fields these arguments are.
fn fields_of_one_struct<'a>(
    structs: &'a [Option<Struct>],
    caller: &Definition,
    arguments: &[u32],
    leaves: &[usize],
) -> Option<(&'a Struct, Vec<(usize, String)>)> {
    let mut source = None;
    let mut fields = Vec::new();
    for &leaf in leaves {
        let Op::Result(call, result) = caller.nodes[arguments[leaf] as usize].op else { return None };
        if source.is_some_and(|other| other != call) {
            return None;
        }
        source = Some(call);
        let Op::Call(callee, _) = caller.nodes[call as usize].op else { return None };
        let made = structs[callee as usize].as_ref()?;
        fields.push((leaf, made.fields[result as usize].0.clone()));
    }
    let Op::Call(callee, _) = caller.nodes[source? as usize].op else { return None };
    structs[callee as usize].as_ref().map(|made| (made, fields))
}
