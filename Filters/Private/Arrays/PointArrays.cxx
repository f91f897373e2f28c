// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/PointArrays.h"

#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Private/ArrayNames.h"

#include "vtkAlgorithm.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace subdivision
{
namespace
{

/// The first values of an array in double.
const double* ReadValues(vtkDataArray* array, vtkIdType size, Buffer<double>& converted)
{
  return ReadDoubles(array->GetVoidPointer(0), array->GetDataType(), size, converted);
}

/// Gives each centre the mean of its members. The mean is computed in double and stored in the type
/// of the array; integers are rounded.
void FillCentres(vtkDataArray* array, const SimplicesOfCells& cells)
{
  const int components = array->GetNumberOfComponents();
  const vtkIdType first = array->GetNumberOfTuples() - cells.GetNumberOfCentres();
  Buffer<double> converted;
  const double* values = ReadValues(array, first * components, converted);
  Buffer<double> means(components * cells.GetNumberOfCentres());
  ForEach(cells.GetNumberOfCentres(),
    [&](vtkIdType c)
    {
      const vtkIdType begin = cells.CentreOffsets[c];
      const vtkIdType end = cells.CentreOffsets[c + 1];
      for (int k = 0; k < components; ++k)
      {
        auto sumOver = [&](double divisor)
        {
          double sum = 0.;
          for (vtkIdType m = begin; m < end; ++m)
          {
            sum += values[cells.CentreMembers[m] * components + k] / divisor;
          }
          return sum;
        };
        const double members = static_cast<double>(end - begin);
        const double mean = sumOver(1.) / members;
        means[c * components + k] = std::isfinite(mean) ? mean : sumOver(members);
      }
    });
  StoreDoubles(
    means.data(), array->GetVoidPointer(first * components), array->GetDataType(), means.size());
}

/// An array that an operator moves, and keeps as long as it needs it.
MovedArray MoveFrom(const vtkSmartPointer<vtkDataArray>& array)
{
  const int type = array->GetDataType();
  return { array->GetVoidPointer(0), type, nullptr, type, array->GetNumberOfComponents(),
    array->GetNumberOfTuples(), { array.GetPointer(), [array](const void*) {} } };
}

/// Divides the values of each tuple by the last one, which becomes 1.
template <typename Value>
void DivideByWeights(Value* values, int components, vtkIdType tuples)
{
  ForEach(tuples,
    [=](vtkIdType i)
    {
      Value* tuple = values + i * components;
      const Value weight = tuple[components - 1];
      const bool isKnown = weight > static_cast<Value>(LeastWeight);
      for (int k = 0; k < components; ++k)
      {
        tuple[k] = isKnown ? tuple[k] / weight : Value(0);
      }
    });
}

void DivideByWeights(vtkDataArray* array)
{
  void* values = array->GetVoidPointer(0);
  const int components = array->GetNumberOfComponents();
  array->GetDataType() == VTK_FLOAT
    ? DivideByWeights(static_cast<float*>(values), components, array->GetNumberOfTuples())
    : DivideByWeights(static_cast<double*>(values), components, array->GetNumberOfTuples());
}

}

vtkSmartPointer<vtkDataArray> StartValues(
  vtkDataArray* array, int valueType, const SimplicesOfCells& cells)
{
  const vtkIdType given = array->GetNumberOfTuples();
  const vtkIdType points = cells.Simplices.NumberOfPoints;
  const auto source = Contiguous(array);
  if (given == points && array->GetDataType() == valueType)
  {
    return source;
  }
  const int components = array->GetNumberOfComponents();
  const auto start = MakeArray(valueType, components, points);
  if (start->GetNumberOfValues() > 0)
  {
    void* values = start->GetVoidPointer(0);
    if (valueType == source->GetDataType())
    {
      std::memcpy(values, source->GetVoidPointer(0),
        static_cast<std::size_t>(given * components) * source->GetDataTypeSize());
    }
    else
    {
      Buffer<double> converted;
      const vtkIdType size = given * components;
      StoreDoubles(ReadValues(source, size, converted), values, valueType, size);
    }
    if (cells.GetNumberOfCentres() > 0)
    {
      FillCentres(start, cells);
    }
  }
  CopyLooks(array, start);
  return start;
}

void PointArrayOptions::ChooseOriginalIds(vtkPointSet* input, bool areWanted, bool isContinued)
{
  this->CarryOriginalIds = (isContinued || !areWanted) &&
    HasIds(input->GetPointData(), OriginalPointIdsName, input->GetNumberOfPoints());
  this->OriginalIds = areWanted || this->CarryOriginalIds;
  if (this->OriginalIds)
  {
    this->Replaced.emplace_back(OriginalPointIdsName);
  }
}

PointArrays::PointArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const vtkIdType* globalIds, vtkIdType numberOfGlobalIds, const PointArrayOptions& options)
  : Input(input)
  , Cells(cells)
  , GlobalIds(globalIds)
  , NumberOfGlobalIds(numberOfGlobalIds)
  , Options(options)
  , NumberOfPoints(cells.Simplices.NumberOfPoints)
  , NumberOfInputPoints(input->GetNumberOfPoints())
{
  vtkDataArray* points = input->GetPoints()->GetData();
  const int given = points->GetDataType();
  const int type = options.Precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT
    : options.Precision == vtkAlgorithm::DOUBLE_PRECISION              ? VTK_DOUBLE
    : given == VTK_FLOAT                                               ? VTK_FLOAT
                                                                       : VTK_DOUBLE;
  this->Tie = given == VTK_FLOAT || type == VTK_FLOAT ? SingleTie : DoubleTie;
  this->Points = StartValues(points, type, cells);
  vtkPointData* data = input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const bool isShort = array->GetNumberOfTuples() != input->GetNumberOfPoints();
    if ((array == data->GetGlobalIds() && isShort) || // ReadControlMesh tells of it
      name == vtkDataSetAttributes::GhostArrayName() ||
      std::find(options.Replaced.begin(), options.Replaced.end(), name) != options.Replaced.end())
    {
      continue;
    }
    if (!HasTuples(array, input->GetNumberOfPoints(), "point", options.Warn))
    {
      continue;
    }
    Entry entry{ i, nullptr };
    entry.IsNormals = array == data->GetNormals();
    entry.AreIds = array == data->GetGlobalIds() || array == data->GetPedigreeIds();
    const bool isMade = !entry.IsNormals && !entry.AreIds;
    if (isMade && IsSmoothed(array, options.InterpolateIntegers))
    {
      entry.Current = StartValues(vtkDataArray::SafeDownCast(array), array->GetDataType(), cells);
    }
    this->HasGathered = this->HasGathered || (isMade && !entry.Current);
    this->Entries.push_back(entry);
  }
  this->StartOrigins();
}

