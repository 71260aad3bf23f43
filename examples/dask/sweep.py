"""A sweep cut into shares that Dask runs, on this machine or on a cluster whose machines see one folder.

    python sweep.py backhands --out swept --shares 8
    python sweep.py plan.toml --out /shared/swept --shares 64 --scheduler tcp://head:8786

Each share is a process `hyzer sweep PLAN --out DIR --part I/N` on one thread; a last call without --part joins them. The
flights are the same bits however they are cut. A share that failed is tried again, and flies only what it has not written.
Needs dask[distributed], and hyzer on every machine (--hyzer PATH).
"""

import argparse
import subprocess
import sys

from dask.distributed import Client, LocalCluster, as_completed


def fly(hyzer, plan, out, part):
    """Runs one share, or joins all where part is None."""
    command = [hyzer, "sweep", plan, "--out", out, "--threads", "1"]
    if part is not None:
        command += ["--part", part]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()}")
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plan")
    parser.add_argument("--out", required=True)
    parser.add_argument("--shares", type=int, default=8)
    parser.add_argument("--scheduler", help="address of a Dask scheduler; without it a cluster on this machine")
    parser.add_argument("--hyzer", default="hyzer")
    options = parser.parse_args()
    cluster = options.scheduler or LocalCluster(threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        parts = [f"{k + 1}/{options.shares}" for k in range(options.shares)]
        shares = client.map(
            lambda part: fly(options.hyzer, options.plan, options.out, part), parts, retries=2, pure=False
        )
        for done, share in enumerate(as_completed(shares), 1):
            share.result()
            print(f"{done} of {options.shares} shares", file=sys.stderr)
    print(fly(options.hyzer, options.plan, options.out, None), end="")


if __name__ == "__main__":
    main()
