// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/PointArrays.h"

#include "Core/Memory/Store.h"
#include "Private/ArrayNames.h"

#include "vtkAlgorithm.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Gives each centre the mean of its members. The mean is computed in double and stored in the type
/// of the array; integers are rounded.
template <typename T>
void FillCentres(T* values, int components, const SimplicesOfCells& cells, vtkIdType first)
{
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
            sum += static_cast<double>(values[cells.CentreMembers[m] * components + k]) / divisor;
          }
          return sum;
        };
        const double members = static_cast<double>(end - begin);
        const double mean = sumOver(1.) / members;
        values[(first + c) * components + k] =
          Store<T>(std::isfinite(mean) ? mean : sumOver(members));
      }
    });
}

template <typename To, typename From>
To ConvertValue(From value)
{
  if constexpr (std::is_same<From, double>::value && std::is_same<To, float>::value)
  {
    return Store<float>(value); // stays finite
  }
  else
  {
    return static_cast<To>(value);
  }
}

template <typename From, typename To>
void Convert(const From* from, To* to, vtkIdType size)
{
  ForEach(size, [&](vtkIdType i) { to[i] = ConvertValue<To>(from[i]); });
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
    auto fill = [&](auto* values)
    {
      switch (source->GetDataType())
      {
        vtkTemplateMacro(Convert(
          static_cast<const VTK_TT*>(source->GetVoidPointer(0)), values, given * components));
      }
      FillCentres(values, components, cells, given);
    };
    switch (valueType)
    {
      vtkTemplateMacro(fill(static_cast<VTK_TT*>(start->GetVoidPointer(0))));
    }
  }
  CopyLooks(array, start);
  return start;
}

PointArrays::PointArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const vtkIdType* globalIds, vtkIdType numberOfGlobalIds, const PointArrayOptions& options)
  : Input(input)
  , Cells(cells)
  , GlobalIds(globalIds)
  , NumberOfGlobalIds(numberOfGlobalIds)
  , Options(options)
  , NumberOfPoints(cells.Simplices.NumberOfPoints)
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
    if (array == data->GetGlobalIds() || array == data->GetPedigreeIds() ||
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
    if (this->IsSmoothed(array))
    {
      entry.Current = StartValues(vtkDataArray::SafeDownCast(array), array->GetDataType(), cells);
    }
    this->HasGathered = this->HasGathered || !entry.Current;
    this->Entries.push_back(entry);
  }
  this->StartOrigins();
}

bool PointArrays::IsSmoothed(vtkAbstractArray* array) const
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
      return this->Options.InterpolateIntegers || array->GetNumberOfComponents() == 3 ||
        array->GetNumberOfComponents() == 4;
    default:
      return this->Options.InterpolateIntegers;
  }
}

Coordinates PointArrays::GetCoordinates()
{
  if (this->Points->GetDataType() == VTK_DOUBLE)
  {
    return { static_cast<const double*>(this->Points->GetVoidPointer(0)), this->Tie };
  }
  const vtkIdType values = 3 * this->NumberOfPoints;
  this->Doubles = Buffer<double>(values);
  Convert(static_cast<const float*>(this->Points->GetVoidPointer(0)), this->Doubles.data(), values);
  return { this->Doubles.data(), this->Tie };
}

bool PointArrays::IsEarlier(vtkIdType a, vtkIdType b) const
{
  const bool known = a < this->NumberOfGlobalIds && b < this->NumberOfGlobalIds;
  return known && this->GlobalIds[a] != this->GlobalIds[b] ? this->GlobalIds[a] < this->GlobalIds[b]
                                                           : a < b;
}

void PointArrays::ForgetInputPoints()
{
  this->NumberOfGlobalIds = 0;
  this->HasInputPoints = false;
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
  for (vtkIdType c = 0; c < this->Cells.GetNumberOfCentres(); ++c)
  {
    const vtkIdType* members = this->Cells.CentreMembers.data();
    this->Origins[given + c] = *std::min_element(members + this->Cells.CentreOffsets[c],
      members + this->Cells.CentreOffsets[c + 1],
      [this](vtkIdType a, vtkIdType b) { return this->IsEarlier(a, b); });
  }
}

