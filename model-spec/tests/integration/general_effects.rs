//! What any model gets: effects bound by what it has, and what is said where one does not fit.

use model_spec::compose::{EffectTree, KnownEffect, ModelTree, Origin, known_effects};
use model_spec::load::{self, EFFECTS, MODELS, from_text};
use model_spec::model::Model;

/// Test models of kinds of bodies that are not built in, each with the minimum number of built-in effects that must be
/// applicable to it.
const OWN: [(&str, usize); 6] = [
    ("shuttlecock", 15),
    ("pendulum", 10),
    ("spinning_ball", 25),
    ("quaternion_dart", 25),
    ("glider", 10),
    ("kite", 5),
];

fn own(name: &str) -> ModelTree {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../studies/models");
    ModelTree::load(&format!("{folder}/{name}.hyz")).unwrap_or_else(|error| panic!("{error}"))
}

fn candidates(model: &Model) -> Vec<KnownEffect> {
    let known = known_effects(model).into_iter();
    known.filter(|known| known.refused.is_none()).collect()
}

fn names(candidates: &[KnownEffect]) -> Vec<&str> {
    candidates.iter().map(|k| k.effect.name()).collect()
}

#[test]
fn any_model_gets_candidates_that_can_be_applied_alone_and_together() {
    for (name, least) in OWN {
        let tree = own(name);
        let offered = candidates(&tree.check().unwrap());
        assert!(offered.len() >= least, "{name}: {:?}", names(&offered));
        let mut all = tree.clone();
        for known in &offered {
            let alone = tree.with(&known.effect).and_then(|with| with.check());
            let alone = alone.unwrap_or_else(|error| panic!("{name}:\n{error}"));
            let effect = &alone.effects[0];
            for own in &effect.coefficients {
                assert_eq!(own.null_value, 0.0, "{}", effect.name);
                assert!(own.smallest_effect_of_interest.is_some_and(|n| n > 0.0));
            }
            assert!(!effect.variables.is_empty() && !effect.doc.is_empty());
            all = all
                .with(&known.effect)
                .unwrap_or_else(|e| panic!("{name}:\n{e}"));
        }
        let model = all
            .check()
            .unwrap_or_else(|error| panic!("{name}:\n{error}"));
        assert_eq!(model.effects.len(), offered.len());
        // What was composed is a file of its own.
        let text = all.to_text("");
        let read = from_text("all.hyz", &text, &[]).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(read.coefficients.len(), model.coefficients.len());
    }
}

#[test]
fn the_built_in_bodies_keep_the_effects_of_their_own() {
    // The distortion of a lens and the turns of attitudes and of a template are in no body's own list.
    let of_attitude = &["attitude_turned", "lens_distortion", "template_tilt"][..];
    for (model, count, general) in [
        ("disc", 35, of_attitude),
        ("disc_quaternion", 35, of_attitude),
        ("discus", 32, of_attitude),
        ("ball", 12, &["lens_distortion"]),
    ] {
        let offered = candidates(&load::load(model, &[]).unwrap());
        let specific = offered.iter().filter(|k| k.origin == Origin::Specific);
        let specific = specific.count();
        assert!(
            specific >= count,
            "{model} lost effects: {:?}",
            names(&offered)
        );
        let others = offered.iter().filter(|k| k.origin != Origin::Specific);
        let others: Vec<&str> = others.map(|k| k.effect.name()).collect();
        assert_eq!(others, general, "{model}");
    }
    // By what it is, and not by its name.
    let disc = MODELS.iter().find(|(name, _)| *name == "disc").unwrap().1;
    let other = disc.replace("model disc;", "model my_disc;");
    let model = from_text("my_disc.hyz", &other, &[]).unwrap();
    let of_disc = candidates(&load::load("disc", &[]).unwrap());
    assert_eq!(names(&candidates(&model)), names(&of_disc));
}

#[test]
fn every_built_in_effect_is_read_and_generalises_others_that_exist() {
    let all = EffectTree::built_in();
    assert_eq!(all.len(), EFFECTS.len());
    for effect in all {
        for narrower in effect.generalises() {
            let name = effect.name();
            let mut others = all.iter().filter(|other| other.name() != name);
            let found = others.find(|other| other.name() == narrower);
            // What generalises each other would leave neither.
            let is_narrower = found.is_some_and(|own| !own.generalises().any(|back| back == name));
            assert!(is_narrower, "{name} generalises `{narrower}`");
        }
    }
}

const STONE: &str = "\
model stone;
param m = 0.5 kg;
frame E;
point stone { mass 2*m; position (x, y, z) in E; velocity (vx, vy, vz) in E; }
let speed = norm(velocity);
let turned = (0, 0, 1 [m/s]) in E;
observe seen = position + tag;
marker tag in E;
";

