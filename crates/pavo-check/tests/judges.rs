//! The judges accept what is correct and refuse what is not, naming file, line and judge.

use pavo_check::{
    CheckError, Judge, Stage, assemble_spirv, disassemble, glsl_to_spirv, judge_glsl, judge_spirv, judge_text,
    judge_wgsl, wgsl_to_spirv,
};
use pavo_emit::{Form, Language};

const FILE: &str = "folder/shader.txt";

/// The names of the judges that pass a text, or the diagnostics of those that refuse it, as `line: [judge] message`.
fn outcome<V: IntoIterator<Item = pavo_check::Verdict>>(result: Result<V, CheckError>) -> Result<String, String> {
    match result {
        Ok(verdicts) => {
            let verdicts: Vec<_> = verdicts.into_iter().collect();
            for verdict in &verdicts {
                assert!(verdict.passed && !verdict.version.is_empty(), "{verdict:?}");
            }
            Ok(verdicts.iter().map(|verdict| verdict.judge.name()).collect::<Vec<_>>().join(" "))
        }
        Err(error @ CheckError::Refused { .. }) => {
            assert_eq!(error.exit_status(), 1);
            let lines = error.diagnostics().map(|diagnostic| {
                assert_eq!(diagnostic.file, FILE, "{diagnostic}");
                let line = diagnostic.line.map_or("-".to_owned(), |line| line.to_string());
                format!("{line}: [{}] {}", diagnostic.judge, diagnostic.message)
            });
            Err(lines.collect::<Vec<_>>().join("\n"))
        }
        Err(other) => panic!("the judges could not do their work: {other}"),
    }
}

fn check_passes(language: Language, form: Form, text: &str, judges: &str) {
    assert_eq!(outcome(judge_text(language, form, FILE, text)), Ok(judges.to_owned()), "{language:?} {form:?}\n{text}");
}

/// Each part of `expected` begins the diagnostic of one judge, and no other judge refuses.
fn check_refused(language: Language, form: Form, text: &str, expected: &[&str]) {
    check_refusal(outcome(judge_text(language, form, FILE, text)), text, expected);
}

fn check_refusal(outcome: Result<String, String>, text: &str, expected: &[&str]) {
    let said = outcome.expect_err(text);
    assert_eq!(said.lines().count(), expected.len(), "{text}\n{said}");
    for (line, expected) in said.lines().zip(expected) {
        assert!(line.starts_with(expected), "{text}\n{line}\n{expected}");
    }
}

const WGSL_COMPUTE: &str = "\
@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;

@compute @workgroup_size(64)
fn evaluate(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&inputs) {
        outputs[id.x] = cos(inputs[id.x]);
    }
}
";

const GLSL_450_COMPUTE: &str = "\
#version 450
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs { float inputs[]; };
layout(std430, set = 0, binding = 1) buffer Outputs { float outputs[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(inputs.length())) {
        outputs[i] = cos(inputs[i]);
    }
}
";

const FUNCTION: &str = "\
// The square of a number.
float square(float x) {
    return x * x;
}
";

/// [`FUNCTION`] with an unknown name in line 3.
const WRONG_FUNCTION: &str = "\
// The square of a number.
float square(float x) {
    return x * y;
}
";

/// A fragment shader of one output after the lines `head`; `body` stands in the last line but one.
fn fragment(head: &str, body: &str) -> String {
    format!("{head}\nout vec4 color;\nvoid main() {{\n    {body}\n}}\n")
}

#[test]
fn correct_texts_pass_every_judge_of_their_language() {
    check_passes(Language::Wgsl, Form::Compute, WGSL_COMPUTE, "naga spirv-val");
    check_passes(Language::Glsl450, Form::Compute, GLSL_450_COMPUTE, "naga glslang spirv-val");
    let text = fragment("#version 450\nlayout(location = 0)", "color = vec4(dFdx(gl_FragCoord.x));");
    check_passes(Language::Glsl450, Form::Fragment, &text, "naga glslang spirv-val");
    let text = fragment("#version 330 core\nuniform vec3 light;", "color = vec4(light, 1.0);");
    check_passes(Language::Glsl330, Form::Fragment, &text, "glslang");
    let text = fragment("#version 300 es\nprecision highp float;\nuniform vec3 light;", "color = vec4(light, 1.0);");
    check_passes(Language::Essl300, Form::Fragment, &text, "glslang");
}

