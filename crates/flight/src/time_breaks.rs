//! Times at which the right-hand side of a model is not smooth: knots of tables of the time, and switches at a stated
//! time.

use codegen::Layout;
use model_spec::model::{Expr, ExprKind, Function, Model};

/// Expressions of a model that are not smooth in the time, each a function of the time and of parameters alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct TimeBreaks {
    /// Arguments piecewise linear in the time, each after those within it, with the values where it is not smooth.
    arguments: Vec<(InTime, Vec<f64>)>,
    /// For each auxiliary variable, its definition if that is piecewise linear in the time; empty without arguments.
    variables: Vec<Option<InTime>>,
    /// Whether a function with kinks has an argument that changes with the time, but is not piecewise linear in it.
    has_others: bool,
}

/// Expression that is piecewise linear in the time for all parameter values.
#[derive(Clone, Debug)]
enum InTime {
    Time,
    Constant(f64),
    /// Value of the parameter with this index in the model's layout.
    Parameter(usize),
    /// Auxiliary variable with this index, and whether it depends on the time.
    Variable(usize, bool),
    Two(fn(f64, f64) -> f64, Box<[InTime; 2]>),
}

impl TimeBreaks {
    /// Collects the functions of `model` with kinks whose argument is piecewise linear in the time.
    pub fn of(model: &Model, layout: &Layout) -> TimeBreaks {
        let reader = Reader::new(model, layout);
        let mut breaks = TimeBreaks::default();
        for root in model.expressions() {
            reader.collect(root, &mut breaks);
        }
        if !breaks.arguments.is_empty() {
            breaks.variables = reader.variables;
        }
        breaks
    }

    /// Whether every kink or jump of a function of the time alone is among the breaks.
    pub fn is_complete(&self) -> bool {
        !self.has_others
    }

    /// Times of the breaks, s, for parameter values in the order of the model's layout; increasing.
    pub fn at(&self, parameters: &[f64]) -> Vec<f64> {
        let mut times = Vec::new();
        for (argument, knots) in &self.arguments {
            let found = self.crossings(argument, knots, &times, parameters);
            times.extend(found);
            times.sort_unstable_by(f64::total_cmp);
            times.dedup();
        }
        times
    }

    /// Times at which `argument` has one of the values `knots`, where it is linear between the increasing `times`.
    fn crossings(
        &self,
        argument: &InTime,
        knots: &[f64],
        times: &[f64],
        parameters: &[f64],
    ) -> Vec<f64> {
        let mut found = Vec::new();
        for k in 0..=times.len() {
            let from = k.checked_sub(1).map(|k| times[k]);
            // Two times within the interval, which may be unbounded.
            let [a, b] = match (from, times.get(k)) {
                (Some(from), Some(until)) => [1.0, 2.0].map(|p| from + (until - from) * p / 3.0),
                (Some(from), None) => [from + 1.0, from + 2.0],
                (None, Some(until)) => [until - 2.0, until - 1.0],
                (None, None) => [0.0, 1.0],
            };
            let [at_a, at_b] = [a, b].map(|t| self.value(argument, t, parameters));
            let slope = (at_b - at_a) / (b - a);
            let is_within = |time: &f64| {
                time.is_finite()
                    && from.is_none_or(|from| *time >= from)
                    && times.get(k).is_none_or(|until| time <= until)
            };
            let at = |time: f64| at_a + slope * (time - a);
            let first = from.map_or(f64::NEG_INFINITY * slope, at);
            let last = times
                .get(k)
                .map_or(f64::INFINITY * slope, |until| at(*until));
            // A knot at an end of the interval may be missed by rounding: that end is a break already.
            let begin = knots.partition_point(|knot| *knot < first.min(last));
            let until = knots.partition_point(|knot| *knot <= first.max(last));
            let inner = knots.get(begin..until).unwrap_or_default().iter();
            found.extend(
                inner
                    .map(|knot| a + (knot - at_a) / slope)
                    .filter(is_within),
            );
        }
        found
    }

    fn value(&self, argument: &InTime, t: f64, parameters: &[f64]) -> f64 {
        let mut variables = Vec::with_capacity(self.variables.len());
        for definition in &self.variables {
            let value = definition
                .as_ref()
                .map(|of| of.at(t, parameters, &variables));
            variables.push(value.unwrap_or(f64::NAN));
        }
        argument.at(t, parameters, &variables)
    }
}

impl InTime {
    fn two(a: InTime, b: InTime, function: fn(f64, f64) -> f64) -> Option<InTime> {
        Some(InTime::Two(function, Box::new([a, b])))
    }

    fn has_time(&self) -> bool {
        match self {
            InTime::Time => true,
            InTime::Constant(_) | InTime::Parameter(_) => false,
            InTime::Variable(_, has_time) => *has_time,
            InTime::Two(_, parts) => parts.iter().any(InTime::has_time),
        }
    }

    fn at(&self, t: f64, parameters: &[f64], variables: &[f64]) -> f64 {
        match self {
            InTime::Time => t,
            InTime::Constant(value) => *value,
            InTime::Parameter(index) => parameters[*index],
            InTime::Variable(index, _) => variables[*index],
            InTime::Two(function, parts) => {
                let [a, b] = [&parts[0], &parts[1]].map(|part| part.at(t, parameters, variables));
                function(a, b)
            }
        }
    }
}

