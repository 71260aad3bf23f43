//! A model made ready to fly: by its generated code where that belongs to the model's text, by the tape where not.

mod linear;
mod observer;

pub use linear::LinearMotion;
pub use observer::{Derivatives, Observer};

use crate::dynamics::Dynamics;
use crate::event::Event;
use crate::release::Release;
use codegen::Layout;
use codegen::compile::{Effort, Selection, compile, compile_at};
use codegen::rust::source_hash;
use codegen::tape_model::{At, Scratch, TapeModel};
use model_spec::model::Model;
use std::borrow::Cow;

/// States of a model whose number is known only when it is read.
pub type States = Box<[f64]>;

/// A model ready to fly.
pub struct Body {
    layout: Layout,
    /// Bound and reason of each limit.
    limits: Vec<(f64, String)>,
    functions: Functions,
    patterns: linear::Patterns,
}

enum Functions {
    Generated(&'static generated::Model),
    Tape(Box<TapeModel>),
}

impl Body {
    /// Takes the generated code if it was made from this very text, and lays out a tape if not.
    pub fn new(model: &Model) -> Body {
        let same = |code: &&generated::Model| code.source_hash == source_hash(model);
        match generated::model(&model.name).filter(same) {
            Some(code) => Body::by(model, Functions::Generated(code)),
            None => Body::on_tape(model),
        }
    }

    /// Lays out a tape in any case.
    pub fn on_tape(model: &Model) -> Body {
        // With every derivative, as the generated code was: what is computed once per flight is then the same too.
        let compiled = compile(model);
        Body::by(model, Functions::Tape(Box::new(TapeModel::new(&compiled))))
    }

    /// Lays out a tape for given values of some parameters, by their place in the layout: derivatives by them are there as by
    /// all others, and nothing else is left of what vanishes at these values. Other values of them are not heeded.
    pub fn on_tape_at(model: &Model, fixed: &[(usize, f64)]) -> Body {
        let compiled = compile_at(model, &Selection::All, fixed, Effort::Quick);
        Body::by(model, Functions::Tape(Box::new(TapeModel::new(&compiled))))
    }

    fn by(model: &Model, functions: Functions) -> Body {
        Body {
            layout: Layout::new(model),
            limits: limits(model),
            patterns: linear::Patterns::of(&functions),
            functions,
        }
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        match self.layout.states.get(state) {
            Some(name) => name.as_str().into(),
            None => format!("state {state}").into(),
        }
    }

    /// Whether it flies by generated code.
    pub fn is_generated(&self) -> bool {
        matches!(self.functions, Functions::Generated(_))
    }

    /// Names and places of states and parameters.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The states that the position of a marker depends on, in their order.
    pub fn observed_states(&self) -> Vec<usize> {
        let mut states: Vec<usize> = self
            .patterns
            .dy_dx
            .iter()
            .map(|(_, state)| *state)
            .collect();
        states.sort_unstable();
        states.dedup();
        states
    }

    /// The parameters of a release, in the order of the layout: the model's defaults with its values, its wind and
    /// what else is known of the flight.
    pub fn parameters(&self, release: &Release) -> Vec<f64> {
        let names = self.layout.parameters.iter().map(String::as_str);
        let mut parameters = release.constants(names.zip(self.layout.default_parameters()));
        let known = release
            .known
            .iter()
            .map(|(name, value)| (name.as_str(), value));
        for (name, vector) in known.chain([("wind", &release.wind)]) {
            // A model without wind has no place for it.
            let places = self.layout.components(name).into_iter().flatten();
            for (place, value) in places.zip(vector) {
                parameters[place.index()] = *value;
            }
        }
        parameters
    }

    /// The body with these parameters, in the order of the layout.
    pub fn with(&self, parameters: Vec<f64>) -> Conditions<'_> {
        let prepared = match &self.functions {
            Functions::Tape(tape) => tape.prepare(&parameters),
            Functions::Generated(code) => {
                let mut prepared = vec![0.0; code.prepared.len()];
                (code.prepare)(&parameters, &mut prepared);
                prepared
            }
        };
        Conditions {
            body: self,
            parameters,
            prepared,
        }
    }
}

fn limits(model: &Model) -> Vec<(f64, String)> {
    let limits = model.limits.iter();
    limits
        .map(|limit| (limit.bound, limit.reason.clone()))
        .collect()
}

/// A body in the conditions of one flight.
pub struct Conditions<'a> {
    body: &'a Body,
    parameters: Vec<f64>,
    prepared: Vec<f64>,
}

