//! Expressions as text, with no more parentheses than their meaning needs. `a + (b + c)` keeps its own, since sums are
//! rounded in the order in which they are written.

use crate::dialect::{Dialect, Syntax};
use crate::function::Local;
use crate::literal::number;
use crate::passing::PassedStruct;
use crate::rust;
use crate::text::PrintedTable;
use pavo_shade::{BinaryOp, Comparison, Definition, Op, Type, UnaryOp};

/// How tightly an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    Choice,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Unary,
    Primary,
}

impl Binding {
    pub fn tighter(self) -> Binding {
        match self {
            Binding::Choice => Binding::Or,
            Binding::Or => Binding::And,
            Binding::And => Binding::Comparison,
            Binding::Comparison => Binding::Sum,
            Binding::Sum => Binding::Product,
            Binding::Product => Binding::Unary,
            Binding::Unary | Binding::Primary => Binding::Primary,
        }
    }
}

/// Prints the expressions of one function.
pub struct Expressions<'a> {
    pub dialect: &'a Dialect,
    pub definition: &'a Definition,
    /// What stands for each node: a name, or nothing where the expression is written out.
    pub locals: &'a [Local],
    /// The names of the called functions.
    pub functions: &'a [String],
    /// The program's tables.
    pub tables: &'a [PrintedTable],
    /// The fields of the structs that called functions return, empty where they return one value.
    pub fields: &'a [Vec<String>],
    /// The structs that each function takes in place of their fields.
    pub passed: &'a [Vec<PassedStruct>],
    /// Whether the expression is one of half precision.
    pub in_half: bool,
}

