"""Documents with faults: an error that says where, or a model that computes; never a crash."""

from __future__ import annotations

import copy
import json
import re
import warnings
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from conftest import ROOT, document
from hyzer.ir import IrError, read, to_numpy

ZOO = (str(ROOT / "codegen/tests/integration/zoo/zoo.hyz"),)

anything = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from(["t", "x0", "x99", "s0", "s9999", "p-1", "k00", "sin", "table", "mul"])
    | st.just(10**400),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=4), inner, max_size=3)
    ),
    max_leaves=6,
)


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the paths to all parts of a document."""
    items: Any = value.items() if isinstance(value, dict) else ()
    items = enumerate(value) if isinstance(value, list) else items
    return [path, *(place for key, part in items for place in places(part, (*path, key)))]


DOCUMENTS = [document(("ball",)), document(ZOO)]
PLACES = [places(each)[1:] for each in DOCUMENTS]


@st.composite
def damaged(draw: st.DrawFn) -> Any:
    """Draw a document of which one to three parts are replaced, dropped or doubled."""
    which = draw(st.sampled_from([0, 1]))
    found = copy.deepcopy(DOCUMENTS[which])
    for _ in range(draw(st.integers(1, 3))):
        *path, last = draw(st.sampled_from(PLACES[which]))
        part = found
        try:
            for key in path:
                part = part[key]
            change = draw(st.sampled_from(["replace", "drop", "double"]))
            if change == "replace":
                part[last] = draw(anything)
            elif change == "drop":
                del part[last]
            elif isinstance(part, list):
                part.insert(last, part[last])
        except (KeyError, IndexError, TypeError):
            pass  # An earlier change took the part away.
    return found


def computes(found: Any) -> None:
    """Compute all functions, unless the document is refused with the place of its fault."""
    try:
        model = to_numpy(found)
    except IrError as error:
        message = str(error)
    else:
        message = ""
    if message:
        assert re.match(r"[\w.\[\]]*: found .+, expected .+", message, flags=re.DOTALL), message
        return
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        assert model.rhs(0.0, model.x0).shape == model.x0.shape
        assert model.jac(0.0, model.x0)[1].shape == (len(model.x0), len(model.p0))
        model.quantities(0.0, np.stack([model.x0] * 2))
        model.limits(0.0, model.x0)
        if model.ir.functions["observe"].outputs[0].values:
            assert model.observe(0.0, model.x0).shape == (3,)


@settings(max_examples=2000, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(damaged())
def test_damaged_documents_are_refused_or_compute(found: Any) -> None:
    computes(found)


@settings(max_examples=500, deadline=None)
@given(anything)
def test_anything_else_is_refused(found: Any) -> None:
    with pytest.raises(IrError):
        read(found)


FAULTS = {
    "functions.rhs.statements[0]: found 'cosh', expected an operation of hyzer.ir/1: neg": (
        ("functions", "rhs", "statements", 0, 0),
        "cosh",
    ),
    "functions.rhs.statements[0][1]: found 's0', expected an operand": (
        ("functions", "rhs", "statements", 0, 1),
        "s0",
    ),
    "functions.rhs.statements[0][1]: found 'm0', expected an operand": (
        ("functions", "rhs", "statements", 0, 1),
        "m0",
    ),
    "functions.jacobian.outputs[1].shape: found [6, 7], expected [6, 6]": (
        ("functions", "jacobian", "outputs", 1, "shape"),
        [6, 7],
    ),
    "functions.jacobian.outputs[1].entries[0]: found 6, expected an index from 0 to 5": (
        ("functions", "jacobian", "outputs", 1, "entries", 0, 0),
        6,
    ),
    "parameters[0].value: found nan, expected a finite number": (
        ("parameters", 0, "value"),
        float("nan"),
    ),
    "names: found 'y', expected each name": (("states", 0, "name"), "y"),
    "inputs[0].parameters: found 'wind_w', expected the name of a parameter": (
        ("inputs", 0, "parameters", 0),
        "wind_w",
    ),
}


@pytest.mark.parametrize("message", FAULTS)
def test_a_fault_is_told_with_its_place(message: str) -> None:
    (*path, last), value = FAULTS[message]
    found = part = document(("ball",))
    for key in path:
        part = part[key]
    part[last] = value
    with pytest.raises(IrError) as error:
        read(found)
    assert message in str(error.value)


def test_a_number_of_many_digits_is_refused() -> None:
    with pytest.raises(IrError, match="schema: found a number of thousands of digits"):
        read({"schema": 10**5000})


def test_a_deep_document_is_refused() -> None:
    deep: Any = 1
    for _ in range(100_000):
        deep = [deep]
    with pytest.raises(IrError, match="states: found"):
        read({**document(("ball",)), "states": {"a": deep}})


def test_unknown_fields_are_ignored() -> None:
    found = document(("ball",))
    assert read({**found, "more": 1}) == read(json.loads(json.dumps(found)))
