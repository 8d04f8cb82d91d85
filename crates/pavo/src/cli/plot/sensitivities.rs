//! The sensitivities over wavelength, over wave number and as Fourier transforms, with the Gaussian fits.
//!
//! The four panels are those of Belcour and Barla 2017, figure 5.

use super::{FONT, Format, Picture, shown, tick};
use crate::cli::arguments;
use crate::cli::failure::Failure;
use crate::cli::output;
use crate::cli::spectrum;
use pavo_spectra::fits::{FitFamily, FitTerm, SensitivityFit, SpectralTransform, built_in};
use pavo_spectra::gaussian::belcour_barla;
use pavo_spectra::{Illuminant, Sensitivities};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::f64::consts::PI;

/// The colours of the three channels.
const COLOURS: [RGBColor; 3] = [RGBColor(200, 40, 40), RGBColor(30, 140, 60), RGBColor(40, 70, 200)];
/// Steps of a curve.
const STEPS: usize = 400;
/// The wave numbers that are drawn, 1/um.
const WAVE_NUMBERS: [f64; 2] = [1.25, 2.75];
/// The largest optical path difference that is drawn, um.
const MAX_OPD_UM: f64 = 6.0;
/// The optical path difference of the film in the last panel, um: index 1.33, 350 nm thick, at normal incidence.
const FILM_OPD_UM: f64 = 2.0 * 1.33 * 0.35;
/// By how much each further order of that film is weaker: the product of its two inner reflection coefficients.
const FILM_B: f64 = 0.7;

/// Draws the four panels.
pub fn run(arguments: &arguments::PlotSensitivities) -> Result<(), Failure> {
    let format = Format::of(&arguments.output)?;
    let sensitivities = spectrum::sensitivities(&arguments.spectrum)?;
    let fit = gaussian_fit(&sensitivities);
    if fit.is_none() {
        output::warn("there is no Gaussian fit for this observer and illuminant: the curves are drawn without one");
    }
    let transform = SpectralTransform::new(&sensitivities);
    format.write(&Panels { sensitivities, transform, fit }, &arguments.output)
}

/// The published fit where it holds, otherwise the built-in one of two Gaussians for each of X, Y and Z.
fn gaussian_fit(sensitivities: &Sensitivities) -> Option<SensitivityFit> {
    if *sensitivities.illuminant() != Illuminant::E {
        return built_in(FitFamily::XyzGaussians, 2, sensitivities, MAX_OPD_UM);
    }
    let gaussians = belcour_barla(sensitivities.observer(), sensitivities.space()).ok()?;
    let term = |gaussian: pavo_spectra::Gaussian| FitTerm {
        wave_number: [gaussian.angular_wave_number * 1e3 / (2.0 * PI); 3],
        decay: [gaussian.decay * 1e6; 3],
        weight_re: gaussian.weight,
        weight_im: [0.0; 3],
    };
    Some(SensitivityFit {
        family: FitFamily::XyzGaussians,
        terms: gaussians.into_iter().map(term).collect(),
        window_um: None,
        max_opd_um: MAX_OPD_UM,
        max_error: 0.0,
        rms_error: 0.0,
    })
}

/// The density over the wave number (1/um) whose transform the fit is.
fn fitted_density(fit: &SensitivityFit, wave_number: f64) -> [f64; 3] {
    std::array::from_fn(|channel| {
        let density = |term: &FitTerm| {
            let decay = term.decay[channel];
            let offset = wave_number - term.wave_number[channel];
            term.weight_re[channel] * (PI / decay).sqrt() * (-(PI * offset).powi(2) / decay).exp()
        };
        fit.terms.iter().filter(|term| term.decay[channel] > 0.0).map(density).sum()
    })
}

/// Three curves over one axis.
type Curves = Vec<(f64, [f64; 3])>;

fn curves([low, high]: [f64; 2], value: impl Fn(f64) -> [f64; 3]) -> Curves {
    let at = |step: usize| low + (high - low) * step as f64 / STEPS as f64;
    (0..=STEPS).map(|step| (at(step), value(at(step)))).collect()
}

struct Panels {
    sensitivities: Sensitivities,
    transform: SpectralTransform,
    fit: Option<SensitivityFit>,
}

/// What one panel shows.
struct Panel<'a> {
    title: String,
    x: &'a str,
    y: &'a str,
    exact: Curves,
    fitted: Option<Curves>,
    /// Orders of the film: place and height.
    spikes: Vec<(f64, f64)>,
    channels: &'a [usize],
}

