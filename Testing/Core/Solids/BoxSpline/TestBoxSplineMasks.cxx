// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 5: the masks of the scheme of Chang and Qin, as its tables have them.
#include "Precompiled.h"

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"

using namespace subdivision;

namespace
{

void ExpectMask(const RingMasks& masks, bool ofEdge, Rule rule, vtkIdType size, double own)
{
  const PartedMask mask = GetMask(masks, ofEdge, rule, size);
  const double ends = ofEdge ? 2. : 1.;
  EXPECT_NEAR(mask.Own, own, 1e-15) << static_cast<int>(rule) << " " << size;
  EXPECT_EQ(mask.Parts, 1);
  EXPECT_EQ(mask.Sizes[0], size);
  if (size == 0)
  {
    EXPECT_EQ(mask.Weights[0], 0.); // there is no member
    return;
  }
  EXPECT_NEAR(mask.Weights[0], (1. - ends * own) / static_cast<double>(size), 1e-15)
    << static_cast<int>(rule) << " " << size;
}

}

TEST(BoxSplineMasks, OfVertices)
{
  for (const LoopWeights weights : { LoopWeights::Warren, LoopWeights::Loop })
  {
    const RingMasks& masks = BoxSplineMasks(weights);
    EXPECT_EQ(&masks, &BoxSplineMasks(weights)); // made once
    for (const vtkIdType size : { 1, 2, 3, 4, 5, 6, 7, 12, 63, 64, 100 })
    {
      const double wave = 3. / 8. + std::cos(2. * std::acos(-1.) / static_cast<double>(size)) / 4.;
      const double surface = size == 3   ? 7. / 16.
        : weights == LoopWeights::Warren ? 5. / 8.
                                         : 3. / 8. + wave * wave;
      ExpectMask(masks, false, Rule::Surface, size, surface);
      ExpectMask(masks, false, Rule::Solid, size, 9. / 16.);
    }
    ExpectMask(masks, false, Rule::Curve, 2, 3. / 4.);
  }
}

// A vertex without a ring stays.
TEST(BoxSplineMasks, OfVerticesWithoutARing)
{
  for (const LoopWeights weights : { LoopWeights::Warren, LoopWeights::Loop })
  {
    for (const Rule rule : { Rule::Curve, Rule::Surface, Rule::Solid })
    {
      ExpectMask(BoxSplineMasks(weights), false, rule, 0, 1.);
    }
  }
}

TEST(BoxSplineMasks, OfEdges)
{
  for (const LoopWeights weights : { LoopWeights::Warren, LoopWeights::Loop })
  {
    const RingMasks& masks = BoxSplineMasks(weights);
    ExpectMask(masks, true, Rule::Surface, 2, 3. / 8.);
    ExpectMask(masks, true, Rule::Solid, 5, 5. / 16.);
    ExpectMask(masks, true, Rule::Solid, 0, 1. / 2.);
    ExpectMask(masks, true, Rule::RegularEdge, 4, 1. / 4.);
  }
}
