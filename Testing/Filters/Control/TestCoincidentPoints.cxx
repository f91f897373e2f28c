// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCoincidentPoints.cxx
 * One warning tells of points at one place where cells would be joined if they shared them, and
 * none of others.
 */
#include "FeatureTools.h"
#include "FileTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSurfaceSubdivision.h"

using namespace feature_tools;

namespace
{

/// What the filter says of such points; each of its messages has to be of them.
template <typename FilterClass = Filter>
std::vector<std::string> Tell(
  vtkDataObject* input, const std::function<void(FilterClass*)>& configure = {}, int updates = 1)
{
  vtkNew<FilterClass> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  if (configure)
  {
    configure(filter);
  }
  for (int i = 0; i < updates; ++i)
  {
    filter->Modified();
    filter->Update();
  }
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(messages->CountWarnings("at the place of another") +
      messages->CountWarnings("the size of the mesh from another"),
    static_cast<int>(messages->Warnings.size()));
  return messages->Warnings;
}

bool Has(const std::vector<std::string>& warnings, const std::string& part)
{
  return warnings.size() == 1 && warnings[0].find(part) != std::string::npos;
}

/// 0 to 3: a tetrahedron; 4 to 6 at the places of 0 to 2.
const std::vector<Point> Places = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { -0., 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }, { 2, 2, 2 } };

std::vector<std::string> TellOf(const std::vector<Cell>& cells)
{
  return Tell<Filter>(MakeGrid(Places, cells), [](Filter* filter) { filter->JoinSidesOff(); });
}

const Cell Tet = { VTK_TETRA, { 0, 1, 2, 3 } };

/// A cylinder whose first and last points are at one place, with a texture or without.
vtkSmartPointer<vtkPolyData> MakeSeam(bool hasTexture)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  for (int i = 0; i <= 8; ++i)
  {
    for (int z = 0; z < 3; ++z)
    {
      const double angle = i % 8 * std::acos(-1.) / 4;
      points->InsertNextPoint(std::cos(angle), std::sin(angle), z);
      texture->InsertNextTuple2(i / 8., z);
    }
    for (int z = 0; i < 8 && z < 2; ++z)
    {
      const vtkIdType first = 3 * i + z;
      const vtkIdType ids[4] = { first, first + 3, first + 4, first + 1 };
      polys->InsertNextCell(4, ids);
    }
  }
  auto seam = vtkSmartPointer<vtkPolyData>::New();
  seam->SetPoints(points);
  seam->SetPolys(polys);
  seam->GetPointData()->SetTCoords(hasTexture ? texture.Get() : nullptr);
  return seam;
}

}

TEST(CoincidentPoints, AreCountedAndNamedWithWhatHelps)
{
  const auto warnings = TellOf({ Tet, { VTK_TETRA, { 5, 4, 6, 7 } } });
  EXPECT_TRUE(Has(warnings,
    "3 points where cells end are at the place of another (for instance "
    "points 0 and 4)"));
  EXPECT_TRUE(Has(warnings, "switch MergePoints on, or apply vtkStaticCleanUnstructuredGrid"));
  EXPECT_TRUE(TellOf({ Tet, { VTK_TETRA, { 1, 0, 2, 7 } } }).empty());
}

TEST(CoincidentPoints, PartsOfAllDimensionsThatWouldBeJoined)
{
  EXPECT_TRUE(Has(TellOf({ Tet, { VTK_TRIANGLE, { 4, 5, 6 } } }), "3 points"));
  EXPECT_TRUE(Has(TellOf({ Tet, { VTK_LINE, { 5, 6 } } }), "2 points"));
  EXPECT_TRUE(
    Has(TellOf({ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 5, 4, 8 } } }), "2 points"));
  EXPECT_TRUE(Has(TellOf({ { VTK_TRIANGLE, { 1, 3, 8 } }, { VTK_TRIANGLE, { 2, 0, 7 } },
                    { VTK_LINE, { 4, 6 } } }),
    "2 points"));
  EXPECT_TRUE(Has(TellOf({ { VTK_LINE, { 3, 0 } }, { VTK_LINE, { 4, 7 } } }),
    "1 point where cells end is at the place of another (for instance points 0 and 4)"));
}

