# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report as one HTML file that needs nothing else: text, pictures, interactive charts drawn by plotly.js."""

import base64
import gzip
import html
import json
import os

HERE = os.path.dirname(os.path.abspath(__file__))
# What the build has packed beside the scripts, then where Debian's python3-plotly has it.
LIBRARIES = (os.path.join(HERE, "..", "plotly.js.gz"), "/usr/share/python3-plotly/plotly.js")
MISSING = "interactive charts need plotly.js (apt install python3-plotly, then build anew)"

# Colours of Okabe and Ito; they hold on white and on black.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9", "#999999", "#B8860B"]
OUTCOMES = {"ricochet": "#0072B2", "perforate": "#D55E00", "edge": "#CC79A7", "pushed": "#009E73", "stuck": "#E69F00",
            "stable": "#009E73", "inaccurate": "#E69F00", "unstable": "#D55E00"}
GREY = "#888888"


def library():
    """plotly.js, compressed; None if it is not installed."""
    for path in LIBRARIES:
        try:
            with open(path, "rb") as file:
                data = file.read()
        except OSError:
            continue
        return data if path.endswith(".gz") else gzip.compress(data, 6, mtime=0)
    return None


def text(value):
    """Anything as harmless HTML."""
    return html.escape(str(value))


def number(value, digits=4):
    """For the eye; a dash if there is none."""
    if isinstance(value, bool) or value is None or value in ("", "-"):
        return "–" if value in (None, "", "-") else str(value)
    if not isinstance(value, (int, float)):
        return text(value)
    if isinstance(value, int) or float(value).is_integer() and abs(value) < 1e7:
        return f"{value:,.0f}".replace(",", " ").replace("-", "−")
    return f"{value:.{digits}g}".replace("-", "−")


UNITS = {"_m_s": "m/s", "_mm2": "mm²", "_mm": "mm", "_us": "µs", "_deg": "°", "_percent": "%", "_J": "J"}


def head(column):
    """The name of a column to be read: "exit speed [m/s]"."""
    for ending, unit in UNITS.items():
        if column.endswith(ending):
            return text(f"{column[:-len(ending)].replace('_', ' ')} [{unit}]")
    return text(column.replace("_", " "))


def chip(outcome):
    """An outcome as a coloured label."""
    return f'<span class="chip" style="--c:{OUTCOMES.get(outcome, GREY)}">{text(outcome)}</span>'


def table(heads, rows, kind=""):
    """Cells are HTML; a pair is what is shown and what is sorted by."""
    def cell(value, name):
        shown, key = value if isinstance(value, tuple) else (value, None)
        attribute = "" if key is None else f' data-key="{text(key)}"'
        return f"<{name}{attribute}>{shown}</{name}>"
    lines = ["".join(cell(head, "th") for head in heads)] if heads else []
    lines = [f"<thead><tr>{line}</tr></thead>" for line in lines]
    body = "".join("<tr>" + "".join(cell(value, "td") for value in row) + "</tr>" for row in rows)
    return f'<div class="scroll"><table class="{kind}">{"".join(lines)}<tbody>{body}</tbody></table></div>'


def cards(entries):
    """Key figures: name, value and a remark each."""
    return '<div class="cards">' + "".join(
        f'<div class="card"><div class="name">{text(name)}</div><div class="value">{value}</div>'
        f'<div class="remark">{text(remark)}</div></div>' for name, value, remark in entries) + "</div>"


def picture(directory, name, caption):
    """A PNG of the folder, embedded; nothing if it is not there."""
    try:
        with open(os.path.join(directory, name), "rb") as file:
            data = base64.b64encode(file.read()).decode()
    except OSError:
        return ""
    return (f'<figure><img alt="{text(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{text(caption)}</figcaption></figure>")


def section(title, content, intro=""):
    """A heading and what is below it; nothing if there is nothing."""
    if not content:
        return ""
    intro = f'<p class="intro">{text(intro)}</p>' if intro else ""
    return f"<section><h2>{text(title)}</h2>{intro}{content}</section>"


def folded(title, content):
    """To be opened."""
    return f"<details><summary>{text(title)}</summary>{content}</details>" if content else ""


def rounded(values):
    """Six digits are more than a screen shows."""
    return [None if value is None or value != value else float(f"{value:.6g}") for value in values]


def chart(title, traces, xaxis, yaxis, **options):
    """For section_of_charts(): traces and axes as plotly.js has them; kind "time" shares its x axis with the others."""
    return {"title": title, "traces": traces, "x": xaxis, "y": yaxis, **options}


def line(name, x, y, color, **options):
    """A curve."""
    return {"type": "scatter", "mode": "lines", "name": name, "x": rounded(x), "y": rounded(y),
            "line": {"color": color, "width": 2, **options.pop("line", {})}, **options}


def marks(name, points, **options):
    """Data of others over time, with error bars: full marks, and open ones where they are inferred."""
    return {"type": "scatter", "mode": "markers", "name": name, "x": [point["time_us"] for point in points],
            "y": [point["wanted"] for point in points],
            "text": [point.get("kind") or "" for point in points],
            "error_y": {"type": "data", "array": [point["error_bar"] or 0 for point in points], "thickness": 1.2, "color": "INK"},
            "marker": {"size": 9, "color": "INK", "symbol": [
                "circle-open" if point.get("kind") in ("inferred", "assumed") else "circle" for point in points]},
            **options}


def section_of_charts(charts, fallback, packed):
    """The charts; without a library the pictures that say the same."""
    if not packed:
        return section("Over time", fallback, "Plain: " + MISSING + ".")
    places = "".join(f'<div class="chart{" wide" if one.get("wide") else ""}"><h3>{text(one["title"])}</h3>'
                     f'<div class="plot" id="chart{i}"></div></div>' for i, one in enumerate(charts))
    data = json.dumps(charts, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")
    return section("Charts", f'<div class="charts">{places}</div><noscript>{fallback}</noscript>'
                             f'<script type="application/json" id="chart-data">{data}</script>',
                   "Drag to zoom, double-click to go back, click on a legend to hide a curve.")


def read(name):
    """A file beside this one."""
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return file.read()


def write_page(directory, title, body, packed):
    """report.html, whole or not at all."""
    parts = [f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{text(title)}</title>',
             '<meta name="viewport" content="width=device-width, initial-scale=1">',
             '<meta name="color-scheme" content="light dark">',
             f'<style>{read("report.css")}</style></head><body><main>{body}</main>']
    if packed:
        parts.append(f'<script type="text/plain" id="plotly">{base64.b64encode(packed).decode()}</script>')
    parts.append(f'<script>{read("report.js")}</script></body></html>\n')
    target = os.path.join(directory, "report.html")
    with open(target + ".tmp", "w", encoding="utf-8") as file:
        file.write("\n".join(parts))
    os.replace(target + ".tmp", target)
    return target
