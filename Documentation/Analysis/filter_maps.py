# SPDX-License-Identifier: BSD-3-Clause
"""Characteristic maps of schemes for solids, of sqrt(3) and of 4-8, as vtkSubdivisionSmoothness samples them."""

import numpy as np
from pages import yes
from quiet import quiet
from vtkmodules.util.numpy_support import vtk_to_numpy

from subdivisionobjects import vtkSubdivisionSmoothness

COLUMNS = ["regular", "injective", "samples"]


def sampled(made, scheme, corners, sector=-1, **options):
    """What the filter says of a vertex, an edge or a face of a mesh, or of a sector at a vertex: the moduli l1, l2, ... of
    its eigenvalues, whether the map is regular and injective (-1: none was sampled), and in how many cells."""
    with quiet():
        smoothness = vtkSubdivisionSmoothness()
        smoothness.SetInputData(made)
        smoothness.SetScheme(getattr(vtkSubdivisionSmoothness, scheme))
        smoothness.SetSampleMaps(True)
        for name, value in options.items():
            getattr(smoothness, "Set" + name)(value)
        smoothness.Update()
    out = smoothness.GetOutput()

    def values(name):
        return vtk_to_numpy(out.GetCellData().GetArray(name))

    ends = vtk_to_numpy(out.GetCells().GetOffsetsArray())
    ids = vtk_to_numpy(out.GetCells().GetConnectivityArray())
    named = (values("SimplexDimension") == len(corners) - 1) & (values("Sector") == sector)
    cell, = (cell for cell in np.flatnonzero(named) if set(ids[ends[cell]:ends[cell + 1]]) == set(corners))
    regular, injective, samples = (int(values(name)[cell]) for name in ("Regular", "Injective", "Samples"))
    return values("Eigenvalues")[cell, 1:].tolist(), regular, injective, samples


def columns(made, scheme, corners, expected, sector=-1, **options):
    """The three columns of a table, for what has these moduli by the table's own computation, too."""
    found, regular, injective, samples = sampled(made, scheme, corners, sector, **options)
    count = min(len(found), len(expected))
    np.testing.assert_allclose(found[:count], expected[:count], atol=1e-6)
    return [yes(regular), yes(injective), str(samples)] if samples else ["-", "-", "-"]
