//! Statements over several lines, as rustfmt breaks them by default.

use super::tree::{Kind, Tree};
use crate::text::WIDTH;

/// How far a block stands in.
const STEP: usize = 4;

/// A statement on one line, broken where it has to be, inside the function's block; the place it was written at follows.
pub fn statement(text: &str, place: &str) -> String {
    let base = STEP + text.len() - text.trim_start().len();
    let text = text.trim_start();
    if text.ends_with('{') || text == "}" {
        return format!("{}{text}{place}\n", spaces(base));
    }
    let (before, value, after) = parts(text);
    let tree = Tree::of(value);
    let same = rendered(&tree, base, base + before.len(), after.len());
    let written = if same.contains('\n') && !before.is_empty() {
        let next = rendered(&tree, base + STEP, base + STEP, after.len());
        if is_better_below(&same, &next) {
            format!("{}\n{}{next}", before.trim_end(), spaces(base + STEP))
        } else {
            format!("{before}{same}")
        }
    } else {
        format!("{before}{same}")
    };
    format!("{}{written}{after}{place}\n", spaces(base))
}

/// What stands before a value, the value, and what ends the statement.
fn parts(text: &str) -> (&str, &str, &str) {
    let end = text.trim_end_matches([';', ',']).len();
    let (text, after) = text.split_at(end);
    let is_name = |part: &str| part.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let assigned = [" = ", " += ", " -= ", " *= "].iter().find_map(|sign| {
        let place = text.find(sign)?;
        let name = text[..place].trim_start_matches("let ").trim_start_matches("mut ");
        is_name(name).then_some(place + sign.len())
    });
    let field = || text.find(": ").filter(|&place| is_name(&text[..place])).map(|place| place + 2);
    let (before, value) = text.split_at(assigned.or_else(field).unwrap_or(0));
    (before, value, after)
}

/// Whether a value that takes several lines stands better below what it is assigned to.
fn is_better_below(same: &str, next: &str) -> bool {
    let lines = |text: &str| text.matches('\n').count();
    let opens = |text: &str| text.lines().next().is_some_and(|line| line.ends_with(['(', '{']));
    lines(next) == 0 || lines(same) > lines(next) + 1 || (opens(same) && !opens(next))
}

fn spaces(count: usize) -> String {
    " ".repeat(count)
}

/// An expression that begins at a column of a block; so many characters follow on its last line.
fn rendered(tree: &Tree<'_>, block: usize, column: usize, after: usize) -> String {
    if tree.is_narrow() && column + tree.text.len() + after <= WIDTH {
        return tree.text.to_owned();
    }
    match &tree.kind {
        Kind::Atom => tree.text.to_owned(),
        Kind::Signed(inner) => tree.text[..1].to_owned() + &rendered(inner, block, column + 1, after),
        Kind::Parentheses(inner) => format!("({})", rendered(inner, block, column + 1, after + 1)),
        Kind::Call(before, arguments) => call(before, arguments, block, column, after),
        Kind::Chain(root, calls) => chain(root, calls, block, column, after),
        Kind::Operators(operator, operands) => operators(operator, operands, block, column, after),
        Kind::Choice(parts) => choice(parts, block, column),
    }
}

fn call(before: &str, arguments: &[Tree<'_>], block: usize, column: usize, after: usize) -> String {
    if let [only] = arguments
        && matches!(only.kind, Kind::Call(..) | Kind::Chain(..))
    {
        return format!("{before}({})", rendered(only, block, column + before.len() + 1, after + 1));
    }
    let inner = block + STEP;
    let lines = arguments.iter().map(|argument| format!("{}{},\n", spaces(inner), rendered(argument, inner, inner, 1)));
    format!("{before}(\n{}{})", lines.collect::<String>(), spaces(block))
}

fn chain(root: &Tree<'_>, calls: &[Tree<'_>], block: usize, column: usize, after: usize) -> String {
    let inner = block + STEP;
    if let [only] = calls {
        let root = rendered(root, block, column, after);
        let fits_below = only.is_narrow() && inner + only.text.len() + after <= WIDTH;
        if fits_below && !root.contains('\n') && root.len() > STEP {
            return format!("{root}\n{}{}", spaces(inner), only.text);
        }
        let column = if root.contains('\n') { block + 1 } else { column + root.len() };
        return root + &rendered(only, block, column, after);
    }
    let root = rendered(root, block, column, 0);
    // After several lines the calls follow the last one.
    let inner = if root.contains('\n') { block } else { inner };
    let lines = calls.iter().map(|call| format!("\n{}{}", spaces(inner), rendered(call, inner, inner, after)));
    root + &lines.collect::<String>()
}

fn operators(operator: &str, operands: &[Tree<'_>], block: usize, column: usize, after: usize) -> String {
    let Some((last, others)) = operands.split_last() else { return String::new() };
    let inner = block + STEP;
    let prefix: String = others.iter().map(|operand| format!("{} {operator} ", operand.text)).collect();
    if prefix.len() <= STEP && !last.text.starts_with('(') && others.iter().all(Tree::is_narrow) {
        return prefix.clone() + &rendered(last, block, column + prefix.len(), after);
    }
    let offset = inner + operator.len() + 1;
    let mut text = String::new();
    for (index, operand) in operands.iter().enumerate() {
        let end = if index + 1 == operands.len() { after } else { 0 };
        let width = text.lines().last().map_or(0, str::len) + if text.contains('\n') { 0 } else { column };
        if index == 0 {
            text = rendered(operand, block, column, 0);
        } else if width <= inner {
            // Nothing stands alone on a line that is as short as the block is deep.
            text = format!("{text} {operator} {}", rendered(operand, block, width + operator.len() + 2, end));
        } else {
            text = format!("{text}\n{}{operator} {}", spaces(inner), rendered(operand, inner, offset, end));
        }
    }
    text
}

fn choice([condition, if_true, if_false]: &[Tree<'_>; 3], block: usize, column: usize) -> String {
    let inner = block + STEP;
    let condition = rendered(condition, block, column + 3, 2);
    let if_true = rendered(if_true, inner, inner, 0);
    let otherwise = match if_false.kind {
        Kind::Choice(_) => rendered(if_false, block, block + 7, 0),
        _ => format!("{{\n{}{}\n{}}}", spaces(inner), rendered(if_false, inner, inner, 0), spaces(block)),
    };
    format!("if {condition} {{\n{}{if_true}\n{}}} else {otherwise}", spaces(inner), spaces(block))
}

#[cfg(test)]
mod tests {
    use super::statement;

    #[test]
    fn statements_break_as_rustfmt_breaks_them() {
        // Each case is what rustfmt makes of its lines joined.
        for expected in [
            "    let a = b + c;\n",
            "    let hidden = if cosine < 0.0 { Vec3::ZERO } else { radiance };\n",
            "    let visibility =\n        smith_schlick_over_cosine(n_dot_l, k) * smith_schlick_over_cosine(n_dot_v, k) * 0.25;\n",
            "    let mut color = 1.0\n        - (series_s.transmittance + series_p.transmittance) * 0.5\n        - Vec3::new(2.6062503, -0.779572, 0.044753853) * wave;\n",
            "    let brdf = surface_brdf(\n        n_dot_l,\n        n_dot_v,\n        n_dot_h,\n        cos_theta1,\n        thickness_nm,\n        roughness,\n    );\n",
        ] {
            let joined: Vec<&str> = expected.lines().map(str::trim).collect();
            let flat = joined.join(" ").replace("( ", "(").replace(", )", ")");
            assert_eq!(statement(&flat, ""), expected);
        }
    }
}
