// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesFiles.cxx
 * Fractures and interfaces of real meshes stay what they are: the children of their triangles, in
 * one piece, planar where they were.
 */
#include "FeatureTools.h"
#include "FileTools.h"

using namespace feature_tools;
using namespace file_tools;

namespace
{

struct File
{
  const char* Name;
  const char* Array;
  int PlanarFractures;
};

class FeaturesFiles : public testing::TestWithParam<File>
{
protected:
  void SetUp() override
  {
    const std::string path = GetSharedFile(std::string(this->GetParam().Name) + ".vtu");
    if (const std::string reason = WhyNotRead(path); !reason.empty())
    {
      GTEST_SKIP() << reason;
    }
    this->Input = DeepCopy(ReadGrid(path));
    ASSERT_TRUE(this->Input->GetCellData()->GetArray(this->GetParam().Array));
  }
  vtkIdType GetValue(vtkUnstructuredGrid* grid, vtkIdType cell) const
  {
    return static_cast<vtkIdType>(
      grid->GetCellData()->GetArray(this->GetParam().Array)->GetTuple1(cell));
  }
  /// The cells of a type, by the value of the file's array.
  std::map<vtkIdType, std::vector<Ids>> GetGroups(vtkUnstructuredGrid* grid, int type) const
  {
    std::map<vtkIdType, std::vector<Ids>> groups;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      if (grid->GetCellType(i) == type)
      {
        groups[this->GetValue(grid, i)].push_back(GetCell(grid, i));
      }
    }
    return groups;
  }

  Grid Input;
};

Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// How many edges have one, two, three ... different triangles of a surface.
std::map<int, int> CountEdges(const std::vector<Ids>& triangles)
{
  std::set<Ids> different;
  std::map<Ids, int> edges;
  for (const Ids& t : triangles)
  {
    if (different.insert(Sorted(t)).second)
    {
      for (int i = 0; i < 3; ++i)
      {
        ++edges[Sorted({ t[i], t[(i + 1) % 3] })];
      }
    }
  }
  std::map<int, int> counts;
  for (const auto& edge : edges)
  {
    ++counts[edge.second];
  }
  return counts;
}

/// Pieces of a surface, where triangles hold together by edges.
int CountPieces(const std::vector<Ids>& triangles)
{
  std::map<Ids, std::vector<std::size_t>> atEdge;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      atEdge[Sorted({ triangles[i][k], triangles[i][(k + 1) % 3] })].push_back(i);
    }
  }
  std::vector<bool> seen(triangles.size(), false);
  int pieces = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    std::vector<std::size_t> front;
    if (!seen[i])
    {
      ++pieces;
      seen[i] = true;
      front.push_back(i);
    }
    while (!front.empty())
    {
      const Ids t = triangles[front.back()];
      front.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        for (std::size_t next : atEdge[Sorted({ t[k], t[(k + 1) % 3] })])
        {
          if (!seen[next])
          {
            seen[next] = true;
            front.push_back(next);
          }
        }
      }
    }
  }
  return pieces;
}

/// A surface and its refinement: as many pieces, and borders and branches that were split along.
void ExpectRefined(const std::vector<Ids>& coarse, const std::vector<Ids>& fine, int levels)
{
  EXPECT_EQ(fine.size(), coarse.size() << (2 * levels));
  EXPECT_EQ(CountPieces(fine), CountPieces(coarse));
  const auto before = CountEdges(coarse);
  const auto after = CountEdges(fine);
  EXPECT_EQ(before.size() + (before.count(2) ? 0 : 1), after.size());
  for (const auto& count : before)
  {
    if (count.first != 2)
    {
      const auto found = after.find(count.first);
      EXPECT_TRUE(found != after.end() && found->second == count.second << levels) << count.first;
    }
  }
}

std::set<Ids> FindFaces(const std::vector<Ids>& tets)
{
  std::set<Ids> faces;
  for (const Ids& tet : tets)
  {
    for (int i = 0; i < 4; ++i)
    {
      Ids face = tet;
      face.erase(face.begin() + i);
      faces.insert(Sorted(face));
    }
  }
  return faces;
}

/// Faces between tetrahedra of different values, by the pair of values.
std::map<std::pair<vtkIdType, vtkIdType>, std::vector<Ids>> FindInterfaces(
  const std::map<vtkIdType, std::vector<Ids>>& solids)
{
  std::map<Ids, vtkIdType> owners;
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<Ids>> interfaces;
  for (const auto& solid : solids)
  {
    for (const Ids& tet : solid.second)
    {
      for (int i = 0; i < 4; ++i)
      {
        Ids face = tet;
        face.erase(face.begin() + i);
        const auto owner = owners.emplace(Sorted(face), solid.first).first->second;
        if (owner != solid.first)
        {
          interfaces[{ owner, solid.first }].push_back(Sorted(face));
        }
      }
    }
  }
  return interfaces;
}

