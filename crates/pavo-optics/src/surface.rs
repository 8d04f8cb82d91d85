//! The whole surface: Fresnel or the film, microfacets, diffuse reflection, and a punctual light.

use crate::baked::{BakedFilm, baked};
use crate::f0::base_index;
use crate::film::{BaseKind, Film, film_reflectance};
use crate::fitted::{FittedFilm, fitted_reflectance};
use crate::fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_schlick, grey, ior_from_reflectance};
use crate::lambert::lambert;
use crate::light::punctual_light;
use crate::metalness::metalness_colors;
use crate::microfacet::{cook_torrance, smith_schlick_k_image_based, smith_schlick_k_punctual};
use crate::spectral::{SpectralNode, weighted};
use crate::table::{FilmTable, table_reflectance};
use pavo_shade::{Real, Scalar, Value, Vector, shade};

/// How the parameter k of Smith-Schlick is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VisibilityK {
    /// `(roughness + 1)^2 / 8`, for punctual lights.
    Punctual,
    /// `alpha / 2`, for light from an image.
    ImageBased,
    /// The value of [`Finish::visibility_k`].
    Given,
}

/// What reflects at the surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Specular {
    /// A film on a base of one index.
    Film(Film),
    /// A film on a base with an index for each channel.
    FilmOnChannels {
        /// What is known of the film.
        film: Film,
        /// Refractive index of the base by channel.
        base_ior: [f64; 3],
        /// Extinction coefficient of the base by channel.
        base_kappa: [f64; 3],
    },
    /// A film on a base given by its specular colour.
    FilmOnMetalness(Film),
    /// A film on a base given by its reflectance at normal incidence under air: a conductor by its edge tint, or a
    /// dielectric.
    FilmOnF0(Film),
    /// A uniform film on its base, as a polynomial over the angle.
    Baked(BakedFilm),
    /// A film of fixed indices, by a form fitted to its reflectance.
    Fitted(FittedFilm),
    /// A film of fixed indices, as a table over angle and thickness.
    Table(FilmTable),
    /// No film: a base of one index.
    Bare(BaseKind),
    /// No film: a conductor whose index depends on the wavelength.
    BareSpectral(Vec<SpectralNode>),
    /// No film: from the specular colour.
    BareMetalness {
        /// Whether by the Fresnel equations of the dielectric that has this colour at normal incidence, instead of
        /// Schlick's approximation.
        exact: bool,
    },
    /// No film: a base given by its reflectance at normal incidence under air.
    BareF0 {
        /// A conductor by its edge tint, or a dielectric.
        base: BaseKind,
        /// Whether by the Fresnel equations, instead of Schlick's approximation, which is for air and knows no edge
        /// tint.
        exact: bool,
    },
}

impl Specular {
    fn is_metalness(&self) -> bool {
        matches!(self, Specular::FilmOnMetalness(_) | Specular::BareMetalness { .. })
    }
}

/// What is known of the surface when the code is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What reflects.
    pub specular: Specular,
    /// Whether there is diffuse reflection.
    pub diffuse: bool,
    /// The parameter k.
    pub visibility_k: VisibilityK,
}

/// The film and the media on both sides. What a surface does not have is ignored.
#[shade(flat)]
pub struct Layers<S: Scalar> {
    /// Thickness of the film, nm, >= 0.
    pub thickness_nm: S,
    /// Refractive index of the ambient medium, > 0.
    pub ambient_ior: S,
    /// Refractive index of the film, > 0.
    pub film_ior: S,
    /// Refractive index of the base, > 0.
    pub base_ior: S,
    /// Extinction coefficient of the base, >= 0.
    pub base_kappa: S,
    /// Reflectance of the base at normal incidence under air, linear, [0, 1].
    pub f0: S::Vec3,
    /// Edge tint of the base, [0, 1].
    pub edge_tint: S::Vec3,
}

/// Roughness and colours.
#[shade(flat)]
pub struct Finish<S: Scalar> {
    /// Roughness, the root of the GGX width alpha, (0, 1].
    pub roughness: S,
    /// Base colour, linear, [0, 1].
    pub base_color: S::Vec3,
    /// Metalness, [0, 1].
    pub metalness: S,
    /// The parameter k of Smith-Schlick, (0, 1].
    pub visibility_k: S,
}

