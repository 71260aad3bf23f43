//! docs/real-data.md: what measured flights and a wind tunnel say.

use std::path::Path;

use identify::dataset;
use identify::fit::{Fitted, fit};
use identify::options::Options;
use identify::report::Report;
use model_spec::model::Model;
use report::figures::{Dots, Line, Look, Panel, figure};

use super::Page;
use super::write::{Text, mean_and_deviation, percent, three};
use crate::paper_flight::{paper_flight, released_at};
use crate::replay::{TABLE_1, way};
use crate::windtunnel::{Curve, Measured, between, lowest, read};

/// What was made of the measured data.
pub struct RealData {
    ball: Report,
    model: Model,
    table: Vec<Measured>,
    disc: Model,
}

impl RealData {
    /// The fit of the balls.
    pub fn ball(&self) -> &Report {
        &self.ball
    }

    /// Fits and compares what is in a folder with `spindoe` and `windtunnel`.
    ///
    /// # Errors
    /// In words, where a file is missing or malformed, or a fit fails.
    pub fn of(folder: &Path) -> Result<Self, String> {
        let flights = dataset::load(&folder.join("spindoe")).map_err(|error| error.to_string())?;
        let model =
            model_spec::load::load(&flights.model, &[]).map_err(|error| error.to_string())?;
        let fitted: Fitted =
            fit(&model, &flights, &Options::default()).map_err(|error| error.to_string())?;
        Ok(Self {
            ball: fitted.report,
            model,
            table: read(&folder.join("windtunnel/potts_crowther.csv"))?,
            disc: crate::made::disc(),
        })
    }
}

/// Angles over which the disc's curves are fitted to the tunnel's table, degrees.
const RANGES: [(f64, f64); 3] = [(-5.0, 10.0), (-5.0, 15.0), (-10.0, 30.0)];

const NAMES: [&str; 3] = ["lift", "drag", "pitching moment"];

/// The page.
pub fn real_data(data: &RealData) -> Page {
    let mut text = Text::default();
    text.paragraph("# Measured data");
    text.paragraph("<!-- Written by `hyzer trials real-data`; do not edit. -->");
    text.paragraph(
        "What the models say to data that nobody of this project made. The data are not part of the repository; where they lie \
         beside it, `hyzer trials real-data --data ../shared/data --out docs/real-data.md` makes this page again.",
    );
    ball(&mut text, data);
    tunnel(&mut text, data);
    paper(&mut text, data);
    Page {
        text: text.finish(),
        figures: vec![("real-data-tunnel.svg".into(), drawn(data))],
    }
}

