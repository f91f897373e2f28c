# SPDX-License-Identifier: BSD-3-Clause
"""vtkSubdivisionMeasures on ranks that share a mesh: each has the table of the whole, but for rounding."""

import numpy as np
import rank_tools as ranks
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects


def measured(mesh, controller):
    made = subdivisionobjects.vtkSubdivisionMeasures()
    if not controller:
        made.SetController(None)
    made.SetMaximumLevel(2)
    made.SetInputDataObject(mesh)
    made.Update()
    rows = made.GetOutput().GetRowData()
    return {rows.GetArrayName(i): vtk_to_numpy(rows.GetArray(i)) for i in range(rows.GetNumberOfArrays())}


def run():
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModelToMechanicalPart()
    source.Update()
    mesh = ranks.numbered(source.GetOutput())
    expected = measured(mesh, False)
    failures = []
    for find in (ranks.in_slabs, ranks.by_chance, ranks.on_last_rank):
        part = ranks.take(mesh, np.nonzero(find(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
        found = measured(part, True)
        if set(found) != set(expected):
            failures.append(f"{find.__name__}: columns {set(found) ^ set(expected)}")
            continue
        for name, values in found.items():
            wanted = expected[name]
            if values.shape != wanted.shape or not np.allclose(values, wanted, rtol=1e-10, atol=1e-10):
                failures.append(f"{find.__name__}: {name}")
    return failures


ranks.main(run)
