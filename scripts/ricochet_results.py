# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the results of a ricochet run or study into numpy. Columns are found by their names, wherever they stand.

    import ricochet_results
    run = ricochet_results.Run("output/quickstart")
    run.summary["outcome"], run.history["speed"], run.history.units["speed"]
    frame = run.frame(20.0)                     # of section.h5, the nearest to 20 us
    frame.time, frame.points, frame.damage      # us, mm, 0 to 1
    for case in ricochet_results.Study("output/study"):
        case.label, case.axes["speed_m_s"], case.run.summary["exit_speed_m_s"]

Needs numpy and h5py; lies beside the scripts that draw, which use it: share/ricochet/scripts of an installation.
"""

import csv
import functools
import json
import os
import re
import sys

try:
    import h5py
    import numpy as np
except ImportError as error:
    print(f"{os.path.basename(sys.argv[0])}: {error}; apt install python3-matplotlib python3-h5py", file=sys.stderr)
    sys.exit(3)

from read_table import without


class History:
    """The columns of history.csv by their names without unit; an incomplete last line is dropped."""

    def __init__(self, path):
        self.path = path
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.columns, self.units = {}, {}
        if not rows or not rows[0]:
            return
        rows, header = [row for row in rows[1:] if len(row) == len(rows[0])], rows[0]
        values = np.array(rows, dtype=float).reshape(-1, len(header))
        for head, column in zip(header, values.T):
            name, _, unit = head.partition(" [")
            self.columns[name.strip()] = column
            self.units[name.strip()] = unit.rstrip("] ")

    def __len__(self):
        return len(self.columns.get("time", ()))

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        if name == "path" and name not in self.columns:  # follows from the others
            steps = [np.diff(self[axis], prepend=self[axis][:1]) for axis in "xyz"]
            return np.cumsum(np.sqrt(sum(step**2 for step in steps)))
        if name not in self.columns:
            raise without(self.path, name, self.columns)
        return self.columns[name]

    def named_with_unit(self, unit):
        """Names of the columns of that unit, in their order."""
        return [name for name in self.columns if self.units[name] == unit]


class Frame:
    """One frame of section.h5, lengths in mm."""

    def __init__(self, group):
        self.time = group.attrs["time_s"] * 1e6  # us
        self.points = group["position"][:][:, [0, 2]] * 1e3
        self.damage = group["damage"][:]
        self.body = group["body"][:]
        names = ["outline"] + sorted((name for name in group if name.startswith("outline ")), key=lambda name: int(name.split()[1]))
        self.outlines = [group[name][:][:, [0, 2]] * 1e3 for name in names]  # of each projectile


class DamageMap:
    """One plate of damage.h5 from above, lengths in m; the maps have a row per x."""

    def __init__(self, file, plate):
        self.plate = plate  # "plate_1"
        self.spacing, self.x, self.y, self.mirrored = file[plate + "_grid"][:]
        self.front, self.rear, self.mean = (file[f"{plate}_{kind}"][:] for kind in ("front", "rear", "mean"))


def read_history(directory):
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


def read_study(directory):
    """What study.json says of a study: title, axes, cases; an empty object if there is none."""
    try:
        with open(os.path.join(directory, "study.json"), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


def stated_times(directory):
    """Times [s] at which the parameter file asks for panels; empty if it does not, or if the run has not ended."""
    summary = read_summary(directory) or {}
    return [position["time_us"] * 1e-6 for position in summary.get("positions", [])]


def read_frames(directory, stated=(), n_panels=6):
    """The frames at the stated times; without any, up to so many at even distances in time, the first and the last
    among them. And the first one of all again. Nothing if the run has none."""
    path = os.path.join(directory, "section.h5")
    if not os.path.exists(path):
        return [], None
    with h5py.File(path, "r") as file:
        names = sorted(file, key=lambda name: int(name.split("_")[1]))
        if not names:
            return [], None
        times = np.array([file[name].attrs["time_s"] for name in names])
        wanted = list(stated) or np.linspace(times[0], times[-1], min(n_panels, len(names)))
        if len(stated) % 2 == 1:
            wanted.append(times[-1])  # there is room for it
        chosen = sorted({int(np.argmin(np.abs(times - time))) for time in wanted})
        first = Frame(file[names[0]])
        first.spacings, first.extent = spacings(directory), plate_extent(directory)
        return [Frame(file[names[i]]) for i in chosen], first


def spacings(directory):
    """Grid spacing of the plates by their number [mm], as the run used it."""
    found, plate = {}, None
    try:
        with open(os.path.join(directory, "used.prm"), encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError:
        return found
    for line in lines:
        words = line.split("#")[0].split()
        if words[:2] == ["subsection", "Plate"]:
            plate = int(words[2])
        elif words[:1] == ["end"]:
            plate = None
        elif plate and words[:4] == ["set", "Grid", "spacing", "="]:
            number, unit = re.fullmatch(r"([-+.0-9eE]+?)([a-zµ]+)", "".join(words[4:])).groups()
            found[plate] = float(number) * {"um": 1e-3, "µm": 1e-3, "mm": 1, "cm": 10, "m": 1e3, "in": 25.4}[unit]
    return found


def plate_extent(directory):
    """Lowest and highest x and z of all plates before anything has moved [mm]; None if the run has not ended."""
    summary, number, length, thickness = read_summary(directory) or {}, 1, 0.0, 0.0
    while summary.get(f"plate_{number}_length_mm") is not None:
        length = max(length, summary[f"plate_{number}_length_mm"])
        thickness += summary[f"plate_{number}_thickness_mm"]
        number += 1
    return (np.array([0.0, -thickness]), np.array([length, 0.0])) if number > 1 else None


def read_damage(directory):
    """The maps of all plates from top to bottom; empty if the run has not ended."""
    path = os.path.join(directory, "damage.h5")
    if not os.path.exists(path):
        return []
    with h5py.File(path, "r") as file:
        plates = [name[: -len("_grid")] for name in file if name.endswith("_grid")]
        return [DamageMap(file, plate) for plate in sorted(plates, key=lambda name: int(name.split("_")[1]))]


def title_of(directory):
    """Title of the run and, if it has ended, its outcome."""
    name = os.path.basename(os.path.abspath(directory))
    summary = read_summary(directory)
    if summary is None:
        return name, "run not finished"
    outcome = str(summary.get("outcome", ""))
    parts = [{"perforate": "perforation", "undecided": "outcome undecided", "pushed": "pushes the target away",
              "edge": f"leaves through the edge of plate {summary.get('exit_plate', 1)}"}.get(outcome, outcome)]
    if summary.get("exit_speed_m_s") is not None and outcome != "stuck":
        parts.append(f"{'last' if outcome == 'undecided' else 'exit'} speed {summary['exit_speed_m_s']:.3g} m/s")
        if summary.get("exit_angle_deg") is not None:
            parts[-1] += f" at {summary['exit_angle_deg']:.1f}°".replace("-", "−")
    if summary.get("max_depth_mm") is not None:
        parts.append(f"greatest depth {summary['max_depth_mm']:.1f} mm")
    return summary.get("title") or name, "  ·  ".join(part for part in parts if part)


class Run:
    """The results of one run: summary (an empty dictionary if it has not ended), history (None if there is none), frames,
    damage maps. Each is read when it is first asked for."""

    def __init__(self, directory):
        self.directory = directory

    @functools.cached_property
    def summary(self):
        """summary.json."""
        return read_summary(self.directory) or {}

    @functools.cached_property
    def history(self):
        """history.csv, columns by their names without units."""
        return read_history(self.directory)

    @functools.cached_property
    def frame_times(self):
        """Times of all frames of section.h5 [us], in their order."""
        path = os.path.join(self.directory, "section.h5")
        if not os.path.exists(path):
            return np.array([])
        with h5py.File(path, "r") as file:
            return np.sort([file[name].attrs["time_s"] * 1e6 for name in file])

    def frame(self, time):
        """The frame nearest to a time [us]; None if there is none."""
        frames, _ = read_frames(self.directory, [time * 1e-6, time * 1e-6])
        return frames[0] if frames else None

    @functools.cached_property
    def damage_maps(self):
        """The maps of damage.h5, plate by plate from above."""
        return read_damage(self.directory)


class Case:
    """A case of a study: name, label, scene, status, values of the axes by the names of their columns, and its run."""

    def __init__(self, directory, study, record):
        self.name, self.label, self.status = record["name"], record["label"], record["status"]
        self.scene = record.get("scene", "")
        self.axes = dict(zip([axis["name"] for axis in study["axes"]], record["axes"]))
        self.run = Run(os.path.join(directory, self.name))


class Study(list):
    """The cases of a study, and what study.json says of it."""

    def __init__(self, directory):
        self.directory, self.record = directory, read_study(directory)
        super().__init__(Case(directory, self.record, record) for record in self.record.get("cases", []))
        self.axes, self.limits = self.record.get("axes", []), self.record.get("limits", [])
