# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw reference.png: the history of one or several runs against somebody else's data, a diagram per column."""

import os

# First, because they say what to install if it is missing.
from plot_style import BLACK, GREY, plt, save, ticks, write_title
from ricochet_results import read_summary

SYMBOLS = {"us": "µs", "deg": "°", "-": "–"}


def columns_of(summary):
    """What the summary compares, column by column; empty without data."""
    return ((summary or {}).get("reference_data") or {}).get("columns", [])


def draw_points(axes, points, color=BLACK):
    """Marks with error bars: full for what is published or measured, open for what is inferred or assumed."""
    for point in points:
        is_open = point.get("kind") in ("inferred", "assumed")
        axes.errorbar([point["time_us"]], [point["wanted"]], yerr=point["error_bar"], fmt="o", color=color,
                      markerfacecolor="white" if is_open else color, markersize=4.5, linewidth=0.9, capsize=2.5,
                      zorder=6)


def overlay(axes, directory, names):
    """The data of those columns in a diagram over time."""
    for column in columns_of(read_summary(directory)):
        if column["name"] in names:
            draw_points(axes, column["points"])


def text_of(column):
    """Errors in one line."""
    errors = [point["relative_error"] for point in column["points"] if point["relative_error"] is not None]
    text = "relative error " + ", ".join(f"{100 * error:+.1f}" for error in errors).replace("-", "−") + " %"
    text = text if 0 < len(errors) <= 6 else ""
    if column["rmse"] is not None:
        text += ("; " if text else "") + f"root-mean-square {column['rmse']:.3g} {column['unit']}"
    return text or "not reached"


def draw_reference(directory, runs, title, subtitle):
    """runs: history, summary, label, colour and dashes of each. None if none of them has data."""
    compared = [run for run in runs if columns_of(run[1]) and run[0] is not None and len(run[0]) > 1]
    if not compared:
        return None
    columns = columns_of(compared[0][1])
    n_columns = min(2, len(columns))
    n_rows = -(-len(columns) // n_columns)
    n_lines = -(-len(compared) // 2) if len(compared) > 1 else 0
    height = 0.95 + 2.6 * n_rows + 0.2 * n_lines
    figure, all_axes = plt.subplots(n_rows, n_columns, figsize=(4.3 * n_columns + 0.4, height), squeeze=False)
    figure.subplots_adjust(left=0.75 / (4.3 * n_columns), right=0.975, top=1 - 0.85 / height,
                           bottom=(0.5 + 0.2 * n_lines) / height, wspace=0.25, hspace=0.5)
    write_title(figure, title, subtitle)
    for axes, column in zip(all_axes.flat, columns):
        for history, summary, label, color, dashes in compared:
            axes.plot(history["time"], history[column["name"]], color=color, linestyle=dashes, label=label)
        draw_points(axes, column["points"])
        if len(compared) == 1:
            axes.set_title(text_of(column), loc="left", size=8, color="#444444", pad=4)
        axes.set_xlabel("time [µs]", labelpad=2)
        axes.set_ylabel(f"{column['name']} [{SYMBOLS.get(column['unit'], column['unit'])}]")
        axes.margins(x=0.02)
        axes.xaxis.set_major_locator(ticks(6))
        axes.yaxis.set_major_locator(ticks(6))
        axes.grid(color="#E3E3E3", linewidth=0.6)
        axes.set_axisbelow(True)
    for axes in all_axes.flat[len(columns):]:
        axes.set_visible(False)
    if len(compared) > 1:
        handles, labels = all_axes.flat[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="lower left", ncol=2, bbox_to_anchor=(0.02, 0.0))
    figure.text(0.985, 1 - 0.14 / height, "● published or measured   ○ inferred", ha="right", va="top", size=8,
                color=GREY)
    target = os.path.join(directory, "reference.png")
    save(figure, target)
    return target
