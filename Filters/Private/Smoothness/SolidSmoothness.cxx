// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Smoothness/SmoothnessProbe.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/SolidSpectra.h"
#include "Core/Smoothness/SurfaceStars.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Smoothness/SmoothnessCells.h"
#include "Private/Smoothness/SolidStars.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <memory>

namespace subdivision
{
namespace
{

/// The dimension of a rule, 4: blended.
int FindDimension(Rule rule)
{
  return rule == Rule::RegularEdge ? 3 : static_cast<int>(rule);
}

/// Takes over the results of sampling the characteristic map.
void TakeMap(const SmoothnessFacts& from, SmoothnessFacts& facts)
{
  facts.Regular = from.Regular;
  facts.Injective = from.Injective;
  facts.Samples = from.Samples;
}

/// Around a vertex on a curve.
SmoothnessFacts ExamineCurve()
{
  SmoothnessFacts facts;
  facts.SetEigenvalues({ 1., 1. / 2., 1. / 4. });
  facts.Condition = Answer::Yes;
  return facts;
}

/// Loop's scheme around a vertex as vtkMultiDimensionalSubdivision has it. Equal stars are examined
/// once.
class SheetReader
{
public:
  SheetReader(bool samples, const FeatureOptions& rules)
    : Samples(samples)
    , Rules(rules)
  {
  }

  SurfaceStar MakeStar(SurfaceStar::Kind kind, bool endsCrease, int faces) const
  {
    SurfaceStar star;
    star.ModifiedBoundary =
      this->Rules.ModifiedBoundary && kind == SurfaceStar::Kind::Curve; // corners have no angle
    star.Weights = this->Rules.Weights;
    star.Where = kind;
    star.EndsCrease = endsCrease;
    star.Faces = faces;
    star.Angle = kind == SurfaceStar::Kind::Corner ? Pi / 2. : 0.; // these rules do not read it
    return star;
  }

  const SmoothnessFacts& Examine(SurfaceStar::Kind kind, bool endsCrease, int faces)
  {
    const SurfaceStar star = this->MakeStar(kind, endsCrease, faces);
    auto known = this->Known.find(star);
    if (known == this->Known.end())
    {
      known = this->Known.emplace(star, ExamineSurface(star, this->Samples)).first;
    }
    return known->second;
  }

private:
  const bool Samples;
  const FeatureOptions& Rules;
  std::map<SurfaceStar, SmoothnessFacts> Known;
};

template <typename Scheme>
class SolidProbe
{
public:
  using Id = typename Scheme::Id;
  using Level = typename Scheme::Level;

  SolidProbe(const Level& level, const SmoothnessOptions& options, SmoothnessCells& cells)
    : Here(level)
    , Complex(level.Complex)
    , Options(options)
    , Sheets(options.SampleMaps, options.Features)
    , Cells(cells)
  {
  }

  /// Returns false if Progress asks to stop.
  bool Run()
  {
    this->CountAround();
    return this->ExamineVertices() && this->ExamineEdges() && this->ExamineFaces() &&
      !this->IsTooLarge;
  }

  const StarMap& GetMap() const { return this->Map; }

private:
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }
  Rule GetRule(Id vertex) const { return this->Here.Strata.Vertices[vertex].GetRule(); }
  bool HasOctahedra() const { return Scheme::CountCentres(this->Here) > 0; }

  /// Counts the neighbours of vertices and the triangles at edges, and lists the tetrahedra at
  /// vertices.
  void CountAround()
  {
    const vtkIdType vertices = this->Complex.NumberOfVertices;
    this->Neighbours = Buffer<int>(vertices, -1);
    for (const Id v : InTurn(this->Complex.VertexCells))
    {
      this->Neighbours[v] = 0;
    }
    for (const Id v : InTurn(this->Complex.EdgeVertices))
    {
      this->Neighbours[v] = std::max(this->Neighbours[v], 0) + 1;
    }
    this->Triangles = Buffer<int>(this->Complex.NumberOfEdges, 0);
    for (const Id e : InTurn(this->Complex.FaceEdges))
    {
      ++this->Triangles[e];
    }
    const auto& corners = this->Complex.TetVertices;
    this->Tets = ListByRow<vtkIdType>(
      vertices, corners.size(), [&](vtkIdType i) { return corners[i]; },
      [](vtkIdType i) { return i / 4; });
  }

