//! How an initial state is varied: freely, but for a quaternion's length and for states that are known.

use model_spec::model::Model;
use nalgebra::DVector;

/// The directions in which an initial state may be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct StateManifold {
    /// States that stand for themselves.
    plain: Vec<usize>,
    /// Groups of four that are unit quaternions, moved by three angles each.
    quaternions: Vec<[usize; 4]>,
    states: usize,
}

impl StateManifold {
    /// The chart of a model's state, with some states known.
    pub fn new(model: &Model, known: &[usize]) -> Self {
        // A quaternion is known as a whole or not at all.
        let quaternions: Vec<[usize; 4]> = model
            .quaternions()
            .filter(|states| !states.iter().any(|state| known.contains(state)))
            .collect();
        let turned: Vec<usize> = quaternions.iter().flatten().copied().collect();
        let plain = (0..model.states.len())
            .filter(|state| !known.contains(state) && !turned.contains(state))
            .collect();
        Self {
            plain,
            quaternions,
            states: model.states.len(),
        }
    }

    /// How many directions there are.
    pub fn dimension(&self) -> usize {
        self.plain.len() + 3 * self.quaternions.len()
    }

    /// How many states there are.
    pub fn states(&self) -> usize {
        self.states
    }

    /// The entries (state, direction, value) of the derivative of the state by the directions, at `state`.
    pub fn tangent(&self, state: &[f64]) -> Vec<(usize, usize, f64)> {
        let plain = self.plain.iter().enumerate();
        plain
            .map(|(column, &row)| (row, column, 1.0))
            .chain(self.turning(state))
            .collect()
    }

    /// Those of the entries that turn quaternions.
    fn turning(&self, state: &[f64]) -> impl Iterator<Item = (usize, usize, f64)> {
        let each = self.quaternions.iter().enumerate();
        each.flat_map(move |(index, &places)| {
            let [q0, q1, q2, q3] = places.map(|place| state[place]);
            // Half the product of the quaternion with each imaginary unit.
            let columns = [[-q1, q0, q3, -q2], [-q2, -q3, q0, q1], [-q3, q2, -q1, q0]];
            let first = self.plain.len() + 3 * index;
            (0..12).map(move |entry| {
                let (k, place) = (entry / 4, entry % 4);
                (places[place], first + k, columns[k][place] / 2.0)
            })
        })
    }

    /// The state that a direction moves, where it moves no other.
    pub fn plain(&self, direction: usize) -> Option<usize> {
        self.plain.get(direction).copied()
    }

    /// The state after a step along the directions.
    pub fn plus(&self, state: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        let mut plus = state.clone();
        for (&row, step) in self.plain.iter().zip(step.iter()) {
            plus[row] += step;
        }
        for (row, column, value) in self.turning(state.as_slice()) {
            plus[row] += value * step[column];
        }
        for places in &self.quaternions {
            let length = places.map(|place| plus[place].powi(2)).iter().sum::<f64>();
            for &place in places {
                plus[place] /= length.sqrt();
            }
        }
        plus
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
        let places = manifold.quaternions[0];
        for (place, value) in places.iter().zip([0.5, -0.5, 0.1, 0.7]) {
            state[*place] = value;
        }
        let state = manifold.plus(&state, &DVector::zeros(12));
        let step = DVector::from_fn(12, |i, _| 1e-6 * (i as f64 - 5.0));
        let plus = manifold.plus(&state, &step);
        let length: f64 = places.iter().map(|&place| plus[place].powi(2)).sum();
        assert!((length - 1.0).abs() < 1e-14);
        let mut linear = state.clone();
        for (row, column, value) in manifold.tangent(state.as_slice()) {
            linear[row] += value * step[column];
        }
        assert!((plus - linear).norm() < 1e-10);
    }

    #[test]
    fn known_states_stay() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let manifold = StateManifold::new(&model, &[11]);
        assert_eq!(manifold.dimension(), 11);
        let plus = manifold.plus(&DVector::zeros(12), &DVector::from_element(11, 1.0));
        assert_eq!(plus[11], 0.0);
    }
}
