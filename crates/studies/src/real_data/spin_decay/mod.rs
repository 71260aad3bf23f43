//! How the spin of a disc in flight dies away: forms of the decay against a gyroscope's record.

pub mod page;

use std::path::Path;

use nalgebra::{DMatrix, DVector};

/// The throw within the record, s: between the hand and the ground.
pub const FLIGHT: (f64, f64) = (0.14, 2.38);

/// A spin's record: times from its beginning, s, and rates about the disc's axis, rad/s.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Times, s.
    pub times: Vec<f64>,
    /// Rates, rad/s.
    pub rates: Vec<f64>,
}

/// Reads `flight.csv`: `t,gx,gy,gz,…` in s and rad/s, the part of it that is the throw.
///
/// # Errors
/// In words, with the line.
pub fn read(file: &Path) -> Result<Record, String> {
    let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    let mut record = Record::default();
    let lines = text.lines().enumerate().skip(1);
    for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let mut cells = line.split(',').map(|cell| cell.trim().parse::<f64>().ok());
        let (Some(Some(time)), Some(Some(rate))) = (cells.next(), cells.nth(2)) else {
            let place = format!("{}:{}", file.display(), index + 1);
            return Err(format!("{place}: found {line:?}, expected t,gx,gy,gz"));
        };
        if (FLIGHT.0 - 1e-9..=FLIGHT.1 + 1e-9).contains(&time) {
            record.times.push(time - FLIGHT.0);
            record.rates.push(rate);
        }
    }
    if record.times.len() < 10 {
        return Err(format!("{}: found no throw", file.display()));
    }
    Ok(record)
}

/// A form of the decay. All begin with a spin and the part of it that is lost each second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A torque that is always the same.
    Constant,
    /// A torque by the spin.
    Linear,
    /// A torque by the spin's square.
    Quadratic,
    /// A torque by a power of the spin that is fitted too.
    Power,
    /// A torque by the spin and a factor that falls evenly with time, as the speed of the disc through the air may.
    Falling,
}

/// All forms.
pub const FORMS: [Form; 5] = [
    Form::Constant,
    Form::Linear,
    Form::Quadratic,
    Form::Power,
    Form::Falling,
];

impl Form {
    /// Where its numbers begin: spin, part lost each second, and the third where it has one.
    fn begin(self, record: &Record) -> DVector<f64> {
        let spin = record.rates.first().copied().unwrap_or(1.0);
        match self {
            Self::Power => DVector::from_vec(vec![spin, 0.04, 1.5]),
            Self::Falling => DVector::from_vec(vec![spin, 0.04, 0.05]),
            _ => DVector::from_vec(vec![spin, 0.04]),
        }
    }

    /// The spin at a time, s, from the release.
    fn at(self, numbers: &DVector<f64>, time: f64) -> f64 {
        let (spin, lost) = (numbers[0], numbers[1]);
        // dr/dt = -lost r (r/spin)^(power - 1), solved; a power of 1 is the limit.
        let by_power = |power: f64| match (power - 1.0).abs() < 1e-9 {
            true => spin * (-lost * time).exp(),
            false => {
                let left = 1.0 + (power - 1.0) * lost * time;
                spin * left.max(1e-9).powf(-1.0 / (power - 1.0))
            }
        };
        match self {
            Self::Constant => by_power(0.0),
            Self::Linear => by_power(1.0),
            Self::Quadratic => by_power(2.0),
            Self::Power => by_power(numbers[2]),
            Self::Falling => spin * (-lost * time * (1.0 - numbers[2] * time / 2.0)).exp(),
        }
    }
}

/// A form fitted under noise that is correlated from sample to sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Spin at the release, part of it lost each second there, and the form's third number.
    pub numbers: Vec<f64>,
    /// Their standard errors.
    pub errors: Vec<f64>,
    /// Root mean square of what is left, rad/s.
    pub rms: f64,
    /// The correlation from one sample to the next, fitted too.
    pub correlation: f64,
    /// Akaike's criterion.
    pub aic: f64,
}

/// Correlations that are tried.
const GRID: usize = 400;

/// The most likely fit of a form; none where the record is too poor for it.
pub fn fit(form: Form, record: &Record) -> Option<Fit> {
    let mut best: Option<Fit> = None;
    for step in 0..GRID {
        let found = under(form, record, step as f64 / GRID as f64);
        if let Some(found) = found
            && best.as_ref().is_none_or(|best| found.aic < best.aic)
        {
            best = Some(found);
        }
    }
    best
}

