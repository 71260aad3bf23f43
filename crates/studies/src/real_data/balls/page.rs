//! Table-tennis balls: what lifts them, and whether the spins that came with them are theirs.

use diagnose::gain::by_held_out;
use diagnose::report::{Gain, Report as Diagnosis};
use identify::dataset::{Dataset, Role};
use identify::{Coefficient, FitReport};
use model_spec::model::Model;
use report::figures::{Dots, Line, Look, Panel, figure};

use crate::markdown::{Text, percent, three};
use crate::real_data::balls::{
    AGREEING, Agreement, Lift, SQUARE, agreeing, agreement, agrees, diagnosed, fitted, lifts,
    number,
};

/// Effects that might bend all paths alike, fitted one by one.
const ALIKE: [&[&str]; 8] = [
    &["gravity"],
    &["tilted_vertical"],
    &["scale"],
    &["clock_rate"],
    &["wind"],
    &["drag_crisis"],
    &["magnus"],
    &["magnus", "spin_decay"],
];

/// Effects that are laid upon the lift by spin, one by one.
const BESIDE: [&str; 6] = [
    "spin_decay",
    "gravity",
    "tilted_vertical",
    "wind",
    "wind_by_height",
    "drag_crisis",
];

/// What was made of the balls.
pub struct Balls {
    /// Gravity and drag.
    pub plain: FitReport,
    /// Effects one by one, on all flights.
    alike: Vec<(&'static [&'static str], FitReport)>,
    lifts: Vec<Lift>,
    own: FitReport,
    /// Of all flights, of those whose spins agree with their lifts, of the others.
    pub agreeing: [Agreement; 3],
    /// Without and with lift by spin, and with its square, on the flights whose spins agree with their lifts.
    pub steps: [FitReport; 3],
    /// What is laid upon the lift by spin there.
    beside: Vec<(&'static str, [FitReport; 2])>,
    said: [Result<Diagnosis, String>; 3],
}

impl Balls {
    /// Fits the balls in every way of this page.
    ///
    /// # Errors
    /// In words.
    pub fn of(flights: &Dataset) -> Result<Self, String> {
        let model: Model =
            model_spec::load::load(&flights.model, &[]).map_err(|error| error.to_string())?;
        let of = |with: &[&str]| fitted(&model, flights, with);
        let (lifts, own) = lifts(&model, flights)?;
        let part = agreeing(flights);
        let of_part = |with: &[&str]| fitted(&model, &part, with);
        let (inside, outside): (Vec<&Lift>, Vec<&Lift>) =
            lifts.iter().partition(|lift| agrees(&lift.file));
        let alike = ALIKE.iter().map(|with| Ok((*with, of(with)?)));
        let beside = BESIDE.iter();
        let beside = beside.map(|effect| {
            let square = of_part(&["magnus", SQUARE, effect])?;
            Ok((*effect, [of_part(&["magnus", effect])?, square]))
        });
        Ok(Self {
            plain: of(&[])?,
            alike: alike.collect::<Result<_, String>>()?,
            agreeing: [
                agreement(&lifts.iter().collect::<Vec<_>>(), 0),
                agreement(&inside, 1),
                agreement(&outside, 2),
            ],
            steps: [
                of_part(&[])?,
                of_part(&["magnus"])?,
                of_part(&["magnus", SQUARE])?,
            ],
            beside: beside.collect::<Result<_, String>>()?,
            said: [
                diagnosed(&model, flights, &[]),
                diagnosed(&model, &part, &[]),
                diagnosed(&model, &part, &["magnus".into()]),
            ],
            lifts,
            own,
        })
    }
}

/// The section.
pub fn section(text: &mut Text, balls: &Balls) {
    text.paragraph("## Table-tennis balls (SpinDOE, arXiv 2303.03879)");
    plain(text, balls);
    all_alike(text, balls);
    own_lift(text, balls);
    whose_spin(text, balls);
    lift_by_spin(text, balls);
    said(text, balls);
}

fn plain(text: &mut Text, balls: &Balls) {
    let report = &balls.plain;
    let count = |role: Role| report.flights.iter().filter(|f| f.role == role).count();
    let drag = &report.coefficients["C_D"];
    text.paragraph(format!(
        "{} flights tracked by cameras, some 7 ms apart, 0.2 to 0.5 s long, each with a spin vector that was measured apart from its \
         path; the dataset holds every third out: {} are fitted, {} held out. Gravity and drag alone (`ball`) leave {:.1} mm (root mean \
         square of a coordinate), {:.1} along x, {:.1} along y, {:.1} along z, correlated by {:.2} from one sample to the next, with \
         `C_D` {}; {} of {} points ({}) are outliers. Such residuals are no noise of a camera.",
        report.flights.len(),
        count(Role::Fit),
        count(Role::HeldOut),
        1e3 * report.rms_m,
        1e3 * report.noise.axes["x"].sigma_m,
        1e3 * report.noise.axes["y"].sigma_m,
        1e3 * report.noise.axes["z"].sigma_m,
        report.noise.ar1,
        by_scatter(drag),
        report.noise.outliers,
        report.noise.points,
        percent(report.noise.outlier_fraction),
    ));
}

