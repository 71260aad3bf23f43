import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import hyzer

DISC = hyzer.Model("disc")
TAPE = hyzer.Model("disc", effects=["wind"])
X = np.array([0, 0, 1, 14, 0, -1, 0.1, -0.2, 0, 0.5, 0, -50.0])
EACH_STATE = st.lists(st.floats(-20, 20), min_size=12, max_size=12)
ANY_ARRAY = st.one_of(
    st.none(),
    st.text(),
    st.floats(),
    st.lists(st.floats() | st.text() | st.none(), max_size=14),
    arrays.arrays(
        arrays.scalar_dtypes() | arrays.datetime64_dtypes(),
        arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=13),
    ),
)


def states(m: int) -> np.ndarray:
    return X + np.random.default_rng(1).normal(0, 0.1, (m, 12))


@pytest.mark.parametrize("model", [DISC, TAPE])
def test_a_batch_has_the_bits_of_single_states(model: hyzer.Model) -> None:
    batch, p = states(50), {"C_D0": 0.2}
    t = np.linspace(0, 1, 50)
    assert np.array_equal(model.rhs(t, batch, p), [model.rhs(*at, p) for at in zip(t, batch)])
    for whole, single in zip(model.jac(0, batch), zip(*[model.jac(0, x) for x in batch])):
        assert np.array_equal(whole, single)
    for m in (1, 15, 16, 17, 40):
        assert np.array_equal(
            model.rhs(t[:m], batch[:m]), [model.rhs(*a) for a in zip(t, batch)][:m]
        )
    markers = [[0.1, 0, 0], [0, 0.1, 0.02]]
    seen = model.observe(0, batch, markers)
    assert np.array_equal(seen, [model.observe(0, x, markers) for x in batch])
    assert np.array_equal(seen[:, 1], model.observe(0, batch, markers[1]))


def test_a_batch_on_several_threads_has_the_bits_of_its_parts() -> None:
    batch, times = states(10_001), np.linspace(0, 1, 10_001)
    for t in (0.5, times):
        parts = [
            DISC.rhs(t if t is not times else t[k : k + 50], batch[k : k + 50])
            for k in range(0, 10_001, 50)
        ]
        assert np.array_equal(DISC.rhs(t, batch), np.concatenate(parts))


def test_jacobians_are_the_derivatives() -> None:
    j, jp = DISC.jac(0.0, X)
    p = DISC.parameter_vector()
    for matrix, at, f in [(j, X, lambda x: DISC.rhs(0, x)), (jp, p, lambda p: DISC.rhs(0, X, p))]:
        for k in range(len(at)):
            step = np.zeros(len(at))
            step[k] = 1e-6 * max(1, abs(at[k]))
            slope = (f(at + step) - f(at - step)) / (2 * step[k])
            assert np.allclose(matrix[:, k], slope, rtol=1e-6, atol=1e-5 * max(1, abs(slope).max()))


def test_parameters_by_array_by_name_and_as_defaults_are_the_same() -> None:
    p = DISC.parameter_vector()
    p[DISC.parameters.index("C_D0")] = 0.2
    by_name = DISC.rhs(0, X, {"C_D0": 0.2})
    assert np.array_equal(DISC.rhs(0, X, p), by_name)
    changed = hyzer.Model("disc", parameters={"C_D0": 0.2})
    assert np.allclose(changed.rhs(0, X), by_name, rtol=1e-12)
    assert not np.array_equal(by_name, DISC.rhs(0, X))


def test_layouts_of_memory_do_not_matter() -> None:
    batch = states(7)
    expected = DISC.rhs(0, batch)
    wide = np.zeros((7, 24))
    wide[:, ::2] = batch
    raw = np.frombuffer(b"\0" + batch.tobytes(), dtype=np.uint8)[1:].view(np.float64)
    for same in [
        np.asfortranarray(batch),
        wide[:, ::2],
        batch[::-1][::-1],
        raw.reshape(7, 12),
        batch.astype(">f8"),
        batch.tolist(),
    ]:
        assert np.array_equal(DISC.rhs(0, same), expected)
    assert np.array_equal(DISC.rhs(0, np.empty((0, 12))), np.empty((0, 12)))


@pytest.mark.parametrize(
    ("x", "message"),
    [
        (X[:11], r"x has the shape \(11,\), expected \(12,\) or \(m, 12\): x, y, z, u"),
        (X.reshape(1, 1, 12), r"shape \(1, 1, 12\)"),
        (5.0, r"shape \(\)"),
        (X.astype(complex), "dtype complex128, expected float64"),
        (np.full(12, "a"), "dtype <U1, expected float64"),
        (np.where(np.arange(12) == 3, np.nan, X), r"x\[3\] \(u\) is NaN, expected a finite"),
        ([X, np.where(np.arange(12) == 3, np.inf, X)], r"x\[1, 3\] \(u\) is inf"),
        ([[1.0], [1.0, 2.0]], "expected an array of float64"),
    ],
)
def test_a_wrong_array_is_refused_with_what_was_expected(x: object, message: str) -> None:
    with pytest.raises(hyzer.InputError, match=message):
        DISC.rhs(0.0, x)


