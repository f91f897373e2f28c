// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridSkin.cxx
 * Tangents by the skin of the level before the last against those of the last level.
 */
#include "Precompiled.h"

#include "HybridTools.h"
#include "HybridZoo.h"

#include "Core/Solids/Hybrid/HybridSkin.h"
#include "Core/Solids/Hybrid/HybridTangents.h"

#include <random>

namespace
{

using namespace hybrid_tools;

template <typename Id>
struct Frames
{
  Buffer<double> Normals;
  Buffer<double> Tangents[2];

  Frames(const SkinTangents<Id>& of, const std::vector<double>& points,
    const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned)
  {
    const auto size = static_cast<vtkIdType>(points.size()) / 3;
    this->Normals = of.ComputeNormals(points.data(), size, inverted, turned);
    of.ComputeTangents(points.data(), size, inverted, turned, this->Tangents);
  }
};

/// `missing`: of points without tangent plane, whose normals come from stars some 40 levels later:
/// rounding, in another order, counts up to 10^4 times there, and once more in each such step.
void ExpectNear(const Buffer<double>& a, const Buffer<double>& b, const char* what,
  const Buffer<unsigned char>& missing)
{
  ASSERT_EQ(a.size(), b.size());
  for (vtkIdType i = 0; i < a.size(); ++i)
  {
    ASSERT_NEAR(a[i], b[i], missing[i / 3] ? 1e-8 : 1e-13) << what << " of point " << i / 3;
  }
}

std::vector<vtkIdType> CountUp(vtkIdType size)
{
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(size));
  std::iota(numbers.begin(), numbers.end(), vtkIdType(0));
  return numbers;
}

/// Compares both ways on each of the first levels that have closed skins, and says how many these
/// are. Some solids count as inside out.
template <typename Id>
int Compare(const HybridMesh& mesh, int levels, unsigned int seed)
{
  const HybridLevel<Id> control = MakeLevel<Id>(mesh);
  std::mt19937 random(seed);
  std::vector<vtkIdType> controls = CountUp(control.Complex.Cells.GetNumberOfCells());
  std::vector<vtkIdType> inverted;
  for (const vtkIdType c : controls)
  {
    random() % 4 == 0 ? inverted.push_back(2 * c) : void();
  }
  const Buffer<unsigned char> turned = FindPolygonSides(control).ListTurned();
  std::vector<double> points = mesh.Points;
  HybridLevel<Id> level = MakeLevel<Id>(mesh);
  int compared = 0;
  for (int steps = 1; steps <= levels; ++steps)
  {
    SCOPED_TRACE(std::to_string(steps) + " steps");
    points = ApplyStep(level, points);
    const bool isClosed = HasClosedSkin(control, steps, true);
    SkinTangents<Id> skin;
    if (isClosed)
    {
      EXPECT_TRUE(HasClosedSkin(level, 1, true)) << "children inherit it";
      EXPECT_TRUE(HasClosedSkin(control, steps, false));
      skin = BuildHybridSkinTangents(level, controls, steps);
      EXPECT_EQ(skin.HasAll, level.Complex.NumberOfTets == 0);
    }
    controls = GiveTo(FindFirstChildren(level.Complex.Cells), controls);
    level = RefineHybrid(level, HybridRules::Smooth);
    if (isClosed)
    {
      SkinTangents<Id> whole;
      whole.Tangents = BuildHybridTangents(level, controls, steps);
      const Frames<Id> a(skin, points, inverted, turned);
      const Frames<Id> b(whole, points, inverted, turned);
      const Buffer<unsigned char> missing = whole.Tangents.FindMissing();
      ExpectNear(a.Normals, b.Normals, "normal", missing);
      ExpectNear(a.Tangents[0], b.Tangents[0], "first tangent", missing);
      ExpectNear(a.Tangents[1], b.Tangents[1], "second tangent", missing);
      ++compared;
    }
  }
  return compared;
}

