//! A scene and a variant together: a surface that can be evaluated, and recorded as a graph.

use crate::fitting::{FitCache, NoCache};
use crate::fixed_film;
use crate::inputs::{GraphReader, InputList, InputReader, PointReader, Rated, ShadingQuantity};
use crate::media::{self, MediaError};
use crate::methods::{FIRST_WAVELENGTH_NM, LAST_WAVELENGTH_NM, MethodError, MethodRequest};
use crate::scene::{self, Base, ColourQuantity, FilmMedium, Quantity, Scene, VisibilityK};
use crate::variant::{FresnelForm, Variant};
use pavo_optics::surface::{brdf_of_reflectance, shade_surface, surface_brdf, surface_radiance, surface_reflectance};
use pavo_optics::{
    BaseKind, Directions, Film, Finish, Geometry, Layers, Light, Method, Precision, Specular, Surface,
    light::punctual_light,
};
use pavo_shade::{
    Dual, Graph, Input, LeftOut, Program, Rate, Scalar, Split, Stages, Vector, specialise, split, stages,
};
use pavo_spectra::edge_tint::index_of_f0;
use pavo_spectra::parallel::map_each;
use pavo_spectra::{OpticalConstants, Point, Reference, Sensitivities, Stack};
use thiserror::Error;

/// Why a scene and a variant do not go together.
#[derive(Debug, Error)]
#[cfg_attr(feature = "points", derive(miette::Diagnostic))]
pub enum ShadingError {
    /// The data behind the scene's names cannot be had.
    #[error(transparent)]
    #[cfg_attr(feature = "points", diagnostic(transparent))]
    Media(#[from] MediaError),
    /// The variant cannot be made for this scene.
    #[error("the variant {variant} cannot be made for the scene {scene}: {cause}")]
    #[cfg_attr(feature = "points", diagnostic(code(pavo::variant), help("{help}")))]
    Variant {
        /// The variant.
        variant: String,
        /// The scene.
        scene: String,
        /// What is in the way.
        cause: String,
        /// What would be right.
        help: String,
    },
}

impl ShadingError {
    /// What would be right, where the message does not say.
    pub fn help_text(&self) -> Option<&str> {
        match self {
            Self::Media(error) => error.help_text(),
            Self::Variant { help, .. } => Some(help),
        }
    }

    /// A variant that cannot be made for a scene.
    pub(crate) fn variant(scene: &Scene, variant: &Variant, cause: String, help: String) -> Self {
        Self::Variant { variant: variant.to_string(), scene: scene.name.clone(), cause, help }
    }
}

/// A surface with a method: evaluated on the CPU, or recorded as a graph.
#[derive(Clone, Debug)]
pub struct Shading {
    scene: Scene,
    variant: Variant,
    surface: Surface,
    sensitivities: Sensitivities,
    dispersive_base: Option<OpticalConstants>,
    dispersive_film: Option<OpticalConstants>,
}

impl Shading {
    /// The surface of a scene by the method of a variant.
    ///
    /// # Errors
    /// If a file of the scene cannot be read, or the variant cannot be made for the scene.
    pub fn new(scene: &Scene, variant: &Variant) -> Result<Self, ShadingError> {
        Self::with_cache(scene, variant, &NoCache)
    }

