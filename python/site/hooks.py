"""Hooks of mkdocs: what the site adds to the plain Markdown of docs/."""

import os
import re
from pathlib import Path, PurePosixPath

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
BUILT = Path(os.environ.get("SITE_BUILD", ROOT / "target/site-build"))  # what notebooks.py wrote
OUTSIDE = re.compile(r"\[([^\[\]]+)\]\(((?:\.\./)+[\w./-]+)(?:#[\w-]+)?\)")
NOTEBOOK = re.compile(r"\]\(((?:[\w.-]+/)*[\w-]+)\.py\)")


def _source(page: str, link: str) -> Path | None:
    """Return the file of the repository outside docs/ that a link of a page means."""
    target = Path(os.path.normpath(DOCS / PurePosixPath(page).parent / link))
    return None if target.is_relative_to(DOCS) or not target.exists() else target


def on_config(config):
    """Put the API of the crates into the navigation, where it was built."""
    if (BUILT / "rust").is_dir():
        for section in config.nav:
            section.get("Reference", []).append({"Rust": "rust/hyzer/index.html"})


def on_files(files, config):
    """Add notebooks, assets, and the files of the repository that pages link to."""
    for asset in (Path(__file__).parent / "assets").iterdir():
        files.append(File.generated(config, f"assets/{asset.name}", abs_src_path=str(asset)))
    for made in sorted(path for path in BUILT.rglob("[!.]*") if path.is_file()):
        name = made.relative_to(BUILT).as_posix()
        files.append(File.generated(config, name, abs_src_path=str(made)))
    for file in list(files.documentation_pages()):
        for _, link in OUTSIDE.findall(file.content_string):
            source = _source(file.src_uri, link)
            if source and source.is_file():
                name = _published(source)
                if name not in files.src_uris:
                    files.append(File.generated(config, name, abs_src_path=str(source)))
    return files


def _published(source: Path) -> str:
    """Return where a file outside docs/ is on the site: as text, which browsers show."""
    name = f"files/{source.relative_to(ROOT).as_posix()}"
    return name if source.suffix in {".svg", ".png", ".csv"} else f"{name}.txt"


def on_page_markdown(markdown, page, config, files):
    """Point links at the site's copies, and show what plain Markdown hides in comments."""
    here = PurePosixPath(page.file.src_uri)

    def outside(match):
        source = _source(str(here), match[2])
        if source is None:
            return match[0]
        if source.is_dir():  # There is no listing of folders.
            return match[1]
        return f"[{match[1]}]({os.path.relpath(_published(source), here.parent)})"

    def notebook(match):
        target = os.path.normpath(DOCS / here.parent / f"{match[1]}.py")
        return f"]({match[1]}.md)" if target.startswith(str(DOCS / "notebooks")) else match[0]

    markdown = NOTEBOOK.sub(notebook, OUTSIDE.sub(outside, markdown))
    return re.sub(r"<!-- (?:site: |(?=:::))(.*?) -->", r"\1", markdown, flags=re.DOTALL)
