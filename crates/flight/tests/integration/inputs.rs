//! Inputs over time: read from releases, interpolated, and flown exactly.

use flight::release::{Release, Vocabulary, read, read_file};
use flight::{CompiledModel, InputInterpolation, read_inputs, simulate};
use model_spec::model::Model;
use ode::{DifferentiableRhs, IntegrationOptions};

const SLED: &str = "
model sled;
param m = 2 kg;
input thrust: N = 0;
input brake = 0 in 0 .. 1;
frame N;
point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force push = (thrust*(1 - brake), 0, 0) in N;
";

const START: &str = "model = \"sled\"\nduration = 3.0\n[initial]\nx = 0.0\ny = 0.0\nz = 1.0\nvx = 1.0\nvy = 0.0\nvz = 0.0\n";

fn sled() -> Model {
    model_spec::load::from_text("sled.hyz", SLED, &[]).expect("a model")
}

fn release(inputs: &str) -> Result<Release, String> {
    let text = format!("{START}[inputs]\n{inputs}");
    let read = read("r.toml", &text, |_| Ok(Vocabulary::of(&sled())));
    read.map_err(|error| error.to_string())
}

/// x and vx at the end of a flight with these inputs.
fn end(inputs: &str) -> [f64; 2] {
    let options = IntegrationOptions::with_tolerance(1e-10);
    let flight = simulate(
        &CompiledModel::new(&sled()),
        &release(inputs).expect(inputs),
        &options,
    );
    let state = flight.expect(inputs).end_state;
    [state[0], state[3]]
}

#[test]
fn a_flight_has_the_integral_of_its_inputs() {
    let near = |found: [f64; 2], x: f64, vx: f64| {
        assert!(
            (found[0] - x).abs() < 1e-9 && (found[1] - vx).abs() < 1e-9,
            "{found:?} {x} {vx}"
        );
    };
    near(end("thrust = 4.0"), 3.0 + 9.0, 7.0);
    // A line from 0 to 6 N: a = t.
    near(
        end("thrust = { t = [0.0, 3.0], value = [0.0, 6.0] }"),
        3.0 + 4.5,
        5.5,
    );
    // A pulse of 20 m/s² for 0.1 s, shorter than a step: at 1.05 s on average, 1.95 s before the end.
    let pulse =
        "{ t = [0.0, 1.0, 1.1, 3.0], value = [0.0, 40.0, 0.0, 0.0], interpolation = \"hold\" }";
    near(end(&format!("thrust = {pulse}")), 3.0 + 2.0 * 1.95, 3.0);
    // Half of it is braked.
    let braked = format!("thrust = {pulse}\nbrake = {{ t = [0.0, 3.0], value = [0.5, 0.5] }}");
    near(end(&braked), 3.0 + 1.95, 2.0);
    // A cubic spline through a straight line is the line.
    let line = "thrust = { t = [0.0, 1.0, 2.5, 3.0], value = [0.0, 2.0, 5.0, 6.0], interpolation = \"cubic\" }";
    near(end(line), 3.0 + 4.5, 5.5);
}

#[test]
fn an_input_ends_a_flight_that_outlasts_it() {
    let short = release("thrust = { t = [0.0, 2.0], value = [0.0, 1.0] }").expect("read");
    let flown = simulate(
        &CompiledModel::new(&sled()),
        &short,
        &IntegrationOptions::default(),
    );
    let error = flown.expect_err("too short").to_string();
    assert!(
        error.contains("the input `thrust` is given only until 2 s"),
        "{error}"
    );
}

#[test]
fn wrong_inputs_are_told() {
    for (inputs, told) in [
        (
            "trust = 1.0",
            "the model has no scalar input \"trust\"; did you mean \"thrust\"?",
        ),
        (
            "thrust = \"much\"",
            "thrust is the text \"much\"; expected a number",
        ),
        ("brake = 1.5", "brake is 1.5; expected a number from 0 to 1"),
        (
            "brake = { t = [0.0, 3.0], value = [0.5, 1.5] }",
            "brake is 1.5 at 3 s; expected a number from 0 to 1",
        ),
        (
            "thrust = { t = [0.0], value = [] }",
            "thrust has 1 times and 0 values",
        ),
        (
            "thrust = { t = [1.0, 1.0], value = [0.0, 0.0] }",
            "the times of thrust have 1 after 1",
        ),
        (
            "thrust = { t = [0.0] }",
            "thrust is incomplete; expected { t = […], value = […] }",
        ),
        (
            "thrust = { t = 0.0, value = [1.0] }",
            "t is 0.0; expected a list of numbers",
        ),
        (
            "thrust = { t = [nan], value = [1.0] }",
            "t is NaN; expected a finite number",
        ),
        (
            "thrust = { file = \"none.csv\" }",
            "none.csv: found no such file; expected a table of inputs",
        ),
        (
            "thrust = { t = [0.0], value = [1.0], interpolation = \"line\" }",
            "expected linear, hold, cubic",
        ),
        (
            "thrust = { t = [0.5, 3.0], value = [1.0, 1.0] }",
            "thrust is given from 0.5 to 3 s, and the flight begins at 0 s; expected values from there on",
        ),
        (
            "thrust = 1.0\n[parameters]\nthrust = 2.0",
            "thrust is in [parameters] too; expected it only here",
        ),
        (
            "brake = 0.5\n[known]\nthrust = 2.0",
            "thrust is a scalar; expected it in [inputs]",
        ),
        (
            "thrust = { t = [0.0], values = [1.0] }",
            "unknown key \"values\" in thrust",
        ),
    ] {
        let error = release(inputs).expect_err(inputs);
        assert!(error.contains(told), "{inputs}: {error}");
    }
}