fn refused(effects: &str, name: &str) -> String {
    let text = format!("{STONE}{effects}");
    from_text("stone.hyz", &text, &[name])
        .unwrap_err()
        .to_string()
}

#[test]
fn an_effect_speaks_of_mass_frames_and_observation_of_any_model() {
    let effect = "effect push { site drag; needs vector air: m/s or velocity; coefficient k = 0 m/s^2;\n\
        force push = mass*k*inertial.1 + 0*mass*k*in_inertial(unit(air)); replace observe = previous + k*(1 [s^2])*inertial.2; }";
    let stone = STONE.replace("(0, 0, 1 [m/s]) in E", "velocity");
    let model = from_text("stone.hyz", &format!("{stone}{effect}"), &["push"]);
    let model = model.unwrap_or_else(|error| panic!("{error}"));
    let text = ModelTree::of(&model).to_text("");
    assert!(text.contains("force push = 2*m*k*E.1"), "{text}");
    assert!(
        text.contains("observe seen = position + tag + k*"),
        "{text}"
    );
    assert!(text.contains("in_E(unit(velocity))"), "{text}");
}

#[test]
fn what_a_model_lacks_is_said_by_name_kind_and_unit() {
    let needs = |what: &str| {
        format!(
            "effect f {{ needs {what}; site drag; coefficient k = 0 [1]; replace speed = previous*(1 + k); }}"
        )
    };
    let stone = |text: &str| text.replace("turned = (0, 0, 1 [m/s]) in E", "turned = velocity");
    for (what, says) in [
        (
            "vector air_velocity: m/s",
            "needs a vector `air_velocity` in m/s, and the model has none",
        ),
        (
            "speed: m",
            "needs `speed` as a number in m, but in this model it is a number in m/s",
        ),
        ("vector speed: m/s", "needs `speed` as a vector"),
    ] {
        let text = stone(&format!("{STONE}{}", needs(what)));
        let error = from_text("stone.hyz", &text, &["f"])
            .unwrap_err()
            .to_string();
        assert!(error.contains(says), "{error}");
    }
    let fine = stone(&format!(
        "{STONE}{}",
        needs("speed: km/h, vector velocity: m/s")
    ));
    from_text("stone.hyz", &fine, &["f"]).unwrap_or_else(|error| panic!("{error}"));
    let error = refused(
        "effect t { site roll; coefficient k = 0 N*m; moment t = k*body.1; }",
        "t",
    );
    assert!(error.contains("a moment cannot act on a point"), "{error}");
}

#[test]
fn a_rate_is_added_to_a_stated_equation() {
    let glider = own("glider");
    let effect = glider.find_effect("rate-of-V-by-time").unwrap();
    let model = glider.with(&effect).unwrap().check().unwrap();
    let added = model.coefficients.last().unwrap();
    assert_eq!(
        (added.name.as_str(), added.unit_text.as_str()),
        ("k_rate_of_V_by_time", "m/s^3")
    );
    let text = ModelTree::of(&model).to_text("");
    assert!(
        text.contains("der(V) = -drag/m - g*sin(gamma) + k_rate_of_V_by_time*time"),
        "{text}"
    );
    // An equation that only names a rate has none.
    let kite = own("kite");
    assert!(kite.find_effect("rate-of-beta").is_err());
    assert!(kite.find_effect("rate-of-betadot").is_ok());
}

/// A rate that is added to a component takes a quaternion off the unit sphere, where it orients no frame.
#[test]
fn no_rates_are_added_to_quaternions() {
    let text = "model spin; frame N; frame C = N by quaternion (q0, q1, q2, q3); param p = 3 rad/s;
        state q0 = 1; state q1 = 0; state q2 = 0; state q3 = 0; state v = 0 m/s;
        der(q0) = -q1*p/2; der(q1) = q0*p/2; der(q2) = q3*p/2; der(q3) = -q2*p/2;
        der(v) = in_N(C.1).2*(1 [m/s^2]);";
    let tree = ModelTree::of(&from_text("spin.hyz", text, &[]).unwrap());
    assert!(tree.find_effect("rate-of-q1").is_err());
    assert!(tree.find_effect("rate-of-v").is_ok());
}

#[test]
fn moments_of_inertia_are_added_to() {
    for (name, entry) in [
        ("spinning_ball", "I_l + I_l*inertia_1_error"),
        ("quaternion_dart", "I_a + I_a*inertia_1_error"),
    ] {
        let tree = own(name);
        let both = tree
            .with_named(["unequal-inertia", "tilted-inertia"])
            .unwrap();
        both.check().unwrap_or_else(|error| panic!("{error}"));
        let text = both.to_text("");
        assert!(text.contains(entry), "{text}");
    }
}
