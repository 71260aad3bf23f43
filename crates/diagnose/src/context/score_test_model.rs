//! The score-test model: the encompassing model at the null values, and the observations of the fitted flights.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use codegen::Layout;
use flight::CompiledModel;
use identify::{Fit, FitError, FitOptions, FitProblem, FlightId, Iterate, LocalId, Observations};
use model_spec::index::IndexVec;
use model_spec::layout::{ParamId, StateId};
use nalgebra::DVector;

use super::columns::{CandidateId, ColumnId, TermId};
use super::encompassing::{Candidate, CandidateParameter, EncompassingModel};
use super::library_terms::LibraryTerms;
use super::{Context, Partition};
use dataset::{Dataset, Role};

/// The encompassing model, its estimation problem, and the observations of the fitted flights.
pub(crate) struct ScoreTestModel<'a> {
    /// Inputs of the diagnosis: model under test, dataset and options.
    pub context: Context<'a>,
    encompassing: EncompassingModel,
    /// Estimation problem at the null values, with the parameters of the model under test and the candidates.
    pub problem: FitProblem,
    columns: IndexVec<CandidateId, Vec<ColumnId>>,
    /// Columns of the normal equations that belong to the global parameters of the model under test.
    pub base: Vec<ColumnId>,
    /// Terms of the term library, whose columns follow those of the global parameters.
    pub terms: Option<LibraryTerms>,
    /// Observations of the fitted flights; states of candidates are unknowns of their initial states.
    pub flights: Vec<Observations>,
    /// Number of least-squares steps taken so far, over all refits (fits of the model with some candidate effects).
    steps: AtomicUsize,
}

/// Maximum number of least-squares steps, summed over all refits of one search.
const MAX_STEPS: usize = 250;

impl<'a> ScoreTestModel<'a> {
    /// The score-test model for the flights of `fit`, and the values of the fit as its unknowns.
    pub fn new(
        encompassing: EncompassingModel,
        context: Context<'a>,
        fit: &Fit,
    ) -> Result<(Self, Iterate), FitError> {
        let problem = encompassing_problem(&encompassing, context, fit)?;
        let layout = problem.body.layout();
        let column = |parameter: &CandidateParameter<ParamId>| {
            let mut globals = problem.globals.iter();
            let found = globals.position(|global| global.param == parameter.id);
            found.map(ColumnId::new)
        };
        let columns: IndexVec<CandidateId, Vec<ColumnId>> = encompassing
            .candidates
            .iter()
            .map(|candidate| candidate.coefficients.iter().filter_map(column).collect())
            .collect();
        let of_candidates: Vec<ColumnId> = columns.iter().flatten().copied().collect();
        let base = Partition::new(of_candidates, problem.globals.len()).tested;
        let library = encompassing.library.clone();
        let terms = library.and_then(|library| LibraryTerms::new(library, layout));
        let (flights, local) = fitted_flights(&problem, context.dataset, fit)?;
        let iterate = Iterate {
            global: fitted_globals(&problem, fit),
            local,
        };
        let model = Self {
            context,
            encompassing,
            problem,
            columns,
            base,
            terms,
            flights,
            steps: AtomicUsize::new(0),
        };
        Ok((model, iterate))
    }

    /// Number of columns of global parameters; those of library terms follow.
    pub fn global_columns(&self) -> usize {
        self.problem.globals.len()
    }

    /// Column of the normal equations that belongs to the coefficient of a library term.
    pub fn term_column(&self, term: TermId) -> ColumnId {
        ColumnId::new(self.global_columns() + term.index())
    }

    pub fn candidates(&self) -> impl ExactSizeIterator<Item = (CandidateId, &Candidate)> {
        self.encompassing.candidates.iter_enumerated()
    }

    pub fn candidate(&self, id: CandidateId) -> &Candidate {
        &self.encompassing.candidates[id]
    }

    /// Whether the search must end: past its deadline, or after the maximum number of steps.
    pub fn is_exhausted(&self) -> bool {
        self.context.is_out_of_time() || self.steps.load(Ordering::Relaxed) >= MAX_STEPS
    }

    /// Adds the least-squares steps of one refit to the total over all refits (fits with some candidate effects).
    pub fn count_steps(&self, steps: usize) {
        self.steps.fetch_add(steps, Ordering::Relaxed);
    }

    pub fn threads(&self) -> usize {
        self.context.options.fit.threads()
    }

    pub fn columns_of(&self, id: CandidateId) -> &[ColumnId] {
        &self.columns[id]
    }

    /// Name of the global parameter of a column; `None` for a library term.
    pub fn column_name(&self, column: ColumnId) -> Option<&str> {
        let global = self.problem.globals.get(column.index())?;
        Some(global.name.as_str())
    }

