//! Measurement equations of the markers: one for all markers, or one per marker if the model has per-marker
//! parameters.

use flight::{BoundModel, CompiledModel, ModelObserver, ObservationJacobians};
use model_spec::layout::ParamId;

/// Components of the input `marker_is`, by which effects refer to single markers: component k is 1 for marker k and 0 for
/// all others.
const MARKER_IS: [&str; 3] = ["marker_is_x", "marker_is_y", "marker_is_z"];

/// Bound models, one per marker and one for points that are no markers, or one shared by all, for the measurement equations.
pub struct MarkerConditions<'a>(Vec<BoundModel<'a>>);

impl<'a> MarkerConditions<'a> {
    /// Binds the same parameters for all `markers` markers; with the input `marker_is`, one model per marker.
    pub fn new(body: &'a CompiledModel, parameters: &[f64], markers: usize) -> Self {
        let places = MARKER_IS.map(|name| body.layout().parameter(name).map(ParamId::index));
        if places.iter().all(Option::is_none) {
            return Self(vec![body.bind(parameters.to_vec())]);
        }
        let bound = |marker: Option<usize>| {
            let mut parameters = parameters.to_vec();
            for (axis, place) in places.iter().enumerate() {
                if let Some(place) = *place {
                    parameters[place] = f64::from(u8::from(Some(axis) == marker));
                }
            }
            body.bind(parameters)
        };
        // The last is for points that are no markers.
        let each = (0..markers).map(Some).chain([None]);
        Self(each.map(bound).collect())
    }

    /// Evaluators of the measurement equations.
    pub fn observers(&self) -> MarkerObservers<'_> {
        MarkerObservers(self.0.iter().map(BoundModel::observer).collect())
    }
}

/// Evaluators of the markers' measurement equations.
pub struct MarkerObservers<'a>(Vec<ModelObserver<'a>>);

impl<'a> MarkerObservers<'a> {
    fn of(&mut self, marker: usize) -> &mut ModelObserver<'a> {
        let last = self.0.len() - 1;
        &mut self.0[marker.min(last)]
    }

    /// Predicted position of a marker in the inertial frame, m, at time `t` (s) and state `x`; `position` is its position in the
    /// frame that it is fixed in, m.
    pub fn position(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> [f64; 3] {
        self.of(marker).position(t, x, position)
    }

    /// Predicted marker position like [`position`](Self::position), with its derivatives.
    pub fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> ([f64; 3], ObservationJacobians<'_>) {
        self.of(marker).position_with_jacobians(t, x, position)
    }
}
