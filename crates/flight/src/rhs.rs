//! Right-hand side of a bound model for the solver of the crate `ode`.

use crate::{BoundModel, ModelState, Workspace};
use lanes::{Enclosure, Switch};
use ode::{DifferentiableRhs, OdeRhs, Projection, RhsProperties};
use std::borrow::Cow;
use std::sync::Arc;

/// Right-hand side dx/dt = f(t, x) of a bound model, with Jacobians by the states and all parameters if asked for.
pub struct ModelRhs<'a> {
    model: &'a BoundModel<'a>,
    workspace: Workspace,
    /// Parameters at the time of an evaluation.
    parameters: Vec<f64>,
    /// Registers of the bounds of switches.
    bounds: Vec<Enclosure>,
}

impl BoundModel<'_> {
    /// Creates the right-hand side dx/dt = f(t, x), for the functions of [`ode`] and for [`ode::Sensitivities`].
    pub fn rhs(&self) -> ModelRhs<'_> {
        ModelRhs {
            model: self,
            workspace: Workspace::default(),
            parameters: Vec::new(),
            bounds: Vec::new(),
        }
    }
}

impl OdeRhs for ModelRhs<'_> {
    type State = ModelState;

    fn derivative(&mut self, t: f64, x: &ModelState, dx: &mut ModelState) {
        let functions = self.model.functions();
        let at = self.model.at(t, x, &mut self.parameters);
        functions.f(at, &mut self.workspace, dx);
    }
}

impl DifferentiableRhs for ModelRhs<'_> {
    fn states(&self) -> usize {
        self.model.model.layout.states.len()
    }

    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.model.model.patterns.jacobian
    }

    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.model.model.patterns.parameter_jacobian
    }

    fn derivative_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        jacobian: &mut [f64],
        parameter_jacobian: &mut [f64],
    ) {
        let at = self.model.at(t, x, &mut self.parameters);
        let workspace = &mut self.workspace;
        self.model
            .functions()
            .f_jac_par(at, workspace, dx, jacobian, parameter_jacobian);
    }
}

impl RhsProperties for ModelRhs<'_> {
    fn projection(&self) -> Option<Projection> {
        let constraints = self.model.constraints.clone()?;
        Some(constraints)
    }

    fn time_breaks(&self) -> &[f64] {
        &self.model.time_breaks
    }

    fn switches(&self) -> Option<Arc<[Switch]>> {
        let switches = self.model.model.switches.as_ref();
        switches.map(|own| own.switches.clone())
    }

    fn switch_arguments(&mut self, t: f64, x: &[f64], to: &mut [f64]) {
        if let Some(own) = &self.model.model.switches {
            let at = self.model.at(t, x, &mut self.parameters);
            own.arguments.eval(at, &[], &mut self.workspace, &mut [to]);
        }
    }

    fn switch_bounds(&mut self, t: Enclosure, x: &[Enclosure], to: &mut [Enclosure]) -> bool {
        // What inputs over time do between two times has no bounds here.
        let switches = self.model.model.switches.as_ref();
        let Some(own) = switches.filter(|_| self.model.inputs.is_empty()) else {
            return false;
        };
        own.bounds(t, x, &self.model.parameters, &mut self.bounds, to);
        true
    }

    fn state_name(&self, state: usize) -> Cow<'_, str> {
        self.model.model.state_name(state)
    }
}
