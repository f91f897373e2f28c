// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 15: the numbers of children, and the weights of solids, number by number.
#include "Precompiled.h"

#include "Core/Cells/CellShapes.h"
#include "Core/Rules/Pi.h"
#include "Core/Solids/Hybrid/HybridMasks.h"

using namespace subdivision;

namespace
{

constexpr double Tiny = 1e-15;
using Points = std::vector<int>;

Points GetPoints(CellShape shape, std::size_t child)
{
  const CellChild& made = GetCellTable(shape).Children[child];
  return { made.Points.begin(), made.Points.begin() + GetCellTable(made.Shape).Corners };
}

void ExpectMask(
  CellShape shape, std::size_t point, double weight, const std::vector<double>& shares)
{
  const SolidMask& mask = GetSolidMasks(shape)[point];
  EXPECT_NEAR(mask.Weight, weight, Tiny);
  double sum = 0.;
  for (std::size_t c = 0; c < shares.size(); ++c)
  {
    EXPECT_NEAR(mask.Shares[c] / mask.Weight, shares[c], Tiny) << "corner " << c;
    sum += mask.Shares[c] / mask.Weight;
  }
  EXPECT_NEAR(sum, 1., Tiny);
}

}

TEST(CellShapes, ChildrenKeepTheOrderOfTheirParent)
{
  EXPECT_EQ(GetPoints(CellShape::Hex, 0), (Points{ 0, 8, 20, 11, 16, 22, 26, 25 }));
  EXPECT_EQ(GetPoints(CellShape::Hex, 3), (Points{ 11, 20, 10, 3, 25, 26, 24, 19 }));
  EXPECT_EQ(GetPoints(CellShape::Hex, 5), (Points{ 22, 17, 23, 26, 12, 5, 13, 21 }));
  EXPECT_EQ(GetPoints(CellShape::Hex, 7), (Points{ 25, 26, 24, 19, 15, 21, 14, 7 }));
  EXPECT_EQ(GetPoints(CellShape::Wedge, 3), (Points{ 6, 7, 8, 15, 16, 17 }));
  EXPECT_EQ(GetPoints(CellShape::Wedge, 7), (Points{ 15, 16, 17, 9, 10, 11 }));
  EXPECT_EQ(GetPoints(CellShape::Wedge, 4), (Points{ 12, 15, 17, 3, 9, 11 }));
  EXPECT_EQ(GetPoints(CellShape::Pyramid, 0), (Points{ 0, 5, 13, 8, 9 }));
  EXPECT_EQ(GetPoints(CellShape::Quad, 2), (Points{ 8, 5, 2, 6 }));
  EXPECT_EQ(GetPoints(CellShape::Triangle, 3), (Points{ 3, 4, 5 }));
  EXPECT_EQ(GetPoints(CellShape::Tet, 1), (Points{ 4, 1, 7, 8 }));
  EXPECT_EQ(GetPoints(CellShape::Octahedron, 0), (Points{ 0, 18, 6, 7, 8, 9 }));
  EXPECT_EQ(GetPoints(CellShape::Octahedron, 6), (Points{ 18, 6, 14, 8 }));
  EXPECT_EQ(GetPoints(CellShape::Octahedron, 7), (Points{ 18, 6, 9, 15 })); // c': swapped
}

TEST(CellShapes, NumbersOfChildren)
{
  const auto after = [](CellShape shape, int steps)
  {
    std::array<double, NumberOfShapes> counts{};
    counts[static_cast<std::size_t>(shape)] = 1.;
    for (int i = 0; i < steps; ++i)
    {
      counts = CountChildren(counts);
    }
    return std::array<double, 5>{ counts[4], counts[5], counts[6], counts[7], counts[8] };
  };
  EXPECT_EQ(after(CellShape::Hex, 3), (std::array<double, 5>{ 0., 0., 0., 512., 0. }));
  EXPECT_EQ(after(CellShape::Wedge, 3), (std::array<double, 5>{ 0., 0., 512., 0., 0. }));
  EXPECT_EQ(after(CellShape::Pyramid, 1), (std::array<double, 5>{ 4., 4., 0., 0., 1. }));
  EXPECT_EQ(after(CellShape::Pyramid, 2), (std::array<double, 5>{ 40., 16., 0., 0., 14. }));
  EXPECT_EQ(after(CellShape::Pyramid, 3), (std::array<double, 5>{ 336., 64., 0., 0., 140. }));
  EXPECT_EQ(after(CellShape::Tet, 3), (std::array<double, 5>{ 176., 0., 0., 0., 84. }));
  EXPECT_EQ(after(CellShape::Octahedron, 2), (std::array<double, 5>{ 80., 0., 0., 0., 44. }));
}

