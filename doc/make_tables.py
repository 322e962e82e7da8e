#!/usr/bin/env python3
"""Makes the pages that list what the program knows by itself, from what it prints:

    build/ricochet template --json | doc/make_tables.py parameters >doc/parameters.md
    build/ricochet columns --json | doc/make_tables.py columns >doc/columns.md
"""
import json
import sys


def row(*cells):
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def table(heads, rows):
    return [row(*heads), "|" + "---|" * len(heads), *(row(*cells) for cells in rows), ""]


def code(text):
    return f"`{text}`" if text else ""


def group(names):
    return " and ".join(code(name) for name in names)


def any_of(words):
    return " or ".join(filter(None, [", ".join(words[:-1]), words[-1]]))


def condition(rule):
    return f" with {code(rule['if']['entry'])} = {any_of(rule['if']['values'])}" if "if" in rule else ""


def demand(entry):
    """When the entry has to be given."""
    if entry["required"]:
        return "yes"
    demands = []
    for rule in entry["rules"]:
        others = [names for names in rule["one_of"] if entry["name"] not in names]
        own = next(names for names in rule["one_of"] if entry["name"] in names)
        partners = [name for name in own if name != entry["name"]]
        text = "yes" + condition(rule)
        if partners:
            text += ", with " + group(partners)
        if others:
            text += ", or " + " or ".join(group(names) for names in others)
        demands.append(text)
    return "; ".join(demands) or "no"


def default(entry):
    if entry["default"] is not None:
        return code(entry["default"])
    return f"({entry['example']})"


def numbered(entries):
    """Axis 1 to Axis 20 are one row."""
    for entry in entries:
        name, _, number = entry["name"].rpartition(" ")
        if not (number.isdigit() and name == "Axis") or number == "1":
            yield entry


KINDS = {
    "scene": ("A scene", "One impact: `ricochet run`, `check`, `mesh`."),
    "study": ("A study", "Several runs: `ricochet study`. `Axis 2`, `Axis 3` and so on are like `Axis 1`."),
    "stability": ("A stability experiment", "Instead of a scene: `ricochet run`, [stability.md](stability.md)."),
}


def parameters(schema):
    lines = [
        "# Parameters", "",
        "Made by `build/ricochet template --json | doc/make_tables.py parameters >doc/parameters.md`; `build/ricochet template` prints the same as",
        "a file to start from. The syntax is in the [README](../README.md): `set NAME = VALUE` within `subsection SECTION` … `end`. A value",
        "in parentheses is an example where there is no default; `<file>` is the name of the parameter file.", "",
    ]
    for kind, (title, text) in KINDS.items():
        lines += [f"## {title}", "", text, ""]
        for section in (s for s in schema["sections"] if s["file"] == kind):
            entries = [e for e in schema["entries"] if (e["file"], e["section"]) == (kind, section["name"])]
            lines += [f"### {section['name'] or 'Outside the sections'}", ""]
            if section["meaning"]:
                lines += [section["meaning"], ""]
            lines += table(["entry", "what it expects", "default", "to be given", "meaning"],
                           [(e["name"], e["expected"], default(e), demand(e), e["meaning"]) for e in numbered(entries)])
    return lines


def columns(lists):
    heads = ["name", "unit", "meaning"]
    rows = {name: [(code(e["name"]), e["unit"], e["meaning"]) for e in lists[name]] for name in ("history", "summary", "frames")}
    return [
        "# Columns and fields", "",
        "Made by `build/ricochet columns --json | doc/make_tables.py columns >doc/columns.md`; `build/ricochet columns` prints the same. A",
        "unit of `-` means a number without one, none that it is no number.", "",
        "## history.csv", "",
        "One row per record, every `Output/History interval`; the head of a column is `name [unit]`. `history.h5` has a dataset of the same name",
        "per column. All numbers are those of whole bodies, also of a symmetric scene, of which one half is computed. With several projectiles",
        "the rows from `x` to `force z` are those of the first, and stand again behind all others with the number of each further one: `x 2`.", "",
        *table(heads, rows["history"]),
        "## summary.json", "",
        "Once, at the end. `plate_N_…` stands for each plate, `zones[]` for one object per plate, `positions[]` for one per stated time,",
        "`projectiles[]`, which is there if there are several, for one per projectile; the same fields without it are those of the first.",
        "Here, too, all numbers are those of whole bodies; but `bond_rate_per_core` is a rate of the work that is done, so of the half that is",
        "computed.", "",
        *table(heads, rows["summary"]),
        "## results.pvd", "",
        "The fields of points and elements in a frame for ParaView, every `Output/Frame interval`, of the half that is computed; ParaView shows",
        "`name [unit]`. `section.h5` has, of the layer next to the plane y = 0, `damage`, `pressure`, `von_mises`, `energy_density` and `body`.", "",
        *table(heads, rows["frames"]),
    ]


pages = {"parameters": parameters, "columns": columns}
if len(sys.argv) != 2 or sys.argv[1] not in pages:
    sys.exit(__doc__)
print("\n".join(pages[sys.argv[1]](json.load(sys.stdin))).rstrip())
