// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationHexahedra.cxx
 * Control meshes whose cells are not cut: lattices of hexahedra, and meshes of all types.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkImageData.h"

using namespace deformation_tools;

namespace
{

/// n^3 hexahedra of length 1 from the origin.
Grid MakeLattice(int n)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(n + 1, n + 1, n + 1);
  return Execute(image, 0, [](Filter* filter) { filter->SetVolumeSchemeToHybrid(); });
}

/// A hexahedron with a wedge, a pyramid and a tetrahedron; apart a hexahedron with a collapsed
/// edge, which needs a centre.
Grid MakeZoo()
{
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0, 0 }, { 2, 0, 1 }, { .5, .5, 2 } };
  for (const int i : { 0, 1, 2, 4, 5, 6, 7 })
  {
    points.push_back({ points[i][0] + 5., points[i][1], points[i][2] });
  }
  return MakeGrid(points,
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } },
      { VTK_PYRAMID, { 4, 5, 6, 7, 10 } }, { VTK_TETRA, { 5, 9, 6, 10 } },
      { VTK_HEXAHEDRON, { 11, 12, 13, 13, 14, 15, 16, 17 } } });
}

Grid MakePoints(const std::vector<Point>& points)
{
  return MakeGrid(points, {});
}

}

TEST(SubdivisionDeformationHexahedra, AffineMapsAreReproduced)
{
  for (const Grid& cage : { MakeLattice(2), MakeZoo() })
  {
    for (const int scheme : { Filter::HYBRID, Filter::LINEAR })
    {
      for (const int levels : { 0, 1, 3 })
      {
        const Grid inside = MakePoints({ { .5, .5, .5 }, { .6, .45, .7 }, { .4, .6, .45 } });
        Deformer filter;
        filter->SetNumberOfLevels(levels);
        filter->SetVolumeScheme(scheme);
        const auto moved = filter.Run(inside, cage, Moved(cage, Affine));
        EXPECT_LT(GetLargestError(moved, inside, Affine), 1e-13) << levels;
        EXPECT_TRUE(filter.GetErrors().empty());
        EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
        filter.Run(inside, cage, Moved(cage, Bend));
        EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1) << "nothing is built again";
      }
    }
  }
}

/// The points of the smooth mesh at rest go where the smooth deformed mesh has them.
TEST(SubdivisionDeformationHexahedra, FollowsTheSubdividedMesh)
{
  for (const Grid& cage : { MakeLattice(3), MakeZoo() })
  {
    const auto subdivide = [](const Grid& grid)
    {
      return Execute(
        grid, 2, [](Filter* filter) { filter->SetVolumeSchemeToHybrid(); }, vtkNew<Messages>());
    };
    const Grid rest = subdivide(cage);
    const Grid bent = subdivide(Moved(cage, Bend));
    Deformer filter;
    filter->SetNumberOfLevels(2);
    filter->SetVolumeSchemeToHybrid();
    const auto result = filter.Run(rest, cage, Moved(cage, Bend));
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0);
    for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(GetPoint(result, i)[c], GetPoint(bent, i)[c], 1e-13) << i;
      }
    }
  }
}

/// In a lattice the deformation is the tensor product of cubic B-splines, up to the last cells.
TEST(SubdivisionDeformationHexahedra, ALatticeIsATricubicSpline)
{
  const Grid cage = MakeLattice(6);
  const Grid moved = DeepCopy(cage);
  const vtkIdType middle = 3 + 7 * (3 + 7 * 3);
  moved->GetPoints()->SetPoint(middle, 3., 3., 4.);
  const auto spline = [](double t)
  {
    t = std::abs(t);
    return t < 1. ? 2. / 3. - t * t + t * t * t / 2. : t < 2. ? std::pow(2. - t, 3) / 6. : 0.;
  };
  const std::vector<Point> places = { { 3, 3, 3 }, { 3.5, 3, 3 }, { 3.5, 2.5, 3.5 },
    { 2.75, 3.25, 3 }, { 4, 3, 2 }, { 4.5, 3, 3 } };
  Deformer filter;
  filter->SetNumberOfLevels(4);
  filter->SetVolumeSchemeToHybrid();
  const auto result = filter.Run(MakePoints(places), cage, moved);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Point& p = places[i];
    const double expected = spline(p[0] - 3.) * spline(p[1] - 3.) * spline(p[2] - 3.);
    // Control points of level 4 are not on the limit yet.
    EXPECT_NEAR(GetPoint(result, static_cast<vtkIdType>(i))[2] - p[2], expected, .004) << i;
  }
}

TEST(SubdivisionDeformationHexahedra, ThreadsBlocksAndFaults)
{
  const Grid cage = MakeLattice(2);
  // Turned inside out.
  Deformer filter;
  filter->SetNumberOfLevels(1);
  filter->SetVolumeSchemeToHybrid();
  filter.Run(MakePoints({ { 1, 1, 1 } }), cage,
    Moved(cage, [](const Point& p) -> Point { return { p[0], p[1], -p[2] }; }));
  ASSERT_EQ(filter.GetWarnings().size(), 1u);
  EXPECT_NE(filter.GetWarnings()[0].find("turns inside out, or makes flat, 8 of its cells"),
    std::string::npos);
  // Too many cells.
  Deformer large;
  large->SetNumberOfLevels(5);
  large->SetVolumeSchemeToHybrid();
  large->SetMaximumNumberOfCells(1000);
  large.Run(MakePoints({ { 1, 1, 1 } }), cage, cage);
  EXPECT_EQ(large.GetErrors().size(), 1u);
}
