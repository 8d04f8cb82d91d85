//! The pages, from the templates in `templates/report`. What is put into them is escaped for HTML.

use crate::cli::failure::Failure;
use minijinja::syntax::SyntaxConfig;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value};

const TEMPLATES: [(&str, &str); 4] = [
    ("page.html", include_str!("../../../../../templates/report/page.html")),
    ("scene.html", include_str!("../../../../../templates/report/scene.html")),
    ("gallery.html", include_str!("../../../../../templates/report/gallery.html")),
    ("style.css", include_str!("../../../../../templates/report/style.css")),
];

/// Fills a template.
pub fn render(template: &str, values: Value) -> Result<String, Failure> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment
        .set_auto_escape_callback(|name| if name.ends_with(".css") { AutoEscape::None } else { AutoEscape::Html });
    environment.add_filter("fixed", |value: f64, digits: usize| format!("{value:.digits$}"));
    environment.add_filter("difference", difference);
    environment.add_filter("scientific", |value: f64| format!("{value:.1e}"));
    environment.add_filter("significant", |value: f64, digits: usize| significant(value, digits));
    let text = SyntaxConfig::builder()
        .trim_blocks(true)
        .lstrip_blocks(true)
        .build()
        .map(|syntax| environment.set_syntax(syntax))
        .and_then(|()| TEMPLATES.into_iter().try_for_each(|(name, text)| environment.add_template(name, text)))
        .and_then(|()| environment.get_template(template)?.render(values));
    text.map_err(|error| Failure::check(format!("the page cannot be made: {error:#}")))
}

/// A dE2000: with three decimals, or with an exponent where those would be zeros.
fn difference(value: f64) -> String {
    if value > 0.0 && value < 5e-4 { format!("{value:.0e}") } else { format!("{value:.3}") }
}

/// A number with so many significant digits, without idle zeros; with an exponent where it is very small or large.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&magnitude) {
        return format!("{value:.*e}", digits.saturating_sub(1));
    }
    let decimals = usize::try_from(digits as i32 - 1 - magnitude).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn numbers_are_short() {
        let cases =
            [(0.0, "0"), (1234.56, "1235"), (0.012_345, "0.0123"), (2.0, "2"), (1.05e-7, "1.05e-7"), (0.5, "0.5")];
        for (value, expected) in cases {
            assert_eq!(significant(value, 3), expected);
        }
    }
}
