//! Errors, counted costs and times of all kernels, in one run.

use crate::catalogue::peers;
use crate::classes::{At, Class, numbers};
use crate::date::today;
use crate::failure::Failure;
use crate::kernel::{Kernel, Origin};
use crate::musts::{self, Outcome};
use pavo::statistics::Difference;
use pavo_check::static_cost::{NetCost, StaticCompiler, net};
use pavo_check::timing::{Candidate, Timings, compare};
use pavo_check::{ComputeShader, Device};
use pavo_emit::WORKGROUP_SIZE;
use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::delta_e_of_linear;
use serde::Serialize;
use std::path::PathBuf;

/// The variants of pavo's that stand beside the peers.
const VARIANTS: [&str; 8] = [
    "cosines:k=6,m=1",
    "windowed:k=4",
    "windowed:k=6",
    "windowed:k=8",
    "poles:k=5",
    "poles:k=6",
    "series:m=2,fit=xyz-gauss",
    "spectral:n=81",
];

/// The peer that all else is compared with.
const REFERENCE: &str = "three.js";

/// What to measure, and how long.
pub struct Plan {
    /// Where the packages are installed.
    pub packages: PathBuf,
    /// Points of each kernel in each round of the timing.
    pub timed_points: usize,
    /// Rounds of the timing.
    pub rounds: usize,
}

/// What was measured.
#[derive(Debug, Serialize)]
pub struct Report {
    /// When.
    pub date: String,
    /// The version of pavo.
    pub pavo: &'static str,
    /// The packages of the peers.
    pub packages: Vec<Package>,
    /// The device that ran the kernels.
    pub device: String,
    /// The compilers that counted their costs.
    pub compilers: Vec<String>,
    /// Threads of lavapipe, where their number was set.
    pub lavapipe_threads: Option<String>,
    /// Points of each kernel in each round of the timing.
    pub timed_points: usize,
    /// Rounds of the timing.
    pub rounds: usize,
    /// The classes of surfaces.
    pub classes: Vec<ClassReport>,
    /// Variants that cannot be made for a class.
    pub left_out: Vec<String>,
    /// What pavo has to reach beside the peers.
    pub musts: Vec<Outcome>,
}

/// The package of a peer.
#[derive(Debug, Serialize)]
pub struct Package {
    /// The system.
    pub system: String,
    /// The package.
    pub package: String,
    /// Its version.
    pub version: String,
}

/// What was measured over a class.
#[derive(Debug, Serialize)]
pub struct ClassReport {
    /// The class.
    pub class: Class,
    /// How many points the errors are over.
    pub points: usize,
    /// A row for each kernel.
    pub rows: Vec<Row>,
}

/// What was measured of one kernel.
#[derive(Debug, Serialize)]
pub struct Row {
    /// The kernel.
    pub name: String,
    /// The peer whose function it is, called as the peer calls it.
    pub peer: Option<String>,
    /// Whether it is a variant of pavo's.
    pub is_pavo: bool,
    /// Against the exact reference.
    pub errors: Errors,
    /// On navi21.
    pub navi21: Cost,
    /// On vega10.
    pub vega10: Cost,
    /// On lavapipe, where it was timed.
    pub lavapipe: Option<Time>,
}

/// Differences of linear sRGB reflectances.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Errors {
    /// The largest in any channel.
    pub max: f64,
    /// The root of the mean square over points and channels.
    pub rms: f64,
    /// The same where both sides are held at 0 or above, as colours out of gamut are by some peers.
    pub rms_clamped: f64,
    /// The mean CIEDE2000.
    pub mean_delta_e: f64,
}

/// A counted cost, less that of an empty shader with the same inputs.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// Without early returns.
    pub net: NetCost,
    /// As it is shipped, where that has an early return.
    pub net_with_exit: Option<NetCost>,
    /// Vector registers of the whole shader.
    pub vgprs: u64,
    /// Net inverse throughput as a multiple of the reference's.
    pub ratio: f64,
}

