#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results are read as they were written, and the pictures of studies that are made up show what there is.

    test_results.py SCRIPT_DIRECTORY

Exit status 77, skipped, without matplotlib or h5py.
"""

import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
try:
    import h5py
    import matplotlib  # noqa: F401, asked for by what is imported next
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)
import plot_accuracy
import plot_convergence
import plot_map
import plot_style
import ricochet_results


def write(folder, name, content):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(content if isinstance(content, str) else json.dumps(content))


def write_run(folder, outcome="ricochet", speed=300.0):
    write(folder, "summary.json", {"outcome": outcome, "exit_speed_m_s": speed, "plate_1_length_mm": 4.0,
                                   "plate_1_thickness_mm": 2.0})
    write(folder, "history.csv", "time [us],x [mm],y [mm],z [mm]\n0,0,0,0\n1,3,0,4\n2,3")  # cut off
    write(folder, "used.prm", "subsection Plate 1\n  set Grid spacing = 1 mm\nend\n")
    with h5py.File(os.path.join(folder, "section.h5"), "w") as file:
        for number, time in enumerate((0.0, 1e-6, 2e-6)):
            group = file.create_group(f"frame_{number}")
            group.attrs["time_s"] = time
            group["position"] = np.array([[0.0, 0.0, -1e-3], [1e-3, 0.0, -1e-3 - time]])
            group["damage"], group["body"] = np.array([0.0, 0.5]), np.array([1, 1])
            group["outline"] = np.array([[0.0, 0.0, 0.0], [1e-3, 0.0, 0.0], [1e-3, 0.0, 1e-3]])


def axis(name, label, unit):
    return {"name": name, "label": label, "unit": unit, "is_number": True}


class Results(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = self.scratch.name

    def tearDown(self):
        self.scratch.cleanup()

    def write_study(self, axes, values, **more):
        """A case per row of values, all but the last one of which have run."""
        names = [f"case_{i}" for i in range(len(values))]
        write(self.folder, "study.json", {"title": "A $study$", "axes": axes, "cases": [
            {"name": name, "label": f"no {name}", "scene": "a", "axes": row, "status": "ok"}
            for name, row in zip(names, values)], **more})
        for i, name in enumerate(names[:-1]):
            write_run(os.path.join(self.folder, name), ("ricochet", "perforate", "undecided", "stuck")[i % 4], 100.0 + i)

    def test_a_run_is_read_as_it_was_written(self):
        write_run(self.folder)
        run = ricochet_results.Run(self.folder)
        self.assertEqual(run.summary["outcome"], "ricochet")
        np.testing.assert_array_equal(run.history["x"], [0, 3])
        np.testing.assert_array_equal(run.history["path"], [0, 5])
        self.assertEqual(run.history.units["time"], "us")
        np.testing.assert_allclose(run.frame_times, [0, 1, 2])
        frame = run.frame(1.2)
        self.assertAlmostEqual(frame.time, 1)
        np.testing.assert_allclose(frame.points, [[0, -1], [1, -1.001]])
        self.assertEqual(run.damage_maps, [])
        with self.assertRaisesRegex(ValueError, "no column 'speed'"):
            run.history["speed"]

    def test_a_run_without_results_is_empty(self):
        run = ricochet_results.Run(self.folder)
        self.assertEqual((run.summary, run.history, run.frame(1.0), len(run.frame_times)), ({}, None, None, 0))
        self.assertEqual(len(ricochet_results.Study(self.folder)), 0)

    def test_a_study_is_its_cases(self):
        self.write_study([axis("speed_m_s", "speed", "m/s")], [[200.0], [300.0]])
        study = ricochet_results.Study(self.folder)
        self.assertEqual([case.axes["speed_m_s"] for case in study], [200.0, 300.0])
        self.assertEqual(study[0].run.summary["exit_speed_m_s"], 100.0)

    def test_a_map_has_a_cell_per_case(self):
        self.write_study([axis("speed_m_s", "speed", "m/s"), axis("angle_deg", "angle", "deg")],
                         [[v, a] for v in (200.0, 300.0) for a in (10.0, 20.0, 40.0)])
        self.assertEqual([os.path.basename(path) for path in plot_map.draw_maps(self.folder)], ["map.png", "residual.png"])
        cells = []
        drawn, plot_map.draw_cell = plot_map.draw_cell, lambda axes, i, j, case: cells.append((i, j, case.name))
        try:
            plot_map.draw_map(ricochet_results.Study(self.folder))
        finally:
            plot_map.draw_cell = drawn
        self.assertEqual(sorted(cells), [(i, j, f"case_{3 * i + j}") for i in range(2) for j in range(3)])

    def test_undecided_cells_are_hatched(self):
        self.write_study([axis("speed_m_s", "speed", "m/s")], [[1.0], [2.0], [3.0], [4.0], [5.0]])
        _, axes = plot_style.plt.subplots()
        for i, case in enumerate(ricochet_results.Study(self.folder)):
            plot_map.draw_cell(axes, i, 0, case)
        self.assertEqual([bool(patch.get_hatch()) for patch in axes.patches], [False, False, True, False, False])
        self.assertEqual([text.get_text() for text in axes.texts], ["100", "101", "102", "", "not run"])

    def test_a_single_axis_gives_a_curve_and_no_map(self):
        limit = {"group": "", "case": "case_0", "axis": 0, "label": "speed", "unit": "m/s", "low": 1.0, "high": 2.0,
                 "is_found": True}
        self.write_study([axis("speed_m_s", "speed", "m/s")], [[1.0], [2.0], [3.0]], limits=[limit])
        self.assertEqual([os.path.basename(path) for path in plot_map.draw_maps(self.folder)], ["residual.png"])

    def test_convergence_shows_errors_and_grids(self):
        self.write_study([axis("grid_spacing_mm", "grid spacing", "mm")], [[2.0], [1.0], [0.5], [0.25]])
        write(self.folder, "convergence.csv",
              "group,grid_spacing_mm,points_per_calibre,path_error_percent,exit_speed_m_s_error_percent,reference\n"
              "-,2.0,3,8.0,-4.0,0\n-,1.0,6,2.0,-,0\n-,0.5,12,0.0,0.0,1\n")
        write(self.folder, "convergence_orders.csv", "group,quantity,order,uncertainty,limit,remark\n"
              "-,path_mm,2.0,0.1,7,-\n-,exit_speed_m_s,-,-,-,none: because\n")
        drawn = plot_convergence.draw_convergence(self.folder)
        self.assertEqual([os.path.basename(path) for path in drawn], ["convergence.png", "convergence_damage.png"])
        orders = plot_convergence.read_csv(os.path.join(self.folder, "convergence_orders.csv"))
        self.assertEqual(plot_convergence.order_of(orders, "-", "path_mm"), "order 2.00 ± 0.1")
        self.assertEqual(plot_convergence.order_of(orders, "-", "exit_speed_m_s"), "order none")

    def test_the_front_has_what_nothing_beats(self):
        rows = [plot_convergence.read_csv.__globals__["Row"]("", {
            "case": name, "reference": "full", "core_seconds": str(cost), "path_error_percent": error})
            for name, cost, error in (("full", 100, "0"), ("a", 10, "5"), ("b", 20, "6"), ("c", 30, "1"), ("d", 5, "-"))]
        self.assertEqual(plot_accuracy.front_of(rows), [(10.0, 5.0), (30.0, 1.0)])

    def test_further_formats_are_on_request(self):
        os.environ["RICOCHET_PICTURE_FORMATS"] = "svg, pdf"
        try:
            figure, _ = plot_style.plt.subplots()
            plot_style.save(figure, os.path.join(self.folder, "a.b.png"))
            self.assertEqual(sorted(os.listdir(self.folder)), ["a.b.pdf", "a.b.png", "a.b.svg"])
            os.environ["RICOCHET_PICTURE_FORMATS"] = "jpg"
            with self.assertRaisesRegex(ValueError, "'jpg'; formats are png, svg and pdf"):
                plot_style.further_formats()
        finally:
            del os.environ["RICOCHET_PICTURE_FORMATS"]


if __name__ == "__main__":
    unittest.main()
