#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw section.png, damage.png and history.png from the results of a ricochet run, finished or not.

    plot_run.py RUN_DIRECTORY

Reads history.csv, section.h5, damage.h5 and summary.json of that folder; what is missing is left out. Exit status:
0 drawn, 1 nothing to draw or a damaged file, 2 wrong use, 3 matplotlib or h5py not installed.
"""

import csv
import json
import os
import sys

try:
    import h5py
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import LinearSegmentedColormap
    from matplotlib.ticker import MaxNLocator
except ImportError as error:
    print(f"plot_run.py: {error}; apt install python3-matplotlib python3-h5py", file=sys.stderr)
    sys.exit(3)

from plot_style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, STYLE, VERMILION

STEEL, STEEL_EDGE = "#8795A3", "#2F3840"

# From sound to broken the lightness falls evenly, so that the map reads in grey as well.
DAMAGE = LinearSegmentedColormap.from_list("damage", ["#EADFC8", "#F0B860", "#D9622B", "#8E1B3C", "#2A0A2C"])


class History:
    """The columns of history.csv by their names without unit; an incomplete last line is dropped."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.columns = {}
        if not rows or not rows[0]:
            return
        rows, header = [row for row in rows[1:] if len(row) == len(rows[0])], rows[0]
        values = np.array(rows, dtype=float).reshape(-1, len(header))
        for name, column in zip(header, values.T):
            self.columns[name.split(" [")[0].strip()] = column

    def __len__(self):
        return len(self.columns.get("time", ()))

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]


class Frame:
    """One frame of section.h5, lengths in mm."""

    def __init__(self, group):
        self.time = group.attrs["time_s"] * 1e6  # us
        self.points = group["position"][:][:, [0, 2]] * 1e3
        self.damage = group["damage"][:]
        self.body = group["body"][:]
        self.outline = group["outline"][:][:, [0, 2]] * 1e3


def read_history(directory, _):
    """The history, or None if the run has none."""
    path = os.path.join(directory, "history.csv")
    return History(path) if os.path.exists(path) else None


def read_summary(directory):
    """The summary of the run, or None if it has not ended."""
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


def title_of(directory):
    """Title of the run and, if it has ended, its outcome."""
    name = os.path.basename(os.path.abspath(directory))
    summary = read_summary(directory)
    if summary is None:
        return name, "run not finished"
    outcome = str(summary.get("outcome", ""))
    parts = [{"perforate": "perforation", "undecided": "outcome undecided",
              "edge": f"leaves through the edge of plate {summary.get('exit_plate', 1)}"}.get(outcome, outcome)]
    if summary.get("exit_speed_m_s") is not None and outcome != "stuck":
        parts.append(f"{'last' if outcome == 'undecided' else 'exit'} speed {summary['exit_speed_m_s']:.0f} m/s")
        if summary.get("exit_angle_deg") is not None:
            parts[-1] += f" at {summary['exit_angle_deg']:.1f}°".replace("-", "−")
    if summary.get("max_depth_mm") is not None:
        parts.append(f"greatest depth {summary['max_depth_mm']:.1f} mm")
    return summary.get("title") or name, "  ·  ".join(part for part in parts if part)


def write_title(figure, directory):
    """Title and outcome in the upper left corner, at fixed distances from the edge."""
    title, outcome = title_of(directory)
    width, height = figure.get_size_inches()
    longest = int(width * 10.5)
    if len(title) > longest:
        title = title[: longest - 1].rstrip() + "…"
    figure.text(0.12 / width, 1 - 0.12 / height, title, size=11, weight="bold", va="top")
    figure.text(0.12 / width, 1 - 0.36 / height, outcome, size=9, color="#444444", va="top")


def ticks(number):
    """About that many ticks at round values."""
    return MaxNLocator(number, steps=[1, 2, 2.5, 5, 10])


def save(figure, path):
    """Write under a temporary name first: an older picture survives a full disk."""
    temporary = path + ".tmp"
    figure.savefig(temporary, format="png")
    os.replace(temporary, path)
    plt.close(figure)


# ---------------------------------------------------------------------------------------------------- section


def spacing_of(points):
    """Distance of neighbouring points of a lattice [mm], from the first frame."""
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


def stated_times(directory):
    """Times [s] at which the parameter file asks for panels; empty if it does not, or if the run has not ended."""
    summary = read_summary(directory) or {}
    return [position["time_us"] * 1e-6 for position in summary.get("positions", [])]