/// A time for one evaluation, less that of reading and writing.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Time {
    /// Nanoseconds, the median of the rounds.
    pub nanoseconds: f64,
    /// A multiple of the reference's, the median of the rounds.
    pub ratio: f64,
    /// A quarter of the rounds lies below.
    pub ratio_lower_quartile: f64,
    /// A quarter of the rounds lies above.
    pub ratio_upper_quartile: f64,
}

/// Measures everything.
///
/// # Errors
/// If a package, a tool or a driver is missing, a text of a peer is not as expected, or a judge refuses one.
pub fn measure(plan: &Plan) -> Result<Report, Failure> {
    // First of all, as opening one sets an environment variable for the moment.
    let compilers = [StaticCompiler::open("navi21")?, StaticCompiler::open("vega10")?];
    let device = Device::lavapipe()?;
    let mut packages = Vec::new();
    let mut texts = Vec::new();
    for peer in peers()? {
        let version = peer.version(&plan.packages)?;
        let text = peer.read(&plan.packages)?;
        packages.push(Package { system: peer.name.clone(), package: peer.package.clone(), version: version.clone() });
        texts.push((peer, version, text));
    }
    let mut left_out = Vec::new();
    let mut classes = Vec::new();
    for class in Class::ALL {
        let mut kernels = Vec::new();
        for (peer, version, text) in &texts {
            for call in peer.call.iter().filter(|call| call.classes.contains(&class)) {
                kernels.push(Kernel::of_peer(peer, version, call, text)?);
            }
        }
        for variant in VARIANTS {
            match Kernel::of_pavo(class, variant) {
                Ok(kernel) => kernels.push(kernel),
                Err(Failure::Shading(error)) => left_out.push(error.to_string()),
                Err(other) => return Err(other),
            }
        }
        classes.push(of_class(class, &kernels, &device, &compilers, plan)?);
    }
    let musts = musts::outcomes(&classes);
    Ok(Report {
        date: today(),
        pavo: env!("CARGO_PKG_VERSION"),
        packages,
        device: device.description().to_string(),
        compilers: compilers.iter().map(|compiler| compiler.description().to_string()).collect(),
        lavapipe_threads: std::env::var("LP_NUM_THREADS").ok(),
        timed_points: plan.timed_points,
        rounds: plan.rounds,
        classes,
        left_out,
        musts,
    })
}

fn of_class(
    class: Class,
    kernels: &[Kernel],
    device: &Device,
    compilers: &[StaticCompiler; 2],
    plan: &Plan,
) -> Result<ClassReport, Failure> {
    let (points, exact) = class.reference()?;
    let timings = timings(class, kernels, device, plan)?;
    let reference = kernels.iter().find(|kernel| kernel.of == Origin::Peer(REFERENCE.to_owned()));
    let reference = reference.ok_or_else(|| Failure::Text(format!("no peer is called {REFERENCE}")))?;
    let mut rows = Vec::new();
    for kernel in kernels {
        let [navi21, vega10] = [&compilers[0], &compilers[1]].map(|compiler| {
            let of_reference = cost(compiler, reference, 1)?.net.inverse_throughput;
            cost(compiler, kernel, of_reference)
        });
        let timing = timings.timings.iter().find(|timing| timing.name == kernel.name);
        rows.push(Row {
            name: kernel.name.clone(),
            peer: if let Origin::Peer(name) = &kernel.of { Some(name.clone()) } else { None },
            is_pavo: kernel.of == Origin::Pavo,
            errors: errors(kernel, device, &points, &exact)?,
            navi21: navi21?,
            vega10: vega10?,
            lavapipe: timing.map(|timing| Time {
                nanoseconds: timing.net.median,
                ratio: timing.ratio.median,
                ratio_lower_quartile: timing.ratio.lower_quartile,
                ratio_upper_quartile: timing.ratio.upper_quartile,
            }),
        });
    }
    Ok(ClassReport { class, points: points.len(), rows })
}

