// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Smoothness/SmoothnessProbe.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/SurfaceStars.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"
#include "Private/Smoothness/SmoothnessCells.h"
#include "Private/Surface/SurfaceChecks.h"
#include "Private/Surface/SurfaceRun.h"

#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <memory>

namespace subdivision
{
namespace
{

using Kind = SurfaceStar::Kind;

class SurfaceProbe
{
public:
  SurfaceProbe(
    const SurfaceLevel<int>& level, const SmoothnessOptions& options, SmoothnessCells& cells)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , Options(options)
    , Cells(cells)
  {
  }

  /// Returns false if Progress asks to stop.
  bool Run(const std::vector<vtkIdType>& vertexCells)
  {
    this->CountAround(vertexCells);
    for (const vtkIdType v : InTurn(this->Mesh.NumberOfVertices))
    {
      if (this->Neighbours[v] >= 0)
      {
        this->ExamineVertex(static_cast<int>(v));
      }
    }
    if (this->Options.Progress && this->Options.Progress(0.6))
    {
      return false;
    }
    ForEachInTurn(this->Mesh.GetNumberOfEdges(), [this](vtkIdType e) { this->ExamineEdge(e); });
    ForEachInTurn(this->Mesh.NumberOfFaces, [this](vtkIdType f) { this->ExamineFace(f); });
    return true;
  }

  /// The map of MapOfCell.
  const StarMap& GetMap() const { return this->Map; }

private:
  void CountAround(const std::vector<vtkIdType>& vertexCells)
  {
    this->Neighbours = Buffer<int>(this->Mesh.NumberOfVertices, -1);
    for (const vtkIdType v : InTurn(vertexCells))
    {
      this->Neighbours[v] = 0;
    }
    for (const int v : InTurn(this->Mesh.EdgeVertices))
    {
      this->Neighbours[v] = std::max(this->Neighbours[v], 0) + 1;
    }
    this->Triangles = Buffer<int>(this->Mesh.GetNumberOfEdges(), 0);
    for (const int e : InTurn(this->Mesh.Edges))
    {
      ++this->Triangles[e];
    }
  }

  const SmoothnessFacts& Examine(
    Kind kind, int faces, bool endsCrease = false, double angle = 0., double flatness = 0.)
  {
    SurfaceStar& star = this->Star;
    star = SurfaceStar();
    this->HasStar = true;
    star.Scheme = this->Options.Scheme;
    star.ModifiedBoundary = this->Options.Features.ModifiedBoundary;
    star.Weights = this->Options.Features.Weights;
    star.Where = kind;
    star.EndsCrease = endsCrease;
    star.Faces = faces;
    star.Angle = angle;
    star.Flatness = flatness;
    auto known = this->Known.find(star);
    if (known == this->Known.end())
    {
      known = this->Known.emplace(star, ExamineSurface(star, this->Options.SampleMaps)).first;
    }
    return known->second;
  }

  /// Makes the map of the star that was examined last, if its cell is the wanted one.
  void Keep(bool isWanted)
  {
    if (isWanted && this->HasStar)
    {
      this->Map = MapSurface(this->Star, this->Options.MapLevels);
    }
    this->HasStar = false;
  }

  static SmoothnessFacts GetTrivial(bool isKnown)
  {
    SmoothnessFacts facts;
    facts.Eigenvalues[0] = isKnown ? 1. : 0.;
    return facts;
  }

  /// Where a curve goes through without faces.
  static SmoothnessFacts GetCurve()
  {
    SmoothnessFacts facts;
    facts.SetEigenvalues({ 1., 1. / 2., 1. / 4. });
    facts.Condition = Answer::Yes;
    return facts;
  }

