// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OutputNumbers.h"

#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// The simplices of the control mesh, and what they have in common with those of other partitions.
class ControlNumbers
{
public:
  ControlNumbers(const ControlMesh& mesh, const SimplexTuples& derived, vtkPointSet* input,
    int steps, Partners& partners)
    : Mesh(mesh)
    , Control(mesh.GetControl())
    , With(partners)
    , Complex(BuildComplex<long long>(AddTuples(this->Control, derived), this->Runs))
  {
    this->FindCells(PlaceCells(input, partners));
    SharedNumbers vertices = NumberVertices(
      input->GetNumberOfPoints(), SimplexView(this->Control), this->Pieces, partners);
    this->Numbers[0] = std::move(vertices.First);
    this->Totals[0] = vertices.Totals[0];
    this->NumberSimplices(steps);
    this->NumberFaces<2>(this->Complex.EdgeVertices, this->Complex.NumberOfLineCells);
    this->NumberFaces<3>(this->Complex.FaceVertices, this->Complex.NumberOfTriangleCells);
  }

  /// The numbers of vertices, edges, faces and tetrahedra, and how many the whole has.
  std::array<Ids, 4> Numbers;
  std::array<vtkIdType, 4> Totals{};
  Ids FirstCells;
  vtkIdType NumberOfCells = 0;

  /// Of each derived simplex of a dimension, whether it is a face of an own cell.
  template <int Dimension>
  std::vector<char> FindOwnDerived() const
  {
    const std::vector<char> own = this->FindOwn<Dimension>();
    const Buffer<long long>* twins[3] = { nullptr, &this->Complex.EqualLines.Twins,
      &this->Complex.EqualTriangles.Twins };
    std::vector<char> found;
    for (const CellRun& run : this->Runs)
    {
      for (vtkIdType i = 0; run.Dimension == Dimension && i < run.Count; ++i)
      {
        if (run.FirstCell + i >= this->Control.GetNumberOfSimplices())
        {
          const vtkIdType index = run.First + i;
          found.push_back(own[Dimension == 0 ? this->Complex.VertexCells[index]
              : run.Equal                    ? (*twins[Dimension])[index]
                                             : index]);
        }
      }
    }
    return found;
  }

private:
  /// act(index of a control simplex, its dimension, its number among those of the complex; -1: an
  /// equal one is in the complex).
  template <typename Act>
  void ForSimplices(const Act& act) const
  {
    for (const CellRun& run : this->Runs)
    {
      const vtkIdType last =
        std::min(run.FirstCell + run.Count, this->Control.GetNumberOfSimplices());
      for (vtkIdType s = run.FirstCell; s < last; ++s)
      {
        act(s, run.Dimension, run.Equal ? -1 : run.First + s - run.FirstCell);
      }
    }
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
    this->ForSimplices(
      [&](vtkIdType s, int dimension, vtkIdType number)
      {
        simplices.Sizes[4 * s] = vtkIdType(1) << (dimension * steps);
        if (dimension > 0 && number >= 0)
        {
          simplices.Sizes[4 * s + dimension] = 1;
        }
      });
    const SharedNumbers numbers = NumberTogether(simplices, this->With);
    this->NumberOfCells = numbers.Totals[0];
    this->FirstCells.resize(this->Cells.size());
    this->ForSimplices(
      [&](vtkIdType s, int dimension, vtkIdType number)
      {
        this->FirstCells[s] = numbers.First[4 * s];
        if (dimension > 0 && number >= 0)
        {
          this->Numbers[dimension].push_back(numbers.First[4 * s + dimension]);
        }
      });
    std::copy_n(numbers.Totals.begin() + 1, 3, this->Totals.begin() + 1);
  }

