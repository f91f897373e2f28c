// SPDX-License-Identifier: BSD-3-Clause
// Limits on curves and in sheets by rows of equal neighbourhoods, against the uniform refinement.
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Solids/Limits/LatticeNames.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/SheetLimits.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

using namespace tetoct_tools;

namespace
{

constexpr int Components = 2;

/// The uniform refinement, and a local one with some of its vertices.
template <typename LevelType>
class SheetCase
{
public:
  SheetCase(const Mesh& mesh, const std::string& options, unsigned int rarely)
    : Given(static_cast<int>(mesh.Cells.NumberOfPoints))
  {
    this->Levels.push_back(
      SchemeOf<LevelType>::Start(std::move(BuildNamed<int>(mesh, options).Level)));
    this->Values = MakeValues(Components * this->Given, 3);
    std::vector<double> values = this->Values;
    for (int step = 0; step < 3; ++step)
    {
      values = ApplyTo(CopyStencils(this->Levels.back()), values, Components);
      this->Levels.push_back(Refine(this->Levels.back(), Depth::ForRefinement));
    }
    this->Uniform = ApplyTo(BuildLimitRows(this->Levels.back()), values, Components);
    this->Ask(rarely);
  }

  void Compare()
  {
    Buffer<unsigned char> wanted(this->Given + static_cast<vtkIdType>(this->Ends.size()), 1);
    const SheetLimits<int> limits(
      this->Levels[0], this->Ends, wanted, this->Sites, this->Values.data(), Components);
    for (const auto& [uniform, number] : this->Numbers)
    {
      this->Expect(limits.OfVertices, number, uniform, this->KnownVertices);
    }
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      this->Expect(limits.OfSites, static_cast<vtkIdType>(i), this->Places[i], this->KnownPlaces);
    }
  }
  /// Whether no rule but those of curves and surfaces occurs.
  bool IsOfSheets() const
  {
    const auto& strata = this->Levels[0].Strata;
    const auto isBeyond = [](Stratum stratum) { return stratum.GetRule() > Rule::Surface; };
    return std::none_of(strata.Vertices.begin(), strata.Vertices.end(), isBeyond) &&
      std::none_of(strata.Edges.begin(), strata.Edges.end(), isBeyond) &&
      std::none_of(strata.Faces.begin(), strata.Faces.end(), isBeyond);
  }

  int KnownVertices = 0;
  int KnownPlaces = 0;
  std::vector<int> Places; ///< three vertices of the uniform refinement for each site

private:
  /// Asks for some midpoints on curves and surfaces, and for all edges and faces between them.
  void Ask(unsigned int rarely)
  {
    const auto isCurved = [](Stratum stratum)
    { return stratum.GetRule() != Rule::Solid && stratum.GetRule() != Rule::RegularEdge; };
    for (int v = 0; v < this->Given; ++v)
    {
      this->Numbers[v] = v;
    }
    for (int l = 0; l < 2; ++l)
    {
      const auto& complex = this->Levels[l].Complex;
      const auto& strata = this->Levels[l].Strata;
      const int next = this->Levels[l + 1].Complex.NumberOfVertices;
      const int onlyNew = l == 0 ? 0 : this->Levels[l - 1].Complex.NumberOfVertices;
      std::map<int, int> more = this->Numbers;
      for (int e = 0; e < complex.NumberOfEdges; ++e)
      {
        const int* ends = complex.EdgeVertices.data() + 2 * e;
        if (!isCurved(strata.Edges[e]) || !this->HasAll(ends, 2))
        {
          continue;
        }
        const int middle = complex.NumberOfVertices + e;
        this->AddSite(ends, 2, { next + 2 * e, middle, next + 2 * e + 1 });
        if (this->Random() % rarely == 0)
        {
          more[middle] = this->Given + static_cast<int>(this->Ends.size());
          this->Ends.push_back({ this->Numbers[ends[0]], this->Numbers[ends[1]] });
        }
      }
      for (int f = 0; f < complex.NumberOfFaces; ++f)
      {
        const int* corners = complex.FaceVertices.data() + 3 * f;
        if (isCurved(strata.Faces[f]) && this->HasAll(corners, 3) &&
          *std::max_element(corners, corners + 3) >= onlyNew)
        {
          const int inside = next + 2 * complex.NumberOfEdges + 3 * f;
          this->AddSite(corners, 3, { inside, inside + 1, inside + 2 });
        }
      }
      this->Numbers = more;
    }
  }
  bool HasAll(const int* vertices, int size) const
  {
    return std::all_of(
      vertices, vertices + size, [this](int v) { return this->Numbers.count(v) > 0; });
  }
  void AddSite(const int* corners, int size, std::array<int, 3> places)
  {
    LimitSite<int> site;
    const int turn = static_cast<int>(this->Sites.size()) % size; // cells have corners in any order
    for (int k = 0; k < size; ++k)
    {
      site.Corners[k] = this->Numbers[corners[(k + turn) % size]];
    }
    if (size == 2)
    {
      std::swap(places[0], places[turn == 0 ? 0 : 2]);
    }
    else
    {
      std::rotate(places.begin(), places.begin() + turn, places.end());
    }
    this->Places.insert(this->Places.end(), places.begin(), places.end());
    this->Sites.push_back(site);
  }
  void Expect(const Buffer<double>& found, vtkIdType place, int uniform, int& known) const
  {
    if (!std::isnan(found[Components * place]))
    {
      ++known;
      for (int c = 0; c < Components; ++c)
      {
        ASSERT_NEAR(found[Components * place + c], this->Uniform[Components * uniform + c], 1e-13);
      }
    }
  }

