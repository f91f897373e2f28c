# SPDX-License-Identifier: BSD-3-Clause
"""1. Attributes: a temperature at few points becomes a smooth field in the solid, and is drawn as a cloud.

In ParaView: Sources > Subdivision Model, Multi-dimensional Subdivision, colour by Tension, representation Volume.
"""

from picture import picture
import subdivisionobjects

block = subdivisionobjects.model(model="MaterialBlock")  # its point array Tension changes from point to point
control = subdivisionobjects.subdivide(block, levels=0)
smooth = subdivisionobjects.subdivide(block, levels=3)  # arrays of floating point numbers are smoothed as points are

for mesh in (control, smooth):
    low, high = mesh.GetPointData().GetArray("Tension").GetRange()
    print(mesh.GetNumberOfPoints(), "points, tension from", round(low, 2), "to", round(high, 2))

picture(control, smooth, array="Tension", cloud=True)
