// SPDX-License-Identifier: BSD-3-Clause
// Doo and Sabin's scheme: masks and topology. TestSurfaceDualSchemes.cxx has what midedge has, too.
#include "DualSchemeTools.h"

using namespace dualtools;

namespace
{

constexpr auto Kind = subdivision::SurfaceSchemeKind::DooSabin;

TEST(SurfaceDooSabin, RegularMaskIsTheBiquadraticSpline)
{
  constexpr int n = 3;
  const Steps steps(MakeLevel(16, MakeQuads(n, n)), Kind, 1);
  const auto rows = steps.GetRows(0);
  const Mesh& mesh = steps[0].Mesh;
  for (int corner = 0; corner < 4 * n * n; ++corner)
  {
    ASSERT_EQ(rows.Offsets[corner + 1] - rows.Offsets[corner], 4);
    const int own = mesh.Vertices[corner];
    for (int k = rows.Offsets[corner]; k < rows.Offsets[corner + 1]; ++k)
    {
      const int other = rows.Columns[k];
      const double x = other % (n + 1) == own % (n + 1) ? 0.75 : 0.25;
      const double y = other / (n + 1) == own / (n + 1) ? 0.75 : 0.25;
      EXPECT_EQ(rows.Weights[k], x * y);
    }
  }
}

TEST(SurfaceDooSabin, SpectrumIsOneTwoHalvesAndQuarters)
{
  for (int k = 3; k <= 12; ++k)
  {
    std::vector<vtkIdType> face(k);
    for (int i = 0; i < k; ++i)
    {
      face[i] = i;
    }
    const Steps steps(MakeLevel(k, { face }), Kind, 1);
    const auto rows = steps.GetRows(0);
    auto weight = [&](int row, int column)
    {
      for (int i = rows.Offsets[row]; i < rows.Offsets[row + 1]; ++i)
      {
        if (rows.Columns[i] == column)
        {
          return rows.Weights[i];
        }
      }
      return 0.;
    };
    for (int mode = 0; mode < k; ++mode)
    {
      const double expected = mode == 0 ? 1. : mode == 1 || mode == k - 1 ? 0.5 : 0.25;
      for (int row = 0; row < k; ++row)
      {
        double re = 0.;
        double im = 0.;
        for (int column = 0; column < k; ++column)
        {
          const double angle = 2. * std::acos(-1.) * mode * (column - row) / k;
          re += weight(row, column) * std::cos(angle);
          im += weight(row, column) * std::sin(angle);
        }
        EXPECT_NEAR(re, expected, 1e-14);
        EXPECT_NEAR(im, 0., 1e-14);
      }
    }
  }
}

TEST(SurfaceDooSabin, Counts)
{
  const auto shapes = MakeShapes();
  const Steps cube(MakeLevel(8, shapes[1].Polygons), Kind, 2);
  EXPECT_EQ(cube[1].Mesh.NumberOfVertices, 24);
  EXPECT_EQ(cube[1].Mesh.NumberOfFaces, 26);
  EXPECT_EQ(cube[2].Mesh.NumberOfVertices, 96);
  EXPECT_EQ(cube[2].Mesh.NumberOfFaces, 98);
  const Steps triangle(MakeLevel(3, { { 0, 1, 2 } }), Kind, 1);
  EXPECT_EQ(triangle[1].Mesh.NumberOfVertices, 9);
  EXPECT_EQ(triangle[1].Mesh.NumberOfFaces, 7);
  EXPECT_EQ(CountOpenSides(triangle[1]), 6);
  const Steps moebius(MakeLevel(10, MakeMoebius(5)), Kind, 2);
  EXPECT_EQ(moebius[1].Mesh.NumberOfFaces, 5 + 15 + 10);
  EXPECT_EQ(CountOpenSides(moebius[2]), 40);
  // A pillow has no vertex faces: a fan of two would have two edges.
  const Steps pillow(MakeLevel(3, { { 0, 1, 2 }, { 0, 2, 1 } }), Kind, 1);
  EXPECT_EQ(pillow[1].Mesh.NumberOfFaces, 2 + 3);
  EXPECT_EQ(CountOpenSides(pillow[1]), 0);
}

TEST(SurfaceDooSabin, FacesBetweenOthersBelongToBoth)
{
  const Steps steps(MakeLevel(6, MakeQuads(2, 1)), Kind, 1);
  const auto carriers = steps.GetCarriers(0);
  const Mesh& mesh = steps[1].Mesh;
  for (int f = 0; f < mesh.NumberOfFaces; ++f)
  {
    int smallest = 2;
    int largest = -1;
    for (int c = mesh.GetFirst(f); c < mesh.GetFirst(f) + mesh.GetSize(f); ++c)
    {
      if (mesh.Vertices[c] < 8)
      {
        smallest = std::min(smallest, mesh.Vertices[c] / 4);
        largest = std::max(largest, mesh.Vertices[c] / 4);
      }
    }
    EXPECT_EQ(carriers[f].First, smallest);
    EXPECT_EQ(carriers[f].Second, largest);
  }
}

TEST(SurfaceDooSabin, ArraysThatAreNotSmoothed)
{
  // A quad and a triangle; labels are the point ids. Global ids order points in the first step.
  const Data input = MakeData(MakeRandomPoints(5, 3), { { 0, 1, 2, 3 }, { 2, 1, 4 } });
  AddIds(input->GetPointData(), "labels", { 10, 11, 12, 13, 14 }, false);
  AddIds(input->GetPointData(), "ids", { 5, 4, 3, 2, 1 }, true);
  AddIds(input->GetCellData(), "cells", { 7, 8 }, false);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(vtkSurfaceSubdivision::DOO_SABIN);
  filter->SetGenerateOriginalIds(true);
  filter->Update();
  vtkPolyData* out = filter->GetOutput();
  vtkDataArray* labels = out->GetPointData()->GetArray("labels");
  ASSERT_TRUE(labels);
  const std::vector<int> expected = { 13, 13, 13, 13, 14, 14, 14 };
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_EQ(labels->GetComponent(i, 0), expected[i]);
  }
  EXPECT_EQ(labels->GetComponent(7, 0), 11); // near 0, on the edge to 1, whose id is smaller
  vtkDataArray* originals = out->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(originals->GetComponent(i, 0), -1.);
  }
  EXPECT_FALSE(out->GetPointData()->GetGlobalIds());
  EXPECT_EQ(out->GetCellData()->GetArray("cells")->GetComponent(1, 0), 8.);
}

}
