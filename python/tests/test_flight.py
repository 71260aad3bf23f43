import json
import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests_of_program import program

import hyzer

DISC = hyzer.Model("disc")


def test_a_wind_is_stated_in_four_ways() -> None:
    throw = {"speed": 12, "launch": 20, "height": 1.2}
    ball = hyzer.Model("ball")
    stated = ball.fly(hyzer.Release(**throw, wind=(1, 0, 0))).landing
    assert stated[0] > ball.fly(hyzer.Release(**throw)).landing[0] + 0.3
    windy = hyzer.Model("ball", parameters={"wind_x": 1.0})
    assert np.array_equal(windy.fly(hyzer.Release(**throw)).landing, stated)
    assert np.array_equal(ball.fly(hyzer.Release(**throw), wind_x=1.0).landing, stated)
    calm = windy.fly(hyzer.Release(**throw, wind=(0, 0, 0))).landing
    assert np.array_equal(calm, ball.fly(hyzer.Release(**throw)).landing)


def test_a_flight_is_that_of_the_program(tmp_path: Path) -> None:
    throw = {"speed": 20, "launch": 8, "nose": 2, "hyzer": 10, "spin": 700, "height": 1.5}
    options = [text for name, value in throw.items() for text in (f"--{name}", str(value))]
    run = program("simulate", "disc", *options, "--out", str(tmp_path / "flown"))
    assert run.returncode == 0, run.stderr
    flight = DISC.fly(hyzer.Release(**throw))
    summary = json.loads((tmp_path / "flown" / "summary.json").read_text())
    assert flight.summary is not None
    assert flight.summary.to_dict() == summary
    table = np.loadtxt(tmp_path / "flown" / "trajectory.csv", delimiter=",", skiprows=1)
    assert np.array_equal(table[:, 0], flight.t)
    assert np.array_equal(table[:, 1:], flight.states)
    flight.save(tmp_path / "same")
    names = {path.name for path in (tmp_path / "flown").iterdir()}
    assert {path.name for path in (tmp_path / "same").iterdir()} == names


def test_a_wind_changes_the_flight_and_its_model() -> None:
    throw = {"speed": 20, "launch": 8, "spin": 700}
    calm = DISC.fly(hyzer.Release(**throw)).landing
    blown = DISC.fly(hyzer.Release(**throw, wind=(0, 3, 0))).landing
    profile = {"profile": "log", "speed": 3.0, "direction": 90.0}
    by_height = DISC.fly(hyzer.Release(**throw, wind=profile)).landing
    assert blown[1] > calm[1] + 1
    assert by_height[1] > calm[1] + 1
    assert by_height[1] != blown[1]


def test_initial_states_and_values_by_name() -> None:
    states = dict.fromkeys(DISC.states, 0.0) | {"z": 1.5, "u": 14.0, "gammadot": -50.0}
    one = DISC.fly(states, until=0.5, C_D0=0.1)
    two = DISC.fly(hyzer.Release(states, until=0.5, coefficients={"C_D0": 0.1}))
    assert np.array_equal(one.states, two.states)
    assert one["u"][-1] > DISC.fly(states, until=0.5)["u"][-1]
    assert one.t[-1] == 0.5
    assert one.ended_by == "time"
    assert DISC.fly(states, z=2.0, until=0.1)["z"][0] == 2.0


def test_a_figure_shows_the_whole_path_with_equal_scales() -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    steep = hyzer.Release(speed=25, launch=10, hyzer=5, spin=600)
    drop = hyzer.Release(speed=1, launch=90, height=30)
    flights = [DISC.fly(steep), DISC.fly("backhand"), hyzer.Model("ball").fly(drop)]
    for flight in flights:
        axes = flight.plot()
        axes[0].figure.canvas.draw()
        for axis, name in zip(axes, "zy"):
            for values, (low, high) in (
                (flight["x"], axis.get_xlim()),
                (flight[name], axis.get_ylim()),
            ):
                assert low < values.min()
                assert values.max() < high
            origin, far = axis.transData.transform([[0, 0], [1, 1]])
            assert np.isclose(*(far - origin))
    axes = flights[1].plot(flights[0].plot())
    for axis, name in zip(axes, "zy"):
        assert axis.get_xlim()[1] > flights[0]["x"].max()
        assert axis.get_ylim()[1] > flights[0][name].max()


