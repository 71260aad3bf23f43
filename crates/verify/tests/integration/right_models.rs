//! Right models with what `f64` handles badly are not refuted: sharp switches, kinks, overflow, limits, pulses, stiff contacts,
//! terms that cancel. They are drawn at random; `HYZER_RIGHT_MODELS` sets how many, and `HYZER_RIGHT_SEED` the first seed.

use crate::support::{QUICK, row};
use model_spec::load::inspect_text;
use verify::Options;
use verify::checks::reference::TREE;
use verify::checks::{derivatives, identities};
use verify::flights::{INVARIANTS, MOMENTA};
use verify::random::Random;
use verify::report::{Outcome, Report, Verdict};

/// Number of models that are drawn by default.
const DRAWN: u64 = 40;

/// Draws one of several texts.
fn one_of<'a>(random: &mut Random, texts: &[&'a str]) -> &'a str {
    texts[random.next() as usize % texts.len()]
}

/// Draws a number whose logarithm is uniformly distributed.
fn between(random: &mut Random, least: f64, greatest: f64) -> f64 {
    least * (greatest / least).powf(random.between(0.0, 1.0))
}

/// A quantity of the flight with its unit.
fn quantity(random: &mut Random) -> (&'static str, &'static str) {
    let all = [
        ("x", "m"),
        ("z", "m"),
        ("(x + y)", "m"),
        ("norm(position)", "m"),
        ("vx", "m/s"),
        ("vz", "m/s"),
        ("(vx - vy)", "m/s"),
        ("norm(velocity)", "m/s"),
        ("dot(velocity, N.2)", "m/s"),
        ("time", "s"),
    ];
    all[random.next() as usize % all.len()]
}

/// A number that is 0 at a place of the flight and changes by 1 over a width.
fn argument(random: &mut Random) -> String {
    let (place, width) = (random.within(5.0), between(random, 1e-4, 3.0));
    argument_of(random, place, width)
}

fn argument_of(random: &mut Random, place: f64, width: f64) -> String {
    let (of, unit) = quantity(random);
    format!("(({of} - ({place:.3} [{unit}]))/({width:.3e} [{unit}]))")
}

/// A switch without unit.
fn switch(random: &mut Random) -> String {
    let u = argument(random);
    match random.next() % 13 {
        0 => format!("tanh({u})"),
        1 => format!("(1 + tanh({u}))/2"),
        2 | 3 => {
            // Beyond 709 widths the exponential overflows.
            let (place, width) = (random.within(5.0), between(random, 5e-2, 3.0));
            let u = argument_of(random, place, width);
            let sign = one_of(random, &["-", ""]);
            format!("1/(1 + exp({sign}{u}))")
        }
        4 => format!("max(0, min(1, {u}))^2*(3 - 2*max(0, min(1, {u})))"),
        5 => format!("step({u})"),
        6 => format!("exp(-{u}^2)"),
        7 => format!("min(max({u}, -1), 1)"),
        8 => format!("abs({u})"),
        9 => format!("exp(min({u}, 3))"),
        10 => {
            // Overflows, but not where every state is 0.
            let width = between(random, 1e-4, 3.0);
            format!("exp({})", argument_of(random, 0.0, width))
        }
        11 => format!("sqrt(max(1 - {u}^2, 0))"),
        _ => format!("{u}/sqrt(1 + {u}^2)"),
    }
}

/// A number of terms that cancel.
fn cancelling(random: &mut Random) -> String {
    let u = argument(random);
    let big = between(random, 1e3, 1e9);
    match random.next() % 5 {
        0 => format!("(({big:.3e} + {u}) - {big:.3e})"),
        1 => format!("(sqrt(1 + {u}^2) - {u})"),
        2 => format!("(cos({u})^2 + sin({u})^2 - 1)"),
        3 => format!("(1 - cos({u}))"),
        _ => format!("(({u} + {big:.3e})^2 - {u}^2 - {big:.3e}^2)"),
    }
}

