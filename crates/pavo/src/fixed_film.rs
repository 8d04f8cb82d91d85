//! What takes a film's place where its indices are fixed: a polynomial over the angle, a table over angle and thickness, or
//! a form fitted to the reflectance. Each is made from the exact reference.

use crate::baking::{chebyshev_cosines, polynomial};
use crate::fitting::{FitCache, GroupsRequest, SceneRequest, groups_fit, rational_fit, scene_fit};
use crate::inputs::ShadingQuantity;
use crate::methods::MethodError;
use crate::shading::{Shading, ShadingError};
use crate::variant::Variant;
use pavo_optics::{BakedFilm, Film, FilmTable, Specular};
use pavo_shade::Table;
use pavo_spectra::Stack;

/// How many angles a quotient of polynomials is fitted at.
const RATIONAL_SAMPLES: usize = 400;

/// The film by the variant, or nothing where the variant is a method for films of any index.
pub(crate) fn specular(shading: &Shading, cache: &dyn FitCache) -> Result<Option<Specular>, ShadingError> {
    let specular = match *shading.variant() {
        Variant::Baked { degree, denominator: 0 } => {
            only_varies(shading, &[], "baked is for uniform surfaces")?;
            let cosines = chebyshev_cosines(degree + 1);
            let points: Vec<Vec<f64>> = cosines.into_iter().map(|cosine| vec![cosine]).collect();
            let values = shading.reference_each(ShadingQuantity::Reflectance, &points)?;
            Specular::Baked(BakedFilm { coefficients: polynomial(&values), denominator: Vec::new() })
        }
        Variant::Baked { degree, denominator } => {
            only_varies(shading, &[], "baked is for uniform surfaces")?;
            let cosines = chebyshev_cosines(RATIONAL_SAMPLES);
            let points: Vec<Vec<f64>> = cosines.iter().map(|&cosine| vec![cosine]).collect();
            let values = shading.reference_each(ShadingQuantity::Reflectance, &points)?;
            let samples: Vec<(f64, [f64; 3])> = cosines.into_iter().zip(values).collect();
            let film = rational_fit(&samples, degree, denominator);
            Specular::Baked(film.map_err(|error| refused(shading, error))?)
        }
        Variant::Windowed { count, groups: Some(groups) } => {
            only_varies(shading, &["thickness_nm"], "groups are for films of fixed indices")?;
            let (film, media, thickness_nm) = dispersive_film(shading)?;
            let sensitivities = shading.sensitivities();
            let request = GroupsRequest { media: &media, thickness_nm, sensitivities, count, groups };
            let method = groups_fit(&request, cache).map_err(|error| refused(shading, error))?;
            Specular::Film(Film { method, ..film })
        }
        Variant::Table { angles, thicknesses } => {
            only_varies(shading, &["thickness_nm"], "a table is over angle and thickness")?;
            Specular::Table(table(shading, angles, thicknesses)?)
        }
        Variant::Fitted { form, count, rms_error } => {
            only_varies(shading, &["thickness_nm"], "fitted is for films of fixed indices")?;
            let media = shading.fixed_stack()?;
            let (Some(media), Some(thickness_nm)) = (media, shading.thickness_nm()) else {
                return Err(refused(shading, no_film()));
            };
            let request = SceneRequest {
                media: &media,
                thickness_nm,
                sensitivities: shading.sensitivities(),
                form,
                count,
                rms_error,
            };
            Specular::Fitted(scene_fit(&request, cache).map_err(|error| refused(shading, error))?)
        }
        _ => return Ok(None),
    };
    Ok(Some(specular))
}

/// The film on a scene's base, its media and its range of thickness, where an index depends on the wavelength.
fn dispersive_film(shading: &Shading) -> Result<(Film, Stack, [f64; 2]), ShadingError> {
    let film = match shading.specular() {
        Specular::Film(film) | Specular::FilmOnChannels { film, .. } => film.clone(),
        _ => return Err(refused(shading, no_film())),
    };
    let (Some(media), Some(thickness_nm)) = (shading.fixed_stack()?, shading.thickness_nm()) else {
        return Err(refused(shading, no_film()));
    };
    if media.film().as_constant().is_some() && media.base().as_constant().is_some() {
        let cause = "its indices are the same at every wavelength, so that there is nothing to group".to_owned();
        return Err(refused(shading, (cause, "leave out groups".to_owned())));
    }
    Ok((film, media, thickness_nm))
}

fn no_film() -> MethodError {
    ("there is no film to fit".to_owned(), "take a scene with a film on a base of a given index".to_owned())
}

fn refused(shading: &Shading, (cause, help): MethodError) -> ShadingError {
    ShadingError::variant(shading.scene(), shading.variant(), cause, help)
}

/// Checks that the reflectance depends on nothing but the angle and these.
fn only_varies(shading: &Shading, allowed: &[&str], what: &str) -> Result<(), ShadingError> {
    let inputs = shading.inputs(ShadingQuantity::Reflectance).into_iter().map(|input| input.name);
    let varying: Vec<String> =
        inputs.filter(|name| name != "cos_theta1" && !allowed.contains(&name.as_str())).collect();
    if varying.is_empty() {
        return Ok(());
    }
    let besides =
        if allowed.is_empty() { "the angle".to_owned() } else { format!("the angle and {}", allowed.join(", ")) };
    let cause = format!("its reflectance depends on {} besides {besides}", varying.join(", "));
    Err(refused(shading, (cause, format!("{what}: fix these in the scene, or take windowed:k=6"))))
}

/// A table over the angle and the scene's range of thickness.
fn table(shading: &Shading, angles: usize, thicknesses: usize) -> Result<FilmTable, ShadingError> {
    let Some(thickness_nm) = shading.thickness_nm() else { return Err(refused(shading, no_film())) };
    let [thinnest, thickest] = thickness_nm;
    if (thinnest == thickest) != (thicknesses == 1) {
        let cause = format!("its thickness runs from {thinnest} to {thickest} nm");
        let help = "the table of a film of one thickness is table:Wx1, that of a range has 2 thicknesses or more";
        return Err(refused(shading, (cause, help.to_owned())));
    }
    let components = shading.inputs(ShadingQuantity::Reflectance).len();
    let points = FilmTable::points(angles, thicknesses, thickness_nm);
    let points: Vec<Vec<f64>> = points.into_iter().map(|point| point[..components].to_vec()).collect();
    let rows = shading.reference_each(ShadingQuantity::Reflectance, &points)?;
    let doc = format!(
        "Reflectance of the film: {angles} angles, the roots of their cosines from 0 to 1, at each of {thicknesses} \
         thicknesses from {thinnest} to {thickest} nm."
    );
    let colors = Table::new("film_colors", &doc, rows);
    Ok(FilmTable { angles, thicknesses, thickness_nm, colors })
}
