//! Labels of states by symbols of Hubbard & Hummel (2000), and grouping of states into panels.

use super::panel::{Line, Panel};

/// Name and unit of a state or an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateLabel<'a> {
    /// Name in the model.
    pub name: &'a str,
    /// Unit, as in the model.
    pub unit: &'a str,
}

/// Quantity that a unit measures.
fn what(unit: &str) -> &'static str {
    match unit {
        "m" => "Position",
        "m/s" => "Velocity",
        "rad" => "Angle",
        "rad/s" => "Rate",
        _ => "State",
    }
}

/// Groups of at most four states for one panel, by index: with equal units and, unless the unit is m or m/s, peak
/// magnitudes of `rows[sample][state]` that differ at most by the factor `apart`.
fn groups(states: &[StateLabel<'_>], rows: &[Vec<f64>], apart: f64) -> Vec<Vec<usize>> {
    let reach = |i: usize| rows.iter().map(|row| row[i].abs()).fold(0.0, f64::max);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (i, state) in states.iter().enumerate() {
        let fits = |group: &Vec<usize>| {
            let alike = |j: &usize| {
                let (a, b) = (reach(i), reach(*j));
                let is_alike = a.max(b) <= apart * a.min(b) || a.max(b) < 1e-9;
                is_alike || matches!(state.unit, "m" | "m/s")
            };
            group.len() < 4 && states[group[0]].unit == state.unit && group.iter().all(alike)
        };
        match groups.iter_mut().find(|group| fits(group)) {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups
}

/// Panels of states over time, one for each of their [`groups`], from points (time, value) by state; or, without `apart`,
/// of inputs, those of one unit together, whatever their sizes.
pub(crate) fn panels_over_time(
    states: &[StateLabel<'_>],
    rows: &[Vec<f64>],
    apart: Option<f64>,
    points: &dyn Fn(usize) -> Vec<(f64, f64)>,
) -> Vec<Panel> {
    let panel = |group: Vec<usize>| {
        let lines = group.iter();
        let lines = lines.map(|&i| Line::new(symbol(states[i].name), points(i)));
        let lines: Vec<Line> = lines.collect();
        let names: Vec<&str> = lines.iter().map(|line| line.name.as_str()).collect();
        let unit = states[group[0]].unit;
        let suffix = match unit {
            "" | "1" => String::new(),
            unit => format!(", {unit}"),
        };
        let title = format!(
            "{} {}{suffix}",
            apart.map_or("Input", |_| what(unit)),
            names.join(", ")
        );
        Panel {
            lines,
            ..Panel::new(title, "time, s")
        }
    };
    let groups = groups(states, rows, apart.unwrap_or(f64::INFINITY));
    groups.into_iter().map(panel).collect()
}

/// Symbol of a state after Hubbard & Hummel (2000), as `α̇` for `alphadot`; any suffix `dot` becomes a dot above.
pub(crate) fn symbol(name: &str) -> String {
    let (base, dot) = match name.strip_suffix("dot") {
        Some(base) if !base.is_empty() => (base, "\u{307}"),
        _ => (name, ""),
    };
    let letter = match base {
        "alpha" => "α",
        "beta" => "β",
        "phi" => "φ",
        "theta" => "θ",
        "gamma" => "γ",
        "psi" => "ψ",
        "omega" => "ω",
        other => other,
    };
    format!("{letter}{dot}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn apart_sizes_get_their_own_panels() {
        let rows = vec![vec![1.0, 2.0, 100.0, 0.0], vec![0.5, 1.0, 50.0, 0.0]];
        let labels = ["a", "b", "c", "d"].map(|name| StateLabel { name, unit: "rad" });
        assert_eq!(groups(&labels, &rows, 8.0), [vec![0, 1], vec![2], vec![3]]);
    }

    #[test]
    fn names_are_the_paper_s() {
        assert_eq!(
            ["phi", "thetadot", "x", "dot", "q0"].map(symbol),
            ["φ", "θ\u{307}", "x", "dot", "q0"]
        );
    }
}