/// Gives each array that is smoothed `size` tuples, which make(from, in, out, components) fills.
template <typename Make>
void PointArrays::ReplaceSmoothed(vtkIdType size, const Make& make)
{
  this->Doubles = Buffer<double>();
  auto replace = [&](vtkSmartPointer<vtkDataArray>& array)
  {
    const vtkSmartPointer<vtkDataArray> from = array;
    const int components = from->GetNumberOfComponents();
    array = MakeArray(from->GetDataType(), components, size);
    CopyLooks(from, array);
    if (array->GetNumberOfValues() > 0)
    {
      switch (from->GetDataType())
      {
        vtkTemplateMacro(make(from, static_cast<const VTK_TT*>(from->GetVoidPointer(0)),
          static_cast<VTK_TT*>(array->GetVoidPointer(0)), components));
      }
    }
  };
  if (!this->FinalPoints)
  {
    replace(this->Points);
  }
  for (Entry& entry : this->Entries)
  {
    if (entry.Current)
    {
      replace(entry.Current);
    }
  }
}

template <typename Operator>
void PointArrays::AdvanceSmoothed(const Operator& rows)
{
  this->HasMoved = true;
  this->ReplaceSmoothed(rows.GetNumberOfRows(),
    [&rows](vtkDataArray*, const auto* in, auto* out, int components)
    { rows.Apply(in, out, components); });
}

/// Applies the rows to all arrays in one pass, so that each row is made only once.
template <typename Id>
void PointArrays::AdvanceSmoothed(const BlockOperator<Id>& rows)
{
  this->HasMoved = true;
  std::vector<typename BlockOperator<Id>::User> users;
  this->ReplaceSmoothed(rows.GetNumberOfRows(),
    [&users](const vtkSmartPointer<vtkDataArray>& from, const auto* in, auto* out, int components)
    {
      users.push_back([from, in, out, components](const RowBlock<Id>& block, vtkIdType first)
        { block.Apply(in, out + first * components, components); });
    });
  if (users.empty())
  {
    return;
  }
  rows.ForRows(
    [&users](const RowBlock<Id>& block, vtkIdType first)
    {
      for (const auto& use : users)
      {
        use(block, first);
      }
    });
}

template void PointArrays::AdvanceSmoothed(const SparseRows<int>&);
template void PointArrays::AdvanceSmoothed(const SparseRows<long long>&);
template void PointArrays::AdvanceSmoothed(const MidpointRows<int>&);
template void PointArrays::AdvanceSmoothed(const MidpointRows<long long>&);
template void PointArrays::AdvanceSmoothed(const LocalLimit<int>&);
template void PointArrays::AdvanceSmoothed(const LocalLimit<long long>&);
template void PointArrays::AdvanceSmoothed(const BlockOperator<int>&);
template void PointArrays::AdvanceSmoothed(const BlockOperator<long long>&);
template void PointArrays::AdvanceSmoothed(const AdaptiveSqrtThreeLimit<int>&);
template void PointArrays::AdvanceSmoothed(const AdaptiveSqrtThreeLimit<long long>&);

/// Finds the origins after a step: an old point keeps its origin, a new one takes that of the end
/// of its edge with the smaller global id.
template <typename Id>
void PointArrays::TakeOriginsOfEdges(const Buffer<Id>& edgeVertices, Buffer<vtkIdType>& next) const
{
  std::copy(this->Origins.begin(), this->Origins.end(), next.begin());
  ForEach(edgeVertices.size() / 2,
    [&](vtkIdType e)
    {
      const vtkIdType a = edgeVertices[2 * e];
      const vtkIdType b = edgeVertices[2 * e + 1];
      next[this->NumberOfPoints + e] = this->Origins[this->IsEarlier(a, b) ? a : b];
    });
}

template <typename Id>
void PointArrays::Advance(const Stencils<Id>& stencils)
{
  this->AdvanceSmoothed(stencils);
  if (this->HasGathered)
  {
    Buffer<vtkIdType> next(stencils.GetNumberOfRows());
    this->TakeOriginsOfEdges(stencils.EdgeVertices, next);
    this->Origins = std::move(next);
  }
  this->NumberOfPoints = stencils.GetNumberOfRows();
}

