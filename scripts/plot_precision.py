#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the error of a single-precision history over the time step from the rows of `ricochet bench history`.

    ricochet bench history | plot_precision.py PICTURE.png

Exit status: 0 drawn, 1 nothing to draw or a damaged input, 2 wrong use, 3 matplotlib not installed.
"""

import sys

from plot_style import BLUE, GREY, STYLE, VERMILION, asks_for_help, fail, plt, save
from read_table import read_json_lines

HALF_DIGIT = 6e-8  # of single precision, relative


def draw(rows, picture):
    """Error over time step, both on logarithmic axes."""
    plt.rcParams.update({**STYLE, "lines.markersize": 4.5})
    figure, axes = plt.subplots(figsize=(4.6, 3.4), layout="constrained")
    steps = [row["dt_per_relaxation_time"] for row in rows]
    axes.loglog(steps, [HALF_DIGIT / step for step in steps], color=GREY, linestyle="--",
                label=r"where it stalls: $6\cdot10^{-8}\,\theta/\Delta t$ of the strain")
    for key, color, marker, label in (("error_held", VERMILION, "s", "held for 4 θ"),
                                      ("error_pulled", BLUE, "o", "pulled to 2 % within θ")):
        # A single step pulls without any error.
        axes.loglog(*zip(*[(row["dt_per_relaxation_time"], row[key]) for row in rows if row[key] > 0.]),
                    color=color, marker=marker, label=label)
    axes.grid(color="#E3E3E3", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.set_xlabel("time step Δt / relaxation time θ")
    axes.set_ylabel("error of a bond's force, of the force")
    axes.legend(loc="upper right")
    save(figure, picture)


def main(arguments):
    """Draw what comes in."""
    status = asks_for_help(arguments, 1, __doc__)
    if status is not None:
        return status
    try:
        draw(read_json_lines(sys.stdin, "the input"), arguments[1])
    except (OSError, ValueError, KeyError, TypeError) as error:
        return fail(error)
    print("Picture: " + arguments[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
