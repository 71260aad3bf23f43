//! Criteria for the stability of the axis of a body of revolution in the air stream, with or without spin: derived from
//! the linearised equations of the axis.
//!
//! Let ω1, ω2 be the angular rates about d1, d2 in axes that do not spin, I_a, I_d the moments of inertia, r the spin
//! and α the angle of attack, and let the aerodynamic moment be −D ω1 about d1 and −D ω2 − K α about d2:
//!
//! ```text
//! I_d ω̇1 = −D ω1 − I_a r ω2
//! I_d ω̇2 =  I_a r ω1 − D ω2 − K α
//! α̇      = −ω2 − a α
//! ```
//!
//! a is the rate at which lift turns the path into the disc's plane. Divided by I_d (δ = D/I_d, κ = K/I_d, ν = I_a
//! r/I_d), the eigenvalues are the zeros of (s + a)[(s + δ)² + ν²] − κ (s + δ), and the Routh–Hurwitz criterion gives
//! the three conditions of [`Criteria`]. Without spin, ν = 0, these are the conditions for an ordinary wing.
//!
//! A projectile flies along its axis, and the air has no other preferred direction. With the complex angle of attack ξ,
//! the overturning moment κ ξ and the Magnus moment i μ ξ (divided by I_d), its axis follows
//!
//! ```text
//! ξ̈ + (H − i ν) ξ̇ − (M + i W) ξ = 0,   H = a + δ,   M = κ − a δ,   W = μ + a ν
//! ```
//!
//! (McCoy, Modern Exterior Ballistics, chapter 10, in units of time), whose roots decay where H > 0 and 1/S_g < S_d (2 −
//! S_d), with S_g = ν²/(4 M) and S_d = 2 W/(H ν).

use nalgebra::{Complex, DMatrix, Vector3};

use crate::stability::linearise::{Linearised, any_normal};
use crate::stability::modes::{NEUTRAL, ROUNDING};

/// Direction in which a body flies relative to its third axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlightDirection {
    /// The axis is nearer to the normal of the air velocity than to its direction, as for a disc.
    AcrossAxis,
    /// The axis is nearer to the direction of the air velocity, forwards or backwards, as for a bullet or a javelin.
    AlongAxis,
}

/// Derivatives of the linearised motion that determine how the axis of a body moves in the air stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisDerivatives {
    /// Direction of flight.
    pub flight: FlightDirection,
    /// Decay rate a of the angle of attack due to lift, 1/s: q A (C_La + C_D)/(m V) for the built-in discs.
    pub lift: f64,
    /// Decay rate δ of the angular rates normal to the axis due to damping, 1/s: −q A d C_Mq/I_d.
    pub damping: f64,
    /// Angular acceleration κ per rad of the angle of attack, 1/s²: −q A d C_Ma/I_d; positive if deviations grow.
    pub pitching: f64,
    /// Angular acceleration μ by the Magnus moment, per rad of the angle of attack, 1/s²; 0 if not along the axis.
    pub magnus: f64,
    /// Frequency ν of the nutation without aerodynamic moments, rad/s: I_a r/I_d with the spin r.
    pub gyroscopic: f64,
    /// Aerodynamic moment about d2, to the left and normal to the axis, divided by I_d, 1/s², at the state.
    pub moment: f64,
}

/// Criteria for the stability of the axis of a body in the air stream; the symbols are those of [`AxisDerivatives`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// Gyroscopic stability factor S = (ν² + δ² + 2 a δ)/κ, or S_g = ν²/(4 (κ − a δ)) along the axis. Spin and damping
    /// stabilise the axis if it is above 1; it is infinite or negative where the pitching moment does not destabilise it.
    pub gyroscopic_factor: f64,
    /// Dynamic stability factor S_d = 2 (μ + a ν)/((a + δ) ν) along the axis; stable if 1/S_g < S_d (2 − S_d).
    pub dynamic_factor: Option<f64>,
    /// Whether ν² + δ² + 2 a δ > κ; along the axis, whether S_g > 1 or κ ≤ a δ.
    pub gyroscopic: bool,
    /// Whether a (ν² + δ²) ≥ κ δ: lift turns the path faster than the axis drifts; along the axis, the slower motion.
    pub slow: bool,
    /// Whether (2 δ + a)(ν² + δ² + 2 a δ − κ) ≥ a (ν² + δ²) − κ δ: the wobble, or the faster motion, does not grow.
    pub wobble: bool,
    /// Frequency of the nutation, |ν| − κ/(2 |ν|), rad/s, to first order in κ/ν².
    pub nutation: f64,
    /// Decay rate of the nutation, δ − κ (a − δ)/(2 ν²), 1/s.
    pub nutation_decay: f64,
    /// Rate of tilt to the right, rad/s: −M/(I_a r), M about d2 (Crowther and Potts); NaN along the axis.
    pub roll_rate: f64,
}

