// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PartsAsCells.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <map>

namespace subdivision
{

Buffer<double> PartsAsCells::Take(int step, const Buffer<double>& values, int components) const
{
  const vtkIdType size = this->Pieces->GetNumberOfPoints(step);
  Buffer<double> taken(components * size);
  ForEach(size,
    [&](vtkIdType i)
    {
      std::copy_n(
        values.data() + components * this->Old[i], components, taken.data() + components * i);
    });
  return taken;
}

void PartsAsCells::ListParts(const std::vector<Part>& wanted)
{
  std::map<Part, vtkIdType> numbers;
  const auto add = [&](const Part& part)
  {
    if (numbers.try_emplace(part, static_cast<vtkIdType>(this->Parts.size())).second)
    {
      this->Parts.push_back(part);
    }
  };
  // Quarters of an octahedron follow each other.
  const auto addAll = [&](const std::vector<Part>& parts)
  {
    for (const Part& part : InTurn(parts))
    {
      const auto quarters = this->GetLattice(part).ListOctahedron(part.Child);
      for (const NestedPieces::Lattice::QuarterChild& quarter : quarters)
      {
        add({ part.Cell + quarter.Quarter, quarter.Child });
      }
      if (quarters.empty())
      {
        add(part);
      }
    }
  };
  addAll(wanted);
  std::vector<vtkIdType> corners;
  for (const Part& part : InTurn(wanted))
  {
    this->Wanted.push_back(numbers.at(part));
    for (int k = 0; k < this->GetLattice(part).Corners; ++k)
    {
      corners.push_back(this->GetOldCorner(part, k));
    }
  }
  SortDistinct(corners);
  std::vector<Part> others;
  for (const vtkIdType corner : InTurn(corners))
  {
    for (const vtkIdType place : this->From.AllSectors.GetPlaces(corner))
    {
      Part part{ this->From.AllSectors.GetCell(place), 0 };
      const NestedPieces::Lattice& lattice = this->GetLattice(part);
      if (lattice.Dimension == 0 && this->From.Pieces.HasThirds())
      {
        continue; // rows tell which vertices stay
      }
      for (; part.Child < static_cast<int>(lattice.Children.size()); ++part.Child)
      {
        for (int k = 0; k < lattice.Corners; ++k)
        {
          if (this->GetOldCorner(part, k) == corner)
          {
            others.push_back(part);
          }
        }
      }
    }
  }
  SortDistinct(others);
  addAll(others);
}

void PartsAsCells::Finish(const std::vector<vtkIdType>& cells, const Sectors::Step& last)
{
  for (vtkIdType& wanted : this->Wanted)
  {
    wanted = cells[wanted];
  }
  this->Corners.resize(static_cast<std::size_t>(this->Pieces->GetNumberOfPoints(0)), { -1, -1 });
  this->Old.resize(static_cast<std::size_t>(this->Pieces->GetNumberOfPoints(2)), -1);
  for (const std::size_t p : InTurn(this->Parts.size()))
  {
    const Part& part = this->Parts[p];
    const NestedPieces::Lattice& lattice = this->GetLattice(part);
    for (int point = 0; point < lattice.CountPoints(); ++point)
    {
      const int before = lattice.FindOfChild(part.Child, point);
      if (before < 0)
      {
        continue;
      }
      const vtkIdType number =
        this->Pieces->GetPoint(this->Pieces->GetFirstPlace(cells[p]) + point);
      this->Old[number] = this->GetOld(part, point);
      if (number < this->Pieces->GetNumberOfPoints(0))
      {
        this->Corners[number] = { part.Cell, before };
      }
    }
  }
  this->Last = last;
  this->AllSectors = std::make_unique<Sectors>(*this->Pieces, last);
}

}
