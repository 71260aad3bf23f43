//! Do all say the same?

use crate::ours::{self, InLanes, Results};
use crate::peers::Peer;
use crate::rows::{Flight, PARAMETERS, STATES};
use generated::disc;
use lanes::{Isa, dispatch_with};

/// Derivatives, dense Jacobians.
struct Dense {
    dx: [f64; STATES],
    j: [[f64; STATES]; STATES],
    jp: [[f64; PARAMETERS]; STATES],
}

/// Worst difference of each peer from ours, each row by its own magnitude: derivatives of the states by the greatest of
/// their first-order shares, since they may cancel.
pub fn worst(peers: &[Peer], flights: &[Flight]) -> Vec<f64> {
    peers
        .iter()
        .map(|peer| {
            let states = flights
                .iter()
                .flat_map(|flight| flight.x.iter().map(move |x| (flight, x)));
            states
                .map(|(flight, x)| difference(peer, flight, x))
                .fold(0.0, greater)
        })
        .collect()
}

/// A NaN is the greatest of all.
fn greater(a: f64, b: f64) -> f64 {
    if a >= b {
        a
    } else if b.is_nan() {
        f64::INFINITY
    } else {
        b
    }
}

fn difference(peer: &Peer, flight: &Flight, x: &[f64; STATES]) -> f64 {
    let ours = our_dense(flight, x);
    let mut out = vec![f64::NAN; peer.outputs()];
    peer.call(x, &flight.p, &mut out);
    let mut theirs = Dense {
        dx: [0.0; STATES],
        j: [[0.0; STATES]; STATES],
        jp: [[0.0; PARAMETERS]; STATES],
    };
    theirs.dx.copy_from_slice(&out[..STATES]);
    for (&(row, column), value) in peer.j.iter().zip(&out[STATES..]) {
        theirs.j[row][column] = *value;
    }
    for (&(row, column), value) in peer.jp.iter().zip(&out[STATES + peer.j.len()..]) {
        theirs.jp[row][column] = *value;
    }
    let mut worst = 0.0;
    for row in 0..STATES {
        let shares = ours.j[row]
            .iter()
            .zip(x)
            .chain(ours.jp[row].iter().zip(&flight.p));
        let scale = shares
            .map(|(d, v)| (d * v).abs())
            .fold(ours.dx[row].abs(), f64::max);
        worst = greater(
            worst,
            (ours.dx[row] - theirs.dx[row]).abs() / (scale + 1e-300),
        );
        if !peer.j.is_empty() {
            worst = greater(worst, of_row(&ours.j[row], &theirs.j[row]));
        }
        if !peer.jp.is_empty() {
            worst = greater(worst, of_row(&ours.jp[row], &theirs.jp[row]));
        }
    }
    worst
}

fn of_row(ours: &[f64], theirs: &[f64]) -> f64 {
    let scale = ours.iter().fold(1e-300, |most: f64, v| most.max(v.abs()));
    let differences = ours.iter().zip(theirs).map(|(a, b)| (a - b).abs() / scale);
    differences.fold(0.0, greater)
}

fn our_dense(flight: &Flight, x: &[f64; STATES]) -> Dense {
    let mut results = Results::new();
    ours::call(2, flight, x, &mut results);
    let mut dense = Dense {
        dx: results.dx,
        j: [[0.0; STATES]; STATES],
        jp: [[0.0; PARAMETERS]; STATES],
    };
    for (&(row, column), value) in disc::J_PATTERN.iter().zip(results.j) {
        dense.j[row as usize][column as usize] = value;
    }
    for (&(row, column), value) in disc::JP_PATTERN.iter().zip(results.jp) {
        dense.jp[row as usize][column as usize] = value;
    }
    dense
}

/// How far lanes are from one number at a time, on the last states, each of the greatest of its kind; 0 where they give the
/// same bits. All three functions.
pub fn from_one(isa: Isa, flights: &[Flight]) -> f64 {
    let mut worst = 0.0;
    for function in 0..3 {
        let kernel = InLanes {
            function,
            flights,
            passes: 1,
        };
        let Some((_, lanes)) = dispatch_with(isa, kernel) else {
            continue;
        };
        for (flight, lane) in flights.iter().zip(lanes) {
            let mut one = Results::new();
            ours::call(function, flight, &flight.x[flight.x.len() - 1], &mut one);
            let mut lane = lane.as_slice();
            for part in [&one.dx[..], &one.j, &one.jp].iter().take(function + 1) {
                let (of, rest) = lane.split_at(part.len());
                lane = rest;
                if part.iter().zip(of).any(|(a, b)| a.to_bits() != b.to_bits()) {
                    worst = greater(worst, of_row(part, of));
                }
            }
        }
    }
    worst
}
