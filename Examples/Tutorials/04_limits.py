# SPDX-License-Identifier: BSD-3-Clause
"""4. Limits: points on the smooth object itself, its normals, and exact values at any place of a cell.

In ParaView: Project To Limit, Generate Limit Normals; filter Subdivision Limit Probe for places.
"""

import numpy as np
from picture import picture
import subdivisionobjects
from vtkmodules.vtkFiltersSources import vtkSphereSource

points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1.0]])
triangles = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
limit = subdivisionobjects.subdivide(points, {"triangle": triangles}, levels=3, project_to_limit=True,
                                     generate_limit_normals=True)

# A place is a cell, and the weights of its second and third point.
corners = subdivisionobjects.evaluate_limit((points, {"triangle": triangles}), range(8), [[1 / 3, 1 / 3, 0]] * 8)
print("the centre of the first face is at", corners.points[0])
print("the normal there is", corners.point_data["LimitNormals"][0])

balls = []
for place in corners.points:
    ball = vtkSphereSource()
    ball.SetCenter(place)
    ball.SetRadius(0.05)
    ball.Update()
    balls.append(ball.GetOutput())
picture([limit, *balls], edges=False)
