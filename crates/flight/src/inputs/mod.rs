//! Inputs over time: scalar inputs of a model that vary during a flight.

mod lag;
mod table;

use std::sync::Arc;

use codegen::table::PiecewiseCubic;
use model_spec::layout::{Layout, ParamId};

use lag::Lagged;
pub use table::read_inputs;

/// Time by which a flight may outlast its inputs, or begin before them, s: rounding of the times of samples.
pub(crate) const END_TOLERANCE: f64 = 1e-9;

/// Interpolation of an input between its samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InputInterpolation {
    /// Straight lines from sample to sample.
    #[default]
    Linear,
    /// Each sample holds until the next one.
    Hold,
    /// A natural cubic spline.
    Cubic,
}

impl InputInterpolation {
    /// The interpolations by the words of files.
    #[doc(hidden)]
    pub const NAMES: [(&str, InputInterpolation); 3] = [
        ("linear", InputInterpolation::Linear),
        ("hold", InputInterpolation::Hold),
        ("cubic", InputInterpolation::Cubic),
    ];
}

/// An input as a function of time, given by its samples.
#[derive(Clone, Debug, PartialEq)]
pub struct InputSeries {
    function: PiecewiseCubic,
    interpolation: InputInterpolation,
}

impl InputSeries {
    /// Interpolates samples (time in s, value in SI), whose times increase.
    ///
    /// # Panics
    /// Without samples.
    pub fn new(samples: &[(f64, f64)], interpolation: InputInterpolation) -> InputSeries {
        let function = match interpolation {
            _ if samples.len() < 2 => PiecewiseCubic::hold(samples),
            InputInterpolation::Linear => PiecewiseCubic::linear(samples),
            InputInterpolation::Hold => PiecewiseCubic::hold(samples),
            InputInterpolation::Cubic => PiecewiseCubic::natural_spline(samples),
        };
        InputSeries {
            function,
            interpolation,
        }
    }

    /// Value at time `t` (s), SI. Before the first sample and after the last one, the interpolation continues.
    pub fn at(&self, t: f64) -> f64 {
        let (origin, [a, b, c, d]) = self.function.piece(t);
        let s = t - origin;
        a + s * (b + s * (c + s * d))
    }

    /// Times of the first and the last sample, s.
    #[doc(hidden)]
    pub fn span(&self) -> (f64, f64) {
        let knots = self.function.knots();
        (knots[0], knots[knots.len() - 1])
    }

    /// Time up to which a flight may last, s: that of the last sample, but for rounding.
    pub(crate) fn end(&self) -> f64 {
        self.span().1 + END_TOLERANCE
    }

    /// The samples: times in s, and values, SI.
    #[doc(hidden)]
    pub fn samples(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let values = self.function.cubics()[1..].iter().map(|cubic| cubic[0]);
        self.function.knots().iter().copied().zip(values)
    }

    /// Turning points between the samples: times in s, and values, SI; none of lines.
    #[doc(hidden)]
    pub fn extremes(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let intervals = self.function.knots().windows(2);
        let cubics = &self.function.cubics()[1..];
        intervals.zip(cubics).flat_map(move |(ends, cubic)| {
            let (from, length) = (ends[0], ends[1] - ends[0]);
            let inside = slopeless(*cubic)
                .into_iter()
                .filter(move |s| (0.0..length).contains(s));
            inside.map(move |s| (from + s, self.at(from + s)))
        })
    }

    /// How the samples are interpolated.
    #[doc(hidden)]
    pub fn interpolation(&self) -> InputInterpolation {
        self.interpolation
    }

    /// Time derivative of the input, per s; of a held one, the slope from sample to sample.
    fn rate(&self) -> InputSeries {
        let samples: Vec<(f64, f64)> = self.samples().collect();
        let (function, interpolation) = match self.interpolation {
            _ if samples.len() < 2 => (self.function.derivative(), self.interpolation),
            InputInterpolation::Cubic => (self.function.derivative(), self.interpolation),
            _ => {
                let lines = PiecewiseCubic::linear(&samples);
                (lines.derivative(), InputInterpolation::Hold)
            }
        };
        InputSeries {
            function,
            interpolation,
        }
    }

    /// The input with the time counted from `origin`, s.
    #[doc(hidden)]
    pub fn since(&self, origin: f64) -> InputSeries {
        let knots = self.function.knots().iter().map(|t| t - origin).collect();
        InputSeries {
            function: PiecewiseCubic::new(knots, self.function.cubics().to_vec()),
            interpolation: self.interpolation,
        }
    }

