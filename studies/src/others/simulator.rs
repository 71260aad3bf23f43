//! The simulators under study, and the changes that correct their equations.

/// A published simulator of disc flight.
#[derive(Clone, Copy, Debug)]
pub struct Simulator {
    /// Name of the built-in model with the simulator's equations.
    pub model: &'static str,
    /// Name and version of the simulator, as printed on the documentation page.
    pub title: &'static str,
    /// Description of the simulated throw, which starts from the default values of the model's states.
    pub throw: &'static str,
    /// Explanation needed to read the simulator's equations; empty if none is needed.
    pub note: &'static str,
    /// Changes of the model's text that together correct the simulator's equations, in the order in which they are
    /// applied.
    pub changes: &'static [Change],
}

/// One correction of a simulator's equations, as edits of the model's text.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// Description of the correction, as printed on the documentation page.
    pub description: &'static str,
    /// Replacements that make the correction in the model's text: (old text, new text).
    pub edits: &'static [(&'static str, &'static str)],
    /// Initial values of states that the change adds: name of the added state, name of a vector variable in the model
    /// before the change, and index (from 0) of the component of that vector that is the initial value.
    pub starts: &'static [(&'static str, &'static str, usize)],
}

/// The published simulators that the page docs/studies/others.md compares with the laws of motion.
pub const SIMULATORS: [Simulator; 2] = [
    Simulator {
        model: "frispy",
        title: "FrisPy 2.0.2",
        throw: "its default release: 10 m/s, level, 62 rad/s of spin, from a height of 1 m",
        note: "",
        changes: &[
            Change {
                description: "the moments are divided by the moments of inertia that it stores",
                edits: &[
                    (
                        "der(dphi) = moment.1*per_inertia;",
                        "der(dphi) = moment.1/I_xx;",
                    ),
                    (
                        "der(dtheta) = moment.2*per_inertia;",
                        "der(dtheta) = moment.2/I_xx;",
                    ),
                    (
                        "der(dgamma) = moment.3*per_inertia;",
                        "der(dgamma) = moment.3/I_zz;",
                    ),
                ],
                starts: &[],
            },
            Change {
                description: "the gyroscopic terms: the angular momentum turns with the axes",
                edits: &[
                    (
                        "der(dphi) = moment.1/I_xx;",
                        "der(dphi) = (moment.1 - I_zz*dtheta*angular_velocity.3 + I_xx*dphi*dtheta*sin(theta))/I_xx;",
                    ),
                    (
                        "der(dtheta) = moment.2/I_xx;",
                        "der(dtheta) = (moment.2 + I_zz*dphi*cos(theta)*angular_velocity.3 - I_xx*dphi^2*cos(theta)*sin(theta))/I_xx;",
                    ),
                ],
                starts: &[],
            },
            Change {
                description: "the rates of the angles are not the components of the angular velocity",
                edits: &[
                    (
                        "+ I_xx*dphi*dtheta*sin(theta))/I_xx;",
                        "+ 2*I_xx*dphi*dtheta*sin(theta))/(I_xx*cos(theta));",
                    ),
                    (
                        "der(dgamma) = moment.3/I_zz;",
                        "der(dgamma) = moment.3/I_zz - der(dphi)*sin(theta) - dphi*dtheta*cos(theta);\nlimit cos(theta) > 0.01 \"the plane of the disc stands vertical\";",
                    ),
                ],
                starts: &[],
            },
        ],
    },
    Simulator {
        model: "shotshaper",
        title: "shotshaper at c99e7a5",
        throw: "24 m/s ahead and 3 m/s upwards, the nose up by 0.12 rad, 116.8 rad/s of spin, from a height of 1.5 m",
        note: "Its matrix of the angles leads from the inertial axes to those of the disc; so these are turned by the negatives of its angles, which are the states `a1`, `a2`, `a3` here. The spin is read as clockwise from above: the other reading would bank the disc the wrong way.",
        changes: &[
            Change {
                description: "the rates of the angles are found from the angular velocity, of which they are not the inertial components",
                edits: &[
                    (
                        "der(a1) = in_N(precession).1;",
                        "der(a1) = in_B(precession).1/cos(a2);",
                    ),
                    (
                        "der(a2) = in_N(precession).2;",
                        "der(a2) = in_B(precession).2;",
                    ),
                    (
                        "der(a3) = in_N(precession).3;",
                        "der(a3) = in_B(precession).3 - in_B(precession).1*tan(a2);",
                    ),
                ],
                starts: &[],
            },
            Change {
                description: "a steady precession is the moment over I_z ω, not over (I_z - I_xy) ω",
                edits: &[("omega*(I_z - I_xy)", "omega*I_z")],
                starts: &[],
            },
            Change {
                description: "the precession follows from the moment by its own equations, with the inertia about a diameter",
                edits: &[
                    (
                        "let precession = -nose_up/(omega*I_z)*ahead;",
                        "state n1 = 0 rad/s;\nstate n2 = 0 rad/s;\nlet precession = (n1, n2, 0) in P;\nlet moment = -nose_up*left;",
                    ),
                    (
                        "der(a1) =",
                        "der(n1) = (moment.1 + I_z*omega*n2)/I_xy;\nder(n2) = (moment.2 - I_z*omega*n1)/I_xy;\nder(a1) =",
                    ),
                ],
                starts: &[("n1", "precession", 0), ("n2", "precession", 1)],
            },
        ],
    },
];
