#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open the reports of a run and of a study in headless Chromium: all charts are drawn, the console stays silent, and
nothing is wider than the screen, at 400 and 1400 pixels, light and dark.

    browse_reports.py PROGRAM QUICKSTART.prm

Exit status 77, skipped, without Chromium or plotly.js.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
STUDY = """subsection Study
  set Title = Two speeds, two angles
  set Scenes = {scene}
  set Axis 1 = Impact/Speed: 600 m/s | 800 m/s
  set Axis 2 = Impact/Incidence angle: 20 deg | 30 deg
  set Settings = Plate 1/Grid spacing: 4 mm; Time/Final time: 20 us; Output/ParaView files: false; Output/Pictures: false
  set Output directory = {folder}/study
end
"""
# The page in a frame of the wanted width, since a window has a least one; what it finds stands in the frame's title.
FRAME = """<!doctype html><body style="margin:0"><iframe id="frame" src="{page}" width="{width}" height="900"></iframe>
<script>setTimeout(() => {{ const page = document.getElementById("frame").contentDocument; document.body.dataset.found =
JSON.stringify({{charts: page.body.dataset.charts, drawn: page.querySelectorAll(".plot .main-svg .xy").length,
wide: page.documentElement.scrollWidth}}); }}, 8000);</script>"""


def browse(chromium, folder, page, width, dark):
    """What the page has drawn; the console."""
    frame = os.path.join(folder, "frame.html")
    with open(frame, "w", encoding="utf-8") as file:
        file.write(FRAME.format(page=page, width=width))
    command = [chromium, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
               "--allow-file-access-from-files", "--enable-logging=stderr", "--virtual-time-budget=10000",
               "--window-size=1500,1000", "--dump-dom", "file://" + frame]
    if dark:
        command.insert(1, "--blink-settings=preferredColorScheme=0")
    done = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    found = re.search(r'data-found="([^"]*)"', done.stdout)
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    return json.loads(found[1].replace("&quot;", '"')) if found else {}, console


def main(program, scene):
    """Make the results, look at their reports."""
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if not chromium:
        print("skipped: there is no chromium (apt install chromium)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "study.prm"), "w", encoding="utf-8") as file:
            file.write(STUDY.format(scene=scene, folder=folder))
        done = subprocess.run([program, "study", os.path.join(folder, "study.prm"), "--quiet"], capture_output=True,
                              text=True, check=True)
        if "(plain:" in done.stdout:
            print("skipped: there is no plotly.js (apt install python3-plotly)")
            return SKIPPED
        failed = 0
        case = "quickstart__speed_600_m_s__incidence_angle_20_deg"
        for page, charts in ((f"{folder}/study/report.html", 5), (f"{folder}/study/{case}/report.html", 6)):
            for width in (400, 1400):
                for dark in (False, True):
                    found, console = browse(chromium, folder, page, width, dark)
                    right = (found.get("charts") == str(charts) and found.get("drawn", 0) >= charts
                             and found.get("wide", width + 1) <= width and not console)
                    failed += not right
                    print("right" if right else "WRONG", os.path.relpath(page, folder), width, "dark" if dark else "light",
                          found, *console)
        return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
