# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the report of one run says: verdict, figures, charts, balance, plates, parameters, origin."""

import os

from report_data import columns_of_data, read_columns, read_json, read_text
from report_page import COLORS, GREY, cards, chart, chip, folded, line, marks, number, picture, section
from report_page import section_of_charts, table, text

BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY = COLORS[:6]
TIME = {"title": "time [µs]"}
# From below; what the projectile keeps comes last, so that the top edge is the conserved total.
LAYERS = {"energy fracture": ("fracture", VERMILION), "energy plastic": ("plastic flow", "#7B3294"),
          "energy viscous": ("viscosity", "#8C564B"), "energy absorbed": ("left through the edges", "#17BECF"),
          "work friction": ("friction", ORANGE), "work debris friction": ("debris friction", "#B8860B"),
          "energy debris": ("debris contact", "#F0E442"), "energy contact": ("contact", PURPLE),
          "energy strain": ("plate strain", GREEN), "energy kinetic": ("plate motion", SKY),
          "energy projectile": ("projectile", "#AEB8C1")}


def verdict(summary):
    """One sentence."""
    outcome = str(summary.get("outcome", "no outcome"))
    reason = str(summary.get("reason", "the run has not ended"))
    return f'<p class="verdict">{chip(outcome)} {text(reason[:1].upper() + reason[1:])}.</p>'


def figures(summary):
    """Cards of what matters most."""
    entries = []

    def add(key, name, unit, remark, factor=1.0, digits=3):
        value = summary.get(key)
        if isinstance(value, (int, float)):
            entries.append((name, f"{number(factor * value, digits)} {unit}".strip(), remark))
    left = summary.get("outcome") not in ("undecided", "stuck", None)
    add("exit_speed_m_s", "exit speed" if left else "last speed", "m/s", "of the projectile")
    add("exit_angle_deg", "direction", "°", "against the plates, up is positive")
    add("max_depth_mm", "greatest depth", "mm", "below the front face")
    add("path_mm", "path", "mm", "of the centroid")
    add("time_us", "time", "µs", "at the end")
    add("energy_residual", "energy residual", "%", "of the impact energy", 100.0, 2)
    add("core_seconds", "cost", "core-s", f"{number(summary.get('points'))} points, {number(summary.get('steps'))} steps")
    return cards(entries)


def warnings(summary):
    """Whatever makes the results doubtful."""
    told = list(summary.get("warnings") or [])
    if summary.get("failed"):
        told.insert(0, f"The run broke down: {summary.get('reason', '')}")
    if summary.get("interrupted"):
        told.insert(0, "The run was interrupted; what follows is not the end of the event.")
    if not told:
        return ""
    return '<div class="warnings"><strong>Warnings</strong><ul>' + "".join(
        f"<li>{text(one)}</li>" for one in told) + "</ul></div>"


def data_of_others(summary):
    """The table of errors."""
    columns = columns_of_data(summary)
    if not columns:
        return ""
    rows = []
    for column in columns:
        for point in column["points"]:
            error = point["relative_error"]
            bar = "" if point["error_bar"] is None else f" ± {number(point['error_bar'])}"
            rows.append([f"{text(column['name'])} at {number(point['time_us'])} µs",
                         "–" if error is None else f"{100 * error:+.1f} %".replace("-", "−"),
                         f"{number(point['wanted'])}{bar} {text(column['unit'])}", number(point["found"]),
                         text(point["kind"] or "–")])
        rows.append([f"{text(column['name'])}, root-mean-square",
                     f"<strong>{number(column['rmse'])} {text(column['unit'])}</strong>", "", "", ""])
    source = "".join(f"<li>{text(one)}</li>" for one in summary["reference_data"].get("source", []))
    return table(["", "error", "theirs", "ours", "kind"], rows) + folded(
        f"Source: {os.path.basename(summary['reference_data']['file'])}", f"<ul>{source}</ul>")


