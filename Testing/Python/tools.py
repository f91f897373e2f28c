# SPDX-License-Identifier: BSD-3-Clause
"""What the ParaView tests share: importing this loads the plugin."""

import os
import sys
import unittest

from paraview import simple
from quiet import quiet  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy

plugin = os.environ.get("SUBDIVISIONOBJECTS_PLUGIN", "")
if not os.path.isfile(plugin):
    sys.exit(f"SUBDIVISIONOBJECTS_PLUGIN names no file: '{plugin}'")
simple.LoadPlugin(plugin, remote=False, ns=vars(simple))

# A line has 2 children, a triangle 4, a tetrahedron 8.
FACTORS = {1: 1, 3: 2, 5: 4, 10: 8}


def output(proxy):
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def arrays(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


def cells_after(grid, levels):
    """How many cells so many levels make of a grid of simplices."""
    return sum(FACTORS[grid.GetCellType(i)] ** levels for i in range(grid.GetNumberOfCells()))


def numbers(grid):
    """Numbers that two equal grids share, and different ones hardly do."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    found = [grid.GetNumberOfCells(), grid.GetNumberOfPoints(), points.sum(), abs(points).sum()]
    for attributes in (grid.GetPointData(), grid.GetCellData()):
        for name in sorted(arrays(attributes)):
            found.append((name, vtk_to_numpy(attributes.GetArray(name)).sum(dtype=float)))
    return found


def saved_and_loaded(proxy):
    """The proxy as a state file brings it back in a new session."""
    simple.RenameSource("saved", proxy)
    state = os.path.abspath("saved.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    simple.LoadState(state)
    return simple.FindSource("saved")


def main():
    """Runs the tests of the script. Ends at once: with windows open, ParaView may crash as it tidies up."""
    program = unittest.main(verbosity=2, exit=False)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if program.result.wasSuccessful() else 1)
