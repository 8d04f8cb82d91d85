//! Users' files: read up to a size, written whole or not at all, and named in messages without control characters.

mod name;
mod read;
mod write;

pub use name::{is_printable, shown, shown_text};
pub use read::{MAXIMUM_SILENCE, read_text_up_to, read_up_to};
pub use write::write;
