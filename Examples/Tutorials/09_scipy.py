# SPDX-License-Identifier: BSD-3-Clause
"""9. The operator in SciPy: all of subdivision is one sparse matrix, with which values can be fitted to data.

In ParaView: a Programmable Filter with this code; Interpolate Arrays does the same for data at the points.
"""

import numpy as np
from picture import picture
from scipy.sparse.linalg import lsqr
import subdivisionobjects
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

smooth = subdivisionobjects.vtkMultiDimensionalSubdivision()
smooth.SetInputDataObject(subdivisionobjects.model(model="MaterialBlock"))
smooth.SetNumberOfLevels(2)
S = subdivisionobjects.operator_matrix(smooth).to_scipy()
print("a matrix of", S.shape[0], "by", S.shape[1], "with", S.nnz, "weights")

# Measured values at the fine points; which values at the 36 control points come nearest to them?
smooth.Update()
fine = smooth.GetOutput()
places = vtk_to_numpy(fine.GetPoints().GetData())
wanted = np.sin(4 * places[:, 0]) * places[:, 2] + np.random.default_rng(1).normal(0, 0.3, len(places))
fitted = S @ lsqr(S, wanted)[0]

views = []
for values in (wanted, fitted):
    views.append(fine.NewInstance())
    views[-1].CopyStructure(fine)
    array = numpy_to_vtk(values, deep=True)
    array.SetName("Values")
    views[-1].GetPointData().AddArray(array)
picture(*views, array="Values", edges=False)
