//! From a parsed TOML document to a scene.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pavo_shade::Rate;
use toml::de::{DeTable, DeValue};

use super::fault::{Checked, Fault};
use super::model::{
    Ambient, Base, Budget, Colour, ColourQuantity, Emit, Film, FilmMedium, IlluminantSource, Lights, Precision,
    Quantity, Scene, Surface, VisibilityK,
};
use super::places::key_text;
use super::shown::shown;
use super::suggest::did_you_mean;
use super::table::{Table, numbers, wrong_type};
use super::vocabulary::{PRECISIONS, RATED_INPUTS, RATES, VISIBILITY_NAMES, WORKFLOWS};

const FILM_HELP: &str =
    "a film has `ior` (or `material`, or `csv`) and `thickness_nm`; for a surface without a film leave `[film]` out";

const CONDUCTOR_HELP: &str = "a conductor has both parts of its index, as in `ior = 2.7` and `kappa = 3.8`";

/// The scene that `document` describes; a relative path in it is joined to `directory`.
///
/// The shape is checked here (keys, types, lengths, which keys go together); the values are not.
pub(super) fn read(document: &DeTable<'_>, directory: &Path) -> Checked<Scene> {
    let top = Table::top(document)?;
    let name = top.string("name")?.ok_or_else(missing_name)?;
    let colour = top.table("colour")?;
    let ambient = top.table("ambient")?;
    let film = top.table("film")?;
    let base = top.table("base")?;
    let surface = top.table("surface")?;
    let lights = top.table("lights")?;
    let budget = top.table("budget")?;
    let rates = top.table("rates")?;
    let emit = top.table("emit")?;

    let base = read_base(&base.ok_or_else(missing_base)?, directory)?;
    Ok(Scene {
        name: name.to_owned(),
        colour: colour.map_or_else(|| Ok(Colour::default()), |table| read_colour(&table, directory))?,
        ambient: ambient.map_or_else(|| Ok(Ambient::default()), |table| read_ambient(&table))?,
        film: film.map(|table| read_film(&table, directory)).transpose()?,
        surface: read_surface(surface.as_ref(), &base)?,
        base,
        lights: lights.map_or_else(|| Ok(Lights::default()), |table| read_lights(&table))?,
        budget: budget.map_or_else(|| Ok(Budget::default()), |table| read_budget(&table))?,
        rates: rates.map_or_else(|| Ok(BTreeMap::new()), |table| read_rates(&table))?,
        emit: emit.map_or_else(|| Ok(Emit::default()), |table| read_emit(&table))?,
    })
}

fn missing_name() -> Box<Fault> {
    Fault::at("name", "`name` goes here", "the scene has no name", "start the file with `name = \"soap-bubble\"`")
}

fn missing_base() -> Box<Fault> {
    let help = format!("add a table `[base]` with one of: {}", kinds_of_base());
    Fault::at("base", "`[base]` is missing", "the scene does not say what the surface is made of", help)
}

fn kinds_of_base() -> &'static str {
    "`ior` (a dielectric), `ior` and `kappa` (a conductor), `metal` (such as Au, Al, Ti, Si), \
     `csv` (a file of wavelength, n, k), `workflow = \"metalness\"`, \
     `workflow = \"f0\"` and `f0` (what it reflects at normal incidence)"
}

fn read_colour(table: &Table<'_>, directory: &Path) -> Checked<Colour> {
    let default = Colour::default();
    let string = |key, default| table.string(key).map(|given| given.map_or(default, ToOwned::to_owned));
    Ok(Colour {
        observer: string("observer", default.observer)?,
        illuminant: read_illuminant(table, directory)?.unwrap_or(default.illuminant),
        space: string("space", default.space)?,
    })
}

fn read_illuminant(table: &Table<'_>, directory: &Path) -> Checked<Option<IlluminantSource>> {
    match (table.string("illuminant")?, table.string("illuminant_csv")?) {
        (None, None) => Ok(None),
        (Some(name), None) => Ok(Some(IlluminantSource::Named(name.to_owned()))),
        (None, Some(file)) => csv_path("colour.illuminant_csv", file, directory).map(IlluminantSource::Table).map(Some),
        (Some(_), Some(_)) => {
            let message = "`[colour]` gives the illuminant twice: by `illuminant` and by `illuminant_csv`";
            let help =
                "keep one of `illuminant` (a standard one) and `illuminant_csv` (a file of wavelength and value)";
            let fault = Fault::at("colour.illuminant_csv", "and again here", message, help).in_key();
            Err(fault.and_at("colour.illuminant", "given here"))
        }
    }
}

fn read_ambient(table: &Table<'_>) -> Checked<Ambient> {
    Ok(table.quantity("ior")?.map_or_else(Ambient::default, |ior| Ambient { ior }))
}

