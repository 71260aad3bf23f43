"""Extensions of griffe: docstrings of compiled methods, parameters as signatures have them."""

import inspect
from collections.abc import Iterator

import griffe

import hyzer


class CompiledDocs(griffe.Extension):
    """Give the methods of `hyzer._hyzer.Model` the docstrings of the library."""

    def on_package(self, *, pkg: griffe.Module, **kwargs: object) -> None:
        """Fill in what is missing."""
        stubs = pkg["_hyzer.Model"]
        for name, member in stubs.members.items():
            text = inspect.getdoc(getattr(hyzer.Model, name, None))
            if member.docstring is None and text and not name.startswith("_"):
                member.docstring = griffe.Docstring(text, parent=member, parser="numpy")


class OwnParameters(griffe.Extension):
    """Give each parameter its own default, and its own type where the docstring states none.

    griffe gives all names of an entry such as `flights, held_out : int` the default of the first,
    and takes the first of `{"range", "hit"}` for a default.
    """

    def on_package(self, *, pkg: griffe.Module, **kwargs: object) -> None:
        """Correct the parameters of all docstrings."""
        for of in _objects(pkg):
            declared = _declared(of)
            own = {parameter.name: parameter for parameter in declared}
            for section in of.docstring.parsed:
                if section.kind is not griffe.DocstringSectionKind.parameters:
                    continue
                for entry in section.value:
                    signature = own.get(entry.name)
                    entry.value = None if signature is None else signature.default
                    # The very object: the docstring stated no type.
                    if any(entry.annotation is other.annotation for other in declared):
                        entry.annotation = None if signature is None else signature.annotation


def _objects(of: griffe.Object) -> Iterator[griffe.Object]:
    """Return the classes and functions with a docstring."""
    for member in of.members.values():
        if member.is_alias:
            continue
        if (member.is_class or member.is_function) and member.docstring:
            yield member
        yield from _objects(member)


def _declared(of: griffe.Object) -> list[griffe.Parameter]:
    """Return the parameters of a function, or of the call of a class."""
    if of.is_function:
        return list(of.parameters)
    made = of.members.get("__init__") or of.members.get("__new__")
    return list(made.parameters) if made else []
