# SPDX-License-Identifier: Apache-2.0
"""Sums up the figures of many seeds, and compares the loss of the main figure with the drawn parameters."""
import collections
import math
import statistics

import figures

LEAST_SEEDS = 20  # fewer say nothing about a parameter


def quantile(values, share):
    """The value at rank share * (n - 1), rounded towards the worse end by the caller's order."""
    return values[min(len(values) - 1, int(share * (len(values) - 1)))]


def table(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
                     .rstrip() for row in rows)


def shown(value):
    return "-" if value is None else f"{value:.3f}" if abs(value) < 100 else f"{value:.0f}"


def ranks(values):
    """Ranks from 0; equal values share the mean of their ranks."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    result = [0.0] * len(values)
    at = 0
    while at < len(order):
        end = at
        while end + 1 < len(order) and values[order[end + 1]] == values[order[at]]:
            end += 1
        for i in range(at, end + 1):
            result[order[i]] = (at + end) / 2
        at = end + 1
    return result


def rank_correlation(a, b):
    """Spearman's; 0 where one of the two does not vary."""
    a, b = ranks(a), ranks(b)
    ma, mb = statistics.fmean(a), statistics.fmean(b)
    saa, sbb = sum((x - ma) ** 2 for x in a), sum((y - mb) ** 2 for y in b)
    if saa == 0 or sbb == 0:
        return 0.0
    return sum((x - ma) * (y - mb) for x, y in zip(a, b)) / math.sqrt(saa * sbb)


def figure_rows(records):
    rows = [["figure", "seeds", "median", "worst tenth", "worst", "seed"]]
    for name, better in figures.DIRECTIONS.items():
        have = [(r["figures"][name], r) for r in records if name in r.get("figures", {})]
        if not have:
            continue
        have.sort(key=lambda pair: pair[0], reverse=better == "-")  # the worst first
        values = [value for value, _ in have]
        worst = have[0][1]
        rows.append([name, str(len(have)), shown(statistics.median(values)), shown(quantile(values, 0.1)),
                     shown(values[0]), f"{worst['scene']} {worst['seed']}"])
    return rows


def loss_of(record, product):
    """1 - main figure; a run that failed, or that drew nothing to judge, has lost everything."""
    return 1 - record.get("figures", {}).get(figures.MAIN[product], 0)


def number_row(name, pairs):
    """Mean loss in the lowest and the highest fifth of a parameter, with all equal values, and the rank correlation."""
    pairs.sort(key=lambda p: p[0])
    fifth = max(1, len(pairs) // 5)
    low = [p for p in pairs if p[0] <= pairs[fifth - 1][0]]
    high = [p for p in pairs if p[0] >= pairs[-fifth][0]]
    if pairs[0][0] == pairs[-1][0]:
        return None
    loss = lambda part: statistics.fmean(p[1] for p in part)
    correlation = rank_correlation([p[0] for p in pairs], [p[1] for p in pairs])
    return abs(loss(high) - loss(low)), [name, f"up to {low[-1][0]:.4g}", f"{loss(low):.3f}", f"from {high[0][0]:.4g}",
                                         f"{loss(high):.3f}", f"{correlation:+.2f}"]


def choice_row(name, pairs):
    """The choices with the least and the most mean loss, of those that at least one seed in twenty has."""
    by_choice = collections.defaultdict(list)
    for choice, loss in pairs:
        by_choice[choice].append(loss)
    means = sorted((statistics.fmean(v), c) for c, v in by_choice.items() if len(v) * 20 >= len(pairs))
    if len(means) < 2:
        return None
    (low, best), (high, worst) = means[0], means[-1]
    return high - low, [name, str(best), f"{low:.3f}", str(worst), f"{high:.3f}", ""]


def parameter_rows(product, records):
    names = sorted({name for r in records for name in r["drawn"]})
    rows = []
    for name in names:
        pairs = [(r["drawn"][name], loss_of(r, product)) for r in records if name in r["drawn"]]
        if len(pairs) < LEAST_SEEDS:
            continue
        is_choice = any(isinstance(value, str) for value, _ in pairs)
        row = choice_row(name, pairs) if is_choice else number_row(name, pairs)
        if row:
            rows.append(row)
    rows.sort(key=lambda r: (-r[0], r[1][0]))
    return [["parameter", "where", "loss", "where", "loss", "rank corr."]] + [row for _, row in rows]


def summary(product, records):
    failed = [r for r in records if "failed" in r]
    parts = [f"{product}: {len(records)} seeds, {len(failed)} failed", table(figure_rows(records))]
    for r in failed[:10]:
        parts.append(f"failed: {r['scene']} {r['seed']}: {r['failed']}")
    worst = sorted(records, key=lambda r: (-loss_of(r, product), r["scene"], r["seed"]))[:10]
    parts.append(f"worst of '{figures.MAIN[product]}'\n" + "\n".join(
        f"  {r['scene']} {r['seed']}: {1 - loss_of(r, product):.3f}   {r['commands']}" for r in worst))
    rows = parameter_rows(product, records)
    if len(rows) > 1:
        parts.append(f"mean loss of '{figures.MAIN[product]}' by drawn parameter, the strongest first\n" + table(rows))
    return "\n\n".join(parts)
