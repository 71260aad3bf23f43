//! Singular points: divisors that may be zero, and guarded functions.

use super::Checker;
use super::kept::{Kept, named};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, Function, Interpolation, Model, Shape};

/// A subexpression that is not differentiable at some point, with its defined behaviour there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SingularPoint {
    /// Source span of the subexpression that is not differentiable at the point.
    pub span: Span,
    /// Source text of the subexpression that is not differentiable at the point.
    pub text: String,
    /// Behaviour at the singular point and condition under which it occurs, such as `has derivative 0 where … is 0`.
    pub what: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Sign {
    Unknown,
    NotNegative,
    NotZero,
    Positive,
}

impl Sign {
    fn never_zero(self) -> bool {
        matches!(self, Sign::NotZero | Sign::Positive)
    }

    fn never_negative(self) -> bool {
        matches!(self, Sign::NotNegative | Sign::Positive)
    }

    fn times(self, other: Sign) -> Sign {
        match (self, other) {
            (Sign::Positive, s) | (s, Sign::Positive) => s,
            (Sign::NotZero, Sign::NotZero) => Sign::NotZero,
            (Sign::NotNegative, Sign::NotNegative) => Sign::NotNegative,
            _ => Sign::Unknown,
        }
    }

    fn plus(self, other: Sign) -> Sign {
        match (self.never_negative(), other.never_negative()) {
            (true, true) if self == Sign::Positive || other == Sign::Positive => Sign::Positive,
            (true, true) => Sign::NotNegative,
            _ => Sign::Unknown,
        }
    }
}

struct Signs<'m> {
    model: &'m Model,
    kept: Kept<'m>,
    lets: Vec<Sign>,
    ranges: Vec<Option<(f64, f64)>>,
}

impl<'m> Signs<'m> {
    fn new(model: &'m Model) -> Signs<'m> {
        let without_limits = Signs::knowing(model, Kept::new(model));
        match model.limits.is_empty() {
            true => without_limits,
            false => Signs::knowing(model, Kept::learned(model, |e| without_limits.range(e))),
        }
    }

    fn knowing(model: &'m Model, kept: Kept<'m>) -> Signs<'m> {
        let mut signs = Signs {
            model,
            kept,
            lets: Vec::with_capacity(model.aux_variables.len()),
            ranges: Vec::with_capacity(model.aux_variables.len()),
        };
        for named in &model.aux_variables {
            let (sign, range) = (signs.of(&named.value), signs.range(&named.value));
            signs.lets.push(sign);
            signs.ranges.push(range);
        }
        signs
    }

    fn of(&self, e: &Expr) -> Sign {
        if self.kept.is_positive(e) {
            return Sign::Positive;
        }
        let sign = self.by_parts(e);
        match self.kept.is_never_zero(e) {
            true if sign.never_negative() => Sign::Positive,
            true => Sign::NotZero,
            false => sign,
        }
    }

