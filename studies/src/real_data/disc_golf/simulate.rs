//! Simulates a disc-golf throw by the oracle.

use model_spec::model::Model;
use nalgebra::{Matrix3, Vector3};
use oracle::{Physical, Point, Quaternion, Reference};

use super::throw::{Disc, Launch, Throw, axis_and_velocity};
use crate::error::StudyError;
use crate::oracle_flights::{
    CurveCoefficients, angle_of_attack, integrate_with_constants, reference_of,
};
use crate::real_data::wind_tunnel::{Measured, interpolated};

/// Mass of the discs, kg, as stated by Giljarhus and others (2022).
const MASS: f64 = 0.175;

/// Air density assumed by Giljarhus and others (2022), kg/m³.
const DENSITY: f64 = 1.225;

/// Roughness length of the logarithmic wind profile of Giljarhus and others (2022), m.
const ROUGHNESS: f64 = 0.1;

/// Height above the ground at which the wind was measured, m.
const WIND_HEIGHT: f64 = 1.5;

/// Maximum time between computed points of a path, s. Positions between these points are interpolated linearly.
const MAX_INTERVAL: f64 = 0.02;

/// Maximum step size of the integration, s. With steps five times smaller, the fitted factors on lift, drag and
/// pitching moment change by less than a tenth of their standard errors.
const MAX_STEP: f64 = 2e-3;

/// Magnitude of the angle of attack (rad) up to which the pitching moment is set to 0. The model's moment slope is the
/// tabulated moment divided by the angle, which must not be 0.
const MIN_ALPHA: f64 = 1e-4;

/// Factors by which the tabulated coefficients of lift, drag and pitching moment are multiplied.
pub(super) type Factors = [f64; 3];

/// Simulates throws of one disc with tabulated aerodynamic coefficients.
pub(super) struct Simulator<'a> {
    reference: Reference,
    coefficients: CurveCoefficients,
    constants: Point<f64>,
    table: &'a [Measured],
}

impl<'a> Simulator<'a> {
    /// Creates a simulator for a disc with an aerodynamic table. Pitch and spin damping, which the table lacks, have
    /// the values of `model`.
    pub(super) fn new(model: &Model, disc: &'a Disc) -> Result<Self, StudyError> {
        let mut constants = Point::defaults(model);
        let radius = disc.diameter / 2.0;
        let known = [
            ("m", MASS),
            ("I_d", MASS * disc.inertia[0]),
            ("I_a", MASS * disc.inertia[1]),
            ("d", disc.diameter),
            ("A", std::f64::consts::PI * radius * radius),
            ("rho", DENSITY),
        ];
        for (name, value) in known {
            let index = model.params.iter().position(|p| p.name == name);
            let index = index.ok_or_else(|| StudyError::Name {
                of: "model of the disc",
                name: name.to_owned(),
            })?;
            constants.params[index] = value;
        }
        if let Some(index) = model.coefficients.iter().position(|c| c.name == "C_Rr") {
            constants.coefficients[index] = 0.0;
        }
        Ok(Self {
            reference: reference_of(model),
            coefficients: CurveCoefficients::of(model, MIN_ALPHA),
            constants,
            table: &disc.table,
        })
    }

