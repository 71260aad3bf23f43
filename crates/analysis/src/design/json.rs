//! Output of a design as JSON and as a release file.

use std::fmt::Write;

use flight::release::Release;
use flight::throw::FIELDS;
use nalgebra::{Matrix2, Vector2, Vector3};
use serde_json::{Map, Value, json};

use crate::design::search::{Design, numbers};
use crate::design::sensitivity::Sensitivity;
use crate::design::spread::{Landings, Spread};

impl Design {
    /// Name of the goal in files and options, such as `hit`.
    pub fn goal_name(&self) -> &'static str {
        self.goal.name()
    }

    /// Target point of the goal, m; `None` for a goal without a point.
    pub fn target(&self) -> Option<Vector3<f64>> {
        self.goal.target()
    }

    /// Name and unit of the value by which the goal is judged, such as `range` and `m`.
    pub fn figure_name(&self) -> (&'static str, &'static str) {
        self.goal.figure()
    }

    /// The design as JSON of the schema `hyzer.design/1`.
    pub fn json(&self, model: &str, spread: Option<&Spread>) -> Value {
        let throw: Map<String, Value> = numbers(&self.throw)
            .map(|(name, _, value)| (name.into(), json!(value)))
            .collect();
        let sensitivity: Map<String, Value> = self.sensitivity.iter().map(of_number).collect();
        let (figure, unit) = self.figure_name();
        json!({
            "schema": "hyzer.design/1",
            "model": model,
            "goal": self.goal_name(),
            "target": self.target().map(|target| [target.x, target.y, target.z]),
            "feasible": self.feasible,
            "throw": throw,
            "miss_m": self.miss,
            "vertical_speed_m_s": self.vertical_speed,
            "clearance_m": self.clearance,
            "side": self.side.map(super::goal::Side::name),
            "landing": [self.landing.x, self.landing.y, self.landing.z + 0.0],
            "seconds": self.time,
            "figure": { "what": figure, "value": self.figure, "unit": unit },
            "sensitivity": sensitivity,
            "spread": spread.map(of_spread),
            "starts_flown": self.flown,
        })
    }

    /// Release file of the design's throw, with the constants and winds of `release`, for the model `model`.
    pub fn release_toml(&self, model: &str, release: &Release) -> String {
        let mut text = format!(
            "model = {}\nuntil = \"ground\"\n\n[throw]\n",
            toml::Value::from(model)
        );
        for (name, unit, value) in numbers(&self.throw) {
            let _ = writeln!(text, "{name} = {value:?}  # {unit}");
        }
        for (key, values) in [
            ("parameters", &release.parameters),
            ("coefficients", &release.coefficients),
        ] {
            if !values.is_empty() {
                let _ = writeln!(text, "\n[{key}]");
            }
            for (name, value) in values {
                let _ = writeln!(text, "{name} = {value:?}");
            }
        }
        match &release.wind_field {
            Some(field) => {
                let _ = write!(text, "\n{}", field.to_toml(release.wind));
            }
            None if release.wind != [0.0; 3] => {
                let _ = writeln!(text, "\n[wind]\nconstant = {:?}", release.wind);
            }
            None => {}
        }
        if !release.known.is_empty() {
            text.push_str("\n[known]\n");
        }
        for (name, value) in &release.known {
            let _ = writeln!(text, "{name} = {value:?}");
        }
        text
    }
}

fn of_number(sensitivity: &Sensitivity) -> (String, Value) {
    let (name, unit, ..) = FIELDS[sensitivity.field];
    let [less, more] = sensitivity.one_unit.map(|one| {
        one.map(|one| {
            let moved = [one.landing.x, one.landing.y];
            json!({ "landing_m": moved, "seconds": one.time, "miss_m": one.miss })
        })
    });
    let value = json!({
        "unit": unit,
        "landing_m_per_unit": [sensitivity.landing.x, sensitivity.landing.y],
        "seconds_per_unit": sensitivity.time,
        "figure_per_unit": sensitivity.figure,
        "one_unit_less": less,
        "one_unit_more": more,
    });
    (name.to_owned(), value)
}

fn of_spread(spread: &Spread) -> Value {
    let vector = |v: &Vector2<f64>| [v.x, v.y];
    let matrix = |m: &Matrix2<f64>| [[m[(0, 0)], m[(0, 1)]], [m[(1, 0)], m[(1, 1)]]];
    let landings = |of: &Landings| {
        let (long, short, direction) = of.ellipse(0.5);
        json!({
            "mean_m": vector(&of.mean),
            "covariance_m2": matrix(&of.covariance),
            "ellipse_50_m": [long, short],
            "ellipse_direction_deg": direction.to_degrees(),
        })
    };
    json!({
        "linear": landings(&spread.linear),
        "sampled": spread.sampled.as_ref().map(|sampled| {
            let mut value = landings(&sampled.landings);
            value["flights"] = json!(sampled.points.len());
            value["failed"] = json!(sampled.failed);
            value
        }),
        "inside_circle": spread.inside,
        "near_target": spread.near_target,
        "touching_obstacle": spread.touching,
        "agreement": spread.agreement.map(|agreement| json!({
            "agrees": agreement.agrees,
            "shift_sd": agreement.shift,
            "sd_ratio_least": agreement.ratios.0,
            "sd_ratio_greatest": agreement.ratios.1,
        })),
    })
}
