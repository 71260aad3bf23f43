//! The shots of a golfer, as a launch monitor tells them, where the data are at hand.

use std::path::PathBuf;

use dataset::{Dataset, Role, ShotOptions, SummaryQuantity, import_shots};
use diagnose::{DiagnosisOptions, diagnose};
use identify::{Fit, FitOptions, fit};
use model_spec::model::Model;

/// Standard deviations that weigh the six numbers of a shot, in their units.
const SIGMAS: [(&str, &str, f64); 6] = [
    ("carry", "yd", 1.5),
    ("side", "yd", 1.0),
    ("apex_height", "ft", 0.6),
    ("hang_time", "s", 0.1),
    ("landing_speed", "mph", 2.0),
    ("landing_angle", "deg", 1.0),
];

/// The golfer's shots with six numbers each; `None`, with a message, where they are absent.
fn shots() -> Option<Dataset> {
    let file = PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../../shared/data/golf/shots.csv"
    ));
    let Ok(bytes) = std::fs::read(&file) else {
        eprintln!("skipped: no measured data golf beside the checkout");
        return None;
    };
    let mut made = import_shots(&file, &bytes, &ShotOptions::default()).expect("a dataset");
    assert_eq!(made.dataset.flights.len(), 18);
    for sensor in &mut made.dataset.sensors {
        let own = SIGMAS.iter().find(|own| own.0 == sensor.kind.name());
        sensor.sigma = own.map(|own| own.2);
    }
    // The distance of the apex, a seventh number, is not compared.
    let is_distance = |kind: &str| kind == SummaryQuantity::ApexDistance.name();
    let mut sensors = made.dataset.sensors.iter();
    let distance = sensors
        .position(|own| is_distance(own.kind.name()))
        .expect("a column");
    made.dataset.sensors.remove(distance);
    for flight in &mut made.dataset.flights {
        flight.readings[0].remove(distance);
    }
    Some(made.dataset)
}

/// Root mean square error of a quantity of the flights with a role, in the unit of its column.
fn rms(fits: &[Fit], role: Role, kind: &str) -> f64 {
    let flights = fits.iter().flat_map(|fit| fit.report.used(role));
    let seen = flights.flat_map(|flight| &flight.seen);
    let errors = seen.filter(|own| own.measures == kind);
    let squares: Vec<f64> = errors
        .map(|own| (own.predicted - own.measured).powi(2))
        .collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Text of the golf ball with other statements of drag and lift; of the statements, the coefficients that are left.
fn changed(drag: &str, lift: &str, effects: &[&str]) -> Model {
    let mut text = String::new();
    for line in golf_ball().lines() {
        let line = match line.split_once(" = ") {
            Some(("let C_D", _)) => drag,
            Some(("let C_L", _)) => lift,
            _ => line,
        };
        let name = line
            .strip_prefix("coefficient ")
            .and_then(|rest| rest.split(' ').next());
        let is_used = |name: &str| drag.contains(name) || lift.contains(name) || name == "C_N";
        if name.is_none_or(is_used) {
            text += &format!("{line}\n");
        }
    }
    model_spec::load::from_text("changed", &text, effects).expect("a model")
}

fn golf_ball() -> &'static str {
    let mut all = model_spec::load::BODIES.iter();
    all.find(|(name, _)| *name == "golf_ball")
        .expect("built in")
        .1
}

const DRAG: &str = "let C_D = C_D0 + C_Ds*spin_ratio + C_DRe*sin(pi*(Re - 90000)/200000);";

/// Lift in proportion to the spin ratio.
const LIFT: &str = "let C_L = C_L1*spin_ratio;";

/// Drag and lift of the trajectory calculator of A. M. Nathan and of libgolf, which follows it.
const SIMULATOR: (&str, &str) = (
    "let C_D = 0.5 - 0.288*min(max((Re - 50000)/50000, 0), 1) + 0.15*spin_ratio;",
    "let C_L = 1.99*min(spin_ratio, 0.3) - 3.25*min(spin_ratio, 0.3)^2;",
);