  bool ExamineVertices()
  {
    const vtkIdType size = this->Complex.NumberOfVertices;
    Buffer<SmoothnessFacts> facts(size);
    const double share = this->Options.SampleMaps ? 0.1 : 0.6; // of the time
    const vtkIdType part = std::max<vtkIdType>(1024, size / 32);
    for (vtkIdType begin = 0; begin < size; begin += part)
    {
      FindSpectra(
        this->Here, std::min(part, size - begin), [begin](vtkIdType v) { return begin + v; },
        facts.data() + begin);
      if (this->IsStopped(share * static_cast<double>(begin) / static_cast<double>(size)))
      {
        return false;
      }
    }
    if (!this->SampleSolids(facts, share))
    {
      return false;
    }
    const std::vector<Sheet> sheets = FindSheets(this->Here);
    auto sheet = sheets.begin();
    for (const Id v : InTurn(this->Complex.NumberOfVertices))
    {
      facts[v].Valence = this->Neighbours[v];
      if (facts[v].Condition == Answer::Yes && this->GetRule(v) == Rule::Surface)
      {
        this->SampleSurface(v, facts[v]);
      }
      if (this->Neighbours[v] >= 0 &&
        this->Cells.Add(0, &v, 1, -1, FindDimension(this->GetRule(v)), facts[v]))
      {
        this->MapVertex(v);
      }
      for (int sector = 0; sheet != sheets.end() && sheet->Vertex == v; ++sheet, ++sector)
      {
        SmoothnessFacts found = ExamineSheet(*sheet, this->Options.Features.ModifiedBoundary);
        const auto kind = sheet->IsCorner ? SurfaceStar::Kind::Corner : SurfaceStar::Kind::Curve;
        TakeMap(this->Sheets.Examine(kind, false, sheet->Triangles), found);
        if (this->Cells.Add(0, &v, 1, sector, 2, found))
        {
          this->MapSheet(kind, false, sheet->Triangles);
        }
      }
    }
    return true;
  }

  /// Whether Progress asks to stop, of many turns of a loop. Each part of the work has its own.
  bool IsStoppedAt(vtkIdType turn, vtkIdType turns, double begin, double end) const
  {
    constexpr vtkIdType between = 64;
    return turn % between == 0 &&
      this->IsStopped(
        begin + (end - begin) * static_cast<double>(turn) / static_cast<double>(turns));
  }

  /// Characteristic maps inside solids of tetrahedra. Returns false if Progress asks to stop.
  bool SampleSolids(Buffer<SmoothnessFacts>& facts, double begin) const
  {
    if (!this->Options.SampleMaps || this->HasOctahedra())
    {
      return true;
    }
    StarReader<Scheme> reader(this->Here, true);
    // In this thread: a star is a mesh of its own, whose loops use threads where it is large, and
    // loops of threads inside loops of other threads may wait for each other.
    for (const vtkIdType v : InTurn(facts.size()))
    {
      if (this->IsStoppedAt(v, facts.size(), begin, 0.6))
      {
        return false;
      }
      const Rule rule = this->GetRule(static_cast<Id>(v));
      if (facts[v].Condition == Answer::Yes && FindDimension(rule) == 3)
      {
        TakeMap(reader.ExamineVertex(static_cast<Id>(v), this->Tets[v]), facts[v]);
      }
    }
    return true;
  }

  /// A surface with the edges of the vertex all inside of it, or one of them the end of a crease.
  void SampleSurface(Id vertex, SmoothnessFacts& facts)
  {
    bool endsCrease = false;
    if (const int triangles = this->CountTriangles(vertex, endsCrease))
    {
      TakeMap(this->Sheets.Examine(SurfaceStar::Kind::Closed, endsCrease, triangles), facts);
    }
  }
  /// 0: something else is there.
  int CountTriangles(Id vertex, bool& endsCrease) const
  {
    const Row<Id> edges = this->Here.Strata.VertexRings.GetCarriers(vertex);
    const auto count = [&](Rule rule)
    {
      return std::count_if(edges.begin(), edges.end(),
        [&](Id edge) { return this->Here.Strata.Edges[edge].GetRule() == rule; });
    };
    const auto creases = count(Rule::Curve);
    endsCrease = creases == 1;
    return creases <= 1 && creases + count(Rule::Surface) == edges.size()
      ? static_cast<int>(edges.size())
      : 0;
  }

