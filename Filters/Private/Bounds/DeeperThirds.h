// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeeperThirds.h
 * Parts of cells as cells of their own, two steps of sqrt(3) deeper.
 *
 * Rows of this scheme reach beyond the neighbours of a cell, so that a further step does not have
 * the rows of the step before, as in DeeperPieces. Here parts are cut out of the mesh, with the
 * cells on which their limits depend, and split as a mesh of their own. Which edges and vertices
 * are fixed is read off the rows.
 */
#ifndef SubdivisionObjects_DeeperThirds_h
#define SubdivisionObjects_DeeperThirds_h

#include "Private/Bounds/DeeperCells.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <utility>
#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace subdivision
{

/// The cell array of a patch that tells which vertices and lines are singular.
constexpr const char* PatchSingularName = "Singular";
/// Splits a patch. Returns null after an error, or a stop.
using SubdividePatch = std::function<vtkSmartPointer<vtkPointSet>(
  vtkPolyData* patch, int levels, MatrixFactors* factors)>;

class DeeperThirds : public DeeperCells
{
public:
  /// Returns null where `subdivide` does.
  static std::unique_ptr<DeeperThirds> Make(
    const SteppedPieces& from, const std::vector<Part>& wanted, const SubdividePatch& subdivide);

  SteppedPieces Get() const override { return { *this->Pieces, *this->AllSectors, this->Last }; }

private:
  explicit DeeperThirds(const SteppedPieces& from)
    : From(from)
  {
  }
  void ListParts(const std::vector<Part>& wanted);
  void AddPart(const Part& part);
  void AddPartsAt(vtkIdType point);
  vtkIdType GetPoint(const Part& part, const LatticePoint& place) const;
  std::vector<vtkIdType> GetCornersOf(const Part& part) const;
  bool IsLine(const Part& part) const { return this->From.Pieces.GetDimension(part.Cell) == 1; }
  using Ends = std::array<vtkIdType, 2>;
  std::set<Ends> ListFixedEdges() const;
  std::vector<std::pair<vtkIdType, double>> GetRow(vtkIdType point) const;
  vtkSmartPointer<vtkPolyData> CutOut();
  bool Split(vtkPolyData* patch, const SubdividePatch& subdivide);
  void FindOld();

  const SteppedPieces From;
  std::vector<Part> Parts;      ///< the wanted ones come first
  std::set<Part> Known;         ///< the same
  std::vector<vtkIdType> Cells; ///< of the parts, in the patch
  MatrixFactors Factors;
  Sectors::Step Last;
  std::unique_ptr<NestedPieces> Pieces;
  std::unique_ptr<Sectors> AllSectors;
};

}

#endif
