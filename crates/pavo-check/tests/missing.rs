//! What is not installed is named, with what to install, and never taken for a pass.
//!
//! The test runs itself a second time as a process that finds neither programs nor drivers.
#![cfg(not(feature = "bundled"))]

use std::process::Command;

use pavo_check::doctor::survey;
use pavo_check::static_cost::StaticCompiler;
use pavo_check::{CheckError, Device, Stage, disassemble, judge_glsl, judge_text, judge_wgsl, wgsl_to_spirv};
use pavo_emit::{Form, Language};

/// Set in the process that finds nothing.
const MARK: &str = "PAVO_CHECK_TEST_FINDS_NOTHING";

fn check_missing<T>(result: Result<T, CheckError>, what: &str, package: &str) {
    let error = result.err().unwrap_or_else(|| panic!("{what} is not missing"));
    assert!(matches!(error, CheckError::Missing { .. }), "{error:?}");
    assert_eq!(error.exit_status(), 3);
    let message = error.to_string();
    assert!(message.contains(what) && message.contains(&format!("`{package}`")), "{message}");
}

#[test]
fn what_is_missing_is_named_with_its_package() {
    if std::env::var_os(MARK).is_some() {
        return find_nothing();
    }
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "what_is_missing_is_named_with_its_package"])
        .env(MARK, "1")
        .env("PATH", "/there/is/no/folder")
        .env("XDG_DATA_DIRS", "/there/is/no/folder")
        .env("VK_DRIVER_FILES", "/there/is/no/lvp_icd.json")
        .env("VK_ICD_FILENAMES", "/there/is/no/lvp_icd.json")
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

fn find_nothing() {
    let wgsl = "@compute @workgroup_size(1) fn run() {}";
    check_missing(judge_wgsl(None, "a.wgsl", wgsl), "spirv-val", "spirv-tools");
    check_missing(judge_glsl(Stage::Fragment, "a.frag", "#version 450\nvoid main() {}"), "glslang", "glslang-tools");
    check_missing(judge_text(Language::Essl300, Form::Library, "a.glsl", ""), "glslang", "glslang-tools");
    check_missing(disassemble(&wgsl_to_spirv("a.wgsl", wgsl).unwrap()), "spirv-dis", "spirv-tools");
    check_missing(Device::lavapipe(), "lavapipe", "mesa-vulkan-drivers");
    check_missing(Device::named("llvmpipe"), "Vulkan driver", "mesa-vulkan-drivers");
    check_missing(StaticCompiler::open("navi21"), "RADV", "mesa-vulkan-drivers");
    let findings = survey();
    let missing = findings.iter().filter(|finding| !finding.found).map(|finding| finding.name.as_str());
    assert_eq!(missing.collect::<Vec<_>>(), ["glslang", "spirv-val", "spirv-dis", "lavapipe", "RADV"]);
    for finding in findings.iter().filter(|finding| !finding.found) {
        assert!(
            finding.install.as_deref().is_some_and(|install| install.contains("install the package")),
            "{finding:?}"
        );
    }
}
