// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenMesh.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/StampFields.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <stdexcept>

namespace subdivision
{
namespace
{

bool HasSameTuples(vtkAbstractArray* array, vtkIdType a, vtkIdType b)
{
  const int components = array->GetNumberOfComponents();
  vtkDataArray* data = vtkDataArray::SafeDownCast(array);
  for (int c = 0; c < components; ++c)
  {
    if (data)
    {
      const double first = data->GetComponent(a, c);
      const double second = data->GetComponent(b, c);
      if (first != second && (first == first || second == second)) // two NaNs are the same
      {
        return false;
      }
    }
    else if (array->GetVariantValue(a * components + c) !=
      array->GetVariantValue(b * components + c))
    {
      return false;
    }
  }
  return true;
}

/// Puts leaves in the place of green cells.
class GreenUndo
{
public:
  GreenUndo(vtkPointSet* input, RedGreenMesh& mesh)
    : Input(input)
    , Mesh(mesh)
    , Read(mesh.Control.Cells.GetView())
  {
  }
  /// False, and nothing happens, where the cells do not fit the arrays; `fault` says why if the
  /// user should know.
  bool Run(std::string& fault)
  {
    if (!this->FindArrays())
    {
      return false;
    }
    const vtkIdType size = this->Read.NumberOfSimplices;
    this->Undone.Control.Cells.Simplices.NumberOfPoints = this->Read.NumberOfPoints;
    const vtkIdType* points = this->Read.Connectivity;
    vtkIdType leaves = 0;
    for (vtkIdType i = 0; i < size;)
    {
      const int dimension = this->Read.Dimensions[i];
      const vtkIdType parent = ToId(this->Parents->GetComponent(i, 0));
      if (parent < 0)
      {
        this->Append(dimension, points, i);
        points += dimension + 1;
        ++i;
        continue;
      }
      if (parent != leaves++ || !this->ReadLeaf(parent, dimension))
      {
        return false;
      }
      const vtkIdType first = i;
      for (; i < size && ToId(this->Parents->GetComponent(i, 0)) == parent; ++i)
      {
        if (this->Read.Dimensions[i] != dimension || !this->HasSameData(first, i, fault))
        {
          return false;
        }
        points += dimension + 1;
      }
      this->Append(dimension, this->Leaf, first);
    }
    auto& midpoints = this->Undone.Midpoints;
    SortDistinct(midpoints);
    const auto isSameEdge = [](const auto& a, const auto& b)
    { return a[0] == b[0] && a[1] == b[1]; };
    if (leaves != this->Leaves->GetNumberOfTuples() ||
      std::adjacent_find(midpoints.begin(), midpoints.end(), isSameEdge) != midpoints.end())
    {
      return false;
    }
    std::swap(this->Mesh.Control.Cells, this->Undone.Control.Cells);
    this->Mesh.Levels = std::move(this->Undone.Levels);
    this->Mesh.Midpoints = std::move(midpoints);
    return true;
  }

  /// The simplices that were read, also after Run replaced them.
  const SimplexView& GetRead() const { return this->Read; }
  /// Undoes the work of Run.
  void Revert()
  {
    std::swap(this->Mesh.Control.Cells, this->Undone.Control.Cells);
    this->Mesh.Levels.clear();
    this->Mesh.Midpoints.clear();
  }

private:
  bool FindArrays()
  {
    vtkCellData* data = this->Input->GetCellData();
    const vtkIdType cells = this->Input->GetNumberOfCells();
    if (!HasIds(data, LevelName, cells) || !HasIds(data, GreenParentName, cells))
    {
      return false;
    }
    this->Levels = data->GetArray(LevelName);
    this->Parents = data->GetArray(GreenParentName);
    this->Leaves = FindField(LeavesName, this->Input->GetFieldData(), LeafComponents);
    return this->Leaves && this->Levels->GetRange(0)[0] >= 0. &&
      this->Levels->GetRange(0)[1] <= 255.;
  }
  /// Reads a leaf and the midpoints of its edges. Returns false if the ids are not valid.
  bool ReadLeaf(vtkIdType index, int dimension)
  {
    if (index >= this->Leaves->GetNumberOfTuples() || dimension < 2)
    {
      return false;
    }
    for (int c = 0; c < LeafComponents; ++c)
    {
      this->Leaf[c] = ToId(this->Leaves->GetComponent(index, c));
      const bool isNeeded = c <= dimension;
      const bool isRepeated =
        isNeeded && std::find(this->Leaf, this->Leaf + c, this->Leaf[c]) != this->Leaf + c;
      if (this->Leaf[c] >= this->Read.NumberOfPoints || (isNeeded && this->Leaf[c] < 0) ||
        isRepeated)
      {
        return false;
      }
    }
    const int edges = dimension == 2 ? 3 : 6;
    const auto* ends = dimension == 2 ? triangle::EdgeVertices : tetrahedron::EdgeVertices;
    for (int e = 0; e < edges; ++e)
    {
      const vtkIdType middle = this->Leaf[4 + e];
      if (middle >= 0)
      {
        const vtkIdType a = this->Leaf[ends[e][0]];
        const vtkIdType b = this->Leaf[ends[e][1]];
        this->Undone.Midpoints.push_back({ { std::min(a, b), std::max(a, b), middle } });
      }
    }
    return true;
  }
  /// Whether two green cells of a leaf have the same cell data. Only then can the leaf take them.
  bool HasSameData(vtkIdType first, vtkIdType cell, std::string& fault) const
  {
    vtkCellData* data = this->Input->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (array->GetNumberOfTuples() == this->Input->GetNumberOfCells() &&
        array != data->GetGlobalIds() && !HasSameTuples(array, first, cell))
      {
        fault = std::string("The cell array \"") + (array->GetName() ? array->GetName() : "") +
          "\" has different values in green cells " + std::to_string(first) + " and " +
          std::to_string(cell) +
          ", which are parts of one cell: the filter keeps both values, and so refines green cells "
          "as they are. Compute the array after the last refinement to avoid thin cells.";
        return false;
      }
    }
    return true;
  }
  void Append(int dimension, const vtkIdType* points, vtkIdType cell)
  {
    SimplexList& list = this->Undone.Control.Cells.Simplices;
    list.Dimensions.push_back(static_cast<unsigned char>(dimension));
    list.Connectivity.insert(list.Connectivity.end(), points, points + dimension + 1);
    this->Undone.Control.Cells.ParentCells.push_back(cell);
    this->Undone.Levels.push_back(static_cast<unsigned char>(this->Levels->GetComponent(cell, 0)));
  }

