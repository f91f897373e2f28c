// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SamplerTools.h
 * Images of vtkSubdivisionSampler, and small meshes for them.
 */
#ifndef SubdivisionObjects_SamplerTools_h
#define SubdivisionObjects_SamplerTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkImageData.h"
#include "vtkSubdivisionSampler.h"

namespace sampler_tools
{

using namespace multi_dimensional_subdivision_tools;

using Image = vtkSmartPointer<vtkImageData>;
using Filter = vtkSubdivisionSampler;

Grid MakeSolid();

/// Two triangles in a plane.
Grid MakeSheet();

Grid MakeCurve();

/// Adds a point array of the first coordinate.
void AddPlaces(vtkPointSet* mesh);

/// Runs a filter, which may warn of its tolerance or of quads against triangles, and copies the
/// image.
Image Sample(Filter* filter, vtkDataObject* input);

/// The first error of a filter, whose image is empty then.
std::string FindError(Filter* filter, vtkDataObject* input);

vtkIdType CountInside(vtkImageData* image);

/// The first difference between images, bit for bit; empty if there is none.
std::string CompareImages(vtkImageData* a, vtkImageData* b);

void SetThicknesses(Filter* filter, const char* name);

}

#endif
