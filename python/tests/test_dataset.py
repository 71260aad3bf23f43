import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import hyzer

DISC = hyzer.Dataset.read(Path(__file__).parents[2] / "examples/disc")


def made(**options: object) -> hyzer.Dataset:
    about = {"markers": DISC.markers, "parameters": DISC.parameters, **options}
    return hyzer.Dataset.from_pandas(DISC.to_pandas(), **about)


def test_a_dataset_in_memory_is_fitted_as_its_files() -> None:
    fit = hyzer.fit(made(held_out=["flight07.csv", 7]))
    same = hyzer.fit(DISC)
    assert fit.coefficients.to_dict() == same.coefficients.to_dict()
    assert fit.to_dict()["flights"] == same.to_dict()["flights"]


def test_arrays_are_tables() -> None:
    flights = {}
    for name, frame in DISC.to_pandas().items():
        columns = {m: frame[[f"{m}_{axis}" for axis in "xyz"]].to_numpy() for m in DISC.markers}
        flights[name] = {"t": frame["t"].to_numpy(), **columns}
    about = {"markers": DISC.markers, "parameters": DISC.parameters}
    data = hyzer.Dataset.from_arrays(flights, held_out=[6, 7], **about)
    assert hyzer.fit(data).coefficients.to_dict() == hyzer.fit(DISC).coefficients.to_dict()


def test_units_and_axes_of_a_recording() -> None:
    frames = {name: frame.set_index("t") * 1000 for name, frame in DISC.to_pandas().items()}
    options = {"markers": DISC.markers, "parameters": DISC.parameters, "held_out": [6, 7]}
    data = hyzer.Dataset.from_pandas(frames, recording={"length": "mm"}, **options)
    value = hyzer.fit(data).coefficients.C_D0.value
    assert np.isclose(value, hyzer.fit(DISC).coefficients.C_D0.value, rtol=1e-6)


def test_sensors_are_measured() -> None:
    t = np.arange(61) / 120
    flight = hyzer.Model("disc").fly("backhand", until=0.5)
    seen = {"t": t, "m1": flight.markers([0.1, 0, 0])}
    rates = np.zeros((61, 3))
    options = {"sensors": {"gyro": {"kind": "gyroscope", "position": [0, 0, 0], "sigma": 0.1}}}
    data = hyzer.Dataset.from_arrays(
        [{**seen, "gyro": rates}], markers={"m1": (0.1, 0, 0)}, **options
    )
    assert "gyro_x" in data.to_pandas()["flight01.csv"]


def test_a_dataset_is_written_and_read_back(tmp_path: Path) -> None:
    made().save(tmp_path / "made")
    again = hyzer.Dataset.read(tmp_path / "made")
    assert again.files == DISC.files
    for name, frame in again.to_pandas().items():
        pd.testing.assert_frame_equal(frame, DISC.to_pandas()[name])
    made().save(tmp_path / "made")
    with pytest.raises(hyzer.FolderError, match="something else"):
        made(sigma=0.001).save(tmp_path / "made")


def test_simulated_flights_are_fitted(tmp_path: Path) -> None:
    odd = hyzer.Model("disc", effects=["zero-lift-drag-angle"], parameters={"alpha_0": -0.07})
    data = hyzer.synthesize(odd, "backhand", flights=4, duration=0.6, seed=3)
    assert hyzer.fit(data, "disc").coefficients.C_D0.value > 0
    data.save(tmp_path / "made")
    assert (tmp_path / "made" / "truth.toml").is_file()
    assert hyzer.fit(tmp_path / "made").model == "disc"
    with pytest.raises(hyzer.Error, match="rate"):
        hyzer.synthesize("disc", "backhand", rate=-1)


