# SPDX-License-Identifier: BSD-3-Clause
"""6. Deformation: a detailed object bends with the few points of a cage around it.

In ParaView: Cage Around the object, Edit Selection on the cage, Subdivision Deformation with object and both cages.
"""

from picture import picture
import subdivisionobjects

ship = subdivisionobjects.subdivide(subdivisionobjects.model(model="Ship"), levels=2)
cage = subdivisionobjects.cage_around(ship)
low, high = cage.GetBounds()[:2]

# The half of the cage in front turns upwards.
front = [i for i in range(cage.GetNumberOfPoints()) if cage.GetPoint(i)[0] > 0.5 * (low + high)]
moved = subdivisionobjects.edit(cage, selection={"points": front}, rotation=(0, -20, 25), falloff_radius=0.3 * (high - low))
bent = subdivisionobjects.deformation(ship, rest_mesh=cage, deformed_mesh=moved)

picture(ship, bent, edges=False, direction=(0.7, -1, 0.5))
