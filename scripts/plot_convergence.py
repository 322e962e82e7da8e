# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw convergence.png, errors over the resolution of a study of convergence with the observed orders, and
convergence_damage.png, the sections of its grids side by side at the same times."""

import os

from plot_damage import draw_damage_bar
from plot_section import draw_frame, sizes_of, window
from plot_style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, close_box, plain, plt, save, ticks
from read_table import read_csv
from ricochet_results import Study, read_frames

import numpy as np
from matplotlib.ticker import LogLocator

COLORS = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK]
MARKS = "oD^vPXs"
LEAST = 0.01  # errors below this are no matter of interest [%]
N_TIMES = 3  # of the sections side by side
MOST_GRIDS = 4


def resolution_of(rows, axis):
    """Values for the axis of resolution, the finer the further right, and its name."""
    if all(row.number("points_per_calibre") is not None for row in rows):
        return [row.number("points_per_calibre") for row in rows], "points per calibre"
    return [1 / row.number(axis) for row in rows], f"1 / {axis.replace('_', ' ')}"


def order_of(orders, group, quantity):
    """What stands behind a curve: the observed order or that there is none."""
    for row in orders:
        if row["group"] == group and row["quantity"] == quantity:
            if row["order"] in ("-", ""):
                return "order none"
            spread = "" if row["uncertainty"] in ("-", "") else f" ± {row.number('uncertainty'):.2g}"
            return f"order {row.number('order'):.2f}{spread}"
    return "order none"


def curves_of(rows):
    """Columns of errors and the quantities they are of."""
    columns = [("path_error_percent", "path_mm", "path")]
    for name in rows[0]:
        if name.endswith("_error_percent") and name != "path_error_percent":
            quantity = name[: -len("_error_percent")]
            shown = quantity
            for unit in ("_m_s", "_mm2", "_mm"):
                shown = shown.removesuffix(unit)
            columns.append((name, quantity, shown.replace("_", " ")))
    return columns


def draw_errors(study, rows, orders):
    """convergence.png: one panel per set of values of the other axes."""
    axis = study.axes[0]["name"]
    groups = list(dict.fromkeys(row["group"] for row in rows))
    figure, panels = plt.subplots(len(groups), 1, squeeze=False, layout="constrained",
                                  figsize=(7.6, 3.1 * len(groups) + 0.4))
    for panel, group in zip(panels.flat, groups):
        chosen = [row for row in rows if row["group"] == group]
        x, name = resolution_of(chosen, axis)
        for i, (column, quantity, shown) in enumerate(curves_of(chosen)):
            points = [(place, max(LEAST, abs(row.number(column)))) for place, row in zip(x, chosen)
                      if row.number(column) is not None and row["reference"] != "1"]
            if not points:
                continue
            panel.plot(*zip(*points), color=COLORS[i % len(COLORS)], linestyle=["-", "--", ":"][i // len(COLORS) % 3], marker=MARKS[i % len(MARKS)], markersize=5, markeredgecolor="white",
                       label=f"{shown}: {order_of(orders, group, quantity)}")
        for place, row in zip(x, chosen):
            if row["reference"] == "1":
                panel.axvline(place, color="#999999", linewidth=0.9, linestyle=(0, (5, 3)))
                panel.text(place, 0.98, " reference", size=7.5, color="#666666", ha="right", va="top", rotation=90,
                           transform=panel.get_xaxis_transform())
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        panel.set_xticks(x, [f"{place:.3g}" for place in x])
        panel.minorticks_off()
        panel.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
        panel.set_xlabel(name)
        panel.set_ylabel("error against the reference [%]")
        panel.grid(color="#E3E3E3", linewidth=0.6)
        panel.set_axisbelow(True)
        panel.set_title("" if group == "-" else plain(group), loc="left")
        panel.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0)
    figure.suptitle(plain(study.record.get("title", "")), size=11, weight="bold", x=0.01, ha="left")
    target = os.path.join(study.directory, "convergence.png")
    save(figure, target)
    return target


def grids_of(study):
    """Of the first set of values of the other axes: a case per grid, from the coarsest, the finest among them."""
    axis = study.axes[0]["name"]
    with_frames = [case for case in study if len(case.run.frame_times) > 0]
    first = {}
    for case in with_frames:
        rest = [value for name, value in case.axes.items() if name != axis]
        if rest == [value for name, value in with_frames[0].axes.items() if name != axis]:
            first.setdefault(case.axes[axis], case)
    grids = [first[value] for value in sorted(first, reverse=True)]
    return grids[-MOST_GRIDS:]


def draw_damage_of_grids(study):
    """convergence_damage.png: a row per time, a column per grid; None without frames."""
    grids = grids_of(study)
    if len(grids) < 2:
        return None
    last = min(case.run.frame_times[-1] for case in grids)
    coarse = [time for time in grids[0].run.frame_times if time <= last * (1 + 1e-9)]
    times = [coarse[-1 - (len(coarse) - 1) * i // N_TIMES] for i in range(min(N_TIMES, len(coarse)))][::-1]
    shown = [(case, *read_frames(case.run.directory, [time * 1e-6 for time in times for _ in (0, 1)])) for case in grids]
    if any(len(frames) == 0 for _, frames, _ in shown):
        return None
    limits = [window(frames, first) for _, frames, first in shown]
    low, high = np.min([limit[0] for limit in limits], axis=0), np.max([limit[1] for limit in limits], axis=0)
    ratio = (high[1] - low[1]) / (high[0] - low[0])
    n_rows = min(len(frames) for _, frames, _ in shown)
    panel, left, right, top, bottom, gap_x, gap_y = 2.9, 0.62, 0.95, 0.62, 0.5, 0.14, 0.28
    width = left + len(grids) * panel + (len(grids) - 1) * gap_x + right
    height = top + n_rows * panel * ratio + (n_rows - 1) * gap_y + bottom
    figure = plt.figure(figsize=(width, height))
    figure.text(0.12 / width, 1 - 0.12 / height, plain(f"{study.record.get('title', '')}: damage at the same times"), size=11,
                weight="bold", va="top")
    for column, (case, frames, first) in enumerate(shown):
        for row, frame in enumerate(frames[-n_rows:]):
            x, y = left + column * (panel + gap_x), bottom + (n_rows - 1 - row) * (panel * ratio + gap_y)
            axes = figure.add_axes([x / width, y / height, panel / width, panel * ratio / height])
            plates = draw_frame(axes, frame, sizes_of(first), None)
            axes.set_xlim(low[0], high[0])
            axes.set_ylim(low[1], high[1])
            axes.xaxis.set_major_locator(ticks(5))
            axes.yaxis.set_major_locator(ticks(4))
            close_box(axes)
            axes.set_title(f"{plain(case.label)}, {frame.time:.1f} µs", loc="left", pad=3, size=8)
            axes.tick_params(labelbottom=row == n_rows - 1, labelleft=column == 0)
            if row == n_rows - 1:
                axes.set_xlabel("x [mm]", labelpad=2)
            if column == 0:
                axes.set_ylabel("z [mm]", labelpad=2)
    draw_damage_bar(figure, plates, right, bottom, n_rows * panel * ratio + (n_rows - 1) * gap_y)
    target = os.path.join(study.directory, "convergence_damage.png")
    save(figure, target)
    return target


def draw_convergence(directory):
    """What there is of both; nothing if the study is none of convergence."""
    path = os.path.join(directory, "convergence.csv")
    rows = read_csv(path) if os.path.exists(path) else []
    if not rows:
        return []
    study, orders = Study(directory), read_csv(os.path.join(directory, "convergence_orders.csv"))
    return [target for target in (draw_errors(study, rows, orders), draw_damage_of_grids(study)) if target]
