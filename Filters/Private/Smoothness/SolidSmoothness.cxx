// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Smoothness/SmoothnessProbe.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/SolidMaps.h"
#include "Core/Smoothness/SolidSpectra.h"
#include "Core/Smoothness/SurfaceStars.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Control/SizeChecks.h"
#include "Private/Smoothness/SmoothnessCells.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <memory>
#include <unordered_map>

namespace subdivision
{
namespace
{

/// The dimension of a rule, 4: blended.
int FindDimension(Rule rule)
{
  return rule == Rule::RegularEdge ? 3 : static_cast<int>(rule);
}

/// How an edge lies in a tetrahedron of the box spline: it is marked, or the marked edges at its
/// first end go to the one or to the other vertex of the tetrahedron.
enum Mark
{
  OnEdge,
  ToFirst,
  ToSecond
};

/// What lies at the simplices of a level, as stars of their own. Equal stars are examined once.
template <typename Scheme>
class StarReader
{
public:
  using Id = typename Scheme::Id;
  using Level = typename Scheme::Level;
  /// The same scheme with the ids of small meshes.
  using SmallScheme =
    std::conditional_t<Scheme::Traits.HasPieces, TetOctScheme<int>, BoxSplineScheme<int>>;

  StarReader(const Level& level, bool samples)
    : Here(level)
    , Complex(level.Complex)
    , Samples(samples)
  {
  }

  /// All tetrahedra at an inner vertex.
  template <typename Tets>
  SmoothnessFacts ExamineVertex(Id vertex, const Tets& tets) const
  {
    SolidStar star;
    std::unordered_map<Id, int> numbers{ { vertex, 0 } };
    for (const Id tet : tets)
    {
      std::array<int, 4> made{};
      for (int k = 0; k < 4; ++k)
      {
        const Id corner = this->Complex.TetVertices[4 * vtkIdType(tet) + k];
        made[k] = numbers.emplace(corner, static_cast<int>(numbers.size())).first->second;
      }
      star.Tets.push_back(made);
    }
    return ExamineSolid<SmallScheme>(star, this->Samples);
  }

  SmoothnessFacts ExamineEdge(Id edge)
  {
    std::vector<int> marks;
    if (!this->ReadMarks(edge, marks))
    {
      return this->ExamineInside();
    }
    std::vector<int> least = marks;
    for (std::size_t i = 1; i < marks.size(); ++i) // where the walk begins does not matter
    {
      std::rotate(marks.begin(), marks.begin() + 1, marks.end());
      least = std::min(least, marks);
    }
    const auto known = this->Edges.find(least);
    return known != this->Edges.end()
      ? known->second
      : this->Edges.emplace(least, this->ExamineMarks(least)).first->second;
  }

  /// A face between two tetrahedra: whether these mark the same edge of it decides.
  SmoothnessFacts ExamineFace(Id face)
  {
    const Row<Id> solids = this->Complex.FaceTets[face];
    const bool areTets = solids.begin()[0] < this->Complex.NumberOfTets &&
      solids.begin()[1] < this->Complex.NumberOfTets;
    const bool isSame = !Scheme::Traits.OrdersTets || !areTets ||
      this->FindMarked(solids.begin()[0], face) == this->FindMarked(solids.begin()[1], face);
    std::unique_ptr<SmoothnessFacts>& known = this->Faces[isSame ? 0 : 1];
    if (!known)
    {
      SolidStar star;
      star.Corners = 3;
      star.Tets = { { { 0, 3, 1, 2 } }, { { 0, 4, 1, 2 } } };
      star.Tets[1] = isSame ? star.Tets[1] : std::array<int, 4>{ { 0, 4, 2, 1 } };
      known = std::make_unique<SmoothnessFacts>(ExamineSolid<SmallScheme>(star, this->Samples));
    }
    return *known;
  }

private:
  /// Inside a tetrahedron, where the mesh is a lattice.
  SmoothnessFacts ExamineInside()
  {
    if (!this->Inside)
    {
      const SolidStar star{ 4, { { { 0, 1, 2, 3 } } } };
      this->Inside =
        std::make_unique<SmoothnessFacts>(ExamineSolid<SmallScheme>(star, this->Samples));
    }
    return *this->Inside;
  }

  SmoothnessFacts ExamineMarks(const std::vector<int>& marks) const
  {
    SolidStar star;
    star.Corners = 2;
    const int size = static_cast<int>(marks.size());
    for (int i = 0; i < size; ++i)
    {
      const int first = 2 + i;
      const int second = 2 + (i + 1) % size;
      const std::array<int, 4> orders[3] = { { { 0, first, 1, second } },
        { { 0, 1, first, second } }, { { 0, 1, second, first } } };
      star.Tets.push_back(orders[marks[i]]);
    }
    return ExamineSolid<SmallScheme>(star, this->Samples);
  }