    /// Times at which the input is not one polynomial, s: a step across them would have a larger error than it estimates.
    fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        let pieces = self.function.cubics().windows(2);
        let knots = self.function.knots().iter().zip(pieces);
        let differ = |before: &[f64; 4], after: &[f64; 4]| match (before, after) {
            ([a, 0.0, 0.0, 0.0], [b, 0.0, 0.0, 0.0]) => a != b,
            ([_, before, 0.0, 0.0], [_, after, 0.0, 0.0]) => before != after,
            _ => true,
        };
        knots.filter_map(move |(t, pair)| differ(&pair[0], &pair[1]).then_some(*t))
    }
}

/// Arguments at which the slope of a cubic, given by its coefficients of rising power, is 0; NaN in place of none.
fn slopeless([_, b, c, d]: [f64; 4]) -> [f64; 2] {
    // By the formula for roots without cancellation: q/(3d) and b/q.
    let root = (c * c - 3.0 * b * d).sqrt();
    let q = -(c + root.copysign(c));
    [q / (3.0 * d), b / q]
}

/// An input over time of a model: its parameter, and those that go with it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RecordedInput {
    pub series: InputSeries,
    pub value: ParamId,
    /// The input `NAME_rate`, and the derivative.
    pub rate: Option<(ParamId, InputSeries)>,
    /// Time by which the input acts later than recorded, which the effect `delay_of_NAME` estimates.
    pub delay: Option<ParamId>,
    pub lag: Option<InputLag>,
}

/// First-order lag through which an input acts, which the effect `lag_of_NAME` estimates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct InputLag {
    /// The time constant.
    tau: ParamId,
    /// The input `NAME_lagging`: the decrease of what acts with the time constant.
    lagging: ParamId,
    /// Derivative of the input by the time.
    rate: InputSeries,
}

impl RecordedInput {
    /// Parameters of the model that vary with the input, in the order of [`RecordedInput::at`].
    pub fn parameters(&self) -> [Option<ParamId>; 3] {
        let rate = self.rate.as_ref().map(|(id, _)| *id);
        let lagging = self.lag.as_ref().map(|lag| lag.lagging);
        [Some(self.value), rate, lagging]
    }

    /// Values of the input, of its rate and of `NAME_lagging` at time `t`, s, where `value_of` gives the value of a
    /// parameter and `known` the responses of the lag at the samples, or nothing. The model subtracts delay × rate and
    /// time constant × lagging; with them the input is exactly what acts at that time.
    #[inline(always)]
    pub fn at(&self, t: f64, known: &[Lagged], value_of: impl Fn(ParamId) -> f64) -> [f64; 3] {
        let delay = self.delay.map_or(0.0, &value_of);
        let t = t - delay;
        let value = self.series.at(t);
        let rate = self.rate.as_ref().map_or(0.0, |(_, rate)| rate.at(t));
        let Some(lag) = &self.lag else {
            return [value + delay * rate, rate, 0.0];
        };
        let tau = value_of(lag.tau);
        if lag::is_none(tau) {
            return [value + delay * rate, rate, lag.rate.at(t)];
        }
        let lagged = lag::at(&self.series.function, t, tau, known);
        let rate = (value - lagged.value) / tau;
        let (acting, lagging) = (lagged.value, -lagged.by_tau);
        [acting + delay * rate + tau * lagging, rate, lagging]
    }

    /// Times at which the input as it acts is not one polynomial, s.
    pub fn breaks<'o>(&'o self, parameters: &[f64]) -> impl Iterator<Item = f64> + use<'o> {
        let delay = self.delay.map_or(0.0, |id| parameters[id.index()]);
        self.series.breaks().map(move |time| time + delay)
    }

    /// The input with 1 at the sample `k` and 0 at the others.
    pub(crate) fn unit(&self, k: usize) -> RecordedInput {
        let samples = self.series.samples().enumerate();
        let samples: Vec<(f64, f64)> = samples
            .map(|(index, (t, _))| (t, f64::from(u8::from(index == k))))
            .collect();
        let series = InputSeries::new(&samples, self.series.interpolation());
        let rate = series.rate();
        RecordedInput {
            rate: self.rate.as_ref().map(|(id, _)| (*id, rate.clone())),
            lag: self.lag.clone().map(|lag| InputLag { rate, ..lag }),
            series,
            ..*self
        }
    }

    /// Responses of a lag at the samples.
    pub(crate) fn responses(&self, parameters: &[f64]) -> Vec<Lagged> {
        let tau = self.lag.as_ref().map(|lag| parameters[lag.tau.index()]);
        let tau = tau.filter(|tau| !lag::is_none(*tau));
        tau.map_or_else(Vec::new, |tau| lag::at_knots(&self.series.function, tau))
    }
}

