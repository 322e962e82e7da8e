#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw accuracy.png from the comparison of a ricochet study with its reference: error of the path against cost.

    plot_accuracy.py STUDY_DIRECTORY

Reads comparison.csv and comparison_paths.csv of that folder. One panel per set of values of the axes; if there is only
one, the error over time stands beside it. Exit status: 0 drawn, 1 nothing to draw or a damaged file, 2 wrong use,
3 matplotlib not installed.
"""

import os
import sys

from plot_style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, STYLE, VERMILION
from plot_style import asks_for_help, fail, plain, plt, save
from read_table import read_csv

from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

# Marks tell the scenes too. The first is the reference's.
STYLES = [(BLACK, "s"), (BLUE, "o"), (VERMILION, "D"), (GREEN, "^"), (ORANGE, "v"), (PURPLE, "P"), (SKY, "X"),
          (GREY, "*")]
BAND = "#E4E4E4"
FRONT = "#9A9A9A"
LEAST = 0.04  # errors below this are no matter of interest [%]
WANTED = 2.0  # what a zone may add to the path of peridynamics throughout [%]
SHARES = {1: "1"} | {1 / share: f"1/{share}" for share in (2, 3, 5, 10, 20, 50, 100)}


def is_reference(row):
    """Whether the row is the one that the others are compared with."""
    return row["case"] == row["reference"]


def labels_of(rows):
    """What tells the titles of the scenes apart, by scene, and what they share."""
    titles = {}
    for row in rows:
        if row["title"] != "-":
            titles.setdefault(row["scene"], row["title"])
    if len(titles) < 2 or len(set(titles.values())) < len(titles):
        return {row["scene"]: row["scene"].replace("_", " ") for row in rows}, ""
    shared = os.path.commonprefix(list(titles.values()))
    shared = shared[:shared.rfind(", ") + 2] if ", " in shared else ""
    labels = {row["scene"]: titles.get(row["scene"], row["scene"])[len(shared) if row["scene"] in titles else 0:]
              for row in rows}
    return {scene: plain(label) for scene, label in labels.items()}, plain(shared.rstrip(", "))


def styles_of(rows):
    """Colour and mark by scene, the reference first."""
    scenes = list(dict.fromkeys(row["scene"] for row in sorted(rows, key=lambda row: not is_reference(row))))
    return {scene: STYLES[i % len(STYLES)] for i, scene in enumerate(scenes)}


def percent_text(value, _=None):
    """An error for the eye: two digits."""
    return f"{value:.0f}" if value >= 10 else f"{value:.2g}"


def error_limits(rows, paths):
    """Ends of the axis of errors [%], which hold everything that is drawn."""
    values = [WANTED]
    for row in rows + paths:
        for name in ("path_error_percent", "path_error_high_percent", "reference_scatter_percent"):
            value = row.number(name)
            if value is not None and value > LEAST:
                values.append(value)
    return max(LEAST, 0.6 * min(values)), 1.6 * max(values)


def set_error_axis(axes, limits):
    """A logarithmic axis with plain numbers."""
    axes.set_yscale("log")
    axes.set_ylim(limits)
    ticks = [digit * 10.0**power for power in range(-2, 4) for digit in (1, 2, 5)]
    axes.yaxis.set_major_locator(FixedLocator([tick for tick in ticks if limits[0] <= tick <= limits[1]]))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(percent_text))
    axes.grid(axis="y", color="#EFEFEF", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.axhline(WANTED, color="#555555", linewidth=0.9, linestyle=(0, (5, 3)), zorder=1.5)


def cost_limits(rows):
    """Ends of the axis of costs [s]."""
    values = [row.number(name) for row in rows for name in ("core_seconds_low", "core_seconds_high")]
    values = [value for value in values if value]
    return 0.75 * min(values), 1.3 * max(values)


def draw_cost(axes, rows, styles, limits, costs):
    """Error against cost of one set of the axes' values: marks are mean position and median cost, bars single runs."""
    set_error_axis(axes, limits)
    axes.set_xscale("log")
    axes.set_xlim(costs)
    ticks = [digit * 10.0**power for power in range(-3, 7) for digit in (1, 2, 5)]
    axes.xaxis.set_major_locator(FixedLocator([tick for tick in ticks if costs[0] <= tick <= costs[1]]))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    # The reference itself may reach a later time than any of the others.
    compared = [row for row in rows if not is_reference(row) and row.number("reference_scatter_percent") is not None]
    if compared:
        latest = max(compared, key=lambda row: row.number("compared_at_us"))
        axes.axhspan(limits[0], latest.number("reference_scatter_percent"), color=BAND, linewidth=0, zorder=0)
    draw_front(axes, rows, limits, costs)
    for row in rows:
        color, mark = styles[row["scene"]]
        cost = row.number("core_seconds")
        if cost is None or (row.number("path_error_percent") is None and not is_reference(row)):
            continue
        # The reference has no error; it stands on the floor.
        error = limits[0] if is_reference(row) else max(limits[0], row.number("path_error_percent"))
        axes.plot([row.number("core_seconds_low"), row.number("core_seconds_high")], [error, error], color=color,
                  linewidth=1, zorder=3, clip_on=False)
        if not is_reference(row):
            low, high = row.number("path_error_low_percent"), row.number("path_error_high_percent")
            axes.plot([cost, cost], [max(limits[0], low), high], color=color, linewidth=1, zorder=3)
        axes.plot([cost], [error], mark, color=color, markersize=7, markeredgecolor="white", markeredgewidth=0.8,
                  zorder=4, clip_on=False)
        if is_reference(row):
            shares = axes.secondary_xaxis("top", functions=(lambda x, whole=cost: x / whole,
                                                            lambda x, whole=cost: x * whole))
            shown = [share for share in SHARES if costs[0] <= share * cost <= costs[1]]
            # Names that would stand on one another are left out, except for those of whole, third and fifth.
            if costs[1] / costs[0] > 8:
                shown = [share for share in shown if share != 1 / 2]
            shares.xaxis.set_major_locator(FixedLocator(shown))
            shares.xaxis.set_minor_locator(NullLocator())
            shares.xaxis.set_major_formatter(FuncFormatter(
                lambda value, _: SHARES[min(SHARES, key=lambda share: abs(share - value))]))
            shares.tick_params(length=3, width=0.7, labelsize=8, pad=1)
            shares.spines["top"].set_visible(True)
            for share in shown:
                axes.axvline(share * cost, color="#D5D5D5", linewidth=0.6, linestyle=":", zorder=0.5)


