// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTakeStencils.cxx
 * Mathematics 1: the operator takes all that its rows need out of a level, and no carriers.
 */
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Solids/Scheme/Stencils.h"

using namespace coretest;

namespace
{

template <typename T>
std::vector<T> ToVector(const Buffer<T>& buffer)
{
  return std::vector<T>(buffer.begin(), buffer.end());
}

std::vector<unsigned char> ToBytes(const Buffer<Stratum>& strata)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(strata.data());
  return std::vector<unsigned char>(
    bytes, bytes + static_cast<std::size_t>(strata.size()) * sizeof(Stratum));
}

/// Everything of a level that its rows are made of.
struct Parts
{
  std::vector<unsigned char> Vertices;
  std::vector<unsigned char> Edges;
  std::vector<int> EdgeVertices;
  std::vector<int> VertexOffsets;
  std::vector<int> VertexMembers;
  std::vector<int> EdgeOffsets;
  std::vector<int> EdgeMembers;
  std::vector<int> Centres;
  bool operator==(const Parts& other) const
  {
    return this->Vertices == other.Vertices && this->Edges == other.Edges &&
      this->EdgeVertices == other.EdgeVertices && this->VertexOffsets == other.VertexOffsets &&
      this->VertexMembers == other.VertexMembers && this->EdgeOffsets == other.EdgeOffsets &&
      this->EdgeMembers == other.EdgeMembers && this->Centres == other.Centres;
  }
};

Parts MakeParts(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges,
  const Buffer<int>& edgeVertices, const Rings<int>& vertexRings, const Rings<int>& edgeRings)
{
  return { ToBytes(vertices), ToBytes(edges), ToVector(edgeVertices), ToVector(vertexRings.Offsets),
    ToVector(vertexRings.Members), ToVector(edgeRings.Offsets), ToVector(edgeRings.Members), {} };
}

/// What the levels of a test had, so that it does not pass for want of that.
struct Sums
{
  std::size_t Sectors = 0;
  vtkIdType VertexCarriers = 0;
  vtkIdType EdgeCarriers = 0;
  vtkIdType Octahedra = 0;
};

/// Takes the operator of a level, and compares.
template <typename Level>
void CheckLevel(Level& level, const Buffer<int>& octahedra, Sums& sums)
{
  const auto& strata = level.Strata;
  Parts before = MakeParts(strata.Vertices, strata.Edges, level.Complex.EdgeVertices,
    strata.VertexRings, strata.EdgeRings);
  before.Centres = ToVector(octahedra);
  const SolidRows<int> solids = GetSolidRows(level);
  const ExplicitRows<int> sectors = MakeSectorRows(level.Strata, level.Complex.EdgeVertices);
  const vtkIdType rows = strata.Vertices.size() + strata.Edges.size() + octahedra.size() / 6;
  EXPECT_EQ(GetStoredRows(level).GetNumberOfRows(), rows);
  EXPECT_EQ(LevelRows<int>(level).GetNumberOfRows(), rows);
  sums.Sectors += sectors.Rows.size();
  sums.VertexCarriers += strata.VertexRings.Carriers.size();
  sums.EdgeCarriers += strata.EdgeRings.Carriers.size();
  sums.Octahedra += octahedra.size() / 6;

  const Stencils<int> taken = TakeStencils(level);
  Parts after =
    MakeParts(taken.Vertices, taken.Edges, taken.EdgeVertices, taken.VertexRings, taken.EdgeRings);
  after.Centres = ToVector(taken.CentreVertices);
  EXPECT_TRUE(after == before);
  EXPECT_EQ(taken.GetNumberOfRows(), rows);
  EXPECT_EQ(taken.VertexRings.Carriers.size(), 0);
  EXPECT_EQ(taken.EdgeRings.Carriers.size(), 0);
  EXPECT_EQ(taken.Masks, solids.Masks);
  EXPECT_EQ(taken.NumberOfCounted, solids.NumberOfCounted);
  EXPECT_EQ(taken.Counts ? taken.Counts->data() : nullptr, solids.Counts);
  EXPECT_EQ(taken.Explicit.Rows, sectors.Rows);
  EXPECT_EQ(taken.Explicit.Offsets, sectors.Offsets);
  EXPECT_EQ(taken.Explicit.Columns, sectors.Columns);
  EXPECT_EQ(taken.Explicit.Weights, sectors.Weights);
}

}

TEST(TakeStencils, NothingIsNamedBeforeItIsSet)
{
  EXPECT_EQ(ExplicitRows<int>().Offsets, std::vector<int>{ 0 });
  const SolidRows<int> solids{ nullptr };
  EXPECT_EQ(solids.NumberOfCentres, 0);
  EXPECT_EQ(solids.CentreVertices, nullptr);
  EXPECT_EQ(solids.NumberOfCounted, 0);
  EXPECT_EQ(solids.Counts, nullptr);
  const Stencils<int> stencils;
  EXPECT_EQ(stencils.Masks, nullptr);
  EXPECT_EQ(stencils.NumberOfCounted, 0);
  EXPECT_EQ(stencils.Counts, nullptr);
  EXPECT_EQ(stencils.GetNumberOfRows(), 0);
}

TEST(TakeStencils, AllOfALevel)
{
  Sums sums;
  for (const Mesh& mesh : MakeZoo())
  {
    for (const char* options : { "Blend", "ModifiedBoundary" })
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      Subdivided<int> level = BuildNamed<int>(mesh, options);
      CheckLevel(level.Level, Buffer<int>(), sums);
    }
  }
  EXPECT_GT(sums.Sectors, 0u);
  EXPECT_GT(sums.VertexCarriers, 0);
  EXPECT_GT(sums.EdgeCarriers, 0);
}

TEST(TakeStencils, AllOfALevelWithOctahedra)
{
  Sums sums;
  for (const Mesh& mesh : MakeZoo())
  {
    SCOPED_TRACE(mesh.Name);
    for (const int steps : { 0, 1 })
    {
      auto level = tetoct_tools::BuildTetOctAt<int>(mesh, steps);
      Buffer<int> copied(level.Level.OctVertices.size());
      std::copy(level.Level.OctVertices.begin(), level.Level.OctVertices.end(), copied.begin());
      CheckLevel(level.Level, copied, sums);
    }
  }
  EXPECT_GT(sums.Octahedra, 0);
}
