//! The scene as data.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use pavo_shade::Rate;

use super::vocabulary::{DEFAULT_TARGETS, DEFAULT_VARIANT};

/// A surface, the light model it is shaded under, and what is to be emitted for it.
///
/// Every field is public, so that a scene can be built without a file; [`Scene::validate`] then says whether it holds.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Scene {
    /// What the scene is called: a letter, then letters, digits, `-` and `_`. Emitted files carry this name.
    pub name: String,
    /// The observer, the illuminant and the colour space of the result.
    pub colour: Colour,
    /// The medium in front of the film.
    pub ambient: Ambient,
    /// The thin film; `None` is a bare surface.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub film: Option<Film>,
    /// What lies under the film.
    pub base: Base,
    /// The microfacet surface and its diffuse part.
    pub surface: Surface,
    /// The lights the emitted code evaluates.
    pub lights: Lights,
    /// What a variant that is chosen by itself must keep to.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Budget::is_empty"))]
    pub budget: Budget,
    /// How often inputs change, by name (one of [`RATED_INPUTS`](super::RATED_INPUTS)), where the scene says so. Else
    /// the thickness of a film is per pixel, and all other inputs of the material and of the light are per material.
    #[cfg_attr(
        feature = "serde",
        serde(skip_serializing_if = "BTreeMap::is_empty", serialize_with = "super::serialise::rates")
    )]
    pub rates: BTreeMap<String, Rate>,
    /// What is emitted, and how.
    pub emit: Emit,
}

/// What a variant that is chosen by itself must keep to: `variant = "auto"`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Budget {
    /// The largest dE2000 against the exact reference, above 0; 1 where it is not given.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub max_delta_e: Option<f64>,
}

impl Budget {
    /// Whether nothing is given.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

impl Scene {
    /// Makes inputs of one value of the thickness and the indices that are fixed, so that it can be asked how much the
    /// surface depends on them. Such a scene does not pass [`Scene::validate`].
    #[cfg(feature = "cli")]
    pub(crate) fn open_layers(&mut self) {
        let open = |quantity: &mut Quantity| {
            if let Quantity::Fixed(value) = *quantity {
                *quantity = Quantity::Range { low: value, high: value };
            }
        };
        open(&mut self.ambient.ior);
        if let Some(film) = &mut self.film {
            open(&mut film.thickness_nm);
            if let FilmMedium::Index(ior) = &mut film.medium {
                open(ior);
            }
        }
        match &mut self.base {
            Base::Dielectric { ior } => open(ior),
            Base::Conductor { ior, kappa } => [ior, kappa].into_iter().for_each(open),
            Base::Metal { .. } | Base::Table { .. } | Base::Metalness | Base::F0 { .. } => {}
        }
    }

    /// A bare surface of `base` with every default: no film, in air, roughness as an input, all default targets.
    ///
    /// With [`Base::Metalness`], metalness is an input over [0, 1] and the base colour is an input.
    pub fn new(name: impl Into<String>, base: Base) -> Self {
        let mut surface = Surface::default();
        if base == Base::Metalness {
            surface.metalness = Some(Surface::DEFAULT_METALNESS);
            surface.base_color = Some(ColourQuantity::Input);
        }
        Scene {
            name: name.into(),
            colour: Colour::default(),
            ambient: Ambient::default(),
            film: None,
            base,
            surface,
            lights: Lights::default(),
            budget: Budget::default(),
            rates: BTreeMap::new(),
            emit: Emit::default(),
        }
    }

    /// The files that the scene names: of optical constants, and of its illuminant.
    pub fn files(&self) -> Vec<&Path> {
        let film = match self.film.as_ref().map(|film| &film.medium) {
            Some(FilmMedium::Table(path)) => Some(path),
            _ => None,
        };
        let base = match &self.base {
            Base::Table { path } => Some(path),
            _ => None,
        };
        let illuminant = match &self.colour.illuminant {
            IlluminantSource::Table(path) => Some(path),
            IlluminantSource::Named(_) => None,
        };
        film.into_iter().chain(base).chain(illuminant).map(PathBuf::as_path).collect()
    }

    /// Whether Schlick's approximation is for the base: it is known by its reflectance at normal incidence in the
    /// ambient medium alone.
    pub(crate) fn has_schlick_base(&self) -> bool {
        match self.base {
            Base::Metalness => true,
            Base::F0 { edge_tint, .. } => edge_tint.is_none() && self.ambient.ior == Quantity::Fixed(1.0),
            Base::Dielectric { .. } | Base::Conductor { .. } | Base::Metal { .. } | Base::Table { .. } => false,
        }
    }

