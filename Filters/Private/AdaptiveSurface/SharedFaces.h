// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedFaces.h
 * Adaptive sqrt(3) refinement of a surface of which several partitions have parts.
 */
#ifndef SubdivisionObjects_SharedFaces_h
#define SubdivisionObjects_SharedFaces_h

#include "Private/AdaptiveSurface/AdaptiveSurfaceMarks.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Surface/SurfaceCells.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/**
 * Passes on splits between partitions. Each marks its own faces, and splits in its copies of other
 * faces all that must be split before. It sends the splits that are in its own faces, or beside
 * them, to the partitions that have copies of these. They split these faces, and all that must be
 * split before, and so on, until nobody has anything new. As the set of split faces does not depend
 * on the order of splits, it is then the same as in the whole surface in all faces that share a
 * point with an own one.
 *
 * Faces that must be split before a face are at most two layers of control faces away from it: one
 * for the control faces themselves, and less than one for the smaller faces of all later levels. So
 * with three layers of copies (LayersOfAdaptiveSurface) no split comes near to the outermost edges,
 * at which the copies have a boundary and the surface has none.
 *
 * A face is known to others by its control face and by which child it is of each face between.
 */
template <typename Id>
class SharedFaces
{
public:
  SharedFaces(const SurfaceCells& cells, const SurfaceLevel<Id>& control,
    AdaptiveSqrtThree<Id>& mesh, OtherPartitions& others);

  const AdaptiveScope& GetScope() const { return this->Scope; }

  /// Does the splits of a round. Returns false if there would be more than `mostCells` cells here;
  /// then some are missing.
  bool Split(const std::vector<AdaptiveMark<Id>>& marks, std::size_t count, vtkIdType mostCells);

  /// The mesh is again as it was when a round began.
  void Restart();

  /// The number of triangles, pieces of line cells and vertex cells. Its sum over all partitions is
  /// the number of the whole surface.
  vtkIdType CountOwnCells() const;

private:
  /// Where a face is: four children in a byte.
  struct Path
  {
    vtkIdType Cell;
    std::int32_t Triangle; ///< of the cell
    std::int32_t Level;
    std::array<unsigned char, 16> Children;
  };

  bool IsOwn(Id controlFace) const { return this->Scope.Faces[controlFace] != 0; }
  void AddHolders(Id face, std::vector<int>& partitions) const;
  Path FindPath(Id face) const;
  using Paths = Exchange::Lists<Path>; ///< of split faces
  Paths TakeNew();
  bool Receive(const Paths& paths, vtkIdType mostCells);
  bool SplitAt(const Path& path, vtkIdType mostCells);

  const SurfaceCells& Cells;
  AdaptiveSqrtThree<Id>& Mesh;
  OtherPartitions& Others;
  AdaptiveScope Scope;
  vtkIdType OwnGiven = 0;                       ///< cells of the input
  std::vector<int> OwnLines;                    ///< on each control segment
  std::vector<Id> FirstOfCell;                  ///< of each control face: the first of its cell
  std::unordered_map<vtkIdType, Id> FirstFaces; ///< by the id of the cell
  AdaptiveSqrtThreeCarriers<Id> Carriers;
  vtkIdType OwnSplits = 0;
  vtkIdType Known = 0; ///< splits that were sent
};

}

#endif
