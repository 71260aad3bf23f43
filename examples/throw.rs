//! Searches for the throw of a disc that flies farthest, and tries how it depends on the speed.
use hyzer::{Design, Error, Goal, Model};

fn main() -> Result<(), Error> {
    let disc = Model::load("disc")?;
    let search = Design::of(&disc, Goal::Range)
        .bound("speed", 10.0, 20.0)
        .bound("spin", 300.0, 900.0);
    let far = search.seed(7).run()?;
    let throw = far.throw();
    println!(
        "{:.1} m at {:.1} m/s, launched at {:.1} deg",
        far.figure(),
        throw.speed,
        throw.launch
    );
    for (quantity, [x, y]) in far.sensitivity() {
        println!("landing by {quantity}: {x:+.3} m ahead, {y:+.3} m to the left");
    }
    let flight = disc.fly(far.release())?;
    let [x, y, _] = far.landing();
    let range = x.hypot(y);
    assert!(far.is_feasible() && (range - far.figure()).abs() < 0.01 && flight.duration() > 1.0);
    Ok(())
}