  /// At the vertices that steps make inside an edge or a face of dimension 0 to 2, or blended.
  SmoothnessFacts ExamineRegular(Rule rule)
  {
    switch (rule)
    {
      case Rule::Curve:
        return ExamineCurve();
      case Rule::Surface:
        return this->Sheets.Examine(SurfaceStar::Kind::Closed, false, 6);
      default:
      {
        SmoothnessFacts unknown;
        unknown.Eigenvalues.fill(0.);
        return unknown;
      }
    }
  }

  bool ExamineEdges()
  {
    const vtkIdType size = this->Complex.NumberOfEdges;
    Buffer<SmoothnessFacts> facts(size);
    StarReader<Scheme> reader(this->Here, this->Options.SampleMaps);
    for (const vtkIdType e : InTurn(size))
    {
      if (this->IsStoppedAt(e, size, 0.6, 0.8))
      {
        return false;
      }
      const Rule rule = this->Here.Strata.Edges[e].GetRule();
      facts[e] = FindDimension(rule) == 3 ? reader.ExamineEdge(static_cast<Id>(e))
                                          : this->ExamineRegular(rule);
      facts[e].Valence = this->Triangles[e];
      const Id* ends = this->Complex.EdgeVertices.data() + 2 * e;
      if (this->Cells.Add(1, ends, 2, -1, FindDimension(rule), facts[e]))
      {
        FindDimension(rule) == 3 ? this->MapStar(reader.MakeEdgeStar(static_cast<Id>(e)))
                                 : this->MapRegular(rule);
      }
    }
    return true;
  }

  bool ExamineFaces()
  {
    StarReader<Scheme> reader(this->Here, this->Options.SampleMaps);
    for (const Id f : InTurn(this->Complex.NumberOfFaces))
    {
      if (this->IsStoppedAt(f, this->Complex.NumberOfFaces, 0.8, 0.95))
      {
        return false;
      }
      const Rule rule = this->Here.Strata.Faces[f].GetRule();
      const Row<Id> solids = this->Complex.FaceTets[f];
      const bool isInside = FindDimension(rule) == 3 && solids.size() == 2;
      SmoothnessFacts facts = isInside
        ? reader.ExamineFace(f)
        : this->ExamineRegular(rule == Rule::Surface ? rule : Rule::Blend);
      facts.Valence = static_cast<int>(solids.size());
      const Id* corners = this->Complex.FaceVertices.data() + 3 * vtkIdType(f);
      if (this->Cells.Add(2, corners, 3, -1, FindDimension(rule), facts))
      {
        isInside ? this->MapStar(reader.MakeFaceStar(f)) : this->MapRegular(rule);
      }
    }
    return true;
  }

  // The map of MapOfCell:

  void MapStar(const SolidStar& star)
  {
    using SmallScheme = typename StarReader<Scheme>::SmallScheme;
    const double cells = CountCellsOfMap(star, this->Options.MapLevels);
    this->IsTooLarge = cells > static_cast<double>(this->Options.MaximumNumberOfCells);
    if (this->IsTooLarge)
    {
      this->Options.Fail("The characteristic map may have " +
        std::to_string(static_cast<long long>(cells)) +
        " cells, which is above MaximumNumberOfCells = " +
        std::to_string(this->Options.MaximumNumberOfCells) +
        ". Take fewer MapLevels, or raise MaximumNumberOfCells.");
      return;
    }
    this->Map = MapSolid<SmallScheme>(star, this->Options.MapLevels);
  }
  void MapSheet(SurfaceStar::Kind kind, bool endsCrease, int triangles)
  {
    this->Map =
      MapSurface(this->Sheets.MakeStar(kind, endsCrease, triangles), this->Options.MapLevels);
  }
  void MapRegular(Rule rule)
  {
    if (rule == Rule::Surface)
    {
      this->MapSheet(SurfaceStar::Kind::Closed, false, 6);
    }
  }
  void MapVertex(Id vertex)
  {
    const Rule rule = this->GetRule(vertex);
    bool endsCrease = false;
    const int triangles = rule == Rule::Surface ? this->CountTriangles(vertex, endsCrease) : 0;
    if (FindDimension(rule) == 3 && !this->HasOctahedra())
    {
      this->MapStar(
        StarReader<Scheme>(this->Here, false).MakeVertexStar(vertex, this->Tets[vertex]));
    }
    else if (triangles > 0)
    {
      this->MapSheet(SurfaceStar::Kind::Closed, endsCrease, triangles);
    }
  }

