//! Quantities that differ from throw to throw, as one normal distribution: quantities of the throw, the wind,
//! coefficients.

use nalgebra::{DMatrix, DVector};

use crate::Estimates;
use crate::design::bounds::Scatter;
use crate::design::throw_flight::{By, ThrowFlights};

/// Normal distribution of the quantities that differ from throw to throw.
#[derive(Clone, Debug, PartialEq)]
pub struct Scattered {
    /// The quantities, in the order of the rows of `covariance`.
    pub by: Vec<By>,
    /// Covariance matrix, in the units of the quantities.
    pub covariance: DMatrix<f64>,
}

impl Scattered {
    /// Independent distributions of release, wind and parameters; the wind is ignored if the model has none.
    pub fn of(flights: &ThrowFlights<'_>, scatter: &Scatter) -> Scattered {
        let release = scatter.release.iter().filter(|(_, sd)| *sd > 0.0);
        let release = release.map(|(field, sd)| (By::Throw(*field), *sd));
        let mut all: Vec<(By, f64)> = release.collect();
        let components = flights.body.compiled.layout().components("wind");
        for (component, sd) in components.into_iter().flatten().zip(scatter.wind) {
            if sd > 0.0 {
                all.push((By::Parameter(component.index()), sd));
            }
        }
        let parameters = scatter.parameters.iter().filter(|(_, sd)| *sd > 0.0);
        all.extend(parameters.map(|(index, sd)| (By::Parameter(*index), *sd)));
        let variances = DVector::from_iterator(all.len(), all.iter().map(|(_, sd)| sd * sd));
        Scattered {
            by: all.iter().map(|(by, _)| *by).collect(),
            covariance: DMatrix::from_diagonal(&variances),
        }
    }

    /// Adds the standard errors and correlations of coefficients; also returns the names that the model does not have.
    pub fn with_coefficients(
        mut self,
        flights: &ThrowFlights<'_>,
        estimates: &Estimates,
    ) -> (Scattered, Vec<String>) {
        let layout = flights.body.compiled.layout();
        let (mut known, mut unknown) = (Vec::new(), Vec::new());
        for own in &estimates.coefficients {
            match (layout.parameter(&own.name), own.std_error) {
                (Some(id), Some(error)) => known.push((own.name.as_str(), id.index(), error)),
                (Some(_), None) => {}
                (None, _) => unknown.push(own.name.clone()),
            }
        }
        let first = self.by.len();
        let mut covariance = self
            .covariance
            .resize(first + known.len(), first + known.len(), 0.0);
        let correlation = |a: &str, b: &str| {
            let is_pair = |(x, y, _): &&(String, String, f64)| x == a && y == b || x == b && y == a;
            let found = estimates.correlations.iter().find(is_pair);
            found.map_or(0.0, |(.., value)| *value)
        };
        for (i, (a, place, error)) in known.iter().enumerate() {
            self.by.push(By::Parameter(*place));
            for (j, (b, _, other)) in known.iter().enumerate() {
                let correlation = if i == j { 1.0 } else { correlation(a, b) };
                covariance[(first + i, first + j)] = correlation * error * other;
            }
        }
        self.covariance = covariance;
        (self, unknown)
    }

    /// Matrix L with L Lᵀ equal to the covariance matrix, which may be singular.
    pub(super) fn root(&self) -> DMatrix<f64> {
        let eigen = self.covariance.clone().symmetric_eigen();
        let sizes = eigen.eigenvalues.map(|value| value.max(0.0).sqrt());
        eigen.eigenvectors * DMatrix::from_diagonal(&sizes)
    }
}
