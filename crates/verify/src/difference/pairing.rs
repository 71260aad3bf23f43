//! Determines which state and parameter of one model corresponds to which of another: by name, by role in the body,
//! then by their influence on the equations.

use super::values::Everything;
use crate::random::Random;
use crate::sample::typical;
use model_spec::model::{FrameKind, Model};
use model_spec::unit::Unit;
use oracle::Point;
use oracle::scalar::Field;
use serde::Serialize;
use std::collections::BTreeMap;

/// Number of random points at which the influence of an unpaired state or parameter on the equations is measured.
const POINTS: usize = 3;
/// Maximum relative difference at which two values count as equal when states and parameters of two models are paired.
const PAIRING_TOLERANCE: f64 = 1e-7;

/// For every state and parameter of the new model, the corresponding one of the old model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairing {
    /// For each state of the new model, the index of the corresponding state of the old model; `None` for an added
    /// state.
    pub states: Vec<Option<usize>>,
    /// For each parameter of the new model, the index of the corresponding parameter of the old model; `None` for an
    /// added parameter.
    pub parameters: Vec<Option<usize>>,
}

/// A state or parameter that has different names in the old and the new model.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Renamed {
    /// Name of the state or parameter in the old model.
    pub from: String,
    /// Name of the state or parameter in the new model.
    pub to: String,
}

/// A state (`true`) or a parameter (`false`), with its index.
type Symbol = (bool, usize);

impl Pairing {
    /// Pairs each state and parameter of the new model with the corresponding one of the old model.
    pub fn of(old: &Everything<'_>, new: &Everything<'_>) -> Self {
        let mut pairing = Self {
            states: by_name(&old.code.layout.states, &new.code.layout.states),
            parameters: by_name(&old.code.layout.parameters, &new.code.layout.parameters),
        };
        pairing.by_role(old.model, new.model);
        pairing.by_effect(old, new);
        pairing
    }

    /// Index of the new model's state that corresponds to the old model's state with index `old`; `None` if it was
    /// removed.
    pub fn new_state(&self, old: usize) -> Option<usize> {
        self.states.iter().position(|&state| state == Some(old))
    }

    /// Index of the new model's parameter that corresponds to the old model's parameter with index `old`; `None` if it
    /// was removed.
    pub fn new_parameter(&self, old: usize) -> Option<usize> {
        self.parameters.iter().position(|&state| state == Some(old))
    }

    /// Whether every state and parameter of each model has a counterpart in the other.
    pub fn is_complete(&self, old: &Model, new: &Model) -> bool {
        let all = |list: &[Option<usize>], count: usize| {
            list.len() == count && list.iter().all(Option::is_some)
        };
        let parameters =
            |model: &Model| model.params.len() + model.coefficients.len() + 3 * model.inputs.len();
        new.states.len() == old.states.len()
            && parameters(new) == parameters(old)
            && all(&self.states, new.states.len())
            && all(&self.parameters, parameters(new))
    }

    /// States and parameters whose names differ between the old and the new model.
    pub fn renamed(&self, old: &Everything<'_>, new: &Everything<'_>) -> Vec<Renamed> {
        let (a, b) = (&old.code.layout, &new.code.layout);
        let mut out = Vec::new();
        for (pairs, old_names, new_names) in [
            (&self.states, &a.states, &b.states),
            (&self.parameters, &a.parameters, &b.parameters),
        ] {
            for (from, to) in pairs.iter().zip(new_names) {
                let from = from.map(|from| &old_names[from]).filter(|from| *from != to);
                out.extend(from.map(|from| Renamed {
                    from: from.clone(),
                    to: to.clone(),
                }));
            }
        }
        out
    }

    /// Returns a copy of the point `there` of the new model. The values of all paired states and parameters, the time
    /// and the marker position are taken from the point `here` of the old model.
    pub fn carry<T: Field>(&self, here: &Point<T>, there: &Point<T>) -> Point<T> {
        let given = here.parameters();
        let mut out = there.clone();
        out.time = here.time;
        out.marker = here.marker;
        for (to, from) in out.states.iter_mut().zip(&self.states) {
            *to = from.map_or(*to, |from| here.states[from]);
        }
        for (to, from) in out.parameters_mut().zip(&self.parameters) {
            *to = from.map_or(*to, |from| given[from]);
        }
        out
    }

