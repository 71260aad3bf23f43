//! One of the paper's flights under a reading.

use flight::CompiledModel;
use flight::release::{Vocabulary, built_in, read};
use model_spec::model::Model;
use ode::{Event, IntegrationOptions, integrate};

use crate::paper::claims::Outcome;
use crate::paper::reading::{Coefficients, Common, RollSpin, SpinDown};

/// The disc with what the readings need beyond its eight coefficients.
const READINGS: &str = include_str!("data/readings.hyz");

/// Local error of the flights: a hundredth of the tightest claim is 1e-4.
const TOLERANCE: f64 = 1e-7;

/// Flies one release under many readings.
pub struct Flyer {
    body: CompiledModel,
    parameters: Vec<f64>,
    initial: Box<[f64]>,
    duration: f64,
}

impl Flyer {
    /// Prepares the built-in release of this name, to be flown for `duration` s.
    ///
    /// # Errors
    /// In words, where the built-in model, effect or release cannot be used.
    pub fn new(name: &str, duration: f64) -> Result<Self, String> {
        let model = model()?;
        let body = CompiledModel::new(&model);
        let text = built_in(name).ok_or_else(|| format!("no release {name} is built in"))?;
        let release =
            read(name, text, |_| Ok(Vocabulary::of(&model))).map_err(|e| e.to_string())?;
        let parameters = body.release_parameters(&release);
        Ok(Self {
            parameters,
            initial: release.state().into(),
            duration,
            body,
        })
    }

    /// Diameter of the disc (m) and gravity (m/s²), which some readings need.
    pub fn scales(&self) -> (f64, f64) {
        (self.parameter("d"), self.parameter("g"))
    }

    fn parameter(&self, name: &str) -> f64 {
        self.body
            .layout()
            .parameter(name)
            .map_or(f64::NAN, |id| self.parameters[id.index()])
    }

    /// What comes out; `None` where the flight cannot be flown to its end.
    pub fn fly(&self, coefficients: &Coefficients, common: &Common) -> Option<Outcome> {
        let [
            c_l0,
            c_la,
            c_d0,
            c_da,
            c_ma,
            pitch,
            roll,
            roll_spin,
            spin_down,
        ] = *coefficients;
        let by_ratio = common.roll_spin == RollSpin::SpinRatio;
        let by_pressure = common.spin_down == SpinDown::TimesDynamicPressure;
        let split = |value: f64, second: bool| if second { (0.0, value) } else { (value, 0.0) };
        let (c_rr, c_rs) = split(roll_spin, by_ratio);
        let (c_nr, c_nq) = split(spin_down, by_pressure);
        let mut p = self.parameters.clone();
        let set = [
            ("C_L0", c_l0),
            ("C_La", c_la),
            ("C_D0", c_d0),
            ("C_Da", c_da),
            ("C_Ma", c_ma),
            ("C_Mq", pitch),
            ("C_Mp", roll - pitch),
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
        let flight = integrate(
            &mut conditions.rhs(),
            (0.0, &self.initial),
            self.duration,
            &options,
            &mut [peak],
        )
        .ok()?;
        let (start, end) = (
            |name| Some(self.initial[layout.state(name)?.index()]),
            |name| Some(flight.end_state[layout.state(name)?.index()]),
        );
        let (spin, spun): (f64, f64) = (start("gammadot")?, end("gammadot")?);
        // The highest point is where the flight begins or ends, unless it turns down in between.
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
            gammadot: spun,
            gammadot_change_fraction: spun.abs() / spin.abs() - 1.0,
            time_of_highest_z: highest.0,
        })
    }
}

/// The disc with the effect that the readings need.
fn model() -> Result<Model, String> {
    let (name, disc) = model_spec::load::MODELS
        .iter()
        .find(|(name, _)| *name == "disc")
        .ok_or("no model disc")?;
    let text = format!("{disc}\n{READINGS}");
    model_spec::load::from_text(name, &text, &["readings"]).map_err(|error| error.to_string())
}
