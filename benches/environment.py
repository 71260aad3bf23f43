"""What the benchmarks beside peers share: an environment for the peers, and our own programs, built."""

import json
import pathlib
import subprocess
import venv

ROOT = pathlib.Path(__file__).resolve().parents[1]


def peers(name, requirements):
    """Python of the environment target/peers/NAME, made where it is not there or is of other requirements."""
    folder = ROOT / "target" / "peers" / name
    python, stamp, wanted = folder / "bin" / "python", folder / "requirements.txt", requirements.read_text()
    if not stamp.exists() or stamp.read_text() != wanted:
        venv.create(folder, with_pip=True, clear=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "-r", requirements], check=True)
        stamp.write_text(wanted)
    return python


def built(example):
    """Cargo's target folder, with `hyzer` and an example in `release`."""
    asked = ["cargo", "metadata", "--format-version", "1", "--no-deps"]
    told = subprocess.run(asked, cwd=ROOT, check=True, capture_output=True).stdout
    target = pathlib.Path(json.loads(told)["target_directory"])
    build = ["cargo", "build", "--release", "--target-dir", target, "--workspace"]
    subprocess.run([*build, "--bin", "hyzer", "--example", example], cwd=ROOT, check=True)
    return target
