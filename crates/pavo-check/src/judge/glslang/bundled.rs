//! glslang compiled in from its sources, by the crate `glslang`.

use glslang::error::GlslangError;
use glslang::{
    Compiler, CompilerOptions, GlslProfile, Program, Shader, ShaderInput, ShaderMessage, ShaderSource, ShaderStage,
    SourceLanguage, SpirvVersion, Target, VulkanVersion,
};

use super::{Answer, Stage, Task};
use crate::CheckError;

/// The release that the crate `glslang` 0.9 carries.
const VERSION: &str = "bundled with the crate glslang 0.9";

/// An answer that is already there.
pub(super) struct Pending {
    answer: Answer,
}

/// Compiles the text at once.
pub(super) fn start(text: &str, stage: Stage, task: Task) -> Result<Pending, CheckError> {
    let compiler = Compiler::acquire().ok_or_else(|| failed("cannot be initialised".to_owned()))?;
    let answer = match compile(compiler, text, stage, task) {
        Ok(spirv) => Answer { passed: true, version: VERSION.to_owned(), log: String::new(), spirv },
        Err(
            GlslangError::PreprocessError(log)
            | GlslangError::ParseError(log)
            | GlslangError::MapIoError(log)
            | GlslangError::LinkError(log),
        ) => Answer { passed: false, version: VERSION.to_owned(), log: log.log, spirv: None },
        Err(error @ (GlslangError::VersionUnsupported(..) | GlslangError::InvalidProfile(..))) => {
            let log = format!("ERROR: 0:1: '#version' : {error}\n");
            Answer { passed: false, version: VERSION.to_owned(), log, spirv: None }
        }
        Err(error) => return Err(failed(error.to_string())),
    };
    Ok(Pending { answer })
}

impl Pending {
    /// The answer.
    pub fn finish(self) -> Result<Answer, CheckError> {
        Ok(self.answer)
    }
}

/// The version of glslang that is compiled in.
pub(crate) fn version() -> Option<String> {
    Some(VERSION.to_owned())
}

/// Vulkan 1.1 with SPIR-V 1.3.
const VULKAN: Target = Target::Vulkan { version: VulkanVersion::Vulkan1_1, spirv_version: SpirvVersion::SPIRV1_3 };

fn compile(compiler: &Compiler, text: &str, stage: Stage, task: Task) -> Result<Option<Vec<u32>>, GlslangError> {
    let mut messages = ShaderMessage::DEFAULT | ShaderMessage::ENHANCED | ShaderMessage::DISPLAY_ERROR_COLUMN;
    let mut version_profile = None;
    let mut source_language = SourceLanguage::GLSL;
    let target = match task {
        Task::Classic => Target::None(None),
        Task::Hlsl { keep_uncalled } => {
            messages |= ShaderMessage::SPV_RULES | ShaderMessage::VULKAN_RULES | ShaderMessage::READ_HLSL;
            messages.set(ShaderMessage::KEEP_UNCALLED, keep_uncalled);
            source_language = SourceLanguage::HLSL;
            VULKAN
        }
        Task::Vulkan { keep_uncalled, read_as } => {
            messages |= ShaderMessage::SPV_RULES | ShaderMessage::VULKAN_RULES;
            messages.set(ShaderMessage::KEEP_UNCALLED, keep_uncalled);
            version_profile =
                read_as.and_then(|version| i32::try_from(version).ok()).map(|version| (version, GlslProfile::Core));
            VULKAN
        }
    };
    let options = CompilerOptions { source_language, target, version_profile, messages };
    let source = ShaderSource::from(text);
    let no_defines: Option<&[(&str, Option<&str>)]> = None;
    let input = ShaderInput::new(&source, stage_of(stage), &options, no_defines, None)?;
    let mut shader = Shader::new(compiler, input);
    if let Task::Hlsl { .. } = task {
        shader.entry_point("main");
        shader.source_entry_point("main");
    }
    let shader = shader.parse()?;
    match task {
        Task::Vulkan { .. } | Task::Hlsl { .. } => shader.compile().map(Some),
        Task::Classic => {
            let mut program = Program::new(compiler);
            program.add_shader(&shader);
            program.link().map(|()| None)
        }
    }
}

fn stage_of(stage: Stage) -> ShaderStage {
    match stage {
        Stage::Vertex => ShaderStage::Vertex,
        Stage::Fragment => ShaderStage::Fragment,
        Stage::Compute => ShaderStage::Compute,
    }
}

fn failed(reason: String) -> CheckError {
    CheckError::Tool { tool: "glslang".to_owned(), reason }
}