  void ExamineVertex(int vertex)
  {
    const VertexTag tag = this->Tags.Vertices[vertex];
    const auto add = [&](int sector, int rule, SmoothnessFacts facts, int valence)
    {
      facts.Valence = valence;
      this->Keep(this->Cells.Add(0, &vertex, 1, sector, rule, facts));
    };
    const int neighbours = this->Neighbours[vertex];
    switch (tag)
    {
      case VertexTag::Smooth:
        add(-1, 2, this->ExamineFan(vertex), neighbours);
        return;
      case VertexTag::Curve:
        add(-1, 1, IsDual(this->Options.Scheme) ? GetTrivial(false) : GetCurveOf(), neighbours);
        break;
      case VertexTag::Corner:
        add(-1, 0, GetTrivial(true), neighbours);
        break;
      default:
        add(-1, 4, GetTrivial(false), neighbours);
        return;
    }
    int sector = 0;
    this->ForSectors(vertex,
      [&](const SectorEnds<int>& ends)
      {
        const bool isCorner = tag == VertexTag::Corner;
        const Sector<int>* record = isCorner ? FindSector(this->Tags, vertex, ends) : nullptr;
        if (!isCorner || record)
        {
          add(sector, 2,
            this->Examine(isCorner ? Kind::Corner : Kind::Curve, ends.Size, false,
              record ? record->Angle : 0., record ? record->Flatness : 0.),
            ends.Size);
        }
        ++sector;
      });
  }

  /// Of sqrt(3) curves are cut in three.
  SmoothnessFacts GetCurveOf() const
  {
    SmoothnessFacts facts = GetCurve();
    if (this->Options.Scheme == SurfaceSchemeKind::SqrtThree)
    {
      facts.SetEigenvalues({ 1., 1. / 3., 1. / 9. });
    }
    return facts;
  }

  /// All around a vertex, at which a crease may end.
  SmoothnessFacts ExamineFan(int vertex)
  {
    const int corner = this->Mesh.VertexCorners[vertex];
    if (corner < 0)
    {
      return GetTrivial(false);
    }
    int faces = 0;
    int creases = 0;
    const bool isCycle = VisitFan(this->Mesh, corner,
      [&](const FanStep<int>& step)
      {
        ++faces;
        creases += IsSharp(this->Tags.Edges[this->Mesh.Edges[step.GetHalfEdgeIn(this->Mesh)]]);
      });
    return isCycle && creases <= 1 ? this->Examine(Kind::Closed, faces, creases == 1)
                                   : GetTrivial(false);
  }

  /// act(ends) for each sector at a vertex between two sharp edges. Schemes without tags have none.
  template <typename Act>
  void ForSectors(int vertex, const Act& act) const
  {
    std::vector<int> done; // first edges
    VisitFans(this->Mesh, vertex,
      [&](int corner)
      {
        VisitFan(this->Mesh, corner,
          [&](const FanStep<int>& step)
          {
            const SectorEnds<int> ends = FindSectorEnds(this->Mesh, this->Tags, step.Corner);
            const int first = ends.Size > 0 ? std::min(ends.First.Corner, ends.Last.Corner) : -1;
            if (first < 0 || std::find(done.begin(), done.end(), first) != done.end())
            {
              return;
            }
            done.push_back(first);
            const auto isSharp = [this](int halfEdge)
            { return IsSharp(this->Tags.Edges[this->Mesh.Edges[halfEdge]]); };
            if (isSharp(ends.First.GetHalfEdgeIn(this->Mesh)) &&
              isSharp(ends.Last.GetHalfEdgeOut(this->Mesh)))
            {
              act(ends);
            }
          });
      });
  }

  void ExamineEdge(vtkIdType edge)
  {
    const EdgeTag tag = this->Tags.Edges[edge];
    const int regular = GetRegularFaces(this->Options.Scheme);
    const bool isDual = IsDual(this->Options.Scheme);
    SmoothnessFacts facts = GetTrivial(false);
    if (tag == EdgeTag::Smooth)
    {
      facts = this->Examine(Kind::Closed, regular);
    }
    else if (IsSharp(tag) && !isDual)
    {
      facts = this->Triangles[edge] > 0 ? this->Examine(Kind::Curve, regular / 2) : GetCurveOf();
    }
    facts.Valence = this->Triangles[edge];
    const int rule = tag == EdgeTag::Smooth ? 2 : IsSharp(tag) ? 1 : 4;
    this->Keep(this->Cells.Add(1, this->Mesh.EdgeVertices.data() + 2 * edge, 2, -1, rule, facts));
  }

