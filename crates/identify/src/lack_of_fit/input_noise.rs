//! What the noise of recorded inputs does to the predictions. No residual weight and no standard error counts it.

use dataset::statistics::{median, robust_sigma};
use flight::{InputSeries, InputsOverTime};
use nalgebra::DVector;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, Normal};

use super::FittedFlight;
use crate::fit::Fit;
use crate::least_squares::{NormalBlock, pseudo_inverse};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::FlightAt;
use crate::report::InputNoise;
use dataset::levels::MIN_SERIES;

/// Orders of the differences that show the noise of an input. In each further one a signal becomes smaller beside the
/// noise where its periods have three samples or more; beyond six, few samples of a flight are left.
const ORDERS: std::ops::RangeInclusive<u32> = 3..=6;

/// Effect on the predictions, over the noise of the measurements, below which the noise of inputs is negligible.
const NEGLIGIBLE: f64 = 0.3;

/// Effect over the residuals above which what looks like noise of an input is what the body got: with such noise they
/// would be larger.
const NOT_NOISE: f64 = 2.0;

/// Number of draws of noise, all of which must have such an effect: the noise moves few flights in few ways, so that its effect
/// varies. What was noise is taken for what the body got in one of twenty cases (Barnard 1963).
const DRAWS: u64 = 19;

/// Seed of the first draw of the noise that is added to the inputs.
const SEED: u64 = 1;

/// Sums of squares over flights, in units of the noise of the measurements.
#[derive(Default)]
struct Sums {
    effect: f64,
    residual: f64,
    count: f64,
}

impl InputNoise {
    /// The input whose noise moves the predictions of `fit` most, if that may be what the residuals show. `noise` is that
    /// of the measurements.
    pub(super) fn of_fit(
        fit: &Fit,
        flights: &[&FittedFlight<'_>],
        noise: &NoiseModel,
    ) -> Option<Self> {
        let layout = fit.problem().body.layout();
        let inputs = layout.varying.iter().filter_map(|id| {
            let name = &layout.parameters[id.index()];
            let (mut noisy, mut sigmas) = (Vec::new(), Vec::new());
            for flight in flights {
                let series = flight.observed.inputs.series();
                let own = series.into_iter().find(|(own, _)| own == id);
                let sigma = own.map_or(0.0, |(_, series)| sigma(series));
                if sigma > 0.0 {
                    sigmas.push(sigma);
                    noisy.push((*flight, sigma));
                }
            }
            let drawn = |draw: u64| {
                let sums = Sums::of_draw(fit, &noisy, noise, (name, SEED + draw));
                sums.map(|sums| sums.rms())
            };
            let (effect, residual) = drawn(0)?;
            let may_be_noise = |(effect, residual): (f64, f64)| effect < NOT_NOISE * residual;
            let matters = effect > NEGLIGIBLE
                && (may_be_noise((effect, residual))
                    || (1..DRAWS).any(|draw| drawn(draw).is_some_and(may_be_noise)));
            matters.then(|| Self {
                input: name.clone(),
                sigma: median(&mut sigmas),
                effect,
            })
        });
        inputs.max_by(|a, b| a.effect.total_cmp(&b.effect))
    }
}

/// Standard deviation of the noise of a recorded input: the least by its differences of [`ORDERS`]; 0 for too few samples.
fn sigma(series: &InputSeries) -> f64 {
    let mut differences: Vec<f64> = series.samples().map(|(_, value)| value).collect();
    if differences.len() < MIN_SERIES {
        return 0.0;
    }
    let (mut least, mut variance) = (f64::INFINITY, 1.0);
    for order in 1..=*ORDERS.end() {
        differences = differences
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect();
        // The variance of a difference of white noise, over that of the noise: 2, 6, 20, 70, …
        variance *= 4.0 - 2.0 / f64::from(order);
        if ORDERS.contains(&order) {
            let mut sizes: Vec<f64> = differences.iter().map(|own| own.abs()).collect();
            least = least.min(robust_sigma(&mut sizes) / f64::sqrt(variance));
        }
    }
    least
}

impl Sums {
    /// Sums over the flights, each with the noise of its input, for one input and one seed; `None` if one cannot be
    /// predicted.
    fn of_draw(
        fit: &Fit,
        flights: &[(&FittedFlight<'_>, f64)],
        noise: &NoiseModel,
        (name, seed): (&str, u64),
    ) -> Option<Self> {
        let mut sums = Self::default();
        for (flight, sigma) in flights {
            sums.add(fit, flight, noise, (name, *sigma, seed))?;
        }
        Some(sums)
    }

    /// Effect of the noise, and residuals: root mean squares.
    fn rms(&self) -> (f64, f64) {
        let rms = |squares: f64| (squares / self.count.max(1.0)).sqrt();
        (rms(self.effect), rms(self.residual))
    }

    /// Adds the effect of noise `sigma` of the input `name` on a flight, as far as no other initial state makes up for
    /// it; `None` if the flight cannot be predicted.
    fn add(
        &mut self,
        fit: &Fit,
        flight: &FittedFlight<'_>,
        noise: &NoiseModel,
        (name, sigma, seed): (&str, f64, u64),
    ) -> Option<()> {
        let at = fit.at(flight.id)?;
        let observed = at.observations;
        let noisy = Observations {
            inputs: noisy(fit, &observed.inputs, name, (sigma, seed))?,
            ..observed.clone()
        };
        let observations = &noisy;
        let other = FlightAt { observations, ..at }.residuals().ok()?;
        let none = DVector::zeros(0);
        let mut changes = NormalBlock::zero(observed.manifold.dimension(), 0);
        let mut squares = 0.0;
        let done = at.each_residual(&[], &mut |point| {
            let with_noise = other[point.channel].get(point.sample).copied().flatten();
            let (Some(with_noise), Some(_)) =
                (with_noise, observed.inlier(point.sample, point.channel))
            else {
                return;
            };
            let axes = at.problem.channels[point.channel].components;
            for (axis, other) in with_noise.into_iter().enumerate().take(axes) {
                let weight = 1.0 / noise.of(point.channel).sigma[axis];
                let row = DVector::from_row_slice(&point.rows[axis]) * weight;
                changes.add((other - point.residual[axis]) * weight, &row, &none);
                squares += (point.residual[axis] * weight).powi(2);
            }
        });
        done.ok()?;
        let gradient = &changes.local_gradient;
        let inverse = pseudo_inverse(&changes.local);
        let taken = inverse.map_or(0.0, |inverse| gradient.dot(&(inverse * gradient)));
        self.effect += (changes.squares - taken).max(0.0);
        self.residual += squares;
        self.count += changes.count as f64;
        Some(())
    }
}

/// The inputs with noise of standard deviation `sigma` added to one of them, by the seed.
fn noisy(
    fit: &Fit,
    inputs: &InputsOverTime,
    name: &str,
    (sigma, seed): (f64, u64),
) -> Option<InputsOverTime> {
    let layout = fit.problem().body.layout();
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noise = Normal::new(0.0, sigma).ok()?;
    let all = inputs.series().map(|(id, series)| {
        let own = layout.parameters[id.index()].as_str();
        let mut samples: Vec<(f64, f64)> = series.samples().collect();
        if own == name {
            for (_, value) in &mut samples {
                *value += noise.sample(&mut random);
            }
        }
        (own, InputSeries::new(&samples, series.interpolation()))
    });
    Some(InputsOverTime::of(layout, all))
}
