//! What a model predicts of the markers, with exact sensitivities to the initial state and to chosen parameters.
//!
//! The sensitivities obey the variational equations dS/dt = J S + [0 | Jp], flown together with the state.

use std::borrow::Cow;

use codegen::compile::{Selection, compile_for};
use codegen::layout::Layout;
use codegen::tape_model::{At, Scratch, TapeModel};
use flight::body::States;
use flight::sensitivity::{Linearised, Sensitivities};
use flight::{Dynamics, Options, equations, fly_at};
use model_spec::model::Model;
use nalgebra::DMatrix;

/// Tolerance of the integration: far below any measurement, far above rounding.
const TOLERANCE: f64 = 1e-9;

/// A compiled model, ready to predict.
pub struct Predictor {
    tapes: TapeModel,
    layout: Layout,
    free: usize,
}

/// What is predicted of one marker at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// Its position in the inertial frame, m.
    pub position: [f64; 3],
    /// Derivatives of the position, 3 rows: by the initial states, then by the free parameters.
    pub sensitivity: DMatrix<f64>,
}

/// The constants of one flight.
pub struct Conditions {
    parameters: Vec<f64>,
    prepared: Vec<f64>,
}

impl Predictor {
    /// Compiles a model, with derivatives by the parameters at these places of its layout.
    pub fn new(model: &Model, free: &[usize]) -> Self {
        let compiled = compile_for(model, &Selection::Only(free.to_vec()));
        Self {
            tapes: TapeModel::new(&compiled),
            layout: compiled.layout,
            free: free.len(),
        }
    }

    /// Names and places of states and parameters.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Prepares a flight with these parameters, in the order of the layout.
    pub fn conditions(&self, parameters: Vec<f64>) -> Conditions {
        let prepared = self.tapes.prepare(&parameters);
        Conditions {
            parameters,
            prepared,
        }
    }

    /// The markers at the times of a flight from an initial state: `[sample][marker]`, m.
    ///
    /// # Errors
    /// In words, where the flight is impossible.
    pub fn positions(
        &self,
        conditions: &Conditions,
        initial: &[f64],
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Result<Vec<Vec<[f64; 3]>>, String> {
        let (states, mut scratch) = (self.tapes.states, Scratch::default());
        let names: Vec<&str> = self.layout.states.iter().map(String::as_str).collect();
        let mut motion = equations(&names, |t, x: &States, dx: &mut States| {
            self.tapes.f(conditions.at(t, x), &mut scratch, dx);
        });
        let samples = flown(&mut motion, initial.into(), times)?;
        let mut scratch = Scratch::default();
        let row = |(&t, x): (&f64, &[f64])| {
            let each = markers.iter().map(|marker| {
                let mut position = [0.0; 3];
                self.tapes
                    .observe(conditions.at(t, x), marker, &mut scratch, &mut position);
                position
            });
            each.collect()
        };
        Ok(times.iter().zip(samples.chunks(states)).map(row).collect())
    }

    /// As [`Predictor::positions`], with sensitivities.
    ///
    /// # Errors
    /// In words, where the flight is impossible.
    pub fn observe(
        &self,
        conditions: &Conditions,
        initial: &[f64],
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Result<Vec<Vec<Observed>>, String> {
        let states = self.tapes.states;
        let (by_start, by_free): (Vec<usize>, Vec<usize>) =
            ((0..states).collect(), (0..self.free).collect());
        let mut variations = Sensitivities::new(self.model(conditions), &by_start, &by_free);
        let start = variations.start(initial);
        let samples = flown(&mut variations, start, times)?;
        let mut observer = Observer::new(self);
        let row = |(&t, both): (&f64, &[f64])| {
            let sensitivity = DMatrix::from_fn(states, variations.columns(), |state, by| {
                variations.row(both, state)[by]
            });
            let at = conditions.at(t, variations.state(both));
            markers
                .iter()
                .map(|marker| observer.observe(at, marker, &sensitivity))
                .collect()
        };
        Ok(times
            .iter()
            .zip(samples.chunks(variations.len()))
            .map(row)
            .collect())
    }

    fn model<'a>(&'a self, conditions: &'a Conditions) -> Tapes<'a> {
        let wide = |pattern: &[(u32, u32)]| {
            pattern
                .iter()
                .map(|&(r, c)| (r as usize, c as usize))
                .collect()
        };
        Tapes {
            predictor: self,
            conditions,
            scratch: Scratch::default(),
            j: wide(self.tapes.j_pattern()),
            jp: wide(self.tapes.jp_pattern()),
        }
    }
}

impl Conditions {
    fn at<'a>(&'a self, t: f64, x: &'a [f64]) -> At<'a> {
        At {
            t,
            x,
            p: &self.parameters,
            prepared: &self.prepared,
        }
    }
}

/// Flies from the first of the times to the last, and gives the state at each.
fn flown(
    dynamics: &mut impl Dynamics<State = States>,
    start: States,
    times: &[f64],
) -> Result<Vec<f64>, String> {
    let mut samples = vec![0.0; start.len() * times.len()];
    let options = Options::tolerance(TOLERANCE);
    fly_at(
        dynamics,
        (times[0], &start),
        times,
        &options,
        &mut [],
        &mut samples,
    )
    .map_err(|error| error.to_string())?;
    Ok(samples)
}

/// The tapes of a model in the conditions of one flight.
struct Tapes<'a> {
    predictor: &'a Predictor,
    conditions: &'a Conditions,
    scratch: Scratch,
    j: Vec<(usize, usize)>,
    jp: Vec<(usize, usize)>,
}

impl Linearised for Tapes<'_> {
    fn states(&self) -> usize {
        self.predictor.tapes.states
    }

