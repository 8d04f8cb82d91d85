//! `pavo build`: emit, judge, run, report.

use super::arguments;
use super::check::targets;
use super::failure::Failure;
use super::manifest::{InputRow, Manifest, PreparedRow, Rates, RunRow, Runs, TargetRow, against_reference};
use super::output;
use super::precision::PrecisionSection;
use super::progress::Progress;
use super::sources::{Emitted, Source};
use crate::emission::{in_language, library_quantity};
use crate::inputs::ShadingQuantity;
use crate::numerics::{FunctionNeeds, Numerics};
use crate::points::spread;
use crate::points_table::{column_names, digits};
use crate::roads::{self, Road};
use crate::shading::Shading;
use crate::statistics::Difference;
use pavo_check::Device;
use pavo_optics::Precision;
use pavo_shade::Input;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// How many points are run on the device.
const RUN_POINTS: usize = 100_000;
/// How many points are compared with the exact reference.
const REFERENCE_POINTS: usize = 2_000;
/// How many points the test vectors hold.
const VECTOR_POINTS: usize = 64;
/// Below this cosine the film's finesse amplifies rounding: those points are run and reported by themselves.
const GRAZING_COSINE: f64 = 0.05;
/// The smallest cosine that is run.
const SMALLEST_COSINE: f64 = 1e-3;

/// Builds a scene.
pub fn run(arguments: &arguments::Build) -> Result<(), Failure> {
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    let progress = Progress::start();
    let targets = if arguments.target.is_empty() { targets(&source)? } else { arguments.target.clone() };
    let mut emitted: Vec<Emitted> = Vec::new();
    for target in targets {
        progress.step(format!("emitting and judging {target}"));
        if emitted.iter().all(|other| other.target != target) {
            emitted.push(source.emit(target, target.default_form(), ShadingQuantity::Reflectance)?);
        }
    }
    let runs = if arguments.no_run { None } else { Some(run_on_lavapipe(&source, &progress)?) };
    progress.step("comparing with the exact reference");
    let shading = &source.shading;
    let library_inputs = shading.program(library_quantity(shading.scene()));
    let manifest = Manifest {
        pavo: env!("CARGO_PKG_VERSION"),
        scene: shading.scene(),
        variant: shading.variant().to_string(),
        inputs: library_inputs.inputs().iter().map(InputRow::from).collect(),
        targets: emitted.iter().map(TargetRow::from).collect(),
        rates: Rates::of(shading),
        operations: shading.program(ShadingQuantity::Reflectance).operations(),
        left_out: shading.left_out(library_quantity(shading.scene())),
        runs,
        against_reference: against_reference(shading, REFERENCE_POINTS)?,
        numerics: Numerics::of(shading)?,
        precision: PrecisionSection::of(shading, REFERENCE_POINTS),
        warnings: shading.warnings(),
    };
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from(&shading.scene().name));
    let json = serde_json::to_string_pretty(&manifest)
        .map_err(|error| Failure::check(format!("the manifest cannot be written: {error}")))?;
    write_all(&folder, &emitted, &json, &test_vectors(&source))?;
    drop(progress);
    if arguments.json {
        return output::print(&(json + "\n"));
    }
    output::print(&report(&folder, &manifest, &emitted))
}

/// Runs the reflectance, and the BRDF or the radiance, by each road.
fn run_on_lavapipe(source: &Source, progress: &Progress) -> Result<Runs, Failure> {
    let device = Device::lavapipe()?;
    let shading = &source.shading;
    let whole = if shading.scene().lights.punctual { ShadingQuantity::Radiance } else { ShadingQuantity::Brdf };
    let mut rows = Vec::new();
    let ordinary = [GRAZING_COSINE, 1.0];
    let runs = [
        (ShadingQuantity::Reflectance, ordinary),
        (ShadingQuantity::Reflectance, [SMALLEST_COSINE, GRAZING_COSINE]),
        (whole, ordinary),
    ];
    for (quantity, cosines) in runs {
        let inputs = with_cosines(shading.inputs(quantity), cosines);
        let points: Vec<Vec<f32>> = spread(&inputs, RUN_POINTS, 2)
            .into_iter()
            .map(|point| point.into_iter().map(|value| value as f32).collect())
            .collect();
        let expected = on_cpu(shading, quantity, &points);
        for road in Road::ALL {
            progress.step(format!("running the {} on lavapipe: {}", quantity.name(), road.name()));
            let found = roads::evaluate(&device, road, &source.shading, quantity, &points)?;
            let (in_f32, in_f64) = match in_language(shading, road.language()) {
                Cow::Borrowed(_) => &expected,
                Cow::Owned(expressed) => &on_cpu(&expressed, quantity, &points),
            };
            rows.push(RunRow::new(quantity, road, &inputs, &points, &found, (in_f32, in_f64)));
        }
    }
    Ok(Runs { device: device.description().clone(), rows })
}

