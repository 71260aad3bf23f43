//! The term libraries of the disc and the ball.

/// Loads that a family of models can be given, and products of variables that are tried on each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TermLibrary {
    /// Name of the effect that adds the loads.
    pub effect: &'static str,
    /// Text of that effect.
    pub text: &'static str,
    /// Coefficient of each load, the site where it acts, and the statement that adds a term there.
    pub loads: &'static [(&'static str, &'static str, &'static str)],
    /// Variables of the products.
    pub variables: &'static [Variable],
    /// Products of variables: index and power of each factor.
    pub products: &'static [&'static [(usize, i32)]],
}

/// A variable of a term library.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    /// The auxiliary variable of the loads' effect that holds it.
    pub quantity: &'static str,
    /// Its formula in the model language.
    pub formula: &'static str,
    /// Its name in the `variables` of an effect.
    pub word: &'static str,
}

const fn variable(quantity: &'static str, formula: &'static str, word: &'static str) -> Variable {
    Variable {
        quantity,
        formula,
        word,
    }
}

/// The disc's channels, in the D frame.
const DISC: TermLibrary = TermLibrary {
    effect: "loads_of_no_law",
    text: "effect loads_of_no_law {
  site unknown;
  coefficient X_lift = 0 [1]; coefficient X_drag = 0 [1]; coefficient X_side = 0 [1];
  coefficient X_roll = 0 [1]; coefficient X_pitch = 0 [1]; coefficient X_spin = 0 [1];
  let on_spin = ratio(r*d, 2*V, 0);
  let on_speed = log(max(V/(12 [m/s]), 0.01));
  let on_rate_1 = ratio(rate_1*d, 2*V, 0);
  let on_rate_2 = ratio(rate_2*d, 2*V, 0);
  let on_height = z/(1 m);
  let on_time = time/(1 s);
  replace C_L = previous + X_lift;
  replace C_D = previous + X_drag;
  replace roll = previous + q*A*d*X_roll;
  replace pitch = previous + q*A*d*X_pitch;
  replace spin_down = previous + q*A*d*X_spin;
  force side_of_no_law = q*A*X_side*d2;
}",
    loads: &[
        ("X_lift", "lift", "replace C_L = previous + (TERM);"),
        ("X_drag", "drag", "replace C_D = previous + (TERM);"),
        ("X_side", "side", "force NAME = q*A*(TERM)*d2;"),
        ("X_roll", "roll", "replace roll = previous + q*A*d*(TERM);"),
        (
            "X_pitch",
            "pitch",
            "replace pitch = previous + q*A*d*(TERM);",
        ),
        (
            "X_spin",
            "spin",
            "replace spin_down = previous + q*A*d*(TERM);",
        ),
    ],
    variables: &[
        variable("alpha", "alpha", "alpha"),
        variable("on_spin", "ratio(r*d, 2*V, 0)", "spin"),
        variable("on_speed", "log(max(V/(12 [m/s]), 0.01))", "speed"),
        variable("on_rate_1", "ratio(rate_1*d, 2*V, 0)", "rates"),
        variable("on_rate_2", "ratio(rate_2*d, 2*V, 0)", "rates"),
        variable("on_height", "z/(1 m)", "height"),
        variable("on_time", "time/(1 s)", "time"),
    ],
    products: &[
        &[],
        &[(0, 1)],
        &[(0, 2)],
        &[(0, 3)],
        &[(1, 1)],
        &[(1, 2)],
        &[(1, 1), (0, 1)],
        &[(1, 2), (0, 1)],
        &[(1, 1), (0, 2)],
        &[(2, 1)],
        &[(2, 1), (0, 1)],
        &[(2, 1), (1, 1)],
        &[(2, 2)],
        &[(3, 1)],
        &[(4, 1)],
        &[(3, 1), (0, 1)],
        &[(4, 1), (0, 1)],
        &[(5, 1)],
        &[(6, 1)],
        &[(6, 1), (0, 1)],
        &[(6, 1), (1, 1)],
        &[(6, 2)],
    ],
};

/// The ball's channels: against its velocity, up and to the left across it, and across spin and velocity.
const BALL: TermLibrary = TermLibrary {
    effect: "loads_of_no_law",
    text: "effect loads_of_no_law {
  site unknown;
  coefficient X_drag = 0 [1]; coefficient X_lift = 0 [1]; coefficient X_side = 0 [1]; coefficient X_spin = 0 [1];
  let along_of_no_law = unit(air_velocity);
  let left_of_no_law = unit(cross(N.3, air_velocity));
  let on_spin = ratio(norm(omega)*radius, V, 0);
  let on_speed = log(max(V/(5 [m/s]), 0.01));
  let on_height = z/(1 m);
  let on_time = time/(1 s);
  force of_no_law = rho*V^2/2*A*(-X_drag*along_of_no_law + X_side*left_of_no_law
    + X_lift*cross(along_of_no_law, left_of_no_law) + X_spin*cross(unit(omega), along_of_no_law));
}",
    loads: &[
        ("X_drag", "drag", "force NAME = -rho*V^2/2*A*(TERM)*unit(air_velocity);"),
        ("X_lift", "lift", "force NAME = rho*V^2/2*A*(TERM)*cross(unit(air_velocity), unit(cross(N.3, air_velocity)));"),
        ("X_side", "side", "force NAME = rho*V^2/2*A*(TERM)*unit(cross(N.3, air_velocity));"),
        ("X_spin", "lift", "force NAME = rho*V^2/2*A*(TERM)*cross(unit(omega), unit(air_velocity));"),
    ],
    variables: &[
        variable("on_spin", "ratio(norm(omega)*radius, V, 0)", "spin"),
        variable("on_speed", "log(max(V/(5 [m/s]), 0.01))", "speed"),
        variable("on_height", "z/(1 m)", "height"),
        variable("on_time", "time/(1 s)", "time"),
    ],
    products: &[
        &[],
        &[(0, 1)],
        &[(0, 2)],
        &[(1, 1)],
        &[(1, 2)],
        &[(0, 1), (1, 1)],
        &[(2, 1)],
        &[(3, 1)],
        &[(3, 2)],
        &[(0, 1), (3, 1)],
    ],
};

/// All libraries; the first that a model can be given is used.
pub(crate) const LIBRARIES: [TermLibrary; 2] = [DISC, BALL];
