// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothnessCells.h
 * The cells of the output of vtkSubdivisionSmoothness, and their arrays.
 */
#ifndef SubdivisionObjects_SmoothnessCells_h
#define SubdivisionObjects_SmoothnessCells_h

#include "Core/Smoothness/StarMap.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Smoothness/SmoothnessProbe.h"

#include <string>
#include <vector>

namespace subdivision
{

class SmoothnessCells
{
public:
  explicit SmoothnessCells(const SmoothnessOptions& options)
    : Options(options)
  {
  }

  /// Adds a cell of dimension 0 to 2. `sector`: which one at a vertex, -1: the vertex itself;
  /// `rule`: the dimension of its rule, 4: blended. Returns whether it is the cell of MapOfCell.
  template <typename Id>
  bool Add(
    int dimension, const Id* points, int size, int sector, int rule, const SmoothnessFacts& facts)
  {
    if (this->Options.FailingOnly && !facts.Fails())
    {
      return false;
    }
    this->Connectivity.insert(this->Connectivity.end(), points, points + size);
    this->Cells.push_back({ facts, static_cast<vtkIdType>(this->Connectivity.size()), sector,
      static_cast<unsigned char>(dimension), static_cast<signed char>(rule) });
    return static_cast<vtkIdType>(this->Cells.size()) == this->Options.MapOfCell + 1;
  }

  /// An error message if there are more cells than MaximumNumberOfCells, or if they do not fit in
  /// memory. `points` counts the points of the output.
  static std::string CheckSize(double cells, double points, const SmoothnessOptions& options);

  void Write(vtkUnstructuredGrid* output) const;

  /// Writes the map of MapOfCell instead. Returns false after an error, if there is none.
  bool WriteMap(const StarMap& map, vtkUnstructuredGrid* output) const;

private:
  struct Cell
  {
    SmoothnessFacts Facts;
    vtkIdType End; ///< of its points
    int Sector;
    unsigned char Dimension;
    signed char Rule;
  };

  vtkIdType GetBegin(vtkIdType cell) const { return cell == 0 ? 0 : this->Cells[cell - 1].End; }
  vtkIdType GetSize(vtkIdType cell) const { return this->Cells[cell].End - this->GetBegin(cell); }
  void WriteCells(vtkUnstructuredGrid* output) const;
  void WriteArrays(vtkUnstructuredGrid* output) const;
  void MarkPoints(vtkUnstructuredGrid* output) const;

  const SmoothnessOptions& Options;
  std::vector<vtkIdType> Connectivity;
  std::vector<Cell> Cells;
};

}

#endif
