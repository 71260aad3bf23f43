//! Quantities that are unknown in each flight: states that keep their initial value stand for inputs, coefficients or
//! constants, so that a fit estimates them with the other initial states of a flight.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::sync::Arc;

use super::ModelTree;
use crate::model::Model;
use crate::read::LoadError;
use crate::syntax::ast::{File, Item, ItemKind};
use crate::{nearest_name, syntax};

/// Error of [`Model::with_unknown`].
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum UnknownError {
    /// The model has no input, coefficient or constant of this name.
    #[error("the model has no input, coefficient or constant `{name}`{hint}")]
    NoSuchName {
        /// The name.
        name: String,
        /// The name that is meant, for the message.
        hint: String,
    },
    /// The model is not valid with states in place of the quantities.
    #[error("`{names}` cannot differ from flight to flight: {source}")]
    Invalid {
        /// Names of the quantities.
        names: String,
        /// Errors of the model.
        source: LoadError,
    },
}

impl Model {
    /// The model with states in place of the inputs, coefficients or constants `names`. The states have their names
    /// (`omega_x`, `omega_y`, `omega_z` for a vector `omega`), start at their default values and do not change. Names
    /// that states already stand for are skipped. [`ModelTree::to_text`] writes the model as it was.
    pub fn with_unknown(&self, names: &BTreeSet<String>) -> Result<Model, UnknownError> {
        self.with_unknown_or_recorded(names, &BTreeSet::new())
    }

    /// [`with_unknown`](Self::with_unknown), where some flights have the scalar inputs `recorded` over time. Of such an
    /// input the state is `NAME_constant`, and the model acts by the sum of it and a scalar input `NAME_recorded`, which
    /// is 0 by default.
    #[doc(hidden)]
    pub fn with_unknown_or_recorded(
        &self,
        names: &BTreeSet<String>,
        recorded: &BTreeSet<String>,
    ) -> Result<Model, UnknownError> {
        let known = self.tree.set_aside.unknown.iter().map(|own| &own.0);
        let all: BTreeSet<&String> = known.clone().chain(names).collect();
        if all.len() == known.count() {
            return Ok(self.clone());
        }
        let mut tree = ModelTree::of(self);
        let file = Arc::make_mut(&mut tree.file);
        // What is unknown already is set aside again, so that all statements are from one text.
        restore(file);
        let given = match self.tree.set_aside.unknown.is_empty() {
            true => self,
            false => &tree.check().map_err(|source| invalid(&all, source))?,
        };
        let (mut text, mut unknown) = (String::new(), Vec::new());
        for name in &all {
            let mut stood_for = self.tree.set_aside.unknown.iter();
            let constant = format!("{name}_constant");
            let is_recorded = recorded.contains(*name)
                || stood_for.any(|(own, states)| own == *name && *states == [&*constant]);
            let states = given.states_for((name, is_recorded), &mut text)?;
            unknown.push(((*name).clone(), states));
        }
        let file = Arc::make_mut(&mut tree.file);
        set_aside(file, &all);
        let source = u16::try_from(tree.sources.len()).unwrap_or(u16::MAX);
        (file.set_aside.unknown, file.set_aside.source) = (unknown, source);
        let parsed = syntax::parse_as("the unknowns of each flight", &text, source);
        file.items.extend(parsed.file.items);
        tree.sources.push(parsed.source);
        tree.check().map_err(|source| invalid(&all, source))
    }

    /// States that stand for unknown quantities: the name of the quantity, and the index of each state.
    pub fn unknown_states(&self) -> Vec<(String, usize)> {
        let unknown = self.tree.set_aside.unknown.iter();
        let pairs =
            unknown.flat_map(|(name, states)| states.iter().map(move |state| (name, state)));
        let index = |state: &str| self.states.iter().position(|own| own.name == state);
        pairs
            .filter_map(|(name, state)| Some((name.clone(), index(state)?)))
            .collect()
    }

    /// Writes the statements that take the place of `name` to `text`, and returns the names of the states.
    fn states_for(
        &self,
        (name, is_recorded): (&str, bool),
        text: &mut String,
    ) -> Result<Vec<String>, UnknownError> {
        let mut state = |name: &str, value: f64, unit: &str| {
            let unit = if unit == "1" { "[1]" } else { unit };
            let _ = writeln!(text, "state {name} = {value:?} {unit};\nder({name}) = 0;");
            name.to_owned()
        };
        let mut scalars = self.params.iter().chain(&self.coefficients);
        if let Some(own) = scalars.find(|own| own.name == name) {
            if own.varies && is_recorded {
                let constant = state(&format!("{name}_constant"), own.value, &own.unit_text);
                let bounds = own.bounds.filter(|(low, high)| *low <= 0.0 && *high >= 0.0);
                let bounds = bounds.map_or_else(String::new, |(low, high)| {
                    format!(" in {low:?} .. {high:?}")
                });
                let _ = writeln!(
                    text,
                    "input {name}_recorded: [{}] = 0{bounds};\nlet {name} = {constant} + {name}_recorded;",
                    own.unit_text
                );
                return Ok(vec![constant]);
            }
            return Ok(vec![state(name, own.value, &own.unit_text)]);
        }
        let Some(own) = self.inputs.iter().find(|own| own.name == name) else {
            let all = self.inputs.iter().map(|own| &*own.name);
            let all = all.chain(
                self.params
                    .iter()
                    .chain(&self.coefficients)
                    .map(|own| &*own.name),
            );
            let hint = nearest_name(name, all);
            return Err(UnknownError::NoSuchName {
                name: name.to_owned(),
                hint: hint.map_or_else(String::new, |near| format!("; did you mean `{near}`?")),
            });
        };
        let axes = ["x", "y", "z"].iter().zip(own.value);
        let states: Vec<String> = axes
            .map(|(axis, value)| state(&format!("{name}_{axis}"), value, &own.unit_text))
            .collect();
        let frame = &self.frames[own.frame].name;
        let _ = writeln!(text, "let {name} = ({}) in {frame};", states.join(", "));
        Ok(states)
    }
}

