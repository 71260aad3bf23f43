//! One set of coefficients for all flights, and each flight's initial state, by least squares.

use std::collections::BTreeMap;

use model_spec::model::Model;
use nalgebra::DVector;

use crate::dataset::{Dataset, Flight, Known, Role};
use crate::levenberg::{Failure, Point, Problem, Solution, solve};
use crate::normal::{Block, Eliminated, eliminate};
use crate::predict::{Conditions, Predictor};
use crate::report::{Coefficient, Estimate, FlightReport, Iterations, Noise, Report, Undetermined};
use crate::start;

/// The part of a held-out flight that its initial state is fitted on; the rest is predicted.
const HELD_OUT_START: f64 = 0.3;

/// Why a dataset cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The dataset and the model do not go together.
    #[error("{0}")]
    Mismatch(String),
    /// A flight cannot be used.
    #[error("{file}: {reason}")]
    Flight {
        /// Its file.
        file: String,
        /// In words.
        reason: String,
    },
    /// The least squares have no solution.
    #[error("{0}")]
    Unsolved(String),
}

/// Fits all coefficients of a model to a dataset's flights.
///
/// # Errors
/// See [`FitError`].
pub fn fit(model: &Model, dataset: &Dataset) -> Result<Report, FitError> {
    let begun = std::time::Instant::now();
    let setting = Setting::new(model, dataset)?;
    let fitted: Vec<&Flight> = dataset
        .flights
        .iter()
        .filter(|flight| flight.role == Role::Fit)
        .collect();
    if fitted.is_empty() {
        return Err(FitError::Mismatch(
            "every flight is held out: none is left to fit".into(),
        ));
    }
    let own = fitted
        .iter()
        .map(|flight| setting.start(flight))
        .collect::<Result<_, _>>()?;
    let free = setting.free.iter().map(|&place| setting.parameters[place]);
    let start = Point {
        shared: DVector::from_iterator(setting.free.len(), free),
        own,
    };
    let problem = Squares {
        setting: &setting,
        flights: fitted,
        held: None,
    };
    let solution = solve(&problem, start).map_err(|failure| problem.told(failure))?;
    // Once for all flights, so that the work stays proportional to their number.
    let system = eliminate(&solution.blocks, 0.0)
        .map_err(|singular| problem.told(Failure::Singular(singular)))?;
    let mut report = setting.report(model, &system, &solution)?;
    let sigma = report.noise.sigma_m;
    let mut indices = 0_usize..;
    for flight in &dataset.flights {
        report.flights.push(match flight.role {
            Role::Fit => {
                let index = indices.next().unwrap_or_default();
                setting.fitted(flight, index, &system, &solution, sigma)
            }
            Role::HeldOut => setting.held_out(flight, &solution.point.shared, sigma)?,
        });
    }
    report.seconds = BTreeMap::from([("total".to_owned(), begun.elapsed().as_secs_f64())]);
    Ok(report)
}

/// The model with what the dataset knows of it.
struct Setting {
    predictor: Predictor,
    /// Parameters in the order of the layout, before a flight's own known inputs.
    parameters: Vec<f64>,
    /// Places of the free coefficients.
    free: Vec<usize>,
    bounds: Vec<(f64, f64)>,
    markers: Vec<[f64; 3]>,
    sigma: Option<f64>,
}

