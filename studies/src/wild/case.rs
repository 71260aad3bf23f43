//! One dataset of the study: its class, and the recording that follows from its seed.

use std::path::Path;

use dataset::synthesize::Corruption;
use model_spec::load::load;
use oracle::Law;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::classes::{CLASSES, Class};
use super::fly::fly;
use super::hidden::{Severity, factor_of_coefficients, hide, own_flights};
use super::recording::Recording;
use super::setting::{Measured, Setting};
use crate::own_models::{Hidden, SUBJECTS, Subject, hidden_of};
use crate::seeded::{SeededEffects, UNLISTED, ball, law, strength};

/// Numbers of flights of a dataset with hidden physics.
const FEW_AND_MANY: [usize; 2] = [2, 20];

/// Effects that are hidden in flights of a ball.
const OF_BALLS: [&str; 3] = ["magnus", "wind", "buoyancy"];

/// What is wrong with a dataset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Nothing is wrong, and the model lacks nothing.
    Clean,
    /// The recording, or what the user states about it, has a mistake.
    Mistake,
    /// The model lacks physics.
    Hidden,
}

impl Group {
    /// Name of the group on the page of results.
    pub fn label(self) -> &'static str {
        match self {
            Self::Clean => "nothing wrong",
            Self::Mistake => "mistake",
            Self::Hidden => "hidden physics",
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Disc(&'static Class),
    Effect {
        name: &'static str,
        severity: Severity,
        flights: usize,
    },
    Ball(Option<(&'static str, Severity)>),
    Own {
        subject: &'static Subject,
        hidden: Option<(Hidden, Severity)>,
        flights: usize,
    },
}

/// One simulated dataset of the study.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    kind: Kind,
    /// Number of the dataset within its class, from 0.
    pub run: u64,
}

/// Lists the datasets of the study whose class, group and number contain all of `words`: `seeds` of each class of
/// mistakes, a multiple of recordings with nothing wrong, and a fraction for each hidden effect.
pub fn cases(seeds: u64, words: &str) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |kind: Kind, runs: u64| cases.extend((0..runs).map(|run| Case { kind, run }));
    for class in CLASSES {
        add(Kind::Disc(class), seeds * class.share as u64);
    }
    add(Kind::Ball(None), seeds);
    for subject in &SUBJECTS {
        for flights in [4, 12] {
            let hidden = None;
            add(
                Kind::Own {
                    subject,
                    hidden,
                    flights,
                },
                seeds.div_ceil(4),
            );
        }
    }
    let few = seeds.div_ceil(16);
    for severity in [Severity::Mild, Severity::Severe] {
        for name in effects_of_discs() {
            for flights in FEW_AND_MANY {
                add(
                    Kind::Effect {
                        name,
                        severity,
                        flights,
                    },
                    few,
                );
            }
        }
        for name in OF_BALLS {
            add(Kind::Ball(Some((name, severity))), few);
        }
        for subject in &SUBJECTS {
            for (place, hidden) in hidden_of(subject).into_iter().enumerate() {
                let flights = if place % 2 == 0 { 12 } else { 2 };
                let hidden = Some((hidden, severity));
                add(
                    Kind::Own {
                        subject,
                        hidden,
                        flights,
                    },
                    few,
                );
            }
        }
    }
    cases.retain(|case| {
        let text = format!("{} {} #{}", case.class(), case.group().label(), case.run);
        words.split_whitespace().all(|word| text.contains(word))
    });
    cases
}

/// Names of the effects that can be hidden in flights of a disc: of every site of the catalogue, and outside of it.
fn effects_of_discs() -> Vec<&'static str> {
    let listed = law::all().filter(|effect| effect.laws.contains(&Law::Disc));
    let listed = listed.map(|effect| effect.name);
    let outside = UNLISTED
        .iter()
        .filter(|effect| effect.laws.contains(&Law::Disc));
    listed.chain(outside.map(|effect| effect.name)).collect()
}

impl Case {
    /// Name of the class of the dataset, such as `rolling shutter` or `hidden stall, mild, 2 flights`.
    pub fn class(&self) -> String {
        match self.kind {
            Kind::Disc(class) => class.name.to_owned(),
            Kind::Effect {
                name,
                severity,
                flights,
            } => {
                format!("hidden {name}, {}, {flights} flights", severity.label())
            }
            Kind::Ball(None) => "nothing wrong: ball".to_owned(),
            Kind::Ball(Some((name, severity))) => {
                format!("ball: hidden {name}, {}", severity.label())
            }
            Kind::Own {
                subject,
                hidden,
                flights,
            } => match hidden {
                None => format!("nothing wrong: {}, {flights} flights", subject.name),
                Some((hidden, severity)) => {
                    let (name, severity) = (hidden.name, severity.label());
                    format!(
                        "{}: hidden {name}, {severity}, {flights} flights",
                        subject.name
                    )
                }
            },
        }
    }

