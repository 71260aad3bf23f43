//! Forces and moments that effects add to those of a law of motion.

use super::Flow;
use nalgebra::Vector3;
use oracle::Load;
use oracle::scalar::Real;
use std::f64::consts::PI;

/// Airspeed at which the Reynolds-number term of the drag is 0, m/s.
const REFERENCE_SPEED: f64 = 14.0;
/// Angle of attack at which stall begins, degrees.
const STALL_ANGLE: f64 = 8.0;
/// Height above the ground at which the additional lift near the ground is 1/e of its value at the ground, m.
const GROUND_EFFECT_HEIGHT: f64 = 0.5;
/// Angle of attack around which the rolling moment that acts only at low angles of attack drops to 0, and half-width of
/// this transition, degrees.
const LOW_ANGLE_END: (f64, f64) = (10.0, 2.0);
/// Kinematic viscosity of air at 20 °C, m²/s.
const VISCOSITY: f64 = 1.5e-5;
/// Critical Reynolds number of the drag crisis, and half-width of the transition around it (both dimensionless).
const CRISIS: (f64, f64) = (1e5, 2e4);

/// Force, N, and moment about the mass centre, N·m, of the effect called `name`, in inertial components; 0 for an
/// effect that adds no load. `values` are those of the effect's coefficients and states. The force of the added mass,
/// which depends on all other forces, is not included.
pub(super) fn load<T: Real>(name: &str, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
    let lift = |change: T| force(flow.lift(values[0] * change));
    let side = |by: T| {
        let [_, left] = flow.forward_and_left();
        force(flow.pressure_force(values[0] * by, left))
    };
    let roll = |by: T| {
        let [forward, _] = flow.forward_and_left();
        moment(flow.pressure_moment(values[0] * by, forward))
    };
    let pitch = |by: T| {
        let [_, left] = flow.forward_and_left();
        moment(flow.pressure_moment(values[0] * by, left))
    };
    match name {
        "stall" => lift(stall(flow)),
        "lift_by_spin" => lift(flow.advance_ratio().abs()),
        "ground_effect" => lift(near_ground(flow)),
        "zero_lift_drag_angle" | "drag_by_spin" | "drag_by_reynolds" => {
            force(flow.drag(drag_change(name, values[0], flow)))
        }
        "side_force_by_spin" => side(flow.advance_ratio()),
        "side_force_by_spin_and_angle" => side(flow.alpha() * flow.advance_ratio()),
        "roll_damping" => {
            let [forward, _] = flow.forward_and_left();
            roll(flow.at.angular_velocity.dot(&forward))
        }
        "rolling_moment_by_angle" => roll(flow.alpha()),
        "rolling_moment_by_spin_ratio" => roll(flow.advance_ratio()),
        "rolling_moment_at_low_angle" => roll(at_low_angle(flow)),
        "constant_pitching_moment" => pitch(T::one()),
        "cubic_pitching_moment" => pitch(flow.alpha().powi(3)),
        "pitching_moment_by_spin" => pitch(flow.advance_ratio().abs()),
        "quadratic_spin_down" | "spin_down_by_pressure" | "spin_down_by_angle" => {
            moment(spin_down(name, values[0], flow))
        }
        "magnus" | "spin_decay" | "drag_crisis" | "buoyancy" => {
            force(on_ball(name, values[0], flow))
        }
        _ => force(Vector3::zeros()),
    }
}

fn force<T: Real>(force: Vector3<T>) -> Load<T> {
    let moment = Vector3::zeros();
    Load { force, moment }
}

fn moment<T: Real>(moment: Vector3<T>) -> Load<T> {
    let force = Vector3::zeros();
    Load { force, moment }
}

/// Negative square of the angle of attack beyond stall, rad².
fn stall<T: Real>(flow: &Flow<'_, T>) -> T {
    let beyond = flow.alpha() - T::lit(STALL_ANGLE.to_radians());
    if beyond.re() > 0.0 {
        -(beyond * beyond)
    } else {
        T::zero()
    }
}

/// Share of the lift at the ground that is left at this height.
fn near_ground<T: Real>(flow: &Flow<'_, T>) -> T {
    let height = flow.at.position.z;
    (-(height * height) / T::lit(GROUND_EFFECT_HEIGHT * GROUND_EFFECT_HEIGHT)).exp()
}

/// Change of the drag coefficient of a disc.
fn drag_change<T: Real>(name: &str, value: T, flow: &Flow<'_, T>) -> T {
    match name {
        "zero_lift_drag_angle" => {
            // Parabola with the shifted minimum, minus the parabola with its minimum at 0.
            let alpha = flow.alpha();
            let shifted = alpha - value;
            flow.constant("C_Da") * (shifted * shifted - alpha * alpha)
        }
        "drag_by_spin" => value * flow.advance_ratio().abs(),
        _ => value * (flow.speed() / T::lit(REFERENCE_SPEED)).ln(),
    }
}

/// Advance ratio, where the angle of attack is low. The model text states the same logistic function by a hyperbolic
/// tangent.
fn at_low_angle<T: Real>(flow: &Flow<'_, T>) -> T {
    let [end, width] =
        [LOW_ANGLE_END.0, LOW_ANGLE_END.1].map(|degrees: f64| T::lit(degrees.to_radians()));
    let x = (flow.alpha() - end) / width;
    flow.advance_ratio() / (T::one() + (x + x).exp())
}

/// Moment about the axis of a disc, N·m.
fn spin_down<T: Real>(name: &str, value: T, flow: &Flow<'_, T>) -> Vector3<T> {
    let (spin, axis) = (flow.spin(), flow.normal());
    match name {
        "quadratic_spin_down" => {
            let sense = if spin.re() < 0.0 { -T::one() } else { T::one() };
            axis * (value * sense * spin * spin)
        }
        "spin_down_by_pressure" => flow.pressure_moment(value * flow.advance_ratio(), axis),
        _ => axis * (value * flow.alpha() * spin),
    }
}

/// Force on a ball in addition to its drag, N.
fn on_ball<T: Real>(name: &str, value: T, flow: &Flow<'_, T>) -> Vector3<T> {
    let [radius, rho] = ["radius", "rho"].map(|name| flow.constant(name));
    let area = T::lit(PI) * radius * radius;
    // ρ V² A / 2 · (R ω / V), perpendicular to spin and path: the vector product contains one V.
    let by_spin = flow.omega.cross(&flow.through_air()) * (rho * area * radius / T::lit(2.0));
    match name {
        "magnus" => by_spin * value,
        "spin_decay" => by_spin * (-value * flow.time),
        "drag_crisis" => {
            let reynolds = flow.speed() * T::lit(2.0) * radius / T::lit(VISCOSITY);
            let beyond = (reynolds - T::lit(CRISIS.0)) / T::lit(CRISIS.1);
            let turbulent = T::one() / (T::one() + (-(beyond + beyond)).exp());
            let pressure = rho * area * flow.speed() / T::lit(2.0);
            flow.through_air() * (pressure * value * turbulent)
        }
        _ => {
            let volume = T::lit(4.0 / 3.0 * PI) * radius.powi(3);
            let up = value * rho * volume * flow.constant("g");
            Vector3::new(T::zero(), T::zero(), up)
        }
    }
}