    /// The same, with a place that keeps the fits that are not built in: some take seconds to make.
    ///
    /// # Errors
    /// As [`Shading::new`].
    pub fn with_cache(scene: &Scene, variant: &Variant, cache: &dyn FitCache) -> Result<Self, ShadingError> {
        let sensitivities = media::sensitivities(&scene.colour)?;
        let dispersive_base = media::dispersive_base(scene)?;
        let dispersive_film = media::dispersive_film(scene)?;
        let request = MethodRequest {
            variant,
            sensitivities: &sensitivities,
            base: dispersive_base.as_ref(),
            // Over a base that is known by its colour alone, the film's index in green light stands for it.
            film: dispersive_film.as_ref().filter(|_| !matches!(scene.base, Base::Metalness | Base::F0 { .. })),
            max_opd_nm: scene
                .film
                .as_ref()
                .map_or(0.0, |film| 2.0 * film_index(film, dispersive_film.as_ref()).high() * film.thickness_nm.high()),
            cache,
        };
        let specular =
            specular(scene, &request).map_err(|(cause, help)| ShadingError::variant(scene, variant, cause, help))?;
        let surface = Surface {
            specular,
            diffuse: scene.surface.diffuse,
            visibility_k: match scene.surface.visibility_k {
                VisibilityK::Punctual => pavo_optics::VisibilityK::Punctual,
                VisibilityK::ImageBased => pavo_optics::VisibilityK::ImageBased,
                VisibilityK::Value(_) => pavo_optics::VisibilityK::Given,
            },
        };
        let mut shading =
            Self { scene: scene.clone(), variant: *variant, surface, sensitivities, dispersive_base, dispersive_film };
        if let Some(specular) = fixed_film::specular(&shading, cache)? {
            shading.surface.specular = specular;
        }
        if scene.emit.precision == scene::Precision::Half
            && let Some(film) = film_of(&mut shading.surface.specular)
        {
            film.precision = Precision::half(&film.method);
        }
        Ok(shading)
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The variant.
    pub fn variant(&self) -> &Variant {
        &self.variant
    }

    /// What reflects.
    pub(crate) fn specular(&self) -> &Specular {
        &self.surface.specular
    }

    /// The surface with the indices and the thickness that the scene fixes as inputs of one value each, where its
    /// method is for films of any: nothing is fitted anew.
    #[cfg(feature = "cli")]
    pub(crate) fn with_all_inputs(&self) -> Self {
        let is_general = match &self.surface.specular {
            Specular::Film(film)
            | Specular::FilmOnMetalness(film)
            | Specular::FilmOnF0(film)
            | Specular::FilmOnChannels { film, .. } => !matches!(film.method, Method::WindowedGroups { .. }),
            Specular::Bare(_)
            | Specular::BareMetalness { .. }
            | Specular::BareF0 { .. }
            | Specular::BareSpectral(_) => true,
            Specular::Baked(_) | Specular::Table(_) | Specular::Fitted(_) => false,
        };
        let mut opened = self.clone();
        if is_general {
            opened.scene.open_layers();
        }
        opened
    }

    /// The same surface at three of its wavelengths, one for each channel, where its method evaluates single ones.
    #[cfg(feature = "cli")]
    pub(crate) fn at_single_wavelengths(&self) -> Option<Self> {
        let mut shading = self.clone();
        let nodes = match &mut shading.surface.specular {
            Specular::BareSpectral(nodes) => nodes,
            specular => match &mut film_of(specular)?.method {
                Method::Spectral { nodes } => nodes,
                _ => return None,
            },
        };
        let last = nodes.len().checked_sub(1)?;
        let of_channel = |channel: usize| {
            let mut weight = [0.0; 3];
            weight[channel] = 1.0;
            pavo_optics::SpectralNode { weight, ..nodes[[0, last / 2, last][channel]] }
        };
        *nodes = (0..3).map(of_channel).collect();
        Some(shading)
    }

    /// The sensitivities of the output channels.
    pub(crate) fn sensitivities(&self) -> &Sensitivities {
        &self.sensitivities
    }

    /// The smallest and the largest thickness of the film, nm.
    pub(crate) fn thickness_nm(&self) -> Option<[f64; 2]> {
        self.scene.film.as_ref().map(|film| [film.thickness_nm.low(), film.thickness_nm.high()])
    }

    /// The same surface with these parts in half precision; methods that are no sum stay as they are.
    #[must_use]
    pub fn with_precision(&self, precision: Precision) -> Self {
        let mut shading = self.clone();
        if let Some(film) = film_of(&mut shading.surface.specular) {
            film.precision = precision;
        }
        shading
    }

    /// The parts in half precision.
    pub fn precision(&self) -> Precision {
        film_of(&mut self.surface.specular.clone()).map_or(Precision::FULL, |film| film.precision)
    }

    /// What should be said of the data: where they do not reach over the visible range.
    pub fn warnings(&self) -> Vec<String> {
        let media = self.dispersive_base.iter().chain(&self.dispersive_film);
        media.flat_map(|medium| medium.warnings_for_range(FIRST_WAVELENGTH_NM, LAST_WAVELENGTH_NM)).collect()
    }

    /// The run-time inputs of a quantity, in the order in which a point gives them.
    pub fn inputs(&self, quantity: ShadingQuantity) -> Vec<Input> {
        let mut list = self.rated(InputList::default());
        self.run::<f64>(quantity, &mut list);
        list.reader.inputs
    }

    /// The colour at one point in `f64`: a number for each component of each input.
    pub fn evaluate(&self, quantity: ShadingQuantity, point: &[f64]) -> [f64; 3] {
        self.run::<f64>(quantity, &mut PointReader { numbers: point.iter() }).to_array()
    }

    /// The colour at one point in `f64`, and its derivative by one of the numbers of the point.
    pub fn evaluate_with_derivative(
        &self,
        quantity: ShadingQuantity,
        point: &[f64],
        column: usize,
    ) -> ([f64; 3], [f64; 3]) {
        let number = |(place, value): (usize, &f64)| Dual::<1> {
            value: *value,
            derivatives: [if place == column { 1.0 } else { 0.0 }],
        };
        let point: Vec<Dual<1>> = point.iter().enumerate().map(number).collect();
        let color = self.run::<Dual<1>>(quantity, &mut PointReader { numbers: point.iter() });
        let channels = [color.x(), color.y(), color.z()];
        (channels.map(|channel| channel.value), channels.map(|channel| channel.derivatives[0]))
    }

    /// What the scene fixes of the media, by the names that inputs would have.
    #[cfg(feature = "cli")]
    pub(crate) fn fixed_media(&self) -> Vec<(&'static str, f64)> {
        let scene = &self.scene;
        let film = scene.film.as_ref().and_then(|film| match film.medium {
            FilmMedium::Index(ior) => Some(ior),
            FilmMedium::Material(_) | FilmMedium::Table(_) => None,
        });
        let (base_ior, base_kappa) = match scene.base {
            Base::Dielectric { ior } => (Some(ior), None),
            Base::Conductor { ior, kappa } => (Some(ior), Some(kappa)),
            Base::Metal { .. } | Base::Table { .. } | Base::Metalness | Base::F0 { .. } => (None, None),
        };
        let media = [
            ("ambient_ior", Some(scene.ambient.ior)),
            ("thickness_nm", scene.film.as_ref().map(|film| film.thickness_nm)),
            ("film_ior", film),
            ("base_ior", base_ior),
            ("base_kappa", base_kappa),
            ("roughness", Some(scene.surface.roughness)),
            ("metalness", scene.surface.metalness),
        ];
        media.into_iter().filter_map(|(name, quantity)| Some((name, quantity?.fixed()?))).collect()
    }

    /// The colours at many points in `f64`, on all cores.
    pub fn evaluate_each(&self, quantity: ShadingQuantity, points: &[Vec<f64>]) -> Vec<[f64; 3]> {
        map_each(points, |point| self.evaluate(quantity, point))
    }

    /// The colours at many points in `f32`, on all cores.
    pub fn evaluate_each_f32(&self, quantity: ShadingQuantity, points: &[Vec<f32>]) -> Vec<[f32; 3]> {
        let evaluate = |point: &Vec<f32>| self.run::<f32>(quantity, &mut PointReader { numbers: point.iter() });
        map_each(points, |point| evaluate(point).to_array())
    }

    /// The program that computes a quantity, for points within the ranges of its inputs: nothing guards others.
    pub fn program(&self, quantity: ShadingQuantity) -> Program {
        specialise(&self.general_program(quantity)).program
    }

    /// The guards that [`Shading::program`] does without, since the ranges of the inputs make them unnecessary.
    pub fn left_out(&self, quantity: ShadingQuantity) -> Vec<LeftOut> {
        specialise(&self.general_program(quantity)).left_out
    }

    /// The program that computes a quantity, with all guards.
    pub fn general_program(&self, quantity: ShadingQuantity) -> Program {
        let graph = Graph::new();
        let value = self.run(quantity, &mut self.rated(GraphReader { graph: &graph }));
        graph.output(quantity.name(), value.as_vec3());
        graph.program()
    }

    /// The program of a quantity in two: what is run once a material, and what is run at each pixel.
    pub fn split(&self, quantity: ShadingQuantity) -> Split {
        split(&self.program(quantity), Rate::Material)
    }

    /// The program of a quantity in three: what is run once a material, at each vertex, and at each pixel.
    pub fn stages(&self, quantity: ShadingQuantity) -> Stages {
        stages(&self.program(quantity))
    }

    fn rated<R>(&self, reader: R) -> Rated<'_, R> {
        Rated { reader, rates: &self.scene.rates }
    }

