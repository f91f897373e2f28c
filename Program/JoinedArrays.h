// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JoinedArrays.h
 * The arrays of all blocks for the one mesh that they become.
 */
#ifndef SubdivisionObjects_JoinedArrays_h
#define SubdivisionObjects_JoinedArrays_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSet;

namespace subdivide
{

class JoinedArrays
{
public:
  explicit JoinedArrays(const std::vector<vtkSmartPointer<vtkDataSet>>& sets);

  /// A copy that shares the values, with all arrays in one order: those that the data set does not
  /// have are 0 or empty. There are no active attributes.
  vtkSmartPointer<vtkDataSet> Complete(vtkDataSet* set) const;

  /// Makes those arrays active that are so in the first block that has any, and adds field arrays
  /// but those in which filters describe their run.
  void Finish(vtkDataSet* joined) const;

private:
  struct Entry
  {
    std::string Name; ///< differs from that in the blocks where another type has the same name
    vtkSmartPointer<vtkAbstractArray> Like;
  };

  void Collect(vtkDataSet* set, int association);
  static vtkAbstractArray* Find(vtkDataSet* set, int association, const Entry& entry);

  std::vector<vtkSmartPointer<vtkDataSet>> Sets;
  std::vector<Entry> Entries[2]; ///< of points and of cells
};

}

#endif
