// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridStamp.h
 * The stamp of a mesh whose cells keep their types (Stamp.h): the next filter reads the control
 * mesh off the cells, and makes its levels again on ids.
 */
#ifndef SubdivisionObjects_HybridStamp_h
#define SubdivisionObjects_HybridStamp_h

#include "Private/Uniform/HybridInput.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

struct HybridStamp
{
  int MadeLevels = 0;  ///< since the control mesh; 0: no earlier filter made the mesh
  HybridCells Control; ///< of each cell its first descendant stands for its values
  vtkIdType NumberOfControlPoints = 0;
  std::vector<DerivedPart> Derived; ///< of the control mesh, with the sharpness that is left
  std::vector<vtkIdType> GlobalIds; ///< of its points; may be empty
};

/// Reads the stamp of an input with these cells. There is none if cells were changed or selected,
/// or if descendants of one cell have different values of the arrays that choose rules.
HybridStamp ReadHybridStamp(
  vtkPointSet* input, const HybridCells& cells, const FeatureOptions& features);

/// Makes the level with these cells again by their stamp. False: the stamp is wrong.
template <typename Id>
bool RestoreHybridLevel(const HybridStamp& stamp, const CellList<Id>& cells, vtkPointSet* input,
  const UniformOptions& options, HybridLevel<Id>& level);

/// Replaces the stamp of an output. `levels`: how many this filter made after `stamp`; 0: there is
/// no stamp, and any filter goes on with the cells as they are. Parts that are not sharp any more
/// are left out. `isPart`: other partitions have the rest. The stamp then has no levels: the next
/// filter starts afresh, and says so (RestoreStamp).
void WriteHybridStamp(
  const HybridStamp& stamp, int levels, bool isPart, vtkUnstructuredGrid* output);

}

#endif
