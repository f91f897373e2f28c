# SPDX-License-Identifier: BSD-3-Clause
"""Values that change, progress and Ctrl+C. The same with plain VTK and with ParaView."""

import os
import signal
import sys
import threading
import types
import unittest
import unittest.mock
import warnings

import numpy as np

import subdivisionobjects
from subdivisionobjects import Subdivider, execution, meshes
from subdivisionobjects.run import FILTERS
from task_tools import CUBE, POINTS, QUADS, TETS, grid

# Of each function work that takes several reports: its mesh and its options.
AROUND = subdivisionobjects.cage(bounds=[-1, 9, -1, 9, -1, 9], number_of_cells=[3, 3, 3])
LONG = {
    "subdivide": (grid(4), {"levels": 2}),
    "surface_subdivision": ((CUBE, QUADS), {"levels": 6}),
    "adaptive_surface_subdivision": ((CUBE, QUADS), {"refine": {"edge_length": 0.02}, "maximum_level": 12}),
    "red_green_refinement": (grid(4), {"refine": {"edge_length": 0.3}}),
    "simplicial_complex_topology": (grid(12), {}),
    "deformation": (grid(8), {"rest_mesh": AROUND, "deformed_mesh": AROUND, "levels": 4}),
    "edit": (grid(40), {"selection": {"points": [0]}, "falloff_radius": 60.0, "falloff_along": "Edges", "scale": (2.0, 1.0, 1.0)}),
    "label_solid": ((np.pad(np.ones((8, 8, 8), int), 1),), {}),
    "limit_probe": (grid(3), {"places": np.random.default_rng(1).random((2000, 3))}),
    "measures": (grid(4), {"maximum_level": 3}),
    "sample": (grid(4), {"number_of_samples": 150, "generate_coverage": True}),
    "smoothness": (grid(4), {}),
}
# They take milliseconds, and report nothing between.
SHORT = {"cage", "cage_around", "extract_dimensions", "model"}


