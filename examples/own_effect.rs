//! Finds an effect of one's own in simulated throws, and writes the extended model.
use hyzer::{Diagnosis, Effect, Error, Model, Plan, Verdict, synthesize};

const EFFECT: &str = "
/// lift lost to the spin
effect lift_by_rate { site lift; variables spin; coefficient C_Lr = 0 [s] in -1 .. 1; negligible C_Lr 0.0005 [s];
  replace C_L = previous + C_Lr*r; }";

fn main() -> Result<(), Error> {
    let (disc, effect) = (Model::load("disc")?, Effect::parse(EFFECT)?);
    let truth = disc.with(&effect)?;
    let release = truth.release("backhand")?.with_coefficient("C_Lr", 0.004);
    let plan = Plan {
        flights: 8,
        held_out: 2,
        duration: Some(1.0),
        seed: 5,
        ..Plan::default()
    };
    let data = synthesize(&truth, &[release], &plan)?;
    let found = Diagnosis::of(&disc.with_candidate(&effect)?).run(&data)?;
    println!("{:?}: {}", found.verdict(), found.summary());
    assert_ne!(found.verdict(), Verdict::Adequate);
    let extended = found.extended().expect("an extended model");
    let path = std::env::temp_dir().join("extended.hyz");
    std::fs::write(&path, extended.fitted_text()).expect("a file");
    let read_back = Model::load(path.to_str().expect("a path"))?;
    assert!(read_back.text().contains("C_Lr"));
    Ok(())
}
