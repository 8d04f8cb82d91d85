//! Wave numbers under a window, as in [`crate::windowed`], for media whose indices depend on the wavelength: the wave
//! numbers fall into a few groups, each with indices of its own, and Fresnel's terms are computed once for a group.
//!
//! `R_j = sum_groups (W_j rest - sum_k w_jk node_k)`, with `W_j` the share of the group in channel j, and `rest` and `node`
//! those of [`WindowedFilm`] for the indices of the group.

use crate::film::{BaseKind, Film, Media};
use crate::relative::relative_film;
use crate::windowed::{Phase, Window, WindowedFilm, closing, color_of_nodes, phases};
use pavo_shade::{Lanes, Real, Scalar, Value, Vector, shade};

/// Consecutive wave numbers that share their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WindowGroup {
    /// How many wave numbers.
    pub nodes: usize,
    /// Refractive index and extinction coefficient of the base, where they are the group's own.
    pub base: Option<(f64, f64)>,
    /// Refractive index of the film, where it is the group's own. Path and phases are then the group's own too.
    pub film: Option<f64>,
}

/// Both polarisations of a film under the window, with the indices of one group of wave numbers.
///
/// Source: the Poisson kernel over orders of Belcour and Barla 2017, equation 9.
#[shade]
pub fn windowed_group<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// Whether the film may reflect totally.
    #[constant]
    total_reflection: bool,
    /// The kind of base.
    #[constant]
    base: BaseKind,
    /// Cosine of the angle of incidence in the ambient medium, [0, 1].
    cos_theta1: S,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: S,
    /// The window g at this optical path difference, (0, 1].
    window: S,
    /// Its square, held at 0.15 or above.
    window_squared: S,
    /// Refractive index of the film in this group, > 0.
    #[runtime]
    film_ior: S,
    /// Refractive index of the base in this group, > 0.
    #[runtime]
    base_ior: R,
    /// Extinction coefficient of the base in this group, >= 0.
    #[runtime]
    base_kappa: R,
) -> WindowedFilm<R> {
    let media = Media { cos_theta1, ambient_ior, film_ior };
    let wave = media.wave_of_orders(total_reflection);
    let film = relative_film(base, media, wave, base_ior, base_kappa);
    WindowedFilm::under([window, window_squared], base, film)
}

/// Reflectance of the film by groups of wave numbers under a window, all orders. Groups without an index of their own have
/// those given.
pub fn grouped_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    film: &Film,
    window: &Window,
    groups: &[WindowGroup],
    media: Media<S>,
    thickness_nm: S,
    path_nm: S,
    base_index: [R; 2],
) -> S::Vec3 {
    let Media { cos_theta1, ambient_ior, .. } = media;
    // What groups without a film index of their own share.
    let closing_of_all = closing(window.width_nm, path_nm);
    let mut phases_of_all = phases(window, film.base, path_nm).into_iter();
    let mut reflected = S::Vec3::lit(0.0);
    for (part, group) in parts(window, groups) {
        let [base_ior, base_kappa] = group.base.map_or(base_index, |(ior, kappa)| [R::lit(ior), R::lit(kappa)]);
        let film_ior = group.film.map_or(media.film_ior, S::lit);
        let shared: Vec<Phase<S>> = phases_of_all.by_ref().take(part.weights.len()).collect();
        let (phases, [g, g_squared]) = match group.film {
            None => (shared, closing_of_all),
            Some(_) => {
                let wave = Media { film_ior, ..media }.wave_of_orders(film.total_reflection);
                let path_nm = (thickness_nm * wave.q2).named("path_nm");
                (phases(&part, film.base, path_nm), closing(window.width_nm, path_nm))
            }
        };
        let terms = windowed_group::<S, R>(
            film.total_reflection,
            film.base,
            cos_theta1,
            ambient_ior,
            g,
            g_squared,
            film_ior,
            base_ior,
            base_kappa,
        )
        .named("group");
        let precision = film.precision;
        let nodes = phases.into_iter().map(|phase| terms.node(precision, phase.map(R::from_scalar)));
        let (rest, centre) = terms.rest_and_centre(precision);
        let rest = precision
            .sum(reflected + precision.weighted::<S>(share(&part.weights), rest.into_vec3()))
            .named("reflected");
        reflected = color_of_nodes(precision, nodes, &part.weights, (rest, centre));
    }
    reflected
}

/// The base as each channel sees it most: the index of the group with the largest share.
pub(crate) fn channel_base<S: Scalar, R: Lanes<S>>(
    window: &Window,
    groups: &[WindowGroup],
    base_index: [R; 2],
) -> [S::Vec3; 2] {
    let parts = parts(window, groups);
    let most = |channel: usize| {
        let largest = parts.iter().max_by(|a, b| share(&a.0.weights)[channel].total_cmp(&share(&b.0.weights)[channel]));
        largest.and_then(|(_, group)| group.base)
    };
    let own: [Option<(f64, f64)>; 3] = core::array::from_fn(most);
    match own {
        [Some(red), Some(green), Some(blue)] => {
            [S::Vec3::lit3([red.0, green.0, blue.0]), S::Vec3::lit3([red.1, green.1, blue.1])]
        }
        _ => base_index.map(Lanes::into_vec3),
    }
}

/// The wave numbers of each group.
fn parts<'a>(window: &Window, groups: &'a [WindowGroup]) -> Vec<(Window, &'a WindowGroup)> {
    let mut rest = window.weights.as_slice();
    let mut first = window.first;
    let mut part = |group: &'a WindowGroup| {
        let (weights, left) = rest.split_at(group.nodes.min(rest.len()));
        let part = Window { first, weights: weights.to_vec(), ..window.clone() };
        first += window.step * weights.len() as f64;
        rest = left;
        (part, group)
    };
    groups.iter().map(&mut part).collect()
}

/// The share of some wave numbers in each channel.
fn share(weights: &[[f64; 3]]) -> [f64; 3] {
    core::array::from_fn(|channel| weights.iter().map(|weight| weight[channel]).sum())
}