impl Setting {
    fn new(model: &Model, dataset: &Dataset) -> Result<Self, FitError> {
        if model
            .body
            .as_ref()
            .is_none_or(|body| body.rotation.is_some())
        {
            return Err(FitError::Mismatch(format!(
                "the model {} has an attitude, and a start is only found for point masses so far",
                model.name
            )));
        }
        if dataset.markers.len() != 1 {
            let found = dataset.markers.len();
            return Err(FitError::Mismatch(format!(
                "a point mass is tracked by one marker, and the dataset has {found}"
            )));
        }
        let first = model.params.len();
        let free: Vec<usize> = (first..first + model.coefficients.len()).collect();
        let predictor = Predictor::new(model, &free);
        let mut parameters = predictor.layout().default_parameters();
        for (name, &value) in &dataset.parameters {
            let place = predictor
                .layout()
                .parameter(name)
                .filter(|&place| place < first);
            let place = place.ok_or_else(|| {
                let known: Vec<&str> = model
                    .params
                    .iter()
                    .map(|constant| constant.name.as_str())
                    .collect();
                FitError::Mismatch(format!(
                    "the dataset sets {name}, and the model {} has {}",
                    model.name,
                    known.join(", ")
                ))
            })?;
            parameters[place] = value;
        }
        let inputs: Vec<&str> = model
            .inputs
            .iter()
            .map(|input| input.name.as_str())
            .collect();
        for flight in &dataset.flights {
            if let Some(name) = flight
                .known
                .keys()
                .find(|name| !inputs.contains(&name.as_str()))
            {
                let reason = format!(
                    "{name} is known of it, and the model {} takes {}",
                    model.name,
                    inputs.join(", ")
                );
                return Err(FitError::Flight {
                    file: flight.file.clone(),
                    reason,
                });
            }
            let scalar = |(name, known): (&String, &Known)| {
                matches!(known, Known::Scalar(_)).then(|| name.clone())
            };
            if let Some(name) = flight.known.iter().find_map(scalar) {
                return Err(FitError::Flight {
                    file: flight.file.clone(),
                    reason: format!("{name} is known as one number, expected three"),
                });
            }
        }
        let unbounded = (f64::NEG_INFINITY, f64::INFINITY);
        let bounds = model
            .coefficients
            .iter()
            .map(|constant| constant.bounds.unwrap_or(unbounded))
            .collect();
        let markers = dataset
            .markers
            .iter()
            .map(|marker| marker.position)
            .collect();
        Ok(Self {
            predictor,
            parameters,
            free,
            bounds,
            markers,
            sigma: dataset.sigma,
        })
    }

    fn start(&self, flight: &Flight) -> Result<DVector<f64>, FitError> {
        let (position, velocity) = start::of_point(flight).map_err(|reason| FitError::Flight {
            file: flight.file.clone(),
            reason,
        })?;
        Ok(DVector::from_iterator(
            6,
            position.into_iter().chain(velocity),
        ))
    }

    /// Constants of a flight with these values of the free coefficients.
    fn conditions(&self, flight: &Flight, shared: &DVector<f64>) -> Conditions {
        let mut parameters = self.parameters.clone();
        for (&place, &value) in self.free.iter().zip(shared.iter()) {
            parameters[place] = value;
        }
        for (name, known) in &flight.known {
            let Known::Vector(vector) = known else {
                continue;
            };
            for (axis, value) in ["x", "y", "z"].iter().zip(vector) {
                if let Some(place) = self.predictor.layout().parameter(&format!("{name}_{axis}")) {
                    parameters[place] = *value;
                }
            }
        }
        self.predictor.conditions(parameters)
    }