/// The zoo, without what lies at solids.
HybridMesh MakeSolids(unsigned int seed)
{
  HybridMesh mesh = Take(hybridtest::MakeRandomHybrid(seed));
  mesh.Cells.erase(std::remove_if(mesh.Cells.begin(), mesh.Cells.end(),
                     [](const Cell& cell) { return GetCellTable(cell.Shape).Dimension < 3; }),
    mesh.Cells.end());
  return mesh;
}

/// Some quads and triangles of the outside of a mesh of solids.
HybridMesh MakeSurface(unsigned int seed)
{
  const HybridMesh solids = MakeSolids(seed);
  const auto complex = std::move(MakeLevel<int>(solids).Complex);
  HybridMesh mesh = solids;
  mesh.Cells.clear();
  for (int f = 0; f < complex.NumberOfFaces; ++f)
  {
    const Row<int> corners = complex.GetVertices(f);
    if (complex.FaceSolids[f].size() == 1 && (seed + f) % 7 > 0)
    {
      mesh.Cells.push_back({ corners.size() == 4 ? CellShape::Quad : CellShape::Triangle,
        { corners.begin(), corners.end() } });
    }
  }
  return mesh;
}

}

TEST(HybridSkin, SolidsEqualTheLastLevel)
{
  int compared = 0;
  int curved = 0;
  for (unsigned int seed = 0; seed < 120; ++seed)
  {
    SCOPED_TRACE(seed);
    HybridMesh mesh = MakeSolids(seed);
    mesh.Options.ModifiedBoundary = seed % 3 == 0;
    if (seed % 5 == 0)
    {
      mesh.Cells.push_back(mesh.Cells[mesh.Cells.size() / 2]); // maybe a twin
    }
    const int levels = mesh.Cells.size() < 8 ? 3 : mesh.Cells.size() < 20 ? 2 : 1;
    const int found =
      seed % 2 == 0 ? Compare<int>(mesh, levels, seed) : Compare<long long>(mesh, levels, seed);
    compared += found;
    curved += mesh.Singular.empty() ? 0 : found;
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(curved, 15);
}

/// Creases and corners on the outside, all solids' edges there by turns.
TEST(HybridSkin, CreasesAndCorners)
{
  int compared = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    HybridMesh mesh = MakeSolids(seed);
    mesh.Singular.clear();
    mesh.Options.ModifiedBoundary = seed % 2 == 0;
    const auto complex = std::move(MakeLevel<int>(mesh).Complex);
    for (int f = 0; f < complex.NumberOfFaces; ++f)
    {
      for (const int edge : complex.GetEdges(f))
      {
        const int* ends = complex.EdgeVertices.data() + 2 * edge;
        if (complex.FaceSolids[f].size() == 1 && (ends[0] + ends[1] + seed) % (2 + seed % 3) == 0)
        {
          mesh.Singular.insert(coretest::Tuple(ends, ends + 2));
        }
      }
    }
    if (seed % 4 == 0)
    {
      AddSharpness(seed, mesh);
    }
    compared += Compare<int>(mesh, mesh.Cells.size() < 12 ? 2 : 1, seed);
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
  }
  EXPECT_GT(compared, 30);
}

