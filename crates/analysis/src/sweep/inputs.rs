//! Inputs of each flight of a sweep: they depend on the plan, the number of the flight and the seed alone.

use std::collections::HashMap;

use flight::CompiledModel;
use flight::release::Vocabulary;
use flight::throw::{FIELDS, NearThrows, Throw, ThrowError, ThrownModel};
use flight::wind::gust_phases;
use model_spec::layout::inertia_depends_on;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use crate::sweep::plan::{Axis, AxisKind, Plan, Target, constant};

/// Data from which the inputs of all flights are made.
pub(crate) struct InputModel {
    x: Vec<f64>,
    p: Vec<f64>,
    thrown: Option<ThrownModel>,
    vocabulary: Vocabulary,
    /// Seed of the gusts and indices of the parameters that are their phases, if every flight has gusts of its own.
    gusts: Option<(u64, Vec<usize>)>,
    /// Indices of the constants by their names, if a moment of inertia varies with one.
    of_inertia: Option<HashMap<String, usize>>,
}

impl InputModel {
    pub(crate) fn new(plan: &Plan, compiled: &CompiledModel) -> Result<InputModel, ThrowError> {
        let thrown = plan.throw.map(|_| ThrownModel::new(&plan.model));
        let field = plan.release.wind_field.as_ref();
        let gusts = field.and_then(|field| field.gusts.as_ref());
        let place = |(name, _): (String, f64)| compiled.layout().parameter(&name);
        let gusts = gusts.filter(|_| plan.gusts).map(|gusts| {
            let phases = gust_phases(gusts.seed, 0).into_iter().filter_map(place);
            (
                gusts.seed,
                phases.map(codegen::layout::ParamId::index).collect(),
            )
        });
        let varies = |axis: &Axis| inertia_depends_on(&plan.model, &axis.name);
        let names = { compiled.layout().parameters.iter().cloned() }.zip(0..);
        Ok(InputModel {
            gusts,
            of_inertia: plan.axes.iter().any(varies).then(|| names.collect()),
            x: plan.release.state(),
            p: compiled.release_parameters(&plan.release).constants,
            thrown: thrown.transpose()?,
            vocabulary: Vocabulary::of(&plan.model),
        })
    }

    /// Parameters of the plan's release, in the order of the model's layout.
    pub(crate) fn parameters(&self) -> &[f64] {
        &self.p
    }
}

/// Draws the inputs of flights, one after the other.
pub(crate) struct Inputs<'p> {
    plan: &'p Plan,
    model: &'p InputModel,
    near: Option<NearThrows<'p>>,
    throw: Option<Throw>,
    /// Independent standard normal values of the current flight, one per normal quantity.
    independent: Vec<f64>,
    random: ChaCha8Rng,
    is_random: bool,
}

impl<'p> Inputs<'p> {
    pub(crate) fn new(plan: &'p Plan, model: &'p InputModel) -> Inputs<'p> {
        let near = model
            .thrown
            .as_ref()
            .map(|thrown| NearThrows::new(thrown, &model.x));
        let is_normal = |axis: &&Axis| matches!(axis.kind, AxisKind::Normal { .. });
        let is_random = |axis: &Axis| !matches!(axis.kind, AxisKind::Values(_));
        Inputs {
            plan,
            model,
            // Without axes the throw does not vary. With axes the states of a throw may depend on parameters.
            near: near.filter(|_| !plan.axes.is_empty()),
            throw: plan.throw,
            independent: vec![0.0; plan.axes.iter().filter(is_normal).count()],
            random: ChaCha8Rng::seed_from_u64(plan.seed),
            is_random: plan.axes.iter().any(is_random),
        }
    }

    /// Draws the values of the varied quantities of a flight, in the order of the plan's axes.
    pub(crate) fn draw(&mut self, flight: u64, values: &mut [f64]) {
        let plan = self.plan;
        if self.is_random {
            self.random.set_stream(flight);
            self.random.set_word_pos(0);
        }
        for number in &mut self.independent {
            *number = StandardNormal.sample(&mut self.random);
        }
        let (mut point, mut normal) = (flight % plan.grid, 0);
        for (axis, value) in plan.axes.iter().zip(values) {
            *value = match &axis.kind {
                AxisKind::Values(values) => {
                    let len = values.len() as u64;
                    let own = values[(point % len) as usize];
                    point /= len;
                    own
                }
                AxisKind::Normal { mean, sd } => {
                    normal += 1;
                    mean + sd * plan.factor.mix(normal - 1, &self.independent)
                }
                AxisKind::Uniform { low, high } => low + (high - low) * self.random.random::<f64>(),
            };
        }
    }

    /// Writes the initial states `x` and parameters `p` of a flight for the drawn `values`, with quaternions of length
    /// 1; `false` if one is out of its bounds, no body has such moments of inertia, or no state has the motion: such a flight
    /// is not simulated.
    pub(crate) fn start(
        &mut self,
        flight: u64,
        values: &[f64],
        x: &mut [f64],
        p: &mut [f64],
    ) -> bool {
        x.copy_from_slice(&self.model.x);
        p.copy_from_slice(&self.model.p);
        if let Some((seed, places)) = &self.model.gusts {
            for (place, (_, phase)) in places.iter().zip(gust_phases(*seed, flight)) {
                p[*place] = phase;
            }
        }
        for (axis, value) in self.plan.axes.iter().zip(values) {
            match axis.target {
                Target::Throw(index) => {
                    if let Some(throw) = &mut self.throw {
                        throw.set(FIELDS[index].0, *value);
                    }
                }
                Target::State(index) => x[index] = *value,
                Target::Parameter(index) => {
                    let known = constant(&self.model.vocabulary, &axis.name);
                    if known.is_some_and(|known| known.expected_instead_of(*value).is_some()) {
                        return false;
                    }
                    p[index] = *value;
                }
            }
        }
        if let Some(places) = &self.model.of_inertia
            && { &self.plan.model }
                .inertia_fault(|own| p[places[&own.name]])
                .is_some()
        {
            return false;
        }
        if let (Some(near), Some(throw)) = (&mut self.near, &self.throw) {
            return near.state(throw, [0.0; 2], p, x).is_ok();
        }
        self.model
            .vocabulary
            .quaternions
            .iter()
            .all(|states| normalise(x, *states))
    }
}

/// Scales the quaternion of the state indices `states` to length 1; `false` if it is 0.
fn normalise(x: &mut [f64], states: [usize; 4]) -> bool {
    let length = states.map(|i| x[i].powi(2)).iter().sum::<f64>().sqrt();
    for i in states {
        x[i] /= length;
    }
    length > 0.0
}
