//! What is measured: a function in a compute entry and in a fragment entry.

use crate::catalogue::{Call, Peer, PeerText};
use crate::classes::{Class, PeerInput};
use crate::failure::Failure;
use minijinja::{Environment, UndefinedBehavior, context};
use pavo::roads::{Road, table_numbers};
use pavo::{Shading, ShadingQuantity, cost, cost_baseline};
use pavo_check::{Stage, glsl_to_spirv, judge_spirv};
use pavo_emit::{Language, WORKGROUP_SIZE};

const COMPUTE: &str = include_str!("../../../templates/peers/compute.glsl");
const FRAGMENT: &str = include_str!("../../../templates/peers/fragment.glsl");
const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;
/// How many numbers a location of a fragment shader holds.
const LOCATION_SIZE: usize = 4;

/// A function in its entries.
pub struct Kernel {
    /// Its name in reports.
    pub name: String,
    /// Whose it is.
    pub of: Origin,
    /// Its inputs.
    pub inputs: Vec<PeerInput>,
    /// The compute shader that is timed.
    pub spirv: Vec<u32>,
    /// The compute shader as it is shipped, with its early return, where it has one.
    pub spirv_with_exit: Option<Vec<u32>>,
    /// The buffers of tables that the compute shader reads.
    pub tables: Vec<Vec<f32>>,
    /// The fragment shader whose cost is counted.
    pub fragment: String,
    /// The fragment shader as it is shipped, with its early return.
    pub fragment_with_exit: Option<String>,
    /// The fragment shader with the same inputs that only adds them up.
    pub baseline: String,
    /// Whether it is timed.
    pub is_timed: bool,
}

/// Whose function a kernel is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A variant of pavo's.
    Pavo,
    /// The function of a peer, as the peer calls it.
    Peer(String),
    /// The function of a peer, called otherwise.
    PeerOtherwise,
}

impl Kernel {
    /// The function of a peer.
    ///
    /// # Errors
    /// If a judge refuses it.
    pub fn of_peer(peer: &Peer, version: &str, call: &Call, text: &PeerText) -> Result<Kernel, Failure> {
        let note = call.note.as_ref().map(|note| format!(", {note}")).unwrap_or_default();
        let name = format!("{} {version}{note}", peer.name);
        let counted = text.without_exit.as_ref().unwrap_or(&text.shipped);
        let with_exit = text.without_exit.as_ref().map(|_| text.shipped.as_str());
        let compute = |text: &str| -> Result<Vec<u32>, Failure> {
            let spirv = glsl_to_spirv(&format!("{name}.comp"), &rendered(COMPUTE, text, call)?, Stage::Compute)?;
            judge_spirv(&name, &spirv)?;
            Ok(spirv)
        };
        let fragment = |text: &str| -> Result<String, Failure> {
            let text = rendered(FRAGMENT, text, call)?;
            // naga does not read all of GLSL: glslang and spirv-val judge what others write.
            judge_spirv(&name, &glsl_to_spirv(&format!("{name}.frag"), &text, Stage::Fragment)?)?;
            Ok(text)
        };
        Ok(Kernel {
            of: if call.note.is_none() { Origin::Peer(peer.name.clone()) } else { Origin::PeerOtherwise },
            inputs: call.inputs.clone(),
            spirv: compute(counted)?,
            spirv_with_exit: with_exit.map(compute).transpose()?,
            tables: Vec::new(),
            fragment: fragment(counted)?,
            fragment_with_exit: with_exit.map(fragment).transpose()?,
            baseline: rendered(FRAGMENT, "", &Call { expression: sum(&call.inputs), ..empty(call) })?,
            is_timed: true,
            name,
        })
    }

    /// A variant of pavo's over surfaces of which everything varies at run time.
    ///
    /// # Errors
    /// If it cannot be made, or a judge refuses it.
    pub fn of_pavo(class: Class, variant: &str) -> Result<Kernel, Failure> {
        let shading: Shading = class.shading(variant)?;
        let program = shading.program(QUANTITY);
        let inputs = program.inputs().iter().map(|input| PeerInput::try_from(input.name.clone()));
        Ok(Kernel {
            name: format!("pavo {variant}"),
            of: Origin::Pavo,
            inputs: inputs.collect::<Result<_, String>>().map_err(Failure::Text)?,
            spirv: Road::Glsl.spirv(&shading, QUANTITY)?,
            spirv_with_exit: None,
            tables: program.tables().iter().map(table_numbers).collect(),
            fragment: cost(&shading, QUANTITY, Language::Glsl450)?,
            fragment_with_exit: None,
            baseline: cost_baseline(&shading, QUANTITY, Language::Glsl450)?,
            // A sum over many wavelengths is there for its error and its count: it would take most of the time.
            is_timed: !variant.starts_with("spectral"),
        })
    }

