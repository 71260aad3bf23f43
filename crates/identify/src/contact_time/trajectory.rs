//! Fitted trajectory of a flight at its samples, with derivatives with respect to the initial state.

use std::ops::Range;

use nalgebra::{DVector, Matrix3xX};

use crate::error::FlightError;
use crate::observations::Observations;
use crate::predict::each_residual;
use crate::problem::FitProblem;
use crate::state_manifold::StateManifold;

/// Predicted marker positions of a flight, with derivatives with respect to the initial state.
pub struct Trajectory {
    /// Number of independent directions in which the initial state may vary (see [`StateManifold`]); smaller than the
    /// number of its components if it contains a quaternion.
    pub dimension: usize,
    /// Index of the first sample of the trajectory.
    pub first: usize,
    /// Predicted markers at each sample from `first` on.
    pub samples: Vec<Vec<Predicted>>,
}

/// Predicted position of one marker at one time.
#[derive(Clone, Debug)]
pub struct Predicted {
    /// Predicted position in the inertial frame, m.
    pub position: [f64; 3],
    /// Derivatives of each coordinate of `position` with respect to the initial state, one entry for each direction in
    /// which the state may vary (see [`StateManifold`]).
    pub derivatives: [DVector<f64>; 3],
}

impl Trajectory {
    /// Computes the trajectory at the samples `seen`. `unknowns` are the global parameters and the initial state.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn new(
        problem: &FitProblem,
        observations: &Observations,
        unknowns: (&DVector<f64>, &DVector<f64>),
        seen: Range<usize>,
    ) -> Result<Self, FlightError> {
        let manifold = StateManifold::new(&problem.model, &[]);
        let (dimension, markers) = (manifold.dimension(), observations.markers);
        let evaluated = Observations {
            measured: vec![Some([0.0; 3]); seen.end * markers],
            manifold,
            known_states: Vec::new(),
            ..observations.first_samples(seen.end)
        };
        let conditions = problem.body.bind(evaluated.parameters(problem, unknowns.0));
        let mut motion = conditions.rhs();
        let mut samples = vec![Vec::with_capacity(markers); seen.len()];
        each_residual(
            problem,
            &evaluated,
            unknowns,
            &mut motion,
            &[],
            &mut |point| {
                if point.sample >= seen.start {
                    let rows = point.rows.each_ref();
                    samples[point.sample - seen.start].push(Predicted {
                        position: point.residual,
                        derivatives: rows.map(|row| DVector::from_column_slice(row)),
                    });
                }
            },
        )?;
        Ok(Self {
            dimension,
            first: seen.start,
            samples,
        })
    }

    /// Predicted markers in a sample.
    pub fn markers(&self, sample: usize) -> &[Predicted] {
        &self.samples[sample - self.first]
    }

    /// Derivatives of the mean predicted position of the markers in a sample with respect to the initial state of the
    /// flight: one row per coordinate.
    pub fn centre(&self, sample: usize) -> Matrix3xX<f64> {
        let markers = self.markers(sample);
        Matrix3xX::from_fn(self.dimension, |axis, column| {
            let each = markers
                .iter()
                .map(|marker| marker.derivatives[axis][column]);
            each.sum::<f64>() / markers.len() as f64
        })
    }
}
