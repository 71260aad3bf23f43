//! Physical meaning of the states of a model, given by a chart or by the claimed body.

use crate::subject::{Bounded, Subject};
use flight::moore_penrose;
use model_spec::model::{ClaimedAttitude, FrameKind, Model};
use nalgebra::{DMatrix, DVector, Vector3};
use oracle::scalar::{ErrorBound, Real};
use oracle::{Chart, ClaimedBody, Physical, PhysicalRate, Point, Tree, moving};

const STEPS: usize = 60;
/// Maximum number of halvings of a Gauss-Newton step.
const HALVINGS: usize = 30;
/// Maximum residual of converged states, relative to 1 + norm of the quantity.
const CONVERGED: f64 = 1e-12;
/// Singular value, relative to the greatest, up to which states do not change the motion.
const RANK_TOLERANCE: f64 = 1e-10;

/// How the states of a model determine the physical state of its body.
pub enum Meaning<'a> {
    /// Each state is a component of a physical quantity.
    Chart(&'a Chart),
    /// The `claim` statement gives the quantities of a body; states are found from them numerically.
    Claim(&'a Model),
}

impl<'a> Meaning<'a> {
    /// Meaning of the states; `None` without a chart and a `claim` statement.
    pub fn of(subject: &'a Subject<'_>) -> Option<Self> {
        match &subject.chart {
            Some(chart) => Some(Self::Chart(chart)),
            None if subject.is_known_by_claim() => Some(Self::Claim(subject.model)),
            None => None,
        }
    }

    /// Whether the body has an attitude.
    pub fn has_attitude(&self) -> bool {
        match self {
            Self::Chart(chart) => chart.has_attitude(),
            Self::Claim(model) => model.claim.as_ref().is_some_and(|c| c.rotation.is_some()),
        }
    }

    /// Axis of revolution (1, 2 or 3) of the claimed body, which turns the frame of its inertia to the body frame.
    pub fn axis_of_revolution(&self) -> Option<u8> {
        let Self::Claim(model) = self else {
            return None;
        };
        let rotation = model.claim.as_ref()?.rotation.as_ref()?;
        match rotation.attitude {
            ClaimedAttitude::Frame(frame) if frame != rotation.inertia_frame => {
                match model.frames[frame].kind {
                    FrameKind::Turned { axis, .. } => Some(axis),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Physical state of the body at a point; `None` if a value is not finite.
    pub fn physical(&self, point: &Point<f64>) -> Option<Physical<f64>> {
        match self {
            Self::Chart(chart) => Some(chart.physical(&point.states)),
            Self::Claim(model) => {
                let body = ClaimedBody::of(&Tree::new(model, point))?;
                is_finite(&body).then(|| body.physical())
            }
        }
    }

    /// Rate of the physical state for rates of the states by true time; `pace`: flight time per recorded time.
    pub fn rate(&self, point: &Point<f64>, rates: &[f64], pace: f64) -> Option<PhysicalRate> {
        match self {
            Self::Chart(chart) => Some(chart.physical_rate(&point.states, rates)),
            Self::Claim(model) => Some(rate_of(&along(model, point, rates, 1.0 / pace)?)),
        }
    }

    /// States that represent a physical state; `None` if none were found. An iteration starts from the point `at`.
    pub fn states(&self, physical: &Physical<f64>, at: &Point<f64>) -> Option<Vec<f64>> {
        match self {
            Self::Chart(chart) => chart.states(physical),
            Self::Claim(model) => solved(model, physical, at),
        }
    }
}

fn is_finite(body: &ClaimedBody<f64>) -> bool {
    let turning = body.turning.iter();
    let of_turning = turning.flat_map(|t| t.axes.iter().chain(t.angular_velocity.iter()));
    let all = body.position.iter().chain(body.velocity.iter());
    all.chain(of_turning).all(|v| v.is_finite())
}

/// The claimed body with its derivatives with respect to true time. The error bounds are not used: another scalar type
/// would be compiled for this alone.
fn along(
    model: &Model,
    point: &Point<f64>,
    rates: &[f64],
    time_rate: f64,
) -> Option<ClaimedBody<Bounded>> {
    let rates: Vec<ErrorBound> = rates.iter().copied().map(ErrorBound::lit).collect();
    let moving = moving(&point.lift(), &rates, ErrorBound::lit(time_rate));
    ClaimedBody::of(&Tree::new(model, &moving))
}

fn rate_of(body: &ClaimedBody<Bounded>) -> PhysicalRate {
    let value = |v: &Vector3<Bounded>| v.map(|d| d.value.value);
    let derivative = |v: &Vector3<Bounded>| v.map(|d| d.derivative.value);
    let (angular_velocity, angular_acceleration) = match &body.turning {
        None => (Vector3::zeros(), Vector3::zeros()),
        Some(turning) => {
            let axis = |k: usize| turning.axes.column(k).into_owned();
            let turns = |k: usize| {
                let axis = axis(k);
                value(&axis).cross(&derivative(&axis))
            };
            let stated = value(&turning.angular_velocity);
            let omega = match turning.axis {
                // ω = ½ Σ axis × d(axis)/dt
                None => (turns(0) + turns(1) + turns(2)) / 2.0,
                // The spin rotates no axis, so it is taken from the stated angular velocity.
                Some(of_revolution) => {
                    let k = usize::from(of_revolution) - 1;
                    let normal = value(&axis(k));
                    turns(k) + normal * normal.dot(&stated)
                }
            };
            (omega, derivative(&turning.angular_velocity))
        }
    };
    PhysicalRate {
        velocity: derivative(&body.position),
        acceleration: derivative(&body.velocity),
        angular_velocity,
        angular_acceleration,
    }
}

/// Solves by damped Gauss-Newton steps, from the states of `at`, for the states of a physical state.
fn solved(model: &Model, physical: &Physical<f64>, at: &Point<f64>) -> Option<Vec<f64>> {
    let turning = ClaimedBody::of(&Tree::new(model, at))?.turning;
    let axes: Vec<u8> = turning.map_or_else(Vec::new, |t| t.turning_axes());
    let mut wanted: Vec<f64> = physical.position.iter().copied().collect();
    wanted.extend(physical.velocity.iter());
    for &axis in &axes {
        wanted.extend(physical.attitude.axis(axis).iter());
    }
    if !axes.is_empty() {
        wanted.extend(physical.angular_velocity.iter());
    }
    let wanted = DVector::from_vec(wanted);
    // Scales of position, velocity, axes and angular velocity, so that their residuals have equal weight.
    let mut sizes = vec![1.0 + physical.position.norm(); 3];
    sizes.extend([1.0 + physical.velocity.norm(); 3]);
    sizes.extend(axes.iter().flat_map(|_| [1.0; 3]));
    sizes.resize(wanted.len(), 1.0 + physical.angular_velocity.norm());
    let residual = |states: &[f64]| -> Option<DVector<f64>> {
        let point = Point {
            states: states.to_vec(),
            ..at.clone()
        };
        let found = quantities(&ClaimedBody::of(&Tree::new(model, &point))?, &axes);
        let scaled = found.iter().zip(wanted.iter()).zip(&sizes);
        Some(DVector::from_iterator(
            wanted.len(),
            scaled.map(|((found, wanted), size)| (found - wanted) / size),
        ))
    };
    let mut states = at.states.clone();
    let mut error = residual(&states)?;
    for _ in 0..STEPS {
        if error.amax() <= CONVERGED {
            return Some(states);
        }
        let jacobian = jacobian(model, &states, at, &axes, &sizes)?;
        let step = moore_penrose(&jacobian, RANK_TOLERANCE) * &error;
        let tried = (0..HALVINGS).find_map(|k| {
            let part = 0.5_f64.powi(k as i32);
            let moved = states.iter().zip(step.iter());
            let moved: Vec<f64> = moved.map(|(state, step)| state - part * step).collect();
            let left = residual(&moved)?;
            (left.norm() < error.norm()).then_some((moved, left))
        });
        (states, error) = tried?;
    }
    (error.amax() <= CONVERGED).then_some(states)
}

/// Jacobian of the [`quantities`] with respect to the states; each row is divided by its scale in `sizes`.
fn jacobian(
    model: &Model,
    states: &[f64],
    at: &Point<f64>,
    axes: &[u8],
    sizes: &[f64],
) -> Option<DMatrix<f64>> {
    let point = Point {
        states: states.to_vec(),
        ..at.clone()
    };
    let mut out = DMatrix::zeros(sizes.len(), states.len());
    for state in 0..states.len() {
        let mut seed = vec![0.0; states.len()];
        seed[state] = 1.0;
        let body = along(model, &point, &seed, 0.0)?;
        for (row, value) in quantities(&body, axes).iter().enumerate() {
            out[(row, state)] = value.derivative.value / sizes[row];
        }
    }
    Some(out)
}

/// Components of position, velocity, unit vectors of the body axes `axes`, and angular velocity.
fn quantities<T: Real>(body: &ClaimedBody<T>, axes: &[u8]) -> Vec<T> {
    let mut out: Vec<T> = body.position.iter().copied().collect();
    out.extend(body.velocity.iter());
    if let Some(turning) = &body.turning {
        for &axis in axes {
            out.extend(turning.axes.column(usize::from(axis) - 1).iter());
        }
        out.extend(turning.angular_velocity.iter());
    }
    out
}
