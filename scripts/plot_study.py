#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw comparison.png from the runs of a ricochet study: the paths of all cases in one diagram, and of each the
section at its end with what came out; eight cases a page, the others in comparison_2.png and so on. With data of
others also reference.png; with two axes of numbers map.png; with an axis of speeds residual.png; of a study of
convergence convergence.png and convergence_damage.png.

    plot_study.py STUDY_DIRECTORY

Reads study.csv and study.json of that folder and the results in the folders of its cases. Exit status:
0 drawn, 1 nothing to draw or a damaged file, 2 wrong use, 3 matplotlib or h5py not installed.
"""

import os
import sys

from plot_convergence import draw_convergence
from plot_damage import draw_damage_bar
from plot_map import draw_maps
from plot_reference import columns_of, draw_reference
from plot_section import draw_frame, sizes_of, window
from plot_style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, STYLE, VERMILION
from plot_style import asks_for_help, close_box, fail, plain, plt, save, ticks
from ricochet_results import read_frames, read_history, read_study, read_summary
from read_table import read_csv

# Dashes tell the cases too.
COLORS = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK, GREY]
DASHES = ["-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (3, 1)), (0, (1, 1))]
MOST = len(COLORS)


class Case:
    """One run: name, title, summary, history and last frame; what is missing is None."""

    def __init__(self, directory, name, label):
        self.name, self.label = name, plain(label)
        folder = os.path.join(directory, name)
        self.summary = read_summary(folder)
        self.history = read_history(folder)
        self.frames, self.first = read_frames(folder, n_panels=2)

    def exists(self):
        """Whether there is anything to draw."""
        return self.history is not None and len(self.history) > 0


def read_cases(directory):
    """The cases of study.csv in their order, as far as they have run, and how many there are in all."""
    labels = {case["name"]: case["label"] for case in read_study(directory).get("cases", [])}
    names = [row["case"] for row in read_csv(os.path.join(directory, "study.csv"))]
    cases = [Case(directory, name, labels.get(name) or name.replace("__", ", ").replace("_", " ")) for name in names]
    return [case for case in cases if case.exists()], len(names)


def numbers_of(case):
    """What came out, in two short lines."""
    s = case.summary
    if s is None:
        return "not finished"
    exit_text = "" if s.get("exit_speed_m_s") is None else f", {s['exit_speed_m_s']:.0f} m/s"
    if exit_text and s.get("exit_angle_deg") is not None:
        exit_text += f" at {s['exit_angle_deg']:.0f}°".replace("-", "−")
    depth = "" if s.get("max_depth_mm") is None else f"; depth {s['max_depth_mm']:.1f} mm"
    path = "" if s.get("path_mm") is None else f"; path {s['path_mm']:.0f} mm"
    lines = [f"{s.get('outcome', '')}{exit_text}{depth}{path}"]
    plates = [key[: -len("_broken_share")] for key in s if key.startswith("plate_") and key.endswith("_broken_share")]
    for plate in plates:
        front, rear = (s.get(f"{plate}_{face}_damaged_mm2") or 0 for face in ("front", "rear"))
        lines.append((f"plate {plate.split('_')[1]}: " if len(plates) > 1 else "") +
                     f"{100 * s[plate + '_broken_share']:.1f} % of the bonds, damaged front "
                     f"{front:.0f}, rear {rear:.0f} mm²")
    return "\n".join(lines)


def overlay_positions(axes, cases):
    """Places of the projectile that somebody else gives."""
    columns = {column["name"]: column["points"] for case in cases for column in columns_of(case.summary)}
    x = {point["time_us"]: point for point in columns.get("x", [])}
    for point in columns.get("z", []):
        if point["time_us"] in x:
            other = x[point["time_us"]]
            axes.errorbar([other["wanted"]], [point["wanted"]], xerr=other["error_bar"], yerr=point["error_bar"],
                          fmt="o", color=BLACK, markersize=4, linewidth=0.9, capsize=2, zorder=6)


def draw_paths(axes, cases):
    """The ways of the centroids in the plane of the flight."""
    for i, case in enumerate(cases):
        x, z = case.history["x"], case.history["z"]
        axes.plot(x, z, color=COLORS[i], linestyle=DASHES[i], label=case.label)
        axes.plot(x[-1:], z[-1:], "o", color=COLORS[i], markersize=4)
    axes.axhline(0, color=GREY, linewidth=0.8, linestyle=(0, (4, 3)))
    overlay_positions(axes, cases)
    axes.set_aspect("equal", adjustable="datalim", anchor="W")
    axes.set_xlabel("x [mm]", labelpad=2)
    axes.set_ylabel("z of the centroid [mm]", labelpad=2)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0, handlelength=2.6)
    axes.grid(color="#E3E3E3", linewidth=0.6)
    axes.set_axisbelow(True)


def draw_section(axes, case, color, low, high):
    """The last frame of a case with the whole path."""
    frame = case.frames[-1]
    plates = draw_frame(axes, frame, sizes_of(case.first), None)
    axes.plot(case.history["x"], case.history["z"], color=color, linewidth=1.1, zorder=4)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.xaxis.set_major_locator(ticks(8))
    axes.yaxis.set_major_locator(ticks(5))
    close_box(axes)
    return plates


def write_results(axes, case, cases, n_lines, panel_height):
    """Name and numbers of a case above its panel, whose height is in inches."""
    color = COLORS[cases.index(case)]
    axes.text(0, 1.02, numbers_of(case), transform=axes.transAxes, size=7.5, va="bottom", color="#444444",
              linespacing=1.25)
    axes.text(0, 1.02 + 0.155 * (n_lines - 1) / panel_height,
              f"{case.label}, at {case.frames[-1].time:.0f} µs",
              transform=axes.transAxes, size=8.5, weight="bold", va="bottom", color=color)


def windows(cases):
    """Limits that fit the sections of all cases."""
    limits = [window(case.frames, case.first) for case in cases]
    lows, highs = zip(*limits)
    return (min(low[0] for low in lows), min(low[1] for low in lows)), (max(high[0] for high in highs),
                                                                       max(high[1] for high in highs))


def draw_page(directory, cases, page, n_pages, n_missing):
    """One page of the comparison."""
    shown = [case for case in cases if case.frames]
    lines = max(numbers_of(case).count("\n") + 2 for case in cases)
    n_columns = 1 if len(shown) == 1 else 2
    n_rows = -(-len(shown) // n_columns)
    low, high = windows(shown) if shown else ((0, 0), (1, 1))
    ratio = min(1.2, (high[1] - low[1]) / (high[0] - low[0]))
    panel = 6.0 if n_columns == 1 else 4.8
    left, right, top, bottom, gap_x, gap_y, paths = 0.62, 0.95, 0.55, 0.5, 0.14, 0.16 + 0.155 * lines, 2.4
    width = left + 2 * 4.8 + gap_x + right
    sections = n_rows * (panel * ratio + gap_y)
    height = top + paths + 0.35 + sections + bottom
    figure = plt.figure(figsize=(width, height))
    title = study_title(directory)
    if n_pages > 1:
        title += f" ({page} of {n_pages})"
    if n_missing:
        title += f": without {n_missing} " + ("case that has" if n_missing == 1 else "cases that have") + " no results"
    figure.text(0.12 / width, 1 - 0.12 / height, plain(title), size=11, weight="bold", va="top")
    draw_paths(figure.add_axes([left / width, (bottom + sections + 0.35) / height, 6.0 / width, paths / height]),
               cases)

    for i, case in enumerate(shown):
        row, column = divmod(i, n_columns)
        x = left + column * (panel + gap_x)
        y = bottom + (n_rows - 1 - row) * (panel * ratio + gap_y)
        axes = figure.add_axes([x / width, y / height, panel / width, panel * ratio / height])
        plates = draw_section(axes, case, COLORS[cases.index(case)], low, high)
        write_results(axes, case, cases, lines, panel * ratio)
        lowest = i + n_columns >= len(shown)
        axes.tick_params(labelbottom=lowest, labelleft=column == 0)
        if lowest:
            axes.set_xlabel("x [mm]", labelpad=2)
        if column == 0:
            axes.set_ylabel("z [mm]", labelpad=2)
    if shown:
        draw_damage_bar(figure, plates, right, bottom, min(sections - gap_y, 3.2))
    target = os.path.join(directory, "comparison.png" if page == 1 else f"comparison_{page}.png")
    save(figure, target)
    return target


def study_title(directory):
    """The title of the study, or the name of its folder."""
    return read_study(directory).get("title") or os.path.basename(os.path.abspath(directory)).replace("_", " ")


def draw(directory):
    """All pictures; none if no case has results."""
    cases, n_all = read_cases(directory)
    pages = [cases[i : i + MOST] for i in range(0, len(cases), MOST)]
    targets = [draw_page(directory, some, i + 1, len(pages), n_all - len(cases)) for i, some in enumerate(pages)]
    runs = [(case.history, case.summary, case.label, COLORS[i % MOST], DASHES[i // MOST % len(DASHES)])
            for i, case in enumerate(cases)]
    compared = draw_reference(directory, runs, study_title(directory), "against data of others")
    return targets + ([compared] if compared else []) + draw_maps(directory) + draw_convergence(directory)


def main(arguments):
    """Draw what there is."""
    status = asks_for_help(arguments, 1, __doc__)
    if status is not None:
        return status
    plt.rcParams.update(STYLE)
    try:
        targets = draw(arguments[1])
    except (OSError, ValueError, KeyError) as error:
        return fail(f"{arguments[1]}: {error}")
    if not targets:
        return fail(f"no case of {arguments[1]} has a history")
    print(("Picture: " if len(targets) == 1 else "Pictures: ") + ", ".join(targets))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
