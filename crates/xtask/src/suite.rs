//! Every check of the workspace, the quick ones first.
//!
//! The order shares the work. The lints, the build without features and the documentation all need the third-party
//! crates checked only, in one profile and with one set of compiler flags: the lints check them, and the two after use
//! what is there. The tests need them compiled, which nothing else here does, so they come last. Nothing sets
//! `RUSTFLAGS`: it would have every third-party crate compiled anew; `-D warnings` reaches the workspace's own crates
//! by clippy's arguments, and rustdoc by its own variable. The documentation is that of the workspace alone, as that
//! of naga takes minutes and belongs to naga.

use crate::console::{list_text, say};
use crate::failure::{Failure, Status};
use crate::steps::Steps;
use crate::workspace::Workspace;

/// Runs the checks up to the first that fails.
///
/// # Errors
///
/// A check fails, or a component of Rust that a check needs is missing.
pub fn run(workspace: &Workspace) -> Result<(), Failure> {
    let missing: Vec<&str> = COMPONENTS
        .into_iter()
        .filter(|(_, subcommand)| !workspace.cargo(&[subcommand, "--version"]).succeeds_silently(workspace))
        .map(|(component, _)| component)
        .collect();
    if !missing.is_empty() {
        return Err(Failure::missing(missing_components(&missing)));
    }
    let mut steps = Steps::default();
    let result = CHECKS.iter().try_for_each(|check| {
        let mut command = workspace.cargo(check.arguments);
        if let Some((name, value)) = check.variable {
            command = command.environment(name, value);
        }
        steps.run(workspace, check.name, &command, |_| Status::CheckFailed)
    });
    say(&format!("\n{}", steps.table()));
    result
}

/// Makes the committed fits again, in their place.
///
/// # Errors
///
/// The program that makes them fails.
pub fn make_fits(workspace: &Workspace) -> Result<(), Failure> {
    let folder = "crates/pavo-spectra/data/fits";
    let make = workspace.cargo(&["run", "--release", "--package", "pavo-fit", "--bin", "pavo-fits", "--", folder]);
    Steps::default().run(workspace, "fits", &make, |_| Status::CheckFailed)
}

/// The components of Rust that not every installation has, and the subcommands of cargo that they add.
const COMPONENTS: [(&str, &str); 2] = [("rustfmt", "fmt"), ("clippy", "clippy")];

/// A call of cargo that succeeds when something holds for the workspace.
struct Check {
    name: &'static str,
    arguments: &'static [&'static str],
    variable: Option<(&'static str, &'static str)>,
}

const CHECKS: [Check; 6] = [
    Check { name: "formatting", arguments: &["fmt", "--all", "--check"], variable: None },
    Check {
        name: "lints",
        arguments: &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"],
        variable: None,
    },
    Check {
        name: "library without features",
        arguments: &["check", "--package", "pavo", "--no-default-features"],
        variable: None,
    },
    Check {
        name: "library as it is fuzzed",
        arguments: &["check", "--package", "pavo", "--no-default-features", "--features", "points"],
        variable: None,
    },
    Check {
        name: "documentation",
        arguments: &["doc", "--workspace", "--no-deps"],
        variable: Some(("RUSTDOCFLAGS", "-D warnings")),
    },
    Check { name: "tests", arguments: &["test", "--workspace"], variable: None },
];

fn missing_components(components: &[&str]) -> String {
    let (noun, them) = if components.len() == 1 { ("component", "it") } else { ("components", "them") };
    format!(
        "Rust's {noun} {} cannot be run; with rustup, `rustup component add {}` adds {them}",
        list_text(components.iter().copied()),
        components.join(" "),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_components_come_with_the_command_that_adds_them() {
        for (components, expected) in [
            (
                &["rustfmt"][..],
                "Rust's component rustfmt cannot be run; with rustup, `rustup component add rustfmt` adds it",
            ),
            (
                &["rustfmt", "clippy"],
                "Rust's components rustfmt and clippy cannot be run; with rustup, `rustup component add rustfmt \
                 clippy` adds them",
            ),
        ] {
            assert_eq!(missing_components(components), expected);
        }
    }
}
