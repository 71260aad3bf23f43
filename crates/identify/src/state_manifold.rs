//! The manifold of initial states: unit quaternions vary by three angles, known states do not vary, and constraints hold.

use std::sync::Arc;

use flight::{CompiledModel, Constraints};
use model_spec::layout::StateId;
use model_spec::model::Model;
use nalgebra::{DMatrix, DVector};

use crate::ids::LocalId;

/// Directions in which an initial state may vary: one per free state, and three per unit quaternion; of these, what
/// keeps the constraints of the model to first order.
#[derive(Clone, Debug)]
pub struct StateManifold {
    /// States that vary and belong to no quaternion: the first directions of the manifold.
    direct: Vec<usize>,
    /// State indices of the four components of each unit quaternion that varies; each has three directions.
    quaternions: Vec<[usize; 4]>,
    states: usize,
    /// Constraints of the model, and the parameters of the flight.
    held: Option<(Arc<Constraints>, Vec<f64>)>,
}

impl StateManifold {
    /// Manifold of the states of a model of which `known` do not vary; a quaternion with a known component does not
    /// vary.
    pub fn new(model: &Model, known: &[StateId]) -> Self {
        let is_known = |state: usize| known.contains(&StateId::new(state));
        let all: Vec<[usize; 4]> = model.quaternions().collect();
        let in_quaternion: Vec<usize> = all.iter().flatten().copied().collect();
        let direct = (0..model.states.len())
            .filter(|&state| !is_known(state) && !in_quaternion.contains(&state))
            .collect();
        let free = |states: &[usize; 4]| !states.iter().any(|&state| is_known(state));
        Self {
            direct,
            quaternions: all.into_iter().filter(free).collect(),
            states: model.states.len(),
            held: None,
        }
    }

    /// The part of the manifold on which the constraints of `body`, the same model compiled, hold with `parameters`.
    pub fn held_by(mut self, body: &CompiledModel, parameters: &[f64]) -> Self {
        let constraints = body.constraints().cloned();
        self.held = constraints.map(|own| (own, parameters.to_vec()));
        self
    }

    /// Whether constraints hold on the manifold.
    pub fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Number of directions in which the state may vary.
    pub fn dimension(&self) -> usize {
        let held = self.held.as_ref().map_or(0, |(own, _)| own.count());
        self.free().saturating_sub(held)
    }

    /// Number of directions without constraints.
    fn free(&self) -> usize {
        self.direct.len() + 3 * self.quaternions.len()
    }

    /// Number of components of the state.
    pub fn states(&self) -> usize {
        self.states
    }

    /// Entries (state, direction, value) of the derivative of the state by its directions, at `state`. Those of a
    /// quaternion are a small rotation vector, rad, in the axes of the frame that it orients. With constraints, the
    /// directions are orthonormal in these.
    pub fn tangent(&self, state: &[f64]) -> Vec<(usize, usize, f64)> {
        let Some(kept) = self.kept(state) else {
            return self.free_tangent(state);
        };
        let entries =
            (0..kept.ncols()).flat_map(|column| (0..kept.nrows()).map(move |row| (row, column)));
        entries
            .map(|(row, column)| (row, column, kept[(row, column)]))
            .filter(|entry| entry.2 != 0.0)
            .collect()
    }

    /// Derivative of the state by the directions that keep the constraints; `None` without constraints.
    fn kept(&self, state: &[f64]) -> Option<DMatrix<f64>> {
        let (constraints, parameters) = self.held.as_ref()?;
        let (_, by_state) = constraints.bind(parameters.clone()).deviations(0.0, state);
        let free = self.free_matrix(state);
        let along = by_state * &free;
        let system = along.tr_mul(&along).symmetric_eigen();
        let mut order: Vec<usize> = (0..self.free()).collect();
        order.sort_by(|&a, &b| system.eigenvalues[a].total_cmp(&system.eigenvalues[b]));
        let columns = order.iter().take(self.dimension());
        let columns: Vec<_> = columns.map(|&k| system.eigenvectors.column(k)).collect();
        Some(match columns.is_empty() {
            true => DMatrix::zeros(self.states, 0),
            false => free * DMatrix::from_columns(&columns),
        })
    }

