//! Fits groups of optical constants to films on metals, and prints the errors on held-out points, evaluated in `f32`.
//!
//! `cargo run --release -p pavo-fit --example group_fits`

use pavo_fit::groups::{GroupsRequest, fit_groups};
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Sensitivities};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let sensitivities = Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb)?;
    let constant = |n: f64| OpticalConstants::constant(n, 0.0);
    let built_in = OpticalConstants::built_in;
    let scenes = [
        ("2.6 on Cu", constant(2.6)?, built_in("Cu")?),
        ("1.77 on Au", constant(1.77)?, built_in("Au")?),
        ("2.0 on Ag", constant(2.0)?, built_in("Ag")?),
        ("TiO2 on Ti", built_in("TiO2")?, built_in("Ti")?),
    ];
    println!("scene: nodes, groups: rms, max, seconds");
    for (name, film, base) in scenes {
        for (nodes, groups) in [(6, 1), (6, 2), (6, 3), (6, 6), (8, 1), (8, 2), (8, 3), (8, 4), (8, 8)] {
            let request = GroupsRequest {
                ambient_ior: 1.0,
                film: film.clone(),
                base: base.clone(),
                thickness_nm: [0.0, 3000.0],
                sensitivities: &sensitivities,
                nodes,
                groups,
            };
            let begin = Instant::now();
            let fit = fit_groups(&request)?;
            let indices: Vec<String> = fit
                .groups
                .iter()
                .map(|group| {
                    let (n, k) = group.base.unwrap_or_default();
                    format!("{}: {n:.2} + {k:.2}i", group.nodes)
                })
                .collect();
            let seconds = begin.elapsed().as_secs_f64();
            println!(
                "{name}: {nodes}, {groups}: {:.2e}, {:.3}, {seconds:.1}; {}",
                fit.rms,
                fit.max,
                indices.join(", ")
            );
        }
    }
    Ok(())
}