TEST(CoincidentPoints, NothingIsSaidWhereNothingWouldBeJoined)
{
  // Parts that touch at a point or along an edge only.
  EXPECT_TRUE(TellOf({ Tet, { VTK_TETRA, { 4, 7, 8, 5 } } }).empty());
  EXPECT_TRUE(TellOf({ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 4, 7, 8 } } }).empty());
  // Edges inside of surfaces, which two triangles have already.
  const Grid tents = MakeGrid(Places,
    { { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 1, 0, 7 } }, { VTK_TRIANGLE, { 4, 5, 8 } },
      { VTK_TRIANGLE, { 5, 4, 2 } } });
  EXPECT_TRUE(Tell(tents).empty());
  EXPECT_TRUE(Tell<vtkSurfaceSubdivision>(tents).empty());
  // The inside of a line, a point without cells, and a vertex.
  EXPECT_TRUE(
    TellOf({ { VTK_LINE, { 3, 0 } }, { VTK_LINE, { 0, 7 } }, { VTK_LINE, { 4, 8 } } }).empty());
  EXPECT_TRUE(TellOf({ Tet }).empty());
  EXPECT_TRUE(TellOf({ { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_VERTEX, { 4 } } }).empty());
  // A cell of no size is at one place with itself.
  EXPECT_TRUE(Tell(MakeGrid(std::vector<Point>(4, Point{ 1, 1, 1 }), { Tet })).empty());
}

TEST(CoincidentPoints, CracksWithDoubledPointsAreTold)
{
  // Four tetrahedra around the edge 0 1; between the first and the last are both sides of a crack
  // that ends at this edge.
  EXPECT_TRUE(Has(Tell(MakeGrid({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 },
                                  { 0, -1, 0 }, { 1, 0, 0 } },
                    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 3, 4 } },
                      { VTK_TETRA, { 0, 1, 4, 5 } }, { VTK_TETRA, { 0, 1, 5, 6 } } })),
    "1 point where cells end is at the place of another (for instance points 2 and 6)"));
}

TEST(CoincidentPoints, PointsThatAreNearAreToldWithATolerance)
{
  std::vector<Point> near = Places;
  near[4][2] = near[5][2] = near[6][2] = 1e-8;
  const std::vector<Cell> cells = { Tet, { VTK_TETRA, { 5, 4, 6, 7 } } };
  for (const bool merges : { false, true })
  {
    vtkNew<Messages> messages;
    Execute(
      MakeGrid(near, cells), 1, [&](Filter* filter) { filter->SetMergePoints(merges); }, messages);
    EXPECT_TRUE(Has(messages->Warnings,
      "3 points where cells end are not farther than 1e-06 times "
      "the size of the mesh from another (for instance points 0 "
      "and 4, 1e-08 apart)"));
    EXPECT_TRUE(Has(messages->Warnings, "switch MergePoints on with MergeTolerance = 1e-06"));
  }
  const Configure merge = [](Filter* filter)
  {
    filter->MergePointsOn();
    filter->SetMergeTolerance(1e-6);
  };
  EXPECT_TRUE(Tell<Filter>(MakeGrid(near, cells), merge).empty());
  near[4][2] = near[5][2] = near[6][2] = -1e-4;
  EXPECT_TRUE(TellOf({ Tet, { VTK_TETRA, { 1, 0, 2, 7 } } }).empty());
  EXPECT_TRUE(Tell(MakeGrid(near, cells)).empty());
}

