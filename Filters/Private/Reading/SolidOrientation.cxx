// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/SolidOrientation.h"

#include "Core/Memory/SimplexStarts.h"
#include "Core/Solids/Location/TetFrame.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <optional>

namespace subdivision
{
namespace
{

/// How many tetrahedra are looked at together: the children of one.
constexpr int InGroup = 8;

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
  /// Whether GetOrientation is not -sign for each of InGroup tetrahedra in a row, as far as their
  /// volumes tell it without a closer look: several at a time, for compilers that use vectors.
  bool HaveSign(vtkIdType first, double sign) const
  {
    // The volume is the one of GetOrientationOfTet. If it rounds to the wrong sign the tetrahedron
    // is flat, so that its orientation is 0. Beyond these bounds products may overflow or vanish.
    constexpr double least = 1e-250;
    constexpr double largest = 1e250;
    const Out* ids = this->Ids + this->Offsets[first];
    double x[4][3][InGroup];
    for (int i = 0; i < InGroup; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        const T* p = this->Points + 3 * static_cast<vtkIdType>(ids[4 * i + k]);
        for (int c = 0; c < 3; ++c)
        {
          x[k][c][i] = static_cast<double>(p[c]);
        }
      }
    }
    double volumes[InGroup];
    for (int i = 0; i < InGroup; ++i)
    {
      double e[3][3];
      for (int k = 0; k < 3; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          e[k][c] = x[k + 1][c][i] - x[0][c][i];
        }
      }
      volumes[i] = sign *
        (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
          e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
    }
    int good = 0;
    for (const double volume : volumes)
    {
      good += volume > least && volume < largest ? 1 : 0;
    }
    return good == InGroup;
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
  std::vector<vtkIdType> found;
  if (CountDimensions(simplices)[3] == 0)
  {
    return found;
  }
  const vtkIdType size = simplices.GetNumberOfSimplices();
  const SimplexStarts firsts = FindCorners(SimplexView(simplices));
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
  for (const vtkIdType i : InTurn(size))
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
  const KnownSigns& signs, unsigned char* marks)
{
  if (CountDimensions(control)[3] == 0)
  {
    return { 0, -1 };
  }
  const vtkIdType size = control.GetNumberOfSimplices();
  const SimplexStarts firsts = FindChildren(control, levels);
  const bool knows = !signs.Signs.empty();
  std::optional<SimplexStarts> firstSigns;
  if (knows)
  {
    firstSigns.emplace(FindChildren(control, levels - signs.Steps));
  }
  const int shift = 3 * signs.Steps;
  const auto getSign = [&](vtkIdType i, vtkIdType cell) -> int
  {
    const vtkIdType place = (*firstSigns)[i] + ((cell - firsts[i]) >> shift);
    return signs.Signs[static_cast<std::size_t>(place)];
  };
  std::atomic<vtkIdType> count(0);
  std::atomic<vtkIdType> least(firsts.GetLength());
  WithCheck(output, tie,
    [&](const auto& check)
    {
      auto mark = [&](vtkIdType cell)
      {
        ++count;
        vtkIdType seen = least;
        while (cell < seen && !least.compare_exchange_weak(seen, cell))
        {
        }
        if (marks)
        {
          marks[cell] = 1;
        }
      };
      auto visit = [&](vtkIdType i, vtkIdType begin, vtkIdType end)
      {
        const auto known = std::lower_bound(inverted.begin(), inverted.end(), 2 * i);
        const bool isKnown = known != inverted.end() && *known / 2 == i;
        const bool isFlat = isKnown && *known % 2 == 1;
        const int wrong = isKnown ? 1 : -1;
        for (vtkIdType first = begin; first < end && !isFlat; first += InGroup)
        {
          if (knows && getSign(i, first) == -wrong)
          {
            // to the end of these descendants, less the step of the loop
            first = firsts[i] + ((((first - firsts[i]) >> shift) + 1) << shift) - InGroup;
            continue;
          }
          const vtkIdType last = std::min(end, first + InGroup);
          if (last - first == InGroup && check.HaveSign(first, -wrong))
          {
            continue;
          }
          for (vtkIdType cell = first; cell < last; ++cell)
          {
            if (check.GetOrientation(cell) == wrong)
            {
              mark(cell);
            }
          }
        }
      };
      // The ranges are of output cells, so that several threads share the children of one control
      // tetrahedron.
      ForRanges(firsts.GetLength(),
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = firsts.Find(begin); i < size && firsts[i] < end; ++i)
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