/// The colours at some points on the CPU, in f32 and in f64.
fn on_cpu(shading: &Shading, quantity: ShadingQuantity, points: &[Vec<f32>]) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let double: Vec<Vec<f64>> = points.iter().map(|point| point.iter().copied().map(f64::from).collect()).collect();
    let single = shading.evaluate_each_f32(quantity, points).into_iter().map(|color| color.map(f64::from));
    (single.collect(), shading.evaluate_each(quantity, &double))
}

/// The inputs with this range of the cosine at the half vector.
fn with_cosines(mut inputs: Vec<Input>, [low, high]: [f64; 2]) -> Vec<Input> {
    for input in inputs.iter_mut().filter(|input| input.name == "cos_theta1") {
        (input.low, input.high) = (low, high);
    }
    inputs
}

/// How far emitted code on a 32-bit device may be from the test vectors.
pub(super) fn vector_tolerance(source: &Source) -> f64 {
    // A number of half precision next to 1 is 1e-3 from the next, and may be rounded either way.
    if source.shading.precision() == Precision::FULL { 2e-5 } else { 4e-3 }
}

/// A point, and the colour that the variant gives there in f64.
pub(super) type Vector = (Vec<f64>, [f64; 3]);

/// The inputs of the reflectance, and points with what the variant gives there in f64.
pub(super) fn vector_points(source: &Source) -> (Vec<Input>, Vec<Vector>) {
    let quantity = ShadingQuantity::Reflectance;
    let inputs = with_cosines(source.shading.inputs(quantity), [GRAZING_COSINE, 1.0]);
    let row = |point: Vec<f64>| {
        let point: Vec<f64> = point.into_iter().map(|value| f64::from(value as f32)).collect();
        let color = source.shading.evaluate(quantity, &point);
        (point, color)
    };
    let rows = spread(&inputs, VECTOR_POINTS, 3).into_iter().map(row).collect();
    (inputs, rows)
}

/// Points with the reflectance that the variant gives in f64, as a table.
pub(super) fn test_vectors(source: &Source) -> Vec<u8> {
    let (inputs, rows) = vector_points(source);
    let columns: Vec<String> = inputs.iter().flat_map(column_names).collect();
    let mut text = format!(
        "# {} of {} by {} in f64; emitted code on a 32-bit device agrees within the tolerance.\n{},r,g,b,tolerance\n",
        ShadingQuantity::Reflectance.name(),
        source.shading.scene().name,
        source.shading.variant(),
        columns.join(",")
    );
    let tolerance = vector_tolerance(source);
    for (point, color) in rows {
        let fields: Vec<String> = point.iter().chain(&color).copied().map(digits).collect();
        text.push_str(&format!("{},{tolerance:e}\n", fields.join(",")));
    }
    text.into_bytes()
}

fn write_all(folder: &Path, emitted: &[Emitted], manifest: &str, vectors: &[u8]) -> Result<(), Failure> {
    output::make_folder(folder)?;
    for shader in emitted {
        output::write(&folder.join(&shader.file), &shader.bytes)?;
    }
    output::write(&folder.join("test-vectors.csv"), vectors)?;
    output::write(&folder.join("manifest.json"), format!("{manifest}\n").as_bytes())
}

