// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/RegularLimits.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LimitRowMaker.h"
#include "Core/Solids/Limits/RingFinder.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace subdivision
{
namespace
{

/// Kinds. Behind these are the kinds of midpoints inside solids and faces, then those of the
/// vertices after the first step.
constexpr int Irregular = -1;
constexpr int OnSurface = 0;
constexpr int OnCurve = 1;
constexpr int Staying = 2;
constexpr int InSolid = 3;
constexpr int KindsOfShape = 16; ///< midpoints of its inner edges, and the centre as the last one
constexpr int InFace = InSolid + 2 * KindsOfShape;
constexpr int SidesOfFace = 64 + 216; ///< places of three corners in a tetrahedron or octahedron
constexpr int FirstOwn = InFace + 3 * SidesOfFace * SidesOfFace;

constexpr std::array<double, 1> StayingWeights{ 1. };

template <typename Rows>
struct SplitOfRows;
template <typename Split>
struct SplitOfRows<ChildRows<Split>>
{
  using Type = Split;
};
template <typename Level>
using SplitOf = typename SplitOfRows<typename SchemeOf<Level>::ChildRows>::Type;

/// How a solid at a face, named as in FaceTets, numbers the corners of the face.
template <typename Level>
int GetSideOfFace(const Level& level, typename Level::IdType face, typename Level::IdType cell)
{
  using Split = SplitOf<Level>;
  const auto* corners = level.Complex.FaceVertices.data() + 3 * vtkIdType(face);
  const auto numbers = Split::CountSolids(level);
  int side = -1;
  int before = 0;
  ForShapes(typename Split::Shapes(),
    [&](auto shape)
    {
      using Shape = decltype(shape);
      constexpr int n = Shape::Vertices;
      if (side < 0 && cell < numbers[Shape::Index])
      {
        const auto* vertices = Split::GetSolids(level, shape).Vertices + n * vtkIdType(cell);
        side = before + FindPlace<n>(vertices, corners[0]) +
          n * (FindPlace<n>(vertices, corners[1]) + n * FindPlace<n>(vertices, corners[2]));
      }
      cell -= numbers[Shape::Index];
      before += n * n * n;
    });
  return side;
}

/// The kind of the midpoint of the first of three edges that a step makes inside a face.
template <typename Level>
int GetKindInFace(const Level& level, typename Level::IdType face)
{
  const Rule rule = level.Strata.Faces[face].GetRule();
  const auto cells = level.Complex.FaceTets[face];
  return rule == Rule::Surface                 ? OnSurface
    : rule == Rule::Curve                      ? OnCurve
    : rule != Rule::Solid || cells.size() != 2 ? Irregular
                                               : InFace +
      3 *
        (GetSideOfFace(level, face, cells.begin()[0]) * SidesOfFace +
          GetSideOfFace(level, face, cells.begin()[1]));
}

/// Makes the rows of FindNextLimits.
template <typename Level>
class NextLimits
{
public:
  using Id = typename Level::IdType;
  using Split = SplitOf<Level>;

  NextLimits(const Level& level, const LimitKinds<Id>& kinds)
    : Here(level)
    , Kinds(kinds)
    , Emitter(level)
    , Numbers(level)
    , NumberOfVertices(level.Complex.NumberOfVertices)
    , NumberOfEdges(level.Complex.NumberOfEdges)
    , Of(Numbers.GetNumberOfVertices())
  {
    HasSolids(level) ? this->TakeKinds() : this->FindKinds();
    this->FindOthers();
  }
  vtkIdType GetNumberOfRows() const { return this->Of.size(); }
  void Append(vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
  {
    while (begin < end)
    {
      begin += this->AppendRun(begin, end - begin, RegularSurfaceLimit, OnSurface, rows);
      begin += this->AppendRun(begin, end - begin, RegularCurveLimit, OnCurve, rows);
      for (; begin < end && this->Of[begin] != OnSurface && this->Of[begin] != OnCurve; ++begin)
      {
        this->AppendRow(begin, rows);
      }
    }
  }

private:
  struct Emit
  {
    RowBlock<Id>* Rows = nullptr; ///< null: leaves members out
    const double* Weights = nullptr;
    void operator()(Id, Id member)
    {
      if (this->Rows)
      {
        this->Rows->Add(member, *this->Weights++);
      }
    }
  };
  struct Write
  {
    Id* Members = nullptr;
    void operator()(Id, Id member)
    {
      if (this->Members)
      {
        *this->Members++ = member;
      }
    }
  };

  template <typename Act>
  void EmitRing(vtkIdType vertex, Act act) const;
  void FindKinds();
  void TakeKinds();
  void FindOthers();
  template <std::size_t N>
  vtkIdType AppendRun(vtkIdType begin, vtkIdType most, const std::array<double, N>& weights,
    int kind, RowBlock<Id>& rows) const
  {
    return rows.AddRun(weights, most,
      [&](vtkIdType i, Id* columns)
      {
        const vtkIdType vertex = begin + i;
        if (this->Of[vertex] != kind)
        {
          return false;
        }
        columns[0] = static_cast<Id>(vertex);
        this->EmitRing(vertex, Write{ columns + 1 });
        return true;
      });
  }
  void AppendRow(vtkIdType vertex, RowBlock<Id>& rows) const;
  /// The first weight of a kind.
  const double* GetWeights(Id kind) const
  {
    return kind == OnSurface ? RegularSurfaceLimit.data()
      : kind == OnCurve      ? RegularCurveLimit.data()
      : kind == Staying      ? StayingWeights.data()
      : kind >= FirstOwn     ? GetRow(this->Kinds.Own, kind - FirstOwn)
                             : GetRow(this->Others, this->Rows[kind]);
  }
  static const double* GetRow(const SparseRows<Id>& rows, vtkIdType row)
  {
    return rows.Weights.data() + rows.Offsets[row];
  }

  const Level& Here;
  const LimitKinds<Id>& Kinds;
  const RingEmitter<Split> Emitter;
  const ChildIds<Split> Numbers;
  const vtkIdType NumberOfVertices;
  const vtkIdType NumberOfEdges;
  Buffer<Id> Of; ///< the kind of each vertex
  /// Rows of vertices that have no kind, and of one vertex of each kind before FirstOwn.
  SparseRows<Id> Others;
  std::vector<Id> OtherVertices; ///< whose rows these are, sorted
  std::vector<Id> Rows;          ///< of Others, by kind
};

/// Calls act(carrier, member) for the ring of a vertex.
template <typename Level>
template <typename Act>
void NextLimits<Level>::EmitRing(vtkIdType vertex, Act act) const
{
  const vtkIdType edge = vertex - this->NumberOfVertices;
  vtkIdType centre = edge - this->NumberOfEdges;
  if (edge < 0)
  {
    this->Emitter.EmitVertex(static_cast<Id>(vertex), act);
  }
  else if (centre < 0)
  {
    Act halves[2];
    this->Emitter.EmitAtEdge(static_cast<Id>(edge), halves, act);
  }
  else
  {
    ForShapes(typename Split::Shapes(),
      [&](auto shape)
      {
        if constexpr (decltype(shape)::Centres > 0)
        {
          this->Emitter.template EmitCentre<decltype(shape)>(static_cast<Id>(centre), act);
        }
      });
  }
}

/// Finds kinds without solids.
template <typename Level>
void NextLimits<Level>::FindKinds()
{
  const RingFinder<Level> finder(this->Here, 0);
  const Strata<Id>& strata = this->Here.Strata;
  const auto isCurve = [&](Id edge) { return strata.Edges[edge].GetRule() == Rule::Curve; };
  ForEach(this->NumberOfVertices,
    [&](vtkIdType v)
    {
      const Rule rule = strata.Vertices[v].GetRule();
      const Row<Id> edges = strata.VertexRings.GetCarriers(v);
      Id ring[RegularRings<Id>::Size];
      this->Of[v] = rule == Rule::Corner ? Staying
        : rule == Rule::Curve && edges.size() == 2 && isCurve(edges.begin()[0]) &&
          isCurve(edges.begin()[1])
        ? OnCurve
        : finder.FindOld(static_cast<Id>(v), ring) >= 0 ? OnSurface
                                                        : Irregular;
    });
  ForEach(this->NumberOfEdges,
    [&](vtkIdType e)
    {
      Id ring[RegularRings<Id>::Size];
      this->Of[this->NumberOfVertices + e] = isCurve(static_cast<Id>(e)) ? OnCurve
        : finder.FindMidpoint(static_cast<Id>(e), ring) >= 0             ? OnSurface
                                                                         : Irregular;
    });
}

template <typename Level>
void NextLimits<Level>::TakeKinds()
{
  ForEach(this->NumberOfVertices, [&](vtkIdType v) { this->Of[v] = this->Kinds.Vertices[v]; });
  ForEach(this->NumberOfEdges,
    [&](vtkIdType e) { this->Of[this->NumberOfVertices + e] = this->Kinds.Edges[e]; });
  const vtkIdType centres = this->NumberOfVertices + this->NumberOfEdges;
  Fill(this->Of.data() + centres, this->Of.size() - centres, Id(InFace - 1));
  for (const SectorEdge<Id>& sector : this->Here.Strata.Sectors)
  {
    this->Of[this->NumberOfVertices + sector.Edge] = Irregular;
  }
}

/// Finds rows where the weights of a kind do not tell them, in the level itself around these.
template <typename Level>
void NextLimits<Level>::FindOthers()
{
  this->Rows.assign(HasSolids(this->Here) ? FirstOwn : 0, Id(-1));
  ForEachInTurn(this->Of.size(),
    [&](vtkIdType v)
    {
      const Id kind = this->Of[v];
      const bool isFirst = kind >= InSolid && kind < FirstOwn && this->Rows[kind] < 0;
      if (isFirst)
      {
        this->Rows[kind] = static_cast<Id>(this->OtherVertices.size());
      }
      if (isFirst || kind == Irregular)
      {
        this->OtherVertices.push_back(static_cast<Id>(v));
      }
    });
  if (this->OtherVertices.empty())
  {
    return;
  }
  Buffer<unsigned char> at(this->NumberOfVertices, 0);
  for (const Id vertex : InTurn(this->OtherVertices))
  {
    const vtkIdType edge = vertex - this->NumberOfVertices;
    const vtkIdType centre = edge - this->NumberOfEdges;
    const auto flag = [&](const Id* vertices, int count)
    { std::for_each(vertices, vertices + count, [&](Id v) { at[v] = 1; }); };
    if (edge < 0)
    {
      at[vertex] = 1;
    }
    else if (centre < 0)
    {
      flag(this->Here.Complex.EdgeVertices.data() + 2 * edge, 2);
    }
    ForShapes(typename Split::Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        if (Shape::Centres > 0 && centre >= 0)
        {
          flag(Split::GetSolids(this->Here, shape).Vertices + Shape::Vertices * centre,
            Shape::Vertices);
        }
      });
  }
  const RefinedPart<Level> part(this->Here, at);
  Buffer<Id> wanted(static_cast<vtkIdType>(this->OtherVertices.size()));
  ForEach(wanted.size(), [&](vtkIdType i) { wanted[i] = part.GetOwn(this->OtherVertices[i]); });
  this->Others = BuildLimitRows(part.GetNext(), {}, wanted);
  ForEach(this->Others.Columns.size(),
    [&](vtkIdType i) { this->Others.Columns[i] = part.GetWhole(this->Others.Columns[i]); });
}

template <typename Level>
void NextLimits<Level>::AppendRow(vtkIdType vertex, RowBlock<Id>& rows) const
{
  const Id kind = this->Of[vertex];
  if (kind == Irregular)
  {
    const auto row = std::lower_bound(this->OtherVertices.begin(), this->OtherVertices.end(),
                       static_cast<Id>(vertex)) -
      this->OtherVertices.begin();
    for (vtkIdType i = this->Others.Offsets[row]; i < this->Others.Offsets[row + 1]; ++i)
    {
      rows.Add(this->Others.Columns[i], this->Others.Weights[i]);
    }
  }
  else
  {
    const double* weights = this->GetWeights(kind);
    rows.Add(vertex, *weights);
    this->EmitRing(vertex, Emit{ &rows, weights + 1 });
  }
  rows.EndRow();
}

}

template <typename Id>
template <typename Level>
void LimitKinds<Id>::Refine(const Level& level)
{
  using Split = SplitOf<Level>;
  const ChildIds<Split> ids(level);
  const vtkIdType vertices = level.Complex.NumberOfVertices;
  const bool isFirst = this->Vertices.empty();
  Buffer<Id> ofVertices(ids.GetNumberOfVertices());
  Buffer<Id> ofEdges(ids.GetNumberOfEdges());
  ForEach(ofVertices.size(),
    [&](vtkIdType v)
    {
      const vtkIdType edge = v - vertices;
      ofVertices[v] = isFirst                ? static_cast<Id>(FirstOwn + v)
        : edge < 0                           ? this->Vertices[v]
        : edge < level.Complex.NumberOfEdges ? this->Edges[edge]
                                             : Id(InFace - 1);
    });
  ForEach(level.Complex.NumberOfEdges,
    [&](vtkIdType e) { ofEdges[2 * e] = ofEdges[2 * e + 1] = ofVertices[vertices + e]; });
  ForEach(level.Complex.NumberOfFaces,
    [&](vtkIdType f)
    {
      const int kind = GetKindInFace(level, static_cast<Id>(f));
      Id* edges = ofEdges.data() + ids.InFace(static_cast<Id>(f), 0);
      for (int corner = 0; corner < 3; ++corner)
      {
        edges[corner] = static_cast<Id>(kind < InFace ? kind : kind + corner);
      }
    });
  ForShapes(typename Split::Shapes(),
    [&](auto shape)
    {
      using Shape = decltype(shape);
      constexpr int inner = InnerEdgesOf<Shape>;
      ForEach(inner * vtkIdType(ids.GetNumberOfSolids(Shape::Index)),
        [&](vtkIdType i)
        {
          ofEdges[ids.template InnerEdge<Shape>(0, 0) + i] =
            static_cast<Id>(InSolid + KindsOfShape * Shape::Index + i % std::max(1, inner));
        });
    });
  this->Vertices = std::move(ofVertices);
  this->Edges = std::move(ofEdges);
}

template <typename Id>
template <typename Level>
void LimitKinds<Id>::FindOwn(const Level& level)
{
  this->Own = BuildLimitRows(level);
  Buffer<Id>& kinds = this->Vertices;
  const auto& strata = level.Strata;
  ForEach(kinds.size(),
    [&](vtkIdType v)
    {
      // A row that reads more, or in another order, is one of this level alone.
      const Row<Id> ring = strata.VertexRings.GetMembers(v);
      const Id* columns = this->Own.Columns.data() + this->Own.Offsets[v];
      const vtkIdType size = this->Own.Offsets[v + 1] - this->Own.Offsets[v];
      const bool isCorner = strata.Vertices[v].GetRule() == Rule::Corner;
      const bool isRing = size == 1 + static_cast<vtkIdType>(ring.size()) &&
        std::equal(ring.begin(), ring.end(), columns + 1);
      kinds[v] = isCorner ? Id(Staying) : isRing ? kinds[v] : Id(Irregular);
    });
  for (const SectorEdge<Id>& sector : strata.Sectors)
  {
    // Further steps do not read the other end's curve there.
    const Id* ends = level.Complex.EdgeVertices.data() + 2 * vtkIdType(sector.Edge);
    kinds[ends[1 - sector.End]] = Irregular;
  }
  ForEach(this->Edges.size(),
    [&](vtkIdType e)
    {
      const Id kind = this->Edges[e];
      this->Edges[e] = kind < FirstOwn ? kind : kinds[kind - FirstOwn];
    });
}

template <typename Level>
bool HasSolids(const Level& level)
{
  return level.Complex.NumberOfTets > 0 || SchemeOf<Level>::CountCentres(level) > 0;
}

template <typename Level>
BlockOperator<typename Level::IdType> FindNextLimits(
  const Level& level, const LimitKinds<typename Level::IdType>& kinds)
{
  using Id = typename Level::IdType;
  if constexpr (SchemeOf<Level>::Traits.HasTangents)
  {
    const auto limits = std::make_shared<const NextLimits<Level>>(level, kinds);
    return { limits->GetNumberOfRows(), limits->GetNumberOfRows(),
      [limits](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      { limits->Append(begin, end, rows); } };
  }
  const vtkIdType size = LevelRows<Id>(level).GetNumberOfRows();
  return { size, size, [](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
    { rows.AddCopies(begin, end - begin); } };
}

SUBDIVISION_COMPILE(struct LimitKinds);

#define SUBDIVISION_REGULAR_LIMITS(Scheme)                                                         \
  template void LimitKinds<Scheme::Id>::Refine(const Scheme::Level&);                              \
  template void LimitKinds<Scheme::Id>::FindOwn(const Scheme::Level&);                             \
  template bool HasSolids(const Scheme::Level&);                                                   \
  template BlockOperator<Scheme::Id> FindNextLimits(                                               \
    const Scheme::Level&, const LimitKinds<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_REGULAR_LIMITS);

}
