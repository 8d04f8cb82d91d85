//! Parameters that are passed together: where each call of a function gives it fields of one struct for the leaves of one
//! parameter of the Rust function, the emitted function takes that struct. So it is where they are fields of a struct
//! that the caller took itself.

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
    let mut passed = vec![Vec::new(); program.functions().len()];
    // Callers first: they may pass on what they took.
    for (index, definition) in program.functions().iter().enumerate().rev() {
        passed[index] = of_function(program, structs, &passed, index, definition);
    }
    passed
}

fn of_function(
    program: &Program,
    structs: &[Option<Struct>],
    taken: &[Vec<PassedStruct>],
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
            let taken = caller.map_or(&[][..], |caller| taken[caller].as_slice());
            let caller = caller.map_or(program.body(), |caller| &program.functions()[caller]);
            let (type_name, fields) = fields_of_one_struct(structs, taken, caller, arguments, &leaves)?;
            let (name, doc) = whole.clone();
            let passed = PassedStruct { name, doc, type_name, fields };
            if found.as_ref().is_some_and(|other| *other != passed) {
                return None;
            }
            found = Some(passed);
        }
        found.filter(|passed| passed.fields.len() > 1)
    });
    passed.collect()
}

/// All calls of a function, with the number of the function that calls, nothing for the body.
fn calls_of(program: &Program, callee: u32) -> impl Iterator<Item = (Option<usize>, &[u32])> {
    let functions = program.functions().iter().enumerate().map(|(index, function)| (Some(index), function));
    functions.chain([(None, program.body())]).flat_map(move |(index, caller)| {
        caller.nodes.iter().filter_map(move |node| match node.op {
            Op::Call(called, arguments) if called == callee => {
                Some((index, caller.calls[arguments as usize].as_slice()))
            }
            _ => None,
        })
    })
}

/// The name of the struct whose fields these arguments are, and which field each leaf is.
fn fields_of_one_struct(
    structs: &[Option<Struct>],
    taken: &[PassedStruct],
    caller: &Definition,
    arguments: &[u32],
    leaves: &[usize],
) -> Option<(String, Vec<(usize, String)>)> {
    /// Where a struct comes from: a call, or a parameter of the caller.
    #[derive(PartialEq)]
    enum Source {
        Call(u32),
        Taken(usize),
    }
    let mut source = None;
    let mut type_name = String::new();
    let mut fields = Vec::new();
    for &leaf in leaves {
        let (from, of_type, field) = match caller.nodes[arguments[leaf] as usize].op {
            Op::Result(call, result) => {
                let Op::Call(callee, _) = caller.nodes[call as usize].op else { return None };
                let made = structs[callee as usize].as_ref()?;
                (Source::Call(call), &made.name, &made.fields[result as usize].0)
            }
            Op::Parameter(parameter) => {
                let field_of =
                    |passed: &'_ PassedStruct| passed.fields.iter().position(|(leaf, _)| *leaf == parameter as usize);
                let (index, field) =
                    taken.iter().enumerate().find_map(|(index, passed)| Some((index, field_of(passed)?)))?;
                (Source::Taken(index), &taken[index].type_name, &taken[index].fields[field].1)
            }
            _ => return None,
        };
        if source.as_ref().is_some_and(|other| *other != from) {
            return None;
        }
        source = Some(from);
        type_name.clone_from(of_type);
        fields.push((leaf, field.clone()));
    }
    Some((type_name, fields))
}
