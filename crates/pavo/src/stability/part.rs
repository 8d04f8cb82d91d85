//! The points of the cases that one surface has.

use super::StabilityError;
use super::catalogue::{Case, Catalogue};
use super::draw::{Drawer, column};
use super::finding::Check;
use crate::inputs::ShadingQuantity;
use crate::media::MediaError;
use crate::shading::Shading;
use pavo_shade::Input;

/// Where the exact reference is one: its step of wavelengths is too coarse for thicker films and closer to grazing.
const REFERENCE: (f64, f64) = (0.01, 3000.0);

/// The cases of one quantity.
pub(super) struct Part<'a> {
    pub quantity: ShadingQuantity,
    pub inputs: Vec<Input>,
    pub width: usize,
    pub cases: Vec<CasePoints<'a>>,
    /// The points of all cases, one after the other.
    pub points: Vec<f32>,
}

/// The points of a case.
pub(super) struct CasePoints<'a> {
    pub case: &'a Case,
    /// The first, among those of all cases.
    pub first: usize,
    /// The exact reflectance where it is known, by the place in the case.
    pub reference: Vec<(usize, [f64; 3])>,
}

impl<'a> Part<'a> {
    pub fn new(
        catalogue: &Catalogue,
        cases: &[&'a Case],
        shading: &Shading,
        quantity: ShadingQuantity,
        fixed: &[(String, f64)],
    ) -> Result<Self, StabilityError> {
        let inputs = shading.inputs(quantity);
        let mut part = Self {
            quantity,
            width: inputs.iter().map(Input::components).sum(),
            inputs,
            cases: Vec::new(),
            points: Vec::new(),
        };
        for &case in cases {
            let drawer = Drawer::new(catalogue, case, &part.inputs, fixed)?;
            let points = drawer.points(0, case.points, 1);
            let reference = if case.checks.contains(&Check::Reference) {
                let places: Vec<usize> = (0..case.points).collect();
                let width = part.width;
                reference(shading, &part.inputs, &places, |place| &points[place * width..(place + 1) * width])?
            } else {
                Vec::new()
            };
            part.cases.push(CasePoints { case, first: part.points.len() / part.width, reference });
            part.points.extend(&points);
            if case.checks.contains(&Check::Reciprocity) {
                part.points.extend(exchanged(points, part.width));
            }
        }
        Ok(part)
    }
}

/// The points with light and view exchanged, which follow the normal.
fn exchanged(mut points: Vec<f32>, width: usize) -> Vec<f32> {
    for point in points.chunks_exact_mut(width) {
        let (light, view) = point[3..9].split_at_mut(3);
        light.swap_with_slice(view);
    }
    points
}

/// The exact reflectance at those of some points where it is one.
pub(super) fn reference<'p>(
    shading: &Shading,
    inputs: &[Input],
    places: &[usize],
    point: impl Fn(usize) -> &'p [f32],
) -> Result<Vec<(usize, [f64; 3])>, MediaError> {
    let (cosine, thickness) = (column(inputs, "cos_theta1"), column(inputs, "thickness_nm"));
    let is_exact = |place: &&usize| {
        let number = |column: Option<usize>| column.map(|column| f64::from(point(**place)[column]));
        number(cosine).is_none_or(|cosine| cosine >= REFERENCE.0)
            && number(thickness).is_none_or(|thickness| thickness <= REFERENCE.1)
    };
    let places: Vec<usize> = places.iter().filter(is_exact).copied().collect();
    let points: Vec<Vec<f64>> =
        places.iter().map(|&place| point(place).iter().copied().map(f64::from).collect()).collect();
    let exact = shading.reference_each(ShadingQuantity::Reflectance, &points)?;
    Ok(places.into_iter().zip(exact).collect())
}
