//! Expressions: the graph as a number type.

use crate::fold;
use crate::function::FunctionInfo;
use crate::graph::{BinaryOp, Comparison, Graph, NodeId, Op, Type, UnaryOp};
use crate::real::{Lanes, Mask, Real, Scalar, Vector};
use crate::table::Table;
use crate::value::{Arguments, LeafInfo, Value, join};
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A constant, or a node of a graph. It stands for a number or for a vector: a scalar is used as a vector with three
/// equal components without being written out as one.
#[derive(Clone, Copy)]
pub enum Expr<'g> {
    /// A constant number, or a vector with this number in each component.
    Literal(f64),
    /// A constant vector.
    Literal3([f64; 3]),
    /// A node of a graph.
    Node(&'g Graph, NodeId),
}

/// A truth value as an expression.
#[derive(Clone, Copy)]
pub enum ExprMask<'g> {
    /// Known at build time.
    Literal(bool),
    /// Known at build time, for each component.
    Literal3([bool; 3]),
    /// Computed at run time.
    Node(Expr<'g>),
}

impl<'g> Expr<'g> {
    /// The type as far as it is known: a literal number counts as a scalar.
    pub fn ty(self) -> Type {
        match self {
            Expr::Literal(_) => Type::Scalar,
            Expr::Literal3(_) => Type::Vec3,
            Expr::Node(graph, id) => graph.ty(id),
        }
    }

    /// The same value written out as a vector.
    #[track_caller]
    pub fn as_vec3(self) -> Self {
        match self {
            Expr::Literal(value) => Expr::Literal3([value; 3]),
            Expr::Node(graph, id) if graph.ty(id) == Type::Scalar => {
                graph.node(Op::Splat(graph.operand(self)), Type::Vec3)
            }
            vector => vector,
        }
    }

    fn graph(self) -> Option<&'g Graph> {
        match self {
            Expr::Node(graph, _) => Some(graph),
            _ => None,
        }
    }

    pub(crate) fn op(self) -> Option<(&'g Graph, Op, NodeId)> {
        match self {
            Expr::Node(graph, id) => Some((graph, graph.op(id), id)),
            _ => None,
        }
    }

    #[track_caller]
    fn unary(self, op: UnaryOp) -> Self {
        if let Some(folded) = fold::unary(op, self) {
            return folded;
        }
        let graph = self.graph().expect("only nodes are left after folding");
        graph.node(Op::Unary(op, graph.operand(self)), self.ty())
    }

    #[track_caller]
    fn binary(self, op: BinaryOp, other: Self) -> Self {
        if let Some(folded) = fold::binary(op, self, other) {
            return folded;
        }
        let graph = self.graph().or(other.graph()).expect("only nodes are left after folding");
        let vector = self.ty() == Type::Vec3 || other.ty() == Type::Vec3;
        let arithmetic = matches!(op, BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide);
        // Arithmetic takes a scalar beside a vector in every language; functions take equal types only.
        let (a, b) = if vector && !arithmetic { (self.as_vec3(), other.as_vec3()) } else { (self, other) };
        let ty = if vector && op != BinaryOp::Dot { Type::Vec3 } else { Type::Scalar };
        graph.node(Op::Binary(op, graph.operand(a), graph.operand(b)), ty)
    }
}

/// Operands widened to the type that they have together.
#[track_caller]
fn widened<'g, const N: usize>(mut operands: [Expr<'g>; N]) -> ([Expr<'g>; N], Type) {
    if operands.iter().all(|operand| operand.ty() != Type::Vec3) {
        return (operands, Type::Scalar);
    }
    for operand in &mut operands {
        *operand = operand.as_vec3();
    }
    (operands, Type::Vec3)
}

macro_rules! operator {
    ($trait:ident, $method:ident, $op:ident) => {
        impl<'g> $trait for Expr<'g> {
            type Output = Self;
            #[track_caller]
            fn $method(self, other: Self) -> Self {
                self.binary(BinaryOp::$op, other)
            }
        }
    };
}

operator!(Add, add, Add);
operator!(Sub, sub, Subtract);
operator!(Mul, mul, Multiply);
operator!(Div, div, Divide);

impl Neg for Expr<'_> {
    type Output = Self;
    #[track_caller]
    fn neg(self) -> Self {
        self.unary(UnaryOp::Negate)
    }
}

