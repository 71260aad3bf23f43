//! Simulates a laboratory session: takes with several throws of one disc.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, Normal};

use super::ends::{Hand, in_net};
use crate::contact::{Surface, Touched, fly};
use crate::oracle_flights::{
    TWELVE, Throws, disc, disc_constants, integrate, marker_positions, reference_of,
};

/// Number of takes (recordings) per session, and number of throws per take.
const TAKES: (usize, usize) = (3, 4);
/// Frame rates of the simulated cameras from which the rate of a session is chosen, Hz.
const RATES: [f64; 5] = [120.0, 150.0, 200.0, 250.0, 300.0];
/// Two times after a catch by the net or the first ground contact, s: the time for which the body remains visible, and
/// the following time without the body, until the next throw.
const AFTER: (f64, f64) = (0.3, 0.7);
/// Minimum time from the release to the first ground contact of a simulated low throw, s. Throws with a shorter time
/// are redrawn.
const SHORTEST: f64 = 0.35;
/// Probability that a single marker position in a sample is missing from the recording.
const GAPS: f64 = 0.02;
/// Minimum time after the release, and before the end of a flight, during which the body is not occluded as a whole, s.
const IN_SIGHT: f64 = 0.1;

/// Ranges of the launch conditions: low, downward throws that reach the ground.
const LOW: Throws = Throws {
    speed: (8.0, 18.0),
    launch: (-0.3, 0.0),
    nose: (-0.1, 0.2),
    ..Throws::SPREAD
};

/// Marker positions of a recording, m, with the z axis up, indexed by sample and marker; `None` for a missing position.
pub(super) type Rows = Vec<Vec<Option<[f64; 3]>>>;

/// Simulated recordings of one session, with the true markers and flights.
pub(super) struct Filmed {
    /// True positions of the markers in the body frame, m: the origin is the centre of mass, and the third axis is the
    /// axis of the disc.
    pub markers: Vec<[f64; 3]>,
    /// Frame rate of the simulated cameras, Hz.
    pub rate: f64,
    /// Standard deviation of the noise of each simulated marker coordinate, m.
    pub sigma: f64,
    pub takes: Vec<FilmedTake>,
}

/// Simulated recording of several throws, one after the other.
pub(super) struct FilmedTake {
    pub rows: Rows,
    /// Indices of the first and last sample of each true free flight in the recording.
    pub flights: Vec<(usize, usize)>,
}

/// Simulates one recording session (several takes with the same markers, frame rate and noise) from a seed.
pub(super) fn filmed(seed: u64) -> Filmed {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let r = &mut random;
    let rate = RATES[r.random_range(0..RATES.len())];
    let sigma = r.random_range(0.0005..0.0015);
    let count = r.random_range(3..=5);
    let phase: f64 = r.random_range(0.0..TAU);
    let markers = (0..count).map(|k| {
        let angle = phase + TAU * f64::from(k) / f64::from(count) + r.random_range(-0.4..0.4);
        let radius = r.random_range(0.05..0.12);
        let height = r.random_range(0.005..0.02);
        [radius * angle.cos(), radius * angle.sin(), height]
    });
    let markers: Vec<[f64; 3]> = markers.collect();
    let takes = (0..TAKES.0).map(|_| {
        let mut take = FilmedTake {
            rows: Vec::new(),
            flights: Vec::new(),
        };
        for _ in 0..TAKES.1 {
            add_throw(&mut take, &markers, rate, sigma, r);
        }
        take
    });
    Filmed {
        takes: takes.collect(),
        markers,
        rate,
        sigma,
    }
}