    fn by_role(&mut self, old: &Model, new: &Model) {
        let (old, new) = (roles(old), roles(new));
        for (role, state) in new {
            if let Some(&from) = old.get(&role)
                && self.states[state].is_none()
                && self.new_state(from).is_none()
            {
                self.states[state] = Some(from);
            }
        }
    }

    /// Pairs the states and parameters that have no counterpart yet with those of the same kind and unit in the other
    /// model. Pairs whose influence on the equations differs least are formed first.
    fn by_effect(&mut self, old: &Everything<'_>, new: &Everything<'_>) {
        let (olds, news) = self.unpaired(old.model, new.model);
        if olds.is_empty() || news.is_empty() {
            return;
        }
        let (here, there) = (
            Effects::of(old, &olds, Some, Some),
            Effects::of(
                new,
                &news,
                |state| self.states[state],
                |parameter| self.parameters[parameter],
            ),
        );
        let mut pairs = Vec::new();
        for (i, a) in olds.iter().enumerate() {
            for (j, b) in news.iter().enumerate() {
                if a.0 != b.0 || unit(old.model, *a) != unit(new.model, *b) {
                    continue;
                }
                let defaults = value(old.model, *a) != value(new.model, *b);
                pairs.push((here.conflicts(i, &there, j), defaults, i.abs_diff(j), i, j));
            }
        }
        pairs.sort_unstable();
        let (mut used, mut found) = (Vec::new(), Vec::new());
        for (_, _, _, i, j) in pairs {
            if !used.contains(&i) && !found.contains(&j) {
                used.push(i);
                found.push(j);
                let ((is_state, from), (_, to)) = (olds[i], news[j]);
                if is_state {
                    self.states[to] = Some(from);
                } else {
                    self.parameters[to] = Some(from);
                }
            }
        }
    }

    /// Lists the symbols (states and parameters) of the old model, and those of the new model, that are not paired yet.
    fn unpaired(&self, old: &Model, new: &Model) -> (Vec<Symbol>, Vec<Symbol>) {
        let states = (0..old.states.len()).filter(|&i| self.new_state(i).is_none());
        let count = Point::defaults(old).parameters().len();
        let rest = (0..count).filter(|&i| self.new_parameter(i).is_none());
        let olds = states.map(|i| (true, i)).chain(rest.map(|i| (false, i)));
        let states = (0..new.states.len()).filter(|&i| self.states[i].is_none());
        let rest = (0..self.parameters.len()).filter(|&i| self.parameters[i].is_none());
        let news = states.map(|i| (true, i)).chain(rest.map(|i| (false, i)));
        (olds.collect(), news.collect())
    }
}

fn by_name(old: &[String], new: &[String]) -> Vec<Option<usize>> {
    new.iter()
        .map(|name| old.iter().position(|o| o == name))
        .collect()
}

/// Index of the state for each role in the model's body. The key is (role, index of the component), where the role is
/// position, velocity, angular velocity, angle or angular rate of a frame, or quaternion. Empty for a model without a
/// body.
fn roles(model: &Model) -> BTreeMap<(&'static str, usize), usize> {
    let mut out = BTreeMap::new();
    let Some(body) = &model.body else {
        return out;
    };
    let mut put = |role, states: &[usize]| {
        for (k, &state) in states.iter().enumerate() {
            out.insert((role, k), state);
        }
    };
    put("position", &body.position);
    put("velocity", &body.velocity);
    if let Some((states, _)) = body.rotation.as_ref().and_then(|r| r.angular_velocity) {
        put("angular velocity", &states);
    }
    let turned = model.frames.iter().filter_map(|frame| match frame.kind {
        FrameKind::Turned { angle, rate, .. } => Some((angle, rate)),
        _ => None,
    });
    let (angles, rates): (Vec<_>, Vec<_>) = turned.unzip();
    put("angle", &angles);
    put("rate", &rates.into_iter().flatten().collect::<Vec<_>>());
    for frame in &model.frames {
        if let FrameKind::Quaternion { states, .. } = frame.kind {
            put("quaternion", &states);
        }
    }
    out
}

fn unit(model: &Model, (is_state, index): Symbol) -> Unit {
    if is_state {
        return model.states[index].unit;
    }
    let constants = model.params.iter().chain(&model.coefficients);
    let inputs = model.inputs.iter().flat_map(|input| [input.unit; 3]);
    let mut units = constants.map(|c| c.unit).chain(inputs);
    units.nth(index).unwrap_or_default()
}