    fn by_parts(&self, e: &Expr) -> Sign {
        use ExprKind as K;
        match self.range(e) {
            Some((least, _)) if least > 0.0 => return Sign::Positive,
            Some((_, greatest)) if greatest < 0.0 => return Sign::NotZero,
            _ => {}
        }
        let bounded = |bounds: Option<(f64, f64)>| match bounds {
            Some((least, _)) if least > 0.0 => Sign::Positive,
            _ => Sign::NotZero,
        };
        match &e.kind {
            K::Number { value, .. } if *value > 0.0 => Sign::Positive,
            K::Number { value, .. } if *value < 0.0 => Sign::NotZero,
            K::Number { .. } => Sign::NotNegative,
            K::Pi | K::Call(Function::Exp, _) => Sign::Positive,
            // A divisor must not contain one whose default is 0: see `zero_default`.
            K::Param(i) if self.model.params[*i].varies => Sign::Unknown,
            K::Param(i) => bounded(self.model.params[*i].bounds),
            K::Coefficient(i) => bounded(self.model.coefficients[*i].bounds),
            K::AuxVariable(i) => self.lets.get(*i).copied().unwrap_or(Sign::Unknown),
            K::Neg(a) if self.of(a).never_zero() => Sign::NotZero,
            K::Mul(a, b) | K::Div(a, b) => self.of(a).times(self.of(b)),
            K::Add(a, b) => self.of(a).plus(self.of(b)),
            K::Pow(a, doubled) => match self.of(a) {
                _ if *doubled == 0 => Sign::Positive,
                Sign::Positive => Sign::Positive,
                Sign::NotZero if doubled % 4 == 0 => Sign::Positive,
                Sign::NotZero if doubled % 2 == 0 => Sign::NotZero,
                Sign::NotNegative => Sign::NotNegative,
                _ if doubled % 4 == 0 || doubled % 2 != 0 => Sign::NotNegative,
                _ => Sign::Unknown,
            },
            K::RealPower(a, _) if self.of(a) == Sign::Positive => Sign::Positive,
            K::RealPower(..) | K::Norm(_) | K::Call(Function::Step, _) => Sign::NotNegative,
            K::Call(Function::Sqrt, a) if self.of(a) == Sign::Positive => Sign::Positive,
            K::Call(Function::Sqrt, _) => Sign::NotNegative,
            K::Call(Function::Abs, a) if self.of(a).never_zero() => Sign::Positive,
            K::Call(Function::Abs, _) => Sign::NotNegative,
            K::Dot(a, b) if a.same(b) => Sign::NotNegative,
            K::Ratio(parts) => {
                let signs = parts.each_ref().map(|part| self.of(part));
                match signs.iter().all(|sign| sign.never_negative()) {
                    true => Sign::NotNegative,
                    false => Sign::Unknown,
                }
            }
            K::Max(a, b) => match (self.of(a), self.of(b)) {
                (Sign::Positive, _) | (_, Sign::Positive) => Sign::Positive,
                (a, b) if a.never_negative() || b.never_negative() => Sign::NotNegative,
                _ => Sign::Unknown,
            },
            K::Min(a, b) => match (self.of(a), self.of(b)) {
                (Sign::Positive, Sign::Positive) => Sign::Positive,
                (a, b) if a.never_negative() && b.never_negative() => Sign::NotNegative,
                _ => Sign::Unknown,
            },
            _ => Sign::Unknown,
        }
    }

    /// Range of an expression, SI, by interval arithmetic over the bounds of parameters and what limits keep.
    fn range(&self, e: &Expr) -> Option<(f64, f64)> {
        let own = self.range_of_parts(e);
        let Some((least, greatest)) = self.kept.range(e) else {
            return own;
        };
        let (from, to) = own.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        Some((from.max(least), to.min(greatest)))
    }

    fn range_of_parts(&self, e: &Expr) -> Option<(f64, f64)> {
        use ExprKind as K;
        match &e.kind {
            K::Number { value, .. } => Some((*value, *value)),
            K::Param(i) => self.model.params[*i].bounds,
            K::Coefficient(i) => self.model.coefficients[*i].bounds,
            K::AuxVariable(i) => *self.ranges.get(*i)?,
            K::Neg(a) => self.range(a).map(|(least, greatest)| (-greatest, -least)),
            K::Add(a, b) => {
                let (a, b) = (self.range(a)?, self.range(b)?);
                Some((a.0 + b.0, a.1 + b.1))
            }
            K::Sub(a, b) => {
                let (a, b) = (self.range(a)?, self.range(b)?);
                Some((a.0 - b.1, a.1 - b.0))
            }
            K::Mul(a, b) => Some(product(self.range(a)?, self.range(b)?)),
            K::Div(a, b) => {
                let (least, greatest) = self.range(b)?;
                let is_away_from_zero = least > 0.0 || greatest < 0.0;
                let inverse = (1.0 / greatest, 1.0 / least);
                is_away_from_zero.then(|| Some(product(self.range(a)?, inverse)))?
            }
            K::Pi => Some((std::f64::consts::PI, std::f64::consts::PI)),
            K::Call(function, a) => of_function(*function, self.range(a)),
            K::Pow(a, doubled) if *doubled > 0 && doubled % 4 == 0 => {
                let power = |x: f64| x.powi(doubled / 2);
                let Some((least, greatest)) = self.range(a) else {
                    return Some((0.0, f64::INFINITY));
                };
                let (one, other) = (power(least), power(greatest));
                let has_zero = least <= 0.0 && greatest >= 0.0;
                let smallest = if has_zero { 0.0 } else { one.min(other) };
                Some((smallest, one.max(other)))
            }
            K::Norm(_) => Some((0.0, f64::INFINITY)),
            K::Min(a, b) => {
                let (a, b) = (self.range(a)?, self.range(b)?);
                Some((a.0.min(b.0), a.1.min(b.1)))
            }
            K::Max(a, b) => {
                let (a, b) = (self.range(a)?, self.range(b)?);
                Some((a.0.max(b.0), a.1.max(b.1)))
            }
            _ => None,
        }
        // The sum of unbounded ranges may have no bounds.
        .filter(|(least, greatest)| !least.is_nan() && !greatest.is_nan())
    }

