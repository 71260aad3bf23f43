"""The page on other solvers runs as it is written, and the schema holds for what is exported."""

from __future__ import annotations

import doctest
import importlib
import json
import os
import re
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from conftest import CASES, ROOT, document, hyzer, name_of, program
from hyzer.ir import SCHEMA
from hyzer.ir._document import ARITY

REFERENCE = ROOT / "docs/reference"
JSON_SCHEMA = json.loads((REFERENCE / "ir.schema.json").read_text())


def test_the_page_on_other_solvers_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (ROOT / "docs/how-to/other-solvers.md").read_text()
    monkeypatch.chdir(tmp_path)
    commands = re.findall(r"^    hyzer (.*)$", page, flags=re.MULTILINE)
    assert len(commands) == 2
    for command in commands:
        *words, file = command.split()
        hyzer(*words, str(tmp_path / file))
    names: dict[str, Any] = {}
    for block in re.findall(r"```python\n(.*?)```", page, flags=re.DOTALL):
        exec(compile(block, "other-solvers.md", "exec"), names)
    assert np.max(np.abs(names["same"] - names["by_parameter"])) < 1e-5 * np.max(names["same"])
    assert 20 < names["landing"][0] < 120
    assert abs(names["landing"][2]) < 1e-9
    assert str(names["disc"].rhs["x"]) == "u*cos(theta) + w*sin(theta)"


@pytest.mark.parametrize("module", ["_read", "numpy_", "jax_", "casadi_", "sympy_"])
def test_the_examples_of_docstrings_run(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(program("--bin", "hyzer").parent), prepend=os.pathsep)
    options = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
    tested = doctest.testmod(importlib.import_module(f"hyzer.ir.{module}"), optionflags=options)
    assert (tested.failed, tested.attempted > 0) == (0, True)


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_what_is_exported_fits_the_schema(case: tuple[str, ...]) -> None:
    jsonschema.Draft202012Validator(JSON_SCHEMA).validate(document(case))


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("schema",), "hyzer.ir/2"),
        (("functions", "rhs", "statements", 0), ["cosh", "x0"]),
        (("functions", "rhs", "statements", 0), ["sin", "x0", "x1"]),
        (("functions", "rhs", "statements", 0), ["add", "x0"]),
        (("functions", "rhs", "statements", 0), ["sin", "x01"]),
        (("functions", "rhs", "statements", 0), ["table", "x0"]),
        (("parameters", 0, "bounds"), [1]),
        (("states", 0), {"name": "x"}),
    ],
)
def test_what_does_not_fit_the_schema_is_refused(path: tuple[Any, ...], value: Any) -> None:
    found = part = document(("ball",))
    for key in path[:-1]:
        part = part[key]
    part[path[-1]] = value
    assert not jsonschema.Draft202012Validator(JSON_SCHEMA).is_valid(found)


def test_schema_page_and_reader_have_the_same_operations() -> None:
    *fixed, table, table_of_two = JSON_SCHEMA["$defs"]["statement"]["oneOf"]
    arity = {
        operation: len(each["prefixItems"]) - 1
        for each in fixed
        for operation in each["prefixItems"][0]["enum"]
    }
    lookups = {table["prefixItems"][0]["const"]: 1, table_of_two["prefixItems"][0]["const"]: 2}
    assert {**arity, **lookups} == ARITY
    page = (REFERENCE / "ir.md").read_text()
    rows = page.split("| operation |")[1].split("\n\n")[0].splitlines()[2:]
    named = [name for row in rows for name in re.findall(r"`(\w+)`", row.split("|")[1])]
    assert sorted(named) == sorted(ARITY)
    assert JSON_SCHEMA["properties"]["schema"]["const"] == SCHEMA
    assert f"{len(ARITY)} operations" in (ROOT / "docs/how-to/other-solvers.md").read_text()
