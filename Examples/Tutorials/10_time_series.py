# SPDX-License-Identifier: BSD-3-Clause
"""10. A time series: cells stay, points and values change, and each step costs one product with the kept operator.

In ParaView: open a series, Multi-dimensional Subdivision, play. The filter keeps the operator by itself.
"""

import time

import numpy as np
from picture import picture
from subdivisionobjects import Subdivider

rows = 12
points = np.array([[x, y, 0.0] for x in range(rows) for y in range(rows)])
quads = [[rows * x + y, rows * x + y + rows, rows * x + y + rows + 1, rows * x + y + 1]
         for x in range(rows - 1) for y in range(rows - 1)]
smooth = Subdivider(points, {"quad": quads}, levels=3)

steps = []
start = time.perf_counter()
for step in range(20):
    wave = np.sin(points[:, 0] - 0.5 * step) * np.cos(points[:, 1] / 3)
    made = smooth.apply({"Height": wave})
    made.points = smooth.apply(points + wave[:, None] * [0, 0, 1])
    steps.append(made)
print("a step took", round((time.perf_counter() - start) / 20 * 1000, 1), "ms")

picture(*steps[::7], array="Height", edges=False, direction=(0.6, -1, 1.2))
