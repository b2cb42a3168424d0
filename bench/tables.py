# SPDX-License-Identifier: Apache-2.0
"""Makes Markdown tables and SVG plots from the results of bench/run.

usage: bench/tables.py results.json FOLDER    draws them again
"""
import json
import math
import pathlib
import sys

BEGIN, END = "<!-- tables: made by bench/run --readme -->", "<!-- end of tables -->"


def number(v):
    return f"{v:.0f}" if v >= 100 else f"{v:.1f}" if v >= 10 else f"{v:.2f}" if v >= 0.1 else f"{v:.3g}"


def one_line(line):
    if "rows" in line:
        text = ", ".join(f"{r['name']} {number(r['rate'])}" + (f" (x{r['ratio']:.2f})" if i else "")
                         for i, r in enumerate(line["rows"]))
        text += f" {line['unit']}"
    elif "share" in line:
        text = f"2 threads are {line['scaling']:.2f} times as fast, the loop {line['loop_scaling']:.2f}"
    else:
        text = ", ".join(f"{k} {number(v)}" for k, v in line["figures"].items())
    return f"  {line['kernel']}, {line['variant']}, {line['threads']} threads: {text}"


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
                     + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def is_ours(row):
    return row["name"].startswith("ilot")


def is_ceiling(row):
    return row["name"] == "ceiling"


def comparisons(results):
    """Returns (line, our row, other row) for every peer."""
    for line in results["lines"]:
        for row in line.get("rows", [])[1:]:
            if not is_ours(row) and not is_ceiling(row):
                yield line, line["rows"][0], row


def kernel_table(results):
    rows = [[l["kernel"], l["variant"], l["threads"], f"{number(a['rate'])} {l['unit']}", b["name"], number(b["rate"]),
             f"**{b['ratio']:.2f}, the peer wins**" if b["ratio"] < 1 else f"{b['ratio']:.1f}"]
            for l, a, b in comparisons(results)]
    return table(["kernel", "case", "threads", "ilot", "peer", "its rate", "ratio"], rows)


def ceiling_table(results):
    rows = [[l["threads"]] + [number(v) for v in l["figures"].values()]
            for l in results["lines"] if l["kernel"] == "ceiling"]
    return table(["threads", "read, GB/s", "triad, GB/s", "register loop, G point-planes/s"], rows)


def share_table(results):
    rows = []
    for l in results["lines"]:
        rows += [[l["kernel"], l["variant"], l["threads"], f"{r['ratio']:.2f}"]
                 for r in l.get("rows", []) if is_ceiling(r)]
    return table(["kernel", "case", "threads", "share of the ceiling"], rows)


def scaling_table(results):
    rows = [[l["kernel"], l["variant"], f"{l['scaling']:.2f}", f"{l['loop_scaling']:.2f}", f"{l['share']:.3f}"]
            for l in results["lines"] if "share" in l]
    if results["pipeline"]:
        m, s = results["pipeline"]["scaling"]["million_points"], results["pipeline"]["scaling"]["median"]
        rows.append(["whole run", f"{m} M points", f"{s['speedup']:.2f}", f"{s['loop_scaling']:.2f}",
                     f"{s['share_of_loop']:.3f}"])
    return table(["kernel", "case", "2 threads / 1", "register loop's", "share"], rows)


def figure_table(results):
    rows = [[l["kernel"], l["variant"], "; ".join(f"{k}: {v:.4g}" for k, v in l["figures"].items())]
            for l in results["lines"] if "figures" in l and l["kernel"] != "ceiling"]
    return table(["kernel", "what", "figures"], rows)


def pipeline_table(results):
    rows = [[f"{r['million_points']} M", r["seconds_per_million"], r["peak_mib"], r["planes"]]
            for r in results["pipeline"]["sizes"]]
    return table(["points", "seconds per million", "peak resident, MiB", "planes"], rows)


def losses(results):
    rows = [f"  {l['kernel']}, {l['variant']}, {l['threads']} threads: "
            f"{b['name']} is {1 / b['ratio']:.2f} times as fast"
            for l, _, b in comparisons(results) if b["ratio"] < 1]
    return "A peer wins:\n" + "\n".join(rows) if rows else "No peer wins."


