// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridPatch.h"

#include "Core/Memory/Ids.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace subdivision
{
namespace
{

using Middles = std::array<std::array<int, 8>, 8>;

Middles FindMiddles(CellShape shape)
{
  const CellTable& table = GetCellTable(shape);
  Middles middles{};
  for (int i = 0; i < table.Corners; ++i)
  {
    for (int j = 0; j < table.Corners; ++j)
    {
      const auto hasBoth = [i, j](const std::vector<unsigned char>& corners)
      {
        return std::count(corners.begin(), corners.end(), i) > 0 &&
          std::count(corners.begin(), corners.end(), j) > 0;
      };
      // Corners, edges, quads, the centre: the first one is the smallest.
      const auto found =
        std::find_if(table.PointCorners.begin(), table.PointCorners.end(), hasBoth);
      middles[i][j] = static_cast<int>(found - table.PointCorners.begin());
    }
  }
  return middles;
}

template <typename Id>
int FindPlace(const Id* corners, Id vertex)
{
  const Id* place = corners;
  while (*place != vertex)
  {
    ++place;
  }
  return static_cast<int>(place - corners);
}

template <typename List>
bool Contains(const List& list, int item)
{
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// The local edges and faces of a type that have a corner.
struct PartsAtCorner
{
  std::vector<std::size_t> Edges;
  std::vector<std::size_t> Faces;
};

PartsAtCorner FindPartsAt(const CellTable& table, int corner)
{
  PartsAtCorner parts;
  const auto list = [corner](const auto& of, std::vector<std::size_t>& at)
  {
    for (std::size_t k = 0; k < of.size(); ++k)
    {
      Contains(of[k], corner) ? at.push_back(k) : void();
    }
  };
  list(table.Edges, parts.Edges);
  list(table.Faces, parts.Faces);
  return parts;
}

const PartsAtCorner& GetPartsAt(CellShape shape, int corner)
{
  static const auto all = []
  {
    std::array<std::array<PartsAtCorner, 8>, NumberOfShapes> made;
    for (std::size_t s = 0; s < NumberOfShapes; ++s)
    {
      for (int i = 0; i < 8; ++i)
      {
        made[s][static_cast<std::size_t>(i)] =
          FindPartsAt(GetCellTable(static_cast<CellShape>(s)), i);
      }
    }
    return made;
  }();
  return all[static_cast<std::size_t>(shape)][static_cast<std::size_t>(corner)];
}

int GetCode(const Decision& decision)
{
  return static_cast<int>(decision.Result.GetRule()) | static_cast<int>(decision.Ring) << 4 |
    decision.Dimensions << 8;
}

}

int GetMiddle(CellShape shape, int i, int j)
{
  static const std::array<Middles, NumberOfShapes> all = []
  {
    std::array<Middles, NumberOfShapes> made{};
    for (int s = 0; s < NumberOfShapes; ++s)
    {
      made[static_cast<std::size_t>(s)] = FindMiddles(static_cast<CellShape>(s));
    }
    return made;
  }();
  return all[static_cast<std::size_t>(shape)][static_cast<std::size_t>(i)]
            [static_cast<std::size_t>(j)];
}

template <typename Id>
StarCell<Id> GetStarCell(const CellComplex<Id>& complex, vtkIdType cell, Id vertex)
{
  const Id* corners = complex.Cells.GetCorners(cell);
  return { complex.Cells.Shapes[cell], FindPlace(corners, vertex), corners,
    complex.CellEdges[cell].begin(), complex.CellFaces[cell].begin(), complex.Centres[cell] };
}

template <typename Id>
vtkIdType GetNewPoint(const CellComplex<Id>& complex, const StarCell<Id>& cell, int point)
{
  const CellPart part = cell.GetTable().Points[static_cast<std::size_t>(point)];
  const vtkIdType edges = complex.NumberOfVertices;
  const vtkIdType quads = edges + complex.NumberOfEdges;
  switch (part.Kind)
  {
    case CellPart::AtCorner:
      return cell.Corners[part.Index];
    case CellPart::InEdge:
      return edges + cell.Edges[part.Index];
    case CellPart::InFace:
      return quads + cell.Faces[part.Index];
    default:
      return quads + complex.NumberOfQuads + cell.Centre;
  }
}

template <typename Id>
void HybridPatch<Id>::ReadStar(Id vertex)
{
  this->Cells.clear();
  this->Numbers.Clear();
  this->Numbers.GetNumber(vertex);
  this->Known = 1;
  this->AddCellsAt(vertex);
  this->ReadExceptions();
  this->WriteKey();
}

template <typename Id>
void HybridPatch<Id>::ReadLayers(const StarCell<Id>& cell, int layers)
{
  const Id* allCorners = this->Here.Complex.Cells.Corners.data();
  // Solids are what their corners are, others their face or edge.
  const auto getName = [allCorners](const StarCell<Id>& of)
  {
    const int dimension = of.GetTable().Dimension;
    return 3 *
      (dimension == 3      ? vtkIdType(of.Corners - allCorners)
          : dimension == 2 ? vtkIdType(*of.Faces)
                           : vtkIdType(*of.Edges)) +
      dimension % 3;
  };
  const auto number = [this](const StarCell<Id>& of)
  {
    for (int i = 0; i < of.GetTable().Corners; ++i)
    {
      this->Numbers.GetNumber(of.Corners[i]);
    }
  };
  this->Cells.assign(1, cell);
  this->Numbers.Clear();
  number(cell);
  VertexNumbers<vtkIdType> names;
  names.GetNumber(getName(cell));
  this->Known = 0;
  for (int layer = 0; layer < layers; ++layer)
  {
    const std::size_t before = this->Known;
    this->Known = this->Numbers.Vertices.size();
    for (std::size_t v = before; v < this->Known; ++v)
    {
      std::size_t end = this->Cells.size();
      this->AddCellsAt(this->Numbers.Vertices[v]);
      for (std::size_t c = end; c < this->Cells.size(); ++c)
      {
        const std::size_t known = names.Vertices.size();
        names.GetNumber(getName(this->Cells[c]));
        if (names.Vertices.size() > known)
        {
          number(this->Cells[c]);
          this->Cells[end++] = this->Cells[c];
        }
      }
      this->Cells.resize(end);
    }
  }
  this->ReadExceptions();
  this->WriteKey();
}

template <typename Id>
void HybridPatch<Id>::AddCellsAt(Id vertex)
{
  const CellComplex<Id>& complex = this->Here.Complex;
  const auto add = [&](CellShape shape, const Id* corners, const Id* edges, const Id* faces)
  { this->Cells.push_back({ shape, FindPlace(corners, vertex), corners, edges, faces, Id(-1) }); };
  for (const Id cell : complex.VertexSolids[vertex])
  {
    this->Cells.push_back(GetStarCell(complex, cell, vertex));
  }
  for (const Id& edge : complex.VertexEdges[vertex])
  {
    const Row<Id> faces = complex.EdgeFaces[edge];
    for (const Id& face : faces)
    {
      const Row<Id> corners = complex.GetVertices(face);
      // Each face once, at the edge to its next vertex.
      if (complex.FaceSolids[face].size() == 0 &&
        complex.GetEdges(face)
            .begin()[std::find(corners.begin(), corners.end(), vertex) - corners.begin()] == edge)
      {
        add(corners.size() == 3 ? CellShape::Triangle : CellShape::Quad, corners.begin(),
          complex.GetEdges(face).begin(), &face);
      }
    }
    if (faces.size() == 0)
    {
      add(CellShape::Line, complex.EdgeVertices.data() + 2 * vtkIdType(edge), &edge, nullptr);
    }
  }
}

/// Calls onEdge and onFace for the local edges and faces of a cell that have a known corner.
template <typename Id>
template <typename ActOnEdge, typename ActOnFace>
void HybridPatch<Id>::ForParts(
  const StarCell<Id>& cell, const ActOnEdge& onEdge, const ActOnFace& onFace) const
{
  if (this->Known == 1)
  {
    const PartsAtCorner& parts = GetPartsAt(cell.Shape, cell.Place);
    std::for_each(parts.Edges.begin(), parts.Edges.end(), onEdge);
    std::for_each(parts.Faces.begin(), parts.Faces.end(), onFace);
    return;
  }
  const CellTable& table = cell.GetTable();
  std::array<bool, 8> isKnown{};
  for (int i = 0; i < table.Corners; ++i)
  {
    isKnown[static_cast<std::size_t>(i)] = this->IsKnown(cell, i);
  }
  const auto act = [&isKnown](const auto& parts, const auto& on)
  {
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      std::any_of(parts[k].begin(), parts[k].end(), [&](int i) { return isKnown[i]; }) ? on(k)
                                                                                       : void();
    }
  };
  act(table.Edges, onEdge);
  act(table.Faces, onFace);
}

/// Calls act(known vertex, edge at it).
template <typename Id>
template <typename Act>
void HybridPatch<Id>::ForEdgesAtKnown(const Act& act) const
{
  for (std::size_t v = 0; v < this->Known; ++v)
  {
    const Id vertex = this->Numbers.Vertices[v];
    for (const Id edge : this->Here.Complex.VertexEdges[vertex])
    {
      act(vertex, edge);
    }
  }
}

/// Ends of sectors at other vertices, and members of rings of Blend edges outside of faces, change
/// the first step. Sectors of semi-sharp creases count as such.
template <typename Id>
void HybridPatch<Id>::ReadExceptions()
{
  this->HasSectors = this->Changes = false;
  this->SharpSteps = 0.;
  for (std::size_t v = 0; v < this->Known && !this->Here.Sharpness.Stages.empty(); ++v)
  {
    this->SharpSteps = std::max(this->SharpSteps,
      this->Here.Sharpness.GetMost(this->Here.Complex, this->Numbers.Vertices[v]));
  }
  const auto read = [this](const HybridStrata<Id>& strata, bool isSharp)
  {
    if (strata.Reliefs.empty() && strata.Sectors.empty())
    {
      return;
    }
    this->ForEdgesAtKnown(
      [&](Id vertex, Id edge)
      {
        this->Changes = this->Changes ||
          (!strata.Reliefs.empty() && !strata.Reliefs[static_cast<std::size_t>(edge)].empty());
        for (const SectorEdge<Id>& sector : FindSectorEdges(strata.Sectors, edge))
        {
          const Id end = this->Here.Complex.EdgeVertices[2 * vtkIdType(edge) + sector.End];
          this->HasSectors = true;
          this->Changes = this->Changes || isSharp || sector.IsShared || end != vertex;
        }
      });
  };
  read(this->Here.Strata, false);
  for (const auto& stage : this->Here.Sharpness.Stages)
  {
    read(stage.Strata, true);
  }
}

template <typename Id>
void HybridPatch<Id>::WriteKey()
{
  this->Key.assign({ static_cast<int>(this->Known), this->Changes ? 1 : 0 });
  for (const StarCell<Id>& cell : this->Cells)
  {
    this->Key.push_back(static_cast<int>(cell.Shape) | cell.Place << 4);
    for (int i = 0; i < cell.GetTable().Corners; ++i)
    {
      this->Key.push_back(static_cast<int>(this->Numbers.GetNumber(cell.Corners[i])));
    }
  }
  this->WriteVertices(this->Here.Strata);
  for (const StarCell<Id>& cell : this->Cells)
  {
    this->WriteRules(cell, this->Here.Strata);
  }
  if (this->SharpSteps <= 0.)
  {
    return;
  }
  const HybridSharpness<Id>& sharpness = this->Here.Sharpness;
  for (const auto& stage : sharpness.Stages)
  {
    this->Key.push_back(static_cast<int>(stage.Steps));
    this->WriteVertices(stage.Strata);
  }
  const auto write = [this](const std::vector<double>& left, Id item)
  {
    const double value = left.empty() ? 0. : left[static_cast<std::size_t>(item)];
    int bits[2] = {};
    static_assert(sizeof(bits) == sizeof(double), "a double is two numbers");
    std::memcpy(bits, &value, sizeof(bits));
    this->Key.insert(this->Key.end(), bits, bits + 2);
  };
  for (const StarCell<Id>& cell : this->Cells)
  {
    for (const auto& stage : sharpness.Stages)
    {
      this->WriteRules(cell, stage.Strata);
    }
    this->ForParts(
      cell, [&](std::size_t k) { write(sharpness.Left.Edges, cell.Edges[k]); },
      [&](std::size_t k) { write(sharpness.Left.Faces, cell.Faces[k]); });
  }
}

/// Writes the rules of known vertices.
template <typename Id>
void HybridPatch<Id>::WriteVertices(const HybridStrata<Id>& strata)
{
  for (std::size_t v = 0; v < this->Known; ++v)
  {
    const Id vertex = this->Numbers.Vertices[v];
    const Decision& decision = strata.Vertices[vertex];
    this->Key.insert(this->Key.end(), { GetCode(decision), decision.Part });
    if (decision.Result.GetRule() == Rule::Curve)
    {
      for (const Id end : strata.GetCurve(vertex).Ring)
      {
        this->Key.push_back(static_cast<int>(this->Numbers.Find(end)));
      }
    }
  }
}

/// Writes the rules of the parts of a cell; -1 if all are those of parts inside of solids.
template <typename Id>
void HybridPatch<Id>::WriteRules(const StarCell<Id>& cell, const HybridStrata<Id>& strata)
{
  constexpr int solid = static_cast<int>(Rule::Solid);
  static const int inSolid = GetCode(DecideIn(Rule::Solid, 0, DimensionBit(3)));
  bool isInside = true;
  this->Codes.clear();
  this->ForParts(
    cell,
    [&](std::size_t k)
    {
      const Decision& decision = strata.Edges[cell.Edges[k]];
      this->Codes.push_back(GetCode(decision));
      isInside = isInside && this->Codes.back() == inSolid;
      if (decision.Ring == RingKind::Part)
      {
        this->Codes.push_back(decision.Part);
      }
    },
    [&](std::size_t k)
    {
      const Id face = cell.Faces[k];
      const bool isSingular = !strata.SingularFaces.empty() && strata.SingularFaces[face];
      this->Codes.push_back(static_cast<int>(strata.Faces[face].GetRule()) | (isSingular ? 16 : 0));
      isInside = isInside && this->Codes.back() == solid;
      if (!strata.FaceParts.empty())
      {
        this->Codes.push_back(strata.FaceParts[face]);
      }
    });
  this->Key.push_back(isInside ? -1 : static_cast<int>(this->Codes.size()));
  if (!isInside)
  {
    this->Key.insert(this->Key.end(), this->Codes.begin(), this->Codes.end());
  }
}

template <typename Id>
HybridLevel<Id> HybridPatch<Id>::MakeLevel() const
{
  CellList<Id> list;
  list.NumberOfPoints = static_cast<vtkIdType>(this->Numbers.Vertices.size());
  const auto size = static_cast<vtkIdType>(this->Cells.size());
  list.Shapes = Buffer<CellShape>(size);
  list.Offsets = Buffer<Id>(size + 1, Id(0));
  std::vector<Id> corners;
  for (vtkIdType c = 0; c < size; ++c)
  {
    const StarCell<Id>& cell = this->Cells[static_cast<std::size_t>(c)];
    list.Shapes[c] = cell.Shape;
    for (int i = 0; i < cell.GetTable().Corners; ++i)
    {
      corners.push_back(static_cast<Id>(this->Numbers.Find(cell.Corners[i])));
    }
    list.Offsets[c + 1] = static_cast<Id>(corners.size());
  }
  list.Corners = Buffer<Id>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), list.Corners.begin());
  HybridLevel<Id> level;
  level.Complex = BuildCellComplex(std::move(list));
  this->CopyStrata(this->Here.Strata, level.Complex, level.Strata);
  this->CopySharpness(level);
  return level;
}

