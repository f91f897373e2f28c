// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridStrata.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace subdivision
{
namespace
{

/// The rule of what lies inside of solids.
constexpr Decision InSolid = DecideIn(Rule::Solid, 0, DimensionBit(3));

/// Makes the list of curves: ring(v, curve) fills in the neighbours of a vertex with d = 1.
template <typename Id, typename Ring>
Buffer<CurveVertex<Id>> ListCurves(const Buffer<Decision>& vertices, const Ring& ring)
{
  Buffer<Id> places(vertices.size() + 1);
  ForEach(vertices.size(),
    [&](vtkIdType v) { places[v] = vertices[v].Result.GetRule() == Rule::Curve ? 1 : 0; });
  CountsToOffsets(places);
  Buffer<CurveVertex<Id>> curves(places[vertices.size()]);
  ForEach(vertices.size(),
    [&](vtkIdType v)
    {
      if (places[v] < places[v + 1])
      {
        curves[places[v]].Vertex = static_cast<Id>(v);
        ring(static_cast<Id>(v), curves[places[v]]);
      }
    });
  return curves;
}

/// The rule of edges inside a face.
template <typename Id>
Decision DecideInFace(const CellComplex<Id>& complex, const HybridStrata<Id>& strata, Id face)
{
  const Stratum stratum = strata.Faces[face];
  switch (stratum.GetRule())
  {
    case Rule::Surface:
    {
      const vtkIdType solids = complex.FaceSolids[face].size();
      const bool isSingular = !strata.SingularFaces.empty() && strata.SingularFaces[face];
      return isSingular ? Decide(Rule::Surface, stratum.GetType(), RingKind::SingularFaces)
        : solids == 0   ? DecideIn(Rule::Surface, stratum.GetType(), DimensionBit(2))
                        : Decide(Rule::Surface, stratum.GetType(), RingKind::BoundaryOfSolid);
    }
    case Rule::Curve:
      return Decide(Rule::Curve, stratum.GetType(), RingKind::SharpJoints);
    case Rule::Blend:
      return DecideIn(Rule::Blend, stratum.GetType(), AllDimensions);
    default:
      return InSolid;
  }
}

/// The rule of the middle of a quad: in one that is sharp four sharp edges meet there.
Decision DecideMiddle(Decision inFace)
{
  return inFace.Result.GetRule() == Rule::Curve
    ? Decide(Rule::Corner, inFace.Result.GetType(), RingKind::None)
    : inFace;
}

/// Calls act(part, cell, new edge or face) for each edge and face of the next level at its first
/// occurrence in a cell: `part` is where it lies in the parent `cell`.
template <typename Id, typename Parts, typename Act>
void ForParts(const CellComplex<Id>& complex, const Rows<Id>& items, const Buffer<Id>& firsts,
  const Parts& parts, const Act& act)
{
  const Buffer<Id> children = FindFirstChildren(complex.Cells);
  ForEach(complex.Cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      vtkIdType child = children[c];
      for (const CellChild& made : complex.Cells.GetTable(c).Children)
      {
        vtkIdType place = items.Offsets[child++];
        for (const CellPart& part : parts(made))
        {
          const Id item = items.Items[place];
          if (firsts[item] == place)
          {
            act(part, c, item);
          }
          ++place;
        }
      }
    });
}

template <typename Id>
class StrataRefiner
{
public:
  StrataRefiner(
    const CellComplex<Id>& complex, const HybridStrata<Id>& strata, const CellComplex<Id>& next)
    : Complex(complex)
    , Strata(strata)
    , Next(next)
  {
  }

  HybridStrata<Id> Refine()
  {
    this->Result.Weights = this->Strata.Weights;
    this->RefineVertices();
    this->RefineEdges();
    this->RefineFaces();
    this->Result.Curves = ListCurves<Id>(this->Result.Vertices,
      [this](Id vertex, CurveVertex<Id>& curve) { this->FindNeighbours(vertex, curve); });
    this->RefineSectors();
    return std::move(this->Result);
  }

private:
  void RefineVertices()
  {
    Buffer<Decision>& vertices = this->Result.Vertices;
    vertices = Buffer<Decision>(this->Next.NumberOfVertices, InSolid);
    CopyInThreads(this->Strata.Vertices.data(), this->Complex.NumberOfVertices, vertices.data());
    ForEach(this->Complex.NumberOfEdges, [&](vtkIdType e)
      { vertices[this->Complex.NumberOfVertices + e] = this->AtEdge(this->Strata.Edges[e]); });
    const vtkIdType first = vtkIdType(this->Complex.NumberOfVertices) + this->Complex.NumberOfEdges;
    ForEach(this->Complex.NumberOfQuads,
      [&](vtkIdType f)
      {
        vertices[first + f] =
          DecideMiddle(DecideInFace(this->Complex, this->Strata, static_cast<Id>(f)));
      });
  }
  /// The rule of the middle of an edge; lines of their own have no ring.
  Decision AtEdge(const Decision& edge) const
  {
    return edge.Ring == RingKind::None
      ? DecideIn(Rule::Curve, edge.Result.GetType(), DimensionBit(1))
      : edge;
  }

  void RefineEdges()
  {
    Buffer<Decision>& edges = this->Result.Edges;
    edges = Buffer<Decision>(this->Next.NumberOfEdges);
    const Buffer<int>& parts = this->Strata.EdgeParts;
    Buffer<int>& newParts = this->Result.EdgeParts;
    newParts = Buffer<int>(parts.empty() ? 0 : vtkIdType(this->Next.NumberOfEdges), -1);
    ForParts(
      this->Complex, this->Next.CellEdges, this->Next.EdgeFirsts,
      [](const CellChild& child) -> const auto& { return child.Edges; },
      [&](const CellPart& part, vtkIdType cell, Id edge)
      {
        if (part.Kind == CellPart::InEdge)
        {
          const Id parent = this->Complex.CellEdges[cell].begin()[part.Index];
          edges[edge] = this->Strata.Edges[parent];
          if (!parts.empty())
          {
            newParts[edge] = parts[parent];
          }
        }
        else
        {
          edges[edge] = part.Kind == CellPart::InFace
            ? DecideInFace(
                this->Complex, this->Strata, this->Complex.CellFaces[cell].begin()[part.Index])
            : InSolid;
        }
      });
  }

  void RefineFaces()
  {
    const auto take = [](const auto& from, auto& to, Id face, Id parent)
    {
      if (!from.empty() && parent >= 0)
      {
        to[face] = from[parent];
      }
    };
    const vtkIdType size = this->Next.NumberOfFaces;
    const HybridStrata<Id>& strata = this->Strata;
    HybridStrata<Id>& result = this->Result;
    result.Faces = Buffer<Stratum>(size, Stratum(Rule::Solid));
    result.SingularFaces =
      Buffer<unsigned char>(strata.SingularFaces.empty() ? 0 : size, static_cast<unsigned char>(0));
    result.FaceParts = Buffer<int>(strata.FaceParts.empty() ? 0 : size, -1);
    ForParts(
      this->Complex, this->Next.CellFaces, this->Next.FaceFirsts,
      [](const CellChild& child) -> const auto& { return child.Faces; },
      [&](const CellPart& part, vtkIdType cell, Id face)
      {
        const Id parent = part.Kind == CellPart::InFace
          ? this->Complex.CellFaces[cell].begin()[part.Index]
          : Id(-1);
        take(strata.Faces, result.Faces, face, parent);
        take(strata.SingularFaces, result.SingularFaces, face, parent);
        take(strata.FaceParts, result.FaceParts, face, parent);
      });
  }

  /// The neighbours of an old vertex are the middles of its edges along the curve; the middle of an
  /// edge has its ends.
  void FindNeighbours(Id vertex, CurveVertex<Id>& curve) const
  {
    const Id vertices = this->Complex.NumberOfVertices;
    if (vertex >= vertices)
    {
      std::copy_n(
        this->Complex.EdgeVertices.data() + 2 * vtkIdType(vertex - vertices), 2, curve.Ring);
      return;
    }
    const CurveVertex<Id>& old = this->Strata.GetCurve(vertex);
    for (int i = 0; i < 2; ++i)
    {
      curve.Ring[i] = vertices + this->Complex.FindEdge(vertex, old.Ring[i]);
    }
  }

  /// The half of an edge at the curve takes its place.
  void RefineSectors()
  {
    const Id vertices = this->Complex.NumberOfVertices;
    for (SectorEdge<Id> sector : this->Strata.Sectors)
    {
      const Id vertex = this->Complex.EdgeVertices[2 * vtkIdType(sector.Edge) + sector.End];
      for (int i = 0; i < 2; ++i)
      {
        if (sector.Bounds[i] >= 0)
        {
          sector.Ends[i] = vertices + sector.Bounds[i];
          sector.Bounds[i] = this->Next.FindEdge(vertex, sector.Ends[i]);
        }
      }
      sector.Edge = this->Next.FindEdge(vertex, vertices + sector.Edge);
      sector.End = 0; // old vertices have the smaller numbers
      sector.IsShared = false;
      this->Result.Sectors.push_back(sector);
    }
    std::sort(this->Result.Sectors.begin(), this->Result.Sectors.end(),
      [](const SectorEdge<Id>& a, const SectorEdge<Id>& b) { return a.Edge < b.Edge; });
  }

  const CellComplex<Id>& Complex;
  const HybridStrata<Id>& Strata;
  const CellComplex<Id>& Next;
  HybridStrata<Id> Result;
};

}

