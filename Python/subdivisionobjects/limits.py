# SPDX-License-Identifier: BSD-3-Clause
"""The limit at places of cells. NumPy is loaded when it is needed."""

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .run import Arrays, listen_to


def evaluate_limit(made, cells, parameters) -> Arrays:
    """The limit of a vtkMultiDimensionalSubdivision or vtkSurfaceSubdivision, with its input and rules, at many places.

    cells: the id of a cell for each place, which is a vertex, line, triangle or tetrahedron. parameters: a row of one to
    three numbers u, v, w for each: the weights of the second, third and fourth point of the cell; the first has the
    rest. By CatmullClark cells are polygons: in a quad u goes from the first point to the second and v to the fourth,
    both from 0 to 1; in others w is the number of a point, and u and v those in the quad that the first step makes there.
    Gives points, and in point_data all smoothed arrays there, the derivatives DerivativeU, DerivativeV and
    DerivativeW of the points, and the LimitNormals, MeanCurvature and GaussianCurvature of surfaces; MeanCurvature of a
    curve is its curvature.
    """
    import numpy as np
    from . import meshes
    ids = meshes.to_integers("cells", cells)
    given = meshes.to_numpy("parameters", parameters)
    if given.dtype.kind not in "iuf":
        raise ValueError(f"parameters must be numbers, not {given.dtype}")
    if ids.ndim != 1 or given.ndim != 2 or len(given) != len(ids) or not 1 <= given.shape[1] <= 3:
        raise ValueError("there must be a cell and a row of one to three parameters for each place, not the shapes "
                         f"{ids.shape} and {given.shape}")
    rows = np.zeros((len(ids), 3))
    rows[:, :given.shape[1]] = given
    result = vtkPolyData()
    with listen_to(made):
        made.EvaluateLimit(meshes.to_vtk_ids(ids), meshes.to_vtk_array(rows), result)
    return meshes.to_arrays(result)