    /// Whether the functions come in two parts, one of which is run once a material: the scene says what is uniform, or
    /// asks for it by [`Emit::prepare`] or [`Emit::vertex`].
    pub fn is_prepared(&self) -> bool {
        self.emit.prepare || self.emit.vertex || !self.rates.is_empty()
    }
}

/// A scalar of the scene: fixed when the code is emitted, or an input when it runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// Known at build time: a constant of the emitted code.
    Fixed(f64),
    /// A run-time input within `low..=high`; `low < high`, both finite.
    Range {
        /// The smallest value the input takes.
        low: f64,
        /// The largest value the input takes.
        high: f64,
    },
}

impl Quantity {
    /// The value, if it is fixed.
    pub fn fixed(self) -> Option<f64> {
        match self {
            Quantity::Fixed(value) => Some(value),
            Quantity::Range { .. } => None,
        }
    }

    /// The smallest value: the fixed value itself, or the lower end of the range.
    pub fn low(self) -> f64 {
        match self {
            Quantity::Fixed(value) => value,
            Quantity::Range { low, .. } => low,
        }
    }

    /// The largest value: the fixed value itself, or the upper end of the range.
    pub fn high(self) -> f64 {
        match self {
            Quantity::Fixed(value) => value,
            Quantity::Range { high, .. } => high,
        }
    }

    /// Whether the emitted code takes this quantity as an argument.
    pub fn is_input(self) -> bool {
        matches!(self, Quantity::Range { .. })
    }

    /// The fixed value, or the middle of the range.
    pub fn midpoint(self) -> f64 {
        f64::midpoint(self.low(), self.high())
    }
}

/// A colour of the scene, linear and in the scene's own colour space ([`Colour::space`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColourQuantity {
    /// Known at build time; each component within [0, 1].
    Fixed([f64; 3]),
    /// A run-time input, each component within [0, 1].
    Input,
}

impl ColourQuantity {
    /// The colour, if it is fixed.
    pub fn fixed(self) -> Option<[f64; 3]> {
        match self {
            ColourQuantity::Fixed(colour) => Some(colour),
            ColourQuantity::Input => None,
        }
    }

    /// Whether the emitted code takes this colour as an argument.
    pub fn is_input(self) -> bool {
        self == ColourQuantity::Input
    }
}

/// How a spectrum becomes three numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Colour {
    /// The colour-matching functions; one of [`OBSERVERS`](super::OBSERVERS).
    pub observer: String,
    /// The illuminant that weighs them.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub illuminant: IlluminantSource,
    /// The space of the result; one of [`SPACES`](super::SPACES).
    pub space: String,
}

impl Default for Colour {
    /// The CIE 1931 2 degree observer under D65, in linear sRGB.
    fn default() -> Self {
        Colour {
            observer: "cie1931-2deg".to_owned(),
            illuminant: IlluminantSource::Named("D65".to_owned()),
            space: "linear-srgb".to_owned(),
        }
    }
}

/// The illuminant of a scene's colours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IlluminantSource {
    /// A standard one; one of [`ILLUMINANTS`](super::ILLUMINANTS).
    Named(String),
    /// A spectrum that is read from a file: wavelength, and power in any unit.
    Table(PathBuf),
}

impl fmt::Display for IlluminantSource {
    /// The name, or that of the file without its folder.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            IlluminantSource::Named(name) => f.write_str(name),
            IlluminantSource::Table(path) => write!(f, "{}", path.file_name().unwrap_or(path.as_os_str()).display()),
        }
    }
}

/// The medium that light arrives through; it does not absorb.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ambient {
    /// Refractive index.
    pub ior: Quantity,
}

impl Default for Ambient {
    /// Air, taken as index 1.
    fn default() -> Self {
        Ambient { ior: Quantity::Fixed(1.0) }
    }
}

/// A thin film that does not absorb.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Film {
    /// What it is made of.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub medium: FilmMedium,
    /// Thickness in nanometres, within [0, [`MAXIMUM_THICKNESS_NM`](super::MAXIMUM_THICKNESS_NM)].
    pub thickness_nm: Quantity,
}

/// What a film is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum FilmMedium {
    /// A refractive index, the same at each wavelength.
    Index(Quantity),
    /// A transparent material whose index at each wavelength is built in; one of
    /// [`FILM_MATERIALS`](super::FILM_MATERIALS).
    Material(String),
    /// A material whose index at each wavelength is read from a file; it may not absorb.
    Table(PathBuf),
}

