import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tests_of_program import program

import hyzer

BALL = {"model": "ball", "until": "ground", "throw": {"speed": 30}}


def test_a_design_is_that_of_the_program(tmp_path: Path) -> None:
    options = ["--goal", "hit", "--target", "4,1,0", "--model", "ball", "--starts", "64"]
    run = program("design", *options, "--samples", "50", "--out", str(tmp_path / "one"))
    assert run.returncode == 0, run.stderr
    found = hyzer.design("ball", "hit", target=(4, 1, 0), starts=64, samples=50)
    assert found.to_dict() == json.loads((tmp_path / "one" / "design.json").read_text())
    found.save(tmp_path / "two")
    names = {path.name for path in (tmp_path / "one").iterdir()}
    assert {path.name for path in (tmp_path / "two").iterdir()} == names
    landing = hyzer.Model("ball").fly(found.release).landing
    assert np.allclose(landing, (4, 1, 0), atol=1e-2)


def test_a_design_within_bounds() -> None:
    found = hyzer.design("ball", "range", bounds={"speed": (5, 9)}, starts=32, samples=10)
    assert found.throw.to_dict()["speed"] <= 9
    with pytest.raises(hyzer.InputError, match="needs a target"):
        hyzer.design("ball", "hit")
    with pytest.raises(hyzer.InputError, match='goal is "win"'):
        hyzer.design("ball", "win")
    with pytest.raises(hyzer.InputError, match="bounds"):
        hyzer.design("ball", "range", bounds={"frob": (5, 9)})


def test_a_design_in_wind_scatters_by_a_fit(tmp_path: Path) -> None:
    fit = hyzer.fit("examples/ball")
    fit.save(tmp_path / "fitted")
    report = tmp_path / "fitted" / "report.json"
    options = ["--goal", "range", "--model", "ball", "--wind=-3,0,0", "--fit", str(report)]
    numbers = ["--starts", "32", "--samples", "50", "--out", str(tmp_path / "one")]
    run = program("design", *options, *numbers)
    assert run.returncode == 0, run.stderr
    of = {"wind": (-3, 0, 0), "starts": 32, "samples": 50}
    found = hyzer.design("ball", "range", fit=fit, **of)
    assert found.to_dict() == json.loads((tmp_path / "one" / "design.json").read_text())
    assert hyzer.design("ball", "range", fit=report, **of).to_dict() == found.to_dict()
    assert hyzer.design("ball", "range", starts=32, samples=50).to_dict() != found.to_dict()
    with pytest.warns(UserWarning, match="the model has no C_D0"):
        hyzer.design("ball", "range", fit=hyzer.fit("examples/disc"), starts=8, samples=2)
    with pytest.raises(hyzer.InputError, match="^wind: found"):
        hyzer.design("ball", "range", wind=(1, 2))
    with pytest.raises(hyzer.InputError, match="^fit"):
        (tmp_path / "none.json").write_text("{}")
        hyzer.design("ball", "range", fit=tmp_path / "none.json", starts=8)


def test_stability_is_that_of_the_program(tmp_path: Path) -> None:
    run = program("stability", "disc", "--times", "5", "--out", str(tmp_path / "one"))
    assert run.returncode == 0, run.stderr
    found = hyzer.stability("disc", times=5)
    assert found.to_dict() == json.loads((tmp_path / "one" / "stability.json").read_text())
    assert found.text() == run.stdout
    found.save(tmp_path / "two")
    assert (tmp_path / "two" / "map.csv").read_text() == (tmp_path / "one" / "map.csv").read_text()
    assert len(found.to_pandas()) > 0