template <typename Id>
const CurveVertex<Id>& HybridStrata<Id>::GetCurve(Id vertex) const
{
  return *std::lower_bound(this->Curves.begin(), this->Curves.end(), vertex,
    [](const CurveVertex<Id>& curve, Id wanted) { return curve.Vertex < wanted; });
}

template <typename Id>
bool IsInRing(
  const CellComplex<Id>& complex, const HybridStrata<Id>& strata, Id face, const Decision& decision)
{
  const vtkIdType solids = complex.FaceSolids[face].size();
  switch (decision.Ring)
  {
    case RingKind::SingularFaces:
      return !strata.SingularFaces.empty() && strata.SingularFaces[face];
    case RingKind::BoundaryOfSolid:
      return solids == 1;
    case RingKind::Part:
      return solids == 0 && strata.FaceParts[face] == decision.Part;
    default:
      return (DimensionBit(solids > 0 ? 3 : 2) & decision.Dimensions) != 0;
  }
}

template <typename Id>
HybridStrata<Id> DecideHybridStrata(
  const CellComplex<Id>& complex, const SingularSimplices& singular, const StrataOptions& options)
{
  StrataDecisions<Id, CellComplex<Id>> decisions(complex, singular, options);
  HybridStrata<Id> strata;
  strata.Weights = options.Weights;
  strata.Edges = Buffer<Decision>(complex.NumberOfEdges);
  strata.Vertices = Buffer<Decision>(complex.NumberOfVertices);
  decisions.DecideAll(strata.Edges, strata.Vertices);
  strata.Faces = Buffer<Stratum>(complex.NumberOfFaces);
  ForEach(complex.NumberOfFaces,
    [&](vtkIdType f) { strata.Faces[f] = decisions.DecideFace(static_cast<Id>(f)); });
  const auto copy = [](const auto& from, auto& to)
  {
    to = std::decay_t<decltype(to)>(from.size());
    CopyInThreads(from.data(), from.size(), to.data());
  };
  copy(singular.Faces, strata.SingularFaces);
  copy(options.EdgeParts, strata.EdgeParts);
  copy(options.FaceParts, strata.FaceParts);
  strata.Curves = ListCurves<Id>(strata.Vertices,
    [&](Id vertex, CurveVertex<Id>& curve)
    {
      Id* next = curve.Ring;
      for (const Id edge : complex.VertexEdges[vertex])
      {
        if (next < curve.Ring + 2 && decisions.IsInVertexRing(edge, strata.Vertices[vertex]))
        {
          *next++ = complex.GetOtherEnd(edge, vertex);
        }
      }
    });
  strata.Reliefs = decisions.CollectReliefs(strata.Edges);
  if (options.ModifiedBoundary)
  {
    strata.Sectors = decisions.CollectSectors(strata.Edges, strata.Vertices);
  }
  return strata;
}