/// The same where the correlation is given: steps of Gauss and Newton on whitened residuals.
fn under(form: Form, record: &Record, correlation: f64) -> Option<Fit> {
    let count = record.times.len();
    let first = (1.0 - correlation * correlation).sqrt();
    let whiten = |values: &[f64]| {
        DVector::from_fn(count, |k, _| match k {
            0 => first * values[0],
            _ => values[k] - correlation * values[k - 1],
        })
    };
    let left = |numbers: &DVector<f64>| -> Vec<f64> {
        let each = record.times.iter().zip(&record.rates);
        each.map(|(time, rate)| rate - form.at(numbers, *time))
            .collect()
    };
    let mut numbers = form.begin(record);
    let mut normal = DMatrix::zeros(numbers.len(), numbers.len());
    for _ in 0..12 {
        let here = whiten(&left(&numbers));
        let columns: Vec<DVector<f64>> = (0..numbers.len())
            .map(|k| {
                let mut moved = numbers.clone();
                let size = 1e-6 * numbers[k].abs().max(1e-3);
                moved[k] += size;
                (&here - whiten(&left(&moved))) / size
            })
            .collect();
        let design = DMatrix::from_columns(&columns);
        normal = design.transpose() * &design;
        let step = normal
            .clone()
            .cholesky()?
            .solve(&(design.transpose() * here));
        numbers += step;
    }
    let residuals = left(&numbers);
    let squares = whiten(&residuals).norm_squared();
    let n = count as f64;
    let freedom = n - numbers.len() as f64;
    let covariance = normal.try_inverse()? * (squares / freedom);
    let deviance = n * (squares / n).ln() - 2.0 * first.ln();
    // The size of the noise and its correlation are fitted too.
    let aic = deviance + 2.0 * (numbers.len() as f64 + 2.0);
    aic.is_finite().then(|| Fit {
        errors: (0..numbers.len())
            .map(|k| covariance[(k, k)].sqrt())
            .collect(),
        numbers: numbers.iter().copied().collect(),
        rms: (residuals.iter().map(|r| r * r).sum::<f64>() / n).sqrt(),
        correlation,
        aic,
    })
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_chacha::ChaCha12Rng;
    use rand_distr::{Distribution, StandardNormal};

    use super::*;

    /// A spin that a form slows, integrated in small steps, under correlated noise.
    fn made(torque: impl Fn(f64, f64) -> f64) -> Record {
        let mut random = ChaCha12Rng::seed_from_u64(5);
        let (mut spin, mut noise) = (60.0, 0.0);
        let mut record = Record::default();
        for k in 0..225 {
            let time = f64::from(k) * 0.01;
            let fresh: f64 = StandardNormal.sample(&mut random);
            noise = 0.5 * noise + 0.008 * fresh;
            record.times.push(time);
            record.rates.push(spin + noise);
            for step in 0..100 {
                spin += 1e-4 * torque(spin, time + f64::from(step) * 1e-4);
            }
        }
        record
    }

    #[test]
    fn the_form_that_made_a_record_is_likeliest_and_its_rate_is_found() {
        type Torque = fn(f64, f64) -> f64;
        let torques: [(Form, Torque); 4] = [
            (Form::Constant, |_, _| -2.4),
            (Form::Linear, |spin, _| -0.04 * spin),
            (Form::Quadratic, |spin, _| -0.04 / 60.0 * spin * spin),
            (Form::Falling, |spin, time| {
                -0.04 * (1.0 - 0.2 * time) * spin
            }),
        ];
        for (form, torque) in torques {
            let record = made(torque);
            let of = |form| fit(form, &record).unwrap();
            let found = of(form);
            let pull = (found.numbers[1] - 0.04) / found.errors[1];
            assert!(pull.abs() < 3.5, "{form:?} {found:?}");
            assert!((0.3..0.7).contains(&found.correlation), "{found:?}");
            for other in [Form::Constant, Form::Linear, Form::Quadratic] {
                assert!(
                    other == form || of(other).aic > found.aic + 10.0,
                    "{form:?} {other:?}"
                );
            }
        }
    }
}
