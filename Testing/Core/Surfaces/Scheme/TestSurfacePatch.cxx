// SPDX-License-Identifier: BSD-3-Clause
// Tags of a patch of a level: corners of sectors are corners of the patch at their vertices, or -1.
#include "SurfaceTools.h"

#include "Core/Surfaces/Scheme/SurfacePatch.h"

using namespace surfacetools;

namespace
{

struct Count
{
  int Known = 0;
  int Unknown = 0;
};

void CheckSectors(const SurfacePatch<int>& patch, const SurfaceTags<int>& tags, Count& count)
{
  for (const Sector<int>& sector : tags.Sectors)
  {
    for (const int corner : { sector.First, sector.Last })
    {
      corner < 0 ? ++count.Unknown : ++count.Known;
      if (corner != -1)
      {
        ASSERT_GE(corner, 0);
        ASSERT_LT(corner, patch.Level.Mesh.GetNumberOfCorners());
        EXPECT_EQ(patch.Level.Mesh.Vertices[corner], sector.Vertex);
      }
    }
  }
}

/// Crops the surroundings of each vertex that has sectors.
Count CheckPatches(const SurfaceLevel<int>& level)
{
  Count count;
  int last = -1;
  for (const Sector<int>& sector : level.Tags.Sectors)
  {
    if (sector.Vertex == last)
    {
      continue;
    }
    last = sector.Vertex;
    const SurfacePatch<int> patch(level, { last });
    CheckSectors(patch, patch.Level.Tags, count);
  }
  return count;
}

}

TEST(SurfacePatch, CornersOfSectorsAreThoseOfTheLevel)
{
  for (const SurfaceSchemeKind kind :
    { SurfaceSchemeKind::FourEight, SurfaceSchemeKind::SqrtThree, SurfaceSchemeKind::CatmullClark })
  {
    Count first;
    for (const auto& [name, model] : MakeZoo(kind == SurfaceSchemeKind::SqrtThree))
    {
      SCOPED_TRACE(name);
      Walk walk(model, kind);
      const Count now = CheckPatches(walk.Level);
      EXPECT_EQ(now.Unknown, 0);
      first.Known += now.Known;
      for (int step = 0; step < 2; ++step)
      {
        walk.Step();
        const Count later = CheckPatches(walk.Level); // corners of the control level become -1
        EXPECT_EQ(later.Unknown + later.Known > 0, now.Known > 0);
        EXPECT_TRUE(kind != SurfaceSchemeKind::CatmullClark || later.Unknown == 0);
      }
    }
    EXPECT_GT(first.Known, 0);
  }
}

TEST(SurfacePatch, CornersThatAreNoneStayNone)
{
  const Walk walk(MakeZoo(false).begin()->second, SurfaceSchemeKind::FourEight);
  ASSERT_FALSE(walk.Level.Tags.Sectors.empty());
  const SurfacePatch<int> patch(walk.Level, { walk.Level.Tags.Sectors.front().Vertex });
  ASSERT_FALSE(patch.Level.Tags.Sectors.empty());
  SurfaceTags<int> tags;
  tags.Edges = Buffer<EdgeTag>(walk.Level.Tags.Edges.size());
  std::fill(tags.Edges.begin(), tags.Edges.end(), EdgeTag::Smooth);
  tags.Vertices = Buffer<VertexTag>(walk.Level.Tags.Vertices.size());
  std::fill(tags.Vertices.begin(), tags.Vertices.end(), VertexTag::Corner);
  tags.Sectors = walk.Level.Tags.Sectors;
  for (Sector<int>& sector : tags.Sectors)
  {
    sector.First = -2;
    sector.Last = static_cast<int>(walk.Level.Mesh.GetNumberOfCorners());
  }
  for (const Sector<int>& sector : patch.CropTags(walk.Level, tags).Sectors)
  {
    EXPECT_EQ(sector.First, -1);
    EXPECT_EQ(sector.Last, -1);
  }
}
