//! Stated equations held to the body that they are claimed to be about: right ones are not refuted, wrong ones are named.

use crate::support::{QUICK, built_in, row};
use model_spec::load::{Loaded, inspect_text};
use verify::Options;
use verify::checks::claim::CLAIM;
use verify::checks::{exact, identities, metamorphic, reference};
use verify::flights::{INVARIANTS, MOMENTA};
use verify::report::{Outcome, Report, Row, Verdict};

/// Text of a `claim` block: the physical meaning of the explicitly written equations of the built-in disc model
/// `disc_appendix`.
const DISC: &str = "claim body disc {
  mass m;
  inertia diag(I_d, I_d, I_a) in B;
  fixed in C;
  position (x, y, z) in N;
  velocity velocity;
  angular velocity angular_velocity;
  force force_b;
  moment moment_b;
}
";

/// Text of a test model of a glider in its vertical plane, with speed and flight-path angle as states.
const GLIDER: &str = "model glider;
param m = 3 g;
param S = 0.017 m^2;
param rho = 1.225 kg/m^3;
param g = 9.81 m/s^2;
coefficient C_L = 0.6 [1] in 0 .. 3;
coefficient C_D = 0.1 [1] in 0 .. 3;
frame N;
state range = 0 m;
state height = 2 m;
state V = 4 m/s;
state gamma = 0 rad;
limit V > 0.2 m/s \"it hangs in the air\";
let along = (cos(gamma), 0, sin(gamma)) in N;
let up_across = (-sin(gamma), 0, cos(gamma)) in N;
let pressure_force = rho*V^2/2*S;
der(range) = V*cos(gamma);
der(height) = V*sin(gamma);
der(V) = -pressure_force*C_D/m - g*sin(gamma);
der(gamma) = pressure_force*C_L/(m*V) - g*cos(gamma)/V;
claim point glider {
  mass m;
  position (range, 0, height) in N;
  velocity V*along;
  force pressure_force*(C_L*up_across - C_D*along) - m*g*N.3;
}
";

fn loaded(text: &str) -> Loaded {
    let loaded = inspect_text("own", text, &[]).unwrap();
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    loaded
}

fn report(text: &str) -> Report {
    verify::run(&loaded(text), &QUICK)
}

/// Text of a built-in model in which a `claim` block replaces the reference law.
fn by_claim(name: &str) -> String {
    let text = built_in(name).sources[0].text.clone();
    let without = text.replace("reference hubbard_hummel_disc;\n", "");
    assert_ne!(text, without);
    without + DISC
}

fn named(report: &Report) -> String {
    let named = report.refuted.iter();
    let named = named.map(|r| format!("der({}): {}", r.state, r.corrections.join(", and ")));
    named.collect::<Vec<_>>().join("\n")
}

/// Names of the laws of motion that are violated, read from the detail text of a check result.
fn laws(row: &Row) -> Vec<&str> {
    let lines = row.detail.lines().filter_map(|l| l.split_once(": off by "));
    lines.map(|(law, _)| law).collect()
}

/// Text of a test model of a flying top. Its `claim` block gives the orientation of the body only by the axis of
/// revolution, `axis B.3`.
const TOP: &str = "model top;
param m = 0.1 kg;
param I_a = 2e-4 kg*m^2;
param I_d = 1e-4 kg*m^2;
param g = 9.81 m/s^2;
coefficient c = 1e-4 kg*m^2/s in 0 .. 1;
frame N;
frame A = N turned phi about 1;
frame B = A turned theta about 2;
state x = 0 m;
state y = 0 m;
state z = 0 m;
state vx = 1 m/s;
state vy = 0 m/s;
state vz = 2 m/s;
state phi = 0.1 rad;
state theta = 0.2 rad;
state phidot = 0.1 rad/s;
state thetadot = 0.2 rad/s;
state spin = 40 rad/s;
limit cos(theta) > 0.05 \"its axis lies along N.1\";
der(x) = vx;
der(y) = vy;
der(z) = vz;
der(vx) = 0;
der(vy) = 0;
der(vz) = -g;
der(phi) = phidot;
der(theta) = thetadot;
der(phidot) = (2*I_d*phidot*thetadot*sin(theta) - I_a*spin*thetadot)/(I_d*cos(theta));
der(thetadot) = (I_a*spin*phidot*cos(theta) - I_d*phidot^2*sin(theta)*cos(theta))/I_d;
der(spin) = -c*spin/I_a;
claim body top {
  mass m;
  inertia diag(I_d, I_d, I_a) in B;
  axis B.3;
  position (x, y, z) in N;
  velocity (vx, vy, vz) in N;
  angular velocity (phidot*cos(theta), thetadot, spin) in B;
  force -m*g*N.3;
  moment -c*spin*B.3;
}
";

