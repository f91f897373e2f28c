// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesTools.h"
#include "FileTools.h"

#include "Private/Reading/ReadableMesh.h"

#include <iostream>

using namespace cells_to_simplices_tools;
using namespace file_tools;

namespace
{

std::vector<Point> GetPoints(vtkPointSet* input)
{
  std::vector<Point> points(static_cast<size_t>(input->GetNumberOfPoints()));
  for (size_t i = 0; i < points.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

std::map<int, vtkIdType> CountByDimension(const SimplicesOfCells& result)
{
  std::map<int, vtkIdType> count;
  for (const unsigned char dimension : result.Simplices.Dimensions)
  {
    ++count[dimension];
  }
  return count;
}

}

struct SharedMesh
{
  const char* Name;
  size_t Warnings;
  vtkIdType Count[4]; ///< simplices of each dimension
  vtkIdType Centres;
  size_t Outside; ///< faces of one tet only
  size_t TrianglesOnTets;
  size_t NonLinear = 0; ///< warnings
};

void PrintTo(const SharedMesh& mesh, std::ostream* out)
{
  *out << mesh.Name;
}

class CellsToSimplicesOfFile : public testing::TestWithParam<SharedMesh>
{
};

TEST_P(CellsToSimplicesOfFile, GivesWhatIsExpected)
{
  const SharedMesh& expected = GetParam();
  const std::string file = GetSharedFile(expected.Name);
  if (const std::string reason = WhyNotRead(file); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  const auto grid = ReadGrid(file);
  std::vector<std::string> warnings;
  const auto readable =
    subdivision::MakeReadable(grid, subdivision::NonLinearRule::Corners, warnings);
  const auto result = CellsToSimplices(vtkPointSet::SafeDownCast(readable), nullptr);
  EXPECT_EQ(warnings.size(), expected.NonLinear);
  ExpectSound(result, grid->GetNumberOfCells());
  auto count = CountByDimension(result);
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    EXPECT_EQ(count[dimension], expected.Count[dimension]) << dimension;
  }
  EXPECT_EQ(result.GetNumberOfCentres(), expected.Centres);
  EXPECT_EQ(result.Warnings.size(), expected.Warnings);
  for (const std::string& warning : result.Warnings)
  {
    std::cout << warning << "\n";
  }
  const auto simplices = GetSimplices(result);
  const auto faces = CountFaces(simplices);
  size_t trianglesOnTets = 0;
  for (const Ids& s : simplices)
  {
    trianglesOnTets += s.size() == 3 && faces.count(MakeFace(s[0], s[1], s[2])) ? 1 : 0;
  }
  EXPECT_EQ(FacesUsed(faces, 1).size(), expected.Outside);
  EXPECT_EQ(trianglesOnTets, expected.TrianglesOnTets);
}

// Where the last number is that of all triangles, every shell lies exactly on faces of the solids.
INSTANTIATE_TEST_SUITE_P(Shared, CellsToSimplicesOfFile,
  testing::Values( //
    SharedMesh{ "hostile_degenerate_cells.vtu", 2, { 1, 1, 5, 14 }, 0, 8, 1 },
    SharedMesh{ "hostile_duplicate_points.vtu", 0, { 4, 208, 952, 2016 }, 0, 6184, 529 },
    SharedMesh{ "hostile_empty.vtu", 0, { 0, 0, 0, 0 }, 0, 0, 0 },
    SharedMesh{ "hostile_inverted_cells.vtu", 0, { 4, 208, 952, 2028 }, 0, 694, 952 },
    SharedMesh{ "hostile_nan_inf_coords.vtu", 1, { 8, 414, 1748, 3918 }, 0, 1136, 1748 },
    SharedMesh{ "hostile_out_of_range_ids.vtu", 1, { 4, 207, 952, 2013 }, 0, 676, 949 },
    SharedMesh{ "hostile_quadratic_among_linear.vtu", 0, { 0, 2, 2, 2 }, 0, 6, 2, 1 },
    SharedMesh{ "hostile_unsupported_types.vtu", 1, { 3, 4, 9, 19 }, 1, 24, 1 },
    SharedMesh{ "hostile_unused_points.vtu", 0, { 4, 208, 952, 2016 }, 0, 674, 952 },
    SharedMesh{ "mix_elmer_shell_on_solid.vtu", 0, { 0, 96, 7168, 24576 }, 0, 5120, 5120 },
    SharedMesh{ "mix_elmer_wire_pair.vtu", 0, { 8, 426, 1800, 4050 }, 0, 1020, 1800 },
    SharedMesh{ "mix_geos_cube.vtu", 0, { 8, 36, 108, 162 }, 0, 108, 108 },
    SharedMesh{ "mix_nastran_isat.vtu", 0, { 15, 790, 9192, 150 }, 0, 292, 0 },
    SharedMesh{ "mix_ogs5_fracture_network.vtu", 0, { 0, 0, 1359, 29080 }, 0, 11184, 1231 },
    SharedMesh{ "mix_porepy_case2_4k.vtu", 0, { 27, 480, 3500, 8433 }, 0, 1806, 3500 },
    SharedMesh{ "hex_geos_box_hybrid.vtu", 0, { 0, 0, 0, 15105 }, 78, 4388, 0 },
    SharedMesh{
      "hex_gmsh_quadtri_torus_4types.vtu", 0, { 44, 1060, 14572, 120521 }, 0, 1764, 14572 },
    SharedMesh{ "hex_mfem_tinyzoo.vtu", 0, { 0, 0, 20, 12 }, 0, 20, 20 },
    SharedMesh{ "nat_ogs_sphere_zero_volume.vtu", 0, { 0, 0, 0, 122820 }, 0, 11094, 0 },
    SharedMesh{ "nat_geos_all_types.vtu", 0, { 0, 0, 0, 214 }, 7, 238, 0 }),
  [](const auto& param)
  {
    const std::string name = param.param.Name;
    return name.substr(0, name.find('.'));
  });

TEST(CellsToSimplicesFiles, HybridBoxThatDoesNotConformAsFound)
{
  const std::string file = GetSharedFile("hex_geos_box_hybrid.vtu");
  if (const std::string reason = WhyNotRead(file); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  // 1232 quads meet two triangles. Conforming means: what only one tet has lies on the box.
  const auto grid = ReadGrid(file);
  const auto result = CellsToSimplices(grid, nullptr);
  double b[6];
  grid->GetBounds(b);
  ExpectFills(result, GetPoints(grid), (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]));
  const auto points = AddCentres(GetPoints(grid), result);
  for (const Face& face : FacesUsed(CountFaces(GetSimplices(result)), 1))
  {
    bool onBox = false;
    for (int side = 0; side < 6; ++side)
    {
      const auto isOn = [&](vtkIdType id)
      { return std::abs(points[id][side / 2] - b[side]) < 1e-9; };
      onBox = onBox || std::all_of(face.begin(), face.end(), isOn);
    }
    EXPECT_TRUE(onBox);
  }
}

TEST(CellsToSimplicesFiles, QuadraticTetsAreOneOrEight)
{
  const std::string file = GetSharedFile("nat_fea_quadratic_tets.vtu");
  if (const std::string reason = WhyNotRead(file); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  const auto grid = ReadGrid(file);
  ASSERT_EQ(grid->GetNumberOfCells(), 56786);
  std::vector<std::string> warnings;
  const auto corners =
    subdivision::MakeReadable(grid, subdivision::NonLinearRule::Corners, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(Has(warnings[0], "56786 cells")) << warnings[0];
  const auto one = CellsToSimplices(vtkPointSet::SafeDownCast(corners), nullptr);
  EXPECT_EQ(one.Simplices.GetNumberOfSimplices(), 56786);
  const auto pieces = subdivision::MakeReadable(grid, subdivision::NonLinearRule::Pieces, warnings);
  EXPECT_EQ(pieces, grid) << "nothing is copied";
  const auto eight = CellsToSimplices(grid, nullptr);
  EXPECT_EQ(eight.Simplices.GetNumberOfSimplices(), 8 * 56786);
  EXPECT_EQ(eight.GetNumberOfCentres(), 0);
  const auto faces = CountFaces(GetSimplices(eight));
  EXPECT_EQ(FacesUsed(faces, 1).size(), 4 * FacesUsed(CountFaces(GetSimplices(one)), 1).size());
  EXPECT_TRUE(std::all_of(faces.begin(), faces.end(), [](const auto& f) { return f.second <= 2; }));
}
