"""Extension of griffe: compiled methods have types in the stubs, docstrings in the library."""

import inspect

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
