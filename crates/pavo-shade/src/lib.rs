//! The pavo DSL: a shading function is ordinary Rust, generic over its number type.
//!
//! A function written over [`Real`] (or over [`Scalar`], when it also needs colours and directions) runs at once on
//! `f32` and `f64`. Run on [`Expr`], the same function records a [`Graph`], which `pavo-emit` prints as shader text.
//! There is one description; nothing is written twice.
//!
//! # A BRDF of your own
//! ```
//! use pavo_shade::{shade, Graph, Input, Rate, Scalar, Vector, Real};
//!
//! /// Lambert's diffuse reflection and Phong's highlight.
//! ///
//! /// Source: Phong 1975, with the specular lobe left unnormalised as in the paper.
//! #[shade]
//! pub fn lambert_phong<S: Scalar>(
//!     /// Cosine of the angle between normal and light, [0, 1].
//!     n_dot_l: S,
//!     /// Cosine of the angle between mirror direction and view, [-1, 1].
//!     r_dot_v: S,
//!     /// Diffuse colour, linear, [0, 1].
//!     diffuse: S::Vec3,
//! ) -> S::Vec3 {
//!     let highlight = r_dot_v.max(0.0).powi(16);
//!     let reflected = diffuse * (1.0 / core::f64::consts::PI) + S::Vec3::splat(0.04 * highlight);
//!     reflected * n_dot_l
//! }
//!
//! // On the CPU it is a plain function:
//! let colour = lambert_phong::<f32>(1.0, 1.0, glam::Vec3::ONE);
//! assert!((colour.x - 0.358_309_9).abs() < 1e-6);
//!
//! // As a graph it has inputs with names, units and ranges, and is ready to be printed:
//! let graph = Graph::new();
//! let n_dot_l = graph.input(Input::scalar("n_dot_l", "", 0.0, 1.0, Rate::Pixel));
//! let r_dot_v = graph.input(Input::scalar("r_dot_v", "", -1.0, 1.0, Rate::Pixel));
//! let diffuse = graph.input(Input::colour("diffuse", Rate::Material));
//! graph.output("radiance", lambert_phong(n_dot_l, r_dot_v, diffuse).as_vec3());
//! let program = graph.program();
//! assert_eq!(program.functions().len(), 1);
//! ```
//!
//! # What `#[shade]` does
//! 1. A float literal becomes `R::lit(..)`, so that `1.0 - x` reads as it would on `f32`. A literal with a suffix
//!    (`1.0_f64`) and the argument of `lit(..)` stay as they are; `f64` constants by path become literals too.
//! 2. Each `let` carries its name into the emitted code, and so does each assignment.
//! 3. The function keeps its boundary: the emitted code has a function of this name with this doc comment. Arguments
//!    that are literal at the call are folded into the function; `#[runtime]` on a parameter keeps it a parameter
//!    all the same. `#[constant]` marks a build-time parameter of any type (an order, a table of coefficients).
//!
//! On a `struct`, `#[shade]` makes it a [`Value`], which functions take and return; emitted code has the same struct.
//!
//! # Rules
//! - No `if` on values: [`Real::select`]. A Rust `for` unrolls.
//! - Folding is exact: literals are combined in `f64`, and `x + 0`, `x * 1`, `x * 0` (values are taken to be finite),
//!   `x - x`, `-(-x)` and a selection by a known mask disappear. Nothing else is rewritten: no reassociation, no
//!   multiplication by a reciprocal in place of a division.
//! - A guard (`max`, `min`, `clamp`, `abs`, a comparison) is written where the formula needs one; [`specialise`] leaves
//!   out those that never act within the ranges of the inputs, and [`bounds`] says what the values are within. On
//!   [`interval::Interval`] a function gives bounds of its results.
//!
//! # Numbers to judge a function by
//! A function runs on these as well, without a change to it:
//! - [`Dual`] gives derivatives of its results.
//! - [`Emulated`] is `f32` with what drivers do to it: contraction, flushing, inexact sines and quotients.
//! - [`Half`] rounds each operation to half precision.
//!
//! [`evaluate`] computes a recorded program on any of them: what is emitted, and not the function that it comes from.
//! [`evaluate_inexact`] gives its sines, cosines and exponentials errors of any size.
//! # Half precision
//! [`Real::half`] marks what may be held in 16 bits. On the CPU it rounds; emitted WGSL has `f16` there, GLSL 4.50
//! `float16_t` and GLSL ES `mediump`. A sum, difference, product or quotient of numbers held so that is held so itself
//! is one of half precision: rounding it from `f32` gives the same bits, so that the CPU says what a device does.

mod bounds;
mod dual;
pub mod emulated;
mod evaluation;
mod expr;
mod fold;
mod function;
mod graph;
mod half;
pub mod interpret;
pub mod interval;
pub mod naming;
mod native;
mod operations;
mod program;
mod rates;
mod real;
mod specialise;
mod table;
mod triple;
mod value;

pub use bounds::{Bounds, FunctionBounds, bounds, bounds_over};
pub use dual::Dual;
pub use emulated::Emulated;
pub use evaluation::{FunctionErrors, evaluate, evaluate_inexact};
pub use expr::{Expr, ExprMask};
pub use function::{FunctionInfo, Input, ParameterInfo, Rate};
pub use graph::{BinaryOp, Comparison, Graph, Node, NodeId, Op, Type, UnaryOp};
pub use half::Half;
pub use operations::{Operations, is_held_in_half, is_in_half};
pub use pavo_shade_macros::shade;
pub use program::{Definition, Output, Parameter, Program, ReturnValue, operands};
pub use rates::{LEAST_SAVED, OperationsByRate, PREPARED_SURFACE, Prepared, Split, Stages, split, stages};
pub use real::{Lanes, Mask, Real, Scalar, Vector};
pub use specialise::{LeftOut, Specialised, specialise};
pub use table::Table;
pub use triple::Triple;
pub use value::{Arguments, LeafInfo, Value, join};
