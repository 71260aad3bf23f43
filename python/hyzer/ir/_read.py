"""Checks the dict of ``json.loads`` and turns it into an :class:`Ir`."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from ._check import Fields, each, entries, exactly, fault, flag, index, number, string, table_of
from ._document import (
    ARITY,
    SCHEMA,
    Function,
    Input,
    Ir,
    Limit,
    Operand,
    Output,
    Parameter,
    Quantity,
    State,
    Statement,
    Table,
    TableOfTwo,
)

OPERAND = re.compile(r"t|([xpkms])(0|[1-9][0-9]{0,8})")
Lengths = Mapping[str, int]
Tables = Sequence[Table | TableOfTwo]
LOOKUPS: dict[str, type[object]] = {"table": Table, "table_of_two": TableOfTwo}


def state(value: object, place: str) -> State:
    fields = Fields(value, place)
    return State(fields.of("name", string), fields.of("unit", string), fields.of("value", number))


def bounds(value: object, place: str) -> tuple[float, float] | None:
    if value is None:
        return None
    low, high = exactly(each(value, place, number), place, 2)
    return low, high


def parameter(value: object, place: str) -> Parameter:
    fields = Fields(value, place)
    return Parameter(
        name=fields.of("name", string),
        unit=fields.of("unit", string),
        value=fields.of("value", number),
        coefficient=fields.of("coefficient", flag),
        bounds=fields.of("bounds", bounds),
        doc=fields.of("doc", string),
    )


def vector_input(value: object, place: str) -> Input:
    fields = Fields(value, place)
    x, y, z = exactly(fields.all("parameters", string), f"{place}.parameters", 3)
    return Input(
        name=fields.of("name", string),
        unit=fields.of("unit", string),
        frame=fields.of("frame", string),
        parameters=(x, y, z),
    )


def quantity(value: object, place: str) -> Quantity:
    fields = Fields(value, place)
    return Quantity(fields.of("name", string), fields.of("unit", string))


def limit(value: object, place: str) -> Limit:
    fields = Fields(value, place)
    return Limit(fields.of("bound", number), fields.of("reason", string))


def cubic(value: object, place: str) -> tuple[float, ...]:
    return exactly(each(value, place, number), place, 4)


def bicubic(value: object, place: str) -> tuple[float, ...]:
    return exactly(each(value, place, number), place, 16)


def knots_of(fields: Fields, key: str, place: str) -> tuple[float, ...]:
    knots = fields.all(key, number)
    if not knots or any(b <= a for a, b in pairwise(knots)):
        raise fault(f"{place}.{key}", list(knots), "one or more increasing numbers")
    return knots


def table(value: object, place: str) -> Table | TableOfTwo:
    fields = Fields(value, place)
    name, knots = fields.of("name", string), knots_of(fields, "knots", place)
    if "second_knots" not in fields.values:
        cubics = exactly(fields.all("cubics", cubic), f"{place}.cubics", len(knots) + 1)
        return Table(name, knots, cubics)
    second = knots_of(fields, "second_knots", place)
    count = (len(knots) + 1) * (len(second) + 1)
    cells = exactly(fields.all("bicubics", bicubic), f"{place}.bicubics", count)
    return TableOfTwo(name, knots, second, cells)


def operand(value: object, place: str, lengths: Lengths) -> Operand:
    """Read a number, or a letter and an index below the length of that array."""
    if not isinstance(value, str):
        return number(value, place)
    match = OPERAND.fullmatch(value)
    letter, k = (match[1] or "t", int(match[2] or 0)) if match else ("", 0)
    if k < lengths.get(letter, 0):
        return letter, k
    raise fault(place, value, f"an operand: a number, or one of {described(lengths)}")


def described(lengths: Lengths) -> str:
    """Return the operands that exist, as text."""
    ranges = (
        f"{letter}0 to {letter}{n - 1}" for letter, n in lengths.items() if letter != "t" and n
    )
    return ", ".join(["t", *ranges] if "t" in lengths else ranges)


def statement(value: object, place: str, lengths: Lengths, tables: Tables) -> Statement:
    items = entries(value, place)
    operation = string(items[0], place) if items else ""
    if operation not in ARITY:
        raise fault(place, operation, f"an operation of {SCHEMA}: {', '.join(ARITY)}")
    rest = items[1:]
    looked_up = None
    if (kind := LOOKUPS.get(operation)) and rest:
        looked_up = index(rest.pop(0), place, len(tables))
        if not isinstance(tables[looked_up], kind):
            raise fault(place, items, f"the index of a table for {operation}")
    if len(rest) != ARITY[operation]:
        raise fault(place, items, f"{ARITY[operation]} operands of {operation}")
    operands = tuple(operand(item, f"{place}[{k + 1}]", lengths) for k, item in enumerate(rest))
    return Statement(operation, operands, looked_up)


def output(value: object, place: str, lengths: Lengths, shape: tuple[int, ...]) -> Output:
    fields = Fields(value, place)
    found = fields.all("shape", lambda n, at: index(n, at, 1 << 30))
    if found != shape:
        raise fault(f"{place}.shape", list(found), f"{list(shape)}")
    values = fields.all("values", lambda item, at: operand(item, at, lengths))
    if len(shape) == 1:
        exactly(values, f"{place}.values", shape[0])
        return Output(fields.of("name", string), shape, values, None)
    pairs = fields.all("entries", lambda pair, at: entry(pair, at, shape))
    exactly(pairs, f"{place}.entries", len(values))
    if len(set(pairs)) != len(pairs):
        raise fault(f"{place}.entries", "an entry twice", "each entry once")
    return Output(fields.of("name", string), shape, values, pairs)


def entry(value: object, place: str, shape: tuple[int, ...]) -> tuple[int, int]:
    row, column = exactly(tuple(entries(value, place)), place, 2)
    return index(row, place, shape[0]), index(column, place, shape[1])


def function(
    value: object,
    place: str,
    lengths: Lengths,
    shapes: Mapping[str, tuple[int, ...]],
    tables: Tables,
) -> Function:
    """Read a function whose outputs have the given names and shapes."""
    fields = Fields(value, place)
    inputs = fields.all("inputs", string)
    known = {letter: lengths[letter] for letter in inputs if letter in lengths}
    if len(known) != len(inputs):
        raise fault(f"{place}.inputs", list(inputs), f"each once, of {', '.join(lengths)}")
    statements: list[Statement] = []
    for k, item in enumerate(fields.of("statements", entries)):
        at = f"{place}.statements[{k}]"
        statements.append(statement(item, at, {**known, "s": k}, tables))
    known["s"] = len(statements)
    outputs = fields.of("outputs", entries)
    exactly(tuple(outputs), f"{place}.outputs", len(shapes))
    read_outputs: list[Output] = []
    for k, (name, shape) in enumerate(shapes.items()):
        found = output(outputs[k], f"{place}.outputs[{k}]", known, shape)
        if found.name != name:
            raise fault(f"{place}.outputs[{k}].name", found.name, repr(name))
        read_outputs.append(found)
    return Function(inputs, tuple(statements), tuple(read_outputs))


def shapes_of(sizes: Lengths) -> dict[str, dict[str, tuple[int, ...]]]:
    """Return the outputs of each function of a model, with their shapes."""
    n, p, m, y = sizes["x"], sizes["p"], sizes["m"], sizes["y"]
    return {
        "rhs": {"dx": (n,)},
        "jacobian": {"dx": (n,), "j": (n, n), "jp": (n, p)},
        "observe": {"y": (y,)},
        "observe_jacobian": {"y": (y,), "dy_dx": (y, n), "dy_dp": (y, p), "dy_dmarker": (y, m)},
        "quantities": {"q": (sizes["q"],)},
        "limits": {"l": (sizes["l"],)},
    }


def functions(value: object, place: str, sizes: Lengths, tables: Tables) -> dict[str, Function]:
    fields = Fields(value, place)
    prepared = prepared_length(fields)
    prepare = {"prepared": (prepared,)}
    read_functions = {
        "prepare": fields.of(
            "prepare", lambda v, at: function(v, at, {"p": sizes["p"]}, prepare, tables)
        )
    }
    lengths = {"t": 1, "x": sizes["x"], "p": sizes["p"], "k": prepared}
    for name, shapes in shapes_of(sizes).items():
        given = {**lengths, "m": sizes["m"]} if name.startswith("observe") else lengths

        def item(v: object, at: str, given: Lengths = given, shapes: Any = shapes) -> Function:
            return function(v, at, given, shapes, tables)

        read_functions[name] = fields.of(name, item)
    return read_functions


def prepared_length(functions: Fields) -> int:
    """Return the number of values that ``prepare`` computes."""
    outputs = functions.of("prepare", Fields).of("outputs", entries)
    place = "functions.prepare.outputs"
    first = Fields(exactly(tuple(outputs), place, 1)[0], f"{place}[0]")
    return len(first.of("values", entries))


def observed_length(value: object, place: str) -> int:
    """Return the number of components that are observed: 3, or 0 without an observation."""
    outputs = Fields(Fields(value, place).of("observe", table_of), f"{place}.observe")
    first = outputs.of("outputs", entries)[:1]
    return 3 if first and Fields(first[0], place).of("values", entries) else 0


def read(ir: object) -> Ir:
    """Check an IR document and return its parts.

    Parameters
    ----------
    ir : dict
        Document as ``json.loads`` returns it; an :class:`Ir` is returned as it is.

    Returns
    -------
    Ir
        Names, units, default values and functions of the model.

    Raises
    ------
    IrError
        If the schema is another, an operation is unknown, or any part is not as
        its page in the reference describes it.

    Examples
    --------
    >>> read({"schema": "hyzer.ir/9"})
    Traceback (most recent call last):
    hyzer.ir._document.IrError: schema: found 'hyzer.ir/9', expected 'hyzer.ir/1'; ...
    """
    if isinstance(ir, Ir):
        return ir
    fields = Fields(ir, "")
    schema = fields.of("schema", string)
    if schema != SCHEMA:
        advice = "export the model again with this version of hyzer"
        raise fault("schema", schema, f"{SCHEMA!r}; {advice}")
    states, parameters = fields.all("states", state), fields.all("parameters", parameter)
    quantities, limits = fields.all("quantities", quantity), fields.all("limits", limit)
    marker, tables = fields.all("marker", string), fields.all("tables", table)
    sizes = {
        "x": len(states),
        "p": len(parameters),
        "m": len(marker),
        "y": fields.of("functions", observed_length),
        "q": len(quantities),
        "l": len(limits),
    }
    inputs = fields.all("inputs", vector_input)
    known = [parameter.name for parameter in parameters]
    unique([*(state.name for state in states), *known, *marker])
    for k, given in enumerate(inputs):
        for name in given.parameters:
            if name not in known:
                raise fault(f"inputs[{k}].parameters", name, "the name of a parameter")
    return Ir(
        version=fields.of("version", string),
        model=fields.of("model", string),
        effects=fields.all("effects", string),
        states=states,
        parameters=parameters,
        inputs=inputs,
        marker=marker,
        quantities=quantities,
        limits=limits,
        tables=tables,
        functions=fields.of("functions", lambda v, at: functions(v, at, sizes, tables)),
    )


def unique(names: list[str]) -> None:
    """Raise if a state, a parameter or a coordinate of the marker has the name of another."""
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise fault("names", name, "each name of a state, parameter or coordinate once")
        seen.add(name)
