//! Inputs over time: scalar inputs of a model that vary during a flight.

mod table;

use std::sync::Arc;

use codegen::table::PiecewiseCubic;
use model_spec::layout::{Layout, ParamId};

pub use table::{TableFault, read_inputs};

/// Time by which a flight may outlast its inputs, s: rounding of the times of samples.
const END_TOLERANCE: f64 = 1e-9;

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
    pub fn span(&self) -> (f64, f64) {
        let knots = self.function.knots();
        (knots[0], knots[knots.len() - 1])
    }

    /// Time up to which a flight may last, s: that of the last sample, but for rounding.
    pub(crate) fn end(&self) -> f64 {
        self.span().1 + END_TOLERANCE
    }

    /// The samples: times in s, and values, SI.
    pub fn samples(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let values = self.function.cubics()[1..].iter().map(|cubic| cubic[0]);
        self.function.knots().iter().copied().zip(values)
    }

    /// How the samples are interpolated.
    pub fn interpolation(&self) -> InputInterpolation {
        self.interpolation
    }

    /// The input with the time counted from `origin`, s.
    pub fn since(&self, origin: f64) -> InputSeries {
        let knots = self.function.knots().iter().map(|t| t - origin).collect();
        InputSeries {
            function: PiecewiseCubic::new(knots, self.function.cubics().to_vec()),
            interpolation: self.interpolation,
        }
    }

    /// Times at which the input has a kink or a jump, s.
    fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        let pieces = self.function.cubics().windows(2);
        let is_smooth = self.interpolation == InputInterpolation::Cubic;
        let differ = move |pair: &[[f64; 4]]| {
            pair[0][1] != pair[1][1] || pair[1][1] == 0.0 && pair[0][0] != pair[1][0]
        };
        let knots = self.function.knots().iter().zip(pieces);
        knots.filter_map(move |(t, pair)| (!is_smooth && differ(pair)).then_some(*t))
    }
}

/// Inputs over time of one flight, each with the index of its parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InputsOverTime(Option<Arc<Vec<(ParamId, InputSeries)>>>);

impl InputsOverTime {
    /// The inputs of a model with this layout by their names. Those that the model lacks are left out.
    pub fn of<'a>(
        layout: &Layout,
        inputs: impl IntoIterator<Item = (&'a str, InputSeries)>,
    ) -> InputsOverTime {
        let all = inputs.into_iter();
        let known = all.filter_map(|(name, series)| {
            let id = layout.parameter(name)?;
            layout.varying.contains(&id).then_some((id, series))
        });
        let known: Vec<_> = known.collect();
        InputsOverTime((!known.is_empty()).then(|| Arc::new(known)))
    }

    /// Each input with the index of its parameter.
    pub fn iter(&self) -> impl Iterator<Item = &(ParamId, InputSeries)> {
        self.0.iter().flat_map(|all| all.iter())
    }

    /// Whether all inputs are constant.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Times at which an input has a kink or a jump, s.
    pub(crate) fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        self.iter().flat_map(|(_, series)| series.breaks())
    }

    /// `parameters` with the values of the inputs at time `t`, copied to `buffer` where an input varies.
    #[inline(always)]
    pub(crate) fn at<'b>(
        &self,
        t: f64,
        parameters: &'b [f64],
        buffer: &'b mut Vec<f64>,
    ) -> &'b [f64] {
        match &self.0 {
            None => parameters,
            Some(inputs) => {
                buffer.clear();
                buffer.extend_from_slice(parameters);
                for (id, series) in inputs.iter() {
                    buffer[id.index()] = series.at(t);
                }
                buffer
            }
        }
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
