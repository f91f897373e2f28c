// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctErrorBounds.cxx
 * GenerateErrorBounds with VolumeScheme = TetOct, whose octahedra are written as four tetrahedra.
 * Where points lie in the cells of a level before is written down from the definition (Mathematics
 * 10).
 */
#include "BoundTools.h"
#include "Turns.h"

using namespace bound_tools;

namespace
{

/// One tetrahedron, n of them around an edge, or 8 around a vertex.
Grid MakeStar(int n, double noise)
{
  std::mt19937 random(static_cast<unsigned>(n));
  const auto draw = [&] { return noise * (random() / 4294967296. - 0.5); };
  std::vector<Point> points;
  std::vector<Cell> cells;
  if (n == 8)
  {
    points.push_back({ draw(), draw(), draw() });
    for (int i = 0; i < 6; ++i)
    {
      Point p{ draw(), draw(), draw() };
      p[i / 2] += i % 2 ? -1. : 1.;
      points.push_back(p);
    }
    for (int i = 0; i < 8; ++i)
    {
      cells.push_back({ VTK_TETRA, { 0, 1 + i % 2, 3 + i / 2 % 2, 5 + i / 4 } });
    }
  }
  else if (n == 1)
  {
    points = { { draw(), 0., 0. }, { 1., draw(), 0. }, { 0., 1., 0. }, { 0., 0., 1. } };
    cells = { { VTK_TETRA, { 0, 1, 2, 3 } } };
  }
  else
  {
    points = { { draw(), 0., 1. }, { draw(), 0., -1. } };
    for (vtkIdType i = 0; i < n; ++i)
    {
      const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / n;
      points.push_back({ std::cos(angle) + draw(), std::sin(angle) + draw(), draw() });
      cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % n } });
    }
  }
  return WithValues(MakeGrid(points, cells));
}

void SetTetOct(Filter* filter)
{
  filter->SetVolumeSchemeToTetOct();
}

/// A tetrahedron or an octahedron.
struct TetOctSolid
{
  vtkIdType Cell;            ///< its first cell in the mesh; an octahedron has four
  std::size_t Of;            ///< the solid of a level before in which it lies
  Ids Points;                ///< four, or six: opposite ones side by side
  std::vector<Point> Places; ///< of the points, in that solid
  bool IsOct() const { return this->Points.size() == 6; }
};

constexpr int Faces[8][3] = { { 0, 2, 4 }, { 1, 4, 2 }, { 0, 4, 3 }, { 1, 3, 4 }, { 0, 5, 2 },
  { 1, 2, 5 }, { 0, 3, 5 }, { 1, 5, 3 } };
constexpr int MiddlePairs[6][2] = { { 0, 1 }, { 2, 3 }, { 0, 3 }, { 1, 2 }, { 0, 2 }, { 1, 3 } };

Point Mean(const Point& a, const Point& b)
{
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
}

/// The children of one solid.
class Splitter
{
public:
  /// `first`: the first of the cells that the solid's first cell was split into.
  Splitter(const TetOctSolid& solid, vtkIdType first, vtkUnstructuredGrid* next,
    std::vector<TetOctSolid>& made)
    : Solid(solid)
    , Next(next)
    , Made(made)
    , First(first)
  {
  }

  void Split()
  {
    if (!this->Solid.IsOct())
    {
      for (int v = 0; v < 4; ++v)
      {
        const Ids child = GetCell(this->Next, this->First + v);
        EXPECT_EQ(child[v], this->Solid.Points[v]);
        for (int w = 0; w < 4; ++w)
        {
          this->Known[Key(v, w)] = child[w];
        }
        this->Add(this->First + v, { { v, 0 }, { v, 1 }, { v, 2 }, { v, 3 } });
      }
      std::vector<std::pair<int, int>> middles;
      for (const auto& pair : MiddlePairs)
      {
        middles.emplace_back(pair[0], pair[1]);
      }
      this->Add(this->First + 4, middles);
      return;
    }
    for (int f = 0; f < 8; ++f)
    {
      const Ids child = GetCell(this->Next, this->First + 24 + f);
      const int* face = Faces[f];
      this->Known[{ -1, -1 }] = child[0];
      for (int i = 0; i < 3; ++i)
      {
        this->Known[Key(face[i], face[(i + 1) % 3])] = child[1 + i];
      }
    }
    for (int v = 0; v < 6; ++v)
    {
      this->Known[{ v, v }] = this->Solid.Points[v];
      std::vector<std::pair<int, int>> points;
      for (int w = 0; w < 6; ++w)
      {
        points.emplace_back(w == (v ^ 1) ? std::pair<int, int>{ -1, -1 } : Key(v, w));
      }
      this->Add(this->First + 4 * v, points);
    }
    for (int f = 0; f < 8; ++f)
    {
      const int* face = Faces[f];
      this->Add(this->First + 24 + f,
        { { -1, -1 }, Key(face[0], face[1]), Key(face[1], face[2]), Key(face[2], face[0]) });
    }
  }

private:
  /// A vertex as v, v; the middle of an edge by its ends; the centre as -1, -1.
  using Name = std::pair<int, int>;
  static Name Key(int v, int w) { return { std::min(v, w), std::max(v, w) }; }

