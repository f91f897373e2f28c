# SPDX-License-Identifier: BSD-3-Clause
"""vtkSubdivisionSampler on ranks that share a mesh: each has its part of the image of the whole."""

import numpy as np
import rank_tools as ranks
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.util.numpy_support import vtk_to_numpy

import subdivisionobjects


def sampled(mesh, controller, extent=None):
    made = subdivisionobjects.vtkSubdivisionSampler()
    if not controller:
        made.SetController(None)
    made.SetNumberOfSamples(40)
    made.SetGenerateCoverage(True)
    made.SetGenerateDistance(True)
    made.SetInputDataObject(mesh)
    made.UpdateInformation()
    whole = made.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
    made.UpdateExtent(extent or whole)
    image = made.GetOutput()
    points = image.GetPointData()
    return image, {points.GetArrayName(i): vtk_to_numpy(points.GetArray(i)) for i in range(points.GetNumberOfArrays())}


def models():
    """One of tetrahedra, surfaces and curves, and one of hexahedra, whose quads all ranks have to cut alike."""
    source = subdivisionobjects.vtkSubdivisionModelSource()
    source.SetModelToMechanicalPart()
    source.Update()
    yield source.GetOutput()
    image = vtkImageData()
    image.SetDimensions(5, 4, 4)
    hexahedra = subdivisionobjects.vtkMultiDimensionalSubdivision()
    hexahedra.SetController(None)
    hexahedra.SetInputData(image)
    hexahedra.SetNumberOfLevels(0)
    hexahedra.SetVolumeSchemeToHybrid()
    hexahedra.Update()
    hexahedra.GetOutput().GetFieldData().Initialize()
    yield hexahedra.GetOutput()


def run():
    return [failure for model in models() for failure in failures_of(ranks.numbered(model))]


def failures_of(mesh):
    image, _ = sampled(mesh, False)
    extent = list(image.GetExtent())
    size = extent[5] + 1
    extent[4:] = ranks.RANK * size // ranks.RANKS, (ranks.RANK + 1) * size // ranks.RANKS - 1
    expected_image, expected = sampled(mesh, False, extent)
    failures = []
    for find in (ranks.in_slabs, ranks.by_chance, ranks.on_last_rank):
        part = ranks.take(mesh, np.nonzero(find(mesh, ranks.RANKS) == ranks.RANK)[0], with_ids=True)
        found_image, found = sampled(part, True, extent)
        name = find.__name__
        if found_image.GetExtent() != expected_image.GetExtent() or set(found) != set(expected) or not np.allclose(
                found_image.GetOrigin(), expected_image.GetOrigin(), rtol=0, atol=1e-12):
            failures.append(f"{name}: another image, {found_image.GetExtent()}, {set(found) ^ set(expected)}")
            continue
        # Where a place of a voxel, or a sample, lies on a face, rounding may give it to either side.
        for array, values in found.items():
            away = np.abs(values.astype(float) - expected[array])
            if (away > 1e-9).mean() > 1e-4 or array == "Coverage" and away.max() > 0.05:
                failures.append(f"{name}: {array}, {(away > 1e-9).sum()} samples, {away.max()}")
    return failures


ranks.main(run)
