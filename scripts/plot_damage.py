# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw damage.png: both faces of every plate and the mean through its thickness, at the end of a run."""

import os

# First, because they say what to install if it is missing.
from plot_style import close_box, plt, save, ticks, write_title
from ricochet_results import read_damage, read_summary, title_of

import numpy as np
from matplotlib.colors import LinearSegmentedColormap

# From sound to broken the lightness falls evenly, so that the map reads in grey as well.
DAMAGE = LinearSegmentedColormap.from_list("damage", ["#EADFC8", "#F0B860", "#D9622B", "#8E1B3C", "#2A0A2C"])


def draw_damage_bar(figure, image, right, bottom, panels):
    """The scale of damage in the right margin, in the middle of the panels' height; all lengths in inches."""
    width, height = figure.get_size_inches()
    bar_height = min(panels, 3.2)
    bar_bottom = bottom + (panels - bar_height) / 2
    bar = figure.add_axes([(width - right + 0.18) / width, bar_bottom / height, 0.13 / width, bar_height / height])
    colorbar = figure.colorbar(image, cax=bar, ticks=[0, 0.25, 0.5, 0.75, 1])
    colorbar.set_label("damage", labelpad=3)
    colorbar.outline.set_linewidth(0.7)


def draw_map(axes, plate, values):
    """One map of a plate from above, x along the flight; a half is completed by its mirror image."""
    rows = values.T
    if plate.mirrored:
        rows = np.concatenate([rows[::-1], rows])
    n_y, n_x = rows.shape
    low = -n_y * plate.spacing / 2 if plate.mirrored else plate.y
    limits = 1e3 * np.array([plate.x, plate.x + n_x * plate.spacing, low, low + n_y * plate.spacing])
    image = axes.imshow(rows, origin="lower", extent=limits, cmap=DAMAGE, vmin=0, vmax=1, interpolation="nearest")
    axes.xaxis.set_major_locator(ticks(8))
    axes.yaxis.set_major_locator(ticks(5))
    close_box(axes)
    return image


def titles_of(plate, summary):
    """What stands above the three maps of a plate."""
    number = plate.plate.split("_")[1]
    titles = []
    for face in ("front", "rear"):
        area = summary.get(f"{plate.plate}_{face}_damaged_mm2")
        titles.append(f"plate {number}, {face} face" + ("" if area is None else f": {area:.0f} mm² damaged"))
    share = summary.get(plate.plate + "_broken_share")
    titles.append(f"plate {number}, mean through the thickness"
                  + ("" if share is None else f": {100 * share:.1f} % of the bonds"))
    return titles


def draw_damage(directory, _):
    """damage.png, or None if the run has no maps."""
    maps = read_damage(directory)
    if not maps:
        return None
    summary = read_summary(directory) or {}
    n_x, n_y = maps[0].front.shape
    ratio = n_y * (2 if maps[0].mirrored else 1) / n_x
    panel, left, right, top, bottom, gap_x, gap_y = 3.4, 0.62, 0.95, 0.72, 0.5, 0.26, 0.30
    width = left + 3 * panel + 2 * gap_x + right
    height = top + len(maps) * panel * ratio + (len(maps) - 1) * gap_y + bottom
    figure = plt.figure(figsize=(width, height))
    write_title(figure, *title_of(directory))
    for row, plate in enumerate(maps):
        lowest = row == len(maps) - 1
        y = bottom + (len(maps) - 1 - row) * (panel * ratio + gap_y)
        values_of_plate = (plate.front, plate.rear, plate.mean)
        for column, (title, values) in enumerate(zip(titles_of(plate, summary), values_of_plate)):
            x = left + column * (panel + gap_x)
            axes = figure.add_axes([x / width, y / height, panel / width, panel * ratio / height])
            image = draw_map(axes, plate, values)
            axes.set_title(title, loc="left", pad=3, size=8)
            axes.tick_params(labelbottom=lowest, labelleft=column == 0)
            if lowest:
                axes.set_xlabel("x [mm]", labelpad=2)
            if column == 0:
                axes.set_ylabel("y [mm]", labelpad=2)
    draw_damage_bar(figure, image, right, bottom, height - top - bottom)
    target = os.path.join(directory, "damage.png")
    save(figure, target)
    return target
