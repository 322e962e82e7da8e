#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports are whole and need nothing from outside: made of results that are made up, and taken apart again.

    test_report.py SCRIPT_DIRECTORY
"""

import html.parser
import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import make_report
import report_page
import report_run
import report_study

VOID = {"meta", "img", "br", "input", "link", "hr"}
PNG = b"\x89PNG\r\n\x1a\n"


class Page(html.parser.HTMLParser):
    """Checks that tags are closed as they are opened; gathers texts of elements with an id, images and outside links."""

    def __init__(self, path):
        super().__init__()
        self.open, self.by_id, self.images, self.outside, self.plots = [], {}, 0, [], 0
        self.identity, self.words = None, []
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())
        assert not self.open, self.open

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag not in VOID:
            self.open.append(tag)
        self.images += tag == "img" and attrs["src"].startswith("data:image/png;base64,")
        self.plots += attrs.get("class") == "plot"
        self.outside += [value for name, value in attrs.items()
                         if name in ("src", "href") and value.partition(":")[0] in ("http", "https", "file")]
        assert tag not in ("link", "iframe")
        self.identity = attrs.get("id")

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()

    def handle_data(self, data):
        self.words.append(data)
        if self.identity:
            self.by_id[self.identity] = data
            self.identity = None


def write(folder, name, content):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def write_run(folder, title="A <run> & more", **more):
    write(folder, "summary.json", json.dumps(
        {"title": title, "outcome": "ricochet", "reason": "it has left", "exit_speed_m_s": 300.0, "max_depth_mm": None,
         "warnings": ["careful: </script>"], "plate_1_length_mm": 198.0, "plate_1_width_mm": 96.0,
         "plate_1_thickness_mm": 24.0, "momentum_drift": 1e-12, "version": "0", "command": "ricochet run 'a b.prm'",
         "reference_data": {"file": "exp.csv", "source": ["A. Uthor"], "columns": [
             {"name": "path", "unit": "mm", "rmse": 1.5, "points": [
                 {"time_us": 5.0, "kind": "inferred", "wanted": 10.0, "error_bar": 1.0, "found": 9.0,
                  "relative_error": -0.1},
                 {"time_us": 99.0, "kind": "", "wanted": 10.0, "error_bar": None, "found": None,
                  "relative_error": None}]}]}, **more}))
    write(folder, "history.csv", "time [us],x [mm],y [mm],z [mm],speed [m/s],energy projectile [J],residual relative [-]\n"
          + "".join(f"{t},{t},0,{-t},{700 - t},{100 - t},nan\n" for t in range(10)) + "10,10")  # cut off
    write(folder, "used.prm", "set Title = <x>\n")
    write(folder, "section.png", PNG)


class Report(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = self.scratch.name

    def tearDown(self):
        self.scratch.cleanup()

    def page(self, packed=b"packed"):
        kind = report_study if os.path.exists(os.path.join(self.folder, "study.json")) else report_run
        return Page(report_page.write_page(self.folder, *kind.page(self.folder, packed), packed))

    def test_run(self):
        write_run(self.folder)
        page = self.page()
        text = "".join(page.words)
        self.assertIn("A <run> & more", text)  # escaped, not taken for a tag
        self.assertIn("careful: </script>", text)
        self.assertIn("−10.0 %", text)
        self.assertIn("ricochet run 'a b.prm'", text)
        self.assertIn("set Title = <x>", text)
        self.assertEqual(page.images, 1)
        self.assertEqual(page.outside, [])
        charts = json.loads(page.by_id["chart-data"])
        self.assertEqual(page.plots, len(charts))
        titles = [chart["title"] for chart in charts]
        for title in ("Velocity", "Path of the centroid", "Where the energy is", "Path"):
            self.assertIn(title, titles)
        residual = charts[titles.index("Energy that the balance does not account for")]
        self.assertEqual(residual["traces"][0]["y"][0], None)  # not a number is a gap
        path = charts[titles.index("Path")]["traces"]
        self.assertAlmostEqual(path[0]["y"][-1], 9 * 2**0.5, places=4)
        self.assertEqual(path[1]["marker"]["symbol"], ["circle-open", "circle"])
        self.assertEqual(charts[titles.index("Path of the centroid")]["y"]["scaleanchor"], "x")

    def test_study(self):
        write(self.folder, "study.json", json.dumps(
            {"title": "Two", "file": "", "axes": [{"name": "speed_m_s", "label": "speed", "unit": "m/s", "is_number": True}],
             "cases": [{"name": "a", "label": "300 m/s", "axes": [300.0], "status": "ok"},
                       {"name": "b", "label": "400 m/s", "axes": [400.0], "status": "failed: because"}]}))
        write(self.folder, "study.csv", "case,speed_m_s,outcome,status\na,300.0,ricochet,ok\nb,400.0,-,failed: because\n")
        write_run(os.path.join(self.folder, "a"))
        page = self.page()
        text = "".join(page.words)
        self.assertIn("400 m/s: failed: because", text)
        self.assertIn("1 of 2 without result", text)
        self.assertIn("speed [m/s]", text)
        titles = [chart["title"] for chart in json.loads(page.by_id["chart-data"])]
        self.assertEqual(titles, ["Exit speed; marks by outcome", "Paths of the centroid", "Speed", "Path"])

    def test_limits_convergence_and_advice_of_a_study(self):
        write(self.folder, "study.json", json.dumps({"title": "", "file": "", "axes": [], "cases": [], "limits": [
            {"group": "30 deg", "label": "speed", "unit": "m/s", "low": 700.0, "high": 710.0, "low_outcome": "ricochet",
             "high_outcome": "perforate", "runs": 8, "is_found": True, "status": "found"},
            {"group": "40 deg", "label": "speed", "unit": "m/s", "low": 500.0, "high": 900.0, "low_outcome": "stuck",
             "high_outcome": "stuck", "runs": 2, "is_found": False, "status": "not found: the range does not hold it"}]}))
        write(self.folder, "study.csv", "case,status\n")
        write(self.folder, "convergence_orders.csv", "group,quantity,order\n-,path_mm,1.93\n")
        write(self.folder, "convergence_damage.png", PNG)
        write(self.folder, "comparison.txt", "Within 2 % the cheapest is <a>.\n")
        page = self.page()
        text = "".join(page.words)
        for said in ("705 ± 5 m/s", "the range does not hold it", "1.93", "Within 2 % the cheapest is <a>."):
            self.assertIn(said, text)
        self.assertEqual(page.images, 1)

    def test_without_library_it_is_plain(self):
        write_run(self.folder)
        write(self.folder, "history.png", PNG)
        page = self.page(packed=None)
        self.assertEqual(page.plots, 0)
        self.assertNotIn("chart-data", page.by_id)
        self.assertEqual(page.images, 2)
        self.assertIn(report_page.MISSING, "".join(page.words))

    def test_broken_results_are_no_obstacle(self):
        for summary, history in (("{", "time [us]\n"), ("[]", ""), ("{}", "time [us],x [mm]\nword,word\n")):
            write(self.folder, "summary.json", summary)
            write(self.folder, "history.csv", history)
            self.assertEqual(make_report.main(["make_report.py", self.folder]), 0)

    def test_nothing_is_said(self):
        self.assertEqual(make_report.main(["make_report.py", self.folder]), 1)
        self.assertEqual(make_report.main(["make_report.py"]), 2)


if __name__ == "__main__":
    unittest.main()
