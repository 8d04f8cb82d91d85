//! The package managers that are known here, as data.

/// The package that holds a requirement, by the package manager that installs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Packages {
    /// Debian and Ubuntu.
    pub apt: &'static str,
    /// Fedora.
    pub dnf: &'static str,
    /// Arch Linux.
    pub pacman: &'static str,
    /// Homebrew.
    pub brew: &'static str,
}

/// A package manager, and how to install with it.
#[derive(Clone, Copy, Debug)]
pub struct PackageManager {
    /// The program.
    pub program: &'static str,
    /// The arguments that fetch the lists of packages, where that is a step of its own.
    pub refresh: Option<&'static [&'static str]>,
    /// The arguments before the names of the packages to install.
    pub install: &'static [&'static str],
    /// Whether root installs.
    pub by_root: bool,
    /// Whether this tool runs it; otherwise it tells what to run.
    pub run_here: bool,
    /// An environment variable to install with.
    pub variable: Option<(&'static str, &'static str)>,
    /// Its own name for a package.
    pub package: fn(&Packages) -> &'static str,
}

/// The package managers in the order in which they are looked for. A system may have Homebrew beside its own.
pub const PACKAGE_MANAGERS: [PackageManager; 4] = [APT, DNF, PACMAN, BREW];

/// Debian and Ubuntu.
pub const APT: PackageManager = PackageManager {
    program: "apt-get",
    refresh: Some(&["update"]),
    // A fresh machine installs its own updates first and holds the lock meanwhile: wait for it, up to two minutes.
    install: &["install", "-y", "--no-install-recommends", "-o", "DPkg::Lock::Timeout=120"],
    by_root: true,
    run_here: true,
    variable: Some(("DEBIAN_FRONTEND", "noninteractive")),
    package: |packages| packages.apt,
};

/// Fedora.
pub const DNF: PackageManager = PackageManager {
    program: "dnf",
    refresh: None,
    install: &["install", "-y"],
    by_root: true,
    run_here: false,
    variable: None,
    package: |packages| packages.dnf,
};

/// Arch Linux.
pub const PACMAN: PackageManager = PackageManager {
    program: "pacman",
    refresh: None,
    install: &["-S", "--needed"],
    by_root: true,
    run_here: false,
    variable: None,
    package: |packages| packages.pacman,
};

/// Homebrew, which refuses to run as root.
pub const BREW: PackageManager = PackageManager {
    program: "brew",
    refresh: None,
    install: &["install"],
    by_root: false,
    run_here: false,
    variable: None,
    package: |packages| packages.brew,
};