  /// The mark of each tetrahedron around an edge. Returns false if there are octahedra at it.
  bool ReadMarks(Id edge, std::vector<int>& marks) const
  {
    const auto isTet = [this](Id solid) { return solid < this->Complex.NumberOfTets; };
    const Row<Id> faces = this->Here.Strata.EdgeRings.GetCarriers(edge);
    const Id first = faces.begin()[0];
    const Id firstTet = this->Complex.FaceTets[first].begin()[0];
    Id face = first;
    Id tet = firstTet;
    do
    {
      if (!isTet(tet))
      {
        return false;
      }
      const Id* tetFaces = this->Complex.TetFaces.data() + 4 * vtkIdType(tet);
      const int* ends = tetrahedron::EdgeVertices[this->Complex.EdgeInTet(tet, edge)];
      const Id* corners = this->Complex.TetVertices.data() + 4 * vtkIdType(tet);
      const int start =
        corners[ends[0]] == this->Complex.EdgeVertices[2 * vtkIdType(edge)] ? ends[0] : ends[1];
      const int end = start == ends[0] ? ends[1] : ends[0];
      const int beyond = this->Complex.FaceInTet(tet, face); // not on the face
      const int here = 6 - start - end - beyond;
      const int partner = start ^ 2; // marked edges are 02 and 13
      marks.push_back(!Scheme::Traits.OrdersTets || partner == end ? OnEdge
          : partner == here                                        ? ToFirst
                                                                   : ToSecond);
      face = tetFaces[here];
      const Row<Id> sides = this->Complex.FaceTets[face];
      if (sides.size() != 2)
      {
        return false;
      }
      tet = sides.begin()[0] == tet ? sides.begin()[1] : sides.begin()[0];
    } while (tet != firstTet && static_cast<vtkIdType>(marks.size()) < faces.size());
    return true;
  }

  /// The edge of a face that a tetrahedron of the box spline marks, as the vertex opposite to it.
  Id FindMarked(Id tet, Id face) const
  {
    const Id* corners = this->Complex.TetVertices.data() + 4 * vtkIdType(tet);
    return corners[this->Complex.FaceInTet(tet, face) ^ 2];
  }

  const Level& Here;
  const SimplicialComplex<Id>& Complex;
  const bool Samples;
  std::map<std::vector<int>, SmoothnessFacts> Edges;
  std::unique_ptr<SmoothnessFacts> Faces[2];
  std::unique_ptr<SmoothnessFacts> Inside;
};

/// Takes over what sampling the characteristic map has shown.
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

  const SmoothnessFacts& Examine(SurfaceStar::Kind kind, bool endsCrease, int faces)
  {
    SurfaceStar star;
    star.ModifiedBoundary =
      this->Rules.ModifiedBoundary && kind == SurfaceStar::Kind::Curve; // corners have no angle
    star.Weights = this->Rules.Weights;
    star.Where = kind;
    star.EndsCrease = endsCrease;
    star.Faces = faces;
    star.Angle = kind == SurfaceStar::Kind::Corner ? Pi / 2. : 0.; // these rules do not read it
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
    return this->ExamineVertices() && !this->IsStopped(0.6) && this->ExamineEdges() &&
      !this->IsStopped(0.9) && this->ExamineFaces();
  }

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
    this->Tets.Offsets = Buffer<vtkIdType>(vertices + 1, 0);
    for (const Id v : InTurn(this->Complex.TetVertices))
    {
      ++this->Tets.Offsets[v];
    }
    CountsToOffsets(this->Tets.Offsets);
    this->Tets.Items = Buffer<vtkIdType>(this->Complex.TetVertices.size());
    Buffer<vtkIdType> next(vertices);
    std::copy_n(this->Tets.Offsets.begin(), vertices, next.begin());
    ForEachInTurn(this->Complex.TetVertices.size(),
      [&](vtkIdType i) { this->Tets.Items[next[this->Complex.TetVertices[i]]++] = i / 4; });
  }