/// Verifies the model `text` in which the first occurrence of `from` is replaced by `to`, and returns the report.
fn changed(text: &str, from: &str, to: &str) -> Report {
    assert!(text.contains(from), "no `{from}`");
    report(&text.replacen(from, to, 1))
}

/// Checks that the model in whose `text` `from` is replaced by `to` violates the law of motion `law`, and that the
/// report describes the wrong equation by the text `said`.
fn refused(text: &str, (from, to): (&str, &str), law: &str, said: &str) {
    let report = changed(text, from, to);
    let row = row(&report, CLAIM);
    assert_eq!(row.verdict, Verdict::Refuted, "{}", report.table());
    assert!(laws(row).contains(&law), "{to}: {}", row.detail);
    assert_eq!(named(&report), said, "{}", report.table());
    assert_eq!(report.outcome(), Outcome::Refuted);
}

#[test]
fn each_law_refuses_and_names_the_equation_and_the_term() {
    refused(
        GLIDER,
        ("der(range) = V*cos(gamma)", "der(range) = V*sin(gamma)"),
        "d(position)/dt = velocity",
        "der(range): the term `V*sin(gamma)` has a sine for a cosine of `gamma`",
    );
    refused(
        GLIDER,
        ("C_D/m - g*sin", "C_D/m + g*sin"),
        "d(mass*velocity)/dt = force",
        "der(V): the term `g*sin(gamma)` has the wrong sign",
    );
    refused(
        &by_claim("disc_appendix"),
        ("der(phi) = phidot;", "der(phi) = 2*phidot;"),
        "d(axes)/dt = angular velocity × axes",
        "der(phi): the term `2*phidot` carries a factor `2` too many",
    );
    refused(
        TOP,
        ("der(theta) = thetadot", "der(theta) = thetadot*cos(phi)"),
        "d(axes)/dt = angular velocity × axes",
        "der(theta): the term `thetadot*cos(phi)` carries a factor `cos(phi)` too many",
    );
    refused(
        TOP,
        (
            "der(spin) = -c*spin/I_a",
            "der(spin) = -c*spin/I_a*cos(theta)",
        ),
        "d(inertia*angular velocity)/dt = moment",
        "der(spin): the term `-c*spin/I_a*cos(theta)` carries a factor `cos(theta)` too many",
    );
}

#[test]
fn an_axis_of_revolution_stands_for_a_frame_fixed_in_the_body() {
    let report = report(TOP);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    assert_eq!(row(&report, CLAIM).verdict, Verdict::Holds);
    assert_eq!(row(&report, INVARIANTS).verdict, Verdict::Holds);
}

#[test]
fn energy_and_flights_refuse_as_well() {
    let wrong = changed(GLIDER, "g*sin(gamma);", "2*g*sin(gamma);");
    for check in [identities::IDENTITIES, INVARIANTS, MOMENTA] {
        let row = row(&wrong, check);
        assert_eq!(row.verdict, Verdict::Refuted, "{}", wrong.table());
    }
}

#[test]
fn a_force_out_of_the_plane_of_the_states_is_a_contradiction() {
    let wrong = changed(GLIDER, "- m*g*N.3;", "- m*g*N.3 + 0.1*m*g*N.2;");
    let row = row(&wrong, CLAIM);
    assert_eq!(row.verdict, Verdict::Refuted);
    let said = "no equations of these states could obey d(mass*velocity)/dt = force";
    assert!(row.detail.contains(said), "{}", row.detail);
    assert!(row.detail.contains("along N.2"), "{}", row.detail);
    // The equations themselves are not at fault.
    assert_eq!(named(&wrong), "");
}

