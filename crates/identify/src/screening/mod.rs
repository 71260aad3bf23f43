//! Screening of a dataset before a fit: mistakes of the laboratory that a fit cannot recover from, found by the
//! distances between markers, by poses and by free fall, without the aerodynamic model.

mod fault;

pub use fault::{DataFault, FaultKind};

use crate::dataset::Dataset;
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::options::FitOptions;
use crate::problem::FitProblem;

/// Faults of a dataset's flights, in the dataset's order.
pub(crate) fn screen(_problem: &FitProblem, _dataset: &Dataset, _threads: usize) -> Vec<DataFault> {
    Vec::new()
}

/// Flights that are excluded because of their faults; none if the options trust the data.
pub(crate) fn excluded(
    dataset: &Dataset,
    faults: &[DataFault],
    options: &FitOptions<'_>,
) -> Vec<ExcludedFlight> {
    let mut excluded = Vec::new();
    if options.trust_data {
        return excluded;
    }
    for (index, flight) in dataset.flights.iter().enumerate() {
        let fault = faults.iter().find(|fault| fault.file == flight.file);
        excluded.extend(fault.map(|fault| ExcludedFlight {
            flight: FlightId::new(index),
            file: flight.file.clone(),
            reason: FlightError::DataFault(fault.clone()),
        }));
    }
    excluded
}