impl<'g> Value for Expr<'g> {
    type Leaf = Expr<'g>;
    fn flatten(self, leaves: &mut Vec<Self>) {
        leaves.push(self);
    }
    fn unflatten(leaves: &mut dyn Iterator<Item = Self>) -> Self {
        leaves.next().expect("one leaf per expression")
    }
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
        leaves.push(LeafInfo::new(path, doc));
    }
    fn named(self, name: &str) -> Self {
        if let Expr::Node(graph, id) = self {
            graph.name(id, name);
        }
        self
    }
    fn named_part(self, whole: &str, part: &str) -> Self {
        match self.op() {
            // The results of a call stay together under the name of the struct.
            Some((graph, Op::Result(index, _), id)) => {
                graph.name(NodeId { index, ..id }, whole);
                self
            }
            _ => self.named(&join(whole, part)),
        }
    }
}

impl<'g> Mask for ExprMask<'g> {
    #[track_caller]
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (ExprMask::Literal(true), mask) | (mask, ExprMask::Literal(true)) => mask,
            (ExprMask::Literal(false), _) | (_, ExprMask::Literal(false)) => ExprMask::Literal(false),
            (a, b) => a.combined(BinaryOp::And, b),
        }
    }
    #[track_caller]
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (ExprMask::Literal(false), mask) | (mask, ExprMask::Literal(false)) => mask,
            (ExprMask::Literal(true), _) | (_, ExprMask::Literal(true)) => ExprMask::Literal(true),
            (a, b) => a.combined(BinaryOp::Or, b),
        }
    }
    #[track_caller]
    fn not(self) -> Self {
        match self {
            ExprMask::Literal(value) => ExprMask::Literal(!value),
            ExprMask::Literal3(values) => ExprMask::Literal3(values.map(|value| !value)),
            ExprMask::Node(expr) => {
                let (graph, _, id) = expr.op().expect("a mask that is no literal is a node");
                ExprMask::Node(graph.node(Op::Unary(UnaryOp::Not, graph.operand(expr)), graph.ty(id)))
            }
        }
    }
    fn named(self, name: &str) -> Self {
        if let ExprMask::Node(expr) = self {
            Value::named(expr, name);
        }
        self
    }
}

impl<'g> ExprMask<'g> {
    /// Two masks that are not alike in each component, combined: at least one is a node, or both are constant vectors.
    #[track_caller]
    fn combined(self, op: BinaryOp, other: Self) -> Self {
        let both = |a: bool, b: bool| if op == BinaryOp::And { a & b } else { a | b };
        match (self, other) {
            (ExprMask::Node(a), ExprMask::Node(b)) => ExprMask::Node(a.mask_binary(op, b)),
            (ExprMask::Node(a), constant) => ExprMask::Node(a.mask_binary(op, constant.in_graph_of(a))),
            (constant, ExprMask::Node(b)) => ExprMask::Node(constant.in_graph_of(b).mask_binary(op, b)),
            (a, b) => {
                let (a, b) = (a.components(), b.components());
                fold::literal_mask([both(a[0], b[0]), both(a[1], b[1]), both(a[2], b[2])])
            }
        }
    }

    fn components(self) -> [bool; 3] {
        match self {
            ExprMask::Literal(value) => [value; 3],
            ExprMask::Literal3(values) => values,
            ExprMask::Node(_) => unreachable!("it is a literal"),
        }
    }

    /// A constant mask as a node: the comparison of two constant vectors.
    #[track_caller]
    fn in_graph_of(self, mask: Expr<'g>) -> Expr<'g> {
        let graph = mask.graph().expect("a mask that is no literal is a node");
        let numbers = self.components().map(|value| if value { 0.0 } else { 1.0 });
        let half = graph.operand(Expr::Literal3([0.5; 3]));
        let numbers = graph.operand(Expr::Literal3(numbers));
        graph.node(Op::Compare(Comparison::Less, numbers, half), Type::Mask3)
    }
}

impl<'g> Expr<'g> {
    #[track_caller]
    fn mask_binary(self, op: BinaryOp, other: Self) -> Self {
        let graph = self.graph().expect("a mask that is no literal is a node");
        let vector = self.ty() == Type::Mask3 || other.ty() == Type::Mask3;
        let (a, b) = if vector { (self.as_mask3(), other.as_mask3()) } else { (self, other) };
        let ty = if vector { Type::Mask3 } else { Type::Mask };
        graph.node(Op::Binary(op, graph.operand(a), graph.operand(b)), ty)
    }

