//! The arguments of the command.

use super::work::count;
use crate::inputs::ShadingQuantity;
use crate::target::Target;
use crate::variant::FittedForm;
use clap::{Args, Parser, Subcommand, ValueEnum};
use pavo_emit::Form;
use pavo_spectra::fits::FitFamily;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  pavo new my-film                                  a scene to start from: my-film.toml
  pavo build my-film.toml                           emit, judge, run on lavapipe, report
  pavo emit my-film.toml --target wgsl              the shader functions, on standard output
  pavo export my-film.toml --engine three           what an engine takes, and where it goes
  pavo preview my-film.toml -o sphere.png           a picture of a lit sphere
  pavo eval my-film.toml --points points.csv --on reference
  pavo fit scene my-film.toml --max-rms 0.002        a short form, fitted to this scene
  pavo tune my-film.toml --max-delta-e 1            the cheapest variant that is right enough
  pavo report my-film.toml -o report                all of this, as one page: report/index.html
  pavo stability my-film.toml                       where its variant breaks
  pavo doctor                                       which judges and drivers are here

Exit status: 0 fine, 1 a check failed, 2 bad input, 3 something needed is missing.";

/// Thin-film iridescence shaders, generated and proven.
///
/// A scene file says what a surface is made of; out come WGSL, GLSL and SPIR-V, judged by naga, glslang and SPIRV-Tools
/// and run on lavapipe against the CPU evaluation, and Rust for the CPU.
#[derive(Debug, Parser)]
#[command(name = "pavo", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Emit a scene's shaders, judge them, run them on lavapipe, and report.
    Build(Build),
    /// Emit one shader.
    Emit(Emit),
    /// Write a scene's functions as an engine takes them.
    Export(Export),
    /// Ask the judges only: of the shaders of a scene, or of shader files.
    Check(Check),
    /// Evaluate a scene at the points of a table.
    Eval(Eval),
    /// Render a lit sphere on lavapipe.
    Preview(Preview),
    /// Draw the sensitivities and their fits, or the colours of a scene beside the exact ones.
    Plot(Plot),
    /// Make a fit: of sensitivities, or of one scene's reflectance.
    Fit(Fit),
    /// Measure error and cost of every variant, and pick one.
    Tune(Tune),
    /// Write a page on a scene: every variant's error and cost, the pick, pictures, the worst points, the code.
    Report(Report),
    /// Examine where variants break: a catalogue of hard cases and a sweep of many points, on the CPU and on lavapipe.
    #[command(after_help = STABILITY_EXAMPLES)]
    Stability(Stability),
    /// List the variants of a scene with their errors and operation counts.
    Variants(Variants),
    /// Say which judges and drivers were found.
    Doctor(Doctor),
    /// Write a starter scene.
    New(New),
}