/// Inputs over time of one flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InputsOverTime {
    recorded: Arc<Vec<RecordedInput>>,
    /// Responses of the lag of each input at its samples; empty until the values of the parameters are known.
    responses: Vec<Vec<Lagged>>,
}

impl InputsOverTime {
    /// Parameter of the layout that varies with the input `name`: `NAME_recorded` where a state stands for its value in
    /// other flights.
    #[doc(hidden)]
    pub fn parameter(layout: &Layout, name: &str) -> Option<ParamId> {
        let recorded = format!("{name}_recorded");
        let mut ids = [name, &recorded].into_iter();
        ids.find_map(|name| {
            let id = layout.parameter(name)?;
            layout.varying.contains(&id).then_some(id)
        })
    }

    /// The inputs of the layout by name. A `NAME_rate` that is not given is the time derivative of `NAME`.
    pub fn of<'a>(
        layout: &Layout,
        inputs: impl IntoIterator<Item = (&'a str, InputSeries)>,
    ) -> InputsOverTime {
        let id_of = |name: &str| {
            let id = layout.parameter(name)?;
            layout.varying.contains(&id).then_some(id)
        };
        let inputs: Vec<(&str, InputSeries)> = inputs.into_iter().collect();
        let names: Vec<&str> = inputs.iter().map(|(name, _)| *name).collect();
        let known = inputs.into_iter().filter_map(|(name, series)| {
            let rate = format!("{name}_rate");
            let rate = id_of(&rate).filter(|_| !names.contains(&&*rate));
            let lagging = id_of(&format!("{name}_lagging"));
            let tau = layout.parameter(&format!("k_lag_of_{name}"));
            Some(RecordedInput {
                value: Self::parameter(layout, name)?,
                delay: rate.and_then(|_| layout.parameter(&format!("k_delay_of_{name}"))),
                lag: lagging.zip(tau).map(|(lagging, tau)| InputLag {
                    tau,
                    lagging,
                    rate: series.rate(),
                }),
                rate: rate.map(|id| (id, series.rate())),
                series,
            })
        });
        InputsOverTime {
            recorded: Arc::new(known.collect()),
            responses: Vec::new(),
        }
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &RecordedInput> {
        self.recorded.iter()
    }

    /// The inputs in a model with these values of its parameters.
    pub(crate) fn with_parameters(mut self, parameters: &[f64]) -> InputsOverTime {
        let responses = self.iter().map(|own| own.responses(parameters));
        self.responses = responses.collect();
        self
    }

    /// The inputs over time, each with its parameter; as recorded, without delay and lag.
    pub fn series(&self) -> impl Iterator<Item = (ParamId, &InputSeries)> {
        self.iter().map(|own| (own.value, &own.series))
    }

    /// Whether all inputs are constant.
    pub fn is_empty(&self) -> bool {
        self.recorded.is_empty()
    }

    /// Times at which an input is not one polynomial, s.
    pub(crate) fn breaks<'o>(&'o self, parameters: &'o [f64]) -> impl Iterator<Item = f64> + 'o {
        self.iter().flat_map(|own| own.breaks(parameters))
    }

    /// `parameters` with the values of the inputs at time `t`, copied to `buffer` where an input varies.
    #[inline(always)]
    pub(crate) fn at<'b>(
        &self,
        t: f64,
        parameters: &'b [f64],
        buffer: &'b mut Vec<f64>,
    ) -> &'b [f64] {
        if self.is_empty() {
            return parameters;
        }
        buffer.clear();
        buffer.extend_from_slice(parameters);
        for (index, own) in self.iter().enumerate() {
            let known = self.responses.get(index).map_or(&[][..], Vec::as_slice);
            let values = own.at(t, known, |id| parameters[id.index()]);
            for (id, value) in own.parameters().into_iter().zip(values) {
                if let Some(id) = id {
                    buffer[id.index()] = value;
                }
            }
        }
        buffer
    }
}

/// Values of the parameters in one flight: constants in the order of the model's [`Layout`], and inputs over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlightParameters {
    /// Values of all parameters, SI; those of inputs over time are not used.
    pub constants: Vec<f64>,
    /// Inputs that vary during the flight.
    pub inputs: InputsOverTime,
}

impl From<Vec<f64>> for FlightParameters {
    fn from(constants: Vec<f64>) -> FlightParameters {
        FlightParameters {
            constants,
            inputs: InputsOverTime::default(),
        }
    }
}