bool IsSmoothed(vtkAbstractArray* array, bool interpolateIntegers)
{
  if (!vtkDataArray::SafeDownCast(array) || array->GetNumberOfComponents() < 1)
  {
    return false;
  }
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return true;
    case VTK_BIT:
      return false;
    case VTK_UNSIGNED_CHAR:
      return interpolateIntegers || array->GetNumberOfComponents() == 3 ||
        array->GetNumberOfComponents() == 4;
    default:
      return interpolateIntegers;
  }
}

Coordinates PointArrays::GetCoordinates()
{
  return { ReadValues(this->Points, 3 * this->NumberOfPoints, this->Doubles), this->Tie };
}

bool PointArrays::IsEarlier(vtkIdType a, vtkIdType b) const
{
  const bool known = a < this->NumberOfGlobalIds && b < this->NumberOfGlobalIds;
  if (!known)
  {
    return a < b;
  }
  const vtkIdType first = this->GlobalIds[this->TakenPoints.empty() ? a : this->TakenPoints[a]];
  const vtkIdType second = this->GlobalIds[this->TakenPoints.empty() ? b : this->TakenPoints[b]];
  return first != second ? first < second : a < b;
}

void PointArrays::ForgetInputPoints()
{
  this->NumberOfGlobalIds = 0;
  this->NumberOfInputPoints = 0;
}