    /// Factor of the divisor `e` that may be zero; `e` itself if no single one is found.
    fn culprit<'e>(&self, e: &'e Expr) -> &'e Expr {
        match &e.kind {
            ExprKind::Mul(a, b) if !self.of(a).never_zero() && self.of(b).never_zero() => {
                self.culprit(a)
            }
            ExprKind::Mul(a, b) if self.of(a).never_zero() => self.culprit(b),
            ExprKind::Neg(a) => self.culprit(a),
            ExprKind::Pow(a, doubled) if *doubled > 0 => self.culprit(a),
            _ => e,
        }
    }
}

/// Range of a product; a factor of 0 makes 0 also of what is unbounded.
fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let corners = [(a.0, b.0), (a.0, b.1), (a.1, b.0), (a.1, b.1)];
    let corners = corners.map(|(a, b)| if a == 0.0 || b == 0.0 { 0.0 } else { a * b });
    let least = corners.into_iter().fold(f64::INFINITY, f64::min);
    let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
    (least, greatest)
}

/// Range of the values of a function, given that of its argument.
fn of_function(function: Function, argument: Option<(f64, f64)>) -> Option<(f64, f64)> {
    use std::f64::consts::{FRAC_PI_2, PI};
    let everything = (f64::NEG_INFINITY, f64::INFINITY);
    let (least, greatest) = argument.unwrap_or(everything);
    Some(match function {
        Function::Sin => cosines(least - FRAC_PI_2, greatest - FRAC_PI_2),
        Function::Cos => cosines(least, greatest),
        Function::Tan => {
            let (low, high) = cosines(least, greatest);
            let is_away_from_zero = low > 0.0 || high < 0.0;
            return is_away_from_zero.then(|| (rounded(least.tan()), rounded(greatest.tan())));
        }
        Function::Sign => (-1.0, 1.0),
        Function::Tanh => (least.tanh(), greatest.tanh()),
        Function::Step => (0.0, 1.0),
        Function::Atan => (least.atan(), greatest.atan()),
        Function::Asin => (-FRAC_PI_2, FRAC_PI_2),
        Function::Acos => (0.0, PI),
        Function::Exp => (least.exp(), greatest.exp()),
        Function::Sqrt => (least.max(0.0).sqrt(), greatest.max(0.0).sqrt()),
        Function::Abs if least > 0.0 || greatest < 0.0 => {
            let (a, b) = (least.abs(), greatest.abs());
            (a.min(b), a.max(b))
        }
        Function::Abs => (0.0, least.abs().max(greatest.abs())),
        Function::Log => return (least > 0.0).then(|| (least.ln(), greatest.ln())),
        Function::Table(_) => return None,
    })
}

/// Value of a function of an angle; 0 if it is as close to 0 as that of 180 degrees, which are not exact in radians.
fn rounded(value: f64) -> f64 {
    const NEGLIGIBLE: f64 = 1e-12;
    if value.abs() < NEGLIGIBLE { 0.0 } else { value }
}

/// Range of the cosine over a range of angles, rad.
fn cosines(least: f64, greatest: f64) -> (f64, f64) {
    use std::f64::consts::{PI, TAU};
    let contains = |angle: f64| {
        let turns = |from: f64| (from - angle) / TAU;
        turns(least).ceil() <= turns(greatest).floor()
    };
    let (one, other) = (rounded(least.cos()), rounded(greatest.cos()));
    let low = if contains(PI) { -1.0 } else { one.min(other) };
    let high = if contains(0.0) { 1.0 } else { one.max(other) };
    (low, high)
}

/// The divisor of a quotient, or the base of a negative power; `None` for other expressions.
fn divisor(e: &Expr) -> Option<&Expr> {
    match &e.kind {
        ExprKind::Div(_, b) => Some(b),
        ExprKind::Pow(a, doubled) if *doubled < 0 => Some(a),
        _ => None,
    }
}