template void PointArrays::Advance(const Stencils<int>&);
template void PointArrays::Advance(const Stencils<long long>&);

/// The current point whose values one of the rows takes in arrays that are not smoothed.
template <typename Id>
vtkIdType PointArrays::FindOrigin(const StencilRows<Id>& rows, vtkIdType i) const
{
  if (!rows.OfEdges)
  {
    return rows.FirstRow + i;
  }
  const vtkIdType a = rows.Ends[2 * i];
  const vtkIdType b = rows.Ends[2 * i + 1];
  return this->IsEarlier(a, b) ? a : b;
}
template <typename Id>
vtkIdType PointArrays::FindOrigin(const TetOctRows<Id>& rows, vtkIdType i) const
{
  if (!rows.OfCentres)
  {
    return this->FindOrigin(static_cast<const StencilRows<Id>&>(rows), i);
  }
  return this->FindEarliest(rows.GetRing(i));
}
/// The vertex of an octahedron with the smallest global id.
template <typename Id>
vtkIdType PointArrays::FindEarliest(Row<Id> vertices) const
{
  return *std::min_element(
    vertices.begin(), vertices.end(), [this](Id a, Id b) { return this->IsEarlier(a, b); });
}

template <typename Rows>
void PointArrays::Advance(const RowsOnTheFly<Rows>& operation)
{
  const vtkIdType size = operation.GetNumberOfRows();
  std::vector<RowsUser<Rows>> users;
  this->ReplaceSmoothed(size,
    [&users](const vtkSmartPointer<vtkDataArray>& from, const auto* in, auto* out, int components)
    {
      users.push_back(
        [from, in, out, components](const Rows& rows) { SumRows(rows, in, out, components); });
    });
  Buffer<vtkIdType> origins(this->HasGathered ? size : 0);
  if (this->HasGathered)
  {
    users.push_back(
      [&](const Rows& rows)
      {
        for (vtkIdType i = 0; i < rows.Count; ++i)
        {
          origins[rows.FirstRow + i] = this->Origins[this->FindOrigin(rows, i)];
        }
      });
  }
  operation.ForRows(
    [&](const Rows& rows)
    {
      for (const RowsUser<Rows>& use : users)
      {
        use(rows);
      }
    });
  this->Origins = std::move(origins);
  this->NumberOfPoints = size;
}

template void PointArrays::Advance(const RowsOnTheFly<StencilRows<int>>&);
template void PointArrays::Advance(const RowsOnTheFly<StencilRows<long long>>&);
template void PointArrays::Advance(const RowsOnTheFly<TetOctRows<int>>&);
template void PointArrays::Advance(const RowsOnTheFly<TetOctRows<long long>>&);

template <typename Id>
void PointArrays::Advance(const TetOctStencils<Id>& stencils)
{
  this->AdvanceSmoothed(stencils);
  if (this->HasGathered)
  {
    Buffer<vtkIdType> next(stencils.GetNumberOfRows());
    this->TakeOriginsOfEdges(stencils.EdgeVertices, next);
    const vtkIdType octs = stencils.OctVertices.size() / 6;
    ForEach(octs,
      [&](vtkIdType o)
      {
        const Id* vertices = stencils.OctVertices.data() + 6 * o;
        next[next.size() - octs + o] =
          this->Origins[this->FindEarliest(Row<Id>{ vertices, vertices + 6 })];
      });
    this->Origins = std::move(next);
  }
  this->NumberOfPoints = stencils.GetNumberOfRows();
}

template void PointArrays::Advance(const TetOctStencils<int>&);
template void PointArrays::Advance(const TetOctStencils<long long>&);

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
  for (const Entry& entry : this->Entries)
  {
    vtkAbstractArray* source = from->GetAbstractArray(entry.Source);
    vtkSmartPointer<vtkAbstractArray> array = source;
    if (!unchanged)
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
  const vtkIdType given = this->HasInputPoints ? this->Input->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < this->NumberOfPoints; ++i)
  {
    values[i] = i >= given ? -1 : carried ? static_cast<vtkIdType>(carried->GetComponent(i, 0)) : i;
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