    /// Nuisance columns, ascending: of the model under test and the candidates in `conditioned_on`.
    pub fn nuisance_columns(&self, conditioned_on: &[CandidateId]) -> Vec<ColumnId> {
        let mut columns = self.base.clone();
        columns.extend(conditioned_on.iter().flat_map(|&id| &self.columns[id]));
        columns.sort_unstable();
        columns
    }

    /// Number of unknowns that `effects` add: one per coefficient, and one per state and flight.
    pub fn unknowns_of(&self, effects: &[CandidateId]) -> usize {
        let each = effects.iter().map(|&id| {
            self.columns[id].len() + self.candidate(id).states.len() * self.flights.len()
        });
        each.sum()
    }

    pub fn null_states(&self, conditioned_on: &[CandidateId]) -> Vec<StateId> {
        self.candidates()
            .filter(|(id, _)| !conditioned_on.contains(id))
            .flat_map(|(_, candidate)| candidate.states.iter().map(|state| state.id))
            .collect()
    }

    /// Directions of a flight's initial state: of candidates' states at their null values, and all others.
    pub fn local_partition(
        &self,
        flight: usize,
        conditioned_on: &[CandidateId],
    ) -> (Vec<LocalId>, Vec<LocalId>) {
        let null = self.null_states(conditioned_on);
        let manifold = &self.flights[flight].manifold;
        let is_null = |direction: &LocalId| {
            let state = manifold.direct_state(*direction);
            state.is_some_and(|state| null.contains(&state))
        };
        (0..manifold.dimension())
            .map(LocalId::new)
            .partition(is_null)
    }

    /// Estimation problem in which other candidates than `effects` are constants; its derivatives are cheaper.
    pub fn problem_with(&self, effects: &[CandidateId]) -> FitProblem {
        let fixed = fixed_parameters(&self.encompassing, effects);
        FitProblem {
            body: Arc::new(CompiledModel::specialized(&self.encompassing.model, &fixed)),
            ..self.problem.clone()
        }
    }

    /// As [`problem_with`](Self::problem_with), with the parameters of `columns` alone as unknowns.
    pub fn refit_problem(&self, effects: &[CandidateId], columns: &[ColumnId]) -> FitProblem {
        let fixed = fixed_parameters(&self.encompassing, effects);
        let globals = columns
            .iter()
            .map(|column| &self.problem.globals[column.index()]);
        let globals: Vec<_> = globals.cloned().collect();
        let by = globals.iter().map(|global| global.param.index()).collect();
        let model = &self.encompassing.model;
        FitProblem {
            body: Arc::new(CompiledModel::specialized_by(model, &fixed, by)),
            globals,
            ..self.problem.clone()
        }
    }

    /// Copy of an iterate with the candidate `dropped` at its null value.
    pub fn at_null_value(&self, iterate: &Iterate, dropped: CandidateId) -> Iterate {
        let candidate = self.candidate(dropped);
        let mut iterate = iterate.clone();
        for (column, parameter) in self.columns[dropped].iter().zip(&candidate.coefficients) {
            iterate.global[column.index()] = parameter.null_value;
        }
        for state in &candidate.states {
            for local in &mut iterate.local {
                local[state.id.index()] = state.null_value;
            }
        }
        iterate
    }

    /// The result of `fit` as an iterate of this model; `None` if it used other flights.
    pub fn iterate_of(&self, fit: &Fit) -> Option<Iterate> {
        let (flights, local) = fitted_flights(&self.problem, self.context.dataset, fit).ok()?;
        let global = fitted_globals(&self.problem, fit);
        self.has_same_flights(&flights)
            .then_some(Iterate { global, local })
    }

    /// Whether `flights` are those of this model; sums of squares are then comparable.
    pub fn has_same_flights(&self, flights: &[Observations]) -> bool {
        let own = self.flights.iter().map(|flight| &flight.file);
        own.eq(flights.iter().map(|flight| &flight.file))
    }

    /// Number of measured coordinates in all fitted flights, at least 2.
    pub fn coordinates(&self) -> usize {
        let points = |flight: &Observations| flight.measured.iter().flatten().count();
        (3 * self.flights.iter().map(points).sum::<usize>()).max(2)
    }
}

