// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzChecks.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace fuzz
{
namespace
{

constexpr double Moderate = 1e30; ///< sums of such numbers fit in single precision

template <typename Use>
void ForSets(vtkDataObject* data, const Use& use)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    use(set);
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      ForSets(each->GetCurrentDataObject(), use);
    }
  }
}

bool IsFloating(vtkAbstractArray* array)
{
  return array && (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
}

bool IsWithin(vtkDataArray* numbers, double limit)
{
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      if (!(std::abs(numbers->GetComponent(i, c)) <= limit))
      {
        return false;
      }
    }
  }
  return true;
}

bool AreWithin(vtkFieldData* arrays, double limit)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    if (IsFloating(arrays->GetAbstractArray(i)) && !IsWithin(arrays->GetArray(i), limit))
    {
      return false;
    }
  }
  return true;
}

bool ArePointsWithin(vtkDataSet* set, double limit)
{
  for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
  {
    double x[3];
    set->GetPoint(i, x);
    if (!(std::abs(x[0]) <= limit && std::abs(x[1]) <= limit && std::abs(x[2]) <= limit))
    {
      return false;
    }
  }
  return true;
}

bool HaveLength(vtkFieldData* arrays, vtkIdType length)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    if (arrays->GetAbstractArray(i)->GetNumberOfTuples() != length)
    {
      return false;
    }
  }
  return true;
}

/// Read as arrays: vtkPolyData does not survive some cells.
std::vector<vtkCellArray*> ListCells(vtkDataSet* set)
{
  if (auto* surface = vtkPolyData::SafeDownCast(set))
  {
    return { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() };
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(set);
  return grid && grid->GetCells() ? std::vector<vtkCellArray*>{ grid->GetCells() }
                                  : std::vector<vtkCellArray*>{};
}

bool HaveValidIds(vtkDataSet* set)
{
  for (vtkCellArray* cells : ListCells(set))
  {
    vtkDataArray* ids = cells->GetConnectivityArray();
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      const double id = ids->GetComponent(i, 0);
      if (id < 0. || id >= static_cast<double>(set->GetNumberOfPoints()))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether an output may have no array of this name, as FindLostArray says.
bool MayBeMissing(vtkDataSetAttributes* data, vtkAbstractArray* array, vtkIdType tuples)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  constexpr const char* replaced[] = { "MaterialPointIds", // of copies, which a warning tells
    "vtkOriginalPointIds", "vtkOriginalCellIds", "vtkGhostType" };
  return name.empty() || array->GetNumberOfTuples() != tuples || array == data->GetGlobalIds() ||
    array == data->GetPedigreeIds() || array == data->GetNormals() ||
    std::find(std::begin(replaced), std::end(replaced), name) != std::end(replaced);
}

std::string FindLost(vtkDataSetAttributes* before, vtkDataSetAttributes* after, vtkIdType tuples)
{
  for (int i = 0; i < before->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = before->GetAbstractArray(i);
    if (!MayBeMissing(before, array, tuples) && !after->HasArray(array->GetName()))
    {
      return std::string(array->GetName()) + ", a " + array->GetClassName() + " of " +
        before->GetClassName();
    }
  }
  return std::string();
}

bool IsSameArray(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b || a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfValues() != b->GetNumberOfValues() ||
    std::strcmp(a->GetName() ? a->GetName() : "", b->GetName() ? b->GetName() : "") != 0)
  {
    return false;
  }
  // Bytes first: a vtkVariant for each value of a large output takes seconds.
  const auto size = static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize();
  if (a->HasStandardMemoryLayout() && b->HasStandardMemoryLayout() && a->IsNumeric() && size > 0 &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0)
  {
    return true;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    // A vtkVariant of NaN is not equal to itself, its text is.
    if (a->GetVariantValue(i) != b->GetVariantValue(i) &&
      a->GetVariantValue(i).ToString() != b->GetVariantValue(i).ToString())
    {
      return false;
    }
  }
  return true;
}

bool AreSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return false;
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    if (!IsSameArray(a->GetAbstractArray(i), b->GetAbstractArray(i)))
    {
      return false;
    }
  }
  return true;
}