#[test]
fn a_value_of_an_input_with_a_table_would_have_no_influence() {
    let read = release("thrust = { t = [0.0, 3.0], value = [1.0, 1.0] }\nbrake = 0.5");
    let read = read.expect("a release");
    let why = read.overruled("thrust").expect("a table");
    assert!(
        why.contains("thrust has a table over time in [inputs]"),
        "{why}"
    );
    assert_eq!((read.overruled("brake"), read.overruled("m")), (None, None));
}

#[test]
fn a_table_beside_the_release_is_read_with_its_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("r.toml");
    let write = |table: &str, inputs: &str| {
        std::fs::write(folder.path().join("u.csv"), table).expect("written");
        std::fs::write(&place, format!("{START}[inputs]\n{inputs}")).expect("written");
        read_file(&place, |_| Ok(Vocabulary::of(&sled()))).map_err(|error| error.to_string())
    };
    let table = "# from the logger\nt;force;brake\n0;0;0\n\n1.5;;0\n3;6;NaN\n";
    let read = write(
        table,
        "thrust = { file = \"u.csv\", column = \"force\" }\nbrake = { file = \"u.csv\" }",
    );
    let read = read.expect("a table");
    let series = |name: &str| &read.inputs.iter().find(|own| own.0 == name).expect(name).1;
    let samples: Vec<_> = series("thrust").samples().collect();
    assert_eq!(samples, [(0.0, 0.0), (3.0, 6.0)]);
    assert_eq!(series("brake").span(), (0.0, 1.5));
    let error = write(table, "thrust = { file = \"u.csv\" }").expect_err("no such column");
    assert!(error.contains("has no column \"thrust\""), "{error}");
    let error =
        write("t,thrust\n0,1\n1,fast\n", "thrust = { file = \"u.csv\" }").expect_err("a word");
    assert!(error.contains("u.csv:3:2: found \"fast\""), "{error}");
}

#[test]
fn tables_of_inputs_are_checked() {
    for (table, told) in [
        ("", "no header"),
        ("# a comment\n\n", "no header"),
        ("a,b\n0,1\n", "no column t"),
        ("t\n0\n", "the column t alone"),
        ("t,a,a\n0,1,2\n", "a second column \"a\""),
        ("t,t,a\n0,1,2\n", "a second column \"t\""),
        ("t,a\n", "no value in the column \"a\""),
        ("t,a\n0,NaN\n1,\n", "no value in the column \"a\""),
        ("t,a\n0,1\n0,2\n", "t = 0"),
        ("t,a\n1,1\n0,2\n", "t = 0"),
        ("t,a\n,1\n", "no time"),
        ("t,a\nNaN,1\n", "no time"),
        ("t,a\n0,1,2\n", "3 cells"),
        ("t,a\n0\n", "1 cells"),
        ("t,a\n0,inf\n", "\"inf\""),
        ("t,a\n0,1e999\n", "\"1e999\""),
        ("t,a\n0,1.2.3\n", "\"1.2.3\""),
        ("t,a\n0,0x1\n", "\"0x1\""),
        ("t,a\n0,1\n700,1\n", "t = 700"),
        ("t,a\n0,\"1\n", "a quote that is not closed"),
        ("0,1\n1,2\n", "no column t"),
    ] {
        let read = read_inputs(table, InputInterpolation::Linear, |t| t);
        let fault = read.expect_err(table);
        assert!(fault.found.contains(told), "{table:?}: {fault:?}");
        assert!(
            fault.location.place().0 >= 1 && !fault.expected.is_empty(),
            "{table:?}: {fault:?}"
        );
    }
    let comma = read_inputs("t;a\n0;1,5\n", InputInterpolation::Linear, |t| t);
    assert_eq!(comma.expect("a decimal comma")[0].1.at(0.0), 1.5);
    let mixed = read_inputs("\u{FEFF}t\ta\n0\t1\n2\t3", InputInterpolation::Hold, |t| {
        t / 2.0
    });
    let (name, series) = &mixed.expect("tabs")[0];
    assert_eq!(
        (name.as_str(), series.at(0.9), series.at(1.0)),
        ("a", 1.0, 3.0)
    );
}