def test_takes_are_imported_as_by_the_program(tmp_path: Path) -> None:
    takes = ["examples/disc/flight01.csv", "examples/disc/flight02.csv"]
    options = {"length": "m", "time": "s", "up": "+z", "markers": "examples/disc/dataset.toml"}
    data = hyzer.Dataset.import_takes(takes, **options)
    assert len(data) == 2
    data.save(tmp_path / "imported")
    assert (tmp_path / "imported" / "import.html").is_file()
    with pytest.raises(hyzer.InputError, match="up: found") as raised:
        hyzer.Dataset.import_takes(takes, **{**options, "up": "sky"})
    assert "--" not in str(raised.value)
    with pytest.raises(hyzer.InputError, match="markers=") as raised:
        hyzer.Dataset.import_takes(takes, length="m", time="s", up="+z")
    assert "--" not in str(raised.value)
    with pytest.raises(hyzer.InputError, match="nothing.c3d"):
        hyzer.Dataset.import_takes(["nothing.c3d"], **options)


def test_datasets_in_memory_have_names(tmp_path: Path) -> None:
    takes, options = ["examples/disc/flight01.csv"], {"length": "m", "time": "s", "up": "+z"}
    options["markers"] = "examples/disc/dataset.toml"
    data = hyzer.Dataset.import_takes(takes, **options)
    assert data.name == "disc"
    named = hyzer.Dataset.import_takes(takes, **options, name="hall 3", held_out=[0])
    assert named.name == "hall 3"
    assert named.decisions == data.decisions
    assert hyzer.Dataset.import_takes(takes, **options, held_out=[0]).name == "disc"
    frames, markers = data.to_pandas(), data.markers
    assert hyzer.Dataset.from_pandas(frames, markers=markers).name == "flights"
    fit = hyzer.fit(hyzer.Dataset.from_pandas(frames, markers=markers, name="mine"))
    assert (fit.dataset, "fitted to mine" in fit.page()) == ("mine", True)


def test_imported_takes_have_constants_and_flights_apart() -> None:
    takes = ["examples/disc/flight01.csv", "examples/disc/flight02.csv"]
    options = {"length": "m", "time": "s", "up": "+z", "markers": "examples/disc/dataset.toml"}
    data = hyzer.Dataset.import_takes(
        takes, **options, parameters={"m": 0.2}, held_out=[0, "flight02.csv"]
    )
    assert data.parameters["m"] == 0.2
    # The constants of the template stay.
    assert data.parameters["I_a"] == DISC.parameters["I_a"]
    with pytest.raises(hyzer.InputError, match="m = -1"):
        hyzer.Dataset.import_takes(takes, **options, parameters={"m": -1})
    with pytest.raises(hyzer.InputError, match="held_out: found the flight 2, expected"):
        hyzer.Dataset.import_takes(takes, **options, held_out=[2])


def test_flights_are_held_out_by_their_recording(tmp_path: Path) -> None:
    for name, source in [("b", "flight01"), ("c", "flight02"), ("d", "flight03")]:
        shutil.copy(f"examples/disc/{source}.csv", tmp_path / f"throw_{name}.csv")
    (tmp_path / "throw_a.csv").write_text("no recording\n")
    data = hyzer.Dataset.import_takes(
        tmp_path,
        length="m",
        time="s",
        up="+z",
        markers="examples/disc/dataset.toml",
        held_out="throw_c.csv",
    )
    # The first recording has no flight.
    assert data.files == ("flight01.csv", "flight02.csv", "flight03.csv")
    assert [flight.role for flight in hyzer.fit(data).flights] == ["fit", "held_out", "fit"]


def test_recordings_of_one_name_are_held_out_together_or_by_path(tmp_path: Path) -> None:
    for day, source in [("monday", "flight01"), ("friday", "flight02")]:
        (tmp_path / day).mkdir()
        shutil.copy(f"examples/disc/{source}.csv", tmp_path / day / "throw.csv")
    days = [tmp_path / "monday", tmp_path / "friday"]
    options = {"length": "m", "time": "s", "up": "+z", "markers": "examples/disc/dataset.toml"}
    for number, (held_out, count) in enumerate(
        [
            ("throw.csv", 2),
            (days[1] / "throw.csv", 1),
            ([str(days[0] / "throw.csv"), 1], 2),
        ]
    ):
        saved = tmp_path / str(number)
        hyzer.Dataset.import_takes(days, **options, held_out=held_out).save(saved)
        assert (saved / "dataset.toml").read_text().count("held-out") == count


