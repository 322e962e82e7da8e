# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pictures of all scripts have in common: matplotlib, colours, the style of the axes, titles and saving."""

import os
import sys

SCRIPT = os.path.basename(sys.argv[0])

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import MaxNLocator
except ImportError as error:
    print(f"{SCRIPT}: {error}; apt install python3-matplotlib python3-h5py", file=sys.stderr)
    sys.exit(3)

# Colours of Okabe and Ito, distinguishable with every kind of colour vision.
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
BLUE, VERMILION, PURPLE, GREY = "#0072B2", "#D55E00", "#CC79A7", "#777777"

# As the reports have them.
OUTCOMES = {"ricochet": BLUE, "perforate": VERMILION, "edge": PURPLE, "pushed": GREEN, "stuck": ORANGE}

STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.fontsize": 8,
    "axes.linewidth": 0.7,
    "xtick.major.width": 0.7,
    "ytick.major.width": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "savefig.dpi": 200,
}


def plain(text):
    """Any text as matplotlib shall show it: without formulas between dollar signs."""
    return str(text).replace("$", r"\$")


def write_title(figure, title, outcome):
    """Title and outcome in the upper left corner, at fixed distances from the edge."""
    width, height = figure.get_size_inches()
    longest = int(width * 10.5)
    if len(title) > longest:
        title = title[: longest - 1].rstrip() + "…"
    figure.text(0.12 / width, 1 - 0.12 / height, plain(title), size=11, weight="bold", va="top")
    figure.text(0.12 / width, 1 - 0.36 / height, plain(outcome), size=9, color="#444444", va="top")


def ticks(number):
    """About that many ticks at round values."""
    return MaxNLocator(number, steps=[1, 2, 2.5, 5, 10])


def close_box(axes):
    """Draw the axes' upper and right edge too, for what is a picture and not a diagram."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(True)


def further_formats():
    """What the environment asks for beside PNG, as RICOCHET_PICTURE_FORMATS=svg,pdf."""
    asked = os.environ.get("RICOCHET_PICTURE_FORMATS", "").replace(",", " ").split()
    wrong = [name for name in asked if name not in ("png", "svg", "pdf")]
    if wrong:
        raise ValueError(f"RICOCHET_PICTURE_FORMATS has '{wrong[0]}'; formats are png, svg and pdf")
    return [name for name in asked if name != "png"]


def save(figure, path):
    """Write under a temporary name first: an older picture survives a full disk. In other formats too, if asked for."""
    for name in ["png"] + further_formats():
        target = os.path.splitext(path)[0] + "." + name
        figure.savefig(target + ".tmp", format=name)
        os.replace(target + ".tmp", target)
    plt.close(figure)


def fail(message):
    """One line that says why there is no picture; the exit status that goes with it."""
    print(f"{SCRIPT}: {message}", file=sys.stderr)
    return 1


def asks_for_help(arguments, n_arguments, text):
    """The exit status if the command line asks for help or is wrong, having printed the text; None if it is right."""
    if len(arguments) == n_arguments + 1 and arguments[1] not in ("-h", "--help"):
        return None
    print(text.strip())
    return 0 if "-h" in arguments or "--help" in arguments else 2
