// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceLastStep.cxx
 * What is left out of the last two levels of a surface, and rings that are found without a walk,
 * change nothing.
 */
#include "SurfaceTools.h"

#include "Core/Surfaces/Steps/SurfaceSteps.h"

using namespace surfacetools;

namespace
{

class SurfaceLastStep : public testing::TestWithParam<SurfaceSchemeKind>
{
};

std::vector<vtkIdType> GetFaces(const SurfaceSteps<int>& steps)
{
  const int last = steps.GetNumberOfSteps();
  std::vector<vtkIdType> faces(steps.GetNumberOfCorners(last));
  steps.WriteFaces(last, faces.data());
  std::vector<int> narrow(faces.size());
  steps.WriteFaces(last, narrow.data());
  EXPECT_TRUE(std::equal(faces.begin(), faces.end(), narrow.begin(), narrow.end()));
  return faces;
}

std::vector<int> GetLineEnds(const SurfaceLevel<int>& level)
{
  std::vector<int> ends;
  for (const int line : level.Lines)
  {
    ends.push_back(level.Mesh.EdgeVertices[2 * (line / 2) + line % 2]);
    ends.push_back(level.Mesh.EdgeVertices[2 * (line / 2) + 1 - line % 2]);
  }
  return ends;
}

template <typename T>
void ExpectEqual(const Buffer<T>& a, const Buffer<T>& b)
{
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
}

}

TEST_P(SurfaceLastStep, IsTheSameAsOfWholeLevels)
{
  const bool triangles = MakeSurfaceScheme<int>(GetParam(), true)->NeedsTriangles();
  for (const auto& entry : MakeZoo(triangles))
  {
    for (int count = 1; count <= 4; ++count)
    {
      SCOPED_TRACE(entry.first + ", " + std::to_string(count) + " steps");
      Walk first(entry.second, GetParam());
      Walk second(entry.second, GetParam());
      const SurfaceSteps<int> brief(std::move(first.Level), first.Scheme, count, false, nullptr);
      const SurfaceSteps<int> full(std::move(second.Level), second.Scheme, count, true, nullptr);
      EXPECT_EQ(GetFaces(brief), GetFaces(full));
      EXPECT_EQ(GetLineEnds(brief.GetLevel(count)), GetLineEnds(full.GetLevel(count)));
      for (int step = 0; step < count; ++step)
      {
        const SparseRows<int> rows = brief.GetStep(step).Store();
        const SparseRows<int> expected = full.GetStep(step).Store();
        ExpectEqual(rows.Offsets, expected.Offsets);
        ExpectEqual(rows.Columns, expected.Columns);
        ExpectEqual(rows.Weights, expected.Weights);
        const auto faces = MakeCarriers<int>(full.GetLevel(step).Mesh.NumberOfFaces);
        Buffer<Carrier<int>> carriers[2];
        brief.GetScheme().CarryFaces(brief.GetLevel(step), faces, true, carriers[0]);
        full.GetScheme().CarryFaces(full.GetLevel(step), faces, true, carriers[1]);
        ExpectEqual(carriers[0], carriers[1]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfaceLastStep,
  testing::Values(SurfaceSchemeKind::Loop, SurfaceSchemeKind::ModifiedButterfly,
    SurfaceSchemeKind::CatmullClark, SurfaceSchemeKind::DooSabin, SurfaceSchemeKind::Midedge,
    SurfaceSchemeKind::FourEight, SurfaceSchemeKind::SqrtThree, SurfaceSchemeKind::Linear));

/// In odd steps, and in even ones where no edge is fixed, the row of a smooth vertex is its ring in
/// the order of its fan.
TEST(SurfaceSqrtThree, RowsHaveTheRingInTheOrderOfTheFan)
{
  int centres = 0;
  for (const auto& entry : MakeZoo(true))
  {
    SCOPED_TRACE(entry.first);
    Walk walk(entry.second, SurfaceSchemeKind::SqrtThree);
    for (int step = 0; step < 4; ++step, walk.Step())
    {
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      if (!walk.Level.Places.empty())
      {
        continue;
      }
      const RowBlock<int> rows = walk.GetRows();
      for (int v = 0; v < mesh.NumberOfVertices; ++v)
      {
        if (walk.Level.Tags.Vertices[v] != VertexTag::Smooth)
        {
          continue;
        }
        std::vector<int> ring{ v };
        VisitCycle(mesh, mesh.VertexCorners[v], [&](const FanStep<int>& at)
          { ring.push_back(mesh.GetOtherEnd(mesh.Edges[at.GetHalfEdgeIn(mesh)], v)); });
        const std::vector<int> columns(
          rows.GetColumns() + rows.GetBegin(v), rows.GetColumns() + rows.GetEnd(v));
        ASSERT_EQ(columns, ring) << "vertex " << v << ", step " << step;
        centres += step > 0 && ring.size() == 7;
        for (std::size_t k = rows.GetBegin(v) + 1; k < rows.GetEnd(v); ++k)
        {
          ASSERT_EQ(rows.GetWeights()[k], rows.GetWeights()[rows.GetBegin(v) + 1]);
        }
      }
    }
  }
  EXPECT_GT(centres, 100);
}
