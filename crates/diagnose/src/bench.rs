//! The bench on which all candidates are tried: the fitted flights in the model that has every candidate switched on, and
//! off by its value.

use std::sync::Arc;

use codegen::Layout;
use flight::batch;
use flight::{BoundModel, CompiledModel};
use identify::StateManifold;
use identify::dataset::{Dataset, Role};
use identify::{
    Constraint, Fit, FitError, FitOptions, FitProblem, Iterate, LeastSquaresProblem, Loss,
    NoiseModel, NormalBlock, Observations, PointResidual, Solution, StoppingCriteria, Unknowns,
    constrained_step, each_residual, eliminate, linearise, linearise_with, solve,
};
use model_spec::layout::StateId;
use nalgebra::DVector;
use ode::DifferentiableRhs;

use crate::catalogue::{Candidate, Catalogue};
use crate::kept::{Kept, Vantage};
use crate::scores::local_block;
use crate::terms::Grammar;

/// A refit that takes more steps leads nowhere.
const STEPS: StoppingCriteria = StoppingCriteria {
    max_steps: 25,
    ..StoppingCriteria::CONVERGED
};

/// The flights, in the model with all candidates.
pub struct Bench {
    /// The model, with every candidate off; its shared unknowns are those of the base and the candidates' coefficients.
    pub problem: FitProblem,
    catalogue: Catalogue,
    /// The candidates.
    pub candidates: Vec<Columns>,
    /// The shared unknowns of the base, by index.
    pub base: Vec<usize>,
    /// Terms outside the catalogue, where the model has channels for them; their unknowns come behind the shared ones.
    pub grammar: Option<Grammar>,
    /// The fitted flights; every state may be varied.
    pub observation_sets: Vec<Observations>,
    /// Flights worked on at once.
    pub threads: usize,
}

/// A candidate, with where its unknowns are.
#[derive(Clone, Debug)]
pub struct Columns {
    /// What it is.
    pub candidate: Candidate,
    /// Its coefficients among the shared unknowns.
    pub global: Vec<usize>,
    /// Its states.
    pub states: Vec<usize>,
}

impl Bench {
    /// Puts fitted flights on the bench; and the point that the fit found, with every candidate off.
    ///
    /// # Errors
    /// Where the flights do not go with the model.
    pub fn new(
        catalogue: &Catalogue,
        dataset: &Dataset,
        fitted: &Fit,
        options: &FitOptions<'_>,
    ) -> Result<(Self, Iterate), FitError> {
        let mut hold = options.fixed.to_vec();
        let loads = catalogue.channels.iter().flat_map(|c| c.loads);
        hold.extend(loads.map(|(name, ..)| ((*name).to_owned(), None)));
        let all = FitOptions {
            fixed: &hold,
            // What is profiled is the fit's.
            profiles: &[],
            ..*options
        };
        let fixed = off(catalogue, &[]);
        let body = CompiledModel::specialized(&catalogue.model, &fixed);
        let mut problem = FitProblem::with_body(&catalogue.model, body, dataset, &all)?;
        problem.sigma0 = fitted.problem().sigma0;
        let layout = problem.body.layout();
        let columns: Vec<Columns> = catalogue
            .candidates
            .iter()
            .cloned()
            .map(|candidate| {
                let global = candidate.coefficients.iter().filter_map(|part| {
                    let place = layout.coefficient(part.index).index();
                    problem.globals.iter().position(|s| s.param == place)
                });
                Columns {
                    global: global.collect(),
                    states: candidate.states.iter().map(|part| part.index).collect(),
                    candidate,
                }
            })
            .collect();
        let of_candidates: Vec<usize> = columns.iter().flat_map(|c| c.global.clone()).collect();
        let base = (0..problem.globals.len()).filter(|i| !of_candidates.contains(i));
        let base: Vec<usize> = base.collect();
        let before = fitted.problem();
        let global = problem.globals.iter().map(|unknown| {
            let same = before.globals.iter().position(|s| s.name == unknown.name);
            same.map_or(unknown.model_value, |i| fitted.global()[i])
        });
        let global = DVector::from_iterator(problem.globals.len(), global);
        let places: Vec<Option<StateId>> = layout
            .states
            .iter()
            .map(|state| before.body.layout().state(state))
            .collect();
        let (mut observation_sets, mut local) = (Vec::new(), Vec::new());
        for (index, flight) in dataset.flights.iter().enumerate() {
            let Some((observations, state)) =
                fitted.flight(index).filter(|_| flight.role == Role::Fit)
            else {
                continue;
            };
            let fresh = Observations::new(&problem, flight).map_err(|reason| FitError::Flight {
                file: flight.file.clone(),
                reason,
            })?;
            observation_sets.push(Observations {
                parameters: fresh.parameters,
                known_states: fresh.known_states,
                manifold: fresh.manifold,
                ..observations.clone()
            });
            let full = places
                .iter()
                .zip(&layout.initial)
                .map(|(place, initial)| place.map_or(*initial, |place| state[place.index()]));
            local.push(DVector::from_iterator(places.len(), full));
        }
        let grammar = catalogue
            .channels
            .and_then(|channels| Grammar::new(channels, layout));
        let bench = Self {
            catalogue: catalogue.clone(),
            grammar,
            problem,
            candidates: columns,
            base,
            observation_sets,
            threads: options.threads(),
        };
        Ok((bench, Iterate { global, local }))
    }