    /// The same mask for each component: the comparisons in it, of vectors instead of numbers.
    #[track_caller]
    fn as_mask3(self) -> Self {
        let (graph, op, id) = self.op().expect("a mask that is no literal is a node");
        if graph.ty(id) == Type::Mask3 {
            return self;
        }
        let operand = |index: u32| Expr::Node(graph, NodeId { index, ..id });
        let op = match op {
            Op::Compare(comparison, a, b) => {
                let (a, b) = (operand(a).as_vec3(), operand(b).as_vec3());
                Op::Compare(comparison, graph.operand(a), graph.operand(b))
            }
            Op::Unary(op, a) => Op::Unary(op, graph.operand(operand(a).as_mask3())),
            Op::Binary(op, a, b) => {
                let (a, b) = (operand(a).as_mask3(), operand(b).as_mask3());
                Op::Binary(op, graph.operand(a), graph.operand(b))
            }
            _ => unreachable!("a mask is a comparison or a combination of masks"),
        };
        graph.node(op, Type::Mask3)
    }
}

impl<'g> Real for Expr<'g> {
    type Mask = ExprMask<'g>;

    fn lit(value: f64) -> Self {
        Expr::Literal(value)
    }
    #[track_caller]
    fn sqrt(self) -> Self {
        self.unary(UnaryOp::Sqrt)
    }
    #[track_caller]
    fn inverse_sqrt(self) -> Self {
        self.unary(UnaryOp::InverseSqrt)
    }
    #[track_caller]
    fn sin(self) -> Self {
        self.unary(UnaryOp::Sin)
    }
    #[track_caller]
    fn cos(self) -> Self {
        self.unary(UnaryOp::Cos)
    }
    #[track_caller]
    fn exp(self) -> Self {
        self.unary(UnaryOp::Exp)
    }
    #[track_caller]
    fn abs(self) -> Self {
        self.unary(UnaryOp::Abs)
    }
    #[track_caller]
    fn floor(self) -> Self {
        self.unary(UnaryOp::Floor)
    }
    #[track_caller]
    fn fract(self) -> Self {
        self.unary(UnaryOp::Fract)
    }
    #[track_caller]
    fn half(self) -> Self {
        self.unary(UnaryOp::Half)
    }
    #[track_caller]
    fn min(self, other: Self) -> Self {
        self.binary(BinaryOp::Min, other)
    }
    #[track_caller]
    fn max(self, other: Self) -> Self {
        self.binary(BinaryOp::Max, other)
    }
    #[track_caller]
    fn less_than(self, other: Self) -> ExprMask<'g> {
        if let (Expr::Literal(a), Expr::Literal(b)) = (self, other) {
            return ExprMask::Literal(a < b);
        }
        let ([a, b], ty) = widened([self, other]);
        let graph = a.graph().or(b.graph());
        match graph {
            Some(graph) => {
                let mask = if ty == Type::Vec3 { Type::Mask3 } else { Type::Mask };
                ExprMask::Node(graph.node(Op::Compare(Comparison::Less, graph.operand(a), graph.operand(b)), mask))
            }
            None => fold::compare_literals(a, b),
        }
    }
    #[track_caller]
    fn select(mask: ExprMask<'g>, if_true: Self, if_false: Self) -> Self {
        match mask {
            ExprMask::Literal(true) => if_true,
            ExprMask::Literal(false) => if_false,
            ExprMask::Literal3([x, y, z]) => {
                let (a, b) = (if_true, if_false);
                Self::new(if x { a.x() } else { b.x() }, if y { a.y() } else { b.y() }, if z { a.z() } else { b.z() })
            }
            ExprMask::Node(condition) => {
                if let Some(same) = fold::same(if_true, if_false) {
                    return same;
                }
                let graph = condition.graph().expect("a mask that is no literal is a node");
                let ([if_true, if_false], ty) = if condition.ty() == Type::Mask3 {
                    ([if_true.as_vec3_in(graph), if_false.as_vec3_in(graph)], Type::Vec3)
                } else {
                    widened([if_true, if_false])
                };
                let (if_true, if_false) = (graph.operand(if_true), graph.operand(if_false));
                graph.node(Op::Select(graph.operand(condition), if_true, if_false), ty)
            }
        }
    }
    #[track_caller]
    fn clamp(self, low: Self, high: Self) -> Self {
        let Some(graph) = self.graph() else { return self.max(low).min(high) };
        let ([x, low, high], ty) = widened([self, low, high]);
        graph.node(Op::Clamp(graph.operand(x), graph.operand(low), graph.operand(high)), ty)
    }
    #[track_caller]
    fn mix(a: Self, b: Self, t: Self) -> Self {
        match (t, a.graph().or(b.graph()).or(t.graph())) {
            (Expr::Literal(0.0), _) => a,
            (Expr::Literal(1.0), _) => b,
            (_, Some(graph)) => {
                let ([a, b, t], ty) = widened([a, b, t]);
                graph.node(Op::Mix(graph.operand(a), graph.operand(b), graph.operand(t)), ty)
            }
            (_, None) => a * (Self::lit(1.0) - t) + b * t,
        }
    }

