# SPDX-License-Identifier: BSD-3-Clause
"""8. Labels to solids: voxels of a segmented scan become one smooth solid of two materials.

In ParaView: open the image of labels, Smooth Solid from Labels, Apply; colour by Label.
"""

import numpy as np
from picture import picture
from subdivisionobjects import label_solid

x, y, z = np.mgrid[-1:1:16j, -1:1:16j, -1:1:16j]
labels = np.zeros(x.shape, np.uint8)
labels[x**2 + y**2 + z**2 < 0.7] = 1
labels[(x - 0.4) ** 2 + (y + 0.5) ** 2 + (z - 0.4) ** 2 < 0.2] = 2

voxels = label_solid(labels, spacing=(2 / 15,) * 3, number_of_control_cells=0, levels=0)
solid = label_solid(labels, spacing=(2 / 15,) * 3)
print(len(solid.cells), "tetrahedra of labels", np.unique(solid.cell_data["Label"]))

picture(voxels, solid, array="Label", edges=False)
