//! A package whose build script uses pavo, without the judges and the solver: what it makes is the same as here, lies in
//! memory as in a uniform buffer, and is made again when a file of the scene changes.

use encase::{ShaderType, UniformBuffer};
use glam::Vec3;
use naga::front::spv;
use naga::{Module, TypeInner};
use pavo::scene::{Base, Scene};
use pavo::{Build, Language, Shading, ShadingQuantity, Variant, library};
use pavo_check::glsl_to_spirv;
use pavo_tests::{SCENES, scene_file};
use std::path::{Path, PathBuf};
use std::process::Command;

const FIXTURE: [&str; 5] = ["Cargo.toml", "build.rs", "src/main.rs", "scenes/plated.toml", "scenes/plating.csv"];

/// A copy of the package with the workspace's lock file.
struct Package {
    folder: PathBuf,
}

/// What a call of cargo said.
struct Said {
    is_success: bool,
    output: String,
    errors: String,
}

impl Package {
    fn new(name: &str) -> Self {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let package = Self { folder: Path::new(env!("CARGO_TARGET_TMPDIR")).join(name) };
        let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
        let manifest = read(&workspace.join("Cargo.toml"));
        let glam = manifest.lines().find(|line| line.starts_with("glam = ")).expect("the workspace uses glam");
        let pavo = workspace.join("crates/pavo").canonicalize().expect("pavo is there");
        let dependencies = format!("pavo = {{ path = {:?}, default-features = false }}\n{glam}", pavo.display());
        for file in FIXTURE {
            let text = read(&workspace.join("tests/fixtures/build-script").join(file));
            let text = text.replace("WORKSPACE_DEPENDENCIES", &dependencies);
            package.write(file, &text.replace("name = \"build-script\"", &format!("name = {name:?}")));
        }
        package.write("Cargo.lock", &read(&workspace.join("Cargo.lock")));
        package
    }

    fn write(&self, file: &str, text: &str) {
        let path = self.folder.join(file);
        std::fs::create_dir_all(path.parent().expect("a file has a folder")).expect("the folder can be made");
        std::fs::write(path, text).unwrap_or_else(|error| panic!("{file}: {error}"));
    }

    fn cargo(&self, arguments: &[&str]) -> Said {
        let mut command = Command::new(env!("CARGO"));
        command
            .current_dir(&self.folder)
            .args(arguments)
            .arg("--offline")
            // The packages of all tests share what they compile.
            .env("CARGO_TARGET_DIR", self.folder.with_file_name("build-script-target"));
        let output = command.output().unwrap_or_else(|error| panic!("cargo {arguments:?}: {error}"));
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Said { is_success: output.status.success(), output: text(&output.stdout), errors: text(&output.stderr) }
    }

    /// The numbers that the program prints behind a name.
    fn run(&self) -> impl Fn(&str) -> Vec<f64> {
        let said = self.cargo(&["run", "--quiet"]);
        assert!(said.is_success && !said.errors.contains("warning"), "{}", said.errors);
        move |name| {
            let row = said.output.lines().find_map(|line| line.strip_prefix(&format!("{name}: ")));
            let row = row.unwrap_or_else(|| panic!("no {name} in {}", said.output));
            row.split(' ').map(|word| word.parse().unwrap_or_else(|error| panic!("{word}: {error}"))).collect()
        }
    }

    /// A text that the build script has written.
    fn text(&self, file: &str) -> String {
        let build = self.folder.with_file_name("build-script-target").join("debug/build");
        let name = self.folder.file_name().unwrap_or_default().display().to_string();
        let folders = std::fs::read_dir(&build).unwrap_or_else(|error| panic!("{build:?}: {error}"));
        let folders = folders.filter_map(|folder| Some(folder.ok()?.path()));
        let own = folders.filter(|path| path.display().to_string().contains(&format!("/{name}-")));
        let files = own.map(|folder| folder.join("out").join(file));
        let mut found: Vec<PathBuf> = files.filter(|path| path.is_file()).collect();
        found.sort_by_key(|path| path.metadata().and_then(|metadata| metadata.modified()).ok());
        let newest = found.pop().unwrap_or_else(|| panic!("no {file} below {build:?}"));
        std::fs::read_to_string(&newest).unwrap_or_else(|error| panic!("{newest:?}: {error}"))
    }
}

