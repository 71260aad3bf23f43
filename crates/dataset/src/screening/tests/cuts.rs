//! Flights are truncated at bounces and nowhere else.

use super::{Screened, ball, discs};
use crate::Flight;
use crate::contact;
use crate::screening::track::{self, Track};

/// Copy of a flight in which the body bounces at the time `time`, s: its velocity jumps by `change`, m/s.
fn bounced(flight: &Flight, time: f64, change: [f64; 3]) -> Flight {
    let mut flight = flight.clone();
    for (t, row) in flight.times.iter().zip(&mut flight.positions) {
        let since = (t - time).max(0.0);
        for point in row.iter_mut().flatten() {
            for (axis, change) in point.iter_mut().zip(change) {
                *axis += change * since;
            }
        }
    }
    flight
}

/// Index of the first sample after the detected impact on the ground or an object, at which the flight is truncated;
/// `None` if no impact is detected.
fn cut_at(body: &Screened, flight: &Flight) -> Option<usize> {
    let (track, _) = Track::of(body, flight);
    contact::first_change(&track.points).map(|contact| contact.sample)
}

fn cuts(seeds: std::ops::Range<u64>) -> [usize; 4] {
    let (mut flown, mut wrong, mut bounces, mut missed) = (0, 0, 0, 0);
    for seed in seeds {
        let (disc, mut datasets) = discs(12, 1000 * seed);
        let (ball, of_ball) = ball(seed);
        let discs = datasets.len();
        datasets.push(of_ball);
        for (k, dataset) in datasets.iter().enumerate() {
            let model = if k < discs { &disc } else { &ball };
            let body = Screened::new(model, dataset);
            for (index, flight) in dataset.flights.iter().enumerate() {
                flown += 1;
                if let Some(at) = cut_at(&body, flight) {
                    wrong += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index} cut at {at} of {}",
                        flight.times.len()
                    );
                }
                let (track, _) = Track::of(&body, flight);
                let middle = track.points.len() / 2 + index;
                let Some(motion) =
                    track::parabola(&track.points[middle - 10..middle + 10], track.noise)
                else {
                    continue;
                };
                let velocity = motion.velocity;
                if velocity.z > -1.0 {
                    continue;
                }
                bounces += 1;
                let restitution = 0.2 + 0.05 * index as f64;
                let change = [
                    -0.2 * velocity.x,
                    -0.2 * velocity.y,
                    -(1.0 + restitution) * velocity.z,
                ];
                let time = track.points[middle].time - 0.003;
                let at = cut_at(&body, &bounced(flight, time, change));
                // Dropouts may hide the samples at the impact.
                let index_of = |sample| track.points.partition_point(|point| point.sample < sample);
                if at.is_none_or(|at| index_of(at).abs_diff(middle) > 2) {
                    missed += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index}: bounce at {middle} of change {change:?}, cut at {:?}",
                        at.map(index_of)
                    );
                }
            }
        }
    }
    eprintln!("{wrong} of {flown} cut wrongly; {missed} of {bounces} bounces missed");
    [flown, wrong, bounces, missed]
}

#[test]
fn flights_are_cut_at_bounces_only() {
    let [flown, wrong, bounces, missed] = cuts(0..1);
    assert!(flown > 50 && bounces > 20);
    assert_eq!([wrong, missed], [0, 0]);
}

/// Tests, for many simulated flights, that a flight is truncated only at a bounce and that nearly all bounces are
/// detected; run with `--ignored` in a release build.
#[test]
#[ignore = "takes long"]
fn two_thousand_flights_are_cut_at_bounces_only() {
    let [_, wrong, bounces, missed] = cuts(0..30);
    assert_eq!(wrong, 0);
    assert!(100 * missed <= bounces);
}