/// Appends one throw to a take (recording): motion in the hand, flight, catch by a net or ground contact, and the time
/// until the next throw in which no body is visible.
fn add_throw(
    take: &mut FilmedTake,
    markers: &[[f64; 3]],
    rate: f64,
    sigma: f64,
    r: &mut ChaCha12Rng,
) {
    let model = disc();
    let (reference, constants) = (reference_of(&model), disc_constants(&model, &TWELVE));
    let is_low = r.random_bool(0.5);
    let (longest, deceleration) = (r.random_range(0.5..1.0), r.random_range(60.0..200.0));
    // A low throw must reach the ground within the recorded time; any other throw must not.
    let (start, surface, touch) = loop {
        let mut start = match is_low {
            true => LOW.draw(r),
            false => Throws::SPREAD.draw(r),
        };
        if is_low {
            start.position.z = r.random_range(0.6..1.8);
        }
        let surface = Surface {
            restitution: r.random_range(0.2..0.6),
            friction: r.random_range(0.2..0.7),
        };
        let seen = fly(&model, (&reference, &constants), start, surface, &[longest]);
        let touch = seen.first.map(|(time, _)| time);
        match touch {
            None if !is_low => break (start, surface, None),
            Some(time) if is_low && time >= SHORTEST => break (start, surface, touch),
            _ => {}
        }
    };
    let hand = Hand::draw(start, r);
    let released = hand.seconds();
    // Times of the frames relative to the release. No frame need coincide with the release.
    let flown = (0..)
        .map(|k| f64::from(k) / rate - released)
        .skip_while(|t| *t < 0.0)
        .take_while(|t| *t <= longest + AFTER.0);
    let flown: Vec<f64> = flown.collect();
    let Touched { states, .. } = fly(&model, (&reference, &constants), start, surface, &flown);
    let end = touch.unwrap_or(longest);
    let at_net = integrate(&reference, &constants, start, &[longest])[0];
    let noise = Normal::new(0.0, sigma).expect("a positive width");
    let hidden = hidden(end, r);
    let before = (0..)
        .map(|k| f64::from(k) / rate)
        .take_while(|t| *t < released)
        .map(|t| (t - released, hand.at(t)));
    let after = flown.iter().zip(&states).map(|(t, state)| match touch {
        None if *t > longest => (*t, in_net(&at_net, deceleration, *t - longest)),
        _ => (*t, *state),
    });
    let seen: Vec<_> = before
        .chain(after.take_while(|(t, _)| *t <= end + AFTER.0))
        .collect();
    let at = take.rows.len();
    let first = seen.iter().position(|(t, _)| *t >= 0.0);
    let last = seen.iter().rposition(|(t, _)| *t <= end);
    if let (Some(first), Some(last)) = (first, last) {
        take.flights.push((at + first, at + last));
    }
    for (t, body) in seen {
        let is_hidden = hidden.is_some_and(|(from, to)| t > from && t < to);
        let row = marker_positions(&body, markers).into_iter().map(|exact| {
            let noisy = exact.map(|x| x + noise.sample(r));
            (!r.random_bool(GAPS) && !is_hidden).then_some(noisy)
        });
        take.rows.push(row.collect());
    }
    let fetched = (AFTER.1 * rate) as usize;
    take.rows
        .extend((0..fetched).map(|_| vec![None; markers.len()]));
}

/// Draws a time interval (start, end), s after the release, in which the whole disc is occluded from the cameras during
/// a flight that ends `end` seconds after the release. A third of the flights on average have such an interval; `None`
/// for the rest.
fn hidden(end: f64, r: &mut ChaCha12Rng) -> Option<(f64, f64)> {
    let (from, to) = (IN_SIGHT, end - 2.0 * IN_SIGHT);
    let length = r.random_range(0.02..0.06);
    let at = from + r.random_range(0.0..1.0) * (to - from);
    (r.random_bool(1.0 / 3.0) && to > from).then_some((at, at + length))
}

/// Rotates marker positions about the disc's axis (third body axis) so that the marker with the index `first` lies in
/// the plane of the first and third body axes, as in an estimated marker template.
pub(super) fn turned(markers: &[[f64; 3]], first: usize) -> Vec<[f64; 3]> {
    let [x, y, _] = markers[first];
    let angle = y.atan2(x);
    let (s, c) = angle.sin_cos();
    let each = markers.iter();
    each.map(|[x, y, z]| [c * x + s * y, c * y - s * x, *z])
        .collect()
}
