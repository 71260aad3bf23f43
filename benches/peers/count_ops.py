"""Counts the floating-point operations of straight-line C, C++ or Rust, whoever generated it.

    python3 count_ops.py FILE [FUNCTION ...]     # JSON, one entry per function

Rules, the same for all:
- `+ - * /` between two values count one each, `+=` and its like too; a unary minus counts as `neg`, apart, unless it is
  the sign of a number. Arithmetic between two numbers is folded and counts nothing. Nothing inside `[...]` counts.
- sqrt, sin, cos, tan, atan, atan2, exp, log, abs, min, max, hypot count one each, as f(x) or x.f(); `sin_cos` is a sin
  and a cos; `mul_add` and `fma` are a `*` and a `+`, our `mul_sub` and `neg_mul_add` a `*` and a `-`; `recip` is a `/`; `casadi_sq` is a `*`.
- A power of a whole number n is the products of repeated squaring (n=2: one, 3: two, 4: two) and, if n < 0, a `/`;
  with a half on top a `sqrt` besides; every other power is a `pow`. `powi` likewise.
- `total` leaves out `neg`, which is free on most machines and which tools spread differently; `total_with_neg` has it.
- Any other call counts under its own name in `calls` and never in `total`, so that nothing is hidden silently.
"""

import json
import re
import sys
from collections import Counter

NUMBER = r"(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?(?:_?[fiu](?:32|64|size))?[fFL]?"
TOKEN = re.compile(
    rf"\s+|//[^\n]*|/\*.*?\*/|(?P<num>{NUMBER})|(?P<id>[A-Za-z_]\w*)"
    r"|(?P<op>::|->|=>|==|!=|<=|>=|&&|\|\||[-+*/]=|\.\.=?|[-+*/()\[\]{}<>=,;:.!&|?%^#@'\"\\~$])",
    re.S,
)
ONCE = {"sqrt", "sin", "cos", "tan", "atan", "atan2", "asin", "acos", "exp", "log", "hypot", "abs", "min", "max"}
ALIAS = {"fabs": "abs", "fmin": "min", "fmax": "max", "ln": "log"}
SEVERAL = {
    "sin_cos": ("sin", "cos"),
    "sincos": ("sin", "cos"),
    "mul_add": ("*", "+"),
    "fma": ("*", "+"),
    "mul_sub": ("*", "-"),
    "neg_mul_add": ("*", "-"),
    "recip": ("/",),
    "casadi_sq": ("*",),
}
# Access to data, not arithmetic; so is any name with an underscore in front (wrenfold's spans).
FREE = {"get", "set", "splat", "from", "into", "make_input_span", "make_output_span", "to_array", "if", "return", "while", "for"}
KEYWORDS = {"return", "in", "let", "mut", "if", "else", "const", "as", "match"}


def tokens(text):
    text = re.sub(r"static_cast<\w+>\(([^()]*)\)", r"(\1)", text)  # casts of numbers
    text = re.sub(r"\((\d+)i64\)\s*as\s+f64", r"\1.0", text)
    text = re.sub(rf"(?<!\w)\(({NUMBER})\)", r" \1 ", text)
    text = re.sub(r"\bstd::(\w+)\(", r"\1(", text)
    return [(m.lastgroup, m.group()) for m in TOKEN.finditer(text) if m.lastgroup]


def is_value_end(token):
    kind, text = token
    return kind == "num" or (kind == "id" and text not in KEYWORDS) or text in (")", "]")


def squarings(n):
    return n.bit_length() - 1 + bin(n).count("1") - 1


def power(exponent, ops):
    """What x^exponent costs; the exponent is text."""
    digits = re.sub(r"\s|_?[iu](32|64)|_?f64", "", exponent)
    sums = re.fullmatch(r"\(?(-?)\(?([\d.]+)(?:/([\d.]+))?\)?\)?", digits)
    value = (-1 if sums.group(1) else 1) * float(sums.group(2)) / float(sums.group(3) or 1) if sums else 0.25
    if value == 0 or (2 * value) % 1:
        ops["pow"] += 1
        return
    whole, half = divmod(abs(value), 1)
    whole = int(whole)
    ops["*"] += squarings(whole) if whole else 0
    if half:
        ops["sqrt"] += 1
        ops["*"] += 1 if whole else 0
    ops["/"] += 1 if value < 0 else 0


def last_argument(toks, i):
    """The text of the last argument of the call whose parenthesis opens at i."""
    depth, start = 0, i + 1
    for j in range(i, len(toks)):
        t = toks[j][1]
        depth += (t in "([{") - (t in ")]}") if len(t) == 1 else 0
        if t == "," and depth == 1:
            start = j + 1
        if depth == 0:
            return "".join(t for _, t in toks[start:j]), (start, j)
    raise ValueError("a call that does not close")


def count(text):
    """Operations in a body; a `{` of the signature and all before it is passed over."""
    toks = tokens(text[text.index("{") + 1 :] if "{" in text else text)
    ops, calls, brackets, skip = Counter(), Counter(), 0, (0, 0)
    for i, (kind, t) in enumerate(toks):
        before = toks[i - 1] if i else ("op", ";")
        after = toks[i + 1] if i + 1 < len(toks) else ("op", ";")
        brackets += (t == "[") - (t == "]")
        # A bracket after a value is an index; one that opens an array holds values.
        if t == "[" and not is_value_end(before):
            brackets -= 1
            toks[i] = ("op", "[list")
        if t == "]" and brackets < 0:
            brackets = 0
        if brackets or skip[0] <= i < skip[1]:
            continue
        if kind == "id" and after[1] == "(":
            name = ALIAS.get(t, t)
            if name in ("pow", "powi", "powf"):
                exponent, skip = last_argument(toks, i + 1)
                power(exponent, ops)
            elif name in SEVERAL:
                ops.update(SEVERAL[name])
            elif name in ONCE:
                ops[name] += 1
            elif name not in FREE and name not in KEYWORDS and not name.startswith("_"):
                calls[name] += 1
        elif t in ("+=", "-=", "*=", "/="):
            ops[t[0]] += 1
        elif t in ("+", "-", "*", "/"):
            if not is_value_end(before):
                ops["neg"] += t == "-" and after[0] != "num"
            elif not folded(toks, i):
                ops[t] += 1
    total = sum(n for k, n in ops.items() if k != "neg")
    return {**{k: n for k, n in sorted(ops.items()) if n}, "total": total, "total_with_neg": total + ops["neg"],
            **({"calls": dict(calls)} if calls else {})}


def folded(toks, i):
    """Two numbers and nothing that binds the first of them to a value before it."""
    if toks[i - 1][0] != "num" or i + 1 >= len(toks) or toks[i + 1][0] != "num":
        return False
    head = toks[i - 2][1] if i >= 2 else ";"
    return head in ("(", "=", ",", ";", "[list", "return") or (head in "+-" and toks[i][1] in "*/")


def functions(text):
    """Name and text of every function with a body."""
    found = {}
    for m in re.finditer(r"\bfn\s+(\w+)[^{]*\{|\b(\w+)\s*\([^{};()]*\)\s*\{", text):
        name = m.group(1) or m.group(2)
        if name in KEYWORDS | {"for", "while", "switch"}:
            continue
        depth = 0
        for j in range(m.end() - 1, len(text)):
            depth += (text[j] == "{") - (text[j] == "}")
            if depth == 0:
                found[name] = text[m.end() - 1 : j + 1]
                break
    return found


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        everything = functions(file.read())
    wanted = sys.argv[2:] or list(everything)
    print(json.dumps({name: count(everything[name]) for name in wanted}, indent=1))
