// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/SolidOrientation.h"

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/TetFrame.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>

namespace subdivision
{
namespace
{

/// Running sums of `count`: where the corners of each simplex begin in the connectivity, or where
/// its children begin among the cells of the output.
template <typename Count>
Buffer<vtkIdType> FindFirsts(const SimplexList& simplices, const Count& count)
{
  Buffer<vtkIdType> firsts(simplices.GetNumberOfSimplices() + 1);
  ForEach(firsts.size() - 1, [&](vtkIdType i) { firsts[i] = count(simplices.Dimensions[i]); });
  CountsToOffsets(firsts);
  return firsts;
}

/// Tells the orientation of tetrahedra of an output.
template <typename Out, typename T>
class CellCheck
{
public:
  CellCheck(vtkUnstructuredGrid* output, double tie)
    : Offsets(static_cast<const Out*>(output->GetCells()->GetOffsetsArray()->GetVoidPointer(0)))
    , Ids(static_cast<const Out*>(output->GetCells()->GetConnectivityArray()->GetVoidPointer(0)))
    , Points(static_cast<const T*>(output->GetPoints()->GetVoidPointer(0)))
    , Tie(tie)
  {
  }
  int GetOrientation(vtkIdType cell) const
  {
    double x[4][3];
    const double* corners[4];
    for (int k = 0; k < 4; ++k)
    {
      const T* p = this->Points + 3 * static_cast<vtkIdType>(this->Ids[this->Offsets[cell] + k]);
      for (int c = 0; c < 3; ++c) // std::copy would call a function
      {
        x[k][c] = static_cast<double>(p[c]);
      }
      corners[k] = x[k];
    }
    return GetOrientationOfTet(corners, this->Tie);
  }

private:
  const Out* Offsets;
  const Out* Ids;
  const T* Points;
  const double Tie;
};

template <typename Act>
void WithCheck(vtkUnstructuredGrid* output, double tie, const Act& act)
{
  const bool isSingle = output->GetPoints()->GetDataType() == VTK_FLOAT;
  if (output->GetCells()->IsStorage64Bit())
  {
    isSingle ? act(CellCheck<long long, float>(output, tie))
             : act(CellCheck<long long, double>(output, tie));
  }
  else
  {
    isSingle ? act(CellCheck<int, float>(output, tie)) : act(CellCheck<int, double>(output, tie));
  }
}

}

std::vector<vtkIdType> FindInvertedTets(const SimplexList& simplices, const Coordinates& points)
{
  const vtkIdType size = simplices.GetNumberOfSimplices();
  const Buffer<vtkIdType> firsts =
    FindFirsts(simplices, [](int dimension) { return dimension + 1; });
  Buffer<signed char> orientations(size, 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      if (simplices.Dimensions[i] == 3)
      {
        const double* corners[4];
        for (int k = 0; k < 4; ++k)
        {
          corners[k] = points.Values + 3 * simplices.Connectivity[firsts[i] + k];
        }
        orientations[i] = static_cast<signed char>(GetOrientationOfTet(corners, points.Tie));
      }
    });
  std::vector<vtkIdType> found;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (orientations[i] < 1)
    {
      found.push_back(2 * i + (orientations[i] == 0 ? 1 : 0));
    }
  }
  return found;
}

InvertedCells FindInvertedCells(const SimplexList& control, int levels,
  const std::vector<vtkIdType>& inverted, double tie, vtkUnstructuredGrid* output,
  unsigned char* marks)
{
  const vtkIdType size = control.GetNumberOfSimplices();
  const Buffer<vtkIdType> firsts =
    FindFirsts(control, [levels](int dimension) { return vtkIdType(1) << (dimension * levels); });
  std::atomic<vtkIdType> count(0);
  std::atomic<vtkIdType> least(firsts[size]);
  WithCheck(output, tie,
    [&](const auto& check)
    {
      auto visit = [&](vtkIdType i, vtkIdType begin, vtkIdType end)
      {
        const auto known = std::lower_bound(inverted.begin(), inverted.end(), 2 * i);
        const bool isKnown = known != inverted.end() && *known / 2 == i;
        const bool isFlat = isKnown && *known % 2 == 1;
        const int wrong = isKnown ? 1 : -1;
        for (vtkIdType cell = begin; cell < end && !isFlat; ++cell)
        {
          if (check.GetOrientation(cell) != wrong)
          {
            continue;
          }
          ++count;
          vtkIdType seen = least;
          while (cell < seen && !least.compare_exchange_weak(seen, cell))
          {
          }
          if (marks)
          {
            marks[cell] = 1;
          }
        }
      };
      // The ranges are of output cells, so that several threads share the children of one control
      // tetrahedron.
      ForRanges(firsts[size],
        [&](vtkIdType begin, vtkIdType end)
        {
          vtkIdType i = std::upper_bound(firsts.begin(), firsts.end(), begin) - firsts.begin() - 1;
          for (; i < size && firsts[i] < end; ++i)
          {
            if (control.Dimensions[i] == 3)
            {
              visit(i, std::max(begin, firsts[i]), std::min(end, firsts[i + 1]));
            }
          }
        });
    });
  return { count, count > 0 ? least.load() : vtkIdType(-1) };
}

}
