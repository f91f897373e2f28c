# SPDX-License-Identifier: BSD-3-Clause
"""0. Hello, solid: five points and two tetrahedra become a smooth solid.

In ParaView: open a file of tetrahedra, Filters > Subdivision Objects > Multi-dimensional Subdivision, Apply.
"""

from picture import picture
from subdivisionobjects import subdivide

points = [[0, 0, 0], [1, 0, 0], [0.5, 0.9, 0], [0.5, 0.3, 0.8], [0.5, 0.3, -0.8]]
tetrahedra = [[0, 1, 2, 3], [0, 2, 1, 4]]

control = subdivide(points, tetrahedra, levels=0)
smooth = subdivide(points, tetrahedra, levels=3)  # each level splits a tetrahedron into 8, and moves points
print(len(tetrahedra), "tetrahedra became", len(smooth.cells))

picture(control, smooth)