    /// Simulated horizontal positions (x, y), m, of the disc at `times` (s) after a launch, relative to the release and
    /// in the axes of the measured track. Times after the landing give the landing position.
    pub(super) fn track(
        &self,
        throw: &Throw,
        launch: &Launch,
        factors: &Factors,
        times: &[f64],
    ) -> Vec<[f64; 2]> {
        let [.., tailwind, crosswind] = *launch;
        let profile = |height: f64| ((height + ROUGHNESS) / ROUGHNESS).ln();
        let at_wind_height = profile(WIND_HEIGHT);
        let wind = |height: f64| {
            let factor = profile(height.max(0.0)) / at_wind_height;
            Vector3::new(tailwind * factor, crosswind * factor, 0.0)
        };
        let set = |body: &Physical<f64>, constants: &mut Point<f64>| {
            self.set_constants(constants, body, wind(body.position.z), factors);
        };
        let duration = times.last().copied().unwrap_or(0.0);
        let intervals = (duration / MAX_INTERVAL).ceil().max(1.0);
        let fine_times: Vec<f64> = (0..=intervals as usize)
            .map(|k| k as f64 * duration / intervals)
            .collect();
        let start = release(throw, launch);
        let states = integrate_with_constants(
            &self.reference,
            &self.constants,
            &set,
            start,
            &fine_times,
            MAX_STEP,
        );
        let path: Vec<Vector3<f64>> = states.iter().map(|body| body.position).collect();
        let at = |time: f64| {
            let index = (time / duration * intervals).clamp(0.0, intervals);
            let k = (index as usize).min(path.len().saturating_sub(2));
            path[k] + (path[k + 1] - path[k]) * (index - k as f64)
        };
        let landing = path.windows(2).find(|two| two[1].z < 0.0).map(|two| {
            let fraction = two[0].z / (two[0].z - two[1].z);
            two[0] + (two[1] - two[0]) * fraction
        });
        let mut samples = fine_times.iter().zip(&path);
        let landed_by = samples.find(|(_, position)| position.z < 0.0);
        let landed_by = landed_by.map_or(f64::INFINITY, |(time, _)| *time);
        let positions = times.iter().map(|time| {
            let position = at(*time);
            let is_down = *time >= landed_by || position.z < 0.0;
            let position = landing.filter(|_| is_down).unwrap_or(position);
            [position.x, position.y]
        });
        positions.collect()
    }

    /// Writes the wind (m/s) and aerodynamic coefficients to `constants`. With these coefficients, the model's lift,
    /// drag and pitching moment at the body's angle of attack equal the tabulated values multiplied by `factors`.
    fn set_constants(
        &self,
        constants: &mut Point<f64>,
        body: &Physical<f64>,
        wind: Vector3<f64>,
        factors: &Factors,
    ) {
        let alpha = angle_of_attack(body, wind);
        let found = interpolated(self.table, alpha);
        if let Some(input) = constants.inputs.first_mut() {
            *input = wind;
        }
        let curves = [0, 1, 2].map(|k| factors[k] * found[k]);
        self.coefficients.set(constants, alpha, curves);
    }
}

/// State of the disc at the release, with the speed and angles in `launch` (the wind in `launch` is not used) and the
/// spin and height of `throw`. The axes are those of the measured track, with the origin on the ground below the
/// release.
fn release(throw: &Throw, launch: &Launch) -> Physical<f64> {
    let (axis, velocity) = axis_and_velocity(launch);
    let first = Vector3::x().cross(&axis).cross(&axis).normalize();
    let matrix = Matrix3::from_columns(&[first, axis.cross(&first), axis]);
    Physical {
        position: Vector3::new(0.0, 0.0, throw.height),
        velocity,
        attitude: Quaternion::from_matrix(&matrix),
        // A right-hander's backhand: clockwise, seen from above.
        angular_velocity: axis * -throw.spin,
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Disc with an aerodynamic table that is computed from polynomials of the angle of attack.
    pub(in super::super) fn smooth_disc() -> Disc {
        let row = |k: i32| {
            let alpha = f64::from(k).to_radians();
            Measured {
                alpha,
                coefficients: [
                    0.1 + 2.5 * alpha,
                    0.06 + 2.0 * alpha * alpha,
                    0.01 - 0.2 * alpha,
                ],
            }
        };
        Disc {
            diameter: 0.21,
            inertia: [3.7e-3, 7.4e-3],
            table: (-45..=45).step_by(5).map(row).collect(),
        }
    }

    #[test]
    fn a_disc_that_has_landed_stays() {
        let (disc, model) = (smooth_disc(), crate::oracle_flights::disc());
        let simulator = Simulator::new(&model, &disc).unwrap();
        let throw = Throw {
            number: 1,
            launch: [15.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
            spin: 100.0,
            height: 0.5,
            track: Vec::new(),
        };
        let times = [0.1, 1.0, 2.0];
        let track = simulator.track(&throw, &throw.launch, &[0.0, 0.0, 0.0], &times);
        // Without aerodynamic forces the disc lands where 0.5 - 15 sin(0.2) t - g t²/2 is 0.
        let fall = 15.0 * 0.2_f64.sin();
        let time = (-fall + (fall * fall + 2.0 * 9.81 * 0.5).sqrt()) / 9.81;
        assert!(
            (track[1][0] - 15.0 * 0.2_f64.cos() * time).abs() < 0.01,
            "{track:?}"
        );
        assert_eq!(track[1], track[2]);
    }
}
