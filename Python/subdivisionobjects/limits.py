# SPDX-License-Identifier: BSD-3-Clause
"""The limit at places of cells, and derivatives of its measures. NumPy is loaded when it is needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPointData, vtkPolyData

from .arrays import Arrays
from .execution import listen_to
from .run import find_filter, prepare, to_filter

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike

    from .kinds import AnyMesh, Cells


def evaluate_limit(
    mesh: AnyMesh, cells: ArrayLike, parameters: ArrayLike, *, function: Union[str, Callable[..., object]] = "subdivide", **options: Any
) -> Arrays:
    """The limit of a mesh by `subdivide` or `surface_subdivision`, with options that choose rules, at many places.

        at = evaluate_limit((points, tetrahedra), [0, 0], [[0.25, 0.25, 0.25], [0, 0, 1]])
        at = evaluate_limit((points, quads), [3], [[0.5, 0.5]], function="surface_subdivision", scheme="catmull-clark")

    mesh: a pair of points and cells, or another mesh that these functions take; or a vtkMultiDimensionalSubdivision or
    vtkSurfaceSubdivision, with its input and rules.
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
        raise ValueError(
            "there must be a cell and a row of one to three parameters for each place, not the shapes "
            f"{ids.shape} and {given.shape}"
        )
    rows = np.zeros((len(ids), 3))
    rows[:, : given.shape[1]] = given
    result = vtkPolyData()
    progress = options.pop("progress", None)
    made, words = to_filter(mesh, None, function, options)
    with listen_to(made, words, progress):
        made.EvaluateLimit(meshes.to_vtk_ids(ids), meshes.to_vtk_array(rows), result)
    return meshes.to_arrays(result)


def measure_gradients(
    mesh: AnyMesh, cells: Optional[Cells] = None, *, row: int = 0, **options: Any
) -> Dict[str, np.ndarray[Any, Any]]:
    """The derivatives of a row of `measures`, with these options, by the control points: a dictionary of arrays with a row
    for each point.

        made = measure_gradients(points, tetrahedra, point_data={"Heat": heat})
        made["MeasureByPoints"]         # of the volume, by x, y and z
        made["HeatIntegralByPoints"]    # of the integral of Heat, by x, y and z
        made["HeatIntegralByValues"]    # the same, by the value of Heat

    With `density_array` there are "MassByPoints", "MassByDensity" and "HeatIntegralByDensity", too. An array of several
    components has x, y and z of one component after another.
    """
    from . import meshes

    one = find_filter("measures")
    progress = options.pop("progress", None)
    made = prepare(one, {"mesh": mesh, "cells": cells, **options}).made
    found = vtkPointData()
    with listen_to(made, one.words, progress):
        made.ComputeGradients(row, found)
    return meshes.data_arrays(found)
