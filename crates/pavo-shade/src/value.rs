//! What functions take and return: numbers, vectors, arrays, and structs marked `#[shade]`.

use crate::function::ParameterInfo;

/// The name of a leaf and what it means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeafInfo {
    /// Its name in emitted code.
    pub name: String,
    /// Meaning, unit and range in one line.
    pub doc: String,
}

impl LeafInfo {
    /// A leaf that is named as a whole.
    pub fn new(name: &str, doc: &str) -> Self {
        Self { name: name.to_owned(), doc: doc.to_owned() }
    }

    /// The meaning of a part: that of the whole, then its own.
    pub fn part_doc(whole: &str, part: &str) -> String {
        if whole.is_empty() {
            return part.to_owned();
        }
        let first = part.chars().next().map(|first| first.to_lowercase().to_string()).unwrap_or_default();
        let rest: String = part.chars().skip(1).collect();
        format!("{}; {first}{rest}", whole.trim_end_matches('.'))
    }
}

/// A value made of leaves: single numbers natively, scalar or vector nodes in the graph.
pub trait Value: Sized {
    /// The type of a leaf.
    type Leaf: Copy;

    /// Appends the leaves in order.
    fn flatten(self, leaves: &mut Vec<Self::Leaf>);
    /// Takes the leaves off again, in the same order.
    fn unflatten(leaves: &mut dyn Iterator<Item = Self::Leaf>) -> Self;
    /// Appends a name and a meaning for each leaf, made from those of the whole.
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>);
    /// The name of the struct, when it has one.
    fn type_name() -> Option<&'static str> {
        None
    }
    /// The value, with this name carried into emitted code. Plain numbers have none.
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        let _ = name;
        self
    }
    /// The value as a field of a struct of this name.
    #[inline(always)]
    fn named_part(self, whole: &str, part: &str) -> Self {
        let _ = (whole, part);
        self
    }
}

impl<T: Value, const N: usize> Value for [T; N] {
    type Leaf = T::Leaf;
    fn flatten(self, leaves: &mut Vec<T::Leaf>) {
        self.into_iter().for_each(|element| element.flatten(leaves));
    }
    fn unflatten(leaves: &mut dyn Iterator<Item = T::Leaf>) -> Self {
        core::array::from_fn(|_| T::unflatten(leaves))
    }
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
        for index in 0..N {
            T::describe(&join(path, &format!("v{index}")), doc, leaves);
        }
    }
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        let mut index = 0;
        self.map(|element| {
            let element = element.named(&format!("{name}_v{index}"));
            index += 1;
            element
        })
    }
}

/// The arguments of a function: a tuple of values.
pub trait Arguments: Sized {
    /// The type of a leaf, the same for all arguments.
    type Leaf: Copy;
    /// Appends the leaves of all arguments.
    fn flatten(self, leaves: &mut Vec<Self::Leaf>);
    /// Takes the leaves off again.
    fn unflatten(leaves: &mut dyn Iterator<Item = Self::Leaf>) -> Self;
    /// For each leaf, the index of its parameter and what it is.
    fn describe(parameters: &[ParameterInfo]) -> Vec<(usize, LeafInfo)>;
}

macro_rules! arguments {
    ($first:ident $(, $rest:ident)*) => {
        impl<$first: Value $(, $rest: Value<Leaf = $first::Leaf>)*> Arguments for ($first, $($rest,)*) {
            type Leaf = $first::Leaf;
            #[allow(non_snake_case)]
            fn flatten(self, leaves: &mut Vec<Self::Leaf>) {
                let ($first, $($rest,)*) = self;
                $first.flatten(leaves);
                $($rest.flatten(leaves);)*
            }
            fn unflatten(leaves: &mut dyn Iterator<Item = Self::Leaf>) -> Self {
                ($first::unflatten(leaves), $($rest::unflatten(leaves),)*)
            }
            fn describe(parameters: &[ParameterInfo]) -> Vec<(usize, LeafInfo)> {
                let describers: &[fn(&str, &str, &mut Vec<LeafInfo>)] = &[$first::describe, $($rest::describe),*];
                let mut described = Vec::new();
                for (index, (parameter, describe)) in parameters.iter().zip(describers).enumerate() {
                    let mut leaves = Vec::new();
                    describe(parameter.name, parameter.doc, &mut leaves);
                    described.extend(leaves.into_iter().map(|leaf| (index, leaf)));
                }
                described
            }
        }
    };
}

arguments!(A);
arguments!(A, B);
arguments!(A, B, C);
arguments!(A, B, C, D);
arguments!(A, B, C, D, E);
arguments!(A, B, C, D, E, F);
arguments!(A, B, C, D, E, F, G);
arguments!(A, B, C, D, E, F, G, H);
arguments!(A, B, C, D, E, F, G, H, I);
arguments!(A, B, C, D, E, F, G, H, I, J);
arguments!(A, B, C, D, E, F, G, H, I, J, K);
arguments!(A, B, C, D, E, F, G, H, I, J, K, L);
arguments!(A, B, C, D, E, F, G, H, I, J, K, L, M);
arguments!(A, B, C, D, E, F, G, H, I, J, K, L, M, N);
arguments!(A, B, C, D, E, F, G, H, I, J, K, L, M, N, O);
arguments!(A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P);

/// The name of a part of a value: `path_part`, or the part alone where the whole has no name.
pub fn join(path: &str, part: &str) -> String {
    if path.is_empty() { part.to_owned() } else { format!("{path}_{part}") }
}
