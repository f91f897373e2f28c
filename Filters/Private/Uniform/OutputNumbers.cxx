// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OutputNumbers.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/RunSimplices.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Run/StampFields.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Finds the numbers of control simplices.
template <typename Id>
class ControlNumbering
{
public:
  ControlNumbering(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
    const ControlMesh& mesh, const WantedSimplices& wanted, vtkPointSet* input,
    OtherPartitions& others)
    : Mesh(mesh)
    , Control(mesh.GetControl())
    , Wanted(wanted)
    , With(others)
    , Runs(runs)
    , Complex(complex)
  {
    this->FindCells(PlaceCells(input, others));
    Flags own;
    for (const vtkIdType cell : InTurn(this->Cells))
    {
      own.push_back(others.IsOwn(cell));
    }
    this->Own = this->FindParts(own);
  }
  ControlNumbers Number(vtkPointSet* input, int steps)
  {
    WholeIds vertices = NumberVertices(
      input->GetNumberOfPoints(), SimplexView(this->Control), this->Pieces, this->With);
    this->Made.Numbers[0] = std::move(vertices.Ids);
    this->Made.Totals[0] = vertices.Total;
    this->NumberSimplices(steps);
    const auto& complex = this->Complex;
    this->NumberFaces<2>(complex.EdgeVertices, complex.NumberOfLineCells, complex.NumberOfEdges);
    this->NumberFaces<3>(
      complex.FaceVertices, complex.NumberOfTriangleCells, complex.NumberOfFaces);
    this->Made.Parts = this->FindParts(this->Wanted.Flags);
    for (const vtkIdType point : InTurn(this->Wanted.Points))
    {
      this->Made.Parts.Kept[0][point] = 1;
    }
    this->FindOwnDerived();
    return std::move(this->Made);
  }

private:
  using Flags = std::vector<char>;

  /// Some control simplices with their faces; `wanted`: flags of these, empty: all.
  ControlParts FindParts(const Flags& wanted) const
  {
    const auto& complex = this->Complex;
    const vtkIdType sizes[4] = { complex.NumberOfVertices, complex.NumberOfEdges,
      complex.NumberOfFaces, complex.NumberOfTets };
    ControlParts parts;
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      parts.Kept[dimension].assign(static_cast<size_t>(sizes[dimension]), wanted.empty() ? 1 : 0);
    }
    this->ForControl(
      [&](vtkIdType s, int dimension, vtkIdType number, bool)
      {
        if (!wanted.empty() && wanted[s])
        {
          parts.Kept[dimension][number] = 1;
        }
      });
    const auto addFaces = [&](int dimension, int size, const Buffer<Id>& faces)
    {
      for (vtkIdType i = 0; i < faces.size(); ++i)
      {
        parts.Kept[dimension - 1][faces[i]] |= parts.Kept[dimension][i / size];
      }
    };
    addFaces(3, 4, complex.TetFaces);
    addFaces(2, 3, complex.FaceEdges);
    addFaces(1, 2, complex.EdgeVertices);
    return parts;
  }

  void FindOwnDerived()
  {
    ForSimplices(this->Complex, this->Runs,
      [&](vtkIdType s, int dimension, vtkIdType number, bool)
      {
        if (s >= this->Control.GetNumberOfSimplices() && this->Made.Parts.Kept[dimension][number])
        {
          this->Made.IsOwnDerived[dimension].push_back(this->Own.Kept[dimension][number]);
        }
        if (s >= this->Control.GetNumberOfSimplices())
        {
          this->Made.HasDerived[dimension].push_back(this->Made.Parts.Kept[dimension][number]);
        }
      });
  }

  /// As ForSimplices, for simplices of the control mesh only; derived ones follow.
  template <typename Act>
  void ForControl(const Act& act) const
  {
    ForSimplices(this->Complex, this->Runs,
      [&](vtkIdType s, int dimension, vtkIdType number, bool isEqual)
      {
        if (s < this->Control.GetNumberOfSimplices())
        {
          act(s, dimension, number, isEqual);
        }
      });
  }

  /// Finds for each control simplex the input cell whose piece it is, or which is its first
  /// descendant, and the key of the simplex: the place of this cell, and which of its pieces.
  void FindCells(const Ids& places)
  {
    const vtkIdType size = this->Control.GetNumberOfSimplices();
    vtkIdType next = 0;
    for (const vtkIdType s : InTurn(size))
    {
      const bool isPiece = this->Mesh.MadeLevels == 0 && !this->Mesh.Cells.ParentCells.empty();
      const vtkIdType cell = isPiece ? this->Mesh.Cells.ParentCells[s] : next;
      next += vtkIdType(1) << (this->Control.Dimensions[s] * this->Mesh.MadeLevels);
      this->Cells.push_back(cell);
    }
    this->Pieces = MakeKeysOfPieces(this->Cells, places, this->With);
  }

  /// Cells of the output, and lines, triangles and tetrahedra that are control simplices.
  void NumberSimplices(int steps)
  {
    SharedKeys simplices = this->Pieces;
    simplices.Kinds = 4;
    simplices.Sizes.assign(4 * this->Cells.size(), 0);
    this->ForControl(
      [&](vtkIdType s, int dimension, vtkIdType, bool isEqual)
      {
        simplices.Sizes[4 * s] = vtkIdType(1) << (dimension * steps);
        if (dimension > 0 && !isEqual)
        {
          simplices.Sizes[4 * s + dimension] = 1;
        }
      });
    const SharedNumbers numbers = NumberTogether(simplices, this->With);
    this->Made.NumberOfCells = numbers.Totals[0];
    this->ForControl(
      [&](vtkIdType s, int dimension, vtkIdType, bool isEqual)
      {
        if (this->Wanted.Has(s))
        {
          this->Made.FirstCells.push_back(numbers.First[4 * s]);
        }
        if (dimension > 0 && !isEqual)
        {
          this->Made.Numbers[dimension].push_back(numbers.First[4 * s + dimension]);
        }
      });
    std::copy_n(numbers.Totals.begin() + 1, 3, this->Made.Totals.begin() + 1);
  }

  /// Numbers the edges (2 vertices) or faces (3) that are no control simplices; `others`: the first
  /// that is not derived, `last`: their end. In the whole derived ones come first, and all are in
  /// the order of their vertices. A partition is sure of all that begin at a vertex of an own cell.
  template <int Size>
  void NumberFaces(const Buffer<Id>& verticesOfAll, vtkIdType others, vtkIdType last)
  {
    Ids& numbers = this->Made.Numbers[Size - 1];
    const auto given = static_cast<vtkIdType>(numbers.size());
    SharedKeys faces;
    faces.Width = Size;
    faces.Kinds = 2;
    for (vtkIdType face = given; face < last; ++face)
    {
      std::array<std::pair<vtkIdType, Id>, Size> corners;
      for (int k = 0; k < Size; ++k)
      {
        const Id vertex = verticesOfAll[Size * face + k];
        corners[k] = { this->Made.Numbers[0][vertex], vertex };
      }
      std::sort(corners.begin(), corners.end());
      for (const auto& corner : corners)
      {
        faces.Keys.push_back(corner.first); // nobody keeps one that begins with -1
      }
      faces.Own.push_back(corners[0].first >= 0 && this->Own.Kept[0][corners[0].second]);
      faces.Sizes.insert(faces.Sizes.end(), { face < others, face >= others });
    }
    const SharedNumbers found = NumberTogether(faces, this->With);
    vtkIdType& total = this->Made.Totals[Size - 1];
    for (vtkIdType face = given; face < last; ++face)
    {
      const bool isOther = face >= others;
      const vtkIdType before = found.First[2 * (face - given) + isOther];
      numbers.push_back(before < 0 ? -1 : total + (isOther ? found.Totals[0] : 0) + before);
    }
    total += found.Totals[0] + found.Totals[1];
  }

  const ControlMesh& Mesh;
  const SimplexList& Control;
  const WantedSimplices& Wanted;
  OtherPartitions& With;
  const std::vector<CellRun>& Runs;
  const SimplicialComplex<Id>& Complex;
  Ids Cells;         ///< of each control simplex, the input cell
  SharedKeys Pieces; ///< control simplices as pieces of these cells
  ControlParts Own;  ///< own simplices, with their faces
  ControlNumbers Made;
};

}

