//! What effects may add to a model, under every check: states of each flight, a clock, products of inertia.

use crate::support::{QUICK, built_in, refuted, row};
use model_spec::load::{Loaded, inspect_text};
use verify::checks::{cases, derivatives, effects, exact, identities, metamorphic, reference};
use verify::flights::{INVARIANTS, MOMENTA};
use verify::report::{Report, Verdict};

/// Loads a built-in model with the effect declarations `text` appended, and applies the effects named in `effects`.
fn with(name: &str, text: &str, effects: &[&str]) -> Loaded {
    let own = built_in(name).sources[0].text.clone();
    let loaded = inspect_text(name, &(own + text), effects).unwrap();
    assert!(
        loaded.diagnostics.is_empty(),
        "{name}: {:#?}",
        loaded.diagnostics
    );
    loaded
}

fn report(name: &str, text: &str, effects: &[&str]) -> Report {
    verify::run(&with(name, text, effects), &QUICK)
}

/// Report on a built-in model whose file text was printed after the effect `effect` had been merged into its
/// statements.
fn written_in(name: &str, effect: &str) -> Report {
    let text = with(name, "", &[effect]).file.to_string();
    verify::run(&inspect_text("own.hyz", &text, &[]).unwrap(), &QUICK)
}

/// Text of an effect that adds a wind with two states: W_x is constant, and W_y decays with a time constant of 2 s.
/// `velocity` is the new expression for the air velocity.
fn wind(velocity: &str) -> String {
    format!(
        "effect gust {{ site wind; state W_x = 0 m/s; state W_y = 0 m/s;\n\
         der(W_x) = 0; der(W_y) = -W_y/(2 s);\n\
         replace air_velocity = {velocity}; }}\n"
    )
}

#[test]
fn states_of_each_flight_pass_every_check() {
    for (name, velocity) in [
        ("ball", "previous - (W_x, W_y, 0) in N"),
        ("disc", "previous - in_B((W_x, W_y, 0) in N)"),
        ("disc_quaternion", "previous - in_C((W_x, W_y, 0) in N)"),
        ("disc_appendix", ""),
    ] {
        let report = match velocity {
            // Its equations are stated, and use no vector for the velocity.
            "" => report(
                name,
                "effect gust { site unknown; state c = 0; der(c) = -c/(1 s); replace C_D = previous + c; }\n",
                &["gust"],
            ),
            velocity => report(name, &wind(velocity), &["gust"]),
        };
        assert!(refuted(&report).is_empty(), "{name}\n{}", report.table());
        assert!(report.refuted.is_empty(), "{name}: {:?}", report.refuted);
        for check in [reference::REFERENCE, reference::TREE, effects::EFFECTS] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Holds,
                "{name} {check}"
            );
        }
    }
}

#[test]
fn a_state_that_acts_at_its_default_is_no_effect_that_is_off() {
    let acts = wind("previous - (W_x + 1 [m/s], W_y, 0) in N");
    let report = report("ball", &acts, &["gust"]);
    let off = row(&report, effects::EFFECTS);
    assert_eq!(off.verdict, Verdict::Refuted, "{}", report.table());
}

const CLOCK: &str = "effect rate { site clock; coefficient c = 0 in -0.5 .. 0.5; coefficient by_z = 0 /m;\n\
    replace clock = previous/(1 + c) + by_z*z; }\n";

#[test]
fn what_is_off_costs_nothing_beside_an_effect_that_is_written_in() {
    for effect in ["magnus", "spin_decay", "drag_crisis"] {
        let report = written_in("ball", effect);
        let off = row(&report, effects::EFFECTS);
        assert_eq!(off.verdict, Verdict::Holds, "{effect}\n{}", report.table());
    }
}

#[test]
fn effects_agree_with_their_references_in_models_with_added_states() {
    for model in ["ball", "disc"] {
        let report = written_in(model, "wind_of_each_flight");
        assert!(refuted(&report).is_empty(), "{model}\n{}", report.table());
    }
}

#[test]
fn a_clock_passes_every_check() {
    for name in ["ball", "disc", "disc_quaternion", "disc_appendix", "discus"] {
        let report = report(name, CLOCK, &["rate"]);
        assert!(refuted(&report).is_empty(), "{name}\n{}", report.table());
        for check in [reference::TREE, effects::EFFECTS, derivatives::CHECKS[2]] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Holds,
                "{name} {check}"
            );
        }
    }
}