    /// Name of the row of the page's table to which the dataset belongs.
    pub fn row(&self) -> String {
        match self.kind {
            Kind::Disc(class) => class.name.to_owned(),
            Kind::Effect {
                severity, flights, ..
            } => {
                format!("effects of a disc, {}, {flights} flights", severity.label())
            }
            Kind::Ball(None) => self.class(),
            Kind::Ball(Some(_)) => "effects of a ball".to_owned(),
            Kind::Own { hidden: None, .. } => "nothing wrong: models in other words".to_owned(),
            Kind::Own {
                hidden: Some((_, severity)),
                ..
            } => {
                format!("effects of models in other words, {}", severity.label())
            }
        }
    }

    /// What is wrong with the dataset.
    pub fn group(&self) -> Group {
        match self.kind {
            Kind::Disc(class) => class.group,
            Kind::Ball(None) | Kind::Own { hidden: None, .. } => Group::Clean,
            Kind::Effect { .. } | Kind::Ball(Some(_)) | Kind::Own { .. } => Group::Hidden,
        }
    }

    /// Whether a diagnosis that identifies an effect, or several together, names what is in the dataset.
    /// `cause` is the effect that describes a mistake of the recording.
    pub(super) fn is_cause(&self, cause: Option<&str>, names: &[String], sites: &[String]) -> bool {
        let is_alone = |accepted: &str| names == [accepted];
        match self.kind {
            Kind::Disc(_) => cause.is_some_and(is_alone),
            Kind::Effect { name, .. } => {
                let near = crate::seeded::unlisted(name).and_then(|found| found.near);
                is_alone(name) || near.is_some_and(is_alone)
            }
            Kind::Ball(of) => of.is_some_and(|(name, _)| is_alone(name)),
            Kind::Own { hidden, .. } => hidden.is_some_and(|(hidden, _)| {
                let is_right = |site: &String| hidden.sites.contains(&site.as_str());
                !sites.is_empty() && sites.iter().all(is_right)
            }),
        }
    }

    fn seed(&self) -> u64 {
        let bytes = self.class().into_bytes().into_iter();
        let bytes = bytes.chain(self.run.to_le_bytes());
        // Other code multiplies seeds by 1000.
        model_spec::fingerprint(&bytes.collect::<Vec<u8>>()) >> 24
    }

    /// Writes the dataset to a folder, as the program `hyzer` reads it, with a file `truth.txt`: description, options of
    /// the fit, true coefficients.
    ///
    /// # Errors
    /// If the folder has other content, or cannot be written.
    pub fn write(&self, folder: &Path) -> std::io::Result<()> {
        let recording = self.recording(false);
        let mut text = format!(
            "{}, number {}\n{}\n",
            self.class(),
            self.run,
            recording.description
        );
        for (name, value) in &recording.fixed {
            text += &format!("--hold {name}={}\n", value.unwrap_or(f64::NAN));
        }
        for prior in &recording.priors {
            text += &format!("--prior {}={}+-{}\n", prior.name, prior.value, prior.sigma);
        }
        for own in &recording.model.coefficients {
            text += &format!("{} within {:?}\n", own.name, own.bounds);
        }
        for (name, value) in &recording.truth {
            text += &format!("{name} = {value}\n");
        }
        dataset::write_with(folder, &recording.dataset, &[("truth.txt".into(), text)])
    }