def read_frames(path, stated=(), n_panels=6):
    """The frames at the stated times; without any, up to six at even distances in time, the first and the last among
    them. And the first one of all again."""
    with h5py.File(path, "r") as file:
        names = sorted(file, key=lambda name: int(name.split("_")[1]))
        if not names:
            return [], None
        times = np.array([file[name].attrs["time_s"] for name in names])
        wanted = list(stated) or np.linspace(times[0], times[-1], min(n_panels, len(names)))
        if len(stated) % 2 == 1:
            wanted.append(times[-1])  # there is room for it
        chosen = sorted({int(np.argmin(np.abs(times - time))) for time in wanted})
        return [Frame(file[names[i]]) for i in chosen], Frame(file[names[0]])


def window(frames, first):
    """Limits of the axes, the same in all panels: the projectile's way and the plates beside it."""
    outlines = np.concatenate([frame.outline for frame in frames])
    shown = [outlines]
    for frame in frames:
        if len(frame.damage) == len(first.points):
            shown.append(first.points[frame.damage > 0.05])
    shown = np.concatenate(shown)
    low, high = shown.min(axis=0), shown.max(axis=0)
    if len(first.points):
        plate_low, plate_high = first.points.min(axis=0), first.points.max(axis=0)
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
    axes.fill(*frame.outline.T, facecolor=STEEL, edgecolor=STEEL_EDGE, linewidth=0.7, zorder=3, joinstyle="round")
    if history is not None and "x" in history and "z" in history:
        past = history["time"] <= frame.time * (1 + 1e-9)
        axes.plot(history["x"][past], history["z"][past], color=BLUE, linewidth=0.9, zorder=4)
        if past.any():
            axes.plot(history["x"][past][-1:], history["z"][past][-1:], "o", color=BLUE, markersize=2.2, zorder=4)
    return plates


def draw_section(directory, history):
    """section.png: the section y = 0 at the stated times, or at up to six."""
    path = os.path.join(directory, "section.h5")
    if not os.path.exists(path):
        return None
    frames, first = read_frames(path, stated_times(directory))
    if not frames:
        return None
    sizes = {body: spacing_of(first.points[first.body == body]) for body in np.unique(first.body)}
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
    write_title(figure, directory)

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
        for side in ("top", "right"):
            axes.spines[side].set_visible(True)
        axes.set_title(f"{frame.time:.{precision}f} µs", loc="left", pad=3)
        lowest = i + n_columns >= len(frames)
        axes.tick_params(labelbottom=lowest, labelleft=column == 0)
        if lowest:
            axes.set_xlabel("x [mm]", labelpad=2)
        if column == 0:
            axes.set_ylabel("z [mm]", labelpad=2)

    bar_height = min(n_rows * panel * ratio + (n_rows - 1) * gap_y, 3.2)
    bar_bottom = bottom + (n_rows * panel * ratio + (n_rows - 1) * gap_y - bar_height) / 2
    bar = figure.add_axes([(width - right + 0.18) / width, bar_bottom / height, 0.13 / width, bar_height / height])
    colorbar = figure.colorbar(plates, cax=bar, ticks=[0, 0.25, 0.5, 0.75, 1])
    colorbar.set_label("damage", labelpad=3)
    colorbar.outline.set_linewidth(0.7)

    target = os.path.join(directory, "section.png")
    save(figure, target)
    return target


# ----------------------------------------------------------------------------------------------------- damage


def draw_map(axes, grid, values):
    """One map of a plate from above, x along the flight; a half is completed by its mirror image."""
    spacing, x, y, mirrored = grid
    rows = values.T
    if mirrored:
        rows = np.concatenate([rows[::-1], rows])
    n_y, n_x = rows.shape
    low = -n_y * spacing / 2 if mirrored else y
    limits = 1e3 * np.array([x, x + n_x * spacing, low, low + n_y * spacing])
    image = axes.imshow(rows, origin="lower", extent=limits, cmap=DAMAGE, vmin=0, vmax=1, interpolation="nearest")
    axes.xaxis.set_major_locator(ticks(8))
    axes.yaxis.set_major_locator(ticks(5))
    for side in ("top", "right"):
        axes.spines[side].set_visible(True)
    return image


