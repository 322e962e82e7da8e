# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw map.png, outcomes and exit speeds over two axes of a study, and residual.png, exit speed over impact speed."""

import os

from plot_style import GREY, OUTCOMES, close_box, plain, plt, save
from ricochet_results import Study

from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

UNDECIDED = "#D9D9D9"
MISSING = "#FFFFFF"
SPEED = "speed"  # the label of the axis Impact/Speed


def axes_of_numbers(study):
    """Axes with two different numbers or more; the one of a limit's search is not among them."""
    searched = {limit["axis"] for limit in study.limits}
    return [axis for i, axis in enumerate(study.axes) if axis["is_number"] and i not in searched
            and len({case.axes[axis["name"]] for case in study if case.axes[axis["name"]] is not None}) > 1]


def name_of(axis):
    """With its unit."""
    return axis["label"] + (f" [{axis['unit']}]" if axis["unit"] else "")


def outcome_of(case):
    """As its summary says; nothing without one."""
    return case.run.summary.get("outcome", "")


def others(study, case, names):
    """What a case has besides these axes, to be read."""
    parts = []
    if len({one.scene for one in study}) > 1:
        parts.append(case.scene.replace("_", " "))
    for axis in study.axes:
        if axis["name"] not in names:
            value = case.axes[axis["name"]]
            shown = f"{value:g}" if isinstance(value, (int, float)) else str(value)
            parts.append(f"{shown} {axis['unit']}" if axis["unit"] else f"{axis['label']} {shown}")
    return ", ".join(parts)


def groups_of(study, names):
    """The cases by what they have besides these axes, in their order."""
    groups = {}
    for case in study:
        groups.setdefault(others(study, case, names), []).append(case)
    return groups


def draw_cell(axes, i, j, case):
    """One field: the colour by the outcome, the number the exit speed."""
    outcome = outcome_of(case) if case else ""
    style = {"facecolor": OUTCOMES.get(outcome, UNDECIDED if outcome else MISSING), "edgecolor": "white", "linewidth": 1.5}
    if outcome == "undecided":
        style.update(hatch="////", edgecolor="#8A8A8A", linewidth=0.5)
    axes.add_patch(Rectangle((i - 0.5, j - 0.5), 1, 1, **style))
    speed = case.run.summary.get("exit_speed_m_s") if case else None
    if not outcome:
        text = "–" if case is None else "failed" if case.status.startswith("failed") else "not run"
    else:
        text = "" if speed is None or outcome == "stuck" else f"{speed:.0f}"
    dark = outcome in OUTCOMES and outcome != "stuck"
    axes.text(i, j, text, ha="center", va="center", size=8, color="white" if dark else "#333333",
              bbox={"facecolor": UNDECIDED, "edgecolor": "none", "pad": 1} if outcome == "undecided" and text else None)


