//! Statements of a generated function body.

use super::expression::Writer;
use super::ident::ident;
use super::{print, signature};
use crate::backend::body::{Body, Step, input_element};
use crate::program::Operand;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Tokens of all lines of the body of a generated function in order, comments included.
pub(super) fn statements(writer: Writer<'_>) -> TokenStream {
    let mut tokens = TokenStream::new();
    for &step in &writer.body.steps {
        tokens.extend(statement(writer, step));
    }
    tokens
}

fn statement(writer: Writer<'_>, step: Step) -> TokenStream {
    let Writer { body, .. } = writer;
    let variable = |k: usize| ident(body.variables.of_statement(k).unwrap_or_default());
    match step {
        Step::Gap => print::blank_line(),
        Step::Source(origin) => {
            let (blank, line) = (
                print::blank_line(),
                print::comment(&body.source_line(origin)),
            );
            quote!(#blank #line)
        }
        Step::Load(operand) => load(body, operand),
        Step::Let(k) => {
            let (name, value) = (variable(k), writer.statement(k));
            quote!(let #name = #value;)
        }
        Step::SinCos { sin, cos, angle } => {
            let (sin, cos, angle) = (variable(sin), variable(cos), writer.receiver(angle));
            quote!(let (#sin, #cos) = #angle.sin_cos();)
        }
        Step::Store {
            output,
            section,
            element,
        } => store(writer, output, section, element),
    }
}

fn load(body: &Body<'_>, operand: Operand) -> TokenStream {
    let (Some((input, k)), Some(name)) = (input_element(operand), body.variables.of(operand))
    else {
        return TokenStream::new();
    };
    let (name, array, k) = (ident(name), ident(input.name()), Literal::u32_unsuffixed(k));
    quote!(let #name = #array[#k];)
}

fn store(writer: Writer<'_>, output: usize, section: usize, element: usize) -> TokenStream {
    let function = writer.body.function;
    let section = &function.sections[section];
    let value = writer.value(function.program.outputs[output]);
    let result = &function.results[output];
    let note = if section.pattern.is_some() && value.to_string() != *result {
        print::trailing_comment(result)
    } else {
        TokenStream::new()
    };
    let array = ident(signature::of(function).argument(section.name));
    let element = Literal::usize_unsuffixed(element);
    quote!(#note #array[#element] = #value;)
}
