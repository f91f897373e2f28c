# SPDX-License-Identifier: BSD-3-Clause
"""write_solver_mesh: what Gmsh, CalculiX, Exodus's readers and meshio read is the mesh, node for node, with its groups. Without
these programs their tests say "skipped"."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkUnstructuredGrid

import subdivisionobjects
from subdivisionobjects import solvers, write_solver_mesh

CUBE = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
# A hexahedron, and a wedge, a pyramid and a tetrahedron beside it: vertices, lines and surfaces of all sorts, too.
MIXED = {"hexahedron": [[0, 1, 3, 2, 4, 5, 7, 6]], "wedge": [[1, 8, 5, 3, 9, 7]], "pyramid": [[4, 5, 7, 6, 10]],
         "tetra": [[4, 5, 10, 11]], "quad": [[0, 1, 3, 2]], "triangle": [[4, 5, 11]], "line": [[11, 12]], "vertex": [[12]]}
POINTS = np.array(CUBE + [[2, 0, 0.5], [2, 1, 0.5], [0.5, 0.5, 2], [0.5, -1, 1.5], [0.5, -2, 1.5]])


def needs(*modules):
    for name in modules:
        if not importlib.util.find_spec(name):
            raise unittest.SkipTest(f"skipped: there is no {name}")


def single_cells(kinds, bend=0.1):
    """A cell of each type of VTK with its number of nodes, solids bent, side by side: cell i is in group i + 1."""
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    grid.SetPoints(points)
    for index, (kind, size) in enumerate(kinds):
        shape = solvers.SHAPES[kind][0]
        at = places_of(kind, size)
        if shape == "pyramid":
            at[:, :2] *= 1 - at[:, 2:]
        place = at + bend * np.sin(1.5 * at[:, [1, 2, 0]]) * [1, 1, solvers.DIMENSION[shape] == 3] + [3 * index, 0, 0]
        grid.InsertNextCell(kind, size, [points.InsertNextPoint(*row) for row in place])
    return with_groups(grid, np.arange(1, len(kinds) + 1))


def places_of(kind, size):
    """Parameters of nodes in VTK's order."""
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetNumberOfPoints(size)
    grid.SetPoints(points)
    grid.InsertNextCell(kind, size, list(range(size)))
    return np.reshape(grid.GetCell(0).GetParametricCoords(), (-1, 3))[:size].copy()


def with_groups(grid, numbers):
    array = numpy_to_vtk(np.asarray(numbers), deep=True)
    array.SetName("Part")
    grid.GetCellData().AddArray(array)
    return grid


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def location(cell, parameters):
    place = [0., 0., 0.]
    cell.EvaluateLocation(mutable(0), list(parameters), place, [0.] * cell.GetNumberOfPoints())
    return np.array(place)


