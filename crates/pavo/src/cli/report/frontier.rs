//! The plot of error against cost: a panel for the largest dE2000 and one for the root of the mean square error.

use super::label::{FAR, Labels, NEAR, Rectangle as Pixels};
use super::page::significant;
use crate::cli::plot::{FONT, Picture, shown};
use plotters::coord::Shift;
use plotters::coord::combinators::LogCoord;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const FRONTIER: RGBColor = RGBColor(35, 120, 190);
const PICKED: RGBColor = RGBColor(217, 72, 15);
const OTHER: RGBColor = RGBColor(128, 134, 142);

/// A chart with two logarithmic axes.
type Logarithmic<'a, B> = ChartContext<'a, B, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

/// A variant in the plot.
#[derive(Clone, Debug)]
pub struct PlottedVariant {
    /// Its name.
    pub name: String,
    /// Its cost, above 0.
    pub cost: f64,
    /// Its largest dE2000 and its root of the mean square error.
    pub errors: [f64; 2],
    /// Whether it is the one to be marked.
    pub is_marked: bool,
}

/// Error against one kind of cost.
pub struct FrontierPlot {
    /// What the cost is, with its unit.
    pub axis: String,
    /// The title.
    pub title: String,
    /// The largest dE2000 that is allowed.
    pub budget: f64,
    /// What the marked variant is.
    pub marked: &'static str,
    /// The variants.
    pub variants: Vec<PlottedVariant>,
}

impl Picture for FrontierPlot {
    const SIZE: (u32, u32) = (1240, 560);

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), String> {
        let (heading, panels) = area.split_vertically(46);
        draw_heading(&heading, &self.title, self.marked)?;
        let panels = panels.split_evenly((1, 2));
        let names = ["largest dE2000 (CIEDE2000)", "RMS error of the linear channels"];
        for (index, (panel, name)) in panels.iter().zip(names).enumerate() {
            let budget = (index == 0).then_some(self.budget);
            self.panel(panel, name, |variant| variant.errors[index], budget)?;
        }
        Ok(())
    }
}

impl FrontierPlot {
    fn panel<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        name: &str,
        error: impl Fn(&PlottedVariant) -> f64,
        budget: Option<f64>,
    ) -> Result<(), String> {
        let at = |variant: &PlottedVariant| (variant.cost.max(LEAST), error(variant).max(LEAST));
        let (x, y) = (
            around(self.variants.iter().map(|variant| at(variant).0)),
            around(self.variants.iter().map(|variant| at(variant).1).chain(budget)),
        );
        let mut chart = ChartBuilder::on(area)
            .margin(10)
            .margin_right(16)
            .x_label_area_size(46)
            .y_label_area_size(72)
            .build_cartesian_2d((x.0..x.1).log_scale(), (y.0..y.1).log_scale())
            .map_err(shown)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(OTHER)
            .x_desc(&self.axis)
            .y_desc(name)
            .x_label_formatter(&|_| String::new())
            .y_label_formatter(&|_| String::new())
            .axis_desc_style((FONT, 14))
            .draw()
            .map_err(shown)?;
        let (left, top) = area.get_base_pixel();
        let pixel = |chart: &Logarithmic<'_, B>, place: (f64, f64)| {
            let (x, y) = chart.backend_coord(&place);
            (x - left, y - top)
        };
        for (value, label) in ticks(x) {
            let style = OTHER.mix(if label.is_some() { 0.35 } else { 0.12 });
            chart.draw_series([PathElement::new([(value, y.0), (value, y.1)], style)]).map_err(shown)?;
            let (x, y) = pixel(&chart, (value, y.0));
            draw_tick(area, label, (x, y + 5), Pos::new(HPos::Center, VPos::Top))?;
        }
        for (value, label) in ticks(y) {
            let style = OTHER.mix(if label.is_some() { 0.35 } else { 0.12 });
            chart.draw_series([PathElement::new([(x.0, value), (x.1, value)], style)]).map_err(shown)?;
            let (x, y) = pixel(&chart, (x.0, value));
            draw_tick(area, label, (x - 6, y), Pos::new(HPos::Right, VPos::Center))?;
        }
        if let Some(budget) = budget {
            let line = DashedLineSeries::new([(x.0, budget), (x.1, budget)], 6, 5, PICKED.stroke_width(1));
            chart.draw_series(line).map_err(shown)?;
        }
        let frontier = frontier(&self.variants, &at);
        let steps: Vec<(f64, f64)> = frontier
            .iter()
            .enumerate()
            .flat_map(|(index, &variant)| {
                let (cost, error) = at(variant);
                let before = index.checked_sub(1).map(|before| (cost, at(frontier[before]).1));
                before.into_iter().chain([(cost, error)])
            })
            .chain(frontier.last().map(|variant| (x.1, at(variant).1)))
            .collect();
        chart.draw_series(LineSeries::new(steps.iter().copied(), FRONTIER.mix(0.6).stroke_width(2))).map_err(shown)?;
        let mark = |variant: &PlottedVariant| {
            let is_frontier = frontier.iter().any(|other| std::ptr::eq(*other, variant));
            match (variant.is_marked, is_frontier) {
                (true, _) => (6, PICKED.filled()),
                (false, true) => (5, FRONTIER.filled()),
                (false, false) => (3, OTHER.stroke_width(1)),
            }
        };
        // The marked one is drawn last, and is named first.
        let mut ordered: Vec<&PlottedVariant> = self.variants.iter().collect();
        ordered.sort_by_key(|variant| mark(variant).0);
        chart
            .draw_series(ordered.iter().map(|variant| Circle::new(at(variant), mark(variant).0, mark(variant).1)))
            .map_err(shown)?;

        let pixel = |place| pixel(&chart, place);
        let corners = [pixel((x.0, y.1)), pixel((x.1, y.0))];
        let bounds = Pixels { low: (corners[0].0 + 2, corners[0].1 + 2), high: (corners[1].0 - 2, corners[1].1 - 2) };
        let points = ordered.iter().map(|variant| Pixels::around(pixel(at(variant)), mark(variant).0 + 1)).collect();
        let mut lines: Vec<Pixels> = steps.windows(2).map(|ends| between(pixel(ends[0]), pixel(ends[1]))).collect();
        lines.extend(budget.map(|budget| between(pixel((x.0, budget)), pixel((x.1, budget)))));
        let mut labels = Labels::new(bounds, points, lines);
        for variant in ordered.iter().rev() {
            let (radius, style) = mark(variant);
            let size = if radius > 3 { 12 } else { 10 };
            let style = TextStyle::from((FONT, size)).color(&style.color).pos(Pos::new(HPos::Left, VPos::Top));
            let text = short(&variant.name);
            let (width, height) = area.estimate_text_size(&text, &style).map_err(shown)?;
            let point = pixel(at(variant));
            let reach = if radius > 3 { FAR } else { NEAR };
            let Some(place) = labels.place(point, (width as i32 + 2, height as i32), reach) else { continue };
            if let Some(end) = place.lead {
                area.draw(&PathElement::new([point, end], OTHER.mix(0.6))).map_err(shown)?;
            }
            area.draw(&Text::new(text, place.label.low, style)).map_err(shown)?;
        }
        Ok(())
    }
}

