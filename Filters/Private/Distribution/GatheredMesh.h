// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GatheredMesh.h
 * A small mesh, such as a control mesh, whole on every rank.
 */
#ifndef SubdivisionObjects_GatheredMesh_h
#define SubdivisionObjects_GatheredMesh_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPointSet;

namespace subdivision
{

/**
 * Makes one mesh of all blocks that all ranks have, the same on each rank; null if there are none.
 * Points are identified as in IdentifyPoints. A single mesh of one rank, or one that all ranks have
 * alike (as readers give it that are asked for the whole), is returned as it is. All ranks call
 * this together. `controller`: null for one process.
 */
vtkSmartPointer<vtkPointSet> GatherMesh(vtkDataObject* input, vtkMultiProcessController* controller,
  const std::function<void(const std::string&)>& warn);

}

#endif
