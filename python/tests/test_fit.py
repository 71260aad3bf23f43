import json
import multiprocessing
import os
import pickle
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests_of_program import program

import hyzer
from hyzer import _hyzer


def without_seconds(report: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in report.items() if key != "seconds"}


@pytest.fixture(scope="module")
def fit() -> hyzer.Fit:
    return hyzer.fit(Path(__file__).parents[2] / "examples/disc")


def test_a_fit_is_that_of_the_program(fit: hyzer.Fit, tmp_path: Path) -> None:
    run = program("fit", "examples/disc", "--out", str(tmp_path / "one"))
    assert run.returncode == 0
    report = json.loads((tmp_path / "one" / "report.json").read_text())
    assert without_seconds(fit.to_dict()) == without_seconds(report)
    fit.save(tmp_path / "two")
    # The report and the page tell the time that the fit took; the manifest has hashes of both.
    timed = {"report.json", "report.html"}
    for path in (tmp_path / "one").rglob("*"):
        other = tmp_path / "two" / path.relative_to(tmp_path / "one")
        assert other.exists(), path
        if path.is_file() and path.name not in timed and not path.name.startswith("."):
            assert other.read_bytes() == path.read_bytes(), path
    assert fit.text() == run.stdout


def test_a_diagnosis_is_that_of_the_program(tmp_path: Path) -> None:
    run = program("diagnose", "examples/mystery", "--out", str(tmp_path / "one"))
    found = hyzer.diagnose("examples/mystery")
    report = json.loads((tmp_path / "one" / "report.json").read_text())
    assert found.extended_model is None
    found.save(tmp_path / "two")
    saved = json.loads((tmp_path / "two" / "report.json").read_text())
    assert without_seconds(saved) == without_seconds(report)
    names = {path.name for path in (tmp_path / "one").iterdir()}
    assert {path.name for path in (tmp_path / "two").iterdir()} == names
    assert found.text() == run.stdout
    assert found.causes == ["stall"]
    assert found.extended is not None
    assert found.extended.check()
    assert "stall" in repr(found)
    assert "misfit" in found._repr_html_()


def test_options_are_those_of_the_program(tmp_path: Path) -> None:
    options = ["--hold", "C_Nr=-3e-5", "--hold", "C_Rr", "--prior", "C_D0=0.1+-0.02"]
    options += ["--free", "wind_x", "--profile", "C_La", "--threads", "1"]
    out = str(tmp_path / "one")
    run = program("fit", "examples/disc", *options, "--out", out)
    report = json.loads((tmp_path / "one" / "report.json").read_text())
    fit = hyzer.fit(
        "examples/disc",
        fixed={"C_Nr": -3e-5, "C_Rr": None},
        priors={"C_D0": (0.1, 0.02)},
        free=["wind_x"],
        profiles=["C_La"],
        threads=2,
    )
    assert run.returncode in {0, 1}
    assert without_seconds(fit.to_dict()) == without_seconds(report)


def test_attributes_tables_and_arrays(fit: hyzer.Fit) -> None:
    frame = fit.coefficients.to_pandas()
    assert frame.loc["C_D0", "value"] == fit.coefficients.C_D0.value
    assert len(fit.flights.to_pandas()) == 8
    covariance = fit.covariance()
    errors = [fit.coefficients[name].std_error for name in fit.estimated]
    assert np.allclose(np.sqrt(np.diag(covariance)), errors)
    assert np.all(np.linalg.eigvalsh(fit.correlation()) > 0)
    assert fit.fitted.defaults["C_D0"] == fit.coefficients.C_D0.value
    with pytest.raises(AttributeError, match="found 'frob', expected one of schema"):
        _ = fit.frob
    assert "C_D0" in fit._repr_html_()
    assert "fit" in repr(fit).lower()
    assert "<html" in fit.page()
    import matplotlib as mpl

    mpl.use("Agg")
    axes = fit.plot()
    assert len(axes.patches) == 8
    assert axes.get_ylabel() == "RMS residual of the marker, mm"
    first = next(flight for flight in fit.flights if flight.outcome == "fitted")
    height = axes.patches[0].get_height()
    assert height == pytest.approx(1000 * first.residual_rms["marker"].value)
    axes.figure.canvas.draw()
    legend = axes.get_legend().get_window_extent()
    assert legend.y0 >= axes.get_window_extent().y1 - 1


