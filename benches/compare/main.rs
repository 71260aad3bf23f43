//! The peers' disc and ours, in one process and one interleaved run: `python3 benches/peers/run.py --compare`.
//!
//! Prints a page of Markdown, or writes it to the file after `--out`.

mod agreement;
mod counts;
mod flights;
mod ours;
mod peers;
mod report;
mod rows;

use lanes::{Isa, dispatch_with};
use peers::Peer;
use rows::{FLIGHTS, Flight, STEPS};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Names of the three functions.
pub const TITLES: [&str; 3] = ["f", "f+J", "f+J+Jp"];
/// Passes over all states in a round.
const PASSES: usize = 2;

/// Everything that was measured.
pub struct Measured {
    /// The peers' functions.
    pub peers: Vec<Peer>,
    /// Worst difference of each.
    pub differences: Vec<f64>,
    /// Medians of each, ns.
    pub peer_ns: Vec<f64>,
    /// Lanes and how far they are from one number at a time.
    pub isas: Vec<(Isa, f64)>,
    /// Medians of ours for `f64`, and then for each of the lanes, ns a state, function by function.
    pub our_ns: Vec<[f64; 3]>,
    /// Median of `prepare`, ns.
    pub prepare_ns: f64,
    /// How many rounds.
    pub rounds: usize,
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    // `cargo test --benches` runs this too, without measuring.
    if !arguments.iter().any(|a| a == "--bench") {
        return;
    }
    let Some(results) = peers::results() else {
        println!("no peers to compare with: run `python3 benches/peers/run.py --compare`");
        return;
    };
    let value = |name: &str| {
        let at = arguments.iter().position(|a| a == name)?;
        arguments.get(at + 1).cloned()
    };
    let rounds = value("--rounds")
        .and_then(|n| n.parse().ok())
        .unwrap_or(201);
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let measured = measure(peers::load(&results), rounds);
    let flown = flights::measure(root, &results["frispy"]["landing"]);
    let frispy = flights::frispy(root);
    let page = report::page(root, &measured, flown, frispy, &results);
    println!("{page}");
    if let Some(path) = value("--out") {
        std::fs::write(root.join(path), page).expect("a place for the page");
    }
}

/// One round times every function of everyone once.
fn measure(peers: Vec<Peer>, rounds: usize) -> Measured {
    let flights = rows::draw(1);
    let differences = agreement::worst(&peers, &flights);
    let isas: Vec<(Isa, f64)> = [Isa::Avx512, Isa::Avx2, Isa::Portable]
        .into_iter()
        .filter(|isa| isa.is_supported())
        .map(|isa| (isa, agreement::from_one(isa, &flights)))
        .collect();
    let mut peer_ns = vec![Vec::new(); peers.len()];
    let mut our_ns = vec![[const { Vec::new() }; 3]; 1 + isas.len()];
    let mut prepare_ns = Vec::new();
    let mut out = vec![0.0; 12 + 12 * 30];
    for _ in 0..rounds {
        for (peer, times) in peers.iter().zip(&mut peer_ns) {
            times.push(one_by_one(&flights, |flight, x| {
                peer.call(x, &flight.p, black_box(&mut out));
            }));
        }
        let mut results = ours::Results::new();
        our_ns[0][0].push(one_by_one(&flights, |flight, x| {
            ours::call(0, flight, x, black_box(&mut results));
        }));
        our_ns[0][1].push(one_by_one(&flights, |flight, x| {
            ours::call(1, flight, x, black_box(&mut results));
        }));
        our_ns[0][2].push(one_by_one(&flights, |flight, x| {
            ours::call(2, flight, x, black_box(&mut results));
        }));
        let mut k = [0.0; rows::PREPARED];
        prepare_ns.push(one_by_one(&flights, |flight, _| {
            (generated::disc::MODEL.prepare)(&flight.p, black_box(&mut k));
        }));
        for ((isa, _), times) in isas.iter().zip(&mut our_ns[1..]) {
            for (function, times) in times.iter_mut().enumerate() {
                let pass = |passes| ours::InLanes {
                    function,
                    flights: &flights,
                    passes,
                };
                dispatch_with(*isa, pass(1));
                times.extend(dispatch_with(*isa, pass(PASSES)).map(|(ns, _)| ns));
            }
        }
    }
    Measured {
        differences,
        peer_ns: peer_ns.into_iter().map(median).collect(),
        isas,
        our_ns: our_ns.into_iter().map(|of| of.map(median)).collect(),
        prepare_ns: median(prepare_ns),
        rounds,
        peers,
    }
}

/// Nanoseconds a call, over all states; a part of them is passed over once before, to warm up.
#[inline(always)]
fn one_by_one(flights: &[Flight], mut call: impl FnMut(&Flight, &[f64; rows::STATES])) -> f64 {
    for flight in &flights[..2] {
        flight.x.iter().for_each(|x| call(flight, x));
    }
    let start = Instant::now();
    for _ in 0..PASSES {
        for flight in flights {
            flight.x.iter().for_each(|x| call(flight, x));
        }
    }
    1e9 * start.elapsed().as_secs_f64() / (PASSES * FLIGHTS * STEPS) as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
