// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: rows of tangents with equal weights, where all around is regular.
#include "SchemeTools.h"

using namespace surfacetools;

namespace
{

/// A level five steps after a surface with irregular vertices and a boundary.
SurfaceLevel<int> MakeFine(const SurfaceScheme<int>& scheme)
{
  const Model model = MakeFan(7, false);
  SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, {});
  ClassifyModel(model, scheme, {}, level);
  scheme.RestrictTags(level);
  for (int step = 0; step < 5; ++step)
  {
    scheme.Prepare(level);
    level = scheme.Refine(level, Depth::ForRefinement);
  }
  scheme.Prepare(level);
  return level;
}

Weights GetRow(const SurfaceScheme<int>& scheme, const SurfaceLevel<int>& level,
  const SurfaceTags<int>& tags, LimitKind kind, int vertex)
{
  RowBlock<int> rows;
  scheme.AppendLimitRows(level, tags, kind, vertex, vertex + 1, rows);
  return ToWeights(rows);
}

}

TEST(RegularTangents, TheSecondHasTheColumnsOfTheFirst)
{
  for (const SurfaceSchemeKind kind : { SurfaceSchemeKind::ModifiedButterfly,
         SurfaceSchemeKind::SqrtThree, SurfaceSchemeKind::DooSabin })
  {
    SCOPED_TRACE(static_cast<int>(kind));
    const auto scheme = MakeSurfaceScheme<int>(kind, false);
    const SurfaceLevel<int> level = MakeFine(*scheme);
    RowBlock<int> rows;
    scheme->AppendLimitRows(
      level, level.Tags, LimitKind::Tangent1, 0, level.Mesh.NumberOfVertices, rows);
    int regular = 0;
    rows.ForRuns(0,
      [&](const auto& run)
      {
        using Run = std::decay_t<decltype(run)>;
        if constexpr (std::is_same<Run, EqualRows<int>>::value)
        {
          const double* second = scheme->GetSecondTangent(run.Weights);
          ASSERT_NE(second, nullptr);
          for (vtkIdType i = 0; i < run.Count; ++i, ++regular)
          {
            Weights row;
            for (int k = 0; k < run.Size; ++k)
            {
              row[run.Columns[run.Size * i + k]] += second[k];
            }
            const int vertex = static_cast<int>(run.FirstRow + i);
            ExpectRow(row, GetRow(*scheme, level, level.Tags, LimitKind::Tangent2, vertex),
              "vertex " + std::to_string(vertex));
          }
        }
      });
    EXPECT_GT(regular, 20);
    EXPECT_LT(regular, level.Mesh.NumberOfVertices);
  }
}

/// Tags that Prepare did not see make no row regular: then rows come from the next level.
TEST(RegularTangents, OfButterflyAreThoseOfTheNextLevel)
{
  const auto scheme = MakeSurfaceScheme<int>(SurfaceSchemeKind::ModifiedButterfly, false);
  const SurfaceLevel<int> level = MakeFine(*scheme);
  SurfaceTags<int> others;
  others.Edges = Buffer<EdgeTag>(level.Tags.Edges.size());
  others.Vertices = Buffer<VertexTag>(level.Tags.Vertices.size());
  std::copy(level.Tags.Edges.begin(), level.Tags.Edges.end(), others.Edges.begin());
  std::copy(level.Tags.Vertices.begin(), level.Tags.Vertices.end(), others.Vertices.begin());
  for (const LimitKind kind : { LimitKind::Tangent1, LimitKind::Tangent2 })
  {
    for (int vertex = 0; vertex < level.Mesh.NumberOfVertices; ++vertex)
    {
      const Weights expected = GetRow(*scheme, level, others, kind, vertex);
      const Weights row = GetRow(*scheme, level, level.Tags, kind, vertex);
      ExpectRow(row, expected, "vertex " + std::to_string(vertex));
    }
  }
}
