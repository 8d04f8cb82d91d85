//! What the values of a scene must satisfy, whether it came from a file or was built in Rust.

use pavo_shade::Rate;

use super::error::SceneError;
use super::fault::{Checked, Fault};
use super::model::{Base, ColourQuantity, Emit, FilmMedium, IlluminantSource, Quantity, Scene, Surface, VisibilityK};
use super::shown::{shown, shown_number};
use super::suggest::did_you_mean;
use super::vocabulary::{
    DELTA_E_LIMITS, FILM_MATERIALS, ILLUMINANTS, INDEX_LIMITS, KAPPA_LIMITS, Limits, MAXIMUM_IDENTIFIER_LENGTH,
    METALNESS_LIMITS, METALS, OBSERVERS, ROUGHNESS_LIMITS, SPACES, TARGETS, THICKNESS_LIMITS, VISIBILITY_LIMITS,
};

impl Scene {
    /// Checks every value of the scene: names, limits, and what must go together.
    ///
    /// # Errors
    /// The first thing that does not hold, by key ([`SceneError::key`]). A scene that came from
    /// [`Scene::from_toml`] or [`Scene::load`] has passed this already.
    pub fn validate(&self) -> Result<(), SceneError> {
        check(self).map_err(|fault| fault.into_error())
    }
}

/// The first fault among the values of `scene`.
pub(super) fn check(scene: &Scene) -> Checked<()> {
    check_name(&scene.name)?;
    check_choice("colour.observer", "observer", &scene.colour.observer, OBSERVERS)?;
    if let IlluminantSource::Named(name) = &scene.colour.illuminant {
        check_choice("colour.illuminant", "illuminant", name, ILLUMINANTS)?;
    }
    check_choice("colour.space", "colour space", &scene.colour.space, SPACES)?;
    check_quantity("ambient.ior", scene.ambient.ior, &INDEX_LIMITS)?;
    if let Some(film) = &scene.film {
        match &film.medium {
            FilmMedium::Index(ior) => check_quantity("film.ior", *ior, &INDEX_LIMITS)?,
            FilmMedium::Material(name) => check_choice("film.material", "film material", name, FILM_MATERIALS)?,
            FilmMedium::Table(_) => {}
        }
        check_quantity("film.thickness_nm", film.thickness_nm, &THICKNESS_LIMITS)?;
    }
    check_base(&scene.base)?;
    check_surface(&scene.surface, &scene.base)?;
    if let Some(max_delta_e) = scene.budget.max_delta_e {
        check_number("budget.max_delta_e", max_delta_e, &DELTA_E_LIMITS)?;
    }
    check_rates(scene)?;
    check_vertex(scene)?;
    check_emit(&scene.emit)
}

/// The name of a scene: a letter, then letters, digits, `-` and `_`.
pub(super) fn check_name(name: &str) -> Checked<()> {
    let fault = |label: &str, message: String| {
        let help = format!(
            "a name starts with a letter from A to Z and goes on with such letters, digits, - and _, \
             at most {MAXIMUM_IDENTIFIER_LENGTH} characters: \"soap-bubble\""
        );
        Err(Fault::at("name", label, message, help))
    };
    let mut characters = name.chars();
    let Some(first) = characters.next() else { return fault("empty", "the name of the scene is empty".to_owned()) };
    if !first.is_ascii_alphabetic() {
        return fault(
            "not a name",
            format!("the name of the scene starts with {first:?}, which is not a letter from A to Z"),
        );
    }
    if let Some(bad) = characters.find(|c| !(c.is_ascii_alphanumeric() || matches!(c, '-' | '_'))) {
        return fault("not a name", format!("the name of the scene contains {bad:?}"));
    }
    if name.len() > MAXIMUM_IDENTIFIER_LENGTH {
        return fault("too long", format!("the name of the scene has {} characters", name.len()));
    }
    Ok(())
}

fn check_choice(path: &str, what: &str, given: &str, allowed: &[&str]) -> Checked<()> {
    if allowed.contains(&given) {
        return Ok(());
    }
    let all = format!("the {what}s are");
    let message = format!("unknown {what} `{}`", shown(given));
    Err(Fault::at(path, format!("unknown {what}"), message, did_you_mean(given, allowed, &all)))
}