#[test]
fn libraries_pass_without_an_entry_point() {
    check_passes(Language::Wgsl, Form::Library, "fn square(x: f32) -> f32 {\n    return x * x;\n}\n", "naga");
    check_passes(Language::Glsl450, Form::Library, FUNCTION, "naga glslang spirv-val");
    check_passes(Language::Glsl330, Form::Library, FUNCTION, "glslang");
    check_passes(Language::Essl300, Form::Library, FUNCTION, "glslang");
    check_passes(Language::Essl300, Form::Library, &format!("precision highp float;\n\n{FUNCTION}"), "glslang");
    check_passes(Language::Glsl450, Form::Library, &format!("#version 450\n{FUNCTION}"), "naga glslang spirv-val");
}

#[test]
fn derivatives_are_allowed_in_libraries() {
    let text = "float edge(float x) {\n    return fwidth(x);\n}\n";
    check_passes(Language::Glsl450, Form::Library, text, "naga glslang spirv-val");
    check_passes(Language::Essl300, Form::Library, text, "glslang");
}

#[test]
fn wrong_wgsl_is_refused_at_its_line() {
    for (text, expected) in [
        ("fn f() -> f32 {\n    return 1.0\n}\n", "3: [naga] expected "),
        ("fn f() -> f32 {\n    let x = 1u;\n    return x * 2.0;\n}\n", "3: [naga] "),
        ("fn f(x: f32) -> f32 {\n    return y;\n}\n", "2: [naga] no definition in scope for identifier: `y`"),
        ("fn f(x: f32) -> f32 {\n    return vec2(x, x);\n}\n", "2: [naga] "),
    ] {
        check_refused(Language::Wgsl, Form::Library, text, &[expected]);
    }
}

#[test]
fn rust_is_judged_by_its_syntax() {
    check_passes(Language::Rust, Form::Library, "pub fn square(x: f32) -> f32 {\n    x * x\n}\n", "syn");
    let text = "pub fn f(x: f32) -> f32 {\n    x +\n}\n";
    check_refused(Language::Rust, Form::Library, text, &["3: [syn] "]);
    let verdicts = judge_text(Language::Rust, Form::Library, FILE, "").unwrap();
    assert_eq!(serde_json::to_value(&verdicts).unwrap()[0]["checks"], "syntax alone");
}

#[test]
fn wrong_glsl_is_refused_at_its_line_by_every_judge_that_reads_it() {
    let wrong = "color = vec4(missing, 1.0);";
    let text = fragment("#version 450\nlayout(location = 0)", wrong);
    let unknown = "5: [glslang] 'missing' : undeclared identifier";
    check_refused(Language::Glsl450, Form::Fragment, &text, &["5: [naga] Unknown variable: missing", unknown]);
    let text = fragment("#version 330 core\n", wrong);
    check_refused(Language::Glsl330, Form::Fragment, &text, &[unknown]);
    let text = fragment("#version 300 es\nprecision highp float;", wrong);
    check_refused(Language::Essl300, Form::Fragment, &text, &[unknown]);
}

#[test]
fn what_only_one_version_allows_is_refused_in_the_others() {
    // An implicit conversion from int to float is allowed in desktop GLSL only.
    let text = fragment("#version 330 core\n", "color = vec4(1) * 2;");
    check_passes(Language::Glsl330, Form::Fragment, &text, "glslang");
    let text = fragment("#version 300 es\nprecision highp float;", "color = vec4(1) * 2;");
    check_refused(Language::Essl300, Form::Fragment, &text, &["5: [glslang] "]);
    // A uniform outside a block is not allowed for Vulkan.
    let text = "#version 450\nuniform vec3 light;\nlayout(location = 0) out vec4 color;\nvoid main() {\n    color = vec4(light, 1.0);\n}\n";
    let said = outcome(judge_text(Language::Glsl450, Form::Fragment, FILE, text)).unwrap_err();
    assert!(said.contains("2: [glslang] 'non-opaque uniforms outside a block'"), "{said}");
    // A name that 4.50 reserves and 4.40 does not.
    let text = "float f() {\n    float pervertexEXT = 1.0;\n    return pervertexEXT;\n}\n";
    let said = outcome(judge_text(Language::Glsl450, Form::Library, FILE, text)).unwrap_err();
    assert!(said.contains("2: [glslang] "), "{said}");
}

