//! Figure of a flight like Figures 5 and 6 of Hubbard & Hummel (2000): path, and states over time.

use super::figure::figure;
use super::panel::{Mark, Panel};
use super::states::{StateLabel, panels_over_time};
use flight::InputSeries;
use ode::Trajectory;

const SAMPLES: usize = 400;
/// Maximum ratio of the peak magnitudes of two states in one panel.
const APART: f64 = 8.0;

/// Draws a flight as SVG: side and top view if the states include `x`, `y` and `z`, varying inputs, and all states.
///
/// # Panics
/// If the number of labels differs from the number of states.
pub fn flight(
    title: &str,
    flight: &Trajectory,
    states: &[StateLabel<'_>],
    inputs: &[(StateLabel<'_>, InputSeries)],
) -> String {
    assert_eq!(states.len(), flight.states(), "a label for each state");
    let (rows, times) = sampled(flight);
    let place = |name: &str| states.iter().position(|s| s.name == name);
    let mut panels = Vec::new();
    if let (Some(x), Some(y), Some(z)) = (place("x"), place("y"), place("z")) {
        for (title, up) in [
            ("Seen from the side: z, m", z),
            ("Top view: y, m (left is up)", y),
        ] {
            let points = rows.iter().map(|row| (row[x], row[up]));
            let starts = std::iter::once(("release", &rows[0]));
            let events = flight.events.iter().map(|e| (&*e.event, &e.state));
            let marks = starts
                .chain(events)
                .map(|(name, state)| Mark::new(name, (state[x], state[up])));
            panels.push(Panel {
                marks: marks.collect(),
                map: true,
                ..Panel::new(title, "x, m").line("", points)
            });
        }
    }
    let events = flight.events.iter();
    let marks: Vec<Mark> = events.map(|e| Mark::vertical(&e.event, e.time)).collect();
    let points = |i: usize| {
        let samples = times.iter().zip(&rows);
        samples.map(|(t, row)| (*t, row[i])).collect()
    };
    let labels: Vec<StateLabel<'_>> = inputs.iter().map(|(label, _)| *label).collect();
    let given = |t: &f64| inputs.iter().map(|(_, series)| series.at(*t)).collect();
    let given: Vec<Vec<f64>> = times.iter().map(given).collect();
    let of_input = |i: usize| {
        let samples = times.iter().zip(&given);
        samples.map(|(t, row)| (*t, row[i])).collect()
    };
    let over_time = panels_over_time(&labels, &given, None, &of_input).into_iter();
    let over_time = over_time.chain(panels_over_time(states, &rows, Some(APART), &points));
    panels.extend(over_time.map(|panel| Panel {
        marks: marks.clone(),
        ..panel
    }));
    figure(title, &panels)
}

fn sampled(flight: &Trajectory) -> (Vec<Vec<f64>>, Vec<f64>) {
    let rate = SAMPLES as f64 / (flight.end - flight.start);
    let (times, rows) = flight.at_rate(rate).unzip();
    (rows, times)
}

#[cfg(test)]
mod tests {
    use super::*;
    use flight::InputInterpolation;
    use ode::{Event, IntegrationOptions, integrate_to_event, rhs_from_fn};

    fn stone(names: &[StateLabel<'_>]) -> String {
        let mut d = rhs_from_fn(&[], |_, x: &[f64; 4], dx: &mut [f64; 4]| {
            *dx = [x[3], 0.0, x[2] * 0.0 - 1.0, 0.0];
        });
        let ground = Event::falls_to("ground <1>", 2, 0.0).terminal();
        let flown = integrate_to_event(
            &mut d,
            (0.0, &[0.0, 0.5, 2.0, 3.0]),
            9.0,
            &IntegrationOptions::default(),
            &mut [ground],
        );
        let push = InputSeries::new(&[(0.0, 0.0), (9.0, 1.0)], InputInterpolation::Linear);
        let label = StateLabel {
            name: "push",
            unit: "N",
        };
        flight("A stone & more", &flown.unwrap(), names, &[(label, push)])
    }

    #[test]
    fn a_flight_shows_its_path_and_every_state_with_units() {
        let [x, y, z] = ["x", "y", "z"].map(|name| StateLabel { name, unit: "m" });
        let svg = stone(&[
            x,
            y,
            z,
            StateLabel {
                name: "thetadot",
                unit: "rad/s",
            },
        ]);
        for text in [
            "A stone &amp; more",
            "ground &lt;1&gt;",
            "from the side: z, m",
            "Top view",
            "Position x, y, z, m",
            "Input push, N",
            "θ\u{307}, rad/s",
            "time, s",
        ] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        assert_eq!(svg.matches("<path").count(), 2 + 1 + 4);
    }

    #[test]
    fn without_a_place_there_is_no_map() {
        let svg = stone(&["a", "b", "c", "d"].map(|name| StateLabel { name, unit: "1" }));
        assert!(!svg.contains("Seen from"));
    }
}