void PointArrays::StartOrigins()
{
  if (!this->HasGathered)
  {
    return;
  }
  this->Origins = Buffer<vtkIdType>(this->NumberOfPoints);
  const vtkIdType given = this->Input->GetNumberOfPoints();
  ForEach(given, [&](vtkIdType i) { this->Origins[i] = i; });
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCentres()))
  {
    const vtkIdType* members = this->Cells.CentreMembers.data();
    this->Origins[given + c] = *std::min_element(members + this->Cells.CentreOffsets[c],
      members + this->Cells.CentreOffsets[c + 1],
      [this](vtkIdType a, vtkIdType b) { return this->IsEarlier(a, b); });
  }
}

std::vector<vtkSmartPointer<vtkDataArray>*> PointArrays::ListSmoothed()
{
  std::vector<vtkSmartPointer<vtkDataArray>*> smoothed;
  if (!this->FinalPoints)
  {
    smoothed.push_back(&this->Points);
  }
  for (Entry& entry : this->Entries)
  {
    if (entry.Current)
    {
      smoothed.push_back(&entry.Current);
    }
  }
  return smoothed;
}

/// Applies an operator to all arrays that are smoothed. Each block goes to `also` too.
void PointArrays::AdvanceSmoothed(
  const PointOperator& operation, const PointOperator::User& also, bool goesOn)
{
  this->HasMoved = true;
  this->Doubles = Buffer<double>();
  const bool areStaying = goesOn && !this->Options.HasMaterialFields;
  const bool arePacked = areStaying || !this->Packed.IsEmpty();
  const vtkIdType rows = operation.GetNumberOfRows();
  const std::vector<vtkSmartPointer<vtkDataArray>*> smoothed = this->ListSmoothed();
  std::vector<MovedArray> arrays;
  for (const vtkSmartPointer<vtkDataArray>* array : smoothed)
  {
    arrays.push_back(MoveFrom(*array));
  }
  if (arePacked)
  {
    this->Packed.Take(arrays, rows);
  }
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const vtkSmartPointer<vtkDataArray> from = *smoothed[i];
    const bool isEmpty = areStaying && this->Packed.Has(i);
    *smoothed[i] = MakeArray(arrays[i].InType, arrays[i].Components, isEmpty ? 0 : rows);
    CopyLooks(from, *smoothed[i]);
    arrays[i].Out = (*smoothed[i])->GetVoidPointer(0);
  }
  if (rows > 0 && arePacked)
  {
    this->Packed.Start(arrays, rows, areStaying);
    ApplyToArrays(operation, this->Packed, std::move(arrays), also);
  }
  else if (rows > 0)
  {
    ApplyToArrays(operation, std::move(arrays), also);
  }
  for (const Entry& entry : this->Entries)
  {
    if (this->HasWeights(entry))
    {
      DivideByWeights(entry.Current);
    }
  }
}

/// Finds the current points whose values rows take in arrays that are not smoothed. An old point
/// keeps its own. A new one takes values of the end of its edge, or vertex of its octahedron, with
/// the smallest global id.
template <typename Id>
void PointArrays::FindOrigins(const RingRows<Id>& rows, vtkIdType* origins) const
{
  auto earliest = [this](const Id* begin, const Id* end)
  {
    return static_cast<vtkIdType>(
      *std::min_element(begin, end, [this](Id a, Id b) { return this->IsEarlier(a, b); }));
  };
  for (vtkIdType i = 0; i < rows.Count; ++i)
  {
    const vtkIdType row = rows.FirstRow + i;
    const Row<Id> ring = rows.OfCentres ? rows.GetRing(i) : Row<Id>();
    const vtkIdType from = rows.OfCentres ? earliest(ring.begin(), ring.end())
      : rows.OfEdges                      ? earliest(rows.Ends + 2 * i, rows.Ends + 2 * i + 2)
                                          : rows.GetColumn(i);
    origins[row] = this->Origins[from];
  }
}

