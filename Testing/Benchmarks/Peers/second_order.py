# SPDX-License-Identifier: BSD-3-Clause
"""Quadratic tetrahedra of a plate with a round hole: by Gmsh from a CAD model (OpenCASCADE), and by OutputCells = Quadratic
from the control mesh MechanicalPart. By hand: second_order.py, with a Python that finds subdivisionobjects and gmsh
(Debian: python3-gmsh). All in one thread; processor time, medians of three.

What is not comparable: Gmsh makes its tetrahedra, of a size that it is told, from exact faces of a CAD model; this project
splits tetrahedra that it is given, and its limit is the shape. Nearest to its work is the step setOrder(2) of Gmsh alone, which
puts nodes on edges and on the CAD faces. setOrder(2) does not prove that cells are valid, OutputCells = Quadratic does."""

import statistics
import time

import gmsh
from vtkmodules.vtkCommonCore import vtkSMPTools

import subdivisionobjects

LEVELS = (1, 2, 3)


def plate(size):
    """Seconds to mesh, and for the second order; numbers of tetrahedra and nodes."""
    gmsh.clear()
    gmsh.model.add("plate")
    box = gmsh.model.occ.addBox(-2, -1, 0, 4, 2, 0.5)
    hole = gmsh.model.occ.addCylinder(-1, 0, 0, 0, 0, 0.5, 0.5)
    part = gmsh.model.occ.cut([(3, box)], [(3, hole)])[0]
    gmsh.model.occ.synchronize()
    edges = [tag for _, tag in gmsh.model.getEntities(1)]
    upright = [tag for tag in edges if abs(gmsh.model.getBoundingBox(1, tag)[2] - gmsh.model.getBoundingBox(1, tag)[5]) > 0.4
               and gmsh.model.getBoundingBox(1, tag)[0] > 1.9]
    gmsh.model.occ.fillet([part[0][1]], upright, [0.5])
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    start = time.process_time()
    gmsh.model.mesh.generate(3)
    meshed = time.process_time()
    gmsh.model.mesh.setOrder(2)
    done = time.process_time()
    return meshed - start, done - meshed, *count()


def count():
    return sum(map(len, gmsh.model.mesh.getElements(3)[1])), len(gmsh.model.mesh.getNodes()[0])


def quadratic(model, levels):
    """Seconds with OutputCells = Quadratic, and Linear with as many points; numbers of tetrahedra and nodes."""
    seconds = []
    for cells, more in (("Quadratic", 0), ("Linear", 1)):
        made = subdivisionobjects.vtkMultiDimensionalSubdivision()
        made.SetInputDataObject(model)
        made.SetNumberOfLevels(levels + more)
        made.ProjectToLimitOn()
        getattr(made, f"SetOutputCellsTo{cells}")()
        made.SetOutputDimensions(8)
        start = time.process_time()
        made.Update()
        seconds.append(time.process_time() - start)
        if not more:
            output = made.GetOutput()
    return *seconds, output.GetNumberOfCells(), output.GetNumberOfPoints()


def median(run, *given):
    return [statistics.median(values) for values in zip(*(run(*given) for _ in range(3)))]


def main():
    vtkSMPTools.Initialize(1)
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    model = subdivisionobjects.model(model="MechanicalPart")
    print("| way | tetrahedra | nodes | seconds | nodes a second |\n|---|---|---|---|---|")
    for levels in LEVELS:
        ours, linear, cells, nodes = median(quadratic, model, levels)
        print(f"| OutputCells = Quadratic, {levels} level(s) | {cells:,.0f} | {nodes:,.0f} | {ours:.3f} | {nodes / ours:,.0f} |")
        print(f"| OutputCells = Linear, as many points | {8 * cells:,.0f} | {nodes:,.0f} | {linear:.3f} | {nodes / linear:,.0f} |")
        size = (19 / cells) ** (1 / 3)
        mesh, order, cells, nodes = median(plate, size)
        print(f"| Gmsh {gmsh.__version__}, mesh and setOrder(2) | {cells:,.0f} | {nodes:,.0f} | {mesh + order:.3f} "
              f"| {nodes / (mesh + order):,.0f} |")
        print(f"| Gmsh, setOrder(2) alone | {cells:,.0f} | {nodes:,.0f} | {order:.3f} | {nodes / order:,.0f} |")


if __name__ == "__main__":
    main()
