#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw seconds over points from the rows of `ricochet bench search --json`.

    plot_search.py ROWS.jsonl PICTURE.png

ROWS.jsonl has one JSON object per line. One panel per arrangement; colours tell the methods, filled marks and solid
lines one process, open marks and broken lines several. Exit status: 0 drawn, 1 nothing to draw or a damaged file,
2 wrong use, 3 matplotlib not installed.
"""

import sys

from plot_style import BLACK, BLUE, GREY, ORANGE, STYLE, VERMILION, asks_for_help, fail, plt, save
from read_table import read_json_lines

# Marks tell the methods too.
METHODS = {"brute force": (BLACK, "s"), "kd-tree": (ORANGE, "^"), "hybrid": (VERMILION, "D"),
           "linked cells": (BLUE, "o")}
OTHER = (GREY, "v")


def draw_panel(axes, rows):
    """Seconds over points for every method and number of processes."""
    several = max(row["processes"] for row in rows)
    present = {row["method"] for row in rows}
    for method in [name for name in METHODS if name in present] + sorted(present - set(METHODS)):
        color, marker = METHODS.get(method, OTHER)
        for processes in sorted({row["processes"] for row in rows}):
            line = sorted((row["points"], row["seconds"]) for row in rows
                          if row["method"] == method and row["processes"] == processes)
            if not line:
                continue
            one = processes == 1
            label = method if several == 1 else f"{method}, {processes} process{'' if one else 'es'}"
            axes.loglog(*zip(*line), color=color, marker=marker, linestyle="-" if one else "--",
                        markerfacecolor=color if one else "white", label=label)
    axes.grid(color="#E3E3E3", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.set_xlabel("points")


def draw(rows, picture):
    """One panel per arrangement."""
    plt.rcParams.update({**STYLE, "lines.markersize": 4.5})
    arrangements = sorted({row["arrangement"] for row in rows}, reverse=True)
    figure, panels = plt.subplots(1, len(arrangements), figsize=(4.2 * len(arrangements) + 0.4, 3.6), sharey=True,
                                  squeeze=False, layout="constrained")
    for axes, arrangement in zip(panels[0], arrangements):
        chosen = [row for row in rows if row["arrangement"] == arrangement]
        draw_panel(axes, chosen)
        axes.set_title(f"{arrangement}: all pairs closer than {1e3 * chosen[0]['radius_m']:g} mm "
                       f"in a cube of {1e3 * chosen[0]['edge_m']:g} mm", loc="left", size=8)
    panels[0][0].set_ylabel("seconds")
    panels[0][-1].legend(loc="upper left", bbox_to_anchor=(1.02, 1), handlelength=2.4, labelspacing=0.3)
    save(figure, picture)


def main(arguments):
    """Draw what there is."""
    status = asks_for_help(arguments, 2, __doc__)
    if status is not None:
        return status
    try:
        with open(arguments[1], encoding="utf-8") as file:
            draw(read_json_lines(file, arguments[1]), arguments[2])
    except (OSError, ValueError, KeyError, TypeError) as error:
        return fail(f"{arguments[1]}: {error}")
    print("Picture: " + arguments[2])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