#[test]
fn what_breaks_a_symmetry_is_said_and_refutes_nothing() {
    let text = by_claim("disc_appendix").replace(
        "- m*g*in_B(N.3);",
        "- m*g*in_B(N.3) - 0.1 [N/m]*in_B((x, y, z) in N);",
    );
    let report = report(&text);
    let relations = row(&report, metamorphic::METAMORPHIC);
    assert_eq!(relations.verdict, Verdict::Skipped);
    assert!(
        relations.detail.contains("it breaks: translation"),
        "{relations:?}"
    );
    assert_eq!(row(&report, CLAIM).verdict, Verdict::Holds);
}

#[test]
fn a_clock_and_an_explicit_time_are_no_fault() {
    // The position drifts by the time of the clock, of which 0.8 s pass in a second of flight.
    let drift = GLIDER
        .replace("frame N;", "frame N;\nclock 1.25;")
        .replace(
            "V*sin(gamma);\nder(V)",
            "V*sin(gamma) - 0.8*1 [m/s];\nder(V)",
        )
        .replace(
            "(range, 0, height) in N;",
            "(range, 0, height + 1 [m/s]*time) in N;",
        );
    let right = report(&drift);
    assert_eq!(
        row(&right, CLAIM).verdict,
        Verdict::Holds,
        "{}",
        right.table()
    );
    let wrong = report(&drift.replace("- 0.8*1 [m/s]", "- 1 [m/s]"));
    assert_eq!(row(&wrong, CLAIM).verdict, Verdict::Refuted);
}

#[test]
fn a_claim_changes_nothing_of_what_is_computed() {
    for text in [by_claim("disc_appendix"), GLIDER.to_owned(), TOP.to_owned()] {
        let start = text.find("claim ").unwrap();
        let (with, without) = (loaded(&text), loaded(&text[..start]));
        let compiled = |loaded: &Loaded| {
            let compiled = codegen::compile(loaded.model.as_ref().unwrap());
            let functions = [&compiled.f, &compiled.f_jac_par, &compiled.observe];
            functions.map(|function| format!("{:?}", function.program))
        };
        assert_eq!(compiled(&with), compiled(&without));
    }
}

#[test]
fn a_state_that_the_laws_leave_free_is_not_examined() {
    let text = TOP.replace(
        "claim body",
        "state battery = 1;\nder(battery) = -0.1 [1/s];\nclaim body",
    );
    let report = report(&text);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
}

#[test]
fn right_claims_hold_for_every_seed() {
    let texts = [by_claim("disc_appendix"), GLIDER.to_owned(), TOP.to_owned()];
    for text in texts {
        let loaded = loaded(&text);
        for seed in 2..8 {
            let report = verify::run(&loaded, &Options { seed, ..QUICK });
            assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
        }
    }
}

#[test]
fn the_printed_appendix_is_named_by_its_claim_as_by_its_reference() {
    let by_reference = verify::run(&built_in("disc_appendix_printed"), &QUICK);
    let by_claim = report(&by_claim("disc_appendix_printed"));
    assert_eq!(named(&by_claim), named(&by_reference));
    assert_eq!(by_claim.refuted.len(), 5, "{}", by_claim.table());
    let row = row(&by_claim, CLAIM);
    assert_eq!(row.verdict, Verdict::Refuted);
    assert_eq!(
        laws(row),
        [
            "d(mass*velocity)/dt = force",
            "d(inertia*angular velocity)/dt = moment"
        ]
    );
}

#[test]
fn the_corrected_appendix_holds_by_its_claim_alone() {
    let report = report(&by_claim("disc_appendix"));
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    assert!(report.refuted.is_empty());
    for check in [CLAIM, identities::IDENTITIES, INVARIANTS, MOMENTA] {
        let row = row(&report, check);
        assert_eq!(row.verdict, Verdict::Holds, "{}", report.table());
    }
}

#[test]
fn a_glider_in_its_plane_is_verified() {
    let report = report(GLIDER);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    for check in [CLAIM, identities::IDENTITIES, MOMENTA] {
        let row = row(&report, check);
        assert_eq!(row.verdict, Verdict::Holds, "{}", report.table());
    }
    for check in [reference::REFERENCE, exact::EXACT] {
        assert_eq!(row(&report, check).verdict, Verdict::Skipped);
    }
}