    fn state_pattern(&self) -> &[(usize, usize)] {
        &self.j
    }

    fn constant_pattern(&self) -> &[(usize, usize)] {
        &self.jp
    }

    fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        by_state: &mut [f64],
        by_constant: &mut [f64],
    ) {
        let at = self.conditions.at(t, x);
        self.predictor
            .tapes
            .f_jac_par(at, &mut self.scratch, dx, by_state, by_constant);
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.predictor
            .layout
            .states
            .get(state)
            .map_or_else(|| "a state".into(), |name| name.as_str().into())
    }
}

/// Space for observations.
struct Observer<'a> {
    predictor: &'a Predictor,
    scratch: Scratch,
    dy_dx: Vec<f64>,
    dy_dp: Vec<f64>,
    dy_dmarker: Vec<f64>,
}

impl<'a> Observer<'a> {
    fn new(predictor: &'a Predictor) -> Self {
        let tapes = &predictor.tapes;
        Self {
            predictor,
            scratch: Scratch::default(),
            dy_dx: vec![0.0; tapes.dy_dx_pattern().len()],
            dy_dp: vec![0.0; tapes.dy_dp_pattern().len()],
            dy_dmarker: vec![0.0; tapes.dy_dmarker_pattern().len()],
        }
    }

    fn observe(&mut self, at: At<'_>, marker: &[f64; 3], state: &DMatrix<f64>) -> Observed {
        let tapes = &self.predictor.tapes;
        let mut position = [0.0; 3];
        let results = [
            &mut position[..],
            &mut self.dy_dx,
            &mut self.dy_dp,
            &mut self.dy_dmarker,
        ];
        tapes.observe_jac(at, marker, &mut self.scratch, results);
        let mut sensitivity = DMatrix::zeros(3, state.ncols());
        for (&(row, by), &value) in tapes.dy_dx_pattern().iter().zip(&self.dy_dx) {
            for column in 0..state.ncols() {
                sensitivity[(row as usize, column)] += value * state[(by as usize, column)];
            }
        }
        for (&(row, parameter), &value) in tapes.dy_dp_pattern().iter().zip(&self.dy_dp) {
            sensitivity[(row as usize, tapes.states + parameter as usize)] += value;
        }
        Observed {
            position,
            sensitivity,
        }
    }
}
