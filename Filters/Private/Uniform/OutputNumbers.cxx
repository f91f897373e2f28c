// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OutputNumbers.h"

#include "Core/Memory/Ids.h"
#include "Private/ArrayNames.h"
#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"
#include "Private/Control/StampFields.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <numeric>

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
    const ControlMesh& mesh, const WantedSimplices& wanted, vtkPointSet* input, Partners& partners)
    : Mesh(mesh)
    , Control(mesh.GetControl())
    , Wanted(wanted)
    , With(partners)
    , Runs(runs)
    , Complex(complex)
  {
    this->FindCells(PlaceCells(input, partners));
    Flags own;
    for (const vtkIdType cell : this->Cells)
    {
      own.push_back(partners.IsOwn(cell));
    }
    this->Own = this->FindParts(own);
  }
  ControlNumbers Number(vtkPointSet* input, int steps)
  {
    SharedNumbers vertices = NumberVertices(
      input->GetNumberOfPoints(), SimplexView(this->Control), this->Pieces, this->With);
    this->Made.Numbers[0] = std::move(vertices.First);
    this->Made.Totals[0] = vertices.Totals[0];
    this->NumberSimplices(steps);
    this->template NumberFaces<2>(this->Complex.EdgeVertices, this->Complex.NumberOfLineCells);
    this->template NumberFaces<3>(this->Complex.FaceVertices, this->Complex.NumberOfTriangleCells);
    this->Made.Parts = this->FindParts(this->Wanted.Flags);
    for (const vtkIdType point : this->Wanted.Points)
    {
      this->Made.Parts.Kept[0][point] = 1;
    }
    this->FindOwnDerived();
    return std::move(this->Made);
  }

private:
  using Flags = std::vector<char>;

  /// What some control simplices have; `wanted`: flags of these, empty: all.
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
    this->ForSimplices(
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

  /// act(its index, its dimension, its number among those of the complex, whether the complex has
  /// an equal one instead) for each simplex: those of the control mesh, and then derived ones.
  template <typename Act>
  void ForSimplices(const Act& act) const
  {
    const auto& complex = this->Complex;
    const Buffer<Id>* twins[4] = { nullptr, &complex.EqualLines.Twins,
      &complex.EqualTriangles.Twins, &complex.EqualTets.Twins };
    for (const CellRun& run : this->Runs)
    {
      for (vtkIdType i = 0; i < run.Count; ++i)
      {
        const vtkIdType index = run.First + i;
        act(run.FirstCell + i, run.Dimension,
          run.Dimension == 0 ? complex.VertexCells[index]
            : run.Equal      ? (*twins[run.Dimension])[index]
                             : index,
          run.Equal);
      }
    }
  }
  /// The same for those of the control mesh only.
  template <typename Act>
  void ForControl(const Act& act) const
  {
    this->ForSimplices(
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
    for (vtkIdType s = 0; s < size; ++s)
    {
      const bool isPiece = this->Mesh.MadeLevels == 0 && !this->Mesh.Cells.ParentCells.empty();
      const vtkIdType cell = isPiece ? this->Mesh.Cells.ParentCells[s] : next;
      next += vtkIdType(1) << (this->Control.Dimensions[s] * this->Mesh.MadeLevels);
      this->Cells.push_back(cell);
    }
    this->Pieces = MakeKeysOfPieces(this->Cells, places, this->With);
  }

  /// Cells of the output, and those lines, triangles and tetrahedra that are control simplices.
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

  /// Numbers the edges or faces that are no control simplices: those that are derived, and then all
  /// others.
  template <int Size>
  void NumberFaces(const Buffer<Id>& vertices, vtkIdType firstOther)
  {
    const auto first = static_cast<vtkIdType>(this->Made.Numbers[Size - 1].size());
    this->template NumberFaces<Size>(vertices, first, firstOther);
    this->template NumberFaces<Size>(vertices, firstOther, vertices.size() / Size);
  }

  /// Some of them, in the order of their vertices.
  template <int Size>
  void NumberFaces(const Buffer<Id>& vertices, vtkIdType first, vtkIdType last)
  {
    SharedKeys faces;
    faces.Width = Size;
    for (vtkIdType f = first; f < last; ++f)
    {
      std::array<vtkIdType, Size> key;
      for (int k = 0; k < Size; ++k)
      {
        key[k] = this->Made.Numbers[0][vertices[Size * f + k]];
      }
      std::sort(key.begin(), key.end());
      faces.Own.push_back(this->Own.Kept[Size - 1][f] && key[0] >= 0);
      std::replace(key.begin(), key.end(), vtkIdType(-1), vtkIdType(0));
      faces.Keys.insert(faces.Keys.end(), key.begin(), key.end());
    }
    const SharedNumbers found = NumberTogether(faces, this->With);
    vtkIdType& total = this->Made.Totals[Size - 1];
    for (const vtkIdType number : found.First)
    {
      this->Made.Numbers[Size - 1].push_back(number < 0 ? -1 : total + number);
    }
    total += found.Totals[0];
  }

  const ControlMesh& Mesh;
  const SimplexList& Control;
  const WantedSimplices& Wanted;
  Partners& With;
  const std::vector<CellRun>& Runs;
  const SimplicialComplex<Id>& Complex;
  Ids Cells;         ///< of each control simplex, the input cell
  SharedKeys Pieces; ///< control simplices as pieces of these cells
  ControlParts Own;  ///< what own simplices have
  ControlNumbers Made;
};

}

template <typename Id>
ControlNumbers NumberControl(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const ControlMesh& mesh, const WantedSimplices& wanted, vtkPointSet* input, int steps,
  Partners& partners)
{
  return ControlNumbering<Id>(complex, runs, mesh, wanted, input, partners).Number(input, steps);
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
    for (size_t i = 0; i < control.Numbers[dimension].size(); ++i)
    {
      if (control.Parts.Kept[dimension][i])
      {
        things.back().First.push_back(control.Numbers[dimension][i]);
      }
    }
  }
  const IdSegments vertices = scheme.ListVertices(steps);
  const WholeIds points = std::move(FindWholeIds({ &vertices }, things)[0]);
  output.Points = MakeField<vtkIdTypeArray>(PointNumbersName, points.Ids);
  output.NumberOfPoints = points.Total;
  const auto countCells = [&](vtkIdType s)
  { return vtkIdType(1) << (wanted.Dimensions[s] * steps); };
  const vtkIdType size = wanted.GetNumberOfSimplices();
  Buffer<vtkIdType> firsts(size + 1);
  ForEach(size, [&](vtkIdType s) { firsts[s] = countCells(s); });
  CountsToOffsets(firsts);
  output.Cells = vtkSmartPointer<vtkIdTypeArray>::New();
  output.Cells->SetName(CellNumbersName);
  output.Cells->SetNumberOfValues(firsts[size]);
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
