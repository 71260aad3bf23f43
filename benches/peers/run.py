"""Benchmarks the peers: `python3 benches/peers/run.py [--quick] [--compare]` writes target/peers/results.json.

With `--compare` it then times them and us in one process and writes docs/studies/benchmarks.md.

Makes an environment of its own in target/peers/venv and leaves everything else alone.
"""

import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import environment

OUT = environment.ROOT / "target" / "peers"


def main():
    python = environment.peers("venv", HERE / "requirements.txt")
    # SymPy's order of terms, and so its code, depends on the seed.
    env = {**os.environ, "PYTHONHASHSEED": "0"}
    ours = [a for a in sys.argv[1:] if a != "--compare"]
    subprocess.run([python, HERE / "measure.py", "--out", OUT, *ours], env=env, check=True)
    if "--compare" in sys.argv:
        command = ["cargo", "bench", "--bench", "compare", "--", "--out", "docs/studies/benchmarks.md"]
        subprocess.run(command, cwd=HERE.parents[1], check=True)


if __name__ == "__main__":
    main()