#[test]
fn laws_of_motion_are_checked_in_the_seconds_of_the_flight() {
    // A case expects what is measured, and this one has a clock of its own.
    let text = "param pace = 1.25;\nclock pace;\n\
        check \"twice the clock, twice as far\" { set pace = 2; set vx = 3 m/s; expect der(x) = 6 m/s within 1e-12; }\n";
    for name in ["disc", "disc_quaternion"] {
        let text = if name == "disc" {
            text.replace("vx", "u")
        } else {
            text.to_owned()
        };
        // Its other cases say what is so where the clock keeps to the flight.
        let report = report(name, &text, &[]);
        for check in [
            reference::REFERENCE,
            reference::TREE,
            identities::IDENTITIES,
            metamorphic::METAMORPHIC,
            exact::EXACT,
            derivatives::CHECKS[3],
        ] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Holds,
                "{name} {check}\n{}",
                report.table()
            );
        }
        for check in [INVARIANTS, MOMENTA] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Skipped,
                "{name} {check}"
            );
        }
        let own = &row(&report, cases::CASES).detail;
        assert!(!own.contains("twice"), "{own}");
    }
}

/// Text of an effect that adds products of inertia, constant in the body-fixed frame, to a disc.
const WOBBLE: &str = "effect wobble { site inertia; coefficient I_13 = 0 kg*m^2 in -1e-4 .. 1e-4;\n\
    coefficient I_23 = 0 kg*m^2 in -1e-4 .. 1e-4; coefficient more = 0 in -0.5 .. 0.5;\n\
    replace inertia ((I_d*(1 + more), 0, I_13), (0, I_d, I_23), (I_13, I_23, I_a)) in C; }\n";

#[test]
fn products_of_inertia_in_the_frame_of_the_disc_pass_every_check() {
    for name in ["disc", "disc_quaternion", "discus"] {
        let report = report(name, WOBBLE, &["wobble"]);
        assert!(refuted(&report).is_empty(), "{name}\n{}", report.table());
        for check in [
            reference::TREE,
            effects::EFFECTS,
            exact::EXACT,
            derivatives::CHECKS[2],
        ] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Holds,
                "{name} {check}"
            );
        }
    }
}

/// Loads a variant of the disc model without a reference law and with a full inertia tensor; its angular velocity has
/// its components in the frame `seen`.
fn unbalanced(seen: &str) -> Loaded {
    let text = built_in("disc").sources[0].text.clone();
    let body = format!(
        "inertia ((I_d, I_12, I_13), (I_12, I_2, I_23), (I_13, I_23, I_a)) in C;\n angular velocity in {seen};"
    );
    // Effects of the catalogue that give the disc an inertia of theirs are not for this one.
    let text = text
        .replace("model disc;", "model unbalanced;")
        .replace("reference hubbard_hummel_disc;", "")
        .replace("inertia diag(I_d, I_d, I_a) in B;", &body)
        + "param I_2 = 0.0015 kg*m^2;\nparam I_12 = -0.0001 kg*m^2;\n\
           param I_13 = 0.0002 kg*m^2;\nparam I_23 = 0.0003 kg*m^2;\n";
    // What the model takes along axes of B it now takes along those of the frame it is seen in.
    let text = text.replace("dot(angular_velocity, d", "dot(in_B(angular_velocity), d");
    let loaded = inspect_text("unbalanced", &text, &[]).unwrap();
    assert!(loaded.diagnostics.is_empty(), "{:#?}", loaded.diagnostics);
    loaded
}

#[test]
fn an_unbalanced_disc_keeps_energy_and_angular_momentum() {
    for seen in ["C", "B", "A", "N"] {
        let report = verify::run(&unbalanced(seen), &QUICK);
        assert!(refuted(&report).is_empty(), "{seen}\n{}", report.table());
        let told = &row(&report, metamorphic::METAMORPHIC).detail;
        assert!(told.contains("the body is not symmetric"), "{told}");
        for check in [
            reference::TREE,
            identities::IDENTITIES,
            INVARIANTS,
            exact::EXACT,
        ] {
            assert_eq!(
                row(&report, check).verdict,
                Verdict::Holds,
                "{seen} {check}"
            );
        }
    }
}