    /// Simulates the recording, without noise if `is_exact`.
    pub(super) fn recording(&self, is_exact: bool) -> Recording {
        let seed = self.seed();
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(u64::MAX - 4);
        match self.kind {
            Kind::Disc(class) => of_class(class, is_exact, seed, &mut random),
            Kind::Effect {
                name,
                severity,
                flights,
            } => {
                let mut setting = Setting::draw(Measured::Markers, &mut random);
                setting.flights = flights;
                hide(&mut setting, name, severity, seed, &mut random);
                with_hidden(&setting, is_exact, seed)
            }
            Kind::Ball(hidden) => of_ball(hidden, is_exact, seed, &mut random),
            Kind::Own {
                subject,
                hidden,
                flights,
            } => of_own(subject, hidden, flights, is_exact, seed, &mut random),
        }
    }
}

fn of_class(class: &Class, is_exact: bool, seed: u64, random: &mut ChaCha12Rng) -> Recording {
    let measured = class.measured[random.random_range(0..class.measured.len())];
    let mut setting = Setting::draw(measured, random);
    (class.prepare)(&mut setting, random);
    let mut recording = flown(&setting, is_exact, seed);
    (class.spoil)(&mut recording, random);
    recording
}

fn flown(setting: &Setting, is_exact: bool, seed: u64) -> Recording {
    let model = load(setting.model, &[]).expect("a built-in model");
    let exact = setting.exact();
    let dataset = fly(&model, if is_exact { &exact } else { setting }, seed);
    Recording::of(model, dataset, setting)
}

fn with_hidden(setting: &Setting, is_exact: bool, seed: u64) -> Recording {
    let mut recording = flown(setting, is_exact, seed);
    let factor = factor_of_coefficients(&setting.hidden);
    recording.scale_truth(factor, |name| name != "C_Nr");
    let SeededEffects {
        listed, unlisted, ..
    } = &setting.hidden;
    for (_, values) in listed {
        let values: Vec<String> = values.iter().map(|value| format!("{value:.2e}")).collect();
        recording.note(values.join(" "));
    }
    for (_, size) in unlisted {
        recording.note(format!("{size:.2e}"));
    }
    recording
}

/// Draws the noise of a recording, m.
fn sigma(random: &mut impl Rng) -> f64 {
    5e-4 * 8.0_f64.powf(random.random::<f64>())
}

fn of_ball(
    hidden: Option<(&str, Severity)>,
    is_exact: bool,
    seed: u64,
    random: &mut impl Rng,
) -> Recording {
    let sigma = sigma(random);
    let mut seeded = match hidden {
        None => SeededEffects::default(),
        Some((name, severity)) => {
            let found = strength(name).expect("a strength of every effect");
            let values = match severity {
                Severity::Mild => found.weak,
                Severity::Severe => found.strong,
            };
            SeededEffects::listed(name, values)
        }
    };
    if !is_exact {
        seeded = seeded.with_noise(Corruption {
            sigma,
            ..Corruption::default()
        });
    }
    let flights = [1, 2, 4, 8, 12, 20][random.random_range(0..6)];
    let rate = [30.0, 60.0, 120.0, 240.0][random.random_range(0..4)];
    let plan = ball::Plan {
        flights,
        rate,
        ..ball::TABLE_TENNIS
    };
    let model = load("ball", &[]).expect("the built-in ball");
    let truth = plan
        .truth
        .iter()
        .map(|(name, value)| ((*name).to_owned(), *value));
    Recording {
        truth: truth.collect(),
        dataset: ball::dataset(&plan, &seeded, seed),
        model,
        fixed: Vec::new(),
        cause: None,
        priors: Vec::new(),
        sigma: Some(sigma),
        description: format!("{flights} flights, {rate} Hz, {:.1} mm", 1e3 * sigma),
    }
}

fn of_own(
    subject: &Subject,
    hidden: Option<(Hidden, Severity)>,
    flights: usize,
    is_exact: bool,
    seed: u64,
    random: &mut impl Rng,
) -> Recording {
    let sigma = sigma(random);
    let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
    let hidden = hidden.map(|(hidden, severity)| {
        let [weak, strong] = hidden.sizes;
        let size = if severity == Severity::Mild {
            weak
        } else {
            strong
        };
        (hidden, sign * size)
    });
    let model = subject.model();
    let noise = if is_exact { 0.0 } else { sigma };
    // No flight of a kite tells its mass from its coefficients.
    let mass = match hidden {
        Some((hidden, size)) if hidden.name == "heavy" => 1.0 + size,
        _ => 1.0,
    };
    let truth = model.coefficients.iter();
    let truth = truth.map(|own| (own.name.clone(), own.value * subject.truth / mass));
    Recording {
        truth: truth.collect(),
        dataset: own_flights(subject, hidden, flights, noise, seed),
        model,
        fixed: Vec::new(),
        cause: None,
        priors: Vec::new(),
        sigma: Some(sigma),
        description: format!("{flights} flights, 120 Hz, {:.1} mm", 1e3 * sigma),
    }
}
