"""wrenfold: Rust and C++ from the same symbolic function, most thorough of its own settings."""

import re
from typing import Annotated

from wrenfold import code_generation as cg
from wrenfold import sym
from wrenfold.type_annotations import Shape

import chain as chains
import disc
from unit import FUNCTIONS, NP, NX, Unit, dense_map, shapes

# The least part of wrenfold's span.h that its C++ needs: reading and writing an array, column by column.
CPP_HEAD = """#include <cmath>
namespace wf {
template <int R, int C, typename T> struct span {
  T* data;
  constexpr T& operator()(int i, int j) const { return data[i + R * j]; }
};
template <int R, int C> constexpr span<R, C, const double> make_input_span(const double* d) { return {d}; }
template <int R, int C> constexpr span<R, C, double> make_output_span(double* d) { return {d}; }
}  // namespace wf
// The kernel goes in a namespace without a name: else the linker would merge the kernels of several files.
"""

RUST_HEAD = "use crate::{From, To};\n"

# More passes than six change nothing here.
PASSES = (1, 2, 3, 4, 6)


def matrix(rows):
    return Annotated[sym.MatrixExpr, Shape(rows=rows, cols=1)]


def zero(expression):
    return expression.is_identical_to(sym.zero)


def jacobians(x, p, function, variant, chain):
    """f, then a Jacobian for x and for p as the function asks, as rows."""
    x, p = [x[i] for i in range(NX)], [p[i] for i in range(NP)]
    names = chains.Names(sym.symbol, chain)
    rates, _ = disc.derivative(sym, x, p, variant, names)
    tables = []
    for by in (x, p)[: FUNCTIONS.index(function)]:
        rows = chains.jacobian(rates, names.defined, by, lambda e, s: e.diff(s), zero)
        tables.append(sym.matrix(rows))
    f = sym.vector(*rates)
    for _, symbol, expression in reversed(names.defined):
        f = f.subs(symbol, expression)
        tables = [t.subs(symbol, expression) for t in tables]
    return f, tables


def describe(function, variant, chain, layout):
    """The symbolic function, and the place of each output."""
    maps = [[], []]

    def kernel(x, p):
        f, tables = jacobians(x, p, function, variant, chain)
        outs = [cg.OutputArg(f, "out_f")]
        for slot, table in enumerate(tables):
            places = dense_map(*table.shape)
            if layout == "sparse":
                places = [(i, j) for i, j in places if not zero(table[i, j])]
            maps[slot] = places
            outs.append(cg.OutputArg(sym.vector(*[table[i, j] for i, j in places]), ("out_j", "out_jp")[slot]))
        return outs

    kernel.__annotations__ = {"x": matrix(NX), "p": matrix(NP)}
    return cg.create_function_description(kernel, name="kernel"), maps


def transpiled(description, count):
    """The fewest operations over the settings that the tool has."""
    best = None
    for passes in PASSES:
        options = cg.OptimizationParams()
        options.factorization_passes = passes
        options.binarize_operations = True
        tree = cg.transpile(description, optimization_params=options)
        total = count(cg.RustGenerator().generate(tree))
        if best is None or total < best[0]:
            best = (total, tree)
    return best[1]


def own_count(code):
    return int(re.search(r"// total: (\d+)", code).group(1))


def cpp_wrapper(maps, outs):
    offsets = ["out", "out + 12", f"out + {12 + len(maps[0])}"][:outs]
    return (
        'extern "C" void SYM(const double* x, const double* p, double* out) '
        f"{{ kernel<double>(x, p, {', '.join(offsets)}); }}\n"
    )


def rust_wrapper(maps, outs):
    """A module of its own for every function, so that one crate can hold them all."""
    offsets = [0, 12, 12 + len(maps[0])][:outs]
    args = ", ".join(f"&mut To(unsafe {{ out.add({o}) }})" for o in offsets)
    return (
        "#[unsafe(no_mangle)]\npub unsafe extern \"C\" fn SYM(x: *const f64, p: *const f64, out: *mut f64) {\n"
        f"    kernel(&From(x), &From(p), {args});\n}}\n"
    )


def generate(layouts):
    for variant in disc.VARIANTS:
        for outs, function in enumerate(FUNCTIONS, 1):
            for chain, layout in shapes(function, layouts):
                description, maps = describe(function, variant, chain, layout)
                tree = transpiled(description, own_count)
                rust, cpp = cg.RustGenerator().generate(tree), cg.CppGenerator().generate(tree)
                shape = (function, variant, chain, layout)
                yield Unit("wrenfold_rust", *shape, rust, RUST_HEAD + rust + rust_wrapper(maps, outs), "rust", *maps)
                yield Unit("wrenfold_cpp", *shape, cpp, CPP_HEAD + "namespace {\n" + cpp + "}\n" + cpp_wrapper(maps, outs), "cpp", *maps)