fn check_quantity(path: &str, quantity: Quantity, limits: &Limits) -> Checked<()> {
    let (low, high) = match quantity {
        Quantity::Fixed(value) => return check_number(path, value, limits),
        Quantity::Range { low, high } => (low, high),
    };
    check_number(&format!("{path}[0]"), low, limits)?;
    check_number(&format!("{path}[1]"), high, limits)?;
    let key = path.rsplit('.').next().unwrap_or(path);
    let (low_text, high_text) = (shown_number(low), shown_number(high));
    if low > high {
        let message = format!("the range of `{path}` is reversed: it starts at {low_text} and ends at {high_text}");
        return Err(Fault::at(path, "reversed", message, format!("write `{key} = [{high_text}, {low_text}]`")));
    }
    if low == high {
        let message = format!("the range of `{path}` is empty: it starts and ends at {low_text}");
        let help = format!("write the number, `{key} = {low_text}`: what is fixed becomes a constant");
        return Err(Fault::at(path, "empty range", message, help));
    }
    Ok(())
}

fn check_number(path: &str, value: f64, limits: &Limits) -> Checked<()> {
    let Limits { what, low, high, unit, help } = limits;
    let bounds = format!("{what} lies between {} and {}{unit}", shown_number(*low), shown_number(*high));
    if !value.is_finite() {
        let message = format!("`{path}` is not a finite number, but {bounds}");
        return Err(Fault::at(path, "not finite", message, *help));
    }
    if value < *low || value > *high {
        let message = format!("`{path}` is {}, but {bounds}", shown_number(value));
        return Err(Fault::at(path, "out of range", message, *help));
    }
    Ok(())
}

fn check_base(base: &Base) -> Checked<()> {
    match base {
        Base::Dielectric { ior } => check_quantity("base.ior", *ior, &INDEX_LIMITS),
        Base::Conductor { ior, kappa } => {
            check_quantity("base.ior", *ior, &INDEX_LIMITS)?;
            check_quantity("base.kappa", *kappa, &KAPPA_LIMITS)
        }
        Base::Metal { name } => check_choice("base.metal", "metal", name, METALS),
        Base::Table { path } if path.as_os_str().is_empty() => {
            Err(Fault::at("base.csv", "empty", "`base.csv` names no file", "name a file of wavelength, n and k"))
        }
        Base::F0 { f0, edge_tint } => {
            let colours = [("base.f0", Some(*f0)), ("base.edge_tint", *edge_tint)];
            let fixed = colours.into_iter().filter_map(|(path, colour)| Some((path, colour?.fixed()?)));
            fixed.into_iter().try_for_each(|(path, colour)| check_colour(path, colour))
        }
        Base::Table { .. } | Base::Metalness => Ok(()),
    }
}

fn check_surface(surface: &Surface, base: &Base) -> Checked<()> {
    check_quantity("surface.roughness", surface.roughness, &ROUGHNESS_LIMITS)?;
    check_base_color(surface, base)?;
    check_metalness(surface, base)?;
    match surface.visibility_k {
        VisibilityK::Punctual | VisibilityK::ImageBased => Ok(()),
        VisibilityK::Value(k) => check_quantity("surface.visibility_k", k, &VISIBILITY_LIMITS),
    }
}

fn check_base_color(surface: &Surface, base: &Base) -> Checked<()> {
    let path = "surface.base_color";
    let workflow = *base == Base::Metalness;
    match surface.base_color {
        None if workflow || surface.diffuse => {
            let (at, why) = if workflow {
                ("base.workflow", "the metalness workflow")
            } else {
                ("surface.diffuse", "a diffuse surface")
            };
            let message = format!("{why} needs `{path}`, which is missing");
            let help = "add to [surface]: `base_color = [0.1, 0.5, 0.2]` (linear, each within 0 and 1), \
                        or `base_color = \"input\"`";
            Err(Fault::at(at, "needs a base colour", message, help))
        }
        Some(_) if !workflow && !surface.diffuse => {
            let help = "remove `base_color`, or set `diffuse = true` in [surface] or \
                        `workflow = \"metalness\"` in [base]";
            Err(Fault::at(path, "never used", format!("`{path}` has no effect here"), help))
        }
        Some(ColourQuantity::Fixed(colour)) => check_colour(path, colour),
        Some(ColourQuantity::Input) | None => Ok(()),
    }
}

