//! Auxiliary variables that predict the readings of instruments: declared by `let`, else by default.

use std::sync::Arc;

use crate::model::Model;
use crate::read::LoadError;
use crate::syntax::ast::ItemKind;
use crate::syntax::{self, of_kind};

use super::{Instrument, ModelTree};

impl ModelTree {
    /// The model with an auxiliary variable [`Instrument::name`] for each of `instruments`, which predicts the measured
    /// value: by default, if the model does not declare it.
    pub(crate) fn with_instruments(&self, instruments: &[Instrument]) -> ModelTree {
        let mut tree = self.clone();
        for instrument in instruments {
            if tree.file.binding(instrument.name()).is_none() {
                tree.define(*instrument);
            }
        }
        tree
    }

    fn define(&mut self, instrument: Instrument) {
        let marker = of_kind!(self.file.items.iter(), ItemKind::Marker).next();
        let marker = marker.map(|marker| (marker.frame.text.as_str(), marker.name.text.as_str()));
        let inertial = self.file.inertial().unwrap_or("N");
        let (frame, marker) = marker.unwrap_or((inertial, "position"));
        let text = instrument.definition(frame, marker);
        let name = format!("the usual {}", instrument.name());
        let place = u16::try_from(self.sources.len()).unwrap_or(u16::MAX);
        let parsed = syntax::parse_as(&name, &text, place);
        self.sources.push(parsed.source);
        Arc::make_mut(&mut self.file)
            .items
            .extend(parsed.file.items);
    }
}

impl Model {
    /// Returns the model with an auxiliary variable for each of `instruments`, which predicts its measured value.
    pub fn with_instruments(&self, instruments: &[Instrument]) -> Result<Model, LoadError> {
        let has = |name: &str| self.aux_variables.iter().any(|own| own.name == name);
        if instruments.iter().all(|own| has(own.name())) {
            return Ok(self.clone());
        }
        ModelTree::of(self).with_instruments(instruments).check()
    }

    /// Returns the model with a variable for each instrument whose definition is valid for it.
    pub fn with_every_instrument(&self) -> Model {
        let all = Instrument::ALL.into_iter();
        all.fold(self.clone(), |model, instrument| {
            model.with_instruments(&[instrument]).unwrap_or(model)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_has_every_instrument_and_a_point_mass_has_a_speed() {
        for name in ["disc", "disc_quaternion", "discus"] {
            let model = crate::load::load(name, &[]).expect(name);
            let measured = model.with_instruments(&Instrument::ALL).expect(name);
            assert_eq!(measured.aux_variables.len(), model.aux_variables.len() + 3);
        }
        let ball = crate::load::load("ball", &[]).expect("the ball");
        assert!(ball.with_instruments(&[Instrument::Speed]).is_ok());
        let refused = ball.with_instruments(&[Instrument::Gyroscope]);
        let words = refused.expect_err("a point has no rates").to_string();
        assert!(words.contains("a point has no angular velocity"), "{words}");
    }

    #[test]
    fn a_model_s_own_definition_stays() {
        let text = "model stone; frame N; point stone { mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
                    let speed = velocity.1;";
        let model = crate::load::from_text("stone.hyz", text, &[]).expect("a model");
        let measured = model
            .with_instruments(&[Instrument::Speed])
            .expect("as it is");
        assert_eq!(measured.aux_variables.len(), 1);
    }

    #[test]
    fn loads_cannot_depend_on_what_follows_from_them() {
        let text = "model stone; frame N; point stone { mass 1 kg; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
                    let felt = specific_force; force drag = -(1 kg)*felt;";
        let refused = crate::load::from_text("stone.hyz", text, &[]).expect_err("a circle");
        let words = refused.to_string();
        assert!(
            words.contains("follow from the forces and moments"),
            "{words}"
        );
    }
}
