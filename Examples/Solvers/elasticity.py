# SPDX-License-Identifier: BSD-3-Clause
"""Linear elasticity: the mechanical part, held at its flat end and pressed down at the other, by CalculiX with curved cells C3D10.

Needs ccx (Debian: calculix-ccx). The stress comes back as point data, and is drawn on the smooth object.
"""

import numpy as np
from calculix import draw, mises, node_set, points_of, run, with_results
import subdivisionobjects

# One curved cell of ten nodes for each tetrahedron of level 1; all nodes are on the smooth object.
part = subdivisionobjects.subdivide(subdivisionobjects.model(model="MechanicalPart"), levels=1, output_cells="Quadratic",
                                    output_dimensions="Tetrahedra")
subdivisionobjects.write_solver_mesh(part, "part.inp")

points = points_of(part)
low, high = points.min(axis=0), points.max(axis=0)
held = np.flatnonzero(points[:, 0] > high[0] - 1e-6)
free = np.flatnonzero(points[:, 0] < low[0] + 0.1 * (high - low)[0])
results = run("elasticity", f"""*INCLUDE, INPUT=part.inp
{node_set("HELD", held)}
{node_set("FREE", free)}
*MATERIAL, NAME=STEEL
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=SOLIDS, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
HELD, 1, 3
*CLOAD
FREE, 3, {-1 / len(free)}
*NODE FILE
U
*EL FILE
S
*END STEP
""")

stress, displacement = mises(results["STRESS"]), results["DISP"][:, :3]
length, width, thickness = high - low
print(f"{part.GetNumberOfCells()} cells C3D10, {part.GetNumberOfPoints()} nodes: the tip moves by "
      f"{-displacement[free, 2].mean():.5f}, that of a straight bar of this size by "
      f"{4 * length**3 / (210000 * width * thickness**3):.5f}; the largest stress is {stress.max():.1f}")
scale = 0.1 * length / np.abs(displacement).max()
draw(part, with_results(part, displacement, scale, Stress=stress), array="Stress")