    /// The program of the fragment entry: the mirrored share of the surroundings, and the radiance of a punctual light
    /// where the scene has them.
    pub fn sphere_program(&self) -> Program {
        let graph = Graph::new();
        let mut reader = self.rated(GraphReader { graph: &graph });
        let cosine = reader.number("n_dot_v", "", [0.0, 1.0], Rate::Pixel);
        let directions = self.scene.lights.punctual.then(|| directions(&mut reader));
        let layers = self.layers(&mut reader);
        let finish = self.finish(&mut reader);
        let mirrored = surface_reflectance(&self.surface, cosine, layers, finish.base_color, finish.metalness);
        graph.output("mirrored", mirrored.as_vec3());
        if let Some(directions) = directions {
            let light = light(&mut reader);
            graph.output("radiance", shade_surface(&self.surface, directions, layers, finish, light).as_vec3());
        }
        graph.program()
    }

    /// The colours at many points by the exact spectral reference: the film's reflectance integrated over the
    /// spectrum, the rest of the surface in `f64`.
    ///
    /// # Errors
    /// If an index of a point is no index.
    pub fn reference_each(&self, quantity: ShadingQuantity, points: &[Vec<f64>]) -> Result<Vec<[f64; 3]>, MediaError> {
        let reference = Reference::new(&self.sensitivities);
        let fixed_stack = self.fixed_stack()?;
        let prepared = fixed_stack.as_ref().map(|stack| reference.prepare(stack));
        let reflectance = |point: &Vec<f64>| -> Result<[f64; 3], MediaError> {
            let mut reader = PointReader { numbers: point.iter() };
            let geometry = geometry(quantity, &mut reader);
            let layers = self.layers(&mut reader);
            let finish = self.finish_of(quantity, &mut reader);
            let at = Point::new(geometry.cos_theta1, layers.thickness_nm);
            Ok(match (&prepared, &self.scene.base) {
                (Some(prepared), _) => prepared.reflectance(at),
                (None, Base::Metalness) => {
                    let base = finish.base_color.to_array().map(|color| {
                        let specular = 0.04 + (color - 0.04) * finish.metalness;
                        (index_of_f0(specular, None).0 * layers.ambient_ior, 0.0)
                    });
                    reference.reflectance_per_channel(layers.ambient_ior, layers.film_ior, base, at)
                }
                (None, Base::F0 { edge_tint, .. }) => {
                    let tint = |channel: usize| edge_tint.is_some().then(|| layers.edge_tint[channel]);
                    let base = std::array::from_fn(|channel| index_of_f0(layers.f0[channel], tint(channel)));
                    reference.reflectance_per_channel(layers.ambient_ior, layers.film_ior, base, at)
                }
                (None, _) => reference.reflectance(&self.stack(layers)?, at),
            })
        };
        let reflectances = map_each(points, reflectance).into_iter().collect::<Result<Vec<_>, _>>()?;
        Ok(self.of_reflectance_each(quantity, points, &reflectances))
    }

