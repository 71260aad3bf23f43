//! Three-dimensional view of flights: one self-contained HTML file that animates them.
//!
//! The page draws on a canvas with the script `viewer/viewer.js`, which is embedded; nothing is loaded from
//! elsewhere.

mod samples;

use codegen::latex;
use dataset::Role;
use flight::CompiledModel;
use flight::release::Release;
use identify::{Fit, FlightId};
use model_spec::model::{Expr, Model};
use ode::Trajectory;
use serde::Serialize;

use crate::figures::svg::escape;
use crate::thin::MAX_FIGURES;
use samples::{FlightModel, flown, recorded};

/// Maximum number of samples with which the 3D view shows a flight.
const MAX_SAMPLES: usize = 240;

/// Shape with which the 3D view draws a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Shape {
    /// A disc, for a rigid body with its third axis as axis of symmetry.
    Disc,
    /// Three lines from the origin of the body frame along its axes, for a rigid body whose third axis is not an axis
    /// of symmetry.
    Cross,
    /// A ball, for a body modelled as a point mass.
    Ball,
}

/// Content of a page that animates flights in 3D: the flights shown together, and the shape of their common body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct View {
    shape: Shape,
    /// Maximum distance of a marker from the origin of the body frame, m, which sets the size of the drawn body; `None`
    /// if unknown.
    radius: Option<f64>,
    flights: Vec<samples::Flight>,
}

impl View {
    /// 3D view of the flights of a fit, measured and predicted, in the order of the dataset. If there are more than
    /// `MAX_FIGURES` flights, evenly spaced ones are selected. `by` names the predicting model, to distinguish flights
    /// of two models, and may be empty.
    pub fn of_fit(fit: &Fit, by: &str) -> View {
        let problem = fit.problem();
        let used = (0..fit.report.flights.len()).filter(|&i| fit.report.flights[i].is_used());
        let used: Vec<usize> = used.collect();
        let step = used.len().div_ceil(MAX_FIGURES).max(1);
        let flights = used.iter().step_by(step).filter_map(|&i| {
            let id = FlightId::new(i);
            let evidence = fit.evidence(id)?;
            let (observations, _) = fit.flight(id)?;
            let parameters = observations.parameters(problem, fit.global());
            let flight_model = FlightModel::new(&problem.model, &problem.body, parameters);
            let role = match evidence.role {
                Role::Fit => "fitted",
                Role::HeldOut => "not fitted",
            };
            let mut flight = recorded(&flight_model, &evidence, MAX_SAMPLES);
            if by.is_empty() {
                flight.note = role.to_owned();
            } else {
                flight.name += &format!(" · {by}");
                flight.note = format!("{role}; predicted by the {by} model");
            }
            Some(flight)
        });
        let markers = problem.markers.iter().map(|m| m[0].hypot(m[1]).hypot(m[2]));
        View {
            shape: shape(&problem.model),
            radius: Some(markers.fold(0.0, f64::max)).filter(|r| *r > 0.0),
            flights: flights.collect(),
        }
    }

    /// 3D view of a single simulated flight.
    pub fn of_trajectory(
        name: &str,
        model: &Model,
        body: &CompiledModel,
        release: &Release,
        trajectory: &Trajectory,
    ) -> View {
        let flight_model = FlightModel::new(model, body, body.release_parameters(release));
        View {
            shape: shape(model),
            radius: None,
            flights: vec![flown(&flight_model, name, trajectory, MAX_SAMPLES)],
        }
    }

    /// Adds to this 3D view the flights of another view of the same body.
    pub fn join(mut self, other: View) -> View {
        self.flights.extend(other.flights);
        self
    }

    /// Renders the 3D view as an HTML page; `None` if there is no flight to show.
    pub fn html(&self, title: &str) -> Option<String> {
        if self.flights.is_empty() {
            return None;
        }
        // In a script, `<` could end the element.
        let data = serde_json::to_string(self).ok()?.replace('<', "\\u003c");
        let page = include_str!("../viewer/viewer.html")
            .replace("STYLE_SHEET", include_str!("../viewer/viewer.css"))
            .replace("SCRIPT_TEXT", include_str!("../viewer/viewer.js"))
            .replace("PAGE_TITLE", &escape(title));
        let (before, after) = page.split_once("FLIGHT_DATA")?;
        Some([before, &data, after].concat())
    }
}

/// Shape with which the body of a model is drawn: a ball for a point mass (no moments of inertia), a disc for a rigid
/// body whose first two moments of inertia are the same expression, three lines along the axes for any other.
fn shape(model: &Model) -> Shape {
    let inertia: Option<&[[Expr; 3]; 3]> = match (&model.body, &model.claim) {
        (Some(body), _) => body.rotation.as_ref().map(|r| &r.inertia),
        (None, Some(claim)) => claim.rotation.as_ref().map(|r| &r.inertia),
        (None, None) => None,
    };
    let text = |expr| latex::expression(model, expr);
    match inertia {
        None => Shape::Ball,
        Some(inertia) if text(&inertia[0][0]) == text(&inertia[1][1]) => Shape::Disc,
        Some(_) => Shape::Cross,
    }
}