impl Picture for Panels {
    const SIZE: (u32, u32) = (1200, 900);

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), String> {
        let sensitivities = &self.sensitivities;
        let names = sensitivities.space().channels();
        let title = format!(
            "Sensitivities {} of {} under {}",
            names.join(", "),
            sensitivities.observer().name(),
            sensitivities.illuminant().name()
        );
        let area = area.titled(&title, (FONT, 24)).map_err(shown)?;
        // Densities are scaled to an area of 1 over the wavelength in um, and over the wave number in 1/um.
        let areas = curves([0.36, 0.83], |wavelength_um| sensitivities.at(1e3 * wavelength_um));
        let step = (0.83 - 0.36) / STEPS as f64;
        let areas: [f64; 3] =
            std::array::from_fn(|channel| step * areas.iter().map(|(_, value)| value[channel]).sum::<f64>());
        let density = |wavelength_nm: f64| {
            let value = sensitivities.at(wavelength_nm);
            std::array::from_fn::<f64, 3, _>(|channel| value[channel] / areas[channel])
        };
        let (opds, wave_number_unit) = ([0.0, MAX_OPD_UM], "µm⁻¹");
        let transforms = curves(opds, |opd| self.transform.at(opd).map(|value| value.norm()));
        let orders = 1..=(MAX_OPD_UM / FILM_OPD_UM) as i32;
        let wave_number_axis = format!("wave number 1/λ ({wave_number_unit})");
        let panels = [
            Panel {
                title: "(a) over the wavelength".to_owned(),
                x: "wavelength λ (nm)",
                y: "density (1/µm)",
                exact: curves([360.0, 780.0], density),
                fitted: None,
                spikes: Vec::new(),
                channels: &[0, 1, 2],
            },
            Panel {
                title: "(b) over the wave number".to_owned(),
                x: &wave_number_axis,
                y: "density (µm)",
                exact: curves(WAVE_NUMBERS, |number| density(1e3 / number).map(|value| value / (number * number))),
                fitted: self.fit.as_ref().map(|fit| curves(WAVE_NUMBERS, |number| fitted_density(fit, number))),
                spikes: Vec::new(),
                channels: &[0, 1, 2],
            },
            Panel {
                title: "(c) moduli of the Fourier transforms".to_owned(),
                x: "optical path difference D (µm)",
                y: "|Ŝ(D)|",
                exact: transforms.clone(),
                fitted: self
                    .fit
                    .as_ref()
                    .map(|fit| curves(opds, |opd| fit.transform_at(opd).map(|value| value.norm()))),
                spikes: Vec::new(),
                channels: &[0, 1, 2],
            },
            Panel {
                title: format!("(d) the orders of a film, D = {FILM_OPD_UM:.2} µm, |b| = {FILM_B}"),
                x: "optical path difference m D (µm)",
                y: "|Ŝ(m D)|, |b|^m",
                exact: transforms,
                fitted: None,
                spikes: orders.map(|order| (f64::from(order) * FILM_OPD_UM, FILM_B.powi(order))).collect(),
                channels: &[2],
            },
        ];
        for (panel, area) in panels.iter().zip(area.split_evenly((2, 2))) {
            panel.draw(&area, names)?;
        }
        Ok(())
    }
}

impl Panel<'_> {
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>, names: [&str; 3]) -> Result<(), String> {
        let all = self.exact.iter().chain(self.fitted.iter().flatten());
        let values = || all.clone().flat_map(|(_, value)| value.iter().copied()).filter(|value| value.is_finite());
        let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
        let ends = [self.exact.first(), self.exact.last()].map(|end| end.map_or(0.0, |end| end.0));
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, (FONT, 18))
            .margin(14)
            .x_label_area_size(44)
            .y_label_area_size(60)
            .build_cartesian_2d(ends[0]..ends[1], low * 1.05..high * 1.05)
            .map_err(shown)?;
        chart
            .configure_mesh()
            .x_desc(self.x)
            .y_desc(self.y)
            .axis_desc_style((FONT, 15))
            .label_style((FONT, 13))
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .light_line_style(TRANSPARENT)
            .draw()
            .map_err(shown)?;
        for &channel in self.channels {
            let colour = COLOURS[channel];
            let points = |curves: &Curves| curves.iter().map(|(x, y)| (*x, y[channel])).collect::<Vec<_>>();
            chart
                .draw_series(LineSeries::new(points(&self.exact), colour.stroke_width(2)))
                .map_err(shown)?
                .label(names[channel])
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], colour.stroke_width(2)));
            if let Some(fitted) = &self.fitted {
                let dashes = DashedLineSeries::new(points(fitted), 6, 4, BLACK.stroke_width(1));
                let drawn = chart.draw_series(dashes).map_err(shown)?;
                if Some(&channel) == self.channels.last() {
                    drawn.label("Gaussian fit").legend(|(x, y)| {
                        let dash = |start: i32| PathElement::new([(x + start, y), (x + start + 6, y)], BLACK);
                        EmptyElement::at((0, 0)) + dash(0) + dash(9) + dash(18)
                    });
                }
            }
        }
        if !self.spikes.is_empty() {
            let spike = |&(x, y): &(f64, f64)| PathElement::new([(x, 0.0), (x, y)], BLACK.stroke_width(3));
            chart
                .draw_series(self.spikes.iter().map(spike))
                .map_err(shown)?
                .label("orders of the film")
                .legend(|(x, y)| PathElement::new([(x, y), (x + 24, y)], BLACK.stroke_width(3)));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .legend_area_size(34)
            .label_font((FONT, 14))
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .draw()
            .map_err(shown)
    }
}
