//! Looks for the tools and drivers that the judges and the runs need.

use std::path::PathBuf;

use serde::Serialize;

use crate::install::{GLSLANG, LAVAPIPE, RADV, Requirement, SPIRV_DIS, SPIRV_VAL, VULKAN_LOADER};
use crate::judge::{NAGA_VERSION, SYN_VERSION, glslang_version, spirv_tool_version};
use crate::static_cost::StaticCompiler;
use crate::vulkan::{Device, Driver, LAVAPIPE_MANIFEST, RADV_MANIFEST, manifests};

/// Whether one tool or driver is here.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// The tool or driver.
    pub name: String,
    /// Whether it is here and works.
    pub found: bool,
    /// Its version, where it tells one.
    pub version: Option<String>,
    /// Where it is: the path of a program or a driver's library, or `compiled in`.
    pub location: Option<String>,
    /// What to install; only when it is missing.
    pub install: Option<String>,
}

/// Looks for naga, syn, glslang, spirv-val, spirv-dis, the Vulkan loader, lavapipe and RADV, in that order.
pub fn survey() -> Vec<Finding> {
    vec![
        Finding {
            name: "naga".to_owned(),
            found: true,
            version: Some(NAGA_VERSION.to_owned()),
            location: Some(COMPILED_IN.to_owned()),
            install: None,
        },
        Finding {
            name: "syn".to_owned(),
            found: true,
            version: Some(SYN_VERSION.to_owned()),
            location: Some(COMPILED_IN.to_owned()),
            install: None,
        },
        program("glslang", GLSLANG, &["glslangValidator", "glslang"], glslang_version()),
        program("spirv-val", SPIRV_VAL, &["spirv-val"], spirv_tool_version("spirv-val")),
        program("spirv-dis", SPIRV_DIS, &["spirv-dis"], spirv_tool_version("spirv-dis")),
        vulkan_loader(),
        lavapipe(),
        radv(),
    ]
}

const COMPILED_IN: &str = "compiled in";

fn program(name: &str, requirement: Requirement, programs: &[&str], version: Option<String>) -> Finding {
    let location = if cfg!(feature = "bundled") {
        Some(COMPILED_IN.to_owned())
    } else {
        programs.iter().find_map(|program| find_program(program)).map(|path| path.display().to_string())
    };
    finding(name, requirement, version.is_some() || location.is_some(), version, location)
}

fn vulkan_loader() -> Finding {
    let driver = Driver::through_loader();
    let found = !matches!(&driver, Err(crate::CheckError::Missing { what, .. }) if what == VULKAN_LOADER.name);
    let version = driver.ok().and_then(|driver| driver.loader_version());
    finding("Vulkan loader", VULKAN_LOADER, found, version, None)
}

fn lavapipe() -> Finding {
    let device = Device::lavapipe();
    let version = device.as_ref().ok().map(|device| device.description().to_string());
    let location = manifests(LAVAPIPE_MANIFEST).first().map(|manifest| manifest.library.display().to_string());
    finding("lavapipe", LAVAPIPE, device.is_ok(), version, location)
}

fn radv() -> Finding {
    let compiler = StaticCompiler::open(SURVEYED_FAMILY);
    let version = compiler.as_ref().ok().map(|compiler| compiler.description().to_string());
    let location = manifests(RADV_MANIFEST).first().map(|manifest| manifest.library.display().to_string());
    finding("RADV", RADV, compiler.is_ok(), version, location)
}

/// The family that RADV is opened for, to see that it works: one that opens fast.
const SURVEYED_FAMILY: &str = "vega10";

fn finding(
    name: &str,
    requirement: Requirement,
    found: bool,
    version: Option<String>,
    location: Option<String>,
) -> Finding {
    let install = (!found).then(|| requirement.install.to_owned());
    Finding { name: name.to_owned(), found, version, location, install }
}

/// The path of a program in the folders of `PATH`.
fn find_program(name: &str) -> Option<PathBuf> {
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&std::env::var_os("PATH")?).map(|folder| folder.join(&file)).find(|path| path.is_file())
}
