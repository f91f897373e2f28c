# SPDX-License-Identifier: BSD-3-Clause
"""7. Edit, and keep the detail: what was drawn on a fine level follows when the coarse mesh is changed.

In ParaView: Subdivide, Edit Selection with Frame = Local, Subdivide; then Edit Selection in front of the first one.
"""

from picture import picture
from subdivisionobjects import edit, subdivide

points = [[x, y, 0.0] for x in range(9) for y in range(3)]
quads = [[3 * x + y, 3 * x + y + 3, 3 * x + y + 4, 3 * x + y + 1] for x in range(8) for y in range(2)]
flat = subdivide(points, {"quad": quads}, levels=0)
right = [i for i, point in enumerate(points) if point[0] > 5]
bent = edit(flat, selection={"points": right}, rotation=(0, -80, 0), centre=(4, 0, 0), falloff_radius=3)


def add_bumps(mesh, frame):
    """Bumps along the middle, in the world or in the frames of the surface."""
    bumps = {"points": [i for i, x in enumerate(rest.points) if abs(x[1] - 1) < 0.1 and x[0] % 1 == 0]}
    return edit(mesh, selection=bumps, rest_mesh=rest, frame=frame, translation=(0, 0, 0.6), falloff_radius=0.5)


rest, moved = subdivide(flat, levels=2), subdivide(bent, levels=2)
picture(*(subdivide(add_bumps(mesh, frame), levels=1)
          for mesh, frame in ((rest, "Local"), (moved, "World"), (moved, "Local"))), edges=False)