template <typename Id>
void HybridPatch<Id>::CopyStrata(
  const HybridStrata<Id>& from, const CellComplex<Id>& complex, HybridStrata<Id>& strata) const
{
  const Decision inSolid = DecideIn(Rule::Solid, 0, DimensionBit(3));
  strata.Weights = from.Weights;
  strata.Vertices =
    Buffer<Decision>(complex.NumberOfVertices, Decide(Rule::Corner, 0, RingKind::None));
  strata.Edges = Buffer<Decision>(complex.NumberOfEdges, inSolid);
  strata.Faces = Buffer<Stratum>(complex.NumberOfFaces, Stratum(Rule::Solid));
  const auto start = [](const auto& like, auto& made, Id size, auto value)
  { made = std::decay_t<decltype(made)>(like.empty() ? 0 : vtkIdType(size), value); };
  start(from.SingularFaces, strata.SingularFaces, complex.NumberOfFaces, (unsigned char)(0));
  start(from.EdgeParts, strata.EdgeParts, complex.NumberOfEdges, -1);
  start(from.FaceParts, strata.FaceParts, complex.NumberOfFaces, -1);
  const auto copy = [](const auto& like, auto& made, Id to, Id item)
  {
    if (!made.empty())
    {
      made[to] = like[item];
    }
  };
  std::vector<CurveVertex<Id>> curves;
  for (std::size_t v = 0; v < this->Known; ++v)
  {
    const Id vertex = this->Numbers.Vertices[v];
    strata.Vertices[static_cast<vtkIdType>(v)] = from.Vertices[vertex];
    if (from.Vertices[vertex].Result.GetRule() == Rule::Curve)
    {
      const Id* ring = from.GetCurve(vertex).Ring;
      curves.push_back({ static_cast<Id>(v),
        { static_cast<Id>(this->Numbers.Find(ring[0])),
          static_cast<Id>(this->Numbers.Find(ring[1])) } });
    }
  }
  strata.Curves = Buffer<CurveVertex<Id>>(static_cast<vtkIdType>(curves.size()));
  std::copy(curves.begin(), curves.end(), strata.Curves.begin());
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    const StarCell<Id>& cell = this->Cells[c];
    const Id* edges = complex.CellEdges[static_cast<vtkIdType>(c)].begin();
    const Id* faces = complex.CellFaces[static_cast<vtkIdType>(c)].begin();
    this->ForParts(
      cell,
      [&](std::size_t k)
      {
        copy(from.Edges, strata.Edges, edges[k], cell.Edges[k]);
        copy(from.EdgeParts, strata.EdgeParts, edges[k], cell.Edges[k]);
      },
      [&](std::size_t k)
      {
        copy(from.Faces, strata.Faces, faces[k], cell.Faces[k]);
        copy(from.SingularFaces, strata.SingularFaces, faces[k], cell.Faces[k]);
        copy(from.FaceParts, strata.FaceParts, faces[k], cell.Faces[k]);
      });
  }
  this->CopySectors(from, complex, strata);
}

