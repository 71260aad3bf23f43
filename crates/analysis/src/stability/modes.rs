//! Modes of the linearised motion: eigenvalues after removal of the coordinates that nothing depends on, classified by
//! the variables that move most.

use nalgebra::{Complex, DMatrix, DVector, Vector3};

use crate::stability::linearise::Linearised;

/// Size of an element of the linearised motion, or of the real part of an eigenvalue, relative to the norm, below which it is
/// rounding.
pub(super) const ROUNDING: f64 = 1e-9;

/// Rate below which a motion neither decays nor grows, 1/s: it doubles in a week.
pub const NEUTRAL: f64 = 1e-6;

/// Kind of a mode of the linearised motion, by the variables that change most in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// The body axis circles at about the spin times the ratio of axial to diametral inertia: a wobble.
    Nutation,
    /// The body axis oscillates without gyroscopic stiffness: pitching or coning with little or no spin.
    ShortPeriod,
    /// The angle of attack decays or grows without oscillation, because lift turns the path.
    Incidence,
    /// Slow precession: axis and direction of flight change together, more slowly than in the nutation.
    Precession,
    /// Slow oscillation in which speed and climb are exchanged.
    Phugoid,
    /// Mode in which only the speed decays or grows, without oscillation.
    Speed,
    /// Mode in which only the spin decays or grows.
    Spin,
    /// Neutral mode: a change of the heading, which affects no force or moment.
    Heading,
}

impl ModeKind {
    /// Name in tables and files, such as `nutation`.
    pub fn name(self) -> &'static str {
        match self {
            ModeKind::Nutation => "nutation",
            ModeKind::ShortPeriod => "short period",
            ModeKind::Incidence => "incidence",
            ModeKind::Precession => "precession",
            ModeKind::Phugoid => "phugoid",
            ModeKind::Speed => "speed",
            ModeKind::Spin => "spin",
            ModeKind::Heading => "heading",
        }
    }
}

/// A mode of the linearised motion: a real eigenvalue or a conjugate pair of eigenvalues.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Eigenvalue, 1/s; for a conjugate pair the one with a positive imaginary part.
    pub value: Complex<f64>,
    /// Kind of the mode.
    pub kind: ModeKind,
    /// Fractions of the squared amplitude that are tilt, change of direction, and relative changes of speed and spin.
    pub shares: [f64; 4],
}

impl Mode {
    /// Angular frequency of the oscillation, rad/s; 0 for a real eigenvalue.
    pub fn frequency(&self) -> f64 {
        self.value.im.abs()
    }

    /// Decay rate of the mode, 1/s; negative if the mode grows, 0 where the sign is due to rounding.
    pub fn decay(&self) -> f64 {
        match self.value.re.abs() < ROUNDING * (1.0 + self.value.norm()) {
            true => 0.0,
            false => -self.value.re,
        }
    }

    /// Damping ratio −Re/|λ|; 1 for a decaying mode without oscillation, 0 for a neutral one.
    pub fn damping_ratio(&self) -> f64 {
        match self.decay() {
            0.0 => 0.0,
            decay => decay / self.value.norm(),
        }
    }
}

/// Modes of the linearised motion of a body about a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// Modes in order of decreasing magnitude of the eigenvalue.
    pub modes: Vec<Mode>,
    /// Names of the coordinates on which no rate of change depends.
    pub ignorable: Vec<&'static str>,
    /// Whether no rate of change depends on the rotation angle about the axis, as for a body of revolution. Otherwise the
    /// linearised motion of a spinning body changes within every turn, and the modes are those in axes that turn with it.
    pub is_symmetric: bool,
}