  /// Which vertices, edges or faces belong to own simplices.
  template <int Dimension>
  std::vector<char> FindOwn() const
  {
    const auto& complex = this->Complex;
    const vtkIdType sizes[3] = { complex.NumberOfVertices, complex.NumberOfEdges,
      complex.NumberOfFaces };
    std::vector<char> own(static_cast<size_t>(sizes[Dimension]), 0);
    const auto mark = [&own](const Buffer<long long>& parts, vtkIdType simplex, int size)
    {
      for (vtkIdType i = simplex * size; i < (simplex + 1) * size; ++i)
      {
        own[parts[i]] = 1;
      }
    };
    const Buffer<long long>* vertices[4] = { &complex.VertexCells, &complex.EdgeVertices,
      &complex.FaceVertices, &complex.TetVertices };
    this->ForSimplices(
      [&](vtkIdType s, int dimension, vtkIdType number)
      {
        if (number < 0 || dimension < Dimension || !this->With.IsOwn(this->Cells[s]))
        {
          return;
        }
        if (Dimension == 0)
        {
          mark(*vertices[dimension], number, dimension + 1);
        }
        else if (dimension == Dimension)
        {
          own[number] = 1;
        }
        else if (Dimension == 1)
        {
          mark(
            dimension == 2 ? complex.FaceEdges : complex.TetEdges, number, dimension == 2 ? 3 : 6);
        }
        else
        {
          mark(complex.TetFaces, number, 4);
        }
      });
    return own;
  }

  /// Numbers the edges or faces that are no control simplices: those that are derived, and then all
  /// others.
  template <int Size>
  void NumberFaces(const Buffer<long long>& vertices, vtkIdType firstOther)
  {
    const std::vector<char> own = this->FindOwn<Size - 1>();
    const auto first = static_cast<vtkIdType>(this->Numbers[Size - 1].size());
    this->NumberFaces<Size>(vertices, own, first, firstOther);
    this->NumberFaces<Size>(vertices, own, firstOther, vertices.size() / Size);
  }

  /// Some of them, in the order of their vertices.
  template <int Size>
  void NumberFaces(const Buffer<long long>& vertices, const std::vector<char>& own, vtkIdType first,
    vtkIdType last)
  {
    SharedKeys faces;
    faces.Width = Size;
    for (vtkIdType f = first; f < last; ++f)
    {
      std::array<vtkIdType, Size> key;
      for (int k = 0; k < Size; ++k)
      {
        key[k] = this->Numbers[0][vertices[Size * f + k]];
      }
      std::sort(key.begin(), key.end());
      faces.Own.push_back(own[f] && key[0] >= 0);
      std::replace(key.begin(), key.end(), vtkIdType(-1), vtkIdType(0));
      faces.Keys.insert(faces.Keys.end(), key.begin(), key.end());
    }
    const SharedNumbers found = NumberTogether(faces, this->With);
    vtkIdType& total = this->Totals[Size - 1];
    for (const vtkIdType number : found.First)
    {
      this->Numbers[Size - 1].push_back(number < 0 ? -1 : total + number);
    }
    total += found.Totals[0];
  }

  const ControlMesh& Mesh;
  const SimplexList& Control;
  Partners& With;
  std::vector<CellRun> Runs;
  const SimplicialComplex<long long> Complex;
  Ids Cells;         ///< of each control simplex, the input cell
  SharedKeys Pieces; ///< control simplices as pieces of these cells
};

}

OutputNumbers NumberOutput(const ControlMesh& mesh, const SimplexTuples& derived,
  vtkPointSet* input, int steps, const SchemeTraits& scheme, Partners& partners)
{
  const ControlNumbers control(mesh, derived, input, steps, partners);
  OutputNumbers output;
  output.FirstCells = control.FirstCells;
  output.NumberOfCells = control.NumberOfCells;
  output.NumberOfControlPoints = control.Totals[0];
  output.IsOwnDerived[0] = control.FindOwnDerived<0>();
  output.IsOwnDerived[1] = control.FindOwnDerived<1>();
  output.IsOwnDerived[2] = control.FindOwnDerived<2>();
  std::vector<SharedNumbers> things;
  for (size_t dimension = 0; dimension < 4; ++dimension)
  {
    things.push_back({ control.Numbers[dimension], { control.Totals[dimension] } });
  }
  const IdSegments vertices = scheme.ListVertices(steps);
  WholeIds points = std::move(FindWholeIds({ &vertices }, things)[0]);
  output.Points = std::move(points.Ids);
  output.NumberOfPoints = points.Total;
  const SimplexList& simplices = mesh.GetControl();
  for (vtkIdType s = 0; s < simplices.GetNumberOfSimplices(); ++s)
  {
    const vtkIdType size = vtkIdType(1) << (simplices.Dimensions[s] * steps);
    for (vtkIdType k = 0; k < size; ++k)
    {
      output.Cells.push_back(control.FirstCells[s] < 0 ? -1 : control.FirstCells[s] + k);
    }
  }
  return output;
}

}
