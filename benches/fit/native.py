"""The disc's equations by SymPy, compiled with gcc into `libfit.so`: whole flights, markers, and their sensitivities."""

import ctypes
import pathlib
import subprocess
import sys

import numpy as np
import sympy as sp

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "peers"))
import disc  # noqa: E402
import gen_sympy  # noqa: E402

COEFFICIENTS = [n for n in disc.PARAMETERS if n.startswith("C_")]
FIRST = disc.PARAMETERS.index(COEFFICIENTS[0])
NX, NC = len(disc.STATES), len(COEFFICIENTS)
WIDTH = NC + NX  # unknowns of one flight: the shared coefficients, then its initial state
FLAGS = ["-O3", "-march=native", "-ffast-math", "-fopenmp"]


def still_air(chain):
    """SymPy's tables with the wind at zero, since these flights have none."""
    x, p, defined, rates, jacs = gen_sympy.tables("algebraic", chain)
    calm = {s: 0 for s, name in zip(p, disc.PARAMETERS) if name.startswith("wind")}
    quiet = lambda e: sp.sympify(e).subs(calm)
    return x, p, [(s, quiet(e)) for s, e in defined], [quiet(e) for e in rates], [[[quiet(e) for e in row] for row in j] for j in jacs]


def motion_text():
    """`motion`: f alone; `linear`: f, then what is not zero of both Jacobians; and `add_product`: J S + [Jp | 0]."""
    x, p, _, rates, _ = still_air("plain")
    pairs, outs = gen_sympy.steps([], rates)
    text = gen_sympy.body(x, p, pairs, outs, range(NX), NX).replace("kernel", "motion")

    x, p, defined, rates, (by_x, by_p) = still_air("named")
    J = [(i, j) for i in range(NX) for j in range(NX) if by_x[i][j] != 0]
    Jp = [(i, k) for i in range(NX) for k in range(NC) if by_p[i][FIRST + k] != 0]
    flat = rates + [by_x[i][j] for i, j in J] + [by_p[i][FIRST + k] for i, k in Jp]
    pairs, outs = gen_sympy.steps(defined, flat)
    text += gen_sympy.body(x, p, pairs, outs, range(len(outs)), len(outs)).replace("kernel", "linear")

    lines = ["static inline void add_product(const double* o, const double (*S)[WIDTH], double (*dS)[WIDTH]) {"]
    for i in range(NX):
        terms = [f"o[{NX + k}]*S[{c}][j]" for k, (r, c) in enumerate(J) if r == i]
        lines.append(f"  for (int j = 0; j < WIDTH; j++) dS[{i}][j] = {' + '.join(terms) or '0'};")
        lines += [f"  dS[{i}][{c}] += o[{NX + len(J) + k}];" for k, (r, c) in enumerate(Jp) if r == i]
    return text + "\n".join(lines + ["}"]) + f"\n#define LINEAR {len(flat)}\n"


def marker(x, mark):
    """Where a marker fixed in the disc is: position + R_x(phi) R_y(theta) R_z(gamma) mark."""
    phi, theta, gamma = x[6:9]
    about = lambda axis, angle: sp.Matrix(sp.rot_axis1(-angle) if axis == 1 else sp.rot_axis2(-angle) if axis == 2 else sp.rot_axis3(-angle))
    return sp.Matrix(x[:3]) + about(1, phi) * about(2, theta) * about(3, gamma) * sp.Matrix(mark)


def marker_text():
    """`shown`: a marker's position, then its derivatives by phi, theta, gamma (those by x, y, z are 1)."""
    x, mark = sp.symbols(disc.STATES, real=True), sp.symbols("p_1:4", real=True)
    y = marker(x, mark)
    pairs, outs = gen_sympy.steps([], list(y) + [sp.diff(e, a) for e in y for a in x[6:9]])
    return gen_sympy.body(x, mark, pairs, outs, range(12), 12).replace("kernel", "shown")


def shared_library(source, made, flags):
    """In two steps: linked with -ffast-math it would flush small numbers to zero in all of the process."""
    subprocess.run(["gcc", *flags, "-w", "-fPIC", "-c", source, "-o", source.with_suffix(".o")], check=True)
    subprocess.run(["gcc", "-shared", "-fopenmp", source.with_suffix(".o"), "-o", made, "-lm"], check=True)


def library(out):
    """Compiles where it is not there yet; SymPy's part takes a minute."""
    out.mkdir(parents=True, exist_ok=True)
    made, source = out / "libfit.so", out / "fit.c"
    if not made.exists() or made.stat().st_mtime < max(f.stat().st_mtime for f in (HERE / "flight.c", HERE / "native.py")):
        head = f"#include <math.h>\n#define NX {NX}\n#define NC {NC}\n#define NP {len(disc.PARAMETERS)}\n#define WIDTH {WIDTH}\n"
        source.write_text(head + motion_text() + marker_text() + (HERE / "flight.c").read_text())
        shared_library(source, made, FLAGS)
    return Native(ctypes.CDLL(str(made)))


class Native:
    """The library's functions on numpy arrays; `substeps` of Runge and Kutta's method in each sample's interval."""

    def __init__(self, lib):
        self.lib = lib

    def call(self, name, *args):
        pointer = lambda a: a.ctypes.data_as(ctypes.c_void_p) if isinstance(a, np.ndarray) else a
        self.lib[name](*[pointer(a) for a in args])

    def fly(self, p, start, samples, interval, substeps):
        states = np.empty((len(start), samples, NX))
        start = np.ascontiguousarray(start)
        self.call("fly", len(start), samples, substeps, ctypes.c_double(interval), p, start, states)
        return states

    def markers(self, states, marks):
        shown = np.empty(states.shape[:2] + (len(marks), 3))
        self.call("markers", states.shape[0] * states.shape[1], states, len(marks), marks, shown)
        return shown

    def residuals(self, p, start, data, substeps):
        r = np.empty(data.seen.shape)
        self.call("residuals", *self.arguments(p, start, data, substeps), r)
        return r.ravel()

    def jacobian(self, p, start, data, substeps):
        """Rows of 20: by the coefficients, then by the flight's own initial state."""
        r, J = np.empty(data.seen.shape), np.empty((data.seen.size, WIDTH))
        self.call("jacobian", *self.arguments(p, start, data, substeps), r, J)
        return r.ravel(), J

    def arguments(self, p, start, data, substeps):
        flights, samples, marks, _ = data.seen.shape
        self.kept = np.ascontiguousarray(p), np.ascontiguousarray(start)  # alive during the call
        scale, interval = ctypes.c_double(1 / data.sigma), ctypes.c_double(data.interval)
        return flights, samples, substeps, interval, *self.kept, marks, data.marks, data.seen, scale
