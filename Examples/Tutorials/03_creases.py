# SPDX-License-Identifier: BSD-3-Clause
"""3. Creases: edges of a cube that are smooth, sharp for some levels, or sharp for ever.

In ParaView: Surface Subdivision; select edges' points, Copy Active Selection into Mark Selection, Mark Creases.
"""

from picture import picture
from subdivisionobjects import surface_subdivision

points = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
rim = [[4, 5], [5, 7], [7, 6], [6, 4]]  # pairs of points


def subdivide(**creases):
    return surface_subdivision(points, quads, scheme="catmull-clark", levels=3, **creases)


smooth = subdivide()
semi_sharp = subdivide(creases=[edge + [1.5] for edge in rim])  # sharp for 1.5 levels
sharp = subdivide(creases=rim)

picture(smooth, semi_sharp, sharp)
