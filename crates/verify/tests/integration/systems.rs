//! Blocks `solve { … }`: random systems against nalgebra, derivatives against dual numbers.

use crate::support::QUICK;
use codegen::tape_model::{At, Scratch};
use codegen::{TapeModel, compile};
use model_spec::load::from_text;
use model_spec::model::Model;
use nalgebra::{DMatrix, DVector};
use oracle::scalar::{Dual, Real};
use oracle::{Point, derivatives};
use verify::balance_rank;
use verify::checks::{balances, derivatives as by_derivatives, reference};
use verify::engine::Engine;
use verify::random::Random;
use verify::report::Verdict;
use verify::subject::Subject;

/// Random entries: linear in a state, a sine of one, a parameter, a number, or nothing.
struct Entries<'r> {
    random: &'r mut Random,
    states: Vec<f64>,
    a: f64,
    density: f64,
}

impl Entries<'_> {
    /// Text and value of an entry.
    fn draw(&mut self) -> (String, f64) {
        let (a, count) = (self.a, self.states.len());
        let mut uniform = |low: f64, high: f64| self.random.between(low, high);
        if uniform(0.0, 1.0) > self.density {
            return ("0".to_owned(), 0.0);
        }
        let k = (uniform(0.0, count as f64) as usize).min(count - 1);
        let (x, c) = (self.states[k], (uniform(-4.0, 4.0) * 16.0).round() / 16.0);
        match uniform(0.0, 4.0) as usize {
            0 => (format!("({c} + x{k})"), c + x),
            1 => (format!("(sin(x{k})*a)"), x.sin() * a),
            2 => (format!("({c}*a)"), c * a),
            _ => (format!("({c})"), c),
        }
    }
}

/// A model whose derivatives are the solution of a random system, with the system at its default state.
fn random_system(random: &mut Random, count: usize) -> (String, DMatrix<f64>, DVector<f64>) {
    let states: Vec<f64> = (0..count).map(|_| random.between(-2.0, 2.0)).collect();
    let density = random.between(0.4, 1.0);
    let a = 1.25;
    let mut text = "model probe; frame N; param a = 1.25; param s = 1 s;\n".to_owned();
    for (k, x) in states.iter().enumerate() {
        text += &format!("state x{k} = {x};\n");
    }
    let mut entries = Entries {
        random,
        states,
        a,
        density,
    };
    let (mut matrix, mut right) = (DMatrix::zeros(count, count), DVector::zeros(count));
    let mut rows = Vec::new();
    for row in 0..count {
        let mut terms = Vec::new();
        for column in 0..count {
            let (mut entry, mut value) = entries.draw();
            if row == column {
                entry = format!("({entry} + 3)");
                value += 3.0;
            }
            if entry != "0" {
                terms.push(format!("{entry}*s*der(x{column})"));
            }
            matrix[(row, column)] = value;
        }
        let (entry, value) = entries.draw();
        right[row] = value;
        rows.push(format!("  {} = {entry};\n", terms.join(" + ")));
    }
    text += &format!("solve {{\n{}}}\n", rows.concat());
    (text, matrix, right)
}

