//! Derivatives of a flight by the samples of an input over time: what an error of each sample does to the states.

use model_spec::layout::ParamId;
use ode::{IntegrationError, IntegrationOptions, Sensitivities};

use crate::inputs::RecordedInput;
use crate::{BasisLoads, BoundModel, parallel};

/// Number of samples whose derivatives are integrated together.
const TOGETHER: usize = 32;

impl BoundModel<'_> {
    /// Derivatives of the states at `times`, s, by each sample of the input `id`, of a flight that begins at the time
    /// `start.0` with the states `start.1`: for each sample those of all states at the first time, then at the next one.
    /// A delay or a lag of the input is part of them. Empty if the input is constant.
    ///
    /// # Errors
    /// [`IntegrationError`] if the flight cannot be integrated.
    pub fn derivatives_by_samples(
        &self,
        id: ParamId,
        start: (f64, &[f64]),
        times: &[f64],
        options: &IntegrationOptions,
    ) -> Result<Vec<Vec<f64>>, IntegrationError> {
        let Some(input) = self.inputs.iter().find(|own| own.value == id) else {
            return Ok(Vec::new());
        };
        let samples = input.series.samples().count();
        let parts = samples.div_ceil(TOGETHER);
        let found = parallel::each(parts, |part| {
            let first = part * TOGETHER;
            let some = first..samples.min(first + TOGETHER);
            self.derivatives_by(input, some, start, times, options)
        });
        let found: Vec<_> = found.into_iter().collect::<Result<_, _>>()?;
        Ok(found.into_iter().flatten().collect())
    }

    /// The derivatives by some samples of an input.
    fn derivatives_by(
        &self,
        input: &RecordedInput,
        samples: std::ops::Range<usize>,
        (t, state): (f64, &[f64]),
        times: &[f64],
        options: &IntegrationOptions,
    ) -> Result<Vec<Vec<f64>>, IntegrationError> {
        // The input, its rate and its lag are linear in the samples: each derivative is that of a unit sample.
        let units: Vec<_> = samples.clone().map(|k| input.unit(k)).collect();
        let responses: Vec<_> = units
            .iter()
            .map(|unit| unit.responses(&self.parameters))
            .collect();
        let first = self.model.layout.parameters.len();
        let varies = input.parameters();
        let columns = first..first + units.len();
        let loads: Vec<(ParamId, usize)> = columns
            .clone()
            .flat_map(|column| varies.iter().flatten().map(move |id| (*id, column)))
            .collect();
        let each = varies.iter().flatten().count();
        let basis = |t: f64, _: &[f64], values: &mut [f64]| {
            let unit = units.iter().zip(&responses);
            for ((unit, known), values) in unit.zip(values.chunks_mut(each)) {
                let all = unit.at(t, known, |id| self.parameters[id.index()]);
                let own = varies.iter().zip(all).filter(|(id, _)| id.is_some());
                for (value, (_, of_unit)) in values.iter_mut().zip(own) {
                    *value = of_unit;
                }
            }
        };
        let delay = input.delay.map_or(0.0, |id| self.parameters[id.index()]);
        let knots = input.series.samples().map(|(t, _)| t + delay);
        let mut motion = BasisLoads::new(self, &loads, basis).with_breaks(knots);
        let columns: Vec<usize> = columns.collect();
        let mut augmented = Sensitivities::new(&mut motion, 0, &columns);
        let layout = augmented.layout();
        let begin = augmented.initial_state(state, &[]);
        let mut along = vec![0.0; times.len() * augmented.len()];
        let rows = augmented.len();
        augmented.integrate_at((t, &begin), times, options, &mut [], &mut along)?;
        let by_sample = (0..columns.len()).map(|column| {
            let at_times = along.chunks(rows);
            let states = at_times.flat_map(|augmented| {
                (0..state.len()).map(move |row| layout.padded_row(augmented, row)[column])
            });
            states.collect()
        });
        Ok(by_sample.collect())
    }
}
