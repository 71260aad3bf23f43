//! Random states of discs in flight, in several flights with parameters of their own.

use generated::disc;

/// Number of states.
pub const STATES: usize = disc::STATES.len();
/// Number of parameters.
pub const PARAMETERS: usize = disc::PARAMETERS.len();
/// Number of prepared constants.
pub const PREPARED: usize = disc::PREPARED.len();
/// As many flights as the widest lanes hold.
pub const FLIGHTS: usize = 8;
/// States of each.
pub const STEPS: usize = 125;

/// How far the states reach, as in `benches/peers/states.py`.
const REACH: [f64; STATES] = [
    10.0, 10.0, 5.0, 15.0, 8.0, 4.0, 0.8, 0.8, 6.3, 8.0, 8.0, 60.0,
];
/// Wind about which the parameters scatter; the others scatter about their defaults.
const WIND: [f64; 3] = [1.0, -1.5, 0.4];

/// One flight's parameters and states.
pub struct Flight {
    /// Parameters.
    pub p: [f64; PARAMETERS],
    /// What `prepare` makes of them.
    pub k: [f64; PREPARED],
    /// States.
    pub x: Vec<[f64; STATES]>,
}

/// The flights.
pub fn draw(mut seed: u64) -> Vec<Flight> {
    let mut uniform = |low: f64, high: f64| low + (high - low) * splitmix(&mut seed);
    let mut flights = Vec::new();
    for _ in 0..FLIGHTS {
        let mut p = disc::DEFAULTS;
        p[PARAMETERS - 3..].copy_from_slice(&WIND);
        p.iter_mut().for_each(|value| *value *= uniform(0.7, 1.3));
        let mut k = [0.0; PREPARED];
        (disc::MODEL.prepare)(&p, &mut k);
        let x = (0..STEPS)
            .map(|_| REACH.map(|reach| uniform(-reach, reach)))
            .collect();
        flights.push(Flight { p, k, x });
    }
    flights
}

/// Between 0 and 1.
fn splitmix(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}