fn check_colour(path: &str, colour: [f64; 3]) -> Checked<()> {
    for (index, component) in colour.into_iter().enumerate() {
        if (0.0..=1.0).contains(&component) {
            continue;
        }
        let help = "colours are linear, from 0 to 1: divide 8-bit values by 255, then undo their sRGB encoding";
        let value = if component.is_finite() { shown_number(component) } else { "not a finite number".to_owned() };
        let path = format!("{path}[{index}]");
        let message = format!("`{path}` is {value}, but a component of a colour lies between 0 and 1");
        return Err(Fault::at(path, "out of range", message, help));
    }
    Ok(())
}

fn check_metalness(surface: &Surface, base: &Base) -> Checked<()> {
    let path = "surface.metalness";
    match (surface.metalness, base) {
        (Some(metalness), Base::Metalness) => check_quantity(path, metalness, &METALNESS_LIMITS),
        (None, Base::Metalness) => {
            let help = "give a metalness, such as an input over [0, 1]";
            Err(Fault::at(path, "missing", format!("the metalness workflow needs `{path}`"), help))
        }
        (Some(_), _) => {
            let message = format!("`{path}` is given, but the base is not of the metalness workflow");
            let help = "remove `metalness`, or write `workflow = \"metalness\"` alone in [base]";
            Err(Fault::at(path, "never used", message, help))
        }
        (None, _) => Ok(()),
    }
}

/// What a scene says of an input.
enum Given {
    /// It is one.
    Input,
    /// It is fixed by this key.
    Fixed(&'static str),
    /// The scene has nothing of the kind.
    Absent,
}

fn check_rates(scene: &Scene) -> Checked<()> {
    for name in scene.rates.keys() {
        let path = format!("rates.{name}");
        match given(scene, name) {
            Some(Given::Input) => {}
            Some(Given::Fixed(key)) => {
                let (_, word) = key.rsplit_once('.').unwrap_or(("", key));
                let is_color = ["base_color", "f0", "edge_tint"].contains(&name.as_str());
                let value = if is_color { "\"input\"" } else { "[low, high]" };
                let message = format!("`{name}` is fixed, so that it has no rate");
                let help = format!("remove this line, or make it an input: `{word} = {value}` at `{key}`");
                return Err(Fault::at(path, "of a fixed value", message, help));
            }
            Some(Given::Absent) => {
                let message = format!("this scene has no `{name}`, so that it has no rate");
                return Err(Fault::at(path, "not in this scene", message, "remove this line").in_key());
            }
            None => return Err(super::read::unknown_input(name).in_key()),
        }
    }
    Ok(())
}

/// What a scene says of the input of this name; nothing where no scene has one of this name.
fn given(scene: &Scene, name: &str) -> Option<Given> {
    let surface = &scene.surface;
    let of = |quantity: Option<Quantity>, key: &'static str| match quantity {
        None => Given::Absent,
        Some(quantity) if quantity.is_input() => Given::Input,
        Some(_) => Given::Fixed(key),
    };
    let of_color = |color: Option<ColourQuantity>, key: &'static str| match color {
        None => Given::Absent,
        Some(ColourQuantity::Input) => Given::Input,
        Some(ColourQuantity::Fixed(_)) => Given::Fixed(key),
    };
    let (base_ior, base_kappa) = match scene.base {
        Base::Dielectric { ior } => (Some(ior), None),
        Base::Conductor { ior, kappa } => (Some(ior), Some(kappa)),
        Base::Metal { .. } | Base::Table { .. } | Base::Metalness | Base::F0 { .. } => (None, None),
    };
    let (f0, edge_tint) = match scene.base {
        Base::F0 { f0, edge_tint } => (Some(f0), edge_tint),
        _ => (None, None),
    };
    let light = if scene.lights.punctual { Given::Input } else { Given::Absent };
    Some(match name {
        "thickness_nm" => of(scene.film.as_ref().map(|film| film.thickness_nm), "film.thickness_nm"),
        "ambient_ior" => of(Some(scene.ambient.ior), "ambient.ior"),
        "film_ior" => match scene.film.as_ref().map(|film| &film.medium) {
            Some(FilmMedium::Index(ior)) => of(Some(*ior), "film.ior"),
            Some(FilmMedium::Material(_) | FilmMedium::Table(_)) => Given::Fixed("film.ior"),
            None => Given::Absent,
        },
        "base_ior" => of(base_ior, "base.ior"),
        "base_kappa" => of(base_kappa, "base.kappa"),
        "roughness" => of(Some(surface.roughness), "surface.roughness"),
        "f0" => of_color(f0, "base.f0"),
        "edge_tint" => of_color(edge_tint, "base.edge_tint"),
        "base_color" => of_color(surface.base_color, "surface.base_color"),
        "metalness" => of(surface.metalness, "surface.metalness"),
        "visibility_k" => match surface.visibility_k {
            VisibilityK::Value(k) => of(Some(k), "surface.visibility_k"),
            VisibilityK::Punctual | VisibilityK::ImageBased => Given::Fixed("surface.visibility_k"),
        },
        "light_color" | "light_intensity" => light,
        _ => return None,
    })
}

