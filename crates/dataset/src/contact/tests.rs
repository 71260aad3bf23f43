//! Contacts of a disc whose rim touches the ground first.

use nalgebra::{UnitQuaternion, Vector3};

use super::{PathPoint, first_change};

/// Interval between samples, s.
const INTERVAL: f64 = 1.0 / 120.0;
/// Spin rate of the simulated disc, and angular rate of its wobble, rad/s.
const RATES: (f64, f64) = (50.0, 96.0);

/// Deterministic pseudo-random value between −1 and 1, used as measurement noise.
pub fn jitter(seed: usize) -> f64 {
    let mixed = (seed as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((mixed >> 11) as f64 / (1_u64 << 53) as f64).mul_add(2.0, -1.0)
}

/// Simulated flight of a spinning disc that wobbles. At the time `touch`, s, and again two samples later, the velocity
/// jumps upward by `jump`, m/s, and the wobble grows by 0.06 rad per m/s of `jump`; `None` for no ground contact.
/// `seed` determines the pseudo-random noise.
fn flight(touch: Option<f64>, jump: f64, seed: usize) -> Vec<PathPoint> {
    let each = (0..100).map(|i| {
        let noise = |k: usize, size: f64| size * jitter(seed * 10_007 + 6 * i + k);
        let time = i as f64 * INTERVAL;
        let since = |t: f64| (time - t).max(0.0);
        let rise = touch.map_or(0.0, |t| jump * (since(t) + since(t + 2.0 * INTERVAL)));
        let position = Vector3::new(
            8.0 * time + noise(0, 0.0015),
            noise(1, 0.0015),
            1.5 - 1.5 * time - 2.0 * time * time + rise + noise(2, 0.0015),
        );
        let (spin, rate) = RATES;
        let swing = touch.map_or((0.0, 0.0), |t| {
            let (sine, cosine) = (rate * since(t)).sin_cos();
            (0.06 * jump * sine, 0.06 * jump * (1.0 - cosine))
        });
        let (sine, cosine) = (rate * time).sin_cos();
        let tilt = Vector3::new(
            0.1 + 0.02 * sine + swing.0 + noise(3, 0.015),
            0.3 * time + 0.02 * cosine + swing.1 + noise(4, 0.015),
            0.0,
        );
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), spin * time);
        PathPoint {
            sample: i,
            time,
            position,
            attitude: Some(UnitQuaternion::new(tilt) * turn),
        }
    });
    each.collect()
}

fn found(path: &[PathPoint]) -> Option<usize> {
    first_change(path).map(|contact| contact.sample)
}

#[test]
fn a_touch_of_the_rim_is_found_within_two_samples() {
    for seed in 0..40 {
        let (sample, jump) = (35 + seed, 0.5 + 0.02 * seed as f64);
        let touch = (sample as f64 - 0.5) * INTERVAL;
        let found = found(&flight(Some(touch), jump, seed));
        let found = found.unwrap_or_else(|| panic!("touch {seed} is missed"));
        assert!(found.abs_diff(sample) <= 2, "{found} for {sample}");
    }
}

#[test]
fn a_touch_where_markers_are_hidden_is_found_within_two_samples() {
    for seed in 0..20 {
        let (sample, jump) = (40 + seed, 1.0 + 0.02 * seed as f64);
        let touch = (sample as f64 - 0.5) * INTERVAL;
        let mut posed = flight(Some(touch), jump, seed);
        posed.retain(|point| !(sample - 1..sample + 6).contains(&point.sample));
        let found = found(&posed).unwrap_or_else(|| panic!("touch {seed} is missed"));
        assert!(found.abs_diff(sample) <= 2, "{found} for {sample}");
    }
}

#[test]
fn a_disc_that_wobbles_touches_nothing() {
    for seed in 0..100 {
        let mut posed = flight(None, 0.0, seed);
        for (i, point) in posed.iter_mut().enumerate() {
            if jitter(seed * 7919 + i) > 0.98 {
                point.position.z += 0.05 * jitter(seed + 31 * i);
                let turn = UnitQuaternion::new(Vector3::x() * 0.4 * jitter(seed + 37 * i));
                point.attitude = point.attitude.map(|attitude| turn * attitude);
            }
        }
        assert_eq!(found(&posed), None, "seed {seed}");
    }
}

#[test]
fn a_body_that_is_held_still_touches_nothing() {
    let still = |i: usize| PathPoint {
        sample: i,
        time: i as f64 * INTERVAL,
        position: Vector3::zeros(),
        attitude: Some(UnitQuaternion::identity()),
    };
    let posed: Vec<PathPoint> = (0..60).map(still).collect();
    assert_eq!(found(&posed), None);
    assert_eq!(found(&posed[..3]), None);
    assert_eq!(found(&[]), None);
}