def test_a_sweep_is_a_table(tmp_path: Path) -> None:
    plan = {**BALL, "vary": {"launch": {"values": [20.0, 30.0, 40.0]}}}
    told: list[int] = []
    swept = hyzer.sweep(plan, progress=lambda stage, done, total: told.append(total))
    frame = swept.to_pandas()
    assert list(frame["launch"]) == [20.0, 30.0, 40.0]
    assert swept.flights == 3
    on_disk = hyzer.sweep(plan, out=tmp_path / "swept", threads=1)
    assert on_disk.to_dict() == swept.to_dict()
    assert (tmp_path / "swept" / "flights.parquet").is_file()
    with pytest.raises(hyzer.InputError, match="plan:"):
        hyzer.sweep({**plan, "frob": 1})
    with pytest.raises(hyzer.FolderError):
        hyzer.sweep({**plan, "throw": {"speed": 31}}, out=tmp_path / "swept")


def test_shares_make_the_whole(tmp_path: Path) -> None:
    plan = {**BALL, "vary": {"launch": {"values": [20.0, 30.0, 40.0]}}}
    for k in (1, 2):
        assert hyzer.sweep(plan, out=tmp_path / "swept", part=(k, 2)) is None
    assert hyzer.sweep(plan, out=tmp_path / "swept").to_dict() == {
        **hyzer.sweep(plan, out=tmp_path / "whole").to_dict()
    }
    options = {"refits": 40, "threads": 1}
    for k in (2, 1):
        assert hyzer.bootstrap("examples/disc", out=tmp_path / "r", part=(k, 2), **options) is None
    joined = hyzer.bootstrap("examples/disc", out=tmp_path / "r", **options)
    whole = hyzer.bootstrap("examples/disc", **options)
    assert joined.coefficients.to_dict() == whole.coefficients.to_dict()
    assert joined.to_pandas().equals(whole.to_pandas())
    # The program goes on with the same folder.
    run = program("bootstrap", "examples/disc", "--refits", "40", "--out", str(tmp_path / "r"))
    assert run.returncode == 0, run.stderr
    for wrong in ((0, 2), (3, 2)):
        with pytest.raises(hyzer.InputError, match="part is"):
            hyzer.sweep(plan, out=tmp_path / "swept", part=wrong)
    with pytest.raises(hyzer.InputError, match="part needs out"):
        hyzer.bootstrap("examples/disc", part=(1, 2))  # type: ignore[call-overload]


@pytest.mark.parametrize(
    "code",
    [
        "hyzer.design('disc', 'range', starts=100_000, threads=2)",
        "hyzer.verify('disc', cases=100_000)",
        "hyzer.stability('disc', times=100_000)",
    ],
)
def test_cancelled_work_stops_computing(code: str) -> None:
    # The interrupt comes while the work runs; then the process is idle.
    text = f"""
import hyzer, os, resource, signal, threading, time
code = {code!r}
hyzer.Model("disc")
threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    eval(code)
    raise SystemExit("not interrupted")
except hyzer.Cancelled:
    pass
used = lambda: sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
time.sleep(1.0)
before = used()
time.sleep(1.0)
assert used() - before < 0.1, used() - before
"""
    run = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr


def test_refits_do_not_depend_on_threads(tmp_path: Path) -> None:
    one = hyzer.bootstrap("examples/disc", refits=20, threads=1)
    two = hyzer.bootstrap("examples/disc", refits=20, threads=2)
    assert one.to_dict() == two.to_dict()
    assert one.to_pandas().shape == (20, 9)
    run = program("bootstrap", "examples/disc", "--refits", "20", "--out", str(tmp_path / "out"))
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert run.returncode == 0
    assert one.coefficients.to_dict() == summary["coefficients"]
    with pytest.raises(hyzer.InputError, match="refits is 0"):
        hyzer.bootstrap("examples/disc", refits=0)


def test_verification_and_difference() -> None:
    found = hyzer.verify("ball", cases=20)
    assert found.outcome == "verified"
    assert "verified" in found.text().lower() or found.text()
    changed = hyzer.diff("disc_appendix_printed", "disc_appendix", releases=["backhand"])
    assert changed.changed is True
    assert hyzer.diff("disc", "disc").changed is False
    with pytest.raises(hyzer.InputError):
        hyzer.verify("ball", cases=0)
