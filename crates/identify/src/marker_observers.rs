//! Measurement equations of the markers: one for all markers, or one per marker if the model has per-marker
//! parameters.

use flight::{BoundModel, CompiledModel, ModelObserver, ObservationJacobians};
use model_spec::layout::ParamId;

/// Components of the model input `marker_is`, with which effects refer to single markers: component k is 1 in the
/// measurement equation of marker k and 0 in all others.
const MARKER_IS: [&str; 3] = ["marker_is_x", "marker_is_y", "marker_is_z"];

/// Models with given parameter values for the measurement equations of the markers. One model serves all points; but if
/// the model has the input `marker_is`, there is one per marker and a last one for points that are not markers.
pub struct MarkerConditions<'a>(Vec<BoundModel<'a>>);

impl<'a> MarkerConditions<'a> {
    /// Binds the model `body` to the values `parameters`; if the model has the input `marker_is`, once for each of the
    /// `markers` markers, because the value of that input depends on the marker.
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
        // The last model is for points that are not markers.
        let each = (0..markers).map(Some).chain([None]);
        Self(each.map(bound).collect())
    }

    /// Returns evaluators of the measurement equations of the markers.
    pub fn observers(&self) -> MarkerObservers<'_> {
        MarkerObservers(self.0.iter().map(BoundModel::observer).collect())
    }
}

/// Evaluators of the markers' measurement equations: predicted positions from state and time.
pub struct MarkerObservers<'a>(Vec<ModelObserver<'a>>);

impl<'a> MarkerObservers<'a> {
    fn of(&mut self, marker: usize) -> &mut ModelObserver<'a> {
        let last = self.0.len() - 1;
        &mut self.0[marker.min(last)]
    }

    /// Predicted position of a marker in the inertial frame, m, at time `t` (s) and state `x`. `marker` is its index
    /// and `position` its coordinates in the frame in which it is fixed, m.
    pub fn position(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> [f64; 3] {
        self.of(marker).position(t, x, position)
    }

    /// Predicted position of a marker in the inertial frame, m, at time `t` (s) and state `x`, with its Jacobians with
    /// respect to state and parameters. `marker` is its index and `position` its coordinates in the frame in which it
    /// is fixed, m.
    pub fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        (marker, position): (usize, &[f64; 3]),
    ) -> ([f64; 3], ObservationJacobians<'_>) {
        self.of(marker).position_with_jacobians(t, x, position)
    }
}
