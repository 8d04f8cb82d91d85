//! Half precision: which parts stand it, measured.

use pavo::points::spread;
use pavo::{Shading, Variant, scene::Scene};
use pavo_optics::Precision;

#[test]
fn measure() {
    let films = [
        ("soap", "ior = 1.33", "ior = 1.0", 1200.0),
        ("oil", "ior = 1.5", "ior = 1.33", 3000.0),
        ("high", "ior = 2.5", "ior = 1.2", 3000.0),
        ("ti", "ior = 2.4", "ior = 2.7\nkappa = 3.8", 3000.0),
        ("ag", "ior = 2.0", "ior = 0.06\nkappa = 3.6", 3000.0),
    ];
    let variants = [
        "windowed:k=4",
        "windowed:k=6",
        "windowed:k=8",
        "poles:k=4",
        "poles:k=5",
        "poles:k=6",
        "series:m=3,fit=xyz-gauss",
        "series:m=3,fit=exact",
        "cosines:k=6,m=2",
        "spectral:n=16",
        "spectral:n=81",
    ];
    for (name, film, base, most) in films {
        let text = format!("name = \"x\"\n[film]\n{film}\nthickness_nm = [0, {most}]\n[base]\n{base}\n");
        let scene = Scene::from_toml("x.toml", &text, std::path::Path::new(".")).unwrap();
        for variant in variants {
            let full = Shading::new(&scene, &variant.parse::<Variant>().unwrap()).unwrap();
            let quantity = pavo::ShadingQuantity::Reflectance;
            let points = spread(&full.inputs(quantity), 2000, 1);
            let exact = full.reference_each(quantity, &points).unwrap();
            let base = full.evaluate_each(quantity, &points);
            let rms = |a: &[[f64; 3]], b: &[[f64; 3]]| {
                let d: Vec<f64> = a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).collect();
                (
                    (d.iter().map(|d| d * d).sum::<f64>() / d.len() as f64).sqrt(),
                    d.iter().fold(0.0, |m: f64, d| m.max(*d)),
                )
            };
            print!("{name:5} {variant:26} own {:.2e} {:.2e}", rms(&base, &exact).0, rms(&base, &exact).1);
            for precision in [Precision { sums: true, nodes: false }, Precision { sums: true, nodes: true }] {
                let half = full.with_precision(precision).evaluate_each(quantity, &points);
                let ((r, m), (rr, _)) = (rms(&half, &base), rms(&half, &exact));
                print!(" | {:?} {r:.2e} {m:.2e} to ref {rr:.2e}", precision.nodes);
            }
            println!();
        }
    }
}
