"""CasADi: SX graph, its own Jacobians, CSE, C code."""

import functools
import itertools
import pathlib
import re
import tempfile

import casadi as ca

import chain as chains
import disc
from unit import FUNCTIONS, NP, NX, Unit, shapes

# static lets gcc inline the kernel into the wrapper and drop CasADi's null checks on its arguments.
HEAD = "#define CASADI_SYMBOL_EXPORT static __attribute__((unused))\n"
WRAPPER = """
void SYM(const double* x, const double* p, double* out) {
  const double* arg[2] = {x, p};
  double* res[3] = {out, out + 12, out + %d};
  disc(arg, res, 0, 0, 0);
}
"""


def jacobian(f, by, weight):
    return ca.jacobian(f, by, {"helper_options": {"ad_weight": weight, "ad_weight_sp": weight}})


# Every way to the Jacobian that the tool offers; the one with the fewest operations is kept.
WAYS = {
    "forward": lambda f, by: jacobian(f, by, 0.0),
    "reverse": lambda f, by: jacobian(f, by, 1.0),
    "default": ca.jacobian,
    "rows": lambda f, by: ca.vertcat(*[ca.gradient(f[i], by).T for i in range(f.numel())]),
}


def by_hand(rates, defined, by):
    rows = chains.jacobian(rates, defined, ca.vertsplit(by), ca.jacobian, lambda e: e.is_zero())
    return ca.vertcat(*[ca.horzcat(*r) for r in rows])


def candidates(function, variant, chain):
    """Every combination of ways to the Jacobians that the function has."""
    x, p = ca.SX.sym("x", NX), ca.SX.sym("p", NP)
    args = (ca, ca.vertsplit(x), ca.vertsplit(p), variant)
    names = chains.Names(ca.SX.sym, chain)
    f = ca.vertcat(*disc.derivative(*args)[0])
    rates, _ = disc.derivative(*args, names)
    tables = []
    for by in (x, p)[: FUNCTIONS.index(function)]:
        tables.append([way(f, by) for way in WAYS.values()])
        if chain != "plain":
            # By hand for the states; for the parameters whatever is leaner.
            tables[-1] = [by_hand(rates, names.defined, by)] + (tables[-1] if by is p else [])
    for chosen in itertools.product(*tables):
        outs = [f, *chosen]
        for _, symbol, expression in reversed(names.defined):
            outs = ca.substitute(outs, [symbol], [expression])
        yield x, p, [ca.sparsify(o) for o in ca.cse(outs)]


@functools.cache
def leanest(function, variant, chain):
    return min(candidates(function, variant, chain), key=lambda c: function_of(*c).n_instructions())


def function_of(x, p, outs):
    return ca.Function("disc", [x, p], [ca.densify(outs[0])] + outs[1:], {"cse": True})


def to_c(fun):
    gen = ca.CodeGenerator("disc.c", {"with_header": False, "main": False})
    gen.add(fun)
    with tempfile.TemporaryDirectory() as tmp:
        gen.generate(tmp + "/")
        text = (pathlib.Path(tmp) / "disc.c").read_text()
    # As generated, a helper such as casadi_sq is visible outside and so is not inlined in a shared library.
    return re.sub(r"^casadi_real casadi_", "static inline casadi_real casadi_", text, flags=re.M)


def places(matrix):
    """(row, column) in CasADi's own order of storage, column by column."""
    rows, cols = matrix.sparsity().get_triplet()
    return list(zip(rows, cols))


def generate(layouts):
    for variant in disc.VARIANTS:
        for function in FUNCTIONS:
            for chain, layout in shapes(function, layouts):
                x, p, outs = leanest(function, variant, chain)
                if layout == "dense":
                    outs = [ca.densify(o) for o in outs]
                text = HEAD + to_c(function_of(x, p, outs))
                maps = [places(o) for o in outs[1:]] + [[], []]
                kernel = re.search(r"static int casadi_f0.*?\n}\n", text, re.S).group(0)
                text += WRAPPER % (12 + len(maps[0]))
                yield Unit("casadi", function, variant, chain, layout, kernel, text, "c", maps[0], maps[1])