    /// How many numbers a point has.
    pub fn inputs_per_point(&self) -> usize {
        self.inputs.iter().map(|input| input.components()).sum()
    }
}

/// A template around a call.
fn rendered(template: &str, text: &str, call: &Call) -> Result<String, Failure> {
    let mut offset = 0;
    let inputs: Vec<minijinja::Value> = call
        .inputs
        .iter()
        .map(|input| {
            let first = offset;
            offset += input.components();
            context! { name => input.name(), vector => input.is_colour, offset => first, value => value(first, *input) }
        })
        .collect();
    let values = context! {
        text,
        inputs,
        expression => &call.expression,
        stride => offset,
        locations => offset.div_ceil(LOCATION_SIZE),
        workgroup_size => WORKGROUP_SIZE,
    };
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    let broken = |error: minijinja::Error| Failure::Text(format!("templates/peers: {error}"));
    environment.render_str(template, values).map_err(broken)
}

/// An input as the fragment shader reads it.
fn value(first: usize, input: PeerInput) -> String {
    let numbers: Vec<String> = (first..first + input.components()).map(varying).collect();
    if input.is_colour { format!("vec3({})", numbers.join(", ")) } else { numbers.concat() }
}

/// One number of all inputs in a row.
fn varying(number: usize) -> String {
    format!("varying_{}.{}", number / LOCATION_SIZE, ["x", "y", "z", "w"][number % LOCATION_SIZE])
}

/// All inputs added up.
fn sum(inputs: &[PeerInput]) -> String {
    let count = inputs.iter().map(|input| input.components()).sum();
    format!("vec3({})", (0..count).map(varying).collect::<Vec<_>>().join(" + "))
}

fn empty(call: &Call) -> Call {
    Call { note: None, classes: Vec::new(), inputs: call.inputs.clone(), expression: String::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A text and a call that are made up.
    fn tint() -> (PeerText, Call) {
        let function = |exit: &str| format!("vec3 tint(float c, vec3 f) {{\n    {exit}return f * c;\n}}");
        let text = PeerText {
            shipped: function("if (c < 0.0) { return vec3(1.0); }\n    "),
            without_exit: Some(function("")),
        };
        let inputs = ["cos_theta1", "thickness_nm", "base_f0_rgb"];
        let inputs = inputs.map(|name| PeerInput::try_from(name.to_owned()).expect("it is an input"));
        let expression = "tint(cos_theta1 + thickness_nm, base_f0_rgb)".to_owned();
        (text, Call { note: None, classes: vec![Class::Dielectric], inputs: inputs.to_vec(), expression })
    }

    #[test]
    fn both_entries_of_a_call_read_its_inputs_in_a_row() {
        let (text, call) = tint();
        let fragment = rendered(FRAGMENT, &text.shipped, &call).unwrap_or_else(|error| panic!("{error}"));
        assert!(fragment.contains("vec3 base_f0_rgb = vec3(varying_0.z, varying_0.w, varying_1.x);"), "{fragment}");
        let compute = rendered(COMPUTE, &text.shipped, &call).unwrap_or_else(|error| panic!("{error}"));
        assert!(compute.contains("= vec3(inputs[point * 5u + 2u], inputs[point * 5u + 3u], inputs"), "{compute}");
    }

    #[test]
    fn a_made_up_peer_passes_the_judges_with_and_without_its_early_return() {
        let (text, call) = tint();
        let peer = Peer {
            name: "made up".to_owned(),
            registry: crate::catalogue::Registry::Npm,
            package: "none".to_owned(),
            prelude: String::new(),
            early_exit: None,
            text: Vec::new(),
            call: Vec::new(),
        };
        let kernel = Kernel::of_peer(&peer, "1", &call, &text).unwrap_or_else(|error| panic!("{error}"));
        assert!(!kernel.fragment.contains("return vec3(1.0)"));
        let with_exit = kernel.fragment_with_exit.as_ref().expect("it has one");
        assert!(with_exit.contains("return vec3(1.0)"), "{with_exit}");
        for fragment in [with_exit, &kernel.baseline] {
            glsl_to_spirv("made-up.frag", fragment, Stage::Fragment).unwrap_or_else(|error| panic!("{error}"));
        }
        assert_eq!(kernel.inputs_per_point(), 5);
    }
}
