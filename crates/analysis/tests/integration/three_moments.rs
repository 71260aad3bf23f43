//! Modes of a body that is none of revolution.

use analysis::stability::{Body, modes};
use nalgebra::Complex;

use crate::eigenvalues::defaults;

/// Euler's equations without moments: about the axis k at Ω, λ² = −Ω² (I_k − I_i)(I_k − I_j)/(I_i I_j).
#[test]
fn a_body_of_three_moments_turns_about_the_middle_one_unstably() {
    const SPIN: f64 = 50.0;
    let moments = [1.0_f64, 2.0, 2.5];
    for k in 0..3 {
        let text = format!(
            "model free; param m = 1 kg; param I_1 = 1 g*m^2; param I_2 = 2 g*m^2; param I_3 = 2.5 g*m^2; frame N;
            frame B = N by quaternion (q0, q1, q2, q3);
            body b {{ mass m; inertia diag(I_1, I_2, I_3) in B; fixed in B; position (x, y, z) in N;
              velocity (vx, vy, vz) in N; angular velocity (p, q, r) in B; axis B.{}; }}
            force drag = -1e-3[kg/m]*norm(velocity)*velocity;",
            k + 1
        );
        let model = model_spec::load::from_text("free", &text, &[]).expect("a model");
        let body = Body::new(model).expect("a body");
        let mut state = body.compiled.layout().default_states();
        let place = |name: &str| body.model.states.iter().position(|own| own.name == name);
        state[place("vx").expect("a state")] = 20.0;
        state[place(["p", "q", "r"][k]).expect("a state")] = SPIN;
        let found = modes(
            &defaults(&body).linearise(0.0, &state).expect("linear"),
            0.0,
        );
        assert!(!found.is_symmetric);
        let [i, j] = [(k + 1) % 3, (k + 2) % 3].map(|other| moments[other]);
        let square = (moments[k] - i) * (moments[k] - j) / (i * j);
        let expected = Complex::new(-SPIN * SPIN * square, 0.0).sqrt();
        let has = |value: Complex<f64>| {
            found
                .modes
                .iter()
                .any(|mode| (mode.value - value).norm() < 1e-4)
        };
        assert!(has(expected), "axis {k}: {expected}: {:?}", found.modes);
        // A real root has its negative beside it: the motion grows.
        assert!(
            has(if square < 0.0 { -expected } else { expected }),
            "axis {k}: {:?}",
            found.modes
        );
    }
}
