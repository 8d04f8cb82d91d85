//! Work on many points: on all cores with the feature `parallel`, else on one.

/// What a function gives for each item, in their order.
#[cfg(feature = "parallel")]
pub fn map_each<T: Sync, R: Send>(items: &[T], of: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter().map(of).collect()
}

/// What a function gives for each item, in their order.
#[cfg(not(feature = "parallel"))]
pub fn map_each<T: Sync, R: Send>(items: &[T], of: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    items.iter().map(of).collect()
}
