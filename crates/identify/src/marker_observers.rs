//! How each marker is seen: by one observer for all, or by one each where the model asks which marker it is.

use flight::{BoundModel, CompiledModel, ModelObserver, ObservationJacobians};
use model_spec::layout::ParamId;

/// The input that says which marker is observed, `marker_is`: 1 in the place of the first, second or third.
const MARKER_IS: [&str; 3] = ["marker_is_x", "marker_is_y", "marker_is_z"];

/// The conditions of a flight under which each marker is observed.
pub struct MarkerConditions<'a>(Vec<BoundModel<'a>>);

impl<'a> MarkerConditions<'a> {
    /// One for all of `markers`, unless the model has the input `marker_is`.
    pub fn new(body: &'a CompiledModel, parameters: &[f64], markers: usize) -> Self {
        let places = MARKER_IS.map(|name| body.layout().parameter(name).map(ParamId::index));
        if places.iter().all(Option::is_none) {
            return Self(vec![body.bind(parameters.to_vec())]);
        }
        let each = (0..markers).map(|marker| {
            let mut parameters = parameters.to_vec();
            for (axis, place) in places.iter().enumerate() {
                if let Some(place) = *place {
                    parameters[place] = f64::from(u8::from(axis == marker));
                }
            }
            body.bind(parameters)
        });
        Self(each.collect())
    }

    /// What is seen under them.
    pub fn observers(&self) -> MarkerObservers<'_> {
        MarkerObservers(self.0.iter().map(BoundModel::observer).collect())
    }
}

/// Observers, of which each marker has its own.
pub struct MarkerObservers<'a>(Vec<ModelObserver<'a>>);

impl<'a> MarkerObservers<'a> {
    fn of(&mut self, marker: usize) -> &mut ModelObserver<'a> {
        let last = self.0.len() - 1;
        &mut self.0[marker.min(last)]
    }

    /// Where a marker is seen in the inertial frame, m; `position` is its place in the frame that it is fixed in, m.
    pub fn position(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> [f64; 3] {
        self.of(marker).position(t, x, position)
    }

    /// As [`position`](Self::position), with its derivatives.
    pub fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> ([f64; 3], ObservationJacobians<'_>) {
        self.of(marker).position_with_jacobians(t, x, position)
    }

    /// The model's named quantities, in the order of the layout.
    pub fn quantities(&mut self, t: f64, x: &[f64]) -> Vec<f64> {
        self.of(0).quantities(t, x)
    }
}