/// Expression of a force.
fn force(random: &mut Random) -> String {
    let size = between(random, 1e-3, 1e2);
    let axis = one_of(random, &["N.1", "N.2", "N.3", "T.1", "T.3"]);
    let (stiffness, damping) = (between(random, 1e2, 1e6), between(random, 1e-2, 1e1));
    match random.next() % 8 {
        0 | 1 => format!("{size:.3e} [N]*{}*{axis}", switch(random)),
        2 => format!(
            "-{size:.3e} [kg/m]*norm(velocity)*({})*velocity",
            switch(random)
        ),
        3 => format!(
            "max({stiffness:.3e} [N/m]*max(-z, 0) - {damping:.3e} [kg/s]*vz*step(-z), 0)*N.3"
        ),
        4 => format!("{stiffness:.3e} [N/m]*max(-x, 0)*{axis}"),
        5 => format!("{size:.3e} [N]*{}*{axis}", cancelling(random)),
        6 => format!("-c*(velocity - dot(velocity, {axis})*{axis})"),
        _ => format!("pulse(time)*{axis}"),
    }
}

fn limit(random: &mut Random) -> String {
    let v = between(random, 1e-2, 3e2);
    let (of, bound) = match random.next() % 7 {
        0 => ("norm(velocity)", format!("{v:.3} m/s")),
        1 => ("z", format!("-{v:.3} m")),
        2 => ("z", format!("{v:.3} m")),
        3 => ("-norm(velocity)", format!("-{} m/s", 1.0 + v)),
        4 => ("-time", format!("-{v:.3} s")),
        5 => ("a + b", String::from("0 m")),
        _ => ("vx", format!("{v:.3} m/s")),
    };
    format!("limit {of} > {bound} \"the law ends\";\n")
}

/// Text of a random model of a point or of a body whose attitude is a quaternion.
fn model(seed: u64) -> String {
    let random = &mut Random::new(seed, "right models");
    let start = between(random, 1e-3, 0.9);
    let width = between(random, 1e-3, 0.3);
    let (middle, end) = (start + width / 2.0, start + width);
    let mut text = format!(
        "model right; param m = {:.3e} kg; param g = 9.81 m/s^2; param a = 2 cm; param b = 3 cm; param I_1 = 2e-3 kg*m^2;
param I_2 = 3e-3 kg*m^2; coefficient c = {:.3e} kg/s in 0 .. 10;
frame N;
table pulse(t: s): N = {{ 0: 0, {start:.6}: 0, {middle:.6}: 5, {end:.6}: 0, 2: 0 }} monotone, constant;\n",
        between(random, 1e-2, 10.0),
        between(random, 1e-3, 1.0),
    );
    let is_point = !random.once_in(3);
    if is_point {
        text += "point right { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n";
    } else {
        text += "frame B = N by quaternion (q0, q1, q2, q3);
body right { mass m; inertia diag(I_1, I_2, I_2) in B; fixed in B; position (x, y, z) in N; velocity (vx, vy, vz) in N; angular velocity (p, q, r) in B; }\n";
        let size = between(random, 1e-4, 1e-1);
        text += &format!(
            "moment damping = -{size:.3e} [N*m*s]*({})*angular_velocity;\n",
            switch(random)
        );
    }
    if random.once_in(2) {
        text += &limit(random);
    }
    text += "force weight = -m*g*N.3;\n";
    for k in 0..=random.next() % 3 {
        text += &format!("force f{k} = {};\n", force(random));
    }
    let turned = if is_point {
        ["N.1", "N.3"]
    } else {
        ["in_N(B.1)", "in_N(B.3)"]
    };
    text.replace("T.1", turned[0]).replace("T.3", turned[1])
}

/// Text of a random model with stated equations: a point on a rail, held to its claim.
fn claimed(seed: u64) -> String {
    let random = &mut Random::new(seed, "right claims");
    let forces: Vec<String> = (0..=random.next() % 2)
        .map(|_| {
            let size = between(random, 1e-3, 1e1);
            let factor = if random.once_in(3) {
                cancelling(random)
            } else {
                switch(random)
            };
            format!("{size:.3e} [N]*{factor}")
        })
        .collect();
    let along = forces.join(" + ");
    let along = along
        .replace("norm(position)", "abs(x)")
        .replace("norm(velocity)", "abs(vx)");
    let along = along.replace("(x + y)", "x").replace("(vx - vy)", "vx");
    let along = along
        .replace("dot(velocity, N.2)", "vx")
        .replace("vz", "vx")
        .replace('z', "x");
    let limit = match random.next() % 3 {
        0 => "limit x > -0.5 m \"the rail ends\";\n",
        1 => "limit length > 0 \"no length\";\n",
        _ => "",
    };
    format!(
        "model right; param m = {:.3e} kg; param a = 5 mm; param b = 3 mm; frame N; state x = 0 m; state vx = 0 m/s;
let length = a + b; let f = {along};
{limit}der(x) = vx; der(vx) = f/m;
claim point right {{ mass m; position x*N.1; velocity vx*N.1; force f*N.1; }}\n",
        between(random, 1e-2, 10.0)
    )
}