/// Cosines between the directions at the surface.
#[shade(flat)]
pub struct Geometry<S: Scalar> {
    /// Cosine of the angle between normal and light, [0, 1].
    pub n_dot_l: S,
    /// Cosine of the angle between normal and view, [0, 1].
    pub n_dot_v: S,
    /// Cosine of the angle between normal and half vector, [0, 1].
    pub n_dot_h: S,
    /// Cosine of the angle between half vector and light, [0, 1].
    pub cos_theta1: S,
}

/// A punctual light.
#[shade(flat)]
pub struct Light<S: Scalar> {
    /// Colour of the light, linear, [0, 1].
    pub light_color: S::Vec3,
    /// Intensity of the light, >= 0.
    pub light_intensity: S,
}

/// Directions at the surface, each of length 1.
#[shade(flat)]
pub struct Directions<S: Scalar> {
    /// Surface normal, length 1.
    pub normal: S::Vec3,
    /// Direction to the light, length 1.
    pub light_direction: S::Vec3,
    /// Direction to the view, length 1.
    pub view_direction: S::Vec3,
}

/// Specular reflectance of the surface in unpolarised light as a linear colour: the share of light that is mirrored at
/// this angle.
#[shade]
pub fn surface_reflectance<S: Scalar>(
    /// What is known of the surface.
    #[constant]
    surface: &Surface,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
    /// The film and its media.
    layers: Layers<S>,
    /// Base colour, linear, [0, 1].
    base_color: S::Vec3,
    /// Metalness, [0, 1].
    metalness: S,
) -> S::Vec3 {
    let Layers { thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, f0, edge_tint } = layers;
    match &surface.specular {
        Specular::Film(film) => {
            film_reflectance::<S, S>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa)
        }
        Specular::FilmOnChannels { film, base_ior, base_kappa } => {
            let (base_ior, base_kappa) = (S::Vec3::lit3(*base_ior), S::Vec3::lit3(*base_kappa));
            film_reflectance::<S, S::Vec3>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa)
        }
        Specular::FilmOnMetalness(film) => {
            let specular_color = metalness_colors::<S>(base_color, metalness).specular_color;
            let base_ior = ior_from_reflectance(specular_color, S::Vec3::splat(ambient_ior));
            let none = S::Vec3::lit(0.0);
            film_reflectance::<S, S::Vec3>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, none)
        }
        Specular::FilmOnF0(film) => {
            let base = base_index::<S>(film.base, f0, edge_tint);
            film_reflectance::<S, S::Vec3>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base.ior, base.kappa)
        }
        Specular::Baked(film) => baked::<S>(film, cos_theta1),
        Specular::Fitted(film) => fitted_reflectance::<S>(film, cos_theta1, thickness_nm),
        Specular::Table(table) => table_reflectance::<S>(table, cos_theta1, thickness_nm),
        Specular::Bare(BaseKind::Dielectric { .. }) => grey::<S>(fresnel_dielectric(cos_theta1, ambient_ior, base_ior)),
        Specular::Bare(BaseKind::Conductor) => {
            grey::<S>(fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa))
        }
        Specular::BareSpectral(nodes) => weighted(nodes, |node| {
            let (base_ior, base_kappa) = node.base.unwrap_or((1.0_f64, 0.0_f64));
            grey::<S>(bare_node_reflectance(cos_theta1, ambient_ior, S::lit(base_ior), S::lit(base_kappa)))
        }),
        Specular::BareMetalness { exact } => {
            let specular_color = metalness_colors::<S>(base_color, metalness).specular_color;
            if !exact {
                return fresnel_schlick::<S>(cos_theta1, specular_color);
            }
            let (cosine, ambient_ior) = (S::Vec3::splat(cos_theta1), S::Vec3::splat(ambient_ior));
            fresnel_dielectric(cosine, ambient_ior, ior_from_reflectance(specular_color, ambient_ior))
        }
        Specular::BareF0 { exact: false, .. } => fresnel_schlick::<S>(cos_theta1, f0),
        Specular::BareF0 { base, exact: true } => {
            let index = base_index::<S>(*base, f0, edge_tint);
            let (cosine, ambient_ior) = (S::Vec3::splat(cos_theta1), S::Vec3::splat(ambient_ior));
            match base {
                BaseKind::Conductor => fresnel_conductor(cosine, ambient_ior, index.ior, index.kappa),
                BaseKind::Dielectric { .. } => fresnel_dielectric(cosine, ambient_ior, index.ior),
            }
        }
    }
}

/// Reflectance of a bare conductor at one wavelength, with the index that it has there.
#[shade]
pub fn bare_node_reflectance<R: Real>(
    /// Cosine of the angle of incidence, [0, 1].
    cos_theta1: R,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: R,
    /// Refractive index of the base at this wavelength, > 0.
    #[runtime]
    base_ior: R,
    /// Extinction coefficient of the base at this wavelength, >= 0.
    #[runtime]
    base_kappa: R,
) -> R {
    fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa)
}

