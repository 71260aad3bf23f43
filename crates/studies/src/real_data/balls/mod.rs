//! Table-tennis balls whose spin was measured apart from their path: what lifts them, and whether that is their spin.

pub mod page;

use diagnose::diagnosis::{Asked, diagnose};
use diagnose::report::Report as Diagnosis;
use identify::dataset::{Dataset, Flight, KnownValue, Role};
use identify::{FitOptions, FitReport, FlightEvidence, fit};
use model_spec::model::Model;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

/// A lift that nothing is said of, but that it is steady and turns the path; along the path's own direction, which is y, no turn shows.
const OWN_LIFT: &str = r#"
effect lift_of_each_flight {
  source "none: a lift of which only size and direction are asked";
  site lift;
  variables none;
  state turn_x = 0 rad/s;
  state turn_z = 0 rad/s;
  der(turn_x) = 0;
  der(turn_z) = 0;
  negligible turn_x 1e-3 rad/s;
  negligible turn_z 1e-3 rad/s;
  force own_lift = m*cross((turn_x, 0 [rad/s], turn_z) in N, air_velocity);
}
"#;

/// A lift by the square of the spin ratio, beside the effect `magnus`, whose lift it takes away from fast spins.
const BY_SQUARE: &str = r#"
effect magnus_by_square {
  source "none: the next power of the spin ratio after magnus";
  site lift;
  variables spin, speed;
  coefficient C_Lww = 0 in -5 .. 5;
  negligible C_Lww 1e-3;
  force by_square = rho_air/2*A*C_Lww*radius^2*norm(omega)*cross(omega, unit(air_velocity));
}
"#;

/// The names of the two effects above.
pub const OWN: &str = "lift_of_each_flight";
/// See [`OWN`].
pub const SQUARE: &str = "magnus_by_square";

/// Stretches of the files' numbers in which every flight is lifted to the side that its spin says.
pub const AGREEING: [(u32, u32); 2] = [(2, 54), (139, 213)];

/// Shuffles of the spins among the flights of a stretch.
const SHUFFLES: usize = 10_000;

/// The ball, with effects of the catalogue and those of this file switched on.
///
/// # Errors
/// In words.
pub fn ball(model: &Model, with: &[&str]) -> Result<Model, String> {
    let source = &model.sources[0];
    let text = format!("{}{OWN_LIFT}{BY_SQUARE}", source.text);
    model_spec::load::from_text(&source.name, &text, with).map_err(|error| error.to_string())
}

/// A fit of the ball with some effects.
///
/// # Errors
/// In words.
pub fn fitted(model: &Model, flights: &Dataset, with: &[&str]) -> Result<FitReport, String> {
    let model = ball(model, with)?;
    let fitted = fit(&model, flights, &FitOptions::default()).map_err(|error| error.to_string())?;
    Ok(fitted.report)
}

/// The number in a file's name.
pub fn number(file: &str) -> u32 {
    let digits: String = file.chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap_or(0)
}

/// Whether a flight lies in one of the agreeing stretches.
pub fn agrees(file: &str) -> bool {
    let number = number(file);
    AGREEING
        .iter()
        .any(|(first, last)| (*first..=*last).contains(&number))
}

/// The flights of the agreeing stretches.
pub fn agreeing(flights: &Dataset) -> Dataset {
    let mut part = flights.clone();
    part.flights.retain(|flight| agrees(&flight.file));
    part
}

/// One flight's lift as its path says, and the spin that was given with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// Its file.
    pub file: String,
    /// The mean speed, m/s.
    pub speed: f64,
    /// The direction of the flight from end to end.
    direction: [f64; 3],
    /// Coefficient of lift, about the axis that turns the path so.
    turn: [f64; 3],
    /// Spin ratio, by component.
    spin: [f64; 3],
    /// Root mean square of the residuals along y, m.
    pub along: f64,
    /// The same along x and z, m.
    pub across: f64,
}

impl Lift {
    /// Coefficient of lift, whatever its side.
    pub fn size(&self) -> f64 {
        norm(across(self.turn, self.direction))
    }

    /// Ratio of the surface's speed to the flight's, of the spin across the path.
    pub fn ratio(&self) -> f64 {
        norm(across(self.spin, self.direction))
    }

    /// Cosine of the angle between the lift and the side that some spin would lift to.
    fn cosine_with(&self, spin: [f64; 3]) -> f64 {
        let (turn, spin) = (
            across(self.turn, self.direction),
            across(spin, self.direction),
        );
        dot(turn, spin) / (norm(turn) * norm(spin)).max(f64::MIN_POSITIVE)
    }