impl AxisDerivatives {
    /// Computes the derivatives of a linearised motion in air with the velocity `wind`, m/s, in inertial axes.
    pub fn of(linearised: &Linearised, wind: Vector3<f64>) -> AxisDerivatives {
        let n = linearised.axis;
        let velocity = linearised.motion.velocity - wind;
        let least = ROUNDING * linearised.matrix.norm();
        let kept = |value: f64| if value.abs() < least { 0.0 } else { value };
        let all = match n.dot(&velocity).abs() > velocity.norm() * std::f64::consts::FRAC_1_SQRT_2 {
            true => AxisDerivatives::along_axis(linearised, velocity),
            false => AxisDerivatives::across_axis(linearised, velocity),
        };
        AxisDerivatives {
            lift: kept(all.lift),
            damping: kept(all.damping),
            pitching: kept(all.pitching),
            magnus: kept(all.magnus),
            ..all
        }
    }

    /// Derivatives of a body that flies across its axis.
    fn across_axis(linearised: &Linearised, velocity: Vector3<f64>) -> AxisDerivatives {
        let n = linearised.axis;
        let flat = velocity - n * n.dot(&velocity);
        let d1 = flat.try_normalize(1e-9).unwrap_or_else(Vector3::x);
        let d2 = n.cross(&d1);
        let spin = linearised.rates.dot(&n);
        let matrix = &linearised.matrix;
        let entry = |row: usize, left: Vector3<f64>, column: usize, right: Vector3<f64>| -> f64 {
            (left.transpose() * matrix.fixed_view::<3, 3>(row, column) * right)[0]
        };
        // Angular rates about axes that move with the body but do not spin: ω1' = ω1 − r φ2, ω2' = ω2 + r φ1.
        let rate_1 = entry(9, d1, 9, d1);
        let rate_2 = entry(9, d2, 9, d2);
        let cross = 0.5 * (entry(9, d2, 9, d1) - entry(9, d1, 9, d2));
        let by_tilt = entry(9, d2, 6, d2) + spin * entry(9, d2, 9, d1);
        let speed = velocity.norm().max(1e-9);
        AxisDerivatives {
            flight: FlightDirection::AcrossAxis,
            magnus: 0.0,
            lift: -entry(3, n, 6, d2) / speed,
            damping: -0.5 * (rate_1 + rate_2),
            pitching: by_tilt,
            gyroscopic: cross + spin,
            // The moment is the angular acceleration of the axis minus its gyroscopic part at the present angular rate.
            moment: linearised.angular_acceleration.dot(&d2) - cross * linearised.rates.dot(&d1),
        }
    }

    /// Derivatives of a body that flies along its axis: means over the two directions normal to the axis.
    fn along_axis(linearised: &Linearised, velocity: Vector3<f64>) -> AxisDerivatives {
        let n = linearised.axis;
        let backwards = n.dot(&velocity).signum();
        let e1 = any_normal(n);
        let e2 = n.cross(&e1);
        let spin = linearised.rates.dot(&n);
        let block = |row: usize, column: usize| linearised.matrix.fixed_view::<3, 3>(row, column);
        // A tilt of the axis towards e, with the angular velocity normal to the axis held.
        let tilted = |e: Vector3<f64>| block(9, 6) * n.cross(&e) + block(9, 9) * (e * spin);
        let turned = |e: Vector3<f64>| block(9, 9) * e;
        let lifted = |e: Vector3<f64>| block(3, 6) * n.cross(&e);
        // Complex mean (part along, part a quarter turn ahead) of a response to e1 and e2.
        let mean = |of: &dyn Fn(Vector3<f64>) -> Vector3<f64>| {
            let (of_1, of_2) = (of(e1), of(e2));
            let along = 0.5 * (e1.dot(&of_1) + e2.dot(&of_2));
            Complex::new(along, 0.5 * (e2.dot(&of_1) - e1.dot(&of_2)))
        };
        let (rates, moment) = (mean(&turned), mean(&tilted));
        AxisDerivatives {
            flight: FlightDirection::AlongAxis,
            lift: mean(&lifted).re * backwards / velocity.norm().max(1e-9),
            damping: -rates.re,
            // The axis turns a quarter turn behind the moment: κ + iμ = −i G.
            pitching: moment.im,
            magnus: -moment.re,
            gyroscopic: rates.im + spin,
            moment: 0.0,
        }
    }

