// SPDX-License-Identifier: BSD-3-Clause
#include "HybridReferenceStrata.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hybridtest
{

namespace
{

/// Whether an edge has only hexahedra, and wedges along their axis, which it counts.
bool IsProduct(const std::vector<Cell>& cells, const Ids& edge, int& hexes, int& wedges)
{
  hexes = wedges = 0;
  for (const Cell& cell : cells)
  {
    const Ids triangle =
      cell.Shape == Type::Wedge ? Ids(cell.Corners.begin(), cell.Corners.begin() + 3) : Ids();
    const bool isAxis =
      cell.Shape == Type::Wedge && Has(triangle, edge[0]) != Has(triangle, edge[1]);
    hexes += cell.Shape == Type::Hex;
    wedges += isAxis;
    if (cell.Shape != Type::Hex && !isAxis)
    {
      return false;
    }
  }
  return !cells.empty();
}

/// How many pieces cells make that meet in sides of a dimension which have the given side.
int CountPieces(const std::vector<Cell>& cells, const Ids& side, int dimensionOfSide)
{
  int pieces = 0;
  std::vector<bool> seen(cells.size());
  for (std::size_t first = 0; first < cells.size(); ++first)
  {
    pieces += !seen[first];
    std::vector<std::size_t> open = seen[first] ? std::vector<std::size_t>() : std::vector{ first };
    seen[first] = true;
    while (!open.empty())
    {
      const Cell cell = cells[open.back()];
      open.pop_back();
      for (const Cell& node :
        Complex::SidesAt({ cell }, side, dimensionOfSide, dimensionOfSide + 1))
      {
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
          if (!seen[i] && HasSide(cells[i], Sorted(node.Corners), dimensionOfSide + 1))
          {
            seen[i] = true;
            open.push_back(i);
          }
        }
      }
    }
  }
  return pieces;
}

int Count(const std::vector<Cell>& cells, Type shape)
{
  return static_cast<int>(std::count_if(
    cells.begin(), cells.end(), [shape](const Cell& cell) { return cell.Shape == shape; }));
}

}

Complex::Complex(const Mesh& mesh)
  : Given(mesh)
{
  std::set<Ids> proper[4];
  std::set<Ids> before[4];
  for (const Cell& cell : mesh.Cells)
  {
    for (int d = 0; d < DimensionOf(cell.Shape); ++d)
    {
      for (const Cell& side : Sides(cell, d))
      {
        proper[d].insert(Sorted(side.Corners));
      }
    }
  }
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    const Cell& cell = mesh.Cells[i];
    const int dimension = DimensionOf(cell.Shape);
    const Ids key = Sorted(cell.Corners);
    this->Maximal.push_back(
      proper[dimension].count(key) == 0 && before[dimension].insert(key).second);
    if (!this->Maximal.back())
    {
      continue;
    }
    for (int d = 0; d <= dimension; ++d)
    {
      for (const Cell& side : Sides(cell, d))
      {
        this->Known[d].emplace(Sorted(side.Corners), side);
      }
    }
    for (int corner : cell.Corners)
    {
      this->AtVertex[corner].push_back(i);
    }
  }
}

