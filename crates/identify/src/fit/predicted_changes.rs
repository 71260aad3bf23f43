//! Contacts that the model itself predicts. Detection compares a flight with smooth motion, which a model need not
//! predict: a motor that ignites, a stated contact or a fast joint change a velocity as a touch of the ground does. Where
//! that may be, or the user trusts the data, the flights are fitted first as if nothing touched them; a flight whose
//! residuals after the contact are noise keeps its samples.

use model_spec::model::{Expr, ExprKind, Function, Model};

use super::FitError;
use super::converged;
use super::initial_guess::{self, ObservedFlights, observe};
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::ids::FlightId;
use crate::noise::overall;
use crate::options::FitOptions;
use crate::predict::{Residuals, robust_scale};
use crate::problem::FitProblem;
use dataset::contact::ContactSearch;
use dataset::levels::{ROBUST_ERROR, ROUGHLY_NOISE, SIGNIFICANT};
use dataset::{Dataset, Role};

/// A flight that detection truncates, and the number of samples before its contact.
type CutFlight = (FlightId, usize);

/// Observes flights again without the contacts that the model predicts, which it removes from `contacts`; the flights
/// `observed`, truncated at all contacts, if it predicts none.
pub fn without_predicted(
    problem: &FitProblem,
    (dataset, fitted): (&Dataset, &[FlightId]),
    contacts: &mut Vec<Option<ContactSearch>>,
    observed: ObservedFlights,
    options: &FitOptions<'_>,
) -> ObservedFlights {
    let flights = observed.usable.iter();
    let cut = flights.filter(|(_, flight)| flight.truncation.is_some());
    let cut: Vec<CutFlight> = cut.map(|(id, flight)| (*id, flight.times.len())).collect();
    if cut.is_empty() || !(options.trust_data || may_change_suddenly(&problem.model)) {
        return observed;
    }
    let mut whole = contacts.clone();
    whole.resize(dataset.flights.len(), None);
    cut.iter()
        .for_each(|(id, _)| remove_contact(&mut whole, *id));
    let trial = predicted(problem, (dataset, fitted), (&whole, &cut), options).unwrap_or_default();
    if trial.is_empty() {
        return observed;
    }
    contacts.resize(dataset.flights.len(), None);
    trial.iter().for_each(|id| remove_contact(contacts, *id));
    if trial.len() == cut.len() {
        let flights = dataset.flights.iter().enumerate();
        let held_out = flights.filter(|(_, flight)| flight.role == Role::HeldOut);
        held_out.for_each(|(index, _)| remove_contact(contacts, FlightId::new(index)));
    }
    observe(problem, dataset, fitted, contacts, options)
}

fn remove_contact(contacts: &mut [Option<ContactSearch>], flight: FlightId) {
    let search = contacts[flight.index()].get_or_insert_default();
    search.contact = None;
}

/// The flights `cut` that a fit of all flights with the searches `whole` predicts to their ends.
fn predicted(
    problem: &FitProblem,
    (dataset, fitted): (&Dataset, &[FlightId]),
    (whole, cut): (&[Option<ContactSearch>], &[CutFlight]),
    options: &FitOptions<'_>,
) -> Result<Vec<FlightId>, FitError> {
    let mut problem = problem.clone();
    let observed = observe(&problem, dataset, fitted, whole, options);
    initial_guess::set_noise(&mut problem, &observed, std::iter::empty());
    let floor = observed.noise_floor.map_or(0.0, overall);
    let noise = problem.sigma0.max(floor);
    let guesses = initial_guess::from_guesses(&problem, dataset, observed, options)?;
    let (state, cache) = converged(guesses, Vec::new())?;
    let kept = cut
        .iter()
        .filter(|cut| is_noise(&state, &cache, cut, noise));
    Ok(kept.map(|(id, _)| *id).collect())
}

/// Whether the residuals of a flight from its contact on have the standard deviation `noise`, m, of the measurements.
fn is_noise(
    state: &State<'_>,
    cache: &ResidualCache,
    (id, samples): &CutFlight,
    noise: f64,
) -> bool {
    let place = state.place(*id);
    let path = place.and_then(|place| cache.path(&state.flights, place).ok());
    let Some(path) = path else {
        return false;
    };
    let channels = path.residuals.iter();
    let after = channels.map(|series| series.get(*samples..).unwrap_or_default().to_vec());
    let after: Residuals = after.collect();
    let values = 3 * after.iter().flatten().flatten().count();
    let by_chance = 1.0 + SIGNIFICANT * ROBUST_ERROR / (values.max(1) as f64).sqrt();
    robust_scale(&after).is_some_and(|scale| scale <= noise * ROUGHLY_NOISE.max(by_chance))
}

/// Whether motion that a model predicts may look like one that something touched: it names the time or switches, reads
/// tables, holds constraints, or states every equation, of which nothing is known.
fn may_change_suddenly(model: &Model) -> bool {
    let may_switch = |e: &Expr| {
        matches!(
            e.kind,
            ExprKind::Time
                | ExprKind::Min(..)
                | ExprKind::Max(..)
                | ExprKind::Lookup(..)
                | ExprKind::Call(Function::Step | Function::Sign | Function::Table(_), _)
        )
    };
    let mut parts = model.expressions().into_iter().flat_map(Expr::nodes);
    !model.systems.is_empty() || model.body.is_none() || parts.any(may_switch)
}