struct Plane
{
  Point Origin = { 0, 0, 0 };
  Point Normal = { 0, 0, 0 };
  double Size = 0.;
};

Plane FitPlane(vtkUnstructuredGrid* grid, const std::vector<Ids>& triangles)
{
  Plane plane;
  double low[3] = { 1e300, 1e300, 1e300 };
  double high[3] = { -1e300, -1e300, -1e300 };
  for (const Ids& t : triangles)
  {
    const Point a = GetPoint(grid, t[0]);
    const Point b = GetPoint(grid, t[1]);
    const Point c = GetPoint(grid, t[2]);
    double cross[3];
    double dot = 0.;
    for (int k = 0; k < 3; ++k)
    {
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      cross[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
      dot += cross[k] * plane.Normal[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      plane.Normal[k] += dot < 0. ? -cross[k] : cross[k];
      plane.Origin[k] += (a[k] + b[k] + c[k]) / 3. / static_cast<double>(triangles.size());
      low[k] = std::min({ low[k], a[k], b[k], c[k] });
      high[k] = std::max({ high[k], a[k], b[k], c[k] });
      plane.Size = std::max(plane.Size, high[k] - low[k]);
    }
  }
  const double length = std::sqrt(plane.Normal[0] * plane.Normal[0] +
    plane.Normal[1] * plane.Normal[1] + plane.Normal[2] * plane.Normal[2]);
  for (double& component : plane.Normal)
  {
    component /= length;
  }
  return plane;
}

/// The largest distance from a plane, by the plane's size.
double Flatness(vtkUnstructuredGrid* grid, const std::vector<Ids>& triangles, const Plane& plane)
{
  double largest = 0.;
  for (const Ids& t : triangles)
  {
    for (vtkIdType v : t)
    {
      const Point p = GetPoint(grid, v);
      double distance = 0.;
      for (int k = 0; k < 3; ++k)
      {
        distance += (p[k] - plane.Origin[k]) * plane.Normal[k];
      }
      largest = std::max(largest, std::abs(distance) / plane.Size);
    }
  }
  return largest;
}

}

TEST_P(FeaturesFiles, FracturesStaySurfaces)
{
  const Grid fine = Execute(this->Input, 1,
    [](Filter* filter)
    {
      filter->SetEmbeddedCellsToSingularInside();
      filter->GenerateOriginalIdsOn();
      filter->GenerateClassificationOn();
    });
  vtkDataArray* original = fine->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType i = 0; i < fine->GetNumberOfCells(); ++i)
  {
    const auto ancestor = static_cast<vtkIdType>(original->GetTuple1(i));
    ASSERT_EQ(this->GetValue(fine, i), this->GetValue(this->Input, ancestor));
    ASSERT_EQ(fine->GetCellType(i), this->Input->GetCellType(ancestor));
  }
  const auto coarseGroups = this->GetGroups(this->Input, VTK_TRIANGLE);
  const auto fineGroups = this->GetGroups(fine, VTK_TRIANGLE);
  ASSERT_EQ(coarseGroups.size(), fineGroups.size());
  auto allTets = [this](vtkUnstructuredGrid* grid)
  {
    std::vector<Ids> tets;
    for (const auto& group : this->GetGroups(grid, VTK_TETRA))
    {
      tets.insert(tets.end(), group.second.begin(), group.second.end());
    }
    return FindFaces(tets);
  };
  const std::set<Ids> coarseFaces = allTets(this->Input);
  const std::set<Ids> fineFaces = allTets(fine);
  vtkDataArray* rules = fine->GetPointData()->GetArray("RuleDimension");
  for (const auto& group : coarseGroups)
  {
    SCOPED_TRACE(group.first);
    const std::vector<Ids>& triangles = fineGroups.at(group.first);
    ExpectRefined(group.second, triangles, 1);
    std::size_t before = 0;
    std::size_t after = 0;
    for (const Ids& t : group.second)
    {
      before += coarseFaces.count(Sorted(t));
    }
    for (const Ids& t : triangles)
    {
      after += fineFaces.count(Sorted(t));
      for (vtkIdType v : t)
      {
        ASSERT_NE(rules->GetTuple1(v), 3.) << "point " << v << " is inside the rock";
      }
    }
    EXPECT_EQ(after, 4 * before); // still faces of the solids
  }
}

