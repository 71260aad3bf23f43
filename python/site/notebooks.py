"""Runs the notebooks of docs/notebooks and writes each as a page, with its figures, for the site.

python notebooks.py [NAME ...] --out FOLDER

Exit status 1 if a cell fails. A cell that draws must say what its figure shows: `# %% alt="…"`.
"""

import argparse
import html
import itertools
import re
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import jupytext
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

ROOT = Path(__file__).resolve().parents[2]
SETUP = """
%config InlineBackend.figure_formats = ["svg"]
import matplotlib as mpl
mpl.rcParams.update({"svg.fonttype": "none", "font.family": "sans-serif", "font.size": 11,
                     "figure.facecolor": "none", "axes.facecolor": "none",
                     "savefig.facecolor": "none", "legend.framealpha": 0})
"""
_count = itertools.count()


def figure(svg: str, alt: str) -> str:
    """Return an SVG of matplotlib as part of a page: in the page's colours, its names its own."""
    svg = re.sub(r"^.*?(?=<svg)", "", svg, flags=re.DOTALL)
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    number = next(_count)
    svg = re.sub(r'((?:id="|href="#|url\(#))', rf"\g<1>f{number}-", svg)
    svg = re.sub(r"#000000|#000\b|black", "currentColor", svg)
    svg = re.sub(r"<text style=\"", '<text fill="currentColor" style="', svg)
    svg = re.sub(r' (width|height)="[\d.]+pt"', "", svg, count=2)
    label = html.escape(alt, quote=True)
    svg = svg.replace("<svg ", f'<svg class="figure" role="img" aria-label="{label}" ', 1)
    return "<figure>" + re.sub(r"\s*\n\s*", " ", svg) + "</figure>"


def streams_joined(outputs: list) -> list:
    """Return outputs with streams joined, without what a carriage return overwrote."""
    joined: list = []
    for output in outputs:
        is_stream = output["output_type"] == "stream"
        if is_stream and joined and joined[-1].get("name") == output["name"]:
            joined[-1]["text"] += output["text"]
        else:
            joined.append(dict(output))
    for output in joined:
        if "text" in output:
            lines = [line.rstrip("\r").rsplit("\r", 1)[-1] for line in output["text"].split("\n")]
            output["text"] = "\n".join(lines)
    return joined


def shown(output: dict, alt: str | None) -> str:
    """Return one output of a cell as Markdown."""
    if output["output_type"] == "stream":
        text = output["text"] if output["name"] == "stdout" else ""
        return f'```text title="Output"\n{text.rstrip()}\n```' if text.strip() else ""
    data = output.get("data", {})
    if "image/svg+xml" in data:
        if not alt:
            raise ValueError('a cell draws a figure without # %% alt="…"')
        return figure(data["image/svg+xml"], alt)
    if "text/html" in data:
        table = re.sub(
            r"<style.*?</style>|\s*\n\s*|border=\"1\"", " ", data["text/html"], flags=re.DOTALL
        )
        return f'<div class="output">{table}</div>'
    return f'```text title="Output"\n{data.get("text/plain", "").rstrip()}\n```'


def page(notebook: dict, name: str) -> str:
    """Return an executed notebook as Markdown."""
    parts = []
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        alt = cell.metadata.get("alt")
        outputs = streams_joined(cell.outputs)
        if alt:  # Of a cell that draws, the value is an object of matplotlib.
            outputs = [output for output in outputs if output["output_type"] != "execute_result"]
        parts += [shown(output, alt) for output in outputs]
    parts.append(f"Download: [{name}.ipynb]({name}.ipynb), [{name}.py]({name}.py.txt)")
    return "\n\n".join(part for part in parts if part) + "\n"


def executed(source: Path) -> tuple[dict, str, float]:
    """Return a notebook with its outputs, its text without them, and the seconds that it took."""
    begun = time.perf_counter()
    notebook = jupytext.read(source)
    plain = jupytext.writes(notebook, fmt="ipynb")
    setup = jupytext.reads("# %%\n" + SETUP.strip(), fmt="py:percent").cells[0]
    setup.source = SETUP
    notebook.cells.insert(0, setup)
    client = NotebookClient(
        notebook,
        timeout=600,
        kernel_name="python3",
        resources={"metadata": {"path": str(ROOT)}},
    )
    client.execute()
    notebook.cells.pop(0)
    return notebook, plain, time.perf_counter() - begun


def main() -> int:
    """Run what was asked for, two notebooks side by side."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    sources = sorted((ROOT / "docs/notebooks").glob("*.py"))
    asked = [s for s in sources if not options.names or s.stem in options.names]
    with ThreadPoolExecutor(2) as pool:
        running = [pool.submit(executed, source) for source in asked]
    for source, done in zip(asked, running, strict=True):
        try:
            notebook, plain, seconds = done.result()
        except CellExecutionError as error:
            print(f"{source.name}: {error}", file=sys.stderr)
            return 1
        (options.out / f"{source.stem}.md").write_text(
            page(notebook, source.stem), encoding="utf-8"
        )
        (options.out / f"{source.stem}.ipynb").write_text(plain, encoding="utf-8")
        (options.out / f"{source.stem}.py.txt").write_text(source.read_text(), encoding="utf-8")
        print(f"{source.name}: {seconds:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
