//! Every check can fail: for each a model with a line changed, or code of another model, that this very
//! check refuses, and the model as it is that it lets through.

use crate::support::{QUICK, WITHOUT_EFFECTS, built_in, edited, row, verdict, with_lines};
use model_spec::model::Model;
use verify::checks::{
    backends, cases, derivatives, effects, exact, identities, reference, singular,
};
use verify::checks::{metamorphic, units};
use verify::engine::Engine;
use verify::flights::{INVARIANTS, MOMENTA};
use verify::random::Random;
use verify::report::Verdict;
use verify::sample;
use verify::subject::Subject;

/// Asserts that the check refutes the disc model in whose text `from` is replaced by `to`, and that it holds for the
/// unchanged disc model.
fn refuses(check: &str, from: &str, to: &str) {
    let model = edited("disc", from, to);
    assert_eq!(
        verdict(&model, check),
        Verdict::Refuted,
        "{check}: {to} {:?}",
        model.diagnostics
    );
    assert_eq!(verdict(&built_in("disc"), check), Verdict::Holds, "{check}");
}

fn disc() -> Model {
    built_in("disc").model.unwrap()
}

/// Compiled code of the disc model in whose text `from` is replaced by `to`, to be compared with the unchanged model.
fn stale(from: &str, to: &str) -> codegen::Compiled {
    codegen::compile(&edited("disc", from, to).model.unwrap())
}

#[test]
fn units() {
    refuses(units::UNITS, "rho_air*V^2/2", "rho_air*V/2");
    let report = verify::run(&edited("disc", "rho_air*V^2/2", "rho_air*V/2"), &QUICK);
    assert!(
        row(&report, units::UNITS).detail.starts_with("line "),
        "{}",
        report.table()
    );
}

#[test]
fn frames() {
    let mixed = edited("disc", "velocity - in_B(air)", "velocity - air");
    let report = verify::run(&mixed, &QUICK);
    assert_eq!(row(&report, units::UNITS).verdict, Verdict::Refuted);
    assert!(!report.holds());
}

#[test]
fn the_reference_implementation() {
    refuses(reference::REFERENCE, "-m*g_here*N.3", "m*g_here*N.3");
    refuses(
        reference::REFERENCE,
        "C_D0 + C_Da*alpha^2",
        "C_D0 + C_Da*alpha^3",
    );
    refuses(reference::REFERENCE, "marker mark in C", "marker mark in B");
    let report = verify::run(&edited("disc", "rate_2)", "rate_1)"), &WITHOUT_EFFECTS);
    assert_eq!(
        row(&report, reference::REFERENCE).detail,
        "differ from the reference implementation: der(phidot), der(thetadot), der(gammadot)"
    );
}

#[test]
fn a_reference_that_does_not_fit() {
    refuses(
        reference::REFERENCE,
        "hubbard_hummel_disc",
        "hubbard_hummel",
    );
    refuses(
        reference::REFERENCE,
        "hubbard_hummel_disc",
        "ball_with_drag",
    );
}

#[test]
fn the_vector_tree() {
    let (model, old) = (disc(), stale("cross(d3, d1)", "cross(d1, d3)"));
    let engine = Engine::new(&old);
    let row = reference::tree(&Subject::new(&model, &engine), &QUICK);
    assert_eq!(row.verdict, Verdict::Refuted);
    let engine = Engine::new(&codegen::compile(&model));
    assert_eq!(
        reference::tree(&Subject::new(&model, &engine), &QUICK).verdict,
        Verdict::Holds
    );
}

#[test]
fn momentum_and_energy() {
    refuses(identities::IDENTITIES, "mass m;", "mass 2*m;");
    refuses(
        identities::IDENTITIES,
        "diag(I_d, I_d, I_a)",
        "diag(I_d, I_d, I_a/2)",
    );
}

#[test]
fn energy_of_a_stated_equation() {
    let model = edited(
        "disc_appendix",
        "der(thetadot) = (M_b2 - I_d",
        "der(thetadot) = (M_b2 + I_d",
    );
    assert_eq!(verdict(&model, identities::IDENTITIES), Verdict::Refuted);
    assert_eq!(verdict(&model, INVARIANTS), Verdict::Refuted);
    assert_eq!(
        verdict(&built_in("disc_appendix"), INVARIANTS),
        Verdict::Holds
    );
}

#[test]
fn flight_without_air() {
    refuses(
        INVARIANTS,
        "force weight = -m*g_here*N.3;",
        "force weight = -m*g_here*N.3; force drag_2 = -0.1 [kg/s]*velocity;",
    );
    refuses(INVARIANTS, "diag(I_d, I_d, I_a)", "diag(I_d, I_d, I_a/2)");
}

#[test]
fn flight_by_momenta() {
    refuses(MOMENTA, "-m*g_here*N.3", "-1.001*m*g_here*N.3");
}

#[test]
fn metamorphic_relations() {
    let broken = |line: &str| {
        let loaded = with_lines("disc", line);
        assert!(loaded.model.is_some(), "{:#?}", loaded.diagnostics);
        let report = verify::run(&loaded, &WITHOUT_EFFECTS);
        assert_eq!(
            row(&report, metamorphic::METAMORPHIC).verdict,
            Verdict::Refuted,
            "{:?}",
            loaded.diagnostics
        );
        row(&report, metamorphic::METAMORPHIC).detail.clone()
    };
    assert_eq!(broken("force spring = -0.1 [N/m]*position;"), "translation");
    assert_eq!(broken("force north = 0.1 [N]*N.1;"), "heading");
    assert_eq!(
        broken("force side = 0.1*q*A*d2;"),
        "mirror image with opposite spin"
    );
    assert_eq!(
        broken("force jet = 0.1 [N]*C.1;"),
        "turn about the axis of symmetry"
    );
    assert_eq!(
        broken("force pulse = 0.1 [N]*sin(time*1 [1/s])*B.3;"),
        "delay"
    );
    assert_eq!(
        broken("force rail = -0.1 [kg/s]*dot(velocity, d1)*d1;"),
        "steady motion of air and body together"
    );
}

