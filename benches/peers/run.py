"""Benchmarks the peers: `python3 benches/peers/run.py [--quick]` writes target/peers/results.json.

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
    sys.exit(subprocess.run([python, HERE / "measure.py", "--out", OUT, *sys.argv[1:]], env=env).returncode)


if __name__ == "__main__":
    main()