#[derive(Debug, Args)]
pub struct Build {
    /// The scene file.
    pub scene: PathBuf,
    /// The folder to write to [default: the scene's name].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Targets, separated by commas [default: those of the scene].
    #[arg(long, value_delimiter = ',', value_name = "LIST", value_parser = target)]
    pub target: Vec<Target>,
    /// The variant, such as series:m=3,fit=xyz-gauss or spectral:n=81 [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// Do not run the shaders on lavapipe.
    #[arg(long)]
    pub no_run: bool,
    /// Print the manifest instead of the report.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct Emit {
    /// The scene file.
    pub scene: PathBuf,
    /// What to emit: wgsl, glsl450, glsl330, essl300, rust, spirv, spirv-asm.
    #[arg(long, value_parser = target)]
    pub target: Target,
    /// The variant [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// What stands around the functions [default: library, for SPIR-V compute].
    #[arg(long, value_enum)]
    pub form: Option<FormName>,
    /// What the compute form evaluates.
    #[arg(long, value_enum, default_value_t = QuantityName::Reflectance)]
    pub quantity: QuantityName,
    /// End each statement with the line of Rust that made it.
    #[arg(long)]
    pub source_lines: bool,
    /// The file to write [default: standard output].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

const EXPORT_EXAMPLES: &str = "\
Examples:
  pavo export --list                                the engines, and how each was verified
  pavo export my-film.toml --engine three -o film   the chunk for three.js, a README, vectors and a page that checks";

#[derive(Debug, Args)]
#[command(after_help = EXPORT_EXAMPLES)]
pub struct Export {
    /// The scene file.
    #[arg(required_unless_present = "list")]
    pub scene: Option<PathBuf>,
    /// The engine: one of those that --list shows.
    #[arg(long, value_name = "NAME", required_unless_present = "list")]
    pub engine: Option<String>,
    /// The folder to write to [default: the scene's name with the engine's].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// The variant [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// List the engines with their languages and how each was verified.
    #[arg(long)]
    pub list: bool,
    /// Print the list as a table in Markdown.
    #[arg(long, requires = "list", conflicts_with = "json")]
    pub markdown: bool,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct Check {
    /// A scene (.toml), whose targets are emitted and judged, or shader files.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// The variant, for scenes.
    #[arg(long)]
    pub variant: Option<String>,
    /// Print the verdicts as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct Eval {
    /// The scene file.
    pub scene: PathBuf,
    /// The points: a CSV whose header names run-time inputs of the scene.
    #[arg(long, value_name = "CSV")]
    pub points: PathBuf,
    /// On what to evaluate.
    #[arg(long, value_enum)]
    pub on: Evaluator,
    /// What to evaluate.
    #[arg(long, value_enum, default_value_t = QuantityName::Reflectance)]
    pub quantity: QuantityName,
    /// The variant [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// The file to write [default: standard output].
    #[arg(short, long, value_name = "CSV")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct Preview {
    /// The scene file.
    pub scene: PathBuf,
    /// The picture to write.
    #[arg(short, long, value_name = "PNG", default_value = "sphere.png")]
    pub output: PathBuf,
    /// The variant [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// The width and height of the picture in pixels, 16 to 4096.
    #[arg(long, value_name = "PIXELS", default_value = "512", value_parser = count)]
    pub size: f64,
}

#[derive(Debug, Args)]
pub struct Plot {
    #[command(subcommand)]
    pub plot: PlotCommand,
}

#[derive(Debug, Subcommand)]
pub enum PlotCommand {
    /// Draw spectral sensitivities, their Fourier transforms and the Gaussian fits of both.
    Sensitivities(PlotSensitivities),
    /// Draw the reflectance over angle and thickness, beside the exact one and their difference.
    Reflectance(PlotReflectance),
}

#[derive(Debug, Args)]
pub struct PlotSensitivities {
    #[command(flatten)]
    pub spectrum: SpectrumArguments,
    /// The picture to write, .svg or .png.
    #[arg(short, long, value_name = "FILE", default_value = "sensitivities.svg")]
    pub output: PathBuf,
}

#[derive(Debug, Args)]
pub struct SpectrumArguments {
    /// The observer: cie1931-2deg or cie1964-10deg.
    #[arg(long, default_value = "cie1931-2deg")]
    pub observer: String,
    /// The illuminant: E, D65, D50 or A, or a CSV file with the columns wavelength_nm and value.
    #[arg(long, default_value = "E")]
    pub illuminant: String,
    /// The colour space: linear-srgb, display-p3, rec2020, acescg or xyz.
    #[arg(long, default_value = "xyz")]
    pub space: String,
}

#[derive(Debug, Args)]
pub struct PlotReflectance {
    /// The scene file.
    pub scene: PathBuf,
    /// The variant [default: that of the scene].
    #[arg(long)]
    pub variant: Option<String>,
    /// The picture to write, .png or .svg.
    #[arg(short, long, value_name = "FILE", default_value = "reflectance.png")]
    pub output: PathBuf,
}

#[derive(Debug, Args)]
pub struct Fit {
    #[command(subcommand)]
    pub fit: FitCommand,
}

#[derive(Debug, Subcommand)]
pub enum FitCommand {
    /// Fit the Fourier transforms of spectral sensitivities.
    Sensitivities(FitSensitivities),
    /// Fit the reflectance of a scene whose indices are fixed.
    Scene(FitScene),
}

#[derive(Debug, Args)]
pub struct FitSensitivities {
    /// The form of the fit.
    #[arg(long, value_enum)]
    pub family: FamilyName,
    /// How many terms; for rgb-gauss and xyz-gauss, for each channel.
    #[arg(long, value_parser = count)]
    pub count: f64,
    #[command(flatten)]
    pub spectrum: SpectrumArguments,
    /// The largest optical path difference that is fitted, um.
    #[arg(long, value_name = "UM", default_value_t = 12.0)]
    pub max_opd_um: f64,
    /// What the random numbers of the starts begin with.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Print the fit as JSON.
    #[arg(long)]
    pub json: bool,
    /// The file to write [default: standard output].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct FitScene {
    /// The scene file.
    pub scene: PathBuf,
    /// The form [default: the cheapest that keeps to the errors; with none given, the one that comes closest].
    #[arg(long, value_enum)]
    pub form: Option<FormOfFit>,
    /// How many waves; where the form is left open, how many at most.
    #[arg(short = 'k', long, default_value = "6", value_parser = count)]
    pub count: f64,
    /// The largest root of the mean square error.
    #[arg(long, value_name = "ERROR")]
    pub max_rms: Option<f64>,
    /// The largest error in any channel at any point.
    #[arg(long, value_name = "ERROR")]
    pub max_error: Option<f64>,
    /// What the random numbers of the starts begin with.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Print the fit with its coefficients as JSON.
    #[arg(long)]
    pub json: bool,
    /// The file to write [default: standard output].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct Tune {
    /// The scene file.
    pub scene: PathBuf,
    /// Pick the cheapest variant whose largest dE2000 is at most this [default: the scene's budget, or 1].
    #[arg(long, value_name = "DE", conflicts_with = "max_cost")]
    pub max_delta_e: Option<f64>,
    /// Pick the cheapest variant whose root of the mean square error is at most this.
    #[arg(long, value_name = "ERROR", conflicts_with_all = ["max_cost", "max_delta_e"])]
    pub max_rms: Option<f64>,
    /// Pick the closest variant that costs at most this.
    #[arg(long, value_name = "COST")]
    pub max_cost: Option<f64>,
    /// What the cost counts: ops, navi21, vega10, gfx1100 and other families, or lavapipe.
    #[arg(long, default_value = "ops")]
    pub cost: String,
    /// Measure the time on the Vulkan device whose name contains this.
    #[arg(long, value_name = "NAME", conflicts_with = "cost")]
    pub device: Option<String>,
    /// Let variants be picked that read tables of many constants: what counts costs sees no cache that they do not fit.
    #[arg(long)]
    pub tables: bool,
    /// List the variants off the frontier too, and why some cannot be made.
    #[arg(long)]
    pub all: bool,
    /// Print all figures as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct Report {
    /// The scene files; several make a gallery, with a page for each scene in a folder of its own.
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// The folder to write to.
    #[arg(short, long, value_name = "DIR", default_value = "report")]
    pub output: PathBuf,
    /// Pick the cheapest variant whose largest dE2000 is at most this [default: the scene's budget, or 1].
    #[arg(long, value_name = "DE")]
    pub max_delta_e: Option<f64>,
    /// Do not run the shaders on lavapipe: no times, and pictures by the CPU.
    #[arg(long)]
    pub no_run: bool,
    /// Print all figures as JSON; of several scenes, as a list.
    #[arg(long)]
    pub json: bool,
}

const STABILITY_EXAMPLES: &str = "\
Examples:
  pavo stability my-film.toml                       the variant of the scene
  pavo stability --all -o stability                 every built-in variant, with maps and the worst points
  pavo stability --all --quick                      the same with a short sweep";

#[derive(Debug, Args)]
pub struct Stability {
    /// The scene file.
    #[arg(required_unless_present = "all", conflicts_with = "all")]
    pub scene: Option<PathBuf>,
    /// Examine every built-in variant, with everything at run time.
    #[arg(long)]
    pub all: bool,
    /// The variant [default: that of the scene, or all].
    #[arg(long)]
    pub variant: Option<String>,
    /// The points of the sweep of each variant on lavapipe [default: 10000000, or with --quick 40000].
    #[arg(long, value_name = "N", value_parser = count)]
    pub points: Option<f64>,
    /// A short sweep, and each variant by every road on one surface alone.
    #[arg(long)]
    pub quick: bool,
    /// Print all figures as JSON.
    #[arg(long)]
    pub json: bool,
    /// The folder for the figures, the worst points, the scenes and maps of the error.
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct Variants {
    /// The scene file.
    pub scene: PathBuf,
    /// Print the list as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct Doctor {
    /// Print the findings as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct New {
    /// The name of the scene; the file is NAME.toml.
    pub name: String,
}

/// The families of fits by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FamilyName {
    /// Gaussians that the channels share.
    Gauss,
    /// Gaussians for each output channel.
    RgbGauss,
    /// Gaussians for each of X, Y and Z.
    XyzGauss,
    /// Complex exponentials that decay.
    Poles,
    /// Equally spaced wave numbers under a window.
    Windowed,
    /// Wavelengths of a quadrature.
    Nodes,
}

impl From<FamilyName> for FitFamily {
    fn from(name: FamilyName) -> Self {
        match name {
            FamilyName::Gauss => FitFamily::SharedGaussians,
            FamilyName::RgbGauss => FitFamily::RgbGaussians,
            FamilyName::XyzGauss => FitFamily::XyzGaussians,
            FamilyName::Poles => FitFamily::Poles,
            FamilyName::Windowed => FitFamily::WindowedNodes,
            FamilyName::Nodes => FitFamily::Nodes,
        }
    }
}

/// The forms of fits to a scene by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormOfFit {
    /// The angle alone: for a film of one thickness.
    AngleOnly,
    /// The first order of interference: for low contrast.
    #[value(alias = "m1")]
    FirstOrder,
    /// All orders by one kernel: for low contrast.
    #[value(alias = "ks")]
    Kernel,
    /// All orders, the higher ones damped more: for dielectrics.
    #[value(alias = "k")]
    DampedKernel,
    /// The same with a first order of its own: for high contrast.
    #[value(alias = "l2")]
    CorrectedKernel,
    /// Three orders with phases: for bases that absorb.
    #[value(alias = "cm3")]
    ThreeOrders,
}

impl From<FormOfFit> for FittedForm {
    fn from(form: FormOfFit) -> Self {
        match form {
            FormOfFit::AngleOnly => FittedForm::AngleOnly,
            FormOfFit::FirstOrder => FittedForm::FirstOrder,
            FormOfFit::Kernel => FittedForm::Kernel,
            FormOfFit::DampedKernel => FittedForm::DampedKernel,
            FormOfFit::CorrectedKernel => FittedForm::CorrectedKernel,
            FormOfFit::ThreeOrders => FittedForm::ThreeOrders,
        }
    }
}

/// The forms by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormName {
    /// Functions only.
    Library,
    /// A compute entry that evaluates a buffer of points.
    Compute,
    /// A fragment entry that shades a sphere.
    Fragment,
}

