//! The rewriting of a function's body: literals become constants of the number type, bindings carry their names.

use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Ident, Pat, Stmt, parse_quote, parse_quote_spanned};

/// Rewrites a body for this number type.
pub struct Body<'a> {
    pub number: &'a Ident,
}

impl VisitMut for Body<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        if is_lit_call(expr) {
            return;
        }
        visit_mut::visit_expr_mut(self, expr);
        match expr {
            Expr::Lit(literal) => {
                if let syn::Lit::Float(value) = &literal.lit
                    && value.suffix().is_empty()
                {
                    let number = self.number;
                    // The span of the literal: an operation on it then stands where its author wrote it.
                    *expr = parse_quote_spanned!(value.span()=> <#number as ::pavo_shade::Real>::lit(#value));
                }
            }
            Expr::Path(path) if is_float_constant(&path.path) => {
                let number = self.number;
                *expr = parse_quote_spanned!(path.span()=> <#number as ::pavo_shade::Real>::lit(#path));
            }
            Expr::Assign(assign) => {
                if let Some(name) = plain_name(&assign.left) {
                    *assign.right = bound(&assign.right, &name);
                }
            }
            Expr::Binary(binary) => {
                let written = binary.op.span();
                let operator: syn::BinOp = match binary.op {
                    syn::BinOp::AddAssign(_) => parse_quote_spanned!(written=> +),
                    syn::BinOp::SubAssign(_) => parse_quote_spanned!(written=> -),
                    syn::BinOp::MulAssign(_) => parse_quote_spanned!(written=> *),
                    syn::BinOp::DivAssign(_) => parse_quote_spanned!(written=> /),
                    _ => return,
                };
                if let Some(name) = plain_name(&binary.left) {
                    let (left, right) = (&binary.left, &binary.right);
                    let value = bound(&parse_quote_spanned!(written=> #left #operator (#right)), &name);
                    *expr = parse_quote!(#left = #value);
                }
            }
            _ => {}
        }
    }

    fn visit_block_mut(&mut self, block: &mut syn::Block) {
        visit_mut::visit_block_mut(self, block);
        let mut statements = Vec::new();
        for mut statement in std::mem::take(&mut block.stmts) {
            let rebound = match &mut statement {
                Stmt::Local(local) => name_local(local),
                _ => Vec::new(),
            };
            statements.push(statement);
            statements.extend(rebound);
        }
        block.stmts = statements;
    }
}

/// Names a `let`: its value when it binds one name, each name after it when it takes a value apart.
fn name_local(local: &mut syn::Local) -> Vec<Stmt> {
    let Some(init) = &mut local.init else { return Vec::new() };
    let (pattern, declared) = match &mut local.pat {
        Pat::Type(typed) => (&mut *typed.pat, Some(&typed.ty)),
        pattern => (pattern, None),
    };
    match pattern {
        Pat::Ident(binding) if binding.by_ref.is_none() && binding.subpat.is_none() => {
            if is_named(&init.expr) {
                *init.expr = match declared {
                    Some(declared) => bound_as(&init.expr, declared, &binding.ident),
                    None => bound(&init.expr, &binding.ident),
                };
            }
            Vec::new()
        }
        pattern => {
            let mut names = Names(Vec::new());
            names.visit_pat_mut(pattern);
            let rebind = |(mutability, name): &(Option<syn::Token![mut]>, Ident)| -> Stmt {
                let value = bound(&parse_quote!(#name), name);
                parse_quote!(let #mutability #name = #value;)
            };
            names.0.iter().map(rebind).collect()
        }
    }
}

/// The names in a pattern. A `mut` goes from the pattern to where the name is bound again.
struct Names(Vec<(Option<syn::Token![mut]>, Ident)>);

impl VisitMut for Names {
    fn visit_pat_ident_mut(&mut self, pattern: &mut syn::PatIdent) {
        if pattern.by_ref.is_none() {
            self.0.push((pattern.mutability.take(), pattern.ident.clone()));
        }
    }
}

/// The expression with a name.
fn bound(expr: &Expr, name: &Ident) -> Expr {
    bound_as(expr, &parse_quote!(_), name)
}

/// The expression of a declared type with a name. The type decides whether it is a value.
fn bound_as(expr: &Expr, declared: &syn::Type, name: &Ident) -> Expr {
    let text = name.to_string();
    parse_quote!({
        #[allow(unused_imports)]
        use ::pavo_shade::naming::{BindMask as _, BindOther as _, BindValue as _, Binding};
        (&&&Binding::<#declared>::new(#expr)).bind(#text)
    })
}

/// Whether the right-hand side of a `let` may be a value. References, closures and whole numbers are not.
fn is_named(expr: &Expr) -> bool {
    !matches!(expr, Expr::Reference(_) | Expr::Closure(_) | Expr::Lit(_) | Expr::Range(_))
}

fn plain_name(expr: &Expr) -> Option<Ident> {
    match expr {
        Expr::Path(path) => path.path.get_ident().cloned(),
        _ => None,
    }
}

/// `lit(..)` and `lit3(..)` take plain numbers.
fn is_lit_call(expr: &Expr) -> bool {
    match expr {
        Expr::Call(call) => match &*call.func {
            Expr::Path(path) => {
                path.path.segments.last().is_some_and(|segment| segment.ident == "lit" || segment.ident == "lit3")
            }
            _ => false,
        },
        _ => false,
    }
}

/// A constant of `core::f64::consts` written by its path.
fn is_float_constant(path: &syn::Path) -> bool {
    let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    names.windows(3).any(|window| window[0] == "f64" && window[1] == "consts") && names.len() >= 3
}
