// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestStarOrder.cxx
 * Stars of vertices that are the same but for the numbers of their vertices become the same.
 */
#include "Precompiled.h"

#include "Core/Smoothness/SolidMaps.h"

using namespace subdivision;

namespace
{

/// The vertex 0 in the middle of a double pyramid over a polygon, in tetrahedra of random orders.
SolidStar MakeStar(int sides, std::mt19937& random)
{
  SolidStar star;
  for (int i = 0; i < sides; ++i)
  {
    for (int top = 1; top < 3; ++top)
    {
      std::array<int, 4> tet{ { 0, top, 3 + i, 3 + (i + 1) % sides } };
      for (std::size_t k = 3; k > 0; --k)
      {
        std::swap(tet[k], tet[random() % (k + 1)]);
      }
      star.Tets.push_back(tet);
    }
  }
  return star;
}

/// The same star with other numbers and orders; marked edges, 02 and 13, stay.
SolidStar Renumber(const SolidStar& star, int vertices, std::mt19937& random)
{
  std::vector<int> numbers(static_cast<std::size_t>(vertices));
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin() + 1, numbers.end(), random);
  SolidStar made = star;
  for (auto& tet : made.Tets)
  {
    std::transform(tet.begin(), tet.end(), tet.begin(), [&](int v) { return numbers[v]; });
    random() % 2 == 0 ? std::swap(tet[0], tet[2]) : void();
    random() % 2 == 0 ? std::swap(tet[1], tet[3]) : void();
    random() % 2 == 0 ? void(std::rotate(tet.begin(), tet.begin() + 1, tet.end())) : void();
  }
  std::shuffle(made.Tets.begin(), made.Tets.end(), random);
  return made;
}

}

TEST(StarOrder, NumbersDoNotMatterButMarksDo)
{
  std::mt19937 random(1);
  for (int sides = 3; sides < 9; ++sides)
  {
    const SolidStar star = MakeStar(sides, random);
    const SolidStar ordered = OrderStar(star, true);
    EXPECT_EQ(ordered.Tets.size(), star.Tets.size());
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_EQ(OrderStar(Renumber(star, sides + 3, random), true).Tets, ordered.Tets);
    }
    const SolidStar other = MakeStar(sides, random);
    EXPECT_EQ(OrderStar(other, false).Tets, OrderStar(star, false).Tets);
    SolidStar marked = star;
    std::swap(marked.Tets[0][1], marked.Tets[0][2]);
    EXPECT_NE(OrderStar(marked, true).Tets, ordered.Tets) << sides;
  }
}

TEST(StarOrder, OpenStarsStay)
{
  std::mt19937 random(1);
  SolidStar star = MakeStar(5, random);
  star.Tets.pop_back();
  EXPECT_EQ(OrderStar(star, true).Tets, star.Tets);
}
