"""One self-contained page and a Markdown table."""
from __future__ import annotations

from html import escape

import numpy as np

from .case import Comparison, Quantity, Result
from .plot import Series, plot

STYLE = """
:root { color-scheme: light dark; --ink: #1b2230; --dim: #5c6675; --line: #d9dee6; --page: #ffffff; --card: #f6f8fa;
  --c0: #1f6fb2; --c1: #d1495b; --c2: #2a9d6f; --c3: #b07d12; --c4: #8250c4; --good: #1a7f4b; --bad: #b3261e; --note: #8a6100; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e8ef; --dim: #9aa5b4; --line: #333b48; --page: #14181f;
  --card: #1b212b; --c0: #6fb1e8; --c1: #f08a97; --c2: #67cfa1; --c3: #e0b656; --c4: #b795ec; --good: #5fd39a; --bad: #ff8d85; --note: #e0b656; } }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--page); margin: 0 auto;
  max-width: 1060px; padding: 2rem 1rem; }
h1 { margin: 0 0 .3rem; } h2 { margin: 2.6rem 0 .2rem; font-size: 1.15rem; } p { margin: .3rem 0; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; } th, td { text-align: left; padding: .3rem .6rem;
  border-bottom: 1px solid var(--line); vertical-align: top; } td.n, th.n { text-align: right; white-space: nowrap;
  font-variant-numeric: tabular-nums; } .scroll { overflow-x: auto; } a { color: var(--c0); }
.met { color: var(--good); } .missed, .failed { color: var(--bad); } .shown { color: var(--dim); }
.dim { color: var(--dim); } .why { color: var(--note); } pre { white-space: pre-wrap; font-size: 12px; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(320px, 1fr)); gap: 1rem; margin: .8rem 0; }
figure { margin: 0; background: var(--card); border-radius: 8px; padding: .5rem; } svg { width: 100%; display: block; }
svg text { fill: var(--dim); font-size: 11px; } .grid { stroke: var(--line); } polyline { fill: none; stroke-width: 2; }
.l0 { stroke: var(--c0); } .l1 { stroke: var(--c1); } .l2 { stroke: var(--c2); } .l3 { stroke: var(--c3); }
.l4 { stroke: var(--c4); } .s0 { fill: var(--c0); } .s1 { fill: var(--c1); } .s2 { fill: var(--c2); }
.ring { fill: none; stroke-width: 1.3; } figcaption { display: flex; gap: 1rem; flex-wrap: wrap;
  font-size: 12px; color: var(--dim); padding: 0 .5rem; } figcaption i { display: inline-block; width: 16px; height: 3px;
  margin-right: 5px; vertical-align: middle; } .k0 { background: var(--c0); } .k1 { background: var(--c1); }
.k2 { background: var(--c2); } .k3 { background: var(--c3); } .k4 { background: var(--c4); }
figcaption i.points, figcaption i.rings { width: 8px; height: 8px; border-radius: 50%; }
"""


def percent(value: float | None) -> str:
    if value is None:
        return "–"
    if 0 < value < 1e-5:
        return f"{value:.1e}"
    return f"{100 * value:.2g} %" if value < 0.1 else f"{100 * value:.3g} %"


def _order(result: Result) -> str:
    order = result.order()
    return "–" if order is None else f"{order:.1f}"


def judged(comparison: Comparison) -> str:
    """The error, where anything is judged."""
    return percent(comparison.error()) if any(quantity.judged for quantity in comparison.quantities) else "–"


def _error(result: Result) -> str:
    return "did not run" if result.failure else judged(result.comparisons[-1])


def _verdict(result: Result) -> str:
    return result.verdict() + (" (known)" if result.case.known_miss and result.verdict() in ("missed", "failed") else "")


def _sizes(result: Result) -> str:
    return ", ".join(str(size) for size in result.sizes) + ("" if result.case.size_name == "triangles" else
                                                            f" {result.case.size_name}")


def _cells(result: Result) -> list[str]:
    return [result.case.title, result.case.source, result.case.compares, _sizes(result), _error(result),
            percent(result.bar), _verdict(result), _order(result)]


HEADS = ["Case", "Source", "Compared", "Triangles", "Error", "Bar", "Verdict", "Order"]


def summary(results: list[Result]) -> str:
    verdicts = [result.verdict() for result in results]
    return ", ".join(f"{verdicts.count(each)} {each}" for each in ("met", "missed", "failed", "shown"))


def markdown(results: list[Result]) -> str:
    lines = [f"# Validation: {summary(results)}", "", "| " + " | ".join(HEADS) + " |", "|" + " --- |" * len(HEADS)]
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in _cells(result)) + " |" for result in results]
    reasons = [f"- **{result.case.title}**: {result.case.known_miss}" for result in results
               if result.case.known_miss and result.verdict() != "met"]
    notes = [f"- **{result.case.title}**: {note}" for result in results if result.comparisons
             for note in result.comparisons[-1].notes]
    failures = [f"- **{result.case.title}**: {' '.join(result.failure.split())}" for result in results if result.failure]
    for title, items in (("Why bars are missed", reasons), ("What did not run", failures), ("Notes", notes)):
        if items:
            lines += ["", f"## {title}", "", *items]
    return "\n".join(lines) + "\n"


