# SPDX-License-Identifier: BSD-3-Clause
"""Images of smooth objects. The same with plain VTK and with ParaView."""

import copy
import pickle
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

import subdivisionobjects
from function_tools import TET
from subdivisionobjects import meshes


class Images(unittest.TestCase):
    def test_images_are_a_dictionary_of_arrays(self):
        cells = {"tetra": [[0, 1, 2, 3], [1, 2, 3, 4]]}
        points = np.vstack([TET, [1, 1, 1]]) * [1, 2, 3]
        data = {"point_data": {"Place": points, "Heat": points[:, 0]}, "cell_data": {"MaterialId": [7, 5]}}
        image = subdivisionobjects.sample(points, cells, spacing=0.05, generate_coverage=True, tolerance=0.01, **data)
        self.assertIsInstance(image, subdivisionobjects.Image)
        self.assertEqual(image.spacing, (0.05, 0.05, 0.05))
        shape = image["Heat"].shape
        self.assertGreater(shape[0], shape[1])  # z, y, x
        self.assertGreater(shape[1], shape[2])
        self.assertEqual(image["Place"].shape, shape + (3,))
        self.assertEqual(image["Coverage"].shape, shape + (2,))
        inside = image["vtkValidPointMask"] == 1
        self.assertEqual(set(image["Material"][inside]), {5, 7})
        k, j, i = np.nonzero(inside)
        places = np.array(image.origin) + np.column_stack([i, j, k]) * image.spacing
        np.testing.assert_allclose(image["Place"][..., 0], image["Heat"], atol=1e-12)
        # The volume of each material, in ascending order.
        measured = subdivisionobjects.measures(points, cells, **data)
        np.testing.assert_allclose(places.mean(axis=0), measured["Centroid"][0], atol=0.01)
        volumes = image["Coverage"].sum(axis=(0, 1, 2), dtype=float) * 0.05**3
        np.testing.assert_allclose(volumes, measured["Measure"][measured["AllMaterials"] == 0], rtol=1e-3)

    def test_images_are_given_as_meshes_are(self):
        points = TET * [1, 2, 3]
        given = {"spacing": 0.1, "scheme": "linear"}
        image = subdivisionobjects.sample(points, [[0, 1, 2, 3]], point_data={"Heat": points[:, 0]}, **given)
        self.assertRegex(repr(image), r"^<Image: 13 x 23 x 33 samples; Heat, vtkValidPointMask>$")
        grid = meshes.to_vtk(points, [[0, 1, 2, 3]], {"Heat": points[:, 0]})
        made = subdivisionobjects.sample(grid, **given)
        self.assertIsInstance(made, vtkImageData)
        grid.GetPointData().SetActiveScalars("Heat")
        active = meshes.to_samples(subdivisionobjects.sample(grid, **given))
        self.assertEqual((active.scalars, meshes.to_samples(active.to_vtk()).scalars), ("Heat", "Heat"))
        for same in (image, image.to_vtk(), meshes.to_samples(made), copy.deepcopy(image),
                     pickle.loads(pickle.dumps(image))):
            same = same if isinstance(same, dict) else meshes.to_samples(same)
            self.assertEqual(list(same), list(image))
            self.assertEqual((same.origin, same.spacing, same.scalars), (image.origin, image.spacing, image.scalars))
            np.testing.assert_array_equal(same["Heat"], image["Heat"])
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        name = folder.name + "/image.vti"
        for file in (name, name.replace(".vti", ".vtk")):
            image.save(file)
            np.testing.assert_array_equal(meshes.to_samples(meshes.to_vtk(file))["Heat"], image["Heat"])
        with self.assertRaisesRegex(ValueError, "which hold images"):
            image.save(name.replace(".vti", ".vtu"))
        # The grid of another image, whose extent begins elsewhere.
        made.SetExtent(*(number + 2 for number in made.GetExtent()))
        for grid in (image, name):
            same = subdivisionobjects.sample(points, [[0, 1, 2, 3]], grid=grid, scheme="linear")
            np.testing.assert_array_equal(same["vtkValidPointMask"], image["vtkValidPointMask"])
        moved = subdivisionobjects.sample(points, [[0, 1, 2, 3]], grid=made, scheme="linear")
        np.testing.assert_allclose(moved.origin, np.array(image.origin) + 0.2)
        np.testing.assert_array_equal(moved["vtkValidPointMask"][:-2, :-2, :-2], image["vtkValidPointMask"][2:, 2:, 2:])
        image["Other"] = np.zeros((2, 2, 2))
        with self.assertRaisesRegex(ValueError, "must have the same axes z, y and x"):
            image.to_vtk()