fn load(text: &str) -> Model {
    from_text("probe.hyz", text, &[]).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn random_systems_are_solved_as_by_nalgebra_with_exact_derivatives() {
    let mut random = Random::new(46, "systems");
    let mut solved = 0;
    for round in 0..300 {
        let count = if round % 25 == 0 {
            5 + round / 25 % 8
        } else {
            1 + round % 4
        };
        let (text, matrix, right) = random_system(&mut random, count);
        let values = matrix.singular_values();
        let condition = values.max() / values.min();
        if condition > 1e6 {
            continue;
        }
        let expected = matrix.full_piv_lu().solve(&right).unwrap();
        let model = load(&text);
        let tape = TapeModel::new(&compile(&model));
        let point = Point::defaults(&model);
        let prepared = tape.prepare(&point.params);
        let at = At {
            t: 0.0,
            x: &point.states,
            p: &point.params,
            prepared: &prepared,
        };
        let (mut dx, mut scratch) = (vec![0.0; count], Scratch::default());
        let [mut j, mut jp] = ["j", "jp"].map(|name| vec![0.0; tape.f_jac_par.pattern(name).len()]);
        tape.f_jac_par
            .eval(at, &[], &mut scratch, &mut [&mut dx, &mut j, &mut jp]);
        let error = (DVector::from_vec(dx.clone()) - &expected).norm();
        let bound = 4.0 * count as f64 * f64::EPSILON * condition * expected.norm();
        assert!(error <= bound, "{error:e} > {bound:e} for\n{text}");
        for column in 0..count {
            let mut moving = point.map(Dual::constant);
            moving.states[column].derivative = 1.0;
            let rates = derivatives(&model, &moving).unwrap();
            let scale = { rates.iter() }.fold(1.0, |most: f64, own| most.max(own.derivative.abs()));
            for (&(row, _), value) in { tape.f_jac_par.pattern("j").iter().zip(&j) }
                .filter(|((_, of), _)| *of as usize == column)
            {
                let expected = rates[row as usize].derivative;
                let difference = (value - expected).abs();
                let allowed = 64.0 * f64::EPSILON * condition * condition * scale;
                assert!(difference <= allowed, "{value} for {expected} in\n{text}");
            }
        }
        solved += 1;
    }
    assert!(solved > 250, "{solved}");
}

/// Determinacy at the defaults.
fn determinacy(text: &str) -> f64 {
    let model = load(text);
    let point = Point::defaults(&model).lift::<f64>();
    let tree = oracle::Tree::new(&model, &point);
    tree.scalar(&model.limits.last().unwrap().value).re()
}

#[test]
fn a_state_that_determines_nothing_is_outside_the_limits() {
    let at = |x: &str| {
        format!(
            "model probe; frame N; param L = 2 m; state x = {x} m; state v = 0 m/s; der(x) = v;
             solve rod {{ x*der(v) = 1 [m^2/s^2]; }}"
        )
    };
    assert_eq!(determinacy(&at("1e-9")), 1.0);
    assert_eq!(determinacy(&at("0")), 0.0);
}

fn gallery(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/gallery/");
    std::fs::read_to_string(format!("{folder}{name}.hyz")).unwrap()
}

/// Verdicts of the claimed balances, the vector tree and the derivatives.
fn verdicts(text: &str) -> Vec<Verdict> {
    let model = load(text);
    let compiled = compile(&model);
    let engine = Engine::new(&compiled);
    let subject = Subject::new(&model, &engine);
    let mut rows: Vec<_> = balances::check(&subject, &QUICK).into_iter().collect();
    rows.push(reference::tree(&subject, &QUICK));
    rows.extend(by_derivatives::check(&subject, &compiled, &QUICK));
    rows.iter().map(|row| row.verdict).collect()
}

#[test]
fn right_models_of_the_gallery_hold_and_wrong_ones_are_refuted_by_their_balances() {
    let wrong = [
        (
            "double_pendulum",
            "= partial(L, theta_1)",
            "= 1.1*partial(L, theta_1)",
        ),
        (
            "spinning_top",
            "der(partial(L, psidot)) = 0",
            "der(partial(L, psidot)) = psidot*1e-6 [N*m*s]",
        ),
        ("euler_disc", "contact × in_B(R)", "-contact × in_B(R)"),
        ("tethered_kite", "= drag + lift", "= 1.1*drag + lift"),
        ("parachute_payload", "= T*unit(line)", "= 1.1*T*unit(line)"),
    ];
    for (name, from, to) in wrong {
        let text = gallery(name);
        let found = verdicts(&text);
        assert!(
            { found.iter() }.all(|own| matches!(own, Verdict::Holds | Verdict::Skipped)),
            "{name}: {found:?}"
        );
        assert!(text.contains(from), "{name}");
        assert_eq!(
            verdicts(&text.replace(from, to))[0],
            Verdict::Refuted,
            "{name}"
        );
    }
}

/// Balances make up for a claimed body where they determine every equation, and not where one of them lacks, or names
/// what follows from the equations.
#[test]
fn balances_verify_only_what_they_determine() {
    let moment = "claim der(in_N(H) - to_contact × mv) = to_contact × (m*g*N.3) - (turning × to_contact) × mv;";
    let balance = "claim der((x, y, a*sin(theta)) in N) = in_N(v);";
    let of_equations = "claim der((x, y, a*sin(theta)) in N) = (der(x), der(y), in_N(v).3) in N;";
    for (from, to, expected) in [
        ("", "", true),
        (moment, "", false),
        (balance, of_equations, false),
    ] {
        let text = gallery("euler_disc");
        assert!(text.contains(from));
        let model = load(&text.replace(from, to));
        assert_eq!(balance_rank::determine_all_rates(&model), expected, "{to}");
    }
    for name in [
        "double_pendulum",
        "falling_plate",
        "spinning_top",
        "tethered_kite",
        "water_rocket",
    ] {
        let determined = balance_rank::determine_all_rates(&load(&gallery(name)));
        assert!(determined, "{name}");
    }
}

/// A block that determines its unknown nowhere is found out before any other check, and soon.
#[test]
fn a_block_that_is_singular_everywhere_is_refuted() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/gallery/tethered_kite.hyz"
    );
    let text = std::fs::read_to_string(path).expect("the kite");
    let line = "- T*r/L;";
    assert!(text.contains(line));
    let wrong = text.replace(line, "- T*cross(r, v)/(L*1 [m/s]);");
    let loaded = model_spec::load::inspect_text("kite.hyz", &wrong, &[]).expect("a model");
    let begun = std::time::Instant::now();
    let report = verify::run(&loaded, &verify::Options::default());
    let seconds = begun.elapsed().as_secs_f64();
    println!("{seconds:.2} s");
    assert!(seconds < 60.0, "{seconds} s");
    let fault = report.rows.last().expect("a row");
    assert_eq!(
        (fault.check, fault.verdict),
        ("unknowns determined", Verdict::Refuted)
    );
    assert!(
        fault.detail.contains("\"solve line\" does not determine"),
        "{}",
        fault.detail
    );
    assert_eq!(report.outcome(), verify::report::Outcome::Refuted);
}