  void Add(vtkIdType cell, const std::vector<Name>& names)
  {
    TetOctSolid child{ cell, this->Solid.Of, {}, {} };
    for (const Name& given : names)
    {
      const Name name = given.first < 0 ? given : Key(given.first, given.second);
      child.Points.push_back(this->Known.at(name));
      const auto& places = this->Solid.Places;
      child.Places.push_back(name.first < 0 ? Mean(places[0], places[1])
                                            : Mean(places[name.first], places[name.second]));
    }
    std::set<vtkIdType> read;
    for (vtkIdType c = cell; c < cell + (child.IsOct() ? 4 : 1); ++c)
    {
      const Ids ids = GetCell(this->Next, c);
      read.insert(ids.begin(), ids.end());
    }
    EXPECT_EQ(read, std::set<vtkIdType>(child.Points.begin(), child.Points.end()));
    this->Made.push_back(child);
  }

  const TetOctSolid& Solid;
  vtkUnstructuredGrid* Next;
  std::vector<TetOctSolid>& Made;
  const vtkIdType First;
  std::map<Name, vtkIdType> Known;
};

/// The weights of the corners of a cell at a place; a negative one if it is not in the cell.
std::array<double, 4> WeighCorners(const TetOctSolid& solid, const Ids& cell, const Point& place)
{
  std::array<double, 4> weights{};
  if (!solid.IsOct())
  {
    return { { 1. - place[0] - place[1] - place[2], place[0], place[1], place[2] } };
  }
  double left = 1.;
  std::array<int, 4> vertices{};
  std::array<int, 3> counts{};
  for (int k = 0; k < 4; ++k)
  {
    const auto found = std::find(solid.Points.begin(), solid.Points.end(), cell[k]);
    vertices[k] = static_cast<int>(found - solid.Points.begin());
    ++counts[vertices[k] / 2];
  }
  const auto along = [&](int k) { return (vertices[k] % 2 ? -1. : 1.) * place[vertices[k] / 2]; };
  for (int k = 0; k < 4; ++k)
  {
    if (counts[vertices[k] / 2] == 1)
    {
      weights[k] = along(k);
      left -= weights[k];
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    if (counts[vertices[k] / 2] == 2)
    {
      weights[k] = 0.5 * (left + along(k));
    }
  }
  return weights;
}

/// The tetrahedra of a control mesh: `Of` is the cell, and a place says the weights of its corners
/// but the first.
std::vector<TetOctSolid> ListControlTets(vtkUnstructuredGrid* control)
{
  std::vector<TetOctSolid> solids;
  for (vtkIdType c = 0; c < control->GetNumberOfCells(); ++c)
  {
    if (control->GetCellType(c) == VTK_TETRA)
    {
      solids.push_back({ c, static_cast<std::size_t>(c), GetCell(control, c),
        { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. } } });
    }
  }
  return solids;
}

/// What one step made of those of a mesh.
std::vector<TetOctSolid> SplitTetOct(
  const std::vector<TetOctSolid>& solids, vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* next)
{
  Ids firsts{ 0 }; // a cell of dimension d becomes 2^d cells
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    const auto dimension = static_cast<int>(GetCell(mesh, c).size()) - 1;
    firsts.push_back(firsts.back() + (vtkIdType(1) << dimension));
  }
  std::vector<TetOctSolid> made;
  for (const TetOctSolid& solid : solids)
  {
    Splitter(solid, firsts[solid.Cell], next, made).Split();
  }
  return made;
}

