//! The survey names everything that is needed, and what to install for what is missing.

use pavo_check::doctor::survey;

#[test]
fn every_tool_and_driver_of_the_tests_is_here() {
    let findings = survey();
    let names: Vec<&str> = findings.iter().map(|finding| finding.name.as_str()).collect();
    assert_eq!(names, ["naga", "syn", "glslang", "spirv-val", "spirv-dis", "Vulkan loader", "lavapipe", "RADV"]);
    for finding in &findings {
        assert!(finding.found, "{} is missing: {}", finding.name, finding.install.as_deref().unwrap_or("?"));
        assert!(finding.install.is_none(), "{finding:?}");
        assert!(finding.version.as_deref().is_some_and(|version| version.contains('.')), "{finding:?}");
    }
    let json = serde_json::to_value(&findings).unwrap();
    assert_eq!(json[0]["location"], "compiled in");
}
