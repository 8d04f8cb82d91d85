//! What a judge says.

use std::fmt;

use pavo_emit::Form;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::CheckError;

/// A program that reads shaders and refuses what is not correct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Judge {
    /// naga, the shader translator of wgpu and Firefox: reads WGSL and GLSL 4.40 to 4.60.
    Naga,
    /// glslang, the reference front end of Khronos for GLSL, with one for HLSL.
    Glslang,
    /// glslang's front end for HLSL, reading OSL with its names defined as those of HLSL: the nearest judge of OSL that is
    /// at hand without a renderer.
    GlslangForOsl,
    /// spirv-val, the validator of SPIRV-Tools.
    SpirvVal,
    /// syn, the parser of Rust that macros use.
    Syn,
}

impl Judge {
    /// The judge's own name, as its project writes it.
    pub fn name(self) -> &'static str {
        match self {
            Judge::Naga => "naga",
            Judge::Glslang => "glslang",
            Judge::GlslangForOsl => "glslang, read as HLSL",
            Judge::SpirvVal => "spirv-val",
            Judge::Syn => "syn",
        }
    }

    /// The name, and what it checks where that is less than one expects.
    pub fn described(self) -> String {
        match self {
            Judge::Syn | Judge::GlslangForOsl => format!("{} ({})", self.name(), self.checks()),
            _ => self.name().to_owned(),
        }
    }

    /// What it checks.
    pub fn checks(self) -> &'static str {
        match self {
            Judge::Naga | Judge::Glslang => "syntax and types",
            Judge::GlslangForOsl => "syntax and types, by the rules of HLSL with OSL's names; no OSL compiler",
            Judge::SpirvVal => "validity for Vulkan 1.1",
            Judge::Syn => "syntax alone",
        }
    }
}

impl fmt::Display for Judge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

impl Serialize for Judge {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// One thing that a judge says about one place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Diagnostic {
    /// The name of the input, as the caller gave it.
    pub file: String,
    /// The line in the caller's own text, counted from 1. For SPIR-V the number of the instruction, counted from 1,
    /// which is its line in a disassembly without header. `None` where the judge gives no line.
    pub line: Option<u32>,
    /// The column in that line, counted from 1 in bytes. `None` where the judge gives no column.
    pub column: Option<u32>,
    /// What is wrong there.
    pub message: String,
    /// Who says so.
    pub judge: Judge,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(formatter, ":{line}")?;
            if let Some(column) = self.column {
                write!(formatter, ":{column}")?;
            }
        }
        write!(formatter, ": [{}] {}", self.judge, self.message)
    }
}

/// The answer of one judge about one input. In JSON it says what the judge checks, too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Who judged.
    pub judge: Judge,
    /// The judge's version, as it prints it; empty where it prints none.
    pub version: String,
    /// Whether the input is correct.
    pub passed: bool,
    /// What the judge had to say: the errors of a refusal, the warnings of a pass.
    pub diagnostics: Vec<Diagnostic>,
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Verdict", 5)?;
        fields.serialize_field("judge", &self.judge)?;
        fields.serialize_field("version", &self.version)?;
        fields.serialize_field("checks", self.judge.checks())?;
        fields.serialize_field("passed", &self.passed)?;
        fields.serialize_field("diagnostics", &self.diagnostics)?;
        fields.end()
    }
}

impl Verdict {
    /// A refusal with one diagnostic.
    pub(super) fn refusal(judge: Judge, version: &str, file: &str, line: Option<u32>, message: String) -> Verdict {
        let diagnostic = Diagnostic { file: file.to_owned(), line, column: None, message, judge };
        Verdict { judge, version: version.to_owned(), passed: false, diagnostics: vec![diagnostic] }
    }
}

/// The verdicts when all of them pass, otherwise the refusal that carries them.
pub(super) fn all_passed(verdicts: Vec<Verdict>) -> Result<Vec<Verdict>, CheckError> {
    if verdicts.iter().all(|verdict| verdict.passed) { Ok(verdicts) } else { Err(CheckError::Refused { verdicts }) }
}

/// A stage of the graphics pipeline, or the compute stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Places vertices.
    Vertex,
    /// Shades fragments.
    Fragment,
    /// Runs over a grid of invocations.
    Compute,
}

impl Stage {
    /// The stage's name as WGSL and Vulkan write it.
    pub fn name(self) -> &'static str {
        match self {
            Stage::Vertex => "vertex",
            Stage::Fragment => "fragment",
            Stage::Compute => "compute",
        }
    }

    /// The stage of a complete form; `None` for a library, which belongs to no stage.
    pub fn of_form(form: Form) -> Option<Stage> {
        match form {
            Form::Compute => Some(Stage::Compute),
            Form::Fragment => Some(Stage::Fragment),
            Form::Library => None,
        }
    }

    /// The stage as naga names it.
    pub(super) fn for_naga(self) -> ::naga::ShaderStage {
        match self {
            Stage::Vertex => ::naga::ShaderStage::Vertex,
            Stage::Fragment => ::naga::ShaderStage::Fragment,
            Stage::Compute => ::naga::ShaderStage::Compute,
        }
    }
}
