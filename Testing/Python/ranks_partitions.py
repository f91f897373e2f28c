# SPDX-License-Identifier: BSD-3-Clause
"""On each rank the cells that it has become what they become in the whole mesh, bit for bit.

Run under mpirun, by python3 or by `pvbatch --symmetric`; then half of the filters are those of proxies.
"""

import itertools
import os
import pathlib

import numpy as np
import rank_tools as ranks
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

import subdivisionobjects

CUTS = {"slabs": (ranks.in_slabs, True), "cell by cell": (ranks.by_chance, True),
        "one rank has all": (ranks.on_last_rank, True), "slabs by coordinates": (ranks.in_slabs, False),
        "cell by cell, by coordinates": (ranks.by_chance, False)}
SOLID = [("vtkMultiDimensionalSubdivision", {"NumberOfLevels": 2}),
         ("vtkMultiDimensionalSubdivision", {"NumberOfLevels": 1, "VolumeScheme": 1, "ProjectToLimit": 1,
                                             "GenerateClassification": 1, "DetectFeatures": 1}),
         ("vtkMultiDimensionalSubdivision", {"NumberOfLevels": 2, "ModifiedBoundary": 0, "DetectFeatures": 1})]
HYBRID = subdivisionobjects.vtkMultiDimensionalSubdivision.HYBRID
LOOP = subdivisionobjects.vtkSurfaceSubdivision.LOOP
SCHEMES = range(LOOP, subdivisionobjects.vtkSurfaceSubdivision.SQRT_THREE + 1)
SURFACE = [("vtkSurfaceSubdivision", {"Scheme": scheme, "NumberOfLevels": 2, "DetectFeatures": int(scheme == LOOP),
                                      "GenerateGlobalIds": 1})
           for scheme in (*SCHEMES, subdivisionobjects.vtkSurfaceSubdivision.AUTOMATIC)]
RED_GREEN = [("vtkRedGreenRefinement", {"RefineByAttributeError": 0, "RefineByEdgeLength": 1, "MaximumEdgeLength": 0.4,
                                        "MaximumLevel": 3, "GenerateGlobalIds": 1})]
LIMITS = [("vtkRedGreenRefinement", dict(RED_GREEN[0][1], Placement=1, VolumeScheme=scheme, MaximumLevel=2, **options))
          for scheme in (0, 1)
          for options in ({"GenerateLimitNormals": 1},
                          {"PreserveInterfaces": 1, "InterfaceValues": 1, "GenerateGlobalIds": 0})]
ADAPTIVE = [("vtkAdaptiveSurfaceSubdivision", dict({"RefineByAttributeError": 0, "MaximumLevel": 4,
                                                    "GenerateGlobalIds": 1}, **options))
            for options in ({"RefineByGeometricError": 1, "GeometricTolerance": 0.003},
                            {"RefineByCurvature": 1, "MaximumAngle": 20., "GenerateLimitNormals": 1})]
JUMPING = {"PreserveInterfaces": 1, "InterfaceValues": 1, "InterpolateArrays": 1}
INTERPOLATED = {"InterpolatePoints": 1, "InterpolateArrays": 1, "InterpolationWeight": 0.75}
FILES = ("hex_geos_box_hybrid.vtu", "mix_elmer_shell_on_solid.vtu", "nm_nastran_wingbox.vtu", "surf_bunny_3k.vtp",
         "poly_cow_mixed.vtp")
PROXIES = {"vtkMultiDimensionalSubdivision": "MultidimensionalSubdivision", "vtkSurfaceSubdivision": "SurfaceSubdivision",
           "vtkAdaptiveSurfaceSubdivision": "AdaptiveSurfaceSubdivision",
           "vtkRedGreenRefinement": "RedGreenRefinement"}


def run_class(name, options, data, controller, warnings=None):
    made = getattr(subdivisionobjects, name)()
    made.SetController(controller)
    if warnings is not None:
        def keep(_, __, text):
            warnings.append(text)
        keep.CallDataType = VTK_STRING
        made.AddObserver("WarningEvent", keep)
    if hasattr(made, "SmoothShadingOff"):  # it is for a mesh that one partition has as a whole
        made.SmoothShadingOff()
    for key, value in options.items():
        getattr(made, "Set" + key)(value)
    made.SetInputDataObject(data)
    made.Update()
    return made.GetOutputDataObject(0)


