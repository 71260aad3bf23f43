"""Arguments as NumPy and pandas state them: names, masks, labels, times."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from tests_of_program import program

import hyzer

DISC = hyzer.Model("disc")
FRAMES = hyzer.Dataset.read(Path(__file__).parents[2] / "examples/ball").to_pandas()
BALL: dict[str, Any] = {"markers": {"centre": (0, 0, 0)}, "model": "ball"}
PLAN = {"until": "ground", "throw": {"speed": 30}, "vary": {"launch": {"values": [20.0, 30.0]}}}


def balls(frames: Any = FRAMES, **options: Any) -> hyzer.Dataset:
    return hyzer.Dataset.from_pandas(frames, **{**BALL, **options})


def held_out(data: hyzer.Dataset) -> list[int]:
    text = data.native.texts()[0]
    roles = [line for line in text.splitlines() if line.startswith("role")]
    return [number for number, role in enumerate(roles) if "held-out" in role]


def test_labels_of_series_and_frames_are_names() -> None:
    flight = DISC.fly("backhand").to_pandas()
    x = flight.iloc[10]
    base = DISC.rhs(0, x.to_numpy())
    assert np.array_equal(DISC.rhs(0, x.sort_index()), base)
    assert np.array_equal(DISC.rhs(0, pd.Series(x.to_numpy())), base)
    frame = flight.iloc[:40]
    turned = frame[frame.columns[::-1]]
    assert np.array_equal(DISC.rhs(0, turned), DISC.rhs(0, frame.to_numpy()))
    for whole, other in zip(DISC.jac(0, turned), DISC.jac(0, frame.to_numpy())):
        assert np.array_equal(whole, other)
    p = pd.Series({name: DISC.defaults[name] for name in sorted(DISC.parameters)})
    assert np.array_equal(DISC.rhs(0, x, p), base)
    assert np.array_equal(DISC.rhs(0, x, p[["m"]]), base)
    assert np.array_equal(DISC.rhs(0, x, pd.Series(DISC.parameter_vector())), base)
    marker = pd.Series({"z": 0.02, "x": 0.1, "y": 0.0})
    assert np.array_equal(DISC.observe(0, x, marker), DISC.observe(0, x, [0.1, 0, 0.02]))
    with pytest.raises(hyzer.InputError, match="x has the labels a, y, .*, expected x, y, z"):
        DISC.rhs(0, x.rename({"x": "a"}))
    with pytest.raises(hyzer.InputError, match="x has the labels"):
        DISC.rhs(0, x.drop("x"))
    with pytest.raises(hyzer.InputError, match='no parameter "C_DO"'):
        DISC.rhs(0, x, pd.Series({"C_DO": 0.1}))
    with pytest.raises(hyzer.InputError, match="x has the labels"):
        DISC.rhs(0, pd.Series(x.to_numpy(), index=np.linspace(0, 1, 12)))


def test_states_by_name_go_by_their_keys() -> None:
    x = DISC.fly("backhand").to_pandas().iloc[10]
    base = DISC.rhs(0, x.to_numpy())
    assert np.array_equal(DISC.rhs(0, dict(x[::-1])), base)
    several = {**x, "u": np.array([x["u"], x["u"] + 1])}
    assert np.array_equal(DISC.rhs(0, several)[0], base)
    with pytest.raises(hyzer.InputError, match="x has the names x, y, expected x, y, z"):
        DISC.rhs(0, {"x": 0.0, "y": 1.0})


def test_coordinates_and_lists_of_series_are_names() -> None:
    x = DISC.fly("backhand").to_pandas().iloc[10]
    base = DISC.rhs(0, x.to_numpy())
    coords = {"state": list(DISC.states)}
    array = xr.DataArray([x.to_numpy()], dims=("time", "state"), coords=coords)
    assert np.array_equal(DISC.rhs(0, array.isel(state=slice(None, None, -1)))[0], base)
    assert np.array_equal(DISC.rhs(0, [x.sort_index(), x])[0], base)
    p = xr.DataArray([0.2, 0.1], dims="p", coords={"p": ["m", "C_D0"]})
    assert np.array_equal(DISC.rhs(0, x, p), DISC.rhs(0, x, {"m": 0.2, "C_D0": 0.1}))


def test_columns_of_frames_among_arrays_are_names() -> None:
    frame = FRAMES["flight01.csv"]
    xyz = ["centre_x", "centre_y", "centre_z"]

    def tables(columns: pd.DataFrame) -> pd.DataFrame:
        data = hyzer.Dataset.from_arrays([{"t": frame.t, "centre": columns}], **BALL)
        return data.to_pandas()["flight01.csv"]

    expected = tables(frame[xyz])
    assert tables(frame[xyz[::-1]]).equals(expected)
    assert tables(frame[xyz[::-1]].set_axis(["z", "y", "x"], axis=1)).equals(expected)
    with pytest.raises(hyzer.InputError, match="centre has the labels a, b, c"):
        tables(frame[xyz].set_axis(["a", "b", "c"], axis=1))


@pytest.mark.parametrize("dtype", ["Float64", "float64[pyarrow]"])
def test_what_pandas_has_as_missing_is_missing(dtype: str) -> None:
    frame = next(iter(FRAMES.values()))
    nullable = frame.astype(dict.fromkeys(frame.columns, dtype))
    nullable.iloc[10:20, 1] = pd.NA
    expected = balls(frame.where(nullable.notna())).native.texts()
    assert balls(nullable).native.texts() == expected
    centre = nullable[["centre_x", "centre_y", "centre_z"]]
    data = hyzer.Dataset.from_arrays({"flight01.csv": {"t": nullable.t, "centre": centre}}, **BALL)
    found = data.to_pandas()["flight01.csv"].centre_x.isna()
    assert found.tolist() == nullable.centre_x.isna().tolist()


def test_a_view_has_a_height_in_pixels() -> None:
    flight = DISC.fly("backhand")
    assert "height:300px" in flight.view(np.int64(300))._repr_html_()
    for height in ("a", 0, 2.5, True):
        with pytest.raises(hyzer.InputError, match="height: found"):
            flight.view(height)  # type: ignore[arg-type]


def test_what_is_masked_is_missing() -> None:
    frame = FRAMES["flight01.csv"]
    xyz = frame[["centre_x", "centre_y", "centre_z"]].to_numpy()
    masked = np.ma.masked_array(xyz.copy(), mask=np.zeros_like(xyz, bool))
    masked[10:20] = np.ma.masked
    masked.data[10:20] = 999
    data = hyzer.Dataset.from_arrays({"one": {"t": frame.t, "centre": masked}}, **BALL)
    seen = data.to_pandas()["one"].centre_x
    assert seen[10:20].isna().all()
    assert seen[9] == xyz[9, 0]
    with pytest.raises(hyzer.InputError, match="x.0. .x. is NaN"):
        DISC.rhs(0, np.ma.masked_array(np.zeros(12), mask=[True] + 11 * [False]))


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ([False] * 6 + [False, True], [7]),
        (np.arange(8) > 5, [6, 7]),
        (pd.Series(np.arange(8) > 5), [6, 7]),
        (pd.Series([True, False], index=["flight03.csv", "flight02.csv"]), [2]),
        ([np.int64(7)], [7]),
        (np.array([6, 7]), [6, 7]),
        (pd.Index([6, 7]), [6, 7]),
        ("flight08.csv", [7]),
        (np.array(["flight01.csv"]), [0]),
        (7, [7]),
        ((), []),
        (None, []),
    ],
)
def test_flights_are_held_out_by_name_number_or_mask(given: Any, expected: list[int]) -> None:
    assert held_out(balls(held_out=given)) == expected
    takes = [f"examples/ball/flight0{k}.csv" for k in range(1, 9)]
    about = {"model": "ball", "length": "m", "time": "s", "up": "+z"}
    if expected:
        made = hyzer.Dataset.import_takes(takes, held_out=given, **about)
        assert held_out(made) == expected


def test_a_mask_of_another_length_is_refused() -> None:
    with pytest.raises(hyzer.InputError, match="held_out: found a mask of 3, expected .* 8"):
        balls(held_out=[True, False, True])
    with pytest.raises(hyzer.InputError, match="held_out: found the flight 99"):
        balls(held_out=np.array([99]))


def test_keys_of_groups_are_names_of_flights() -> None:
    long = pd.concat([frame.assign(throw=10 * k) for k, frame in enumerate(FRAMES.values(), 1)])
    groups = {key: group.drop(columns="throw") for key, group in long.groupby("throw")}
    data = balls(groups, held_out=[20], known={np.int64(10): {"omega": [0, 0, 0]}})
    assert data.files[:2] == ("10.csv", "20.csv")
    assert held_out(data) == [1]
    with pytest.raises(hyzer.InputError, match="found the flight 1, expected one of 10, 20"):
        balls(groups, held_out=[1])
    several = {("a", 1): FRAMES["flight01.csv"], ("a", 2): FRAMES["flight02.csv"]}
    assert balls(several, held_out=[("a", 2)]).files == ("a_1.csv", "a_2.csv")
    with pytest.raises(hyzer.InputError, match="flights of the same name"):
        balls({1: FRAMES["flight01.csv"], "1.csv": FRAMES["flight02.csv"]})


def test_one_table_is_one_flight() -> None:
    frame = FRAMES["flight01.csv"]
    assert balls(frame).files == ("flight01.csv",)
    xyz = frame[["centre_x", "centre_y", "centre_z"]]
    assert len(hyzer.Dataset.from_arrays({"t": frame.t, "centre": xyz}, **BALL)) == 1
    with pytest.raises(hyzer.InputError, match="found a str, expected a DataFrame"):
        balls(["a"])


def test_times_may_be_differences_or_dates() -> None:
    frame = FRAMES["flight01.csv"]
    passed = pd.to_timedelta(frame.t, unit="s")
    expected = passed.dt.total_seconds().tolist()
    began = pd.Timestamp("2024-05-01 10:00")
    xyz = frame[["centre_x", "centre_y", "centre_z"]].to_numpy()
    for times in (passed, began + passed, began.tz_localize("Europe/Zurich") + passed):
        seen = balls([frame.assign(t=times)]).to_pandas()["flight01.csv"]
        assert np.allclose(seen.t, expected, atol=1e-12)
        assert list(seen.columns) == list(frame.columns)
        indexed = balls([frame.assign(t=times).set_index("t")])
        assert np.allclose(indexed.to_pandas()["flight01.csv"].t, expected, atol=1e-12)
        for given in (times.to_numpy(), list(times)):
            of = hyzer.Dataset.from_arrays([{"t": given, "centre": xyz}], **BALL)
            assert np.allclose(of.to_pandas()["flight01.csv"].t, expected, atol=1e-6)
    force = pd.Series([0.7, 0.8], index=pd.to_timedelta([0, 2], unit="s"))
    same = pd.Series([0.7, 0.8], index=[0.0, 2.0])
    quadrotor = hyzer.Model("quadrotor")
    ends = [
        quadrotor.fly(hyzer.Release(speed=1, inputs={"motor_1": given}, until=1.0)).states[-1]
        for given in (force, same, ([0, 2], np.array([0.7, 0.8])))
    ]
    assert np.array_equal(ends[0], ends[1])
    assert np.array_equal(ends[0], ends[2])
    with pytest.raises(hyzer.InputError, match="inputs: a has 4 parts"):
        hyzer.Release(speed=1, inputs={"a": np.zeros((4, 2))})


def test_dates_of_inputs_count_from_those_of_their_flight(tmp_path: Path) -> None:
    t = np.arange(0, 1, 0.02)
    began = pd.Timestamp("2024-05-01 10:00")
    seen = pd.DataFrame({"t": began + pd.to_timedelta(t, unit="s"), "rotor_x": t})
    seen = seen.assign(rotor_y=0.0, rotor_z=1.0)
    earlier = began - pd.Timedelta(0.5, unit="s")
    force = pd.DataFrame({"t": [earlier, began + pd.Timedelta(2, unit="s")], "motor_1": [0.7, 0.8]})
    about: dict[str, Any] = {"markers": {"rotor": (0.1, 0, 0)}, "model": "quadrotor"}

    def rows(flight: pd.DataFrame, inputs: pd.DataFrame) -> str:
        data = hyzer.Dataset.from_pandas({"a.csv": flight}, inputs={"a.csv": inputs}, **about)
        data.save(tmp_path / "flights")
        return (tmp_path / "flights/a-inputs.csv").read_text()

    assert "\n-0.5,0.7\n" in rows(seen, force)
    for flight, inputs in ((seen.assign(t=t), force), (seen, force.assign(t=[0.0, 2.0]))):
        with pytest.raises(hyzer.InputError, match="inputs01.csv: its times are .* of one clock"):
            rows(flight, inputs)
    with pytest.raises(hyzer.InputError, match="its times are dates; recording states a unit"):
        balls([FRAMES["flight01.csv"].assign(t=seen.t.iloc[0])], recording={"time": "ms"})


def test_masks_with_the_keys_of_the_flights_go_by_them() -> None:
    flights = dict(zip([8, 7, 6, 5, 4, 3, 2, 1], FRAMES.values()))
    mask = pd.Series({k: k == 1 for k in range(1, 9)})
    assert held_out(balls(flights, held_out=mask)) == [7]
    assert held_out(balls(flights, held_out=dict(mask))) == [7]
    assert held_out(balls(flights, held_out=mask.to_list())) == [0]
    with pytest.raises(hyzer.InputError, match="held_out: found a mapping of 'yes'"):
        balls(flights, held_out={1: "yes"})


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: hyzer.Dataset.from_pandas(None, **BALL), "flights: found None"),
        (lambda: hyzer.synthesize("disc", None), "releases: found None"),
        (lambda: balls(parameters={"m": None}), "m: found None, expected a number"),
        (lambda: hyzer.Release(speed=1 + 2j).to_toml("disc"), r"speed: found \(1\+2j\)"),
        (lambda: hyzer.Release({"x": 1.0}, speed=20), "found states and speed"),
        (lambda: hyzer.fit("examples/ball", priors={"C_D": 0.3}), "priors: found 0.3 for C_D"),
        (lambda: hyzer.fit("examples/ball", threads=-1), "threads is -1"),
        (lambda: hyzer.bootstrap("examples/ball", refits=-1), "refits is -1"),
        (lambda: hyzer.design("ball", "hit", target="3,0,0"), "target is '3,0,0'"),
        (lambda: hyzer.Model("ball", parameters={"C_D": 7}), "C_D is 7, expected"),
        (
            lambda: hyzer.Dataset.import_takes("a", model="disc", parameters={"mass": 0.2}),
            'no parameter "mass"',
        ),
        (
            lambda: hyzer.Dataset.from_arrays(
                {"t": [0, 1], "g": np.zeros((2, 3))}, sensors={"g": {"kind": "gyro"}}
            ),
            "the kind 'gyro' of 'g', expected one of pose, gyroscope",
        ),
    ],
)
def test_what_is_no_value_is_named(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(hyzer.InputError, match=message):
        call()


@pytest.mark.parametrize(
    ("one", "several"),
    [
        (
            lambda: hyzer.Model("disc", effects="wind"),
            lambda: hyzer.Model("disc", effects=["wind"]),
        ),
        (lambda: balls(unknown="omega"), lambda: balls(unknown=["omega"])),
        (lambda: balls(unknown={0: "omega"}), lambda: balls(unknown={0: ["omega"]})),
    ],
)
def test_a_string_is_one_name(one: Callable[[], Any], several: Callable[[], Any]) -> None:
    def text(made: Any) -> Any:
        return made.text if isinstance(made, hyzer.Model) else made.native.texts()

    assert text(one()) == text(several())


def test_a_string_is_one_name_of_options() -> None:
    for name in ("free", "profiles"):
        with pytest.raises(hyzer.InputError, match='"nothing"|nothing'):
            hyzer.fit("examples/ball", **{name: "nothing"})
    with pytest.raises(hyzer.InputError, match="nothing"):
        hyzer.diagnose("examples/ball", without="nothing")
    with pytest.raises(hyzer.InputError, match="nothing.csv"):
        hyzer.Dataset.import_takes("nothing.csv", model="ball", up="+z")
    changed = hyzer.diff("disc", "disc", releases="backhand")
    assert [landing["release"] for landing in changed["landings"]] == ["backhand"]


def test_series_are_mappings() -> None:
    m = pd.Series({"m": 0.18})
    assert hyzer.Model("disc", parameters=m).defaults["m"] == 0.18
    assert balls(parameters=m).parameters == {"m": 0.18}
    fixed = hyzer.fit("examples/ball", fixed=pd.Series({"C_D": 0.45}))
    assert fixed.coefficients.C_D.value == 0.45
    with pytest.raises(hyzer.InputError, match="parameters: found 3, expected a mapping"):
        hyzer.Model("disc", parameters=3)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: hyzer.fit("examples/ball", threads=-1), "^threads is -1: "),
        (lambda: hyzer.fit("examples/ball", threads=1.5), "^threads is 1.5: "),
        (lambda: hyzer.fit("examples/ball", fixed={"C_D": "a"}), "^fixed is .*'C_D'"),
        (lambda: hyzer.design("ball", "hit", target=(4, 1)), "^target is .4.0, 1.0.: "),
        (lambda: hyzer.design("ball", "hit", target=(4, 1, np.nan)), "the target is .4, 1, NaN"),
        (lambda: hyzer.design("disc", "flare", target=(np.nan, 0, 2)), "the target is .NaN, 0, 2"),
        (lambda: hyzer.design("ball", "range", fit="nope.json"), "^fit: nope.json: No such"),
        (lambda: hyzer.design("ball", "range", bounds="nope.toml"), "^bounds: nope.toml: No such"),
        (lambda: hyzer.sweep("backhand"), "^plan: found no file 'backhand', .* backhands"),
        (lambda: hyzer.synthesize("ball", "serve", noise_sigma=-1), "^noise_sigma: found -1"),
        (lambda: hyzer.synthesize("ball", "serve", held_out=100), "^held_out: found 100"),
        (lambda: hyzer.synthesize("ball", "serve", flights=-1), "^flights is -1: "),
        (lambda: hyzer.Dataset.import_takes([]), "^takes: found none, expected"),
        (lambda: DISC.fly("backhand", C_D0=np.nan), "C_D0 is nan, expected a finite"),
        (lambda: DISC.fly("backhand", C_D0="a"), "C_D0 is 'a', expected a number"),
        (lambda: DISC.fly("backhand", wind_X=1), "wind_x|expected one of m"),
        (lambda: DISC.fly(3), "release: found a int, expected a name"),
        (lambda: DISC.rhs(0, [0] * 12, {"m": 0}), "m is 0, expected a number above 0"),
        (lambda: DISC.rhs(0, [0] * 12, 0 * DISC.parameter_vector()), "m is 0, expected"),
        (lambda: hyzer.diff("ball", "disc", releases=["b"]), "^b: No such file"),
        (
            lambda: hyzer.Dataset.import_takes(
                ["examples/ball/flight01.csv"], model="ball", parameters={"m": np.nan}
            ),
            "parameters: m is nan, expected a finite number",
        ),
    ],
)
def test_a_wrong_argument_is_named(call: Callable[[], object], message: str) -> None:
    with pytest.raises(hyzer.InputError, match=message) as raised:
        call()
    for word in ("failed to extract", "--", "Usage", "Options", "noise-sigma", "held-out:"):
        assert word not in str(raised.value)


def test_components_of_inputs_are_among_the_expected_names() -> None:
    with pytest.raises(hyzer.InputError, match="wind_x, wind_y, wind_z"):
        hyzer.Model("disc").fly("backhand", nothing_at_all=1)


def test_a_model_without_attitude_is_told_by_its_name() -> None:
    with pytest.raises(hyzer.Error, match="^the model ball has no body that turns") as raised:
        hyzer.stability("ball")
    assert "release" not in str(raised.value)


def test_cautions_name_keyword_arguments(tmp_path: Path) -> None:
    fit = hyzer.fit("examples/mystery", priors={"C_D0": (1e-3, 1e-6)})
    text = fit.text() + "".join([*fit.cautions, *fit.notes]) + str(fit.to_dict())
    for option in ("--unbounded", "--label", "--out", "--up"):
        assert option not in text


def test_labels_stand_as_in_the_file(tmp_path: Path) -> None:
    frame = hyzer.Dataset.read("examples/disc").to_pandas()["flight01.csv"]
    values = (1000 * frame.drop(columns="t")).round(3)
    values.insert(0, "frame", range(1, len(frame) + 1))
    values.insert(1, "sub", 0)
    lines = ["Trajectories", "120", ",,Disc:a,,,Disc:b,,,Disc:c,,"]
    lines += ["Frame,Sub Frame," + ",".join(["X,Y,Z"] * 3), ",," + ",".join(["mm"] * 9)]
    take = tmp_path / "take.csv"
    take.write_text("\n".join(lines) + "\n" + values.to_csv(index=False, header=False))
    about = {"up": "+z", "markers": "examples/disc/dataset.toml"}
    texts = []
    for subject in ("Disc:", ""):
        labels = {f"{subject}{label}": f"m{k}" for k, label in enumerate("abc", 1)}
        texts.append(hyzer.Dataset.import_takes([take], labels=labels, **about).native.texts())
    assert texts[0] == texts[1]
    with pytest.raises(hyzer.InputError, match="labels=") as raised:
        hyzer.Dataset.import_takes([take], labels={"x": "m1"}, **about)
    assert "--" not in str(raised.value)


def test_more_threads_than_can_help_are_not_started() -> None:
    one = hyzer.fit("examples/ball", threads=1)
    assert hyzer.fit("examples/ball", threads=100_000).to_dict()["flights"] == one["flights"]


def test_a_value_of_the_model_that_does_not_count_is_told(tmp_path: Path) -> None:
    heavy = hyzer.Model("disc", parameters={"m": 0.35})
    told = "the dataset states m = 0.175, which counts, and not 0.35 of the model"
    for model in (heavy, hyzer.Model(heavy.text)):
        fit = hyzer.fit("examples/disc", model)
        assert any(note.startswith(told) for note in fit.notes)
        assert told in fit.text()
    assert not any("which counts" in note for note in hyzer.fit("examples/disc").notes)
    with pytest.warns(UserWarning, match="the release states m = 0.175, which counts"):
        heavy.fly("backhand", until=0.1)
    with pytest.warns(UserWarning, match=told):
        hyzer.bootstrap("examples/disc", heavy, refits=2)
    (tmp_path / "heavy.hyz").write_text(heavy.text)
    run = program("simulate", str(tmp_path / "heavy.hyz"), "--release", "backhand")
    assert "note: the release states m = 0.175, which counts" in run.stderr
    run = program("fit", "examples/disc", "--model", str(tmp_path / "heavy.hyz"))
    assert told in run.stdout


@pytest.mark.filterwarnings("error")
def test_a_value_that_counts_is_not_told() -> None:
    heavy = hyzer.Model("disc", parameters={"m": 0.35})
    heavy.fly("backhand", until=0.1, m=0.3)
    heavy.fly(hyzer.Release(speed=10, spin=500, until=0.1))
    hyzer.Model("disc").fly("backhand", until=0.1)


def test_a_sweep_of_a_model(tmp_path: Path) -> None:
    heavy = hyzer.Model("ball", parameters={"m": 0.5})
    (tmp_path / "heavy.hyz").write_text(heavy.text)
    of_file = hyzer.sweep({**PLAN, "model": tmp_path / "heavy.hyz"}).to_pandas()
    for model in (heavy, str(tmp_path / "heavy.hyz")):
        assert hyzer.sweep({**PLAN, "model": model}).to_pandas().equals(of_file)
    assert not hyzer.sweep({**PLAN, "model": "ball"}).to_pandas().equals(of_file)
    disc = {**PLAN, "throw": {"speed": 15, "spin": 500}}
    effects = ["zero-lift-drag-angle"]
    named = hyzer.sweep({**disc, "model": "disc", "effects": effects}).to_pandas()
    made = hyzer.sweep({**disc, "model": DISC, "effects": effects}).to_pandas()
    assert made.equals(named)
    # Work in a folder goes on, wherever the text of the model was.
    out = tmp_path / "swept"
    assert hyzer.sweep({**PLAN, "model": heavy}, out=out, part=(1, 2)) is None
    assert hyzer.sweep({**PLAN, "model": heavy}, out=out).flights == 2