fn all_alike(text: &mut Text, balls: &Balls) {
    text.paragraph(
        "Nothing that bends all paths alike takes them away: with the effects below, alone or together, fitted to all flights \
         (± is the standard error by the scatter of the flights):",
    );
    let rows = balls.alike.iter().map(|(with, report)| {
        let own = report
            .coefficients
            .iter()
            .filter(|(name, _)| *name != "C_D");
        let own: Vec<String> = own
            .map(|(name, found)| format!("`{name}` {}", by_scatter(found)))
            .collect();
        let with: Vec<String> = with.iter().map(|name| format!("`{name}`")).collect();
        vec![
            with.join(", "),
            format!("{:.1}", 1e3 * report.rms_m),
            own.join(", "),
        ]
    });
    text.table(&["with", "leaves, mm", "coefficients"], rows);
}

fn own_lift(text: &mut Text, balls: &Balls) {
    let noise = &balls.own.noise.axes;
    let late = median(balls.lifts.iter().map(|lift| lift.along / lift.speed));
    text.paragraph(format!(
        "What is missing is a lift. Give each flight a steady lift across its path, of its own size and direction (two numbers a flight, and \
         nothing said of spin), and {:.1}, {:.1}, {:.1} mm are left along x, y, z; positions are given to 1 mm. All flights go down y: what \
         is left along the path is, in the median over flights, what samples {:.1} ms early or late would do, and times are given to 1 ms.",
        1e3 * noise["x"].sigma_m,
        1e3 * noise["y"].sigma_m,
        1e3 * noise["z"].sigma_m,
        1e3 * late,
    ));
}

fn median(each: impl Iterator<Item = f64>) -> f64 {
    let mut each: Vec<f64> = each.collect();
    each.sort_by(f64::total_cmp);
    each.get(each.len() / 2).copied().unwrap_or(f64::NAN)
}

fn whose_spin(text: &mut Text, balls: &Balls) {
    let [all, inside, outside] = balls.agreeing;
    let least = balls.lifts.iter().filter(|lift| agrees(&lift.file));
    let least = least.map(Lift::cosine).fold(f64::INFINITY, f64::min);
    let beyond = |limit: f64| {
        let others = balls.lifts.iter().filter(|lift| !agrees(&lift.file));
        others
            .filter(|lift| lift.cosine() * limit.signum() > limit.abs())
            .count()
    };
    let stretches: Vec<String> = AGREEING
        .iter()
        .map(|(first, last)| format!("{first} to {last}"))
        .collect();
    text.paragraph(format!(
        "Is it the spin's lift? Spin lifts to the side of ω × v; the figure has the cosine of the angle between that side and the lift that \
         the path shows. In the files {} every one of {} flights is lifted to the side that its spin says, within {:.0}° at worst: mean \
         cosine {:.3}. In the other stretches the mean of {} flights is {:.2}: {} are lifted to that side (cosine above 0.9) and {} \
         to the opposite one (below -0.9).",
        stretches.join(" and "),
        inside.flights,
        least.acos().to_degrees(),
        inside.cosine,
        outside.flights,
        outside.cosine,
        beyond(0.9),
        beyond(-0.9),
    ));
    let row = |name: &str, found: Agreement| {
        vec![
            name.into(),
            found.flights.to_string(),
            format!("{:.3}", found.cosine),
            format!("{:.3} ± {:.3}", found.shuffled, found.spread),
            if found.by_chance > 0.0 {
                percent(found.by_chance)
            } else {
                "none".into()
            },
            format!("{:.3}", found.turned),
            format!("{:.3}", found.turned_shuffled),
        ]
    };
    text.table(
        &[
            "files",
            "flights",
            "mean cosine",
            "spins shuffled among them",
            "shuffles that do as well",
            "axes turned at will",
            "the same, shuffled",
        ],
        [
            row("all", all),
            row(&stretches.join(", "), inside),
            row("the others", outside),
        ],
    );
    text.paragraph(
        "The stretches were chosen by this figure, so their row is a description and no test; the first row is a test. The lift \
         of the other stretches is as steady and as great, so their paths are good, and no turn or mirroring of the spins' axes \
         brings them nearer to their lifts than it brings spins that are shuffled. We read it so: in those stretches the spins are \
         not those of the flights that they stand with (or were measured wrong, which from here looks the same). No shift of the \
         order restores them; half of the source's flights are not in this folder. What follows uses the agreeing stretches. They \
         were chosen by the side of the lift: that side proves nothing further there, but its size, and how it goes with the spin, \
         had no part in the choice.",
    );
    text.paragraph(
        "![Side of the lift by file (crosses: the agreeing stretches), and their coefficient of lift by spin ratio](real-data-spin.svg)",
    );
}