/// Each is itself the one in which it lies: a tetrahedron has places as in ListControlTets, an
/// octahedron has its points at 1 and -1 of each axis.
std::vector<TetOctSolid> Restart(std::vector<TetOctSolid> solids)
{
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    solids[i].Of = i;
    for (std::size_t v = 0; v < solids[i].Points.size(); ++v)
    {
      Point place{};
      if (solids[i].IsOct())
      {
        place[v / 2] = v % 2 ? -1. : 1.;
      }
      else if (v > 0)
      {
        place[v - 1] = 1.;
      }
      solids[i].Places[v] = place;
    }
  }
  return solids;
}

/// The points of fine solids in the cells of the mesh in whose solids they lie.
PlacedPoints PlaceTetOctPoints(vtkUnstructuredGrid* coarse, const std::vector<TetOctSolid>& solids,
  const std::vector<TetOctSolid>& fine)
{
  PlacedPoints placed;
  std::set<std::pair<std::size_t, vtkIdType>> known;
  for (const TetOctSolid& part : fine)
  {
    const TetOctSolid& solid = solids[part.Of];
    for (std::size_t v = 0; v < part.Points.size(); ++v)
    {
      if (!known.insert({ part.Of, part.Points[v] }).second)
      {
        continue;
      }
      for (vtkIdType c = solid.Cell; c < solid.Cell + (solid.IsOct() ? 4 : 1); ++c)
      {
        const auto weights = WeighCorners(solid, GetCell(coarse, c), part.Places[v]);
        if (*std::min_element(weights.begin(), weights.end()) > -1e-9)
        {
          placed[c].push_back({ part.Points[v], weights });
        }
      }
    }
  }
  return placed;
}

/// The solids after some levels.
std::vector<TetOctSolid> FindTetOctSolids(
  vtkDataObject* input, int levels, const Configure& configure = {})
{
  std::vector<TetOctSolid> solids;
  Grid before;
  for (int level = 0; level <= levels; ++level)
  {
    const Grid mesh = Execute(input, level,
      [&](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        if (configure)
        {
          configure(filter);
        }
      });
    solids = level == 0 ? ListControlTets(mesh) : SplitTetOct(solids, before, mesh);
    before = mesh;
  }
  return solids;
}

/// Expects that bounds hold at all points of so many further steps, as ExpectBounds.
void ExpectTetOctBounds(vtkDataObject* input, int levels, int steps, const Configure& configure,
  bool projects, Tightness& tightness)
{
  const Configure both = [&](Filter* filter)
  {
    filter->SetVolumeSchemeToTetOct();
    if (configure)
    {
      configure(filter);
    }
  };
  const auto bounded = MakeBounded<Filter>(input, levels, steps, both, projects);
  std::vector<TetOctSolid> solids = Restart(FindTetOctSolids(input, levels, configure));
  std::vector<TetOctSolid> fine = solids;
  Grid before = bounded.Coarse;
  for (int step = 1; step <= steps; ++step)
  {
    const Grid mesh = Execute(input, levels + step, both);
    fine = SplitTetOct(fine, before, mesh);
    before = mesh;
  }
  const PlacedPoints placed = PlaceTetOctPoints(bounded.Coarse, solids, fine);
  ExpectBounds(bounded.Coarse, bounded.Fine, steps, tightness, 1e-12, &placed);
}

}