const ACTUATOR: &str = "
model actuator;
param m = 2 kg;
coefficient tau = 0.04 s in 0.001 .. 1;
input thrust: N = 1;
frame N;
point sled { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
state lagged = 1 N;
der(lagged) = (thrust - lagged)/tau;
force push = lagged*N.1;
";

/// Commands from 1 N, in steps, lines and curves, with intervals shorter and longer than the lag.
const COMMANDS: &str =
    "t = [0.0, 0.5, 0.52, 0.9, 2.0, 3.0], value = [1.0, 6.0, -2.0, 3.0, 0.0, 1.0]";

#[test]
fn a_lag_acts_as_the_state_that_follows_the_input() {
    let late = ["lag_of_thrust", "delay_of_thrust"];
    let with_lag = model_spec::load::from_text("sled.hyz", SLED, &late).expect("it fits");
    let actuator = model_spec::load::from_text("actuator.hyz", ACTUATOR, &[]).expect("a model");
    let options = IntegrationOptions {
        max_step: 1e-3,
        ..IntegrationOptions::with_tolerance(1e-11)
    };
    let end = |model: &Model, more: &str, inputs: &str| {
        let text = format!("{START}{more}[inputs]\nthrust = {{ {inputs} }}");
        let release = read("r.toml", &text, |_| Ok(Vocabulary::of(model))).expect("a release");
        let flight = simulate(&CompiledModel::new(model), &release, &options);
        let state = flight.expect(inputs).end_state;
        [state[0], state[3]]
    };
    for interpolation in ["linear", "hold", "cubic"] {
        let inputs = format!("{COMMANDS}, interpolation = \"{interpolation}\"");
        for tau in [0.003, 0.04, 0.7] {
            let by_effect = format!("[coefficients]\nk_lag_of_thrust = {tau}\n");
            let by_state = format!("lagged = 1.0\n[coefficients]\ntau = {tau}\n");
            let [a, b] = [
                end(&with_lag, &by_effect, &inputs),
                end(&actuator, &by_state, &inputs),
            ];
            for (a, b) in a.iter().zip(&b) {
                assert!((a - b).abs() < 1e-9, "{interpolation} {tau}: {a} {b}");
            }
        }
    }
}

#[test]
fn derivatives_by_delay_and_lag_are_those_of_what_acts() {
    let late = ["lag_of_thrust", "scale_of_thrust", "delay_of_thrust"];
    let model = model_spec::load::from_text("sled.hyz", SLED, &late).expect("they fit");
    let compiled = CompiledModel::new(&model);
    let text = format!("{START}[inputs]\nthrust = {{ {COMMANDS}, interpolation = \"cubic\" }}");
    let release = read("r.toml", &text, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let state = release.state();
    let place = |name: &str| compiled.layout().parameter(name).expect(name).index();
    let columns = ["k_delay_of_thrust", "k_lag_of_thrust"].map(place);
    let at = |t: f64, values: [f64; 2]| {
        let mut parameters = compiled.release_parameters(&release);
        parameters.constants[place("k_scale_of_thrust")] = 0.2;
        for (column, value) in columns.into_iter().zip(values) {
            parameters.constants[column] = value;
        }
        let bound = compiled.bind(parameters);
        let mut rhs = bound.rhs();
        let pattern = rhs.parameter_jacobian_pattern().to_vec();
        let (mut f, mut by_state) = (vec![0.0; 6], vec![0.0; rhs.jacobian_pattern().len()]);
        let mut by = vec![0.0; pattern.len()];
        rhs.derivative_with_jacobians(t, &state, &mut f, &mut by_state, &mut by);
        let entry = |column: usize| pattern.iter().position(|own| *own == (3, column));
        (
            f[3],
            columns.map(|column| entry(column).map_or(0.0, |k| by[k])),
        )
    };
    for (delay, lag) in [
        (0.0, 0.0),
        (0.03, 0.0),
        (0.0, 0.05),
        (0.03, 0.05),
        (-0.02, 0.4),
    ] {
        for t in [0.3, 0.515, 0.8, 1.4, 2.9] {
            let step = 1e-6;
            let exact = at(t, [delay, lag]).1;
            let by_delay = at(t, [delay + step, lag]).0 - at(t, [delay - step, lag]).0;
            // A lag is not negative.
            let by_lag = match lag > 0.0 {
                true => at(t, [delay, lag + step]).0 - at(t, [delay, lag - step]).0,
                false => {
                    4.0 * at(t, [delay, step]).0
                        - at(t, [delay, 2.0 * step]).0
                        - 3.0 * at(t, [delay, 0.0]).0
                }
            };
            for (exact, difference) in exact.into_iter().zip([by_delay, by_lag]) {
                let found = difference / (2.0 * step);
                assert!(
                    (exact - found).abs() < 1e-5 * found.abs().max(1.0),
                    "{delay} {lag} {t}: {exact} {found}"
                );
            }
        }
    }
}

#[test]
fn derivatives_by_samples_are_those_of_flights_with_other_samples() {
    let nonlinear = SLED.replace(
        "force push = (thrust*(1 - brake), 0, 0) in N;",
        "param c = 0.05 1/N;\nparam k = 0.3 kg/m;\nforce push = (thrust*(1 + c*thrust), 0, 0) in N;\nforce drag = -k*norm(velocity)*velocity;",
    );
    let late = ["lag_of_thrust", "delay_of_thrust"];
    let model = model_spec::load::from_text("sled.hyz", &nonlinear, &late).expect("they fit");
    let compiled = CompiledModel::new(&model);
    let options = IntegrationOptions {
        max_step: 0.02,
        ..IntegrationOptions::with_tolerance(1e-10)
    };
    let times = [0.4, 0.7, 1.1, 2.8];
    // The value holds from 0.52 s to 0.9 s, where the input itself has no kink.
    let values = [1.0, 6.0, -2.0, -2.0, 0.0, 1.0];
    for interpolation in ["linear", "hold", "cubic"] {
        for [delay, lag] in [[0.0, 0.0], [0.03, 0.0], [0.03, 0.05]] {
            let parameters = |values: &[f64]| {
                let series = format!("t = [0.0, 0.5, 0.52, 0.9, 2.0, 3.0], value = {values:?}");
                let text = format!(
                    "{START}[coefficients]\nk_delay_of_thrust = {delay}\nk_lag_of_thrust = {lag}\n\
                     [inputs]\nthrust = {{ {series}, interpolation = \"{interpolation}\" }}"
                );
                let release = read("r.toml", &text, |_| Ok(Vocabulary::of(&model)));
                let release = release.expect("a release");
                (compiled.release_parameters(&release), release.state())
            };
            let (own, state) = parameters(&values);
            let bound = compiled.bind(own);
            let thrust = compiled.layout().parameter("thrust").expect("an input");
            let found = bound.derivatives_by_samples(thrust, (0.0, &state), &times, &options);
            let found = found.expect("a flight");
            assert_eq!(found.len(), values.len());
            for (sample, by_sample) in found.iter().enumerate() {
                let flown = |step: f64| {
                    let mut values = values;
                    values[sample] += step;
                    let (own, state) = parameters(&values);
                    let mut along = vec![0.0; times.len() * state.len()];
                    let bound = compiled.bind(own);
                    let start: Box<[f64]> = state.into();
                    let end =
                        bound.integrate_at((0.0, &start), &times, &options, &mut [], &mut along);
                    end.map(|_| along).expect("a flight")
                };
                let (up, down) = (flown(1e-3), flown(-1e-3));
                for (index, exact) in by_sample.iter().enumerate() {
                    let difference = (up[index] - down[index]) / 2e-3;
                    assert!(
                        (exact - difference).abs() < 2e-6,
                        "{interpolation} {delay} {lag}, sample {sample}, {index}: {exact} {difference}"
                    );
                }
            }
        }
    }
}

/// The turning points of a spline are where it is greatest and least on a fine grid.
#[test]
fn a_spline_turns_where_its_values_do() {
    let samples = [
        (0.0, 0.0),
        (1.0, 3.0),
        (1.5, -1.0),
        (4.0, 2.0),
        (5.0, 1.9),
        (7.0, 0.0),
    ];
    let series = flight::InputSeries::new(&samples, InputInterpolation::Cubic);
    let values: Vec<f64> = (0..=7000).map(|k| series.at(1e-3 * f64::from(k))).collect();
    let turns = values.windows(3).enumerate().filter_map(|(k, own)| {
        ((own[1] - own[0]) * (own[2] - own[1]) < 0.0).then_some(1e-3 * (k + 1) as f64)
    });
    let expected: Vec<f64> = turns.collect();
    assert!(expected.len() > 2, "{expected:?}");
    let found: Vec<(f64, f64)> = series.extremes().collect();
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for ((t, value), expected) in found.iter().zip(&expected) {
        assert!((t - expected).abs() < 2e-3, "{found:?} {expected:?}");
        assert_eq!(*value, series.at(*t));
    }
}
