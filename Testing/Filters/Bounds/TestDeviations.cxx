// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestDeviations.cxx
 * Pieces of cells, and ranges of what belongs to their points.
 */
#include "FeatureTools.h"

#include "Private/Bounds/Deviations.h"

using namespace feature_tools;
using subdivision::Deviations;
using subdivision::NestedPieces;

namespace
{

/// The pieces of a mesh, which the filter of one level makes of `input`.
NestedPieces MakePieces(vtkDataObject* input, vtkSmartPointer<vtkPointSet>& mesh)
{
  std::array<vtkIdType, NestedPieces::Steps + 1> points{};
  Grid fine;
  for (int step = 0; step <= NestedPieces::Steps; ++step)
  {
    fine = Execute(input, 1 + step);
    points[step] = fine->GetNumberOfPoints();
    if (step == 0)
    {
      mesh = fine;
    }
  }
  return NestedPieces(fine, points);
}

}

TEST(Deviations, PiecesLieInTheirCells)
{
  vtkSmartPointer<vtkPointSet> mesh;
  const Grid input = MakeRandomComplex(4);
  const NestedPieces pieces = MakePieces(input, mesh);
  ASSERT_TRUE(pieces.AreOf(mesh));
  EXPECT_FALSE(pieces.AreOf(Execute(input, 2)));
  // Midpoints without smoothing: each point is where its weights and its parents say.
  const Configure linear = [](Filter* filter) { filter->SetVolumeSchemeToLinear(); };
  const Grid fine = Execute(input, 1 + NestedPieces::Steps, linear);
  const auto getMean = [&](const vtkIdType* ids, const double* weights, int size)
  {
    Point mean{};
    for (int k = 0; k < size; ++k)
    {
      const Point p = GetPoint(fine, ids[k]);
      for (int x = 0; x < 3; ++x)
      {
        mean[x] += weights[k] * p[x];
      }
    }
    return mean;
  };
  const auto expectNear = [](const Point& a, const Point& b)
  {
    for (int x = 0; x < 3; ++x)
    {
      ASSERT_NEAR(a[x], b[x], 1e-12);
    }
  };
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    const int corners = pieces.GetNumberOfCorners(c);
    vtkIdType ids[4]{};
    for (int k = 0; k < corners; ++k)
    {
      ids[k] = pieces.GetCorner(c, k);
    }
    for (vtkIdType p = pieces.GetFirst(c); p < pieces.GetFirst(c + 1); ++p)
    {
      for (int k = 0; k < corners; ++k)
      {
        expectNear(GetPoint(fine, pieces.GetPiece(p)[k]),
          getMean(ids, pieces.GetWeights(c, p, k).data(), corners));
      }
    }
  }
  const double half[2] = { 0.5, 0.5 };
  for (const int step : { 2, 3 })
  {
    for (vtkIdType i = pieces.GetNumberOfPoints(step - 1); i < pieces.GetNumberOfPoints(step); ++i)
    {
      const vtkIdType* parents = pieces.GetParents(step, i);
      ASSERT_GE(parents[1], 0);
      ASSERT_LT(parents[2], 0);
      expectNear(GetPoint(fine, i), getMean(parents, half, 2));
    }
  }
}

TEST(Deviations, RangesSpreadInLayersOfPieces)
{
  vtkSmartPointer<vtkPointSet> mesh;
  const NestedPieces pieces = MakePieces(MakeFan(5), mesh);
  const vtkIdType size = pieces.GetNumberOfPoints(NestedPieces::Steps);
  std::set<vtkIdType> reached{ pieces.GetPiece(7)[1] };
  const double zero[2] = { 0., 0. };
  const double vector[2] = { 3., -4. };
  for (const int layers : { 0, 1, 2 })
  {
    Deviations deviations(pieces, 2);
    for (vtkIdType i = 0; i < size; ++i)
    {
      deviations.Add(i, zero);
    }
    deviations.Add(pieces.GetPiece(7)[1], vector);
    deviations.Spread(layers);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const double* range = deviations.Get(i);
      const bool isReached = reached.count(i) > 0;
      EXPECT_EQ(range[1], isReached ? -4. : 0.) << layers << " " << i; // the least
      EXPECT_EQ(range[2], isReached ? 3. : 0.);                        // the largest
      EXPECT_EQ(range[4], isReached ? 5. : 0.);                        // the norm
      EXPECT_EQ(range[0], 0.);
      EXPECT_EQ(range[3], 0.);
    }
    const std::set<vtkIdType> before = reached;
    for (vtkIdType p = 0; p < pieces.GetNumberOfPieces(); ++p)
    {
      const vtkIdType* piece = pieces.GetPiece(p);
      if (std::any_of(piece, piece + 3, [&](vtkIdType i) { return before.count(i) > 0; }))
      {
        reached.insert(piece, piece + 3);
      }
    }
  }
}

TEST(Deviations, WhatIsNotFiniteIsUnknown)
{
  vtkSmartPointer<vtkPointSet> mesh;
  const NestedPieces pieces = MakePieces(MakeFan(3), mesh);
  Deviations deviations(pieces, 1);
  const double values[2] = { 1., std::nan("") };
  deviations.Add(0, values);
  deviations.Add(0, values + 1);
  deviations.Add(0, values);
  EXPECT_EQ(deviations.Get(0)[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(deviations.Get(0)[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(deviations.Get(0)[2], std::numeric_limits<double>::infinity());
}