class Prolongations(unittest.TestCase):
    def test_polynomials_stay_what_they_are(self):
        """From the nodes of one level to those of the next, as a matrix of SciPy; cells are straight."""
        needs("scipy")
        points, cells = POINTS[[0, 1, 2, 4, 7]], [[0, 1, 2, 3], [1, 4, 2, 3]]
        for levels in (1, 2):
            for order in (0, 1, 2, 3, 4):
                options = {"volume_scheme": "linear", "output_cells": "lagrange", "cell_order": order}
                options = options if order else {"volume_scheme": "linear", "output_cells": "quadratic"}
                before, after = (subdivisionobjects.subdivide(points, cells, levels=level, **options).points
                                 for level in (levels - 1, levels))
                step = subdivisionobjects.prolongation_matrix(points, cells, levels=levels, **options).to_scipy()
                self.assertEqual((step.format, step.shape), ("csr", (len(after), len(before))))
                np.testing.assert_allclose(step @ before, after, rtol=0, atol=1e-14)
                for degree in range((order or 2) + 1):
                    values = [(1 + at @ [1, 2, -1]) ** degree + at[:, 0] ** degree for at in (before, after)]
                    np.testing.assert_allclose(step @ values[0], values[1], rtol=0, atol=1e-11)

    def test_levels_of_a_smooth_object(self):
        """Where nodes keep the shape of the first level its volume stays, whatever the number of levels."""
        part = subdivisionobjects.model(model="Cylinder")
        options = {"output_cells": "quadratic", "output_dimensions": "Tetrahedra"}
        made = [subdivisionobjects.subdivide(part, levels=level, **options) for level in (0, 1)]
        step = subdivisionobjects.prolongation_matrix(part, levels=1, **options)
        self.assertEqual((len(step.offsets) - 1, step.number_of_columns), tuple(made[i].GetNumberOfPoints() for i in (1, 0)))
        np.testing.assert_allclose(step.multiply(np.ones(step.number_of_columns)), 1, rtol=0, atol=1e-14)
        points = points_of(made[0])
        volumes = [volume_of(points, made[0]), volume_of(step.multiply(points), made[1])]
        self.assertAlmostEqual(volumes[0], volumes[1], delta=1e-12 * volumes[0])

    def test_errors(self):
        with self.assertRaisesRegex(RuntimeError, "prolongation goes from the nodes of curved cells"):
            subdivisionobjects.prolongation_matrix(POINTS, {"tetra": [[0, 1, 2, 4]]}, levels=1)


def volume_of(points, mesh):
    """Of quadratic tetrahedra: the determinant has degree 3, for which the rule with the centre and four more places is exact."""
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    grid.GetPoints().SetNumberOfPoints(10)
    grid.InsertNextCell(24, 10, list(range(10)))
    total, slopes, cells = 0., [0.] * 30, vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 10)
    places = [([0.25] * 3, -2 / 15)] + [([0.5 if i == k else 1 / 6 for i in range(3)], 3 / 40) for k in range(4)]
    for at, weight in places:
        grid.GetCell(0).InterpolateDerivs(at, slopes)
        jacobians = np.einsum("dn,cnk->cdk", np.reshape(slopes, (3, 10)), points[cells])
        total += weight * np.linalg.det(jacobians).sum()
    return total


QUADRATIC = [(24, 10), (25, 20), (26, 15), (22, 6), (23, 8), (21, 3), (10, 4), (12, 8), (13, 6), (5, 3), (9, 4), (3, 2)]
LAGRANGE = [(kind, solvers.NODES[shape](order)) for kind, (shape, _) in solvers.SHAPES.items() if kind > 67
            for order in range(1, len(solvers.GMSH[shape]) + 1)]


class InFolder(unittest.TestCase):
    def setUp(self):
        self.before = os.getcwd()
        self.folder = tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()


