//! `#[shade]` on a function.

use crate::{doc_lines, number_type, rewrite::Body};
use proc_macro2::TokenStream;
use quote::quote;
use syn::visit_mut::VisitMut;
use syn::{FnArg, Ident, ItemFn, Pat};

struct Parameter {
    name: Ident,
    doc: String,
    runtime: bool,
    constant: bool,
}

pub fn expand(mut item: ItemFn) -> syn::Result<TokenStream> {
    let number = number_type(&item.sig.generics)?;
    let doc = doc_lines(&item.attrs);
    let parameters = item.sig.inputs.iter_mut().map(take_parameter).collect::<syn::Result<Vec<Parameter>>>()?;
    let values: Vec<&Parameter> = parameters.iter().filter(|parameter| !parameter.constant).collect();
    if values.is_empty() {
        return Err(syn::Error::new_spanned(&item.sig, "#[shade] needs at least one parameter that is a value"));
    }
    Body { number: &number }.visit_block_mut(&mut item.block);

    let ItemFn { attrs, vis, sig, block, .. } = &item;
    let mut inner = sig.clone();
    inner.ident = Ident::new("body", sig.ident.span());
    let name = sig.ident.to_string();
    let documented = parameters.iter().filter(|parameter| !parameter.doc.is_empty());
    let parameter_docs = documented.map(|parameter| format!("- `{}`: {}", parameter.name, parameter.doc));
    let type_parameters = sig.generics.params.iter().filter_map(|parameter| match parameter {
        syn::GenericParam::Type(parameter) => Some(&parameter.ident),
        syn::GenericParam::Const(parameter) => Some(&parameter.ident),
        syn::GenericParam::Lifetime(_) => None,
    });
    let generic_constants = sig.generics.const_params().map(|parameter| &parameter.ident);
    let generic_types = sig.generics.type_params().map(|parameter| &parameter.ident);
    let all = parameters.iter().map(|parameter| &parameter.name);
    let constants = parameters.iter().filter(|parameter| parameter.constant).map(|parameter| &parameter.name);
    let value_names: Vec<&Ident> = values.iter().map(|parameter| &parameter.name).collect();
    let infos = values.iter().map(|parameter| {
        let (name, doc, runtime) = (parameter.name.to_string(), &parameter.doc, parameter.runtime);
        quote!(::pavo_shade::ParameterInfo { name: #name, doc: #doc, runtime: #runtime })
    });
    // The function's own parameters are all used by the call below, whatever its body does with them.
    Ok(quote! {
        #(#attrs)*
        #[doc = ""]
        #[doc = "# Parameters"]
        #(#[doc = #parameter_docs])*
        #[track_caller]
        #vis #sig {
            #[inline(always)]
            #[allow(clippy::needless_lifetimes, clippy::extra_unused_lifetimes)]
            #inner #block
            static INFO: ::pavo_shade::FunctionInfo = ::pavo_shade::FunctionInfo {
                name: #name,
                module: ::core::module_path!(),
                doc: &[#(#doc),*],
                parameters: &[#(#infos),*],
            };
            <#number as ::pavo_shade::Real>::call(
                &INFO,
                || {
                    ::std::string::String::new()
                        #(+ &::std::format!("{:?};", #constants))*
                        #(+ &::std::format!("{:?};", #generic_constants))*
                        #(+ ::core::any::type_name::<#generic_types>() + ";")*
                },
                (#(#value_names,)*),
                |(#(#value_names,)*)| body::<#(#type_parameters),*>(#(#all),*),
            )
        }
    })
}

/// Takes pavo's own attributes off a parameter.
fn take_parameter(argument: &mut FnArg) -> syn::Result<Parameter> {
    let FnArg::Typed(argument) = argument else {
        return Err(syn::Error::new_spanned(argument, "#[shade] takes free functions only, without `self`"));
    };
    let Pat::Ident(pattern) = &*argument.pat else {
        return Err(syn::Error::new_spanned(&argument.pat, "a parameter of a #[shade] function is a plain name"));
    };
    let has = |name: &str| argument.attrs.iter().any(|attribute| attribute.path().is_ident(name));
    let parameter = Parameter {
        name: pattern.ident.clone(),
        doc: doc_lines(&argument.attrs).join(" "),
        runtime: has("runtime"),
        constant: has("constant"),
    };
    let own = ["runtime", "constant", "doc"];
    argument.attrs.retain(|attribute| !own.iter().any(|name| attribute.path().is_ident(name)));
    Ok(parameter)
}