bool IsSameSet(vtkDataSet* a, vtkDataSet* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells() ||
    !AreSameArrays(a->GetPointData(), b->GetPointData()) ||
    !AreSameArrays(a->GetCellData(), b->GetCellData()))
  {
    return false;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    if (std::memcmp(p, q, sizeof(p)) != 0)
    {
      return false;
    }
  }
  const auto own = ListCells(a);
  const auto other = ListCells(b);
  if (!std::equal(own.begin(), own.end(), other.begin(), other.end(),
        [](vtkCellArray* x, vtkCellArray* y)
        {
          return IsSameArray(x->GetOffsetsArray(), y->GetOffsetsArray()) &&
            IsSameArray(x->GetConnectivityArray(), y->GetConnectivityArray());
        }))
  {
    return false;
  }
  for (vtkIdType cell = 0; a->IsA("vtkUnstructuredGrid") && cell < a->GetNumberOfCells(); ++cell)
  {
    if (a->GetCellType(cell) != b->GetCellType(cell))
    {
      return false;
    }
  }
  return true;
}

}

Soundness Examine(vtkDataObject* data, double limit)
{
  Soundness sound;
  ForSets(data,
    [&](vtkDataSet* set)
    {
      sound.HasValidIds = sound.HasValidIds && HaveValidIds(set);
      sound.HasWholeArrays = sound.HasWholeArrays &&
        HaveLength(set->GetPointData(), set->GetNumberOfPoints()) &&
        HaveLength(set->GetCellData(), set->GetNumberOfCells());
      sound.HasFiniteValues = sound.HasFiniteValues && ArePointsWithin(set, limit) &&
        AreWithin(set->GetPointData(), limit) && AreWithin(set->GetCellData(), limit);
    });
  return sound;
}

const char* FindFault(vtkDataObject* input, vtkDataObject* output, vtkAlgorithm* filter)
{
  Soundness before = Examine(input, Moderate);
  // Of the other inputs, places and control meshes, values may be missing, too.
  for (int port = 1; filter && port < filter->GetNumberOfInputPorts(); ++port)
  {
    vtkDataObject* other =
      filter->GetNumberOfInputConnections(port) > 0 ? filter->GetInputDataObject(port, 0) : nullptr;
    before.HasFiniteValues =
      before.HasFiniteValues && (!other || Examine(other, Moderate).HasFiniteValues);
  }
  const Soundness after = Examine(output, std::numeric_limits<double>::max());
  if (before.HasValidIds && !after.HasValidIds)
  {
    return "a cell of the output has an id that is no point";
  }
  if (before.HasWholeArrays && !after.HasWholeArrays)
  {
    return "an array of the output has a wrong length";
  }
  if (before.HasFiniteValues && !after.HasFiniteValues)
  {
    return "the output has NaN or infinite numbers, and the input has none";
  }
  return nullptr;
}

std::string FindLostArray(vtkDataObject* input, vtkDataObject* output, bool ofCells)
{
  auto* before = vtkDataSet::SafeDownCast(input);
  auto* after = vtkDataSet::SafeDownCast(output);
  if (!before || !after || after->GetNumberOfPoints() == 0 || after->GetNumberOfCells() == 0)
  {
    return std::string();
  }
  const std::string lost =
    FindLost(before->GetPointData(), after->GetPointData(), before->GetNumberOfPoints());
  return !lost.empty() || !ofCells
    ? lost
    : FindLost(before->GetCellData(), after->GetCellData(), before->GetNumberOfCells());
}

bool HasDoublesOnly(vtkDataObject* data)
{
  auto* set = vtkPointSet::SafeDownCast(data);
  if (!set || !set->GetPoints() || set->GetPoints()->GetDataType() != VTK_DOUBLE ||
    !Examine(data, Moderate).HasFiniteValues)
  {
    return false;
  }
  for (int i = 0; i < set->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const int type = set->GetPointData()->GetAbstractArray(i)->GetDataType();
    if (type == VTK_FLOAT || type == VTK_UNSIGNED_CHAR) // bytes are colours, which are smoothed
    {
      return false;
    }
  }
  return true;
}

bool AreEqual(vtkDataObject* a, vtkDataObject* b)
{
  std::vector<vtkDataSet*> own;
  std::vector<vtkDataSet*> other;
  ForSets(a, [&](vtkDataSet* set) { own.push_back(set); });
  ForSets(b, [&](vtkDataSet* set) { other.push_back(set); });
  return std::equal(own.begin(), own.end(), other.begin(), other.end(), IsSameSet);
}

}