    /// The colours at many points of a surface whose reflectance at each is given.
    pub(crate) fn of_reflectance_each(
        &self,
        quantity: ShadingQuantity,
        points: &[Vec<f64>],
        reflectances: &[[f64; 3]],
    ) -> Vec<[f64; 3]> {
        let pairs: Vec<(&Vec<f64>, [f64; 3])> = points.iter().zip(reflectances.iter().copied()).collect();
        map_each(&pairs, |&(point, reflectance)| {
            let mut reader = PointReader { numbers: point.iter() };
            let geometry = geometry(quantity, &mut reader);
            self.layers(&mut reader);
            let finish = self.finish_of(quantity, &mut reader);
            self.of_reflectance(quantity, reflectance.into(), geometry, finish, &mut reader).to_array()
        })
    }

    /// The media at a point.
    fn stack(&self, layers: Layers<f64>) -> Result<Stack, MediaError> {
        let data = |error: &dyn std::fmt::Display| MediaError::Data { message: error.to_string() };
        let film = match &self.dispersive_film {
            Some(film) => film.clone(),
            None => OpticalConstants::constant(layers.film_ior, 0.0).map_err(|error| data(&error))?,
        };
        let base = match &self.dispersive_base {
            Some(base) => base.clone(),
            None => OpticalConstants::constant(layers.base_ior, layers.base_kappa).map_err(|error| data(&error))?,
        };
        Stack::new(layers.ambient_ior, film, base).map_err(|error| data(&error))
    }

