//! A sign of life on a terminal during long work.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A spinner with the name of the step at work; nothing where standard error is no terminal.
pub struct Progress(ProgressBar);

impl Progress {
    /// Starts with no step.
    pub fn start() -> Self {
        let bar = ProgressBar::new_spinner();
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} [{elapsed}]") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(bar)
    }

    /// Names the step.
    pub fn step(&self, name: impl Into<String>) {
        self.0.set_message(name.into());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