    /// The normal equations of every flight, by every unknown of the base and the catalogue.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn look(
        &self,
        problem: &FitProblem,
        point: &Iterate,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        let nothing = Kept::default();
        let from = Vantage {
            problem,
            point,
            kept: &nothing,
        };
        self.look_by(from, noise, None)
    }

    /// The same by the terms outside the catalogue too, whose unknowns come behind the shared ones.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn look_further(
        &self,
        from: Vantage<'_>,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        self.look_by(from, noise, self.grammar.as_ref())
    }

    fn look_by(
        &self,
        from: Vantage<'_>,
        noise: &NoiseModel,
        grammar: Option<&Grammar>,
    ) -> Result<Vec<NormalBlock>, FitError> {
        let Vantage { problem, point, .. } = from;
        let found = batch::each_on(self.threads, self.observation_sets.len(), |flight| {
            let observations = &self.observation_sets[flight];
            let unknowns = (&point.global, &point.local[flight]);
            let samples = observations.times.len();
            let loss = Loss::Whitened(noise);
            let found = match grammar {
                None => linearise(
                    problem,
                    observations,
                    unknowns,
                    samples,
                    Unknowns::All,
                    loss,
                ),
                Some(grammar) => {
                    let conditions = conditions(problem, observations, &point.global);
                    let (motion, places) = self.further(&conditions, grammar);
                    let by = (motion, places.as_slice());
                    from.kept.with(flight, |kept| {
                        linearise_with(
                            problem,
                            observations,
                            unknowns,
                            samples,
                            loss,
                            by,
                            Some(kept),
                        )
                    })
                }
            };
            found.map_err(|reason| self.impossible(flight, reason))
        });
        found.into_iter().collect()
    }

    /// Equations of motion with the terms of a grammar, and the places of all constants.
    fn further<'c>(
        &self,
        conditions: &'c BoundModel<'c>,
        grammar: &'c Grammar,
    ) -> (impl DifferentiableRhs + use<'c>, Vec<usize>) {
        let first = self.problem.body.layout().parameters.len();
        let mut places: Vec<usize> = self.problem.globals.iter().map(|s| s.param).collect();
        places.extend(first..first + grammar.terms.len());
        (grammar.motion(conditions, first), places)
    }

    /// Hands out a track's residuals with their derivatives by everything there is.
    ///
    /// # Errors
    /// In words, where the flight is impossible.
    pub(crate) fn each_residual_further(
        &self,
        problem: &FitProblem,
        observations: &Observations,
        unknowns: (&DVector<f64>, &DVector<f64>),
        each: impl FnMut(PointResidual<'_>),
    ) -> Result<(), String> {
        let conditions = conditions(problem, observations, unknowns.0);
        match &self.grammar {
            Some(grammar) => {
                let (motion, places) = self.further(&conditions, grammar);
                each_residual(problem, observations, unknowns, motion, &places, each)
            }
            None => {
                let places: Vec<usize> = self.problem.globals.iter().map(|s| s.param).collect();
                let motion = conditions.differentiable_rhs();
                each_residual(problem, observations, unknowns, motion, &places, each)
            }
        }
    }

    pub(crate) fn impossible(&self, flight: usize, reason: String) -> FitError {
        FitError::Flight {
            file: self.observation_sets[flight].file.clone(),
            reason,
        }
    }

    /// The model in which these candidates may be on, the others being off: for their derivatives it is quicker than one in which
    /// all may be.
    pub fn setting_with(&self, effects: &[usize]) -> FitProblem {
        let fixed = off(&self.catalogue, effects);
        FitProblem {
            body: Arc::new(CompiledModel::specialized(&self.catalogue.model, &fixed)),
            ..self.problem.clone()
        }
    }

    /// The shared unknowns of the base and of some candidates, by index, in order.
    pub fn unknowns(&self, with: &[usize]) -> Vec<usize> {
        let mut unknowns = self.base.clone();
        unknowns.extend(with.iter().flat_map(|&c| &self.candidates[c].global));
        unknowns.sort_unstable();
        unknowns
    }

    /// States of candidates that are not among these.
    pub fn states_but(&self, with: &[usize]) -> Vec<usize> {
        let each = self.candidates.iter().enumerate();
        each.filter(|(index, _)| !with.contains(index))
            .flat_map(|(_, columns)| columns.states.clone())
            .collect()
    }

    /// The directions of a flight's chart that move the states of candidates which are not among `with`, and all others.
    pub(crate) fn directions(&self, flight: usize, with: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let off = self.states_but(with);
        let manifold = &self.observation_sets[flight].manifold;
        let is_off =
            |direction: &usize| manifold.plain(*direction).is_some_and(|s| off.contains(&s));
        (0..manifold.dimension()).partition(is_off)
    }

    /// A flight's normal equations by its own unknowns without the states of candidates that are not among `with`; and which
    /// directions of its chart are left.
    pub(crate) fn own_of(
        &self,
        flight: usize,
        block: &NormalBlock,
        with: &[usize],
    ) -> (NormalBlock, Vec<usize>) {
        let (_, local) = self.directions(flight, with);
        (local_block(block, &local, &[]), local)
    }

    /// Fits the base and some candidates from a point on, all other candidates staying as they are there; the sum of squares
    /// that is left.
    ///
    /// # Errors
    /// In words, where that is impossible.
    pub fn refit(
        &self,
        problem: &FitProblem,
        with: &[usize],
        from: &Iterate,
        noise: &NoiseModel,
    ) -> Result<(Iterate, f64), String> {
        let unknowns = self.unknowns(with);
        let problem = FitProblem {
            globals: unknowns
                .iter()
                .map(|&i| problem.globals[i].clone())
                .collect(),
            ..problem.clone()
        };
        let held = self.states_but(with);
        let observation_sets = self.observation_sets.iter().map(|observations| {
            let mut known: Vec<usize> = observations
                .known_states
                .iter()
                .map(|(state, _)| *state)
                .collect();
            known.extend(&held);
            let mut parameters = observations.parameters.clone();
            for (unknown, value) in self.problem.globals.iter().zip(from.global.iter()) {
                parameters[unknown.param] = *value;
            }
            Observations {
                parameters,
                manifold: StateManifold::new(&self.problem.model, &known),
                ..observations.clone()
            }
        });
        let objective = Refit {
            known: problem
                .globals
                .iter()
                .map(|global| global.constraint)
                .collect(),
            problem,
            observation_sets: observation_sets.collect(),
            noise,
            threads: self.threads,
        };
        let start = Iterate {
            global: DVector::from_iterator(
                unknowns.len(),
                unknowns.iter().map(|&i| from.global[i]),
            ),
            local: from.local.clone(),
        };
        let leapt = objective.stepped(&start);
        let found = leapt.and_then(|leapt| solve(&objective, leapt, STEPS).ok());
        let found = match found {
            Some(found) => found,
            None => solve(&objective, start, STEPS).map_err(|failure| failure.to_string())?,
        };
        let Solution {
            iterate: point,
            squares,
            ..
        } = found;
        let mut global = from.global.clone();
        for (&i, value) in unknowns.iter().zip(point.global.iter()) {
            global[i] = *value;
        }
        let point = Iterate {
            global,
            local: point.local,
        };
        Ok((point, squares))
    }
}

