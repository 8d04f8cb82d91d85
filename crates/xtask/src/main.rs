//! The set-up, the demo and the tests of this workspace: `cargo xtask help` lists what it does.

mod arguments;
mod clients;
mod command_line;
mod console;
mod demo;
mod failure;
mod measuring;
mod peers;
mod programs;
mod setup;
mod steps;
mod suite;
mod workspace;

use std::process::ExitCode;

use arguments::{Task, USAGE};
use failure::Failure;
use workspace::Workspace;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            console::complain(&format!("error: {}", failure.message));
            failure.exit_code()
        }
    }
}

fn run() -> Result<(), Failure> {
    let task = arguments::parse(std::env::args_os().skip(1))?;
    let workspace = Workspace::of_this_tool()?;
    match task {
        Task::Help => {
            console::say(USAGE);
            Ok(())
        }
        Task::Setup => setup::set_up(&workspace),
        Task::Demo { scene } => {
            let scene = demo::find_scene(&workspace, scene.as_deref())?;
            setup::set_up(&workspace)?;
            demo::run(&workspace, &scene)
        }
        Task::Fits => suite::make_fits(&workspace),
        Task::Peers { install, json } => peers::run(&workspace, install, json),
        Task::Clients { names, json } => clients::run(&workspace, &names, json),
        Task::Savings => measuring::run(&workspace, "pavo-savings", |measure| measure),
        Task::Test { set_up } => {
            if set_up {
                setup::set_up(&workspace)?;
            }
            suite::run(&workspace)
        }
    }
}