TEST_P(FeaturesFiles, IntersectionsAreCurves)
{
  // Where three and more fracture triangles meet inside the rock, and every embedded line there.
  const Grid fine = Execute(this->Input, 1,
    [](Filter* filter)
    {
      filter->SetEmbeddedCellsToSingularInside();
      filter->GenerateClassificationOn();
    });
  vtkDataArray* rules = fine->GetPointData()->GetArray("RuleDimension");
  vtkDataArray* types = fine->GetPointData()->GetArray("NonManifoldType");
  std::map<Ids, int> sides;
  for (const auto& solid : this->GetGroups(fine, VTK_TETRA))
  {
    for (const Ids& tet : solid.second)
    {
      for (int i = 0; i < 4; ++i)
      {
        Ids face = tet;
        face.erase(face.begin() + i);
        ++sides[Sorted(face)];
      }
    }
  }
  std::map<Ids, std::set<Ids>> edges;
  for (const auto& group : this->GetGroups(fine, VTK_TRIANGLE))
  {
    for (const Ids& t : group.second)
    {
      for (int i = 0; i < 3 && sides[Sorted(t)] == 2; ++i)
      {
        edges[Sorted({ t[i], t[(i + 1) % 3] })].insert(Sorted(t));
      }
    }
  }
  int crossings = 0;
  for (const auto& edge : edges)
  {
    for (vtkIdType v : edge.first)
    {
      if (edge.second.size() > 2)
      {
        ++crossings;
        ASSERT_LE(rules->GetTuple1(v), 1.) << v << " type " << types->GetTuple1(v);
      }
    }
  }
  EXPECT_GT(crossings, 0);
}

TEST_P(FeaturesFiles, InterfacesStaySurfaces)
{
  const char* name = this->GetParam().Array;
  const Configure preserve = [name](Filter* filter)
  {
    SetCellArray(filter, 1, name);
    filter->PreserveInterfacesOn();
  };
  const Grid fine = Execute(this->Input, 1, preserve);
  const auto coarse = FindInterfaces(this->GetGroups(this->Input, VTK_TETRA));
  const auto after = FindInterfaces(this->GetGroups(fine, VTK_TETRA));
  ASSERT_EQ(coarse.size(), after.size());
  for (const auto& between : coarse)
  {
    SCOPED_TRACE(std::to_string(between.first.first) + " " + std::to_string(between.first.second));
    ASSERT_TRUE(after.count(between.first));
    ExpectRefined(between.second, after.at(between.first), 1);
  }
  const Grid plain = Execute(this->Input, 1);
  const std::string difference =
    CompareValues(plain->GetPoints()->GetData(), fine->GetPoints()->GetData());
  EXPECT_EQ(difference, coarse.empty() ? "" : "values");
}

TEST_P(FeaturesFiles, PlanarFracturesStayPlanar)
{
  // Flagged are all triangles but those on the outside; there edges of the block would be round.
  std::map<Ids, int> sides;
  for (const auto& solid : this->GetGroups(this->Input, VTK_TETRA))
  {
    for (const Ids& tet : solid.second)
    {
      for (int i = 0; i < 4; ++i)
      {
        Ids face = tet;
        face.erase(face.begin() + i);
        ++sides[Sorted(face)];
      }
    }
  }
  auto isOutside = [&sides](const Ids& triangle)
  {
    const auto found = sides.find(Sorted(triangle));
    return found != sides.end() && found->second == 1;
  };
  std::vector<int> flags;
  for (vtkIdType i = 0; i < this->Input->GetNumberOfCells(); ++i)
  {
    flags.push_back(
      this->Input->GetCellType(i) == VTK_TRIANGLE && !isOutside(GetCell(this->Input, i)));
  }
  const Grid fine = Execute(With(this->Input, "Singular", flags), 2);
  const auto groups = this->GetGroups(fine, VTK_TRIANGLE);
  int planar = 0;
  for (const auto& group : this->GetGroups(this->Input, VTK_TRIANGLE))
  {
    const Plane plane = FitPlane(this->Input, group.second);
    if (std::none_of(group.second.begin(), group.second.end(), isOutside) &&
      Flatness(this->Input, group.second, plane) < 1e-12)
    {
      ++planar;
      EXPECT_LE(Flatness(fine, groups.at(group.first), plane), 1e-12) << group.first;
    }
  }
  EXPECT_EQ(planar, this->GetParam().PlanarFractures);
}

INSTANTIATE_TEST_SUITE_P(Meshes, FeaturesFiles,
  testing::Values(File{ "mix_porepy_case2_4k", "PhysicalIds", 9 },
    File{ "mix_ogs5_fracture_network", "MaterialIDs", 3 },
    File{ "tet_gmsh_coil_crack", "PhysicalIds", 1 }),
  [](const auto& param) { return std::string(param.param.Name); });
