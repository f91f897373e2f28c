// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 10: the weights of rows with d = 3, number by number, worked out by hand from the
// table of weighted centroids; and the weights that this scheme shares with the box spline.
#include "Precompiled.h"

#include "Core/Operators/RingMasks.h"
#include "Core/Solids/TetOct/TetOctMasks.h"
#include "Core/Solids/TetOct/TetOctSplit.h"

using namespace subdivision;

namespace
{

constexpr double Tiny = 1e-15;

/// The number of members and the weight of each, for each section of a ring.
using Sections = std::vector<std::pair<vtkIdType, double>>;

void ExpectMask(const PartedMask& mask, double own, const Sections& sections)
{
  EXPECT_NEAR(mask.Own, own, Tiny);
  ASSERT_EQ(mask.Parts, static_cast<int>(sections.size()));
  for (std::size_t i = 0; i < 3; ++i)
  {
    // Sections behind the last are empty.
    const auto expected = i < sections.size() ? sections[i] : std::make_pair(vtkIdType(0), 0.);
    EXPECT_EQ(mask.Sizes[i], expected.first) << "section " << i;
    EXPECT_NEAR(mask.Weights[i], expected.second, Tiny) << "section " << i;
  }
}

/// `owners` is 1 for a vertex, 2 for the ends of an edge.
void ExpectSumIsOne(const PartedMask& mask, double owners)
{
  double sum = owners * mask.Own;
  for (int i = 0; i < mask.Parts; ++i)
  {
    sum += static_cast<double>(mask.Sizes[i]) * mask.Weights[i];
  }
  EXPECT_NEAR(sum, 1., Tiny);
}

const std::vector<vtkIdType> TetsAtEdges = { 1, 2, 3, 4, 5, 6, 7, 20, 100 };
const std::vector<LoopWeights> BothWeights = { LoopWeights::Warren, LoopWeights::Loop };

}

// Linear subdivision, and then the mean of the centroids: what a coarse cell adds to a row, times
// the number of fine cells that it has there.
TEST(TetOctMaskWeights, SharesOfCoarseCells)
{
  EXPECT_NEAR(tetoct::TetVertexOwn, 15. / 32., Tiny);
  EXPECT_NEAR(tetoct::TetVertexOther, 17. / 96., Tiny);
  EXPECT_NEAR(tetoct::OctVertexOwn, 85. / 144., Tiny);
  EXPECT_NEAR(tetoct::OctVertexNear, 13. / 144., Tiny);
  EXPECT_NEAR(tetoct::OctVertexFar, 7. / 144., Tiny);
  EXPECT_NEAR(tetoct::TetEdgeEnd, 11. / 12., Tiny);
  EXPECT_NEAR(tetoct::TetEdgeOther, 7. / 12., Tiny);
  EXPECT_NEAR(tetoct::OctEdgeEnd, 9. / 8., Tiny);
  EXPECT_NEAR(tetoct::OctEdgeNear, 7. / 12., Tiny);
  EXPECT_NEAR(tetoct::OctEdgeFar, 7. / 24., Tiny);
}

TEST(TetOctMaskWeights, RegularVertexAndEdge)
{
  for (LoopWeights weights : BothWeights)
  {
    const PartedMask vertex = TetOctVertexMask(Rule::RegularEdge, RegularVertexRing, weights);
    ExpectMask(vertex, 25. / 48., { { 12, 11. / 288. }, { 6, 1. / 288. } });
    ExpectSumIsOne(vertex, 1.);
  }
  const PartedMask edge = TetOctEdgeMask(Rule::RegularEdge, RegularEdgeRing);
  ExpectMask(edge, 7. / 24., { { 4, 1. / 12. }, { 4, 1. / 48. } });
  ExpectSumIsOne(edge, 2.);
}

TEST(TetOctMaskWeights, VertexInsideAControlEdge)
{
  for (vtkIdType n : TetsAtEdges)
  {
    SCOPED_TRACE(n);
    const double m = static_cast<double>(n);
    const PartedMask mask = TetOctVertexMask(Rule::Solid, 3 * n + 2, LoopWeights::Warren);
    ExpectMask(
      mask, 55. / 108., { { 2, 17. / 288. }, { 2 * n, 77. / (432. * m) }, { n, 7. / (432. * m) } });
    ExpectSumIsOne(mask, 1.);
  }
}