fn report(folder: &Path, manifest: &Manifest<'_>, emitted: &[Emitted]) -> String {
    let mut text = format!("{}, {}\n\n", manifest.scene.name, manifest.variant);
    for shader in emitted {
        let judges: Vec<String> = shader.verdicts.iter().map(|verdict| verdict.judge.described()).collect();
        let path = folder.join(&shader.file);
        text.push_str(&format!(
            "  {:<10} passed by {:<28} {}\n",
            shader.target.name(),
            judges.join(", "),
            path.display()
        ));
    }
    match &manifest.runs {
        None => text.push_str("\nNOT run on lavapipe, as asked by --no-run.\n"),
        Some(runs) => {
            text.push_str(&format!(
                "\nOn {}, {RUN_POINTS} points a row, differences over max(1, |value|):\n\n\
                 {:<12} {:<20} {:<16} {:<24} against CPU f64\n",
                runs.device, "  quantity", "road", "cos theta1", "against CPU f32"
            ));
            for row in &runs.rows {
                let pair =
                    |difference: &Difference| format!("max {:.1e} RMS {:.1e}", difference.max_relative, difference.rms);
                text.push_str(&format!(
                    "  {:<12} {:<20} {:<14} {}  {}\n",
                    row.quantity,
                    row.road,
                    format!("{} to {}", row.cos_theta1[0], row.cos_theta1[1]),
                    pair(&row.against_f32.difference),
                    pair(&row.against_f64.difference)
                ));
            }
            text.push_str(&worst(runs));
        }
    }
    if manifest.rates.emitted {
        let names: Vec<&str> = manifest.rates.prepared.iter().map(PreparedRow::name).collect();
        text.push_str(&format!(
            "\nPrepared once a material: {}. Each pixel is spared {} operations.\n",
            names.join(", "),
            manifest.rates.saved_per_pixel.weight()
        ));
    }
    if manifest.rates.vertex.emitted {
        let names: Vec<&str> = manifest.rates.vertex.interpolated.iter().map(PreparedRow::name).collect();
        text.push_str(&format!(
            "\nComputed at each vertex: {}. Each pixel is spared {} more operations; interpolated values are \
             approximations.\n",
            names.join(", "),
            manifest.rates.vertex.saved_per_pixel.weight()
        ));
    }
    text.push_str(&manifest.precision.report());
    let reference = &manifest.against_reference;
    text.push_str(&needs(&manifest.numerics.needs));
    text.push_str(&format!(
        "\nReflectance against the exact spectral reference: max {:.2e}, RMS {:.2e} over {} points.\n\
         All figures: {}\n",
        reference.max,
        reference.rms,
        reference.points,
        folder.join("manifest.json").display()
    ));
    text
}

/// What the variant needs of a driver's functions.
fn needs(needs: &FunctionNeeds) -> String {
    let named = [("sin", needs.sin), ("cos", needs.cos), ("exp", needs.exp)];
    let named: Vec<String> =
        named.iter().filter_map(|(name, error)| error.map(|error| format!("{name} {error:.0e}"))).collect();
    match (named.is_empty(), needs.met) {
        (true, _) => "\nNeeds no sine, cosine or exponential.\n".to_owned(),
        (_, true) => format!("\nErrors of functions that add less than its own: {}.\n", named.join(", ")),
        (_, false) => format!("\nErrors of functions that already add more than its own: {}.\n", named.join(", ")),
    }
}

/// The worst point of the reflectance on any road, away from grazing angles.
fn worst(runs: &Runs) -> String {
    let rows = runs.rows.iter().filter(|row| row.quantity == "reflectance" && row.cos_theta1[0] == GRAZING_COSINE);
    let largest = rows.max_by(|a, b| a.against_f64.difference.max.total_cmp(&b.against_f64.difference.max));
    let Some(row) = largest else { return String::new() };
    let Some(inputs) = row.against_f64.worst_inputs.first() else { return String::new() };
    let named: Vec<String> =
        row.columns.iter().zip(inputs).map(|(column, value)| format!("{column} = {value}")).collect();
    format!("  worst reflectance against f64 at {} ({})\n", named.join(", "), row.road)
}
