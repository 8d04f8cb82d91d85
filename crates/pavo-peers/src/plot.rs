//! A picture of the errors over the costs.

use crate::measure::{ClassReport, Report, Row};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};
use std::fmt::Display;

const FONT: &str = "sans-serif";
const SIZE: (u32, u32) = (1240, 560);
const PEER: RGBColor = RGBColor(190, 60, 40);
const OWN: RGBColor = RGBColor(25, 95, 150);

/// The picture as SVG.
///
/// # Errors
/// If it cannot be drawn.
pub fn svg(report: &Report) -> Result<String, String> {
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular()).map_err(|_| "its font cannot be read")?;
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE).map_err(shown)?;
        let panels = area.split_evenly((1, report.classes.len().max(1)));
        for (class, panel) in report.classes.iter().zip(panels) {
            draw(class, &panel)?;
        }
        area.present().map_err(shown)?;
    }
    Ok(text)
}

fn draw<B: DrawingBackend>(class: &ClassReport, area: &DrawingArea<B, Shift>) -> Result<(), String> {
    let place = |row: &Row| (row.navi21.net.inverse_throughput as f64, row.errors.rms);
    // A sum over wavelengths stands far to the right of all else.
    let rows: Vec<&Row> = class.rows.iter().filter(|row| row.lavapipe.is_some()).collect();
    let places = rows.iter().map(|row| place(row));
    let (most_cost, least, most) = places
        .fold((1.0, f64::INFINITY, 0.0), |(cost, least, most): (f64, f64, f64), place| {
            (cost.max(place.0), least.min(place.1), most.max(place.1))
        });
    let mut chart = ChartBuilder::on(area)
        .caption(format!("Error over cost: {}", class.class.name()), (FONT, 18))
        .margin(14)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(0.0..most_cost * 1.2, (least / 2.0..most * 2.0).log_scale())
        .map_err(shown)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .x_desc("navi21, net inverse throughput (cycles)")
        .y_desc("RMS error against the exact reference")
        .x_label_formatter(&|value| format!("{value:.0}"))
        .y_label_formatter(&|value| format!("{value}"))
        .axis_desc_style((FONT, 14))
        .label_style((FONT, 12))
        .draw()
        .map_err(shown)?;
    for row in rows {
        let (color, name) =
            if row.is_pavo { (OWN, row.name.trim_start_matches("pavo ")) } else { (PEER, row.name.as_str()) };
        let at = place(row);
        // A peer called otherwise has the same error, so that its name stands below its point. Names of points on the
        // right half stand on their left.
        let (horizontal, vertical, shift) = if !row.is_pavo && row.peer.is_none() {
            (HPos::Center, VPos::Top, (0, 8))
        } else if at.0 > most_cost * 0.7 {
            (HPos::Right, VPos::Center, (-8, 0))
        } else {
            (HPos::Left, VPos::Center, (8, 0))
        };
        let style = TextStyle::from((FONT, 12)).color(&color).pos(Pos::new(horizontal, vertical));
        let mark =
            EmptyElement::at(at) + Circle::new((0, 0), 4, color.filled()) + Text::new(name.to_owned(), shift, style);
        chart.draw_series([mark]).map_err(shown)?;
    }
    Ok(())
}

fn shown(error: impl Display) -> String {
    format!("the plot cannot be drawn: {error}")
}
