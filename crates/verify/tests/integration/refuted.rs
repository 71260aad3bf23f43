//! The appendix as it was printed: which equations are wrong, in which terms, and by which check.

use crate::support::{QUICK, built_in, edited, refuted, row};
use verify::checks::{reference, units};
use verify::report::Verdict;

#[test]
fn the_printed_appendix_is_refuted_term_by_term() {
    let report = verify::run(&built_in("disc_appendix_printed"), &QUICK);
    // The units refuse four equations; the others are put to the oracle all the same.
    let by_units = row(&report, units::UNITS);
    assert_eq!(by_units.worst, 4.0, "{}", by_units.detail);
    assert_eq!(row(&report, reference::REFERENCE).verdict, Verdict::Refuted);
    let told: Vec<String> = report
        .refuted
        .iter()
        .map(|r| format!("der({}): {}", r.state, r.corrections.join(", and ")))
        .collect();
    insta::assert_snapshot!(told.join("\n"), @r"
    der(u): the divisor `m` belongs to `F_b1` alone
    der(v): the divisor `m` belongs to `F_b2` alone
    der(w): the divisor `m` belongs to `F_b3` alone
    der(phidot): the term `2*I_d*u*phidot*thetadot*sin(theta)` carries a factor `u` too many, and the term `I_a*thetadot*(phidot*sin(theta) + gammadot)*cos(theta)` carries a factor `cos(theta)` too many
    der(gammadot): the term `I_a*(der(phidot)*sin(theta) + phidot*thetadot*cos(theta))*cos(theta)` carries a factor `cos(theta)` too many
    ");
    for refuted in &report.refuted {
        assert!(
            refuted.error > 1e-3 && refuted.error_corrected < 1e-14,
            "{}",
            refuted.sentence()
        );
    }
}

#[test]
fn the_corrected_appendix_is_not() {
    let report = verify::run(&built_in("disc_appendix"), &QUICK);
    assert!(
        refuted(&report).is_empty() && report.refuted.is_empty(),
        "{}",
        report.table()
    );
}

#[test]
fn other_misprints_are_named_too() {
    let named = |from: &str, to: &str| {
        let report = verify::run(&edited("disc_appendix", from, to), &QUICK);
        assert_eq!(report.refuted.len(), 1, "{from}: {}", report.table());
        let refuted = &report.refuted[0];
        format!("{}: {}", refuted.state, refuted.corrections.join(", and "))
    };
    let told = [
        named("w*cos(theta)*sin(phi)", "w*cos(theta)*cos(phi)"),
        named("u*cos(theta) + w*sin(theta)", "u*cos(theta) - w*sin(theta)"),
        named("v*sin(phi)", "v"),
        named(
            "I_d*phidot^2*cos(theta)*sin(theta)",
            "2*I_d*phidot^2*cos(theta)*sin(theta)",
        ),
    ];
    insta::assert_snapshot!(told.join("\n"), @r"
    y: the term `w*cos(theta)*cos(phi)` has a cosine for a sine of `phi`
    x: the term `w*sin(theta)` has the wrong sign
    z: the term `v` lacks a factor `sin(phi)`
    thetadot: the term `2*I_d*phidot^2*cos(theta)*sin(theta)` carries a factor `2` too many
    ");
}
