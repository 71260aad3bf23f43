"""`hyzer diagnose` on a folder, and what its report says of the hidden effect."""

import json
import subprocess
import time


def diagnose(hyzer, folder, out, *options):
    """Its report, and the seconds of the whole process."""
    clock = time.perf_counter()
    run = subprocess.run([hyzer, "diagnose", folder, "--out", out, *options], capture_output=True, text=True)
    seconds = time.perf_counter() - clock
    if run.returncode not in (0, 1):
        raise RuntimeError(f"hyzer diagnose {folder}: {run.stderr}")
    return json.loads((out / "report.json").read_text()), seconds


def told(report):
    """The causes, each as the names of its effects."""
    causes = [[effect["name"].replace("-", "_") for effect in cause["effects"]] for cause in report["explanations"]]
    return {"verdict": report["verdict"], "causes": causes, "seconds": report["seconds"]["total"]}


def judged(case, told):
    """What came of it, in one word, and how many explanations were left."""
    causes, truth = told["causes"], [case["effect"]]
    if told["verdict"] == "unattributed":
        # Terms of its own making, where no effect of the catalogue explains the flights.
        word = "outside"
    elif not causes:
        word = "none"
    elif causes == [truth]:
        word = "exact"
    elif truth in causes:
        word = "among"
    elif any(truth[0] in cause for cause in causes):
        word = "joined"
    else:
        word = "wrong" if len(causes) == 1 else "wrong set"
    return word, len(causes)
