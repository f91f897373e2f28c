// SPDX-License-Identifier: BSD-3-Clause
// Tables of masks: what a function computes, once for each rule and size that tables have.
#include "Precompiled.h"

#include "Core/Operators/RingMasks.h"

using namespace subdivision;

namespace
{

std::map<std::pair<int, vtkIdType>, int> Computed; ///< how often, by rule and size

/// Numbers that tell rules and sizes apart.
Mask ComputeForVertices(Rule rule, vtkIdType size)
{
  ++Computed[{ static_cast<int>(rule), size }];
  return { 1000. * static_cast<int>(rule) + static_cast<double>(size), 0.5 };
}
Mask ComputeForEdges(Rule rule, vtkIdType size)
{
  return { 7000. + 1000. * static_cast<int>(rule) + static_cast<double>(size), 0.25 };
}
PartedMask MakeTwoParts(Rule rule, vtkIdType size)
{
  return { 1000. * static_cast<int>(rule) + static_cast<double>(size), 2, { 3, size - 3, 0 },
    { 0.5, 0.125, 0. } };
}
PartedMask MakeOtherParts(Rule rule, vtkIdType size)
{
  PartedMask mask = MakeTwoParts(rule, size);
  mask.Own += 7000.;
  return mask;
}

}

TEST(RingMasks, TablesHaveAllRulesAndSmallRings)
{
  Computed.clear();
  const MaskTable<Mask> table(ComputeForVertices);
  EXPECT_EQ(Computed.size(), 6u * 64u);
  for (int rule = 0; rule < 6; ++rule)
  {
    for (vtkIdType size = 0; size < 200; ++size)
    {
      ASSERT_EQ((Computed[{ rule, size }]), size < 64 ? 1 : 0);
      Mask scratch{ -1., -1. };
      const Mask& mask = table.Get(static_cast<Rule>(rule), size, scratch);
      EXPECT_EQ(mask.Own, 1000. * rule + static_cast<double>(size));
      EXPECT_EQ(mask.Ring, 0.5);
      // Only large rings are computed now, into the place for them.
      EXPECT_EQ((Computed[{ rule, size }]), 1);
      EXPECT_EQ(&mask == &scratch, size >= 64);
    }
  }
}

TEST(RingMasks, OneMaskFromEitherKindOfTable)
{
  const RingMasks plain{ MaskTables<Mask>{
    MaskTable<Mask>(ComputeForVertices), MaskTable<Mask>(ComputeForEdges) } };
  const RingMasks parted{ MaskTables<PartedMask>{
    MaskTable<PartedMask>(MakeTwoParts), MaskTable<PartedMask>(MakeOtherParts) } };
  EXPECT_EQ(plain.CountedOwn, 0.); // no counts
  EXPECT_EQ(plain.CountedOther, 0.);
  for (const vtkIdType size : { 5, 100 })
  {
    for (const bool ofEdge : { false, true })
    {
      const double own = (ofEdge ? 7000. : 0.) + 3000. + static_cast<double>(size);
      const PartedMask one = GetMask(plain, ofEdge, Rule::Solid, size);
      EXPECT_EQ(one.Own, own);
      EXPECT_EQ(one.Parts, 1);
      EXPECT_EQ(one.Sizes[0], size);
      EXPECT_EQ(one.Weights[0], ofEdge ? 0.25 : 0.5);
      const PartedMask two = GetMask(parted, ofEdge, Rule::Solid, size);
      EXPECT_EQ(two.Own, own);
      EXPECT_EQ(two.Parts, 2);
      EXPECT_EQ(two.Sizes[0], 3);
      EXPECT_EQ(two.Sizes[1], size - 3);
      EXPECT_EQ(two.Weights[1], 0.125);
    }
  }
}
