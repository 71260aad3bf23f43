"""Benchmarks the fit beside the peers: `python3 benches/fit/run.py [--quick]` writes docs/benchmarks-fit.md.

Uses the peers' environment, target/peers/venv, and makes it where it is not there.
"""

import json
import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
REQUIREMENTS = ROOT / "benches" / "peers" / "requirements.txt"


def environment():
    """As benches/peers/run.py makes it."""
    folder = ROOT / "target" / "peers" / "venv"
    python, stamp, wanted = folder / "bin" / "python", folder / "requirements.txt", REQUIREMENTS.read_text()
    if not stamp.exists() or stamp.read_text() != wanted:
        venv.create(folder, with_pip=True, clear=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "-r", REQUIREMENTS], check=True)
        stamp.write_text(wanted)
    return python


def main():
    python = environment()
    subprocess.run(["cargo", "build", "--release", "--bin", "hyzer", "--example", "fit_alone"], cwd=ROOT, check=True)
    asked = ["cargo", "metadata", "--format-version", "1", "--no-deps"]
    target = json.loads(subprocess.run(asked, cwd=ROOT, check=True, capture_output=True).stdout)["target_directory"]
    # SymPy's order of terms depends on the seed; threads that wait give way to others.
    env = {**os.environ, "PYTHONHASHSEED": "0", "OMP_WAIT_POLICY": "passive"}
    built = pathlib.Path(target) / "release"
    command = [python, HERE / "measure.py", "--hyzer", built / "hyzer", "--alone", built / "examples" / "fit_alone", "--out", pathlib.Path(target) / "fit-bench"]
    subprocess.run([*command, "--page", ROOT / "docs" / "benchmarks-fit.md", *sys.argv[1:]], env=env, check=True)


if __name__ == "__main__":
    main()