class Gmsh(InFolder):
    @classmethod
    def setUpClass(cls):
        needs("gmsh")
        import gmsh
        cls.gmsh = gmsh
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)

    @classmethod
    def tearDownClass(cls):
        cls.gmsh.finalize()

    def open(self, grid, **given):
        """Writes the grid, and lets Gmsh read it: nodes in order of their tags."""
        write_solver_mesh(grid, "made.msh", **given)
        self.gmsh.clear()
        self.gmsh.open("made.msh")
        tags, places, _ = self.gmsh.model.mesh.getNodes()
        found = np.full((len(tags), 3), np.nan)
        found[tags.astype(int) - 1] = places.reshape(-1, 3)
        return found

    def check_elements(self, grid):
        """Each node of each element is where VTK has the place of this node in its cell. Returns how many there are."""
        mesh, points, count = self.gmsh.model.mesh, points_of(grid), 0
        for kind, elements, nodes in zip(*mesh.getElements()):
            _, dimension, _, size, places, _ = mesh.getElementProperties(kind)
            places = np.hstack([np.reshape(places, (size, -1)), np.zeros((size, 3))])[:, :3]
            for element, row in zip(elements.astype(int), nodes.astype(int).reshape(-1, size)):
                cell = grid.GetCell(element - 1)
                self.assertEqual(cell.GetCellDimension(), dimension)
                for place, node in zip(places, row):
                    there = location(cell, self.to_vtk(solvers.SHAPES[cell.GetCellType()][0], place))
                    np.testing.assert_allclose(there, points[node - 1], atol=1e-9 * (1 + abs(there).max()))
                    count += 1
        return count

    @staticmethod
    def to_vtk(shape, place):
        """Parameters of VTK: Gmsh has cubes from -1 to 1."""
        place = place.copy()
        if shape in ("line", "quad", "hexahedron"):
            return (place + 1) / 2
        if shape == "wedge":
            place[2] = (place[2] + 1) / 2
        if shape == "pyramid":
            place[:2] = (place[:2] / max(1 - place[2], 1e-12) + 1) / 2
        return place

    def test_cells_of_all_types(self):
        for kinds in (QUADRATIC + [(27, 13), (14, 5), (1, 1)], LAGRANGE):
            grid = single_cells(kinds)
            np.testing.assert_array_equal(self.open(grid, groups="Part"), points_of(grid))
            self.assertEqual(self.check_elements(grid), sum(size for _, size in kinds))

    def test_outputs_of_filters(self):
        part = subdivisionobjects.model(model="MechanicalPart")
        flower = subdivisionobjects.model(model="MixedDimensions")
        for mesh, given in ((part, {"output_cells": "Quadratic"}), (flower, {"output_cells": "Quadratic"}),
                            (flower, {"output_cells": "Lagrange", "cell_order": 3}), (flower, {"output_cells": "Lagrange", "cell_order": 4}), (part, {}), (part, {"levels": 0})):
            grid = subdivisionobjects.subdivide(mesh, **given)
            grid = grid if isinstance(grid, vtkUnstructuredGrid) else grid.to_vtk()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = self.open(grid, groups="MaterialId")
            np.testing.assert_array_equal(found, points_of(grid).astype(float))
            self.assertGreater(self.check_elements(grid), grid.GetNumberOfCells())
            values = vtk_to_numpy(grid.GetCellData().GetArray("MaterialId"))
            for dimension, number in self.gmsh.model.getPhysicalGroups():
                entities = self.gmsh.model.getEntitiesForPhysicalGroup(dimension, number)
                cells = np.concatenate([one for tag in entities for one in self.gmsh.model.mesh.getElements(dimension, tag)[1]])
                material = int(re.match(r"MaterialId_(\d+)", self.gmsh.model.getPhysicalName(dimension, number))[1])
                cells = cells.astype(int) - 1
                self.assertEqual(set(values[cells].tolist()), {material})
                self.assertEqual({grid.GetCell(cell).GetCellDimension() for cell in cells[:20].tolist()}, {dimension})

    def test_uncut_cells(self):
        made = subdivisionobjects.subdivide(POINTS, MIXED, volume_scheme="Keep cell types", output_cells="Quadratic")
        grid = made.to_vtk()
        np.testing.assert_array_equal(self.open(grid), points_of(grid))
        self.assertGreater(self.check_elements(grid), 8 * 20)
        self.assertEqual([self.gmsh.model.getPhysicalName(*one) for one in self.gmsh.model.getPhysicalGroups()],
                         ["points", "curves", "surfaces", "solids"])

    def test_values(self):
        grid = single_cells([(24, 10), (22, 6)])
        values = numpy_to_vtk(np.arange(16.) / 7, deep=True)
        values.SetName("T")
        grid.GetPointData().AddArray(values)
        self.open(grid)
        views = {self.gmsh.option.getString(f"View[{i}].Name"): tag for i, tag in enumerate(self.gmsh.view.getTags())}
        self.assertEqual(set(views), {"T", "Part"})
        found = self.gmsh.view.getModelData(views["T"], 0)
        np.testing.assert_array_equal(np.ravel(found[2]), np.arange(16.) / 7)
        np.testing.assert_array_equal(found[1], np.arange(16) + 1)


