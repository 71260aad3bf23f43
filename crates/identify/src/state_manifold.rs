//! The manifold of initial states: unit quaternions vary by three angles, and known states do not vary.

use model_spec::layout::StateId;
use model_spec::model::Model;
use nalgebra::DVector;

use crate::ids::LocalId;

/// Directions in which an initial state may vary: one per free state, and three per unit quaternion.
#[derive(Clone, Debug, PartialEq)]
pub struct StateManifold {
    /// Indices of the states that vary and belong to no quaternion. The first directions of the manifold are the
    /// changes of these states, in this order.
    direct: Vec<usize>,
    /// State indices of the four components of each unit quaternion that varies; each has three directions.
    quaternions: Vec<[usize; 4]>,
    states: usize,
}

impl StateManifold {
    /// Manifold of the states of a model, of which the states `known` do not vary. A quaternion with a known component
    /// does not vary at all, so that its norm remains 1.
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
        }
    }

    /// Number of directions in which the state may vary.
    pub fn dimension(&self) -> usize {
        self.direct.len() + 3 * self.quaternions.len()
    }

    /// Number of components of the state.
    pub fn states(&self) -> usize {
        self.states
    }

    /// Entries (state index, direction index, value), all others being zero, of the derivative of the state with
    /// respect to the directions in which it may vary, at `state`. The directions of a quaternion are the components of
    /// a small rotation vector, rad, in the axes of the frame that the quaternion orients.
    pub fn tangent(&self, state: &[f64]) -> Vec<(usize, usize, f64)> {
        let direct = self.direct.iter().enumerate();
        direct
            .map(|(direction, &state)| (state, direction, 1.0))
            .chain(self.quaternion_tangent(state))
            .collect()
    }

    /// Entries (state index, direction index, value), all others being zero, of the derivative of the state with
    /// respect to the directions in which it may vary, at `state`, for the states that are components of
    /// quaternions. The three directions of a quaternion are the components of a small rotation vector, rad, in the
    /// axes of the frame that it orients.
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

    /// Index of the state that varies along `direction`; `None` if `direction` belongs to a quaternion, whose four
    /// components vary together.
    pub fn direct_state(&self, direction: LocalId) -> Option<StateId> {
        let state = self.direct.get(direction.index())?;
        Some(StateId::new(*state))
    }

    /// Returns the state after a step along the directions in which it may vary. `step` has one element per direction:
    /// first the changes of the free states, SI, then for each quaternion the three components of a rotation vector,
    /// rad, in the axes of the frame that the quaternion orients. A quaternion is changed to first order in its
    /// rotation vector and then normalised.
    pub fn plus(&self, state: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        let mut moved = state.clone();
        for (&row, step) in self.direct.iter().zip(step.iter()) {
            moved[row] += step;
        }
        for (row, direction, value) in self.quaternion_tangent(state.as_slice()) {
            moved[row] += value * step[direction];
        }
        for components in &self.quaternions {
            let squares = components.map(|component| moved[component].powi(2));
            let length = squares.iter().sum::<f64>().sqrt();
            for &component in components {
                moved[component] /= length;
            }
        }
        moved
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
