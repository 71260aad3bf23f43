//! Derivatives of the states of a declared body, for constraints on its motion.

use super::Checker;
use super::elaborate::node;
use crate::diagnostic::Span;
use crate::model::{Expr, ExprKind, FrameKind, Load, Shape};

impl Checker<'_> {
    /// Derivative of a state of the body by the time of the flight.
    pub fn body_rate(&self, state: usize, span: Span) -> Expr {
        let loads: &[Load] = match &self.model.body {
            Some(body) if body.velocity.contains(&state) => &self.model.forces,
            Some(_) if self.is_angular(state) => &self.model.moments,
            _ => &[],
        };
        let loads = loads.iter().map(|own| own.value.clone()).collect();
        let mut rate = node(ExprKind::BodyRate(state, loads), Shape::Scalar, span);
        let unit = self.model.states[state].unit;
        rate.unit = unit
            .checked_div(crate::unit::Unit::SECOND)
            .unwrap_or_default();
        rate
    }

    /// Whether a state of the body is a component of its angular velocity, or the rate of an angle.
    fn is_angular(&self, state: usize) -> bool {
        self.angular_states().contains(&state)
    }

    /// States of the angular velocity of the body: its components, or the rates of the angles.
    fn angular_states(&self) -> Vec<usize> {
        match self
            .model
            .rotation()
            .map(|own| (own.body_frame, own.angular_velocity))
        {
            None => Vec::new(),
            Some((_, Some((components, _)))) => components.to_vec(),
            Some((frame, None)) => self.rates_of_frame(frame),
        }
    }

    /// Rates of the angles that turn a frame against the inertial one.
    fn rates_of_frame(&self, frame: usize) -> Vec<usize> {
        let chain = self.chain(frame).into_iter();
        let rates = chain.filter_map(|frame| match self.model.frames[frame].kind {
            FrameKind::Turned { rate, .. } => rate,
            _ => None,
        });
        rates.collect()
    }

    /// States on which the position, velocity or angular velocity of the body depends.
    pub fn states_of_motion(&self, kind: &ExprKind) -> Vec<usize> {
        let Some(body) = &self.model.body else {
            return Vec::new();
        };
        match (kind, &body.rotation) {
            (ExprKind::Position, _) => body.position.to_vec(),
            (ExprKind::Velocity, _) => body.velocity.to_vec(),
            (_, Some(rotation)) => {
                let mut states = self.states_of_attitude(rotation.body_frame);
                states.extend(self.angular_states());
                states
            }
            _ => Vec::new(),
        }
    }

    /// States on which the derivative of a coordinate of the body depends.
    pub fn states_of_body_rate(&self, state: usize) -> Vec<usize> {
        let Some(body) = &self.model.body else {
            return Vec::new();
        };
        if body.position.contains(&state) {
            let mut states = body.velocity.to_vec();
            states.extend(self.states_of_attitude(body.velocity_frame));
            return states;
        }
        let of_frame = self.model.frames.iter().enumerate().find_map(|(i, frame)| {
            let is_own = match frame.kind {
                FrameKind::Turned { angle, .. } => angle == state,
                FrameKind::Quaternion { states, .. } => states.contains(&state),
                _ => false,
            };
            is_own.then_some(i)
        });
        let Some(frame) = of_frame else {
            return Vec::new();
        };
        let mut states = self.states_of_attitude(frame);
        states.extend(self.angular_states());
        states.extend(self.rates_of_frame(frame));
        states
    }
}