fn read_film(table: &Table<'_>, directory: &Path) -> Checked<Film> {
    let given: Vec<&str> = ["ior", "material", "csv"].into_iter().filter(|key| table.has(key)).collect();
    let medium = match given[..] {
        ["material"] => FilmMedium::Material(table.string("material")?.unwrap_or_default().to_owned()),
        ["csv"] => FilmMedium::Table(csv_path("film.csv", table.string("csv")?.unwrap_or_default(), directory)?),
        [first, .., last] => {
            let message = format!("`[film]` describes the material more than once: by `{first}` and by `{last}`");
            let help = "keep one of `ior` (a number or a range), `material` (a built-in one) and `csv` (a file)";
            let fault = Fault::at(format!("film.{last}"), "and again here", message, help).in_key();
            return Err(fault.and_at(format!("film.{first}"), "described here"));
        }
        _ => FilmMedium::Index(table.required_quantity("ior", FILM_HELP)?),
    };
    Ok(Film { medium, thickness_nm: table.required_quantity("thickness_nm", FILM_HELP)? })
}

fn read_base(table: &Table<'_>, directory: &Path) -> Checked<Base> {
    let given: Vec<&str> = ["ior", "kappa", "metal", "csv", "workflow"].into_iter().filter(|k| table.has(k)).collect();
    if !given.contains(&"workflow") {
        check_belongs_to_f0(table)?;
    }
    match given[..] {
        ["ior"] => Ok(Base::Dielectric { ior: table.required_quantity("ior", CONDUCTOR_HELP)? }),
        ["ior", "kappa"] => {
            let ior = table.required_quantity("ior", CONDUCTOR_HELP)?;
            match table.required_quantity("kappa", CONDUCTOR_HELP)? {
                Quantity::Fixed(0.0) => Ok(Base::Dielectric { ior }),
                kappa => Ok(Base::Conductor { ior, kappa }),
            }
        }
        ["kappa"] => {
            let message = "`base.kappa` is given without `base.ior`";
            Err(Fault::at("base.kappa", "needs `ior` beside it", message, CONDUCTOR_HELP))
        }
        ["metal"] => Ok(Base::Metal { name: table.string("metal")?.unwrap_or_default().to_owned() }),
        ["csv"] => {
            let file = table.string("csv")?.unwrap_or_default();
            Ok(Base::Table { path: csv_path("base.csv", file, directory)? })
        }
        [] => {
            let message = "`[base]` does not say what the material is";
            Err(Fault::at("base", "no material", message, format!("give one of: {}", kinds_of_base())))
        }
        [first, .., last] => {
            let kinds = given.iter().map(|key| format!("by `{key}`")).collect::<Vec<_>>().join(", ");
            // The two parts of one index are one way.
            let kinds = kinds.replace("by `ior`, by `kappa`", "by `ior` and `kappa`");
            let message = format!("`[base]` describes the material more than once: {kinds}");
            let help = format!("keep one of these: {}", kinds_of_base());
            let fault = Fault::at(format!("base.{last}"), "and again here", message, help).in_key();
            Err(fault.and_at(format!("base.{first}"), "described here"))
        }
        // Of the five keys only `workflow` is left.
        [_] => read_workflow(table),
    }
}

/// What belongs to the workflow `f0` is given without it.
fn check_belongs_to_f0(table: &Table<'_>) -> Checked<()> {
    let Some(key) = ["f0", "edge_tint"].into_iter().find(|key| table.has(key)) else { return Ok(()) };
    let path = table.path(key);
    let message = format!("`{path}` is given, but the base is not of the workflow `f0`");
    let help = format!("remove `{key}`, or write `workflow = \"f0\"` in place of what else describes the material");
    Err(Fault::at(path, "belongs to `workflow = \"f0\"`", message, help).in_key())
}

fn csv_path(key: &str, file: &str, directory: &Path) -> Checked<PathBuf> {
    if file.trim().is_empty() {
        let help = "name a file beside the scene, as in `csv = \"nickel.csv\"`, of wavelength, n and k";
        return Err(Fault::at(key, "empty", format!("`{key}` names no file"), help));
    }
    Ok(directory.join(file))
}

fn read_workflow(table: &Table<'_>) -> Checked<Base> {
    let workflow = table.string("workflow")?.unwrap_or_default();
    if workflow == "metalness" {
        check_belongs_to_f0(table)?;
        return Ok(Base::Metalness);
    }
    if workflow == "f0" {
        let read = |key| table.value(key).map(|value| read_color(table, key, value)).transpose();
        let Some(f0) = read("f0")? else {
            let message = "the workflow `f0` needs `base.f0`, which is missing";
            let help = "add to [base] what it reflects at normal incidence under air: `f0 = [1.0, 0.71, 0.29]` (linear, \
                        each within 0 and 1), or `f0 = \"input\"`";
            return Err(Fault::at("base.workflow", "needs `f0` beside it", message, help));
        };
        return Ok(Base::F0 { f0, edge_tint: read("edge_tint")? });
    }
    let help = did_you_mean(workflow, WORKFLOWS, "the workflows are");
    Err(Fault::at("base.workflow", "unknown workflow", format!("unknown workflow `{}`", shown(workflow)), help))
}