template <typename Id>
ControlNumbers NumberControl(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const ControlMesh& mesh, const WantedSimplices& wanted, vtkPointSet* input, int steps,
  OtherPartitions& others)
{
  return ControlNumbering<Id>(complex, runs, mesh, wanted, input, others).Number(input, steps);
}
SUBDIVISION_COMPILE_FUNCTION(NumberControl);

OutputNumbers NumberOutput(
  const ControlNumbers& control, const SimplexList& wanted, int steps, const SchemeTraits& scheme)
{
  OutputNumbers output;
  std::vector<SharedNumbers> things;
  for (size_t dimension = 0; dimension < 4; ++dimension)
  {
    things.push_back({ {}, { control.Totals[dimension] } });
    things.back().First.reserve(control.Numbers[dimension].size());
    for (size_t i = 0; i < control.Numbers[dimension].size(); ++i)
    {
      if (control.Parts.Kept[dimension][i])
      {
        things.back().First.push_back(control.Numbers[dimension][i]);
      }
    }
  }
  const IdSegments vertices = scheme.ListVertices(steps);
  output.Points = vtkSmartPointer<vtkIdTypeArray>::New();
  output.Points->SetName(PointNumbersName);
  output.NumberOfPoints = FindWholeIds(vertices, things, output.Points);
  const auto countCells = [&](vtkIdType s)
  { return vtkIdType(1) << (wanted.Dimensions[s] * steps); };
  const vtkIdType size = wanted.GetNumberOfSimplices();
  Buffer<vtkIdType> firsts(size + 1);
  ForEach(size, [&](vtkIdType s) { firsts[s] = countCells(s); });
  CountsToOffsets(firsts);
  output.Cells = vtkSmartPointer<vtkIdTypeArray>::New();
  output.Cells->SetName(CellNumbersName);
  Allocate(output.Cells.Get(), 1, firsts[size]);
  vtkIdType* cells = output.Cells->GetPointer(0);
  ForEach(size,
    [&](vtkIdType s)
    {
      for (vtkIdType k = firsts[s]; k < firsts[s + 1]; ++k)
      {
        cells[k] = control.FirstCells[s] < 0 ? -1 : control.FirstCells[s] + k - firsts[s];
      }
    });
  return output;
}

}
