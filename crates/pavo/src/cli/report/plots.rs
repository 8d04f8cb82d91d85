//! The plots of a report: one for each cost that was measured.

use super::figures::VariantFigures;
use super::frontier::{FrontierPlot, PlottedVariant};
use crate::cli::failure::Failure;
use crate::cli::plot;
use crate::scene::Scene;
use pavo_check::timing::Timings;

/// A plot.
pub struct PlotFile {
    /// The name of its file.
    pub file: &'static str,
    /// What it shows.
    pub caption: String,
    /// Its text.
    pub svg: String,
}

/// A plot for each cost that was measured.
pub fn plots(
    scene: &Scene,
    budget: f64,
    is_picked: bool,
    variants: &[VariantFigures],
    timings: Option<&Timings>,
) -> Result<Vec<PlotFile>, Failure> {
    let draw = |file, title: &str, axis: &str, caption: String, cost: &dyn Fn(&VariantFigures) -> Option<f64>| {
        let plotted = |variant: &VariantFigures| {
            Some(PlottedVariant {
                name: variant.variant.clone(),
                cost: cost(variant)?,
                errors: [variant.errors.max_delta_e, variant.errors.rms],
                is_marked: variant.is_shown,
            })
        };
        let plotted: Vec<PlottedVariant> = variants.iter().filter_map(plotted).collect();
        let plot = FrontierPlot {
            axis: axis.to_owned(),
            title: format!("{}: {title}", scene.name),
            budget,
            marked: if is_picked { "picked" } else { "closest: none keeps to the budget" },
            variants: plotted,
        };
        let svg = plot::svg(&plot);
        svg.map(|svg| PlotFile { file, caption, svg })
            .map_err(|error| Failure::check(format!("the plot cannot be drawn: {error}")))
    };
    let mut plots = vec![draw(
        "frontier.svg",
        "error against operations",
        "operations of the emitted program",
        "Operations of one evaluation of the reflectance: roots, quotients, sines and the like count 4, rows of tables \
         16, all else 1."
            .to_owned(),
        &|variant| Some(variant.ops.cost),
    )?];
    if variants.iter().any(|variant| variant.navi21.is_some()) {
        plots.push(draw(
            "frontier-navi21.svg",
            "error against cycles on navi21",
            "cycles of inverse throughput on navi21",
            "Inverse throughput on a navi21 card as RADV's compiler counts it, net of an empty shader with the same \
             inputs."
                .to_owned(),
            &|variant| variant.navi21.map(|cost| cost.cost),
        )?);
    }
    if let Some(timings) = timings {
        let positive =
            |variant: &VariantFigures| variant.lavapipe.map(|time| time.ns.median).filter(|time| *time > 0.0);
        let hidden = variants.iter().filter(|variant| positive(variant).is_none()).count();
        let left_out = match hidden {
            0 => String::new(),
            _ => format!(" Left out are {hidden} that take no longer than reading and writing alone."),
        };
        plots.push(draw(
            "frontier-lavapipe.svg",
            "error against time on lavapipe",
            "time of an evaluation on lavapipe (ns)",
            format!(
                "Median over {} rounds of {} points on {}, net of reading and writing. Times differ from run to run \
                 and with what else the machine does.{left_out}",
                timings.rounds, timings.points, timings.device
            ),
            &positive,
        )?);
    }
    Ok(plots)
}
