// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledObject.h
 * The pieces of the object and the grid, which vtkSubdivisionSampler keeps.
 */
#ifndef SubdivisionObjects_SampledObject_h
#define SubdivisionObjects_SampledObject_h

#include "Private/Samples/SolidFaces.h"

#include "vtkBoundingBox.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <tuple>
#include <utility>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;

namespace subdivision
{

struct SampledObject
{
  /// The pieces of a level; of the meshes of all blocks.
  void SetLevel(vtkDataObject* level, bool measures);
  /// Bounds of what is sampled, without thickness, and the other figures, are those of all ranks.
  void Agree(vtkMultiProcessController* controller);
  /// The materials of the solids on all ranks, after the arrays are found.
  void FindMaterials(vtkMultiProcessController* controller);

  /// The inputs of the pipeline and when they were modified, when the filter was, and the distances
  /// and indices of the samples of an image at port 3, for which levels are fine enough.
  using Key = std::tuple<std::vector<std::pair<vtkDataObject*, vtkMTimeType>>, vtkMTimeType,
    std::array<double, 3>, std::array<int, 6>>;
  Key MadeFor;
  bool IsMade = false; ///< false: there was an error
  vtkSmartPointer<vtkDataObject> Level;
  std::vector<SampledMesh> Meshes;
  std::vector<SolidFace> Outside; ///< of solids, if there are distances
  std::vector<double> Materials;  ///< of solids
  /// 0, or where that is a material a number that is none.
  double MaterialOutside = 0.;
  vtkBoundingBox Bounds;
  double Bend = 0.;
  double Deviation = -1.; ///< from the limit, at most about this; negative: not known
  double Cells = 0.;      ///< of the level
  SampleGrid Grid{};
};

/// No image has more steps along an axis. One that should have more has these, and is refused.
constexpr int MostSteps = VTK_INT_MAX / 8;

/// The distance of samples, and the number along each axis, of an image around a box.
SampleGrid MakeSampleGrid(const vtkBoundingBox& box, int samples, double spacing, int margin);
/// The number of samples, which may be larger than any id.
double CountSamples(const SampleGrid& grid);
bool HasMostSteps(const SampleGrid& grid);

/// Takes the samples of other ranks into an image that all have with the same grid, by the order of
/// SampleOptions; among equals that of the first rank counts.
void JoinRanks(
  vtkImageData* image, const SampleOptions& options, vtkMultiProcessController* controller);

}

#endif