  const int Given;
  std::mt19937 Random{ 9 };
  std::vector<LevelType> Levels;
  std::vector<double> Values;
  std::vector<double> Uniform;
  std::map<int, int> Numbers; ///< of uniform vertices among those asked for
  std::vector<std::array<int, 2>> Ends;
  std::vector<LimitSite<int>> Sites;
};

template <typename LevelType>
void ExpectUniformLimits()
{
  std::mt19937 random(4);
  int known = 0;
  int all = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      SheetCase<LevelType> which(mesh, options, 1 + random() % 2);
      which.Compare();
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
      known += which.KnownPlaces;
      all += static_cast<int>(which.Places.size());
    }
  }
  EXPECT_GT(known, all / 4);
}

}

/// By values, so that limits have the same bits whatever numbers the corners have; equal ones stay
/// in their order.
TEST(SheetLimits, CornersAreSorted)
{
  for (int all = 0; all < 27; ++all)
  {
    const std::array<int, 3> values{ { all % 3, all / 3 % 3, all / 9 } };
    const auto isBefore = [&](int a, int b) { return values[a] < values[b]; };
    for (const int size : { 2, 3 })
    {
      std::vector<int> expected{ 0, 1, 2 };
      std::stable_sort(expected.begin(), expected.begin() + size, isBefore);
      const std::array<int, 3> sorted = SortCorners(size, isBefore);
      EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin())) << all << " " << size;
    }
  }
}

TEST(SheetLimits, EqualTheUniformRefinementOnTheWholeZoo)
{
  ExpectUniformLimits<Level<int>>();
}

TEST(SheetLimits, EqualTheUniformRefinementOfTheTetOctScheme)
{
  ExpectUniformLimits<TetOctLevel<int>>();
}

/// What follows the rules of curves and surfaces is found, and not left to LocalLimit. Triangles
/// without neighbours are left to it.
TEST(SheetLimits, KnowAllOfCurvesAndSurfaces)
{
  int meshes = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    SheetCase<Level<int>> which(mesh, "Blend", 1);
    which.Compare();
    const bool isAlone = mesh.Name == "SingleTriangle" || mesh.Name == "RepeatedTriangles";
    if (which.IsOfSheets() && !which.Places.empty() && !isAlone)
    {
      ++meshes;
      EXPECT_EQ(which.KnownPlaces, static_cast<int>(which.Places.size()));
    }
  }
  EXPECT_GT(meshes, 3);
}

namespace
{

/// Small faces and edges of some levels in a row, on curves and surfaces of a mesh.
class DeepSites
{
public:
  DeepSites(const Level<int>& level, unsigned int seed)
    : Given(level.Complex.NumberOfVertices)
    , Names(level.Complex.NumberOfVertices)
    , Random(seed)
  {
    const auto isCurved = [](Stratum stratum)
    { return stratum.GetRule() != Rule::Solid && stratum.GetRule() != Rule::RegularEdge; };
    this->GoDown(level.Complex.FaceVertices, level.Strata.Faces, 3, isCurved);
    this->GoDown(level.Complex.EdgeVertices, level.Strata.Edges, 2, isCurved);
    this->Existing = this->Names.GetMidpoints();
    for (const LimitSite<int>& site : this->Sites)
    {
      this->NamePlaces(site);
    }
  }

