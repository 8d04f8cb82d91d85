//! A medium by its reflectance at normal incidence under air and an edge tint: from a complex index to them and back, as
//! the paper has it. The reference and what is compared with it come from here; emitted code has a form of its own.
//!
//! Source: O. Gulbrandsen, "Artist Friendly Metallic Fresnel", Journal of Computer Graphics Techniques 3(4), 2014.

/// The root of the largest reflectance that an index is made for: 0.9998 is an index of 2e4.
const LARGEST_ROOT: f64 = 0.9999;

/// The complex index of what reflects `f0` at normal incidence, [0, 1]: without an edge tint a dielectric, with one,
/// [0, 1], a conductor. What reflects more than 0.9998 reflects 0.9998.
pub fn index_of_f0(f0: f64, edge_tint: Option<f64>) -> (f64, f64) {
    let root = f0.max(0.0).sqrt().min(LARGEST_ROOT);
    let largest = (1.0 + root) / (1.0 - root);
    let Some(edge_tint) = edge_tint else { return (largest, 0.0) };
    let r = root * root;
    let smallest = (1.0 - r) / (1.0 + r);
    let n = edge_tint * smallest + (1.0 - edge_tint) * largest;
    let k_squared = (r * (n + 1.0).powi(2) - (n - 1.0).powi(2)) / (1.0 - r);
    (n, k_squared.max(0.0).sqrt())
}

/// Reflectance at normal incidence and edge tint of a complex index. Weak absorbers of an index below 1 have an edge tint
/// above 1; air has none, and 0 is given for it.
pub fn f0_and_edge_tint(n: f64, k: f64) -> (f64, f64) {
    let r = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
    let largest = (1.0 + r.sqrt()) / (1.0 - r.sqrt());
    let smallest = (1.0 - r) / (1.0 + r);
    let span = largest - smallest;
    (r, if span > 0.0 { (largest - n) / span } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::{f0_and_edge_tint, index_of_f0};

    #[test]
    fn an_index_comes_back_from_its_reflectance_and_edge_tint() {
        // Titanium, copper in red, silver in green, a dielectric, silicon.
        for (n, k) in [(2.7, 3.8), (0.27, 3.41), (0.06, 3.6), (1.5, 0.0), (4.1, 0.04)] {
            let (f0, edge_tint) = f0_and_edge_tint(n, k);
            assert!((-1e-12..=1.0).contains(&edge_tint), "{n} + {k}i: {edge_tint}");
            let (found_n, found_k) = index_of_f0(f0, Some(edge_tint));
            assert!((found_n - n).abs() < 1e-9 && (found_k * found_k - k * k).abs() < 1e-9, "{found_n} + {found_k}i");
        }
    }

    #[test]
    fn a_dielectric_has_no_edge_tint_and_needs_none() {
        let (f0, edge_tint) = f0_and_edge_tint(1.5, 0.0);
        assert!((f0 - 0.04).abs() < 1e-15 && edge_tint.abs() < 1e-12);
        let (n, k) = index_of_f0(0.04, None);
        assert!((n - 1.5).abs() < 1e-12 && k == 0.0);
        assert_eq!(f0_and_edge_tint(1.0, 0.0), (0.0, 0.0));
    }
}
