//! The layout of a struct in a uniform buffer, as WGSL and std140 have it: a vector begins at a multiple of 16 bytes, and
//! where there is one, the whole ends at such.

use crate::text::Struct;
use pavo_shade::Type;

/// How many numbers are as long as a vector is aligned.
const ALIGNMENT: usize = 4;

/// How many numbers stand unused before each field, and after the last one.
pub fn padding(made: &Struct) -> Vec<usize> {
    let mut place: usize = 0;
    let mut has_vector = false;
    let mut padding = Vec::new();
    for (_, ty, _) in &made.fields {
        let is_vector = *ty == Type::Vec3;
        let begin = if is_vector { place.next_multiple_of(ALIGNMENT) } else { place };
        padding.push(begin - place);
        place = begin + if is_vector { 3 } else { 1 };
        has_vector |= is_vector;
    }
    padding.push(if has_vector { place.next_multiple_of(ALIGNMENT) - place } else { 0 });
    padding
}

#[cfg(test)]
mod tests {
    use super::padding;
    use crate::text::Struct;
    use pavo_shade::Type::{Scalar, Vec3};

    #[test]
    fn vectors_begin_at_multiples_of_16_bytes() {
        for (types, expected) in [
            (&[Scalar, Scalar][..], &[0, 0, 0][..]),
            (&[Vec3, Scalar, Scalar, Vec3], &[0, 0, 0, 3, 1]),
            (&[Vec3, Vec3], &[0, 1, 1]),
        ] {
            let fields = types.iter().map(|&ty| ("x".to_owned(), ty, String::new())).collect();
            let made = Struct { name: "Prepared".to_owned(), fields, is_prepared: true };
            assert_eq!(padding(&made), expected);
        }
    }
}