/// A declared body that a block holds is verified as any other.
#[test]
fn constrained_bodies_are_verified() {
    let text = "model rod; param m = 0.5 kg; param l = 0.6 m; param I = 0.06 kg*m^2; param I_a = 1e-3 kg*m^2; param L = 0.8 m; param g = 9.81 m/s^2;
        frame N; frame C = N by quaternion (q0, q1, q2, q3);
        body rod { mass m; inertia diag(I, I, I_a) in C; fixed in C; axis C.3; forward C.1;
          position (x, y, z) in N; velocity (u, v, w) in C; angular velocity (p, q, r) in C; }
        let end = position + l*in_N(C.3);
        force weight = -m*g*N.3;
        force string = -T*unit(end);
        moment string = l*C.3 × in_C(-T*unit(end));
        solve string { unknown T: N; constraint norm(end) = L within 1 cm; }";
    let loaded = model_spec::load::inspect_text("rod.hyz", text, &[]).expect("a model");
    let options = verify::Options {
        cases: 5,
        mutants: false,
        effects: false,
        ..verify::Options::default()
    };
    let report = verify::run(&loaded, &options);
    assert!(report.holds(), "{}", report.table());
}

/// Where a body states which axis points ahead, about half of the random states are those of a typical flight.
#[test]
fn random_states_of_an_arrow_are_of_flights_along_it() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/gallery/arrow.hyz"
    );
    let text = std::fs::read_to_string(path).expect("the arrow");
    let count = |text: &str| {
        let model = from_text("arrow.hyz", text, &[]).expect("a model");
        let chart = oracle::Chart::declared(&model).expect("a body");
        let points = verify::sample::points(&model, 400, &mut Random::new(7, "arrow"));
        let along = points.iter().filter(|point| {
            let physical = chart.physical(&point.states);
            let ahead = physical
                .attitude
                .axis(1)
                .dot(&physical.velocity.normalize());
            ahead > 0.55_f64.cos()
        });
        along.count()
    };
    let stated = count(&text);
    let unstated = count(&text.replace("forward C.1;", ""));
    assert!((150..300).contains(&stated), "{stated}");
    assert!(unstated < 80, "{unstated}");
}

/// Derivatives by the tape and by the oracle, at the default states but for those `set`.
fn both_rates(text: &str, set: &[(&str, f64)]) -> [Vec<f64>; 2] {
    let model = load(text);
    let tape = TapeModel::new(&compile(&model));
    let mut point = Point::defaults(&model);
    for (name, value) in set {
        let states = model.states.iter().position(|state| state.name == *name);
        point.states[states.expect(name)] = *value;
    }
    let prepared = tape.prepare(&point.params);
    let at = At {
        t: 0.0,
        x: &point.states,
        p: &point.params,
        prepared: &prepared,
    };
    let mut dx = vec![0.0; point.states.len()];
    tape.f
        .eval(at, &[], &mut Scratch::default(), &mut [&mut dx]);
    [dx, derivatives(&model, &point.lift::<f64>()).unwrap()]
}

