//! Resolution of names in expressions.

use super::elaborate::node;
use super::scope::Symbol;
use super::term::{Fraction, Term};
use super::{Checker, Definition, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, MAX_SHOWN, Span};
use crate::model::{ExprKind, Shape};
use crate::suggest;
use crate::syntax::ast::{self, ItemKind};
use crate::syntax::of_kind;
use crate::unit::{Unit, symbol};

impl Checker<'_> {
    /// Resolves a name to an expression; `None`, with an error reported, if it is undefined.
    pub fn name(&mut self, name: &str, span: Span) -> Option<Typed> {
        let scalar = |kind, term| Typed::scalar(kind, span, UnitOf::Term(term));
        if let Some(symbol) = self.scope.find(name) {
            let kind = match symbol {
                Symbol::Param(i) => ExprKind::Param(i),
                Symbol::Coefficient(i) => ExprKind::Coefficient(i),
                Symbol::State(i) => ExprKind::State(i),
                Symbol::Input(i) => ExprKind::Input(i),
                Symbol::InputPart(i, part) => {
                    let shape = self.shape_of_symbol(Symbol::Input(i))?;
                    let input = node(ExprKind::Input(i), shape, span);
                    ExprKind::Component(Box::new(input), part)
                }
                Symbol::Let(_) | Symbol::Unknown(_) => match self.defined(symbol)? {
                    Definition::Missing => return None,
                    Definition::Done(index, ..) => ExprKind::AuxVariable(index),
                },
                Symbol::Marker => ExprKind::Marker,
            };
            let shape = self.shape_of_symbol(symbol)?;
            let unit = match self.unit_of_symbol(symbol)? {
                UnitOf::Term(term) if !matches!(symbol, Symbol::Let(_) | Symbol::Unknown(_)) => {
                    UnitOf::Term(self.used(term, span))
                }
                unit => unit,
            };
            return Some(Typed::new(kind, shape, span, unit));
        }
        match name {
            "pi" => Some(scalar(ExprKind::Pi, Term::one())),
            "time" => Some(scalar(ExprKind::Time, Term::known(Unit::SECOND))),
            _ if super::OF_BODY.contains(&name) => self.of_body(name, span),
            _ => self.unknown_name(name, span),
        }
    }

    /// Definition of an auxiliary variable or of an unknown of a block `solve`; `None` for other symbols.
    pub fn defined(&self, symbol: Symbol) -> Option<Definition> {
        match symbol {
            Symbol::Let(i) => self.definitions.get(i).cloned(),
            Symbol::Unknown(i) => {
                let shape = self.model.aux_variables.get(i)?.value.shape;
                Some(Definition::Done(i, shape, self.variables[i].unit.clone()))
            }
            _ => None,
        }
    }

    /// Unit of the declared quantity `symbol`; `None` for an auxiliary variable whose definition has an error.
    pub fn unit_of_symbol(&self, symbol: Symbol) -> Option<UnitOf> {
        let term = match symbol {
            Symbol::Param(i) => &self.params[i],
            Symbol::Coefficient(i) => &self.coefficients[i],
            Symbol::State(i) => &self.states[i],
            Symbol::Input(i) | Symbol::InputPart(i, _) => &self.inputs[i],
            Symbol::Marker => return Some(UnitOf::of(Unit::METRE)),
            Symbol::Let(_) | Symbol::Unknown(_) => match self.defined(symbol)? {
                Definition::Missing => return None,
                Definition::Done(_, _, unit) => return Some(unit),
            },
        };
        Some(UnitOf::Term(term.clone()))
    }

    /// Shape of the declared quantity `symbol`; `None` for an auxiliary variable whose definition has an error.
    pub fn shape_of_symbol(&self, symbol: Symbol) -> Option<Shape> {
        Some(match symbol {
            Symbol::Input(i) => Shape::Vector(self.model.inputs[i].frame),
            Symbol::Marker => Shape::Vector(self.model.marker.as_ref()?.frame),
            Symbol::Let(_) | Symbol::Unknown(_) => match self.defined(symbol)? {
                Definition::Missing => return None,
                Definition::Done(_, shape, _) => shape,
            },
            _ => Shape::Scalar,
        })
    }

    /// Resolves a predefined vector of the body, such as `velocity`.
    fn of_body(&mut self, name: &str, span: Span) -> Option<Typed> {
        if self.declared_body.is_none() {
            let message = format!("there is no body whose `{name}` this could be");
            let fault = Diagnostic::new(Kind::Name, span, message);
            return self.refuse(fault.help(format!(
                "declare a body, or name the vector: `let {name} = (…, …, …) in N;`"
            )));
        }
        // `None` if the body has an error, which has been reported.
        let body = self.model.body.as_ref()?;
        let (kind, frame, unit) = match name {
            "position" => (ExprKind::Position, 0, Unit::METRE),
            "velocity" => (ExprKind::Velocity, body.velocity_frame, Unit::SPEED),
            "specific_force" => (
                ExprKind::SpecificForce,
                body.velocity_frame,
                Unit::ACCELERATION,
            ),
            _ => match &body.rotation {
                Some(rotation) if name == "angular_velocity" => (
                    ExprKind::AngularVelocity,
                    rotation.angular_velocity_frame,
                    Unit::RATE,
                ),
                Some(rotation) => (
                    ExprKind::AngularAcceleration,
                    rotation.angular_velocity_frame,
                    Unit::ANGULAR_ACCELERATION,
                ),
                None => {
                    let words = name.replace('_', " ");
                    let message = format!("a point has no {words}");
                    let fault = Diagnostic::new(Kind::Name, span, message);
                    let help = "declare a `body` with moments of inertia, or an `input`";
                    return self.refuse(fault.help(help));
                }
            },
        };
        let unit = UnitOf::of(unit);
        Some(Typed::new(kind, Shape::Vector(frame), span, unit))
    }

    fn unknown_name(&mut self, name: &str, span: Span) -> Option<Typed> {
        let element = self.element_in_text(name, span);
        let shown = element.as_ref().map_or(name, |(_, shown)| shown);
        let mut fault = Diagnostic::new(Kind::Name, span, format!("there is no `{shown}`"));
        if self.is_reported(&fault) {
            return self.refuse(fault);
        }
        if name == super::PREVIOUS {
            fault =
                fault.note("`previous` stands for what is replaced, in a `replace` of an effect");
        } else if let Some((array, _)) = element {
            let elements = self.elements(&array);
            fault = match &elements[..] {
                [] if self.scope.find(&array).is_some() => {
                    let parts = format!("`{array}.1`, `{array}.2`, `{array}.3`");
                    fault.help(format!("components are written {parts}"))
                }
                [] => fault.help(format!("declare it: `let {array}[i] for i in 1..3 = …;`")),
                [only] => fault.note(format!("the only element is `{only}`")),
                [first, .., last] => fault.note(format!("the elements are `{first}` to `{last}`")),
            };
        } else if let [first, ..] = &self.elements(name)[..] {
            fault.message = format!("`{name}` is an array");
            fault = fault.help(format!("write one of its elements, such as `{first}`"));
        } else if self.scope.frame(name).is_some() {
            fault.message = format!("`{name}` is a frame, not a quantity");
            fault = fault.help(format!(
                "its axes are `{name}.1`, `{name}.2` and `{name}.3`"
            ));
        } else if self.scope.has_function(name)
            || self.scope.table(name).is_some()
            || super::function_names().any(|own| own == name)
        {
            let what = if self.scope.table(name).is_some() {
                "table"
            } else {
                "function"
            };
            fault.message = format!("`{name}` is a {what}, not a quantity");
            fault = fault.help(format!("call it: `{name}(…)`"));
        } else if let Some(near) = suggest::nearest(name, self.declared_names()) {
            let near = near.to_owned();
            fault = fault.suggest(&near);
        } else if name == "t" {
            fault = fault.help("the time since release is `time`; `t` is a unit, the tonne");
        } else if name == "g" {
            fault = fault.help("declare the acceleration of gravity: `param g = 9.81 m/s^2;`");
        } else if let Some(function) = self.function_with(name) {
            fault = fault.note(format!(
                "`{name}` is known within the function `{function}` alone"
            ));
        } else if symbol::find(name).is_some() {
            fault = fault.help(format!(
                "`{name}` is a unit; to give a number this unit write `5 {name}`, or `5 [m/s]` for one of \
                 several factors"
            ));
        } else if name == "acceleration" && self.declared_body.is_some() {
            let advice = self.acceleration_advice();
            fault = fault.help(format!("it follows from the forces: {advice}"));
        } else {
            fault = fault
                .note("names are declared with `param`, `coefficient`, `input`, `state` or `let`");
        }
        self.refuse(fault)
    }

    /// A function of the text of which a name is a parameter or a variable.
    fn function_with(&self, name: &str) -> Option<String> {
        let mut functions = of_kind!(self.searched().iter(), ItemKind::Function);
        let found = functions.find(|own| {
            let parameters = own.parameters.iter().map(|own| &own.name);
            let mut names = parameters.chain(own.lets.iter().map(|own| &own.name));
            names.any(|own| own.text == name)
        })?;
        Some(found.name.text.clone())
    }

    /// Array and element as in messages, of a name that stands as an element in the text.
    fn element_in_text(&self, name: &str, span: Span) -> Option<(String, String)> {
        let text = self.text(span);
        let (array, _) = text.split_once('[').filter(|_| text.ends_with(']'))?;
        let array = crate::syntax::spelling::plain(array.trim_end());
        let subscripts = name.strip_prefix(array.as_str())?.strip_prefix('_')?;
        let element = format!("{array}[{}]", subscripts.replace('_', ", "));
        Some((array, element))
    }

    /// Statements in which what explains an error is searched: errors that are not shown need no search.
    pub fn searched(&self) -> &[ast::Item] {
        match self.reported.len() < MAX_SHOWN {
            true => &self.file.items,
            false => &[],
        }
    }

    /// Elements of an array of the text, in order, as in messages.
    fn elements(&self, array: &str) -> Vec<String> {
        let written = self.searched().iter().filter_map(super::shown::written);
        let is_element =
            |name: &String| name.split('[').next() == Some(array) && name.contains('[');
        written.map(|(_, shown)| shown).filter(is_element).collect()
    }

    /// Unit of the derivative of a state.
    pub fn unit_of_rate(&self, state: usize) -> Option<Term> {
        let second = Term::known(Unit::SECOND);
        self.states[state].times_power(&second, Fraction::MINUS_ONE)
    }

    /// Records the first use of each unknown unit in `term`, and returns the term.
    fn used(&mut self, term: Term, span: Span) -> Term {
        for unknown in term.unknowns() {
            let place = &mut self.first_uses[unknown as usize];
            place.get_or_insert(span);
        }
        term
    }

    pub fn part(&mut self, of: &ast::Expr, part: u8, span: Span) -> Option<Typed> {
        if let ast::ExprKind::Name(name) = &of.kind
            && let Some(frame) = self.scope.frame(name)
        {
            let (kind, unit) = (ExprKind::Axis(frame, part), UnitOf::of(Unit::ONE));
            return Some(Typed::new(kind, Shape::Vector(frame), span, unit));
        }
        if let ast::ExprKind::Name(name) = &of.kind
            && self.scope.find(name).is_none()
            && !super::OF_BODY.contains(&name.as_str())
        {
            let message = format!("there is no frame or vector `{name}`");
            let frames = self.model.frames.iter().map(|f| f.name.as_str());
            // A frame is suggested rather than a quantity.
            let fault = Diagnostic::new(Kind::Name, of.span, message)
                .did_you_mean(name, self.declared_names())
                .did_you_mean(name, frames);
            return self.refuse(fault);
        }
        let of_typed = self.elaborate(of)?;
        if of_typed.expr.shape == Shape::Scalar {
            let message = format!("`{}` is a number and has no components", self.text(of.span));
            return self.refuse(Diagnostic::new(Kind::Shape, span, message));
        }
        let kind = ExprKind::Component(Box::new(of_typed.expr), part);
        Some(Typed::scalar(kind, span, of_typed.unit))
    }

    /// What stands for the acceleration in expressions and in cases.
    fn acceleration_advice(&self) -> String {
        let states = self.states_of_body("velocity");
        let state = states.map_or("STATE", |[.., last]| last);
        format!(
            "what a sensor feels is made of `specific_force` and `angular_acceleration`; a `check` may \
             `expect der({state}) = …`"
        )
    }

    /// States of the body's `position`, `velocity` or `angular_velocity`.
    pub fn states_of_body(&self, name: &str) -> Option<[&str; 3]> {
        // Errors that are not shown need no search.
        let is_shown = self.reported.len() < MAX_SHOWN;
        let parts = &self.declared_body.filter(|_| is_shown)?.parts;
        let words = name.replace('_', " ");
        parts.iter().find_map(|part| match &part.kind {
            ast::BodyPartKind::States(states, ..) if part.words == words => {
                Some(states.each_ref().map(|own| own.text.as_str()))
            }
            _ => None,
        })
    }

    pub fn derivative(&mut self, state: &ast::Name, span: Span) -> Option<Typed> {
        let found = self.scope.find(&state.text);
        if !matches!(found, Some(Symbol::State(_)) | None) {
            let of = self.name(&state.text, state.span)?;
            return self.rate_of(of, span);
        }
        let derived = match found {
            Some(Symbol::State(i)) => i < self.of_body,
            _ => self.declared_body.is_some(),
        };
        if derived {
            let message = format!(
                "`der({})` follows from the forces and cannot be used here",
                state.text
            );
            let fault = Diagnostic::new(Kind::Cycle, span, message);
            let advice = self.acceleration_advice();
            return self.refuse(fault.help(format!(
                "the derivative of a position is a component of `velocity`; {advice}"
            )));
        }
        let Some(Symbol::State(i)) = found else {
            self.no_state(state);
            return None;
        };
        if let Some(&unknown) = self.solved.get(&i) {
            return Some(self.unknown(unknown, span));
        }
        let definition = self.derivative_definition(i)?;
        // The unit follows from that of the state, even if the equation has an error.
        let unit = self.unit_of_rate(i).map_or(UnitOf::Faulty, UnitOf::Term);
        match self.definitions.get(definition)? {
            Definition::Missing => None,
            Definition::Done(index, shape, _) => {
                let kind = ExprKind::AuxVariable(*index);
                Some(Typed::new(kind, *shape, span, unit))
            }
        }
    }
}
