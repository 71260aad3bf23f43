//! Summaries of flights: the release, and what was seen of the apex and the landing, as functions of the initial state.

mod assumed;

use std::sync::Arc;

use flight::throw::{MotionVector, ThrownModel};
use flight::{BoundModel, CompiledModel, FlightParameters, ModelObserver};
use model_spec::model::{ExprKind, Model};

use crate::channel::{Channel, ChannelKind};
use crate::error::FitError;
use crate::noise::group_count;
use crate::summary_value::{SummaryValue, Vectors};
use dataset::statistics::median_of;
use dataset::{Dataset, Sensor, SummaryEvent, SummaryQuantity};

/// The vectors of a motion, in the order of [`Vectors`].
const VECTORS: [MotionVector; 6] = [
    MotionVector::Position,
    MotionVector::Velocity,
    MotionVector::Spin,
    MotionVector::Axis,
    MotionVector::FirstAxis,
    MotionVector::Momentum,
];

/// Compiled functions of a model that summaries need.
pub struct SummaryModel {
    /// The vectors of the motion that the model has, each with its index in [`Vectors`].
    vectors: Vec<(usize, CompiledModel)>,
    pub(crate) thrown: ThrownModel,
    /// States that are the position of the mass centre.
    pub(crate) position: [usize; 3],
    /// States that are not of the motion and begin at their own values.
    pub(crate) held: Vec<usize>,
    /// States that effects add and that keep their values during a flight.
    pub(crate) constant: Vec<usize>,
    /// States that are the spin of a point mass, if it is estimated.
    spin: Option<[usize; 3]>,
}

/// The functions of the model for the channels of summaries, if there are any, and adds those for what releases have by
/// assumption.
pub(crate) fn of_channels(
    model: &Model,
    dataset: &Dataset,
    channels: &mut Vec<Channel>,
) -> Result<Option<Arc<SummaryModel>>, FitError> {
    let columns = channels.iter().filter_map(|own| match own.kind {
        ChannelKind::Summary(SummaryValue::Column(quantity)) => Some(quantity),
        _ => None,
    });
    let columns: Vec<_> = columns.collect();
    if columns.is_empty() {
        return Ok(None);
    }
    let summary = SummaryModel::new(model, &columns).map_err(|reason| FitError::Sensor {
        model: model.name.clone(),
        reason,
    })?;
    let groups: Vec<usize> = channels.iter().map(|own| own.group).collect();
    let usual = |quantity: SummaryQuantity| {
        let is_own =
            |own: &&Channel| own.kind == ChannelKind::Summary(SummaryValue::Column(quantity));
        let own = channels.iter().find(is_own)?;
        let sensor = dataset
            .sensors
            .iter()
            .find(|sensor| sensor.name == own.name)?;
        median_of(dataset.values_of(sensor)).map(|value| value * own.to_si)
    };
    let assumed = summary.assumed(group_count(&groups), usual);
    channels.extend(assumed);
    Ok(Some(Arc::new(summary)))
}

impl SummaryModel {
    /// Compiles the functions; an error, as text for the message, if the model has no quantity of `columns`.
    pub fn new(model: &Model, columns: &[SummaryQuantity]) -> Result<Self, String> {
        let thrown = ThrownModel::new(model).map_err(|error| error.to_string())?;
        let compiled = VECTORS.iter().enumerate();
        let compiled = compiled.filter_map(|(k, vector)| Some((k, vector.compile(model)?)));
        let vectors: Vec<(usize, CompiledModel)> = compiled.collect();
        let has = |k: usize| vectors.iter().any(|(own, _)| *own == k);
        for &quantity in columns {
            check(quantity, thrown.has_attitude(), has(2))?;
        }
        let position = vectors.first().and_then(|(_, own)| coordinates(own));
        let position = position.ok_or(
            "the position of its body is not three of its states, as `position (x, y, z)` states it",
        )?;
        let unknown: Vec<usize> = model
            .unknown_states()
            .into_iter()
            .map(|own| own.1)
            .collect();
        let is_constant = |state: usize| {
            let own = model.equations.iter().find(|own| own.state == state);
            own.is_some_and(
                |own| matches!(own.value.kind, ExprKind::Number { value, .. } if value == 0.0),
            )
        };
        let added = model.added_states().into_iter();
        let (constant, held) = added
            .filter(|state| !unknown.contains(state))
            .partition(|state| is_constant(*state));
        let omega = model.unknown_states().into_iter();
        let omega = omega
            .filter(|(name, _)| name == Sensor::SPIN)
            .map(|(_, state)| state);
        let spin = omega.collect::<Vec<_>>().try_into().ok();
        Ok(Self {
            spin: spin.filter(|_| !thrown.has_attitude()),
            vectors,
            thrown,
            position,
            held,
            constant,
        })
    }

    pub(crate) fn bind(&self, parameters: &FlightParameters) -> Vec<(usize, BoundModel<'_>)> {
        let each = self.vectors.iter();
        each.map(|(k, own)| (*k, own.bind(parameters.clone())))
            .collect()
    }
}

/// Checks that a body, or a point mass if `has_attitude` is false, has a quantity.
fn check(quantity: SummaryQuantity, has_attitude: bool, has_spin: bool) -> Result<(), String> {
    let name = quantity.name();
    match quantity {
        SummaryQuantity::Nose | SummaryQuantity::Hyzer | SummaryQuantity::Wobble
            if !has_attitude =>
        {
            Err(format!(
                "{name} is of a body with an attitude, and it is a point mass"
            ))
        }
        SummaryQuantity::SpinAxis if has_attitude => Err(format!(
            "{name} is of a ball; the attitude of a body is told by nose and hyzer"
        )),
        SummaryQuantity::Spin | SummaryQuantity::SpinAxis | SummaryQuantity::FinalSpin
            if !has_spin =>
        {
            Err(format!(
                "it has no {name}; expected an input {} of a ball, or a body that turns",
                Sensor::SPIN
            ))
        }
        _ => Ok(()),
    }
}

/// States that are the three components of an observed vector; `None` if it is not three states.
fn coordinates(observed: &CompiledModel) -> Option<[usize; 3]> {
    let layout = observed.layout();
    let bound = observed.bind(layout.default_parameters());
    let mut observer = bound.observer();
    let (_, by) = observer.position_with_jacobians(0.0, &layout.default_states(), &[0.0; 3]);
    let row = |row: usize| {
        let entries = by.by_state_pattern.iter().zip(by.by_state);
        let mut own = entries.filter(|((axis, _), value)| *axis == row && **value != 0.0);
        match (own.next(), own.next()) {
            (Some(((_, state), value)), None) if *value == 1.0 => Some(*state),
            _ => None,
        }
    };
    Some([row(0)?, row(1)?, row(2)?])
}

/// Vectors of the motion at a state; those that the model lacks are zero.
pub(crate) fn vectors(
    observers: &mut [(usize, ModelObserver<'_>)],
    time: f64,
    state: &[f64],
) -> Vectors {
    let mut vectors = Vectors::default();
    for (k, observer) in observers {
        vectors[*k] = observer.position(time, state, &[0.0; 3]);
    }
    vectors
}

/// Event at which the value of a channel is seen; `None` if the channel is not of summaries.
pub(crate) fn event(kind: ChannelKind) -> Option<SummaryEvent> {
    match kind {
        ChannelKind::Summary(SummaryValue::Column(quantity)) => Some(quantity.event()),
        ChannelKind::Summary(_) => Some(SummaryEvent::Release),
        _ => None,
    }
}
