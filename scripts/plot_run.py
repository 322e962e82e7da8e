#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw section.png, damage.png, history.png and, with data of others, reference.png from the results of a ricochet run,
finished or not.

    plot_run.py RUN_DIRECTORY

Reads history.csv, section.h5, damage.h5 and summary.json of that folder; what is missing is left out. Exit status:
0 drawn, 1 nothing to draw or a damaged file, 2 wrong use, 3 matplotlib or h5py not installed.
"""

import sys

from plot_damage import draw_damage
from plot_history import draw_history
from plot_reference import draw_reference
from plot_section import draw_section
from plot_style import BLUE, STYLE, asks_for_help, fail, plt
from ricochet_results import read_history, read_summary, title_of


def draw_data(directory, history):
    """reference.png, or None if the run has not been compared with data."""
    return draw_reference(directory, [(history, read_summary(directory), "", BLUE, "-")], *title_of(directory))


def main(arguments):
    """Draw what there is: what is damaged costs its own picture and not the others."""
    status = asks_for_help(arguments, 1, __doc__)
    if status is not None:
        return status
    directory = arguments[1]
    plt.rcParams.update(STYLE)
    history, drawn, failed = None, [], False
    try:
        history = read_history(directory)
    except (OSError, ValueError) as error:
        failed = fail(f"read history of {directory}: {error}")
    for draw in (draw_section, draw_damage, draw_history, draw_data):
        try:
            picture = draw(directory, history)
        except (OSError, ValueError, KeyError) as error:
            failed = fail(f"{draw.__name__.replace('_', ' ')} of {directory}: {error}")
        else:
            drawn += [picture] if picture else []
    if failed:
        return 1
    if not drawn:
        return fail(f"{directory} has neither section.h5 nor history.csv with data")
    print("Pictures: " + ", ".join(drawn))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
