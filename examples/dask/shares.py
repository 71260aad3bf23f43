"""A sweep or a bootstrap cut into shares that Dask runs, on this machine or on a cluster whose machines see one folder.

    python shares.py sweep backhands --out swept
    python shares.py bootstrap examples/disc --refits 200 --out scattered --shares 4
    python shares.py sweep plan.toml --out /shared/swept --shares 64 --scheduler tcp://head:8786

Each share is a process `hyzer COMMAND … --part I/N` on one thread; a last call without --part joins them. The results are the
same bits however they are cut. A share that failed is tried again, and does only what it has not written. Options that are
not among those below go to hyzer. Needs dask[distributed], and hyzer on every machine (--hyzer PATH).
"""

import argparse
import subprocess
import sys

from dask.distributed import Client, LocalCluster, as_completed


def run(command, part):
    """Runs one share, or joins all where part is None."""
    command = [*command, "--threads", "1"]
    if part is not None:
        command += ["--part", part]
    done = subprocess.run(command, capture_output=True, text=True)
    # 1: done, but the fit cannot be relied on; hyzer says why.
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()}")
    return done


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["sweep", "bootstrap"])
    parser.add_argument("of", metavar="PLAN|DATASET")
    parser.add_argument("--shares", type=int, default=8)
    parser.add_argument("--scheduler", help="address of a Dask scheduler; without it a cluster on this machine")
    parser.add_argument("--hyzer", default="hyzer")
    options, rest = parser.parse_known_args()
    command = [options.hyzer, options.command, options.of, *rest]
    cluster = options.scheduler or LocalCluster(threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        parts = [f"{k + 1}/{options.shares}" for k in range(options.shares)]
        shares = client.map(lambda part: run(command, part).returncode, parts, retries=2, pure=False)
        for done, share in enumerate(as_completed(shares), 1):
            share.result()
            print(f"{done} of {options.shares} shares", file=sys.stderr)
    joined = run(command, None)
    print(joined.stdout, end="")
    print(joined.stderr, end="", file=sys.stderr)
    sys.exit(joined.returncode)


if __name__ == "__main__":
    main()