def front_of(rows):
    """Those than which none is both cheaper and better, from the cheapest: cost and error."""
    points = sorted((row.number("core_seconds"), row.number("path_error_percent")) for row in rows if not is_reference(row)
                    and row.number("core_seconds") is not None and row.number("path_error_percent") is not None)
    front = []
    for cost, error in points:
        if not front or error < front[-1][1]:
            front.append((cost, error))
    return front


def draw_front(axes, rows, limits, costs):
    """The Pareto front as steps: what is above and to the right of it costs more for no better a result."""
    front = front_of(rows)
    if len(front) < 2:
        return
    x = [front[0][0]] + [cost for cost, _ in front] + [costs[1]]
    y = [limits[1]] + [max(limits[0], error) for _, error in front] + [max(limits[0], front[-1][1])]
    axes.step(x, y, where="post", color=FRONT, linewidth=1.1, zorder=1.6)


def draw_time(axes, rows, paths, styles, limits):
    """Errors over the stated times."""
    set_error_axis(axes, limits)
    for row in rows:
        line = [path for path in paths if path["case"] == row["case"]]
        times = [path.number("stated_us") for path in line]
        if is_reference(row):
            scatter = [path.number("reference_scatter_percent") for path in line]
            if None not in scatter:
                axes.fill_between(times, limits[0], scatter, color=BAND, linewidth=0, zorder=0)
            continue
        color, mark = styles[row["scene"]]
        axes.plot(times, [path.number("path_error_percent") for path in line], color=color, marker=mark,
                  markersize=5, markeredgecolor="white", markeredgewidth=0.6)
    axes.set_xlabel("time [µs]", labelpad=2)
    axes.xaxis.set_major_locator(MaxNLocator(6))
    axes.tick_params(labelleft=False)


