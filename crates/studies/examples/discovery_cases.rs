//! Writes the cases of benches/discovery as folders: flights of the disc with one aerodynamic effect of the catalogue hidden in
//! them, weak and strong, and flights with none; beside each dataset a `truth.json`. The same bytes on every run.
//!
//! `cargo run --release -p hyzer-studies --example discovery_cases -- FOLDER`

use std::fs;
use std::path::Path;

use identify::dataset::write_with;
use identify::synthesize::Corruption;
use model_spec::load::load;
use serde_json::{Value, json};
use studies::identification::coverage::TWELVE;
use studies::oracle_flights::dataset::{Plan, disc, truth};
use studies::seeded::{Hidden, dataset, strength};

/// Twenty throws of a second each, three markers, 120 Hz.
const TWENTY: Plan<'static> = Plan {
    flights: 20,
    ..TWELVE
};
/// What the cameras add: 1.5 mm on each axis, white.
const WHITE: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.0,
    outliers: 0.0,
    outlier_size: 0.0,
    dropouts: 0.0,
};
/// Datasets of each effect and strength.
const SEEDS: u64 = 5;
/// Datasets in which nothing is hidden.
const NULLS: u64 = 20;
/// Loads in the D frame: an effect that acts elsewhere is no term of a coefficient.
const SITES: [&str; 6] = ["lift", "drag", "side", "roll", "pitch", "spin"];
/// Denser air is the same as greater coefficients: there is nothing for anyone to find.
const ABSORBED: &str = "air_density";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("which folder?")?;
    let folder = Path::new(&folder);
    let mut index = Vec::new();
    let mut add = |name: String, hidden: Hidden, seed: u64, mut told: Value| {
        let plan = truth(&disc(), &TWENTY);
        told["seed"] = seed.into();
        told["coefficients"] = plan.into_iter().collect::<Value>();
        let beside = format!("{told:#}\n");
        let place = folder.join(&name);
        if place.exists() {
            fs::remove_dir_all(&place)?;
        }
        write_with(
            &place,
            &dataset(&TWENTY, &hidden, seed),
            &[("truth.json", beside)],
        )?;
        told["name"] = name.into();
        index.push(told);
        Ok::<_, std::io::Error>(())
    };
    for (number, row) in strength::ALL.iter().enumerate() {
        // An effect of the ball alone does not load.
        let Ok(model) = load("disc", &[row.effect]) else {
            continue;
        };
        let site = &model.effects[0].site;
        if row.effect == ABSORBED || !SITES.contains(&site.as_str()) {
            continue;
        }
        for (size, values) in [("weak", row.weak), ("strong", row.strong)] {
            for seed in 1..=SEEDS {
                let effect = row.effect;
                let mut told = json!({"effect": effect, "site": site, "size": size, "values": values, "noise": true});
                let hidden = Hidden::effect(effect, values);
                // No two cases have their throws or their noise in common.
                let own = 100 * (1 + number as u64) + seed + if size == "weak" { 0 } else { 50 };
                let name = format!("{effect}-{size}-{seed}");
                add(name, hidden.clone().with_noise(WHITE), own, told.clone())?;
                if seed == 1 {
                    told["noise"] = false.into();
                    add(format!("{effect}-{size}-clean"), hidden, own, told)?;
                }
            }
        }
    }
    for seed in 1..=NULLS {
        let told =
            json!({"effect": null, "site": null, "size": "null", "values": [], "noise": true});
        let hidden = Hidden::default().with_noise(WHITE);
        add(format!("none-{seed}"), hidden, seed, told)?;
    }
    fs::write(
        folder.join("cases.json"),
        format!("{:#}\n", Value::from(index)),
    )?;
    Ok(())
}