    /// Eigenvalues of the motion of the axis, 1/s: the zeros of (s + a)[(s + δ)² + ν²] − κ (s + δ), or the two of
    /// s² + (H − i ν) s − (M + i W) for a body that flies along its axis.
    pub fn eigenvalues(&self) -> Vec<Complex<f64>> {
        if self.flight == FlightDirection::AlongAxis {
            return self.circular_motions().to_vec();
        }
        let (a, d) = (self.lift, self.damping);
        let (k, h) = (self.pitching, self.gyroscopic);
        let matrix = DMatrix::from_row_slice(3, 3, &[-d, -h, 0.0, h, -d, -k, 0.0, -1.0, -a]);
        matrix.complex_eigenvalues().iter().copied().collect()
    }

    /// The criteria with these derivatives.
    pub fn criteria(&self) -> Criteria {
        match self.flight {
            FlightDirection::AcrossAxis => self.criteria_across_axis(),
            FlightDirection::AlongAxis => self.criteria_along_axis(),
        }
    }

    /// Zeros of s² + (H − i ν) s − (M + i W), 1/s: the faster and the slower circular motion.
    fn circular_motions(&self) -> [Complex<f64>; 2] {
        let (a, d) = (self.lift, self.damping);
        let half = Complex::new(a + d, -self.gyroscopic) / 2.0;
        let stiffness = Complex::new(self.pitching - a * d, self.magnus + a * self.gyroscopic);
        let root = (half * half + stiffness).sqrt();
        let mut zeros = [-half + root, -half - root];
        zeros.sort_by(|a, b| b.im.abs().total_cmp(&a.im.abs()));
        zeros
    }

    fn criteria_along_axis(&self) -> Criteria {
        let (a, d, h) = (self.lift, self.damping, self.gyroscopic);
        let stiffness = self.pitching - a * d;
        let [fast, slow] = self.circular_motions();
        let dynamic = 2.0 * (self.magnus + a * h) / ((a + d) * h);
        Criteria {
            gyroscopic_factor: h * h / (4.0 * stiffness),
            dynamic_factor: Some(dynamic).filter(|factor| factor.is_finite()),
            gyroscopic: h * h > 4.0 * stiffness,
            slow: slow.re < NEUTRAL,
            wobble: fast.re < NEUTRAL,
            nutation: fast.im.abs(),
            nutation_decay: -fast.re,
            roll_rate: f64::NAN,
        }
    }

    fn criteria_across_axis(&self) -> Criteria {
        let (a, d) = (self.lift, self.damping);
        let (k, h) = (self.pitching, self.gyroscopic);
        let stiff = h * h + d * d;
        let held = stiff + 2.0 * a * d;
        let slow = a * stiff - k * d;
        Criteria {
            gyroscopic_factor: held / k,
            dynamic_factor: None,
            gyroscopic: held > k,
            slow: slow >= 0.0,
            wobble: (2.0 * d + a) * (held - k) >= slow,
            nutation: h.abs() - k / (2.0 * h.abs()),
            nutation_decay: d - k * (a - d) / (2.0 * h * h),
            roll_rate: -self.moment / h,
        }
    }
}

impl Criteria {
    /// Whether all three conditions hold, so that no motion of the axis relative to the air stream grows.
    pub fn is_stable(&self) -> bool {
        self.gyroscopic && self.slow && self.wobble
    }
}