def test_where_no_recording_has_a_throw_each_tells_why(tmp_path: Path) -> None:
    (tmp_path / "one.csv").write_text("no recording\n")
    rows = [f"{t / 100},1.0,2.0,0.5" for t in range(100)]
    (tmp_path / "two.csv").write_text("\n".join(["t,m_x,m_y,m_z", *rows]) + "\n")
    with pytest.raises(hyzer.InputError, match="found no throw") as raised:
        hyzer.Dataset.import_takes(tmp_path, model="disc", length="m", time="s", up="+z")
    assert "one.csv:1: found the first line" in str(raised.value)
    assert "two.csv" in str(raised.value)
    with pytest.raises(hyzer.InputError) as raised:
        hyzer.Dataset.import_takes(tmp_path / "one.csv", model="disc", up="+z")
    assert raised.value.file == str(tmp_path / "one.csv")
    assert raised.value.hint


def test_faults_have_a_place() -> None:
    frames = DISC.to_pandas()
    frames["flight02.csv"].loc[4, "t"] = 0.0
    with pytest.raises(hyzer.InputError, match=r"flight02.csv:6:1: found .*, expected") as raised:
        hyzer.Dataset.from_pandas(frames, markers=DISC.markers)
    assert (raised.value.file, raised.value.line) == ("flight02.csv", 6)
    assert raised.value.hint is not None
    assert isinstance(raised.value, ValueError)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"markers": {}}, "marker"),
        ({"markers": {"m9": (0, 0, 0)}}, "m9"),
        ({"parameters": {"m": -1.0}}, "dataset.toml:.*m"),
        ({"markers": {"m1": (100.0, 0, 0)}}, "dataset.toml:"),
        ({"held_out": ["nothing.csv"]}, "found the flight 'nothing.csv'"),
        ({"held_out": [99]}, "found the flight 99"),
        ({"recording": {"length": "furlong"}}, "furlong"),
        ({"sigma": -1.0}, "dataset.toml:"),
        ({"sensors": {"s": {"kind": "frob"}}}, "frob"),
    ],
)
def test_wrong_datasets_are_refused(options: dict[str, object], message: str) -> None:
    with pytest.raises(hyzer.InputError, match=message):
        made(**options)


def test_wrong_arrays_are_refused() -> None:
    seen = {"t": np.arange(5) / 10, "m1": np.zeros((4, 3))}
    with pytest.raises(hyzer.InputError, match="m1 has the shape .4, 3., expected 5 rows of 3"):
        hyzer.Dataset.from_arrays([seen], markers={"m1": (0, 0, 0)})
    with pytest.raises(hyzer.InputError, match="found the array 'm2', expected one of t, m1"):
        hyzer.Dataset.from_arrays([{**seen, "m2": seen["m1"]}], markers={"m1": (0, 0, 0)})
    with pytest.raises(TypeError, match="frob"):
        hyzer.Dataset.from_arrays([seen], markers={"m1": (0, 0, 0)}, frob=1)


def test_a_cell_that_no_table_can_hold_is_refused() -> None:
    frame = pd.DataFrame({"t": [0.0], "m1_x": [0.0], "m1_y": [0.0], "m1_z": ["\0"]})
    with pytest.raises(hyzer.InputError, match="flight01.csv.*found"):
        hyzer.Dataset.from_pandas([frame], markers={"m1": (0, 0, 0)}, model="ball")


CELL = st.floats() | st.integers() | st.text(max_size=5) | st.none()