std::vector<Cell> Complex::CellsAt(const Ids& side, int k) const
{
  std::vector<Cell> cells;
  const auto found = this->AtVertex.find(side[0]);
  if (found == this->AtVertex.end())
  {
    return cells;
  }
  // Three and four corners are those of a face: whole cells are not asked for.
  const int dimension = std::min(static_cast<int>(side.size()), 3) - 1;
  for (std::size_t i : found->second)
  {
    const Cell& cell = this->Given.Cells[i];
    if (DimensionOf(cell.Shape) == k && k >= dimension && HasSide(cell, side, dimension))
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

std::vector<Cell> Complex::SidesAt(
  const std::vector<Cell>& cells, const Ids& side, int dimensionOfSide, int dimension)
{
  std::map<Ids, Cell> found;
  for (const Cell& cell : cells)
  {
    for (const Cell& own : Sides(cell, dimension))
    {
      if (HasSide(own, side, dimensionOfSide))
      {
        found.emplace(Sorted(own.Corners), own);
      }
    }
  }
  std::vector<Cell> sides;
  for (const auto& item : found)
  {
    sides.push_back(item.second);
  }
  return sides;
}

Strata::Strata(const Mesh& mesh, const Complex& complex)
  : Given(mesh)
  , Whole(complex)
{
}

std::vector<int> Strata::DimensionsAt(const Ids& side) const
{
  std::vector<int> dimensions;
  for (int k = 1; k <= 3; ++k)
  {
    if (!this->Whole.CellsAt(side, k).empty())
    {
      dimensions.push_back(k);
    }
  }
  return dimensions;
}

Strata::Place Strata::PlaceOf(const Ids& side, int dimensionOfSide, int k) const
{
  const std::vector<Cell> cells = this->Whole.CellsAt(side, k);
  if (k == dimensionOfSide)
  {
    return Place::Interior;
  }
  if (k == dimensionOfSide + 1)
  {
    return cells.size() > 2 ? Place::Joint : cells.size() == 2 ? Place::Interior : Place::Boundary;
  }
  if (k == dimensionOfSide + 3)
  {
    return this->PlaceInSolids(side[0]);
  }
  Place place = Place::Interior;
  for (const Cell& node : Complex::SidesAt(cells, side, dimensionOfSide, dimensionOfSide + 1))
  {
    const std::size_t degree = this->Whole.CellsAt(Sorted(node.Corners), k).size();
    if (degree > 2)
    {
      return Place::Joint;
    }
    place = degree == 1 ? Place::Boundary : place;
  }
  return CountPieces(cells, side, dimensionOfSide) > 1 ? Place::Joint : place;
}

Strata::Place Strata::PlaceInSolids(int vertex) const
{
  const std::vector<Cell> cells = this->Whole.CellsAt({ vertex }, 3);
  const std::vector<Cell> faces = Complex::SidesAt(cells, { vertex }, 0, 2);
  const std::vector<Cell> edges = Complex::SidesAt(cells, { vertex }, 0, 1);
  bool isBoundary = false;
  for (const Cell& face : faces)
  {
    isBoundary = isBoundary || this->Whole.CellsAt(Sorted(face.Corners), 3).size() == 1;
  }
  for (const Cell& edge : edges)
  {
    if (this->PlaceOf(Sorted(edge.Corners), 1, 3) == Place::Joint)
    {
      return Place::Joint;
    }
  }
  // The link is a connected surface: a sphere or a disk by its Euler characteristic.
  const int characteristic =
    static_cast<int>(edges.size() + cells.size()) - static_cast<int>(faces.size());
  if (CountPieces(cells, { vertex }, 0) > 1 || characteristic != (isBoundary ? 1 : 2))
  {
    return Place::Joint;
  }
  return isBoundary ? Place::Boundary : Place::Interior;
}

bool Strata::IsJoint(const Ids& side, int dimensionOfSide) const
{
  const std::vector<int> dimensions = this->DimensionsAt(side);
  return dimensions.size() > 1 ||
    (dimensions.size() == 1 && this->PlaceOf(side, dimensionOfSide, dimensions[0]) == Place::Joint);
}

std::vector<Cell> Strata::FacesAt(const Ids& side, int dimensionOfSide) const
{
  std::vector<Cell> cells = this->Whole.CellsAt(side, 2);
  const std::vector<Cell> solids = this->Whole.CellsAt(side, 3);
  cells.insert(cells.end(), solids.begin(), solids.end());
  return Complex::SidesAt(cells, side, dimensionOfSide, 2);
}

std::vector<Cell> Strata::EdgesAt(int vertex) const
{
  std::vector<Cell> cells;
  for (int k = 1; k <= 3; ++k)
  {
    const std::vector<Cell> some = this->Whole.CellsAt({ vertex }, k);
    cells.insert(cells.end(), some.begin(), some.end());
  }
  return Complex::SidesAt(cells, { vertex }, 0, 1);
}

bool Strata::IsSingularFace(const Ids& face) const
{
  const std::vector<Cell> cells = this->Whole.CellsAt(face, 3);
  return this->Given.Singular.count(face) > 0 ||
    (cells.size() == 2 && cells[0].Material != cells[1].Material);
}

std::vector<Cell> Strata::SingularFacesAt(const Ids& side, int dimensionOfSide) const
{
  std::vector<Cell> faces;
  for (const Cell& face : this->FacesAt(side, dimensionOfSide))
  {
    if (this->IsSingularFace(Sorted(face.Corners)))
    {
      faces.push_back(face);
    }
  }
  return faces;
}

std::vector<Cell> Strata::BoundaryFacesAt(const Ids& side, int dimensionOfSide) const
{
  std::vector<Cell> faces;
  for (const Cell& face : this->FacesAt(side, dimensionOfSide))
  {
    if (this->Whole.CellsAt(Sorted(face.Corners), 3).size() == 1)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

bool Strata::IsCrease(const Ids& edge) const
{
  const std::vector<Cell> surfaces = this->Whole.CellsAt(edge, 2);
  const std::size_t singular = this->SingularFacesAt(edge, 1).size();
  return this->Given.Singular.count(edge) > 0 || (singular != 0 && singular != 2) ||
    (surfaces.size() == 2 && surfaces[0].Material != surfaces[1].Material &&
      this->Whole.CellsAt(edge, 3).empty());
}

Stratum Strata::OfEdge(const Ids& edge) const
{
  const Cell line = { Type::Line, edge };
  if (this->IsCrease(edge))
  {
    return { 1, false, { line }, {} };
  }
  const std::vector<Cell> singular = this->SingularFacesAt(edge, 1);
  if (singular.size() == 2)
  {
    return { 2, false, singular, {} };
  }
  if (this->IsJoint(edge, 1))
  {
    return this->Given.Joint == Joints::Sharp ? Stratum{ 1, false, { line }, {} }
                                              : Stratum{ 3, true, {}, {} };
  }
  const int k = this->DimensionsAt(edge).front();
  const Place place = this->PlaceOf(edge, 1, k);
  if (k == 1 || (k == 2 && place == Place::Boundary))
  {
    return { 1, false, { line }, {} };
  }
  if (k == 3 && place == Place::Boundary)
  {
    return { 2, false, this->BoundaryFacesAt(edge, 1), {} };
  }
  Stratum stratum = { k, false, this->Whole.CellsAt(edge, k), {} };
  int q = 0;
  int t = 0;
  if (k == 3 && IsProduct(stratum.Parts, edge, q, t))
  {
    stratum.Weight = Relaxation(q, t, this->Given.HasLoopWeights);
  }
  return stratum;
}

Stratum Strata::OfQuad(const Ids& quad) const
{
  const std::vector<Cell> cells = this->Whole.CellsAt(quad, 3);
  const bool isFlat = this->IsSingularFace(quad) || cells.size() < 2 ||
    (cells.size() > 2 && this->Given.Joint == Joints::Sharp);
  return isFlat ? Stratum{ 2, false, { this->Whole.GetSides(2).at(quad) }, {} }
                : Stratum{ 3, false, cells, {} };
}

bool Strata::IsDart(int vertex) const
{
  const std::vector<Cell> edges = this->EdgesAt(vertex);
  const bool isOnRim = std::any_of(edges.begin(), edges.end(),
    [this](const Cell& edge) { return this->Whole.CellsAt(Sorted(edge.Corners), 2).size() == 1; });
  // A line ends at its boundary too.
  return this->Given.HasDarts && !isOnRim && this->Whole.CellsAt({ vertex }, 1).size() != 1;
}

Stratum Strata::InSurface(const std::vector<Cell>& faces) const
{
  return { 2, false, faces, {},
    Relaxation(
      Count(faces, Type::Quad), Count(faces, Type::Triangle), this->Given.HasLoopWeights) };
}

Stratum Strata::OfVertex(int vertex) const
{
  const Stratum corner;
  std::vector<Cell> creases;
  for (const Cell& edge : this->EdgesAt(vertex))
  {
    if (this->IsCrease(Sorted(edge.Corners)))
    {
      creases.push_back(edge);
    }
  }
  const std::vector<int> dimensions = this->DimensionsAt({ vertex });
  if (this->Given.Singular.count({ vertex }) > 0 || dimensions.empty())
  {
    return corner;
  }
  if (!creases.empty() && !(creases.size() == 1 && this->IsDart(vertex)))
  {
    return creases.size() == 2 ? Stratum{ 1, false, creases, {} } : corner;
  }
  const std::vector<Cell> singular = this->SingularFacesAt({ vertex }, 0);
  if (!singular.empty())
  {
    // Each edge but that of a dart has none or two of them.
    const std::size_t atDart =
      creases.empty() ? 0 : this->SingularFacesAt(Sorted(creases[0].Corners), 1).size();
    const bool isClosed = CountPieces(singular, { vertex }, 0) == 1 && (atDart == 0 || atDart == 2);
    return isClosed ? this->InSurface(singular) : corner;
  }
  if (this->IsJoint({ vertex }, 0))
  {
    return this->AtJoint(vertex);
  }
  const int k = dimensions.front();
  const std::vector<Cell> cells = this->Whole.CellsAt({ vertex }, k);
  if (this->PlaceOf({ vertex }, 0, k) == Place::Interior)
  {
    return k == 3 ? this->InSolids(vertex)
      : k == 2    ? this->InSurface(cells)
                  : Stratum{ 1, false, cells, {} };
  }
  if (k == 3)
  {
    return this->InSurface(this->BoundaryFacesAt({ vertex }, 0));
  }
  Stratum curve = { k - 1, false, {}, {} };
  for (const Cell& edge : this->EdgesAt(vertex))
  {
    if (k == 2 && this->Whole.CellsAt(Sorted(edge.Corners), 2).size() == 1)
    {
      curve.Parts.push_back(edge);
    }
  }
  return curve;
}

Stratum Strata::AtJoint(int vertex) const
{
  if (this->Given.Joint == Joints::Blend)
  {
    return { 3, true, {}, {} };
  }
  Stratum curve = { 1, false, {}, {} };
  const auto known = this->Given.Curves.find(vertex);
  for (std::size_t i = 0; known != this->Given.Curves.end() && i < 2; ++i)
  {
    curve.Parts.push_back({ Type::Line, Sorted({ vertex, known->second[i] }) });
  }
  if (!curve.Parts.empty())
  {
    return curve;
  }
  for (const Cell& edge : this->EdgesAt(vertex))
  {
    if (!this->IsCrease(Sorted(edge.Corners)) && this->IsJoint(Sorted(edge.Corners), 1))
    {
      curve.Parts.push_back(edge);
    }
  }
  return curve.Parts.size() == 2 ? curve : Stratum();
}

Stratum Strata::InSolids(int vertex) const
{
  Stratum stratum = { 3, false, this->Whole.CellsAt({ vertex }, 3), {} };
  std::map<std::pair<int, int>, std::vector<Cell>> axes;
  for (const Cell& edge : this->EdgesAt(vertex))
  {
    int q = 0;
    int t = 0;
    const Ids key = Sorted(edge.Corners);
    if (IsProduct(this->Whole.CellsAt(key, 3), key, q, t))
    {
      axes[{ q, t }].push_back(edge);
    }
  }
  for (const auto& [count, edges] : axes)
  {
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const bool isColumn = std::all_of(stratum.Parts.begin(), stratum.Parts.end(),
          [&](const Cell& cell)
          {
            return HasSide(cell, Sorted(edges[i].Corners), 1) !=
              HasSide(cell, Sorted(edges[j].Corners), 1);
          });
        if (isColumn)
        {
          stratum.Along = { edges[i], edges[j] };
          stratum.Weight = Relaxation(count.first, count.second, this->Given.HasLoopWeights);
        }
      }
    }
  }
  return stratum;
}

double Relaxation(int q, int t, bool hasLoopWeights)
{
  if (q == 0 && hasLoopWeights)
  {
    return 8. / 3 * (5. / 8 - std::pow(3. / 8 + std::cos(2. * std::acos(-1.) / t) / 4, 2));
  }
  const double sum = 3. * q + 2. * t;
  return q == 0 && t == 3 ? 1.5 : (36. * q / sum + 2. * t) / sum;
}

}
