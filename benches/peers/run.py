"""Benchmarks the peers: `python3 benches/peers/run.py [--quick] [--compare]` writes target/peers/results.json.

With `--compare` it then times them and us in one process and writes docs/benchmarks.md.

Makes an environment of its own in target/peers/venv and leaves everything else alone.
"""

import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE.parents[1] / "target" / "peers"


def main():
    python, stamp = OUT / "venv" / "bin" / "python", OUT / "venv" / "requirements.txt"
    wanted = (HERE / "requirements.txt").read_text()
    if not stamp.exists() or stamp.read_text() != wanted:
        venv.create(OUT / "venv", with_pip=True, clear=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "-r", HERE / "requirements.txt"], check=True)
        stamp.write_text(wanted)
    # SymPy's order of terms, and so its code, depends on the seed.
    env = {**os.environ, "PYTHONHASHSEED": "0"}
    ours = [a for a in sys.argv[1:] if a != "--compare"]
    subprocess.run([python, HERE / "measure.py", "--out", OUT, *ours], env=env, check=True)
    if "--compare" in sys.argv:
        command = ["cargo", "bench", "--bench", "compare", "--", "--out", "docs/benchmarks.md"]
        subprocess.run(command, cwd=HERE.parents[1], check=True)


if __name__ == "__main__":
    main()
