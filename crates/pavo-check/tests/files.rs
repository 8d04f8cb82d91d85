//! Files are judged by their kind.

use std::path::PathBuf;

use pavo_check::{CheckError, disassemble, judge_file, wgsl_to_spirv};
use tempfile::TempDir;

/// Writes a file of that name and judges it: the judges that pass it, or the message.
fn judge(name: &str, content: impl AsRef<[u8]>) -> Result<String, String> {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, content).unwrap();
    match judge_file(&path) {
        Ok(verdicts) => Ok(verdicts.iter().map(|verdict| verdict.judge.name()).collect::<Vec<_>>().join(" ")),
        Err(error) => {
            let message = error.to_string();
            assert!(message.contains(name), "no file name in {message}");
            Err(message)
        }
    }
}

fn check_passes(name: &str, content: impl AsRef<[u8]>, judges: &str) {
    assert_eq!(judge(name, content), Ok(judges.to_owned()), "{name}");
}

fn check_refused(name: &str, content: impl AsRef<[u8]>, expected: &str) {
    let message = judge(name, content).expect_err(name);
    assert!(message.contains(expected), "{name}: {message}\nexpected: {expected}");
}

const WGSL: &str = "@compute @workgroup_size(1)\nfn run() {\n    var x = 1.0;\n}\n";
const FUNCTION: &str = "float square(float x) {\n    return x * x;\n}\n";

#[test]
fn glsl_files_are_judged_by_version_and_stage() {
    let for_vulkan = "naga glslang spirv-val";
    check_passes("a.glsl", FUNCTION, for_vulkan);
    check_passes("a.frag", format!("#version 330 core\n{FUNCTION}"), "glslang");
    check_passes("a.frag.glsl", "#version 450\nvoid main() { discard; }\n", for_vulkan);
    check_passes("a.comp", "#version 460\nlayout(local_size_x = 4) in;\nvoid main() {}\n", for_vulkan);
    check_passes("a.glsl", "#version 450\nlayout(local_size_x = 4) in;\nvoid main() {}\n", for_vulkan);
    check_passes("a.glsl", "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n", "glslang");
    check_passes("a.VERT", "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n", "glslang");
    // The compiled-in glslang gives a column as well.
    check_refused("a.vert", "#version 450\nvoid main() {\n    discard;\n}\n", "a.vert:3:");
    check_refused("a.frag", "void main() { discard; }\n", "a.frag:1: [glslang] no `#version` line");
    check_refused("a.frag", "#version 300 es\nfloat f() { return 1; }\n", "a.frag:2:");
}

#[test]
fn wgsl_files_may_have_entry_points_or_none() {
    check_passes("a.wgsl", WGSL, "naga spirv-val");
    check_passes("a.wgsl", "fn f() {}", "naga");
    check_refused("a.wgsl", "fn f() {", "a.wgsl:1:9: [naga] ");
}

#[test]
fn spirv_files_are_validated_as_binary_and_as_text() {
    let words = wgsl_to_spirv("a.wgsl", WGSL).unwrap();
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    check_passes("a.spv", &bytes, "spirv-val");
    check_refused("a.spv", &bytes[..bytes.len() - 3], "[spirv-val] ");
    check_refused("a.spv", &bytes[..bytes.len() - 3], "not a whole number of 4-byte words");
    check_refused("a.spv", "hello world!", "[spirv-val] Invalid SPIR-V");
    let text = disassemble(&words).unwrap();
    check_passes("a.spvasm", &text, "spirv-val");
    check_refused("a.spvasm", "OpCapability Shader\nOpNothing\n", "a.spvasm:2:1: [spirv-val] spirv-as: ");
    check_refused("a.spvasm", text.replace("OpFunctionEnd", ""), "[spirv-val] ");
}

#[test]
fn other_files_say_what_would_be_right() {
    let endings = "expected one of .wgsl, .glsl, .vert, .frag, .comp, .hlsl, .osl, .spv, .spvasm, .rs";
    check_refused("a.metal", "", endings);
    check_refused("wgsl", "", "no judge reads this kind of file");
    check_refused("a.wgsl", b"fn f() {}\n\xff", "not UTF-8 text: wrong byte at offset 10");
    let missing = PathBuf::from("there/is/no/file.wgsl");
    assert!(matches!(judge_file(&missing), Err(CheckError::Unreadable { path, .. }) if path == missing));
}
