"""Results as objects of Python: copies, tables, what a notebook shows."""

import copy
import os
import pickle
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hyzer

PLAN = {"model": "ball", "until": "ground", "throw": {"speed": 30}}
PLAN |= {"vary": {"launch": {"values": [20.0, 30.0]}}}


def copies(value: Any) -> list[Any]:
    return [pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)]


def test_models_are_copied(tmp_path: Path) -> None:
    (tmp_path / "own.hyz").write_text(hyzer.Model("ball").text)
    disc = hyzer.Model("disc", effects=["wind"], parameters={"m": 0.18})
    own = hyzer.Model(tmp_path / "own.hyz", parameters={"m": 0.3})
    text = hyzer.Model(hyzer.Model("disc").text)
    made = [pickle.dumps(model) for model in (disc, own, text)]
    (tmp_path / "own.hyz").unlink()
    for model, data in zip((disc, own, text), made):
        for same in [pickle.loads(data), copy.copy(model), copy.deepcopy(model)]:
            assert type(same) is hyzer.Model
            assert (same.text, same.defaults, same.effects) == (
                model.text,
                model.defaults,
                model.effects,
            )
            x = np.linspace(0.1, 1.0, len(model.states))
            assert np.array_equal(same.rhs(0, x), model.rhs(0, x))


def test_datasets_are_copied() -> None:
    for data in (hyzer.Dataset.read("examples/disc"), hyzer.synthesize("ball", "serve", flights=3)):
        for same in copies(data):
            assert same.native.texts() == data.native.texts()
            assert (same.name, same.decisions) == (data.name, data.decisions)
    fit = hyzer.fit("examples/ball")
    assert hyzer.fit(copy.copy(hyzer.Dataset.read("examples/ball"))).flights == fit.flights


def test_a_dataset_keeps_what_is_written_beside_it(tmp_path: Path) -> None:
    data = hyzer.synthesize(hyzer.Model("ball", parameters={"m": 0.5}), "serve", flights=2)
    copy.deepcopy(data).save(tmp_path / "copy")
    data.save(tmp_path / "made")
    names = {path.name for path in (tmp_path / "made").iterdir()}
    assert {path.name for path in (tmp_path / "copy").iterdir()} == names
    assert "ball.hyz" in names


def test_flights_and_releases_are_copied() -> None:
    throw = hyzer.Release(speed=20, spin=700, wind=(1, 0, 0))
    flight = hyzer.Model("disc", effects=["wind"]).fly(throw, rate=60, C_D0=0.2)
    for same in copies(flight):
        assert np.array_equal(same.states, flight.states)
        assert same.summary == flight.summary
    for same in copies(throw):
        assert same.to_toml("disc") == throw.to_toml("disc")


def test_results_are_copied(tmp_path: Path) -> None:
    results: list[Any] = [
        hyzer.fit("examples/ball"),
        hyzer.diagnose("examples/mystery", without=["wind_of_each_flight"]),
        hyzer.design("ball", "range", starts=16, samples=10),
        hyzer.stability("disc", times=3),
        hyzer.bootstrap("examples/ball", refits=3),
        hyzer.verify("ball", cases=5),
        hyzer.diff("ball", "ball"),
    ]
    for number, result in enumerate(results):
        for same in copies(result)[:2]:
            assert type(same) is type(result)
            assert same.to_dict() == result.to_dict()
            assert (same.text(), repr(same)) == (result.text(), repr(result))
            if hasattr(result, "page"):
                assert same.page() == result.page()
            if hasattr(result, "to_pandas"):
                assert same.to_pandas().equals(result.to_pandas())
        result.save(tmp_path / f"{number}a")
        copy.copy(result).save(tmp_path / f"{number}b")
        first, second = [
            {str(p.relative_to(root)): p.read_bytes() for p in root.rglob("*") if p.is_file()}
            for root in (tmp_path / f"{number}a", tmp_path / f"{number}b")
        ]
        assert first == second
    assert copy.copy(results[0]).fitted.text == results[0].fitted.text
    assert copy.copy(results[1]).extended.text == results[1].extended.text
    assert copy.copy(results[2]).release.to_toml("ball") == results[2].release.to_toml("ball")
    for same in copies(hyzer.sweep(PLAN)):
        assert same.to_pandas().equals(hyzer.sweep(PLAN).to_pandas())


def test_pages_are_there_or_not_a_method() -> None:
    for result in (hyzer.verify("ball", cases=5), hyzer.diff("ball", "ball")):
        assert not hasattr(result, "page")
    assert not hasattr(hyzer.Bootstrap, "page")
    fit = hyzer.fit("examples/disc")
    for page in (fit.page(), hyzer.design("ball", "range", starts=16, samples=10).page()):
        assert page.startswith("<!DOCTYPE html>")
        ids = re.findall(r' id="?([^" >]+)', page)
        assert len(ids) == len(set(ids)), sorted(one for one in ids if ids.count(one) > 1)


def test_a_sweep_is_read_after_a_change_of_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    swept = hyzer.sweep(PLAN, out="swept")
    os.chdir("/")
    assert (swept.folder / "flights.parquet").is_file()
    pytest.importorskip("pyarrow")
    frame = swept.to_pandas()
    in_memory = hyzer.sweep(PLAN).to_pandas()
    assert frame.equals(in_memory)
    assert (frame.dtypes == in_memory.dtypes).all()


def test_numbers_of_a_table_are_floats() -> None:
    kinds = hyzer.sweep(PLAN).to_pandas().dtypes
    for name in ("steps", "landing_y", "launch"):
        assert kinds[name].kind == "f"
    assert kinds["flight"].kind == "i"


def test_a_slice_of_rows_is_rows() -> None:
    flights = hyzer.fit("examples/ball").flights
    assert len(flights[:2].to_pandas()) == 2
    assert flights[-1].file == "flight08.csv"
    assert flights[::-1][0].file == "flight08.csv"


def test_a_dict_of_a_result_is_a_copy() -> None:
    fit = hyzer.fit("examples/ball")
    fit.to_dict()["coefficients"]["C_D"]["value"] = 9.0
    fit.coefficients.to_dict()["C_D"]["value"] = 9.0
    assert fit.coefficients.C_D.value < 1.0


def test_objects_show_what_was_replaced() -> None:
    assert repr(hyzer.Model("disc", parameters={"m": 0.18})) == (
        'Model("disc", parameters={"m": 0.18})'
    )
    throw = hyzer.Release(speed=20, wind=(1, 0, 0), until=2.0, parameters={"m": 0.2})
    for word in ("speed=20", "wind=", "(1, 0, 0)", "until=2.0", "parameters={'m': 0.2}"):
        assert word in repr(throw)


def test_a_notebook_shows_tables() -> None:
    results: list[tuple[Any, str]] = [
        (hyzer.design("ball", "range", starts=16, samples=0), "launch"),
        (hyzer.stability("disc", times=3), "speed_m_s"),
        (hyzer.bootstrap("examples/ball", refits=3), "C_D"),
        (hyzer.sweep(PLAN), "landing_x"),
        (hyzer.verify("ball", cases=5), "verdict"),
    ]
    for result, word in results:
        shown = result._repr_html_()
        assert "<table>" in shown
        assert word in shown