@given(
    st.lists(st.fixed_dictionaries({"t": CELL, "m1_x": CELL, "m1_y": CELL, "m1_z": CELL})),
    st.dictionaries(st.text(max_size=5), st.lists(st.floats(), max_size=4)),
)
@settings(max_examples=200, deadline=None, derandomize=True)
def test_no_table_ends_the_interpreter(
    rows: list[dict[str, object]], markers: dict[str, list[float]]
) -> None:
    frame = pd.DataFrame(rows)
    try:
        hyzer.Dataset.from_pandas([frame], markers={"m1": (0, 0, 0), **markers}, model="ball")
    except (hyzer.Error, UnicodeEncodeError):
        pass


DRONE = """
model drone;
param m = 0.5 kg;
param g = 9.81 m/s^2;
coefficient k = 8 N in 0 .. 20;
input throttle = 0.7;
frame N;
point drone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force thrust = k*throttle^2*N.3;
marker mark in N;
observe mark = position + mark;
"""


def test_derivatives_by_the_samples_of_an_input_sum_to_that_by_its_bias(tmp_path: Path) -> None:
    model = hyzer.Model(DRONE)
    t = np.linspace(0, 2, 41)
    start = dict.fromkeys(("x", "y", "vx", "vy", "vz"), 0.0) | {"z": 5.0}

    def flown(bias: float) -> hyzer.Flight:
        throttle = 0.75 + 0.1 * np.sin(3 * t) + bias
        release = hyzer.Release(start, inputs={"throttle": (t, throttle)}, until=2.0)
        return model.fly(release, rate=10.0, tolerance=1e-10)

    by_sample = flown(0).derivatives("throttle")
    assert by_sample.shape == (41, 21, 6)
    difference = (flown(1e-4).states - flown(-1e-4).states) / 2e-4
    np.testing.assert_allclose(by_sample.sum(0), difference, atol=1e-6)
    with pytest.raises(hyzer.InputError, match="expected one of throttle"):
        flown(0).derivatives("elevator")
    constant = model.fly(hyzer.Release(start, inputs={"throttle": 0.7}, until=1.0))
    with pytest.raises(hyzer.InputError, match="throttle is constant in this flight"):
        constant.derivatives("throttle")


def test_inputs_over_time_are_columns_or_tables_of_their_own(tmp_path: Path) -> None:
    path = tmp_path / "drone.hyz"
    path.write_text(DRONE)
    model = hyzer.Model(path)
    t = np.linspace(0, 2, 201)
    throttle = 0.75 + 0.1 * np.sin(3 * t)
    start = dict.fromkeys(("x", "y", "vx", "vy", "vz"), 0.0) | {"z": 5.0}
    release = hyzer.Release(start, inputs={"throttle": (t, throttle)}, until=2.0)
    flight = model.fly(release, k=9.0)
    seen = flight.at(t)[:, :3]
    noise = np.random.default_rng(1).normal(0, 1e-3, (3, *seen.shape))
    arrays = [{"t": t, "c": seen + own, "throttle": throttle} for own in noise]
    about: dict[str, Any] = {"markers": {"c": (0, 0, 0)}, "model": str(path)}
    data = hyzer.Dataset.from_arrays(arrays, **about)
    inside = hyzer.fit(data, model).to_dict()["coefficients"]["k"]
    assert abs(inside["value"] - 9) < 5 * inside["std_error"] < 0.1
    frames = [
        pd.DataFrame({"t": t, **{f"c_{axis}": own["c"][:, j] for j, axis in enumerate("xyz")}})
        for own in arrays
    ]
    motors = pd.DataFrame({"t": t, "throttle": throttle})
    data = hyzer.Dataset.from_pandas(frames, inputs=dict.fromkeys(range(3), motors), **about)
    beside = hyzer.fit(data, model).to_dict()["coefficients"]["k"]
    assert beside["value"] == pytest.approx(inside["value"], rel=1e-9)
    short = hyzer.Dataset.from_pandas(frames[:1], inputs={0: motors.iloc[:50]}, **about)
    with pytest.raises(hyzer.FitError, match="throttle is given from 0 to 0.49 s"):
        hyzer.fit(short, model)
    with pytest.raises(hyzer.InputError, match="did you mean hold"):
        hyzer.Dataset.from_pandas(frames, interpolation="hol", **about)