TEST(HybridMasks, SharesOfCoarseCells)
{
  const double h = 1. / 64.;
  ExpectMask(
    CellShape::Hex, 0, 7. / 4., { 27. * h, 9. * h, 3. * h, 9. * h, 9. * h, 3. * h, h, 3. * h });
  const double a = 9. / 32.;
  const double b = 3. / 32.;
  const double c = 1. / 32.;
  ExpectMask(CellShape::Hex, 8, 7. / 2., { a, a, b, b, b, b, c, c });
  const double q = 3. / 16.;
  ExpectMask(CellShape::Hex, 20, 7., { q, q, q, q, 1. / 16., 1. / 16., 1. / 16., 1. / 16. });
  ExpectMask(
    CellShape::Wedge, 0, 7. / 6., { 15. / 32., 9. / 64., 9. / 64., 5. / 32., 3. / 64., 3. / 64. });
  ExpectMask(CellShape::Wedge, 6, 7. / 2., { a, a, q, b, b, 1. / 16. });
  ExpectMask(CellShape::Wedge, 12, 7. / 3., { 5. / 16., b, b, 5. / 16., b, b });
  ExpectMask(CellShape::Wedge, 15, 7., { q, q, 1. / 8., q, q, 1. / 8. });
  ExpectMask(CellShape::Tet, 0, 1., { 15. / 32., 17. / 96., 17. / 96., 17. / 96. });
  ExpectMask(CellShape::Tet, 4, 3., { 11. / 36., 11. / 36., 7. / 36., 7. / 36. });
  const double o = 13. / 144.;
  ExpectMask(CellShape::Octahedron, 0, 1., { 85. / 144., 7. / 144., o, o, o, o });
  ExpectMask(CellShape::Octahedron, 6, 4., { a, 7. / 96., a, 7. / 96., 7. / 48., 7. / 48. });
  const double n = 19. / 192.;
  ExpectMask(CellShape::Pyramid, 0, 1. / 2., { 39. / 64., n, 13. / 192., n, 1. / 8. });
  const double l = 11. / 96.;
  ExpectMask(CellShape::Pyramid, 4, 1., { l, l, l, l, 13. / 24. });
  const double e = 113. / 384.;
  ExpectMask(CellShape::Pyramid, 5, 2., { e, e, 11. / 128., 11. / 128., 23. / 96. });
  ExpectMask(
    CellShape::Pyramid, 9, 4., { 79. / 256., 49. / 256., 77. / 768., 49. / 256., 5. / 24. });
  const double m = 39. / 224.;
  ExpectMask(CellShape::Pyramid, 13, 7., { m, m, m, m, 17. / 56. });
}

TEST(HybridMasks, Relaxation)
{
  for (const LoopWeights weights : { LoopWeights::Warren, LoopWeights::Loop })
  {
    EXPECT_EQ(GetRelaxation(4, 0, weights), 1.);
    EXPECT_EQ(GetRelaxation(0, 6, weights), 1.);
    EXPECT_EQ(GetRelaxation(2, 3, weights), 1.);
    EXPECT_NEAR(GetRelaxation(0, 3, weights), 3. / 2., Tiny);
    EXPECT_NEAR(GetRelaxation(5, 0, weights), 4. / 5., Tiny);
    EXPECT_NEAR(GetRelaxation(1, 1, weights), (36. / 5. + 2.) / 5., Tiny);
  }
  EXPECT_EQ(GetRelaxation(0, 5, LoopWeights::Warren), 1.);
  const double wave = 3. / 8. + std::cos(2. * Pi / 5.) / 4.;
  EXPECT_NEAR(GetRelaxation(0, 5, LoopWeights::Loop), 8. / 3. * (5. / 8. - wave * wave), Tiny);
}