def legend_of(rows, labels, styles, numbers):
    """Handles and texts: the scenes, with their numbers if there is one set of them, then band and line."""
    handles, texts = [], []
    for scene in styles:
        row = next(row for row in rows if row["scene"] == scene)
        color, mark = styles[scene]
        text = labels[scene]
        if is_reference(row):
            text += " (reference: no error by definition)" if numbers else " (reference)"
        elif numbers and row.number("path_error_percent") is not None:
            text += (f": {percent_text(row.number('path_error_percent'))} % at {row.number('compared_at_us'):.0f} µs, "
                     f"{row.number('cost_ratio'):.2f} of the cost")
        elif numbers:
            text += ": not compared"
        handles.append(Line2D([], [], color=color, marker=mark, linestyle="", markersize=6.5, markeredgecolor="white"))
        texts.append(text)
    most = max(int(row.number("runs") or 0) for row in rows)
    if most > 1:
        handles.append(Line2D([], [], color="#555555", linewidth=1))
        texts.append(f"from the best to the worst of {most} single runs")
    if any(len(front_of([row for row in rows if row["group"] == group])) > 1 for group in {row["group"] for row in rows}):
        handles.append(Line2D([], [], color=FRONT, linewidth=1.1))
        texts.append("Pareto front: none is both cheaper and better")
    handles += [Patch(color=BAND), Line2D([], [], color="#555555", linewidth=0.9, linestyle=(0, (5, 3)))]
    texts += ["where single runs of the reference lie themselves", f"{WANTED:g} %"]
    return handles, texts


def draw(directory):
    """accuracy.png, or None if nothing has been compared."""
    rows, paths = (read_csv(os.path.join(directory, name)) for name in ("comparison.csv", "comparison_paths.csv"))
    if not any(row.number("path_error_percent") is not None and not is_reference(row) for row in rows):
        return None
    styles = styles_of(rows)
    labels, shared = labels_of(rows)
    groups = list(dict.fromkeys(row["group"] for row in rows))
    limits, costs = error_limits(rows, paths if len(groups) == 1 else []), cost_limits(rows)
    n_columns = 3 if len(groups) % 3 == 0 and len(groups) % 2 else 2
    n_rows = max(1, -(-len(groups) // n_columns))
    legend_columns = 2 if n_columns == 2 else 3
    legend_height = 0.19 * -(-(4 + len(styles)) // legend_columns)
    width, panel, top = (8.2, 3.3, 0.78) if n_columns == 2 else (9.6, 2.5, 0.78)
    if len(groups) > 1:
        top, panel = top + 0.15, 2.5
    left, bottom, gap_x, gap_y = 0.62, 0.5, 0.2, 0.95
    height = top + n_rows * panel + (n_rows - 1) * gap_y + bottom + legend_height + 0.12
    figure = plt.figure(figsize=(width, height))
    title = os.path.basename(os.path.abspath(directory)).replace("_", " ") if len(groups) > 1 or not shared else shared
    figure.text(0.12 / width, 1 - 0.1 / height, f"{title}: error of the path against cost", size=11, weight="bold",
                va="top")
    panel_width = (width - left - 0.15 - (n_columns - 1) * gap_x) / n_columns

    def place(index):
        line, column = divmod(index, n_columns)
        x = left + column * (panel_width + gap_x)
        y = height - top - (line + 1) * panel - line * gap_y
        return figure.add_axes([x / width, y / height, panel_width / width, panel / height])

    for i, group in enumerate(groups):
        axes = place(i)
        chosen = [row for row in rows if row["group"] == group]
        draw_cost(axes, chosen, styles, limits, costs)
        axes.set_xlabel("core-seconds of a run", labelpad=2)
        axes.text(0, 1 + 0.17 / panel, "cost as a share of the reference's", transform=axes.transAxes, size=8,
                  color="#555555", va="bottom")
        if group:
            axes.text(0, 1 + 0.34 / panel, group, transform=axes.transAxes, size=9,
                      weight="bold", va="bottom")
        if i % n_columns == 0:
            axes.set_ylabel("error of the path [%]", labelpad=2)
        else:
            axes.tick_params(labelleft=False)
    if len(groups) == 1:
        axes = place(1)
        draw_time(axes, rows, paths, styles, limits)
        axes.text(0, 1 + 0.17 / panel, "over the time of flight", transform=axes.transAxes, size=8, color="#555555",
                  va="bottom")
    handles, texts = legend_of(rows, labels, styles, len(groups) == 1)
    figure.legend(handles, texts, loc="lower left", bbox_to_anchor=((left - 0.1) / width, 0.08 / height),
                  ncol=legend_columns, columnspacing=2.5, borderaxespad=0, handlelength=2, labelspacing=0.35)
    target = os.path.join(directory, "accuracy.png")
    save(figure, target)
    return target


def main(arguments):
    """Draw what there is."""
    status = asks_for_help(arguments, 1, __doc__)
    if status is not None:
        return status
    plt.rcParams.update(STYLE)
    try:
        target = draw(arguments[1])
    except (OSError, ValueError, KeyError) as error:
        return fail(f"{arguments[1]}: {error}")
    if target is None:
        return fail(f"{arguments[1]}: no run could be compared with the reference")
    print("Picture: " + target)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