#[test]
fn derivatives() {
    let (model, old) = (disc(), stale("C_La*alpha", "1.01*C_La*alpha"));
    let engine = Engine::new(&old);
    let rows = derivatives::check(&Subject::new(&model, &engine), &old, &QUICK);
    assert_eq!(rows.len(), derivatives::CHECKS.len());
    for row in rows {
        assert_eq!(row.verdict, Verdict::Refuted, "{}", row.check);
    }
}

#[test]
fn exact_arithmetic() {
    let model = exact::free_loads(&disc());
    let old = edited(
        "disc",
        "diag(I_d, I_d, I_a)",
        "diag(I_d, I_d, 1.0000000001*I_a)",
    )
    .model
    .unwrap();
    let row = exact::compare(&model, &codegen::compile(&exact::free_loads(&old)), &QUICK);
    assert_eq!(row.verdict, Verdict::Refuted);
    let row = exact::compare(&model, &codegen::compile(&model), &QUICK);
    assert_eq!(row.verdict, Verdict::Holds, "{}", row.detail);
}

#[test]
fn backends() {
    let (model, compiled) = (disc(), codegen::compile(&disc()));
    let points: Vec<_> = singular::points(&model)
        .into_iter()
        .map(|(_, point)| point)
        .collect();
    let mut runs = backends::runs(&model, &compiled, &points);
    runs.retain(|run| run.backend.starts_with("tape"));
    assert!(runs.len() > 2, "{runs:?}");
    assert_eq!(backends::check(&compiled, &runs).verdict, Verdict::Holds);
    for fuses in [false, true] {
        let mut runs = runs.clone();
        runs.retain(|run| run.fuses == fuses);
        // A machine may have one kind of lanes that fuses, or none.
        let [_, .., last] = runs.as_mut_slice() else {
            continue;
        };
        let result = last.results[0].last_mut().unwrap();
        *result = f64::from_bits(result.to_bits() + 1);
        let row = backends::check(&compiled, &runs);
        assert_eq!((row.verdict, row.worst), (Verdict::Refuted, 1.0));
        assert!(row.detail.starts_with("limits in tape"), "{}", row.detail);
    }
}

#[test]
fn fused_and_not() {
    let (model, compiled) = (disc(), codegen::compile(&disc()));
    let point = sample::point(&model, &mut Random::new(0, "fused and not"));
    let mut runs = backends::runs(&model, &compiled, &[point]);
    let Some(fused) = runs.iter().position(|run| run.fuses) else {
        return;
    };
    assert_eq!(
        backends::check_fma(&compiled, &[], &runs).verdict,
        Verdict::Holds
    );
    let last = runs[fused].results[0].last_mut().unwrap();
    *last *= 1.0 + 1e-11;
    let row = backends::check_fma(&compiled, &[], &runs);
    assert_eq!(
        (row.verdict, row.detail.as_str()),
        (Verdict::Refuted, "limits")
    );
}

#[test]
fn singular_points() {
    let lines = "force burst = 0.1 [N]*exp(z*1e5 [1/m])*d1;";
    let loaded = with_lines("disc", lines);
    let report = verify::run(&loaded, &WITHOUT_EFFECTS);
    let row = row(&report, singular::SINGULAR);
    assert_eq!(
        row.verdict,
        Verdict::Refuted,
        "{:?} {}",
        loaded.diagnostics,
        report.table()
    );
    assert!(
        row.detail.contains("is not finite in tape"),
        "{}",
        row.detail
    );
    assert_eq!(
        verdict(&built_in("disc"), singular::SINGULAR),
        Verdict::Holds
    );
}

#[test]
fn the_models_own_cases() {
    refuses(cases::CASES, "-3.004714285714286", "-3.004714285814286");
    refuses(
        cases::CASES,
        "expect alpha = 0.0996",
        "expect alpha = -0.0996",
    );
}

#[test]
fn effects_off() {
    let effect = |law: &str| {
        let text = format!(
            "effect shift {{ site lift; coefficient C_x = 0 in -1 .. 1; negligible C_x 0.001;
               replace C_L = C_L0 + C_La*alpha{law}; }}"
        );
        with_lines("disc", &text)
    };
    assert_eq!(verdict(&effect(" + C_x"), effects::EFFECTS), Verdict::Holds);
    let report = verify::run(&effect(" + 0.001*cos(C_x)"), &QUICK);
    assert_eq!(row(&report, effects::EFFECTS).verdict, Verdict::Refuted);
    // Nothing changes in value, and yet it costs something.
    let report = verify::run(
        &effect(" + sin(3*alpha + C_x) - 3*sin(alpha) + 4*sin(alpha)^3"),
        &QUICK,
    );
    let row = row(&report, effects::EFFECTS);
    assert!(
        row.worst < 1e-12 && row.verdict == Verdict::Refuted,
        "{}",
        row.detail
    );
    assert!(
        row.detail.starts_with("shift: off, it takes "),
        "{}",
        row.detail
    );
}