/// The title, and what the marks mean.
fn draw_heading<B: DrawingBackend>(area: &DrawingArea<B, Shift>, title: &str, marked: &str) -> Result<(), String> {
    let text = |text: &str, at: (i32, i32), size: i32| {
        let style = TextStyle::from((FONT, size)).color(&BLACK);
        area.draw(&Text::new(text.to_owned(), at, style)).map_err(shown)
    };
    text(title, (16, 0), 17)?;
    let legend: [(i32, ShapeStyle, &str); 3] = [
        (6, PICKED.filled(), marked),
        (5, FRONTIER.filled(), "on the frontier of this panel: no cheaper one is closer"),
        (3, OTHER.stroke_width(1), "others; dashed, the budget"),
    ];
    let mut left = 22;
    for (radius, style, meaning) in legend {
        area.draw(&Circle::new((left, 33), radius, style)).map_err(shown)?;
        text(meaning, (left + 11, 27), 12)?;
        let (width, _) = area.estimate_text_size(meaning, &TextStyle::from((FONT, 12))).map_err(shown)?;
        left += width as i32 + 40;
    }
    Ok(())
}

/// What a logarithmic axis can show at least.
const LEAST: f64 = 1e-9;

/// The variants that are closer than all cheaper ones, the cheapest first.
fn frontier<'a>(
    variants: &'a [PlottedVariant],
    at: &impl Fn(&PlottedVariant) -> (f64, f64),
) -> Vec<&'a PlottedVariant> {
    let mut ordered: Vec<&PlottedVariant> = variants.iter().collect();
    ordered.sort_by(|a, b| at(a).partial_cmp(&at(b)).unwrap_or(std::cmp::Ordering::Equal));
    let mut least = f64::INFINITY;
    ordered.retain(|variant| {
        let is_closer = at(variant).1 < least;
        least = least.min(at(variant).1);
        is_closer
    });
    ordered
}

/// A range of a logarithmic axis around some values.
fn around(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if low <= high { (low / 1.6, high * 1.6) } else { (0.1, 10.0) }
}

/// What a line between two pixels covers, for a line along an axis.
fn between(a: (i32, i32), b: (i32, i32)) -> Pixels {
    Pixels { low: (a.0.min(b.0) - 1, a.1.min(b.1) - 1), high: (a.0.max(b.0) + 1, a.1.max(b.1) + 1) }
}

/// A variant's name without what all of its family have alike.
fn short(name: &str) -> String {
    let name = name.split(",rms=").next().unwrap_or(name);
    name.replace("form=", "").replace("fit=", "")
}

/// Values along a logarithmic axis, with what stands at some of them: at 1, 2 and 5 times the powers of ten where there
/// are few, at the powers alone where there are many.
fn ticks((low, high): (f64, f64)) -> Vec<(f64, Option<String>)> {
    let decades = (high / low).log10();
    let labelled: &[i32] = match decades {
        decades if decades < 1.0 => &[1, 2, 3, 4, 5, 6, 8],
        decades if decades < 3.5 => &[1, 2, 5],
        _ => &[1],
    };
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let values = (first..=last).flat_map(|power| (1..10).map(move |factor| (factor, power)));
    values
        .map(|(factor, power)| (f64::from(factor) * 10.0_f64.powi(power), factor, power))
        .filter(|(value, ..)| (low..=high).contains(value))
        .map(|(value, factor, power)| {
            let text = if (-3..5).contains(&power) { significant(value, 2) } else { format!("{factor}e{power}") };
            (value, labelled.contains(&factor).then_some(text))
        })
        .collect()
}

fn draw_tick<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    label: Option<String>,
    at: (i32, i32),
    position: Pos,
) -> Result<(), String> {
    let Some(label) = label else { return Ok(()) };
    let style = TextStyle::from((FONT, 12)).color(&BLACK).pos(position);
    area.draw(&Text::new(label, at, style)).map_err(shown)
}