TEST(TetOctErrorBounds, HoldAtRandomPlaces)
{
  std::mt19937 random(5);
  vtkIdType places = 0;
  const auto check = [&](vtkUnstructuredGrid* mesh, int levels, int count, bool projects)
  {
    if (!turns::IsNextInTurn())
    {
      return;
    }
    const Grid input = WithValues(mesh);
    vtkNew<Filter> filter;
    SetTetOct(filter);
    const Grid output = UpdateWithBounds(filter.Get(), input, levels, projects);
    const std::vector<TetOctSolid> solids = FindTetOctSolids(input, levels);
    PlacesOfParts drawn;
    for (int i = 0; i < count; ++i)
    {
      const TetOctSolid& solid = solids[random() % solids.size()];
      const vtkIdType part =
        solid.Cell + (solid.IsOct() ? static_cast<vtkIdType>(random() % 4) : 0);
      const Ids corners = GetCell(output, part);
      const std::array<double, 4> weights = DrawWeights(random, 4);
      Point place{};
      for (int k = 0; k < 4; ++k)
      {
        const auto at = std::find(solid.Points.begin(), solid.Points.end(), corners[k]);
        for (int x = 0; x < 3; ++x)
        {
          place[x] += weights[k] * solid.Places[at - solid.Points.begin()][x];
        }
      }
      drawn.Add(part, weights, static_cast<vtkIdType>(solid.Of), place);
    }
    ExpectBoundsAtPlaces(filter, output, drawn);
    places += count;
  };
  for (const bool projects : { false, true })
  {
    for (const int n : { 3, 4, 5, 8 })
    {
      check(MakeStar(n, 0.3), n % 2, 4500, projects);
    }
  }
  check(MakeStar(5, 0.3), 2, 4500, false);
  EXPECT_GT(places, turns::GetShare(40000));
}

TEST(TetOctErrorBounds, HoldAndAreNearTheTruth)
{
  vtkIdType samples = 0;
  for (const bool projects : { false, true })
  {
    for (const int n : { 1, 3, 4, 7, 8 })
    {
      for (const int levels : turns::Some({ 0, 1, 2 }))
      {
        Tightness found;
        ExpectTetOctBounds(MakeStar(n, 0.3), levels, levels == 2 ? 3 : 4, {}, projects, found);
        EXPECT_LT(found.GetMedian(), projects ? 2.5 : 1.3) << n << " " << levels;
        EXPECT_LT(found.GetLargest(), 3.) << n << " " << levels << " " << projects;
        samples += found.Samples;
      }
    }
  }
  EXPECT_GT(samples, turns::GetShare(1000000));
}

TEST(TetOctErrorBounds, AreNearTheTruthOnRandomComplexes)
{
  Tightness found;
  std::vector<unsigned> seeds(99);
  std::iota(seeds.begin(), seeds.end(), 1U);
  seeds.push_back(270); // two tetrahedra are equal, with other orders of corners after a level
  for (const unsigned seed : seeds)
  {
    if (!turns::IsInTurn(seed))
    {
      continue;
    }
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    random();
    const Grid input = WithValues(MakeRandomComplex(seed));
    const unsigned bits = random() >> 4;
    const Configure configure = ChooseFeatures(bits);
    ExpectTetOctBounds(input, bits / 120 % 2, 3, configure, bits / 60 % 2 == 0, found);
  }
  ExpectRatios(found, turns::GetShare(5000), 2.45);
}

/// A filter that reads octahedra starts with them.
TEST(TetOctErrorBounds, GoOnWithAFilterBefore)
{
  const Grid input = MakeStar(4, 0.3);
  const Configure configure = [](Filter* filter)
  {
    SetTetOct(filter);
    filter->GenerateErrorBoundsOn();
  };
  const Grid both = Execute(input, 2, configure);
  const Grid first = Execute(input, 1, configure);
  const Grid second = Execute(first, 1, configure);
  const Grid none = Execute(first, 0, configure);
  const auto expectSame = [](vtkUnstructuredGrid* one, vtkUnstructuredGrid* other)
  {
    for (const char* name : { "ErrorBound", "OneErrorBound", "TwoErrorBound" })
    {
      vtkDataArray* a = one->GetCellData()->GetArray(name);
      vtkDataArray* b = other->GetCellData()->GetArray(name);
      ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
      for (vtkIdType c = 0; c < a->GetNumberOfTuples(); ++c)
      {
        EXPECT_GT(a->GetComponent(c, 0), 0.);
        EXPECT_NEAR(a->GetComponent(c, 0), b->GetComponent(c, 0), 1e-12) << name << " of " << c;
      }
    }
  };
  expectSame(both, second);
  expectSame(first, none);
}

TEST(TetOctErrorBounds, DoNotDependOnThreads)
{
  const Configure configure = [](Filter* filter)
  {
    SetTetOct(filter);
    filter->GenerateErrorBoundsOn();
    filter->ProjectToLimitOn();
  };
  const Grid one = MakeInThreads([&] { return Execute(MakeStar(8, 0.3), 1, configure); });
  ASSERT_NE(one->GetCellData()->GetArray("ErrorBound"), nullptr);
}