fn lift_by_spin(text: &mut Text, balls: &Balls) {
    let names = [
        "gravity and drag",
        "with `magnus`",
        "with `magnus` and its square",
    ];
    let floor = balls.own.noise.sigma_m;
    let rows = names
        .iter()
        .zip(&balls.steps)
        .enumerate()
        .map(|(k, (name, report))| {
            let found = |name: &str| {
                report
                    .coefficients
                    .get(name)
                    .map_or(String::new(), by_scatter)
            };
            let gain = k
                .checked_sub(1)
                .and_then(|before| by_held_out(&balls.steps[before], report, floor));
            let held = by_held_out(report, report, floor);
            vec![
                (*name).into(),
                format!("{:.1}", 1e3 * report.rms_m),
                found("C_D"),
                found("C_Lw"),
                found("C_Lww"),
                held.map_or(String::new(), |held| {
                    format!("{:.1}", 1e3 * held.held_out_rms_before_m)
                }),
                gain.map_or(String::new(), |gain| gained(&gain)),
            ]
        });
    text.table(
        &[
            "model",
            "leaves, mm",
            "`C_D`",
            "`C_Lw`",
            "square",
            "held-out, mm",
            "gain on the row above, mm",
        ],
        rows,
    );
    let lift = &balls.steps[1].coefficients["C_Lw"];
    let error = lift.std_error_clustered.unwrap_or(lift.std_error);
    text.paragraph(format!(
        "Held-out flights have their initial state fitted on their first 30 % and the rest predicted. Lift by spin is found: `C_Lw` {} \
         (95 %: {} .. {} by the scatter of the flights). But it is no one number. By the path of each flight (figure) the lift is {} times \
         the spin ratio where that is below 0.3 and {} times where it is above 0.7: it levels off, as the lift of other balls does \
         (Nathan 2008 has 1/(2.32 + 0.4/S) of the spin ratio S for baseballs), and for table-tennis balls even a fall about S = 0.5 is reported \
         (Miyazaki and others 2017, \"Lift crisis of a spinning table tennis ball\").",
        by_scatter(lift),
        three(lift.value - 1.96 * error),
        three(lift.value + 1.96 * error),
        mean_ratio(balls, 0.0, 0.3),
        mean_ratio(balls, 0.7, f64::INFINITY),
    ));
    text.paragraph(
        "What else asks to be let in, with its standard error by the scatter of the flights (in brackets the value over that error):",
    );
    let names = balls.steps[2].coefficients.keys();
    let own: Vec<&String> = names.collect();
    let rows = balls.beside.iter().map(|(effect, [alone, square])| {
        let each = |report: &FitReport| -> Vec<String> {
            let found = report.coefficients.iter();
            let found = found.filter(|(name, _)| !own.contains(name));
            found
                .map(|(name, found)| {
                    let error = found.std_error_clustered.unwrap_or(found.std_error);
                    format!(
                        "`{name}` {} ({:.1})",
                        by_scatter(found),
                        found.value.abs() / error
                    )
                })
                .collect()
        };
        vec![
            format!("`{effect}`"),
            each(alone).join(", "),
            format!("{:.2}", 1e3 * alone.rms_m),
            each(square).join(", "),
            format!("{:.2}", 1e3 * square.rms_m),
        ]
    });
    text.table(
        &[
            "effect",
            "beside `magnus`",
            "leaves, mm",
            "beside `magnus` and its square",
            "leaves, mm",
        ],
        rows,
    );
    text.paragraph(
        "Beside `magnus` alone the decay of the spin stands in for the levelling off: it takes lift from the same flights. \
         Beside the square it is not asked for. A wind along the path is, a little; but it is bought with a smaller `C_D`, indoors, \
         and says rather that the drag is not quite that of one coefficient.",
    );
}