/// Modes in axes that rotate about the vertical at the rate `turn`, rad/s: 0, or that of a steady turn. Those of a body that
/// is none of revolution are in axes that turn with it: its inertia is constant in them.
pub fn modes(linearised: &Linearised, turn: f64) -> Modes {
    let n = linearised.axis;
    // Coordinates: displacement 3, velocity 3, tilt of the axis 2, turn about it 1, angular velocity 3.
    let first = match n.cross(&Vector3::z()).norm() > 0.5 {
        true => Vector3::z(),
        false => linearised
            .motion
            .velocity
            .cross(&n)
            .try_normalize(1e-9)
            .unwrap_or_else(Vector3::x),
    };
    let across = (first - n * n.dot(&first)).normalize();
    let other = n.cross(&across);
    let mut basis = DMatrix::identity(12, 12);
    for (k, axis) in [across, other, n].into_iter().enumerate() {
        basis.view_mut((6, 6 + k), (3, 1)).copy_from(&axis);
    }
    let names = ["x", "y", "z", "", "", "", "", "", "turn about the axis"];
    let still = basis.transpose() * &linearised.matrix * &basis;
    let size = still.norm();
    let mut kept: Vec<usize> = (0..12).collect();
    let mut ignorable = Vec::new();
    for place in [0, 1, 2, 8] {
        // The rows of the rotation contain the turn about the axis only because it moves with the axis, which is no
        // dependence.
        let rows = kept
            .iter()
            .filter(|row| **row != place && (place < 3 || !(6..9).contains(*row)));
        let column = rows.map(|row| still[(*row, place)].abs());
        if column.fold(0.0, f64::max) < ROUNDING * size {
            kept.retain(|k| *k != place);
            ignorable.push(names[place]);
        }
    }
    let is_symmetric = linearised.is_round && ignorable.contains(&names[8]);
    let mut matrix = linearised.matrix.clone();
    let about = match is_symmetric {
        true => Vector3::new(0.0, 0.0, turn).cross_matrix(),
        false => linearised.rates.cross_matrix(),
    };
    for block in 0..4 {
        let mut part = matrix.view_mut((3 * block, 3 * block), (3, 3));
        part -= about;
    }
    let matrix = basis.transpose() * matrix * &basis;
    let m = kept.len();
    let reduced = DMatrix::from_fn(m, m, |i, j| matrix[(kept[i], kept[j])]);
    let values = reduced.complex_eigenvalues();
    let speed = linearised.motion.velocity.norm().max(1e-6);
    let spin = linearised.rates.dot(&n);
    let along = linearised.motion.velocity / speed;
    let complex = reduced.map(|v| Complex::new(v, 0.0));
    let mut modes: Vec<Mode> = Vec::new();
    for value in values.iter().filter(|value| value.im >= 0.0) {
        let vector = eigenvector(&complex, *value);
        let full = |place: usize| {
            kept.iter()
                .position(|k| *k == place)
                .map_or(Complex::default(), |k| vector[k])
        };
        let velocity = [full(3), full(4), full(5)];
        let lengthwise: Complex<f64> = (0..3).map(|k| velocity[k] * along[k]).sum();
        let all: f64 = velocity.iter().map(nalgebra::Complex::norm_sqr).sum();
        let rates: Complex<f64> = (0..3).map(|k| full(9 + k) * n[k]).sum();
        let parts = [
            full(6).norm_sqr() + full(7).norm_sqr(),
            (all - lengthwise.norm_sqr()).max(0.0) / (speed * speed),
            lengthwise.norm_sqr() / (speed * speed),
            rates.norm_sqr() / spin.powi(2).max(1.0),
        ];
        let whole: f64 = parts.iter().sum::<f64>().max(1e-300);
        modes.push(Mode {
            value: *value,
            kind: ModeKind::Precession,
            shares: parts.map(|part| part / whole),
        });
    }
    modes.sort_by(|a, b| b.value.norm().total_cmp(&a.value.norm()));
    let gyroscopic = (linearised.inertia.0 / linearised.inertia.1 * spin).abs();
    name(&mut modes, gyroscopic, size);
    Modes {
        is_symmetric,
        ignorable,
        modes,
    }
}

/// Assigns the kinds; `gyroscopic` is the nutation without aerodynamic moments, rad/s, `size` the norm of the matrix.
fn name(modes: &mut [Mode], gyroscopic: f64, size: f64) {
    let (mut has_nutation, mut has_incidence) = (false, false);
    for mode in modes {
        let [axis, path, speed, spin] = mode.shares;
        let oscillates = mode.frequency() > 1e-9 * size;
        let is_fast = mode.frequency() > 0.5 * gyroscopic && axis > 0.5;
        mode.kind = if spin > 0.9 {
            ModeKind::Spin
        } else if mode.value.norm() < 1e-8 * size {
            ModeKind::Heading
        } else if is_fast && oscillates && !has_nutation {
            has_nutation = true;
            if gyroscopic > 0.2 * mode.frequency() {
                ModeKind::Nutation
            } else {
                ModeKind::ShortPeriod
            }
        } else if !oscillates && !has_incidence && axis + path > 0.8 {
            has_incidence = true;
            ModeKind::Incidence
        } else if oscillates && speed > 0.1 && speed + path > axis {
            ModeKind::Phugoid
        } else if speed > 0.5 {
            ModeKind::Speed
        } else {
            ModeKind::Precession
        };
    }
}

/// Right eigenvector of a matrix for the approximate eigenvalue `value`, by inverse iteration.
fn eigenvector(matrix: &DMatrix<Complex<f64>>, value: Complex<f64>) -> DVector<Complex<f64>> {
    let n = matrix.nrows();
    let offset = Complex::new(1e-9 * (1.0 + value.norm()), 0.7e-9 * (1.0 + value.norm()));
    let shifted = matrix - DMatrix::identity(n, n) * (value + offset);
    let factor = shifted.lu();
    let mut vector = DVector::from_fn(n, |i, _| Complex::new(1.0 + 0.1 * i as f64, 0.3));
    for _ in 0..4 {
        if let Some(next) = factor.solve(&vector) {
            let size = next.norm();
            if size.is_finite() && size > 0.0 {
                vector = next / Complex::new(size, 0.0);
            }
        }
    }
    vector
}
