//! The words after `cargo xtask`.

use std::ffi::OsString;

use lexopt::{Arg, Parser};

use crate::failure::Failure;

/// What to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Task {
    /// Install what is missing from the system.
    Setup,
    /// Build the command in release and run it on a scene.
    Demo {
        /// The scene: a file, or the name of one in `templates/scenes`.
        scene: Option<OsString>,
    },
    /// Run every check of the workspace.
    Test {
        /// Whether to install first what is missing from the system.
        set_up: bool,
    },
    /// Build and run the examples.
    Examples {
        /// The one to run, else all that do not take minutes to compile.
        name: Option<OsString>,
    },
    /// Make the committed fits of the sensitivities again.
    Fits,
    /// Fuzz what reads users' text, guided by coverage.
    Fuzz {
        /// For how many seconds each target runs.
        seconds: u32,
    },
    /// Measure the variants beside the shaders that other systems ship.
    Peers {
        /// Whether to install the packages of the other systems first.
        install: bool,
        /// Whether to print JSON.
        json: bool,
    },
    /// Render the exports in their engines, in a browser.
    Clients {
        /// The clients; none for all.
        names: Vec<OsString>,
        /// Whether to print JSON.
        json: bool,
    },
    /// Print what the emitted code saves where a scene fixes something.
    Savings,
    /// Print the usage.
    Help,
}

/// What `cargo xtask help` prints.
pub const USAGE: &str = "\
Usage: cargo xtask <TASK>

Tasks:
  setup              Install what is missing from the system: glslang, SPIRV-Tools, the Vulkan loader, lavapipe,
                     libEGL and llvmpipe
  demo [SCENE]       Set up, build the command, and run it on a scene: a file, or a name in templates/scenes
                     (soap-bubble where none is given)
  test [--no-setup]  Set up, then check formatting, lints, the build without features, documentation and tests
  examples [NAME]    Set up, then build and run the examples, or one of them: a C++ program, a picture with wgpu, ...
                     (bevy-film only where it is named: it takes minutes to compile)
  fits               Make the committed fits in crates/pavo-spectra/data/fits again (minutes)
  fuzz [--seconds N] Build the readers of users' text with counters, and fuzz each for N seconds (60)
  peers [--no-install] [--json]
                     Install the npm package three and the PyPI package MaterialX into target/peers, and measure pavo
                     beside their thin-film shaders: errors, costs, times
  clients [NAME ...] [--json]
                     Install three.js, Babylon.js and PlayCanvas into target/clients, render what `pavo export` writes for
                     them in a headless Chromium, and compare each pixel with the CPU evaluation; where they are named,
                     the same by what is nearest to each: materialx (needs xvfb), blender (downloads 360 MB), slang,
                     bevy, godot, filament (needs matc), metal
  savings            Print what the emitted code saves where a scene fixes something, as a Markdown table
  help               Print this

Exit codes: 0 fine, 1 a check failed, 2 bad input, 3 something needed is missing";

const TASKS: &str = "the tasks are setup, demo, test, examples, fits, fuzz, peers, clients, savings and help";

/// Reads the words, the first of which names the task.
///
/// # Errors
///
/// A word that is no task, or one that the task does not take.
pub fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Task, Failure> {
    let mut parser = Parser::from_args(words);
    let Some(word) = next(&mut parser)? else {
        return Err(Failure::bad_input(format!("name a task: {TASKS}")));
    };
    let mut task = match &word {
        Arg::Short('h') | Arg::Long("help") => Task::Help,
        Arg::Value(word) => match word.to_str() {
            Some("setup") => Task::Setup,
            Some("demo") => Task::Demo { scene: None },
            Some("test") => Task::Test { set_up: true },
            Some("examples") => Task::Examples { name: None },
            Some("fits") => Task::Fits,
            Some("fuzz") => Task::Fuzz { seconds: 60 },
            Some("peers") => Task::Peers { install: true, json: false },
            Some("clients") => Task::Clients { names: Vec::new(), json: false },
            Some("savings") => Task::Savings,
            Some("help") => Task::Help,
            _ => {
                return Err(Failure::bad_input(format!("`{}` is no task; {TASKS}", word.to_string_lossy())));
            }
        },
        other => return Err(not_taken(other, "cargo xtask", TASKS)),
    };
    while let Some(argument) = next(&mut parser)? {
        match (&mut task, argument) {
            (_, Arg::Short('h') | Arg::Long("help")) => return Ok(Task::Help),
            (Task::Demo { scene: scene @ None }, Arg::Value(value)) => *scene = Some(value),
            (Task::Demo { .. }, other) => return Err(not_taken(&other, "demo", "it takes one scene")),
            (Task::Examples { name: name @ None }, Arg::Value(value)) => *name = Some(value),
            (Task::Examples { .. }, other) => return Err(not_taken(&other, "examples", "it takes one example")),
            (Task::Test { set_up }, Arg::Long("no-setup")) => *set_up = false,
            (Task::Test { .. }, other) => return Err(not_taken(&other, "test", "it takes --no-setup only")),
            (Task::Fuzz { seconds }, Arg::Long("seconds")) => *seconds = read_seconds(&mut parser)?,
            (Task::Fuzz { .. }, other) => return Err(not_taken(&other, "fuzz", "it takes --seconds N only")),
            (Task::Peers { install, .. }, Arg::Long("no-install")) => *install = false,
            (Task::Peers { json, .. }, Arg::Long("json")) => *json = true,
            (Task::Peers { .. }, other) => {
                return Err(not_taken(&other, "peers", "it takes --no-install and --json only"));
            }
            (Task::Clients { names, .. }, Arg::Value(value)) => names.push(value),
            (Task::Clients { json, .. }, Arg::Long("json")) => *json = true,
            (Task::Clients { .. }, other) => {
                return Err(not_taken(&other, "clients", "it takes names of clients and --json only"));
            }
            (Task::Setup, other) => return Err(not_taken(&other, "setup", "it takes nothing")),
            (Task::Fits, other) => return Err(not_taken(&other, "fits", "it takes nothing")),
            (Task::Savings, other) => return Err(not_taken(&other, "savings", "it takes nothing")),
            (Task::Help, other) => return Err(not_taken(&other, "help", "it takes nothing")),
        }
    }
    Ok(task)
}