template <typename Id>
void HybridPatch<Id>::CopySectors(
  const HybridStrata<Id>& from, const CellComplex<Id>& complex, HybridStrata<Id>& strata) const
{
  if (from.Sectors.empty())
  {
    return;
  }
  const CellComplex<Id>& all = this->Here.Complex;
  const auto number = [this](Id vertex) { return static_cast<Id>(this->Numbers.Find(vertex)); };
  this->ForEdgesAtKnown(
    [&](Id vertex, Id edge)
    {
      for (SectorEdge<Id> sector : FindSectorEdges(from.Sectors, edge))
      {
        if (all.EdgeVertices[2 * vtkIdType(edge) + sector.End] == vertex)
        {
          const Id end = number(vertex);
          const Id other = number(all.GetOtherEnd(edge, vertex));
          sector.Edge = complex.FindEdge(end, other);
          sector.End = end < other ? 0 : 1;
          for (int i = 0; i < 2 && sector.Bounds[i] >= 0; ++i)
          {
            sector.Ends[i] = number(sector.Ends[i]);
            sector.Bounds[i] = complex.FindEdge(end, sector.Ends[i]);
          }
          strata.Sectors.push_back(sector);
        }
      }
    });
  std::sort(strata.Sectors.begin(), strata.Sectors.end(),
    [](const SectorEdge<Id>& a, const SectorEdge<Id>& b)
    { return a.Edge != b.Edge ? a.Edge < b.Edge : a.End < b.End; });
}

