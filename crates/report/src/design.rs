//! The page and text of a design.

use analysis::design::{Band, Bounds, Design, Landings, Path, QUANTILES, Sensitivity, Spread};
use flight::throw::FIELDS;
use nalgebra::{Rotation2, Vector2, Vector3};

use crate::figures::{Layout, Look, Mark, Panel};
use crate::text::fitted;
use crate::thin::{MAX_DOTS, stride};
use crate::{Figure, Html, Page, Table, Units, hundredths};

/// Number of line segments of a path; an ellipse has half as many.
const POINTS: usize = 200;

/// The page of a throw design.
pub fn page(
    title: &str,
    found: &Design,
    bounds: &Bounds,
    spread: &Spread,
    path: &Path<'_>,
) -> Page {
    let units = Units::Si;
    let mut lead = Html::new();
    for text in lead_words(found, units) {
        lead.paragraph(text);
    }
    lead.alarms("Mind", nearest(found, units));
    for text in spread_words(spread, bounds, units) {
        lead.paragraph(text);
    }
    let mut picture = Html::new();
    picture.leading_figure(Some(figure_of_path(found, bounds, path, spread)));
    let mut landings = Html::new();
    landings.figure(figure_of_landings(found, bounds, spread), true);
    let mut body = Html::new();
    body.opening(lead, picture, landings);
    let mut section = Html::new();
    section.paragraph(
        "What a unit of each number does to the place and the time of the landing and to the goal's figure: exact derivatives, by \
         the sensitivities of the flight. Where one unit less and one unit more land was flown.",
    );
    section.table(&throw(found, bounds, units));
    body.section("throw", "Throw", section);
    body.note(concat!("hyzer ", env!("CARGO_PKG_VERSION")));
    Page {
        kind: "hyzer design",
        title: title.into(),
        body,
        ..Page::default()
    }
}

/// Text of a throw design, in `units`.
pub fn text(found: &Design, bounds: &Bounds, spread: &Spread, units: Units) -> String {
    let sentences = nearest(found, units).into_iter();
    let sentences = sentences.chain(lead_words(found, units));
    let lines: String = sentences.map(|sentence| fitted(&sentence)).collect();
    let table = throw(found, bounds, units).text(usize::MAX);
    let spread = spread_words(spread, bounds, units).into_iter();
    lines + &table + &spread.map(|sentence| fitted(&sentence)).collect::<String>()
}

/// Sentence on a throw that does not serve its purpose; `None` if it does.
fn nearest(found: &Design, units: Units) -> Option<String> {
    (!found.feasible).then(|| {
        format!(
            "{}: not possible within these bounds, as far as {} throws and the descents from the best of them can tell; what comes \
             nearest misses by {:.3} {}.",
            found.goal_name(),
            found.flown,
            units.of_metres(found.miss),
            units.length()
        )
    })
}

fn lead_words(found: &Design, units: Units) -> Vec<String> {
    let (figure, unit) = found.figure_name();
    let (unit, size) = units.instead_of(unit);
    let (m, length) = (units.length(), |value| units.of_metres(value));
    let mut words = vec![format!(
        "{}: {figure} {:.4} {unit} without scatter. The throw lands at x {:.2} {m}, y {:.2} {m} after {:.2} s.",
        found.goal_name(),
        found.figure / size,
        hundredths(length(found.landing.x)),
        hundredths(length(found.landing.y)),
        found.time
    )];
    if let (Some(side), Some(clearance)) = (found.side, found.clearance) {
        words.push(format!(
            "Without scatter it passes {} of the obstacle, {:.3} {m} clear of it.",
            side.name(),
            length(clearance)
        ));
    }
    if let Some(speed) = found.vertical_speed {
        words.push(format!(
            "It rises at {:.3} {} at the target.",
            units.of(speed, "m/s"),
            units.speed()
        ));
    }
    words
}

