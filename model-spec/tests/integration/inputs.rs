//! Scalar inputs: how they are written, what they may not do, and effects that replace them.

use model_spec::compose::ModelTree;
use model_spec::load::from_text;
use model_spec::model::Model;

const SLED: &str = "
model sled;
param m = 2 kg;
input thrust: N = 1;
input angle: deg = 90 in 0 .. 180;
frame N;
point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force push = thrust*sin(angle)*N.1;
limit thrust > -5 N \"it is pulled\";
";

fn sled(more: &str) -> Result<Model, String> {
    from_text("sled.hyz", &format!("{SLED}{more}"), &[]).map_err(|error| error.to_string())
}

#[test]
fn a_scalar_input_is_a_parameter_that_varies() {
    let model =
        sled("input share = 0.5;\ninput area: [1] = 1;\ninput force = 3 N;").expect("a model");
    let inputs: Vec<_> = model.params.iter().filter(|own| own.varies).collect();
    let told: Vec<_> = inputs
        .iter()
        .map(|own| (own.name.as_str(), own.value, own.bounds))
        .collect();
    let pi = std::f64::consts::PI;
    let expected = [
        ("thrust", 1.0, None),
        ("angle", pi / 2.0, Some((0.0, pi))),
        ("share", 0.5, None),
        ("area", 1.0, None),
        ("force", 3.0, None),
    ];
    assert_eq!(told, expected);
    let text = ModelTree::of(&model).to_text("");
    for statement in [
        "input thrust: N = 1;",
        "input angle: deg = 90 in 0 .. 180;",
        "input force: N = 3;",
    ] {
        assert!(text.contains(statement), "{text}");
    }
    let again = from_text("again.hyz", &text, &[]).expect("the same model");
    assert_eq!(ModelTree::of(&again).to_text(""), text);
}

#[test]
fn what_an_input_may_not_do_is_told() {
    for (more, told) in [
        ("input a: N = 2 kg;", "the unit is stated twice"),
        ("input a: N;", "expected `=` and the default of the input"),
        ("input a: N = b;", "a number"),
        ("input thrust: N = 1;", "thrust"),
        ("let inverse = 1/thrust;", "which may be zero"),
        ("input a: N = 5 in 0 .. 1;", "lies outside its bounds"),
        ("force more = angle*N.1;", "must be in N"),
    ] {
        let error = sled(more).expect_err(more);
        assert!(error.contains(told), "{more}: {error}");
    }
    sled("input voltage: V = 4 in 3 .. 5;\nlet inverse = 1/voltage;")
        .expect("bounds keep it above 0");
    let mass = SLED.replace("param m = 2 kg;", "input m: kg = 2;");
    let error = from_text("sled.hyz", &mass, &[])
        .expect_err("a mass that varies")
        .to_string();
    assert!(error.contains("must not change during a flight"), "{error}");
}

#[test]
fn effects_replace_an_input_where_it_is_used_and_add_up() {
    let base = ModelTree::of(&sled("").expect("a model"));
    let names = [
        "bias_of_thrust",
        "scale_of_thrust",
        "delay_of_thrust",
        "lag_of_thrust",
        "bias_of_angle",
    ];
    let model = base
        .with_named(names)
        .expect("they go together")
        .check()
        .expect("a model");
    let text = ModelTree::of(&model).to_text("");
    assert!(text.contains("limit thrust_acting > -5 N"), "{text}");
    assert!(
        text.contains("thrust_acting*sin(angle_acting)*N.1"),
        "{text}"
    );
    // Delay and lag are of what was recorded, in whichever order the effects are switched on.
    let lines = [
        "let thrust_acting = (thrust_in_time + k_bias_of_thrust)*(1 + k_scale_of_thrust);",
        "let thrust_in_time = thrust - k_delay_of_thrust*thrust_rate - k_lag_of_thrust*thrust_lagging;",
    ];
    let late_first = base.with_named(["delay_of_thrust", "lag_of_thrust", "bias_of_thrust"]);
    let late_first = late_first.and_then(|tree| tree.with_named(["scale_of_thrust"]));
    let late_first = late_first.expect("they go together").to_text("");
    for line in lines {
        assert!(text.contains(line), "{text}");
        assert!(late_first.contains(line), "{late_first}");
    }
    let again = from_text("extended.hyz", &text, &[]).expect("what is written is a model");
    // A model with the rate as an input of its own is not given another.
    let own =
        sled("input thrust_rate: N/s = 0;\nforce more = thrust_rate*0 [s]*N.1;").expect("a model");
    let own = ModelTree::of(&own)
        .with_named(["delay_of_thrust"])
        .expect("it fits");
    assert_eq!(own.to_text("").matches("input thrust_rate").count(), 1);
    for of_an_effect in ["bias_of_thrust_rate", "bias_of_thrust_lagging"] {
        assert!(ModelTree::of(&again).find_effect(of_an_effect).is_err());
    }
}
