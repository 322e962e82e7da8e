# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read tables of results by the names of their columns."""

import csv
import json
import os


class MissingColumn(ValueError):
    """A table lacks a column that is needed."""


def without(path, name, columns):
    """The one message for a missing column."""
    return MissingColumn(f"{os.path.basename(path)} has no column '{name}'; it has {', '.join(columns) or 'none'}")


class Row(dict):
    """One row, which says where it comes from if asked for a column that it lacks."""

    def __init__(self, path, cells):
        super().__init__(cells)
        self.path = path

    def __missing__(self, name):
        raise without(self.path, name, self)

    def number(self, name, empty=None):
        """A column as a number, or what stands for an empty one."""
        return empty if self[name] in ("", "-", None) else float(self[name])


def read_csv(path):
    """The rows of a CSV file."""
    with open(path, newline="", encoding="utf-8") as file:
        return [Row(path, cells) for cells in csv.DictReader(file)]


def read_json_lines(file, path):
    """The JSON objects of an open file, one per line; ValueError if there is none."""
    rows = [Row(path, json.loads(line)) for line in file if line.strip()]
    if not rows:
        raise ValueError("no rows")
    return rows
