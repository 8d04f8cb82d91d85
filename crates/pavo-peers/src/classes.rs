//! The surfaces and the points that are measured.

use crate::failure::Failure;
use pavo::points::spread;
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_shade::{Input, Rate};
use serde::{Deserialize, Serialize};
use std::path::Path;

const MAX_THICKNESS_NM: f64 = 3000.0;
const MIN_COSINE: f64 = 0.01;
/// Points spread over the ranges of one surface, beside those along their edges.
const SPREAD_POINTS: usize = 2000;

/// A class of surfaces: a film in air over a kind of base.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// Bases that do not absorb.
    Dielectric,
    /// Bases that do.
    Conductor,
}

/// A film in air over a base.
#[derive(Clone, Copy, Debug)]
pub struct Media {
    film_ior: f64,
    base_ior: f64,
    base_kappa: f64,
}

const fn media(film_ior: f64, base_ior: f64, base_kappa: f64) -> Media {
    Media { film_ior, base_ior, base_kappa }
}

/// A soap film, oil on water, magnesium fluoride on glass, nacre, high contrast.
const DIELECTRICS: [Media; 5] = [
    media(1.33, 1.0, 0.0),
    media(1.5, 1.33, 0.0),
    media(1.38, 1.52, 0.0),
    media(1.53, 1.66, 0.0),
    media(2.5, 1.2, 0.0),
];

/// Titania on titanium, silica on silicon, 2.6 on copper, 1.77 on gold, 2.0 on silver; at 555 nm.
const CONDUCTORS: [Media; 5] = [
    media(2.4, 2.7, 3.8),
    media(1.46, 4.1, 0.04),
    media(2.6, 0.97, 2.6),
    media(1.77, 0.36, 2.69),
    media(2.0, 0.06, 3.6),
];

/// A point on one of the surfaces.
#[derive(Clone, Copy, Debug)]
pub struct At {
    media: Media,
    cos_theta1: f64,
    thickness_nm: f64,
}

/// A run-time input of a kernel.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(try_from = "String")]
pub struct PeerInput {
    quantity: Quantity,
    /// Whether it is a colour.
    pub is_colour: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    CosTheta1,
    ThicknessNm,
    FilmIor,
    BaseIor,
    BaseKappa,
    BaseF0,
}

impl Quantity {
    const ALL: [Quantity; 6] = [
        Quantity::CosTheta1,
        Quantity::ThicknessNm,
        Quantity::FilmIor,
        Quantity::BaseIor,
        Quantity::BaseKappa,
        Quantity::BaseF0,
    ];

    fn name(self) -> &'static str {
        match self {
            Quantity::CosTheta1 => "cos_theta1",
            Quantity::ThicknessNm => "thickness_nm",
            Quantity::FilmIor => "film_ior",
            Quantity::BaseIor => "base_ior",
            Quantity::BaseKappa => "base_kappa",
            Quantity::BaseF0 => "base_f0",
        }
    }
}

impl TryFrom<String> for PeerInput {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let (plain, is_colour) = name.strip_suffix("_rgb").map_or((name.as_str(), false), |plain| (plain, true));
        let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.name() == plain);
        let names = Quantity::ALL.map(Quantity::name).join(", ");
        let quantity =
            quantity.ok_or_else(|| format!("`{name}` is no input: expected one of {names}, or it in _rgb"))?;
        Ok(PeerInput { quantity, is_colour })
    }
}

impl PeerInput {
    /// The name of the variable that holds it.
    pub fn name(self) -> String {
        format!("{}{}", self.quantity.name(), if self.is_colour { "_rgb" } else { "" })
    }

    /// How many numbers it is.
    pub fn components(self) -> usize {
        if self.is_colour { 3 } else { 1 }
    }

    /// Its value at a point; all components are alike, as one index stands for the spectrum.
    fn at(self, at: &At) -> f32 {
        let Media { film_ior, base_ior, base_kappa } = at.media;
        let value = match self.quantity {
            Quantity::CosTheta1 => at.cos_theta1,
            Quantity::ThicknessNm => at.thickness_nm,
            Quantity::FilmIor => film_ior,
            Quantity::BaseIor => base_ior,
            Quantity::BaseKappa => base_kappa,
            Quantity::BaseF0 => normal_reflectance(base_ior, base_kappa),
        };
        value as f32
    }
}

/// The reflectance of a base in air at normal incidence.
fn normal_reflectance(ior: f64, kappa: f64) -> f64 {
    ((ior - 1.0).powi(2) + kappa * kappa) / ((ior + 1.0).powi(2) + kappa * kappa)
}

/// The numbers of these inputs at all points, those of a point one after the other.
pub fn numbers(points: &[At], inputs: &[PeerInput]) -> Vec<f32> {
    let of_point = |at| inputs.iter().flat_map(move |input| std::iter::repeat_n(input.at(at), input.components()));
    points.iter().flat_map(of_point).collect()
}