template <typename Id>
HybridStrata<Id> RefineHybridStrata(
  const CellComplex<Id>& complex, const HybridStrata<Id>& strata, const CellComplex<Id>& next)
{
  return StrataRefiner<Id>(complex, strata, next).Refine();
}

template <typename Id>
std::vector<SharpRow> HybridSharpness<Id>::FindRows(
  const CellComplex<Id>& complex, const HybridStrata<Id>& smooth) const
{
  SharpParts parts;
  const vtkIdType edges = complex.NumberOfVertices;
  const vtkIdType quads = edges + complex.NumberOfEdges;
  const auto isSharp = [](const std::vector<double>& left, vtkIdType i)
  { return left[static_cast<std::size_t>(i)] > 0.; };
  for (const vtkIdType e : InTurn(static_cast<vtkIdType>(this->Left.Edges.size())))
  {
    for (int i = 0; isSharp(this->Left.Edges, e) && i < 3; ++i)
    {
      const vtkIdType row = i < 2 ? vtkIdType(complex.EdgeVertices[2 * e + i]) : edges + e;
      parts.Add(row, false, this->Left.Edges[static_cast<std::size_t>(e)]);
    }
  }
  for (const std::size_t f : InTurn(this->Left.Faces.size()))
  {
    const Id face = static_cast<Id>(f);
    const double left = this->Left.Faces[f];
    const int size = left > 0. ? complex.GetSize(face) : 0;
    for (int i = 0; i < size; ++i)
    {
      parts.Add(complex.GetVertices(face).begin()[i], true, left);
      parts.Add(edges + complex.GetEdges(face).begin()[i], true, left);
    }
    if (size == 4)
    {
      parts.Add(quads + face, true, left);
    }
  }
  parts.Sort();
  std::vector<SharpRow> rows = parts.GetRows();
  const auto listSectors = [&](const HybridStrata<Id>& strata)
  {
    std::vector<Id> found;
    for (const SectorEdge<Id>& sector : InTurn(strata.Sectors))
    {
      const Id row = complex.NumberOfVertices + sector.Edge;
      if (found.empty() || found.back() < row)
      {
        found.push_back(row);
      }
    }
    return found;
  };
  if (!this->Stages.empty())
  {
    AddSharpSectors(listSectors(smooth), listSectors(this->Stages.front().Strata),
      complex.EdgeVertices, complex.NumberOfVertices, rows);
  }
  return rows;
}

