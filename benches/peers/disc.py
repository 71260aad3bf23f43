"""The disc of model-spec/models/disc.hyz, written once by hand as a competent user of the peers would write it.

The same text is run on every tool's symbols: `ops` is any namespace with sin, cos, sqrt and atan2.
"""

STATES = "x y z u v w phi theta gamma phidot thetadot gammadot".split()
PARAMETERS = (
    "m I_a I_d d A rho g C_L0 C_La C_D0 C_Da C_Ma C_Mq C_Rr C_Nr wind_x wind_y wind_z".split()
)
# How the user writes sin(alpha) and cos(alpha): as such, or as ratios of velocities.
VARIANTS = ("trig", "algebraic")
# How much of the chain rule the user does for the tool, by hand: none of it, that through the velocity in the air (wind
# makes every load depend on the attitude through these three), or that through every named quantity besides.
CHAINS = ("plain", "air", "named")
AIR = ("a1", "a2", "a3")


def derivative(ops, x, p, variant, name=lambda _, expression: expression):
    """The twelve time derivatives, in the order of STATES, and the loads that made them.

    `name` sees every quantity that a chain rule by hand would go through, and may put a symbol in its place.
    """
    _, _, _, u, v, w, phi, theta, _, phidot, thetadot, gammadot = x
    m, I_a, I_d, d, A, rho, g, C_L0, C_La, C_D0, C_Da, C_Ma, C_Mq, C_Rr, C_Nr, wx, wy, wz = p
    s1, c1, s2, c2 = ops.sin(phi), ops.cos(phi), ops.sin(theta), ops.cos(theta)

    # Velocity through the air, in B.
    n = c1 * wz - s1 * wy
    a1 = name("a1", u - (c2 * wx - s2 * n))
    a2 = name("a2", v - (c1 * wy + s1 * wz))
    a3 = name("a3", w - (s2 * wx + c2 * n))
    h2 = a1 * a1 + a2 * a2
    V2 = name("V2", h2 + a3 * a3)
    h = name("h", ops.sqrt(h2))
    alpha = name("alpha", ops.atan2(-a3, h))
    if variant == "trig":
        sin_alpha, cos_alpha = name("sin_alpha", ops.sin(alpha)), name("cos_alpha", ops.cos(alpha))
    else:
        V = name("V", ops.sqrt(V2))
        sin_alpha, cos_alpha = name("sin_alpha", -a3 / V), name("cos_alpha", h / V)
    cos_beta, sin_beta = name("cos_beta", a1 / h), name("sin_beta", a2 / h)  # d1 in B; d2 is (-sin_beta, cos_beta, 0)

    # Angular velocity: of the B frame (o1, o2, o3), of the disc (o1, o2, r).
    o1, o2, o3 = name("o1", phidot * c2), thetadot, name("o3", phidot * s2)
    r = name("r", o3 + gammadot)
    rate1 = name("rate1", o1 * cos_beta + o2 * sin_beta)
    rate2 = name("rate2", o2 * cos_beta - o1 * sin_beta)

    qA = name("qA", rho * V2 * A / 2)
    lift = name("lift", qA * (C_L0 + C_La * alpha))
    drag = name("drag", qA * (C_D0 + C_Da * alpha * alpha))
    forward = name("forward", lift * sin_alpha - drag * cos_alpha)
    up = name("up", lift * cos_alpha + drag * sin_alpha)
    roll = name("roll", qA * d * (C_Rr * r + C_Mq * rate1))
    pitch = name("pitch", qA * d * (C_Ma * alpha + C_Mq * rate2))
    spin = C_Nr * r

    F1, F2, F3 = forward * cos_beta, forward * sin_beta, up
    M1 = roll * cos_beta - pitch * sin_beta
    M2 = roll * sin_beta + pitch * cos_beta

    # Newton and Euler in B.
    udot = F1 / m + g * s2 * c1 + o3 * v - o2 * w
    vdot = F2 / m - g * s1 + o1 * w - o3 * u
    wdot = F3 / m - g * c2 * c1 + o2 * u - o1 * v
    o1dot = (M1 - o2 * (I_a * r - I_d * o3)) / I_d
    o2dot = (M2 + o1 * (I_a * r - I_d * o3)) / I_d
    rdot = spin / I_a
    phiddot = (o1dot + thetadot * o3) / c2
    gammaddot = rdot - phiddot * s2 - thetadot * o1

    k = w * c2 - u * s2
    rates = [
        u * c2 + w * s2,
        v * c1 - s1 * k,
        v * s1 + c1 * k,
        udot,
        vdot,
        wdot,
        phidot,
        thetadot,
        gammadot,
        phiddot,
        o2dot,
        gammaddot,
    ]
    return rates, {"force_B": (F1, F2, F3), "moment_B": (M1, M2, spin)}
