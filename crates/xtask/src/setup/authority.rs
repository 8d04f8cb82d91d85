//! Whether this user may install packages.

use std::io::IsTerminal;
use std::process::Command;

use crate::command_line::CommandLine;
use crate::programs::find_program;
use crate::workspace::Workspace;

/// How this user comes to install packages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Authority {
    /// The user is root.
    Root,
    /// `sudo` asks for no password, or there is a terminal to ask on.
    Sudo,
    /// `sudo` wants a password, and there is no terminal to ask on.
    SudoWithoutTerminal,
    /// There is no `sudo`.
    NoSudo,
}

impl Authority {
    /// What the user that runs this tool may do.
    pub fn of_this_user(workspace: &Workspace) -> Authority {
        if is_root() {
            Authority::Root
        } else if find_program("sudo").is_none() {
            Authority::NoSudo
        } else if std::io::stdin().is_terminal() || sudo_asks_nothing(workspace) {
            Authority::Sudo
        } else {
            Authority::SudoWithoutTerminal
        }
    }
}

fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

fn sudo_asks_nothing(workspace: &Workspace) -> bool {
    CommandLine::new("sudo").arguments(["-n", "true"]).succeeds_silently(workspace)
}