    #[track_caller]
    fn call<A, O>(
        info: &'static FunctionInfo,
        key: impl FnOnce() -> String,
        arguments: A,
        body: impl FnOnce(A) -> O,
    ) -> O
    where
        A: Arguments<Leaf = Self>,
        O: Value<Leaf = Self>,
    {
        let mut leaves = Vec::new();
        arguments.flatten(&mut leaves);
        let Some(graph) = leaves.iter().find_map(|leaf| leaf.graph()) else {
            return body(A::unflatten(&mut leaves.into_iter()));
        };
        let mut results = Vec::new();
        O::describe("", "", &mut results);
        let returned =
            graph.call(info, key(), A::describe(info.parameters), &leaves, results, O::type_name(), |inside| {
                let mut returned = Vec::new();
                body(A::unflatten(&mut inside.into_iter())).flatten(&mut returned);
                returned
            });
        O::unflatten(&mut returned.into_iter())
    }
}

impl<'g> Expr<'g> {
    /// Like [`Expr::as_vec3`], for a value that a vector mask selects.
    #[track_caller]
    fn as_vec3_in(self, graph: &'g Graph) -> Self {
        debug_assert!(self.graph().is_none_or(|own| std::ptr::eq(own, graph)));
        self.as_vec3()
    }
}

impl<'g> Lanes<Expr<'g>> for Expr<'g> {
    fn from_scalar(value: Self) -> Self {
        value
    }
    fn into_vec3(self) -> Self {
        self
    }
}

impl<'g> Scalar for Expr<'g> {
    type Vec3 = Expr<'g>;
    #[track_caller]
    fn fetch(table: &Table, index: Self) -> Self {
        match index {
            Expr::Literal(index) => fold::literal3(table.row(index)),
            Expr::Literal3([index, ..]) => fold::literal3(table.row(index)),
            Expr::Node(graph, _) => graph.node(Op::Fetch(graph.table(table), graph.operand(index)), Type::Vec3),
        }
    }
}

impl<'g> Vector<Expr<'g>> for Expr<'g> {
    #[track_caller]
    fn new(x: Self, y: Self, z: Self) -> Self {
        if let (Expr::Literal(x), Expr::Literal(y), Expr::Literal(z)) = (x, y, z) {
            return fold::literal3([x, y, z]);
        }
        if let Some(same) = fold::same(x, y).and_then(|same| fold::same(same, z)) {
            return same;
        }
        let graph = x.graph().or(y.graph()).or(z.graph()).expect("only nodes are left after folding");
        graph.node(Op::Vec3(graph.operand(x), graph.operand(y), graph.operand(z)), Type::Vec3)
    }
    fn splat(value: Self) -> Self {
        value
    }
    fn lit3(value: [f64; 3]) -> Self {
        fold::literal3(value)
    }
    #[track_caller]
    fn x(self) -> Self {
        self.component(0)
    }
    #[track_caller]
    fn y(self) -> Self {
        self.component(1)
    }
    #[track_caller]
    fn z(self) -> Self {
        self.component(2)
    }
    #[track_caller]
    fn dot(self, other: Self) -> Self {
        // The scalar product of two scalars that stand for vectors still has three terms.
        if self.graph().is_none() && other.graph().is_none() {
            return fold::dot_literals(self, other);
        }
        self.as_vec3().binary(BinaryOp::Dot, other.as_vec3())
    }
    #[track_caller]
    fn normalize(self) -> Self {
        if self.graph().is_none() {
            return fold::normalize_literal(self);
        }
        self.as_vec3().unary(UnaryOp::Normalize)
    }
    #[track_caller]
    fn choose(mask: ExprMask<'g>, if_true: Self, if_false: Self) -> Self {
        Self::select(mask, if_true, if_false)
    }
}

impl<'g> Expr<'g> {
    #[track_caller]
    fn component(self, index: u8) -> Self {
        match self {
            Expr::Literal(_) => self,
            Expr::Literal3(value) => Expr::Literal(value[usize::from(index)]),
            Expr::Node(graph, id) => match (graph.ty(id), graph.op(id)) {
                (Type::Vec3, Op::Vec3(x, y, z)) => {
                    let index = [x, y, z][usize::from(index)];
                    Expr::Node(graph, NodeId { index, ..id })
                }
                (Type::Vec3, _) => graph.node(Op::Component(graph.operand(self), index), Type::Scalar),
                _ => self,
            },
        }
    }
}

impl fmt::Debug for Expr<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Expr::Literal(value) => write!(f, "{value}"),
            Expr::Literal3(value) => write!(f, "{value:?}"),
            Expr::Node(graph, id) => write!(f, "{:?}", graph.op(*id)),
        }
    }
}