template <typename Id>
double HybridSharpness<Id>::GetMost(const CellComplex<Id>& complex, Id vertex) const
{
  const auto get = [](const std::vector<double>& left, Id item)
  { return left.empty() ? 0. : left[static_cast<std::size_t>(item)]; };
  double most = 0.;
  for (const Id edge : complex.VertexEdges[vertex])
  {
    most = std::max(most, get(this->Left.Edges, edge));
    for (const Id face : complex.EdgeFaces[edge])
    {
      most = std::max(most, get(this->Left.Faces, face));
    }
  }
  return most;
}

template <typename Id>
HybridSharpness<Id> DecideHybridSharpness(const CellComplex<Id>& complex,
  const SingularSimplices& singular, const StrataOptions& options, SolidSharpness sharpness)
{
  HybridSharpness<Id> result;
  std::set<double> ends;
  for (std::vector<double>* values : { &sharpness.Edges, &sharpness.Faces })
  {
    for (double& left : InTurn(*values))
    {
      left = std::min<double>(left, SharpForever);
      left > 0. ? void(ends.insert(std::ceil(left))) : void();
    }
  }
  for (const double end : ends)
  {
    SingularSimplices sharp;
    const auto flag = [end](const Buffer<unsigned char>& given, const std::vector<double>& left,
                        Buffer<unsigned char>& flags)
    {
      const auto size = std::max(given.size(), static_cast<vtkIdType>(left.size()));
      flags = Buffer<unsigned char>(size, static_cast<unsigned char>(0));
      std::copy(given.begin(), given.end(), flags.begin());
      for (const std::size_t i : InTurn(left.size()))
      {
        unsigned char& isSingular = flags[static_cast<vtkIdType>(i)];
        isSingular = std::ceil(left[i]) >= end ? 1 : isSingular;
      }
    };
    flag(singular.Vertices, {}, sharp.Vertices);
    flag(singular.Edges, sharpness.Edges, sharp.Edges);
    flag(singular.Faces, sharpness.Faces, sharp.Faces);
    result.Stages.push_back({ end, DecideHybridStrata(complex, sharp, options) });
  }
  if (!result.Stages.empty())
  {
    result.Left = std::move(sharpness);
  }
  return result;
}

