//! Source files of the crate `generated`: each model is a module, a `Model`, and a type with `Equations`.

use super::constants;
use super::function::HEADER;
use super::names::{module_ident, type_ident};
use super::print::{blank_line, doc, file, inner_doc};
use super::signature::{FUNCTIONS, Signature};
use crate::backend::SourceFile;
use crate::backend::body::Input;
use crate::compile::Compiled;
use model_spec::model::Model;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Text of a model's `mod.rs`: constants, implementation of the trait `Equations`, and value of type `Model`.
pub(super) fn model_module(compiled: &Compiled, model: &Model) -> String {
    let head = inner_doc(&documentation(compiled, model));
    let mut modules: Vec<&str> = FUNCTIONS.iter().map(|function| function.name).collect();
    if super::tables::file(compiled).is_some() {
        modules.push("tables");
    }
    modules.sort_unstable();
    let modules: Vec<_> = modules
        .into_iter()
        .map(|name| format_ident!("{name}"))
        .collect();
    let functions = modules.iter().filter(|module| **module != "tables");
    let constants = constants::items(model, compiled, &TokenStream::new());
    let equations = equations(compiled);
    file(
        &[HEADER],
        quote! {
            #head
            #(mod #modules;)*
            #(pub use #functions::#functions;)*
            #constants
            #equations
        },
    )
}

fn documentation(compiled: &Compiled, model: &Model) -> String {
    let mut text = match model.doc.trim() {
        "" => format!("`{}`.", compiled.name),
        doc => doc.to_string(),
    };
    text.push_str("\n\n| function | operations |\n|---|---|\n");
    for function in compiled.functions() {
        let count = crate::count::count(&function.program);
        text.push_str(&format!("| `{}` | {count} |\n", function.name));
    }
    text
}