/// Table of the quantities of the throw, their bounds, and what a unit of each does, flown in SI units alone.
fn throw(found: &Design, bounds: &Bounds, units: Units) -> Table {
    let size = |s: &Sensitivity| units.instead_of(FIELDS[s.field].1).1;
    let value = |s: &Sensitivity| {
        let value = found.throw.field(FIELDS[s.field].0);
        format!("{:.3}", value.unwrap_or(f64::NAN) / size(s))
    };
    let range = |s: &Sensitivity| {
        let range = bounds.ranges.iter().find(|range| range.0 == s.field);
        match range {
            Some((_, least, greatest)) if least < greatest => {
                let [least, greatest] = [least, greatest].map(|end| match size(s) {
                    1.0 => end.to_string(),
                    size => format!("{:.2}", end / size),
                });
                format!("{least} .. {greatest}")
            }
            Some(_) => "held".to_owned(),
            None => String::new(),
        }
    };
    let one_unit = |s: &Sensitivity, which: usize| match &s.one_unit[which] {
        Some(one) => format!("{:+.2}, {:+.2}", one.landing.x, one.landing.y),
        None => "no flight".to_owned(),
    };
    let slope = |value: f64| format!("{value:+.4}");
    let (m, metres) = (units.length(), units.instead_of("m").1);
    let goal = units.instead_of(found.figure_name().1).1;
    let is_si = units == Units::Si;
    Table::of(&found.sensitivity)
        .name("number", |s| {
            let (name, unit, ..) = FIELDS[s.field];
            format!("{name}, {}", units.instead_of(unit).0)
        })
        .number("value", |s| value(s))
        .number("bounds", |s| range(s))
        .number(&format!("x, {m}/unit"), |s| {
            slope(s.landing.x * size(s) / metres)
        })
        .number(&format!("y, {m}/unit"), |s| {
            slope(s.landing.y * size(s) / metres)
        })
        .number("time, s/unit", |s| slope(s.time * size(s)))
        .number("goal/unit", |s| {
            s.figure.map(|own| slope(own * size(s) / goal))
        })
        .when(is_si, |rows| {
            rows.number("one less, m", |s| one_unit(s, 0))
                .number("one more, m", |s| one_unit(s, 1))
        })
        .table()
}

fn figure_of_path(found: &Design, bounds: &Bounds, path: &Path<'_>, spread: &Spread) -> Figure {
    let place = |k: usize| path.position(path.duration() * k as f64 / POINTS as f64);
    let places: Vec<Vector3<f64>> = (0..=POINTS).map(place).collect();
    let length = spread.linear.mean.norm().max(1e-6);
    let along = spread.linear.mean / length;
    let left = Vector2::new(-along.y, along.x);
    let sampled = spread.sampled.as_ref();
    let bands = sampled.map_or(&[][..], |sampled| &sampled.bands);
    // The bands lie along the line to the landing, so the map is turned to it.
    let turned = |of: Vector2<f64>| (of.dot(&along), of.dot(&left));
    let landing = Mark::new("landing", turned(found.landing.xy()));
    let mut marks = vec![Mark::new("release", (0.0, 0.0)), landing];
    let mut side_marks = vec![Mark::new("release", (0.0, places[0].z))];
    if let Some(target) = found.target() {
        let at = turned(target.xy());
        marks.push(Mark::new("target", at));
        side_marks.push(Mark::new("target", (at.0, target.z)));
    }
    let ribbon = |of: &dyn Fn(&Band) -> [f64; 3]| {
        let points = bands
            .iter()
            .map(|band| (band.distance, of(band)[0], of(band)[2]));
        points.collect::<Vec<_>>()
    };
    let panel = |title: &str, marks, ribbon| Panel {
        marks,
        ribbon,
        map: true,
        ..Panel::new(title, "along the line from release to landing, m")
    };
    let title = "From above: to the left of the line, m";
    let mut above = panel(title, marks, ribbon(&|band| band.left))
        .line("", places.iter().map(|p| turned(p.xy())));
    if let Some(obstacle) = bounds.obstacle {
        let round = circle(obstacle.place, obstacle.radius);
        above = above.line("obstacle", round.into_iter().map(turned));
    }
    let height = ribbon(&|band| band.height);
    let side = panel("From the side: height, m", side_marks, height)
        .line("", places.iter().map(|p| (turned(p.xy()).0, p.z)));
    let caption = format!(
        "Blue: the throw. Shaded: between the {:.0} % and the {:.0} % quantile of the scattered throws that reach the distance.",
        100.0 * QUANTILES[0],
        100.0 * QUANTILES[2]
    );
    let title = "From above and from the side";
    Figure::of_panels("path", title, caption, Layout::COLUMN, &[above, side])
}

fn figure_of_landings(found: &Design, bounds: &Bounds, spread: &Spread) -> Figure {
    let points = |of: Vec<Vector2<f64>>| of.into_iter().map(|p| (p.x, p.y));
    let mut panel = Panel {
        marks: vec![Mark::new("landing", (found.landing.x, found.landing.y))],
        map: true,
        ..Panel::new("y, m", "x, m").line("linear", points(ellipse(&spread.linear)))
    };
    if let Some(sampled) = &spread.sampled {
        let landings = stride(&sampled.points, MAX_DOTS);
        let landings = landings.into_iter().map(|p| (p.x, p.y));
        panel = panel
            .line("sampled", points(ellipse(&sampled.landings)))
            .dots(Look::Pale, landings);
    }
    let aim = found.target().filter(|target| target.z == 0.0);
    let aim = aim.unwrap_or(found.landing).xy();
    let panel = panel.line("circle", points(circle(aim, bounds.circle)));
    let caption = "Ellipses that half of the landings are inside of, were they normal: blue by the exact derivatives, red dashed of \
                   the sampled flights; grey: sampled landings; green: the landing circle.";
    let title = "Scatter of the landings";
    Figure::of_panels("landings", title, caption, Layout::COLUMN, &[panel])
}

