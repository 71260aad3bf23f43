"""Runs the C driver and reads medians."""

import pathlib
import statistics

import build
import states


def measure(entries, work, rounds, calls=1000):
    """`entries`: (library, symbol). Median and tenth percentile of ns per call, in that order."""
    driver, listing, data = work / "driver", work / "list.txt", work / "states.bin"
    build.run(["gcc", "-O2", "-o", driver, pathlib.Path(__file__).with_name("driver.c"), "-ldl"])
    listing.write_text("".join(f"{lib} {sym}\n" for lib, sym in entries))
    states.draw(1000).tofile(data)
    text = build.run([driver, listing, data, str(rounds), str(calls)])
    columns = zip(*[[float(v) for v in line.split()] for line in text.splitlines()])
    return [(round(statistics.median(c), 2), round(sorted(c)[len(c) // 10], 2)) for c in columns]
