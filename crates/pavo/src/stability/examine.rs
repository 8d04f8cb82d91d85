//! One surface: its points, and what each variant makes of them.

use super::catalogue::{Case, Catalogue};
use super::checks::{Largest, OverWhite, colouring, difference, exchange, jump, not_finite};
use super::draw::{Drawer, column};
use super::finding::{Check, Finding, SWEEP};
use super::furnace::furnace;
use super::map::ErrorMap;
use super::part::{CasePoints, Part, reference};
use super::surfaces::{Placed, Surface};
use super::{Effort, StabilityError};
use crate::inputs::ShadingQuantity;
use crate::roads::{Prepared, Road};
use crate::scene::Base;
use crate::shading::Shading;
use pavo_check::Device;
use pavo_shade::Input;
use rayon::prelude::*;

/// How many points of the sweep follow each other from one case.
const PIECE: usize = 64;
/// How many points of a case are looked at for jumps.
const JUMP_POINTS: usize = 32;

/// A surface with the points that all its variants are examined at.
pub(super) struct Examination<'a> {
    pub(super) device: &'a Device,
    effort: Effort,
    pub(super) reflectance: Part<'a>,
    radiance: Part<'a>,
    /// The points of the sweep; a variant takes as many from the start as are its share.
    pub(super) sweep: Vec<f32>,
    sweep_reference: Vec<(usize, [f64; 3])>,
    placed: &'a [Placed],
}

/// Colours by the names of the roads that they came by.
type OnDevice = (String, Vec<[f32; 3]>);

/// What was found of a variant on a surface.
pub(super) struct Examined {
    pub variant: String,
    pub findings: Vec<Finding>,
    pub map: Option<ErrorMap>,
    pub device_points: usize,
}

