//! A scene in words.

use crate::scene::{Base, ColourQuantity, FilmMedium, Quantity, Scene};
use serde::Serialize;
use std::path::Path;

/// What a page says of a scene.
#[derive(Serialize)]
pub struct Description {
    /// What its file says in the comment at its top.
    pub comment: String,
    /// Its file.
    pub text: String,
    /// Its parts: a name, and what it is.
    pub parts: Vec<(&'static str, String)>,
}

impl Description {
    /// A scene with its file's text.
    pub fn new(scene: &Scene, text: String) -> Self {
        let comment: Vec<&str> = text
            .lines()
            .map_while(|line| line.strip_prefix('#'))
            .map(str::trim)
            .filter(|line| !line.is_empty())
            .collect();
        let film = match &scene.film {
            None => "none".to_owned(),
            Some(film) => format!("{}, {}", medium(&film.medium), quantity(film.thickness_nm, " nm thick")),
        };
        let mut parts = vec![
            ("Film", film),
            ("Base", base(scene)),
            ("Ambient medium", format!("index {}", quantity(scene.ambient.ior, ""))),
            ("Roughness", quantity(scene.surface.roughness, "")),
        ];
        if scene.surface.diffuse {
            let color = match scene.surface.base_color {
                Some(ColourQuantity::Fixed(color)) => format!("of the base colour {color:?}"),
                _ => "of a base colour given at run time".to_owned(),
            };
            parts.push(("Diffuse part", color));
        }
        parts.push(("Illuminant", scene.colour.illuminant.to_string()));
        parts.push(("Observer", scene.colour.observer.clone()));
        parts.push(("Colour space", scene.colour.space.clone()));
        Self { comment: comment.join(" "), text, parts }
    }
}

fn medium(medium: &FilmMedium) -> String {
    match medium {
        FilmMedium::Index(ior) => format!("index {}", quantity(*ior, "")),
        FilmMedium::Material(name) => format!("{name}, whose index depends on the wavelength"),
        FilmMedium::Table(path) => format!("the material of {}", file_name(path)),
    }
}

fn base(scene: &Scene) -> String {
    match &scene.base {
        Base::Dielectric { ior } => format!("a dielectric of index {}", quantity(*ior, "")),
        Base::Conductor { ior, kappa } => {
            format!("a conductor of index {} + i {}", quantity(*ior, ""), quantity(*kappa, ""))
        }
        Base::Metal { name } => format!("{name}, whose index depends on the wavelength"),
        Base::Table { path } => format!("the material of {}", file_name(path)),
        Base::F0 { f0, edge_tint } => {
            let of = |color: &ColourQuantity| match color {
                ColourQuantity::Fixed(color) => format!("{color:?}"),
                ColourQuantity::Input => "given at run time".to_owned(),
            };
            let edge = edge_tint.as_ref().map_or_else(String::new, |color| format!(", edge tint {}", of(color)));
            format!("by what it reflects at normal incidence under air: F0 {}{edge}", of(f0))
        }
        Base::Metalness => {
            let metalness = scene.surface.metalness.map_or_else(|| "0".to_owned(), |value| quantity(value, ""));
            format!("by base colour and metalness ({metalness}), as engines have it")
        }
    }
}

fn quantity(quantity: Quantity, unit: &str) -> String {
    match quantity {
        Quantity::Fixed(value) => format!("{value}{unit}"),
        Quantity::Range { low, high } => format!("{low} to {high}{unit}"),
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).display().to_string()
}