  const Level& Here;
  const SimplicialComplex<Id>& Complex;
  const SmoothnessOptions& Options;
  SheetReader Sheets;
  SmoothnessCells& Cells;
  Buffer<int> Neighbours; ///< of each vertex, -1: no cell has it
  Buffer<int> Triangles;  ///< at each edge
  Rows<vtkIdType> Tets;   ///< at each vertex
  StarMap Map;            ///< of MapOfCell
  bool IsTooLarge = false;
};

class SolidSmoothness
{
public:
  SolidSmoothness(vtkPointSet* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
  {
  }

  bool Run()
  {
    bool isDone = false;
    if (!this->Try(true, isDone)) // the stamp is wrong
    {
      this->Try(false, isDone);
    }
    return isDone;
  }

private:
  bool Try(bool trustStamp, bool& isDone)
  {
    return this->Options.IsTetOct
      ? this->Try<TetOctScheme<int>, TetOctScheme<long long>>(trustStamp, isDone)
      : this->Try<BoxSplineScheme<int>, BoxSplineScheme<long long>>(trustStamp, isDone);
  }

  /// Returns false if the stamp is wrong.
  template <typename Small, typename Large>
  bool Try(bool trustStamp, bool& isDone)
  {
    this->Read(trustStamp, Small::Traits);
    const bool isLarge =
      NeedsLargeIds(this->Mesh.GetControl(), this->Mesh.MadeLevels + 1, Small::Traits);
    return isLarge ? this->Examine<Large>(isDone) : this->Examine<Small>(isDone);
  }

  void Read(bool trustStamp, const SchemeTraits& scheme)
  {
    this->Mesh = ReadControlMesh(this->Input, trustStamp, this->Options.Features,
      this->Options.IsTetOct ? StampScheme::TetOct : StampScheme::BoxSpline);
    if (this->Mesh.IsOfOtherScheme)
    {
      this->Mesh.Warnings.emplace_back(
        "An earlier filter made the input with another VolumeScheme. This filter takes it as any "
        "other mesh: it looks for features again, and octahedra are four tetrahedra each.");
    }
    this->Points = StartPointArrays(this->Options, this->Input, this->Mesh.Cells,
      this->Mesh.GlobalIds, this->Mesh.IsStamped, nullptr, { FailingName });
    if (!this->Mesh.IsStamped && scheme.OrdersTets)
    {
      OrderTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates(),
        this->Mesh.GetGlobalIds(), static_cast<vtkIdType>(this->Mesh.GlobalIds.size()));
    }
  }

  template <typename Scheme>
  bool Examine(bool& isDone)
  {
    using Id = typename Scheme::Id;
    ControlComplex<Id> control;
    typename Scheme::Level level;
    if (!BuildControlComplex<Scheme>(
          this->Mesh, this->Options.Features, this->Points->GetCoordinates(),
          [this](const std::string& warning) { this->Mesh.Warnings.push_back(warning); },
          Depth::ForRefinement, control, level))
    {
      return false;
    }
    Tell(this->Mesh.Warnings, this->Options);
    const LevelCounts counts = CountSimplices<Scheme>(level);
    const std::string tooLarge = SmoothnessCells::CheckSize(
      counts.Vertices + counts.Edges + counts.Faces, counts.Vertices, this->Options);
    if (!tooLarge.empty())
    {
      this->Options.Fail(tooLarge);
      return true;
    }
    SmoothnessCells cells(this->Options);
    SolidProbe<Scheme> probe(level, this->Options, cells);
    if (!probe.Run())
    {
      return true;
    }
    if (this->Options.MapOfCell >= 0)
    {
      isDone = cells.WriteMap(probe.GetMap(), this->Output);
    }
    else
    {
      this->Points->Finish(this->Output);
      cells.Write(this->Output);
      isDone = true;
    }
    return true;
  }

  vtkPointSet* Input;
  const SmoothnessOptions& Options;
  vtkUnstructuredGrid* Output;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
};

}

bool ProbeSolids(vtkPointSet* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output)
{
  return SolidSmoothness(input, options, output).Run();
}

}
