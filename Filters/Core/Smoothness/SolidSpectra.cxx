// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/SolidSpectra.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Smoothness/LocalMatrix.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LevelStar.h"

#include <algorithm>

namespace subdivision
{
namespace
{

Answer FindCondition(Rule rule, const std::vector<double>& moduli)
{
  switch (rule)
  {
    case Rule::Curve:
    case Rule::Surface:
      return HoldsInside(moduli, static_cast<int>(rule));
    case Rule::Solid:
    case Rule::RegularEdge:
      return HoldsInside(moduli, 3);
    default:
      return Answer::None;
  }
}

/// Reads the stars of vertices, and solves each kind of star once.
template <typename Level>
class SpectrumFinder
{
public:
  using Id = typename Level::IdType;
  using Star = LevelStar<SchemeOf<Level>>;

  explicit SpectrumFinder(const Level& level)
    : Here(level)
  {
  }

  SmoothnessFacts Find(Id vertex)
  {
    const StarRules<Id> rules = this->Here.GetRules();
    const Rule rule = rules.Strata.Vertices[vertex].GetRule();
    if (rule == Rule::Corner)
    {
      return SmoothnessFacts();
    }
    this->Keys.Clear();
    this->Local.assign(1, static_cast<int>(rule));
    const auto number = [this](Id key, Id)
    { return 1 + static_cast<int>(this->Keys.GetNumber(key)); };
    this->Here.ReadRow(rules, vertex, Id(-1), false, this->Local, number);
    for (std::size_t i = 0; i < this->Keys.Vertices.size(); ++i) // the list grows meanwhile
    {
      this->Here.ReadRow(rules, vertex, this->Keys.Vertices[i], false, this->Local, number);
    }
    const auto known = this->Solved.find(this->Local);
    if (known != this->Solved.end())
    {
      return known->second;
    }
    if (this->Solved.size() > 65536) // bounds the memory
    {
      this->Solved.clear();
    }
    return this->Solved.emplace(this->Local, this->Solve(rule)).first->second;
  }

private:
  SmoothnessFacts Solve(Rule rule) const
  {
    const int size = 1 + static_cast<int>(this->Keys.Vertices.size());
    SmoothnessFacts facts;
    facts.Valence = size - 1;
    if (size > LocalMatrix::MostItems)
    {
      facts.SetEigenvalues({});
      return facts;
    }
    LocalMatrix matrix(size);
    const int* row = this->Local.data() + 1;
    for (int i = 0; i < size; ++i)
    {
      this->Here.Weigh(row, i, [&](int item, double weight) { matrix.At(i, item) += weight; });
    }
    const std::vector<double> moduli = matrix.FindModuli();
    facts.SetEigenvalues(moduli);
    facts.Condition = FindCondition(rule, moduli);
    return facts;
  }

  const Star Here;
  std::unordered_map<Neighbourhood, SmoothnessFacts, HashNeighbourhood> Solved;
  VertexNumbers<Id> Keys; ///< of the current vertex; item i is key i - 1
  Neighbourhood Local;
};

/// The triangles of sheets at vertices that may end sheets, and how they hang together.
template <typename Level>
class SheetFinder
{
public:
  using Id = typename Level::IdType;

