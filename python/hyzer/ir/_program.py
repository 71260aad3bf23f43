"""Evaluates the functions of an IR with the operations of a library."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from ._document import Function, Ir, Operand, Table
from ._operations import Library, Operation, operations

Values = dict[str, list[Any]]
"""Values of each output of a function, by its name."""


def required(package: str, function: str) -> Any:
    """Import a package, or raise an `ImportError` that says how to install it."""
    try:
        return importlib.import_module(package)
    except ImportError as error:
        top = package.partition(".")[0]
        advice = f"install it with `pip install {top}`, or `pip install 'hyzer[{top}]'`"
        raise ImportError(f"hyzer.ir.{function} needs the package {top}: {advice}") from error


class Program:
    """A function of an IR: operations with the places of their operands among all values.

    The values are the constants, then the inputs in the order of `Function.inputs`, then the
    results of the statements.
    """

    def __init__(self, function: Function, lengths: Mapping[str, int], calls: Sequence[Operation]):
        self.inputs = function.inputs
        self.constants: list[Any] = []
        self.outputs = function.outputs
        operands = [operand for s in function.statements for operand in s.operands]
        operands += [operand for output in function.outputs for operand in output.values]
        self.constants = list(dict.fromkeys(o for o in operands if not isinstance(o, tuple)))
        starts, start = {"": 0}, len(self.constants)
        for letter in (*function.inputs, "s"):
            starts[letter], start = start, start + lengths.get(letter, 0)
        places = {constant: k for k, constant in enumerate(self.constants)}

        def place(operand: Operand) -> int:
            if isinstance(operand, tuple):
                return starts[operand[0]] + operand[1]
            return places[operand]

        self.steps = [
            (call, [place(operand) for operand in statement.operands])
            for call, statement in zip(calls, function.statements, strict=True)
        ]
        self.results = {o.name: [place(value) for value in o.values] for o in function.outputs}

    def __call__(self, arrays: Mapping[str, Sequence[Any]]) -> Values:
        """Evaluate the outputs; `arrays` has the elements of each input by its letter."""
        values = list(self.constants)
        for letter in self.inputs:
            values += arrays[letter]
        for call, places in self.steps:
            if len(places) == 2:
                values.append(call(values[places[0]], values[places[1]]))
            else:
                values.append(call(*[values[k] for k in places]))
        return {name: [values[k] for k in places] for name, places in self.results.items()}


class Programs:
    """All functions of an IR with the operations of a library.

    Parameters
    ----------
    ir : Ir
        Checked document.
    library : Library
        Functions of the library.
    constant : callable
        Turns a float into a number of the library.
    """

    def __init__(self, ir: Ir, library: Library, constant: Callable[[float], Any] = float):
        known = operations(library)
        tables = [
            partial(library.lookup, table)
            if isinstance(table, Table)
            else partial(library.lookup_of_two, table)
            for table in ir.tables
        ]
        lengths = {
            "t": 1,
            "x": len(ir.states),
            "p": len(ir.parameters),
            "k": len(ir.functions["prepare"].outputs[0].values),
            "m": len(ir.marker),
        }
        self.programs: dict[str, Program] = {}
        for name, function in ir.functions.items():
            calls = [
                known[s.operation] if s.table is None else tables[s.table]
                for s in function.statements
            ]
            program = Program(function, lengths, calls)
            program.constants = [constant(value) for value in program.constants]
            self.programs[name] = program

    def __call__(self, name: str, arrays: Mapping[str, Sequence[Any]]) -> Values:
        """Evaluate the function `name`; ``prepare`` comes before it."""
        program = self.programs[name]
        if "k" not in program.inputs:
            return program(arrays)
        prepared = self.programs["prepare"](arrays)["prepared"]
        return program({**arrays, "k": prepared})