    /// The media, where all points have the same.
    pub(crate) fn fixed_stack(&self) -> Result<Option<Stack>, MediaError> {
        let mut list = InputList::default();
        let layers = self.layers::<f64>(&mut list);
        let varies = list.inputs.iter().any(|input| input.name != "thickness_nm");
        let has_channels = matches!(self.scene.base, Base::Metalness | Base::F0 { .. });
        if varies || has_channels { Ok(None) } else { self.stack(layers).map(Some) }
    }

    /// Evaluates a quantity on any number type.
    fn run<S: Scalar>(&self, quantity: ShadingQuantity, reader: &mut impl InputReader<S>) -> S::Vec3 {
        if quantity == ShadingQuantity::Directions {
            let directions = directions(reader);
            let layers = self.layers(reader);
            let finish = self.finish(reader);
            return shade_surface::<S>(&self.surface, directions, layers, finish, light(reader));
        }
        let geometry = geometry(quantity, reader);
        let layers = self.layers(reader);
        let finish = self.finish_of(quantity, reader);
        match quantity {
            ShadingQuantity::Reflectance => {
                let Finish { base_color, metalness, .. } = finish;
                surface_reflectance::<S>(&self.surface, geometry.cos_theta1, layers, base_color, metalness)
            }
            ShadingQuantity::Brdf => surface_brdf::<S>(&self.surface, geometry, layers, finish),
            _ => surface_radiance::<S>(&self.surface, geometry, layers, finish, light(reader)),
        }
    }

    /// The quantity of a surface that mirrors this much.
    fn of_reflectance(
        &self,
        quantity: ShadingQuantity,
        reflectance: glam::DVec3,
        geometry: Geometry<f64>,
        finish: Finish<f64>,
        reader: &mut PointReader<'_, f64>,
    ) -> glam::DVec3 {
        if quantity == ShadingQuantity::Reflectance {
            return reflectance;
        }
        let brdf = brdf_of_reflectance::<f64>(&self.surface, reflectance, geometry, finish);
        if quantity == ShadingQuantity::Brdf {
            return brdf;
        }
        let light = light::<f64>(reader);
        punctual_light::<f64>(brdf, geometry.n_dot_l, light.light_color, light.light_intensity)
    }

    fn layers<S: Scalar>(&self, reader: &mut impl InputReader<S>) -> Layers<S> {
        let scene = &self.scene;
        let (thickness, film_ior) = match &scene.film {
            Some(film) => (film.thickness_nm, film_index(film, self.dispersive_film.as_ref())),
            None => (Quantity::Fixed(0.0), Quantity::Fixed(1.0)),
        };
        let (base_ior, base_kappa) = match scene.base {
            Base::Dielectric { ior } => (ior, Quantity::Fixed(0.0)),
            Base::Conductor { ior, kappa } => (ior, kappa),
            Base::Metal { .. } | Base::Table { .. } | Base::Metalness | Base::F0 { .. } => {
                (Quantity::Fixed(1.0), Quantity::Fixed(0.0))
            }
        };
        let (f0, edge_tint) = match scene.base {
            Base::F0 { f0, edge_tint } => (Some(f0), edge_tint),
            _ => (None, None),
        };
        Layers {
            thickness_nm: number(reader, thickness, "thickness_nm", "nm", Rate::Pixel),
            ambient_ior: number(reader, scene.ambient.ior, "ambient_ior", "", Rate::Material),
            film_ior: number(reader, film_ior, "film_ior", "", Rate::Material),
            base_ior: number(reader, base_ior, "base_ior", "", Rate::Material),
            base_kappa: number(reader, base_kappa, "base_kappa", "", Rate::Material),
            f0: color(reader, f0, "f0"),
            edge_tint: color(reader, edge_tint, "edge_tint"),
        }
    }