impl Expressions<'_> {
    /// The text of a node where an expression may stand on its own.
    pub fn whole(&self, index: u32) -> String {
        self.at_least(index, Binding::Choice)
    }

    /// The text that computes a node, even where a name stands for it.
    pub fn computed(&self, index: u32) -> (String, Binding) {
        let node = &self.definition.nodes[index as usize];
        if self.dialect.syntax == Syntax::Rust
            && let Some(written) = self.in_rust(node)
        {
            return written;
        }
        if let Op::Unary(UnaryOp::Half, operand) = node.op {
            return self.held_in_half(operand, node.ty);
        }
        if self.dialect.syntax.fills_by_braces()
            && let Some(written) = self.in_parts(node)
        {
            return written;
        }
        let call = |name: &str, operands: &[u32]| {
            let operands: Vec<String> = operands.iter().map(|&operand| self.whole(operand)).collect();
            (format!("{name}({})", operands.join(", ")), Binding::Primary)
        };
        match node.op {
            Op::Literal(bits) => self.literal(f64::from_bits(bits)),
            Op::Literal3(bits) => (self.vector(bits.map(f64::from_bits)), Binding::Primary),
            Op::Parameter(_) => (self.name(index), Binding::Primary),
            Op::Unary(op @ (UnaryOp::Negate | UnaryOp::Not), operand) => self.negation(op, operand, node.ty),
            Op::Unary(op, operand) => call(self.dialect.function_name(op), &[operand]),
            Op::Binary(op, a, b) => match op {
                BinaryOp::Add => self.sum(a, b, false),
                BinaryOp::Subtract => self.sum(a, b, true),
                BinaryOp::Multiply => self.infix("*", Binding::Product, a, b),
                BinaryOp::Divide => self.infix("/", Binding::Product, a, b),
                BinaryOp::And => self.logic("&&", "&", Binding::And, a, b, node.ty),
                BinaryOp::Or => self.logic("||", "|", Binding::Or, a, b, node.ty),
                BinaryOp::Min => call("min", &[a, b]),
                BinaryOp::Max => call("max", &[a, b]),
                BinaryOp::Dot => call("dot", &[a, b]),
            },
            Op::Compare(Comparison::Less, a, b) => match (self.dialect.syntax, node.ty) {
                (Syntax::C, Type::Mask3) => call("lessThan", &[a, b]),
                _ => self.infix("<", Binding::Comparison, a, b),
            },
            Op::Select(condition, if_true, if_false) => self.select(condition, if_true, if_false),
            Op::Clamp(x, low, high) => call("clamp", &[x, low, high]),
            Op::Mix(a, b, t) => call(self.dialect.mix, &[a, b, t]),
            Op::Vec3(x, y, z) => call(self.dialect.type_name(Type::Vec3), &[x, y, z]),
            Op::Splat(value) => call(self.dialect.type_name(Type::Vec3), &[value]),
            Op::Fetch(table, row) => {
                let row = self.whole(row);
                (format!("{}[{}({row})]", self.tables[table as usize].name, self.dialect.index_type), Binding::Primary)
            }
            Op::Component(vector, component) => {
                let component = ["x", "y", "z"][usize::from(component)];
                (format!("{}.{component}", self.at_least(vector, Binding::Primary)), Binding::Primary)
            }
            Op::Call(callee, arguments) => self.call(callee, &self.definition.calls[arguments as usize]),
            Op::Result(called, result) => self.result(called, result),
        }
    }

    pub fn at_least(&self, index: u32, binding: Binding) -> String {
        if !self.in_half && self.is_half(index) && self.dialect.half.as_ref().is_some_and(|half| half.converts) {
            let ty = self.definition.nodes[index as usize].ty;
            return format!("{}({})", self.dialect.type_name(ty), self.with_half(true).whole(index));
        }
        if let Local::Named { .. } = self.locals[index as usize] {
            return self.name(index);
        }
        let (text, own) = self.computed(index);
        if own < binding { format!("({text})") } else { text }
    }

    fn name(&self, index: u32) -> String {
        match &self.locals[index as usize] {
            Local::Named { name, .. } => name.clone(),
            Local::Written => unreachable!("a parameter and a call of several results have names"),
        }
    }

    fn result(&self, called: u32, result: u32) -> (String, Binding) {
        let Op::Call(callee, _) = self.definition.nodes[called as usize].op else {
            unreachable!("a result is of a call")
        };
        match self.fields[callee as usize].get(result as usize) {
            Some(field) => (format!("{}.{field}", self.name(called)), Binding::Primary),
            None => self.computed(called),
        }
    }

    /// A call; fields that are passed together are passed as their struct.
    fn call(&self, callee: u32, arguments: &[u32]) -> (String, Binding) {
        let passed = &self.passed[callee as usize];
        let mut texts = Vec::new();
        for (index, &argument) in arguments.iter().enumerate() {
            match passed.iter().find(|taken| taken.fields.iter().any(|(leaf, _)| *leaf == index)) {
                None => texts.push(self.whole(argument)),
                Some(taken) if taken.fields[0].0 == index => match self.definition.nodes[argument as usize].op {
                    Op::Result(called, _) => texts.push(self.name(called)),
                    // A field of a struct that this function took: the struct is what stands before the point.
                    _ => texts.push(self.name(argument).split('.').next().unwrap_or_default().to_owned()),
                },
                Some(_) => {}
            }
        }
        (format!("{}({})", self.functions[callee as usize], texts.join(", ")), Binding::Primary)
    }

    fn infix(&self, operator: &str, binding: Binding, a: u32, b: u32) -> (String, Binding) {
        (format!("{} {operator} {}", self.at_least(a, binding), self.at_least(b, binding.tighter())), binding)
    }

    /// A sum or a difference. What is added with a minus sign is subtracted: the same value.
    fn sum(&self, a: u32, b: u32, subtract: bool) -> (String, Binding) {
        if let (Local::Written, Op::Literal(bits)) = (&self.locals[b as usize], self.definition.nodes[b as usize].op)
            && f64::from_bits(bits) < 0.0
        {
            let operator = if subtract { "+" } else { "-" };
            let positive = self.literal(-f64::from_bits(bits)).0;
            let text = format!("{} {operator} {positive}", self.at_least(a, Binding::Sum));
            return (text, Binding::Sum);
        }
        self.infix(if subtract { "-" } else { "+" }, Binding::Sum, a, b)
    }

    fn negation(&self, op: UnaryOp, operand: u32, ty: Type) -> (String, Binding) {
        if op == UnaryOp::Not && ty == Type::Mask3 && self.dialect.syntax == Syntax::C {
            return (format!("not({})", self.whole(operand)), Binding::Primary);
        }
        let sign = if op == UnaryOp::Not { "!" } else { "-" };
        (format!("{sign}{}", self.at_least(operand, Binding::Primary)), Binding::Unary)
    }

    fn logic(&self, scalar: &str, vector: &str, binding: Binding, a: u32, b: u32, ty: Type) -> (String, Binding) {
        match (self.dialect.syntax, ty) {
            (_, Type::Mask) => {
                // WGSL does not mix `&&` and `||` without parentheses.
                let operand = |index: u32| self.at_least(index, Binding::Comparison);
                (format!("{} {scalar} {}", operand(a), operand(b)), binding)
            }
            (Syntax::Wgsl | Syntax::Rust, _) => {
                let operand = |index: u32| self.at_least(index, Binding::Primary);
                (format!("{} {vector} {}", operand(a), operand(b)), binding)
            }
            _ => {
                // GLSL has no operator for this: a choice between the two.
                let (a, b) = (self.whole(a), self.whole(b));
                let text = if vector == "&" {
                    format!("mix(bvec3(false), {b}, {a})")
                } else {
                    format!("mix({b}, bvec3(true), {a})")
                };
                (text, Binding::Primary)
            }
        }
    }

    fn select(&self, condition: u32, if_true: u32, if_false: u32) -> (String, Binding) {
        let by_component = self.definition.nodes[condition as usize].ty == Type::Mask3;
        let [if_true_text, if_false_text] = [if_true, if_false].map(|index| self.whole(index));
        match (self.dialect.syntax, by_component) {
            (Syntax::Wgsl, _) => {
                (format!("select({if_false_text}, {if_true_text}, {})", self.whole(condition)), Binding::Primary)
            }
            (Syntax::C, true) => {
                (format!("mix({if_false_text}, {if_true_text}, {})", self.whole(condition)), Binding::Primary)
            }
            (Syntax::C | Syntax::Hlsl | Syntax::Osl, false) => {
                let operand = |index: u32| self.at_least(index, Binding::Or);
                let text = format!("{} ? {} : {}", operand(condition), operand(if_true), operand(if_false));
                (text, Binding::Choice)
            }
            (Syntax::Rust | Syntax::Hlsl | Syntax::Osl, _) => unreachable!("they have their own ways to choose"),
        }
    }
}

/// A constant vector.
pub fn vector(dialect: &Dialect, components: [f64; 3]) -> String {
    let name = dialect.type_name(Type::Vec3);
    let [x, y, z] = components.map(|component| literal(dialect, component).0);
    match dialect.syntax {
        Syntax::Rust => rust::vector(name, [&x, &y, &z]),
        Syntax::Hlsl => format!("{name}({x}, {y}, {z})"),
        _ if x == y && y == z => format!("{name}({x})"),
        _ => format!("{name}({x}, {y}, {z})"),
    }
}

/// A constant number.
pub fn literal(dialect: &Dialect, value: f64) -> (String, Binding) {
    let text = if dialect.syntax == Syntax::Rust { rust::number(value) } else { number(value) };
    (text, if value.is_sign_negative() { Binding::Unary } else { Binding::Primary })
}
