# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw section.png: plates, projectile and its path in the plane y = 0 at several times."""

import os

# First, because they say what to install if it is missing.
from plot_style import BLUE, close_box, plt, save, ticks, write_title
from ricochet_results import read_frames, stated_times, title_of
from plot_damage import DAMAGE, draw_damage_bar

import numpy as np
from matplotlib.collections import PolyCollection

STEEL, STEEL_EDGE = "#8795A3", "#2F3840"


def spacing_of(points):
    """Distance of neighbouring points of a lattice [mm] that has not moved yet."""
    for coordinate in (points[:, 1], points[:, 0]):
        steps = np.diff(np.sort(coordinate))
        steps = steps[steps > 0.01 * steps.max(initial=1e-3)]  # the others are rounding of equal coordinates
        if len(steps) > 0:
            return float(np.median(steps))
    return 1.0


def squares(points, sizes):
    """A square around each point, n x 4 x 2."""
    corners = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])
    return points[:, None, :] + corners[None, :, :] * sizes[:, None, None]


def sizes_of(first):
    """Edge of the squares that stand for the points of each body [mm]: the grid spacing. The first frame, which may show
    plates that have moved, is asked only about bodies that are no plates."""
    return {body: first.spacings.get(int(body)) or spacing_of(first.points[first.body == body])
            for body in np.unique(first.body)}


def window(frames, first):
    """Limits of the axes, the same in all panels: the projectile's way and the plates beside it."""
    outlines = np.concatenate([outline for frame in frames for outline in frame.outlines])
    shown = [outlines]
    for frame in frames:
        if len(frame.damage) == len(first.points):
            where = first.points[frame.damage > 0.05]
            shown.append(np.clip(where, *first.extent) if first.extent else where)  # in the plates, wherever it flies
    shown = np.concatenate(shown)
    low, high = shown.min(axis=0), shown.max(axis=0)
    if len(first.points):
        plate_low, plate_high = first.extent or (first.points.min(axis=0), first.points.max(axis=0))
        low[1], high[1] = min(low[1], plate_low[1]), max(high[1], plate_high[1])
        # A plate only a little longer than the event is shown whole.
        length = high[0] - low[0]
        if low[0] - plate_low[0] < 0.35 * length:
            low[0] = min(low[0], plate_low[0])
        if plate_high[0] - high[0] < 0.35 * length:
            high[0] = max(high[0], plate_high[0])
    pad = 0.04 * max(high - low)
    low, high = low - pad, high + pad
    # Very flat windows would leave no room for anything thrown up.
    least = 0.22 * (high[0] - low[0])
    if high[1] - low[1] < least:
        high[1] = low[1] + least
    return low, high


def draw_frame(axes, frame, sizes, history):
    """Plates, projectile and its path up to the time of the frame."""
    size_of_point = np.array([sizes.get(body, 1.0) for body in frame.body])
    order = np.argsort(frame.damage, kind="stable")
    plates = PolyCollection(
        squares(frame.points[order], size_of_point[order]),
        array=frame.damage[order],
        cmap=DAMAGE,
        antialiaseds=False,
        linewidths=0,
        zorder=2,
    )
    plates.set_clim(0, 1)
    axes.add_collection(plates)
    for outline in frame.outlines:
        axes.fill(*outline.T, facecolor=STEEL, edgecolor=STEEL_EDGE, linewidth=0.7, zorder=3, joinstyle="round")
    if history is not None:
        past = history["time"] <= frame.time * (1 + 1e-9)
        axes.plot(history["x"][past], history["z"][past], color=BLUE, linewidth=0.9, zorder=4)
        if past.any():
            axes.plot(history["x"][past][-1:], history["z"][past][-1:], "o", color=BLUE, markersize=2.2, zorder=4)
    return plates


def draw_section(directory, history):
    """section.png: the section y = 0 at the stated times, or at up to six."""
    frames, first = read_frames(directory, stated_times(directory))
    if not frames:
        return None
    sizes = sizes_of(first)
    low, high = window(frames, first)
    ratio = (high[1] - low[1]) / (high[0] - low[0])

    n_columns = 1 if len(frames) == 1 else 2 if ratio < 0.75 or len(frames) in (2, 4) else 3
    n_rows = -(-len(frames) // n_columns)
    most_height = 9.0 / n_rows  # of a panel; the page stays a page
    # All distances in inches, so that panels of any shape fill the page without gaps.
    panel = min({1: 6.6, 2: 4.4, 3: 3.0}[n_columns], most_height / ratio)
    left, right, top, bottom, gap_x, gap_y = 0.62, 0.95, 0.72, 0.5, 0.14, 0.28
    width = left + n_columns * panel + (n_columns - 1) * gap_x + right
    height = top + n_rows * panel * ratio + (n_rows - 1) * gap_y + bottom
    figure = plt.figure(figsize=(width, height))
    write_title(figure, *title_of(directory))

    precision = 0 if frames[-1].time - frames[0].time >= 20 * len(frames) else 1
    for i, frame in enumerate(frames):
        row, column = divmod(i, n_columns)
        x = left + column * (panel + gap_x)
        y = bottom + (n_rows - 1 - row) * (panel * ratio + gap_y)
        axes = figure.add_axes([x / width, y / height, panel / width, panel * ratio / height])
        plates = draw_frame(axes, frame, sizes, history)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.xaxis.set_major_locator(ticks(8))
        axes.yaxis.set_major_locator(ticks(5 if ratio > 0.3 else 3))
        close_box(axes)
        axes.set_title(f"{frame.time:.{precision}f} µs", loc="left", pad=3)
        lowest = i + n_columns >= len(frames)
        axes.tick_params(labelbottom=lowest, labelleft=column == 0)
        if lowest:
            axes.set_xlabel("x [mm]", labelpad=2)
        if column == 0:
            axes.set_ylabel("z [mm]", labelpad=2)

    draw_damage_bar(figure, plates, right, bottom, n_rows * panel * ratio + (n_rows - 1) * gap_y)
    target = os.path.join(directory, "section.png")
    save(figure, target)
    return target
