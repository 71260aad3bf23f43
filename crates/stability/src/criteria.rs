//! Criteria for a body of revolution that spins about its axis, or does not: derived from the linearised equations of its axis in the
//! stream.
//!
//! With small rotations η about d2 and rates ω1, ω2 about d1, d2 in axes that do not spin, moments of inertia I_a, I_d, spin r, and the
//! moment of the air −D ω1 about d1, −D ω2 − K α about d2:
//!
//! ```text
//! I_d ω̇1 = −D ω1 − I_a r ω2
//! I_d ω̇2 =  I_a r ω1 − D ω2 − K α
//! α̇      = −ω2 − a α
//! ```
//!
//! a is the rate at which lift turns the path into the disc's plane. Divided by I_d (δ = D/I_d, κ = K/I_d, ν = I_a r/I_d), the
//! eigenvalues are the zeros of (s + a)[(s + δ)² + ν²] − κ (s + δ), and Routh and Hurwitz give the three conditions of
//! [`Criteria`]. Without spin, ν = 0, the same conditions are those of an ordinary wing.

use nalgebra::{Complex, DMatrix, Vector3};

use crate::linearise::Linearised;

/// Derivatives that decide how the axis moves in the stream, 1/s and 1/s².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisDerivatives {
    /// a = q A (C_La + C_D)/(m V) for the built-in discs: decay of the angle of attack by lift.
    pub lift: f64,
    /// δ = −q A d C_Mq/I_d: decay of the rates by damping.
    pub damping: f64,
    /// κ = −q A d C_Ma/I_d: growth by the pitching moment, 1/s²; positive where the stream lifts the nose.
    pub pitching: f64,
    /// ν = I_a r/I_d: the nutation's frequency without a stream.
    pub gyroscopic: f64,
    /// Moment about d2 divided by I_d at the state, 1/s².
    pub moment: f64,
}

/// What the criteria say of a body in its stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// S = (ν² + δ² + 2 a δ)/κ: spin and damping hold the axis where S > 1; infinite or negative where the stream itself holds it.
    pub gyroscopic_factor: f64,
    /// Whether ν² + δ² + 2 a δ > κ: the gyroscopic condition.
    pub gyroscopic: bool,
    /// Whether a (ν² + δ²) > κ δ: lift turns the path to the axis sooner than damping lets the axis wander.
    pub slow: bool,
    /// Whether (2 δ + a)(ν² + δ² + 2 a δ − κ) > a (ν² + δ²) − κ δ: the wobble decays.
    pub wobble: bool,
    /// Frequency of the nutation, ν − κ/(2 ν), rad/s: of first order in κ/ν².
    pub nutation: f64,
    /// Decay of the nutation, δ − κ (a − δ)/(2 ν²), 1/s.
    pub nutation_decay: f64,
    /// Rate at which the plane rolls, M/(I_a r), rad/s: Crowther and Potts's closed form of the roll rate in straight flight.
    pub roll_rate: f64,
}

impl AxisDerivatives {
    /// Derivatives at a linearised motion in air of a velocity, m/s.
    pub fn of(linearised: &Linearised, wind: Vector3<f64>) -> AxisDerivatives {
        let n = linearised.axis;
        let velocity = linearised.motion.velocity - wind;
        let flat = velocity - n * n.dot(&velocity);
        let d1 = flat.try_normalize(1e-9).unwrap_or_else(Vector3::x);
        let d2 = n.cross(&d1);
        let spin = linearised.rates.dot(&n);
        let matrix = &linearised.matrix;
        let entry = |row: usize, left: Vector3<f64>, column: usize, right: Vector3<f64>| -> f64 {
            (left.transpose() * matrix.fixed_view::<3, 3>(row, column) * right)[0]
        };
        // Rates about axes that go with the body but do not spin: ω1' = ω1 − r φ2, ω2' = ω2 + r φ1.
        let rate_1 = entry(9, d1, 9, d1);
        let rate_2 = entry(9, d2, 9, d2);
        let cross = 0.5 * (entry(9, d2, 9, d1) - entry(9, d1, 9, d2));
        let by_tilt = entry(9, d2, 6, d2) + spin * entry(9, d2, 9, d1);
        let speed = velocity.norm().max(1e-9);
        AxisDerivatives {
            lift: -entry(3, n, 6, d2) / speed,
            damping: -0.5 * (rate_1 + rate_2),
            pitching: by_tilt,
            gyroscopic: cross + spin,
            // The moment is what turns the axis beyond what the spin's stiffness does at its rate.
            moment: linearised.angular_acceleration.dot(&d2) - cross * linearised.rates.dot(&d1),
        }
    }

    /// The three zeros of (s + a)[(s + δ)² + ν²] − κ (s + δ), 1/s.
    pub fn eigenvalues(&self) -> [Complex<f64>; 3] {
        let AxisDerivatives {
            lift: a,
            damping: d,
            pitching: k,
            gyroscopic: h,
            ..
        } = *self;
        let matrix = DMatrix::from_row_slice(3, 3, &[-d, -h, 0.0, h, -d, -k, 0.0, -1.0, -a]);
        let values = matrix.complex_eigenvalues();
        [values[0], values[1], values[2]]
    }

    /// What the criteria say.
    pub fn criteria(&self) -> Criteria {
        let AxisDerivatives {
            lift: a,
            damping: d,
            pitching: k,
            gyroscopic: h,
            moment,
        } = *self;
        let stiff = h * h + d * d;
        let held = stiff + 2.0 * a * d;
        let slow = a * stiff - k * d;
        Criteria {
            gyroscopic_factor: held / k,
            gyroscopic: held > k,
            slow: slow > 0.0,
            wobble: (2.0 * d + a) * (held - k) > slow,
            nutation: h.abs() - k / (2.0 * h.abs()),
            nutation_decay: d - k * (a - d) / (2.0 * h * h),
            roll_rate: -moment / h,
        }
    }
}

impl Criteria {
    /// Whether all three conditions hold: every motion of the axis in the stream decays.
    pub fn is_stable(&self) -> bool {
        self.gyroscopic && self.slow && self.wobble
    }
}
