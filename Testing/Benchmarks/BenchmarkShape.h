// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkShape.h
 * Red-green refinement on the limit by the shape of the limit, beside uniform levels on the limit.
 *  - screw: by the distance from the limit, some 7,500 cells, as exact as uniform level 4 (`./dev
 *    demo` measures that);
 *  - screw-angle, plate-angle: the screw and the mechanical part by curvature;
 *  - files of the folder of further meshes by curvature, without uniform levels.
 */
#ifndef SubdivisionObjects_BenchmarkShape_h
#define SubdivisionObjects_BenchmarkShape_h

#include "vtkRedGreenRefinement.h"

#include "vtkSmartPointer.h"

#include <string>

namespace benchmarks
{

/// A fresh filter on the input of a case; null: there is no case of this name.
/// Null if no case has that name, or its file is missing.
vtkSmartPointer<vtkRedGreenRefinement> MakeShapeFilter(const std::string& name);

}

#endif
