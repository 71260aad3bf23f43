//! Description of an estimated template in sentences: uncertainty and assumptions.

use super::{CentreHeight, EstimatedTemplate, count};

fn mm(metres: f64) -> String {
    format!("{:.1} mm", 1e3 * metres)
}

impl EstimatedTemplate {
    /// Sentences that state how the marker positions were found and how uncertain they are.
    pub fn decisions(&self) -> Vec<String> {
        let mut lines = vec![format!(
            "the template is estimated from {} with {} samples and {:.0} turns of the body; noise of a coordinate {:.2} mm",
            count(self.flights, "flight"),
            self.samples,
            self.turns,
            1e3 * self.sigma
        )];
        if self.outliers > 0 {
            lines.push(format!(
                "{} left out of the estimate as outliers",
                count(self.outliers, "position")
            ));
        }
        for marker in &self.markers {
            let [x, y, z] = marker.position.map(|x| format!("{:.2}", 1e3 * x));
            let [sx, sy, sz] = marker.std_error.map(|x| format!("{:.2}", 1e3 * x));
            lines.push(format!(
                "{}: {x}, {y}, {z} mm, standard errors {sx}, {sy}, {sz} mm",
                marker.label
            ));
        }
        lines.push(format!(
            "third axis: the axis of the spin, standard error {:.2}°; {}",
            self.tilt_error.to_degrees(),
            match &self.up {
                Some(up) if up.against == 0 => "it points up at the release".to_owned(),
                Some(up) => format!(
                    "it points up at the release of {} and down at that of {}: check its sense",
                    count(up.for_it, "flight"),
                    up.against
                ),
                None =>
                    "the flights do not decide which side is up: its sense is arbitrary".to_owned(),
            }
        ));
        let first = self
            .markers
            .get(self.first)
            .map_or("", |m| m.label.as_str());
        lines.push(format!("first axis: towards {first}, by choice"));
        lines.push(match self.height {
            CentreHeight::Estimated { height, std_error } => format!(
                "centre of mass: {} above the mean of the markers along the third axis, standard error {}, from the wobble of the body",
                mm(height),
                mm(std_error)
            ),
            CentreHeight::Stated { height, shown } => {
                let shown = match shown {
                    Some((height, std_error)) => {
                        format!("the flights show {} with standard error {}", mm(height), mm(std_error))
                    }
                    None => "the flights do not determine it".to_owned(),
                };
                format!(
                    "centre of mass: {} above the mean of the markers along the third axis, by --centre-height; {shown}",
                    mm(height)
                )
            }
            CentreHeight::Assumed { std_error } => {
                let why = match std_error {
                    Some(std_error) => format!("an estimate would have a standard error of {}", mm(std_error)),
                    None => "the body does not wobble enough".to_owned(),
                };
                format!(
                    "centre of mass: assumed at the mean height of the markers along the third axis, since {why}; state it by --centre-height METRES where it is known"
                )
            }
        });
        lines
    }
}