def test_a_throw_without_spin_is_told() -> None:
    with pytest.warns(UserWarning, match="thrown without spin; spin= states it, in rpm") as told:
        DISC.fly(hyzer.Release(speed=20, until=0.1))
    assert [warning.filename for warning in told] == [__file__]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        DISC.fly(hyzer.Release(speed=20, spin=0, until=0.1))
        DISC.fly("backhand")
        hyzer.Model("ball").fly(hyzer.Release(speed=20))


def test_tables_and_figures() -> None:
    flight = DISC.fly("backhand", rate=60)
    frame = flight.to_pandas()
    assert list(frame.columns) == list(DISC.states)
    assert frame.index.name == "t"
    assert flight.to_xarray()["u"].attrs["units"] == "m/s"
    assert flight.markers([[0.1, 0, 0], [0, 0.1, 0]]).shape == (len(flight.t), 2, 3)
    assert np.array_equal(flight.at(flight.t), flight.states)
    page = str(flight.view())
    assert "<html" in page
    assert "srcdoc" in flight.view()._repr_html_()
    import matplotlib as mpl

    mpl.use("Agg")
    side, _ = flight.plot()
    assert len(side.lines) == 1


@pytest.mark.filterwarnings("ignore:thrown without spin")
@pytest.mark.parametrize(
    ("release", "options", "message"),
    [
        ("nothing", {}, "expected a TOML file, or a release by name: fssh3"),
        (hyzer.Release(speed=-1), {}, "release:.*speed"),
        (
            hyzer.Release(speed=20, nose=200),
            {},
            "nose is 200; expected a number from -90 to 90 deg",
        ),
        ({"z": 1.0}, {}, "expected every state of the model"),
        ("backhand", {"until": -1}, 'until is -1, expected "ground" or a number'),
        ("backhand", {"until": "sky"}, "until is sky"),
        ("backhand", {"rate": 0}, "rate is 0"),
        ("backhand", {"tolerance": 1}, "tolerance is 1"),
        ("backhand", {"C_DO": 0.1}, 'no "C_DO"; did you mean "C_D0"'),
        ("backhand", {"m": -1.0}, "m is -1, expected"),
    ],
)
def test_a_wrong_release_is_refused(
    release: object, options: dict[str, object], message: str
) -> None:
    with pytest.raises(hyzer.InputError, match=message):
        DISC.fly(release, **options)


def test_a_flight_that_never_lands_is_an_error() -> None:
    with pytest.raises(hyzer.FlightError):
        DISC.fly("backhand", until="ground", g=1e-9)
    with pytest.raises(hyzer.InputError, match="expected a time of the flight"):
        DISC.fly("backhand", until=0.1).at(5.0)


NUMBER = st.floats() | st.integers(-(2**70), 2**70)


@pytest.mark.filterwarnings("ignore:thrown without spin")
@given(st.dictionaries(st.sampled_from(["speed", "nose", "spin", "wobble", "height"]), NUMBER))
@settings(max_examples=200, deadline=None, derandomize=True)
def test_no_release_ends_the_interpreter(throw: dict[str, float]) -> None:
    try:
        DISC.fly(hyzer.Release(**throw), until=0.05)
    except (hyzer.Error, OverflowError):
        pass


@given(st.text(max_size=30))
@settings(max_examples=100, deadline=None, derandomize=True)
def test_no_text_of_a_release_ends_the_interpreter(text: str) -> None:
    try:
        DISC.fly(hyzer.Release.parse("text", 'model = "disc"\nuntil = "ground"\n' + text))
    except (hyzer.Error, UnicodeEncodeError):
        pass