fn shader<'a>(kernel: &'a Kernel, spirv: &'a [u32]) -> ComputeShader<'a> {
    ComputeShader { spirv, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &kernel.tables }
}

/// The errors of a kernel as it is shipped.
fn errors(kernel: &Kernel, device: &Device, points: &[At], exact: &[[f64; 3]]) -> Result<Errors, Failure> {
    let inputs = numbers(points, &kernel.inputs);
    let spirv = kernel.spirv_with_exit.as_ref().unwrap_or(&kernel.spirv);
    let found = device.evaluate(&shader(kernel, spirv), &inputs, kernel.inputs_per_point(), 3)?;
    let found: Vec<[f64; 3]> =
        found.chunks_exact(3).map(|color| [color[0], color[1], color[2]].map(f64::from)).collect();
    let difference = Difference::between(&found, exact, 1);
    let clamped = |colors: &[[f64; 3]]| -> Vec<[f64; 3]> {
        colors.iter().map(|color| color.map(|value| value.max(0.0))).collect()
    };
    let pairs = found.iter().zip(exact);
    let sum: f64 = pairs.map(|(found, exact)| delta_e_of_linear(*found, *exact, ColourSpace::LinearSrgb)).sum();
    Ok(Errors {
        max: difference.max,
        rms: if difference.not_finite > 0 { f64::INFINITY } else { difference.rms },
        rms_clamped: Difference::between(&clamped(&found), &clamped(exact), 1).rms,
        mean_delta_e: sum / found.len() as f64,
    })
}

/// What a kernel costs, as a multiple of the inverse throughput of the reference.
fn cost(compiler: &StaticCompiler, kernel: &Kernel, of_reference: i64) -> Result<Cost, Failure> {
    let baseline = compiler.glsl("baseline.frag", &kernel.baseline)?;
    let whole = compiler.glsl("cost.frag", &kernel.fragment)?;
    let with_exit = kernel.fragment_with_exit.as_ref();
    let with_exit = with_exit.map(|text| net(&compiler.glsl("cost.frag", text)?, &baseline)).transpose()?;
    let net = net(&whole, &baseline)?;
    let ratio = net.inverse_throughput as f64 / of_reference as f64;
    Ok(Cost { net, net_with_exit: with_exit, vgprs: whole.vgprs, ratio })
}

/// The times of all kernels that are timed, by turns.
fn timings(class: Class, kernels: &[Kernel], device: &Device, plan: &Plan) -> Result<Timings, Failure> {
    let timed: Vec<&Kernel> = kernels.iter().filter(|kernel| kernel.is_timed).collect();
    let points = class.many_points(plan.timed_points);
    // Kernels with the same inputs share them.
    let mut shared: Vec<(&Kernel, Vec<f32>)> = Vec::new();
    for kernel in &timed {
        if !shared.iter().any(|(other, _)| other.inputs == kernel.inputs) {
            shared.push((kernel, numbers(&points, &kernel.inputs)));
        }
    }
    let candidates = timed.iter().map(|kernel| {
        let inputs = shared.iter().find(|(other, _)| other.inputs == kernel.inputs);
        Candidate {
            name: &kernel.name,
            shader: shader(kernel, &kernel.spirv),
            inputs: inputs.map_or(&[], |(_, numbers)| numbers),
            inputs_per_point: kernel.inputs_per_point(),
            outputs_per_point: 3,
        }
    });
    let candidates: Vec<Candidate<'_>> = candidates.collect();
    let reference = timed.iter().find(|kernel| kernel.of == Origin::Peer(REFERENCE.to_owned()));
    let reference = reference.map_or(REFERENCE, |kernel| &kernel.name);
    Ok(compare(device, &candidates, reference, plan.rounds)?)
}