impl Checker<'_> {
    /// Reports divisors that may be zero, functions of numbers outside their domain, and tangents unless bounds or a
    /// validity limit keep their cosine away from zero.
    pub fn singularities(&mut self) {
        let mut faults: Vec<Diagnostic> = Vec::new();
        let signs = Signs::new(&self.model);
        for (index, root) in self.model.expressions().into_iter().enumerate() {
            let earlier = faults.len();
            for e in root.nodes() {
                if let Some(divisor) = divisor(e) {
                    if !signs.of(divisor).never_zero() {
                        faults.push(self.division(e, divisor, signs.culprit(divisor)));
                    } else if let Some(zero) = self.zero_default(divisor) {
                        faults.push(zero);
                    }
                }
                faults.extend(self.outside_domain(e, &signs));
                let is_arc = |angle| {
                    matches!(
                        named(&self.model, angle).kind,
                        ExprKind::Call(Function::Atan, _)
                    )
                };
                if let ExprKind::Call(Function::Tan, angle) = &e.kind
                    && !is_arc(angle)
                {
                    let mut cosine = e.clone();
                    cosine.kind = ExprKind::Call(Function::Cos, angle.clone());
                    if !signs.of(&cosine).never_zero() {
                        let text = self.text(angle.span);
                        let message =
                            format!("`{}` is infinite where cos({text}) = 0", self.text(e.span));
                        let fault = Diagnostic::new(Kind::Singular, e.span, message);
                        let limit = format!("limit cos({text}) > 0.01 \"…\";");
                        faults.push(fault.help(format!("say where the model ends: `{limit}`")));
                    }
                }
            }
            let found: Vec<Diagnostic> = faults.drain(earlier..).collect();
            let found = found.into_iter();
            faults.extend(found.map(|fault| self.at_call(fault, index, root)));
        }
        self.diagnostics.extend(faults);
    }

    /// Error for a function whose argument is outside its domain for all values within the bounds.
    fn outside_domain(&self, e: &Expr, signs: &Signs<'_>) -> Option<Diagnostic> {
        let (argument, domain) = match &e.kind {
            ExprKind::Call(Function::Sqrt, a) => (a, (0.0, f64::INFINITY)),
            ExprKind::Call(Function::Log, a) | ExprKind::RealPower(a, _) => {
                (a, (f64::MIN_POSITIVE, f64::INFINITY))
            }
            ExprKind::Pow(a, doubled) if doubled % 2 != 0 => (a, (0.0, f64::INFINITY)),
            ExprKind::Call(Function::Asin | Function::Acos, a) => (a, (-1.0, 1.0)),
            _ => return None,
        };
        let (least, greatest) = signs.range(argument)?;
        if greatest >= domain.0 && least <= domain.1 {
            return None;
        }
        let (whole, what) = (self.text(e.span), self.text(argument.span));
        let message = format!("`{whole}` is not defined: `{what}` is outside its domain");
        let range = match domain {
            (-1.0, _) => "-1 .. 1",
            (0.0, _) => "numbers that are not negative",
            _ => "numbers above 0",
        };
        let fault = Diagnostic::new(Kind::Singular, e.span, message);
        Some(fault.note(format!("the domain is {range}")))
    }

    fn division(&self, e: &Expr, divisor: &Expr, culprit: &Expr) -> Diagnostic {
        let (whole, what) = (self.text(e.span), self.text(culprit.span));
        let message = format!("`{whole}` divides by `{what}`, which may be zero");
        let mut fault = Diagnostic::new(Kind::Singular, e.span, message)
            .label(divisor.span, "the divisor")
            .note(
                "a divisor is made of numbers, constants, sums that bounds keep away from 0, exp(…) and what a `limit` keeps away from 0",
            );
        if let ExprKind::AuxVariable(i) = culprit.kind {
            let place = self.model.aux_variables[i].span;
            fault = fault.label(place, format!("`{what}` is defined here"));
        }
        fault = match &e.kind {
            ExprKind::Div(a, _) if a.shape != Shape::Scalar => fault.help(format!(
                "where `v` is zero, `unit(v)` is the zero vector: write it for `v/norm(v)`; or say where the model ends: `limit {what} > 0 \"…\";`"
            )),
            ExprKind::Div(a, b) => fault.help(format!(
                "say what holds there: `ratio({}, {}, 0)`, or where the model ends: `limit {what} > 0 \"…\";`",
                self.text(a.span),
                self.text(b.span)
            )),
            _ => fault.help(format!("say where the model ends: `limit {what} > 0 \"…\";`")),
        };
        fault
    }

    /// Error for a divisor with a constant factor whose default is 0.
    fn zero_default(&self, divisor: &Expr) -> Option<Diagnostic> {
        let mut found = None;
        factors(divisor, &mut |factor| {
            let constant = match factor.kind {
                ExprKind::Param(i) => &self.model.params[i],
                ExprKind::Coefficient(i) => &self.model.coefficients[i],
                _ => return,
            };
            if constant.value == 0.0 {
                let message = format!("`{}` is 0 by default, but it is divided by", constant.name);
                found = Some(
                    Diagnostic::new(Kind::Singular, factor.span, message)
                        .label(constant.span, "declared as 0")
                        .label(factor.span, "divided by here")
                        .help("give it a default other than 0, or use `ratio(…)`"),
                );
            }
        });
        found
    }
}