  void ExamineFace(vtkIdType face)
  {
    const int first = this->Mesh.GetFirst(static_cast<int>(face));
    const int size = this->Mesh.GetSize(static_cast<int>(face));
    const bool becomesOne = IsDual(this->Options.Scheme) || HasCentres(this->Options.Scheme);
    SmoothnessFacts facts =
      this->Examine(Kind::Closed, becomesOne ? size : GetRegularFaces(this->Options.Scheme));
    facts.Valence = size;
    this->Keep(this->Cells.Add(2, this->Mesh.Vertices.data() + first, size, -1, 2, facts));
  }

  const PolygonMesh<int>& Mesh;
  const SurfaceTags<int>& Tags;
  const SmoothnessOptions& Options;
  SmoothnessCells& Cells;
  Buffer<int> Neighbours; ///< of each vertex, -1: no cell has it
  Buffer<int> Triangles;  ///< at each edge
  std::map<SurfaceStar, SmoothnessFacts> Known;
  SurfaceStar Star; ///< that was examined for the next cell
  bool HasStar = false;
  StarMap Map;
};

/// Makes the levels up to the level of the input.
class SurfaceSmoothness
{
public:
  SurfaceSmoothness(
    vtkPolyData* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
  {
    static_cast<RunOptions&>(this->Surface) = options;
    this->Surface.Scheme = options.Scheme;
    this->Surface.Levels = 0;
    this->Surface.JoinSeams = false;
  }

  bool Run()
  {
    int level = 0;
    const SurfaceSteps<int>* steps = this->MakeLevels(level);
    if (steps && level > 0)
    {
      // An earlier filter made the input. Its level has all that rows read if limits are to follow.
      this->Surface.Warn = [](const std::string&) {}; // told already
      steps = this->MakeLevels(level, true);
    }
    return steps && this->Examine(steps->GetLevel(level));
  }

private:
  const SurfaceSteps<int>* MakeLevels(int& level, bool isWhole = false)
  {
    const auto scheme = MakeSurfaceScheme<int>(this->Options.Scheme,
      this->Options.Features.ModifiedBoundary, this->Options.Features.Weights);
    SurfaceCells cells;
    bool isLarge = false;
    if (!ReadAndCheck(this->Input, *scheme, this->Surface, cells, isLarge))
    {
      return nullptr;
    }
    if (isLarge)
    {
      this->Options.Fail(
        "The surface has more faces than this filter can number. Use a part of it.");
      return nullptr;
    }
    this->Surface.ProjectToLimit = isWhole; // after checks of rows of limits, which nobody makes
    this->VertexCells = cells.Vertices;
    this->Maker = std::make_unique<SurfaceRun<int>>(this->Input, this->Surface, scheme, nullptr);
    return this->Maker->MakeLevels(std::move(cells), level);
  }

  bool Examine(const SurfaceLevel<int>& level)
  {
    const auto vertices = static_cast<double>(level.Mesh.NumberOfVertices);
    const std::string tooLarge =
      SmoothnessCells::CheckSize(vertices + static_cast<double>(level.Mesh.GetNumberOfEdges()) +
          static_cast<double>(level.Mesh.NumberOfFaces),
        vertices, this->Options);
    if (!tooLarge.empty())
    {
      this->Options.Fail(tooLarge);
      return false;
    }
    SmoothnessCells cells(this->Options);
    SurfaceProbe probe(level, this->Options, cells);
    if (!probe.Run(this->VertexCells))
    {
      return false;
    }
    if (this->Options.MapOfCell >= 0)
    {
      return cells.WriteMap(probe.GetMap(), this->Output);
    }
    SimplicesOfCells noCentres;
    noCentres.Simplices.NumberOfPoints = this->Input->GetNumberOfPoints();
    StartPointArrays(this->Options, this->Input, noCentres, {}, false, nullptr, { FailingName })
      ->Finish(this->Output);
    cells.Write(this->Output);
    return true;
  }

  vtkPolyData* Input;
  const SmoothnessOptions& Options;
  vtkUnstructuredGrid* Output;
  SurfaceOptions Surface;
  std::vector<vtkIdType> VertexCells;
  std::unique_ptr<SurfaceRun<int>> Maker;
};

}

bool ProbeSurfaces(
  vtkPolyData* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output)
{
  return SurfaceSmoothness(input, options, output).Run();
}

}