  vtkPointSet* Input;
  RedGreenMesh& Mesh;
  const SimplexView Read;
  vtkDataArray* Levels = nullptr;
  vtkDataArray* Parents = nullptr;
  vtkDataArray* Leaves = nullptr;
  RedGreenMesh Undone;
  vtkIdType Leaf[LeafComponents];
};

/// Whether the green cells of the leaves are, one by one, the cells that were read.
template <typename Id>
bool IsWhatWasRead(const SimplexView& read, const RedGreenMesh& mesh)
{
  RedGreen<Id> state(mesh.GetView());
  for (const auto& midpoint : InTurn(mesh.Midpoints))
  {
    state.AddMidpoint(
      static_cast<Id>(midpoint[0]), static_cast<Id>(midpoint[1]), static_cast<Id>(midpoint[2]));
  }
  try
  {
    state.Close();
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  const RedGreenOutput<Id> output(state);
  const CellCounts counts = output.GetCounts();
  if (state.GetNumberOfVertices() != read.NumberOfPoints ||
    counts.Cells != read.NumberOfSimplices || counts.Entries != FindCorners(read).GetLength())
  {
    return false;
  }
  Buffer<vtkIdType> connectivity(counts.Entries);
  Buffer<vtkIdType> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  RedGreenStorage<vtkIdType> storage;
  storage.Cells = { connectivity.data(), offsets.data(), types.data() };
  output.Write(storage);
  return std::equal(connectivity.begin(), connectivity.end(), read.Connectivity);
}

}

RedGreenMesh ReadRedGreenMesh(vtkPointSet* input, const FeatureOptions& features,
  StampScheme scheme, bool trustStamp, bool undo)
{
  RedGreenMesh mesh;
  // The pieces of an octahedron come with its diagonal as a marked edge, which they keep.
  mesh.Control = ReadControlMesh(input, trustStamp, features, scheme, PlainIds::InPlace);
  mesh.TetOrderIsFinal = mesh.Control.IsStamped;
  Stamp stamp;
  const auto& cells = mesh.Control.Cells;
  if (!undo || !trustStamp || !ReadStamp(input, StampScheme::RedGreen, stamp) ||
    !cells.ParentCells.empty() || cells.GetNumberOfCentres() > 0)
  {
    return mesh;
  }
  GreenUndo greens(input, mesh);
  const SimplexView read = greens.GetRead();
  std::string fault;
  if (!greens.Run(fault))
  {
    if (!fault.empty())
    {
      mesh.Control.Warnings.push_back(fault);
    }
    return mesh;
  }
  const double largest = 64. * static_cast<double>(read.NumberOfSimplices);
  if (!(largest < 2e9 ? IsWhatWasRead<int>(read, mesh) : IsWhatWasRead<long long>(read, mesh)))
  {
    greens.Revert();
    return mesh;
  }
  mesh.IsContinued = true;
  mesh.TetOrderIsFinal = stamp.TetOrderIsFinal;
  return mesh;
}

template <typename Id>
void WriteRedGreenFields(const RedGreenMesh& mesh, const RedGreenOutput<Id>& plan, bool isProjected,
  const WholeNumbers& whole, vtkUnstructuredGrid* output)
{
  const vtkIdType leaves = plan.GetNumberOfGreenLeaves();
  vtkNew<vtkIdTypeArray> array;
  array->SetName(LeavesName);
  Allocate(array, LeafComponents, leaves);
  vtkIdType* tuples = leaves > 0 ? array->GetPointer(0) : nullptr;
  ForEach(leaves,
    [&](vtkIdType i)
    {
      const GreenLeaf<Id> leaf = plan.GetGreenLeaf(i);
      vtkIdType* tuple = tuples + i * LeafComponents;
      std::copy(leaf.Vertices.begin(), leaf.Vertices.end(), tuple);
      std::copy(leaf.Midpoints.begin(), leaf.Midpoints.end(), tuple + 4);
    });
  output->GetFieldData()->AddArray(array);
  Stamp stamp;
  stamp.Scheme = StampScheme::RedGreen;
  stamp.NumberOfControlPoints =
    whole.Points.Total > 0 ? whole.Points.Total : output->GetNumberOfPoints();
  stamp.NumberOfPoints = whole.Points.Total;
  stamp.NumberOfCells = whole.Cells.Total;
  stamp.IsProjected = isProjected;
  stamp.TetOrderIsFinal = mesh.TetOrderIsFinal;
  WriteStamp(stamp, output);
  StampedIds ids;
  ids.Global = mesh.Control.GlobalIds;
  WriteStampedIds(ids, output);
}

SUBDIVISION_COMPILE_FUNCTION(WriteRedGreenFields);

}