    fn finish<S: Scalar>(&self, reader: &mut impl InputReader<S>) -> Finish<S> {
        let surface = &self.scene.surface;
        let visibility_k = match surface.visibility_k {
            VisibilityK::Value(value) => value,
            _ => Quantity::Fixed(0.0),
        };
        Finish {
            roughness: number(reader, surface.roughness, "roughness", "", Rate::Material),
            base_color: color(reader, surface.base_color, "base_color"),
            metalness: number(reader, self.metalness(), "metalness", "", Rate::Material),
            visibility_k: number(reader, visibility_k, "visibility_k", "", Rate::Material),
        }
    }

    /// Only what the quantity needs: the reflectance of a film on a given base needs no finish.
    fn finish_of<S: Scalar>(&self, quantity: ShadingQuantity, reader: &mut impl InputReader<S>) -> Finish<S> {
        if quantity != ShadingQuantity::Reflectance {
            return self.finish(reader);
        }
        let zero = S::lit(0.0);
        let (base_color, metalness) = match self.scene.base {
            Base::Metalness => {
                let base_color = color(reader, self.scene.surface.base_color, "base_color");
                (base_color, number(reader, self.metalness(), "metalness", "", Rate::Material))
            }
            _ => (S::Vec3::splat(zero), zero),
        };
        Finish { roughness: zero, base_color, metalness, visibility_k: zero }
    }

