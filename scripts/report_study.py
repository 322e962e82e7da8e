# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the report of a study says: outcomes of all cases, charts over the axes, the table, pictures, origin."""

import collections
import glob
import os

from report_data import columns_of_data, read_columns, read_json, read_text
from report_page import COLORS, GREY, OUTCOMES, chart, chip, folded, head, line, marks, number, picture, section
from report_page import section_of_charts, table, text
from read_table import read_csv

DASHES = ["solid", "dash", "dot", "dashdot"]


class Case:
    """One run: what study.json says of it and what it has left."""

    def __init__(self, directory, record, number_of_case):
        folder = os.path.join(directory, record["name"])
        self.name, self.label, self.axes = record["name"], record["label"], record["axes"]
        self.status = record["status"]
        self.summary = read_json(folder, "summary.json")
        self.history, self.units = read_columns(folder)
        self.outcome = self.summary.get("outcome") or self.summary.get("verdict")
        self.has_report = os.path.exists(os.path.join(folder, "report.html"))
        self.style = {"color": COLORS[number_of_case % len(COLORS)],
                      "line": {"dash": DASHES[number_of_case // len(COLORS) % len(DASHES)], "width": 1.8}}

    def trace(self, x, y, **options):
        """A curve in the case's own style."""
        return line(self.label, self.history[x], self.history[y], self.style["color"], line=self.style["line"], **options)


def verdict(cases):
    """How the cases have ended."""
    counts = collections.Counter(case.outcome for case in cases if case.outcome)
    text_of_counts = " ".join(f"{count} × {chip(outcome)}" for outcome, count in counts.most_common())
    n_open = sum(1 for case in cases if not case.outcome)
    rest = f" {n_open} of {len(cases)} without result" if n_open else ""
    return f'<p class="verdict">{len(cases)} cases: {text_of_counts}{rest}</p>'


def warnings(cases):
    """Cases that failed, with their reasons, and what runs have warned of."""
    told = [f"{case.label}: {case.status}" for case in cases if case.status.startswith("failed")]
    told += [f"{case.label}: {one}" for case in cases for one in case.summary.get("warnings") or []]
    if not told:
        return ""
    return '<div class="warnings"><strong>Warnings</strong><ul>' + "".join(
        f"<li>{text(one)}</li>" for one in told) + "</ul></div>"


def numeric_axes(study, cases):
    """Numbers of the axes that have at least two different numbers."""
    return [i for i, axis in enumerate(study["axes"])
            if axis["is_number"] and len({case.axes[i] for case in cases if case.axes[i] is not None}) > 1]


def name_of(axis):
    """With its unit."""
    return axis["label"] + (f" [{axis['unit']}]" if axis["unit"] else "")


def outcome_map(study, cases, axes):
    """Outcome over two axes: colour, and exit speed as a number."""
    i, j = axes[:2]
    traces = []
    for outcome in dict.fromkeys(case.outcome for case in cases if case.outcome):
        some = [case for case in cases if case.outcome == outcome and case.axes[i] is not None]
        traces.append({"type": "scatter", "mode": "markers+text", "name": outcome,
                       "x": [case.axes[i] for case in some], "y": [case.axes[j] for case in some],
                       "text": [number(case.summary.get("exit_speed_m_s"), 3) for case in some],
                       "hovertext": [case.label for case in some], "hoverinfo": "text+name",
                       "textfont": {"color": "#ffffff", "size": 11},
                       "marker": {"symbol": "square", "size": 38, "color": OUTCOMES.get(outcome, GREY)}})
    return chart("Outcome, and exit speed in m/s", traces, {"title": name_of(study["axes"][i])},
                 {"title": name_of(study["axes"][j])}, hover="closest", wide=True)


def over_axis(study, cases, axis):
    """Exit speed over one axis, a line for every set of values of the others, the mark by the outcome."""
    groups = {}
    for case in cases:
        value = case.summary.get("exit_speed_m_s")
        if value is not None and case.axes[axis] is not None:
            others = tuple(f"{number(v)} {study['axes'][k]['unit']}".strip() if isinstance(v, (int, float)) else str(v)
                           for k, v in enumerate(case.axes) if k != axis)
            scene = (case.name.split("__")[0].replace("_", " "),) if several_scenes(cases) else ()
            groups.setdefault(scene + others, []).append((case.axes[axis], value, case))
    traces = []
    for i, (others, rows) in enumerate(groups.items()):
        rows.sort(key=lambda row: row[0])
        traces.append({"type": "scatter", "mode": "lines+markers", "name": ", ".join(others) or "exit speed",
                       "x": [row[0] for row in rows], "y": [row[1] for row in rows],
                       "text": [row[2].outcome for row in rows], "line": {"color": COLORS[i % len(COLORS)], "width": 1.5},
                       "hovertemplate": "%{y:.0f} m/s, %{text}",
                       "marker": {"size": 10, "color": [OUTCOMES.get(row[2].outcome, GREY) for row in rows]}})
    return chart("Exit speed; marks by outcome", traces, {"title": name_of(study["axes"][axis])},
                 {"title": "exit speed [m/s]"})


def several_scenes(cases):
    """Whether the cases have more than one scene."""
    return len({case.name.split("__")[0] for case in cases}) > 1


def charts(study, cases):
    """All diagrams of the study."""
    flown = [case for case in cases if case.history.get("time")]
    axes, made = numeric_axes(study, cases), []
    with_speed = any(case.summary.get("exit_speed_m_s") is not None for case in cases)
    if len(axes) >= 2 and with_speed:
        made.append(outcome_map(study, cases, axes))
    made += [over_axis(study, cases, axis) for axis in axes[:4]] if with_speed else []
    if not flown:
        return made
    made.append(chart("Paths of the centroid", [
        case.trace("x", "z", hovertemplate="x %{x:.1f} mm, z %{y:.1f} mm") for case in flown], {"title": "x [mm]"},
        {"title": "z [mm]", "scaleanchor": "x"}, hover="closest", wide=True, side=True))
    data = {column["name"]: column for case in flown for column in columns_of_data(case.summary)}
    for name, title, unit in [("speed", "Speed", "m/s")] + [
            (name, name.capitalize(), column["unit"]) for name, column in data.items() if name != "speed"]:
        traces = [case.trace("time", name) for case in flown if name in case.history]
        if name in data:
            traces.append(marks("of others", data[name]["points"]))
        made.append(chart(title, traces, {"title": "time [µs]"}, {"title": f"{name} [{unit}]"}, kind="time", hover="closest",
                          wide=True, side=True))
    return made


def cases_table(directory, study, cases):
    """study.csv, to be sorted; every case links to its own report where that lies beside this one."""
    rows, by_name = [], {case.name: case for case in cases}
    written = read_csv(os.path.join(directory, "study.csv"))
    columns = [name for name in (written[0] if written else {}) if name != "case"]
    for row in written:
        case = by_name.get(row["case"])
        label = text(case.label if case else row["case"])
        cells = [f'<a href="{text(case.name)}/report.html">{label}</a>' if case and case.has_report else label]
        for name in columns:
            value = row[name]
            try:
                cells.append((number(float(value)), value))
            except ValueError:
                cells.append(chip(value) if name in ("outcome", "verdict") and value != "-" else text(value[:80]))
        rows.append(cells)
    axes = {axis["name"]: text(name_of(axis)) for axis in study["axes"]}
    heads = ["case"] + [axes.get(name) or head(name) for name in columns]
    return table(heads, rows, "sortable") if rows else ""


def plain(value):
    """A cell of a CSV file."""
    try:
        return number(float(value)), value
    except ValueError:
        return text(value)


def plain_table(directory, name):
    """Any other CSV file of the study."""
    path = os.path.join(directory, name)
    written = read_csv(path) if os.path.exists(path) else []
    if not written:
        return ""
    return table([head(name) for name in written[0]], [[plain(row[name]) for name in row] for row in written], "sortable")


def pictures(directory):
    """All that are there."""
    pages = sorted(glob.glob(os.path.join(directory, "comparison*.png")),
                   key=lambda path: (len(os.path.basename(path)), path))
    return "".join([picture(directory, "map.png", "Map: outcome, and exit speed in m/s"),
                    picture(directory, "residual.png", "Exit speed over impact speed"),
                    picture(directory, "accuracy.png", "Accuracy against cost"),
                    *(picture(directory, os.path.basename(page), "Paths and sections of the cases") for page in pages)])


def limits(study):
    """What a search has found, with its bracket."""
    rows = [[text(one["group"] or "all"),
             f"{number((one['low'] + one['high']) / 2)} ± {number((one['high'] - one['low']) / 2, 2)} {text(one['unit'])}"
             if one["is_found"] else text(one["status"]),
             f"{chip(one['low_outcome'])} at {number(one['low'])}, {chip(one['high_outcome'])} at {number(one['high'])} "
             f"{text(one['unit'])}", number(one["runs"])] for one in study.get("limits", [])]
    label = text(study["limits"][0]["label"]) if rows else ""
    return table(["", label, "bracket", "runs"], rows, "words") if rows else ""


def convergence(directory):
    """Pictures and tables of a study of convergence."""
    return "".join([picture(directory, "convergence.png", "Errors against the reference, and observed orders"),
                    picture(directory, "convergence_damage.png", "Damage on all grids at the same times"),
                    plain_table(directory, "convergence_orders.csv"), plain_table(directory, "convergence.csv")])


def sentences(directory):
    """What comparison.txt says."""
    lines = [line for line in read_text(os.path.join(directory, "comparison.txt")).splitlines() if line]
    return "<ul>" + "".join(f"<li>{text(line)}</li>" for line in lines) + "</ul>" if lines else ""


def page(directory, packed):
    """Title and body."""
    study = read_json(directory, "study.json")
    cases = [Case(directory, record, i) for i, record in enumerate(study.get("cases", []))]
    title = study.get("title") or os.path.basename(os.path.abspath(directory))
    used = read_text(study.get("file", ""))
    rows = [["version", text(study.get("version", "unknown"))],
            ["command", f"<code>{text(study.get('command') or 'not recorded')}</code>"],
            ["study", text(study.get("file", ""))]]
    body = [f"<header><h1>{text(title)}</h1>{verdict(cases)}"
            f'<p class="origin">ricochet {text(study.get("version", ""))}</p></header>', warnings(cases),
            section("Cases", cases_table(directory, study, cases), "Click on a head to sort."),
            section_of_charts(charts(study, cases), picture(directory, "reference.png", "Against data of others"), packed),
            section("Limits", limits(study), "Found by bisection: every step is a case above."),
            section("Convergence", convergence(directory)),
            section("Comparison with the reference", sentences(directory) + plain_table(directory, "comparison.csv")),
            section("Pictures", pictures(directory)),
            section("How it was made", table([], rows, "words") + folded(
                "The study's file", f"<pre>{text(used)}</pre>" if used else ""))]
    return title, "".join(body)
