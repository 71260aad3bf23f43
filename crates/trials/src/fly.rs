//! Flights by the oracle: its forces and moments, and the classic Runge–Kutta method at a fixed small step.

use nalgebra::Vector3;
use oracle::attitude::Quaternion;
use oracle::physical::Physical;
use oracle::point::Point;
use oracle::reference::Reference;

/// Longest step, s: a nutation of 100 rad/s is followed to 1e-9 of its size over a second.
const STEP: f64 = 4e-4;

/// Where a body is, by the oracle, at each of the times (s, increasing); it starts at time 0.
///
/// # Panics
/// Where times run back.
pub fn fly(
    reference: &Reference,
    constants: &Point<f64>,
    start: Physical<f64>,
    times: &[f64],
) -> Vec<Physical<f64>> {
    fly_with(reference, &|_| constants.clone(), start, times)
}

/// As [`fly`], with constants that follow the state: so that curves of any form take the place of the model's.
///
/// # Panics
/// Where times run back.
pub fn fly_with(
    reference: &Reference,
    constants: Constants<'_>,
    start: Physical<f64>,
    times: &[f64],
) -> Vec<Physical<f64>> {
    let mut now = start;
    let mut clock = 0.0;
    times
        .iter()
        .map(|&time| {
            assert!(time >= clock, "times run on");
            let steps = ((time - clock) / STEP).ceil().max(1.0);
            let h = (time - clock) / steps;
            for _ in 0..steps as usize {
                now = step(reference, constants, &now, h);
            }
            clock = time;
            now
        })
        .collect()
}

/// Where markers fixed in the body are.
pub fn markers(physical: &Physical<f64>, markers: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let place = |marker: &[f64; 3]| physical.position + physical.attitude.carry((*marker).into());
    markers.iter().map(|marker| place(marker).into()).collect()
}

/// How a body's state changes.
struct Rate {
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    turn: Quaternion<f64>,
    angular_acceleration: Vector3<f64>,
}

type Constants<'c> = &'c dyn Fn(&Physical<f64>) -> Point<f64>;

fn rate(reference: &Reference, constants: Constants<'_>, at: &Physical<f64>) -> Rate {
    let motion = reference.motion_at(at, &constants(at));
    let spin = Quaternion {
        w: 0.0,
        v: at.angular_velocity * 0.5,
    };
    Rate {
        velocity: at.velocity,
        acceleration: motion.acceleration,
        turn: spin.times(at.attitude),
        angular_acceleration: motion.angular_acceleration,
    }
}

fn moved(from: &Physical<f64>, h: f64, rate: &Rate) -> Physical<f64> {
    Physical {
        position: from.position + rate.velocity * h,
        velocity: from.velocity + rate.acceleration * h,
        attitude: Quaternion {
            w: from.attitude.w + h * rate.turn.w,
            v: from.attitude.v + rate.turn.v * h,
        },
        angular_velocity: from.angular_velocity + rate.angular_acceleration * h,
    }
}

fn step(
    reference: &Reference,
    constants: Constants<'_>,
    x: &Physical<f64>,
    h: f64,
) -> Physical<f64> {
    let k1 = rate(reference, constants, x);
    let k2 = rate(reference, constants, &moved(x, h / 2.0, &k1));
    let k3 = rate(reference, constants, &moved(x, h / 2.0, &k2));
    let k4 = rate(reference, constants, &moved(x, h, &k3));
    let mean = |part: fn(&Rate) -> Vector3<f64>| {
        (part(&k1) + (part(&k2) + part(&k3)) * 2.0 + part(&k4)) / 6.0
    };
    let turn = Quaternion {
        w: (k1.turn.w + 2.0 * (k2.turn.w + k3.turn.w) + k4.turn.w) / 6.0,
        v: mean(|k| k.turn.v),
    };
    let mut next = moved(
        x,
        h,
        &Rate {
            velocity: mean(|k| k.velocity),
            acceleration: mean(|k| k.acceleration),
            turn,
            angular_acceleration: mean(|k| k.angular_acceleration),
        },
    );
    let attitude = next.attitude;
    let length = (attitude.w * attitude.w + attitude.v.norm_squared()).sqrt();
    next.attitude = Quaternion {
        w: attitude.w / length,
        v: attitude.v / length,
    };
    next
}
