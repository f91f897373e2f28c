// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentPoints.h
 * Points at the same place, or nearly, which many files and sources have where parts touch.
 */
#ifndef SubdivisionObjects_CoincidentPoints_h
#define SubdivisionObjects_CoincidentPoints_h

#include "Private/Control/TouchingSides.h"
#include "Private/Run/RunOptions.h"
#include "Private/Values/MergedValues.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPointSet;

namespace subdivision
{

struct MergeOptions
{
  double Tolerance = 0.; ///< a fraction of the diagonal of the box of all points
  MergedValues Values = MergedValues::First;
  bool InterpolateIntegers = false;
  bool JoinsBlocks = true;
  /// Whether the filter can join points of equal coordinates itself (SurfaceSeams.h), so that
  /// points of different values may stay apart; and whether points of different texture coordinates
  /// do in any case.
  bool HasSeams = false;
  bool KeepsTexture = false;
  /// Whether values are kept as copies of points between which they jump (MaterialFields.h).
  bool HasCopies = false;
  /// Where not empty, only these points of each mesh become one (JoinSides).
  std::map<vtkPointSet*, PointPairs> Sides;
  bool TearsTexture = false; ///< the filter gives both sides their texture coordinates again
};

/// Finds the sides of meshes that the filter does not join itself; false if there are none. The
/// options become those for MergeCoincidentPoints: blocks are joined apart, and TearsTexture is
/// kept for the sides of one closed surface. `sharesRanks`: other ranks may have the rest of an
/// object, of which a warning tells.
bool FindSides(vtkDataObject* readable, bool sharesRanks, MergeOptions& options,
  std::vector<std::string>& warnings);

/**
 * The mesh, or the blocks of a composite data set (ReadableMesh.h), with cells that share points.
 * Of points that are near each other (FindFirstOfNear) all cells have the one with the smallest
 * global id, or without ids the first. With a tolerance the points of all blocks get the least
 * coordinates of their group. Points without cells take no part. The others stay until
 * RemoveMergedPoints, so that ids stay; MergedPointsName says which point each became. Polyhedra
 * that have two points at one place keep them.
 *
 * With MergedValues::Keep points of different values stay points of their own: of HasSeams as they
 * are; of HasCopies as copies, of which MaterialPointIds tells, and the cell array MergedPartsName
 * says which cells are connected by equal values. KeepsTexture: so do points of different
 * texture coordinates, whatever Values is. Warnings tell of values that are replaced, and of cells
 * that collapse. Returns the input where nothing changes.
 */
vtkSmartPointer<vtkDataObject> MergeCoincidentPoints(
  vtkDataObject* readable, const MergeOptions& options, std::vector<std::string>& warnings);

/// For a block, by its flat index: the point of the input that each remaining point is.
using PointSources = std::map<unsigned int, std::vector<vtkIdType>>;

/// Removes the points that were merged with others; `change(mesh, copy)` may add arrays to a copy
/// while it has the points of the mesh. `warn` is told of arrays that do not fit.
vtkSmartPointer<vtkDataObject> RemoveMergedPoints(vtkDataObject* merged,
  const std::function<void(vtkPointSet*, vtkPointSet*)>& change,
  const std::function<void(const std::string&)>& warn, PointSources& sources);

/// A mesh like this one, whose points have the same ids as points of `merged` (without global ids
/// the same index); it gets the ids that these have after RemoveMergedPoints.
vtkSmartPointer<vtkPointSet> FollowMergedPoints(vtkPointSet* mesh, vtkDataObject* merged);

/// Begins an operator, if there is one, on the points of a mesh with the choice of remaining
/// points.
void AppendSources(const PointSources& sources, vtkDataObject* mesh, MatrixFactors* factors);

/// Makes original ids of points in an output the ids before any point was removed.
void RestoreOriginalPoints(vtkDataObject* output, const PointSources& sources);

}

#endif
