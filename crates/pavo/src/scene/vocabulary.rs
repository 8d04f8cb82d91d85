//! The names a scene may use, and the limits of its numbers.

/// The observers a scene may name: the CIE 1931 2 degree and the CIE 1964 10 degree standard observer.
pub const OBSERVERS: &[&str] = &["cie1931-2deg", "cie1964-10deg"];

/// The illuminants a scene may name: equal energy, and CIE D65, D50 and A.
pub const ILLUMINANTS: &[&str] = &["E", "D65", "D50", "A"];

/// The colour spaces a scene may name, all linear.
pub const SPACES: &[&str] = &["linear-srgb", "display-p3", "rec2020", "acescg", "xyz"];

/// The absorbing materials with built-in optical constants, by chemical symbol.
pub const METALS: &[&str] = &pavo_spectra::OpticalConstants::ABSORBING_NAMES;

/// The transparent materials with built-in optical constants.
pub const FILM_MATERIALS: &[&str] = &pavo_spectra::OpticalConstants::DIELECTRIC_NAMES;

/// The languages that can be emitted.
pub const TARGETS: &[&str] = &["wgsl", "glsl450", "glsl330", "essl300", "hlsl", "osl", "rust", "spirv", "spirv-asm"];

/// The languages that are emitted when a scene does not say.
pub const DEFAULT_TARGETS: &[&str] = &["wgsl", "glsl450", "essl300", "spirv"];

/// The variant that is emitted when a scene does not say: the series to order 3 with Gaussian fits in XYZ.
pub const DEFAULT_VARIANT: &str = "series:m=3,fit=xyz-gauss";

/// The smallest refractive index accepted; real ones in visible light stay above 0.02.
pub const MINIMUM_INDEX: f64 = 0.01;

/// The largest refractive or absorption index accepted; real ones in visible light stay below 15.
pub const MAXIMUM_INDEX: f64 = 100.0;

/// The largest film thickness accepted, in nanometres: one millimetre.
pub const MAXIMUM_THICKNESS_NM: f64 = 1.0e6;

/// The most characters in a scene's name or in a prefix.
pub const MAXIMUM_IDENTIFIER_LENGTH: usize = 64;

/// The workflows that `base.workflow` may name.
pub(super) const WORKFLOWS: &[&str] = &["metalness", "f0"];

/// The names that `surface.visibility_k` may take instead of a number.
pub(super) const VISIBILITY_NAMES: &[&str] = &["punctual", "ibl"];

/// The inputs whose rate a scene may say. Directions and the cosines between them are always per pixel.
pub const RATED_INPUTS: &[&str] = &[
    "thickness_nm",
    "ambient_ior",
    "film_ior",
    "base_ior",
    "base_kappa",
    "f0",
    "edge_tint",
    "roughness",
    "base_color",
    "metalness",
    "visibility_k",
    "light_color",
    "light_intensity",
];

/// The rates of an input: once a material, at each vertex, at each pixel.
pub const RATES: &[&str] = &["material", "vertex", "pixel"];

/// How precise the numbers of the emitted code are.
pub const PRECISIONS: &[&str] = &["full", "half"];

/// The keys before the first table.
pub(super) const TOP_KEYS: &[&str] = &["name"];

/// Every table with its keys, in the order a scene file has them.
pub(super) const TABLES: &[(&str, &[&str])] = &[
    ("colour", &["observer", "illuminant", "illuminant_csv", "space"]),
    ("ambient", &["ior"]),
    ("film", &["ior", "material", "csv", "thickness_nm"]),
    ("base", &["ior", "kappa", "metal", "csv", "workflow", "f0", "edge_tint"]),
    ("surface", &["roughness", "diffuse", "base_color", "metalness", "visibility_k"]),
    ("lights", &["punctual"]),
    ("budget", &["max_delta_e"]),
    // Its keys are names of inputs, which are checked where they are read.
    ("rates", &[]),
    ("emit", &["targets", "variant", "prefix", "prepare", "vertex", "precision"]),
];

