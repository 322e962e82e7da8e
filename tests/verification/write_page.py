#!/usr/bin/env python3
"""Makes doc/verification.md from what the tests noted:

    RICOCHET_VERIFICATION=build/verification ctest --test-dir build
    tests/verification/write_page.py build/verification > doc/verification.md

A requirement that is checked several times (in a loop, on several ranks) has one row: the worst.
"""
import pathlib
import sys

# The list, and why a number has no test.
TITLES = {
    1: "Linear patch: a block of points with corners inside elements, six uniform strains",
    2: "Rigid translation and rotation by 90° cause no force",
    3: "A spinning body keeps energy and momenta",
    4: "A body shaken by white noise keeps its discrete energy",
    5: "Static bar of points, elements, points",
    6: "Quadratic patch: a bar under its own weight",
    7: "Waves through the interface, both ways",
    8: "Bars that collide, and a bar on a rigid wall (St Venant)",
    9: "Dispersion of lattice and elements",
    10: "Convergence in the horizon under a sine load",
    11: "First bending frequency of a cantilever of 100 x 10 x 10 mm",
    12: "Hertz: a steel ball of 10 mm radius falls on PMMA at 1 m/s",
    13: "A slow crack dissipates the energy release rate",
    14: "Speed and branching of a steady crack in a strip of PMMA",
    15: "Branching of a crack in a plate of glass under a traction",
    16: "Kalthoff and Winkler: angle of a crack under an edge impact",
    17: "Sphere through a brittle disk, the example of LAMMPS (Howto_peri)",
    18: "Taylor bar of copper",
    19: "A sliding block stops where Coulomb says",
    20: "A sliding sphere begins to roll at 5/7 of its speed",
    21: "Oblique rebound of a sphere in gross slip",
    22: "Elements become points ahead of a pulse and under it",
    23: "An impact with the interface at several distances",
    24: "Any number of ranks gives the same result",
    25: "Dashpots at the end of a bar of elements",
    26: "Oblique impact on plates of PMMA against the published experiments and simulations",
    27: "What must fail, fails: couplings, steps, calibrations and a weighted volume that is recomputed",
    28: "Metamorphic checks: the same event told in another way has the same course, another event has not",
}
UNTESTED = {
    14: "not done yet",
    15: "not done yet",
    16: "not done yet",
    18: "does not apply: projectiles are rigid or elastic",
    26: "not a test but studies of core-hours: single_plate.md, three_layers.md, viscoelastic.md",
}
HEAD = """# Verification

Numbers that must come out, each asked by a test. Made from the tests themselves, on the machine at hand; do not edit by hand:

    RICOCHET_VERIFICATION=build/verification ctest --test-dir build
    tests/verification/write_page.py build/verification > doc/verification.md

The test `Verification.PageNamesWhatTheTestsAsk` fails if a requirement stands here and in no test, or the other way round.
Where more was asked than is reached, the requirement says so in brackets, and the test holds what is reached. Measured is the worst
of all cases of a row, in units of the tests: lengths of waves in horizons, M the modulus of P waves, h the edge of an element.
"""


def read(folder):
    """Rows by (number, requirement): the worst measurement of each."""
    rows = {}
    for file in sorted(pathlib.Path(folder).glob("*.tsv")):
        for line in file.read_text(encoding="utf-8").splitlines():
            number, requirement, measured, relation, limit, tolerance, test = line.split("\t")
            measured, limit, tolerance = float(measured), float(limit), float(tolerance)
            # How much of what is allowed is used up; the larger, the worse.
            used = {"<=": measured - limit, ">=": limit - measured, "=": abs(measured - limit)}[relation]
            key = (int(number[1:]), requirement)
            if key not in rows or used > rows[key][0]:
                rows[key] = (used, measured, relation, limit, tolerance, test)
    return rows


def wanted(relation, limit, tolerance):
    if relation == "=":
        return f"{limit:.6g} ± {tolerance:.2g}" if tolerance > 0.0 else f"{limit:.6g}"
    return {"<=": "≤", ">=": "≥"}[relation] + f" {limit:.3g}"


def page(rows):
    lines = [HEAD]
    for number, title in TITLES.items():
        mine = {requirement: row for (n, requirement), row in rows.items() if n == number}
        lines.append(f"## V{number}: {title}\n")
        if number in UNTESTED:
            assert not mine, f"V{number} has a test: take it off the list of those without"
            lines.append(UNTESTED[number][0].upper() + UNTESTED[number][1:] + ".\n")
            continue
        if not mine:
            sys.exit(f"V{number}: no test noted anything; run all tests, the long ones too")
        lines += ["| asked | limit | measured | test |", "|---|---|---|---|"]
        for requirement, (_, measured, relation, limit, tolerance, test) in sorted(mine.items()):
            lines.append(f"| {requirement} | {wanted(relation, limit, tolerance)} | {measured:.6g} | `{test}` |")
        lines.append("")
    return "\n".join(lines).rstrip("\n") + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.stdout.write(page(read(sys.argv[1])))
