# SPDX-License-Identifier: BSD-3-Clause
"""Uniform refinement of MFEM (package mfem of PyPI) beside VolumeScheme Linear with KeepCellTypes, on 10,648 hexahedra,
three levels. By hand: mfem.py [REPETITIONS], with a Python that finds subdivisionobjects and mfem, or one of them.
VTK_SMP_MAX_THREADS is the number of our threads; MFEM has one. Prints nanoseconds of processor time for each cell."""

import statistics
import sys
import time

SIZE = 22
LEVELS = 3
CELLS = (SIZE * 2 ** LEVELS) ** 3


def measure_mfem():
    from mfem.ser import Element, Mesh
    mesh = Mesh.MakeCartesian3D(SIZE, SIZE, SIZE, Element.HEXAHEDRON)
    start = time.process_time()
    for _ in range(LEVELS):
        mesh.UniformRefinement()
    assert mesh.GetNE() == CELLS
    return time.process_time() - start


def measure_own():
    from vtkmodules.vtkCommonDataModel import vtkImageData
    import subdivisionobjects
    image = vtkImageData()
    image.SetDimensions(SIZE + 1, SIZE + 1, SIZE + 1)
    made = subdivisionobjects.vtkMultiDimensionalSubdivision()
    made.SetInputData(image)
    made.SetNumberOfLevels(LEVELS)
    made.SetVolumeSchemeToLinear()
    made.KeepCellTypesOn()
    made.CacheOperatorOff()
    start = time.process_time()
    made.Update()
    assert made.GetOutput().GetNumberOfCells() == CELLS
    return time.process_time() - start


for name, measure in (("MFEM", measure_mfem), ("Linear, KeepCellTypes", measure_own)):
    try:
        times = [measure() for _ in range(int(sys.argv[1]) if len(sys.argv) > 1 else 3)]
        print("%s: %.0f ns a cell" % (name, 1e9 * statistics.median(times) / CELLS))
    except ImportError as error:
        print("%s: %s" % (name, error))