    fn report(
        &self,
        model: &Model,
        system: &Eliminated<'_>,
        solution: &Solution,
    ) -> Result<Report, FitError> {
        let squares: f64 = solution.blocks.iter().map(|block| block.squares).sum();
        let count: usize = solution.blocks.iter().map(|block| block.count).sum();
        let unknowns = self.free.len() + solution.point.own.iter().map(DVector::len).sum::<usize>();
        if count <= unknowns {
            let reason =
                format!("{count} measured coordinates do not determine {unknowns} unknowns");
            return Err(FitError::Unsolved(reason));
        }
        let estimated = (squares / (count - unknowns) as f64).sqrt();
        let sigma = self.sigma.unwrap_or(estimated);
        let covariance = system.shared_covariance() * sigma.powi(2);
        let error = |i: usize| covariance[(i, i)].max(0.0).sqrt();
        let mut coefficients = BTreeMap::new();
        let mut correlations = BTreeMap::new();
        let mut undetermined = Vec::new();
        for (i, constant) in model.coefficients.iter().enumerate() {
            let value = solution.point.shared[i];
            let (low, high) = self.bounds[i];
            let at_bound = value == low || value == high;
            if at_bound {
                undetermined.push(Undetermined {
                    weights: BTreeMap::new(),
                    relative_error: f64::INFINITY,
                    combination: vec![constant.name.clone()],
                    why: format!("it rests on its bound {value}: the least squares want it beyond"),
                });
            }
            let unit = constant.unit_text.clone();
            coefficients.insert(
                constant.name.clone(),
                Coefficient {
                    value,
                    std_error: error(i),
                    std_error_clustered: None,
                    interval: [value - 1.96 * error(i), value + 1.96 * error(i)],
                    unit,
                    at_bound,
                    held: false,
                    model_value: constant.value,
                    prior: None,
                },
            );
            let row = model.coefficients.iter().enumerate();
            let row = row.map(|(j, other)| {
                (
                    other.name.clone(),
                    covariance[(i, j)] / (error(i) * error(j)),
                )
            });
            correlations.insert(constant.name.clone(), row.collect());
        }
        Ok(Report {
            schema: "hyzer.fit/1".into(),
            effects: Vec::new(),
            model: model.name.clone(),
            rms_m: (squares / count as f64).sqrt(),
            noise: Noise {
                sigma_m: sigma,
                ar1: 0.0,
                estimated: self.sigma.is_none(),
                axes: BTreeMap::new(),
                interval_s: 0.0,
                points: 0,
                outliers: 0,
                outlier_fraction: 0.0,
                dropouts: 0,
            },
            profiles: Vec::new(),
            residuals: BTreeMap::new(),
            coefficients,
            correlations,
            flights: Vec::new(),
            undetermined,
            iterations: Iterations {
                steps: solution.iterations,
                rounds: 1,
                converged: solution.converged,
            },
            seconds: BTreeMap::new(),
        })
    }

    fn fitted(
        &self,
        flight: &Flight,
        index: usize,
        system: &Eliminated<'_>,
        solution: &Solution,
        sigma: f64,
    ) -> FlightReport {
        let block = &solution.blocks[index];
        let rms = (block.squares / block.count.max(1) as f64).sqrt();
        let covariance = system.own_covariance(index);
        let initial = self.initial(&solution.point.own[index], &covariance, sigma);
        FlightReport {
            file: flight.file.clone(),
            role: flight.role,
            samples: flight.times.len(),
            rms_m: rms,
            outliers: 0,
            cut: None,
            notes: Vec::new(),
            initial,
        }
    }

    fn initial(
        &self,
        own: &DVector<f64>,
        covariance: &nalgebra::DMatrix<f64>,
        sigma: f64,
    ) -> BTreeMap<String, Estimate> {
        let names = self.predictor.layout().states.iter().enumerate();
        let estimate = |i: usize| Estimate {
            value: own[i],
            std_error: sigma * covariance[(i, i)].max(0.0).sqrt(),
        };
        names.map(|(i, name)| (name.clone(), estimate(i))).collect()
    }

