//! A figure of the backhand by the hand-written disc: `cargo run -p hyzer-report --example figure > flight.svg`.

#[path = "../../ode/tests/disc/mod.rs"]
mod disc;

use ode::{Event, IntegrationOptions, integrate_to_event};
use report::figures::{StateLabel, flight};

fn main() {
    let mut events = [
        Event::peak_of("apex", 2),
        Event::falls_to("ground", 2, 0.0).terminal(),
    ];
    let flown = integrate_to_event(
        &mut disc::disc(),
        (0.0, &disc::THROW),
        20.0,
        &IntegrationOptions::default(),
        &mut events,
    );
    let units = [
        "m", "m", "m", "m/s", "m/s", "m/s", "rad", "rad", "rad", "rad/s", "rad/s", "rad/s",
    ];
    let labels: Vec<StateLabel<'_>> = disc::NAMES
        .iter()
        .zip(units)
        .map(|(name, unit)| StateLabel { name, unit })
        .collect();
    match flown {
        Ok(flown) => print!("{}", flight("A backhand to the ground", &flown, &labels)),
        Err(error) => eprintln!("{error}"),
    }
}