def draw_damage(directory, _):
    """damage.png: both faces of every plate and the mean through its thickness, at the end of the run."""
    path = os.path.join(directory, "damage.h5")
    if not os.path.exists(path):
        return None
    summary = read_summary(directory) or {}
    with h5py.File(path, "r") as file:
        plates = sorted((name[: -len("_grid")] for name in file if name.endswith("_grid")),
                        key=lambda name: int(name.split("_")[1]))
        maps = [(plate, file[plate + "_grid"][:], [file[f"{plate}_{kind}"][:] for kind in ("front", "rear", "mean")])
                for plate in plates]
    if not maps:
        return None
    spacing, _, _, mirrored = maps[0][1]
    n_x, n_y = maps[0][2][0].shape
    ratio = n_y * (2 if mirrored else 1) / n_x
    panel, left, right, top, bottom, gap_x, gap_y = 3.4, 0.62, 0.95, 0.72, 0.5, 0.26, 0.30
    width = left + 3 * panel + 2 * gap_x + right
    height = top + len(maps) * panel * ratio + (len(maps) - 1) * gap_y + bottom
    figure = plt.figure(figsize=(width, height))
    write_title(figure, directory)
    for row, (plate, grid, values) in enumerate(maps):
        number = plate.split("_")[1]
        share = summary.get(plate + "_broken_share")
        notes = [summary.get(f"{plate}_{face}_damaged_mm2") for face in ("front", "rear")]
        titles = [f"plate {number}, {face} face" + ("" if note is None else f": {note:.0f} mm² damaged")
                  for face, note in zip(("front", "rear"), notes)]
        titles.append(f"plate {number}, mean through the thickness"
                      + ("" if share is None else f": {100 * share:.1f} % of the bonds"))
        y = bottom + (len(maps) - 1 - row) * (panel * ratio + gap_y)
        for column, (title, value) in enumerate(zip(titles, values)):
            x = left + column * (panel + gap_x)
            axes = figure.add_axes([x / width, y / height, panel / width, panel * ratio / height])
            image = draw_map(axes, grid, value)
            axes.set_title(title, loc="left", pad=3, size=8)
            axes.tick_params(labelbottom=row == len(maps) - 1, labelleft=column == 0)
            if row == len(maps) - 1:
                axes.set_xlabel("x [mm]", labelpad=2)
            if column == 0:
                axes.set_ylabel("y [mm]", labelpad=2)
    bar_height = min(height - top - bottom, 3.2)
    bar_bottom = bottom + (height - top - bottom - bar_height) / 2
    bar = figure.add_axes([(width - right + 0.18) / width, bar_bottom / height, 0.13 / width, bar_height / height])
    colorbar = figure.colorbar(image, cax=bar, ticks=[0, 0.25, 0.5, 0.75, 1])
    colorbar.set_label("damage", labelpad=3)
    colorbar.outline.set_linewidth(0.7)

    target = os.path.join(directory, "damage.png")
    save(figure, target)
    return target


# ---------------------------------------------------------------------------------------------------- history


def lines(axes, history, entries, ylabel):
    """The columns that exist; a legend if there is more than one."""
    drawn = 0
    for name, label, color, style in entries:
        if name in history:
            axes.plot(history["time"], history[name], color=color, linestyle=style, label=label)
            drawn += 1
    axes.set_ylabel(ylabel)
    axes.set_xlabel("time [µs]")
    if drawn > 1:
        axes.legend(loc="best", handlelength=1.6, labelspacing=0.3)


def draw_path(axes, history):
    """The way of the centre of mass in the plane of the flight."""
    if "x" not in history or "z" not in history:
        return
    axes.plot(history["x"], history["z"], color=BLUE)
    axes.plot(history["x"][:1], history["z"][:1], "o", color=BLUE, markersize=4, markerfacecolor="white")
    axes.plot(history["x"][-1:], history["z"][-1:], "o", color=BLUE, markersize=4)
    axes.axhline(0, color=GREY, linewidth=0.8, linestyle=(0, (4, 3)))
    axes.annotate("plate surface", (0.99, 0), xycoords=("axes fraction", "data"), xytext=(0, 2),
                  textcoords="offset points", ha="right", va="bottom", size=7.5, color=GREY)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z of the centroid [mm]")
    axes.margins(0.06, 0.1)