#[test]
fn lines_of_a_library_are_those_of_its_own_text() {
    let glslang = "3: [glslang] 'y' : undeclared identifier";
    check_refused(Language::Glsl450, Form::Library, WRONG_FUNCTION, &["3: [naga] Unknown variable: y", glslang]);
    check_refused(Language::Glsl330, Form::Library, WRONG_FUNCTION, &[glslang]);
    check_refused(Language::Essl300, Form::Library, WRONG_FUNCTION, &[glslang]);
    // A brace that is missing at the end is missed in the last line.
    let unclosed = FUNCTION.trim_end().trim_end_matches('}');
    check_refused(Language::Essl300, Form::Library, unclosed, &["3: [glslang] syntax error"]);
}

#[test]
fn a_form_without_its_entry_point_is_refused() {
    check_refused(Language::Wgsl, Form::Fragment, WGSL_COMPUTE, &["-: [naga] no entry point for this form"]);
    check_refused(Language::Glsl330, Form::Fragment, "#version 330 core\n", &["-: [glslang] "]);
    let text = "#version 300 es\nprecision highp float;\nfloat f() { return 1.0; }\n";
    check_refused(
        Language::Essl300,
        Form::Fragment,
        text,
        &["-: [glslang] Linking fragment stage: Missing entry point"],
    );
}

#[test]
fn a_form_with_another_version_line_is_refused() {
    let expected = "1: [glslang] `#version 330 core` where `#version 450` is expected";
    check_refused(Language::Glsl450, Form::Fragment, &fragment("#version 330", "color = vec4(1.0);"), &[expected]);
    let expected = "1: [glslang] no `#version` line";
    check_refused(Language::Essl300, Form::Fragment, &fragment("", "color = vec4(1.0);"), &[expected]);
    let expected = "2: [glslang] this `#version` cannot be read";
    check_refused(Language::Essl300, Form::Library, "\n#version new\n", &[expected]);
}

#[test]
fn a_nul_byte_is_refused_and_not_taken_for_the_end() {
    let text = "float f() { return 1.0; }\n\0 wrong";
    check_refused(Language::Glsl450, Form::Library, text, &["2: [glslang] a NUL byte"]);
    let said = outcome(judge_text(Language::Wgsl, Form::Library, FILE, "fn f() {}\n\0")).unwrap_err();
    assert!(said.starts_with("2: [naga] "), "{said}");
}

#[test]
fn vertex_shaders_are_judged_too() {
    let text = "#version 450\nvoid main() {\n    gl_Position = vec4(0.0);\n}\n";
    assert_eq!(outcome(judge_glsl(Stage::Vertex, FILE, text)), Ok("naga glslang spirv-val".to_owned()));
    let text = "#version 300 es\nvoid main() {\n    gl_Position = vec3(0.0);\n}\n";
    check_refusal(outcome(judge_glsl(Stage::Vertex, FILE, text)), text, &["3: [glslang] 'assign'"]);
    let text = "@vertex\nfn place() -> @builtin(position) vec4<f32> {\n    return vec4<f32>(0.0);\n}\n";
    assert_eq!(outcome(judge_wgsl(Some(Stage::Vertex), FILE, text)), Ok("naga spirv-val".to_owned()));
}

/// The words of a correct module from each of the two roads to SPIR-V.
fn modules() -> [Vec<u32>; 2] {
    [wgsl_to_spirv(FILE, WGSL_COMPUTE).unwrap(), glsl_to_spirv(FILE, GLSL_450_COMPUTE, Stage::Compute).unwrap()]
}

#[test]
fn both_roads_to_spirv_are_valid_and_keep_names() {
    for words in modules() {
        assert_eq!(outcome(judge_spirv(FILE, &words).map(|verdict| [verdict])), Ok("spirv-val".to_owned()));
        let text = disassemble(&words).unwrap();
        assert!(text.starts_with("; SPIR-V\n; Version: 1.3\n"), "{text}");
        assert!(text.contains("%inputs") || text.contains("\"inputs\""), "{text}");
        assert!(!text.contains('\u{1b}'), "colours in {text}");
        assert_eq!(assemble_spirv(FILE, &text).map(|again| again.len()).ok(), Some(words.len()));
    }
    let text = disassemble(&modules()[0]).unwrap();
    assert!(text.contains("OpEntryPoint GLCompute %evaluate \"evaluate\""), "{text}");
}

