"""The chain rule by hand, for any tool: derivatives through named quantities instead of through the whole expression."""

import disc


class Names:
    """Collects the named quantities of one run of the equations, a symbol standing for each."""

    def __init__(self, symbol, chain):
        self.symbol, self.chain, self.defined = symbol, chain, []

    def __call__(self, name, expression):
        if self.chain == "plain" or (self.chain == "air" and name not in disc.AIR):
            return expression
        s = self.symbol(name)
        self.defined.append((name, s, expression))
        return s


def jacobian(outputs, defined, by, diff, is_zero):
    """Rows of d outputs / d by. The velocity in the air comes last, since three columns go in and twelve or more come out."""
    air = [(s, e) for n, s, e in defined if n in disc.AIR]
    inner = [(s, e) for n, s, e in defined if n not in disc.AIR]
    ends = list(by) + [s for s, _ in air]
    known = []  # each named quantity with its derivatives by `ends`

    def row(expression):
        total = [diff(expression, e) for e in ends]
        for symbol, along in known:
            slope = diff(expression, symbol)
            if not is_zero(slope):
                total = [t if is_zero(a) else t + slope * a for t, a in zip(total, along)]
        return total

    for symbol, expression in inner:
        known.append((symbol, row(expression)))
    rows = [row(e) for e in outputs]

    n = len(by)
    through = [[diff(e, b) for b in by] for _, e in air]
    result = []
    for r in rows:
        total = r[:n]
        for slope, along in zip(r[n:], through):
            if not is_zero(slope):
                total = [t if is_zero(a) else t + slope * a for t, a in zip(total, along)]
        result.append(total)
    return result