/// Calls `visit` on each factor of a product, without signs and exponents.
fn factors<'e>(e: &'e Expr, visit: &mut dyn FnMut(&'e Expr)) {
    match &e.kind {
        ExprKind::Mul(a, b) => {
            factors(a, visit);
            factors(b, visit);
        }
        ExprKind::Neg(a) | ExprKind::Pow(a, _) => factors(a, visit),
        _ => visit(e),
    }
}

/// Returns the singular points of a model with their defined behaviour, in the order of their source spans.
pub fn singular_points(model: &Model) -> Vec<SingularPoint> {
    use ExprKind as K;
    let signs = Signs::new(model);
    let text = |e: &Expr| crate::syntax::token::clip(&model.text(e.span));
    let may_vanish = |e: &Expr| signs.of(e) != Sign::Positive;
    let of_root = |e: &Expr| format!("is 0 with derivative 0 where `{}` is 0 or less", text(e));
    let mut points: Vec<SingularPoint> = Vec::new();
    for root in model.expressions() {
        for e in root.nodes() {
            let what = match &e.kind {
                K::Norm(a) => format!("is 0 with derivative 0 where `{}` is zero", text(a)),
                K::Direction(a, Some(other)) => {
                    format!("is `{}` where `{}` is zero", text(other), text(a))
                }
                K::Direction(a, None) => format!("is the zero vector where `{}` is zero", text(a)),
                K::Atan2(y, x) => {
                    let (y, x) = (text(y), text(x));
                    format!("is 0 with derivative 0 where `{y}` and `{x}` are both 0")
                }
                K::Ratio(parts) => {
                    format!("is `{}` where `{}` is 0", text(&parts[2]), text(&parts[1]))
                }
                K::Call(Function::Sqrt | Function::Log, a) if may_vanish(a) => of_root(a),
                K::Pow(a, doubled) if doubled % 2 != 0 && may_vanish(a) => of_root(a),
                K::RealPower(a, _) if may_vanish(a) => of_root(a),
                K::Call(Function::Asin | Function::Acos, a) => {
                    let a = text(a);
                    format!("holds `{a}` within -1 .. 1, with derivative 0 beyond")
                }
                // The text of a constraint has no `abs`.
                K::Call(Function::Abs, a) if a.span == e.span => continue,
                K::Call(Function::Abs, a) => format!("has derivative 0 where `{}` is 0", text(a)),
                K::Call(Function::Sign | Function::Step, a) => {
                    format!("jumps, with derivative 0, where `{}` passes 0", text(a))
                }
                K::Call(Function::Table(index), _) | K::Lookup(index, ..)
                    if model.tables[*index].interpolation == Interpolation::Linear =>
                {
                    format!(
                        "has a kink at each knot of the table `{}`",
                        model.tables[*index].name
                    )
                }
                K::Min(a, b) | K::Max(a, b) => {
                    format!("has a kink where `{}` equals `{}`", text(a), text(b))
                }
                _ => continue,
            };
            points.push(SingularPoint {
                span: e.span,
                text: text(e),
                what,
            });
        }
    }
    points.sort_by_key(|p| p.span);
    points.dedup();
    points
}
