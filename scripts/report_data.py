# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as a report needs them, read with nothing but Python itself."""

import csv
import json
import math
import os

MOST_ROWS = 1500  # more points than a chart of this width has pixels


def read_json(directory, name):
    """An object; empty if there is none."""
    try:
        with open(os.path.join(directory, name), encoding="utf-8") as file:
            found = json.load(file)
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def read_text(path):
    """A text file, or nothing."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def read_columns(directory):
    """history.csv: values by name without unit, thinned, and units; `path` too. Empty if there is none."""
    try:
        with open(os.path.join(directory, "history.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        header = rows[0]
        rows = [[float(cell) for cell in row] for row in rows[1:] if len(row) == len(header)]
    except (OSError, ValueError, IndexError):
        return {}, {}
    heads = [head.partition(" [") for head in header]
    columns = {name: [row[i] for row in rows] for i, (name, _, _) in enumerate(heads)}
    units = {name: unit.rstrip("]") for name, _, unit in heads}
    if all(axis in columns for axis in "xyz"):
        path, places = [0.0], list(zip(*(columns[axis] for axis in "xyz")))
        for one, other in zip(places, places[1:]):
            path.append(path[-1] + math.dist(one, other))
        columns["path"], units["path"] = path[: len(places)], "mm"
    stride = -(-len(rows) // MOST_ROWS) or 1
    kept = sorted({*range(0, len(rows), stride), *([len(rows) - 1] if rows else [])})
    return {name: [values[i] for i in kept] for name, values in columns.items()}, units


def columns_of_data(summary):
    """What the summary compares with data of others, column by column."""
    return (summary.get("reference_data") or {}).get("columns", [])