TEST(TetOctMaskWeights, ControlEdge)
{
  for (vtkIdType n : TetsAtEdges)
  {
    SCOPED_TRACE(n);
    const PartedMask mask = TetOctEdgeMask(Rule::Solid, n);
    ExpectMask(mask, 11. / 36., { { n, 7. / (18. * static_cast<double>(n)) } });
    ExpectSumIsOne(mask, 2.);
  }
}

TEST(TetOctMaskWeights, OtherRulesHaveTheWeightsOfTheBoxSpline)
{
  for (LoopWeights weights : BothWeights)
  {
    ExpectMask(TetOctVertexMask(Rule::Corner, 4, weights), 1., { { 4, 0. } });
    ExpectMask(TetOctVertexMask(Rule::Curve, 2, weights), 3. / 4., { { 2, 1. / 8. } });
    ExpectMask(TetOctVertexMask(Rule::Blend, 7, weights), 9. / 16., { { 7, 1. / 16. } });
    ExpectMask(TetOctVertexMask(Rule::Blend, 1, weights), 9. / 16., { { 1, 7. / 16. } });
  }
  ExpectMask(TetOctVertexMask(Rule::Surface, 4, LoopWeights::Warren), 5. / 8., { { 4, 3. / 32. } });
  ExpectMask(
    TetOctVertexMask(Rule::Surface, 4, LoopWeights::Loop), 33. / 64., { { 4, 31. / 256. } });
  ExpectMask(TetOctEdgeMask(Rule::Curve, 2), 1. / 2., { { 2, 0. } });
  ExpectMask(TetOctEdgeMask(Rule::Surface, 2), 3. / 8., { { 2, 1. / 8. } });
  ExpectMask(TetOctEdgeMask(Rule::Blend, 3), 5. / 16., { { 3, 1. / 8. } });
}

TEST(TetOctMaskWeights, WithoutARingVerticesStayAndEdgesAreHalved)
{
  for (Rule rule : { Rule::Corner, Rule::Curve, Rule::Surface, Rule::Blend })
  {
    SCOPED_TRACE(static_cast<int>(rule));
    ExpectMask(TetOctVertexMask(rule, 0, LoopWeights::Warren), 1., { { 0, 0. } });
    ExpectMask(TetOctEdgeMask(rule, 0), 1. / 2., { { 0, 0. } });
  }
  ExpectMask(TetOctEdgeMask(Rule::Solid, 0), 1. / 2., { { 0, 0. } });
}

// Tables hold masks of rings of up to 63 members; larger ones are computed.
TEST(TetOctMaskWeights, TablesHaveTheSameMasks)
{
  for (LoopWeights weights : BothWeights)
  {
    const RingMasks& masks = TetOctMasks(weights);
    EXPECT_NEAR(masks.CountedOwn, 15. / 32., Tiny);
    EXPECT_NEAR(masks.CountedOther, 17. / 96., Tiny);
    ExpectMask(GetMask(masks, false, Rule::RegularEdge, RegularVertexRing), 25. / 48.,
      { { 12, 11. / 288. }, { 6, 1. / 288. } });
    ExpectMask(GetMask(masks, true, Rule::RegularEdge, RegularEdgeRing), 7. / 24.,
      { { 4, 1. / 12. }, { 4, 1. / 48. } });
    for (vtkIdType n : TetsAtEdges)
    {
      SCOPED_TRACE(n);
      const double m = static_cast<double>(n);
      ExpectMask(GetMask(masks, false, Rule::Solid, 3 * n + 2), 55. / 108.,
        { { 2, 17. / 288. }, { 2 * n, 77. / (432. * m) }, { n, 7. / (432. * m) } });
      ExpectMask(GetMask(masks, true, Rule::Solid, n), 11. / 36., { { n, 7. / (18. * m) } });
    }
  }
  ExpectMask(GetMask(TetOctMasks(LoopWeights::Warren), false, Rule::Surface, 4), 5. / 8.,
    { { 4, 3. / 32. } });
  ExpectMask(GetMask(TetOctMasks(LoopWeights::Loop), false, Rule::Surface, 4), 33. / 64.,
    { { 4, 31. / 256. } });
}
