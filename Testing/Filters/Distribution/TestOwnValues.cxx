// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOwnValues.cxx
 * Parts of a mesh that have different values at points that they share.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "Private/Distribution/OwnValues.h"

using namespace multi_dimensional_subdivision_tools;
using subdivision::MeshPart;

namespace
{

/// A tetrahedron whose first three points are those of the other one.
MeshPart MakePart(int block, double height, const std::vector<double>& values)
{
  const Grid mesh = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, height } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  vtkNew<vtkDoubleArray> array;
  array->SetName("Value");
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  mesh->GetPointData()->AddArray(array);
  MeshPart part;
  part.Mesh = mesh;
  part.Block = block;
  part.Points = { 0, 1, 2, 3 + block };
  part.Cells = { block };
  return part;
}

}

TEST(OwnValues, BecomeCopies)
{
  const std::vector<MeshPart> parts = { MakePart(0, 1., { 1., 2., 3., 4. }),
    MakePart(1, -1., { 1., 20., 30., 40. }) };
  subdivision::JoinedMesh joined = subdivision::Join(parts);
  subdivision::KeepOwnValues(parts, joined);
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(joined.Mesh);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 7);
  EXPECT_EQ(joined.PointIds.size(), 5u);
  EXPECT_EQ(GetCell(mesh, 0), (Ids{ 0, 1, 2, 3 }));
  EXPECT_EQ(GetCell(mesh, 1), (Ids{ 0, 5, 6, 4 }));
  const std::vector<double> values = { 1., 2., 3., 4., 40., 20., 30. };
  const std::vector<double> ids = { 0., 1., 2., 3., 4., 1., 2. };
  for (vtkIdType p = 0; p < 7; ++p)
  {
    EXPECT_EQ(mesh->GetPointData()->GetArray("Value")->GetComponent(p, 0), values[p]);
    EXPECT_EQ(mesh->GetPointData()->GetArray("MaterialPointIds")->GetComponent(p, 0), ids[p]);
    EXPECT_EQ(GetPoint(mesh, p), GetPoint(mesh, static_cast<vtkIdType>(ids[p])));
  }
}

TEST(OwnValues, EqualOnesAreNothing)
{
  const std::vector<MeshPart> parts = { MakePart(0, 1., { 1., NAN, 3., 4. }),
    MakePart(1, -1., { 1., NAN, 3., 40. }) };
  subdivision::JoinedMesh joined = subdivision::Join(parts);
  subdivision::KeepOwnValues(parts, joined);
  EXPECT_EQ(joined.Mesh->GetNumberOfPoints(), 5);
  EXPECT_FALSE(joined.Mesh->GetPointData()->HasArray("MaterialPointIds"));
}