fn conditions<'a>(
    problem: &'a FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
) -> BoundModel<'a> {
    problem.body.bind(observations.parameters(problem, global))
}

/// Places and values of everything that is off where only these candidates are on.
fn off(catalogue: &Catalogue, on: &[usize]) -> Vec<(usize, f64)> {
    let layout = Layout::new(&catalogue.model);
    let each = catalogue.candidates.iter().enumerate();
    let parts = each
        .filter(|(index, _)| !on.contains(index))
        .flat_map(|(_, candidate)| &candidate.coefficients);
    let mut fixed: Vec<(usize, f64)> = parts
        .map(|part| (layout.coefficient(part.index).index(), part.null_value))
        .collect();
    let loads = catalogue.channels.iter().flat_map(|c| c.loads);
    fixed.extend(loads.filter_map(|(name, ..)| Some((layout.parameter(name)?.index(), 0.0))));
    fixed
}

/// The least squares of the base with some candidates.
struct Refit<'a> {
    problem: FitProblem,
    observation_sets: Vec<Observations>,
    noise: &'a NoiseModel,
    known: Vec<Constraint>,
    threads: usize,
}

impl Refit<'_> {
    /// The point after one whole step, even where the squares are greater there: a new effect bends the valley in which the
    /// solution lies, and to follow it in small steps takes long.
    fn stepped(&self, from: &Iterate) -> Option<Iterate> {
        let blocks = batch::each_on(self.threads, self.observation_sets.len(), |flight| {
            self.linearise(flight, &from.global, &from.local[flight])
        });
        let blocks: Vec<NormalBlock> = blocks.into_iter().collect::<Result<_, _>>().ok()?;
        let system = eliminate(&blocks, 0.0).ok()?;
        let (matrix, gradient) = (&system.reduced, &system.gradient);
        let (step, _) = constrained_step(matrix, gradient, &from.global, &self.known, 0.0)?;
        let local = system.back_substitute(&step);
        let local = local.iter().zip(&from.local).enumerate();
        let local = local.map(|(flight, (step, local))| self.plus(flight, local, step));
        Some(Iterate {
            local: local.collect(),
            global: &from.global + step,
        })
    }
}

impl LeastSquaresProblem for Refit<'_> {
    fn flights(&self) -> usize {
        self.observation_sets.len()
    }

    fn linearise(
        &self,
        flight: usize,
        global: &DVector<f64>,
        local: &DVector<f64>,
    ) -> Result<NormalBlock, String> {
        let observations = &self.observation_sets[flight];
        let samples = observations.times.len();
        let loss = Loss::Whitened(self.noise);
        linearise(
            &self.problem,
            observations,
            (global, local),
            samples,
            Unknowns::All,
            loss,
        )
    }

    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.observation_sets[flight].manifold.plus(local, step)
    }

    fn constraints(&self) -> &[Constraint] {
        &self.known
    }

    fn threads(&self) -> usize {
        self.threads
    }
}
