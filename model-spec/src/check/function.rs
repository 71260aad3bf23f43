//! Types of functions: at their definitions, of calls within them, and of arguments where calls are written out.

use super::elaborate::{node, number};
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Definition, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Label, Span};
use crate::model::{self, Expr, ExprKind, Shape};
use crate::syntax::ast::{self, Ascription, ItemKind, Name, UnitExpr};
use crate::syntax::expand::wrong_count;
use crate::syntax::of_kind;

/// Errors found at the definitions of functions. Copies of a faulty function are not reported again.
#[derive(Default)]
pub(super) struct FunctionFaults {
    /// Source spans of the functions with errors.
    faulty: Vec<Span>,
    found: Vec<Diagnostic>,
}

impl FunctionFaults {
    pub fn found(&self) -> &[Diagnostic] {
        &self.found
    }
}

impl<'a> Checker<'a> {
    pub fn declared_functions(&self) -> impl Iterator<Item = &'a ast::Function> + use<'a> {
        of_kind!(self.file.items.iter(), ItemKind::Function)
    }

    /// The first function of a name.
    pub fn declared_function(&self, name: &str) -> Option<&'a ast::Function> {
        self.declared_functions().find(|own| own.name.text == name)
    }

    /// Checks each function once, with parameters of the declared types, whether it is called or not.
    pub fn functions(&mut self) {
        // The errors so far are of copies.
        self.reported.clear();
        for function in self.declared_functions() {
            let earlier = self.diagnostics.len();
            self.function(function);
            if self.diagnostics.len() > earlier {
                self.of_functions.faulty.push(function.span);
                let found = self.diagnostics.drain(earlier..);
                self.of_functions.found.extend(found);
            }
        }
    }

    fn function(&mut self, function: &'a ast::Function) {
        let (variables, definitions) = (self.model.aux_variables.len(), self.definitions.len());
        let mut hidden: Vec<(&str, Option<(Symbol, Span)>)> = Vec::new();
        let mut names: Vec<&Name> = Vec::new();
        for parameter in &function.parameters {
            let name = &parameter.name;
            let of = self.type_of(&parameter.of);
            self.is_free(name, &mut names);
            let typed = of.map(|(shape, term)| {
                let placeholder = node(ExprKind::Time, shape, name.span);
                (placeholder, UnitOf::Term(term))
            });
            hidden.push((&name.text, self.local(name, typed)));
        }
        for own in &function.lets {
            self.is_free(&own.name, &mut names);
            let typed = self.elaborate(&own.value);
            let typed = match &own.unit {
                Some(unit) => typed.and_then(|typed| self.declared_as(typed, unit, &own.name)),
                None => typed,
            };
            let typed = typed.map(|typed| (typed.expr, typed.unit));
            hidden.push((&own.name.text, self.local(&own.name, typed)));
        }
        if let Some(typed) = self.elaborate(&function.value) {
            self.must_have_type(&typed, &function.of_result());
        }
        for (name, before) in hidden.into_iter().rev() {
            self.scope.restore(name, before);
        }
        self.definitions.truncate(definitions);
        self.model.aux_variables.truncate(variables);
        self.variables.truncate(variables);
    }

    /// Declares a parameter or a variable of a function, without a type if it has an error; returns what it hides.
    fn local(&mut self, name: &Name, typed: Option<(Expr, UnitOf)>) -> Option<(Symbol, Span)> {
        let definition = match typed {
            Some((value, unit)) => {
                let shape = value.shape;
                let own = model::AuxVariable {
                    span: name.span,
                    ..model::AuxVariable::new(&name.text, value)
                };
                let made = self.add_variable(own, unit.clone(), true);
                Definition::Done(made, shape, unit)
            }
            None => Definition::Missing,
        };
        let symbol = Symbol::Let(self.definitions.len());
        self.definitions.push(definition);
        self.scope.shadow(&name.text, symbol, name.span)
    }

    /// Reports a name that the function has already, or that is a frame.
    fn is_free(&mut self, name: &'a Name, names: &mut Vec<&'a Name>) {
        let text = &name.text;
        if let Some(first) = names.iter().find(|own| own.text == *text) {
            let message = format!("`{text}` is declared twice in this function");
            let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
            self.report(fault.label(first.span, "first declared here"));
        } else if self.scope.frame(text).is_some() {
            let message = format!("`{text}` is a frame, so that `{text}.1` would be its axis");
            let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
            self.report(fault.help("choose another name"));
        }
        names.push(name);
    }

    /// Shape and unit of a type; `None`, with an error reported, if its unit or frame is unknown.
    fn type_of(&mut self, of: &ast::Type) -> Option<(Shape, Term)> {
        let term = match &of.unit {
            Some(unit) => self.si_unit(unit),
            None => Some(Term::one()),
        };
        let shape = match &of.frame {
            Some(frame) => self.frame_of(frame).map(Shape::Vector),
            None => Some(Shape::Scalar),
        };
        Some((shape?, term?))
    }

    /// Declared unit of a quantity, which must be one of the SI; `None` if it is unknown.
    pub fn si_unit(&mut self, unit: &UnitExpr) -> Option<Term> {
        let measure = self.measure(unit)?;
        if measure.factor != 1.0 {
            let message =
                format!("`{unit}` is not the SI's own unit, in which all quantities are computed");
            let fault = Diagnostic::new(Kind::Value, unit.span, message);
            let named = measure.unit.named().map(|n| n.replace('·', "*"));
            let plain = named.unwrap_or_else(|| measure.unit.to_string());
            self.report(fault.help(format!("write `{plain}`")));
        }
        Some(Term::known(measure.unit))
    }

    /// The quantity `name` with its declared unit, on which later uses rely even if the definition contradicts it.
    pub fn declared_as(&mut self, mut typed: Typed, unit: &UnitExpr, name: &Name) -> Option<Typed> {
        let declared = self.si_unit(unit)?;
        let should = self.described(&declared);
        let rule = format!("`{}` is declared to be {should}", name.text);
        self.must_be(&typed, &declared, &rule);
        typed.unit = UnitOf::Term(declared);
        Some(typed)
    }

    /// Elaborates an argument or a result of a call, which has the declared type from there on.
    pub fn ascribed(
        &mut self,
        of: &ast::Expr,
        ascription: &Ascription,
        span: Span,
    ) -> Option<Typed> {
        let typed = self.elaborate(of)?;
        // Of a result too, though the function has been checked: a copy may have been changed in the tree.
        let (shape, term) = self.must_have_type(&typed, ascription)?;
        let mut expr = typed.expr;
        (expr.span, expr.shape) = (span, shape);
        let unit = UnitOf::Term(term);
        Some(Typed { expr, unit })
    }

    /// Requires the shape, frame and unit of an argument or a result; `None`, with an error reported, for another shape.
    fn must_have_type(&mut self, typed: &Typed, ascription: &Ascription) -> Option<(Shape, Term)> {
        let (shape, term) = self.type_of(&ascription.of)?;
        let earlier = self.diagnostics.len();
        let fits = self.must_have_shape(typed, shape, ascription);
        if fits {
            let should = self.described(&term);
            self.must_be(typed, &term, &format!("{ascription} must be {should}"));
        }
        // Of two parameters with one name, nobody can tell which is meant.
        if self
            .declared_function(&ascription.function)
            .is_some_and(has_doubled)
        {
            self.diagnostics.truncate(earlier);
        }
        if let Some(parameter) = &ascription.parameter {
            let text = format!("`{}{}` is declared here", parameter.text, ascription.of);
            for fault in &mut self.diagnostics[earlier..] {
                let (span, text) = (parameter.span, text.clone());
                fault.labels.push(Label { span, text });
            }
        }
        fits.then_some((shape, term))
    }

    fn must_have_shape(&mut self, typed: &Typed, expected: Shape, what: &Ascription) -> bool {
        let span = typed.expr.span;
        let text = self.text(span);
        let name = |frame: usize| &self.model.frames[frame].name;
        let fault = match (expected, typed.expr.shape) {
            (Shape::Scalar, Shape::Vector(frame)) => {
                let message = format!("{what} must be a number, but `{text}` is a vector");
                Diagnostic::new(Kind::Shape, span, message).help(match what.parameter {
                    None => format!(
                        "state what is returned, behind the parameters: `): vector … in {}`",
                        name(frame)
                    ),
                    Some(_) => format!("take its length `norm({text})`, or one component `….1`"),
                })
            }
            (Shape::Vector(_), Shape::Scalar) => {
                let message = format!("{what} must be a vector, but `{text}` is a number");
                Diagnostic::new(Kind::Shape, span, message)
            }
            (Shape::Vector(expected), Shape::Vector(found)) if expected != found => {
                let (expected, found) = (name(expected), name(found));
                let message = format!(
                    "{what} must be a vector in {expected}, but `{text}` has its components in {found}"
                );
                let fault = Diagnostic::new(Kind::Frame, span, message);
                let fault = fault.help(format!("write `in_{expected}({text})`"));
                self.called(fault, &format!("in_{expected}"), span)
            }
            _ => return true,
        };
        self.report(fault);
        false
    }

    /// Type of a call within the definition of a function, where calls are not written out.
    pub fn call_of_function(
        &mut self,
        function: &'a ast::Function,
        arguments: &[ast::Expr],
        span: Span,
    ) -> Option<Typed> {
        if function.parameters.len() != arguments.len() {
            return self.refuse(wrong_count(function, arguments.len(), span));
        }
        for (parameter, argument) in function.parameters.iter().zip(arguments) {
            self.ascribed(argument, &function.of_argument(parameter), argument.span);
        }
        let (shape, term) = self.type_of(&function.result)?;
        // In messages, a call is an operand like a number with a unit.
        let mut expr = number(1.0, None, term.unit().unwrap_or_default(), span);
        expr.shape = shape;
        let unit = UnitOf::Term(term);
        Some(Typed { expr, unit })
    }

    /// Whether a span lies in the definition of a function.
    fn is_in_function(&self, span: Span) -> bool {
        self.declared_functions().any(|own| own.span.contains(span))
    }

    /// Labels an error in a function with the call at which it arises: that of the variable with index `variable`, or
    /// the one in the expression `root`.
    pub fn at_call(&self, fault: Diagnostic, variable: usize, root: &Expr) -> Diagnostic {
        if !self.is_in_function(fault.span) {
            return fault;
        }
        let own = self.variables.get(variable).and_then(|own| own.call);
        match own.or_else(|| self.call_in(root, fault.span, root.span)) {
            Some(call) => fault.label(call, "in this call"),
            None => fault,
        }
    }

    /// Span of the innermost expression outside of functions that contains a copied node with the span `at`.
    fn call_in(&self, e: &Expr, at: Span, call: Span) -> Option<Span> {
        let call = if self.is_in_function(e.span) {
            call
        } else {
            e.span
        };
        if e.span == at {
            return Some(call);
        }
        let mut children = e.children().into_iter();
        children.find_map(|child| self.call_in(child, at, call))
    }

    /// Errors of the model and of its functions, each once.
    pub fn all_faults(&mut self) -> Vec<Diagnostic> {
        let FunctionFaults { faulty, found } = std::mem::take(&mut self.of_functions);
        let mut faults = std::mem::take(&mut self.diagnostics);
        faults.retain(|fault| !faulty.iter().any(|own| own.contains(fault.span)));
        faults.extend(found);
        let mut seen = std::collections::HashSet::new();
        faults.retain(|fault| seen.insert(self.place(fault)));
        faults
    }
}

/// Whether two parameters of a function have one name.
fn has_doubled(function: &ast::Function) -> bool {
    let mut all = function.parameters.iter().enumerate();
    all.any(|(k, own)| {
        { function.parameters[..k].iter() }.any(|other| other.name.text == own.name.text)
    })
}
