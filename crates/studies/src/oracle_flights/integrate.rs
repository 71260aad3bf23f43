//! Flights by the oracle: its forces and moments, and the classic Runge–Kutta method at a fixed small step.

use nalgebra::Vector3;
use oracle::attitude::Quaternion;
use oracle::physical::{Motion, Physical};
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
    let answer = |at: &Physical<f64>, _: f64, _: f64| Answer {
        motion: reference.motion_at(at, &constants(at)),
        memory: 0.0,
    };
    fly_by(&answer, start, 0.0, times)
}

/// How a body answers at a time, and how what it remembers changes.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// Forces, moments, accelerations.
    pub motion: Motion<f64>,
    /// Rate of change of what it remembers.
    pub memory: f64,
}

/// As [`fly`], by any law: of the body, the time and one number that the body remembers.
///
/// # Panics
/// Where times run back.
pub fn fly_by(
    answer: &dyn Fn(&Physical<f64>, f64, f64) -> Answer,
    start: Physical<f64>,
    memory: f64,
    times: &[f64],
) -> Vec<Physical<f64>> {
    let mut now = Moment {
        time: 0.0,
        body: start,
        memory,
    };
    times
        .iter()
        .map(|&time| {
            assert!(time >= now.time, "times run on");
            let steps = ((time - now.time) / STEP).ceil().max(1.0);
            let h = (time - now.time) / steps;
            for _ in 0..steps as usize {
                now = step(answer, &now, h);
            }
            now.time = time;
            now.body
        })
        .collect()
}

/// Where markers fixed in the body are.
pub fn markers(physical: &Physical<f64>, markers: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let place = |marker: &[f64; 3]| physical.position + physical.attitude.carry((*marker).into());
    markers.iter().map(|marker| place(marker).into()).collect()
}

/// A body at a time, and what it remembers.
#[derive(Clone, Copy)]
struct Moment {
    time: f64,
    body: Physical<f64>,
    memory: f64,
}

/// How all of it changes.
struct Rate {
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    turn: Quaternion<f64>,
    angular_acceleration: Vector3<f64>,
    memory: f64,
}

type Constants<'c> = &'c dyn Fn(&Physical<f64>) -> Point<f64>;
type Law<'l> = &'l dyn Fn(&Physical<f64>, f64, f64) -> Answer;

fn rate(law: Law<'_>, at: &Moment) -> Rate {
    let answer = law(&at.body, at.time, at.memory);
    let spin = Quaternion {
        w: 0.0,
        v: at.body.angular_velocity * 0.5,
    };
    Rate {
        velocity: at.body.velocity,
        acceleration: answer.motion.acceleration,
        turn: spin.times(at.body.attitude),
        angular_acceleration: answer.motion.angular_acceleration,
        memory: answer.memory,
    }
}

fn moved(from: &Moment, h: f64, rate: &Rate) -> Moment {
    let body = &from.body;
    Moment {
        time: from.time + h,
        body: Physical {
            position: body.position + rate.velocity * h,
            velocity: body.velocity + rate.acceleration * h,
            attitude: Quaternion {
                w: body.attitude.w + h * rate.turn.w,
                v: body.attitude.v + rate.turn.v * h,
            },
            angular_velocity: body.angular_velocity + rate.angular_acceleration * h,
        },
        memory: from.memory + h * rate.memory,
    }
}

fn step(law: Law<'_>, x: &Moment, h: f64) -> Moment {
    let k1 = rate(law, x);
    let k2 = rate(law, &moved(x, h / 2.0, &k1));
    let k3 = rate(law, &moved(x, h / 2.0, &k2));
    let k4 = rate(law, &moved(x, h, &k3));
    let mean = |part: fn(&Rate) -> Vector3<f64>| {
        (part(&k1) + (part(&k2) + part(&k3)) * 2.0 + part(&k4)) / 6.0
    };
    let number =
        |part: fn(&Rate) -> f64| (part(&k1) + 2.0 * (part(&k2) + part(&k3)) + part(&k4)) / 6.0;
    let mut next = moved(
        x,
        h,
        &Rate {
            velocity: mean(|k| k.velocity),
            acceleration: mean(|k| k.acceleration),
            turn: Quaternion {
                w: number(|k| k.turn.w),
                v: mean(|k| k.turn.v),
            },
            angular_acceleration: mean(|k| k.angular_acceleration),
            memory: number(|k| k.memory),
        },
    );
    let attitude = next.body.attitude;
    let length = (attitude.w * attitude.w + attitude.v.norm_squared()).sqrt();
    next.body.attitude = Quaternion {
        w: attitude.w / length,
        v: attitude.v / length,
    };
    next
}