def charts(history, units, summary):
    """All diagrams of a run."""
    data = {column["name"]: column["points"] for column in columns_of_data(summary)}
    times, made, shown = history.get("time", []), [], set()

    def over_time(title, entries, unit, **options):
        present = [entry for entry in entries if entry[0] in history]
        if not present:
            return
        traces = [line(label, times, history[name], color, **more) for name, label, color, *rest in present
                  for more in [rest[0] if rest else {}]]
        for name, *_ in present:
            if name in data:
                traces.append(marks(f"{name}, of others", data[name]))
                shown.add(name)
        made.append(chart(title, traces, TIME, {"title": unit}, kind="time", **options))

    over_time("Velocity", [("speed", "speed", BLUE), ("velocity x", "along x", VERMILION, {"line": {"dash": "dash"}}),
                           ("velocity z", "along z", GREEN, {"line": {"dash": "dash"}})], "velocity [m/s]")
    if "x" in history and "z" in history:
        made.append(chart("Path of the centroid", [
            line("path", history["x"], history["z"], BLUE, text=[f"{t:.1f} µs" for t in times],
                 hovertemplate="x %{x:.1f} mm, z %{y:.1f} mm<br>%{text}<extra></extra>"),
            line("front face", [min(history["x"], default=0), max(history["x"], default=1)], [0, 0], GREY,
                 line={"dash": "dot"}, hoverinfo="skip")], {"title": "x [mm]"},
            {"title": "z [mm]", "scaleanchor": "x"}, hover="closest"))
    layers = [(name, label, color, {"stackgroup": "all", "line": {"width": 0.5}, "fillcolor": color})
              for name, (label, color) in LAYERS.items() if any(history.get(name, []))]
    over_time("Where the energy is", layers, "energy [J]", wide=True, side=True)
    over_time("Contact force", [("force normal", "normal", BLUE), ("force friction", "friction", VERMILION),
                                ("force shank", "shank", GREEN)], "force [kN]")
    over_time("Pitch, nose up", [("pitch", "pitch", BLUE)], "pitch [°]")
    if "residual relative" in history:
        history["residual"] = [100 * value for value in history["residual relative"]]
        over_time("Energy that the balance does not account for", [("residual", "residual", BLUE)], "residual [% of the impact energy]")
    for name in data:
        if name in history and name not in shown:
            over_time(name.capitalize(), [(name, name, BLUE)], f"{name} [{units.get(name, '')}]")
    return made


def balance(history, units, summary):
    """Energies at the start and at the end, and what momentum has drifted."""
    names = [name for name, unit in units.items() if unit == "J" and name in history and any(history[name])]
    if not names or not history["time"]:
        return ""
    whole = abs(history["energy projectile"][0]) if history.get("energy projectile") else 0.0
    rows = []
    for name in names:
        first, last = history[name][0], history[name][-1]
        share = 100 * last / whole if whole else 0.0
        first, last = (0.0 if abs(value) < 1e-9 * whole else value for value in (first, last))  # rounding
        rows.append([text(name), number(first), number(last),
                     f'<span class="bar" style="width:{max(0.0, min(100.0, share)):.1f}px"></span>{number(share, 3)}'])
    drift = [[name, number(summary.get(key), 2)] for name, key in (
        ("momentum: change over that at the start", "momentum_drift"),
        ("angular momentum: the same", "angular_momentum_drift")) if summary.get(key) is not None]
    return table(["energy [J]", "at the start", "at the end", "% of the impact"], rows) + (
        table(["balance of momenta", ""], drift) if drift else "")


def plates(summary):
    """Per plate what was computed and what is broken."""
    rows = []
    n = 1
    while f"plate_{n}_length_mm" in summary:
        def get(key, n=n):
            return summary.get(f"plate_{n}_{key}")
        size = " × ".join(number(get(key)) for key in ("length_mm", "width_mm", "thickness_mm"))
        share = get("broken_share")
        rows.append([f"plate {n}", size, "–" if share is None else f"{100 * share:.2f}", number(get("front_damaged_mm2")),
                     number(get("rear_damaged_mm2"))])
        n += 1
    return table(["", "size [mm]", "broken bonds [%]", "damaged front [mm²]", "damaged rear [mm²]"], rows) if rows else ""


def everything(summary):
    """All fields of the summary that are numbers or words."""
    rows = [[text(key), number(value) if not isinstance(value, str) else text(value)] for key, value in summary.items()
            if not isinstance(value, (dict, list))]
    return table([], rows, "words") if rows else ""


def origin(summary, directory):
    """How to make it again."""
    rows = [["version", text(summary.get("version", "unknown"))],
            ["command", f"<code>{text(summary.get('command') or 'not recorded')}</code>"],
            ["processes", number(summary.get("ranks"))], ["kernels", text(summary.get("instruction_set", "–"))],
            ["time step", f"{number(summary.get('time_step_us'))} µs"], ["folder", text(summary.get("directory", directory))]]
    return table([], rows, "words")


def page(directory, packed):
    """Title and body."""
    summary = read_json(directory, "summary.json")
    history, units = read_columns(directory)
    title = summary.get("title") or os.path.basename(os.path.abspath(directory))
    used = read_text(os.path.join(directory, "used.prm"))
    pictures = (picture(directory, "section.png", "The plates in the plane of flight")
                + picture(directory, "damage.png", "Damage from above: faces, and the mean through the thickness"))
    body = [f"<header><h1>{text(title)}</h1>{verdict(summary)}"
            f'<p class="origin">ricochet {text(summary.get("version", ""))}</p></header>', warnings(summary),
            figures(summary), section("Against data of others", data_of_others(summary)), section("Pictures", pictures),
            section_of_charts(charts(history, units, summary),
                              picture(directory, "history.png", "Motion, forces and energies over time")
                              + picture(directory, "reference.png", "Against data of others"), packed),
            section("Energy and momentum", balance(history, units, summary)), section("Plates", plates(summary)),
            section("How it was made", origin(summary, directory)
                    + folded("Parameters as used (used.prm)", f"<pre>{text(used)}</pre>" if used else "")
                    + folded("All of summary.json", everything(summary)))]
    return title, "".join(body)
