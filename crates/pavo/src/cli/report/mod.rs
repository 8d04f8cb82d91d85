//! `pavo report`: what is known of a scene's variants and of the one that is picked, as one page.

mod commands;
mod description;
mod figures;
mod frontier;
mod gallery;
mod label;
mod page;
mod pictures;
mod plots;
mod scene_page;
mod stability;
mod survey;
mod worst;

use super::arguments;
use super::cache::DiskCache;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::work;
use crate::scene::Scene;
use pavo_check::Device;
use pavo_files::shown;
use std::path::{Path, PathBuf};
use survey::{Request, Survey, survey};

/// The page of a scene, and that of the gallery.
const PAGE: &str = "index.html";

/// Reports on each scene: the page of one in the folder itself, those of several in folders of their own.
pub fn run(arguments: &arguments::Report) -> Result<(), Failure> {
    if let Some(limit) = arguments.max_delta_e.filter(|limit| !(limit.is_finite() && *limit > 0.0)) {
        return Err(Failure::input(format!("a budget of {limit}"), "a budget is a number above 0"));
    }
    let count = arguments.scenes.len();
    work::SCENES.check(&format!("a report on {count} files"), count as f64)?;
    let requests = requests(arguments)?;
    let device = if arguments.no_run { None } else { Some(Device::lavapipe()?) };
    output::make_folder(&arguments.output)?;
    let cache = DiskCache::open();
    let progress = Progress::start();
    let mut surveys = Vec::new();
    for request in &requests {
        let survey = survey(request, device.as_ref(), &cache, &progress)?;
        write(&folder(&arguments.output, &request.scene, requests.len()), &survey, requests.len() > 1)?;
        surveys.push(survey);
    }
    if surveys.len() > 1 {
        output::write(&arguments.output.join(PAGE), gallery::page(&surveys)?.as_bytes())?;
    }
    drop(progress);
    if arguments.json {
        output::print(&(json(&surveys)? + "\n"))?;
    } else {
        let lines = surveys.iter().map(|survey| line(survey, &arguments.output, surveys.len()));
        output::print(&lines.collect::<String>())?;
        if surveys.len() > 1 {
            output::print(&format!("{}\n", arguments.output.join(PAGE).display()))?;
        }
    }
    let failed: Vec<&str> = surveys.iter().filter_map(|survey| survey.figures.not_picked.as_deref()).collect();
    if failed.is_empty() { Ok(()) } else { Err(Failure::check(failed.join("\n"))) }
}

/// The scenes, all of which are read before anything is measured.
fn requests(arguments: &arguments::Report) -> Result<Vec<Request>, Failure> {
    let mut requests: Vec<Request> = Vec::new();
    for path in &arguments.scenes {
        let (scene, text) = Scene::load_with_text(path)?;
        if let Some(other) = requests.iter().find(|other| other.scene.name == scene.name) {
            return Err(Failure::input(
                format!("{} and {} are both called {}", shown(&other.path), shown(path), scene.name),
                "give each scene of a gallery a name of its own",
            ));
        }
        requests.push(Request { path: path.clone(), text, scene, max_delta_e: arguments.max_delta_e });
    }
    Ok(requests)
}

fn folder(output: &Path, scene: &Scene, count: usize) -> PathBuf {
    if count > 1 { output.join(&scene.name) } else { output.to_owned() }
}

/// Writes the files of a scene; the page comes last, when all that it speaks of is there.
fn write(folder: &Path, survey: &Survey<'_>, in_gallery: bool) -> Result<(), Failure> {
    let page = scene_page::page(survey, in_gallery)?;
    let figures = json(std::slice::from_ref(survey))? + "\n";
    output::make_folder(folder)?;
    for plot in &survey.plots {
        output::write(&folder.join(plot.file), plot.svg.as_bytes())?;
    }
    output::write(&folder.join(worst::FILE), survey.worst_points.as_bytes())?;
    output::write(&folder.join("report.json"), figures.as_bytes())?;
    output::write(&folder.join(PAGE), page.as_bytes())
}

/// The figures of one scene, or those of several as a list.
fn json(surveys: &[Survey<'_>]) -> Result<String, Failure> {
    let text = match surveys {
        [survey] => serde_json::to_string_pretty(&survey.figures),
        _ => serde_json::to_string_pretty(&surveys.iter().map(|survey| &survey.figures).collect::<Vec<_>>()),
    };
    text.map_err(|error| Failure::check(format!("the figures cannot be written: {error}")))
}

fn line(survey: &Survey<'_>, output: &Path, count: usize) -> String {
    let figures = &survey.figures;
    let page = folder(output, figures.scene, count).join(PAGE);
    let what = if figures.picked.is_some() { "picked" } else { "closest" };
    format!(
        "{}: {what} {}, max dE2000 {:.3}, RMS {:.2e} on {} other points: {}\n",
        figures.scene.name,
        figures.shown.variant,
        figures.shown.verified_max_delta_e,
        figures.shown.verified_rms,
        figures.verified_points,
        page.display()
    )
}