impl Class {
    /// All classes.
    pub const ALL: [Class; 2] = [Class::Dielectric, Class::Conductor];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Class::Dielectric => "dielectrics",
            Class::Conductor => "conductors",
        }
    }

    fn media(self) -> [Media; 5] {
        // What the kernels read are 32-bit numbers: the exact reference takes the same.
        let single = |value: f64| f64::from(value as f32);
        let round = |media: Media| Media {
            film_ior: single(media.film_ior),
            base_ior: single(media.base_ior),
            base_kappa: single(media.base_kappa),
        };
        match self {
            Class::Dielectric => DIELECTRICS.map(round),
            Class::Conductor => CONDUCTORS.map(round),
        }
    }

    /// A surface of pavo's of which everything varies at run time, by a variant.
    ///
    /// Nothing reflects totally within the ranges of the dielectrics, as the peers need it.
    ///
    /// # Errors
    /// If the variant cannot be made for it.
    pub fn shading(self, variant: &str) -> Result<Shading, Failure> {
        let base = match self {
            Class::Dielectric => "ior = [1, 3]",
            Class::Conductor => "ior = [0.05, 4.5]\nkappa = [0.01, 4]",
        };
        let film = format!("ior = [1.2, 2.6001]\nthickness_nm = [0, {MAX_THICKNESS_NM}]");
        shading(self.name(), &film, base, variant)
    }

    /// Points over the ranges of each surface and along their edges, and their exact colours.
    ///
    /// # Errors
    /// If the reference refuses a surface.
    pub fn reference(self) -> Result<(Vec<At>, Vec<[f64; 3]>), Failure> {
        let places: Vec<[f64; 2]> = spread_places(SPREAD_POINTS).into_iter().chain(edges()).map(single).collect();
        let (mut points, mut colors) = (Vec::new(), Vec::new());
        for media in self.media() {
            let Media { film_ior, base_ior, base_kappa } = media;
            let film = format!("ior = {film_ior}\nthickness_nm = [0, {MAX_THICKNESS_NM}]");
            let kappa = if self == Class::Conductor { format!("\nkappa = {base_kappa}") } else { String::new() };
            let shading = shading(self.name(), &film, &format!("ior = {base_ior}{kappa}"), "spectral:n=81")?;
            let of_scene: Vec<Vec<f64>> = places.iter().map(|place| place.to_vec()).collect();
            colors.extend(shading.reference_each(ShadingQuantity::Reflectance, &of_scene)?);
            points.extend(places.iter().map(|place| at(media, *place)));
        }
        Ok((points, colors))
    }

    /// Many points, by turns on each surface.
    pub fn many_points(self, count: usize) -> Vec<At> {
        let media = self.media();
        let places = spread_places(count).into_iter().map(single).enumerate();
        places.map(|(index, place)| at(media[index % media.len()], place)).collect()
    }
}

fn at(media: Media, [cos_theta1, thickness_nm]: [f64; 2]) -> At {
    At { media, cos_theta1, thickness_nm }
}

fn single(place: [f64; 2]) -> [f64; 2] {
    place.map(|value| f64::from(value as f32))
}

fn shading(name: &str, film: &str, base: &str, variant: &str) -> Result<Shading, Failure> {
    let text = format!("name = \"{name}\"\n[film]\n{film}\n[base]\n{base}\n");
    let scene = Scene::from_toml(name, &text, Path::new("."))?;
    Ok(Shading::new(&scene, &variant.parse::<Variant>()?)?)
}

/// Cosines and thicknesses spread over their ranges.
fn spread_places(count: usize) -> Vec<[f64; 2]> {
    let inputs = [
        Input::scalar("cos_theta1", "", MIN_COSINE, 1.0, Rate::Pixel),
        Input::scalar("thickness_nm", "nm", 0.0, MAX_THICKNESS_NM, Rate::Pixel),
    ];
    spread(&inputs, count, 7).iter().map(|point| [point[0], point[1]]).collect()
}

/// Cosines and thicknesses along the edges of their ranges.
fn edges() -> impl Iterator<Item = [f64; 2]> {
    (0..=36).flat_map(|step| {
        let fraction = f64::from(step) / 36.0;
        let (cosine, thickness) = (MIN_COSINE + (1.0 - MIN_COSINE) * fraction, MAX_THICKNESS_NM * fraction);
        [[MIN_COSINE, thickness], [1.0, thickness], [cosine, 0.0], [cosine, MAX_THICKNESS_NM]]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_reflectance_is_that_of_fresnel() {
        assert!((normal_reflectance(1.5, 0.0) - 0.04).abs() < 1e-12);
        // A mirror that absorbs much reflects nearly all.
        assert!((normal_reflectance(0.06, 3.6) - 0.983).abs() < 1e-3);
    }

    #[test]
    fn the_points_lie_within_the_ranges_that_pavo_takes() {
        for class in Class::ALL {
            let inputs =
                class.shading("spectral:n=81").expect("the class is a scene").inputs(ShadingQuantity::Reflectance);
            let of_pavo: Vec<PeerInput> =
                inputs.iter().map(|input| input.name.clone().try_into().expect("a peer has it too")).collect();
            let numbers = numbers(&class.many_points(50), &of_pavo);
            for point in numbers.chunks_exact(inputs.len()) {
                for (value, input) in point.iter().zip(&inputs) {
                    assert!((input.low..=input.high).contains(&f64::from(*value)), "{}: {value}", input.name);
                }
            }
        }
    }

    #[test]
    fn inputs_go_by_their_names() {
        let input = |name: &str| PeerInput::try_from(name.to_owned());
        let colour = input("base_f0_rgb").expect("it is one");
        assert_eq!((colour.name().as_str(), colour.components()), ("base_f0_rgb", 3));
        assert!(input("base_colour").expect_err("it is none").contains("base_kappa"));
    }
}
