//! Scenes made in Rust, without a file.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use pavo_shade::Rate;

use super::error::SceneError;
use super::model::{Base, ColourQuantity, Film, FilmMedium, IlluminantSource, Quantity, Scene, VisibilityK};

impl From<f64> for Quantity {
    fn from(value: f64) -> Self {
        Quantity::Fixed(value)
    }
}

impl From<RangeInclusive<f64>> for Quantity {
    /// An input within the range.
    fn from(range: RangeInclusive<f64>) -> Self {
        Quantity::Range { low: *range.start(), high: *range.end() }
    }
}

impl<Q: Into<Quantity>> From<Q> for FilmMedium {
    /// A refractive index, the same at each wavelength.
    fn from(ior: Q) -> Self {
        FilmMedium::Index(ior.into())
    }
}

impl FilmMedium {
    /// A built-in material, one of [`FILM_MATERIALS`](super::FILM_MATERIALS).
    pub fn material(name: &str) -> Self {
        FilmMedium::Material(name.to_owned())
    }

    /// A material from a CSV file; a relative path is one from the current folder.
    pub fn csv(path: impl Into<PathBuf>) -> Self {
        FilmMedium::Table(path.into())
    }
}

impl Base {
    /// A transparent medium of this refractive index.
    pub fn dielectric(ior: impl Into<Quantity>) -> Self {
        Base::Dielectric { ior: ior.into() }
    }

    /// An absorbing medium of this complex index.
    pub fn conductor(ior: impl Into<Quantity>, kappa: impl Into<Quantity>) -> Self {
        Base::Conductor { ior: ior.into(), kappa: kappa.into() }
    }

    /// A built-in absorbing material, one of [`METALS`](super::METALS).
    pub fn metal(name: &str) -> Self {
        Base::Metal { name: name.to_owned() }
    }

    /// What reflects this much at normal incidence under air, with an edge tint where it is a conductor.
    pub fn f0(f0: ColourQuantity, edge_tint: Option<ColourQuantity>) -> Self {
        Base::F0 { f0, edge_tint }
    }

    /// A material from a CSV file; a relative path is one from the current folder.
    pub fn csv(path: impl Into<PathBuf>) -> Self {
        Base::Table { path: path.into() }
    }
}

/// A scene in the making: what is not said has the defaults of a scene file. A number is fixed, a range such as
/// `0.0..=1200.0` is an input.
///
/// ```
/// use pavo::scene::{Base, Scene};
///
/// let scene = Scene::builder("bubble", Base::dielectric(1.0)).film(1.33, 0.0..=1200.0).roughness(0.2).build()?;
/// assert!(scene.film.is_some_and(|film| film.thickness_nm.is_input()));
/// # Ok::<(), pavo::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuilder {
    scene: Scene,
}

impl Scene {
    /// A scene in the making, of a bare surface of this base.
    pub fn builder(name: impl Into<String>, base: Base) -> SceneBuilder {
        SceneBuilder { scene: Scene::new(name, base) }
    }
}

impl SceneBuilder {
    fn with(mut self, change: impl FnOnce(&mut Scene)) -> Self {
        change(&mut self.scene);
        self
    }

    /// A film of this medium and thickness in nanometres.
    pub fn film(self, medium: impl Into<FilmMedium>, thickness_nm: impl Into<Quantity>) -> Self {
        let film = Film { medium: medium.into(), thickness_nm: thickness_nm.into() };
        self.with(|scene| scene.film = Some(film))
    }

    /// The refractive index in front of the film.
    pub fn ambient_ior(self, ior: impl Into<Quantity>) -> Self {
        self.with(|scene| scene.ambient.ior = ior.into())
    }

    /// The perceptual roughness, within [0, 1].
    pub fn roughness(self, roughness: impl Into<Quantity>) -> Self {
        self.with(|scene| scene.surface.roughness = roughness.into())
    }

    /// A Lambert part of this colour under the specular one.
    pub fn diffuse(self, base_color: ColourQuantity) -> Self {
        self.with(|scene| {
            scene.surface.diffuse = true;
            scene.surface.base_color = Some(base_color);
        })
    }

    /// Base colour and metalness of a base of [`Base::Metalness`].
    pub fn metalness(self, base_color: ColourQuantity, metalness: impl Into<Quantity>) -> Self {
        self.with(|scene| {
            scene.surface.base_color = Some(base_color);
            scene.surface.metalness = Some(metalness.into());
        })
    }

    /// The k of the visibility term.
    pub fn visibility_k(self, k: VisibilityK) -> Self {
        self.with(|scene| scene.surface.visibility_k = k)
    }

    /// The colours: observer, illuminant and space, by the names that a scene file takes.
    pub fn colour(self, observer: &str, illuminant: &str, space: &str) -> Self {
        self.with(|scene| {
            scene.colour.observer = observer.to_owned();
            scene.colour.illuminant = IlluminantSource::Named(illuminant.to_owned());
            scene.colour.space = space.to_owned();
        })
    }

    /// Whether the radiance under a punctual light is emitted, as it is where nothing is said.
    pub fn punctual_light(self, is_emitted: bool) -> Self {
        self.with(|scene| scene.lights.punctual = is_emitted)
    }

    /// How often an input changes.
    pub fn rate(self, input: &str, rate: Rate) -> Self {
        self.with(|scene| {
            scene.rates.insert(input.to_owned(), rate);
        })
    }

    /// What depends on the material alone is computed by a function of its own.
    pub fn prepare(self) -> Self {
        self.with(|scene| scene.emit.prepare = true)
    }

    /// What changes with the vertices is computed by a function of its own, whose results are interpolated.
    pub fn vertex(self) -> Self {
        self.with(|scene| scene.emit.vertex = true)
    }

    /// The method, its order and its options, such as `windowed:k=6`.
    pub fn variant(self, variant: &str) -> Self {
        self.with(|scene| scene.emit.variant = variant.to_owned())
    }

    /// What emitted functions are prefixed with, such as `soap_`.
    pub fn prefix(self, prefix: &str) -> Self {
        self.with(|scene| scene.emit.prefix = prefix.to_owned())
    }

    /// The scene.
    ///
    /// # Errors
    /// The first value or name that no scene can have.
    pub fn build(self) -> Result<Scene, SceneError> {
        self.scene.validate()?;
        Ok(self.scene)
    }
}