fn verified(text: &str, options: &Options) -> Report {
    let loaded = inspect_text("right", text, &[]).unwrap();
    assert!(loaded.model.is_some(), "{text}\n{:#?}", loaded.diagnostics);
    verify::run(&loaded, options)
}

fn number(name: &str, default: u64) -> u64 {
    let set = std::env::var(name).ok();
    set.and_then(|set| set.parse().ok()).unwrap_or(default)
}

#[test]
fn random_right_models_are_not_refuted() {
    let first = number("HYZER_RIGHT_SEED", 1);
    let (mut refuted, mut open) = (Vec::new(), Vec::new());
    let count = number("HYZER_RIGHT_MODELS", DRAWN);
    for seed in first..first + count {
        let text = if seed % 4 == 0 {
            claimed(seed)
        } else {
            model(seed)
        };
        let options = Options {
            effects: seed % 10 == 0,
            ..QUICK
        };
        let report = verified(&text, &options);
        match report.outcome() {
            Outcome::Verified => {}
            Outcome::NotVerified => open.push((seed, report.unverified())),
            Outcome::Refuted => refuted.push(format!("{seed}: {text}{}", report.table())),
        }
    }
    println!(
        "{count} models, {} refuted, {} not verified: {open:?}",
        refuted.len(),
        open.len()
    );
    assert!(refuted.is_empty(), "{}", refuted.join("\n"));
}

const SLED: &str = "model sled; param m = 2 kg; frame N;
    point sled { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }\n";

fn outcome(text: &str) -> Report {
    let report = verified(text, &QUICK);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    report
}

#[test]
fn a_switch_whose_dual_numbers_overflow_is_not_refuted() {
    // cosh overflows beyond 710.
    let brake = "force brake = -3 [N]*tanh(u/(2 [mm/s]))*N.1;";
    let step = "force drag = -(0.1 [kg/m])*(1 - tanh((norm(velocity) - 9 [m/s])/(0.01 [m/s])))*norm(velocity)*velocity;";
    for force in [brake, step] {
        outcome(&format!("{SLED}{force}"));
    }
}

#[test]
fn a_wrong_switch_is_refuted_although_its_dual_numbers_overflow() {
    let text = |factor: &str| {
        let force = format!("force brake = -{factor} [N]*tanh(u/(2 [mm/s]))*N.1;");
        inspect_text("sled", &format!("{SLED}{force}"), &[]).unwrap()
    };
    let (right, wrong) = (text("3"), text("3.00000001"));
    let compiled = codegen::compile(wrong.model.as_ref().unwrap());
    let rows = verify::rows_of_code(right.model.as_ref().unwrap(), &compiled, &QUICK);
    for check in [TREE, derivatives::CHECKS[0], derivatives::CHECKS[2]] {
        let found = rows.iter().find(|row| row.check == check).unwrap();
        assert_eq!(found.verdict, Verdict::Refuted, "{found:?}");
    }
}

/// What is left of an overflow on the way to a finite value depends on the order of the operations.
#[test]
fn a_value_whose_terms_overflow_is_not_refuted() {
    for sum in ["1 + 2*exp(a) + exp(2*a)", "1 + exp(3*a) + exp(a)*exp(a)"] {
        let soft = format!(
            "let a = (0.2 [m] - z)/(1 [mm]); coefficient C = 0.3 N in 0 .. 3; force floor = C*log({sum})*N.3;"
        );
        let report = outcome(&format!("{SLED}{soft}"));
        let told = report.table();
        assert!(
            told.contains("OVERFLOW (derivatives: dual numbers)"),
            "{told}"
        );
    }
}

#[test]
fn an_overflow_is_named_and_not_refuted() {
    let blast = "force blast = 2 [N]*exp(-x/(0.9 [mm]))*N.2;";
    let report = outcome(&format!("{SLED}{blast}"));
    for check in [TREE, identities::IDENTITIES, derivatives::CHECKS[0]] {
        let remark = row(&report, check).remark.clone().unwrap_or_default();
        assert!(
            remark.starts_with("OVERFLOW"),
            "{check}: {}",
            report.table()
        );
    }
    assert!(
        report
            .table()
            .contains("OVERFLOW (vector tree): der(v): beyond")
    );
}