/// Words that people write for one of ours and that no edit distance would find.
pub(super) const ALIASES: &[(&str, &str)] = &[
    ("albedo", "base_color"),
    ("diffuse_color", "base_color"),
    ("eta", "ior"),
    ("n", "ior"),
    ("refractive_index", "ior"),
    ("k", "kappa"),
    ("extinction", "kappa"),
    ("metallic", "metalness"),
    ("specular_color", "f0"),
    ("edge_color", "edge_tint"),
    ("substrate", "base"),
    ("coating", "film"),
    ("medium", "ambient"),
    ("material", "surface"),
    ("output", "emit"),
    ("languages", "targets"),
    ("silver", "Ag"),
    ("gold", "Au"),
    ("copper", "Cu"),
    ("titanium", "Ti"),
    ("silicon", "Si"),
    ("equal-energy", "E"),
    ("tungsten", "A"),
    ("incandescent", "A"),
    ("uniform", "material"),
    ("constant", "material"),
    ("varying", "vertex"),
    ("f32", "full"),
    ("highp", "full"),
    ("f16", "half"),
    ("mediump", "half"),
    ("fragment", "pixel"),
    ("thickness", "thickness_nm"),
    ("webgl2", "essl300"),
    ("webgpu", "wgsl"),
    ("vulkan", "spirv"),
    ("directx", "hlsl"),
    ("unity", "hlsl"),
    ("unreal", "hlsl"),
    ("cycles", "osl"),
    ("blender", "osl"),
    ("rs", "rust"),
];

/// Words that mean something else, and that an edit distance would take for one of ours.
pub(super) const OTHERS: &[&str] = &["msl"];

/// What bounds a number of the scene, in the words of the message.
pub(super) struct Limits {
    /// What the number is, with its article.
    pub what: &'static str,
    /// The smallest value accepted.
    pub low: f64,
    /// The largest value accepted.
    pub high: f64,
    /// The unit after a number, with its space.
    pub unit: &'static str,
    /// What would be right.
    pub help: &'static str,
}

/// Limits of a refractive index.
pub(super) const INDEX_LIMITS: Limits = Limits {
    what: "a refractive index",
    low: MINIMUM_INDEX,
    high: MAXIMUM_INDEX,
    unit: "",
    help: "in visible light air is 1, water 1.33, glass 1.52, diamond 2.42; silver goes down to 0.05, silicon up to 6",
};

/// Limits of an absorption index.
pub(super) const KAPPA_LIMITS: Limits = Limits {
    what: "an absorption index",
    low: 0.0,
    high: MAXIMUM_INDEX,
    unit: "",
    help: "write the complex index as ior + i kappa with kappa positive: titanium is 2.7 + 3.8i in red light",
};

/// Limits of a colour difference.
pub(super) const DELTA_E_LIMITS: Limits = Limits {
    what: "a largest colour difference",
    low: 0.001,
    high: 100.0,
    unit: "",
    help: "it is in dE2000: 1 is just noticeable side by side, 0.1 is never seen",
};

/// Limits of a film thickness.
pub(super) const THICKNESS_LIMITS: Limits = Limits {
    what: "a film thickness",
    low: 0.0,
    high: MAXIMUM_THICKNESS_NM,
    unit: " nm",
    help: "thickness is in nanometres: a soap film has 10 to 1500, a lens coating about 100; 0 is no film",
};

/// Limits of a roughness.
pub(super) const ROUGHNESS_LIMITS: Limits = Limits {
    what: "a roughness",
    low: 0.0,
    high: 1.0,
    unit: "",
    help: "0 is a mirror and 1 fully rough; a percentage is divided by 100",
};

/// Limits of a metalness.
pub(super) const METALNESS_LIMITS: Limits = Limits {
    what: "a metalness",
    low: 0.0,
    high: 1.0,
    unit: "",
    help: "0 is a dielectric and 1 a metal; a percentage is divided by 100",
};

/// Limits of the k of the visibility term.
pub(super) const VISIBILITY_LIMITS: Limits = Limits {
    what: "the k of the visibility term",
    low: 0.0,
    high: 1.0,
    unit: "",
    help: "write \"punctual\" for (roughness + 1)^2 / 8, \"ibl\" for roughness^2 / 2, or k itself",
};