/// Estimation problem of the encompassing model; loads of the term library are fixed at 0.
fn encompassing_problem(
    encompassing: &EncompassingModel,
    context: Context<'_>,
    fit: &Fit,
) -> Result<FitProblem, FitError> {
    let mut held = context.options.fit.fixed.to_vec();
    held.extend(
        encompassing
            .load_coefficients()
            .map(|name| (name.to_owned(), None)),
    );
    let options = FitOptions {
        fixed: &held,
        // Profile likelihoods are computed by the fit, not here.
        profiles: &[],
        ..context.options.fit
    };
    let fixed = fixed_parameters(encompassing, &[]);
    let model = &encompassing.model;
    let mut problem = FitProblem::with_body(model, context.dataset, &options, |_| {
        CompiledModel::specialized(model, &fixed)
    })?;
    problem.take_scales(fit.problem());
    Ok(problem)
}

/// Parameters that are not estimated, at their null values: of candidates outside `on`, and loads of the library.
fn fixed_parameters(encompassing: &EncompassingModel, on: &[CandidateId]) -> Vec<(usize, f64)> {
    let layout = Layout::new(&encompassing.model);
    let null = encompassing.candidates.iter_enumerated();
    let null = null.filter(|(id, _)| !on.contains(id));
    let mut fixed: Vec<(usize, f64)> = null
        .flat_map(|(_, candidate)| &candidate.coefficients)
        .map(|parameter| (parameter.id.index(), parameter.null_value))
        .collect();
    let loads = encompassing.load_coefficients();
    fixed.extend(loads.filter_map(|name| Some((layout.parameter(name)?.index(), 0.0))));
    fixed
}

/// Global parameters of `problem` at a fit; those that the fit lacks at their null values.
fn fitted_globals(problem: &FitProblem, fit: &Fit) -> DVector<f64> {
    let before = &fit.problem().globals;
    let values = problem.globals.iter().map(|global| {
        let same = before.iter().position(|b| b.name == global.name);
        same.map_or(global.model_value, |index| fit.global()[index])
    });
    DVector::from_iterator(problem.globals.len(), values)
}

fn fitted_flights(
    problem: &FitProblem,
    dataset: &Dataset,
    fit: &Fit,
) -> Result<(Vec<Observations>, Vec<DVector<f64>>), FitError> {
    let layout = problem.body.layout();
    let before = fit.problem().body.layout();
    let sources: Vec<Option<StateId>> = layout.states.iter().map(|s| before.state(s)).collect();
    let (mut flights, mut locals) = (Vec::new(), Vec::new());
    for (index, flight) in dataset.flights.iter().enumerate() {
        let fitted = fit
            .flight(FlightId::new(index))
            .filter(|_| flight.role == Role::Fit);
        let Some((observations, state)) = fitted else {
            continue;
        };
        let fresh = Observations::new(problem, flight).map_err(|reason| FitError::Flight {
            file: flight.file.clone(),
            reason,
        })?;
        flights.push(Observations {
            parameters: fresh.parameters,
            inputs: fresh.inputs,
            known_states: fresh.known_states,
            state_priors: fresh.state_priors,
            manifold: fresh.manifold,
            ..observations.clone()
        });
        let values = sources.iter().zip(&layout.initial);
        let values = values.map(|(source, &initial)| source.map_or(initial, |s| state[s.index()]));
        locals.push(DVector::from_iterator(sources.len(), values));
    }
    Ok((flights, locals))
}

#[cfg(test)]
mod tests {
    use crate::test_support::fixture;

    #[test]
    fn columns_belong_to_the_base_or_to_one_candidate() {
        let fixture = fixture();
        let model = &fixture.model;
        let mut all = model.base.clone();
        for (id, candidate) in model.candidates() {
            assert_eq!(model.columns_of(id).len(), candidate.coefficients.len());
            for (column, coefficient) in model.columns_of(id).iter().zip(&candidate.coefficients) {
                assert_eq!(model.column_name(*column), Some(coefficient.name.as_str()));
                // A fit of the model without the candidate leaves the coefficient at its null value.
                let value = fixture.iterate.global[column.index()];
                assert_eq!(value, coefficient.null_value);
            }
            all.extend(model.columns_of(id));
        }
        all.sort_unstable();
        let indices: Vec<usize> = all.iter().map(|column| column.index()).collect();
        assert_eq!(indices, (0..model.global_columns()).collect::<Vec<_>>());
    }

    #[test]
    fn a_state_of_its_own_is_free_only_where_it_is_conditioned_on() {
        let model = &fixture().model;
        let (gusts, candidate) = model
            .candidates()
            .find(|(_, candidate)| candidate.is_per_flight())
            .unwrap();
        let (null, free) = model.local_partition(0, &[]);
        assert_eq!((null.len(), free.len()), (candidate.states.len(), 12));
        let (null, free) = model.local_partition(0, &[gusts]);
        assert_eq!((null.len(), free.len()), (0, 12 + candidate.states.len()));
        assert_eq!(model.unknowns_of(&[gusts]), 2 * model.flights.len());
    }
}
