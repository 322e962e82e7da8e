#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write report.html of a ricochet run or study: one file with verdict, pictures, interactive charts, tables, parameters.

    make_report.py DIRECTORY

Reads what the folder holds (summary.json, history.csv, used.prm, pictures; study.csv, study.json). Needs Python alone;
without plotly.js the report is plain. Exit status: 0 written, 1 nothing to report or not written, 2 wrong use.
"""

import os
import sys

import report_run
import report_study
from report_page import MISSING, library, write_page


def main(arguments):
    """Write what there is to say."""
    if len(arguments) != 2 or arguments[1] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if "-h" in arguments or "--help" in arguments else 2
    directory, packed = arguments[1], library()
    present = set(os.listdir(directory)) if os.path.isdir(directory) else set()
    if "study.json" in present:
        title, body = report_study.page(directory, packed)
    elif {"summary.json", "history.csv"} & present:
        title, body = report_run.page(directory, packed)
    else:
        print(f"make_report.py: {directory} has neither study.json nor summary.json", file=sys.stderr)
        return 1
    try:
        target = write_page(directory, title, body, packed)
    except OSError as error:
        print(f"make_report.py: {error}", file=sys.stderr)
        return 1
    print(f"Report: {target}" + ("" if packed else f" (plain: {MISSING})"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
