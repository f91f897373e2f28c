# SPDX-License-Identifier: BSD-3-Clause
"""2. Two materials: the surface between them stays smooth and sharp, and a value jumps there.

In ParaView: Multi-dimensional Subdivision, part Materials: Preserve Interfaces, Interface Values = Discontinuous.
"""

from picture import picture
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet
import subdivisionobjects

block = subdivisionobjects.model(model="MaterialBlock")  # its cell array MaterialId says which cell is which material


def cut_open(mesh):
    plane = vtkPlane()
    plane.SetOrigin([x + 0.01 for x in block.GetCenter()])
    plane.SetNormal(0.31, 1, 0.02)
    clip = vtkClipDataSet()
    clip.SetInputData(mesh)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


blurred = subdivisionobjects.subdivide(block, levels=3)
jumps = subdivisionobjects.subdivide(block, levels=3, preserve_interfaces=True, interface_values="Discontinuous")
print(jumps.GetNumberOfPoints() - blurred.GetNumberOfPoints(), "points have a second value")

picture(cut_open(blurred), cut_open(jumps), array="Tension", edges=False)