TEST(CoincidentPoints, SchemesWithoutSeamsNameThoseThatHaveThem)
{
  for (const int scheme : { vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::MIDEDGE,
         vtkSurfaceSubdivision::FOUR_EIGHT, vtkSurfaceSubdivision::SQRT_THREE })
  {
    const auto choose = [scheme](vtkSurfaceSubdivision* filter) { filter->SetScheme(scheme); };
    EXPECT_TRUE(Has(Tell<vtkSurfaceSubdivision>(MakeSeam(true), choose),
      "JoinSeams: Loop, ModifiedButterfly, CatmullClark or Linear"));
    EXPECT_TRUE(Has(Tell<vtkSurfaceSubdivision>(MakeSeam(false), choose), "switch MergePoints on"));
  }
  EXPECT_TRUE(Has(Tell<Filter>(MakeSeam(true)), "use vtkSurfaceSubdivision, whose JoinSeams"));
}

TEST(CoincidentPoints, MergePointsLeavesNothingToSay)
{
  const Grid grid = MakeGrid(Places, { Tet, { VTK_TETRA, { 5, 4, 6, 7 } } });
  EXPECT_TRUE(Tell<Filter>(grid, [](Filter* filter) { filter->MergePointsOn(); }).empty());
}

TEST(CoincidentPoints, AreToldOfWhatIsKeptToo)
{
  const Grid grid = MakeGrid(Places, { Tet, { VTK_TETRA, { 5, 4, 6, 7 } } });
  EXPECT_EQ(Tell<Filter>(grid, {}, 3).size(), 3u);
  EXPECT_EQ(Tell<vtkSurfaceSubdivision>(MakeSeam(false), {}, 3).size(), 3u);
}

TEST(CoincidentPoints, OutputsOfAFilterAreNotToldAgain)
{
  const Grid grid = MakeGrid(Places, { Tet, { VTK_TETRA, { 5, 4, 6, 7 } } });
  vtkNew<Messages> messages;
  const Grid output = Execute(grid, 1, {}, messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_TRUE(Tell(output).empty());
}

TEST(CoincidentPoints, OfTheOtherFilters)
{
  EXPECT_TRUE(Has(
    Tell<vtkSimplicialComplexTopology>(MakeGrid(Places, { Tet, { VTK_TETRA, { 5, 4, 6, 7 } } })),
    "3 points"));
  EXPECT_TRUE(Has(Tell<vtkSurfaceSubdivision>(MakeSeam(false)), "3 points"));
  const Grid apart =
    MakeGrid(Places, { { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 5, 4, 8 } } });
  EXPECT_TRUE(Has(Tell<vtkAdaptiveSurfaceSubdivision>(
                    apart, [](vtkAdaptiveSurfaceSubdivision* filter) { filter->JoinSidesOff(); }),
    "2 points"));
}

TEST(CoincidentPoints, SeamsOfATextureAreJoined)
{
  EXPECT_TRUE(Tell<vtkSurfaceSubdivision>(MakeSeam(true)).empty());
  EXPECT_TRUE(Has(Tell<vtkSurfaceSubdivision>(
                    MakeSeam(true), [](vtkSurfaceSubdivision* filter) { filter->JoinSeamsOff(); }),
    "3 points"));
}

/// A crack whose sides share points, and cells of no size at a pole, are no reason to warn.
TEST(CoincidentPointsOfFiles, AreWhatTheyHave)
{
  const std::pair<const char*, const char*> files[] = {
    { "hostile_duplicate_points.vtu", "4032 points" },
    { "nat_bunny_verts_dup_points.vtp", "370 points" },
    { "tet_gmsh_coil_crack.vtu", nullptr },
    { "nat_ogs_sphere_zero_volume.vtu", nullptr },
  };
  for (const auto& file : files)
  {
    const std::string path = file_tools::GetSharedFile(file.first);
    if (const std::string reason = file_tools::WhyNotRead(path); !reason.empty())
    {
      GTEST_SKIP() << reason;
    }
    const auto warnings = Tell<Filter>(
      file_tools::ReadFile(path), [](Filter* filter) { filter->SetNumberOfLevels(0); });
    EXPECT_TRUE(file.second ? Has(warnings, file.second) : warnings.empty()) << file.first;
  }
}