void PointArrays::Advance(const PointOperator& operation)
{
  if (!this->HasGathered)
  {
    this->AdvanceSmoothed(operation);
    this->NumberOfPoints = operation.GetNumberOfRows();
    return;
  }
  Buffer<vtkIdType> next(operation.GetNumberOfRows());
  this->AdvanceSmoothed(operation,
    [&](const RowsView& view)
    {
      if (const auto* rows = std::get_if<RingRows<int>>(&view))
      {
        this->FindOrigins(*rows, next.data());
      }
      else if (const auto* large = std::get_if<RingRows<long long>>(&view))
      {
        this->FindOrigins(*large, next.data());
      }
    });
  this->Origins = std::move(next);
  this->NumberOfPoints = operation.GetNumberOfRows();
}

void PointArrays::Advance(const PointOperator& operation, const OriginOfRow& origin, bool goesOn)
{
  this->AdvanceSmoothed(operation, PointOperator::User(), goesOn);
  if (this->HasGathered)
  {
    Buffer<vtkIdType> next(operation.GetNumberOfRows());
    ForEach(next.size(), [&](vtkIdType row) { next[row] = this->Origins[origin(row)]; });
    this->Origins = std::move(next);
  }
  this->NumberOfPoints = operation.GetNumberOfRows();
}

void PointArrays::Take(const PointOperator& operation, const OriginOfRow& origin, vtkIdType staying)
{
  this->Advance(operation, origin);
  this->Renumber(origin, staying);
}

void PointArrays::Renumber(const OriginOfRow& origin, vtkIdType staying)
{
  const auto takeFirst = [&](vtkIdType& count)
  {
    vtkIdType taken = 0;
    while (taken < staying && origin(taken) < count)
    {
      ++taken;
    }
    count = taken;
  };
  std::vector<vtkIdType> taken;
  takeFirst(this->NumberOfGlobalIds);
  takeFirst(this->NumberOfInputPoints);
  for (const vtkIdType p : InTurn(this->NumberOfInputPoints))
  {
    taken.push_back(this->TakenPoints.empty() ? origin(p) : this->TakenPoints[origin(p)]);
  }
  this->TakenPoints = std::move(taken);
  for (Interpolated& array : this->ToInterpolate)
  {
    const auto width = static_cast<vtkIdType>(array.Entries.size() * array.Range.size() / 2);
    if (array.Given.size() > 0)
    {
      vtkIdType rows = array.Given.size() / width;
      takeFirst(rows);
      Buffer<double> given(rows * width);
      for (vtkIdType p = 0; p < rows; ++p)
      {
        std::copy_n(array.Given.data() + width * origin(p), width, given.data() + width * p);
      }
      array.Given = std::move(given);
    }
  }
}

void PointArrays::Project(const PointOperator& operation)
{
  if (operation.GetNumberOfRows() > 0)
  {
    this->AdvanceSmoothed(operation);
  }
}

void PointArrays::KeepColours(const std::vector<ColourMask>& masks)
{
  for (const Entry& entry : this->Entries)
  {
    if (!masks.empty() && this->HasWeights(entry))
    {
      const int colour = GetColour(entry.Current->GetName());
      const int components = entry.Current->GetNumberOfComponents();
      const int bytes = components * entry.Current->GetDataTypeSize();
      char* values = static_cast<char*>(entry.Current->GetVoidPointer(0));
      ForEach(static_cast<vtkIdType>(masks.size()),
        [&](vtkIdType i)
        {
          if (!(masks[static_cast<std::size_t>(i)] >> colour & 1))
          {
            std::memset(values + i * bytes, 0, static_cast<std::size_t>(bytes));
          }
        });
    }
  }
}

