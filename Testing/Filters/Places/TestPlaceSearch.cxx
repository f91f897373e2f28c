// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPlaceSearch.cxx
 * Newton's method for nearest places, on maps that are written down here.
 */
#include "Precompiled.h"

#include "Private/Places/PlaceSearch.h"

using namespace subdivision;

namespace
{

using Vector = std::array<double, 3>;

/// A search in one tetrahedron or triangle, with the number of places that it looked at.
template <typename Map>
std::pair<PlaceSearch, int> Search(
  int dimension, const Map& map, const Vector& target, const std::array<double, 4>& start)
{
  const std::vector<unsigned char> dimensions{ static_cast<unsigned char>(dimension) };
  const std::vector<vtkIdType> connectivity{ 0, 1, 2, 3 };
  const SearchedCells cells{ dimension + 1, dimensions, connectivity, false };
  PlaceSearch search;
  search.Place.Cell = 0;
  search.Place.Weights = start;
  int count = 0;
  for (; !search.IsDone && count < 40; ++count)
  {
    const auto& w = search.Place.Weights;
    AdvanceSearch(cells, map(w[1], w[2], w[3]), target, search);
  }
  return { search, count };
}

/// A hill over the first two parameters with its top at (0.3, 0.25), which fills what lies above.
/// `bend`: how steep.
PlaceValue MapToHill(double u, double v, double w, double bend)
{
  const double x = u - 0.3;
  const double y = v - 0.25;
  PlaceValue value{};
  value[PlaceParts::Value] = { { u, v, w + bend * (x * x + y * y) } };
  value[PlaceParts::First] = { { 1., 0., 2. * bend * x } };
  value[PlaceParts::First + 1] = { { 0., 1., 2. * bend * y } };
  value[PlaceParts::First + 2] = { { 0., 0., 1. } };
  return value;
}

}

/// From far below, the curvature of the hill counts more than its slopes, and no second derivatives
/// are known in a solid.
TEST(PlaceSearch, ASolidWithACurvedSideIsFoundFromFarAway)
{
  const auto hill = [](double u, double v, double w) { return MapToHill(u, v, w, 2.); };
  for (const std::array<double, 4>& start : { std::array<double, 4>{ { 0.25, 0.25, 0.25, 0.25 } },
         { { 0., 0.9, 0.1, 0. } }, { { 0.1, 0.1, 0.7, 0.1 } } })
  {
    const auto [search, count] = Search(3, hill, { { 0.3, 0.25, -10. } }, start);
    EXPECT_TRUE(search.IsDone);
    EXPECT_LE(count, 20);
    EXPECT_NEAR(search.Place.Weights[1], 0.3, 1e-9);
    EXPECT_NEAR(search.Place.Weights[2], 0.25, 1e-9);
    EXPECT_EQ(search.Place.Weights[3], 0.);
    EXPECT_NEAR(search.Best.Distance, 10., 1e-12);
  }
}

/// Beside a hollow the places on both sides of it are nearer than those between: the search ends at
/// one of them.
TEST(PlaceSearch, ASolidWithAHollowSideIsFoundAtItsRim)
{
  const auto hollow = [](double u, double v, double w) { return MapToHill(u, v, w, -2.); };
  for (const double start : { 0.1, 0.28, 0.31, 0.6 })
  {
    const auto [search, count] =
      Search(3, hollow, { { 0.3, 0.25, -10. } }, { { 0.7 - start, start, 0.2, 0.1 } });
    EXPECT_TRUE(search.IsDone);
    EXPECT_LE(count, 25);
    const auto& w = search.Place.Weights;
    EXPECT_EQ(w[3], 0.);
    EXPECT_EQ(w[0] * w[1] * w[2], 0.);
    EXPECT_LT(search.Best.Distance, 9.8); // the nearest corner is one of the places
  }
}

/// With second derivatives, near the place each step makes right digits twice as many: no step is
/// damped there.
TEST(PlaceSearch, NewtonsMethodIsNotDampedNearThePlace)
{
  const auto hill = [](double u, double v, double w)
  {
    PlaceValue value = MapToHill(u, v, w, 2.);
    value[PlaceParts::Second] = value[PlaceParts::SecondOfSecond] = { { 0., 0., 4. } };
    return value;
  };
  const auto [search, count] =
    Search(2, hill, { { 0.3, 0.25, -10. } }, { { 0.4, 0.32, 0.28, 0. } });
  EXPECT_TRUE(search.IsDone);
  EXPECT_LE(count, 6);
  EXPECT_NEAR(search.Place.Weights[1], 0.3, 1e-13);
}

/// A cusp of the distance: steps that only make it larger become short in few places.
TEST(PlaceSearch, AFoldIsLeftSoon)
{
  const auto fold = [](double u, double v, double w)
  {
    PlaceValue value = MapToHill(u, v, w, 0.);
    value[PlaceParts::Value][2] += u < 0.3 ? 3. * (0.3 - u) : u - 0.3;
    value[PlaceParts::First][2] = u < 0.3 ? -3. : 1.;
    return value;
  };
  const auto [search, count] = Search(3, fold, { { 0.3, 0.25, -10. } }, { { 0.3, 0.3, 0.3, 0.1 } });
  EXPECT_TRUE(search.IsDone);
  EXPECT_LE(count, 20);
  EXPECT_NEAR(search.Best.Distance, 10., 1e-3);
}