struct Reader<'m> {
    model: &'m Model,
    layout: &'m Layout,
    /// For each auxiliary variable so far, its definition if that is piecewise linear in the time.
    variables: Vec<Option<InTime>>,
    /// For each auxiliary variable so far, whether it may change with the time where the state rests.
    times: Vec<bool>,
}

impl<'m> Reader<'m> {
    fn new(model: &'m Model, layout: &'m Layout) -> Reader<'m> {
        let mut reader = Reader {
            model,
            layout,
            variables: Vec::with_capacity(model.aux_variables.len()),
            times: Vec::with_capacity(model.aux_variables.len()),
        };
        for variable in &model.aux_variables {
            let definition = reader.read(&variable.value);
            let has_time = reader.has_time(&variable.value);
            reader.variables.push(definition);
            reader.times.push(has_time);
        }
        reader
    }

    /// Adds the arguments within `e`, inner ones first, at whose knots a function of the time is not smooth.
    fn collect(&self, e: &Expr, breaks: &mut TimeBreaks) {
        for child in e.children() {
            self.collect(child, breaks);
        }
        match &e.kind {
            ExprKind::Call(Function::Table(index), a) => {
                let knots = &self.model.tables[*index].arguments[0].knots;
                self.add([a, a], self.read(a), knots, breaks);
            }
            ExprKind::Lookup(index, a, b) => {
                let of_arguments = self.model.tables[*index].arguments.iter();
                for (argument, of_argument) in [a, b].into_iter().zip(of_arguments) {
                    let read = self.read(argument);
                    self.add([argument, argument], read, &of_argument.knots, breaks);
                }
            }
            ExprKind::Call(Function::Step | Function::Sign | Function::Abs, a) => {
                self.add([a, a], self.read(a), &[0.0], breaks);
            }
            ExprKind::Min(a, b) | ExprKind::Max(a, b) => {
                let both = self.read(a).zip(self.read(b));
                let difference = both.and_then(|(a, b)| InTime::two(a, b, |a, b| a - b));
                self.add([a, b], difference, &[0.0], breaks);
            }
            _ => {}
        }
    }

    /// Adds an argument made of the expressions `of`, as it was read, with its knots.
    fn add(&self, of: [&Expr; 2], read: Option<InTime>, knots: &[f64], breaks: &mut TimeBreaks) {
        match read {
            Some(argument) if argument.has_time() => {
                breaks.arguments.push((argument, knots.to_vec()));
            }
            Some(_) => {}
            None => breaks.has_others |= of.into_iter().any(|e| self.has_time(e)),
        }
    }

    /// Whether an expression may change with the time where the state rests.
    fn has_time(&self, e: &Expr) -> bool {
        e.nodes().any(|e| match &e.kind {
            ExprKind::Time => true,
            ExprKind::AuxVariable(i) => self.times.get(*i).is_none_or(|has_time| *has_time),
            // They stand for equations, loads or angles that are not read here.
            ExprKind::Unknown(..)
            | ExprKind::Determinacy(_)
            | ExprKind::Rate(..)
            | ExprKind::BodyRate(..)
            | ExprKind::Axis(..)
            | ExprKind::SpecificForce
            | ExprKind::AngularAcceleration => true,
            _ => false,
        })
    }

    fn read(&self, e: &Expr) -> Option<InTime> {
        use ExprKind as K;
        let of = |e: &Expr| self.read(e);
        let parameter = |name: &str| {
            let index = self.layout.parameter(name)?;
            Some(InTime::Parameter(index.index()))
        };
        let none = InTime::Constant(0.0);
        match &e.kind {
            K::Number { value, .. } => Some(InTime::Constant(*value)),
            K::Pi => Some(InTime::Constant(std::f64::consts::PI)),
            K::Time => Some(InTime::Time),
            K::Param(i) if self.model.params[*i].varies => None,
            K::Param(i) => parameter(&self.model.params[*i].name),
            K::Coefficient(i) => parameter(&self.model.coefficients[*i].name),
            K::AuxVariable(i) => {
                let definition = self.variables.get(*i)?.as_ref()?;
                Some(InTime::Variable(*i, definition.has_time()))
            }
            K::Neg(a) => InTime::two(none, of(a)?, |a, b| a - b),
            K::Add(a, b) => InTime::two(of(a)?, of(b)?, |a, b| a + b),
            K::Sub(a, b) => InTime::two(of(a)?, of(b)?, |a, b| a - b),
            K::Min(a, b) => InTime::two(of(a)?, of(b)?, f64::min),
            K::Max(a, b) => InTime::two(of(a)?, of(b)?, f64::max),
            K::Call(Function::Abs, a) => InTime::two(of(a)?, none, |a, _| a.abs()),
            K::Mul(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                let is_linear = !(a.has_time() && b.has_time());
                is_linear.then(|| InTime::two(a, b, |a, b| a * b))?
            }
            K::Div(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                let is_linear = !b.has_time();
                is_linear.then(|| InTime::two(a, b, |a, b| a / b))?
            }
            _ => None,
        }
    }
}
