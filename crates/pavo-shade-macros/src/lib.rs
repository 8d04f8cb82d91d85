//! The `#[shade]` attribute; see the documentation of `pavo-shade` for what it does and how to use it.

mod function;
mod rewrite;
mod structure;

use proc_macro::TokenStream;
use quote::ToTokens;

/// On a function: a shading function, generic over `Real` or `Scalar`. On a struct: a value that such functions take
/// and return; `#[shade(flat)]` names its parts without the name of the whole.
#[proc_macro_attribute]
pub fn shade(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let expanded = match syn::parse::<syn::Item>(item) {
        Ok(syn::Item::Fn(item)) if attribute.is_empty() => function::expand(item),
        Ok(syn::Item::Struct(item)) => structure::expand(item, attribute.into()),
        Ok(other) => Err(syn::Error::new_spanned(
            other.to_token_stream(),
            "#[shade] goes on a function or on a struct with named fields; only on a struct does it take `(flat)`",
        )),
        Err(error) => Err(error),
    };
    expanded.unwrap_or_else(|error| error.to_compile_error()).into()
}

/// The lines of the doc comments among the attributes.
fn doc_lines(attributes: &[syn::Attribute]) -> Vec<String> {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    });
    lines.flat_map(|text| text.split('\n').map(|line| line.trim().to_owned()).collect::<Vec<_>>()).collect()
}

/// The type parameter that is bounded by `Real` or `Scalar`.
fn number_type(generics: &syn::Generics) -> syn::Result<syn::Ident> {
    let is_number = |bound: &syn::TypeParamBound| match bound {
        syn::TypeParamBound::Trait(bound) => {
            bound.path.segments.last().is_some_and(|segment| segment.ident == "Real" || segment.ident == "Scalar")
        }
        _ => false,
    };
    generics
        .type_params()
        .find(|parameter| parameter.bounds.iter().any(is_number))
        .map(|parameter| parameter.ident.clone())
        .ok_or_else(|| {
            syn::Error::new_spanned(
                generics,
                "#[shade] needs a type parameter for the number type: `<R: Real>`, or `<S: Scalar>` where vectors are used",
            )
        })
}