class Groups(InFolder):
    def names(self):
        return re.findall(r'^(\d) (\d+) "(.*)"$', pathlib.Path("made.msh").read_text(encoding="utf-8"), re.MULTILINE)

    def test_names(self):
        tets = {"tetra": [[0, 1, 2, 3], [1, 2, 3, 4]], "triangle": [[0, 1, 2]]}
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
        made = subdivisionobjects.subdivide(points, tets, levels=0, cell_data={"region": [5, 7, 5]})
        made.save("made.msh", groups="region")
        self.assertEqual(self.names(), [("2", "5", "region_5_surfaces"), ("3", "5", "region_5_solids"), ("3", "7", "region_7")])
        write_solver_mesh(made, "made.msh", "region", {5: "steel", (2, 5): "skin of it"})
        self.assertEqual(self.names(), [("2", "5", "skin of it"), ("3", "5", "steel"), ("3", "7", "region_7")])
        # As Gmsh and meshio have them, through a filter.
        made.field_data.update({"lead": np.array([7, 3])})
        again = subdivisionobjects.subdivide(made, output_cells="Quadratic")
        write_solver_mesh(again, "made.msh", "region")
        self.assertEqual(self.names()[-1], ("3", "7", "lead"))
        # A table of materials.
        made.field_data.clear()
        made.field_data.update({"region": np.array([5, 7]), "Name": np.array(["steel", "lead"])})
        write_solver_mesh(made, "made.msh", "region")
        self.assertEqual([name for _, _, name in self.names()], ["steel_surfaces", "steel_solids", "lead"])
        write_solver_mesh(made, "made.inp", "region", {5: "1 %"})
        text = pathlib.Path("made.inp").read_text(encoding="utf-8")
        self.assertEqual(re.findall("ELSET=(.*)", text), ["Set_1___surfaces", "Set_1___solids", "lead"])

    def test_numbers_below_one(self):
        made = subdivisionobjects.subdivide(POINTS, MIXED, levels=0, volume_scheme="Keep cell types",
                                            cell_data={"m": np.zeros(8, int)})
        with self.assertWarnsRegex(UserWarning, "solvers count groups from 1: m 0 is number 1 in the file"):
            made.save("made.msh", groups="m")
        self.assertEqual({number for _, number, _ in self.names()}, {"1"})
        made.cell_data["m"] = np.array([0, 0, 0, 0, -4, 0, 0, 7])
        with self.assertWarnsRegex(UserWarning, "m -4 is number 8, m 0 is number 9 in the file"):
            made.save("made.msh", groups="m")
        self.assertEqual({number for _, number, _ in self.names()}, {"7", "8", "9"})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            write_solver_mesh(single_cells([(24, 10)]), "made.inp", groups="Part")

    def test_what_is_refused(self):
        grid = single_cells([(24, 10), (27, 13)])
        hexahedron = single_cells([(72, 27)])
        blocks = single_cells([(71, 20)])
        half = single_cells([(24, 10)])
        half.GetCellData().GetArray("Part").SetName("other")
        part = numpy_to_vtk(np.array([0.5]), deep=True)
        part.SetName("Part")
        half.GetCellData().AddArray(part)
        strip = subdivisionobjects.subdivide([[0, 0, 0], [1, 0, 0], [2, 1, 0], [1, 2, 0], [0, 1, 0]], {"polygon5": [range(5)]},
                                             levels=0, volume_scheme="Keep cell types")
        for text, call in (
                ("cell 1 is a pyramid with 13 nodes, which .inp does not have: .* write .msh, .exo",
                 lambda: write_solver_mesh(grid, "made.inp")),
                ("cell 0 is a hexahedron with 27 nodes, which .inp does not", lambda: write_solver_mesh(hexahedron, "made.inp")),
                ("cell 0 is a tetra with 20 nodes, which .exo does not", lambda: write_solver_mesh(blocks, "made.exo")),
                ("groups is the name of a cell array, not 'Parts'; did you mean Part",
                 lambda: write_solver_mesh(grid, "made.msh", groups="Parts")),
                ("the cell array 'Part' cannot be groups", lambda: write_solver_mesh(half, "made.msh", groups="Part")),
                ("'made.xyz' ends with none of .msh, .inp", lambda: write_solver_mesh(grid, "made.xyz")),
                ("there are no cells for a solver", lambda: write_solver_mesh(vtkUnstructuredGrid(), "made.msh")),
                ("groups are for .msh, .inp, ", lambda: strip.save("made.vtu", groups="Part"))):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaisesRegex(FileNotFoundError, "no folder 'nowhere'"):
            write_solver_mesh(grid, "nowhere/made.msh")
        self.assertEqual(os.listdir(), [])


