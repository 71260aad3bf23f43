//! Labels of states by symbols of Hubbard & Hummel (2000), and grouping of states into panels.

use super::panel::{Line, Panel};

/// Name and unit of a state, from which its label in a figure is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateLabel<'a> {
    /// Name of the state in the model.
    pub name: &'a str,
    /// Unit of the state, as written in the model.
    pub unit: &'a str,
}

/// Name of the physical quantity that a unit measures, such as `Angle` for rad; `State` for any unit other than m, m/s,
/// rad and rad/s.
fn what(unit: &str) -> &'static str {
    match unit {
        "m" => "Position",
        "m/s" => "Velocity",
        "rad" => "Angle",
        "rad/s" => "Rate",
        _ => "State",
    }
}

/// Divides states into groups, each to be drawn in one panel; returns the indices of the states of each group. The
/// states of a group have equal units and, unless the unit is m or m/s, peak magnitudes that differ at most by the
/// factor `apart`. A group has at most four states. `rows[sample][state]` are the values of the states.
fn groups(states: &[StateLabel<'_>], rows: &[Vec<f64>], apart: f64) -> Vec<Vec<usize>> {
    let reach = |i: usize| rows.iter().map(|row| row[i].abs()).fold(0.0, f64::max);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (i, state) in states.iter().enumerate() {
        let fits = |group: &Vec<usize>| {
            let alike = |j: &usize| {
                let (a, b) = (reach(i), reach(*j));
                a.max(b) <= apart * a.min(b)
                    || a.max(b) < 1e-9
                    || state.unit == "m"
                    || state.unit == "m/s"
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

/// Panels of the states over time, one for each group of at most four states with equal units and, unless the unit is m
/// or m/s, peak magnitudes that differ at most by the factor `apart`. `rows[sample][state]` are the values from which
/// the peak magnitudes are computed. `points` returns the pairs of time (s) and value of the state with the given
/// index.
pub(crate) fn panels_of_states(
    states: &[StateLabel<'_>],
    rows: &[Vec<f64>],
    apart: f64,
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
        let title = format!("{} {}{suffix}", what(unit), names.join(", "));
        Panel {
            lines,
            ..Panel::new(title, "time, s")
        }
    };
    let groups = groups(states, rows, apart);
    groups.into_iter().map(panel).collect()
}

/// Symbol of a state in the notation of Hubbard & Hummel (2000), such as `α̇` for `alphadot`. A name without a symbol
/// is returned unchanged, except that the suffix `dot` becomes a dot above its last letter.
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