/// Values at the vertices need an input there.
fn check_vertex(scene: &Scene) -> Checked<()> {
    if !scene.emit.vertex || scene.rates.values().any(|rate| *rate == Rate::Vertex) {
        return Ok(());
    }
    let message = "`emit.vertex` asks for values at the vertices, but no input changes there";
    let help = "say which input does, as in `[rates]` with `thickness_nm = \"vertex\"`, or leave `vertex` out";
    Err(Fault::at("emit.vertex", "no input at the vertices", message, help))
}

fn check_emit(emit: &Emit) -> Checked<()> {
    if emit.targets.is_empty() {
        let help = format!("list at least one of: {}", TARGETS.join(", "));
        return Err(Fault::at("emit.targets", "empty", "`emit.targets` is empty: nothing would be emitted", help));
    }
    for (index, target) in emit.targets.iter().enumerate() {
        check_choice(&format!("emit.targets[{index}]"), "target", target, TARGETS)?;
        if let Some(earlier) = emit.targets[..index].iter().position(|other| other == target) {
            let message = format!("`emit.targets` lists `{target}` twice");
            let fault = Fault::at(format!("emit.targets[{index}]"), "again here", message, "keep one of the two");
            return Err(fault.and_at(format!("emit.targets[{earlier}]"), "listed here"));
        }
    }
    if emit.variant.trim().is_empty() {
        let help = format!("leave `variant` out for `{}`, or write it in full", super::DEFAULT_VARIANT);
        return Err(Fault::at("emit.variant", "empty", "`emit.variant` is empty", help));
    }
    check_prefix(&emit.prefix)
}

fn check_prefix(prefix: &str) -> Checked<()> {
    let path = "emit.prefix";
    let fault = |message: String| {
        let help = format!(
            "a prefix starts with a letter from a to z and goes on with a to z, 0 to 9 and single underscores, \
             at most {MAXIMUM_IDENTIFIER_LENGTH} characters: \"soap_\""
        );
        Err(Fault::at(path, "not a prefix", message, help))
    };
    let Some(first) = prefix.chars().next() else { return Ok(()) };
    if !first.is_ascii_lowercase() {
        return fault(format!("`{path}` starts with {first:?}, which is not a letter from a to z"));
    }
    if let Some(bad) = prefix.chars().find(|c| !(c.is_ascii_lowercase() || c.is_ascii_digit() || *c == '_')) {
        return fault(format!("`{path}` contains {bad:?}"));
    }
    if prefix.contains("__") {
        return fault(format!("`{path}` has two underscores in a row, which GLSL and WGSL reserve"));
    }
    if prefix.starts_with("gl_") {
        return fault(format!("`{path}` starts with `gl_`, which GLSL reserves"));
    }
    if prefix.len() > MAXIMUM_IDENTIFIER_LENGTH {
        return fault(format!("`{path}` has {} characters", prefix.len()));
    }
    Ok(())
}
