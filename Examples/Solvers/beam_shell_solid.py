# SPDX-License-Identifier: BSD-3-Clause
"""Beams, shells and solids in one mesh: the flower, whose stem is a curve, whose petals are surfaces and whose head is solid, in
the wind, by CalculiX with cells B32, S6 and C3D10.

Needs ccx (Debian: calculix-ccx). Parts of all dimensions share their nodes, so no tie and no contact is needed.
"""

import pathlib
import re

import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_LINE, vtkUnstructuredGrid
from calculix import draw, points_of, run, with_results
import subdivisionobjects

# A solid holds the place of the end of a beam alone, a shell also its tilt: the flower would turn there. So the stem goes on in
# the head, around a corner, and in the leaves.
control = vtkUnstructuredGrid()
control.DeepCopy(subdivisionobjects.model(model="MixedDimensions"))
arrays = control.GetCellData()
for line in ((0, 7), (7, 8), (72, 78), (74, 85)):
    control.InsertNextCell(VTK_LINE, 2, line)
    for i in range(arrays.GetNumberOfArrays()):
        arrays.GetArray(i).InsertNextTuple(arrays.GetArray(i).GetTuple(0))
flower = subdivisionobjects.subdivide(control, levels=1, output_cells="Quadratic")
subdivisionobjects.write_solver_mesh(flower, "flower.inp")

points = points_of(flower)
foot = int(points[:, 2].argmin()) + 1
results = run("beam_shell_solid", f"""*INCLUDE, INPUT=flower.inp
*MATERIAL, NAME=GREEN
*ELASTIC
1e9, 0.3
*DENSITY
1
*SOLID SECTION, ELSET=SOLIDS, MATERIAL=GREEN
*SHELL SECTION, ELSET=SURFACES, MATERIAL=GREEN
0.03
*BEAM SECTION, ELSET=CURVES, MATERIAL=GREEN, SECTION=CIRC
0.08, 0.08
1, 0, 0
*STEP
*STATIC
*BOUNDARY
{foot}, 1, 6
*DLOAD
SOLIDS, GRAV, 1, 1, 0, 0
SURFACES, GRAV, 1, 1, 0, 0
CURVES, GRAV, 1, 1, 0, 0
*EL PRINT, ELSET=SOLIDS, TOTALS=ONLY
EVOL
*EL PRINT, ELSET=SURFACES, TOTALS=ONLY
EVOL
*NODE FILE, OUTPUT=2D
U
*END STEP
""")

displacement = results["DISP"][:, :3]
# Point 0 is the limit of vertex 0, where the stem meets the head, whose middle is at z = 0. A straight beam of this height, which
# is round with a diameter of 0.08, bends by `beam` under the weight of the head and of all leaves.
weight = sum(map(float, re.findall(r"total volume.*\n\n +(\S+)", pathlib.Path("beam_shell_solid.dat").read_text())))
height, arm = points[0, 2] - points[foot - 1, 2], -points[0, 2]
beam = weight * (height**3 / 3 + arm * height**2 / 2) / (1e9 * np.pi * 0.08**4 / 64)
print(f"{flower.GetNumberOfCells()} cells, {flower.GetNumberOfPoints()} nodes: the stem moves at its top by "
      f"{displacement[0, 0]:.4f}, a straight beam by {beam:.4f}")
scale = 0.2 * flower.GetLength() / np.abs(displacement).max()
draw(flower, with_results(flower, displacement, scale, Displacement=np.linalg.norm(displacement, axis=1)),
     array="Displacement", curved=False)