    /// The same with its own spin.
    pub fn cosine(&self) -> f64 {
        self.cosine_with(self.spin)
    }

    /// Coefficient of lift to the side that the spin says.
    pub fn by_spin(&self) -> f64 {
        self.size() * self.cosine()
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn across(a: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
    let along = dot(a, direction);
    [0, 1, 2].map(|k| a[k] - along * direction[k])
}

/// The lift of each flight, all fitted; flights that cannot be fitted or have no spin are left out. With it the fit itself.
///
/// # Errors
/// In words.
pub fn lifts(model: &Model, flights: &Dataset) -> Result<(Vec<Lift>, FitReport), String> {
    let mut all = flights.clone();
    for flight in &mut all.flights {
        flight.role = Role::Fit;
    }
    let own = ball(model, &[OWN])?;
    let fitted = fit(&own, &all, &FitOptions::default()).map_err(|error| error.to_string())?;
    let constant = |name: &str| {
        let stated = all.parameters.get(name).copied();
        let default = model.params.iter().find(|p| p.name == name);
        stated
            .or(default.map(|p| p.value))
            .ok_or(format!("the ball has no {name}"))
    };
    let (mass, radius, rho) = (constant("m")?, constant("radius")?, constant("rho")?);
    let area = std::f64::consts::PI * radius * radius;
    let mut found = Vec::new();
    for (index, (flight, report)) in all.flights.iter().zip(&fitted.report.flights).enumerate() {
        let Some(KnownValue::Vector(omega)) = flight.known.get("omega") else {
            continue;
        };
        let turns = ["turn_x", "turn_z"].map(|name| report.initial.get(name).map(|e| e.value));
        let ([Some(turn_x), Some(turn_z)], Some(path), Some(evidence)) =
            (turns, end_to_end(flight), fitted.evidence(index))
        else {
            continue;
        };
        let speed = norm(path);
        let coefficient = 2.0 * mass / (rho * area * speed);
        let [x, along, z] = residuals(&evidence);
        found.push(Lift {
            file: flight.file.clone(),
            speed,
            direction: path.map(|part| part / speed),
            turn: [coefficient * turn_x, 0.0, coefficient * turn_z],
            spin: omega.map(|part| radius * part / speed),
            along,
            across: ((x * x + z * z) / 2.0).sqrt(),
        });
    }
    Ok((found, fitted.report))
}

/// Mean velocity between the first and the last sample that were seen; none where that is nothing.
fn end_to_end(flight: &Flight) -> Option<[f64; 3]> {
    let seen = flight.times.iter().zip(&flight.positions);
    let mut seen = seen.filter_map(|(t, row)| Some((*t, (*row.first()?)?)));
    let first = seen.next()?;
    let last = seen.next_back()?;
    let path = [0, 1, 2].map(|k| (last.1[k] - first.1[k]) / (last.0 - first.0));
    (norm(path) > 0.0).then_some(path)
}

/// Root mean square of the residuals along each axis, m.
fn residuals(evidence: &FlightEvidence) -> [f64; 3] {
    let each = (0..evidence.times.len()).filter_map(|sample| evidence.residual(sample, 0));
    let (mut squares, mut count) = ([0.0; 3], 0.0_f64);
    for residual in each {
        for (square, residual) in squares.iter_mut().zip(residual) {
            *square += residual * residual;
        }
        count += 1.0;
    }
    squares.map(|square| (square / count.max(1.0)).sqrt())
}

/// How well the spins of some flights fit their lifts, beside the same spins shuffled among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Flights.
    pub flights: usize,
    /// Mean cosine between the lift and the side that the spin says.
    pub cosine: f64,
    /// Mean of that mean over shuffles.
    pub shuffled: f64,
    /// Its standard deviation over shuffles.
    pub spread: f64,
    /// Part of the shuffles that do as well.
    pub by_chance: f64,
    /// The best mean cosine that turning or mirroring the axes of all spins alike can give.
    pub turned: f64,
    /// The same with the spins shuffled: mean over shuffles.
    pub turned_shuffled: f64,
}

/// Turns of the spins' axes that are tried.
const TURNS: usize = 2_000;

/// Shuffles under which turns are tried.
const TURNED_SHUFFLES: usize = 20;

/// The best mean cosine over random turns, and the same turns mirrored.
fn best_turned(lifts: &[&Lift], order: &[usize], turns: &[UnitQuaternion<f64>]) -> f64 {
    let means = turns.iter().map(|turn| {
        let each = lifts.iter().zip(order).map(|(lift, &k)| {
            let spin = turn * Vector3::from(lifts[k].spin);
            lift.cosine_with(spin.into())
        });
        // Mirroring through the origin changes every sign.
        each.sum::<f64>().abs() / lifts.len().max(1) as f64
    });
    means.fold(0.0, f64::max)
}

/// The agreement of some flights.
pub fn agreement(lifts: &[&Lift], seed: u64) -> Agreement {
    let mean = |order: &[usize]| {
        let each = lifts.iter().zip(order);
        let sum: f64 = each
            .map(|(lift, &k)| {
                // The other's spin, at this one's speed; the size does not matter to a cosine.
                lift.cosine_with(lifts[k].spin)
            })
            .sum();
        sum / lifts.len().max(1) as f64
    };
    let mut order: Vec<usize> = (0..lifts.len()).collect();
    let cosine = mean(&order);
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let means: Vec<f64> = (0..SHUFFLES)
        .map(|_| {
            order.shuffle(&mut random);
            mean(&order)
        })
        .collect();
    let count = means.len() as f64;
    let shuffled = means.iter().sum::<f64>() / count;
    let squares: f64 = means.iter().map(|m| (m - shuffled).powi(2)).sum();
    let turns: Vec<UnitQuaternion<f64>> = (0..TURNS)
        .map(|_| {
            let four = [0; 4].map(|_| StandardNormal.sample(&mut random));
            UnitQuaternion::from_quaternion(Quaternion::from(four))
        })
        .collect();
    let own: Vec<usize> = (0..lifts.len()).collect();
    let turned_shuffled = (0..TURNED_SHUFFLES).map(|_| {
        order.shuffle(&mut random);
        best_turned(lifts, &order, &turns)
    });
    Agreement {
        turned: best_turned(lifts, &own, &turns),
        turned_shuffled: turned_shuffled.sum::<f64>() / TURNED_SHUFFLES as f64,
        flights: lifts.len(),
        cosine,
        shuffled,
        spread: (squares / count).sqrt(),
        by_chance: means.iter().filter(|m| **m >= cosine).count() as f64 / count,
    }
}

/// What the diagnosis says of the plain ball, or with effects on.
///
/// # Errors
/// In words.
pub fn diagnosed(model: &Model, flights: &Dataset, with: &[String]) -> Result<Diagnosis, String> {
    let names: Vec<&str> = with.iter().map(String::as_str).collect();
    let model = match names.is_empty() {
        true => model.clone(),
        false => {
            let source = &model.sources[0];
            model_spec::load::from_text(&source.name, &source.text, &names)
                .map_err(|error| error.to_string())?
        }
    };
    let asked = Asked {
        dataset: "spindoe",
        with,
        ..Asked::default()
    };
    let diagnosed = diagnose(&model, flights, &asked).map_err(|error| error.to_string())?;
    Ok(diagnosed.report)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball that flies down y, turned about x and z, with a spin.
    fn lift(turn: [f64; 3], spin: [f64; 3]) -> Lift {
        Lift {
            file: "flight001.csv".into(),
            speed: 10.0,
            direction: [0.0, -1.0, 0.0],
            turn,
            spin,
            along: 0.0,
            across: 0.0,
        }
    }

    #[test]
    fn the_side_of_a_lift_is_that_of_its_spin_across_the_path() {
        let same = lift([0.2, 0.0, 0.1], [0.4, 0.7, 0.2]);
        assert!((same.cosine() - 1.0).abs() < 1e-12);
        assert!((same.by_spin() - 0.05_f64.sqrt()).abs() < 1e-12);
        assert!((same.ratio() - 0.2_f64.sqrt()).abs() < 1e-12);
        assert!((lift([0.2, 0.0, 0.0], [-0.4, 0.3, 0.0]).cosine() + 1.0).abs() < 1e-12);
        assert!(lift([0.2, 0.0, 0.0], [0.0, 0.3, 0.4]).cosine().abs() < 1e-12);
    }

    #[test]
    fn spins_in_other_axes_agree_once_they_are_turned() {
        // Right spins, all given in axes turned a quarter about y.
        let turned: Vec<Lift> = (0..24)
            .map(|k| f64::from(k) * 0.7)
            .map(|a| lift([a.cos(), 0.0, a.sin()], [a.sin(), 0.1, -a.cos()]))
            .collect();
        let found = agreement(&turned.iter().collect::<Vec<_>>(), 1);
        assert!(
            found.cosine.abs() < 1e-9 && found.turned > 0.95,
            "{found:?}"
        );
        assert!(found.turned_shuffled < 0.6, "{found:?}");
    }

    #[test]
    fn stretches_are_of_numbers() {
        assert!(agrees("flight054.csv") && !agrees("flight056.csv") && agrees("flight139.csv"));
        assert!(!agrees("flight291.csv"));
    }
}
