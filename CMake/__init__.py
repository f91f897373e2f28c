"""Subdivision of meshes that mix volumes, surfaces and curves: every class of the project.

The VTK modules that the classes are built on have to be loaded first. In ParaView's Python they
are ParaView's own, elsewhere those of the VTK that this package was built against.
"""

from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel  # noqa: F401

from .vtkSubdivisionObjects import *  # noqa: F401,F403
