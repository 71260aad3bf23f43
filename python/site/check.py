"""Checks the built site, and docs/ as plain Markdown.

Of the site: links, anchors, ids, requests to other hosts, parameters of the reference.

python check.py SITE    exit status 1 and a line for each fault
"""

import html
import inspect
import re
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from pkgutil import resolve_name
from urllib.parse import unquote, urlsplit

import markdown
from markdown_it import MarkdownIt

import hyzer

DOCS = Path(__file__).resolve().parents[2] / "docs"
EXTENSIONS = ["admonition", "attr_list", "md_in_html", "sane_lists", "tables"]
EXTENSIONS += ["pymdownx.superfences", "pymdownx.highlight"]
BLOCKS = {
    "li",
    "pre",
    "table",
    "td",
    "th",
    "h1",
    "h2",
    "h3",
    "ol",
    "ul",
    "em",
    "strong",
    "a",
    "img",
}


class Page(HTMLParser):
    """The links, ids and elements of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.elements: Counter[str] = Counter()
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """Note what an element refers to."""
        about = {name: value or "" for name, value in attributes}
        self.elements[tag] += 1
        self.ids += [about["id"]] if "id" in about else []
        if tag in {"a", "link", "use", "image"} and "href" in about:
            self.links.append(about["href"])
        if "src" in about:
            self.links.append(about["src"])
        resource = about.get("src") or (about.get("href", "") if tag == "link" else "")
        is_loaded = tag != "link" or about.get("rel") in {"stylesheet", "icon", "preload"}
        self.loaded += [resource] if resource.startswith(("http", "//")) and is_loaded else []


def site(folder: Path) -> list[str]:
    """Return the faults of the links of a site."""
    whole = {"rust", "demo"}  # Pages of rustdoc and of a report, whose scripts make anchors.
    paths = [p for p in folder.rglob("*.html") if not whole & set(p.relative_to(folder).parts)]
    pages = {path: Page(path.read_text("utf-8")) for path in paths}
    faults = []
    for path, page in pages.items():
        name = path.relative_to(folder)
        faults += [f"{name}: loads {resource} from another host" for resource in page.loaded]
        doubled = [i for i, times in Counter(page.ids).items() if times > 1]
        faults += [f"{name}: the id {i} stands twice" for i in doubled]
        for link in set(page.links):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link == "." or name.name == "404.html":
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            target = target / "index.html" if target.is_dir() else target
            if not target.exists():
                faults.append(f"{name}: {link}: no such file")
            elif parts.fragment and target in pages:
                wanted = unquote(parts.fragment)
                if wanted not in pages[target].ids and not wanted.startswith("__"):
                    faults.append(f"{name}: {link}: no such anchor")
    reference = pages.get(folder / "reference/python.html")
    shown = set(reference.ids) if reference else set()
    names = [name for name in hyzer.__all__ if not name.startswith("__")]
    faults += [
        f"reference/python.md lacks {name}" for name in names if f"hyzer.{name}" not in shown
    ]
    return faults


def signatures(page: str) -> list[str]:
    """Return the parameters of the reference whose default or type differs from the signature."""
    faults, of, known = [], "", dict[str, inspect.Parameter]()
    title = r'<span class="doc-section-title">(\w+)'
    entry = rf'<h\d id="(hyzer[\w.]*)"|{title}|<li class="doc-section-item field-body">(.*?)<div'
    for heading, section, item in re.findall(entry, page, re.DOTALL):
        of = heading or of
        if section == "Parameters":
            known = dict(inspect.signature(resolve_name(of)).parameters)
        elif heading or section:
            known = {}
        text = " ".join(html.unescape(re.sub(r"<[^>]+>", "", item)).split())
        parts = re.fullmatch(r"(\w+) \((.*?)(?:, default: (.*?))? ?\) \W", text)
        if not parts or parts[1] not in known:
            continue
        name, kind, default = parts.groups()
        own = known[name]
        expected = None if own.default is own.empty else repr(own.default)
        if expected != (default and default.replace('"', "'")):
            faults.append(f"{of}: {name} has the default {expected}, shown is {default}")
        kinds = {str(other.annotation): other for other in known.values()}
        if "|" in kind and kinds.get(kind, own) is not own and kind != str(own.annotation):
            faults.append(f"{of}: {name} is of {own.annotation}, shown is {kind}")
    return faults


def plain(docs: Path) -> list[str]:
    """Return the pages that a code host (CommonMark) reads otherwise than the site does."""
    common = MarkdownIt("commonmark", {"html": True}).enable("table")
    faults = []
    for path in sorted(docs.rglob("*.md")):
        text = path.read_text("utf-8")
        here = markdown.markdown(text, extensions=EXTENSIONS)
        there, here = Page(common.render(text)).elements, Page(here).elements
        differ = [f"{b} {there[b]}/{here[b]}" for b in sorted(BLOCKS) if there[b] != here[b]]
        if differ:
            faults.append(f"{path.relative_to(docs)}: Markdown that reads otherwise: {differ}")
    return faults


if __name__ == "__main__":
    built = Path(sys.argv[1]).resolve()
    found = site(built) + plain(DOCS)
    found += signatures((built / "reference/python.html").read_text("utf-8"))
    print(*found, f"{len(found)} faults", sep="\n")
    sys.exit(bool(found))