/// Fit of a model whose coefficients are all held.
fn held(model: &Model, shots: &Dataset) -> Fit {
    let names = model
        .coefficients
        .iter()
        .map(|own| (own.name.clone(), None));
    let fixed: Vec<(String, Option<f64>)> = names.collect();
    let options = FitOptions {
        fixed: &fixed,
        ..FitOptions::default()
    };
    fit(model, shots, &options).expect("predictions")
}

fn leave_one_out(model: &Model, shots: &Dataset) -> Vec<Fit> {
    let each = (0..shots.flights.len()).map(|left_out| {
        let mut split = shots.clone();
        split.flights[left_out].role = Role::HeldOut;
        fit(model, &split, &FitOptions::default()).expect("a fit")
    });
    each.collect()
}

#[test]
fn carry_and_apex_of_all_shots_are_fitted_and_predicted() {
    let Some(shots) = shots() else { return };
    assert!(shots.notes[0].contains("the fit describes the device's model"));
    let effects = [
        "lift_not_in_proportion_to_spin",
        "drag_not_in_proportion_to_spin",
    ];
    let golf = changed(DRAG, LIFT, &effects);
    let all = [fit(&golf, &shots, &FitOptions::default()).expect("a fit")];
    let one_out = leave_one_out(&golf, &shots);
    let public = [
        held(&changed(SIMULATOR.0, SIMULATOR.1, &[]), &shots),
        held(
            &model_spec::load::load("golf_ball", &[]).expect("built in"),
            &shots,
        ),
    ];
    let of_sample = |fit: &Fit, kind: &str| rms(std::slice::from_ref(fit), Role::Fit, kind);
    let mut rows = String::new();
    for (kind, unit, _) in SIGMAS {
        let left_out = rms(&one_out, Role::HeldOut, kind);
        let [simulator, tunnel] = public.each_ref().map(|fit| of_sample(fit, kind));
        rows += &format!(
            "| `{kind}`, {unit} | {:.2} | {left_out:.2} | {simulator:.2} | {tunnel:.2} |\n",
            of_sample(&all[0], kind)
        );
    }
    println!("{rows}");
    if std::env::var_os("UPDATE_GOLF").is_some() {
        write_page(&rows, &all[0]);
    }
    let [carry, apex] = ["carry", "apex_height"].map(|kind| of_sample(&all[0], kind));
    assert!(
        carry <= 2.6 && apex <= 1.0,
        "carry {carry} yd, apex {apex} ft"
    );
    assert!(rms(&one_out, Role::HeldOut, "carry") <= 4.0);
}

/// Writes the page of the study.
fn write_page(rows: &str, found: &Fit) {
    let coefficients =
        found.report.coefficients.iter().map(|(name, own)| {
            format!("| `{name}` | {:.3e} | {:.1e} |\n", own.value, own.std_error)
        });
    let notes = found.report.notes.iter().map(|note| format!("- {note}\n"));
    let notes = notes.collect::<String>();
    let text = PAGE
        .replace("ROWS", rows.trim_end())
        .replace("COEFFICIENTS", coefficients.collect::<String>().trim_end())
        .replace("NOTES", &notes);
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/studies/golf.md");
    std::fs::write(file, text).expect("the page");
}

const PAGE: &str = include_str!("golf.md");

#[test]
fn lift_grows_less_than_in_proportion_to_the_spin() {
    let Some(shots) = shots() else { return };
    let model = changed(DRAG, LIFT, &[]);
    let found = diagnose(&model, &shots, &DiagnosisOptions::default()).expect("a diagnosis");
    println!("{}", found.report.summary);
    let effects = found.report.explanations.iter().take(1);
    let mut effects = effects.flat_map(|own| &own.effects);
    let lift = effects.find(|own| own.name == "lift-not-in-proportion-to-spin");
    let lift = lift.expect("it is named");
    assert!(lift.estimates["C_Lwl"].value < 0.0);
}