template <typename Id>
void HybridPatch<Id>::CopySharpness(HybridLevel<Id>& level) const
{
  if (this->SharpSteps <= 0.)
  {
    return;
  }
  const HybridSharpness<Id>& from = this->Here.Sharpness;
  HybridSharpness<Id>& sharpness = level.Sharpness;
  for (const auto& stage : from.Stages)
  {
    sharpness.Stages.push_back({ stage.Steps, {} });
    this->CopyStrata(stage.Strata, level.Complex, sharpness.Stages.back().Strata);
  }
  const auto copy = [](const std::vector<double>& left, Id item, Id to, std::vector<double>& made)
  {
    if (!left.empty())
    {
      made[static_cast<std::size_t>(to)] = left[static_cast<std::size_t>(item)];
    }
  };
  const auto start = [](const std::vector<double>& left, Id size)
  { return std::vector<double>(left.empty() ? 0 : static_cast<std::size_t>(size), 0.); };
  sharpness.Left.Edges = start(from.Left.Edges, level.Complex.NumberOfEdges);
  sharpness.Left.Faces = start(from.Left.Faces, level.Complex.NumberOfFaces);
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    const StarCell<Id>& cell = this->Cells[c];
    const Id* edges = level.Complex.CellEdges[static_cast<vtkIdType>(c)].begin();
    const Id* faces = level.Complex.CellFaces[static_cast<vtkIdType>(c)].begin();
    this->ForParts(
      cell,
      [&](std::size_t k) { copy(from.Left.Edges, cell.Edges[k], edges[k], sharpness.Left.Edges); },
      [&](std::size_t k) { copy(from.Left.Faces, cell.Faces[k], faces[k], sharpness.Left.Faces); });
  }
}

SUBDIVISION_COMPILE_FUNCTION(GetStarCell);
SUBDIVISION_COMPILE_FUNCTION(GetNewPoint);
SUBDIVISION_COMPILE(class HybridPatch);

}