def markdown(results):
    m = results["machine"]
    parts = [f"Machine: {m['cpu']}, {m['cores']} cores, {m['memory_gib']} GiB, {m['compiler']}"
             + (f", ILOT_FORCE_ISA={m['forced_isa']}" if m["forced_isa"] else "")
             + f", instruction set {results['lines'][0]['isa']}.",
             "### Ceiling", ceiling_table(results), share_table(results),
             "### Kernels beside their peers", kernel_table(results), losses(results).replace("\n  ", "\n- "),
             "### 2 threads against 1", scaling_table(results), "### What was found", figure_table(results)]
    if results["laz"]:
        parts += ["### LAZ, M points/s", table(["case", "rate"], [[r["name"], f"{r['m_points_per_s']:.1f}"]
                                                                 for r in results["laz"]])]
    if results["pipeline"]:
        parts += [f"### Whole run, --memory {results['pipeline']['memory_limit']}, 2 threads, LAS to labelled LAZ",
                  pipeline_table(results)]
    return "\n\n".join(parts) + "\n"


def svg(width, height, body):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">'
            f'<rect width="{width}" height="{height}" fill="white"/>{"".join(body)}</svg>\n')


def text(x, y, content, anchor="start", colour="#222"):
    content = content.replace("&", "&amp;").replace("<", "&lt;")
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{content}</text>'


def ratio_plot(results):
    """Draws a bar per comparison on a logarithmic scale. To the left of 1 the peer wins."""
    bars = [(f"{l['kernel']}, {l['variant']}, {l['threads']} thr.: {b['name']}", b["ratio"])
            for l, _, b in comparisons(results)]
    left, width, step = 520, 1000, 18
    most = max([math.log10(max(r, 1.0)) for _, r in bars] + [1.0])
    least = min([math.log10(min(r, 1.0)) for _, r in bars] + [0.0])
    scale = (width - left - 60) / (most - least)
    zero = left - least * scale
    body = [text(10, 18, "How many times longer the peer takes (logarithmic)")]
    for tick in (1, 2, 5, 10, 20, 50, 100):
        x = zero + math.log10(tick) * scale
        if x <= width - 50:
            body.append(f'<line x1="{x:.1f}" y1="40" x2="{x:.1f}" y2="{46 + step * len(bars)}" stroke="#ccc"/>')
            body.append(text(x, 36, str(tick), "middle"))
    for i, (name, ratio) in enumerate(bars):
        y, x = 46 + step * i, zero + math.log10(ratio) * scale
        colour = "#3b7dd8" if ratio >= 1 else "#d8573b"
        body.append(f'<rect x="{min(zero, x):.1f}" y="{y}" width="{abs(x - zero):.1f}" height="{step - 5}" '
                    f'fill="{colour}"/>')
        body += [text(left - 8, y + 11, name, "end"), text(max(zero, x) + 4, y + 11, number(ratio))]
    return svg(width, 60 + step * len(bars), body)


def pipeline_plot(results):
    """Draws seconds per million points and peak memory against size. Both should be flat."""
    sizes = results["pipeline"]["sizes"]
    panels = [("seconds per million points", "seconds_per_million"), ("peak resident, MiB", "peak_mib")]
    body = []
    for p, (title, key) in enumerate(panels):
        left, top, width, height = 60 + 380 * p, 50, 280, 200
        most = 1.2 * max(r[key] for r in sizes)
        xs = [math.log10(r["million_points"]) for r in sizes]
        span = max(xs[-1] - xs[0], 1e-9)
        at = [(left + width * (x - xs[0]) / span, top + height * (1 - r[key] / most)) for x, r in zip(xs, sizes)]
        body.append(text(left, top - 20, title))
        body.append(f'<path d="M{left} {top}V{top + height}H{left + width}" fill="none" stroke="#444"/>')
        body.append('<polyline fill="none" stroke="#3b7dd8" stroke-width="2" points="'
                    + " ".join(f"{x:.1f},{y:.1f}" for x, y in at) + '"/>')
        for (x, y), r in zip(at, sizes):
            body.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#3b7dd8"/>')
            body += [text(x, y - 10, number(r[key]), "middle"),
                     text(x, top + height + 18, f"{r['million_points']} M", "middle")]
    return svg(780, 300, body)


def write(results, folder):
    (folder / "results.md").write_text(markdown(results))
    (folder / "ratios.svg").write_text(ratio_plot(results))
    if results["pipeline"]:
        (folder / "pipeline.svg").write_text(pipeline_plot(results))


def into_readme(results, path):
    before, rest = path.read_text().split(BEGIN)
    after = rest.split(END)[1]
    path.write_text(f"{before}{BEGIN}\n\n{markdown(results)}\n{END}{after}")


if __name__ == "__main__":
    write(json.loads(pathlib.Path(sys.argv[1]).read_text()), pathlib.Path(sys.argv[2]))