    fn metalness(&self) -> Quantity {
        self.scene.surface.metalness.unwrap_or(Quantity::Fixed(0.0))
    }
}

/// A fixed number, or an input over its range.
fn number<S: Scalar>(reader: &mut impl InputReader<S>, quantity: Quantity, name: &str, unit: &str, rate: Rate) -> S {
    match quantity {
        Quantity::Fixed(value) => S::lit(value),
        Quantity::Range { low, high } => reader.number(name, unit, [low, high], rate),
    }
}

/// A fixed colour, or an input; black where there is none.
fn color<S: Scalar>(reader: &mut impl InputReader<S>, color: Option<ColourQuantity>, name: &str) -> S::Vec3 {
    match color {
        Some(ColourQuantity::Input) => reader.vector(name, [0.0, 1.0], Rate::Material),
        Some(ColourQuantity::Fixed(color)) => S::Vec3::lit3(color),
        None => S::Vec3::splat(S::lit(0.0)),
    }
}

fn geometry<S: Scalar>(quantity: ShadingQuantity, reader: &mut impl InputReader<S>) -> Geometry<S> {
    let mut cosine = |name: &str| reader.number(name, "", [0.0, 1.0], Rate::Pixel);
    if quantity == ShadingQuantity::Reflectance {
        let zero = S::lit(0.0);
        return Geometry { n_dot_l: zero, n_dot_v: zero, n_dot_h: zero, cos_theta1: cosine("cos_theta1") };
    }
    Geometry {
        n_dot_l: cosine("n_dot_l"),
        n_dot_v: cosine("n_dot_v"),
        n_dot_h: cosine("n_dot_h"),
        cos_theta1: cosine("cos_theta1"),
    }
}

fn directions<S: Scalar>(reader: &mut impl InputReader<S>) -> Directions<S> {
    let mut direction = |name: &str| reader.vector(name, [-1.0, 1.0], Rate::Pixel);
    Directions {
        normal: direction("normal"),
        light_direction: direction("light_direction"),
        view_direction: direction("view_direction"),
    }
}

fn light<S: Scalar>(reader: &mut impl InputReader<S>) -> Light<S> {
    Light {
        light_color: reader.vector("light_color", [0.0, 1.0], Rate::Material),
        light_intensity: reader.number("light_intensity", "", [0.0, 10.0], Rate::Material),
    }
}

fn specular(scene: &Scene, request: &MethodRequest<'_>) -> Result<Specular, MethodError> {
    let kind = match scene.base {
        Base::Conductor { .. } | Base::Metal { .. } | Base::Table { .. } => BaseKind::Conductor,
        Base::Dielectric { ior } => BaseKind::Dielectric { total_reflection: ior.low() < scene.ambient.ior.high() },
        // The base's index comes from its reflectance in the ambient medium, so it is never the smaller one.
        Base::Metalness => BaseKind::Dielectric { total_reflection: false },
        Base::F0 { edge_tint: Some(_), .. } => BaseKind::Conductor,
        Base::F0 { f0, edge_tint: None } => {
            let least = f0.fixed().map_or(0.0, |f0| f0.into_iter().fold(1.0, f64::min));
            BaseKind::Dielectric { total_reflection: index_of_f0(least, None).0 < scene.ambient.ior.high() }
        }
    };
    let Some(film) = &scene.film else {
        let approximates = *request.variant == Variant::Fresnel { form: FresnelForm::Schlick };
        if approximates && !scene.has_schlick_base() {
            let cause =
                "Schlick's approximation is for a base of the metalness workflow, or of the workflow f0 in air \
                         without an edge tint"
                    .to_owned();
            return Err((cause, "take fresnel:form=exact".to_owned()));
        }
        return Ok(match (&scene.base, request.base) {
            (Base::Metalness, _) => {
                Specular::BareMetalness { exact: *request.variant == Variant::Fresnel { form: FresnelForm::Exact } }
            }
            (Base::F0 { .. }, _) => Specular::BareF0 { base: kind, exact: !approximates },
            (_, None) => Specular::Bare(kind),
            (_, Some(_)) if matches!(request.variant, Variant::Fresnel { .. }) => {
                Specular::BareSpectral(request.spectral_nodes(81)?)
            }
            (_, Some(_)) => match request.method()? {
                Method::Spectral { nodes } => Specular::BareSpectral(nodes),
                _ => Specular::BareSpectral(request.spectral_nodes(81)?),
            },
        });
    };
    let method = request.method()?;
    let is_at_wavelengths = matches!(method, Method::Spectral { .. });
    let film = Film {
        base: kind,
        total_reflection: film_index(film, request.film).low() < scene.ambient.ior.high(),
        method,
        channel_wavelengths_nm: channel_wavelengths(request.sensitivities),
        precision: Precision::FULL,
    };
    Ok(match (&scene.base, request.base) {
        (Base::Metalness, _) => Specular::FilmOnMetalness(film),
        (Base::F0 { .. }, _) => Specular::FilmOnF0(film),
        (_, Some(base)) if !is_at_wavelengths => {
            let [base_ior, base_kappa] = channel_index(request.sensitivities, base);
            Specular::FilmOnChannels { film, base_ior, base_kappa }
        }
        _ => Specular::Film(film),
    })
}

/// The film that is computed by a method.
fn film_of(specular: &mut Specular) -> Option<&mut Film> {
    match specular {
        Specular::Film(film)
        | Specular::FilmOnMetalness(film)
        | Specular::FilmOnF0(film)
        | Specular::FilmOnChannels { film, .. } => Some(film),
        _ => None,
    }
}

/// The index of a film where one number stands for the spectrum: that in green light.
fn film_index(film: &scene::Film, dispersive: Option<&OpticalConstants>) -> Quantity {
    const GREEN_NM: f64 = 555.0;
    match (&film.medium, dispersive) {
        (FilmMedium::Index(ior), _) => *ior,
        (_, Some(constants)) => Quantity::Fixed(constants.extended_at(GREEN_NM).0),
        (_, None) => Quantity::Fixed(1.0),
    }
}

/// The wavelength at the centre of each channel's sensitivity.
fn channel_wavelengths(sensitivities: &Sensitivities) -> [f64; 3] {
    let wavelengths = pavo_spectra::wavelength::fine_grid();
    std::array::from_fn(|channel| {
        let positive = sensitivities.fine_weights().iter().map(|weight| weight[channel].max(0.0));
        let (sum, moment) = positive
            .zip(wavelengths.iter())
            .fold((0.0, 0.0), |(sum, moment), (weight, wavelength)| (sum + weight, moment + weight * wavelength));
        moment / sum
    })
}

/// The index of a material as each channel sees it: its mean over the channel's sensitivity.
pub(crate) fn channel_index(sensitivities: &Sensitivities, base: &OpticalConstants) -> [[f64; 3]; 2] {
    let mut means = [[0.0; 3]; 2];
    for (wavelength, weight) in pavo_spectra::wavelength::fine_grid().iter().zip(sensitivities.fine_weights()) {
        let (n, k) = base.extended_at(*wavelength);
        for channel in 0..3 {
            means[0][channel] += n * weight[channel];
            means[1][channel] += k * weight[channel];
        }
    }
    means
}