class Series(unittest.TestCase):
    def test_values_are_those_of_the_function(self):
        rows = np.random.default_rng(3).random((5, 2, 2))
        for function, mesh, options in (
            ("subdivide", (POINTS, TETS), {}),
            ("surface_subdivision", (CUBE, QUADS), {"scheme": "catmull-clark"}),
        ):
            smooth = Subdivider(*mesh, levels=2, function=function, **options)
            for values in (mesh[0], mesh[0][:, 0] ** 2, np.sin(mesh[0])):
                expected = getattr(subdivisionobjects, function)(*mesh, levels=2, point_data={"v": values}, **options)
                np.testing.assert_array_equal(smooth.apply(values), expected.point_data["v"])
                made = smooth.apply({"a": values})
                np.testing.assert_array_equal(made.point_data["a"], expected.point_data["v"])
                np.testing.assert_array_equal(made.points, expected.points)
            np.testing.assert_array_equal(smooth.apply(mesh[0]), smooth.points)
        self.assertEqual(Subdivider(POINTS, TETS, levels=1).apply(rows).shape[1:], (2, 2))

    def test_the_operator_is_kept(self):
        """A change of values takes a part of the time: the filter makes no operator."""
        made = Subdivider(POINTS, TETS, levels=2)
        first = made.apply(POINTS)
        with unittest.mock.patch("subdivisionobjects.subdivider.prepare", side_effect=AssertionError):
            second = made.apply(2 * POINTS)
        np.testing.assert_array_equal(2 * first, second)
        self.assertIs(made.cells, made.mesh.cells)
        self.assertIs(made.apply({"a": POINTS}).cells, made.cells)

    def test_arrays_that_make_rules_stay(self):
        data = {"marks": [1, 0, 0, 0, 0], "T": POINTS[:, 0]}
        smooth = Subdivider(POINTS, TETS, levels=1, point_data=data, marks_array="marks")
        expected = subdivisionobjects.subdivide(POINTS, TETS, levels=1, point_data=data, marks_array="marks")
        np.testing.assert_array_equal(smooth.apply(POINTS), expected.points)
        self.assertEqual(expected.points[0].tolist(), POINTS[0].tolist())
        self.assertEqual(set(smooth.apply({"a": POINTS}).point_data), {"a"})
        self.assertLessEqual({"marks", "T"}, set(smooth.point_data))

    def test_results_stay(self):
        smooth = Subdivider(POINTS, TETS, levels=1)
        first = smooth.apply(POINTS[:, 0])
        kept = first.copy()
        smooth.cells[:] = 0
        smooth.apply(7 * POINTS[:, 0])
        np.testing.assert_array_equal(first, kept)
        again = meshes.to_arrays(smooth._ready.made.GetOutputDataObject(0))  # what the filter keeps
        self.assertEqual(again.cells.max(), 13)
        self.assertEqual(len(smooth.matrix().offsets) - 1, len(smooth.points))
        self.assertEqual(smooth.evaluate([1], [[0.2, 0.2, 0.2]]).points.shape, (1, 3))
        self.assertRegex(repr(smooth), "<Subdivider: subdivide, 5 points to <Arrays: 14 points; 16 tetra")

    def test_sides_that_touch(self):
        """Points of the input that become one: each has a value, and that of the first counts."""
        ids = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
        points, triangles = POINTS[:4][ids.ravel()], np.arange(12).reshape(4, 3)
        whole = subdivisionobjects.subdivide(POINTS[:4], ids, levels=2)
        for function in ("subdivide", "surface_subdivision"):
            smooth = Subdivider(points, triangles, levels=2, function=function)
            self.assertEqual(len(smooth.points), len(whole.points))
            np.testing.assert_array_equal(smooth.apply(points), smooth.points)
            values = np.random.default_rng(1).random(12)
            rows = smooth.matrix()
            self.assertEqual(rows.number_of_columns, 12)
            np.testing.assert_allclose(smooth.apply(values), rows.multiply(values), rtol=0, atol=1e-14)

    def test_a_file_and_a_data_set(self):
        grid = meshes.to_vtk(POINTS, TETS)
        self.assertEqual(Subdivider(grid, levels=1).apply(POINTS).shape, (14, 3))
        self.assertEqual(grid.GetPointData().GetNumberOfArrays(), 0)

    def test_errors(self):
        smooth = Subdivider(POINTS, TETS, levels=1)
        with self.assertRaisesRegex(ValueError, "4 values, but there are 5 points"):
            smooth.apply([1.0, 2, 3, 4])
        self.assertEqual(len(smooth.apply(POINTS)), 14)
        with self.assertRaisesRegex(
            ValueError, "red_green_refinement keeps no operator: function is one of subdivide, surface_subdivision"
        ):
            Subdivider(POINTS, TETS, function="red_green_refinement")
        with self.assertRaisesRegex(TypeError, "did you mean .*levels"):
            Subdivider(POINTS, TETS, levle=2)

    def test_operators_and_places_of_arrays(self):
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        made.SetInputDataObject(meshes.to_vtk(POINTS, TETS))
        made.SetNumberOfLevels(1)
        ours = subdivisionobjects.operator_matrix(POINTS, TETS, levels=1)
        np.testing.assert_array_equal(ours.weights, subdivisionobjects.operator_matrix(made).weights)
        self.assertGreater(len(subdivisionobjects.operator_factors(POINTS, TETS, levels=2)), 1)
        at = subdivisionobjects.evaluate_limit((POINTS, TETS), [1], [[0.1, 0.2, 0.3]])
        np.testing.assert_array_equal(at.points, subdivisionobjects.evaluate_limit(made, [1], [[0.1, 0.2, 0.3]]).points)
        options = {"function": "surface_subdivision", "scheme": "catmull-clark", "levels": 1}
        quads = subdivisionobjects.operator_matrix(CUBE, QUADS, **options)
        self.assertEqual(len(quads.offsets) - 1, 26)
        with self.assertRaisesRegex(RuntimeError, "maximum_number_of_cells"):
            subdivisionobjects.operator_matrix(POINTS, TETS, levels=3, maximum_cells=9)
        with self.assertRaisesRegex(TypeError, "a filter has a mesh and options of its own"):
            subdivisionobjects.operator_matrix(made, levels=2)
        with self.assertRaisesRegex(
            ValueError, "cage has no operator: function is one of subdivide, surface_subdivision"
        ):
            subdivisionobjects.operator_matrix(POINTS, TETS, function="cage")


