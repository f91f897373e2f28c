// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sectors.h
 * What the limit of a cell depends on next to each of its faces: the cells beyond a crease do not
 * count there (Mathematics 14).
 */
#ifndef SubdivisionObjects_Sectors_h
#define SubdivisionObjects_Sectors_h

#include "Core/Memory/Buffer.h"
#include "Core/Operators/MatrixFactors.h"
#include "Private/Bounds/NestedPieces.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

class Sectors
{
public:
  /// The factors of a step, the first to be applied first.
  using Step = std::vector<const MatrixFactors::Matrix*>;
  using Mask = NestedPieces::Mask;

  /// `last`: the last step of the pieces. What depends on what is read off its rows.
  Sectors(const NestedPieces& pieces, const Step& last);

  /// The limit next to a place of a cell depends on the points of the pieces at it that belong to
  /// its sector. Calls whole(place) for the place in each cell of the sector, its own cell too; all
  /// neighbours there belong to it. Of other cells calls rest(place) for the neighbours that do.
  template <typename Whole, typename Rest>
  void ForSector(vtkIdType cell, int point, const Whole& whole, const Rest& rest) const;
  vtkIdType GetCell(vtkIdType place) const { return this->CellsOfPlaces[place]; }
  /// The places that are a point.
  Row<vtkIdType> GetPlaces(vtkIdType point) const { return this->PlacesOfPoints[point]; }
  /// Whether the sector at a place of a cell has tetrahedra.
  bool HasTets(vtkIdType cell, int point) const
  {
    return this->GetSector(cell, this->Pieces.GetLattice(cell).Faces[point]).HasTets;
  }

private:
  /// All faces of the cells that a limit depends on, in ascending order.
  struct Sector
  {
    std::vector<vtkIdType> Faces;
    bool IsOpen = false; ///< a row was not understood: all belongs to it
    bool HasTets = false;

    bool Has(vtkIdType face) const
    {
      return this->IsOpen || std::binary_search(this->Faces.begin(), this->Faces.end(), face);
    }
  };
  static constexpr int Masks = 1 << NestedPieces::MostCorners;

  vtkIdType GetFace(vtkIdType cell, Mask mask) const { return this->Faces[Masks * cell + mask]; }
  const Sector& GetSector(vtkIdType cell, Mask face) const
  {
    return this->Found[this->FirstSectors[cell] + static_cast<int>(face) - 1];
  }
  void NumberFaces();
  void ListPlaces();
  void FindInfluences(const Step& last);
  bool IsInside(vtkIdType place) const;
  void AddInfluences(vtkIdType point, vtkIdType column);
  Sector FindSector(vtkIdType cell, Mask face) const;
  Mask FindCorners(vtkIdType cell, vtkIdType of, Mask face) const;

  const NestedPieces& Pieces;
  Buffer<vtkIdType> Faces; ///< the number of each face of each cell; -1: no face
  vtkIdType NumberOfFaces = 0;
  Rows<vtkIdType> PlacesOfPoints;
  Buffer<vtkIdType> CellsOfPlaces;
  /// For each face the larger ones on whose values limits in it depend, as Masks * cell + mask.
  std::vector<std::vector<vtkIdType>> Influences;
  std::vector<char> IsOpen; ///< of each face, whether a row was not understood
  std::vector<vtkIdType> FirstSectors;
  std::vector<Sector> Found;
};

/// Calls act(column, weight) for the columns of a row of the product of some factors.
template <typename Act>
void ForColumns(
  const Sectors::Step& step, std::size_t factors, vtkIdType row, double weight, const Act& act)
{
  const MatrixFactors::Matrix& factor = *step[factors - 1];
  for (vtkIdType e = factor.Offsets[row]; e < factor.Offsets[row + 1]; ++e)
  {
    if (factor.Weights[e] != 0.)
    {
      const double product = weight * factor.Weights[e];
      factors == 1 ? act(factor.Columns[e], product)
                   : ForColumns(step, factors - 1, factor.Columns[e], product, act);
    }
  }
}

template <typename Whole, typename Rest>
void Sectors::ForSector(vtkIdType cell, int point, const Whole& whole, const Rest& rest) const
{
  const Sector& sector = this->GetSector(cell, this->Pieces.GetLattice(cell).Faces[point]);
  for (const vtkIdType place :
    this->PlacesOfPoints[this->Pieces.GetPoint(this->Pieces.GetFirstPlace(cell) + point)])
  {
    const vtkIdType other = this->CellsOfPlaces[place];
    const NestedPieces::Lattice& its = this->Pieces.GetLattice(other);
    if (sector.Has(this->GetFace(other, its.GetWhole())))
    {
      whole(place);
      continue;
    }
    const vtkIdType first = this->Pieces.GetFirstPlace(other);
    for (const int neighbour : its.Neighbours[place - first])
    {
      if (sector.Has(
            this->GetFace(other, its.Close(its.Faces[place - first] | its.Faces[neighbour]))))
      {
        rest(first + neighbour);
      }
    }
  }
}

}

#endif