  explicit SheetFinder(const Level& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
  {
  }

  std::vector<Sheet> Find()
  {
    this->CollectFaces();
    for (const Id v : InTurn(this->Complex.NumberOfVertices))
    {
      this->Walk(v);
    }
    return std::move(this->Sheets);
  }

private:
  bool EndsSheets(Id vertex) const
  {
    return this->Strata.Vertices[vertex].GetRule() <= Rule::Curve;
  }

  /// Lists the faces of surfaces by their vertices where sheets may end, and all others at the end.
  void CollectFaces()
  {
    const auto& corners = this->Complex.FaceVertices;
    const vtkIdType vertices = this->Complex.NumberOfVertices;
    this->Faces = ListByRow<vtkIdType>(
      vertices + 1, corners.size(),
      [&](vtkIdType i)
      {
        const bool isWanted =
          this->Strata.Faces[i / 3].GetRule() == Rule::Surface && this->EndsSheets(corners[i]);
        return isWanted ? vtkIdType(corners[i]) : vertices;
      },
      [](vtkIdType i) { return i / 3; });
  }

  /// The face on the other side of an edge in its sheet; -1 at the sheet's end.
  Id Cross(Id edge, Id face) const
  {
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
    if (this->Strata.Edges[edge].GetRule() != Rule::Surface || faces.size() != 2)
    {
      return -1;
    }
    const Id* two = faces.begin();
    return two[0] == face ? two[1] : two[1] == face ? two[0] : -1;
  }

  /// The edges of a face at a vertex.
  std::array<Id, 2> GetEdgesAt(Id face, Id vertex) const
  {
    const int* at = triangle::EdgesAt[this->Complex.VertexInFace(face, vertex)];
    const Id* edges = this->Complex.FaceEdges.data() + 3 * vtkIdType(face);
    return { { edges[at[0]], edges[at[1]] } };
  }

  /// Goes on from a face over an edge, and marks the faces on the way. Returns the last edge.
  Id Follow(Id vertex, Id face, Id edge, std::vector<Id>& done)
  {
    for (Id next = this->Cross(edge, face);
      next >= 0 && std::find(done.begin(), done.end(), next) == done.end();
      next = this->Cross(edge, face))
    {
      done.push_back(next);
      face = next;
      edge = this->Complex.OtherEdge(face, edge, vertex);
    }
    return edge;
  }

  void Walk(Id vertex)
  {
    std::vector<Id> done;
    for (const vtkIdType at : this->Faces[vertex])
    {
      const Id face = static_cast<Id>(at);
      if (std::find(done.begin(), done.end(), face) != done.end())
      {
        continue;
      }
      const std::size_t before = done.size();
      done.push_back(face);
      const std::array<Id, 2> edges = this->GetEdgesAt(face, vertex);
      const Id last = this->Follow(vertex, face, edges[1], done);
      const Id first = this->Follow(vertex, face, edges[0], done);
      this->Add(vertex, static_cast<int>(done.size() - before), first, last);
    }
  }

  /// `first`, `last`: the edges at which the sheet ends.
  void Add(Id vertex, int triangles, Id first, Id last)
  {
    const bool isCorner = this->Strata.Vertices[vertex].GetRule() == Rule::Corner;
    const Row<Id> curve = this->Strata.VertexRings.GetCarriers(vertex);
    const auto isOwn = [&](Id edge)
    {
      return this->Strata.Edges[edge].GetRule() == Rule::Curve &&
        (isCorner || std::find(curve.begin(), curve.end(), edge) != curve.end());
    };
    if (first != last && isOwn(first) && isOwn(last))
    {
      this->Sheets.push_back({ vertex, triangles, isCorner });
    }
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  Rows<vtkIdType> Faces; ///< of each vertex
  std::vector<Sheet> Sheets;
};

}

template <typename Level>
void FindSpectra(const Level& level, vtkIdType size,
  const std::function<vtkIdType(vtkIdType)>& vertex, SmoothnessFacts* facts)
{
  using Id = typename Level::IdType;
  constexpr vtkIdType block = 256;
  vtkSMPThreadLocal<std::shared_ptr<SpectrumFinder<Level>>> finders;
  const auto find = [&](vtkIdType begin, vtkIdType end)
  {
    auto& finder = finders.Local();
    if (!finder)
    {
      finder = std::make_shared<SpectrumFinder<Level>>(level);
    }
    for (vtkIdType i = begin * block; i < std::min(size, end * block); ++i)
    {
      facts[i] = finder->Find(static_cast<Id>(vertex(i)));
    }
  };
  ForRangesOfBlocks((size + block - 1) / block, find);
}

template <typename Level>
std::vector<Sheet> FindSheets(const Level& level)
{
  return SheetFinder<Level>(level).Find();
}

SmoothnessFacts ExamineSheet(const Sheet& sheet, bool modified)
{
  const int last = sheet.Triangles + 1;
  SmoothnessFacts facts;
  facts.Valence = sheet.Triangles;
  if (last >= LocalMatrix::MostItems)
  {
    facts.SetEigenvalues({});
    return facts;
  }
  const double far =
    modified && !sheet.IsCorner ? GetFarEndWeight(Pi / sheet.Triangles) : PlainEndWeight;
  LocalMatrix matrix(1 + last);
  matrix.At(0, 0) = sheet.IsCorner ? 1. : 3. / 4.;
  matrix.At(0, 1) = matrix.At(0, last) = sheet.IsCorner ? 0. : 1. / 8.;
  for (int i = 1; i <= last; ++i)
  {
    const bool isEnd = i == 1 || i == last;
    matrix.At(i, 0) = matrix.At(i, i) = 1. / 2.;
    if (!isEnd)
    {
      matrix.At(i, 0) = 0.75 - far;
      matrix.At(i, i) = far;
      matrix.At(i, i - 1) = matrix.At(i, i + 1) = 1. / 8.;
    }
  }
  const std::vector<double> moduli = matrix.FindModuli();
  facts.SetEigenvalues(moduli);
  facts.Condition = HoldsBesideCurves(moduli, 1. / 2., sheet.IsCorner ? 2 : 1);
  return facts;
}

#define SUBDIVISION_SPECTRA(Scheme)                                                                \
  template void FindSpectra(const Scheme::Level&, vtkIdType,                                       \
    const std::function<vtkIdType(vtkIdType)>&, SmoothnessFacts*);                                 \
  template std::vector<Sheet> FindSheets(const Scheme::Level&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_SPECTRA);

}