def test_wrong_parameters_and_times_are_refused() -> None:
    with pytest.raises(hyzer.InputError, match='no parameter "C_DO"; did you mean "C_D0"'):
        DISC.rhs(0, X, {"C_DO": 0.1})
    with pytest.raises(hyzer.InputError, match=r"p has the shape \(3,\), expected \(18,\)"):
        DISC.rhs(0, X, [1, 2, 3])
    with pytest.raises(hyzer.InputError, match="C_D0 is nan|C_D0 is NaN"):
        DISC.rhs(0, X, {"C_D0": float("nan")})
    with pytest.raises(hyzer.InputError, match="t has the shape"):
        DISC.rhs([0, 1, 2], states(2))
    with pytest.raises(ValueError, match="finite"):
        DISC.rhs(float("inf"), X)


def test_faults_of_a_text_have_message_place_and_hint() -> None:
    text = DISC.text.replace("C_La*alpha", "C_Lb*alpha", 1)
    with pytest.raises(hyzer.ModelError, match="C_Lb") as raised:
        hyzer.Model(text)
    error = raised.value
    line = 1 + text[: text.index("C_Lb*alpha")].count("\n")
    assert (error.file, error.line) == ("<text>", line)
    assert error.column is not None
    assert error.hint is not None
    assert "C_L" in error.hint
    assert error.faults[0]["line"] == line
    assert isinstance(error, ValueError)
    with pytest.raises(hyzer.ModelError) as raised:
        hyzer.Model("model one_line; param m = 1 kg")
    assert raised.value.file == "<text>"


def test_a_model_is_checked_as_the_program_does() -> None:
    assert "12 states" in DISC.check() or "states" in DISC.check()
    with pytest.raises(hyzer.ModelError, match="did you mean `disc`"):
        hyzer.Model("dsic")
    with pytest.raises(hyzer.ModelError):
        hyzer.Model("disc_appendix_printed")
    with pytest.raises(hyzer.ModelError, match="no effect"):
        hyzer.Model("disc", effects=["nothing"])


@pytest.mark.parametrize("deep", ["(" * 100_000, "-" * 100_000, "{" * 100_000, "1^" * 100_000])
def test_deep_texts_are_refused(deep: str) -> None:
    with pytest.raises(hyzer.ModelError):
        hyzer.Model(f"model deep;\nlet a = {deep}1;\n")


def test_a_check_case_that_fails_is_an_error() -> None:
    text = hyzer.Model("ball").text + '\ncheck "wrong" {\n  expect der(z) = 5.0 within 0.1;\n}\n'
    with pytest.raises(hyzer.ModelError):
        hyzer.Model(text).check()


@given(EACH_STATE)
@settings(max_examples=300, deadline=None, derandomize=True)
def test_any_finite_state_has_derivatives(x: list[float]) -> None:
    for model in (DISC, TAPE):
        single = model.rhs(0.0, x)
        assert single.shape == (12,)
        for m in (2, 20):
            assert np.array_equal(model.rhs(0.0, [x] * m)[-1], single, equal_nan=True)


@given(ANY_ARRAY, ANY_ARRAY, ANY_ARRAY)
@settings(max_examples=700, deadline=None, derandomize=True)
def test_no_array_ends_the_interpreter(t: object, x: object, p: object) -> None:
    for call in (DISC.rhs, DISC.jac, DISC.quantities):
        try:
            call(t, x, p)
        except (hyzer.InputError, TypeError, UnicodeEncodeError):
            pass
    try:
        DISC.observe(0.0, X, x)
    except (hyzer.InputError, TypeError):
        pass


@given(st.text(), st.lists(st.text(), max_size=2), st.dictionaries(st.text(), st.floats()))
@settings(max_examples=500, deadline=None, derandomize=True)
def test_no_name_ends_the_interpreter(
    name: str, effects: list[str], values: dict[str, float]
) -> None:
    for source in (name, "disc"):
        try:
            hyzer.Model(source, effects, values)
        except (hyzer.Error, UnicodeEncodeError):
            pass


@given(st.data())
@settings(max_examples=500, deadline=None, derandomize=True)
def test_no_text_ends_the_interpreter(data: st.DataObject) -> None:
    text = hyzer.Model("ball").text
    at = data.draw(st.integers(0, len(text)))
    length = data.draw(st.integers(0, 40))
    try:
        hyzer.Model(text[:at] + data.draw(st.text(max_size=8)) + text[at + length :])
    except (hyzer.Error, UnicodeEncodeError):
        pass


def test_the_model_as_data_has_the_values_of_the_tape() -> None:
    J, Jp = TAPE.jac(0.0, X)
    functions = TAPE.to_numpy()
    np.testing.assert_allclose(functions.rhs(0.0, X), TAPE.rhs(0.0, X), rtol=1e-12, atol=1e-12)
    for found, expected in zip(functions.jac(0.0, X), (J, Jp)):
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-10)
