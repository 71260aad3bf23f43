"""Writes docs/studies/side-by-side.md: one task by hyzer and by five other programs.

python benches/side_by_side/run.py [--hyzer PYTHON]    PYTHON has hyzer; by default the one that runs this

Makes environments of its own for the others in target/peers.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import textwrap
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import environment

PAGE = environment.ROOT / "docs/studies/side-by-side.md"
ORDER = {"hyzer": "hyzer", "scipy": "SciPy", "casadi": "CasADi", "pysindy": "pysindy", "rocketpy": "RocketPy", "frispy": "FrisPy"}
DATA = """
import sys, hyzer
text = open(sys.argv[1]).read().split('\"\"\"')[1]
shots = [(12, 20), (25, 45), (40, 10), (18, 60)]
releases = [hyzer.Release(speed=v, launch=a, height=1.2, until=0.8, wind=(1, 0, 0)) for v, a in shots]
cork = {"cork": (0, 0, 0)}
made = hyzer.synthesize(hyzer.Model(text, parameters={"C_D": 0.64}), releases, markers=cork, noise_sigma=0.002)
hyzer.Dataset.from_pandas(made.to_pandas(), markers=cork, held_out=[6, 7]).save(sys.argv[2])
"""
HEAD = """# One task, six programs

<!-- Written by benches/side_by_side/run.py; do not edit. -->

A shuttlecock flies by weight and drag. Three questions: where does it land, hit at 25 m/s and 45° from 1.2 m, with C_D = 0.64? What is C_D by
eight flights, the last two of them held out? And what is said when the model is wrong? The flights are simulated, with C_D = 0.64, a noise of 2 mm at 120 Hz,
and a steady wind of 1 m/s that none of the programs is told of. Each program follows the first pages of its documentation; all are in
`benches/side_by_side/`, and `python benches/side_by_side/run.py` writes this page again.

Lines are those that are neither empty nor a comment. Seconds are of the whole process, start and imports included: the least of three runs.
FrisPy has no shuttlecock: it flies its disc, and is listed for its lines and seconds. RocketPy's air is 1.2006 kg/m³, that of the others 1.2.

"""
TOLD = {
    "hyzer": "cause and size",
    "scipy": "{tells}",
    "casadi": "{tells}",
    "pysindy": "equations",
    "rocketpy": "no fit",
    "frispy": "no fit",
}


def run(name, python, folder):
    """Return the seconds and the output of a program."""
    seconds = []
    for _ in range(3):
        begun = time.perf_counter()
        done = subprocess.run([python, HERE / f"{name}_.py", folder], check=True, capture_output=True, text=True)
        seconds.append(time.perf_counter() - begun)
    return min(seconds), done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hyzer", default=sys.executable)
    ours = parser.parse_args().hyzer
    others = environment.peers("side-by-side", HERE / "requirements.txt")
    pythons = dict.fromkeys(ORDER, others)
    pythons |= {"hyzer": ours, "frispy": environment.peers("frispy", HERE / "requirements-frispy.txt")}
    folder = pathlib.Path(tempfile.mkdtemp())
    subprocess.run([ours, "-c", DATA, HERE / "hyzer_.py", folder / "flights"], check=True)
    rows, told = [], {}
    for name, title in ORDER.items():
        seconds, told[name] = run(name, pythons[name], folder / "flights")
        lines = [line for line in (HERE / f"{name}_.py").read_text().splitlines() if line.strip() and not line.startswith("#")]
        said = dict(line.split(" ", 1) for line in told[name].splitlines() if line.split(" ")[0] in ("landing", "C_D", "tells"))
        drag = "–"
        if "C_D" in said:
            value, error = map(float, said["C_D"].split())
            drag = f"{value:.3f} ± {error:.3f}"
        landing = f"{float(said['landing']):.3f}" if "landing" in said and name != "frispy" else "–"
        tells = TOLD[name].format(tells=said.get("tells", ""))
        rows.append(f"| [{title}](../../benches/side_by_side/{name}_.py) | {len(lines)} | {seconds:.1f} | {landing} | {drag} | {tells} |")
    table = ["| program | lines | seconds | landing, m | C_D | told of the wind |", "|---|---:|---:|---:|---:|---|", *rows]
    quoted = [f"\n## What {ORDER[n]} says\n\n```text\n{wrapped(told[n])}\n```" for n in ("hyzer", "pysindy")]
    PAGE.write_text(HEAD + "\n".join(table) + "\n" + TAIL + "\n".join(quoted) + "\n", encoding="utf-8")
    shutil.rmtree(folder)


TAIL = """
hyzer names the cause and its size, and what it did to C_D. SciPy and CasADi tell an RMS residual; that it is too much only those see who know the noise. pysindy
tells an equation for each acceleration, without C_D or standard errors. RocketPy and FrisPy do not fit.

C_D is 0.64. Every fit without the wind is wrong by many of its own standard errors: these hold only if the model is right. That of hyzer differs from
those of SciPy and CasADi, as its errors are correlated in time (AR(1)), and theirs are white. SciPy and CasADi take a wind as two more
unknowns, once somebody has thought of it. hyzer tests the effects of its catalogue; it does not find what is neither there nor added. How pysindy, stepwise
regression and pyoperon find seeded effects is measured in [discovery-peers](discovery-peers.md).
"""


def wrapped(text, width=110):
    """Return text with long lines broken."""
    return "\n".join(part for line in text.strip().splitlines() for part in textwrap.wrap(line, width) or [""])


if __name__ == "__main__":
    main()
