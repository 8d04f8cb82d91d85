//! `pavo fit`: fits of sensitivities, and of one scene's reflectance.

use super::arguments::{self, FitCommand};
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::spectrum;
use super::work;
use crate::fitting::form;
use crate::media::MediaError;
use crate::scene::Scene;
use crate::shading::Shading;
use crate::variant::{FittedForm, Variant};
use pavo_fit::scene::{SceneFit, SceneFitError, SceneFitRequest, fit_scene};
use pavo_fit::sensitivity::{FitRequest, fit};
use pavo_spectra::fits::text::write;

/// Makes the fit that was asked for.
pub fn run(command: &FitCommand) -> Result<(), Failure> {
    match command {
        FitCommand::Sensitivities(arguments) => sensitivities(arguments),
        FitCommand::Scene(arguments) => scene(arguments),
    }
}

fn sensitivities(arguments: &arguments::FitSensitivities) -> Result<(), Failure> {
    work::TERMS.check(&format!("`--count {}`", arguments.count), arguments.count)?;
    let sensitivities = spectrum::sensitivities(&arguments.spectrum)?;
    let request = FitRequest {
        family: arguments.family.into(),
        count: arguments.count as usize,
        observer: sensitivities.observer(),
        illuminant: sensitivities.illuminant().clone(),
        space: sensitivities.space(),
        max_opd_um: arguments.max_opd_um,
        seed: arguments.seed,
    };
    let progress = Progress::start();
    progress.step(format!("fitting {} {}", request.count, request.family.name()));
    let made = fit(&request).map_err(|error| Failure::input(error, "change --count or --max-opd-um"))?;
    drop(progress);
    let text = if arguments.json {
        format!("{:#}\n", serde_json::json!(made))
    } else {
        format!(
            "# {} of the sensitivities of {} under {} in {}, seed {}.\n# Largest error of the transform {:.2e}, RMS {:.2e}, \
             up to {} um. The columns are those of the fits in pavo-spectra/data/fits.\n{}",
            request.family.name(),
            request.observer.name(),
            request.illuminant.name(),
            request.space.name(),
            request.seed,
            made.max_error,
            made.rms_error,
            made.max_opd_um,
            write(&made)
        )
    };
    output::write_or_print(arguments.output.as_deref(), text.as_bytes())
}

fn scene(arguments: &arguments::FitScene) -> Result<(), Failure> {
    work::WAVES.check(&format!("`--count {}`", arguments.count), arguments.count)?;
    let scene = Scene::load(&arguments.scene)?;
    let wanted = arguments.form.map(FittedForm::from);
    // Any method will do: the media and the ranges are what is needed of the surface.
    let shading = Shading::new(&scene, &Variant::Spectral { count: 81 })?;
    let varying: Vec<String> = shading
        .inputs(crate::inputs::ShadingQuantity::Reflectance)
        .into_iter()
        .map(|input| input.name)
        .filter(|name| name != "cos_theta1" && name != "thickness_nm")
        .collect();
    let (Some(media), Some(thickness_nm), true) = (shading.fixed_stack()?, shading.thickness_nm(), varying.is_empty())
    else {
        let besides = if varying.is_empty() { String::new() } else { format!(": {} vary", varying.join(", ")) };
        return Err(Failure::input(
            format!("{} is no film of fixed indices{besides}", scene.name),
            "a fit to a scene needs a film, and a number or a material for each index",
        ));
    };
    let request = SceneFitRequest {
        ambient_ior: media.ambient_ior(),
        film: media.film().clone(),
        base: media.base().clone(),
        thickness_nm,
        sensitivities: shading.sensitivities(),
        form: wanted.map(form),
        nodes: arguments.count as usize,
        seed: arguments.seed,
        rms_error: arguments.max_rms,
        max_error: arguments.max_error,
    };
    let progress = Progress::start();
    progress.step(format!("fitting {}", scene.name));
    let made = fit_scene(&request).map_err(failure)?;
    drop(progress);
    let text = if arguments.json { json(&made) } else { report(&scene, &made) };
    output::write_or_print(arguments.output.as_deref(), text.as_bytes())
}

/// A fit that misses its error is a check that failed; anything else is bad input.
fn failure(error: SceneFitError) -> Failure {
    match error {
        SceneFitError::Missed { .. } => Failure::check(error),
        _ => MediaError::Data { message: error.to_string() }.into(),
    }
}

fn json(fit: &SceneFit) -> String {
    let value = serde_json::json!({
        "form": fit.form.name(),
        "rms": fit.rms,
        "max": fit.max,
        "held_out_points": fit.points,
        "cost": fit.cost,
        "film": fit.film,
    });
    format!("{value:#}\n")
}

fn report(scene: &Scene, fit: &SceneFit) -> String {
    let film = &fit.film;
    let [thinnest, thickest] = film.thickness_nm;
    format!(
        "{}: {} with {} waves, for {thinnest} to {thickest} nm\n\
         on {} points that the fit did not see, in f32: RMS {:.2e}, max {:.2e}\n\
         about {} operations, with roots, reciprocals, exponentials and cosines as 4\n\n\
         Emit it with --variant fitted:form={},k={}; its coefficients are printed by --json.\n",
        scene.name,
        fit.form.name(),
        film.nodes.len(),
        fit.points,
        fit.rms,
        fit.max,
        fit.cost,
        fit.form.name(),
        film.nodes.len().max(1),
    )
}