impl Conditions<'_> {
    /// The equations of motion.
    pub fn motion(&self) -> Motion<'_> {
        Motion {
            conditions: self,
            scratch: Scratch::default(),
        }
    }

    /// The equations of motion with their derivatives, for [`Sensitivities`](crate::sensitivity::Sensitivities).
    pub fn linear_motion(&self) -> LinearMotion<'_> {
        LinearMotion::new(self)
    }

    /// What is seen of the body.
    pub fn observer(&self) -> Observer<'_> {
        Observer::new(self)
    }

    /// Events that end a flight, with the model's own reason, where the model ends.
    pub fn limits(&self) -> Vec<Event<'_, States>> {
        let each = self.body.limits.iter().enumerate();
        each.map(|(index, (bound, reason))| {
            let mut scratch = Scratch::default();
            let mut values = vec![0.0; self.body.limits.len()];
            Event::limit(reason.as_str(), move |t, x: &States| {
                match &self.body.functions {
                    Functions::Generated(code) => {
                        (code.limits)(t, x, &self.parameters, &self.prepared, &mut values);
                    }
                    Functions::Tape(tape) => tape.limits(self.at(t, x), &mut scratch, &mut values),
                }
                values[index] - bound
            })
        })
        .collect()
    }

    fn at<'a>(&'a self, t: f64, x: &'a [f64]) -> At<'a> {
        At {
            t,
            x,
            p: &self.parameters,
            prepared: &self.prepared,
        }
    }
}

/// The equations of motion of a body in the conditions of one flight.
pub struct Motion<'a> {
    conditions: &'a Conditions<'a>,
    scratch: Scratch,
}

impl Dynamics for Motion<'_> {
    type State = States;

    fn derivative(&mut self, t: f64, x: &States, dx: &mut States) {
        let conditions = self.conditions;
        match &conditions.body.functions {
            Functions::Generated(code) => {
                (code.f)(t, x, &conditions.parameters, &conditions.prepared, dx);
            }
            Functions::Tape(tape) => tape.f(conditions.at(t, x), &mut self.scratch, dx),
        }
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        self.conditions.body.state_name(component)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, fly};

    #[test]
    fn the_tape_flies_as_the_generated_code_does() {
        let model = model_spec::load::load("disc", &[]).expect("the disc");
        let (code, tape) = (Body::new(&model), Body::on_tape(&model));
        assert!(code.is_generated() && !tape.is_generated());
        let flown = |body: &Body| {
            let conditions = body.with(body.layout().default_parameters());
            let start = [
                0.0, 0.0, 1.0, 14.0, 0.0, -1.0, 0.1, -0.2, 0.0, 0.5, 0.0, -50.0,
            ];
            let start: Box<[f64]> = Box::new(start);
            let options = Options::default();
            let flight = fly(
                &mut conditions.motion(),
                (0.0, &start),
                1.0,
                &options,
                &mut [],
            );
            flight.expect("it flies").end_state
        };
        assert_eq!(flown(&code), flown(&tape));
    }

    #[test]
    fn a_tape_at_given_values_flies_as_the_whole_one_at_these_values() {
        let names = model_spec::load::EFFECTS.iter().map(|(name, _)| *name);
        let fits = |name: &&str| model_spec::load::load("disc", &[name]).is_ok();
        let names: Vec<&str> = names.filter(fits).collect();
        let model = model_spec::load::load("disc", &names).expect("the disc with all effects");
        let layout = Layout::new(&model);
        let own = model.effects.iter().flat_map(|effect| &effect.coefficients);
        let place = |index| layout.coefficient(index).index();
        let fixed: Vec<(usize, f64)> = own.map(|c| (place(c.index), c.null_value)).collect();
        let flown = |body: &Body, unread: f64| {
            let mut parameters = layout.default_parameters();
            for &(place, value) in &fixed {
                parameters[place] = value + unread;
            }
            let conditions = body.with(parameters);
            let mut start: States = layout.default_states().into();
            start[2..12].copy_from_slice(&[1.0, 14.0, 0.0, -1.0, 0.1, -0.2, 0.0, 0.5, 0.0, -50.0]);
            let (mut motion, options) = (conditions.motion(), Options::default());
            let flight = fly(&mut motion, (0.0, &start), 1.0, &options, &mut []);
            flight.expect("it flies").end_state
        };
        let whole = flown(&Body::on_tape(&model), 0.0);
        let at = flown(&Body::on_tape_at(&model, &fixed), f64::NAN);
        for (a, b) in whole.iter().zip(&at) {
            assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{a} {b}");
        }
    }

    #[test]
    fn a_changed_model_flies_by_the_tape() {
        let (_, text) = model_spec::load::MODELS[0];
        let model = model_spec::load::from_text("changed", &format!("{text}\n"), &[]);
        assert!(!Body::new(&model.expect("still a model")).is_generated());
    }
}