class CalculiX(InFolder):
    def test_volumes(self):
        """ccx finds the volume of each cell by its own shape functions: it has all nodes where VTK has them."""
        if not shutil.which("ccx"):
            self.skipTest("skipped: there is no ccx")
        grid = single_cells(QUADRATIC)
        points_of(grid)[0] = [-1.2345678901234567e-18, -1.2345678901234567e-111, 1e-300]  # ccx reads 20 characters of a number
        write_solver_mesh(grid, "mesh.inp", groups="Part")
        sections = {3: "*SOLID SECTION, ELSET=Part_{0}, MATERIAL=M\n", 2: "*SHELL SECTION, ELSET=Part_{0}, MATERIAL=M\n0.1\n",
                    1: "*BEAM SECTION, ELSET=Part_{0}, MATERIAL=M, SECTION=RECT\n0.1, 0.1\n0, 0, 1\n"}
        numbers = range(1, len(QUADRATIC) + 1)
        text = "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=M\n*ELASTIC\n100, 0.3\n*BOUNDARY\nNODES, 1, 3\n"
        text += "".join(sections[grid.GetCell(i - 1).GetCellDimension()].format(i) for i in numbers)
        text += "*STEP\n*STATIC\n" + "".join(f"*EL PRINT, ELSET=Part_{i}\nEVOL\n" for i in numbers) + "*END STEP\n"
        pathlib.Path("case.inp").write_text(text, encoding="utf-8")
        done = subprocess.run(["ccx", "case"], capture_output=True, text=True, timeout=300, check=False)
        self.assertNotIn("*ERROR", done.stdout)
        found = {int(a): float(b) for a, b in re.findall(r"^ +(\d+) +(\S+)$", pathlib.Path("case.dat").read_text(), re.MULTILINE)}
        for i in numbers:
            thickness = 0.1 ** (3 - grid.GetCell(i - 1).GetCellDimension())
            self.assertAlmostEqual(found[i], thickness * self.content(grid.GetCell(i - 1)), 6, i)

    @staticmethod
    def content(cell):
        """Length, area or volume by Gauss points and differences of the places."""
        dimension, shape = cell.GetCellDimension(), solvers.SHAPES[cell.GetCellType()][0]
        x, w = np.polynomial.legendre.leggauss(5)
        total = 0
        for index in np.ndindex(*dimension * [5]):
            at, weight = np.append((x[list(index)] + 1) / 2, np.zeros(3 - dimension)), np.prod(w[list(index)] / 2)
            if shape in ("triangle", "wedge", "tetra"):
                weight *= 1 - at[0]
                at[1] *= 1 - at[0]
            if shape == "tetra":
                weight *= 1 - at[0] - at[1]
                at[2] *= 1 - at[0] - at[1]
            sides = np.array([location(cell, at + step) - location(cell, at - step) for step in 1e-5 * np.eye(3)[:dimension]])
            total += weight * np.sqrt(np.linalg.det(sides @ sides.T)) / 2e-5**dimension
        return total