    /// Fits the initial state on the first part of a flight, with the coefficients held, and predicts the rest.
    fn held_out(
        &self,
        flight: &Flight,
        shared: &DVector<f64>,
        sigma: f64,
    ) -> Result<FlightReport, FitError> {
        let cut = ((flight.times.len() as f64 * HELD_OUT_START).ceil() as usize)
            .clamp(1, flight.times.len());
        let head = Flight {
            times: flight.times[..cut].to_vec(),
            positions: flight.positions[..cut].to_vec(),
            ..flight.clone()
        };
        let start = Point {
            shared: DVector::zeros(0),
            own: vec![self.start(&head)?],
        };
        let problem = Squares {
            setting: self,
            flights: vec![&head],
            held: Some(shared),
        };
        let solution = solve(&problem, start).map_err(|failure| problem.told(failure))?;
        let conditions = self.conditions(flight, shared);
        let own = &solution.point.own[0];
        let predicted = self
            .predictor
            .positions(&conditions, own.as_slice(), &flight.times, &self.markers)
            .map_err(|reason| FitError::Flight {
                file: flight.file.clone(),
                reason,
            })?;
        let mut squares = 0.0;
        let mut count = 0_usize;
        for (row, seen) in predicted.iter().zip(&flight.positions).skip(cut) {
            for (position, seen) in row.iter().zip(seen) {
                let Some(seen) = seen else { continue };
                squares += position
                    .iter()
                    .zip(seen)
                    .map(|(a, b)| (a - b).powi(2))
                    .sum::<f64>();
                count += 3;
            }
        }
        let initial = match eliminate(&solution.blocks, 0.0) {
            Ok(system) => self.initial(own, &system.own_covariance(0), sigma),
            Err(_) => BTreeMap::new(),
        };
        let rms_m = (squares / count.max(1) as f64).sqrt();
        Ok(FlightReport {
            file: flight.file.clone(),
            role: flight.role,
            samples: flight.times.len(),
            rms_m,
            outliers: 0,
            cut: None,
            notes: Vec::new(),
            initial,
        })
    }
}

/// The sum of squares over some flights; with `held`, the coefficients are not among the unknowns.
struct Squares<'a> {
    setting: &'a Setting,
    flights: Vec<&'a Flight>,
    held: Option<&'a DVector<f64>>,
}

impl Squares<'_> {
    fn told(&self, failure: Failure) -> FitError {
        match failure {
            Failure::Start { flight, reason } => FitError::Flight {
                file: self.flights[flight].file.clone(),
                reason,
            },
            Failure::Singular(crate::normal::Singular::Own(flight)) => FitError::Flight {
                file: self.flights[flight].file.clone(),
                reason: "its samples do not determine its initial state".into(),
            },
            Failure::Singular(singular) => FitError::Unsolved(singular.to_string()),
        }
    }
}

impl Problem for Squares<'_> {
    fn flights(&self) -> usize {
        self.flights.len()
    }

    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String> {
        let (setting, data) = (self.setting, self.flights[flight]);
        let conditions = setting.conditions(data, self.held.unwrap_or(shared));
        let rows = setting.predictor.observe(
            &conditions,
            own.as_slice(),
            &data.times,
            &setting.markers,
        )?;
        let mut block = Block::zero(own.len(), shared.len());
        for (row, seen) in rows.iter().zip(&data.positions) {
            for (observed, seen) in row.iter().zip(seen) {
                let Some(seen) = seen else { continue };
                for (axis, measured) in seen.iter().enumerate() {
                    let by = observed.sensitivity.row(axis).transpose();
                    let (by_own, by_shared) =
                        (by.rows(0, own.len()), by.rows(own.len(), shared.len()));
                    block.add(
                        observed.position[axis] - measured,
                        &by_own.clone_owned(),
                        &by_shared.clone_owned(),
                    );
                }
            }
        }
        Ok(block)
    }

    fn squares(&self, flight: usize, shared: &DVector<f64>, own: &DVector<f64>) -> f64 {
        let (setting, data) = (self.setting, self.flights[flight]);
        let conditions = setting.conditions(data, self.held.unwrap_or(shared));
        let rows =
            setting
                .predictor
                .positions(&conditions, own.as_slice(), &data.times, &setting.markers);
        let Ok(rows) = rows else { return f64::INFINITY };
        let seen = rows.iter().flatten().zip(data.positions.iter().flatten());
        seen.filter_map(|(position, seen)| seen.map(|seen| (position, seen)))
            .map(|(position, seen)| {
                position
                    .iter()
                    .zip(&seen)
                    .map(|(a, b)| (a - b).powi(2))
                    .sum::<f64>()
            })
            .sum()
    }

    fn bounds(&self) -> &[(f64, f64)] {
        if self.held.is_some() {
            &[]
        } else {
            &self.setting.bounds
        }
    }
}