impl From<FormName> for Form {
    fn from(name: FormName) -> Self {
        match name {
            FormName::Library => Form::Library,
            FormName::Compute => Form::Compute,
            FormName::Fragment => Form::Fragment,
        }
    }
}

/// The quantities by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum QuantityName {
    /// The specular reflectance over the angle at the half vector.
    Reflectance,
    /// The BRDF.
    Brdf,
    /// The radiance under a punctual light.
    Radiance,
    /// The same, over the directions themselves.
    Directions,
}

impl From<QuantityName> for ShadingQuantity {
    fn from(name: QuantityName) -> Self {
        match name {
            QuantityName::Reflectance => ShadingQuantity::Reflectance,
            QuantityName::Brdf => ShadingQuantity::Brdf,
            QuantityName::Radiance => ShadingQuantity::Radiance,
            QuantityName::Directions => ShadingQuantity::Directions,
        }
    }
}

/// What evaluates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Evaluator {
    /// The exact spectral reference.
    Reference,
    /// The variant in f64 on the CPU.
    CpuF64,
    /// The variant in f32 on the CPU.
    CpuF32,
    /// The emitted WGSL, by naga, on lavapipe.
    LavapipeWgsl,
    /// The emitted GLSL 4.50, by glslang, on lavapipe.
    LavapipeGlsl,
    /// The emitted HLSL, by glslang, on lavapipe.
    LavapipeHlsl,
    /// The emitted SPIR-V on lavapipe.
    LavapipeSpirv,
}

fn target(text: &str) -> Result<Target, String> {
    text.parse()
}
