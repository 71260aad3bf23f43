//! Tests of the screening on synthetic flights: clean flights have no fault, and mistakes are reported.

mod clean;
mod cuts;
mod handled;
mod instruments;
mod mistakes;

use flight::CompiledModel;
use flight::release::{Release, Stop, Vocabulary, built_in, read};
use model_spec::layout::Layout;
use model_spec::model::Model;

use super::{Body, marker_pairs, screen};
use crate::pose::RigidMotion;
use crate::synthesize::{Corruption, Plan, Spread, flights};
use crate::{DataFault, Dataset, FaultKind, Flight, PosePoints};

pub const AR: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.6,
    outliers: 0.01,
    outlier_size: 0.05,
    dropouts: 0.12,
};

pub fn model(name: &str) -> Model {
    model_spec::load::load(name, &[]).expect("a model")
}

pub fn release(model: &Model, name: &str) -> Release {
    let text = built_in(name).expect("a release");
    read(name, text, |_| Ok(Vocabulary::of(model))).expect("readable")
}

pub fn plan(flights: usize, seed: u64) -> Plan {
    Plan {
        flights,
        seed,
        noise: AR,
        duration: Some(1.0),
        ..Plan::default()
    }
}

pub fn found(model: &Model, dataset: &Dataset) -> Vec<DataFault> {
    screen(&Screened::new(model, dataset), dataset, 2).0
}

/// A body whose distances are all fixed, and of which no state is sought.
pub struct Screened {
    model: Model,
    compiled: CompiledModel,
    parameters: Vec<f64>,
    points: PosePoints,
    sees_positions: bool,
}

impl Screened {
    pub fn new(model: &Model, dataset: &Dataset) -> Self {
        let points = PosePoints::new(model, dataset);
        Self {
            model: model.clone(),
            compiled: CompiledModel::new(model),
            parameters: Layout::new(model).default_parameters(),
            sees_positions: !points.markers.is_empty(),
            points,
        }
    }
}

impl Body for Screened {
    fn model(&self) -> &Model {
        &self.model
    }

    fn compiled(&self) -> &CompiledModel {
        &self.compiled
    }

    fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    fn points(&self) -> &PosePoints {
        &self.points
    }

    fn sees_positions(&self) -> bool {
        self.sees_positions
    }

    fn rigid_pairs(&self) -> Vec<bool> {
        vec![true; marker_pairs(self.points.markers.len()).len()]
    }

    fn states(&self, _: &Flight, motions: &[RigidMotion]) -> Vec<Option<Vec<f64>>> {
        vec![None; motions.len()]
    }
}

/// Releases of a disc: an ordinary throw, and throws at steep angles of attack, fast, slow and upside down.
pub fn disc_releases(model: &Model) -> Vec<Release> {
    let usual = release(model, "backhand");
    let with = |changes: &[(&str, f64)]| {
        let mut release = usual.clone();
        release.stop = Stop::Duration(1.0);
        for (name, value) in &mut release.initial {
            if let Some((_, changed)) = changes.iter().find(|(changed, _)| changed == name) {
                *value = *changed;
            }
        }
        release
    };
    vec![
        with(&[]),
        with(&[("u", 25.0), ("w", -7.0), ("gammadot", -90.0)]),
        with(&[("u", 30.0), ("w", -4.0), ("theta", 0.1)]),
        with(&[("u", 6.0), ("w", -1.0), ("gammadot", -20.0)]),
        with(&[("u", 12.0), ("w", -9.0)]),
        with(&[("phi", 0.9), ("theta", -0.5)]),
    ]
}

pub fn discs(flights_each: usize, seed: u64) -> (Model, Vec<Dataset>) {
    let model = model("disc");
    let each = disc_releases(&model).into_iter().enumerate();
    let made = each.filter_map(|(k, release)| {
        let plan = plan(flights_each, seed + 100 * k as u64);
        flights(&model, &[release], &plan)
            .ok()
            .map(|made| made.dataset)
    });
    let made = made.collect();
    (model, made)
}

pub fn disc(seed: u64) -> (Model, Dataset) {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(1.0);
    let made = flights(&model, &[usual], &plan(10, seed)).expect("flights");
    (model, made.dataset)
}

/// Model of a disc, and simulated flights of it whose data have white noise, but no outliers, missing points or
/// correlated noise.
pub fn calm_disc(seed: u64) -> (Model, Dataset) {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(1.0);
    let plan = Plan {
        noise: Corruption::default(),
        ..plan(10, seed)
    };
    let made = flights(&model, &[usual], &plan).expect("flights");
    (model, made.dataset)
}

pub fn ball(seed: u64) -> (Model, Dataset) {
    let model = model("ball");
    let mut serve = release(&model, "serve");
    serve.stop = Stop::Duration(0.6);
    let plan = Plan {
        duration: Some(0.6),
        spread: Spread {
            fraction: 0.3,
            ..Spread::default()
        },
        ..plan(10, seed)
    };
    let made = flights(&model, &[serve], &plan).expect("flights");
    (model, made.dataset)
}

pub fn each_point(flight: &mut Flight, change: impl Fn([f64; 3]) -> [f64; 3]) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = change(*point);
    }
}

pub type Spoil = fn(&mut Flight);

pub fn spoiled(dataset: &Dataset, which: &[usize], spoil: Spoil) -> Dataset {
    let mut dataset = dataset.clone();
    for &flight in which {
        spoil(&mut dataset.flights[flight]);
    }
    dataset
}

pub fn kinds(faults: &[DataFault]) -> Vec<(&str, FaultKind)> {
    faults
        .iter()
        .map(|fault| (fault.file.as_str(), fault.fault))
        .collect()
}