template <typename Id>
HybridSharpness<Id> RefineHybridSharpness(
  const CellComplex<Id>& complex, const HybridSharpness<Id>& sharpness, const CellComplex<Id>& next)
{
  HybridSharpness<Id> result;
  for (const typename HybridSharpness<Id>::Stage& stage : sharpness.Stages)
  {
    if (stage.Steps > 1.)
    {
      result.Stages.push_back(
        { stage.Steps - 1., RefineHybridStrata(complex, stage.Strata, next) });
    }
  }
  if (result.Stages.empty())
  {
    return result;
  }
  const auto give =
    [](const std::vector<double>& left, Id parent, Id child, std::vector<double>& children)
  {
    children[static_cast<std::size_t>(child)] =
      std::max(0., left[static_cast<std::size_t>(parent)] - 1.);
  };
  if (!sharpness.Left.Edges.empty())
  {
    result.Left.Edges.assign(static_cast<std::size_t>(next.NumberOfEdges), 0.);
    ForParts(
      complex, next.CellEdges, next.EdgeFirsts,
      [](const CellChild& child) -> const auto& { return child.Edges; },
      [&](const CellPart& part, vtkIdType cell, Id edge)
      {
        if (part.Kind == CellPart::InEdge)
        {
          give(sharpness.Left.Edges, complex.CellEdges[cell].begin()[part.Index], edge,
            result.Left.Edges);
        }
      });
  }
  if (!sharpness.Left.Faces.empty())
  {
    result.Left.Faces.assign(static_cast<std::size_t>(next.NumberOfFaces), 0.);
    ForParts(
      complex, next.CellFaces, next.FaceFirsts,
      [](const CellChild& child) -> const auto& { return child.Faces; },
      [&](const CellPart& part, vtkIdType cell, Id face)
      {
        if (part.Kind == CellPart::InFace)
        {
          give(sharpness.Left.Faces, complex.CellFaces[cell].begin()[part.Index], face,
            result.Left.Faces);
        }
      });
  }
  return result;
}

SUBDIVISION_COMPILE(struct HybridStrata);
SUBDIVISION_COMPILE(struct HybridSharpness);
SUBDIVISION_COMPILE_FUNCTION(DecideHybridSharpness);
SUBDIVISION_COMPILE_FUNCTION(RefineHybridSharpness);
SUBDIVISION_COMPILE_FUNCTION(IsInRing);
SUBDIVISION_COMPILE_FUNCTION(DecideHybridStrata);
SUBDIVISION_COMPILE_FUNCTION(RefineHybridStrata);

}
