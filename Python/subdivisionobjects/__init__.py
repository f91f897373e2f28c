# SPDX-License-Identifier: BSD-3-Clause
"""Subdivision of meshes that mix volumes, surfaces and curves.

`subdivide` and the other functions take and return arrays of NumPy, data sets of VTK, or meshes of PyVista:

    points, cells = subdivisionobjects.subdivide(points, cells, levels=3)

The classes (vtkMultiDimensionalSubdivision and so on) are for pipelines.
"""

# The VTK modules that the classes are built on have to be loaded first. In ParaView's Python they are ParaView's own,
# elsewhere those of the VTK that this package was built against.
from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel  # noqa: F401

from .vtkSubdivisionObjects import *  # noqa: F401,F403
from .functions import *  # noqa: F401,F403
from .functions import __version__, multi_dimensional_subdivision  # noqa: F401
from .limits import evaluate_limit  # noqa: F401
from .matrices import operator_factors, operator_matrix  # noqa: F401
from .run import Arrays  # noqa: F401

subdivide = multi_dimensional_subdivision
