//! `pavo check` tells good shaders from bad ones.

use pavo::Variant;
use pavo_tests::{SCENES, run, scene_file};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

#[test]
fn a_broken_shader_is_refused_with_its_line_and_judge() {
    let spirv_header: Vec<u8> =
        [0x0723_0203_u32, 0x0001_0300, 0, 8, 0, 0xffff_ffff].iter().flat_map(|word| word.to_le_bytes()).collect();
    let cases: [(&str, &[u8], &[&str]); 7] = [
        ("broken.wgsl", b"fn f() -> f32 {\n    return vec3f(1.0);\n}\n", &["broken.wgsl:", "[naga]"]),
        ("broken.frag", b"#version 450\nvoid main() {\n    undeclared = 1.0;\n}\n", &["broken.frag:3", "glslang"]),
        (
            "broken.glsl",
            b"#version 300 es\nprecision highp float;\nvoid main() { float x = ; }\n",
            &["broken.glsl:3", "glslang"],
        ),
        ("broken.hlsl", b"float f(float x) {\n    return y;\n}\n", &["broken.hlsl:2", "[glslang]"]),
        ("broken.osl", b"vector f(float x) {\n    return y;\n}\n", &["broken.osl:2", "[glslang, read as HLSL]"]),
        ("broken.rs", b"pub fn f(x: f32) -> f32 {\n    x +\n}\n", &["broken.rs:3", "[syn]"]),
        ("broken.spv", &spirv_header, &["broken.spv", "spirv-val"]),
    ];
    for (file, content, expected) in cases {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        std::fs::write(folder.path().join(file), content).expect("the file can be written");
        let ran = run(PROGRAM, folder.path(), &["check", file]);
        assert_eq!(ran.status, 1, "{file}: {}", ran.errors);
        for fragment in expected {
            assert!(ran.errors.contains(fragment), "{file}: no {fragment:?} in\n{}", ran.errors);
        }
    }
}

#[test]
fn every_form_of_every_starter_scene_is_judged_when_it_is_emitted() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    for name in SCENES {
        let scene = scene_file(name).display().to_string();
        for (target, forms) in [
            ("wgsl", &["library", "compute", "fragment"][..]),
            ("glsl450", &["library", "compute", "fragment"]),
            ("glsl330", &["library", "fragment"]),
            ("essl300", &["library", "fragment"]),
            ("hlsl", &["library", "compute", "fragment"]),
            ("osl", &["library"]),
            ("rust", &["library"]),
            ("spirv", &["compute", "fragment"]),
            ("spirv-asm", &["compute", "fragment"]),
        ] {
            for form in forms {
                let file = format!("{name}-{form}.{target}");
                let arguments = ["emit", &scene, "--target", target, "--form", form, "-o", &file];
                let ran = run(PROGRAM, folder.path(), &arguments);
                assert_eq!(ran.status, 0, "{file}: {}", ran.errors);
                assert!(folder.path().join(&file).exists(), "{file} is written");
            }
        }
    }
}

#[test]
fn every_variant_passes_every_judge() {
    let targets = "wgsl,glsl450,glsl330,essl300,hlsl,osl,rust,spirv";
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    for variant in Variant::candidates().into_iter().map(|variant| variant.to_string()) {
        let mut made = 0;
        for name in ["soap-bubble", "anodised-titanium", "coated-lens", "lacquered-gold"] {
            let scene = scene_file(name).display().to_string();
            let arguments = ["build", &scene, "-o", "out", "--no-run", "--target", targets, "--variant", &variant];
            let ran = run(PROGRAM, folder.path(), &arguments);
            // Some variants are for uniform films only, some for media of fixed indices, or of one index.
            let is_refused = ran.status == 2 && ran.errors.contains("cannot be made for the scene");
            assert!(ran.status == 0 || is_refused, "{name} by {variant}: {}", ran.errors);
            made += usize::from(ran.status == 0);
            // A dielectric and a conductor will do, where there are both.
            if made == 2 {
                break;
            }
        }
        assert!(made > 0, "{variant} is made for none of the scenes");
    }
}

#[test]
fn the_judges_pass_what_build_writes() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("beetle-shell").display().to_string();
    let ran =
        run(PROGRAM, folder.path(), &["build", &scene, "-o", "out", "--no-run", "--target", "wgsl,glsl450,spirv"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    assert!(ran.output.contains("NOT run on lavapipe"), "{}", ran.output);
    for file in ["beetle-shell.wgsl", "beetle-shell.450.glsl", "beetle-shell.spv"] {
        let ran = run(PROGRAM, &folder.path().join("out"), &["check", file]);
        assert_eq!(ran.status, 0, "{file}: {}", ran.errors);
    }
}

#[test]
fn the_preview_shows_a_lit_coloured_sphere() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    let ran = run(PROGRAM, folder.path(), &["preview", &scene, "-o", "sphere.png", "--size", "64"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    let file = std::fs::File::open(folder.path().join("sphere.png")).expect("the picture is written");
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().expect("it is a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
    reader.next_frame(&mut pixels).expect("it is whole");
    let pixel = |x: usize, y: usize| -> [u8; 3] { std::array::from_fn(|channel| pixels[(y * 64 + x) * 3 + channel]) };
    assert_eq!(pixel(1, 1), [0, 0, 0], "around the sphere it is dark");
    let colours: Vec<[u8; 3]> = (12..52).map(|y| pixel(32, y)).collect();
    let saturated =
        colours.iter().filter(|colour| colour.iter().max() > colour.iter().min().map(|least| least + 40).as_ref());
    assert!(saturated.count() > 5, "the film shows colours: {colours:?}");
    assert!(
        colours.iter().any(|colour| colour.iter().all(|channel| *channel > 100)),
        "there are highlights: {colours:?}"
    );
}