#[test]
fn wrong_spirv_is_refused_at_its_instruction() {
    for words in modules() {
        let text = disassemble(&words).unwrap();
        let listed: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
        let instruction = 1 + listed.iter().position(|line| line.contains("OpLoad ")).unwrap();

        // The load reads an identifier that is not there.
        let mut wrong = words.clone();
        let mut start = 5;
        while wrong[start] & 0xffff != 61 {
            start += (wrong[start] >> 16) as usize;
        }
        wrong[start + 3] = wrong[3] + 7;
        let said = outcome(judge_spirv(FILE, &wrong).map(|verdict| [verdict])).unwrap_err();
        assert!(said.starts_with(&format!("{instruction}: [spirv-val] ID ")), "{said}");
        assert!(said.contains("has not been defined"), "{said}");

        let said = outcome(judge_spirv(FILE, &words[..words.len() / 2]).map(|verdict| [verdict])).unwrap_err();
        assert!(said.contains(": [spirv-val] "), "{said}");
        for wrong in [&[][..], &[1, 2, 3, 4, 5, 6]] {
            let said = outcome(judge_spirv(FILE, wrong).map(|verdict| [verdict])).unwrap_err();
            assert!(said.starts_with("-: [spirv-val] Invalid SPIR-V"), "{said}");
        }
    }
}

#[test]
fn spirv_for_vulkan_needs_an_entry_point() {
    let error = wgsl_to_spirv(FILE, "fn f() {}").unwrap_err();
    assert!(error.to_string().contains("no entry point"), "{error}");
    let error = glsl_to_spirv(FILE, "#version 450\nfloat f() { return 1.0; }\n", Stage::Compute).unwrap_err();
    assert!(error.to_string().contains("Missing entry point"), "{error}");
}

#[test]
fn loops_keep_their_shape_in_spirv() {
    let text = "@compute @workgroup_size(1)\nfn run() {\n    for (var i = 0; i < 4; i++) {}\n}\n";
    let listing = disassemble(&wgsl_to_spirv(FILE, text).unwrap()).unwrap();
    assert!(!listing.contains("loop_bound"), "{listing}");
}

#[test]
fn overrides_take_their_default_values() {
    let text =
        "override size = 2.0;\n@fragment\nfn shade() -> @location(0) vec4<f32> {\n    return vec4<f32>(size);\n}\n";
    assert_eq!(outcome(judge_wgsl(None, FILE, text)), Ok("naga spirv-val".to_owned()));
    let text = text.replace(" = 2.0", ": f32");
    let said = outcome(judge_wgsl(None, FILE, &text)).unwrap_err();
    assert!(said.starts_with("-: [naga] naga cannot write this module as SPIR-V"), "{said}");
}

#[test]
fn a_refusal_prints_file_line_column_judge_and_message() {
    let error = judge_text(Language::Wgsl, Form::Library, FILE, "fn f() -> f32 {\n    return y;\n}\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "refused by naga\nfolder/shader.txt:2:12: [naga] no definition in scope for identifier: `y`: unknown identifier"
    );
}

#[test]
fn a_refusal_carries_the_judges_that_pass_as_well() {
    // naga has no opinion about the rules of linking: only glslang misses the body.
    let text = "#version 450\nfloat f(float x);\nlayout(location = 0) out vec4 color;\nvoid main() {\n    color = vec4(1.0);\n    f(1.0);\n}\n";
    let Err(CheckError::Refused { verdicts }) = judge_glsl(Stage::Fragment, FILE, text) else {
        panic!("a function without a body passes")
    };
    let judges: Vec<Judge> = verdicts.iter().map(|verdict| verdict.judge).collect();
    assert_eq!(judges, [Judge::Naga, Judge::Glslang]);
    let json = serde_json::to_value(&verdicts).unwrap();
    assert_eq!(json[1]["judge"], "glslang");
    assert_eq!(json[1]["passed"], false);
}
