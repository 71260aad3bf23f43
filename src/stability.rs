//! Stability of the motion about a state of flight.

use analysis::stability::{Body, Instant, ModeKind, at};

use crate::{Error, Model, Release};

/// A mode of the linearised motion: a real eigenvalue or a conjugate pair.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Mode {
    /// Name by the variables that change most, such as `nutation`.
    pub name: &'static str,
    /// Real part of the eigenvalue, 1/s; negative for a decaying mode.
    pub growth: f64,
    /// Angular frequency of the oscillation, rad/s; 0 for a real eigenvalue.
    pub frequency: f64,
}

/// Modes and stability criteria at a release.
#[derive(Clone, Debug)]
pub struct Stability(Instant);

impl Stability {
    /// Linearises the motion of a model at the state of a release.
    ///
    /// # Errors
    /// [`Error::Stability`] if the model has no body or cannot be linearised there.
    ///
    /// ```
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let disc = hyzer::Model::load("disc")?;
    /// let stability = hyzer::Stability::of(&disc, &disc.release("backhand")?)?;
    /// assert!(stability.modes().any(|mode| mode.name == "nutation" && mode.frequency > 0.0));
    /// # Ok(())
    /// # }
    /// ```
    pub fn of(model: &Model, release: &Release) -> Result<Stability, Error> {
        let body = Body::new(model.checked().clone())?;
        let bound = body.with_parameters(body.compiled.release_parameters(release));
        Ok(Stability(at(&bound, 0.0, &release.state())?))
    }

    /// Modes of the linearised motion, in order of decreasing magnitude of the eigenvalue.
    pub fn modes(&self) -> impl Iterator<Item = Mode> {
        self.0.modes.modes.iter().map(|mode| Mode {
            name: ModeKind::name(mode.kind),
            growth: mode.value.re,
            frequency: mode.frequency(),
        })
    }

    /// Gyroscopic stability factor: above 1 the axis is stable; infinite or negative where nothing destabilises it.
    pub fn gyroscopic_factor(&self) -> f64 {
        self.0.criteria.gyroscopic_factor
    }

    /// Whether the criteria of the body's axis all hold at the release.
    pub fn is_stable(&self) -> bool {
        self.0.criteria.is_stable()
    }
}