TEST(HybridSkin, SurfacesAreTheirOwnSkin)
{
  for (unsigned int seed = 0; seed < 24; ++seed)
  {
    SCOPED_TRACE(seed);
    HybridMesh mesh = MakeSurface(seed);
    if (seed % 3 == 0)
    {
      mesh.Cells.push_back({ CellShape::Line, { 0, 1 } });
      mesh.Cells.push_back({ CellShape::Vertex, { 2 } });
    }
    seed % 4 == 0 ? AddSharpness(seed, mesh) : void();
    EXPECT_EQ(Compare<int>(mesh, 2, seed), 2);
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}

TEST(HybridSkin, IsNotClosedWhereRulesReadSolids)
{
  const HybridMesh box = MakeBox(2, 0);
  const auto isClosed = [](const HybridMesh& mesh, int steps = 1, bool wantsCurves = false)
  { return HasClosedSkin(MakeLevel<int>(mesh), steps, wantsCurves); };
  EXPECT_TRUE(isClosed(box, 1, true));
  HybridMesh changed = box;
  changed.AddPoint(0., 0., 3.);
  changed.Cells.push_back({ CellShape::Line, { 0, 27 } });
  EXPECT_FALSE(isClosed(changed)) << "a line at a solid";
  changed.Cells.back() = { CellShape::Triangle, { 0, 1, 27 } };
  EXPECT_FALSE(isClosed(changed)) << "a surface at a solid";
  changed.Cells.back() = { CellShape::Vertex, { 13 } };
  EXPECT_FALSE(isClosed(changed)) << "a vertex inside";
  changed = box;
  changed.Singular = { { 4, 13 }, { 13, 22 } };
  EXPECT_TRUE(isClosed(changed)) << "a curve inside";
  EXPECT_FALSE(isClosed(changed, 1, true));
  changed = box;
  changed.Sharpness[{ 0, 1 }] = 1.5;
  EXPECT_FALSE(isClosed(changed, 1));
  EXPECT_TRUE(isClosed(changed, 2)) << "it is sharp for two steps";
}

TEST(HybridSkin, LooksSmooth)
{
  const auto looksSmooth = [](const HybridMesh& mesh, int steps = 1)
  { return LooksSmooth(MakeLevel<int>(mesh), steps); };
  HybridMesh box = MakeBox(2, 0);
  EXPECT_TRUE(looksSmooth(box));
  box.AddPoint(0., 0., 3.); // which no cell has
  EXPECT_TRUE(looksSmooth(box));
  HybridMesh changed = box;
  changed.Singular = { { 0, 1 } };
  EXPECT_FALSE(looksSmooth(changed)) << "a crease";
  changed.Singular = { { 4 } };
  EXPECT_FALSE(looksSmooth(changed)) << "a corner";
  changed = box;
  changed.Sharpness[{ 0, 1 }] = 1.5;
  EXPECT_FALSE(looksSmooth(changed, 1));
  EXPECT_TRUE(looksSmooth(changed, 2));
  changed = box;
  changed.Cells.push_back({ CellShape::Triangle, { 0, 1, 27 } });
  EXPECT_FALSE(looksSmooth(changed)) << "a joint";
  // A strip of quads, closed with half a turn or not.
  HybridMesh strip;
  for (int i = 0; i < 12; ++i)
  {
    strip.AddPoint(i / 2, i % 2, std::sin(1. * i));
  }
  for (int i = 0; i < 5; ++i)
  {
    strip.Cells.push_back({ CellShape::Quad, { 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2 } });
  }
  EXPECT_TRUE(looksSmooth(strip)) << "a border";
  changed = strip;
  changed.Cells.push_back({ CellShape::Quad, { 10, 11, 1, 0 } });
  EXPECT_TRUE(looksSmooth(changed)) << "a ring";
  changed.Cells.back() = { CellShape::Quad, { 10, 11, 0, 1 } };
  EXPECT_FALSE(looksSmooth(changed)) << "a strip with one side";
  changed = strip;
  changed.Cells.push_back({ CellShape::Quad, { 2, 3, 5, 11 } });
  EXPECT_FALSE(looksSmooth(changed)) << "three quads at an edge";
  changed = strip;
  changed.Singular = { { 4, 5 } };
  EXPECT_FALSE(looksSmooth(changed)) << "a crease";
  changed.Singular = { { 5 } };
  EXPECT_TRUE(looksSmooth(changed)) << "a corner of the border";
  changed = strip;
  changed.Cells.push_back({ CellShape::Line, { 11, 0 } });
  EXPECT_FALSE(looksSmooth(changed)) << "a line";
}
