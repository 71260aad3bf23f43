//! Models of a user's own: right ones are never refuted, and what could not be checked is said, in words and in the outcome.

use crate::support::{QUICK, TOP, built_in, edited, row, with_lines};
use model_spec::load::{Loaded, inspect_text};
use verify::checks::backends::GENERATED;
use verify::checks::{exact, identities, metamorphic, reference, singular};
use verify::flights::{INVARIANTS, MOMENTA};
use verify::report::{Outcome, Report, Verdict};

/// Text of a test model of a point mass with drag in still air.
const POINT: &str = "model pebble;
param m = 0.05 kg;
param g = 9.81 m/s^2;
coefficient k = 0.002 kg/m in 0.0001 .. 1;
frame N;
point pebble { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force drag = -k*norm(velocity)*velocity;
marker mark in N;
observe mark = position + mark;
";

/// Text of a test model of a glider in its vertical plane, with explicitly written equations. Its flight-path angle is
/// undefined at rest.
const GLIDER: &str = "model glider;
param m = 3 g;
param S = 0.017 m^2;
param rho = 1.225 kg/m^3;
param g = 9.81 m/s^2;
coefficient C_L = 0.6 [1] in 0 .. 3;
coefficient C_D = 0.1 [1] in 0 .. 3;
frame N;
frame P = N turned gamma about 2;
state gamma = 0 rad;
state V = 4 m/s;
limit V > 0.3 m/s \"it hangs in the air\";
limit cos(gamma) > 0.2 \"it loops\";
let pressure_force = rho*V^2/2*S;
der(V) = -pressure_force*C_D/m - g*sin(gamma);
der(gamma) = pressure_force*C_L/(m*V) - g*cos(gamma)/V/cos(gamma);
";

fn report(text: &str) -> Report {
    let loaded: Loaded = inspect_text("own", text, &[]).unwrap();
    assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
    verify::run(&loaded, &QUICK)
}

#[test]
fn a_point_in_still_air_is_verified_and_the_relation_of_the_wind_does_not_apply() {
    let report = report(POINT);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    let relations = row(&report, metamorphic::METAMORPHIC);
    assert_eq!(relations.verdict, Verdict::Holds);
    assert!(relations.detail.contains("does not apply"), "{relations:?}");
}

#[test]
fn a_body_of_revolution_about_its_first_axis_is_verified_and_its_meaning_is_known() {
    let report = report(TOP);
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    for check in [metamorphic::METAMORPHIC, INVARIANTS] {
        assert_eq!(
            row(&report, check).verdict,
            Verdict::Holds,
            "{}",
            report.table()
        );
    }
}

#[test]
fn a_force_across_the_axis_of_revolution_is_said() {
    let report = report(&format!("{TOP}force jet = 0.1 [N]*C.2;"));
    let relations = row(&report, metamorphic::METAMORPHIC);
    assert!(
        relations.detail.contains("turn about the axis of symmetry"),
        "{relations:?}"
    );
}

#[test]
fn a_body_whose_loads_stay_without_air_is_not_refuted() {
    let report = report(&format!("{POINT}force cord = -400 [N/m]*position;"));
    assert_eq!(report.outcome(), Outcome::Verified, "{}", report.table());
    assert_eq!(row(&report, INVARIANTS).verdict, Verdict::Skipped);
    // A drag that the coefficients do not switch off.
    let report = self::report(&format!("{POINT}force rope = -1 [kg/s]*velocity;"));
    assert_eq!(row(&report, INVARIANTS).verdict, Verdict::Skipped);
}

#[test]
fn stated_equations_without_a_law_are_not_verified_and_not_refuted() {
    let report = report(GLIDER);
    assert_eq!(report.outcome(), Outcome::NotVerified, "{}", report.table());
    for check in [
        reference::REFERENCE,
        identities::IDENTITIES,
        INVARIANTS,
        MOMENTA,
        metamorphic::METAMORPHIC,
        exact::EXACT,
    ] {
        assert!(
            report.unverified().contains(&check),
            "{check}: {}",
            report.table()
        );
    }
    assert_eq!(row(&report, singular::SINGULAR).verdict, Verdict::Holds);
    let text = report.table();
    assert!(text.contains("NOT VERIFIED: reference"), "{text}");
}

#[test]
fn what_is_not_finite_beyond_a_stated_limit_alone_is_not_refuted() {
    // Finite where cos(gamma) is above 0.2, and beyond the largest number at a right angle.
    let steep = GLIDER.replace(
        "der(V) = ",
        "der(V) = 1e-300 [m/s^2]*exp(710.5*sin(gamma)) ",
    );
    let right = report(&steep);
    let singular = row(&right, singular::SINGULAR);
    assert_eq!(singular.verdict, Verdict::Holds, "{}", right.table());
    let wide = report(&steep.replace("limit cos(gamma) > 0.2", "limit cos(gamma) > 0"));
    let singular = row(&wide, singular::SINGULAR);
    assert_eq!(singular.verdict, Verdict::Refuted, "{}", wide.table());
}

#[test]
fn a_reference_without_wind_is_one_of_still_air() {
    let still = |text: &str| {
        let wind = text.find("/// velocity of the air\n").unwrap();
        let end = wind + text[wind..].find("m/s;\n").unwrap() + 5;
        let text = format!("{}{}", &text[..wind], &text[end..]);
        text.replace("model ball;", "model still;")
            .replace("let air = wind;", "let air = 0*velocity;")
    };
    let ball = built_in("ball").sources[0].text.clone();
    let right = report(&still(&ball));
    assert_eq!(right.outcome(), Outcome::Verified, "{}", right.table());
    assert!(
        row(&right, reference::REFERENCE)
            .detail
            .contains("still air")
    );
    let wrong = report(&still(&ball).replace("rho_air*V^2/2", "rho_air*V^2/3"));
    assert_eq!(row(&wrong, reference::REFERENCE).verdict, Verdict::Refuted);
}

#[test]
fn a_term_that_the_law_lacks_is_said_whatever_its_stated_value() {
    for value in ["0", "0.002"] {
        let own =
            format!("coefficient C_Y = {value} s; let side = q*A*C_Y*r; force side = side*d2;");
        let report = verify::run(&with_lines("disc", &own), &QUICK);
        let row = row(&report, reference::REFERENCE);
        assert_eq!(row.verdict, Verdict::Holds, "{}", report.table());
        let said = "NOT IN THE LAW: `C_Y`, which changes der(";
        assert!(row.remark.as_ref().unwrap().starts_with(said), "{row:?}");
        assert!(report.table().contains(said));
        // The loads of a body are held by the balance of its momentum.
        assert_eq!(report.outcome(), Outcome::Verified);
    }
}

#[test]
fn a_term_that_the_law_lacks_in_stated_equations_is_not_verified() {
    for value in ["0", "0.002"] {
        let own = format!("coefficient C_Y = {value} kg/s; let F_b1 = force_b.1 + C_Y*v;");
        let report = verify::run(
            &edited("disc_appendix", "let F_b1 = force_b.1;", &own),
            &QUICK,
        );
        let row = row(&report, reference::REFERENCE);
        assert_eq!(row.verdict, Verdict::Unverified, "{}", report.table());
        assert!(
            row.detail.contains("`C_Y`, which changes der(u);"),
            "{row:?}"
        );
        assert_eq!(report.outcome(), Outcome::NotVerified);
    }
}

#[test]
fn a_coefficient_that_moves_nothing_leaves_the_reference_to_hold() {
    let own = "coefficient C_Y = 0 s; force side = 0*q*A*C_Y*r*d2;";
    let report = verify::run(&with_lines("disc", own), &QUICK);
    assert_eq!(row(&report, reference::REFERENCE).verdict, Verdict::Holds);
}

#[test]
fn generated_code_of_another_text_is_said() {
    let report = verify::run(&edited("disc", "-m*g_here*N.3", "-(m*g_here*N.3)"), &QUICK);
    let code = row(&report, GENERATED);
    assert_eq!(code.verdict, Verdict::Skipped, "{}", report.table());
    assert!(report.table().contains("STALE: the code of `disc`"));
    let report = verify::run(&built_in("disc"), &QUICK);
    assert_eq!(row(&report, GENERATED).verdict, Verdict::Holds);
    // A fitted or extended model, of another file, has no code that could be old.
    let text = edited("disc", "-m*g_here*N.3", "-(m*g_here*N.3)").sources[0]
        .text
        .clone();
    let extended = model_spec::load::inspect_text("found/extended.hyz", &text, &[]).unwrap();
    let report = verify::run(&extended, &QUICK);
    assert_eq!(row(&report, GENERATED).verdict, Verdict::Skipped);
    assert!(!report.table().contains("STALE"), "{}", report.table());
    // A model that has a name of its own has no code in the program.
    let report = verify::run(&edited("disc", "model disc;", "model mine;"), &QUICK);
    assert_eq!(row(&report, GENERATED).verdict, Verdict::Skipped);
}

#[test]
fn what_does_not_depend_on_a_turn_but_for_rounding_is_not_refuted() {
    // Lift across the plane of a frame that is turned about that very axis: its terms by `a` cancel.
    let text = "model plate;
param m = 0.2 kg;
param k = 0.03 kg/m;
frame N;
frame A = N turned tilt about 1;
frame B = A turned a about 3;
state vx = 3 m/s;
state vy = 2 m/s;
state vz = 1 m/s;
state tilt = 0.1 rad;
state a = 0.2 rad;
let flow = in_B((vx, vy, vz) in N);
let planar = flow - flow.3*B.3;
let force = in_N(-k*norm(flow)*flow + k*dot(planar, planar)*B.3);
der(vx) = force.1/m;
der(vy) = force.2/m;
der(vz) = force.3/m;
der(tilt) = 0.1 [rad/s];
der(a) = 3 [rad/s];
";
    let report = report(text);
    assert_eq!(report.outcome(), Outcome::NotVerified, "{}", report.table());
}
