import doctest
import inspect
import re
from pathlib import Path

import pytest

import hyzer

PAGE = Path(__file__).parents[2] / "docs/how-to/use-from-python.md"
FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS


@pytest.mark.parametrize(
    "name", ["rhs", "jac", "observe", "quantities", "parameter_vector", "check"]
)
def test_the_examples_of_compiled_methods_run(name: str) -> None:
    text = inspect.cleandoc(getattr(hyzer.Model, name).__doc__)
    test = doctest.DocTestParser().get_doctest(text, {}, name, None, 0)
    told: list[str] = []
    results = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=told.append)
    assert results.failed == 0, "".join(told)
    assert results.attempted > 1


def test_the_snippets_of_the_page_run() -> None:
    blocks = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    text = "\n".join(blocks)
    test = doctest.DocTestParser().get_doctest(text, {}, PAGE.name, str(PAGE), 0)
    told: list[str] = []
    results = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=told.append)
    assert results.failed == 0, "".join(told)
    assert results.attempted > 15
