//! What scenes are accepted, and that no text makes the reader panic.

mod accepted;
mod files;
mod hostile;
mod starters;