def draw_map(study):
    """map.png, or None without two axes of numbers."""
    found = axes_of_numbers(study)
    if len(found) < 2 or not any(outcome_of(case) for case in study):
        return None
    x, y = found[0], found[1]
    names = {x["name"], y["name"]}
    groups = groups_of(study, names)
    columns, rows = (sorted({case.axes[axis["name"]] for case in study if case.axes[axis["name"]] is not None})
                     for axis in (x, y))
    n_columns = min(len(groups), 2)
    n_rows = -(-len(groups) // n_columns)
    width, height = max(2.6, 0.62 * len(columns)), max(1.2, 0.42 * len(rows))
    figure, panels = plt.subplots(n_rows, n_columns, squeeze=False, layout="constrained",
                                  figsize=(max(4.6, n_columns * (width + 0.7)), n_rows * (height + 0.75) + 1.0))
    for panel in list(panels.flat)[len(groups):]:
        panel.remove()
    for panel, (title, cases) in zip(panels.flat, groups.items()):
        by_place = {(case.axes[x["name"]], case.axes[y["name"]]): case for case in cases}
        for i, one in enumerate(columns):
            for j, other in enumerate(rows):
                draw_cell(panel, i, j, by_place.get((one, other)))
        panel.set_xlim(-0.5, len(columns) - 0.5)
        panel.set_ylim(-0.5, len(rows) - 0.5)
        panel.set_xticks(range(len(columns)), [f"{value:g}" for value in columns])
        panel.set_yticks(range(len(rows)), [f"{value:g}" for value in rows])
        panel.tick_params(length=0)
        panel.set_xlabel(name_of(x))
        panel.set_ylabel(name_of(y))
        panel.set_title(plain(title), loc="left")
        close_box(panel)
    seen = list(dict.fromkeys(outcome_of(case) for case in study if outcome_of(case)))
    handles = [Patch(facecolor=OUTCOMES.get(outcome, UNDECIDED), label=outcome,
                     **({"hatch": "////", "edgecolor": "#8A8A8A"} if outcome == "undecided" else {})) for outcome in seen]
    tall = figure.get_size_inches()[1]
    figure.legend(handles=handles, loc="lower center", ncol=len(handles), columnspacing=1.2, handlelength=1.4)
    figure.get_layout_engine().set(rect=(0, 0.3 / tall, 1, 1 - 0.8 / tall))
    figure.text(0.01, 1 - 0.08 / tall, plain(study.record.get("title", "")), size=11, weight="bold", va="top")
    figure.text(0.01, 1 - 0.30 / tall, "colour: outcome; number: exit speed in m/s", size=8, color="#444444", va="top")
    target = os.path.join(study.directory, "map.png")
    save(figure, target)
    return target


def draw_bracket(axes, limit, color):
    """The band in which a limit lies."""
    axes.axvspan(limit["low"], limit["high"], color=color, alpha=0.25, linewidth=0, zorder=0,
                 label=f"limit {(limit['low'] + limit['high']) / 2:.4g} ± {(limit['high'] - limit['low']) / 2:.2g}")


def draw_residual(study):
    """residual.png, or None without an axis of impact speeds."""
    axis = next((axis for axis in study.axes if axis["label"] == SPEED and axis["is_number"]), None)
    groups = groups_of(study, {axis["name"]}) if axis else {}
    curves = {}
    for title, cases in groups.items():
        points = [(case.axes[axis["name"]], case.run.summary.get("exit_speed_m_s"), outcome_of(case)) for case in cases]
        points = sorted(point for point in points if None not in point[:2] and point[2])
        if len(points) > 1:
            curves[title] = points
    if not curves:
        return None
    colors = [GREY, "#444444", "#A0A0A0", "#6B8E23", "#8B4513", "#483D8B", "#2F4F4F", "#B8860B"]
    dashes = ["-", "--", "-.", ":"]
    figure, panel = plt.subplots(figsize=(6.6, 4.0), layout="constrained")
    for i, (title, points) in enumerate(curves.items()):
        style = {"color": colors[i % len(colors)], "linestyle": dashes[i % len(dashes)]}
        panel.plot([point[0] for point in points], [point[1] for point in points], linewidth=1.2, zorder=2,
                   label=plain(title) or "exit speed", **style)
        for speed, left, outcome in points:
            panel.plot([speed], [left], "o", markersize=6, zorder=3, color=OUTCOMES.get(outcome, UNDECIDED),
                       markeredgecolor="#555555" if outcome == "undecided" else "white", markeredgewidth=0.8)
        for limit in study.limits:
            if limit["is_found"] and limit["case"] in {case.name for case in groups[title]}:
                draw_bracket(panel, limit, style["color"])
    if axis["unit"] == "m/s":
        top = max(point[0] for points in curves.values() for point in points)
        panel.plot([0, top], [0, top], color="#BBBBBB", linewidth=0.8, linestyle=(0, (5, 3)), zorder=1)
        low = min(point[0] for points in curves.values() for point in points)
        panel.set_xlim(low - 0.04 * (top - low), top + 0.04 * (top - low))
    panel.set_ylim(bottom=0)
    panel.set_xlabel("impact " + name_of(axis))
    panel.set_ylabel("exit speed [m/s]")
    panel.grid(color="#E3E3E3", linewidth=0.6)
    panel.set_axisbelow(True)
    outcomes = dict.fromkeys(point[2] for points in curves.values() for point in points)
    handles, _ = panel.get_legend_handles_labels()
    handles += [Line2D([], [], marker="o", linestyle="", color=OUTCOMES.get(outcome, UNDECIDED), label=outcome)
                for outcome in outcomes]
    if axis["unit"] == "m/s":
        handles.append(Line2D([], [], color="#BBBBBB", linestyle=(0, (5, 3)), linewidth=0.8, label="nothing lost"))
    panel.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0)
    figure.suptitle(plain(study.record.get("title", "")), size=11, weight="bold", x=0.01, ha="left")
    target = os.path.join(study.directory, "residual.png")
    save(figure, target)
    return target


def draw_maps(directory):
    """What there is of both."""
    study = Study(directory)
    return [target for target in (draw_map(study), draw_residual(study)) if target]