class Progress(unittest.TestCase):
    def setUp(self):
        """Notes the reports of the filter, which go on where nobody stops it."""
        self.reports = []
        report = execution.Stopper.report

        def note(stopper, *more):
            self.reports.append(stopper.made.GetProgress())
            report(stopper, *more)

        patch = unittest.mock.patch.object(execution.Stopper, "report", note)
        self.addCleanup(patch.stop)
        patch.start()

    def last_part(self):
        """How far the filter came. VTK itself reports the end, 1, of a filter that was stopped, too."""
        return max(part for part in self.reports if part < 1)

    def test_it_is_told(self):
        told = []
        subdivisionobjects.subdivide(*grid(4), levels=2, progress=told.append)
        self.assertGreater(len(told), 3)
        self.assertEqual((told, told[-1]), (sorted(told), 1))
        self.assertEqual(told, self.reports)
        self.assertGreater(self.last_part(), 0.6)

    def test_it_is_told_of_operators_and_places(self):
        for call, given in (
            (subdivisionobjects.operator_matrix, grid(3)),
            (subdivisionobjects.operator_factors, grid(3)),
            (subdivisionobjects.evaluate_limit, ((POINTS, TETS), [0], [[0.1, 0.2, 0.3]])),
        ):
            told = []
            call(*given, progress=told.append)
            self.assertTrue(told, call)

    def test_a_bar(self):
        bars = []

        class Bar:
            def __init__(self, total, unit):
                self.n, self.is_closed = 0, False
                bars.append(self)

            def update(self, more):
                self.n += more

            def close(self):
                self.is_closed = True

        stand_in, parent = types.ModuleType("tqdm.auto"), types.ModuleType("tqdm")
        stand_in.tqdm = Bar
        with unittest.mock.patch.dict(sys.modules, {"tqdm": parent, "tqdm.auto": stand_in}):
            subdivisionobjects.subdivide(POINTS, TETS, progress=True)
        self.assertEqual((len(bars), bars[0].n, bars[0].is_closed), (1, 100, True))
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}):
            with self.assertRaisesRegex(ValueError, "needs tqdm, which is not installed"):
                subdivisionobjects.subdivide(POINTS, TETS, progress=True)
        with self.assertRaisesRegex(ValueError, "progress is a function .* not 'yes'"):
            subdivisionobjects.subdivide(POINTS, TETS, progress="yes")

    def test_an_error_of_the_caller_stops(self):
        told = []

        def tell(done):
            told.append(done)
            if done > 0:
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            subdivisionobjects.subdivide(*grid(4), levels=2, progress=tell)
        self.assertLess(self.last_part(), 0.6)
        self.assertEqual(told[-1], max(told))

    def handle(self, handler):
        """Sets a handler of Ctrl+C until the test ends. That of pvpython is none of Python."""
        before = signal.signal(signal.SIGINT, handler)
        self.addCleanup(signal.signal, signal.SIGINT, before or signal.SIG_DFL)

    def test_ctrl_c_stops(self):
        """A real signal, in the midst of the work: the next report stops the filter, and nothing else is told."""
        told, sent = [], []

        def interrupt(done):
            told.append(done)
            if 0 < done < 1 and not sent:
                sent.append(done)
                os.kill(os.getpid(), signal.SIGINT)

        self.handle(signal.default_int_handler)
        with self.assertRaises(KeyboardInterrupt):
            subdivisionobjects.subdivide(*grid(4), levels=2, progress=interrupt)
        self.assertEqual(told[-1], sent[0])
        self.assertLess(self.last_part(), 0.6)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_ctrl_c_stops_every_function(self):
        """A signal at the first report after the beginning: the filter comes no farther."""
        self.assertEqual(set(LONG) | SHORT, set(FILTERS))
        self.handle(signal.default_int_handler)
        for name, (mesh, options) in LONG.items():
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                call = getattr(subdivisionobjects, name)
                self.reports.clear()
                call(*mesh, **options)
                whole = self.last_part()
                sent = []

                def interrupt(done):
                    if 0 < done < 1 and not sent:
                        sent.append(done)
                        os.kill(os.getpid(), signal.SIGINT)

                self.reports.clear()
                with self.assertRaises(KeyboardInterrupt):
                    call(*mesh, progress=interrupt, **options)
                self.assertLess(self.last_part(), whole)
                self.assertLess(sum(sent[0] < part < 1 for part in self.reports), 3)

    def test_work_goes_on_after_a_stop(self):
        def stop(done):
            if stops and done < 1:
                stops.pop()
                raise KeyboardInterrupt

        stops = []
        smooth = Subdivider(*grid(4), levels=2, progress=stop)
        values = np.random.default_rng(2).random(125)
        expected = smooth.apply(values)
        stops.append(1)
        try:
            smooth.apply(2 * values)
        except KeyboardInterrupt:
            pass
        self.assertEqual(stops, [])
        self.assertFalse(smooth._ready.made.GetAbortExecute())
        self.assertEqual(len(smooth.matrix().offsets) - 1, len(expected))
        np.testing.assert_array_equal(smooth.apply(values), expected)

    def test_a_handler_of_the_caller_is_called(self):
        """One that ends nothing lets the filter go on."""
        caught = []

        def interrupt(done):
            if 0 < done < 1:
                os.kill(os.getpid(), signal.SIGINT)

        self.handle(lambda *_: caught.append(1))
        made = subdivisionobjects.subdivide(POINTS, TETS, levels=1, progress=interrupt)
        self.assertTrue(caught)
        self.assertEqual(len(made.cells), 16)

    def test_work_in_other_threads(self):
        """They have no signals, and tell their progress."""
        told, made = [], []
        work = threading.Thread(
            target=lambda: made.append(subdivisionobjects.subdivide(POINTS, TETS, levels=1, progress=told.append))
        )
        work.start()
        work.join()
        self.assertEqual((len(made[0].cells), told[-1]), (16, 1))
