// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Colours.h
 * Colours of materials (Private/Values/MaterialFields.h): which of them the cells at a point have.
 */
#ifndef SubdivisionObjects_Colours_h
#define SubdivisionObjects_Colours_h

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellArray.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace subdivision
{

using ColourMask = std::uint32_t; ///< a bit for each colour

constexpr int MaximumNumberOfColours = 32;
constexpr int NoColour = -1; ///< of a cell that is a face of another one
/// Sums of weights of values (MaterialFields.h) below this are rounding.
constexpr double LeastWeight = 1e-6;

class ColourMasks
{
public:
  explicit ColourMasks(vtkIdType numberOfPoints)
    : Masks(static_cast<std::size_t>(numberOfPoints))
  {
  }
  /// Adds the colours of cells to their points: cell c has the points id(i) for i from offset(c) to
  /// offset(c + 1).
  template <typename Offset, typename Id, typename Colour>
  void Add(vtkIdType cells, const Offset& offset, const Id& id, const Colour& colour)
  {
    ForEach(cells,
      [&](vtkIdType c)
      {
        const int bit = colour(c);
        for (vtkIdType i = offset(c); bit != NoColour && i < offset(c + 1); ++i)
        {
          this->Masks[static_cast<std::size_t>(id(i))].fetch_or(
            ColourMask(1) << bit, std::memory_order_relaxed);
        }
      });
  }
  /// The same for all cells of a vtkCellArray.
  template <typename Colour>
  void Add(vtkCellArray* cells, const Colour& colour)
  {
    CellReader::Integers offsets;
    CellReader::Integers ids;
    offsets.Set(cells->GetOffsetsArray());
    ids.Set(cells->GetConnectivityArray());
    this->Add(
      cells->GetNumberOfCells(), [&](vtkIdType c) { return offsets[c]; },
      [&](vtkIdType i) { return ids[i]; }, colour);
  }
  std::vector<ColourMask> Get() const { return { this->Masks.begin(), this->Masks.end() }; }

private:
  std::vector<std::atomic<ColourMask>> Masks;
};

}

#endif