void PointArrays::SetLimitNormals(const Buffer<double>& normals)
{
  this->Normals = MakeArray(this->Points->GetDataType(), 3, normals.size() / 3);
  this->Normals->SetName(LimitNormalsName);
  StoreDoubles(
    normals.data(), this->Normals->GetVoidPointer(0), this->Points->GetDataType(), normals.size());
}

void PointArrays::SetLimitTangents(const Buffer<double> (&tangents)[2])
{
  for (int t = 0; t < 2; ++t)
  {
    const int type = this->Points->GetDataType();
    this->Tangents[t] = MakeArray(type, 3, tangents[t].size() / 3);
    this->Tangents[t]->SetName(LimitTangentNames[t]);
    StoreDoubles(
      tangents[t].data(), this->Tangents[t]->GetVoidPointer(0), type, tangents[t].size());
  }
}

void PointArrays::Finish(vtkPointSet* output)
{
  if (this->FinalPoints)
  {
    this->Points = this->FinalPoints;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Points->GetDataType());
  points->SetData(this->Points);
  output->SetPoints(points);
  vtkPointData* from = this->Input->GetPointData();
  const bool unchanged =
    !this->HasMoved && this->NumberOfPoints == this->Input->GetNumberOfPoints();
  const bool isOfInput = this->NumberOfPoints == this->NumberOfInputPoints &&
    (!this->TakenPoints.empty() || this->NumberOfPoints == this->Input->GetNumberOfPoints());
  for (const Entry& entry : this->Entries)
  {
    vtkAbstractArray* source = from->GetAbstractArray(entry.Source);
    vtkSmartPointer<vtkAbstractArray> array = source;
    if (((!unchanged || this->LeavesNormals) && entry.IsNormals) || (!isOfInput && entry.AreIds))
    {
      continue;
    }
    if (entry.AreIds && !this->TakenPoints.empty())
    {
      const vtkIdType* taken = this->TakenPoints.data();
      array = Gather(source, { taken, taken + this->TakenPoints.size() });
    }
    else if (!unchanged && !entry.AreIds)
    {
      array = entry.Current ? vtkSmartPointer<vtkAbstractArray>(entry.Current)
                            : Gather(source, { this->Origins.begin(), this->Origins.end() });
    }
    AddLike(from, entry.Source, array, output->GetPointData());
  }
  if (this->Normals)
  {
    AddInstead(from, this->Normals, output->GetPointData());
    output->GetPointData()->SetActiveNormals(this->Normals->GetName());
  }
  for (int t = 0; t < 2 && this->Tangents[t]; ++t)
  {
    AddInstead(from, this->Tangents[t], output->GetPointData());
  }
  if (this->Options.OriginalIds)
  {
    this->AddOriginalIds(output);
  }
}

void PointArrays::AddOriginalIds(vtkPointSet* output) const
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalPointIdsName);
  ids->SetNumberOfTuples(this->NumberOfPoints);
  vtkIdType* values = ids->GetPointer(0);
  vtkDataArray* carried = this->Options.CarryOriginalIds
    ? this->Input->GetPointData()->GetArray(OriginalPointIdsName)
    : nullptr;
  for (const vtkIdType i : InTurn(this->NumberOfPoints))
  {
    const vtkIdType point = i >= this->NumberOfInputPoints ? -1
      : this->TakenPoints.empty()                          ? i
                                                           : this->TakenPoints[i];
    values[i] = carried && point >= 0 ? ToId(carried->GetComponent(point, 0)) : point;
  }
  AddInstead(this->Input->GetPointData(), ids, output->GetPointData());
}

double PointArrays::GetBytesPerPoint() const
{
  double bytes = 3. * this->Points->GetDataTypeSize();
  for (const Entry& entry : this->Entries)
  {
    vtkAbstractArray* array = this->Input->GetPointData()->GetAbstractArray(entry.Source);
    bytes += static_cast<double>(array->GetDataTypeSize()) * array->GetNumberOfComponents();
  }
  return bytes;
}

}