def test_a_spin_that_is_unknown_is_estimated_in_each_flight() -> None:
    t = np.linspace(0, 0.5, 101)
    ball = hyzer.Model("ball", effects=["magnus"])
    start = {"x": 0.0, "y": 0.0, "z": 1.0, "vx": 8.0, "vy": 0.0, "vz": 2.0}
    spins = [(0.0, -200.0, 50.0), (30.0, 150.0, 0.0), (0.0, -80.0, -120.0)]
    noise = np.random.default_rng(2)
    arrays = []
    for spin in spins:
        flight = ball.fly(hyzer.Release(start, known={"omega": spin}, until=0.5), C_Lw=0.9)
        seen = flight.at(t)[:, :3]
        arrays.append({"t": t, "c": seen + noise.normal(0, 2e-4, seen.shape)})
    data = hyzer.Dataset.from_arrays(
        arrays,
        markers={"c": (0, 0, 0)},
        model="ball",
        unknown=["omega"],
        known={0: {"omega": list(spins[0])}},
    )
    found = hyzer.fit(data, ball)
    lift = found.to_dict()["coefficients"]["C_Lw"]
    assert abs(lift["value"] - 0.9) < 5 * lift["std_error"] < 0.1


def test_tables_without_markers_are_answered_with_what_their_columns_may_be() -> None:
    frame = hyzer.Dataset.read("examples/ball").to_pandas()["flight01.csv"]
    with pytest.raises(hyzer.InputError, match=r"markers=\{'centre': \(0, 0, 0\)\}"):
        hyzer.Dataset.from_pandas(frame)
    arrays = {"t": np.arange(9) / 100, "seen": np.zeros((9, 3))}
    with pytest.raises(hyzer.InputError, match=r"markers=\{'seen': \(0, 0, 0\)\}"):
        hyzer.Dataset.from_arrays([arrays])
    with pytest.raises(TypeError, match="found list, expected a folder or a Dataset"):
        hyzer.fit([frame])


def test_a_dataset_names_its_model() -> None:
    frame = hyzer.Dataset.read("examples/ball").to_pandas()["flight01.csv"]
    model = hyzer.Model("ball")
    wrong: Any
    for wrong, found in [(model, "a Model"), (model.text, "the text of a model")]:
        with pytest.raises(hyzer.InputError, match=f"model: found {found}"):
            hyzer.Dataset.from_pandas(frame, markers={"centre": (0, 0, 0)}, model=wrong)


def test_a_model_of_a_file_goes_with_the_dataset(tmp_path: Path) -> None:
    heavy = hyzer.Model("ball", parameters={"m": 0.004})
    release = hyzer.Release(speed=8, launch=20, height=1.5, until=0.4)
    made = hyzer.synthesize(heavy, release, markers={"centre": (0, 0, 0)})
    assert hyzer.fit(made).reliable
    file = tmp_path / "heavy.hyz"
    file.write_text(heavy.text, encoding="utf-8")
    about: dict[str, Any] = {"markers": {"centre": (0, 0, 0)}, "model": file}
    hyzer.Dataset.from_pandas(made.to_pandas(), **about).save(tmp_path / "flights")
    file.unlink()
    assert hyzer.fit(tmp_path / "flights").coefficients.C_D.std_error < 0.1


def test_exact_flights_in_a_plane_are_fitted() -> None:
    ball = hyzer.Model("ball")
    flown = [ball.fly(hyzer.Release(speed=10 + k, launch=30, height=1.5), 0.5) for k in range(3)]
    arrays = [{"t": flight.t, "centre": flight.states[:, :3]} for flight in flown]
    data = hyzer.Dataset.from_arrays(arrays, markers={"centre": (0, 0, 0)}, model="ball")
    assert abs(hyzer.fit(data).coefficients.C_D.value - ball.defaults["C_D"]) < 1e-6