def test_the_figure_of_a_diagnosis_is_of_what_its_cause_changes() -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    model = hyzer.Model("disc", ["zero-lift-drag-angle"], {"alpha_0": -0.1})
    found = hyzer.diagnose(hyzer.synthesize(model, "backhand", flights=6, duration=0.8), "disc")
    assert found.causes == ["zero-lift-drag-angle"]
    for same in (found, pickle.loads(pickle.dumps(found))):
        assert same.plot().get_ylabel() == "C_D"
    assert hyzer.diagnose("examples/mystery").plot().get_ylabel() == "C_L"


def test_what_a_report_leaves_out_is_none() -> None:
    fit = hyzer.fit("examples/disc")
    assert {flight.outcome for flight in fit.flights} <= {"fitted", "held_out"}
    assert {flight.reason for flight in fit.flights} == {None}


def test_progress_is_told_and_can_cancel() -> None:
    told: list[tuple[str, int, int]] = []
    hyzer.diagnose("examples/mystery", progress=lambda *now: told.append(now))
    assert told
    assert all(0 <= done <= total for _, done, total in told)

    def refuse(stage: str, done: int, total: int) -> None:
        raise RuntimeError(stage)

    with pytest.raises(RuntimeError):
        hyzer.diagnose("examples/mystery", progress=refuse)


def test_nothing_is_shown_where_nobody_looks(capfd: pytest.CaptureFixture[str]) -> None:
    hyzer.fit("examples/disc")
    assert capfd.readouterr() == ("", "")
    hyzer.diagnose("examples/mystery", progress=True)
    assert "]" in capfd.readouterr().err


def many(tmp: Path) -> None:
    plan = _hyzer.sweep_plan().replace("flights = ", "flights = 1000")
    hyzer.sweep(plan, out=tmp / "swept")


BALL = hyzer.Model("ball")
ROWS = np.zeros((2_000_000, len(BALL.states)))

WORK: dict[str, Callable[[Path], object]] = {
    "diagnose": lambda tmp: hyzer.diagnose("examples/mystery"),
    "bootstrap": lambda tmp: hyzer.bootstrap("examples/disc", refits=100_000),
    "sweep": many,
    "design": lambda tmp: hyzer.design("disc", "hit", target=(20, 0, 0), starts=600),
    "verify": lambda tmp: hyzer.verify("disc", cases=1000),
    "rhs": lambda tmp: BALL.rhs(0, ROWS),
    "jac": lambda tmp: BALL.jac(0, ROWS[:400_000]),
}


@pytest.mark.alone
@pytest.mark.parametrize("work", WORK)
@pytest.mark.parametrize("begin", [0.06, 0.3])
def test_ctrl_c_ends_work_within_a_fifth_of_a_second(
    work: str, begin: float, tmp_path: Path
) -> None:
    sent: list[float] = []

    def send() -> None:
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(begin, send)
    timer.start()
    with pytest.raises(KeyboardInterrupt) as raised:
        while True:
            WORK[work](tmp_path)
    seconds = time.perf_counter() - sent[0]
    timer.join()
    assert seconds < 0.2
    # Between two calls it is the interpreter that raises.
    assert work in {"diagnose", "rhs", "jac"} or isinstance(raised.value, hyzer.Cancelled)


