# SPDX-License-Identifier: BSD-3-Clause
"""5. Detail where it is needed: cells are split only where the surface bends, and the mesh fits together everywhere.

In ParaView: Red-green Refinement, Shape = Smooth, criterion Curvature with its angle.
"""

from picture import picture
import subdivisionobjects

part = subdivisionobjects.model(model="MechanicalPart")
everywhere = subdivisionobjects.subdivide(part, levels=2)
where_it_bends = subdivisionobjects.red_green_refinement(
    part, placement="Limit", refine={"curvature": 15}, maximum_level=2)
print(everywhere.GetNumberOfCells(), "cells everywhere,", where_it_bends.GetNumberOfCells(), "where the surface bends")

picture(where_it_bends, direction=(-0.45, -1, 0.75))
