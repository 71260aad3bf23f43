//! States and parameters of two models, paired by name.

use model_spec::Layout;
use oracle::Point;
use oracle::scalar::Field;

/// States and parameters of a new model: index of that of the same name in an old one.
pub struct Pairing {
    /// For each state of the new model, the index of the state in the old one.
    pub states: Vec<Option<usize>>,
    parameters: Vec<Option<usize>>,
}

impl Pairing {
    /// Pairs the states and parameters of two models.
    pub fn of(old: &Layout, new: &Layout) -> Self {
        let by_name = |old: &[String], new: &[String]| {
            let place = |name| old.iter().position(|o| o == name);
            new.iter().map(place).collect()
        };
        Self {
            states: by_name(&old.states, &new.states),
            parameters: by_name(&old.parameters, &new.parameters),
        }
    }

    /// Whether the old model has all names of the new one.
    pub fn is_complete(&self) -> bool {
        let all = self.states.iter().chain(&self.parameters);
        all.into_iter().all(Option::is_some)
    }

    /// The point `there` of the new model with paired values, time and marker of the point `here`.
    pub fn carry<T: Field>(&self, here: &Point<T>, there: &Point<T>) -> Point<T> {
        let given = here.parameters();
        let mut out = there.clone();
        out.time = here.time;
        out.marker = here.marker;
        for (to, from) in out.states.iter_mut().zip(&self.states) {
            *to = from.map_or(*to, |from| here.states[from]);
        }
        for (to, from) in out.parameters_mut().zip(&self.parameters) {
            *to = from.map_or(*to, |from| given[from]);
        }
        out
    }
}
