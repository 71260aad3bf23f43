//! Projection of a state with its sensitivities.

use super::SensitivityLayout;
use crate::projection::{Project, Projection};

/// Projection of the augmented state: the columns of S become derivatives of the projected state, to first order in the
/// shift.
#[derive(Debug)]
pub(super) struct ProjectedSensitivities {
    of_states: Projection,
    layout: SensitivityLayout,
    /// Columns of S that are projected: all but those of parameters that move what is kept.
    columns: Vec<usize>,
}

impl ProjectedSensitivities {
    /// Projection of states with the `layout`, in which the last columns of S are derivatives by `parameters`.
    pub fn new(of_states: Projection, layout: SensitivityLayout, parameters: &[usize]) -> Self {
        let directions = layout.columns - parameters.len();
        let kept = parameters.iter().enumerate();
        let kept = kept.filter(|(_, parameter)| !of_states.depends_on(**parameter));
        let kept = kept.map(|(column, _)| directions + column);
        let columns = (0..directions).chain(kept).collect();
        ProjectedSensitivities {
            of_states,
            layout,
            columns,
        }
    }
}

impl Project for ProjectedSensitivities {
    fn project(&self, t: f64, augmented: &mut [f64]) -> bool {
        let (layout, columns) = (self.layout, &self.columns);
        let states = layout.state_range();
        let has_moved = self.of_states.project(t, &mut augmented[states.clone()]);
        if columns.is_empty() {
            return has_moved;
        }
        let place = |state: usize, column: usize| layout.first + state * layout.stride + column;
        let entries = columns.iter().flat_map(|&column| {
            let states = 0..layout.states;
            states.map(move |state| place(state, column))
        });
        let mut directions: Vec<f64> = entries.clone().map(|entry| augmented[entry]).collect();
        let x = &augmented[states];
        self.of_states.project_directions(t, x, &mut directions);
        for (entry, value) in entries.zip(directions) {
            augmented[entry] = value;
        }
        true
    }

    fn project_directions(&self, _: f64, _: &[f64], _: &mut [f64]) {}

    fn depends_on(&self, parameter: usize) -> bool {
        self.of_states.depends_on(parameter)
    }
}