/// Mean ratio of the lift to the spin ratio, between two of those, in the agreeing stretches.
fn mean_ratio(balls: &Balls, low: f64, high: f64) -> String {
    let within = balls.lifts.iter().filter(|lift| agrees(&lift.file));
    let within = within.filter(|lift| (low..high).contains(&lift.ratio()));
    let (lift, ratio) = within.fold((0.0, 0.0), |(lift, ratio), each| {
        (lift + each.by_spin(), ratio + each.ratio())
    });
    format!("{:.2}", lift / ratio)
}

fn said(text: &mut Text, balls: &Balls) {
    let asked = [
        "`hyzer diagnose` of all flights",
        "Of the agreeing stretches",
        "Of the agreeing stretches with `magnus` on",
    ];
    for (asked, said) in asked.iter().zip(&balls.said) {
        match said {
            Ok(report) => {
                let tried = report.candidates.iter().find(|c| c.name == "magnus");
                let magnus = tried.map_or(String::new(), |c| {
                    let part = c.statistic / report.candidates.first().map_or(1.0, |c| c.statistic);
                    let left_out = report.agreement.as_ref().map_or(0, |a| a.contradicting.len());
                    let without = match left_out {
                        0 => String::new(),
                        n => format!(" (without the {n} that contradict)"),
                    };
                    format!(
                        " `magnus` alone would take {:.0} off the weighted sum of squares, {:.2} of what the best of all effects takes{without}.",
                        c.statistic, part
                    )
                });
                text.paragraph(format!("{asked}:{magnus}"));
                text.paragraph(format!("> {}", report.summary.replace('\n', "\n> ")));
            }
            Err(error) => {
                let line = error.lines().next().unwrap_or_default();
                text.paragraph(format!("{asked} fails: {line}"));
            }
        }
    }
    text.paragraph(
        "A cause stands for the diagnosis where what it leaves is noise, here a few millimetres that hardly depend on one another. Measured \
         lift scatters about any law of the measured spin by more than that, from flight to flight, and so no law stands in this \
         sense. What is named is what the flights agree on: \
         with the sign of each flight drawn at random, ten thousand times, the best agreement over all effects and terms at once is \
         as good as that on lift by spin no more often than the probability says. Beside it they agree on nothing more. The flights that contradict it are found by the fit alone, which knows nothing of the \
         stretches above; all of them lie in the others. A held-out flight is predicted with the lift unless its first part, on \
         which its initial state is fitted, contradicts it.",
    );
}

fn gained(gain: &Gain) -> String {
    format!(
        "{:.1} ± {:.1}",
        1e3 * (gain.held_out_rms_before_m - gain.held_out_rms_after_m),
        1e3 * gain.standard_error_m
    )
}

/// A value with its standard error by the scatter of the flights.
fn by_scatter(found: &Coefficient) -> String {
    let error = found.std_error_clustered.unwrap_or(found.std_error);
    format!("{} ± {}", three(found.value), three(error))
}

/// The figure.
pub fn drawn(balls: &Balls) -> String {
    let split = |inside: bool, at: fn(&Lift) -> (f64, f64)| -> Vec<(f64, f64)> {
        let each = balls
            .lifts
            .iter()
            .filter(|lift| agrees(&lift.file) == inside);
        each.map(at).collect()
    };
    let side = |lift: &Lift| (f64::from(number(&lift.file)), lift.cosine());
    let size = |lift: &Lift| (lift.ratio(), lift.by_spin());
    let value = |step: usize, name: &str| {
        let found = balls.steps[step].coefficients.get(name);
        found.map_or(0.0, |found| found.value)
    };
    let curve = |name: &str, step: usize| Line {
        name: name.into(),
        points: (0..=65)
            .map(|k| f64::from(k) * 0.02)
            .map(|s| (s, value(step, "C_Lw") * s + value(step, "C_Lww") * s * s))
            .collect(),
    };
    let panels = [
        Panel {
            title: "Cosine of lift and side that the spin says".into(),
            across: "number of the file".into(),
            dots: vec![
                Dots {
                    look: Look::Pale,
                    points: split(false, side),
                },
                Dots {
                    look: Look::Cross,
                    points: split(true, side),
                },
            ],
            levels: vec![0.0],
            up: Some((-1.1, 1.1)),
            ..Panel::default()
        },
        Panel {
            title: "Coefficient of lift to that side".into(),
            across: "spin ratio".into(),
            lines: vec![curve("magnus", 1), curve("its square", 2)],
            thin: true,
            dots: vec![Dots {
                look: Look::Cross,
                points: split(true, size),
            }],
            ..Panel::default()
        },
    ];
    figure("Spin and lift of table-tennis balls", &panels)
}
