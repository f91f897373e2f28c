// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointGroups.h
 * Which points of some meshes become one when points are merged, and which of them stands for the
 * others.
 */
#ifndef SubdivisionObjects_PointGroups_h
#define SubdivisionObjects_PointGroups_h

#include "Core/Memory/Loops.h"
#include "Core/Memory/UnevenRanges.h"
#include "Private/Control/CoincidentPoints.h"
#include "Private/Reading/NearPoints.h"

#include <algorithm>
#include <cstdint>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace subdivision
{

/// Whether an array has no values of points: ids, which name them, and normals, which a filter
/// makes anew.
bool IsNoValue(vtkDataSetAttributes* data, vtkAbstractArray* array);

/// Groups of points of all meshes together; the points of a mesh come after those of the one
/// before.
class PointGroups
{
public:
  using Group = Row<vtkIdType>;

  PointGroups(
    const std::vector<vtkPointSet*>& meshes, double tolerance, const MergeOptions& options);

  /// Calls visit(group) for each group of several points, in order.
  template <typename Visit>
  void ForEach(const Visit& visit) const;
  /// The mesh of a point.
  int GetMesh(vtkIdType point) const
  {
    return static_cast<int>(
      std::upper_bound(this->Starts.begin(), this->Starts.end(), point) - this->Starts.begin() - 1);
  }

  const std::vector<vtkPointSet*>& Meshes;
  const MergeOptions& Options;
  double Tolerance;
  std::vector<vtkIdType> Starts; ///< of the points of each mesh among all
  Buffer<double> X;
  std::vector<vtkIdType> GlobalIds; ///< or indices in the mesh, of all points
  std::vector<vtkIdType> Members;   ///< of groups of several points, group by group, in order
  Buffer<vtkIdType> Stands;         ///< the point of the same mesh that stands for each
  Buffer<vtkIdType> Firsts;         ///< the first point of each group
  Buffer<vtkIdType> Equals;         ///< the first point of the group that has equal kept values
  std::vector<vtkIdType> Parts;     ///< of each point, if there are copies
  vtkIdType Torn = 0; ///< points that touch another of the same part, with another value

private:
  void Read();
  void Find();
  Buffer<vtkIdType> FindFirsts(const std::vector<vtkIdType>& points, const PointOrder& order) const;
  void Divide(const Group& group);
  bool IsKept(vtkDataSetAttributes* data, vtkAbstractArray* array) const;
  std::vector<std::uint64_t> GetKept(vtkIdType point) const;
  void NumberParts();
};

template <typename Visit>
void PointGroups::ForEach(const Visit& visit) const
{
  const vtkIdType* const end = this->Members.data() + this->Members.size();
  Turns turns;
  for (const vtkIdType* first = this->Members.data(); first != end; turns.Next())
  {
    const vtkIdType* last = std::find_if(
      first, end, [&](vtkIdType i) { return this->Firsts[i] != this->Firsts[*first]; });
    visit(Group{ first, last });
    first = last;
  }
}

}

#endif
