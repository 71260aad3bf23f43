"""Inside the peers' own environment: generate, compile, check, time, choose, and write results.json."""

import argparse
import ctypes
import json
import pathlib
import platform

import build
import check
import count_ops
import frispy_flight
import gen_casadi
import gen_sympy
import gen_wrenfold
import states
import timing
from unit import FUNCTIONS, LAYOUTS

GENERATORS = (gen_casadi, gen_wrenfold, gen_sympy)
PEERS = ("casadi", "wrenfold_rust", "wrenfold_cpp", "sympy")


def say(text):
    print(text, flush=True)


def loaded(library, symbol):
    return ctypes.CDLL(str(library))[symbol]


def candidates(units, out):
    """Every unit under every set of flags, compiled: a dict each, with its unit."""
    made = []
    for peer in PEERS:
        mine = [u for u in units if u.peer == peer]
        for flags in ("strict",) if peer == "wrenfold_rust" else build.FLAGS:
            target = out / "candidates" / f"lib{peer}_{flags}.so"
            parts = [(u, f"{u.key}_{flags}", flags) for u in mine]
            build.library(target, parts)
            made += [{"unit": u, "library": target, "symbol": s, "flags": flags} for u, s, _ in parts]
        say(f"  compiled {peer}")
    return made


def verify(made, rows):
    """Marks what agrees with CasADi's complete function, compiled strictly, and that with mechanics."""
    first = next(c for c in made if c["unit"].key == "casadi_fjp_trig_plain_sparse" and c["flags"] == "strict")
    reference = check.dense(loaded(first["library"], first["symbol"]), rows, first["unit"].J, first["unit"].Jp)
    for c in made:
        unit = c["unit"]
        got = check.dense(loaded(c["library"], c["symbol"]), rows, unit.J, unit.Jp)
        want = [r if given else 0 * r for r, given in zip(reference, (True, unit.J, unit.Jp))]
        c["errors"] = check.worst(got, want, rows, reference)
        c["agrees"] = max(c["errors"]) <= check.TOLERANCE
    return check.mechanics(reference[0], rows)


def best(made, peer, function, chains):
    mine = [c for c in made if c["unit"].peer == peer and c["unit"].function == function and c["unit"].chain in chains]
    return min((c for c in mine if c["agrees"]), key=lambda c: c["ns_median"])


def described(c):
    unit = c["unit"]
    return {
        "peer": unit.peer, "function": unit.function, "variant": unit.variant, "chain": unit.chain,
        "layout": unit.layout, "flags": c["flags"], "ops": count_ops.count(unit.kernel),
        "ns_median": c["ns_median"], "ns_p10": c["ns_p10"], "agrees": c["agrees"], "errors_f_J_Jp": c["errors"],
    }  # fmt: skip


def leanest(made, peer, function, chains):
    mine = [c for c in made if c["unit"].peer == peer and c["unit"].function == function and c["unit"].chain in chains]
    return min((count_ops.count(c["unit"].kernel) for c in mine), key=lambda ops: ops["total"])


def ship(made, chains, folder, rounds):
    """The best of each peer as lib<peer>.so with <peer>_f, _fj, _fjp, timed once more; and what their outputs mean."""
    folder.mkdir(parents=True, exist_ok=True)
    picked = {(p, f): best(made, p, f, chains) for p in PEERS for f in FUNCTIONS}
    for peer in PEERS:
        parts = [(c["unit"], f"{p}_{f}", c["flags"]) for (p, f), c in picked.items() if p == peer]
        build.library(folder / f"lib{peer}.so", parts)
    times = timing.measure([(folder / f"lib{p}.so", f"{p}_{f}") for p, f in picked], folder, rounds)
    report = {p: {} for p in PEERS}
    for ((peer, function), c), (median, p10) in zip(picked.items(), times):
        report[peer][function] = {
            **described(c), "library": f"lib{peer}.so", "symbol": f"{peer}_{function}",
            "ns_median": median, "ns_p10": p10, "fewest_ops": leanest(made, peer, function, chains),
            "outputs": 12 + len(c["unit"].J) + len(c["unit"].Jp), "J": c["unit"].J, "Jp": c["unit"].Jp,
        }  # fmt: skip
    return report


def tool_version(command):
    return build.run(command).splitlines()[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    out, rounds = options.out, 15 if options.quick else 101

    say("generating")
    layouts = LAYOUTS[:1] if options.quick else LAYOUTS
    units = [u for g in GENERATORS for u in g.generate(layouts)]
    made = candidates(units, out)
    rows = states.draw(200, seed=2)
    mechanics = verify(made, rows)
    say(f"mechanics to {mechanics:.1e}; {sum(c['agrees'] for c in made)} of {len(made)} agree to {check.TOLERANCE:g}")
    if mechanics > 1e-9:
        raise SystemExit("the peers' equations are not those of mechanics")
    say("timing")
    times = timing.measure([(c["library"], c["symbol"]) for c in made], out, rounds)
    for c, (median, p10) in zip(made, times):
        c["ns_median"], c["ns_p10"] = median, p10
    results = {
        "schema": "hyzer.peers/1",
        "machine": {"cpu": platform.processor() or platform.machine(), "gcc": tool_version(["gcc", "--version"]),
                    "rustc": tool_version(["rustc", "--version"])},
        "mechanics_error": mechanics,
        "best": ship(made, ("plain", "air", "named"), out / "best", rounds),
        "plain": ship(made, ("plain",), out / "plain", rounds),
        "candidates": [described(c) for c in made],
        "frispy": frispy_flight.measure(5 if options.quick else 31),
    }
    (out / "results.json").write_text(json.dumps(results, indent=1))
    for title in ("plain", "best"):
        for peer, functions in results[title].items():
            cells = [f"{f} {r['fewest_ops']['total']} ops {r['ns_median']} ns" for f, r in functions.items()]
            say(f"{title:6} {peer:14} " + " | ".join(cells))
    flight = results["frispy"]["defaults"]
    say(f"frispy: {flight['ms_median']:.2f} ms a flight")


if __name__ == "__main__":
    main()
