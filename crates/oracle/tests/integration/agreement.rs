//! Two oracles that share no formula agree: the law by hand, and the vector tree.

use model_spec::load::load;
use model_spec::model::{FrameKind, Model};
use oracle::scalar::{ComplexStep, ErrorBound, NumDual, Real};
use oracle::{Chart, Point, Reference, Tree, derivatives};
use proptest::prelude::*;

/// Loads a built-in model; `discus` is always compared with its reference law, even if its model file does not name
/// one.
fn model(name: &str) -> Model {
    let mut model = load(name, &[]).unwrap();
    if name == "discus" {
        model.reference = Some("frohlich_discus".into());
    }
    model
}

/// Converts random numbers `draws`, between -1 and 1, to a point (states, parameters, inputs and marker position) of a
/// model.
fn point(model: &Model, draws: &[f64]) -> Point<f64> {
    let mut draws = draws.iter().cycle();
    let mut draw = || *draws.next().unwrap();
    let mut point = Point::defaults(model);
    for (state, value) in model.states.iter().zip(&mut point.states) {
        *value = draw() * if state.unit_text == "rad" { 1.3 } else { 12.0 };
    }
    for value in point.params.iter_mut().chain(&mut point.coefficients) {
        *value *= draw().exp();
    }
    normalise(model, &mut point);
    for input in &mut point.inputs {
        *input = input.map(|_| 5.0 * draw());
    }
    point.marker = point.marker.map(|_| 0.1 * draw());
    point
}

fn normalise(model: &Model, point: &mut Point<f64>) {
    for frame in &model.frames {
        if let FrameKind::Quaternion { states, .. } = frame.kind {
            let length = states
                .iter()
                .map(|&i| point.states[i].powi(2))
                .sum::<f64>()
                .sqrt();
            states.into_iter().for_each(|i| point.states[i] /= length);
        }
    }
}

fn draws() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1.0..1.0, 53)
}

proptest! {
    #[test]
    fn law_and_tree_agree(draws in draws()) {
        for name in ["disc", "ball", "discus", "disc_quaternion", "disc_appendix"] {
            let model = model(name);
            let point = point(&model, &draws);
            let reference = Reference::bind(&model).unwrap().unwrap();
            let by_hand = reference.derivatives(&point.lift::<ErrorBound>());
            for (i, expected) in by_hand.iter().enumerate() {
                let got = derivatives(&model, &point).unwrap()[i];
                prop_assert!(expected.relative_error(got) < 1e-14, "{name} der({})", model.states[i].name);
            }
            let seen = Tree::new(&model, &point).vector(&model.observation.as_ref().unwrap().value);
            prop_assert!((seen - reference.observation(&point)).norm() < 1e-13);
        }
    }

    #[test]
    fn states_come_back_from_the_physical_state(draws in draws()) {
        for name in ["disc", "ball", "discus", "disc_quaternion"] {
            let model = model(name);
            let states = point(&model, &draws).states;
            let chart = Reference::bind(&model).unwrap().unwrap().chart;
            prop_assert_eq!(Chart::declared(&model).unwrap(), chart.clone());
            let back = chart.states(&chart.physical(&states)).unwrap();
            for (a, b) in states.iter().zip(&back) {
                prop_assert!((a - b).abs() < 1e-10, "{states:?} {back:?}");
            }
        }
    }

    #[test]
    fn dual_numbers_and_complex_steps_agree(draws in draws()) {
        let model = model("disc");
        let point = point(&model, &draws);
        for j in 0..model.states.len() {
            let mut dual = point.lift::<NumDual>();
            dual.states[j] = NumDual::new(point.states[j], 1.0);
            let mut step = point.lift::<ComplexStep>();
            step.states[j] = ComplexStep::new(point.states[j], 1.0);
            let pairs = derivatives(&model, &dual).unwrap().into_iter().zip(derivatives(&model, &step).unwrap());
            for (a, b) in pairs {
                prop_assert!((a.derivative() - b.derivative()).abs() <= 1e-9 * (1.0 + a.derivative().abs()));
                prop_assert!((a.re() - b.re()).abs() <= 1e-9 * (1.0 + a.re().abs()));
            }
        }
    }
}

#[test]
fn at_rest_nothing_is_lost() {
    let model = model("disc");
    let point = Point::defaults(&model).lift::<NumDual>();
    let reference = Reference::bind(&model).unwrap().unwrap();
    for rate in derivatives(&model, &point)
        .unwrap()
        .into_iter()
        .chain(reference.derivatives(&point))
    {
        assert!(rate.re().is_finite() && rate.derivative().is_finite());
    }
}

#[test]
fn what_a_reference_misses_is_told() {
    let text = "model a; reference hubbard_hummel_disc; param m = 1 kg;
        input wind in N = (0, 0, 0) m/s; frame N;
        point p { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
        force weight = -m*9.81 [m/s^2]*N.3;";
    let model = model_spec::load::from_text("a", text, &[]).unwrap();
    let why = Reference::bind(&model).unwrap().unwrap_err();
    assert_eq!(why.to_string(), "`I_a` is not declared");
}

#[test]
fn a_wind_in_body_axes_is_no_wind_of_the_reference() {
    let disc = include_str!("../../../../model-spec/models/disc.hyz");
    let turned = disc.replacen("input wind in N", "input wind in B", 1);
    assert_ne!(disc, turned);
    let model = model_spec::load::from_text("disc.hyz", &turned, &[]).unwrap();
    let why = Reference::bind(&model).unwrap().unwrap_err();
    assert_eq!(
        why.to_string(),
        "the input `wind` is declared in the frame `B`; the reference expects it in the inertial frame"
    );
}
