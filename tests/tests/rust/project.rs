//! A cargo project around emitted modules: it is compiled with the workspace's glam, and run over points.

// Each test file is a crate of its own and uses a part of this.
#![allow(dead_code)]

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A call of an emitted function at points: a Rust expression over the numbers `p` of a point.
pub struct Evaluation {
    /// The expression, a number or a `Vec3`.
    pub expression: String,
    /// The points, all of one length.
    pub points: Vec<Vec<f32>>,
}

/// The largest difference over the larger of 1 and the value.
pub fn difference(found: &[[f32; 3]], expected: &[[f32; 3]]) -> f64 {
    let pairs = found.as_flattened().iter().zip(expected.as_flattened());
    pairs
        .map(|(&found, &expected)| f64::from((found - expected).abs()) / f64::from(expected.abs()).max(1.0))
        .fold(0.0, f64::max)
}

/// The workspace, whose lock file and version of glam are taken.
fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A project with a library of the emitted modules and a program that evaluates them.
pub struct Project {
    folder: PathBuf,
}

const SHARED: &str = "
trait Color {
    fn color(self) -> [f32; 3];
}
impl Color for f32 {
    fn color(self) -> [f32; 3] {
        [self; 3]
    }
}
impl Color for glam::Vec3 {
    fn color(self) -> [f32; 3] {
        self.to_array()
    }
}
fn each<const N: usize>(
    numbers: &mut impl Iterator<Item = f32>,
    results: &mut Vec<u8>,
    count: usize,
    evaluate: impl Fn([f32; N]) -> [f32; 3],
) {
    for _ in 0..count {
        let point = std::array::from_fn(|_| numbers.next().unwrap());
        results.extend(evaluate(point).iter().flat_map(|number| number.to_le_bytes()));
    }
}
";

impl Project {
    /// Writes the modules, by name and text, to a folder of this name.
    ///
    /// # Panics
    /// If they cannot be written.
    pub fn new(name: &str, modules: &[(String, String)]) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let source = folder.join("src");
        // The build folder stays, so that glam is compiled once; modules of an earlier run go.
        let _ = std::fs::remove_dir_all(&source);
        let project = Self { folder };
        let manifest = std::fs::read_to_string(workspace().join("Cargo.toml")).expect("the workspace has a manifest");
        let glam = manifest.lines().find(|line| line.starts_with("glam = ")).expect("the workspace uses glam");
        project.write(
            "Cargo.toml",
            &format!(
                "[package]\nname = \"{name}\"\nedition = \"2024\"\n\n[dependencies]\n{glam}\n\n\
                 [profile.dev]\ndebug = false\n\n[workspace]\n"
            ),
        );
        let lock = std::fs::read_to_string(workspace().join("Cargo.lock")).expect("the workspace has a lock file");
        project.write("Cargo.lock", &lock);
        for (name, text) in modules {
            project.write(&format!("src/{name}.rs"), text);
        }
        let mut declarations: Vec<String> = modules.iter().map(|(name, _)| format!("pub mod {name};\n")).collect();
        // In the order that rustfmt wants.
        declarations.sort();
        let library = format!("#![deny(warnings)]\n{}", declarations.concat());
        project.write("src/lib.rs", &library);
        project
    }

    fn write(&self, file: &str, text: &str) {
        let path = self.folder.join(file);
        std::fs::create_dir_all(path.parent().expect("a file has a folder")).expect("the folder can be made");
        std::fs::write(path, text).unwrap_or_else(|error| panic!("{file}: {error}"));
    }

    /// Runs all evaluations; the results by evaluation and point.
    ///
    /// # Panics
    /// If a module is not accepted by the compiler, or warned of.
    pub fn run(&self, evaluations: &[Evaluation]) -> Vec<Vec<[f32; 3]>> {
        let library = self.folder.file_name().unwrap_or_default().display().to_string().replace('-', "_");
        let mut program = format!("use {library}::*;\n{SHARED}\nfn main() {{\n");
        program.push_str(
            "    let bytes = std::fs::read(\"points\").unwrap();\n    \
             let mut numbers = bytes.chunks_exact(4).map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()));\n    \
             let mut results = Vec::new();\n",
        );
        let mut bytes: Vec<u8> = Vec::new();
        for Evaluation { expression, points } in evaluations {
            let (count, width) = (points.len(), points.first().map_or(0, Vec::len));
            writeln!(
                program,
                "    each(&mut numbers, &mut results, {count}, |p: [f32; {width}]| {expression}.color());"
            )
            .expect("text can be written");
            bytes.extend(points.iter().flatten().flat_map(|number| number.to_le_bytes()));
        }
        program.push_str("    std::fs::write(\"results\", results).unwrap();\n}\n");
        self.write("src/main.rs", &program);
        std::fs::write(self.folder.join("points"), bytes).expect("the points can be written");
        self.execute(env!("CARGO"), &["run", "--quiet", "--offline"]);
        let results = std::fs::read(self.folder.join("results")).expect("the program has written its results");
        let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().expect("a number has four bytes"));
        let mut colors = results.chunks_exact(12).map(|color| [&color[..4], &color[4..8], &color[8..]].map(number));
        evaluations.iter().map(|evaluation| colors.by_ref().take(evaluation.points.len()).collect()).collect()
    }

    /// Has clippy look at the modules, where it is installed.
    ///
    /// # Panics
    /// If it has something to say.
    pub fn lint(&self) {
        self.execute_installed(env!("CARGO"), &["clippy", "--quiet", "--offline", "--lib", "--", "-D", "warnings"]);
    }

    /// Has rustfmt look at the modules with its defaults, where it is installed.
    ///
    /// # Panics
    /// If it would lay them out in another way.
    pub fn format(&self) {
        // The workspace's own settings are not what a user has.
        self.write("rustfmt.toml", "");
        self.execute_installed("rustfmt", &["--edition", "2024", "--check", "src/lib.rs"]);
    }

    fn execute_installed(&self, program: &str, arguments: &[&str]) {
        let command: Vec<&str> = arguments.iter().copied().take_while(|first| !first.starts_with('-')).collect();
        let asked = Command::new(program).args(command).arg("--version").output();
        if asked.is_ok_and(|output| output.status.success()) {
            self.execute(program, arguments);
        } else {
            println!("{program} {arguments:?} is not installed: the text is not judged by it");
        }
    }

    fn execute(&self, program: &str, arguments: &[&str]) {
        let mut command = Command::new(program);
        command
            .current_dir(&self.folder)
            .args(arguments)
            .env("CARGO_TARGET_DIR", self.folder.with_file_name("generated-target"));
        let output = command.output().unwrap_or_else(|error| panic!("{program} {arguments:?}: {error}"));
        assert!(
            output.status.success(),
            "{program} {arguments:?}: {}{}",
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        );
    }
}