def run_proxy(name, options, data, _):
    producer = ranks.simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    labels = {"ModifiedBoundary": "SmoothUpToBorders", "Placement": "Shape", "EmbeddedCells": "CellsInOtherCells",
              "RuleArray": "JointOfEachCell", "Use32BitIds": "CompactIds", "FieldsOfCells": "CellArraysToSmooth"}
    named = {labels.get(key, key): value for key, value in options.items()}  # pvpython has labels
    proxy = getattr(ranks.simple, PROXIES[name])(Input=producer, **named)
    if proxy.GetProperty("SmoothShading") is not None:
        proxy.SmoothShading = 0
    output = ranks.own_cells(proxy)
    ranks.simple.Delete(proxy)
    ranks.simple.Delete(producer)
    return output


class Checks:
    """Runs filters on cut meshes, each time with the next of the CUTS."""

    def __init__(self):
        self.failures = []
        self.sizes = []  # what was run, cells of this rank, cells of the whole
        self.cuts = itertools.cycle(CUTS.items())
        self.rounds = itertools.count()

    def is_in_turn(self):
        """Whether a round runs: in `./dev test` a third of them do, by turns of the commit."""
        turn, number = os.environ.get("SUBDIVISIONOBJECTS_TURN"), next(self.rounds)
        return not turn or (number + number // 3) % 3 == int(turn)

    def cut(self, mesh, filters, always=None):
        for name, options in filters:
            cut, (find, with_ids) = (always, CUTS[always]) if always else next(self.cuts)
            if not self.is_in_turn():
                continue
            part_of = find(mesh, ranks.RANKS)
            part = ranks.take(mesh, np.nonzero(part_of == ranks.RANK)[0], with_ids=with_ids)
            whole = run_class(name, options, mesh if with_ids else ranks.as_it_comes(mesh, part_of, ranks.RANKS), None)
            # Proxies and classes take turns.
            run = run_proxy if ranks.simple and len(self.sizes) % 2 else run_class
            text = f"{name} {options} on {mesh.GetNumberOfCells()} cells, {cut}"
            self.compare(text, whole, [run(name, options, part, ranks.controller)])

    def compare(self, text, whole, outputs):
        for output in outputs:
            self.failures += [f"{text}: {found}" for found in ranks.differences(whole, output)]
        self.sizes.append((text, sum(output.GetNumberOfCells() for output in outputs), whole.GetNumberOfCells()))

    def finish(self):
        """All failures, those too that only all ranks together see."""
        sums = ranks.totals([ours for _, ours, _ in self.sizes])
        return self.failures + [f"{text}: {ours} cells together instead of {whole}"
                                for ours, (text, _, whole) in zip(sums, self.sizes) if ours != whole]


def skin_of(mesh):
    skin = vtkDataSetSurfaceFilter()
    skin.SetInputData(mesh)
    skin.Update()
    return ranks.numbered(skin.GetOutput())


def check_blocks(checks):
    """Each rank has two blocks of a collection; together they are one mesh."""
    mesh = model(subdivisionobjects.vtkSubdivisionModelSource.MATERIAL_BLOCK)
    name, options = SOLID[0]
    part_of = ranks.by_chance(mesh, 2 * ranks.RANKS)
    parts = [ranks.take(mesh, np.nonzero(part_of == 2 * ranks.RANK + i)[0], with_ids=True) for i in range(2)]
    blocks, collection = vtkMultiBlockDataSet(), vtkPartitionedDataSetCollection()
    for i, part in enumerate(parts):
        blocks.SetBlock(i, part)
        collection.SetPartition(i, 0, part)
    whole = run_class(name, options, mesh, None)
    output = run_class(name, options, blocks, ranks.controller)
    checks.compare("multiblock", whole, [output.GetBlock(i) for i in range(2)])
    output = run_class(name, options, collection, ranks.controller)
    checks.compare("collection", whole, [output.GetPartition(i, 0) for i in range(2)])


def check_deformation(checks):
    """Control meshes in parts, moved points in parts: each rank moves its points as one process does."""
    rest = model(subdivisionobjects.vtkSubdivisionModelSource.MATERIAL_BLOCK)
    deformed = rest.NewInstance()
    deformed.DeepCopy(rest)
    points = vtk_to_numpy(deformed.GetPoints().GetData())
    points += 0.1 * np.sin(3 * points[:, ::-1])
    inner = ranks.numbered(run_class("vtkMultiDimensionalSubdivision", {"NumberOfLevels": 1}, rest, None))

    def own(mesh, find, with_ids):
        return ranks.take(mesh, np.nonzero(find(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=with_ids)

    def moved(cages, mesh, controller):
        made = subdivisionobjects.vtkSubdivisionDeformation()
        made.SetController(controller)
        made.SetOutsidePointsToNearest()
        made.SetRestMeshData(cages[0])
        made.SetDeformedMeshData(cages[1])
        made.SetInputData(mesh)
        made.Update()
        return made.GetOutputDataObject(0)

    parts = [own(cage, ranks.by_chance, True) for cage in (rest, deformed)]
    checks.compare("deformation", moved((rest, deformed), inner, None),
                   [moved(parts, own(inner, ranks.in_slabs, False), ranks.controller)])


def check_filters_in_a_row(checks, mesh, options, name=SOLID[0][0], with_ids=1):
    """Two filters give on each rank what one filter with all levels gives, with its indices as global ids."""
    cut, (find, _) = next(checks.cuts)
    if not checks.is_in_turn():
        return
    part = ranks.take(mesh, np.nonzero(find(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
    both = dict(options, GenerateGlobalIds=with_ids)
    whole = run_class(name, dict(both, NumberOfLevels=2), mesh, None)
    for _ in range(2):
        part = run_class(name, dict(both, NumberOfLevels=1), part, ranks.controller)
    checks.compare(f"two filters {options} on {mesh.GetNumberOfCells()} cells, {cut}", whole, [part])


def check_filters_afresh(checks, mesh, name, options, told):
    """Where cells do not show the control mesh the second filter takes them as any other mesh, and says so."""
    if not checks.is_in_turn():
        return
    options = dict(options, NumberOfLevels=1, GenerateGlobalIds=1)
    whole = run_class(name, options, mesh, None)
    field = whole.GetFieldData()
    for array in [field.GetArrayName(i) for i in range(field.GetNumberOfArrays())]:
        if array.startswith("Subdivision"):
            field.RemoveArray(array)
    whole = run_class(name, options, whole, None)
    for find in (ranks.on_last_rank, ranks.in_slabs):
        part = ranks.take(mesh, np.nonzero(find(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
        part = run_class(name, options, part, ranks.controller)
        warnings = []
        vtkObject.GlobalWarningDisplayOn()
        part = run_class(name, options, part, ranks.controller, warnings)
        vtkObject.GlobalWarningDisplayOff()
        text = f"two filters {options} afresh on {mesh.GetNumberOfCells()} cells, {find.__name__}"
        checks.compare(text, whole, [part])
        if ranks.RANK == 0 and not any(told in warning for warning in warnings):
            checks.failures.append(f"{text}: no warning of it: {warnings}")


def check_topology(checks):
    """Each simplex is there once, with the facts that one process finds."""
    mesh = model(subdivisionobjects.vtkSubdivisionModelSource.MIXED_DIMENSIONS)
    part = ranks.take(mesh, np.nonzero(ranks.by_chance(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
    whole = run_class("vtkSimplicialComplexTopology", {}, mesh, None)
    output = run_class("vtkSimplicialComplexTopology", {}, part, ranks.controller)

    def sums(grid):
        names = ("SimplexDimension", "Boundary", "NonManifoldType", "Valence", "RuleDimension")
        facts = [grid.GetCellData().GetArray(name) for name in names]
        return [grid.GetNumberOfCells()] + [int(vtk_to_numpy(fact).sum(dtype=int)) if fact else 0 for fact in facts]

    for name in ("SimplexCounts", "EulerCharacteristic", "ManifoldComponents"):
        fields = [vtk_to_numpy(grid.GetFieldData().GetArray(name)).tolist() for grid in (whole, output)]
        if fields[0] != fields[1]:
            checks.failures.append(f"topology: {name} {fields[1]} instead of {fields[0]}")
    found = list(ranks.totals(sums(output)))
    if found != sums(whole):
        checks.failures.append(f"topology: {found} instead of {sums(whole)}")


def check_bezier_cells(checks):
    """Bezier cells of each rank are those of one process: the tolerance is a part of the whole mesh, and of all values."""
    mesh = model(subdivisionobjects.vtkSubdivisionModelSource.MIXED_DIMENSIONS)
    name, options = SOLID[0][0], {"NumberOfLevels": 1, "OutputCells": 1, "BezierTolerance": 1e-3}
    whole = run_class(name, options, mesh, None)
    part = ranks.take(mesh, np.nonzero(ranks.in_slabs(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
    output = run_class(name, options, part, ranks.controller)

    def cells_of(grid):
        """The points of the cells of each size."""
        points, groups = vtk_to_numpy(grid.GetPoints().GetData()), {}
        for ids in (grid.GetCell(cell).GetPointIds() for cell in range(grid.GetNumberOfCells())):
            groups.setdefault(ids.GetNumberOfIds(), []).append(points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]])
        return {size: np.array(cells) for size, cells in groups.items()}

    wanted = cells_of(whole)
    strange = sum(np.abs(wanted[size] - cell).max(axis=(1, 2)).min() > 1e-9
                  for size, cells in cells_of(output).items() for cell in cells)
    if strange:
        checks.failures.append(f"Bezier cells: {strange} that one process does not have")
    checks.sizes.append(("Bezier cells", output.GetNumberOfCells(), whole.GetNumberOfCells()))


def check_files(checks):
    folder = pathlib.Path(os.environ.get("SUBDIVISIONOBJECTS_SHARED_DATA", ""))
    for name in FILES:
        if not (folder / name).is_file():
            print("not there, left out:", name)
            continue
        reader = vtkXMLPolyDataReader() if name.endswith("p") else vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / name))
        reader.Update()
        filters = SURFACE[::3] if name.endswith("p") else SOLID
        mesh = ranks.numbered(reader.GetOutput())
        checks.cut(mesh, [(cls, dict(options, NumberOfLevels=1)) for cls, options in filters])
        if mesh.IsA("vtkUnstructuredGrid"):
            checks.cut(mesh, SOLID[1:] + LIMITS[2:3], "slabs")  # the first file needs a third layer
            check_filters_in_a_row(checks, mesh, {"VolumeScheme": 0})
            if ranks.RANKS == 1:
                check_filters_in_a_row(checks, mesh, {"VolumeScheme": HYBRID})
            else:
                check_filters_afresh(checks, mesh, SOLID[0][0], {"VolumeScheme": HYBRID}, "cells keep their types")
        else:
            checks.cut(mesh, ADAPTIVE)


def model(number):
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModel(number)
    source.Update()
    return ranks.numbered(source.GetOutput())


def run():
    checks = Checks()
    check_blocks(checks)
    check_deformation(checks)
    check_topology(checks)
    check_bezier_cells(checks)
    for number in range(subdivisionobjects.vtkSubdivisionModelSource.NUMBER_OF_MODELS):
        mesh = model(number)
        checks.cut(mesh, SOLID + RED_GREEN)
        check_filters_in_a_row(checks, mesh, {"DetectFeatures": 1, "VolumeScheme": number % 2})
    block = model(subdivisionobjects.vtkSubdivisionModelSource.MATERIAL_BLOCK)
    checks.cut(block, [(name, dict(options, **JUMPING)) for name, options in SOLID])
    checks.cut(block, LIMITS, "cell by cell")  # needs all layers
    check_filters_in_a_row(checks, block, JUMPING, with_ids=0)  # they are those of points, not of copies
    skin = skin_of(model(subdivisionobjects.vtkSubdivisionModelSource.MIXED_DIMENSIONS))
    checks.cut(skin, SURFACE + ADAPTIVE)
    checks.cut(skin, [(name, dict(options, **INTERPOLATED)) for name, options in (SOLID[1], SURFACE[2])])
    check_filters_in_a_row(checks, skin, INTERPOLATED, "vtkSurfaceSubdivision")
    check_files(checks)
    for scheme in SCHEMES:
        if scheme <= subdivisionobjects.vtkSurfaceSubdivision.CATMULL_CLARK or ranks.RANKS == 1:
            check_filters_in_a_row(checks, skin, {"DetectFeatures": 1, "Scheme": scheme}, "vtkSurfaceSubdivision")
        else:
            check_filters_afresh(checks, skin, "vtkSurfaceSubdivision", {"DetectFeatures": 1, "Scheme": scheme},
                                 "does not go on over ranks")
    return checks.finish()


ranks.main(run)
