//! Reads what a SPIR-V module declares, to compare it with what this crate provides before a driver sees it.
//!
//! The numbers are those of the SPIR-V specification (Khronos, version 1.3): section 2.3 for the layout of a module, 3.3
//! for execution models, 3.31 for capabilities, 3.6 for execution modes, 3.7 for storage classes, 3.20 for decorations, 3.32 for instructions.

use crate::CheckError;

const MAGIC_NUMBER: u32 = 0x0723_0203;
const HEADER_WORDS: usize = 5;

pub(super) const OP_ENTRY_POINT: u32 = 15;
const OP_CAPABILITY: u32 = 17;
const CAPABILITY_FLOAT16: u32 = 9;
const OP_EXECUTION_MODE: u32 = 16;
pub(super) const OP_VARIABLE: u32 = 59;
pub(super) const OP_DECORATE: u32 = 71;
const EXECUTION_MODE_LOCAL_SIZE: u32 = 17;
const STORAGE_CLASS_PUSH_CONSTANT: u32 = 9;
const DECORATION_BINDING: u32 = 33;
const DECORATION_DESCRIPTOR_SET: u32 = 34;

/// The execution model of vertex shaders.
pub(super) const VERTEX: u32 = 0;
/// The execution model of fragment shaders.
pub(super) const FRAGMENT: u32 = 4;
/// The execution model of compute shaders.
pub(super) const COMPUTE: u32 = 5;

/// An entry point of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct EntryPoint {
    pub name: String,
    pub execution_model: u32,
    /// The workgroup size, for compute shaders that have a fixed one.
    pub local_size: Option<[u32; 3]>,
    id: u32,
}

/// What a module declares.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct ModuleInterface {
    entry_points: Vec<EntryPoint>,
    /// Pairs of descriptor set and binding, in ascending order.
    resources: Vec<(u32, u32)>,
    has_push_constants: bool,
    /// Whether it computes in half precision.
    pub has_half_precision: bool,
}

impl ModuleInterface {
    /// Reads the declarations of a module.
    pub fn read(words: &[u32]) -> Result<ModuleInterface, CheckError> {
        let mut interface = ModuleInterface::default();
        let mut sets: Vec<(u32, u32)> = Vec::new();
        let mut bindings: Vec<(u32, u32)> = Vec::new();
        for (opcode, operands) in instructions(words)? {
            match (opcode, operands) {
                (OP_ENTRY_POINT, &[execution_model, id, ref name @ ..]) => {
                    let name = literal_string(name);
                    interface.entry_points.push(EntryPoint { name, execution_model, local_size: None, id });
                }
                (OP_EXECUTION_MODE, &[id, EXECUTION_MODE_LOCAL_SIZE, x, y, z]) => {
                    interface
                        .entry_points
                        .iter_mut()
                        .filter(|entry| entry.id == id)
                        .for_each(|entry| entry.local_size = Some([x, y, z]));
                }
                (OP_CAPABILITY, &[CAPABILITY_FLOAT16]) => interface.has_half_precision = true,
                (OP_VARIABLE, &[_, _, STORAGE_CLASS_PUSH_CONSTANT, ..]) => interface.has_push_constants = true,
                (OP_DECORATE, &[id, DECORATION_DESCRIPTOR_SET, set]) => sets.push((id, set)),
                (OP_DECORATE, &[id, DECORATION_BINDING, binding]) => bindings.push((id, binding)),
                _ => {}
            }
        }
        for &(id, binding) in &bindings {
            let set = sets.iter().find(|(decorated, _)| *decorated == id).map_or(0, |&(_, set)| set);
            interface.resources.push((set, binding));
        }
        interface.resources.sort_unstable();
        Ok(interface)
    }

    /// The entry point of that name and execution model.
    pub fn entry_point(&self, name: &str, execution_model: u32) -> Result<&EntryPoint, CheckError> {
        self.entry_points
            .iter()
            .find(|entry| entry.name == name && entry.execution_model == execution_model)
            .ok_or_else(|| {
                let kind = kind(execution_model);
                let declared: Vec<String> = self
                    .entry_points
                    .iter()
                    .map(|entry| format!("`{}` ({})", entry.name, self::kind(entry.execution_model)))
                    .collect();
                let declared = if declared.is_empty() { "none".to_owned() } else { declared.join(", ") };
                CheckError::Input(format!("the SPIR-V has no {kind} entry point `{name}`: it has {declared}"))
            })
    }

