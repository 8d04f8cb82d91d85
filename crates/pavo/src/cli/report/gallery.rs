//! The page over all scenes.

use super::page;
use super::survey::Survey;
use crate::cli::failure::Failure;
use minijinja::value::Serde;
use minijinja::{Value, context};

/// The page as HTML: a card for each scene, with a link to its page.
pub fn page(surveys: &[Survey<'_>]) -> Result<String, Failure> {
    let cards: Vec<Value> = surveys
        .iter()
        .map(|survey| {
            let figures = &survey.figures;
            let shown = figures.variants.iter().find(|variant| variant.is_shown);
            context! {
                name => &figures.scene.name,
                comment => &survey.description.comment,
                picture => &survey.pictures.variant,
                is_picked => figures.picked.is_some(),
                max_delta_e => figures.max_delta_e,
                shown => Serde(&figures.shown),
                figures => Serde(shown),
            }
        })
        .collect();
    let verified_points = surveys.first().map(|survey| survey.figures.verified_points);
    page::render(
        "gallery.html",
        context! { title => "Thin-film scenes", cards, verified_points, pavo => env!("CARGO_PKG_VERSION") },
    )
}
