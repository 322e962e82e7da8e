# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw history.png: motion, forces and energies of a run over time."""

import os

# First, because they say what to install if it is missing.
from plot_reference import overlay
from plot_style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, plt, save, ticks, write_title
from ricochet_results import title_of

import numpy as np


def lines(axes, history, entries, ylabel):
    """One line per column; a legend if there is more than one."""
    for name, label, color, style in entries:
        axes.plot(history["time"], history[name], color=color, linestyle=style, label=label)
    axes.set_ylabel(ylabel)
    axes.set_xlabel("time [µs]")
    if len(entries) > 1:
        axes.legend(loc="best", handlelength=1.6, labelspacing=0.3)


def draw_path(axes, history):
    """The way of the centre of mass in the plane of the flight."""
    axes.plot(history["x"], history["z"], color=BLUE)
    axes.plot(history["x"][:1], history["z"][:1], "o", color=BLUE, markersize=4, markerfacecolor="white")
    axes.plot(history["x"][-1:], history["z"][-1:], "o", color=BLUE, markersize=4)
    axes.axhline(0, color=GREY, linewidth=0.8, linestyle=(0, (4, 3)))
    axes.annotate("plate surface", (0.99, 0), xycoords=("axes fraction", "data"), xytext=(0, 2),
                  textcoords="offset points", ha="right", va="bottom", size=7.5, color=GREY)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z of the centroid [mm]")
    axes.margins(0.06, 0.1)
    axes.set_aspect("equal", adjustable="datalim")


# Stacked from below; what the projectile keeps is drawn last, so that the top edge is the conserved total. Other
# columns in joules come between, in grey, if they are not zero: a new kind of energy shows without a change here.
ENERGIES = {
    "energy fracture": ("fracture", VERMILION),
    "energy viscous": ("viscosity", "#8C564B"),
    "energy absorbed": ("left through the edges", "#17BECF"),
    "work friction": ("friction", ORANGE),
    "work debris friction": ("debris friction", "#B8860B"),
    "energy debris": ("debris contact", "#F0E442"),
    "energy contact": ("contact", PURPLE),
    "energy strain": ("plate strain", GREEN),
    "energy kinetic": ("plate motion", SKY),
    "energy projectile": ("projectile", "#B9C2CB"),
}
SELDOM = ("energy viscous", "energy absorbed", "work debris friction")  # not shown if zero
OTHERS = ("#5C5C5C", "#7A7A7A", "#989898")


def layers_of(history):
    """The energies to be stacked: values, labels and colours."""
    joules = history.named_with_unit("J")
    unknown = [name for name in joules if name not in ENERGIES and name != "energy residual" and np.any(history[name])]
    known = [name for name in ENERGIES if name in joules and (name not in SELDOM or np.any(history[name]))]
    layers = [(history[name], *ENERGIES[name]) for name in known]
    others = [(history[name], name.replace("energy ", ""), OTHERS[i % len(OTHERS)]) for i, name in enumerate(unknown)]
    return layers[:-1] + others + layers[-1:]


def draw_energies(axes, history):
    """Where the projectile's energy has gone, as layers."""
    present = layers_of(history)
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
    write_title(figure, *title_of(directory))
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
    overlay(speed, directory, ("speed", "velocity x", "velocity z"))
    overlay(pitch, directory, ("pitch",))
    overlay(force, directory, ("force normal", "force friction", "force shank"))
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