fn value(model: &Model, (is_state, index): Symbol) -> f64 {
    if is_state {
        model.states[index].value
    } else {
        Point::defaults(model).parameters()[index]
    }
}

/// How the rows of a model (state derivatives and observation) depend on each symbol (state or parameter) that has no
/// counterpart yet in the other of two compared models. The rows are evaluated at random points, once for each examined
/// symbol. At a point, all symbols without counterpart of the same kind and unit have one common value; only the
/// examined symbol has another value.
struct Effects {
    /// For each unpaired symbol and each random point: values of the rows (state derivatives and observation) that have
    /// a counterpart in the other model, and the sorted values of the remaining rows.
    values: Vec<Vec<(Vec<f64>, Vec<f64>)>>,
}

impl Effects {
    fn of(
        model: &Everything<'_>,
        open: &[Symbol],
        state: impl Fn(usize) -> Option<usize>,
        parameter: impl Fn(usize) -> Option<usize>,
    ) -> Self {
        let is_open = |symbol: Symbol| open.contains(&symbol);
        let base = |round: usize, moved: Option<Symbol>| {
            let mut point = Point::defaults(model.model);
            let draw = |symbol: Symbol, own: Option<usize>| {
                let unit = unit(model.model, symbol);
                let seed = match own {
                    Some(own) if !is_open(symbol) => format!("{round} {} {own}", symbol.0),
                    _ if moved == Some(symbol) => format!("{round} {} {unit} moved", symbol.0),
                    _ => format!("{round} {} {unit}", symbol.0),
                };
                let mut random = Random::new(0, &seed);
                typical(unit) * random.between(0.2, 1.0)
            };
            for i in 0..point.states.len() {
                point.states[i] = draw((true, i), state(i));
            }
            for (i, to) in point.parameters_mut().enumerate() {
                *to = draw((false, i), parameter(i));
            }
            point.time = 0.3;
            point.marker = [0.03, -0.05, 0.07].into();
            model.numbers(&point)
        };
        let states = model.code.layout.states.len();
        let own_row = |i: usize| !is_open((true, i));
        let split = |values: &[f64], symbol: Symbol| {
            let mut fixed: Vec<(usize, f64)> = Vec::new();
            let mut rest = Vec::new();
            for (i, &v) in values.iter().enumerate().take(states) {
                match state(i).filter(|_| own_row(i)) {
                    Some(old) => fixed.push((old, v)),
                    None => rest.push(v),
                }
            }
            fixed.sort_by_key(|(old, _)| *old);
            let mut fixed: Vec<f64> = fixed.into_iter().map(|(_, v)| v).collect();
            // The observation does not depend on the names of the states.
            fixed.extend(&values[states..states + model.code.observed]);
            if symbol.0 {
                fixed.push(values[symbol.1]);
            }
            rest.sort_by(f64::total_cmp);
            (fixed, rest)
        };
        let of_symbol = |&symbol: &Symbol| {
            (0..POINTS)
                .map(|round| split(&base(round, Some(symbol)), symbol))
                .collect()
        };
        Self {
            values: open.iter().map(of_symbol).collect(),
        }
    }

    /// Dissimilarity of two unpaired symbols (states or parameters), one of this model and one of the model `other`.
    /// `here` and `there` are their indices in the lists of unpaired symbols of these models. Each model is evaluated
    /// with its symbol changed. The dissimilarity is the number of values (state derivatives and observation, at all
    /// random points) that then differ between the models; 0 means that the symbols may correspond.
    fn conflicts(&self, here: usize, other: &Self, there: usize) -> usize {
        let differ = |a: &[f64], b: &[f64]| {
            let unequal = a.iter().zip(b).filter(|(a, b)| !is_close(**a, **b));
            unequal.count() + a.len().abs_diff(b.len())
        };
        let points = self.values[here].iter().zip(&other.values[there]);
        points
            .map(|(a, b)| differ(&a.0, &b.0) + differ(&a.1, &b.1))
            .sum()
    }
}

fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= PAIRING_TOLERANCE * (a.abs() + b.abs()) + 1e-12 || (a.is_nan() && b.is_nan())
}
