//! What was measured, as text and as a table of values.

use crate::failure::Failure;
use crate::measure::{ClassReport, Cost, Report, Row};
use std::fmt::Write;

/// The report for people: a Markdown table for each class, and what pavo has to reach.
pub fn text(report: &Report) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        text.push_str(&line);
        text.push('\n');
    };
    let packages = report.packages.iter().map(|package| format!("{} {}", package.package, package.version));
    line(format!("{}: pavo {}, {}.", report.date, report.pavo, packages.collect::<Vec<_>>().join(", ")));
    line(format!("Errors and times on {}.", report.device));
    line(format!("Costs by {}.", report.compilers.join(" and ")));
    let threads = report.lavapipe_threads.as_deref();
    let threads =
        threads.map_or("as many threads as it likes".to_owned(), |threads| format!("LP_NUM_THREADS={threads}"));
    line(format!(
        "Times of {} points in {} rounds by turns, {threads}; medians, and quartiles of the ratio.",
        report.timed_points, report.rounds
    ));
    line(
        "Costs (instructions / inverse throughput) and times are net of an empty shader with the same inputs. All \
         indices are inputs at run time."
            .to_owned(),
    );
    line(
        "Early returns: errors are those of the text as it is shipped; costs and times those of the text without its \
         early return."
            .to_owned(),
    );
    for class in &report.classes {
        line(format!("\n{}", table(class)));
        for row in &class.rows {
            if let Some(with_exit) = &row.navi21.net_with_exit {
                let name = &row.name;
                line(format!("{name} with its early return: {} on navi21.", counts(with_exit)));
            }
        }
    }
    for reason in &report.left_out {
        line(format!("Left out: {reason}."));
    }
    line(String::new());
    for outcome in &report.musts {
        line(outcome.line());
    }
    text
}

fn table(class: &ClassReport) -> String {
    let mut text = format!(
        "| {}, {} points | max | RMS | mean dE2000 | navi21 | navi21 ratio | vega10 ratio | lavapipe | lavapipe ratio |\n\
         |---|---|---|---|---|---|---|---|---|\n",
        class.class.name(),
        class.points
    );
    for Row { name, errors, navi21, vega10, lavapipe, .. } in &class.rows {
        let Cost { net, ratio, .. } = navi21;
        let time = lavapipe.map_or("- | -".to_owned(), |time| {
            let [low, high] = [time.ratio_lower_quartile, time.ratio_upper_quartile];
            format!("{:.1} ns | {:.2} ({low:.2} to {high:.2})", time.nanoseconds, time.ratio)
        });
        let name = name.strip_prefix("pavo ").map_or(name.clone(), |variant| format!("`{variant}`"));
        let _ = writeln!(
            text,
            "| {name} | {:.3} | {:.5} | {:.2} | {} | {ratio:.2} | {:.2} | {time} |",
            errors.max,
            errors.rms,
            errors.mean_delta_e,
            counts(net),
            vega10.ratio
        );
    }
    text
}

fn counts(net: &pavo_check::static_cost::NetCost) -> String {
    format!("{} / {}", net.instructions, net.inverse_throughput)
}

/// All rows as CSV.
///
/// # Errors
/// If a row cannot be written.
pub fn csv(report: &Report) -> Result<Vec<u8>, Failure> {
    let broken = |error: csv::Error| Failure::Text(format!("the table cannot be written: {error}"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer
        .write_record([
            "class",
            "system",
            "max",
            "rms",
            "rms_clamped",
            "mean_de2000",
            "navi21_instructions",
            "navi21_inverse_throughput",
            "navi21_ratio",
            "vega10_instructions",
            "vega10_inverse_throughput",
            "vega10_ratio",
            "lavapipe_ns",
            "lavapipe_ratio",
        ])
        .map_err(broken)?;
    for class in &report.classes {
        for row in &class.rows {
            let errors = &row.errors;
            let mut fields = vec![class.class.name().to_owned(), row.name.clone()];
            fields.extend(
                [errors.max, errors.rms, errors.rms_clamped, errors.mean_delta_e].map(|value| format!("{value:.6e}")),
            );
            for cost in [&row.navi21, &row.vega10] {
                fields.push(cost.net.instructions.to_string());
                fields.push(cost.net.inverse_throughput.to_string());
                fields.push(format!("{:.4}", cost.ratio));
            }
            let time = row.lavapipe.map(|time| [time.nanoseconds, time.ratio].map(|value| format!("{value:.4}")));
            fields.extend(time.unwrap_or_default());
            writer.write_record(&fields).map_err(broken)?;
        }
    }
    writer.into_inner().map_err(|error| Failure::Text(format!("the table cannot be written: {error}")))
}
