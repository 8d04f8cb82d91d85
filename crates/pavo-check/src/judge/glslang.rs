//! glslang, the reference front end of GLSL: the system's `glslangValidator` or, with the feature `bundled`, the
//! library compiled in. Both offer `start` and `version`, so that the rest does not see the difference.

mod messages;

#[cfg(feature = "bundled")]
mod bundled;
#[cfg(not(feature = "bundled"))]
mod tool;

#[cfg(feature = "bundled")]
use bundled as implementation;
#[cfg(not(feature = "bundled"))]
use tool as implementation;

use super::glsl_source::JudgedText;
use super::verdict::{Diagnostic, Judge, Stage, Verdict};
use crate::CheckError;

pub(crate) use implementation::version;

/// What glslang is asked to do with a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Task {
    /// Judge by the rules of the text's own version, linking included.
    Classic,
    /// Read HLSL, judge by the rules of Vulkan 1.1 and write SPIR-V 1.3. The entry point is `main`.
    Hlsl {
        /// Write functions that no entry point calls, too.
        keep_uncalled: bool,
    },
    /// Judge by the rules of Vulkan 1.1 and write SPIR-V 1.3.
    Vulkan {
        /// Write functions that no entry point calls, too.
        keep_uncalled: bool,
        /// Read the text as this version, whatever its `#version` line says.
        read_as: Option<u32>,
    },
}

/// A run of glslang that was begun.
pub(super) struct Run {
    pending: implementation::Pending,
}

/// What glslang answered.
pub(super) struct Answer {
    /// Whether the text was compiled and linked.
    pub passed: bool,
    /// The version of glslang.
    pub version: String,
    /// Its messages, as it prints them.
    pub log: String,
    /// The SPIR-V, for [`Task::Vulkan`] and [`Task::Hlsl`] and a text that passed.
    pub spirv: Option<Vec<u32>>,
}

/// Begins a run; the system's tool works while the caller does something else.
pub(super) fn start(text: &str, stage: Stage, task: Task) -> Result<Run, CheckError> {
    Ok(Run { pending: implementation::start(text, stage, task)? })
}

impl Run {
    /// Waits for the answer.
    pub fn finish(self) -> Result<Answer, CheckError> {
        self.pending.finish()
    }
}

impl Answer {
    /// The verdict, in terms of the caller's own text.
    pub fn verdict(&self, file: &str, judged: &JudgedText) -> Verdict {
        self.verdict_of(Judge::Glslang, file, judged)
    }

    /// The same, of glslang in one of its roles.
    pub fn verdict_of(&self, judge: Judge, file: &str, judged: &JudgedText) -> Verdict {
        let mut messages = messages::parse(&self.log);
        messages.retain(|message| message.is_error != self.passed);
        if messages.is_empty() && !self.passed {
            messages.push(messages::Message::whole_log(&self.log));
        }
        let diagnostics = messages.into_iter().map(|message| Diagnostic {
            file: file.to_owned(),
            line: message.line.map(|line| judged.own_line(line)),
            column: message.column,
            message: message.text,
            judge,
        });
        Verdict { judge, version: self.version.clone(), passed: self.passed, diagnostics: diagnostics.collect() }
    }
}