    /// Refuses resources that this crate does not provide.
    pub fn check_resources(&self, provided: &[(u32, u32)]) -> Result<(), CheckError> {
        if self.has_push_constants {
            return Err(CheckError::Input("the SPIR-V uses push constants, and none are provided".to_owned()));
        }
        match self.resources.iter().find(|resource| !provided.contains(resource)) {
            None => Ok(()),
            Some((set, binding)) => {
                let provided: Vec<String> =
                    provided.iter().map(|(set, binding)| format!("set {set}, binding {binding}")).collect();
                let provided = if provided.is_empty() { "none are".to_owned() } else { provided.join(" and ") };
                Err(CheckError::Input(format!(
                    "the SPIR-V declares a resource at set {set}, binding {binding}: provided: {provided}"
                )))
            }
        }
    }
}

/// The instructions of a module: opcode and operands.
pub(super) fn instructions(words: &[u32]) -> Result<Vec<(u32, &[u32])>, CheckError> {
    let malformed = |what: &str| CheckError::Input(format!("the SPIR-V cannot be run: {what}"));
    if words.first() != Some(&MAGIC_NUMBER) || words.len() < HEADER_WORDS {
        return Err(malformed("it does not begin with the header of a module"));
    }
    let mut instructions = Vec::new();
    let mut rest = &words[HEADER_WORDS..];
    while let Some(&first) = rest.first() {
        let (length, opcode) = ((first >> 16) as usize, first & 0xffff);
        if length == 0 || length > rest.len() {
            return Err(malformed("an instruction is longer than the module"));
        }
        let (instruction, following) = rest.split_at(length);
        rest = following;
        instructions.push((opcode, &instruction[1..]));
    }
    Ok(instructions)
}

fn kind(execution_model: u32) -> &'static str {
    match execution_model {
        VERTEX => "vertex",
        FRAGMENT => "fragment",
        COMPUTE => "compute",
        _ => "other",
    }
}

/// A string of SPIR-V: UTF-8 bytes in words, low byte first, ended by a zero byte.
pub(super) fn literal_string(words: &[u32]) -> String {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).take_while(|&byte| byte != 0).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The number of words that such a string takes, its zero byte included.
pub(super) fn literal_string_words(words: &[u32]) -> usize {
    words.iter().take_while(|word| !word.to_le_bytes().contains(&0)).count() + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: [u32; HEADER_WORDS] = [MAGIC_NUMBER, 0x0001_0300, 0, 10, 0];

    fn module(instructions: &[&[u32]]) -> Vec<u32> {
        let mut words = HEADER.to_vec();
        for instruction in instructions {
            words.push((instruction.len() as u32) << 16 | instruction[0]);
            words.extend(&instruction[1..]);
        }
        words
    }

    #[test]
    fn entry_points_and_resources_are_read() {
        let main = u32::from_le_bytes(*b"main");
        let words = module(&[
            &[OP_ENTRY_POINT, COMPUTE, 4, main, 0],
            &[OP_EXECUTION_MODE, 4, EXECUTION_MODE_LOCAL_SIZE, 64, 1, 1],
            &[OP_DECORATE, 7, DECORATION_BINDING, 1],
            &[OP_DECORATE, 7, DECORATION_DESCRIPTOR_SET, 2],
        ]);
        let interface = ModuleInterface::read(&words).unwrap();
        assert_eq!(interface.entry_point("main", COMPUTE).unwrap().local_size, Some([64, 1, 1]));
        let message = interface.entry_point("main", VERTEX).unwrap_err().to_string();
        assert_eq!(message, "the SPIR-V has no vertex entry point `main`: it has `main` (compute)");
        let message = interface.check_resources(&[(0, 0), (0, 1)]).unwrap_err().to_string();
        assert_eq!(
            message,
            "the SPIR-V declares a resource at set 2, binding 1: provided: set 0, binding 0 and set 0, binding 1"
        );
        assert!(interface.check_resources(&[(2, 1)]).is_ok());
    }

    #[test]
    fn push_constants_are_refused() {
        let words = module(&[&[OP_VARIABLE, 1, 2, STORAGE_CLASS_PUSH_CONSTANT]]);
        assert!(ModuleInterface::read(&words).unwrap().check_resources(&[]).is_err());
    }

    #[test]
    fn words_that_are_no_module_are_refused() {
        let endless = [HEADER.as_slice(), &[9 << 16 | OP_DECORATE]].concat();
        let empty_instruction = [HEADER.as_slice(), &[0]].concat();
        for words in [&[][..], &[MAGIC_NUMBER], &[1, 2, 3, 4, 5], &endless, &empty_instruction] {
            assert!(matches!(ModuleInterface::read(words), Err(CheckError::Input(_))), "{words:?}");
        }
    }
}
