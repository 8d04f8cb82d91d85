//! `#[shade]` on a struct.

use crate::{doc_lines, number_type};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Fields, ItemStruct};

pub fn expand(item: ItemStruct, attribute: TokenStream) -> syn::Result<TokenStream> {
    let flat = match attribute.to_string().as_str() {
        "" => false,
        "flat" => true,
        _ => return Err(syn::Error::new_spanned(attribute, "#[shade] on a struct takes nothing or `flat`")),
    };
    let number = number_type(&item.generics)?;
    let Fields::Named(fields) = &item.fields else {
        return Err(syn::Error::new_spanned(item.to_token_stream(), "#[shade] needs a struct with named fields"));
    };
    let name = &item.ident;
    let text = name.to_string();
    let (generics, arguments, clause) = item.generics.split_for_impl();
    let fields: Vec<_> = fields.named.iter().collect();
    let names: Vec<_> = fields.iter().filter_map(|field| field.ident.as_ref()).collect();
    let types: Vec<_> = fields.iter().map(|field| &field.ty).collect();
    let texts: Vec<String> = names.iter().map(ToString::to_string).collect();
    let docs: Vec<String> = fields.iter().map(|field| doc_lines(&field.attrs).join(" ")).collect();
    let paths = texts
        .iter()
        .map(|field| if flat { quote!(#field.to_owned()) } else { quote!(::pavo_shade::join(path, #field)) });
    let part_docs =
        docs.iter().map(|part| if flat { quote!(#part) } else { quote!(::pavo_shade::LeafInfo::part_doc(doc, #part)) });
    Ok(quote! {
        #[derive(Clone, Copy, Debug)]
        #item

        impl #generics ::pavo_shade::Value for #name #arguments #clause {
            type Leaf = <#number as ::pavo_shade::Value>::Leaf;
            fn flatten(self, leaves: &mut ::std::vec::Vec<Self::Leaf>) {
                #(::pavo_shade::Value::flatten(self.#names, leaves);)*
            }
            fn unflatten(leaves: &mut dyn ::core::iter::Iterator<Item = Self::Leaf>) -> Self {
                #(let #names = ::pavo_shade::Value::unflatten(leaves);)*
                Self { #(#names),* }
            }
            fn describe(
                path: &str,
                doc: &str,
                leaves: &mut ::std::vec::Vec<::pavo_shade::LeafInfo>,
            ) {
                let _ = (path, doc);
                #(<#types as ::pavo_shade::Value>::describe(&#paths, &#part_docs, leaves);)*
            }
            fn type_name() -> ::core::option::Option<&'static str> {
                ::core::option::Option::Some(#text)
            }
            #[inline(always)]
            fn named(self, name: &str) -> Self {
                Self { #(#names: ::pavo_shade::Value::named_part(self.#names, name, #texts)),* }
            }
        }
    })
}