impl<'a> Examination<'a> {
    pub fn new(
        device: &'a Device,
        catalogue: &'a Catalogue,
        surface: &Surface<'a>,
        placed: &'a [Placed],
        effort: Effort,
    ) -> Result<Self, StabilityError> {
        let shading = surface.variants[0];
        let fixed = fixed(shading);
        let of = |quantity: ShadingQuantity, cases: &[&'a Case]| Part::new(catalogue, cases, shading, quantity, &fixed);
        let inputs = shading.inputs(ShadingQuantity::Directions);
        let knows = |name: &str| {
            let known = inputs.iter().any(|input| input.name == name) || fixed.iter().any(|(other, _)| other == name);
            known || ["cos_theta1", "n_dot_l", "n_dot_v", "azimuth"].contains(&name)
        };
        let applying: Vec<&Case> = catalogue
            .cases
            .iter()
            .filter(|case| case.applies(&shading.scene().name, surface.is_built_in, knows))
            // What the surface fixes cannot be drawn.
            .filter(|case| case.inputs.keys().all(|name| !fixed.iter().any(|(other, _)| other == name)))
            .collect();
        let (radiance, reflectance): (Vec<&Case>, Vec<&Case>) =
            applying.into_iter().partition(|case| case.is_of_radiance());
        let radiance = if shading.scene().lights.punctual { radiance } else { Vec::new() };
        let mut examination = Self {
            device,
            effort,
            reflectance: of(ShadingQuantity::Reflectance, &reflectance)?,
            radiance: of(ShadingQuantity::Directions, &radiance)?,
            sweep: Vec::new(),
            sweep_reference: Vec::new(),
            placed,
        };
        let count = surface.variants.iter().map(|shading| examination.share(shading)).max().unwrap_or(0);
        examination.draw_sweep(catalogue, &reflectance, &fixed, count)?;
        let stride = stride(count, effort.reference_points);
        let width = examination.reflectance.width;
        let places: Vec<usize> = (0..count).step_by(stride).collect();
        examination.sweep_reference = reference(shading, &examination.reflectance.inputs, &places, |place| {
            &examination.sweep[place * width..(place + 1) * width]
        })?;
        Ok(examination)
    }

    /// The points of the sweep that fall to one surface of a variant.
    pub(super) fn share(&self, shading: &Shading) -> usize {
        let surfaces = self.placed.iter().filter(|other| other.shading.variant() == shading.variant()).count();
        self.effort.sweep_points.div_ceil(surfaces.max(1))
    }

    /// Draws the sweep: the cases by turns, a few points of each, as often as each one's share says.
    fn draw_sweep(
        &mut self,
        catalogue: &Catalogue,
        cases: &[&Case],
        fixed: &[(String, f64)],
        count: usize,
    ) -> Result<(), StabilityError> {
        let Part { inputs, width, .. } = &self.reflectance;
        let mut turns = Vec::new();
        for case in cases.iter().filter(|case| case.sweep > 0) {
            let drawer = Drawer::new(catalogue, case, inputs, fixed)?;
            let first = turns.len();
            turns.push((drawer, 0, case.sweep));
            let share = turns[first].2;
            for place in 1..share {
                turns.push((Drawer::new(catalogue, case, inputs, fixed)?, place, share));
            }
        }
        if turns.is_empty() {
            return Ok(());
        }
        let mut points = vec![0.0_f32; count * width];
        points.par_chunks_mut(PIECE * width).enumerate().for_each(|(piece, points)| {
            let (drawer, place, share) = &turns[piece % turns.len()];
            drawer.fill((piece / turns.len() * share + place) * PIECE, 2, points);
        });
        self.sweep = points;
        Ok(())
    }

    /// Examines a variant.
    pub fn variant(&self, shading: &Shading) -> Result<Examined, StabilityError> {
        let mut examined =
            Examined { variant: shading.variant().to_string(), findings: Vec::new(), map: None, device_points: 0 };
        // Without all roads, the surface of a variant that runs by all of them is its first.
        let first = self.placed.iter().find(|other| other.shading.variant() == shading.variant());
        let is_first = first.is_some_and(|other| other.shading.scene().name == shading.scene().name);
        let all_roads = self.effort.all_roads || is_first;
        let white = OverWhite::of(shading.sensitivities().space());
        for part in [&self.reflectance, &self.radiance] {
            if part.cases.is_empty() || (part.quantity == ShadingQuantity::Directions && !all_roads) {
                continue;
            }
            let by_wgsl = Prepared::new(Road::Wgsl, shading, part.quantity)?;
            self.catalogue(shading, part, &by_wgsl, all_roads, white, &mut examined)?;
            if part.quantity == ShadingQuantity::Reflectance {
                self.sweep(shading, &by_wgsl, white, &mut examined)?;
                self.single_wavelengths(shading, &mut examined)?;
            }
        }
        Ok(examined)
    }

    /// The cases of one quantity.
    fn catalogue(
        &self,
        shading: &Shading,
        part: &Part<'_>,
        by_wgsl: &Prepared,
        all_roads: bool,
        white: OverWhite,
        examined: &mut Examined,
    ) -> Result<(), StabilityError> {
        let quantity = part.quantity;
        let points: Vec<Vec<f32>> = part.points.chunks_exact(part.width).map(<[f32]>::to_vec).collect();
        let double: Vec<Vec<f64>> = points.iter().map(|point| point.iter().copied().map(f64::from).collect()).collect();
        let in_f64 = shading.evaluate_each(quantity, &double);
        let mut evaluated = vec![("cpu f32".to_owned(), in_f64_of(&shading.evaluate_each_f32(quantity, &points)))];
        for (name, colors) in self.by_roads(shading, part, by_wgsl, all_roads)? {
            examined.device_points += colors.len();
            evaluated.push((name, in_f64_of(&colors)));
        }
        let with_f64: Vec<(&str, &[[f64; 3]])> = std::iter::once(("cpu f64", in_f64.as_slice()))
            .chain(evaluated.iter().map(|(name, colors)| (name.as_str(), colors.as_slice())))
            .collect();
        for CasePoints { case, first, reference } in &part.cases {
            let range = *first..first + case.points;
            let over = |figure: &dyn Fn([f64; 3]) -> f64| {
                largest_of(with_f64.iter().map(|(name, colors)| {
                    (*name, Largest::of(range.clone().map(|index| (index, figure(colors[index])))))
                }))
            };
            for &check in &case.checks {
                let (evaluator, largest, count) = match check {
                    Check::Finite => {
                        let (name, largest) = over(&not_finite);
                        (name, largest, case.points)
                    }
                    Check::Range => {
                        let (name, largest) = over(&|color| white.excess(color));
                        (name, largest, case.points)
                    }
                    // Over a base that has a colour of its own, what is left of an absent film has it too.
                    Check::Neutral if !is_grey(shading, case) => continue,
                    Check::Neutral => {
                        let (name, largest) = over(&colouring);
                        (name, largest, case.points)
                    }
                    Check::Single => {
                        let differences = with_f64[1..].iter().map(|(name, colors)| {
                            let all = range.clone().map(|index| (index, difference(colors[index], in_f64[index])));
                            (*name, Largest::of(all))
                        });
                        let (name, largest) = largest_of(differences);
                        (name, largest, case.points)
                    }
                    Check::Reference if reference.is_empty() => continue,
                    Check::Reference => {
                        let all = reference
                            .iter()
                            .map(|(place, exact)| (first + place, difference(in_f64[first + place], *exact)));
                        ("cpu f64", Largest::of(all), reference.len())
                    }
                    Check::Continuity => {
                        let highs = highs(&part.inputs);
                        let step = case.points.div_ceil(JUMP_POINTS);
                        let places: Vec<usize> = range.clone().step_by(step).collect();
                        let jumps: Vec<(usize, f64)> = places
                            .par_iter()
                            .map(|&index| (index, jump(shading, quantity, &points[index], &highs)))
                            .collect();
                        ("cpu f64", Largest::of(jumps), places.len())
                    }
                    Check::Reciprocity => {
                        let figures = with_f64.iter().map(|(name, colors)| {
                            let all = range.clone().map(|index| {
                                // The heights of light and view over the horizon: the normal is the z axis.
                                let [n_dot_l, n_dot_v] = [points[index][5], points[index][8]].map(f64::from);
                                let other = colors[index + case.points];
                                (index, exchange(colors[index], n_dot_l, other, n_dot_v))
                            });
                            (*name, Largest::of(all))
                        });
                        let (name, largest) = largest_of(figures);
                        (name, largest, case.points)
                    }
                    Check::Energy => {
                        let (largest, settings) = furnace(shading, white);
                        let worst = largest.index.map_or(Vec::new(), |index| settings[index].clone());
                        let finding =
                            self.finding(shading, &case.name, check, "cpu f64", settings.len(), largest.value);
                        examined.findings.push(Finding { quantity: "brdf", worst, ..finding });
                        continue;
                    }
                    Check::Contained => {
                        let (largest, count) = self.contained(part, by_wgsl, *first, case)?;
                        (Road::Wgsl.name(), largest, count)
                    }
                    Check::SingleP99 | Check::Wavelength => {
                        let cause = format!("catalogue.toml: {}: {check} is not for a case to ask for", case.name);
                        return Err(StabilityError::Data(cause));
                    }
                };
                let worst = largest.index.map_or(Vec::new(), |index| points[index].clone());
                let finding = self.finding(shading, &case.name, check, evaluator, count, largest.value);
                let name = if quantity == ShadingQuantity::Directions { "directions" } else { quantity.name() };
                examined.findings.push(Finding { quantity: name, worst, ..finding });
            }
        }
        Ok(())
    }

    /// The points on the device, by WGSL and where that is asked for by all roads.
    fn by_roads(
        &self,
        shading: &Shading,
        part: &Part<'_>,
        by_wgsl: &Prepared,
        all_roads: bool,
    ) -> Result<Vec<OnDevice>, StabilityError> {
        let mut done = vec![(Road::Wgsl.name().to_owned(), by_wgsl.evaluate(self.device, &part.points)?)];
        for road in Road::ALL.into_iter().filter(|road| all_roads && *road != Road::Wgsl) {
            let prepared = Prepared::new(road, shading, part.quantity)?;
            if prepared.words() == by_wgsl.words() {
                // The same words give the same colours: they run once, under both names.
                done[0].0 = format!("{}, {}", done[0].0, road.name());
            } else {
                done.push((road.name().to_owned(), prepared.evaluate(self.device, &part.points)?));
            }
        }
        Ok(done)
    }

    /// The sweep: all points on the device, and some of them on the CPU.
    fn sweep(
        &self,
        shading: &Shading,
        by_wgsl: &Prepared,
        white: OverWhite,
        examined: &mut Examined,
    ) -> Result<(), StabilityError> {
        let Part { inputs, width, quantity, .. } = &self.reflectance;
        let count = self.share(shading).min(self.sweep.len() / (*width).max(1));
        if count == 0 {
            return Ok(());
        }
        let sweep = &self.sweep[..count * width];
        let colors = by_wgsl.evaluate(self.device, sweep)?;
        examined.device_points += colors.len();
        let scan = |(mut infinite, mut outside): (Largest, Largest), (index, color): (usize, &[f32; 3])| {
            let color = color.map(f64::from);
            infinite.add(index, not_finite(color));
            outside.take(index, white.excess(color));
            (infinite, outside)
        };
        let (infinite, outside) = colors
            .par_iter()
            .enumerate()
            .fold(Default::default, scan)
            .reduce(Default::default, |(a, b), (c, d): (Largest, Largest)| (a.and(c), b.or(d)));
        let device = Road::Wgsl.name();
        let point = |index: usize| &sweep[index * width..(index + 1) * width];
        let add = |examined: &mut Examined, check, evaluator, points, largest: Largest| {
            let worst = largest.index.map_or(Vec::new(), |index| point(index).to_vec());
            let finding = self.finding(shading, SWEEP, check, evaluator, points, largest.value);
            examined.findings.push(Finding { worst, ..finding });
        };
        add(examined, Check::Finite, device, count, infinite);
        add(examined, Check::Range, device, count, outside);

        let share = self.effort.compared_points * count / self.effort.sweep_points.max(1);
        let places: Vec<usize> = (0..count).step_by(stride(count, share.max(1))).collect();
        let compared: Vec<(usize, f64)> = places
            .par_iter()
            .map(|&index| {
                let point: Vec<f64> = point(index).iter().copied().map(f64::from).collect();
                (index, difference(colors[index].map(f64::from), shading.evaluate(*quantity, &point)))
            })
            .collect();
        add(examined, Check::Single, device, compared.len(), Largest::of(compared.iter().copied()));
        let mut sorted = compared.clone();
        sorted.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        let (index, value) = sorted[(sorted.len() * 99 / 100).min(sorted.len() - 1)];
        add(examined, Check::SingleP99, device, compared.len(), Largest { value, index: Some(index) });

        let known = self.sweep_reference.iter().filter(|(place, _)| *place < count);
        let against: Vec<(usize, f64)> = known
            .map(|(place, exact)| {
                let point: Vec<f64> = point(*place).iter().copied().map(f64::from).collect();
                (*place, difference(shading.evaluate(*quantity, &point), *exact))
            })
            .collect();
        if !against.is_empty() {
            add(examined, Check::Reference, "cpu f64", against.len(), Largest::of(against));
        }
        if let (Some(cosine), Some(thickness)) = (column(inputs, "cos_theta1"), column(inputs, "thickness_nm")) {
            let mut map = ErrorMap::new(&shading.scene().name, &examined.variant);
            for (index, error) in compared {
                let point = point(index);
                map.take(f64::from(point[cosine]), f64::from(point[thickness]), error);
            }
            examined.map = Some(map);
        }
        Ok(())
    }

    pub(super) fn finding(
        &self,
        shading: &Shading,
        case: &str,
        check: Check,
        evaluator: &str,
        points: usize,
        value: f64,
    ) -> Finding {
        Finding {
            surface: shading.scene().name.clone(),
            variant: shading.variant().to_string(),
            case: case.to_owned(),
            check,
            evaluator: evaluator.to_owned(),
            quantity: "reflectance",
            points,
            value,
            worst: Vec::new(),
        }
    }
}

/// Whether a case leaves the base of a surface without a colour.
fn is_grey(shading: &Shading, case: &Case) -> bool {
    match shading.scene().base {
        Base::Dielectric { .. } | Base::Conductor { .. } => true,
        Base::Metal { .. } | Base::Table { .. } | Base::F0 { .. } => false,
        Base::Metalness => case.inputs.contains_key("base_color"),
    }
}

/// What a scene fixes of the media, by the names of inputs.
fn fixed(shading: &Shading) -> Vec<(String, f64)> {
    shading.fixed_media().into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// The end of the range of each component of each input.
fn highs(inputs: &[Input]) -> Vec<f64> {
    inputs.iter().flat_map(|input| std::iter::repeat_n(input.high, input.components())).collect()
}

/// A step that takes about so many of some points: odd, so that it meets every case.
fn stride(count: usize, wanted: usize) -> usize {
    (count / wanted.max(1)).max(1) | 1
}

pub(super) fn in_f64_of(colors: &[[f32; 3]]) -> Vec<[f64; 3]> {
    colors.iter().map(|color| color.map(f64::from)).collect()
}

/// The largest over evaluators, with the name of the one.
pub(super) fn largest_of<'n>(figures: impl Iterator<Item = (&'n str, Largest)>) -> (&'n str, Largest) {
    figures.fold(("", Largest::default()), |(name, largest), (other, figure)| {
        if largest.index.is_none() || figure.value > largest.value { (other, figure) } else { (name, largest) }
    })
}