/// Where the members of a struct lie, and how long it is, rounded up to 16 bytes as std140 has it.
fn layout(module: &Module, name: &str) -> Vec<f64> {
    let found = module.types.iter().find_map(|(_, ty)| match &ty.inner {
        TypeInner::Struct { members, span } if ty.name.as_deref() == Some(name) => {
            let places = members.iter().map(|member| member.offset);
            Some(places.chain([span.next_multiple_of(16)]).map(f64::from).collect())
        }
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no struct {name}"))
}

/// The layouts of a struct as naga has it of WGSL, and glslang of GLSL by std140.
fn layouts(package: &Package, scene: &str, name: &str) -> [Vec<f64>; 2] {
    let wgsl = naga::front::wgsl::parse_str(&package.text(&format!("{scene}.wgsl")));
    let wgsl = wgsl.unwrap_or_else(|error| panic!("{scene}: {error}"));
    let glsl = format!(
        "#version 450\n{}\nlayout(std140, set = 0, binding = 0) uniform Block {{ {name} uniforms; }};\n\
         layout(location = 0) out vec4 color;\nvoid main() {{ color = vec4(uniforms.light_color, uniforms.roughness); }}\n",
        package.text(&format!("{scene}.450.glsl"))
    );
    let words = glsl_to_spirv(scene, &glsl, pavo_check::Stage::Fragment).unwrap_or_else(|error| panic!("{error}"));
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let glsl = spv::parse_u8_slice(&bytes, &spv::Options::default()).unwrap_or_else(|error| panic!("{error}"));
    [layout(&wgsl, name), layout(&glsl, name)]
}

/// The uniforms of the scene `plated`, laid out by encase.
#[derive(ShaderType)]
struct Plated {
    film_ior: f32,
    roughness: f32,
    light_color: Vec3,
    light_intensity: f32,
}

/// The uniforms of the scene `shell`, laid out by encase.
#[derive(ShaderType)]
struct Shell {
    roughness: f32,
    base_color: Vec3,
    metalness: f32,
    light_color: Vec3,
    light_intensity: f32,
}

fn bytes(uniforms: &(impl ShaderType + encase::internal::WriteInto)) -> Vec<f64> {
    let mut buffer = UniformBuffer::new(Vec::new());
    buffer.write(uniforms).unwrap_or_else(|error| panic!("{error}"));
    let mut bytes = buffer.into_inner();
    bytes.resize(bytes.len().next_multiple_of(16), 0);
    bytes.into_iter().map(f64::from).collect()
}

#[test]
fn a_build_script_makes_texts_uniforms_and_functions_for_the_cpu() {
    let package = Package::new("emitting");
    let printed = package.run();
    for (scene, name) in [("plated", "SurfaceUniforms"), ("shell", "ShellSurfaceUniforms")] {
        let [wgsl, glsl] = layouts(&package, scene, name);
        let of_rust = printed(&format!("{scene} layout"));
        assert_eq!(of_rust, wgsl, "{scene} in WGSL");
        assert_eq!(of_rust, glsl, "{scene} in GLSL");
    }
    let light_color = Vec3::new(0.5, 0.75, 1.0);
    let plated = Plated { film_ior: 1.5, roughness: 0.25, light_color, light_intensity: 3.0 };
    assert_eq!(printed("plated bytes"), bytes(&plated));
    let base_color = Vec3::new(0.1, 0.2, 0.3);
    let shell = Shell { roughness: 0.25, base_color, metalness: 0.5, light_color, light_intensity: 3.0 };
    assert_eq!(printed("shell bytes"), bytes(&shell));

    let scene = Scene::load(&package.folder.join("scenes/plated.toml")).unwrap_or_else(|error| panic!("{error:?}"));
    let variant: Variant = scene.emit.variant.parse().unwrap_or_else(|error| panic!("{error}"));
    let shading = Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{error}"));
    assert!(package.text("plated.wgsl").starts_with(&library(&shading, Language::Wgsl)));
    let expected = shading.evaluate(ShadingQuantity::Reflectance, &[0.7, 300.0, 1.5]);
    for (found, expected) in printed("plated reflectance").into_iter().zip(expected) {
        assert!((found - expected).abs() < 5e-6, "{found} and {expected}");
    }
}

/// With the judges built in, as they are here, each text passes them or is not written.
#[test]
fn every_starter_scene_is_written_with_its_uniforms_in_each_language() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    for name in SCENES {
        let build = Language::ALL.into_iter().fold(Build::scene(scene_file(name)), Build::target);
        let built = build.out_dir(folder.path()).emit().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(built.texts.len(), Language::ALL.len() - 1, "{name}");
        for path in built.texts.iter().chain([&built.module]) {
            let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
            // Constant buffers of HLSL pack otherwise, and OSL has none.
            let has_uniforms = !matches!(path.extension().and_then(|ending| ending.to_str()), Some("hlsl" | "osl"));
            assert_eq!(text.contains("struct SurfaceUniforms {"), has_uniforms, "{path:?}");
        }
    }
}

#[test]
fn a_scene_made_in_rust_is_that_of_a_file() {
    let made = Scene::builder("bubble", Base::dielectric(1.0)).film(1.33, 0.0..=1200.0).roughness(0.2).build();
    let text = "name = \"bubble\"\n[film]\nior = 1.33\nthickness_nm = [0, 1200]\n[base]\nior = 1.0\n[surface]\nroughness = 0.2\n";
    let read = Scene::from_toml("bubble.toml", text, Path::new(""));
    assert_eq!(made.unwrap_or_else(|error| panic!("{error:?}")), read.unwrap_or_else(|error| panic!("{error:?}")));
}

#[test]
fn a_build_that_cannot_be_says_what_would_be_right() {
    let scene = || Scene::builder("bubble", Base::dielectric(1.0)).film(1.33, 0.0..=1200.0);
    let build = |scene: Scene| Build::of(scene).out_dir("no-such-folder");
    let good = || build(scene().build().unwrap_or_else(|error| panic!("{error:?}")));
    let wgsl = Language::Wgsl;
    for (build, expected) in [
        (good(), "the build has no target: nothing would be emitted\n  help: name at least one"),
        (good().target(wgsl).import_path("a b"), "`a b` is no import path\n  help: names of letters"),
        (good().target(wgsl).variant("pole"), "help: "),
        (
            good().target(wgsl).variant("auto"),
            "which no build script does\n  help: name the one that `pavo tune` picks",
        ),
        (good().target(wgsl), "cannot be written: No such file or directory (os error 2)\n  help: name a folder"),
    ] {
        let error = build.emit().expect_err(expected);
        assert!(format!("{error:?}").contains(expected), "{error:?}");
    }
    let error = scene().roughness(2.0).build().expect_err("no roughness is 2");
    assert!(format!("{error:?}").contains("`surface.roughness` is 2"), "{error:?}");
}

#[test]
fn the_texts_are_made_again_when_a_file_that_the_scene_names_changes() {
    let package = Package::new("changing");
    let made = |what: &str| {
        let said = package.cargo(&["build"]);
        assert!(said.is_success, "{what}: {}", said.errors);
        (package.text("plated.wgsl"), said.errors.contains("Compiling changing"))
    };
    let (first, _) = made("first");
    assert_eq!(made("unchanged"), (first.clone(), false));
    package.write("scenes/plating.csv", "wavelength_nm,n,k\n360,0.3,1.9\n555,0.4,2.4\n830,0.2,5.3\n");
    let (second, is_made_again) = made("other constants");
    assert!(is_made_again && second != first);
}

#[test]
fn a_build_script_that_fails_says_where_what_and_what_would_be_right() {
    let package = Package::new("failing");
    let scene = "name = \"plated\"\n[film]\nior = 1.4\nthickness_nm = [0, -5]\n[base]\nior = 1.5\n";
    for (text, expected) in [
        (
            scene.to_owned(),
            "Error: scenes/plated.toml:4:20: `film.thickness_nm[1]` is -5, but a film thickness lies between 0 and 1000000 \
             nm\n      |\n    4 | thickness_nm = [0, -5]\n      |                    ^^ out of range\n    help: thickness is \
             in nanometres",
        ),
        (
            format!("{}[emit]\nvariant = \"poles:q=5\"\n", scene.replace("-5", "500")),
            "Error: scenes/plated.toml: unknown option `q` in the variant `poles:q=5`\n    help: poles takes k=6",
        ),
        (
            format!("{}[emit]\nvariant = \"fitted:k=3\"\n", scene.replace("-5", "500")),
            "a fit to the scene needs a solver\n    help: build pavo with its feature `fit`",
        ),
        (scene.replace("-5", "500").replace("ior = 1.5", "csv = \"absent.csv\""), "Error: scenes/plated.toml:6:7: "),
    ] {
        package.write("scenes/plated.toml", &text);
        let said = package.cargo(&["build"]);
        assert!(!said.is_success && said.errors.contains(expected), "{}", said.errors);
        assert!(!said.errors.contains("panicked"), "{}", said.errors);
    }
}
