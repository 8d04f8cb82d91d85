//! From what is missing to the commands that install it.

use super::authority::Authority;
use super::package_manager::PackageManager;
use super::requirement::Requirement;
use crate::command_line::CommandLine;

/// What to do about what is missing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Plan {
    /// Run these, in this order.
    Install(Vec<CommandLine>),
    /// Tell this to the person, who alone can install.
    Advise(String),
}

/// What to do about requirements that are missing, of which there is at least one, on a system with this package
/// manager (`None`: none that is known here) and for a user with this authority.
pub fn plan(missing: &[&Requirement], manager: Option<&PackageManager>, authority: Authority) -> Plan {
    let Some(manager) = manager else {
        return Plan::Advise(advice_without_manager(missing));
    };
    let commands = commands(manager, &packages(missing, manager), authority);
    let may_run = matches!(authority, Authority::Root | Authority::Sudo);
    if manager.run_here && may_run {
        return Plan::Install(commands);
    }
    let commands: Vec<String> = commands.iter().map(CommandLine::to_string).collect();
    let who = if manager.by_root && authority == Authority::NoSudo { ", as root" } else { "" };
    Plan::Advise(format!("install with this{who}:\n  {}", commands.join(" && ")))
}

/// The packages that hold the requirements, each once, in the order of the requirements.
fn packages(missing: &[&Requirement], manager: &PackageManager) -> Vec<&'static str> {
    let mut packages = Vec::new();
    for requirement in missing {
        let package = (manager.package)(&requirement.packages);
        if !packages.contains(&package) {
            packages.push(package);
        }
    }
    packages
}

fn commands(manager: &PackageManager, packages: &[&str], authority: Authority) -> Vec<CommandLine> {
    let with_sudo = manager.by_root && matches!(authority, Authority::Sudo | Authority::SudoWithoutTerminal);
    let command = |arguments: &[&str], variable: Option<(&'static str, &'static str)>| {
        let command = match (with_sudo, variable) {
            (false, None) => CommandLine::new(manager.program),
            (false, Some((name, value))) => CommandLine::new(manager.program).environment(name, value),
            (true, None) => CommandLine::new("sudo").arguments([manager.program]),
            // Sudo drops the environment, so the variable is set behind it.
            (true, Some((name, value))) => {
                CommandLine::new("sudo").arguments(["env", &format!("{name}={value}"), manager.program])
            }
        };
        command.arguments(arguments)
    };
    let refresh = manager.refresh.map(|arguments| command(arguments, None));
    let install = command(&[manager.install, packages].concat(), manager.variable);
    refresh.into_iter().chain([install]).collect()
}

fn advice_without_manager(missing: &[&Requirement]) -> String {
    let mut lines = vec!["install, by the means of this system:".to_owned()];
    for requirement in missing {
        lines.push(format!("  {} ({})", requirement.name, requirement.source));
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::package_manager::{APT, BREW, DNF, PACMAN};
    use crate::setup::requirement::REQUIREMENTS;

    /// The plan for requirements given by their names, or for all of them, as text.
    fn planned(missing: &str, manager: Option<&PackageManager>, authority: Authority) -> String {
        let missing: Vec<&Requirement> = REQUIREMENTS
            .iter()
            .filter(|requirement| missing == "all" || missing.split(", ").any(|name| name == requirement.name))
            .collect();
        assert!(!missing.is_empty());
        match plan(&missing, manager, authority) {
            Plan::Install(commands) => {
                commands.iter().map(|command| format!("run: {command}")).collect::<Vec<_>>().join("\n")
            }
            Plan::Advise(advice) => advice,
        }
    }

    #[test]
    fn with_apt_get_the_commands_fit_the_user() {
        use Authority::{NoSudo, Root, Sudo, SudoWithoutTerminal};
        for (missing, authority, expected) in [
            (
                "all",
                Root,
                "run: apt-get update\n\
                 run: DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
                 -o DPkg::Lock::Timeout=120 glslang-tools spirv-tools libvulkan1 mesa-vulkan-drivers \
                 libegl1 libgl1-mesa-dri",
            ),
            (
                "spirv-as, lavapipe",
                Sudo,
                "run: sudo apt-get update\n\
                 run: sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
                 -o DPkg::Lock::Timeout=120 spirv-tools mesa-vulkan-drivers",
            ),
            (
                "glslangValidator",
                SudoWithoutTerminal,
                "install with this:\n  \
                 sudo apt-get update && sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y \
                 --no-install-recommends -o DPkg::Lock::Timeout=120 glslang-tools",
            ),
            (
                "the Vulkan loader",
                NoSudo,
                "install with this, as root:\n  \
                 apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
                 -o DPkg::Lock::Timeout=120 libvulkan1",
            ),
        ] {
            assert_eq!(planned(missing, Some(&APT), authority), expected);
        }
    }

    #[test]
    fn with_another_package_manager_the_command_is_told_and_never_run() {
        use Authority::{NoSudo, Root, Sudo, SudoWithoutTerminal};
        for (manager, missing, authority, expected) in [
            (
                DNF,
                "all",
                Sudo,
                "install with this:\n  sudo dnf install -y glslang spirv-tools vulkan-loader mesa-vulkan-drivers libglvnd-egl \
                 mesa-dri-drivers",
            ),
            (
                PACMAN,
                "all",
                Root,
                "install with this:\n  pacman -S --needed glslang spirv-tools vulkan-icd-loader vulkan-swrast libglvnd mesa",
            ),
            (PACMAN, "lavapipe", SudoWithoutTerminal, "install with this:\n  sudo pacman -S --needed vulkan-swrast"),
            (DNF, "spirv-val", NoSudo, "install with this, as root:\n  dnf install -y spirv-tools"),
            (BREW, "all", Sudo, "install with this:\n  brew install glslang spirv-tools vulkan-loader mesa"),
            (BREW, "spirv-dis, spirv-val", NoSudo, "install with this:\n  brew install spirv-tools"),
        ] {
            assert_eq!(planned(missing, Some(&manager), authority), expected);
        }
    }

    #[test]
    fn without_a_known_package_manager_the_sources_are_told() {
        assert_eq!(
            planned("spirv-val, lavapipe", None, Authority::Root),
            "install, by the means of this system:\n  \
             spirv-val (https://github.com/KhronosGroup/SPIRV-Tools)\n  \
             lavapipe (https://docs.mesa3d.org/drivers/llvmpipe.html)"
        );
    }
}
