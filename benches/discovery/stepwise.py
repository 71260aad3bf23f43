"""Stepwise regression, and the predicted squared error that says when to stop.

Klein and Morelli, Aircraft System Identification (2006), 5.4: forward by the greatest partial correlation, backward by the partial F ratio,
and of all models on the way the one with the least PSE = (mean squared residual) + (greatest variance) p / N, where the
greatest variance is that of the left side about its mean.
"""

import numpy as np


def squares(normal, right, total, chosen):
    """Residual sum of squares and partial F numerators of the chosen columns, from the normal equations."""
    if not chosen:
        return total, np.zeros(0)
    inverse = np.linalg.pinv(normal[np.ix_(chosen, chosen)], hermitian=True)
    solution = inverse @ right[chosen]
    return total - right[chosen] @ solution, solution**2 / np.maximum(np.diag(inverse), 1e-300)


def select(columns, left, given, least=4.0, most=16):
    """Columns chosen beside the given ones. A term is taken, and stays, by a partial F above `least`."""
    count = len(left)
    scale = np.linalg.norm(columns, axis=0)
    normal, right, total = (columns / scale).T @ (columns / scale), (columns / scale).T @ left, left @ left
    variance = total - count * left.mean() ** 2
    given, chosen, seen = list(given), list(given), set()
    error = lambda rss, some: rss / count + variance / count * len(some) / count
    rss, _ = squares(normal, right, total, chosen)
    best = (error(rss, chosen), list(chosen))
    while len(chosen) < len(given) + most:
        tried = []
        for column in range(columns.shape[1]):
            if column not in chosen:
                less, gains = squares(normal, right, total, [*chosen, column])
                tried.append((gains[-1] / max(less / (count - len(chosen) - 1), 1e-300), column))
        ratio, column = max(tried)
        if ratio <= least:
            break
        chosen.append(column)
        while True:
            rss, gains = squares(normal, right, total, chosen)
            ratios = gains / (rss / (count - len(chosen)))
            weak = [(f, c) for f, c in zip(ratios, chosen) if c not in given and f < least]
            if not weak:
                break
            chosen.remove(min(weak)[1])
        # A circle of steps forward and back would not end.
        if frozenset(chosen) in seen:
            break
        seen.add(frozenset(chosen))
        best = min(best, (error(rss, chosen), list(chosen)))
    return [c for c in best[1] if c not in given]
