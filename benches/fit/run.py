"""Benchmarks the fit beside the peers: `python3 benches/fit/run.py [--quick]` writes docs/studies/benchmarks-fit.md.

Uses the peers' environment, target/peers/venv, and makes it where it is not there.
"""

import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import environment

ROOT = environment.ROOT


def main():
    python = environment.peers("venv", ROOT / "benches" / "peers" / "requirements.txt")
    target = environment.built("fit_alone")
    built = target / "release"
    # SymPy's order of terms depends on the seed; threads that wait give way to others.
    env = {**os.environ, "PYTHONHASHSEED": "0", "OMP_WAIT_POLICY": "passive"}
    command = [python, HERE / "measure.py", "--hyzer", built / "hyzer", "--alone", built / "examples" / "fit_alone", "--out", target / "fit-bench"]
    subprocess.run([*command, "--page", ROOT / "docs" / "studies" / "benchmarks-fit.md", *sys.argv[1:]], env=env, check=True)


if __name__ == "__main__":
    main()
