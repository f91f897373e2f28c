# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline in plain Python. Documentation/Guide/Python.md says what PYTHONPATH has to be."""
from subdivisionobjects import vtkMultiDimensionalSubdivision, vtkSubdivisionModelSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

model = vtkSubdivisionModelSource()
model.SetModelToShip()
smooth = vtkMultiDimensionalSubdivision()
smooth.SetInputConnection(model.GetOutputPort())
smooth.SetNumberOfLevels(3)
smooth.Update()
print(model.GetOutput().GetNumberOfCells(), "cells became", smooth.GetOutput().GetNumberOfCells())
writer = vtkXMLUnstructuredGridWriter()
writer.SetInputConnection(smooth.GetOutputPort())
writer.SetFileName("ship.vtu")
writer.SetDataModeToBinary()  # appended data are what ParaView 5.11 cannot read on all systems
writer.Write()