fn read_surface(table: Option<&Table<'_>>, base: &Base) -> Checked<Surface> {
    let mut surface = Surface::default();
    if *base == Base::Metalness {
        surface.metalness = Some(Surface::DEFAULT_METALNESS);
    }
    let Some(table) = table else { return Ok(surface) };
    surface.roughness = table.quantity("roughness")?.unwrap_or(surface.roughness);
    surface.diffuse = table.boolean("diffuse")?.unwrap_or(surface.diffuse);
    surface.base_color = table.value("base_color").map(|value| read_color(table, "base_color", value)).transpose()?;
    surface.metalness = table.quantity("metalness")?.or(surface.metalness);
    surface.visibility_k = read_visibility_k(table)?.unwrap_or(surface.visibility_k);
    Ok(surface)
}

fn read_color(table: &Table<'_>, key: &str, value: &DeValue<'_>) -> Checked<ColourQuantity> {
    let path = table.path(key);
    let path = path.as_str();
    let help = format!("write `{key} = [0.1, 0.5, 0.2]` (linear, each within 0 and 1), or `{key} = \"input\"`");
    let help = help.as_str();
    match value {
        DeValue::String(text) if text == "input" => Ok(ColourQuantity::Input),
        DeValue::String(text) => {
            let message = format!("`{path}` is the string `{}`, but the only word it takes is `input`", shown(text));
            Err(Fault::at(path, "not a colour", message, help))
        }
        DeValue::Array(list) => {
            numbers(list, path, "a colour has three: red, green and blue", help).map(ColourQuantity::Fixed)
        }
        other => Err(wrong_type(other, path, "a colour [r, g, b] or \"input\"", help)),
    }
}

fn read_visibility_k(table: &Table<'_>) -> Checked<Option<VisibilityK>> {
    let key = "visibility_k";
    let Some(DeValue::String(name)) = table.value(key) else {
        return Ok(table.quantity(key)?.map(VisibilityK::Value));
    };
    match name.as_ref() {
        "punctual" => Ok(Some(VisibilityK::Punctual)),
        "ibl" => Ok(Some(VisibilityK::ImageBased)),
        other => {
            let help = did_you_mean(other, VISIBILITY_NAMES, "besides a number or a range within 0 and 1, it takes");
            let message = format!("unknown visibility k `{}`", shown(other));
            Err(Fault::at(table.path(key), "unknown name", message, help))
        }
    }
}

fn read_lights(table: &Table<'_>) -> Checked<Lights> {
    Ok(table.boolean("punctual")?.map_or_else(Lights::default, |punctual| Lights { punctual }))
}

fn read_budget(table: &Table<'_>) -> Checked<Budget> {
    let Some(quantity) = table.quantity("max_delta_e")? else { return Ok(Budget::default()) };
    match quantity {
        Quantity::Fixed(max_delta_e) => Ok(Budget { max_delta_e: Some(max_delta_e) }),
        Quantity::Range { .. } => {
            let message = "`budget.max_delta_e` is a range, but a budget is one number";
            Err(Fault::at("budget.max_delta_e", "not one number", message, "write `max_delta_e = 1.0`"))
        }
    }
}

fn read_rates(table: &Table<'_>) -> Checked<BTreeMap<String, Rate>> {
    let mut rates = BTreeMap::new();
    for key in table.keys() {
        if !RATED_INPUTS.contains(&key) {
            return Err(unknown_input(key).in_key());
        }
        let name = table.string(key)?.unwrap_or_default();
        let Some(rate) = Rate::ALL.into_iter().find(|rate| rate.name() == name) else {
            let message = format!("unknown rate `{}`", shown(name));
            return Err(Fault::at(
                table.path(key),
                "unknown rate",
                message,
                did_you_mean(name, RATES, "the rates are"),
            ));
        };
        rates.insert(key.to_owned(), rate);
    }
    Ok(rates)
}

/// The fault of a rate for an input that no scene has.
pub(super) fn unknown_input(name: &str) -> Box<Fault> {
    let key = key_text(name);
    let message = format!("unknown input `{}` in [rates]", shown(&key));
    let help = did_you_mean(name, RATED_INPUTS, "the inputs with a rate are");
    Fault::at(format!("rates.{key}"), "unknown input", message, help)
}

fn read_emit(table: &Table<'_>) -> Checked<Emit> {
    let default = Emit::default();
    let targets = table.strings("targets")?;
    Ok(Emit {
        targets: targets.map_or(default.targets, |list| list.into_iter().map(str::to_owned).collect()),
        variant: table.string("variant")?.map_or(default.variant, str::to_owned),
        prefix: table.string("prefix")?.map_or(default.prefix, str::to_owned),
        prepare: table.boolean("prepare")?.unwrap_or(default.prepare),
        vertex: table.boolean("vertex")?.unwrap_or(default.vertex),
        precision: table.string("precision")?.map_or(Ok(default.precision), read_precision)?,
    })
}

fn read_precision(name: &str) -> Checked<Precision> {
    match name {
        "full" => Ok(Precision::Full),
        "half" => Ok(Precision::Half),
        _ => {
            let help = did_you_mean(name, PRECISIONS, "the precisions are");
            let message = format!("unknown precision `{}`", shown(name));
            Err(Fault::at("emit.precision", "unknown precision", message, help))
        }
    }
}