fn invalid(names: &BTreeSet<&String>, source: LoadError) -> UnknownError {
    let names: Vec<&str> = names.iter().map(|name| name.as_str()).collect();
    UnknownError::Invalid {
        names: names.join("`, `"),
        source,
    }
}

/// Moves the declarations of `names` aside, and the check cases, which may set them.
fn set_aside(file: &mut File, names: &BTreeSet<&String>) {
    let is_left_out = |item: &Item| match &item.kind {
        ItemKind::Check(_) => true,
        ItemKind::Parameter(own) => names.contains(&own.name.text),
        ItemKind::Input(own) => names.contains(&own.name.text),
        _ => false,
    };
    let (out, kept): (Vec<_>, Vec<_>) = std::mem::take(&mut file.items)
        .into_iter()
        .enumerate()
        .partition(|(_, item)| is_left_out(item));
    file.set_aside.items.extend(out);
    file.items = kept.into_iter().map(|(_, item)| item).collect();
}

/// Puts the statements back that states had taken the place of.
pub(super) fn restore(file: &mut File) {
    let aside = std::mem::take(&mut file.set_aside);
    if aside.unknown.is_empty() {
        return;
    }
    file.items.retain(|item| item.span.source != aside.source);
    for (index, item) in aside.items {
        file.items.insert(index.min(file.items.len()), item);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(all: &[&str]) -> BTreeSet<String> {
        all.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn states_stand_for_an_input_and_the_text_has_the_input() {
        let ball = crate::load::load("ball", &["magnus"]).expect("the ball");
        let unknown = ball.with_unknown(&names(&["omega"])).expect("an input");
        assert!(unknown.inputs.iter().all(|input| input.name != "omega"));
        let states: Vec<&str> = unknown.states.iter().map(|own| own.name.as_str()).collect();
        assert_eq!(states[6..], ["omega_x", "omega_y", "omega_z"]);
        assert_eq!(unknown.added_states(), [6, 7, 8]);
        let again = unknown
            .with_unknown(&names(&["omega", "C_D"]))
            .expect("one more");
        assert_eq!(again.states.len(), 10);
        for model in [&unknown, &again] {
            assert_eq!(
                ModelTree::of(model).to_text(""),
                ModelTree::of(&ball).to_text("")
            );
        }
    }

    #[test]
    fn an_input_that_some_flights_record_is_the_sum_of_a_state_and_the_record() {
        let text = "model sled;\nparam m = 2 kg;\ninput thrust: N = 3 in -1 .. 9;\nframe N;\n\
            point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n\
            force push = (thrust, 0, 0) in N;\n";
        let sled = crate::load::from_text("sled.hyz", text, &[]).expect("a sled");
        let thrust = names(&["thrust"]);
        let mixed = sled.with_unknown_or_recorded(&thrust, &thrust);
        let mixed = mixed.expect("an input");
        let again = mixed.with_unknown(&names(&["thrust", "m"]));
        assert!(again.is_err(), "a mass");
        assert_eq!(
            mixed.unknown_states(),
            [("thrust".to_owned(), mixed.states.len() - 1)]
        );
        let state = mixed.states.last().expect("a state");
        assert_eq!((&*state.name, state.value), ("thrust_constant", 3.0));
        let recorded = mixed.params.iter().find(|own| own.varies);
        let recorded = recorded.expect("an input");
        assert_eq!(
            (&*recorded.name, recorded.value, recorded.bounds),
            ("thrust_recorded", 0.0, Some((-1.0, 9.0)))
        );
        let made = |model: &Model| {
            let all = crate::compose::known_effects(model);
            let own = all
                .iter()
                .filter(|own| own.effect.name().contains("_of_thrust"));
            own.count()
        };
        assert_eq!((made(&sled), made(&mixed)), (4, 0));
        assert_eq!(
            ModelTree::of(&mixed).to_text(""),
            ModelTree::of(&sled).to_text("")
        );
    }

    #[test]
    fn what_all_flights_share_and_what_is_not_there_are_told() {
        let disc = crate::load::load("disc", &[]).expect("the disc");
        let told = |name: &str| {
            disc.with_unknown(&names(&[name]))
                .expect_err(name)
                .to_string()
        };
        assert!(
            told("I_a").contains("must not change during a flight"),
            "{}",
            told("I_a")
        );
        assert!(
            told("wnd").contains("did you mean `wind`?"),
            "{}",
            told("wnd")
        );
    }
}
