"""Shortens a page that a study wrote: `python3 studies/tables.py [--split] docs/studies/PAGE.md…`.

A page has at most 600 words. Tables of more than 8 rows, then the largest ones until the page is short enough, become CSV files beside
it, PAGE-SECTION.csv, and a link takes their place. Tables of criteria stay, and so do those of peers that the page of the
discoveries copies. With --split each section of a page becomes a page of its own first. A page that was shortened stays as it is.
"""

import argparse
import csv
import pathlib
import re

MAX_WORDS = 600
MAX_ROWS = 8
KEPT = {"criterion", "bar", "nothing found", "terms found in a dataset, mean"}
SMALL_WORDS = {"a", "and", "at", "by", "for", "from", "in", "is", "of", "on", "one", "the", "this", "to", "what", "with"}


def cells(line):
    """Cells of a line of a table, as plain text. A bar in code does not end a cell: spans are joined until they are closed."""
    parts, cell = [], ""
    for part in line.strip().strip("|").split("|"):
        cell = f"{cell}|{part}" if cell else part
        if cell.count("`") % 2 == 0:
            parts.append(re.sub(r"[`*]", "", cell).strip())
            cell = ""
    return parts


def blocks(text):
    """Text cut into lists of lines, where each list is one table or what stands between two tables."""
    found = []
    for line in text.splitlines():
        is_row = line.startswith("|")
        if not found or found[-1][0] != is_row:
            found.append((is_row, []))
        found[-1][1].append(line)
    return found


def slug(heading):
    """Up to four words of a heading, as a part of a file's name."""
    words = re.sub(r"\(.*?\)|[^\w\s-]", "", heading.lower()).split()
    return "-".join([word for word in words if word not in SMALL_WORDS][:4])


def words(parts):
    return sum(len(line.replace("|", " ").split()) for _, lines in parts for line in lines)


def write_csv(file, lines):
    """Writes a table; cells beyond the header are parts of the last column, whose text has bars."""
    head = cells(lines[0])
    with file.open("w", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(head)
        for line in lines[2:]:
            row = cells(line)
            # A text that was cut off may end within code.
            if len(row) < len(head):
                row = cells(line.replace("`", ""))
            last = len(head) - 1
            writer.writerow(row[:last] + [" | ".join(row[last:])])


def moved(parts):
    """Indices of the tables that become CSV files, in the order of the page."""
    tables = [k for k, (is_table, lines) in enumerate(parts) if is_table and not KEPT & set(cells(lines[0]))]
    total, chosen = words(parts), []
    for k in sorted(tables, key=lambda k: -words([parts[k]])):
        if len(parts[k][1]) - 2 > MAX_ROWS or total > MAX_WORDS:
            chosen.append(k)
            total -= words([parts[k]])
    return sorted(chosen)


def shorten(page):
    """Moves tables of a page to CSV files, and returns the number of words that are left."""
    parts = blocks(page.read_text())
    chosen, taken, base = moved(parts), set(), page.stem
    for k, (is_table, lines) in enumerate(parts):
        headings = [line.lstrip("# ") for line in lines if not is_table and re.match("##+ ", line)]
        if headings:
            base = f"{page.stem}-{slug(headings[-1])}"
        if k in chosen:
            number = next(n for n in range(1, 100) if (base, n) not in taken)
            taken.add((base, number))
            name = f"{base}.csv" if number == 1 else f"{base}-{number}.csv"
            write_csv(page.with_name(name), lines)
            parts[k] = (True, [f"Table: [{name}]({name}), {len(lines) - 2} rows."])
    page.write_text("\n".join(line for _, lines in parts for line in lines) + "\n")
    return words(parts)


def split(page):
    """Moves each section to a page of its own, and lists them."""
    head, *rest = re.split(r"(?m)^## ", page.read_text())
    pages, links = [page], []
    for section in rest:
        title, body = section.split("\n", 1)
        file = page.with_name(f"{page.stem}-{slug(title)}.md")
        body = re.sub(r"(?m)^##(#+ )", r"#\1", body).strip()
        file.write_text(f"# {title}\n\nA part of [{page.stem}]({page.name}).\n\n{body}\n")
        pages.append(file)
        links.append(f"- [{title}]({file.name})")
    if links:
        page.write_text(head.strip() + "\n\n" + "\n".join(links) + "\n")
    return pages


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    parser.add_argument("--split", action="store_true")
    options = parser.parse_args()
    for page in options.pages:
        for file in split(page) if options.split else [page]:
            print(f"{file}: {shorten(file)} words")


if __name__ == "__main__":
    main()