/// Tokens of the type of a model with its `Equations`, and of its `MODEL`.
fn equations(compiled: &Compiled) -> TokenStream {
    let kind = type_ident(&compiled.name);
    let methods = FUNCTIONS.iter().map(|function| {
        let (head, name) = (function.head(), format_ident!("{}", function.name));
        let inputs = function.inputs.iter().map(|&input| {
            let name = format_ident!("{}", input.name());
            match input {
                Input::Time => quote!(#name),
                _ => quote!(crate::array(#name)),
            }
        });
        let outputs = function.output_idents();
        quote! {
            #[inline(always)]
            #head {
                #name(#(#inputs,)* #(crate::array_mut(#outputs)),*);
            }
        }
    });
    let functions: Vec<_> = FUNCTIONS
        .iter()
        .map(|f| format_ident!("{}", f.name))
        .collect();
    let name = &compiled.name;
    let observed = !compiled.layout.marker.is_empty();
    quote! {
        /// The equations of this model as a type.
        #[derive(Clone, Copy, Debug)]
        pub struct #kind;

        impl crate::Equations for #kind {
            const MODEL: &'static crate::Model = &MODEL;
            #(#methods)*
        }

        /// This model as a value, for selection at run time.
        pub static MODEL: crate::Model = crate::Model {
            name: #name,
            source_hash: SOURCE_HASH,
            states: &STATES,
            initial: &INITIAL,
            parameters: &PARAMETERS,
            defaults: &DEFAULTS,
            params: PARAMS,
            coefficients: COEFFICIENTS,
            prepared: &PREPARED,
            quantity_names: &QUANTITIES,
            limit_bounds: &LIMITS,
            limit_reasons: &LIMIT_REASONS,
            j_pattern: &J_PATTERN,
            jp_pattern: &JP_PATTERN,
            dy_dx_pattern: &DY_DX_PATTERN,
            dy_dp_pattern: &DY_DP_PATTERN,
            dy_dmarker_pattern: &DY_DMARKER_PATTERN,
            observed: #observed,
            #(#functions: crate::scalar::#functions::<#kind>),*
        };
    }
}

impl Signature {
    fn output_idents(&self) -> Vec<proc_macro2::Ident> {
        let outputs = self.outputs.iter();
        outputs
            .map(|(_, argument)| format_ident!("{argument}"))
            .collect()
    }

    /// Tokens of the generic signature over slices: `fn f<T: Real>(time: T, state: &[T], …)`.
    fn head(&self) -> TokenStream {
        let name = format_ident!("{}", self.name);
        let inputs = self.inputs.iter().map(|&input| {
            let name = format_ident!("{}", input.name());
            match input {
                Input::Time => quote!(#name: T),
                _ => quote!(#name: &[T]),
            }
        });
        let outputs = self.output_idents();
        quote!(fn #name<T: lanes::Real>(#(#inputs,)* #(#outputs: &mut [T]),*))
    }

    /// Tokens of the function pointer type for `f64`: `fn(f64, &[f64], …)`.
    fn pointer(&self) -> TokenStream {
        let inputs = self.inputs.iter().map(|&input| match input {
            Input::Time => quote!(f64),
            _ => quote!(&[f64]),
        });
        let outputs = self.outputs.iter().map(|_| quote!(&mut [f64]));
        quote!(fn(#(#inputs,)* #(#outputs),*))
    }

    /// Tokens of a function on `f64` that dispatches by instruction set.
    fn dispatched(&self) -> TokenStream {
        let name = format_ident!("{}", self.name);
        let call = format_ident!("{}Call", type_ident(self.name));
        let see = doc(&format!(
            "{}\n\nRuns [`Equations::{}`] with the instruction set of the processor.",
            self.summary, self.name
        ));
        let inputs: Vec<_> = self
            .inputs
            .iter()
            .map(|i| format_ident!("{}", i.name()))
            .collect();
        let outputs = self.output_idents();
        let kind = |input: &Input, lifetime: TokenStream| match input {
            Input::Time => quote!(f64),
            _ => quote!(&#lifetime [f64]),
        };
        let field_types = self.inputs.iter().map(|input| kind(input, quote!('a)));
        let argument_types = self.inputs.iter().map(|input| kind(input, quote!()));
        let lanes = self
            .inputs
            .iter()
            .zip(&inputs)
            .map(|(input, name)| match input {
                Input::Time => quote!(T::splat(self.#name)),
                _ => quote!(T::slice(self.#name)),
            });
        quote! {
            struct #call<'a, E> {
                equations: PhantomData<E>,
                #(#inputs: #field_types,)*
                #(#outputs: &'a mut [f64],)*
            }
            impl<E: Equations> ScalarKernel for #call<'_, E> {
                #[inline(always)]
                fn run<T: ScalarLane>(self) {
                    E::#name(#(#lanes,)* #(T::slice_mut(self.#outputs)),*);
                }
            }
            #see
            #[inline(never)]
            pub fn #name<E: Equations>(#(#inputs: #argument_types,)* #(#outputs: &mut [f64]),*) {
                dispatch_scalar(#call::<E> { equations: PhantomData, #(#inputs,)* #(#outputs),* });
            }
        }
    }
}

/// Files that list all models or functions: `lib.rs`, `model.rs`, `scalar.rs`.
pub fn library(names: &[String]) -> Vec<SourceFile> {
    let text = [
        ("lib.rs", root(names)),
        ("model.rs", model(names)),
        ("scalar.rs", scalar()),
    ];
    text.map(|(path, text)| SourceFile {
        path: path.to_string(),
        text,
    })
    .into()
}

/// Text of `lib.rs`, the only generated file that rustfmt formats.
fn root(names: &[String]) -> String {
    let mut modules: Vec<_> = names.iter().map(|name| module_ident(name)).collect();
    modules.sort();
    let head = inner_doc(
        "Flight models as Rust functions, written by `hyzer generate`.\n\n\
         Each model is a module: functions over arrays of any [`lanes::Real`], and constants with the names of states and\n\
         parameters, default values, and the sparsity patterns of the Jacobians. [`MODELS`] and [`model`] select a model at\n\
         run time for `f64`, [`visit`] for any number type.",
    );
    let blank = blank_line();
    file(
        &[HEADER],
        quote! {
            #head
            #![allow(non_snake_case, non_upper_case_globals, clippy::all)]
            #(#blank #[rustfmt::skip] pub mod #modules;)*
            #blank
            #[rustfmt::skip]
            mod model;
            #blank
            #[rustfmt::skip]
            mod scalar;
            #blank
            pub use model::{Equations, MODELS, Model, Visitor, model, visit};
            use model::{array, array_mut};
        },
    )
}

/// Text of `model.rs`: the type `Model`, the trait `Equations`, and the list of models.
fn model(names: &[String]) -> String {
    let modules: Vec<_> = names.iter().map(|name| module_ident(name)).collect();
    let kinds = names.iter().map(|name| type_ident(name));
    let fields = FUNCTIONS.iter().map(|function| {
        let (name, kind) = (format_ident!("{}", function.name), function.pointer());
        let doc = doc(&format!(
            "{}\n\nArguments as of [`Equations::{}`].",
            function.summary, function.name
        ));
        quote!(#doc pub #name: #kind)
    });
    let methods = FUNCTIONS.iter().map(|function| {
        let (doc, head) = (doc(function.summary), function.head());
        quote!(#doc #head;)
    });
    let head = inner_doc("Models as values and as types.");
    file(
        &[HEADER],
        quote! {
            #head
            /// A model with its functions for `f64`.
            ///
            /// The arguments of the functions are those of [`Equations`]. A function panics if a slice is shorter than the
            /// model requires.
            #[derive(Clone, Copy, Debug)]
            pub struct Model {
                /// Name of the model.
                pub name: &'static str,
                /// Hash of the model's source texts (64-bit FNV-1a).
                pub source_hash: u64,
                /// Names of the states.
                pub states: &'static [&'static str],
                /// Default initial state.
                pub initial: &'static [f64],
                /// Names of the constants, coefficients and components of inputs.
                pub parameters: &'static [&'static str],
                /// Default values of the parameters.
                pub defaults: &'static [f64],
                /// Number of constants, which come first among the parameters.
                pub params: usize,
                /// Number of coefficients, which follow the constants.
                pub coefficients: usize,
                /// Names of the invariants that `prepare` computes.
                pub prepared: &'static [&'static str],
                /// Names of the auxiliary variables that `quantities` computes.
                pub quantity_names: &'static [&'static str],
                /// Lower bounds of the domain of validity, one per result of `limits`.
                pub limit_bounds: &'static [f64],
                /// Why the model does not hold beyond each limit.
                pub limit_reasons: &'static [&'static str],
                /// (row, column) of each entry of `j` = ∂dx/∂state.
                pub j_pattern: &'static [(u32, u32)],
                /// (row, column) of each entry of `jp` = ∂dx/∂parameters.
                pub jp_pattern: &'static [(u32, u32)],
                /// (row, column) of each entry of `dy_dx` = ∂observed/∂state.
                pub dy_dx_pattern: &'static [(u32, u32)],
                /// (row, column) of each entry of `dy_dp` = ∂observed/∂parameters.
                pub dy_dp_pattern: &'static [(u32, u32)],
                /// (row, column) of each entry of `dy_dmarker` = ∂observed/∂marker.
                pub dy_dmarker_pattern: &'static [(u32, u32)],
                /// Whether the model has a measurement equation.
                pub observed: bool,
                #(#fields),*
            }

            /// The functions of a model over slices of any [`lanes::Real`].
            pub trait Equations {
                /// Names, patterns, and the functions for `f64`.
                const MODEL: &'static Model;
                #(#methods)*
            }

            /// All models, sorted by name.
            pub static MODELS: &[&Model] = &[#(&crate::#modules::MODEL),*];

            /// The model with a given name.
            pub fn model(name: &str) -> Option<&'static Model> {
                MODELS.iter().copied().find(|model| model.name == name)
            }

            /// A computation that is generic over the model; see [`visit`].
            pub trait Visitor {
                /// Result of the computation.
                type Output;
                /// Runs the computation with a model.
                fn visit<E: Equations>(self) -> Self::Output;
            }

            /// Runs a visitor with the equations of the model with a given name.
            pub fn visit<V: Visitor>(name: &str, visitor: V) -> Option<V::Output> {
                match name {
                    #(#names => Some(visitor.visit::<crate::#modules::#kinds>()),)*
                    _ => None,
                }
            }

            /// The first `N` elements of a slice.
            #[inline(always)]
            pub(crate) fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
                slice.first_chunk().expect("a slice as long as the model requires")
            }

            /// The first `N` elements of a mutable slice.
            #[inline(always)]
            pub(crate) fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
                slice.first_chunk_mut().expect("a slice as long as the model requires")
            }
        },
    )
}

/// Text of `scalar.rs`: each model function on `f64`, dispatched by instruction set.
fn scalar() -> String {
    let head = inner_doc(
        "The functions for `f64`, compiled for each instruction set that [`lanes::dispatch_scalar`] selects from.",
    );
    let functions = FUNCTIONS.iter().map(Signature::dispatched);
    file(
        &[HEADER],
        quote! {
            #head
            use crate::Equations;
            use lanes::{ScalarKernel, ScalarLane, dispatch_scalar};
            use std::marker::PhantomData;
            #(#functions)*
        },
    )
}
