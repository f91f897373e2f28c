// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/StartPieces.h"

#include "Core/Memory/Loops.h"
#include "Private/Bounds/TetOctPieces.h"
#include "Private/Bounds/TetOctReader.h"
#include "Private/Places/SolidPieces.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace subdivision
{
namespace
{

/// Where a place in a tetrahedron, or in a quarter of an octahedron, is in that solid.
FrameNode GetPlaceInSolid(const std::array<double, 4>& weights, int quarter, int divisions)
{
  FrameNode place{};
  for (int corner = 0; corner < 4; ++corner)
  {
    const auto multiple = static_cast<int>(std::lround(weights[corner] * divisions));
    const FrameNode vertex = quarter >= 0
      ? TetOctPieces::GetVertex(TetOctPieces::GetQuarters()[quarter][corner])
      : FrameNode{ { corner == 1 ? 1 : 0, corner == 2 ? 1 : 0, corner == 3 ? 1 : 0 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] += multiple * vertex[axis];
    }
  }
  return place;
}

/// The corners of all pieces of a tetrahedron, or of a quarter, one piece after the other.
std::vector<FrameNode> ListPieces(int steps, int quarter)
{
  std::vector<FrameNode> corners;
  for (vtkIdType part = 0; part < vtkIdType(1) << (3 * steps); ++part)
  {
    for (int k = 0; k < 4; ++k)
    {
      std::array<double, 4> corner{};
      corner[k] = 1.;
      corners.push_back(
        GetPlaceInSolid(LeavePartOfSimplex(3, steps, part, corner), quarter, 1 << steps));
    }
  }
  return corners;
}

/// Writes the pieces of solids, from the points that these have after some steps.
class PieceWriter
{
public:
  PieceWriter(vtkUnstructuredGrid* fine, int steps, vtkUnstructuredGrid* cut)
    : Reader(fine, steps)
    , Cut(cut)
  {
    for (int quarter = -1; quarter < 4; ++quarter)
    {
      this->Corners[quarter + 1] = ListPieces(steps, quarter);
    }
  }

  void WriteTet(vtkIdType first) { this->Write(this->Reader.GetTet(first), -1); }
  /// `quarters`: the corners of the four quarters.
  void WriteOct(vtkIdType first, const vtkIdType* quarters)
  {
    const auto solid = this->Reader.GetOct(first, TetOctPieces::Join(quarters));
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->Write(solid, quarter);
    }
  }

private:
  void Write(const TetOctReader::Solid& solid, int quarter)
  {
    const std::vector<FrameNode>& corners = this->Corners[quarter + 1];
    for (std::size_t first = 0; first < corners.size(); first += 4)
    {
      vtkIdType piece[4];
      std::transform(corners.begin() + static_cast<std::ptrdiff_t>(first),
        corners.begin() + static_cast<std::ptrdiff_t>(first) + 4, piece,
        [&](const FrameNode& place) { return this->Reader.GetPoint(solid, place); });
      this->Cut->InsertNextCell(VTK_TETRA, 4, piece);
    }
  }

  TetOctReader Reader;
  vtkUnstructuredGrid* Cut;
  std::array<std::vector<FrameNode>, 5> Corners; ///< of a tetrahedron, then of each quarter
};

}

vtkSmartPointer<vtkUnstructuredGrid> CutSolidsAnew(vtkUnstructuredGrid* fine,
  const SimplexList& simplices, const Buffer<vtkIdType>& octahedra, int steps)
{
  auto cut = vtkSmartPointer<vtkUnstructuredGrid>::New();
  cut->SetPoints(fine->GetPoints());
  cut->Allocate(fine->GetNumberOfCells());
  PieceWriter writer(fine, steps, cut);
  vtkNew<vtkIdList> points;
  vtkIdType first = 0;  // of the cells that a simplex becomes
  vtkIdType corner = 0; // of the simplex
  int left = 0;         // quarters that were written with the first one
  for (const vtkIdType s : InTurn(simplices.GetNumberOfSimplices()))
  {
    const int dimension = simplices.Dimensions[s];
    const vtkIdType next = first + (vtkIdType(1) << (dimension * steps));
    if (left > 0)
    {
      --left;
    }
    else if (dimension == 3 && octahedra[s] >= 0)
    {
      writer.WriteOct(first, simplices.Connectivity.data() + corner);
      left = 3;
    }
    else if (dimension == 3)
    {
      writer.WriteTet(first);
    }
    else
    {
      for (vtkIdType cell = first; cell < next; ++cell)
      {
        fine->GetCellPoints(cell, points);
        cut->InsertNextCell(fine->GetCellType(cell), points);
      }
    }
    first = next;
    corner += dimension + 1;
  }
  return cut;
}

}
