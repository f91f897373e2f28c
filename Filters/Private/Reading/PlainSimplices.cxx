// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/PlainSimplices.h"

#include "Core/Memory/Buffer.h"
#include "Private/Reading/CellChecks.h"

#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace subdivision
{
namespace
{

/// The dimension d of the simplex that a cell of this type is if it has d + 1 points; -1 if it
/// never is one.
int GetSimplexDimension(int cellType)
{
  switch (cellType)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return 1;
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return 2;
    case VTK_TETRA:
      return 3;
    default:
      return -1;
  }
}

/// Whether all values are finite. A number that is infinite or NaN has all bits of its exponent
/// set, so that adding 1 to the exponent carries into the sign.
template <typename Bits, int Mantissa, typename Number>
bool AreFinite(const Number* values, vtkIdType begin, vtkIdType end)
{
  static_assert(sizeof(Bits) == sizeof(Number), "the bits of one number");
  constexpr Bits sign = Bits(1) << (8 * sizeof(Bits) - 1);
  constexpr Bits one = Bits(1) << Mantissa;
  constexpr Bits exponent = sign - one;
  Bits found = 0;
  for (vtkIdType i = begin; i < end; ++i)
  {
    Bits bits;
    std::memcpy(&bits, values + i, sizeof(Bits));
    found |= (bits & exponent) + one;
  }
  return (found & sign) == 0;
}

/// Whether each cell has `Corners` ids that are all different and ids of existing points.
template <int Corners, typename Id>
bool AreSimplices(const Id* ids, vtkIdType cells, vtkIdType numberOfPoints)
{
  using Bits = std::make_unsigned_t<Id>;
  constexpr vtkIdType largest = std::numeric_limits<Id>::max();
  const Bits last = static_cast<Bits>(std::min(numberOfPoints - 1, largest));
  Bits signs = 0; // the sign bit is set if an id, or `last` minus an id, is negative
  bool repeats = false;
  for (vtkIdType cell = 0; cell < cells; ++cell, ids += Corners)
  {
    for (int i = 0; i < Corners; ++i)
    {
      signs |= static_cast<Bits>(ids[i]) | (last - static_cast<Bits>(ids[i]));
      for (int k = 0; k < i; ++k)
      {
        repeats |= ids[i] == ids[k];
      }
    }
  }
  return signs <= static_cast<Bits>(largest) && !repeats;
}

template <typename Id>
bool AreSimplices(int dimension, const Id* ids, vtkIdType cells, vtkIdType numberOfPoints)
{
  switch (dimension)
  {
    case 0:
      return AreSimplices<1>(ids, cells, numberOfPoints);
    case 1:
      return AreSimplices<2>(ids, cells, numberOfPoints);
    case 2:
      return AreSimplices<3>(ids, cells, numberOfPoints);
    default:
      return AreSimplices<4>(ids, cells, numberOfPoints);
  }
}

/// Whether the cells [begin, end), all of one type, are simplices of this dimension without fault.
bool IsPlain(const CellReader::Part& part, int dimension, vtkIdType begin, vtkIdType end,
  vtkIdType numberOfPoints)
{
  const vtkIdType first = part.Offsets[begin - part.Begin];
  const bool inOrder = part.Offsets.Visit(
    [&](const auto* offsets)
    {
      using Bits = std::make_unsigned_t<std::decay_t<decltype(*offsets)>>;
      Bits wrong = 0;
      for (vtkIdType i = begin - part.Begin; i < end - part.Begin; ++i)
      {
        const Bits size = static_cast<Bits>(offsets[i + 1]) - static_cast<Bits>(offsets[i]);
        wrong |= size ^ static_cast<Bits>(dimension + 1);
      }
      return wrong == 0;
    });
  const vtkIdType entries = (dimension + 1) * (end - begin);
  if (!inOrder || first < 0 || first > part.Ids.Size || entries > part.Ids.Size - first)
  {
    return false;
  }
  return part.Ids.Visit([&](const auto* ids)
    { return AreSimplices(dimension, ids + first, end - begin, numberOfPoints); });
}

bool HasHidden(const unsigned char* ghosts, vtkIdType begin, vtkIdType end)
{
  return ghosts && std::any_of(ghosts + begin, ghosts + end, IsHiddenCell);
}

}

bool AreFinite(vtkDataArray* array)
{
  const bool isDouble = array->GetDataType() == VTK_DOUBLE;
  if (!array->HasStandardMemoryLayout() || (!isDouble && array->GetDataType() != VTK_FLOAT))
  {
    return false;
  }
  const void* values = array->GetNumberOfValues() > 0 ? array->GetVoidPointer(0) : nullptr;
  std::atomic<bool> finite{ true };
  ForRanges(array->GetNumberOfValues(),
    [&](vtkIdType begin, vtkIdType end)
    {
      const bool good = isDouble
        ? AreFinite<std::uint64_t, 52>(static_cast<const double*>(values), begin, end)
        : AreFinite<std::uint32_t, 23>(static_cast<const float*>(values), begin, end);
      if (!good)
      {
        finite = false;
      }
    });
  return finite;
}

bool ReadPlainSimplices(
  vtkPointSet* input, const CellReader& cells, std::vector<unsigned char>& dimensions)
{
  if (!input->GetPoints())
  {
    return false;
  }
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const unsigned char* ghosts = GetGhosts(input, cells.GetNumberOfCells());
  ResizeInHugePages(dimensions, cells.GetNumberOfCells());
  std::atomic<bool> plain{ true };
  ForCellBlocks(cells,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    {
      bool good = plain && !HasHidden(ghosts, begin, end);
      while (good && begin < end)
      {
        // A run of cells of one type in one part.
        const CellReader::Part& part = cells.FindPart(begin);
        const int type = cells.GetCellType(begin);
        const int dimension = GetSimplexDimension(type);
        vtkIdType next = std::min(end, part.End);
        if (const unsigned char* types = cells.GetTypes())
        {
          next = std::find_if(types + begin, types + next,
                   [type](unsigned char other) { return other != type; }) -
            types;
        }
        good = dimension >= 0 && IsPlain(part, dimension, begin, next, numberOfPoints);
        std::fill_n(
          dimensions.begin() + begin, next - begin, static_cast<unsigned char>(dimension));
        begin = next;
      }
      if (!good)
      {
        plain = false;
      }
    });
  if (!plain || !AreFinite(input->GetPoints()->GetData()))
  {
    dimensions.clear();
    return false;
  }
  return true;
}

}