fn ball(text: &mut Text, data: &RealData) {
    let report = &data.ball;
    text.paragraph("## Table-tennis balls (SpinDOE, arXiv 2303.03879)");
    let fitted = report
        .flights
        .iter()
        .filter(|flight| flight.role == dataset::Role::Fit)
        .count();
    let held: Vec<f64> = report
        .flights
        .iter()
        .filter(|flight| flight.role == dataset::Role::HeldOut)
        .map(|flight| flight.rms_m)
        .collect();
    let mut sorted = held.clone();
    sorted.sort_by(f64::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    text.paragraph(format!(
        "{} flights tracked by cameras, some 7 ms apart, 0.2 to 0.5 s long; {fitted} are fitted, {} held out. The model is `{}`: gravity and drag.",
        report.flights.len(), held.len(), data.model.name
    ));
    let rows = report.coefficients.iter().map(|(name, found)| {
        let clustered = found.std_error_clustered.map_or(String::new(), three);
        vec![
            format!("`{name}`"),
            three(found.value),
            format!(
                "{} .. {}",
                three(found.interval[0]),
                three(found.interval[1])
            ),
            three(found.std_error),
            clustered,
            found.unit.clone(),
        ]
    });
    text.table(
        &[
            "coefficient",
            "value",
            "95 % interval",
            "standard error",
            "by the scatter of flights",
            "unit",
        ],
        rows,
    );
    let noise = &report.noise;
    text.paragraph(format!(
        "Residuals of {:.1} mm (root mean square of a coordinate), correlated by {:.2} from one sample to the next; {} of {} \
         points ({}) are outliers. Held-out flights, their initial state fitted on the first 30 % and the rest predicted: \
         {:.0} mm (median).",
        1e3 * report.rms_m, noise.ar1, noise.outliers, noise.points, percent(noise.outlier_fraction), 1e3 * median
    ));
    let rows = noise.axes.iter().map(|(axis, noise)| {
        vec![
            axis.clone(),
            format!("{:.1}", 1e3 * noise.sigma_m),
            format!("{:.2}", noise.ar1),
        ]
    });
    text.table(&["axis", "residuals, mm", "correlation"], rows);
    let most = noise
        .axes
        .iter()
        .max_by(|a, b| a.1.sigma_m.total_cmp(&b.1.sigma_m));
    if let Some((axis, found)) = most.filter(|(_, found)| found.ar1 > 0.5) {
        text.paragraph(format!(
            "Residuals so correlated ({:.2} along {axis}, where they are greatest) are no noise of a camera: the paths themselves \
             bend away from gravity and drag. These balls spin, and lift by spin is no part of this model. By that the standard \
             error is too small; the scatter of the flights, which needs to know nothing of what is missing, gives the one beside it.",
            found.ar1
        ));
    }
}

fn tunnel(text: &mut Text, data: &RealData) {
    text.paragraph("## A frisbee in a wind tunnel (Potts & Crowther)");
    text.paragraph(
        "Lift, drag and pitching moment of a disc at rest in a stream, from -100° to 100°, against the curves that the model \
         `disc` has: lift linear in the angle of attack, drag quadratic about 0, moment linear and 0 at 0 (nose-up negative here, as \
         the model has it). For each range the curves of this form that are nearest to the table, and how far they stay from it (root mean \
         square, and the same of the model's own coefficients):",
    );
    let own = own(&data.disc);
    let mut rows = Vec::new();
    for (low, high) in RANGES {
        let within = between(&data.table, low, high);
        for which in 0..3 {
            let Some(curve) = form(&within, which) else {
                continue;
            };
            let size = within
                .iter()
                .map(|row| row.coefficients[which].powi(2))
                .sum::<f64>()
                / within.len() as f64;
            rows.push(vec![
                format!("{}, {low}° to {high}°", NAMES[which]),
                if which == 2 {
                    "0".into()
                } else {
                    three(curve.constant)
                },
                three(curve.multiple),
                three(curve.rms(&within, which)),
                three(own[which].rms(&within, which)),
                three(size.sqrt()),
            ]);
        }
    }
    text.table(
        &[
            "curve",
            "constant",
            "multiple",
            "fit stays off by",
            "the model's own",
            "size of the measured",
        ],
        rows,
    );
    text.paragraph(format!(
        "The model's own: {}.",
        data.disc
            .coefficients
            .iter()
            .take(5)
            .map(|c| format!("`{}` {}", c.name, three(c.value)))
            .collect::<Vec<_>>()
            .join(", ")
    ));
    let (low, high) = RANGES[1];
    text.paragraph(format!(
        "![Measured coefficients, the model's own curves, and those fitted from {low}° to {high}°](real-data-tunnel.svg)"
    ));
    missed(text, &data.table);
}

/// Where the table leaves the curves' form, by numbers of its own.
fn missed(text: &mut Text, table: &[Measured]) {
    let slope = |which: usize, low: f64, high: f64| {
        let curve = Curve::fitted(&between(table, low, high), which, 1, false);
        three(curve.map_or(f64::NAN, |curve| curve.multiple))
    };
    text.paragraph(
        "What the forms miss, by slopes (per rad) of straight lines through parts of the table:",
    );
    if let Some(lowest) = lowest(&between(table, -10.0, 15.0), 1) {
        text.line(format!(
            "- drag: a parabola that may lie anywhere is lowest at {:.1}° over -10° to 15°; the model's lies at 0°;",
            lowest.to_degrees()
        ));
    }
    text.line(format!(
        "- lift: {} from 0° to 10°, {} from 10° to 20°, {} from 20° to 30°; the model has one slope;",
        slope(0, 0.0, 10.0),
        slope(0, 10.0, 20.0),
        slope(0, 20.0, 30.0)
    ));
    let at_zero = table.iter().find(|row| row.alpha.abs() < 1e-9);
    text.line(format!(
        "- pitching moment: {} at 0°, where the model has 0; slopes of {} from 0° to 10° and {} from 15° to 25°; the model has one.",
        at_zero.map_or(String::new(), |row| three(row.coefficients[2])),
        slope(2, 0.0, 10.0),
        slope(2, 15.0, 25.0)
    ));
    text.line("");
    text.paragraph(
        "The table is that of a disc that does not spin, and of another make than the model's.",
    );
}

/// Seeds of the paper's flights.
const SEEDS: u64 = 40;

/// The paper's flights in the tunnel's air, fitted one by one by the model.
fn paper(text: &mut Text, data: &RealData) {
    text.paragraph("## The paper's two flights in the tunnel's air");
    let released = ["fssh3", "bffl8"].map(|name| released_at(&data.disc, name).to_degrees());
    text.paragraph(format!(
        "Hubbard & Hummel's fssh3 is released at an angle of attack of {:.0}°, their bffl8 at {:.0}°. Here both are flown by the oracle with lift, drag \
         and pitching moment as the tunnel measured them (damping and spin moments the model's own), seen with the paper's 1.4 mm, and fitted \
         one by one by the model's straight lines and parabola, free of bounds: mean and standard deviation over {SEEDS} seeds.",
        released[0], released[1]
    ));
    let table = Some(data.table.as_slice());
    let ways = ["fssh3", "bffl8"].map(|name| {
        let flight = paper_flight(&data.disc, name, table);
        way(&data.disc, name, &flight, 0.0, SEEDS)
    });
    let rows = data
        .disc
        .coefficients
        .iter()
        .enumerate()
        .map(|(k, constant)| {
            let found = ways.each_ref().map(|way| {
                let (mean, deviation) = mean_and_deviation(&way.estimates[k]);
                format!("{} ± {}", three(mean), three(deviation))
            });
            let printed = TABLE_1.iter().find(|(name, ..)| *name == constant.name);
            let printed = printed.map_or(Default::default(), |(_, a, b)| [three(*a), three(*b)]);
            let [fssh3, bffl8] = found;
            let [printed_fssh3, printed_bffl8] = printed;
            vec![
                format!("`{}`", constant.name),
                fssh3,
                bffl8,
                printed_fssh3,
                printed_bffl8,
            ]
        });
    text.table(
        &[
            "coefficient",
            "fssh3",
            "bffl8",
            "Table 1: fssh3",
            "Table 1: bffl8",
        ],
        rows,
    );
    let apart = (0..data.disc.coefficients.len()).map(|k| {
        let [a, b] = ways
            .each_ref()
            .map(|way| mean_and_deviation(&way.estimates[k]));
        (
            &data.disc.coefficients[k].name,
            (a.0 - b.0).abs() / a.1.hypot(b.1),
        )
    });
    let apart: Vec<String> = apart
        .filter(|(_, apart)| *apart > 3.0)
        .map(|(name, apart)| format!("`{name}` by {apart:.0}"))
        .collect();
    text.paragraph(format!(
        "One disc and one air, yet the two sets differ by more than three standard deviations of their difference: {}. Each flight sees \
         another stretch of curves that are neither straight nor parabolas about 0. Noise alone does not do that \
         (docs/identification.md). Where the columns of lift and drag are interchanged, as the paper's own statements ask (docs/paper.md), Table 1 has \
         `C_D0` 0.077 and `C_Da` 5.07 for bffl8: hold them against the drag found here, and against the parabola above that fits the tunnel \
         from -5° to 10°.",
        apart.join(", ")
    ));
}

/// The curve of the model's form that is nearest to the rows.
fn form(rows: &[Measured], which: usize) -> Option<Curve> {
    let (power, through_zero) = [(1, false), (2, false), (1, true)][which];
    Curve::fitted(rows, which, power, through_zero)
}

/// The model's own curves.
fn own(disc: &Model) -> [Curve; 3] {
    let value = |name: &str| {
        disc.coefficients
            .iter()
            .find(|c| c.name == name)
            .map_or(0.0, |c| c.value)
    };
    [
        Curve {
            constant: value("C_L0"),
            multiple: value("C_La"),
            power: 1,
        },
        Curve {
            constant: value("C_D0"),
            multiple: value("C_Da"),
            power: 2,
        },
        Curve {
            constant: 0.0,
            multiple: value("C_Ma"),
            power: 1,
        },
    ]
}

/// Angles that are drawn, degrees.
const DRAWN: (f64, f64) = (-30.0, 45.0);

fn drawn(data: &RealData) -> String {
    let rows = between(&data.table, DRAWN.0, DRAWN.1);
    let (low, high) = RANGES[1];
    let within = between(&data.table, low, high);
    let own = own(&data.disc);
    let panels: Vec<Panel> = (0..3)
        .map(|which| {
            let line = |name: &str, curve: Curve| Line {
                name: name.into(),
                points: (-60..=90)
                    .map(|k| f64::from(k) * 0.5)
                    .map(|a| (a, curve.at(a.to_radians())))
                    .collect(),
            };
            let mut lines = vec![line("model's", own[which])];
            lines.extend(form(&within, which).map(|curve| line("fitted", curve)));
            Panel {
                title: format!("{}, coefficient", NAMES[which]),
                across: "angle of attack, degrees".into(),
                lines,
                thin: true,
                dots: vec![Dots {
                    look: Look::Cross,
                    points: rows
                        .iter()
                        .map(|row| (row.alpha.to_degrees(), row.coefficients[which]))
                        .collect(),
                }],
                ..Panel::default()
            }
        })
        .collect();
    figure("A wind tunnel's table and the disc's curves", &panels)
}
