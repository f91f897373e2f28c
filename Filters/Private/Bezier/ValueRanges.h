// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ValueRanges.h
 * How large a mesh is, and over which ranges its point arrays go, on all ranks together.
 */
#ifndef SubdivisionObjects_ValueRanges_h
#define SubdivisionObjects_ValueRanges_h

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkMultiProcessController;

namespace subdivision
{

class ValueRanges
{
public:
  /// Reads a mesh, or all meshes of a composite data set. Values that are not finite do not count.
  /// All ranks of `controller`, which may be null, call this together.
  ValueRanges(vtkDataObject* data, vtkMultiProcessController* controller);

  /// A fraction of the length of the range of a point array, the largest of its components; null:
  /// of the diagonal of the mesh. It is not less than the rounding of values of that size, of
  /// single precision if `isSingle`, or all values that are equal would differ too much.
  double GetTolerance(const char* name, double part, bool isSingle) const;

private:
  using Range = std::pair<double, double>;
  void Add(const std::string& name, vtkDataArray* array);
  void Extend(const std::string& name, std::size_t component, const Range& range);
  void Join(vtkMultiProcessController* controller);

  /// Of each component; the points have the empty name.
  std::map<std::string, std::vector<Range>> Arrays;
};

}

#endif