fn assert_equal([own, oracle]: &[Vec<f64>; 2]) {
    for (own, oracle) in own.iter().zip(oracle) {
        let allowed = 1e-12 * oracle.abs().max(1.0);
        assert!((own - oracle).abs() <= allowed, "{own} for {oracle}");
    }
}

/// Each entry of this system vanishes at some angle, and the system is determined at all of them.
#[test]
fn systems_are_solved_where_single_entries_vanish() {
    let text = "model wheel; frame N; state a = 0 rad; state x = 0 m; der(a) = 1 [rad/s];
        solve forces {
          unknown A; unknown B; unknown C; unknown D;
          cos(a)*(A + 0.2*C) - sin(a)*(B + 0.2*D) = 1;
          sin(a)*(A + 0.2*C) + cos(a)*(B + 0.2*D) = 2;
          cos(a)*(C + 0.2*A) - sin(a)*(D + 0.2*B) = 3;
          sin(a)*(C + 0.2*A) + cos(a)*(D + 0.2*B) = 4;
        }
        der(x) = A*1 [m/s];";
    let quarter = std::f64::consts::FRAC_PI_2;
    for turns in [-4.0, -1.0, -0.999, 0.0, 0.5, 1.0, 1.000_001, 2.0, 3.0] {
        let found = both_rates(text, &[("a", turns * quarter)]);
        assert_equal(&found);
        if turns == 1.0 {
            assert!((found[0][1] - 1.25).abs() < 1e-12, "{found:?}");
        }
    }
}

/// Momentum as it is differentiated in a turning frame has entries that vanish for unit quaternions.
#[test]
fn entries_that_vanish_for_unit_quaternions_are_no_pivots() {
    let text = "model spin; param I_a = 0.001 kg*m^2; param I_t = 0.08 kg*m^2; frame N;
        frame C = N by quaternion (q0, q1, q2, q3);
        state q0 = 1; state q1 = 0; state q2 = 0; state q3 = 0;
        state p = 1 rad/s; state q = 2 rad/s; state r = 3 rad/s;
        state u = 1 m/s; state v = 2 m/s; state w = 3 m/s;
        der(q0) = (-q1*p - q2*q - q3*r)/2; der(q1) = (q0*p + q2*r - q3*q)/2;
        der(q2) = (q0*q - q1*r + q3*p)/2; der(q3) = (q0*r + q1*q - q2*p)/2;
        let V = (u, v, w) in C; let H = (I_a*p, I_t*q, I_t*r) in C;
        solve { der(V) = (0, 0, 0) in C; der(H) = (0, 0, 0) in C; }";
    for (q0, q1, q2) in [(1.0, 0.0, 0.0), (0.8, 0.36, 0.48)] {
        let found = both_rates(text, &[("q0", q0), ("q1", q1), ("q2", q2)]);
        assert_equal(&found);
        // Euler's equation: (I_a - I_t) p q/I_t.
        assert!((found[0][6] + 1.975).abs() < 1e-12, "{found:?}");
    }
}

#[test]
fn a_second_body_with_a_quaternion_turns_beside_a_first_one() {
    let body = |name: &str, frame: &str, states: [&str; 9], q: &str| {
        let [x, y, z, u, v, w, p, r, s] = states;
        format!(
            "frame {frame} = N by quaternion ({q}0, {q}1, {q}2, {q}3);
             body {name} {{ mass 1 kg; inertia diag(I, 2*I, 3*I) in {frame}; fixed in {frame};
               position ({x}, {y}, {z}) in N; velocity ({u}, {v}, {w}) in N; angular velocity ({p}, {r}, {s}) in {frame}; }}\n"
        )
    };
    let text = format!(
        "model pair; param I = 4e-3 kg*m^2; frame N;\n{}{}force weight = -1 [N]*N.3; force weight on second = -1 [N]*N.3;",
        body(
            "first",
            "A",
            ["x", "y", "z", "vx", "vy", "vz", "p", "q", "r"],
            "a"
        ),
        body(
            "second",
            "B",
            ["x2", "y2", "z2", "u2", "v2", "w2", "p2", "q2", "r2"],
            "s"
        ),
    );
    let found = both_rates(&text, &[("p", 2.0), ("p2", 2.0), ("q2", 3.0), ("q", 1.0)]);
    assert_equal(&found);
    let model = load(&text);
    let place = |name: &str| model.states.iter().position(|own| own.name == name);
    assert!((found[0][place("s1").unwrap()] - 1.0).abs() < 1e-12);
    assert!((found[0][place("a1").unwrap()] - 1.0).abs() < 1e-12);
}