@pytest.mark.alone
def test_the_lock_of_the_interpreter_is_free_meanwhile() -> None:
    counts = [0]
    running = True

    def count() -> None:
        while running:
            counts[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.perf_counter()
    hyzer.diagnose("examples/mystery")
    seconds = time.perf_counter() - begin
    running = False
    thread.join()
    assert counts[0] > 20 * seconds


def test_threads_that_fit_at_once_get_the_same_bits() -> None:
    results: list[dict[str, Any]] = []

    def work() -> None:
        results.append(without_seconds(hyzer.fit("examples/disc").to_dict()))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4
    assert all(result == results[0] for result in results)


def estimate(folder: str) -> float:
    return hyzer.fit(folder, threads=2).coefficients.C_D.value


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_a_forked_process_can_fit() -> None:
    folder = str(Path(__file__).parents[2] / "examples/ball")
    here = estimate(folder)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(estimate, [folder] * 3).get(timeout=60) == [here] * 3


def test_folders_that_cannot_be_written(fit: hyzer.Fit, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "mine.txt").write_text("mine")
    for folder, message in [
        (tmp_path / "file", "is a file, expected a folder"),
        (tmp_path / "own", "holds files that hyzer did not write"),
        (Path("/proc/hyzer"), "cannot be written"),
    ]:
        with pytest.raises(hyzer.FolderError, match=message) as raised:
            fit.save(folder)
        assert isinstance(raised.value, OSError)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "own"]
    assert (tmp_path / "own" / "mine.txt").read_text() == "mine"


@pytest.mark.skipif(os.geteuid() == 0, reason="root writes everywhere")
def test_a_read_only_folder_is_refused(fit: hyzer.Fit, tmp_path: Path) -> None:
    (tmp_path / "locked").mkdir(mode=0o500)
    with pytest.raises(hyzer.FolderError):
        fit.save(tmp_path / "locked" / "out")


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"fixed": ["C_X"]}, hyzer.InputError, "to be held is C_X"),
        ({"priors": {"C_D0": (0.1, -1.0)}}, hyzer.InputError, "standard deviation"),
        ({"threads": 0}, hyzer.InputError, "threads"),
        ({"max_seconds": -1.0}, hyzer.InputError, "max_seconds is -1"),
        ({"model": "ball"}, hyzer.Error, None),
        ({"model": "dsic"}, hyzer.ModelError, "did you mean"),
    ],
)
def test_wrong_options_are_refused(
    options: dict[str, Any], error: type[Exception], message: str | None
) -> None:
    with pytest.raises(error, match=message):
        hyzer.fit("examples/disc", **options)


def test_a_dataset_without_flights_to_fit_is_a_fit_error() -> None:
    frames = hyzer.Dataset.read("examples/ball").to_pandas()
    markers = hyzer.Dataset.read("examples/ball").markers
    data = hyzer.Dataset.from_pandas(frames, markers=markers, model="ball", held_out=list(frames))
    with pytest.raises(hyzer.FitError, match="every flight is held out"):
        hyzer.fit(data)
    with pytest.raises(hyzer.InputError, match="frob"):
        hyzer.diagnose("examples/disc", without=["frob"])


def test_constants_that_cannot_be_told_apart_and_a_noise_in_another_unit_are_cautions() -> None:
    both = hyzer.fit("examples/ball", free="m")
    assert not both.reliable
    assert "do not determine C_D and m apart from one another" in " ".join(both.cautions)
    frames = hyzer.Dataset.read("examples/ball").to_pandas()
    about: dict[str, Any] = {"markers": {"centre": (0, 0, 0)}, "model": "ball"}
    for sigma, is_right in ((1e-4, False), (2e-3, True), (1.0, False)):
        fit = hyzer.fit(hyzer.Dataset.from_pandas(frames, sigma=sigma, **about))
        assert ("correct `sigma`" in " ".join(fit.cautions)) is not is_right, fit.cautions


def test_residuals_are_measured_minus_predicted() -> None:
    fit = hyzer.fit("examples/ball")
    left = fit.residuals()
    assert set(left.marker) == {"centre"}
    used = left[~left.outlier & left.file.isin(f.file for f in fit.flights if f.role == "fit")]
    rms = float(np.sqrt((used[["x_m", "y_m", "z_m"]] ** 2).to_numpy().mean()))
    assert abs(rms / fit.residual_rms.marker.value - 1) < 0.02
