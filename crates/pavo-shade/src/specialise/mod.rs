//! A program for the ranges of its inputs: guards that are proven never to act are left out.
//!
//! A guard (`max`, `min`, `clamp`, `abs`, a comparison) goes where interval arithmetic proves, over all inputs within
//! their ranges, that it always gives the same operand. The bounds allow for the rounding of `f32` on any device
//! ([`Single`]), so that no rounding makes the guard act either. What is left computes the same bits: only what never
//! acts is left out, and what then folds exactly. Outside of the declared ranges nothing guards any more.

mod record;
pub(crate) mod replay;

pub use record::LeftOut;

use crate::bounds::{Fact, proven};
use crate::interval::Single;
use crate::program::Program;
use std::collections::HashMap;

/// A program for the ranges of its inputs, and what it does without.
#[derive(Clone, Debug)]
pub struct Specialised {
    /// The program.
    pub program: Program,
    /// The guards that it was spared, a row for each place in the Rust source.
    pub left_out: Vec<LeftOut>,
}

/// What is proven of the nodes of each function; the body comes last.
pub(crate) type Facts = HashMap<(usize, u32), Vec<Fact>>;

/// The program without the guards that the ranges of its inputs make unnecessary.
pub fn specialise(program: &Program) -> Specialised {
    let claims = proven::<Single>(program);
    if claims.is_empty() {
        return Specialised { program: program.clone(), left_out: Vec::new() };
    }
    let mut facts = Facts::new();
    for claim in &claims {
        facts.entry((claim.function, claim.node)).or_default().push(claim.fact);
    }
    Specialised { program: replay::replay(program, &facts), left_out: record::left_out(program, &claims) }
}