    /// Derivative of the state by the directions without constraints, as a matrix.
    fn free_matrix(&self, state: &[f64]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.states, self.free());
        for (row, direction, value) in self.free_tangent(state) {
            matrix[(row, direction)] = value;
        }
        matrix
    }

    /// As [`tangent`](Self::tangent), without constraints.
    fn free_tangent(&self, state: &[f64]) -> Vec<(usize, usize, f64)> {
        let direct = self.direct.iter().enumerate();
        direct
            .map(|(direction, &state)| (state, direction, 1.0))
            .chain(self.quaternion_tangent(state))
            .collect()
    }

    /// The entries of [`tangent`](Self::tangent) that belong to quaternions.
    fn quaternion_tangent(&self, state: &[f64]) -> impl Iterator<Item = (usize, usize, f64)> {
        let each = self.quaternions.iter().enumerate();
        each.flat_map(move |(index, &components)| {
            let [q0, q1, q2, q3] = components.map(|component| state[component]);
            // Half the product of the quaternion with each imaginary unit.
            let columns = [[-q1, q0, q3, -q2], [-q2, -q3, q0, q1], [-q3, q2, -q1, q0]];
            let first = self.direct.len() + 3 * index;
            (0..12).map(move |entry| {
                let (k, component) = (entry / 4, entry % 4);
                (
                    components[component],
                    first + k,
                    columns[k][component] / 2.0,
                )
            })
        })
    }

    /// State that varies along `direction`; `None` if it belongs to a quaternion, or constraints couple the states.
    pub fn direct_state(&self, direction: LocalId) -> Option<StateId> {
        if self.is_held() {
            return None;
        }
        let state = self.direct.get(direction.index())?;
        Some(StateId::new(*state))
    }

    /// The state after a step along the directions: changes of free states, SI, then a rotation vector for each
    /// quaternion, rad, which is changed to first order and normalised. With constraints, the nearest state at which they
    /// hold.
    pub fn plus(&self, state: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        let mut moved = state.clone();
        if let (Some(kept), Some((constraints, parameters))) =
            (self.kept(state.as_slice()), &self.held)
        {
            moved += kept * step;
            self.normalise(&mut moved);
            let directions = self.free_matrix(moved.as_slice());
            let bound = constraints.bind(parameters.clone());
            bound.project(0.0, moved.as_mut_slice(), Some(&directions));
            self.normalise(&mut moved);
            return moved;
        }
        for (&row, step) in self.direct.iter().zip(step.iter()) {
            moved[row] += step;
        }
        for (row, direction, value) in self.quaternion_tangent(state.as_slice()) {
            moved[row] += value * step[direction];
        }
        self.normalise(&mut moved);
        moved
    }

    fn normalise(&self, moved: &mut DVector<f64>) {
        for components in &self.quaternions {
            let squares = components.map(|component| moved[component].powi(2));
            let length = squares.iter().sum::<f64>().sqrt();
            for &component in components {
                moved[component] /= length;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quaternion_moves_on_its_sphere_and_along_its_tangent() {
        let model = model_spec::load::load("disc_quaternion", &[]).unwrap();
        let manifold = StateManifold::new(&model, &[]);
        assert_eq!((manifold.states(), manifold.dimension()), (13, 12));
        let mut state = DVector::zeros(13);
        let components = manifold.quaternions[0];
        for (component, value) in components.iter().zip([0.5, -0.5, 0.1, 0.7]) {
            state[*component] = value;
        }
        let state = manifold.plus(&state, &DVector::zeros(12));
        let step = DVector::from_fn(12, |i, _| 1e-6 * (i as f64 - 5.0));
        let moved = manifold.plus(&state, &step);
        let squares = components.iter().map(|&component| moved[component].powi(2));
        assert!((squares.sum::<f64>() - 1.0).abs() < 1e-14);
        let mut linear = state.clone();
        for (row, direction, value) in manifold.tangent(state.as_slice()) {
            linear[row] += value * step[direction];
        }
        assert!((moved - linear).norm() < 1e-10);
    }

    #[test]
    fn one_known_component_fixes_the_quaternion() {
        let model = model_spec::load::load("disc_quaternion", &[]).unwrap();
        let components = model.quaternions().next().unwrap();
        let manifold = StateManifold::new(&model, &[StateId::new(components[2])]);
        assert_eq!(manifold.dimension(), 9);
        let mut state = DVector::zeros(13);
        state[components[0]] = 1.0;
        let moved = manifold.plus(&state, &DVector::from_element(9, 1.0));
        assert_eq!(
            components.map(|component| moved[component]),
            [1.0, 0.0, 0.0, 0.0]
        );
    }

    #[test]
    fn known_states_do_not_vary() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let manifold = StateManifold::new(&model, &[StateId::new(11)]);
        assert_eq!(manifold.dimension(), 11);
        let moved = manifold.plus(&DVector::zeros(12), &DVector::from_element(11, 1.0));
        assert_eq!(moved[11], 0.0);
    }
}
