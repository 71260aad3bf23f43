//! Flights with hidden effects: nothing hidden is nothing changed, every effect shows, and the fit finds it by name.

use dataset::synthesize::Corruption;
use dataset::{Dataset, Role};
use identify::{FitOptions, fit};
use oracle::Law;
use studies::oracle_flights::{Plan, TWELVE, disc, flights};
use studies::seeded::law as effect;
use studies::seeded::{STRENGTHS, SeededEffects, UNLISTED, ball, dataset, strength};

const FOUR: Plan<'static> = Plan {
    flights: 4,
    ..TWELVE
};

/// Maximum absolute difference between corresponding marker coordinates of two datasets, m.
fn apart(a: &Dataset, b: &Dataset) -> f64 {
    let points = |d: &Dataset| -> Vec<[f64; 3]> {
        let rows = d.flights.iter().flat_map(|f| f.positions.iter().flatten());
        rows.map(|point| point.expect("seen")).collect()
    };
    let (a, b) = (points(a), points(b));
    assert_eq!(a.len(), b.len());
    let each = a.iter().flatten().zip(b.iter().flatten());
    each.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn of_law(law: Law, plan: &SeededEffects, seed: u64) -> Dataset {
    match law {
        Law::Ball => {
            let plan_of = ball::Plan {
                flights: 4,
                ..ball::FOOTBALL
            };
            ball::dataset(&plan_of, plan, seed)
        }
        _ => dataset(&FOUR, plan, seed),
    }
}

#[test]
fn nothing_hidden_is_what_is_made_without() {
    let made = flights(&disc(), &FOUR, 5);
    assert_eq!(made, dataset(&FOUR, &SeededEffects::default(), 5));
}

#[test]
fn every_effect_shows_more_when_it_is_strong() {
    for found in effect::all() {
        let name = found.name;
        let strength = strength(name).unwrap_or_else(|| panic!("no strength of {name}"));
        assert_eq!(strength.weak.len(), found.values(), "{name}");
        assert_eq!(strength.strong.len(), found.values(), "{name}");
        for law in [Law::Disc, Law::Ball] {
            if !found.laws.contains(&law) {
                continue;
            }
            let plain = of_law(law, &SeededEffects::default(), 3);
            let shown = [strength.weak, strength.strong].map(|values| {
                apart(
                    &plain,
                    &of_law(law, &SeededEffects::listed(name, values), 3),
                )
            });
            assert!(shown[0] > 1e-5, "{name} of {law:?}: {shown:?}");
            assert!(shown[1] > 1.5 * shown[0], "{name} of {law:?}: {shown:?}");
            assert!(shown[1] < 10.0, "{name} of {law:?}: {shown:?}");
        }
    }
    let known: Vec<&str> = effect::all().map(|effect| effect.name).collect();
    for strength in STRENGTHS {
        let name = strength.effect;
        assert!(
            known.contains(&name),
            "{name} has a strength, but no reference"
        );
    }
}

#[test]
fn what_is_negligible_moves_a_throw_by_millimetres_at_most() {
    let each = effect::all().flat_map(|effect| {
        let bodies = [(Law::Disc, "disc"), (Law::Ball, "ball")];
        let laws = bodies
            .into_iter()
            .filter(|(law, _)| effect.laws.contains(law));
        laws.map(move |(law, model)| (effect, law, model))
    });
    for (found, law, model) in each {
        let name = found.name;
        let plain = of_law(law, &SeededEffects::default(), 3);
        let model = model_spec::load::load(model, &[name]).expect("a model");
        let [applied] = &model.effects[..] else {
            panic!("one effect")
        };
        let unknowns = applied.coefficients.iter().chain(&applied.states);
        for (k, unknown) in unknowns.enumerate() {
            let mut values = vec![0.0; found.values()];
            values[k] = unknown.smallest_effect_of_interest.expect("a size");
            let with = of_law(law, &SeededEffects::listed(name, &values), 3);
            let moved = apart(&plain, &with);
            assert!(
                (1e-6..3e-3).contains(&moved),
                "{name} of {law:?}: {moved} m"
            );
        }
    }
}

#[test]
fn what_is_outside_shows_too() {
    assert!(UNLISTED.len() >= 6);
    for found in UNLISTED {
        assert!(effect::by_name(found.name).is_none(), "{}", found.name);
        for law in [Law::Disc, Law::Ball] {
            if !found.laws.contains(&law) {
                continue;
            }
            let plain = of_law(law, &SeededEffects::default(), 3);
            let shown = found.strength.map(|size| {
                apart(
                    &plain,
                    &of_law(law, &SeededEffects::unlisted(found.name, size), 3),
                )
            });
            assert!(shown[0] > 1e-3, "{} of {law:?}: {shown:?}", found.name);
            assert!(
                shown[1] > 1.5 * shown[0],
                "{} of {law:?}: {shown:?}",
                found.name
            );
            assert!(shown[1] < 10.0, "{} of {law:?}: {shown:?}", found.name);
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_flights() {
    let hidden = SeededEffects {
        held_out: 1,
        ..SeededEffects::listed("wind", &[0.3, 0.1]).with_noise(Corruption::default())
    };
    let made = dataset(&FOUR, &hidden, 8);
    assert_eq!(made, dataset(&FOUR, &hidden, 8));
    assert_ne!(made, dataset(&FOUR, &hidden, 9));
    let roles: Vec<Role> = made.flights.iter().map(|flight| flight.role).collect();
    assert_eq!(roles, [Role::Fit, Role::Fit, Role::Fit, Role::HeldOut]);
}

/// Fits a model with an effect to flights that were simulated with this effect, and asserts that the estimates of the
/// effect's coefficients agree with the true values.
fn found_again(model: &str, name: &str, hidden: &Dataset, truth: &[f64]) {
    let with = model_spec::load::load(model, &[name]).expect("a model");
    let report = fit(&with, hidden, &FitOptions::default())
        .expect("a fit")
        .report;
    let names = effect::by_name(name).expect("by hand").coefficients;
    for (coefficient, truth) in names.iter().zip(truth) {
        let found = &report.coefficients[*coefficient];
        let error = (found.value - truth) / found.std_error;
        assert!(error.abs() < 4.0, "{name}, {coefficient}: {found:?}");
        // It is well known, not merely not excluded.
        assert!(found.std_error < 0.5 * truth.abs(), "{name}: {found:?}");
    }
}

#[test]
fn the_fit_finds_what_is_hidden() {
    for name in [
        "zero_lift_drag_angle",
        "constant_pitching_moment",
        "rolling_moment_by_angle",
        "stall",
        "wind",
        "scale",
        "tilted_vertical",
        "side_force_by_spin",
        "marker_2_misplaced",
        "marker_time_offset",
        "clock_rate",
        "mass_imbalance",
    ] {
        let strong = strength(name).expect("a strength").strong;
        let hidden = SeededEffects::listed(name, strong).with_noise(Corruption::default());
        found_again("disc", name, &dataset(&TWELVE, &hidden, 21), strong);
    }
}

#[test]
fn the_fit_finds_the_wind_of_each_flight() {
    let hidden = SeededEffects::listed("wind_of_each_flight", &[0.5, 0.5]);
    let made = dataset(&TWELVE, &hidden.with_noise(Corruption::default()), 23);
    let with = model_spec::load::load("disc", &["wind_of_each_flight"]).expect("a model");
    let fitted = |model| {
        let fitted = fit(model, &made, &FitOptions::default());
        fitted.expect("a fit").report
    };
    let (plain, report) = (fitted(&disc()), fitted(&with));
    let over = [plain.rms(), report.rms()].map(|rms| rms / 0.0015);
    assert!((over[1] - 1.0).abs() < 0.03, "{over:?}");
    assert!(over[0] > 1.02 * over[1], "{over:?}");
    let gusts = report.flights.iter().map(|f| f.initial["gust_y"].value);
    let spread = (gusts.map(|gust| gust * gust).sum::<f64>() / 12.0).sqrt();
    assert!((0.2..1.2).contains(&spread), "{spread}");
}

#[test]
fn the_fit_finds_what_is_hidden_in_flights_of_a_ball() {
    for (name, plan) in [
        ("magnus", &ball::TABLE_TENNIS),
        ("drag_crisis", &ball::FOOTBALL),
        ("spin_decay", &ball::TABLE_TENNIS),
    ] {
        let strong = strength(name).expect("a strength").strong;
        let hidden = SeededEffects::listed(name, strong).with_noise(Corruption::default());
        found_again("ball", name, &ball::dataset(plan, &hidden, 22), strong);
    }
}
