//! Stated equations held to the body that they are claimed to be about: right ones are not refuted, wrong ones are named.

mod support;

use model_spec::load::{Loaded, inspect_text};
use support::{QUICK, built_in, row};
use verify::Options;
use verify::checks::claim::CLAIM;
use verify::checks::{exact, identities, metamorphic, reference};
use verify::flights::{INVARIANTS, MOMENTA};
use verify::report::{Outcome, Report, Verdict};

/// What the appendix of the paper is about.
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

/// A glider in its vertical plane: speed and path angle.
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

/// A built-in model that states a reference, by its claim alone.
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

#[test]
fn the_printed_appendix_is_named_by_its_claim_as_by_its_reference() {
    let by_reference = verify::run(&built_in("disc_appendix_printed"), &QUICK);
    let by_claim = report(&by_claim("disc_appendix_printed"));
    assert_eq!(named(&by_claim), named(&by_reference));
    assert_eq!(by_claim.refuted.len(), 5, "{}", by_claim.table());
    let row = row(&by_claim, CLAIM);
    assert_eq!(row.verdict, Verdict::Refuted);
    insta::assert_snapshot!(row.detail.lines().map(|l| &l[..l.find(':').unwrap()]).collect::<Vec<_>>().join("\n"), @r"
    ");
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
    println!("{}", report.table());
}