  bool ExamineVertices()
  {
    const vtkIdType size = this->Complex.NumberOfVertices;
    Buffer<SmoothnessFacts> facts(size);
    FindSpectra(this->Here, size, [](vtkIdType v) { return v; }, facts.data());
    if (this->IsStopped(0.2))
    {
      return false;
    }
    this->SampleSolids(facts);
    const std::vector<Sheet> sheets = FindSheets(this->Here);
    auto sheet = sheets.begin();
    for (const Id v : InTurn(this->Complex.NumberOfVertices))
    {
      facts[v].Valence = this->Neighbours[v];
      if (facts[v].Condition == Answer::Yes && this->GetRule(v) == Rule::Surface)
      {
        this->SampleSurface(v, facts[v]);
      }
      if (this->Neighbours[v] >= 0)
      {
        this->Cells.Add(0, &v, 1, -1, FindDimension(this->GetRule(v)), facts[v]);
      }
      for (int sector = 0; sheet != sheets.end() && sheet->Vertex == v; ++sheet, ++sector)
      {
        SmoothnessFacts found = ExamineSheet(*sheet, this->Options.Features.ModifiedBoundary);
        TakeMap(this->Sheets.Examine(
                  sheet->IsCorner ? SurfaceStar::Kind::Corner : SurfaceStar::Kind::Curve, false,
                  sheet->Triangles),
          found);
        this->Cells.Add(0, &v, 1, sector, 2, found);
      }
    }
    return true;
  }

  /// Characteristic maps inside solids of tetrahedra.
  void SampleSolids(Buffer<SmoothnessFacts>& facts) const
  {
    if (!this->Options.SampleMaps || this->HasOctahedra())
    {
      return;
    }
    const StarReader<Scheme> reader(this->Here, true);
    // In this thread: a star is a mesh of its own, whose loops use threads where it is large, and
    // loops of threads inside those of other threads may wait for each other.
    for (const vtkIdType v : InTurn(facts.size()))
    {
      BetweenLoops::Act();
      const Rule rule = this->GetRule(static_cast<Id>(v));
      if (facts[v].Condition == Answer::Yes && FindDimension(rule) == 3)
      {
        TakeMap(reader.ExamineVertex(static_cast<Id>(v), this->Tets[v]), facts[v]);
      }
    }
  }

  /// A surface with the edges of the vertex all inside of it, or one of them the end of a crease.
  void SampleSurface(Id vertex, SmoothnessFacts& facts)
  {
    const Row<Id> edges = this->Here.Strata.VertexRings.GetCarriers(vertex);
    const auto count = [&](Rule rule)
    {
      return std::count_if(edges.begin(), edges.end(),
        [&](Id edge) { return this->Here.Strata.Edges[edge].GetRule() == rule; });
    };
    const auto creases = count(Rule::Curve);
    if (creases <= 1 && creases + count(Rule::Surface) == edges.size())
    {
      TakeMap(this->Sheets.Examine(
                SurfaceStar::Kind::Closed, creases == 1, static_cast<int>(edges.size())),
        facts);
    }
  }

  /// What a step makes inside an edge or a face of dimension 0 to 2, or blended.
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
      const Rule rule = this->Here.Strata.Edges[e].GetRule();
      facts[e] = FindDimension(rule) == 3 ? reader.ExamineEdge(static_cast<Id>(e))
                                          : this->ExamineRegular(rule);
      facts[e].Valence = this->Triangles[e];
      this->Cells.Add(
        1, this->Complex.EdgeVertices.data() + 2 * e, 2, -1, FindDimension(rule), facts[e]);
    }
    return true;
  }

  bool ExamineFaces()
  {
    StarReader<Scheme> reader(this->Here, this->Options.SampleMaps);
    for (const Id f : InTurn(this->Complex.NumberOfFaces))
    {
      const Rule rule = this->Here.Strata.Faces[f].GetRule();
      const Row<Id> solids = this->Complex.FaceTets[f];
      SmoothnessFacts facts = FindDimension(rule) == 3 && solids.size() == 2
        ? reader.ExamineFace(f)
        : this->ExamineRegular(rule == Rule::Surface ? rule : Rule::Blend);
      facts.Valence = static_cast<int>(solids.size());
      this->Cells.Add(
        2, this->Complex.FaceVertices.data() + 3 * vtkIdType(f), 3, -1, FindDimension(rule), facts);
    }
    return true;
  }

  const Level& Here;
  const SimplicialComplex<Id>& Complex;
  const SmoothnessOptions& Options;
  SheetReader Sheets;
  SmoothnessCells& Cells;
  Buffer<int> Neighbours; ///< of each vertex, -1: no cell has it
  Buffer<int> Triangles;  ///< at each edge
  Rows<vtkIdType> Tets;   ///< at each vertex
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
    this->Points = std::make_unique<PointArrays>(this->Input, this->Mesh.Cells,
      this->Mesh.GetGlobalIds(), static_cast<vtkIdType>(this->Mesh.GlobalIds.size()),
      GetPointOptions(this->Input, this->Options, this->Mesh.IsStamped));
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
    if (SolidProbe<Scheme>(level, this->Options, cells).Run())
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
