//! Axes of a body in flight: `axis` and `forward` in the block of a body or claim.

use model_spec::load::from_text;
use model_spec::model::{BodyAxis, FlightAxes, Model};

fn body(statements: &str) -> String {
    format!(
        "model probe; param m = 0.5 kg; param I = 1e-3 kg*m^2; frame N; frame C = N by quaternion (q0, q1, q2, q3);
        body probe {{ mass m; inertia diag(I, I, I) in C; fixed in C; {statements} position (x, y, z) in N;
        velocity (vx, vy, vz) in N; angular velocity (p, q, r) in C; }}"
    )
}

fn read(text: &str) -> Model {
    from_text("probe.hyz", text, &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn axes(statements: &str) -> FlightAxes {
    read(&body(statements)).flight_axes().expect("a body").1
}

fn refused(text: &str) -> String {
    let error = from_text("probe.hyz", text, &[]).expect_err(text);
    error.to_string()
}

fn axis(number: u8, is_opposite: bool) -> BodyAxis {
    BodyAxis {
        number,
        is_opposite,
    }
}

#[test]
fn axes_are_those_stated_and_the_third_and_first_otherwise() {
    let usual = axes("");
    assert_eq!(
        (usual.spin, usual.forward),
        (axis(3, false), axis(1, false))
    );
    assert!(!usual.states_spin && !usual.states_forward && !usual.is_along());
    let arrow = axes("axis C.1; forward C.1;");
    assert!(arrow.is_along() && arrow.states_spin && arrow.states_forward);
    let wing = axes("forward C.1; axis -C.3;");
    assert_eq!((wing.spin, wing.forward), (axis(3, true), axis(1, false)));
    assert_eq!(axes("axis C.2;").forward, axis(3, false));
    assert!(axes("forward C.3;").is_along());
}

#[test]
fn axes_at_a_release_are_a_right_handed_frame() {
    for spin in ["", "axis C.1;", "axis -C.1;", "axis C.2;", "axis -C.3;"] {
        for forward in [
            "",
            "forward C.1;",
            "forward -C.1;",
            "forward -C.2;",
            "forward C.3;",
        ] {
            let stated = axes(&format!("{spin} {forward}"));
            let [a, b, c] = stated.release().map(BodyAxis::vector);
            assert_eq!(a, stated.forward.vector(), "{spin} {forward}");
            if !stated.is_along() {
                assert_eq!(c, stated.spin.vector(), "{spin} {forward}");
            }
            let cross = [1, 2, 0].map(|k: usize| {
                let next = (k + 1) % 3;
                a[k] * b[next] - a[next] * b[k]
            });
            assert_eq!(cross.map(|v| v + 0.0), c, "{spin} {forward}");
        }
    }
}

#[test]
fn axes_are_of_the_frame_that_is_fixed_in_the_body() {
    let message = refused(&body("axis N.1;"));
    let expected = "`axis` is an axis of the frame C, which moves with the body, but this is `N.1`";
    assert!(
        message.contains(expected) && message.contains("write `axis C.1;`"),
        "{message}"
    );
    let message = refused(&body("forward velocity;"));
    assert!(
        message.contains("`forward` is an axis of the frame C"),
        "{message}"
    );
    let message = refused(
        "model probe; param m = 1 kg; frame N; point p { mass m; forward N.1; position (x, y, z) in N; velocity (u, v, w) in N; }",
    );
    assert!(message.contains("a point has no `forward`"), "{message}");
    let message = refused(&body("axis C.1; axis C.2;"));
    assert!(message.contains("`axis` is stated twice"), "{message}");
}

#[test]
fn a_claim_states_its_axes_as_a_body_does() {
    let claim = |statements: &str| {
        format!(
            "model top; param m = 0.1 kg; param a = 2e-4 kg*m^2; param d = 1e-4 kg*m^2; frame N; frame B = N turned theta about 2;
            state theta = 0 rad; state thetadot = 0 rad/s; der(theta) = thetadot; der(thetadot) = 0;
            claim body top {{ mass m; inertia diag(a, d, d) in B; {statements} position (0 [m])*N.1; velocity (0 [m/s])*N.1;
            angular velocity (0, thetadot, 0) in B; force 0*m*9.81 [m/s^2]*N.3; moment 0*m*(1 [m^2/s^2])*N.1; }}"
        )
    };
    let found = read(&claim("fixed in B; axis B.1; forward B.1;")).flight_axes();
    assert!(found.expect("a claim").1.is_along());
    let (_, found) = read(&claim("axis B.1;")).flight_axes().expect("a claim");
    assert_eq!(
        (found.spin, found.forward),
        (axis(1, false), axis(2, false))
    );
    assert!(
        read(&claim("axis B.1; forward -B.1;"))
            .flight_axes()
            .expect("a claim")
            .1
            .is_along()
    );
    let message = refused(&claim("axis B.1; forward B.2;"));
    assert!(
        message.contains("only its axis can point ahead"),
        "{message}"
    );
}

#[test]
fn a_model_is_printed_with_its_axes() {
    let model = read(&body("axis C.1; forward -C.1;"));
    let text = model.tree.to_string();
    assert!(
        text.contains("axis C.1;") && text.contains("forward -C.1;"),
        "{text}"
    );
}
