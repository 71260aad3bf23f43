//! Writes the cases of benches/discovery as folders: flights of the disc with one seeded aerodynamic effect of the
//! catalogue, weak and strong, and flights without a seeded effect. Each dataset has a file `truth.json`. The output is
//! identical for every run.
//!
//! `cargo run --release -p hyzer-studies --example discovery_cases -- FOLDER`

use std::fs;
use std::path::Path;

use dataset::synthesize::Corruption;
use dataset::write_with;
use model_spec::load::load;
use serde_json::{Value, json};
use studies::oracle_flights::{Plan, TWELVE, disc, truth};
use studies::seeded::{STRENGTHS, SeededEffects, dataset, unlisted};

/// Simulated experiment: twenty throws of a disc, each observed for one second at 120 Hz with three markers.
const TWENTY: Plan<'static> = Plan {
    flights: 20,
    ..TWELVE
};
/// Measurement noise: white, with a standard deviation of 1.5 mm on each marker coordinate.
const WHITE: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.0,
    outliers: 0.0,
    outlier_size: 0.0,
    dropouts: 0.0,
};
/// Number of simulated datasets for each physical effect that is added to the flights, and for each of its sizes.
const SEEDS: u64 = 5;
/// Number of simulated datasets to whose flights no physical effect is added.
const NULLS: u64 = 20;
/// Components of the aerodynamic force and moment, named as in the model, on which the physical effects of this
/// comparison act. Effects on other quantities are not terms of an aerodynamic coefficient, so the other programs in
/// the comparison could not find them.
const SITES: [&str; 6] = ["lift", "drag", "side", "roll", "pitch", "spin"];
/// Name of the physical effect that cannot be distinguished from the aerodynamic coefficients: denser air is equivalent
/// to larger coefficients.
const CONFOUNDED: &str = "air_density";
/// Names of physical effects outside the built-in effects catalogue. Each adds a term to one component of the
/// aerodynamic force or moment. The script operon.py contains their formulas.
const OUTSIDE: [&str; 6] = [
    "roll_by_angle_squared",
    "drag_by_climb",
    "side_force_by_angle",
    "pitching_moment_by_time",
    "lift_by_pitch_rate",
    "drag_by_power_of_speed",
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("which folder?")?;
    let folder = Path::new(&folder);
    let mut index = Vec::new();
    let mut add = |name: String, seeded: SeededEffects, seed: u64, mut facts: Value| {
        let plan = truth(&disc(), &TWENTY);
        facts["seed"] = seed.into();
        facts["coefficients"] = plan.into_iter().collect::<Value>();
        let truth_text = format!("{facts:#}\n");
        let case_folder = folder.join(&name);
        if case_folder.exists() {
            fs::remove_dir_all(&case_folder)?;
        }
        write_with(
            &case_folder,
            &dataset(&TWENTY, &seeded, seed),
            &[("truth.json".into(), truth_text)],
        )?;
        facts["name"] = name.into();
        index.push(facts);
        Ok::<_, std::io::Error>(())
    };
    for (number, row) in STRENGTHS.iter().enumerate() {
        // Effects that act only on a ball do not load.
        let Ok(model) = load("disc", &[row.effect]) else {
            continue;
        };
        let site = &model.effects[0].site;
        if row.effect == CONFOUNDED || !SITES.contains(&site.as_str()) {
            continue;
        }
        for (size, values) in [("weak", row.weak), ("strong", row.strong)] {
            for seed in 1..=SEEDS {
                let effect = row.effect;
                let mut facts = json!({"effect": effect, "site": site, "size": size, "values": values, "noise": true});
                let seeded = SeededEffects::listed(effect, values);
                // No two cases have the same throws or noise.
                let case_seed =
                    100 * (1 + number as u64) + seed + if size == "weak" { 0 } else { 50 };
                let name = format!("{effect}-{size}-{seed}");
                add(
                    name,
                    seeded.clone().with_noise(WHITE),
                    case_seed,
                    facts.clone(),
                )?;
                if seed == 1 {
                    facts["noise"] = false.into();
                    add(format!("{effect}-{size}-clean"), seeded, case_seed, facts)?;
                }
            }
        }
    }
    for (number, name) in OUTSIDE.into_iter().enumerate() {
        let effect = unlisted(name).ok_or("an effect outside the catalogue")?;
        for (size, value) in ["weak", "strong"].into_iter().zip(effect.strength) {
            let facts = json!({"effect": name, "site": effect.site, "size": size, "values": [value], "noise": true});
            let seeded = SeededEffects::unlisted(name, value).with_noise(WHITE);
            let seed = 10_000 + 10 * number as u64 + u64::from(size == "weak");
            add(format!("outside-{name}-{size}"), seeded, seed, facts)?;
        }
    }
    for seed in 1..=NULLS {
        let facts =
            json!({"effect": null, "site": null, "size": "null", "values": [], "noise": true});
        let seeded = SeededEffects::default().with_noise(WHITE);
        add(format!("none-{seed}"), seeded, seed, facts)?;
    }
    fs::write(
        folder.join("cases.json"),
        format!("{:#}\n", Value::from(index)),
    )?;
    Ok(())
}