  /// All limits that rows of sheets give are those of a mesh with its solids.
  void Compare(const Level<int>& level) const
  {
    const std::vector<double> values = MakeValues(Components * this->Given, 3);
    const SheetLimits<int> limits(level, this->Existing,
      Buffer<unsigned char>(this->Given + static_cast<vtkIdType>(this->Existing.size()), 1),
      this->Sites, values.data(), Components);
    const auto find = [&](bool isCurvedOnly)
    {
      return ApplyTo(LocalLimit<int>(level, {}, this->Names.GetMidpoints(), Buffer<unsigned char>(),
                       1, nullptr, isCurvedOnly),
        values, Components);
    };
    const std::vector<double> expected = find(false);
    const std::vector<double> curved = find(true);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      if (i / Components >= static_cast<std::size_t>(this->Given))
      {
        ASSERT_NEAR(curved[i], expected[i], 1e-12) << i;
      }
    }
    const auto compare = [&](const Buffer<double>& found, vtkIdType at, int vertex)
    {
      for (int c = 0; c < Components && !std::isnan(found[Components * at]); ++c)
      {
        ASSERT_NEAR(found[Components * at + c], expected[Components * vertex + c], 1e-12);
      }
    };
    for (int v = this->Given; v < this->Given + static_cast<int>(this->Existing.size()); ++v)
    {
      compare(limits.OfVertices, v, v);
    }
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      compare(limits.OfSites, static_cast<vtkIdType>(i), this->Places[i]);
    }
  }
  bool IsEmpty() const { return this->Sites.empty(); }

private:
  template <typename IsCurved>
  void GoDown(
    const Buffer<int>& vertices, const Buffer<Stratum>& strata, int size, const IsCurved& isCurved)
  {
    for (int descent = 0; descent < 5 && !strata.empty(); ++descent)
    {
      const auto start = static_cast<vtkIdType>(this->Random() % strata.size());
      if (!isCurved(strata[start]))
      {
        continue;
      }
      std::array<int, 4> corners{ { -1, -1, -1, -1 } };
      std::copy_n(vertices.data() + size * start, size, corners.begin());
      for (int depth = 0; depth < 5; ++depth)
      {
        const auto children = ListChildren(size - 1).size();
        corners = GetCornersOfChild(
          corners, size - 1, static_cast<int>(this->Random() % children), this->Names);
        this->Sites.push_back({ { { corners[0], corners[1], size < 3 ? -1 : corners[2] } } });
      }
    }
  }
  void NamePlaces(const LimitSite<int>& site)
  {
    const auto& at = site.Corners;
    const auto middle = [this](int a, int b) { return this->Names.GetMidpoint(a, b); };
    for (int k = 0; k < 3; ++k)
    {
      if (site.IsFace())
      {
        const int first = middle(at[k], at[(k + 1) % 3]);
        this->Places.push_back(middle(first, middle(at[k], at[(k + 2) % 3])));
      }
      else
      {
        const int half = middle(at[0], at[1]);
        this->Places.push_back(k == 1 ? half : middle(half, at[k / 2]));
      }
    }
  }

  const int Given;
  VertexNames<int> Names;
  std::mt19937 Random;
  std::vector<LimitSite<int>> Sites;
  std::vector<std::array<int, 2>> Existing; ///< midpoints that are corners of sites
  std::vector<int> Places;                  ///< three vertices for each site
};

}

/// Parts without solids have edges and faces that only look like creases and boundaries, and
/// sectors of which a bound is missing.
TEST(SheetLimits, DeepPartsAreThoseOfTheMeshWithItsSolids)
{
  int cases = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const Level<int> level = std::move(BuildNamed<int>(mesh, options).Level);
      const DeepSites sites(level, 7 + cases);
      if (!sites.IsEmpty())
      {
        ++cases;
        sites.Compare(level);
      }
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(cases, 100);
}
