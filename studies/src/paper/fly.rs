//! Simulates one of the paper's flights under a reading.

use flight::CompiledModel;
use flight::release::{Vocabulary, built_in, read};
use model_spec::model::Model;
use ode::{Event, IntegrationOptions};

use super::claims::Outcome;
use super::coefficients::Coefficients;
use super::conventions::{Conventions, RollSpin, SpinDown};
use crate::error::StudyError;

/// Text of an effect that adds the coefficients that some interpretations of Table 1 of Hubbard & Hummel (2000) need in
/// addition to the eight of the model `disc`.
const READINGS: &str = include_str!("data/readings.hyz");

/// Relative tolerance of the integration. The comparison with the values that Hubbard & Hummel (2000) state needs a
/// relative accuracy of 1e-4, a hundredth of the smallest tolerance of such a value.
const TOLERANCE: f64 = 1e-7;

/// One of the two flights of Hubbard & Hummel (2000): release state and compiled model, for simulation with the
/// coefficients of any interpretation of their Table 1.
pub(super) struct Flyer {
    body: CompiledModel,
    parameters: Vec<f64>,
    initial: Box<[f64]>,
    duration: f64,
}

impl Flyer {
    /// Loads the built-in release (launch conditions) `name` of a flight to be simulated for `duration` (s).
    pub(super) fn new(name: &str, duration: f64) -> Result<Self, StudyError> {
        let model = model()?;
        let body = CompiledModel::new(&model);
        let text = built_in(name).ok_or_else(|| StudyError::Name {
            of: "collection of releases",
            name: name.to_owned(),
        })?;
        let release = read(name, text, |_| Ok(Vocabulary::of(&model)))?;
        let parameters = body.release_parameters(&release).constants;
        Ok(Self {
            parameters,
            initial: release.state().into(),
            duration,
            body,
        })
    }

    /// Diameter of the disc (m) and gravitational acceleration (m/s²) in the flight's launch conditions.
    pub(super) fn scales(&self) -> (f64, f64) {
        (self.parameter("d"), self.parameter("g"))
    }

    fn parameter(&self, name: &str) -> f64 {
        self.body
            .layout()
            .parameter(name)
            .map_or(f64::NAN, |id| self.parameters[id.index()])
    }

    /// Simulates the flight with the coefficients and conventions (signs and units) of one interpretation of Table 1 of
    /// Hubbard & Hummel (2000); `None` if the integration fails.
    pub(super) fn fly(
        &self,
        coefficients: &Coefficients,
        conventions: &Conventions,
    ) -> Option<Outcome> {
        let by_ratio = conventions.roll_spin == RollSpin::SpinRatio;
        let by_pressure = conventions.spin_down == SpinDown::TimesDynamicPressure;
        let split = |value: f64, second: bool| if second { (0.0, value) } else { (value, 0.0) };
        let (c_rr, c_rs) = split(coefficients.roll_spin, by_ratio);
        let (c_nr, c_nq) = split(coefficients.spin_down, by_pressure);
        let [c_l0, c_la, c_d0, c_da] = coefficients.lift_and_drag;
        let mut p = self.parameters.clone();
        let set = [
            ("C_L0", c_l0),
            ("C_La", c_la),
            ("C_D0", c_d0),
            ("C_Da", c_da),
            ("C_Ma", coefficients.pitching_moment),
            ("C_Mq", coefficients.pitch_damping),
            (
                "C_Mp",
                coefficients.roll_damping - coefficients.pitch_damping,
            ),
            ("C_Rr", c_rr),
            ("C_Rs", c_rs),
            ("C_Nr", c_nr),
            ("C_Nq", c_nq),
        ];
        for (name, value) in set {
            p[self.body.layout().parameter(name)?.index()] = value;
        }
        self.outcome(p)
    }

    fn outcome(&self, p: Vec<f64>) -> Option<Outcome> {
        let layout = self.body.layout();
        let conditions = self.body.bind(p);
        let options = IntegrationOptions {
            max_steps: 5_000,
            ..IntegrationOptions::with_tolerance(TOLERANCE)
        };
        let z = layout.state("z")?.index();
        let peak = Event::peak_of("apex", z);
        let from = (0.0, &self.initial);
        let flight = conditions
            .integrate(from, self.duration, &options, &mut [peak])
            .ok()?;
        let (start, end) = (
            |name| Some(self.initial[layout.state(name)?.index()]),
            |name| Some(flight.end_state[layout.state(name)?.index()]),
        );
        let (initial_spin, spin): (f64, f64) = (start("gammadot")?, end("gammadot")?);
        // The maximum height occurs at the start, at the end, or at an apex in between.
        let mut highest = (0.0, self.initial[z]);
        for (time, height) in [(flight.end, flight.end_state[z])].into_iter().chain(
            flight
                .events
                .iter()
                .map(|event| (event.time, event.state[z])),
        ) {
            if height > highest.1 {
                highest = (time, height);
            }
        }
        Some(Outcome {
            delta_x: end("x")? - start("x")?,
            delta_z: end("z")? - start("z")?,
            phi: end("phi")?,
            theta: end("theta")?,
            gammadot: spin,
            gammadot_change_fraction: spin.abs() / initial_spin.abs() - 1.0,
            time_of_highest_z: highest.0,
        })
    }
}

/// Loads the model `disc` with the effect [`READINGS`], which adds coefficients that some interpretations of Table 1 of
/// Hubbard & Hummel (2000) need.
fn model() -> Result<Model, StudyError> {
    let (name, disc) = model_spec::load::MODELS
        .iter()
        .find(|(name, _)| *name == "disc")
        .ok_or_else(|| StudyError::Name {
            of: "collection of models",
            name: "disc".to_owned(),
        })?;
    let text = format!("{disc}\n{READINGS}");
    Ok(model_spec::load::from_text(name, &text, &["readings"])?)
}