/// BRDF of the surface, 1/sr: microfacets that mirror as the surface does, over a diffuse part of what they let
/// through.
#[shade]
pub fn surface_brdf<S: Scalar>(
    /// What is known of the surface.
    #[constant]
    surface: &Surface,
    /// Cosines between the directions.
    geometry: Geometry<S>,
    /// The film and its media.
    layers: Layers<S>,
    /// Roughness and colours.
    finish: Finish<S>,
) -> S::Vec3 {
    let reflectance =
        surface_reflectance::<S>(surface, geometry.cos_theta1, layers, finish.base_color, finish.metalness);
    brdf_of_reflectance(surface, reflectance, geometry, finish)
}

/// BRDF of a surface that mirrors this much, 1/sr: `diffuse (1 - F) + specular`.
///
/// Source: Lenzi 2020, the energy split with F at the half vector.
pub fn brdf_of_reflectance<S: Scalar>(
    surface: &Surface,
    reflectance: S::Vec3,
    geometry: Geometry<S>,
    finish: Finish<S>,
) -> S::Vec3 {
    let Finish { roughness, base_color, metalness, visibility_k } = finish;
    let k = match surface.visibility_k {
        VisibilityK::Punctual => smith_schlick_k_punctual(roughness),
        VisibilityK::ImageBased => smith_schlick_k_image_based(roughness),
        VisibilityK::Given => visibility_k,
    };
    let alpha = (roughness * roughness).named("alpha");
    let Geometry { n_dot_l, n_dot_v, n_dot_h, .. } = geometry;
    let specular = reflectance * cook_torrance(n_dot_l, n_dot_v, n_dot_h, alpha, k);
    if !surface.diffuse {
        return specular;
    }
    let is_metalness = surface.specular.is_metalness();
    let diffuse_color =
        if is_metalness { metalness_colors::<S>(base_color, metalness).diffuse_color } else { base_color };
    let diffuse_brdf = lambert::<S>(diffuse_color).named("diffuse_brdf");
    diffuse_brdf * (S::Vec3::lit(1.0) - reflectance) + specular.named("specular")
}

/// Radiance that a punctual light leaves towards the view.
///
/// Source: the reflection equation for one direction, `L_o(v) = pi f(l, v) c_light (n.l)`.
#[shade]
pub fn surface_radiance<S: Scalar>(
    /// What is known of the surface.
    #[constant]
    surface: &Surface,
    /// Cosines between the directions.
    geometry: Geometry<S>,
    /// The film and its media.
    layers: Layers<S>,
    /// Roughness and colours.
    finish: Finish<S>,
    /// The light.
    light: Light<S>,
) -> S::Vec3 {
    let brdf = surface_brdf::<S>(surface, geometry, layers, finish);
    punctual_light::<S>(brdf, geometry.n_dot_l, light.light_color, light.light_intensity)
}

/// Radiance that a punctual light leaves towards the view, from directions. Light or view below the horizon give none.
///
/// Source: the reflection equation for one direction, with the half vector between light and view.
#[shade]
pub fn shade_surface<S: Scalar>(
    /// What is known of the surface.
    #[constant]
    surface: &Surface,
    /// Directions at the surface.
    directions: Directions<S>,
    /// The film and its media.
    layers: Layers<S>,
    /// Roughness and colours.
    finish: Finish<S>,
    /// The light.
    light: Light<S>,
) -> S::Vec3 {
    let Directions { normal, light_direction, view_direction } = directions;
    let half_vector = (light_direction + view_direction).normalize();
    let n_dot_l = normal.dot(light_direction).clamp(0.0, 1.0);
    let n_dot_v = normal.dot(view_direction).clamp(0.0, 1.0);
    let n_dot_h = normal.dot(half_vector).clamp(0.0, 1.0);
    let cos_theta1 = half_vector.dot(light_direction).clamp(0.0, 1.0);
    let geometry = Geometry { n_dot_l, n_dot_v, n_dot_h, cos_theta1 };
    let radiance = surface_radiance::<S>(surface, geometry, layers, finish, light);
    // Light exactly opposite the view has no half vector; it is below the horizon of one of the two.
    let hidden = n_dot_v.min(n_dot_l).less_than(1e-6);
    S::Vec3::choose(hidden, S::Vec3::lit(0.0), radiance)
}
