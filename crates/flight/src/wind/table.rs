//! A table of wind in height as nodes: monotone cubics between the heights, constant beyond the ends.

use model_spec::syntax::ast::{BinaryOp, EffectPart, Expr};

use super::nodes::{add_let, binary, call, inertial_vector, name, number, sum};

/// Statements that define `wind_height` and `wind_of_profile` by a table of heights (increasing) and velocities.
///
/// Each interval adds a cubic of its own part t of the interval, held within 0 to 1, so that below it the interval adds nothing and
/// above it the difference of its ends. Slopes are 0 at the ends of the table and where the wind turns round; elsewhere they are
/// the weighted harmonic means of Fritsch and Butland (1984), which keep each component monotone between the heights.
pub(super) fn statements(rows: &[[f64; 4]]) -> Vec<EffectPart> {
    let mut parts = vec![add_let("wind_height", height())];
    let heights: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    for (k, ends) in heights.windows(2).enumerate() {
        let above = binary(BinaryOp::Sub, name("wind_height"), metres(ends[0]));
        let part = binary(BinaryOp::Div, above, metres(ends[1] - ends[0]));
        let held = call(
            "max",
            vec![call("min", vec![part, number(1.0, &[])]), number(0.0, &[])],
        );
        parts.push(add_let(&interval(k), held));
    }
    let components = [1, 2, 3].map(|axis| {
        let values: Vec<f64> = rows.iter().map(|row| row[axis]).collect();
        component(&heights, &values)
    });
    parts.push(add_let("wind_of_profile", inertial_vector(components)));
    parts
}

/// Third component of the position.
fn height() -> Expr {
    Expr {
        kind: model_spec::syntax::ast::ExprKind::Part(Box::new(name("position")), 3),
        span: model_spec::diagnostic::Span::default(),
    }
}

fn metres(value: f64) -> Expr {
    number(value, &[("m", 1)])
}

fn interval(k: usize) -> String {
    format!("wind_interval_{}", k + 1)
}

/// A component of the wind as a sum over the intervals, m/s.
fn component(heights: &[f64], values: &[f64]) -> Expr {
    let slopes = slopes(heights, values);
    let first = number(values[0], &[]);
    let intervals = (0..values.len() - 1).filter_map(|k| {
        let (width, rise) = (heights[k + 1] - heights[k], values[k + 1] - values[k]);
        if rise == 0.0 {
            return None;
        }
        // rise (3t² − 2t³) + h (m₀ (t³ − 2t² + t) + m₁ (t³ − t²)), by powers of t.
        let (start, end) = (width * slopes[k], width * slopes[k + 1]);
        let by_power = [
            start,
            3.0 * rise - 2.0 * start - end,
            start + end - 2.0 * rise,
        ];
        let t = || name(&interval(k));
        let horner = by_power.iter().rev().fold(None, |inner: Option<Expr>, c| {
            let c = number(*c, &[]);
            Some(match inner {
                None => c,
                Some(inner) => binary(BinaryOp::Add, c, binary(BinaryOp::Mul, t(), inner)),
            })
        })?;
        Some(binary(BinaryOp::Mul, t(), horner))
    });
    let all = sum(std::iter::once(first).chain(intervals));
    let all = all.unwrap_or_else(|| number(0.0, &[]));
    binary(BinaryOp::Mul, all, number(1.0, &[("m", 1), ("s", -1)]))
}

/// Slopes at the heights.
fn slopes(heights: &[f64], values: &[f64]) -> Vec<f64> {
    let mut slopes = vec![0.0; values.len()];
    for k in 1..values.len().saturating_sub(1) {
        let (before, after) = (heights[k] - heights[k - 1], heights[k + 1] - heights[k]);
        let down = (values[k] - values[k - 1]) / before;
        let up = (values[k + 1] - values[k]) / after;
        if down * up > 0.0 {
            let (a, b) = (2.0 * after + before, after + 2.0 * before);
            slopes[k] = (a + b) / (a / down + b / up);
        }
    }
    slopes
}
