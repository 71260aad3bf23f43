use super::*;
use crate::layout::Layout;
use crate::tape_model::{At, Scratch, TapeModel};

fn load(name: &str) -> Model {
    model_spec::load::load(name, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// Pseudorandom states between 0.3 and 1.1 (in their SI units), and parameters up to 20 % above their defaults in
/// magnitude, or between 0 and 0.3 where the default is 0. The tested models are valid for these values.
fn point(layout: &Layout) -> (Vec<f64>, Vec<f64>) {
    let mut seed = 7_u64;
    let mut next = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let states = layout.states.iter().map(|_| 0.3 + 0.8 * next()).collect();
    let defaults = layout.default_parameters();
    let parameters = defaults
        .iter()
        .map(|value| value * (1.0 + 0.2 * next()) + if *value == 0.0 { 0.3 * next() } else { 0.0 })
        .collect();
    (states, parameters)
}

fn values(tape: &TapeModel, count: usize, x: &[f64], p: &[f64]) -> Vec<f64> {
    let prepared = tape.prepare(p);
    let at = At {
        t: 0.3,
        x,
        p,
        prepared: &prepared,
    };
    let mut q = vec![0.0; count];
    tape.quantities
        .eval(at, &[], &mut Scratch::default(), &mut [&mut q]);
    q
}

/// Checks that the generated code and the LaTeX formula of every derivative of every quantity of a model agree with
/// finite differences.
fn derivatives_agree_with_differences(model: &Model) {
    let layout = Layout::new(model);
    let (x, p) = point(&layout);
    // Marker-dependent variables are not computed without a marker.
    let lets = model
        .aux_variables
        .iter()
        .zip(crate::layout::is_unlisted(model));
    let lets = lets.filter(|(_, of_marker)| !of_marker);
    let mut quantities: Vec<String> = lets.map(|(l, _)| l.name.clone()).collect();
    quantities.extend(model.states.iter().map(|s| format!("der({})", s.name)));
    quantities.extend(model.forces.iter().map(|l| format!("force {}", l.name)));
    quantities.extend(model.moments.iter().map(|l| format!("moment {}", l.name)));
    let wrt: Vec<&String> = layout.states.iter().chain(&layout.parameters).collect();
    for quantity in &quantities {
        let found = find::quantity(model, quantity).unwrap_or_else(|e| panic!("{e}"));
        let count = found.nodes.len();
        let plain = TapeModel::new(&code::generate(&found, None).compiled);
        for (k, name) in wrt.iter().enumerate() {
            let symbol = find::symbol(model, name).unwrap_or_else(|e| panic!("{e}"));
            let made = code::generate(&found, Some((symbol, name)));
            let tape = TapeModel::new(&made.compiled);
            let mut exact = vec![0.0; count];
            let entries = values(&tape, made.rows.len(), &x, &p);
            for (&row, entry) in made.rows.iter().zip(entries) {
                exact[row as usize] = entry;
            }
            let written = written(model, &found, symbol, &x, &p);
            let moved = |step: f64| {
                let (mut x, mut p) = (x.clone(), p.clone());
                match k.checked_sub(x.len()) {
                    None => x[k] += step,
                    Some(k) => p[k] += step,
                }
                values(&plain, count, &x, &p)
            };
            let size = match k.checked_sub(x.len()) {
                None => x[k].abs(),
                Some(k) => p[k].abs(),
            };
            let h = 1e-4 * size.max(1e-8);
            let (low, high) = (moved(-h), moved(h));
            let (lower, higher) = (moved(-2.0 * h), moved(2.0 * h));
            for row in 0..count {
                let difference =
                    (8.0 * (high[row] - low[row]) - (higher[row] - lower[row])) / (12.0 * h);
                let scale = difference
                    .abs()
                    .max(1e-6 * high[row].abs() / size.max(1e-8))
                    .max(1e-9);
                for value in [exact[row], written[row]] {
                    assert!(
                        (value - difference).abs() <= 2e-5 * scale,
                        "{}: {quantity}[{row}] by {name}: {value} is not {difference}",
                        model.name
                    );
                }
            }
        }
    }
}

/// Declares, for each model name, one test of the derivatives, so that the models are tested on several threads.
macro_rules! derivatives_agree_with_differences {
    ($($model:ident),*) => {
        mod derivatives_agree_with_differences {
            $(#[test]
            fn $model() {
                super::derivatives_agree_with_differences(&super::load(stringify!($model)));
            })*
        }
    };
}

derivatives_agree_with_differences!(disc, disc_appendix, disc_quaternion, ball, discus);

/// Values of the derivatives of the components of a quantity with respect to `symbol`, at the states `x` and parameters
/// `p`, computed from the graph nodes from which the LaTeX formulas are written.
fn written(
    model: &Model,
    found: &find::FoundQuantity,
    symbol: crate::graph::Symbol,
    x: &[f64],
    p: &[f64],
) -> Vec<f64> {
    let mut cut = chain::Cut::new(model, &found.compiler.lowered.graph, &found.nodes);
    cut.by = symbol;
    let roots = cut.roots.clone();
    let nodes: Vec<_> = roots
        .into_iter()
        .map(|root| {
            let inside = cut.inside(root);
            cut.derivative(inside)
        })
        .collect();
    let mut compiler = found.compiler.clone();
    compiler.lowered.graph = cut.graph;
    let names = found.names.clone();
    let found = find::FoundQuantity {
        nodes,
        names,
        compiler,
        label: String::new(),
        place: String::new(),
        line: String::new(),
        doc: String::new(),
        latex: None,
        symbols: Vec::new(),
    };
    let made = code::generate(&found, None);
    values(&TapeModel::new(&made.compiled), found.nodes.len(), x, p)
}

#[test]
fn explanations_of_the_disc() {
    let disc = load("disc");
    let mut text = String::new();
    for (quantity, wrt) in [
        ("alpha", None),
        ("alpha", Some("w")),
        ("lift", Some("wind_x")),
        ("roll", Some("C_Mq")),
        ("d1", Some("u")),
        ("force aero", None),
        ("der(u)", None),
        ("der(phidot)", Some("I_a")),
        ("C_L", Some("gamma")),
    ] {
        let mut explained = explain(&disc, quantity, wrt).unwrap_or_else(|e| panic!("{e}"));
        // Omits the generated code, which other tests cover.
        explained.once = String::new();
        explained.code = "…".into();
        explained.cost = Count::default();
        text.push_str(&format!("{explained}\n----\n\n"));
    }
    insta::assert_snapshot!("disc", text);
}

#[test]
fn code_is_what_the_quantity_needs_and_no_more() {
    let disc = load("disc");
    let explained = explain(&disc, "C_L", Some("C_La")).unwrap_or_else(|e| panic!("{e}"));
    assert!(explained.code.contains("atan2"), "{explained}");
    assert!(
        explained.code.contains("// disc.hyz:82  let alpha = "),
        "{explained}"
    );
    for foreign in ["values[", "state[", "wind_x;", "C_D", "T: Real"] {
        assert!(!explained.code.contains(foreign), "{foreign}: {explained}");
    }
    let explained = explain(&disc, "roll", Some("C_Mq")).unwrap_or_else(|e| panic!("{e}"));
    assert!(explained.once.contains("rho"), "{explained}");
    assert!(
        explained.code.contains("let d_roll_d_C_Mq = "),
        "{explained}"
    );
    assert!(explained.cost.total() > 0 && explained.cost_once.total() > 0);
}

#[test]
fn every_formula_is_well_formed() {
    for model in ["disc_appendix", "disc_quaternion", "ball", "discus"].map(load) {
        let layout = Layout::new(&model);
        let quantities = model.aux_variables.iter().map(|l| l.name.clone());
        let rates = model.states.iter().map(|s| format!("der({})", s.name));
        for quantity in quantities.chain(rates) {
            let wrt = [&layout.states[4], &layout.parameters[0]];
            for wrt in wrt {
                let explained = explain(&model, &quantity, Some(wrt));
                let explained = explained.unwrap_or_else(|error| panic!("{error}"));
                for formula in explained.latex.iter().chain(&explained.derivative) {
                    let count = |part: &str| formula.matches(part).count();
                    assert_eq!(count("{"), count("}"), "{formula}");
                    assert_eq!(count("("), count(")"), "{formula}");
                    assert_eq!(count(r"\left"), count(r"\right"), "{formula}");
                    for wrong in ["--", "+ -", "- -", "- +", "^2^", r"\cdot -", "NaN", "()"] {
                        assert!(!formula.contains(wrong), "{formula}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_component_is_named_as_in_a_model_or_as_in_its_code() {
    let disc = load("disc");
    let named = |name: &str| explain(&disc, name, None).expect("a component").to_string();
    assert_eq!(named("air_velocity.1"), named("air_velocity_1"));
}

#[test]
fn what_is_not_there_is_said_with_what_is() {
    let disc = load("disc");
    for (quantity, wrt, start) in [
        (
            "alhpa",
            None,
            "there is no quantity `alhpa`; did you mean `alpha`?\nthere are: air, rho_air,",
        ),
        (
            "u",
            None,
            "there is no quantity `u`; did you mean `der(u)`?\n",
        ),
        ("thrust", None, "there is no quantity `thrust`\n"),
        (
            "aero",
            None,
            "a force and a moment are called `aero`: write `force aero` or `moment aero`",
        ),
        (
            "alpha",
            Some("wind"),
            "there is no state, parameter, coefficient or component of an input `wind`; did you mean `wind_x`?\nthere are: x, y",
        ),
        (
            "alpha",
            Some("C_LA"),
            "there is no state, parameter, coefficient or component of an input `C_LA`; did you mean `C_La`?\n",
        ),
    ] {
        let error = explain(&disc, quantity, wrt)
            .expect_err("is not there")
            .to_string();
        assert!(error.starts_with(start), "{error}");
    }
}

/// Checks that the text that explains a quantity of a model does not grow exponentially with the number of frames in a
/// chain, because repeated subexpressions are written only once.
#[test]
fn a_chain_of_frames_is_explained_in_little_text() {
    let mut text = String::from("model chain;\nframe F0;\n");
    for k in 1..=24 {
        let axis = 1 + k % 3;
        text += &format!("state a{k} = 0.1 rad;\nder(a{k}) = 0;\n");
        text += &format!("frame F{k} = F{} turned a{k} about {axis};\n", k - 1);
    }
    text += "let v = (1, 2, 3) in F24;\nlet seen = in_F0(v);\nlet first = seen.1;\n";
    let model = model_spec::load::from_text("chain.hyz", &text, &[]).expect("a model");
    for quantity in ["first", "seen"] {
        let plain = explain(&model, quantity, None).expect("an explanation");
        let derived = explain(&model, quantity, Some("a24")).expect("an explanation");
        assert!(derived.to_string().contains("s_{1} = "), "{derived}");
        for explanation in [plain, derived] {
            let length = explanation.to_string().len();
            assert!(length < 200_000, "{length} bytes");
        }
    }
}
