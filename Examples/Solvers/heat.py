# SPDX-License-Identifier: BSD-3-Clause
"""Heat in two materials, by dolfinx with curved cells of ten nodes: the outer material conducts ten times as well.

Needs dolfinx and gmsh (Debian: python3-dolfinx, python3-gmsh). The temperature comes back as point data, and equals that
of a few lines of NumPy and SciPy on the same cells.
"""

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc
from calculix import draw, points_of, with_results
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve
from vtkmodules.util.numpy_support import vtk_to_numpy
import subdivisionobjects

CONDUCTIVITY = {0: 10.0, 1: 1.0}  # by MaterialId

block = subdivisionobjects.subdivide(subdivisionobjects.model(model="MaterialBlock"), levels=1, output_cells="Quadratic",
                                     preserve_interfaces=True)
subdivisionobjects.write_solver_mesh(block, "block.msh", groups="MaterialId")
points, materials = points_of(block), vtk_to_numpy(block.GetCellData().GetArray("MaterialId"))
cold = np.flatnonzero(points[:, 2] < points[:, 2].min() + 0.05)


def by_dolfinx():
    """-div(k grad T) = 1, T = 0 at the cold nodes, with functions that are quadratic in the parameters of curved cells."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open("block.msh")
    mesh, groups, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0)
    gmsh.finalize()
    k = fem.Function(fem.FunctionSpace(mesh, ("DG", 0)))
    number = {material: material or 2 for material in CONDUCTIVITY}  # Gmsh counts groups from 1
    for material, value in CONDUCTIVITY.items():
        k.x.array[groups.find(number[material])] = value
    space = fem.FunctionSpace(mesh, ("Lagrange", 2))
    # Each function belongs to a node of the mesh, and this to a point of ours.
    given = np.array(mesh.geometry.input_global_indices)
    node = np.zeros(space.dofmap.index_map.size_local, int)
    for cell in range(mesh.topology.index_map(3).size_local):
        node[space.dofmap.cell_dofs(cell)] = given[mesh.geometry.dofmap.links(cell)]
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    held = fem.dirichletbc(PETSc.ScalarType(0), np.flatnonzero(np.isin(node, cold)).astype(np.int32), space)
    more = {"quadrature_degree": 10}
    problem = fem.petsc.LinearProblem(k * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx(metadata=more),
                                      v * ufl.dx(metadata=more), [held], petsc_options={"pc_type": "lu"})
    temperature = np.zeros(len(points))
    temperature[node] = problem.solve().x.array
    return temperature


def by_scipy():
    """The same, with the shape functions of VTK's quadratic tetrahedra."""
    cells = vtk_to_numpy(block.GetCells().GetConnectivityArray()).reshape(-1, 10)
    x, w = np.polynomial.legendre.leggauss(6)
    a, b, c = np.meshgrid(*3 * [(x + 1) / 2], indexing="ij")  # Gauss points of a cube, squeezed into a tetrahedron
    weights = np.einsum("i,j,k->ijk", *3 * [w / 2]) * (1 - a)**2 * (1 - b)
    a, b, c, weights = (one.ravel() for one in (a, b * (1 - a), c * (1 - a) * (1 - b), weights))
    corners, slopes = np.stack([1 - a - b - c, a, b, c]), np.array([[-1, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    i, j = np.array([(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]).T
    shapes = np.concatenate([corners * (2 * corners - 1), 4 * corners[i] * corners[j]])
    gradients = np.concatenate([(4 * corners - 1)[:, :, None] * slopes[:, None],
                                4 * (corners[i, :, None] * slopes[j, None] + corners[j, :, None] * slopes[i, None])])
    jacobians = np.einsum("cnd,nqa->cqda", points[cells], gradients)
    volumes = np.linalg.det(jacobians) * weights
    by_place = np.einsum("nqa,cqad->cqnd", gradients, np.linalg.inv(jacobians))
    k = np.vectorize(CONDUCTIVITY.get)(materials)
    matrix = np.einsum("cqnd,cqmd,cq,c->cnm", by_place, by_place, volumes, k, optimize=True)
    rows, columns = np.repeat(cells, 10, axis=1).ravel(), np.tile(cells, 10).ravel()
    matrix = coo_matrix((matrix.ravel(), (rows, columns))).tocsc()
    free = np.setdiff1d(np.arange(len(points)), cold)
    right = np.bincount(cells.ravel(), np.einsum("nq,cq->cn", shapes, volumes).ravel())
    temperature = np.zeros(len(points))
    temperature[free] = spsolve(matrix[free][:, free], right[free])
    return temperature


temperature, other = by_dolfinx(), by_scipy()
print(f"{block.GetNumberOfCells()} cells, {len(points)} nodes: the largest temperature is {temperature.max():.4f}, and "
      f"{np.abs(temperature - other).max():.1e} from that of SciPy")
draw(block, with_results(block, Temperature=temperature), array="Temperature")
