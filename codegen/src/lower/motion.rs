//! Equations of motion of a rigid body by Newton's and Euler's laws, and derivatives stated in the model.

use super::frames::{self, Vector};
use super::{Lowering, solve};
use crate::differentiate::partials;
use crate::graph::{NodeId, Symbol};
use crate::number::Number;
use model_spec::model::{Body, FrameKind, Load, Rotation, Shape};

impl Lowering<'_> {
    pub(crate) fn motion(&mut self) -> Vec<NodeId> {
        let model = self.model;
        let zero = self.graph.whole(0);
        let mut dx = vec![zero; model.states.len()];
        for equation in &model.equations {
            let value = self.scalar(&equation.value);
            dx[equation.state] = self.graph.project(value);
        }
        if let Some(body) = &model.body {
            self.travel(body, &mut dx);
            self.newton(body, &mut dx);
            if let Some(rotation) = &body.rotation {
                self.angles(rotation, &mut dx);
                self.euler(rotation, &mut dx);
            }
        }
        if let Some(clock) = &model.clock {
            let pace = self.scalar(&clock.value);
            self.record(pace, "clock", clock.span);
            for node in &mut dx {
                *node = self.graph.times(*node, pace);
            }
        }
        for (k, &node) in dx.iter().enumerate() {
            let state = &model.states[k];
            let equation = model.equations.iter().find(|e| e.state == k);
            let span = equation.map_or(state.span, |e| e.span);
            self.record(node, &format!("{}_dot", state.name), span);
        }
        dx
    }

    /// Derivative of a state of the body by the time of the flight; a coordinate depends on no load.
    pub(crate) fn body_rate(&mut self, state: usize, is_coordinate: bool) -> NodeId {
        let model = self.model;
        let zero = self.graph.whole(0);
        let mut dx = vec![zero; model.states.len()];
        let Some(body) = &model.body else { return zero };
        if is_coordinate {
            self.travel(body, &mut dx);
            if let Some(rotation) = &body.rotation {
                self.angles(rotation, &mut dx);
            }
        } else if body.velocity.contains(&state) {
            self.newton(body, &mut dx);
        } else if let Some(rotation) = &body.rotation {
            self.euler(rotation, &mut dx);
        }
        dx[state]
    }

    fn velocity(&mut self, body: &Body) -> Vector {
        body.velocity
            .map(|state| self.graph.symbol(Symbol::State(state as u32)))
    }

    /// Lowers `der(x) = v` in the inertial frame.
    fn travel(&mut self, body: &Body, dx: &mut [NodeId]) {
        let velocity = self.velocity(body);
        let travel = self.reexpress(velocity, body.velocity_frame, 0);
        for k in 0..3 {
            dx[body.position[k]] = travel[k];
        }
    }

    /// Lowers `m (der(v) + ω × v) = Σ F` in the rotating `Body::velocity_frame`.
    fn newton(&mut self, body: &Body, dx: &mut [NodeId]) {
        let (model, velocity) = (self.model, self.velocity(body));
        let mass = self.scalar(&body.mass);
        self.graph.assume_nonzero(mass);
        let lightness = self.graph.power(mass, -2);
        let frame = body.velocity_frame;
        let spin = self.angular_velocity(frame, frame);
        let carried = frames::cross(&mut self.graph, spin, velocity);
        let force = self.loads(model.forces.iter(), "force", frame);
        for k in 0..3 {
            let pushed = self.graph.distribute(force[k], lightness);
            dx[body.velocity[k]] = self.graph.sub(pushed, carried[k]);
        }
    }

    /// Specific force, m/s², in `Body::velocity_frame`; zero without a body.
    pub(crate) fn specific_force(&mut self) -> Vector {
        let model = self.model;
        let Some(body) = &model.body else {
            return frames::zero(&mut self.graph);
        };
        let felt = model.forces.iter().filter(|load| !load.is_weight());
        let force = self.loads(felt, "force", body.velocity_frame);
        let mass = self.scalar(&body.mass);
        let lightness = self.graph.power(mass, -2);
        force.map(|component| self.graph.distribute(component, lightness))
    }

    /// Inertial derivative of the angular velocity, rad/s², in `Rotation::angular_velocity_frame`.
    pub(crate) fn angular_acceleration(&mut self) -> Vector {
        let Some((rates, turning)) = self.component_rates else {
            return frames::zero(&mut self.graph);
        };
        let spin = self.spin();
        let transport = frames::cross(&mut self.graph, turning, spin);
        frames::add(&mut self.graph, rates, transport)
    }

    fn loads<'m>(
        &mut self,
        loads: impl Iterator<Item = &'m Load>,
        kind: &str,
        frame: usize,
    ) -> Vector {
        let mut total = frames::zero(&mut self.graph);
        for load in loads {
            let vector = self.vector(&load.value);
            let from = match load.value.shape {
                Shape::Vector(from) => from,
                Shape::Scalar => frame,
            };
            let vector = self.reexpress(vector, from, frame);
            for (k, &component) in vector.iter().enumerate() {
                let name = format!("{kind}_{}_{}", load.name, k + 1);
                self.record(component, &name, load.span);
            }
            total = frames::add(&mut self.graph, total, vector);
        }
        total.map(|component| self.graph.project(component))
    }

    /// Lowers the derivatives of the angles or the quaternion of the body; those of other frames are stated.
    fn angles(&mut self, rotation: &Rotation, dx: &mut [NodeId]) {
        let model = self.model;
        for k in frames::path(model, rotation.body_frame) {
            match model.frames[k].kind {
                FrameKind::Inertial | FrameKind::Fixed { .. } => {}
                FrameKind::Turned { angle, rate, .. } => {
                    if let Some(rate) = rate {
                        dx[angle] = self.graph.symbol(Symbol::State(rate as u32));
                    }
                }
                FrameKind::Quaternion { states, .. } => {
                    // der(q) = ½ q ⊗ ω, with ω in the rotated frame
                    let w = self.angular_velocity(k, k);
                    let q = states.map(|state| self.graph.symbol(Symbol::State(state as u32)));
                    let rows = [
                        [(1, 0, -1), (2, 1, -1), (3, 2, -1)],
                        [(0, 0, 1), (2, 2, 1), (3, 1, -1)],
                        [(0, 1, 1), (3, 0, 1), (1, 2, -1)],
                        [(0, 2, 1), (1, 1, 1), (2, 0, -1)],
                    ];
                    for (row, state) in rows.iter().zip(states) {
                        let terms = row
                            .iter()
                            .map(|&(i, j, sign)| {
                                (Number::fraction(sign, 2), self.graph.mul(q[i], w[j]))
                            })
                            .collect();
                        dx[state] = self.graph.sum(terms, Number::ZERO);
                    }
                }
            }
        }
    }

    /// Lowers the rotational equations: `I der(ω) + ω_F × I ω = Σ M`. All components are in the frame F,
    /// `Rotation::angular_velocity_frame`, and ω_F is the angular velocity of F. If the inertia tensor is not constant
    /// in F, the term `(dI/dt) ω` is subtracted from Σ M, with the time derivative of I as seen in F. Writes the
    /// derivatives of the angular velocity or of the angle rates to `dx`.
    fn euler(&mut self, rotation: &Rotation, dx: &mut [NodeId]) {
        let model = self.model;
        let frame = rotation.angular_velocity_frame;
        let given = [0, 1, 2].map(|i| [0, 1, 2].map(|j| self.scalar(&rotation.inertia[i][j])));
        let turned =
            (rotation.inertia_frame != frame).then(|| self.turned_inertia(rotation, given));
        let inertia = turned.map_or(given, |turned| turned.whole);
        let inverse = solve::inverse(&mut self.graph, inertia);
        let spin = self.spin();
        let momentum = inertia.map(|row| frames::dot(&mut self.graph, row, spin));
        let turning = self.angular_velocity(frame, frame);
        let carried = frames::cross(&mut self.graph, turning, momentum);
        let moment = self.loads(model.moments.iter(), "moment", frame);
        let mut left = frames::sub(&mut self.graph, moment, carried);
        if let Some(turned) = &turned {
            let drift = self.drift(turned, spin);
            left = frames::sub(&mut self.graph, left, drift);
        }
        let acceleration = inverse.map(|row| {
            let terms = (0..3)
                .map(|k| (Number::ONE, self.graph.distribute(left[k], row[k])))
                .collect();
            self.graph.sum(terms, Number::ZERO)
        });
        self.component_rates = Some((acceleration, turning));
        match rotation.angular_velocity {
            Some((states, within)) if within == frame => {
                for k in 0..3 {
                    dx[states[k]] = acceleration[k];
                }
            }
            Some((states, within)) => {
                // derivative in another frame: der_within(ω) = der_F(ω) + (ω_F - ω_within) × ω
                let other = self.angular_velocity(within, frame);
                let relative = frames::sub(&mut self.graph, turning, other);
                let extra = frames::cross(&mut self.graph, relative, spin);
                let seen = frames::add(&mut self.graph, acceleration, extra);
                let seen = self.reexpress(seen, frame, within);
                for k in 0..3 {
                    dx[states[k]] = seen[k];
                }
            }
            None => self.rates(rotation, spin, acceleration, dx),
        }
    }

    /// Solves for the second derivatives of the angles, rad/s², from the angular velocity and its rates.
    fn rates(
        &mut self,
        rotation: &Rotation,
        spin: Vector,
        acceleration: Vector,
        dx: &mut [NodeId],
    ) {
        let model = self.model;
        let turned: Vec<(u32, u32)> = frames::path(model, rotation.body_frame)
            .into_iter()
            .filter_map(|frame| match model.frames[frame].kind {
                FrameKind::Turned {
                    angle,
                    rate: Some(rate),
                    ..
                } => Some((angle as u32, rate as u32)),
                _ => None,
            })
            .collect();
        let mut matrix = Vec::new();
        let mut right = Vec::new();
        for k in 0..3 {
            let row: Vec<NodeId> = turned
                .iter()
                .map(|&(_, rate)| partials::total(&mut self.graph, spin[k], Symbol::State(rate)))
                .collect();
            let mut terms = vec![(Number::ONE, acceleration[k])];
            for &(angle, rate) in &turned {
                let by_angle = partials::total(&mut self.graph, spin[k], Symbol::State(angle));
                let rate = self.graph.symbol(Symbol::State(rate));
                terms.push((Number::MINUS_ONE, self.graph.distribute(by_angle, rate)));
            }
            right.push(self.graph.sum(terms, Number::ZERO));
            matrix.push(row);
        }
        let rates = solve::solve(&mut self.graph, matrix, right)
            .expect("a checked model has rotation angles that determine the angular velocity");
        for (unknown, &(_, rate)) in rates.iter().zip(&turned) {
            dx[rate as usize] = *unknown;
        }
    }
}
