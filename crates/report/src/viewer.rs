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

const MAX_SAMPLES: usize = 240;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Shape {
    /// For a rigid body with its third axis as axis of symmetry.
    Disc,
    /// Lines along the three axes, for any other rigid body.
    Cross,
    /// For a point mass.
    Ball,
}

/// Flights of one body that a page animates together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct View {
    shape: Shape,
    /// Largest distance of a marker from the origin of the body frame, m, which sets the size of the body.
    radius: Option<f64>,
    flights: Vec<samples::Flight>,
}

impl View {
    /// Flights of a fit, measured and predicted, at most `MAX_FIGURES`; `by` names the predicting model, or is empty.
    pub fn of_fit(fit: &Fit, by: &str) -> View {
        let problem = fit.problem();
        let used = (0..fit.report.flights.len()).filter(|&i| fit.report.flights[i].is_used());
        let used: Vec<usize> = used.collect();
        let step = used.len().div_ceil(MAX_FIGURES).max(1);
        let flights = used.iter().step_by(step).filter_map(|&i| {
            let id = FlightId::new(i);
            let evidence = fit.evidence(id)?;
            let (observations, _) = fit.flight(id)?;
            let flight_model = FlightModel {
                model: &problem.model,
                body: &problem.body,
                parameters: observations.parameters(problem, fit.global()),
            };
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
        let markers = problem.points.markers.iter();
        let markers = markers.map(|m| m[0].hypot(m[1]).hypot(m[2]));
        View {
            shape: shape(&problem.model),
            radius: Some(markers.fold(0.0, f64::max)).filter(|r| *r > 0.0),
            flights: flights.collect(),
        }
    }

    /// A simulated flight.
    pub fn of_trajectory(
        name: &str,
        model: &Model,
        body: &CompiledModel,
        release: &Release,
        trajectory: &Trajectory,
    ) -> View {
        let flight_model = FlightModel {
            model,
            body,
            parameters: body.release_parameters(release),
        };
        View {
            shape: shape(model),
            radius: None,
            flights: vec![flown(&flight_model, name, trajectory, MAX_SAMPLES)],
        }
    }

    /// Adds the flights of another view of the same body.
    pub fn join(mut self, other: View) -> View {
        self.flights.extend(other.flights);
        self
    }

    /// The view as a page; `None` if there is no flight.
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

/// A ball without moments of inertia, a disc if the first two are the same expression.
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
