"""The page about several machines: each scheduler's results have the bytes of a single process."""

import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/how-to/several-machines.md"
HYZER = Path(sys.executable).with_name("hyzer")
FILES = ("refits.csv", "summary.json")


def blocks() -> dict[str, str]:
    """Return the code of each section of the page, by its heading."""
    found: dict[str, str] = {}
    for section in re.split(r"^#+ ", PAGE.read_text(), flags=re.MULTILINE)[1:]:
        heading, _, text = section.partition("\n")
        code = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        found[heading] = "\n".join(code)
    return found


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("alone") / "scattered"
    command = [str(HYZER), "bootstrap", str(ROOT / "examples/disc"), "--refits", "40"]
    subprocess.run([*command, "--out", str(folder)], check=True, capture_output=True)
    return folder


def test_shares_in_one_process(
    alone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts = blocks()
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    exec("SHARES = 4\n" + parts["Without the program"], {})
    for file in FILES:
        assert (tmp_path / "refits" / file).read_bytes() == (alone / file).read_bytes()


@pytest.mark.parametrize(
    ("heading", "module"), [("joblib", "joblib"), ("Dask", "distributed"), ("Ray", "ray")]
)
def test_shares_have_the_bytes_of_one_process(
    heading: str, module: str, alone: Path, tmp_path: Path
) -> None:
    if importlib.util.find_spec(module) is None:
        pytest.skip(f"{module} is not installed")
    parts = blocks()
    begin, *_ = parts.values()
    begin = begin.replace('"hyzer"', repr(str(HYZER)))
    rest = "\n".join(f"    {line}" for line in f"{parts[heading]}\n{parts['Join']}".splitlines())
    script = tmp_path / "script.py"
    script.write_text(f"{begin}\n\nif __name__ == '__main__':\n{rest}\n")
    shutil.copytree(ROOT / "examples/disc", tmp_path / "examples/disc")
    subprocess.run([sys.executable, script], cwd=tmp_path, check=True, capture_output=True)
    for file in FILES:
        assert (tmp_path / "scattered" / file).read_bytes() == (alone / file).read_bytes()
