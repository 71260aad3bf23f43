"""The Python code of pages of docs/ runs, the blocks of a page one after the other."""

import re
from pathlib import Path
from typing import Any

import pytest

import hyzer

ROOT = Path(__file__).resolve().parents[2]
PAGES = ["README.md", "how-to/coming-from.md", "how-to/from-recordings-to-a-page.md"]
PAGES += ["how-to/design-a-throw.md"]


def vicon(folder: Path) -> None:
    """Write the flights of examples/mystery as CSV exports of Vicon Nexus."""
    folder.mkdir()
    for number, frame in enumerate(hyzer.Dataset.read("examples/mystery").to_pandas().values(), 1):
        values = (1000 * frame.drop(columns="t")).round(3)
        values.insert(0, "frame", range(1, len(frame) + 1))
        values.insert(1, "sub", 0)
        lines = ["Trajectories", "120", ",,Disc:m1,,,Disc:m2,,,Disc:m3,,"]
        lines += ["Frame,Sub Frame," + ",".join(["X,Y,Z"] * 3), ",," + ",".join(["mm"] * 9)]
        text = "\n".join(lines) + "\n" + values.to_csv(index=False, header=False)
        (folder / f"Throw {number:02}.csv").write_text(text)


@pytest.mark.parametrize("page", PAGES)
def test_the_code_of_a_page_runs(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (ROOT / "docs" / page).read_text()
    blocks = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert blocks
    vicon(tmp_path / "vicon")
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for number, block in enumerate(blocks, 1):
        exec(compile(block, f"{page}, block {number}", "exec"), names)
    if page.endswith("design-a-throw.md"):
        assert names["found"].feasible
        return
    assert names["found"].causes == ["stall"]
    if "recordings" in page:
        assert (tmp_path / "page/report.html").is_file()
        assert names["data"].name == "vicon"
        assert "C_Ls," in (tmp_path / "coefficients.csv").read_text()
        heads = (tmp_path / "positions.csv").read_text().partition("\n")[0]
        assert heads == "flight,t,x,y,z,marker"
        assert [f.role for f in names["blind"].flights][-2:] == ["held_out"] * 2
        residuals = names["left"][["x_m", "y_m", "z_m"]]
        assert len(residuals) > 100
        assert residuals.abs().median().max() < 0.002  # Some samples are outliers.
        assert (tmp_path / "flight.png").is_file()
        assert names["flown"].ended_by == "ground"
