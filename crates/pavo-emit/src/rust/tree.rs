//! An expression on one line, taken apart as far as its layout needs it.

/// How wide the arguments of a call may be on one line, and a chain of methods, as rustfmt has it.
const CALL_WIDTH: usize = 60;
/// How wide a choice may be on one line, as rustfmt has it.
const CHOICE_WIDTH: usize = 50;

/// Operators by how tightly they bind, the loosest first.
const OPERATORS: [&[&str]; 7] = [&["||"], &["&&"], &["<"], &["|"], &["&"], &["+", "-"], &["*", "/"]];

/// An expression with its text on one line.
#[derive(Debug)]
pub struct Tree<'a> {
    pub text: &'a str,
    pub kind: Kind<'a>,
}

/// What an expression is.
#[derive(Debug)]
pub enum Kind<'a> {
    /// A name, a number, a place in a table.
    Atom,
    /// Operands with one operator between them, which binds to the left.
    Operators(&'a str, Vec<Tree<'a>>),
    /// A sign before an operand.
    Signed(Box<Tree<'a>>),
    /// An expression in parentheses.
    Parentheses(Box<Tree<'a>>),
    /// A call: what stands before its parentheses, and the arguments.
    Call(&'a str, Vec<Tree<'a>>),
    /// What methods are called on, and the calls with their points.
    Chain(Box<Tree<'a>>, Vec<Tree<'a>>),
    /// A condition and both values.
    Choice(Box<[Tree<'a>; 3]>),
}

impl<'a> Tree<'a> {
    /// Takes an expression apart.
    pub fn of(text: &'a str) -> Self {
        Self { text, kind: choice(text).or_else(|| operators(text)).unwrap_or_else(|| operand(text)) }
    }

    /// Whether rustfmt leaves it on one line where there is room.
    pub fn is_narrow(&self) -> bool {
        match &self.kind {
            Kind::Atom => true,
            Kind::Operators(_, operands) => operands.iter().all(Tree::is_narrow),
            Kind::Signed(inner) | Kind::Parentheses(inner) => inner.is_narrow(),
            Kind::Call(before, arguments) => {
                self.text.len() <= before.len() + 2 + CALL_WIDTH && arguments.iter().all(Tree::is_narrow)
            }
            Kind::Chain(root, calls) => {
                let is_narrow = calls.len() < 2 || self.text.len() <= CALL_WIDTH;
                is_narrow && root.is_narrow() && calls.iter().all(Tree::is_narrow)
            }
            Kind::Choice(parts) => self.text.len() <= CHOICE_WIDTH && parts.iter().all(Tree::is_narrow),
        }
    }
}

/// The places of a text that are in no brackets.
fn outside(text: &str) -> impl DoubleEndedIterator<Item = usize> {
    let mut depth = 0;
    let mut places = Vec::new();
    for (place, byte) in text.bytes().enumerate() {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth -= 1,
            _ if depth == 0 => places.push(place),
            _ => {}
        }
    }
    places.into_iter()
}

fn choice(text: &str) -> Option<Kind<'_>> {
    let rest = text.strip_prefix("if ")?;
    let (condition, rest) = rest.split_at(rest.find(" { ")?);
    let (if_true, rest) = in_braces(rest.trim_start())?;
    let rest = rest.strip_prefix(" else ")?;
    let if_false = if rest.starts_with("if ") { rest } else { in_braces(rest)?.0 };
    Some(Kind::Choice(Box::new([condition, if_true, if_false].map(Tree::of))))
}

/// What stands in the braces that a text begins with, and what follows them.
fn in_braces(text: &str) -> Option<(&str, &str)> {
    let end = closing(text)?;
    Some((text[1..end].trim(), &text[end + 1..]))
}

/// The place of the bracket that closes the one a text begins with.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    text.bytes().position(|byte| {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth -= 1,
            _ => {}
        }
        depth == 0
    })
}

fn operators(text: &str) -> Option<Kind<'_>> {
    // The last of the loosest operators joins two operands; those on the left with the same one belong to it.
    let found = |operator: &&'static str, place: usize| {
        text[place..]
            .strip_prefix(' ')
            .and_then(|rest| rest.strip_prefix(*operator))
            .is_some_and(|rest| rest.starts_with(' '))
    };
    let last = OPERATORS.iter().find_map(|level| {
        outside(text).rev().find_map(|place| {
            level
                .iter()
                .find(|operator| found(operator, place))
                .map(|operator| (place, &text[place + 1..][..operator.len()]))
        })
    });
    let (place, operator) = last?;
    let left = Tree::of(&text[..place]);
    let right = Tree::of(&text[place + operator.len() + 2..]);
    Some(match left.kind {
        Kind::Operators(same, mut operands) if same == operator => {
            operands.push(right);
            Kind::Operators(operator, operands)
        }
        kind => Kind::Operators(operator, vec![Tree { text: left.text, kind }, right]),
    })
}

fn operand(text: &str) -> Kind<'_> {
    if text.starts_with(['-', '!']) {
        return Kind::Signed(Box::new(Tree::of(&text[1..])));
    }
    // A point of a number stands before a digit, that of a field before no parenthesis.
    let is_method = |place: usize| {
        let name = text[place + 1..].bytes().take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'_').count();
        let is_name = text[place + 1..].starts_with(|first: char| first.is_ascii_lowercase());
        text.as_bytes()[place] == b'.' && is_name && text[place + 1 + name..].starts_with('(')
    };
    let points: Vec<usize> = outside(text).filter(|&place| is_method(place)).collect();
    if let Some(&first) = points.first() {
        let ends = points.iter().skip(1).copied().chain([text.len()]);
        let calls = points.iter().zip(ends).map(|(&begin, end)| call_or_atom(&text[begin..end])).collect();
        return Kind::Chain(Box::new(Tree::of(&text[..first])), calls);
    }
    if text.starts_with('(') && closing(text) == Some(text.len() - 1) {
        return Kind::Parentheses(Box::new(Tree::of(&text[1..text.len() - 1])));
    }
    call_or_atom(text).kind
}

/// A call without anything after its parentheses, or what it is else.
fn call_or_atom(text: &str) -> Tree<'_> {
    let kind = match text.find('(') {
        Some(open) if closing(&text[open..]) == Some(text.len() - open - 1) => {
            let inner = &text[open + 1..text.len() - 1];
            let mut arguments = Vec::new();
            let mut begin = 0;
            for comma in outside(inner).filter(|&place| inner.as_bytes()[place] == b',') {
                arguments.push(Tree::of(inner[begin..comma].trim()));
                begin = comma + 1;
            }
            if !inner.is_empty() {
                arguments.push(Tree::of(inner[begin..].trim()));
            }
            Kind::Call(&text[..open], arguments)
        }
        _ => Kind::Atom,
    };
    Tree { text, kind }
}
