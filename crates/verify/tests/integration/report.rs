//! What a report says, and that it says the same again.

use std::sync::LazyLock;

use crate::support::{self, QUICK, built_in, refuted, row, with_lines};
use verify::checks::{metamorphic, reference};
use verify::report::{Measure, Report, Verdict};
use verify::{Options, run};

/// Text of a report without measured errors, which depend on the arithmetic of the machine: check, verdict and
/// tolerance per line.
fn stable(report: &Report) -> String {
    let line = |row: &verify::report::Row| {
        let most = match row.measure {
            Measure::Relative => format!("{:e}", row.tolerance),
            Measure::Ulp => format!("{} ulp", row.tolerance),
            Measure::Magnitude => format!("{} ulp of the magnitude", row.tolerance),
            Measure::Count => format!("{} faults", row.tolerance),
        };
        format!("{}: {:?}, at most {most}", row.check, row.verdict)
    };
    report
        .rows
        .iter()
        .filter(|row| !support::KNOWN.contains(&row.check))
        // Not made on a machine that fuses nothing.
        .filter(|row| row.check != verify::checks::backends::FMA)
        .map(line)
        .collect::<Vec<_>>()
        .join("\n")
}

/// The disc, verified with its mutants.
static DISC: LazyLock<Report> = LazyLock::new(|| disc(QUICK.seed));

fn disc(seed: u64) -> Report {
    let options = Options {
        seed,
        mutants: true,
        ..QUICK
    };
    run(&built_in("disc"), &options)
}

#[test]
fn the_disc_is_verified() {
    assert!(refuted(&DISC).is_empty(), "{}", DISC.table());
    insta::assert_snapshot!(stable(&DISC), @r"
    units and frames: Holds, at most 0 faults
    reference: Holds, at most 1e-12
    vector tree: Holds, at most 1e-12
    momentum and energy: Holds, at most 1e-12
    flight without air: Holds, at most 1e-8
    flight: reference in momenta: Holds, at most 1e-8
    metamorphic relations: Holds, at most 1e-10
    derivatives: num-dual: Holds, at most 1e-12
    derivatives: complex step: Holds, at most 1e-12
    derivatives: dual numbers: Holds, at most 1e-12
    derivatives: reference: Holds, at most 1e-12
    rigid body, exact: Holds, at most 0 faults
    f, J and Jp, exact: Holds, at most 0 faults
    backends: Holds, at most 0 ulp
    rounding: Holds, at most 64 ulp of the magnitude
    generated code: Holds, at most 0 faults
    singular points: Holds, at most 0 faults
    check cases of the model: Holds, at most 0 faults
    effects at null values: Holds, at most 1e-12
    effects: reference: Holds, at most 1e-12
    mutants: Holds, at most 0 faults
    ");
}

#[test]
fn every_model_is_verified() {
    for (name, _) in model_spec::load::MODELS {
        let report = run(&built_in(name), &QUICK);
        assert!(refuted(&report).is_empty(), "{}", report.table());
    }
}

#[test]
fn the_same_seed_gives_the_same_report() {
    let json = |report: &Report| serde_json::to_string(report).unwrap();
    assert_eq!(json(&DISC), json(&disc(QUICK.seed)));
    assert_ne!(json(&DISC), json(&disc(8)));
}

#[test]
fn json_has_every_row() {
    let report = run(&built_in("ball"), &QUICK);
    let json: serde_json::Value = serde_json::to_value(&report).unwrap();
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.len(), report.rows.len());
    assert_eq!(json["model"], "ball");
    assert!(
        rows.iter()
            .all(|row| row["verdict"] == "holds" || row["verdict"] == "skipped")
    );
}

#[test]
fn a_term_of_ones_own_is_verified_against_the_tree() {
    // A side force along d2 by spin: the law by hand does not know it, the vector tree does.
    let own = "coefficient C_Y = 0.1 s; let side = q*A*C_Y*r; force side = side*d2;";
    let report = run(&with_lines("disc", own), &QUICK);
    assert!(refuted(&report).is_empty(), "{}", report.table());
    assert_eq!(row(&report, reference::TREE).verdict, Verdict::Holds);
    assert_eq!(
        row(&report, metamorphic::METAMORPHIC).verdict,
        Verdict::Holds
    );

    // One that always pushes to the left is a law with a handedness, and that is told.
    let handed = "coefficient C_Y = 0.1; let side = q*A*C_Y; force side = side*d2;";
    let report = run(&with_lines("disc", handed), &QUICK);
    assert!(refuted(&report).is_empty(), "{}", report.table());
    let told = &row(&report, metamorphic::METAMORPHIC).detail;
    assert!(
        told.contains("C_Y breaks: mirror image with opposite spin"),
        "{told}"
    );
}
