"""Flights a second beside FrisPy, SciPy, heyoka.py and symjit: `python3 benches/sweep/run.py` writes docs/studies/benchmarks-sweep.md.

Makes an environment of its own in target/peers/sweep and a library of our flights in target/peers/flights.
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import environment

MANIFEST = """[package]
name = "flights"
version = "0.0.0"
edition = "2024"
[lib]
crate-type = ["cdylib"]
[dependencies]
{paths}
[workspace]
"""


def library(target):
    """FrisPy's equations in our language, as generated code over lanes, and the disc, as one library."""
    folder = environment.ROOT / "target" / "peers" / "flights"
    source = folder / "src"
    source.mkdir(parents=True, exist_ok=True)
    model = environment.ROOT / "model-spec" / "refuted" / "frispy.hyz"
    hyzer = target / "release" / "hyzer"
    subprocess.run([hyzer, "generate", model, "--lanes", "--out", source], check=True, stdout=subprocess.DEVNULL)
    rooms = {name: environment.ROOT / "crates" / name for name in ("lanes", "ode", "generated")}
    paths = [f'{name} = {{ package = "hyzer-{name}", path = "{path}" }}' for name, path in rooms.items()]
    (folder / "Cargo.toml").write_text(MANIFEST.format(paths="\n".join(paths)))
    (source / "lib.rs").write_text((HERE / "flights.rs").read_text())
    (source / "states.rs").write_text((HERE / "states.rs").read_text())
    build = ["cargo", "build", "--release", "--quiet", "--target-dir", folder / "target"]
    subprocess.run(build, cwd=folder, check=True)
    return folder / "target" / "release" / "libflights.so"


def main():
    python = environment.peers("sweep", HERE / "requirements.txt")
    target = environment.built("library")
    flights = library(target)
    # heyoka.py needs another NumPy than FrisPy.
    jit = environment.peers("jit", HERE / "requirements-jit.txt")
    compiled = environment.ROOT / "target" / "peers" / "jit.json"
    compiled.write_bytes(subprocess.run([jit, HERE / "jit.py", flights], check=True, capture_output=True).stdout)
    command = [python, HERE / "measure.py", flights, target / "release" / "hyzer", compiled, *sys.argv[1:]]
    subprocess.run(command, check=True)


if __name__ == "__main__":
    main()