fn spread_words(spread: &Spread, bounds: &Bounds, units: Units) -> Vec<String> {
    let m = units.length();
    let of = |landings: &Landings| {
        let (long, short, _) = landings.ellipse(0.5);
        let [long, short] = [long, short].map(|axis| units.of_metres(axis));
        format!("half axes {long:.2} {m} and {short:.2} {m}")
    };
    let mut words = vec![format!(
        "Half of the landings are in an ellipse of {} to first order.",
        of(&spread.linear)
    )];
    let (Some(sampled), Some(inside)) = (&spread.sampled, spread.inside) else {
        return words;
    };
    let circle = match units {
        Units::Si => bounds.circle.to_string(),
        Units::Imperial => format!("{:.1}", units.of_metres(bounds.circle)),
    };
    words.push(format!(
        "Of {} flights ({} more had none): {}; {:.1} % land within {circle} {m} of the aim.",
        sampled.points.len(),
        sampled.failed,
        of(&sampled.landings),
        100.0 * inside
    ));
    let drawn = sampled.points.len() + sampled.failed;
    let percent = |share: f64| 100.0 * share;
    words.extend(spread.near_target.map(|share| {
        let near = percent(share);
        format!("Of {drawn} scattered throws {near:.1} % pass within {circle} {m} of the target.")
    }));
    words.extend(spread.touching.map(|share| {
        format!(
            "{:.1} % of the scattered flights touch the obstacle: a larger radius in [obstacle] keeps the throw clear of it.",
            percent(share)
        )
    }));
    words.extend(spread.agreement.map(|agreement| {
        let (least, greatest) = agreement.ratios;
        let shift = agreement.shift;
        if agreement.agrees {
            format!(
                "Linear and sampled spread agree: the means differ by {shift:.2} standard deviations, the standard deviations by \
                 factors of {least:.2} to {greatest:.2}."
            )
        } else {
            format!(
                "Linear and sampled spread do not agree: the means differ by {shift:.2} standard deviations, the sampled standard \
                 deviations are {least:.2} to {greatest:.2} times the linear ones. The landing is bent within this scatter: use the \
                 sampled spread."
            )
        }
    }));
    words
}

fn ellipse(landings: &Landings) -> Vec<Vector2<f64>> {
    let (long, short, direction) = landings.ellipse(0.5);
    let turn = Rotation2::new(direction);
    let points = round().map(|(c, s)| landings.mean + turn * Vector2::new(long * c, short * s));
    points.collect()
}

fn circle(place: Vector2<f64>, radius: f64) -> Vec<Vector2<f64>> {
    let points = round().map(|(c, s)| place + Vector2::new(c, s) * radius);
    points.collect()
}

/// Points (cosine, sine) of the unit circle; the first is repeated at the end.
fn round() -> impl Iterator<Item = (f64, f64)> {
    (0..=POINTS / 2).map(|k| {
        let (s, c) = (std::f64::consts::TAU * k as f64 / (POINTS / 2) as f64).sin_cos();
        (c, s)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use analysis::design::Scatter;
    use nalgebra::Matrix2;

    const LANDINGS: Landings = Landings {
        mean: Vector2::new(60.0, -3.0),
        covariance: Matrix2::new(25.0, 4.0, 4.0, 9.0),
    };

    /// Half of a normal distribution is within √(2 ln 2) standard deviations in two dimensions.
    #[test]
    fn half_of_the_landings_are_in_the_ellipse() {
        let inverse = LANDINGS.covariance.try_inverse().unwrap();
        let distances = ellipse(&LANDINGS).into_iter().map(|point| {
            let off = point - LANDINGS.mean;
            off.dot(&(inverse * off))
        });
        let distances: Vec<f64> = distances.collect();
        assert!(distances.len() > 20);
        for distance in distances {
            assert!((distance - 2.0 * 2.0_f64.ln()).abs() < 1e-9, "{distance}");
        }
    }

    #[test]
    fn the_spread_is_told_in_the_units_that_are_wished() {
        let spread = Spread {
            linear: LANDINGS,
            sampled: None,
            inside: None,
            near_target: None,
            touching: None,
            agreement: None,
        };
        let bounds = Bounds {
            ranges: Vec::new(),
            obstacle: None,
            circle: 5.0,
            scatter: Scatter {
                release: Vec::new(),
                wind: [0.0; 3],
                parameters: Vec::new(),
            },
        };
        let told = |units| spread_words(&spread, &bounds, units).join(" ");
        let (long, short, _) = LANDINGS.ellipse(0.5);
        let begin = "Half of the landings are in an ellipse of half axes";
        assert_eq!(
            told(Units::Si),
            format!("{begin} {long:.2} m and {short:.2} m to first order.")
        );
        let [long, short] = [long, short].map(|own| own / 0.3048);
        assert_eq!(
            told(Units::Imperial),
            format!("{begin} {long:.2} ft and {short:.2} ft to first order.")
        );
    }
}
