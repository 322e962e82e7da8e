#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the map of stability from the study.csv of a study of stability experiments.

    plot_stability.py STUDY.csv PICTURE.png

One column per scene, one row per changed entry; the colour tells the verdict, the number what decided it: the growth
of the kinetic energy per step, or else the error of the strain. Exit status: 0 drawn, 1 nothing to draw or a damaged
file, 2 wrong use, 3 matplotlib not installed.
"""

import sys

from plot_style import asks_for_help, fail, plt, save
from read_table import read_csv

from matplotlib.patches import Patch, Rectangle

# Colours of Okabe and Ito, lightened; their lightness differs too, so the map reads in grey as well.
COLORS = {"stable": "#BFE3D4", "inaccurate": "#F3CE7A", "unstable": "#C85A1E", "": "#E8E8E8"}
TEXT = {"stable": "#1A1A1A", "inaccurate": "#1A1A1A", "unstable": "#FFFFFF", "": "#777777"}

STYLE = {"font.family": "DejaVu Sans", "font.size": 8, "savefig.dpi": 200}


def label(row):
    """What stands in a field: two digits of what decided."""
    if row is None:
        return ""
    verdict, reason = row["verdict"], row.get("reason") or ""
    if verdict == "unstable" and reason.startswith("hourglass"):
        return "hourglass drifts"
    if verdict == "unstable":
        known = row.get("growth_per_step") not in (None, "", "-")
        return f"grows {row.number('growth_per_step'):.2g}/step" if known else verdict
    if verdict == "inaccurate" and reason != "strain error":
        known = reason == "energy drift" and row.get("energy_drift") not in (None, "", "-")
        return f"{reason} {row.number('energy_drift'):.1g}" if known else reason or verdict
    if verdict in ("stable", "inaccurate"):
        if row.get("strain_error") in (None, "", "-"):  # not among the columns, or not measured
            return verdict
        percent = 100 * row.number("strain_error")
        return f"strain {percent:.0f} %" if percent >= 10 else f"strain {percent:.2g} %"
    return "failed"


def read(path):
    """Names of the columns and rows in their order, and the fields by both."""
    columns, rows, fields = [], [], {}
    for row in read_csv(path):
        scene, _, change = row["case"].partition("__")
        change = change.replace("__", ", ").replace("_s_", "'s ").replace("_", " ") or "as it is"
        scene = scene.replace("_", " ")
        if scene not in columns:
            columns.append(scene)
        if change not in rows:
            rows.append(change)
        fields[scene, change] = row
    if not fields:
        raise ValueError("no cases")
    return columns, rows, fields


def draw(columns, rows, fields, picture):
    """The map."""
    plt.rcParams.update(STYLE)
    width, height = 1.55, 0.235
    figure, axes = plt.subplots(figsize=(2.2 + width * len(columns), 1.0 + height * len(rows)), layout="constrained")
    for i, scene in enumerate(columns):
        for j, change in enumerate(rows):
            row = fields.get((scene, change))
            verdict = row["verdict"] if row else ""
            axes.add_patch(Rectangle((i, j), 1, 1, facecolor=COLORS.get(verdict, COLORS[""]), edgecolor="white",
                                     linewidth=1.5))
            axes.text(i + 0.5, j + 0.52, label(row), ha="center", va="center", color=TEXT.get(verdict, TEXT[""]))
    axes.set_xlim(0, len(columns))
    axes.set_ylim(len(rows), 0)
    axes.set_xticks([i + 0.5 for i in range(len(columns))], columns)
    axes.set_yticks([j + 0.5 for j in range(len(rows))], rows)
    axes.xaxis.tick_top()
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.legend(handles=[Patch(facecolor=COLORS[v], label=v) for v in ("stable", "inaccurate", "unstable")],
                loc="upper center", bbox_to_anchor=(0.5, -0.005), ncol=3, frameon=False)
    save(figure, picture)


def main(arguments):
    """Draw what there is."""
    status = asks_for_help(arguments, 2, __doc__)
    if status is not None:
        return status
    try:
        draw(*read(arguments[1]), arguments[2])
    except (OSError, ValueError, KeyError) as error:
        return fail(f"{arguments[1]}: {error}")
    print("Picture: " + arguments[2])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