# Stacked from below; what the projectile keeps is drawn last, so that the top edge is the conserved total.
ENERGIES = [
    ("energy fracture", "fracture", VERMILION),
    ("energy viscous", "viscosity", "#8C564B"),
    ("energy absorbed", "left through the edges", "#17BECF"),
    ("work friction", "friction", ORANGE),
    ("work debris friction", "debris friction", "#B8860B"),
    ("energy debris", "debris contact", "#F0E442"),
    ("energy contact", "contact", PURPLE),
    ("energy strain", "plate strain", GREEN),
    ("energy kinetic", "plate motion", SKY),
    ("energy projectile", "projectile", "#B9C2CB"),
]


def draw_energies(axes, history):
    """Where the projectile's energy has gone, as layers."""
    present = [(history[name], label, color) for name, label, color in ENERGIES
               if name in history and (name not in ("energy viscous", "energy absorbed", "work debris friction")
                                       or np.any(history[name]))]
    if not present:
        return
    values = np.array([value for value, _, _ in present])
    scale, unit = (1e3, "kJ") if np.nanmax(np.abs(values)) >= 2e3 else (1.0, "J")
    layers = axes.stackplot(history["time"], np.maximum(values, 0) / scale, colors=[color for _, _, color in present],
                            linewidth=0)
    axes.legend(layers[::-1], [label for _, label, _ in present][::-1], loc="upper left", bbox_to_anchor=(1.01, 1.02),
                handlelength=1.0, handleheight=1.0, labelspacing=0.35, borderaxespad=0)
    axes.set_xlabel("time [µs]")
    axes.set_ylabel(f"energy [{unit}]")
    axes.margins(x=0)
    axes.set_ylim(bottom=0)


def draw_residual(axes, history):
    """Energy that the balance does not account for."""
    if "residual relative" not in history:
        return
    axes.plot(history["time"], 100 * history["residual relative"], color=BLACK)
    axes.axhline(0, color=GREY, linewidth=0.8)
    axes.set_xlabel("time [µs]")
    axes.set_ylabel("energy residual [%]")
    # Rounding noise should look like nothing, not like a mountain range.
    reach = max(0.1, 115 * np.nanmax(np.abs(history["residual relative"])))
    axes.set_ylim(-reach, reach)


def draw_history(directory, history):
    """history.png: six diagrams over time."""
    if history is None or len(history) < 2:
        return None
    figure = plt.figure(figsize=(11.0, 6.4))
    write_title(figure, directory)
    grid = figure.add_gridspec(2, 3, left=0.062, right=0.895, top=0.875, bottom=0.085, wspace=0.30, hspace=0.32)
    speed, pitch, path, force, residual, energy = (
        figure.add_subplot(grid[i]) for i in ((0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2))
    )
    lines(speed, history, [("speed", "speed", BLACK, "-"), ("velocity x", "along x", BLUE, "--"),
                           ("velocity z", "along z", VERMILION, "--")], "velocity [m/s]")
    lines(pitch, history, [("pitch", "pitch", BLACK, "-")], "pitch [°]")
    draw_path(path, history)
    lines(force, history, [("force normal", "normal", BLUE, "-"), ("force friction", "friction", VERMILION, "-"),
                           ("force shank", "shank", GREEN, "-")], "contact force [kN]")
    draw_energies(energy, history)
    draw_residual(residual, history)
    for axes in (speed, pitch, force, residual):
        axes.margins(x=0)
    for axes in figure.axes:
        axes.xaxis.set_major_locator(ticks(6))
        axes.yaxis.set_major_locator(ticks(6))
        if axes is not energy:
            axes.grid(color="#E3E3E3", linewidth=0.6)
            axes.set_axisbelow(True)

    target = os.path.join(directory, "history.png")
    save(figure, target)
    return target


def main(arguments):
    """Draw what there is."""
    if len(arguments) != 2 or arguments[1] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if len(arguments) == 2 else 2
    directory = arguments[1]
    plt.rcParams.update(STYLE)
    history, drawn, failed = None, [], False
    for step in (read_history, draw_section, draw_damage, draw_history):
        try:
            result = step(directory, history)
        except (OSError, ValueError, KeyError) as error:
            print(f"plot_run.py: {step.__name__.replace('_', ' ')} of {directory}: {error}", file=sys.stderr)
            failed = True
            continue
        if step is read_history:
            history = result
        elif result:
            drawn.append(result)
    if failed:
        return 1
    if not drawn:
        print(f"plot_run.py: {directory} has neither section.h5 nor history.csv with data", file=sys.stderr)
        return 1
    print("Pictures: " + ", ".join(drawn))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
