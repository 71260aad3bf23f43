"""Discovery beside its peers: `python3 benches/discovery/run.py [--datasets N]` writes docs/studies/discovery-peers.md.

`hyzer diagnose`, pysindy, and stepwise regression with the predicted squared error, on the same hidden cases. What each is given, and
how it is scored, stands on the page. Minutes on four quiet cores, most of them `hyzer diagnose` on 190 datasets; `--datasets 1` takes one of each effect instead of five.
The peers live in an environment of their own, target/peers/discovery, which is made where it is not there (pip).

discovery_cases (an example of studies/) writes the cases with their truth as folders
tracks.py    marker tracks to poses, rates, accelerations, and the six coefficients in the disc's own frame
library.py   the terms that the peers choose from, and which of them is hidden
sparse.py    pysindy's sequentially thresholded least squares on one equation
stepwise.py  stepwise regression, which stops by the predicted squared error
peers.py     both with every setting, and the choices made with knowledge of the truth
ours.py      `hyzer diagnose` and what its report says
measure.py   all of them on all cases, then in turn against the clock; results.json in discovery-bench of cargo's target folder
page.py      the page from the results alone
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
    python = environment.peers("discovery", HERE / "requirements.txt")
    target = environment.built("discovery_cases")
    cases = target / "discovery-cases"
    subprocess.run([target / "release" / "examples" / "discovery_cases", cases], check=True)
    # Every case has a core of its own; the peers' matrices are too small to share.
    env = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = [python, HERE / "measure.py", "--hyzer", target / "release" / "hyzer", "--cases", cases, "--out", target / "discovery-bench"]
    subprocess.run([*command, "--page", ROOT / "docs" / "studies" / "discovery-peers.md", *sys.argv[1:]], env=env, check=True)


if __name__ == "__main__":
    main()
