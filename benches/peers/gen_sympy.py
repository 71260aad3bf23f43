"""SymPy: differentiate, common subexpressions, C code."""

import functools

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

import chain as chains
import disc
from unit import FUNCTIONS, NP, NX, Unit, dense_map, shapes


class Printer(C99CodePrinter):
    """Small powers as products: SymPy would print calls of pow."""

    def _print_Pow(self, e):
        base, n = e.as_base_exp()
        if n.is_Integer and 2 <= abs(n) <= 4:
            product = "*".join([self.parenthesize(base, PRECEDENCE["Atom"])] * abs(int(n)))
            return f"({product})" if n > 0 else f"1.0/({product})"
        return super()._print_Pow(e)


class Roots:
    """Powers of n/2 as powers of a named root, so that each root is taken once and pow is never called."""

    def __init__(self):
        self.named = {}

    def __call__(self, expr):
        half = lambda e: e.is_Pow and e.exp.is_Rational and e.exp.q == 2
        return expr.replace(half, lambda e: self.name(e.base) ** (2 * e.exp))

    def name(self, base):
        return self.named.setdefault(base, sp.Symbol(f"root{len(self.named)}", positive=True))


@functools.cache
def tables(variant, chain):
    """Symbols, named quantities, f, and both Jacobians: slow to make, and the same for all that follows."""
    x = sp.symbols(disc.STATES, real=True)
    p = sp.symbols(["p_" + n for n in disc.PARAMETERS], real=True)
    names = chains.Names(lambda n: sp.Symbol("q_" + n, real=True), chain)
    rates, _ = disc.derivative(sp, x, p, variant, names)
    jacs = [chains.jacobian(rates, names.defined, by, sp.diff, lambda e: e == 0) for by in (x, p)]
    return x, p, [(s, e) for _, s, e in names.defined], rates, jacs


def outputs(function, variant, chain):
    """f and what is not zero of the Jacobians, with its places."""
    x, p, defined, rates, jacs = tables(variant, chain)
    flat, maps = list(rates), [[], []]
    for slot in range(FUNCTIONS.index(function)):
        places = dense_map(NX, (NX, NP)[slot])
        maps[slot] = [(i, j) for i, j in places if jacs[slot][i][j] != 0]
        flat += [jacs[slot][i][j] for i, j in maps[slot]]
    return x, p, defined, flat, maps


def shared(assignments, flat):
    """CSE of named quantities and outputs together, each name defined before it is used."""
    everything = [e for _, e in assignments] + flat
    pairs, rest = sp.cse(everything, symbols=sp.numbered_symbols("t"), order="none")
    waiting = dict(pairs) | {s: e for (s, _), e in zip(assignments, rest)}
    ordered = []

    def define(symbol):
        expression = waiting.pop(symbol, None)
        if expression is not None:
            for s in sorted(expression.free_symbols, key=str):
                define(s)
            ordered.append((symbol, expression))

    for s in list(waiting):
        define(s)
    return ordered, rest[len(assignments) :]


def steps(defined, flat):
    """Assignments, and the outputs by their names. SymPy's own preprocessing, optimizations="basic", costs operations here."""
    roots = Roots()
    flat = [roots(e) for e in flat]
    defined = [(s, roots(e)) for s, e in defined]
    return shared(defined + [(s, sp.sqrt(b)) for b, s in roots.named.items()], flat)


def body(x, p, pairs, outs, places, size):
    """C text; `places` are the indices of the outputs, every other of `size` is a zero."""
    printer = Printer()
    at = dict(zip(places, outs))
    lines = [f"const double {s} = states[{i}];" for i, s in enumerate(x)]
    lines += [f"const double {s} = params[{i}];" for i, s in enumerate(p)]
    lines += [f"const double {s} = {printer.doprint(e)};" for s, e in pairs]
    lines += [f"out[{i}] = {printer.doprint(at.get(i, sp.Integer(0)))};" for i in range(size)]
    return "static inline void kernel(const double* states, const double* params, double* out) {\n  " + "\n  ".join(lines) + "\n}\n"


WRAPPER = "void SYM(const double* x, const double* p, double* out) { kernel(x, p, out); }\n"


@functools.cache
def leanest(function, variant, chain):
    x, p, defined, flat, maps = outputs(function, variant, chain)
    return x, p, maps, *steps(defined, flat)


def generate(layouts):
    for variant in disc.VARIANTS:
        for function in FUNCTIONS:
            for chain, layout in shapes(function, layouts):
                x, p, maps, pairs, outs = leanest(function, variant, chain)
                places = range(len(outs))
                if layout == "dense":
                    places = [*range(12), *(12 + NX * i + j for i, j in maps[0]), *(156 + NP * i + j for i, j in maps[1])]
                    maps = [dense_map(NX, n) if m else [] for m, n in zip(maps, (NX, NP))]
                kernel = body(x, p, pairs, outs, places, 12 + len(maps[0]) + len(maps[1]))
                text = "#include <math.h>\n" + kernel + WRAPPER
                yield Unit("sympy", function, variant, chain, layout, kernel, text, "c", *maps)