#[test]
fn a_burn_and_a_bounce_within_the_flight_are_not_refuted() {
    let burn = "force burn = 40 [N]*step(time - 0.2 [s])*step(0.4 [s] - time)*N.2;";
    let floor = "force weight = -m*(9.81 [m/s^2])*N.3; force floor = max((3e3 [N/m])*max(-z, 0) - (9 [kg/s])*w*step(-z), 0)*N.3;";
    for force in [burn, floor] {
        let report = outcome(&format!("{SLED}{force}"));
        let without_air = row(&report, INVARIANTS);
        assert_eq!(without_air.verdict, Verdict::Skipped, "{}", report.table());
    }
}

#[test]
fn limits_far_from_typical_states_and_near_small_ones_leave_flights() {
    let fast = "limit norm(velocity) > 120 m/s \"supersonic\"; coefficient k = 1e-4 kg/m in 0 .. 1; force drag = -k*norm(velocity)*velocity;";
    let high = "limit z > 3 km \"thin air\"; force weight = -m*(9.81 [m/s^2])*N.3;";
    let layer = "limit z > 500 m \"low\"; limit -z > -510 m \"high\"; force weight = -m*(9.81 [m/s^2])*N.3;";
    let orbit = "param GM = 4e14 m^3/s^2; limit norm(position) > 6e6 m \"in the earth\";
        force gravity = -GM*m/norm(position)^2*unit(position);";
    outcome(&format!("{SLED}{orbit}"));
    for forces in [fast, high, layer] {
        let report = outcome(&format!("{SLED}{forces}"));
        assert!(row(&report, INVARIANTS).cases > 0, "{}", report.table());
    }
    let rail =
        "model rail; param m = 20 g; param h = 4 mm; frame N; state s = 1 mm; state v = 0 m/s;
        let gap = h + h; limit gap > 0 \"no gap\"; der(s) = v; der(v) = -(1 [N/m])*s/m;
        claim point bead { mass m; position s*N.2; velocity v*N.2; force -(1 [N/m])*s*N.2; }";
    assert!(row(&outcome(rail), MOMENTA).cases > 0);
    // Nothing is refuted at states where the model does not hold.
    let nowhere = format!(
        "{SLED}limit norm(velocity) > 9 m/s \"slow\"; limit -norm(velocity) > -8 m/s \"fast\";"
    );
    let report = verified(&nowhere, &QUICK);
    assert_eq!(report.outcome(), Outcome::NotVerified, "{}", report.table());
}

#[test]
fn an_entry_that_cancels_is_compared_with_the_rounding_of_its_terms() {
    let dart =
        "model dart; param m = 0.3 kg; param I_1 = 1e-3 kg*m^2; param I_2 = 2e-3 kg*m^2; frame N;
        frame B = N by quaternion (q0, q1, q2, q3);
        body dart { mass m; inertia diag(I_1, I_2, I_2) in B; fixed in B; position (x, y, z) in N;
          velocity (u, v, w) in N; angular velocity (p, q, r) in B; }
        let air = in_B(velocity);
        force drag = -(0.4 [kg/s])*(air - air.1*B.1);";
    let options = Options {
        cases: 400,
        effects: false,
        ..QUICK
    };
    for seed in 1..=3 {
        let report = verified(dart, &Options { seed, ..options });
        assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    }
}

/// Right angles are multiples of π, also where their product has few decimals: 3·π/2 is 4.71238898038469.
#[test]
fn a_multiple_of_a_right_angle_is_not_refuted() {
    let rotors = "force rotors = (3 [N])*u/(1 [m/s])*(cos(3*90 [deg])*N.1 + sin(3*90 [deg])*N.2 + sin(270 [deg])*N.3);";
    outcome(&format!("{SLED}{rotors}"));
}

/// A claim of the energy alone says less than what the equations need.
#[test]
fn fewer_balances_than_states_leave_a_model_not_verified() {
    let text =
        "model drop; param m = 2 kg; param g = 9.81 m/s^2; frame N; state z = 3 m; state v = 0 m/s;
        der(z) = v; der(v) = -g; claim der(m*v^2/2 + m*g*z) = 0 W;";
    let report = verified(text, &QUICK);
    assert_eq!(report.outcome(), Outcome::NotVerified, "{}", report.table());
}