class Exodus(InFolder):
    def test_vtk_reads_it(self):
        needs("netCDF4")
        from vtkmodules.vtkIOExodus import vtkExodusIIReader
        kinds = QUADRATIC + [(27, 13), (14, 5)]
        grid = single_cells(kinds)
        values = numpy_to_vtk(points_of(grid)[:, 0] * 2, deep=True)
        values.SetName("T")
        grid.GetPointData().AddArray(values)
        write_solver_mesh(grid, "made.exo", groups="Part", names={1: "the first"})
        reader = vtkExodusIIReader()
        reader.SetFileName("made.exo")
        reader.UpdateInformation()
        reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
        reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
        reader.Update()
        blocks = reader.GetOutput().GetBlock(0)
        found = {}
        for index in range(blocks.GetNumberOfBlocks()):
            name = blocks.GetMetaData(index).Get(vtkCompositeDataSet.NAME())
            found[1 if name == "the first" else int(name.split("_")[1])] = blocks.GetBlock(index)
        self.assertEqual(sorted(found), list(range(1, len(kinds) + 1)))
        for number, block in found.items():
            ours, theirs = grid.GetCell(number - 1), block.GetCell(0)
            self.assertEqual((ours.GetCellType(), block.GetNumberOfCells()), (theirs.GetCellType(), 1))
            places = np.array([block.GetPoint(theirs.GetPointId(i)) for i in range(theirs.GetNumberOfPoints())])
            np.testing.assert_allclose(places, points_of(grid)[[ours.GetPointId(i) for i in range(len(places))]], atol=4e-6)
            there = vtk_to_numpy(block.GetPointData().GetArray("T"))
            np.testing.assert_allclose(there, points_of(block)[:, 0] * 2, atol=1e-5)
            self.assertEqual(block.GetCellData().GetArray("Part").GetValue(0), number)


class Meshio(InFolder):
    def test_meshio_reads_all(self):
        needs("meshio", "netCDF4")
        import meshio
        grid = with_groups(subdivisionobjects.subdivide(POINTS[:8], {"hexahedron": MIXED["hexahedron"]}, levels=0,
                                                        volume_scheme="Keep cell types", output_cells="Quadratic").to_vtk(), [3])
        rows = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        for name in ("made.msh", "made.inp"):
            write_solver_mesh(grid, name, groups="Part", names={3: "steel"})
            mesh = meshio.read(name)
            np.testing.assert_array_equal(mesh.points, points_of(grid))
            self.assertEqual([block.type for block in mesh.cells], ["hexahedron20"])
            np.testing.assert_array_equal(mesh.cells[0].data[0], rows)
        self.assertEqual({name: list(value) for name, value in meshio.read("made.msh").field_data.items()}, {"steel": [3, 3]})
        tets = subdivisionobjects.subdivide(subdivisionobjects.model(model="MaterialBlock"), output_cells="Quadratic")
        write_solver_mesh(tets, "made.exo")
        mesh = meshio.read("made.exo")
        np.testing.assert_array_equal(mesh.points, points_of(tets))
        np.testing.assert_array_equal(mesh.cells[0].data.ravel(), vtk_to_numpy(tets.GetCells().GetConnectivityArray()))

    def test_gmsh_groups_come_back(self):
        """A mesh of Gmsh with groups is read by meshio, becomes curved cells, and keeps groups and names."""
        needs("meshio")
        points = np.vstack([POINTS[:4], [[0, 0, 1]]])
        made = subdivisionobjects.subdivide(points, [[0, 1, 2, 4], [1, 3, 2, 4]], levels=0, cell_data={"part": [4, 9]})
        write_solver_mesh(made, "coarse.msh", "part", {4: "steel", 9: "lead"})
        fine = subdivisionobjects.subdivide("coarse.msh", output_cells="Quadratic")
        fine.save("fine.msh", groups="gmsh:physical")
        text = pathlib.Path("fine.msh").read_text(encoding="utf-8")
        self.assertIn('3 4 "steel"\n3 9 "lead"', text)


if __name__ == "__main__":
    unittest.main()
