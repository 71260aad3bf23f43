"""CasADi with IPOPT: multiple shooting, the Gauss-Newton form, exact sparse derivatives."""

import casadi as ca
import numpy as np

import flights
import native
from native import FIRST, NC, NX, disc

# Substeps of a sample's interval, as scipy's.
SUBSTEPS = 2


def rate(x, c):
    """The disc's equations with these coefficients, in still air."""
    p = list(flights.parameters())
    p[FIRST : FIRST + NC] = ca.vertsplit(c)
    return ca.vertcat(*disc.derivative(ca, ca.vertsplit(x), p, "algebraic")[0])


def step(x, c, h):
    k1 = rate(x, c)
    k2 = rate(x + h / 2 * k1, c)
    k3 = rate(x + h / 2 * k2, c)
    k4 = rate(x + h * k3, c)
    return x + h / 6 * (k1 + 2 * (k2 + k3) + k4)


def shown(x, marks):
    """Positions of the markers, one after another."""
    (s1, s2, s3), (c1, c2, c3) = zip(*[(ca.sin(x[i]), ca.cos(x[i])) for i in (6, 7, 8)])
    about_1 = ca.vertcat(ca.horzcat(1, 0, 0), ca.horzcat(0, c1, -s1), ca.horzcat(0, s1, c1))
    about_2 = ca.vertcat(ca.horzcat(c2, 0, s2), ca.horzcat(0, 1, 0), ca.horzcat(-s2, 0, c2))
    about_3 = ca.vertcat(ca.horzcat(c3, -s3, 0), ca.horzcat(s3, c3, 0), ca.horzcat(0, 0, 1))
    turn = ca.mtimes([about_1, about_2, about_3])
    return ca.vertcat(*[x[:3] + ca.mtimes(turn, ca.DM(mark)) for mark in marks])


def compiled(function, folder):
    """The function and its Jacobian as C, by gcc, loaded again."""
    made = folder / f"{function.name()}.so"
    if not made.exists():
        gen = ca.CodeGenerator(f"{function.name()}.c")
        gen.add(function)
        gen.add(function.jacobian())
        gen.generate(str(folder) + "/")
        # -O2 takes ten times as long over such straight code, for nothing.
        native.shared_library(folder / f"{function.name()}.c", made, ["-O1", "-march=native", "-ffast-math"])
    return ca.external(function.name(), str(made))


class Problem:
    """`per` samples in each shooting interval; unknowns in units of `scale`: coefficients, then nodes flight by flight."""

    def __init__(self, lib, data, start, scale, per, threads=1, folder=None, tolerance=1e-4):
        flights_, samples = data.seen.shape[:2]
        self.per, self.nodes = per, (samples - 1) // per + 1
        sizes = np.tile(scale[NC:].reshape(-1, 1, NX), (1, self.nodes, 1))
        coefficients, own = start[:NC], start[NC:].reshape(-1, NX)
        begin = lib.fly(flights.parameters(coefficients), own, samples, data.interval, SUBSTEPS)[:, ::per]
        self.scale = np.concatenate([scale[:NC], sizes.ravel()])
        self.begin = np.concatenate([coefficients, begin.ravel()])
        many = lambda f, n: f.map(n, "thread", threads) if threads > 1 else f.map(n)

        # One interval: the state at its end, and residuals at its samples.
        x, c, seen = ca.SX.sym("x", NX), ca.SX.sym("c", NC), ca.SX.sym("seen", 9, per)
        at, r = x, []
        for k in range(per):
            r.append((shown(at, data.marks) - seen[:, k]) / data.sigma)
            for _ in range(SUBSTEPS):
                at = step(at, c, data.interval / SUBSTEPS)
        interval = ca.Function(f"interval_{per}", [x, c, seen], [at, ca.vertcat(*r)], {"cse": True})
        last = ca.Function("last", [x, seen[:, 0]], [(shown(x, data.marks) - seen[:, 0]) / data.sigma])
        if folder:
            interval = compiled(interval, folder)

        z = ca.MX.sym("z", len(self.begin))
        v = self.begin + z * self.scale
        X = ca.reshape(v[NC:], NX, flights_ * self.nodes)
        inner = [f * self.nodes + k for f in range(flights_) for k in range(self.nodes - 1)]
        ends = [f * self.nodes + self.nodes - 1 for f in range(flights_)]
        flat = data.seen.reshape(flights_, samples, 9)
        table = flat[:, : samples - 1].reshape(-1, per, 9).transpose(2, 0, 1).reshape(9, -1)
        count = len(inner)
        reached, r1 = many(interval, count)(X[:, inner], ca.repmat(v[:NC], 1, count), ca.DM(table))
        r2 = last.map(flights_)(X[:, ends], ca.DM(flat[:, -1].T))
        after = [i + 1 for i in inner]
        # Gaps in units of the states, as the unknowns are.
        gaps = ca.vec((reached - X[:, after]) / ca.DM(sizes.reshape(-1, NX)[after].T))
        # A weight for each axis, which may change without building the problem again.
        p, lam_f, lam_g = ca.MX.sym("p", 3), ca.MX.sym("lam_f"), ca.MX.sym("lam_g", gaps.numel())
        r = ca.vertcat(ca.vec(r1 * ca.repmat(p, 3 * per, count)), ca.vec(r2 * ca.repmat(p, 3, flights_)))
        J = ca.jacobian(r, z)
        hess = ca.Function("gauss_newton", [z, p, lam_f, lam_g], [ca.triu(lam_f * ca.mtimes(J.T, J))],
                           ["x", "p", "lam_f", "lam_g"], ["triu_hess_gamma_x_x"])
        options = {"hess_lag": hess, "print_time": False,
                   "ipopt": {"print_level": 0, "sb": "yes", "tol": tolerance, "nlp_scaling_method": "none"}}
        self.solver = ca.nlpsol("fit", "ipopt", {"x": z, "p": p, "f": ca.sumsqr(r) / 2, "g": gaps}, options)

    def from_nodes(self, coefficients, states):
        """Unknowns that begin at these coefficients and at these states of each flight's samples."""
        begin = np.concatenate([coefficients, states[:, :: self.per].ravel()])
        return (begin - self.begin) / self.scale

    def fit(self, begin=0, weights=(1, 1, 1)):
        """The unknowns where IPOPT ends, and what it says."""
        found = np.array(self.solver(x0=begin, p=weights, lbg=0, ubg=0)["x"]).ravel()
        stats = self.solver.stats()
        return found, f"{stats['iter_count']} iterations, {stats['return_status']}"

    def values(self, found):
        """Coefficients, and each flight's initial state."""
        unknowns = self.begin + found * self.scale
        return unknowns[:NC], unknowns[NC:].reshape(-1, self.nodes, NX)[:, 0]
