// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Conversion.h
 * From what filters make to what a file of one grid, one surface or blocks can hold.
 */
#ifndef SubdivisionObjects_Conversion_h
#define SubdivisionObjects_Conversion_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;

namespace subdivide
{

/// The data sets of all blocks, in their order; the data itself if it has no blocks.
std::vector<vtkDataSet*> GetDataSets(vtkDataObject* data);

/**
 * One grid, one surface, the triangles of that, or blocks. Data that are that already are returned
 * as they are.
 *
 * Blocks become one mesh with all arrays, also those that not all blocks have: values that a block
 * does not have are 0 or empty. An array whose name another one of another type or number of
 * components has gets a "'" after its name. Of field arrays with the same name the first one stays,
 * and a warning names those that are lost.
 *
 * Failure is thrown where cells have points that do not exist, and by AsGridOfNumbers, which is for
 * Exodus files, at cells that these cannot hold.
 */
vtkSmartPointer<vtkDataObject> AsGrid(vtkDataObject* data);
vtkSmartPointer<vtkDataObject> AsGridOfNumbers(vtkDataObject* data); ///< warns of arrays of texts
vtkSmartPointer<vtkDataObject> AsSurface(vtkDataObject* data);
vtkSmartPointer<vtkDataObject> AsTriangles(vtkDataObject* data);
vtkSmartPointer<vtkDataObject> AsBlocks(vtkDataObject* data);
vtkSmartPointer<vtkDataObject> AsItIs(vtkDataObject* data);

}

#endif
