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
    return min((c for c in mine if c["agrees"]), key=lambda c: c["ns_p10"])


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


def ship(made, chains, folder):
    """The best of each peer as lib<peer>.so with <peer>_f, _fj, _fjp, and what their outputs mean."""
    report = {}
    for peer in PEERS:
        picked = {f: best(made, peer, f, chains) for f in FUNCTIONS}
        folder.mkdir(parents=True, exist_ok=True)
        build.library(folder / f"lib{peer}.so", [(c["unit"], f"{peer}_{f}", c["flags"]) for f, c in picked.items()])
        report[peer] = {
            f: {
                **described(c), "library": f"{folder.name}/lib{peer}.so", "symbol": f"{peer}_{f}",
                "fewest_ops": leanest(made, peer, f, chains),
                "outputs": 12 + len(c["unit"].J) + len(c["unit"].Jp), "J": c["unit"].J, "Jp": c["unit"].Jp,
            }
            for f, c in picked.items()
        }  # fmt: skip
    return report


def time_again(reports, out, rounds):
    """Times what is shipped, all of it in one interleaved run, so that every figure saw the same machine."""
    entries = [r for report in reports for functions in report.values() for r in functions.values()]
    times = timing.measure([(out / r["library"], r["symbol"]) for r in entries], out, rounds, calls=2000)
    for r, (median, p10) in zip(entries, times):
        r["ns_median"], r["ns_p10"] = median, p10


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
    shipped = {
        "best": ship(made, ("plain", "air", "named"), out / "best"),
        "plain": ship(made, ("plain",), out / "plain"),
    }
    time_again(shipped.values(), out, rounds)
    results = {
        "schema": "hyzer.peers/1",
        "machine": {"cpu": platform.processor() or platform.machine(), "gcc": tool_version(["gcc", "--version"]),
                    "rustc": tool_version(["rustc", "--version"])},
        "mechanics_error": mechanics,
        **shipped,
        "candidates": [described(c) for c in made],
        "frispy": frispy_flight.measure(5 if options.quick else 31),
    }
    (out / "results.json").write_text(json.dumps(results, indent=1))
    for title in ("plain", "best"):
        for peer, functions in results[title].items():
            cells = [f"{f} {r['fewest_ops']['total']} ops {r['ns_median']} ({r['ns_p10']}) ns" for f, r in functions.items()]
            say(f"{title:6} {peer:14} " + " | ".join(cells))
    flight = results["frispy"]["defaults"]
    say(f"frispy: {flight['ms_median']:.2f} ms a flight")


if __name__ == "__main__":
    main()