def _marks(label: str, quantity: Quantity, style: str) -> Series:
    """The model's values, at most 30 of them: more hide each other and the reference."""
    shown = np.unique(np.linspace(0, len(quantity.places) - 1, min(30, len(quantity.places))).round().astype(int))
    return Series(label, quantity.places[shown], quantity.model[shown], style)


def _quantity_plots(result: Result) -> str:
    """Each drawn quantity: reference, the finest size as dots, the coarser ones as rings."""
    plots = []
    sizes = list(zip(result.sizes, result.comparisons))
    for index, quantity in enumerate(result.comparisons[-1].quantities):
        if not quantity.drawn:
            continue
        places, values = quantity.curve if quantity.curve is not None else (quantity.places, quantity.reference)
        style = "line" if quantity.curve is not None or len(quantity.places) > 12 else "dashed"
        series = [Series(quantity.reference_name, np.asarray(places), np.asarray(values), style),
                  _marks(f"Thinwall, {sizes[-1][0]}", quantity, "points")]
        series += [_marks(str(size), comparison.quantities[index], "rings") for size, comparison in sizes[:-1]]
        plots.append(plot(series, quantity.along, f"{quantity.name}, {quantity.unit}" if quantity.unit else quantity.name))
    return "".join(plots)


def _convergence_plot(result: Result) -> str:
    errors = np.array(result.errors())
    if result.order() is None:
        return ""
    sizes = np.array(result.sizes[:len(errors)], dtype=float)
    edges = (sizes / sizes[0]) ** (-1 / result.case.size_dimension)
    series = [Series("error", edges, 100 * errors, "points"),
              Series("second order", edges, 100 * errors[0] * edges**2, "dashed")]
    if result.bar is not None:
        series.append(Series("bar", edges, np.full(len(edges), 100 * result.bar), "line"))
    return plot(series, "edge length or step, the coarsest being 1", "error, %", logarithmic=True)


def _section(result: Result) -> str:
    case = result.case
    parts = [f'<h2 id="{case.name}">{escape(case.title)} <span class="{result.verdict()}">{_verdict(result)}</span></h2>',
             f'<p class="dim">{escape(case.source)}. Compared: {escape(case.compares)}. '
             f"<code>scenes/validation/{case.scenario or case.name}.yaml</code></p>"]
    if case.known_miss and result.verdict() != "met":
        parts.append(f'<p class="why">{escape(case.known_miss)}</p>')
    if result.failure:
        parts.append(f'<pre class="failed">{escape(result.failure)}</pre>')
    if result.comparisons:
        parts += [f"<p>{escape(note)}</p>" for note in result.comparisons[-1].notes]
        parts.append(f'<div class="plots">{_quantity_plots(result)}{_convergence_plot(result)}</div>')
        rows = "".join(f'<tr><td class="n">{size}</td><td class="n">{judged(comparison)}</td><td>' + "; ".join(
            f"{escape(q.name)} {percent(q.error())}{'' if q.judged else ' (not judged)'}" for q in comparison.quantities)
            + "</td></tr>"
            for size, comparison in zip(result.sizes, result.comparisons))
        parts.append(f'<div class="scroll"><table><tr><th class="n">{escape(case.size_name)}</th><th class="n">error</th>'
                     f"<th>largest error of each quantity</th></tr>{rows}</table></div>")
    return f"<section>{''.join(parts)}</section>"


def page(results: list[Result], version: str) -> str:
    rows = "".join(
        f'<tr><td><a href="#{result.case.name}">{escape(cells[0])}</a></td><td>{escape(cells[1])}</td>'
        f"<td>{escape(cells[2])}</td><td>{escape(cells[3])}</td><td class=\"n\">{cells[4]}</td>"
        f'<td class="n">{cells[5]}</td><td class="{result.verdict()}">{cells[6]}</td><td class="n">{cells[7]}</td></tr>'
        for result, cells in ((result, _cells(result)) for result in results))
    heads = "".join(f'<th{" class=n" if head in ("Error", "Bar", "Order") else ""}>{head}</th>' for head in HEADS)
    return ("<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>Thinwall: validation</title>"
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head><body>'
            f"<h1>Validation</h1><p>{summary(results)}. The error is the largest of all compared values at the finest "
            f"mesh, nothing is extrapolated; of a quantity with a wider bar of its own, its part of that. Order: by the two finest, "
            "where more than tolerances is left. Sizes are the wanted numbers of triangles, which shapes meet within three per "
            f"cent. {escape(version)}.</p>"
            f'<div class="scroll"><table><tr>{heads}</tr>{rows}</table></div>'
            f"{''.join(_section(result) for result in results)}</body></html>\n")