/// What lies under the film, or is the surface itself where there is no film.
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// A transparent medium of one refractive index.
    Dielectric {
        /// Refractive index.
        ior: Quantity,
    },
    /// An absorbing medium of one complex index `ior + i kappa`.
    Conductor {
        /// Real part of the refractive index.
        ior: Quantity,
        /// Imaginary part, not negative: light is absorbed.
        kappa: Quantity,
    },
    /// A material whose index at each wavelength is built in.
    Metal {
        /// One of [`METALS`](super::METALS).
        name: String,
    },
    /// A material whose index at each wavelength is read from a file.
    Table {
        /// The CSV file, already joined to the folder of the scene file.
        path: PathBuf,
    },
    /// A medium that is known by what it reflects at normal incidence under air alone, as engines have it.
    F0 {
        /// Reflectance at normal incidence under air, in the colour space of the scene; what is above 0.9998 is taken as
        /// 0.9998.
        f0: ColourQuantity,
        /// The edge tint of Gulbrandsen 2014, which makes it a conductor by channel: 0 does not absorb, 1 has the smallest
        /// index that `f0` allows. `None` is a dielectric by channel.
        edge_tint: Option<ColourQuantity>,
    },
    /// The base colour and metalness of [`Surface`] give the reflectance at normal incidence, as engines have it.
    Metalness,
}

/// The k of the Schlick-Smith visibility G1(v) = (n.v) / ((n.v)(1 - k) + k).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VisibilityK {
    /// k = (roughness + 1)^2 / 8, for punctual lights (Karis 2013, "Real Shading in Unreal Engine 4").
    Punctual,
    /// k = roughness^2 / 2 = alpha / 2, for image-based lighting (Karis 2013).
    ImageBased,
    /// k itself, within [0, 1].
    Value(Quantity),
}

/// The microfacet surface and its diffuse part.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Surface {
    /// Perceptual roughness, within [0, 1]; the GGX width is alpha = roughness^2.
    pub roughness: Quantity,
    /// Whether the surface has a Lambert part under the specular one.
    pub diffuse: bool,
    /// The base colour; present exactly when `diffuse` is true or the base is [`Base::Metalness`].
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub base_color: Option<ColourQuantity>,
    /// 0 for a dielectric, 1 for a metal; present exactly when the base is [`Base::Metalness`].
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub metalness: Option<Quantity>,
    /// The k of the visibility term.
    pub visibility_k: VisibilityK,
}

impl Surface {
    /// Metalness where a scene of that workflow does not say: an input over [0, 1].
    pub const DEFAULT_METALNESS: Quantity = Quantity::Range { low: 0.0, high: 1.0 };
}

impl Default for Surface {
    /// Roughness as an input over [0.05, 1], no diffuse part, k for punctual lights.
    fn default() -> Self {
        Surface {
            roughness: Quantity::Range { low: 0.05, high: 1.0 },
            diffuse: false,
            base_color: None,
            metalness: None,
            visibility_k: VisibilityK::Punctual,
        }
    }
}

/// The lights the emitted code evaluates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Lights {
    /// Whether the reflected radiance under one punctual light is emitted; otherwise only the BRDF is.
    pub punctual: bool,
}

impl Default for Lights {
    /// One punctual light.
    fn default() -> Self {
        Lights { punctual: true }
    }
}

/// How precise the numbers of the emitted code are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Precision {
    /// All in 32 bits.
    Full,
    /// In 16 bits where the method stands it, as IEEE 754 binary16: the weights and the sum of what the nodes, poles,
    /// Gaussians or wavelengths add to the colour. The rest in 32 bits.
    Half,
}

/// What is emitted, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Emit {
    /// The languages, each one of [`TARGETS`](super::TARGETS), at least one and none twice.
    pub targets: Vec<String>,
    /// The method, its order and its options, as text; see [`DEFAULT_VARIANT`](super::DEFAULT_VARIANT).
    pub variant: String,
    /// What emitted functions are prefixed with: empty, or an identifier in lower case such as `soap_`.
    pub prefix: String,
    /// Whether what depends on the material alone is computed by a function of its own, once for all pixels. A scene
    /// that gives [`Scene::rates`] asks for this by them.
    pub prepare: bool,
    /// Whether what changes with the vertices, and with nothing more frequent, is computed by a function of its own and
    /// interpolated. Between the vertices that is an approximation, so that it is only done where it is asked for.
    pub vertex: bool,
    /// How precise the numbers of the emitted code are.
    pub precision: Precision,
}

impl Default for Emit {
    /// The default targets and variant, without a prefix.
    fn default() -> Self {
        Emit {
            targets: DEFAULT_TARGETS.iter().map(|&target| target.to_owned()).collect(),
            variant: DEFAULT_VARIANT.to_owned(),
            prefix: String::new(),
            prepare: false,
            vertex: false,
            precision: Precision::Full,
        }
    }
}