fn next(parser: &mut Parser) -> Result<Option<Arg<'_>>, Failure> {
    parser.next().map_err(|error| Failure::bad_input(error.to_string()))
}

fn read_seconds(parser: &mut Parser) -> Result<u32, Failure> {
    let value = parser.value().map_err(|error| Failure::bad_input(error.to_string()))?;
    let seconds = value.to_str().and_then(|text| text.parse().ok()).filter(|seconds| (1..=86_400).contains(seconds));
    seconds.ok_or_else(|| {
        let value = value.to_string_lossy();
        Failure::bad_input(format!("--seconds is `{value}`; it is a whole number from 1 to 86400"))
    })
}

fn not_taken(argument: &Arg<'_>, task: &str, hint: &str) -> Failure {
    let shown = match argument {
        Arg::Short(letter) => format!("-{letter}"),
        Arg::Long(name) => format!("--{name}"),
        Arg::Value(value) => value.to_string_lossy().into_owned(),
    };
    Failure::bad_input(format!("{task} does not take `{shown}`; {hint}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::failure::Status;

    fn parsed(words: &str) -> Result<Task, Failure> {
        parse(words.split_whitespace().map(OsString::from))
    }

    #[test]
    fn the_words_name_a_task_and_its_options() {
        for (words, expected) in [
            ("setup", Task::Setup),
            ("demo", Task::Demo { scene: None }),
            ("demo oil-on-water", Task::Demo { scene: Some("oil-on-water".into()) }),
            ("demo -- -odd-name.toml", Task::Demo { scene: Some("-odd-name.toml".into()) }),
            ("test", Task::Test { set_up: true }),
            ("test --no-setup", Task::Test { set_up: false }),
            ("examples", Task::Examples { name: None }),
            ("examples wgpu-bubble", Task::Examples { name: Some("wgpu-bubble".into()) }),
            ("fits", Task::Fits),
            ("peers", Task::Peers { install: true, json: false }),
            ("peers --json --no-install", Task::Peers { install: false, json: true }),
            ("fuzz", Task::Fuzz { seconds: 60 }),
            ("fuzz --seconds 5", Task::Fuzz { seconds: 5 }),
            ("clients", Task::Clients { names: Vec::new(), json: false }),
            ("clients three --json", Task::Clients { names: vec!["three".into()], json: true }),
            ("savings", Task::Savings),
            ("help", Task::Help),
            ("--help", Task::Help),
            ("-h", Task::Help),
            ("test --help", Task::Help),
        ] {
            assert_eq!(parsed(words), Ok(expected), "{words}");
        }
    }

    #[test]
    fn other_words_are_refused_with_what_is_taken() {
        for (words, expected) in [
            (
                "",
                "name a task: the tasks are setup, demo, test, examples, fits, fuzz, peers, clients, savings and help",
            ),
            (
                "tset",
                "`tset` is no task; the tasks are setup, demo, test, examples, fits, fuzz, peers, clients, savings and help",
            ),
            (
                "--no-setup",
                "cargo xtask does not take `--no-setup`; the tasks are setup, demo, test, examples, fits, fuzz, peers, clients, savings and help",
            ),
            ("demo a b", "demo does not take `b`; it takes one scene"),
            ("demo --no-setup", "demo does not take `--no-setup`; it takes one scene"),
            ("test all", "test does not take `all`; it takes --no-setup only"),
            ("peers three", "peers does not take `three`; it takes --no-install and --json only"),
            ("fuzz scene", "fuzz does not take `scene`; it takes --seconds N only"),
            ("fuzz --seconds 0", "--seconds is `0`; it is a whole number from 1 to 86400"),
            ("fuzz --seconds -1", "--seconds is `-1`; it is a whole number from 1 to 86400"),
            ("examples a b", "examples does not take `b`; it takes one example"),
            ("test -x", "test does not take `-x`; it takes --no-setup only"),
            ("clients -x", "clients does not take `-x`; it takes names of clients and --json only"),
            ("setup now", "setup does not take `now`; it takes nothing"),
            ("help me", "help does not take `me`; it takes nothing"),
        ] {
            let failure = parsed(words).expect_err(words);
            assert_eq!((failure.status, failure.message.as_str()), (Status::BadInput, expected), "{words}");
        }
    }
}
