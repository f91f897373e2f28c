// SPDX-License-Identifier: BSD-3-Clause
// Stars of vertices that are the same but for the numbers of their vertices.
#include "Core/Smoothness/SolidMaps.h"

#include <algorithm>
#include <map>
#include <utility>

namespace subdivision
{
namespace
{

/// The triangles opposite to the vertex of a star, and which of their corners the vertex is joined
/// to by a marked edge.
class StarWalk
{
public:
  /// Leaves HasAll false if the triangles do not form one closed surface.
  StarWalk(const SolidStar& star, bool marks)
  {
    for (const auto& tet : star.Tets)
    {
      const auto centre = static_cast<int>(std::find(tet.begin(), tet.end(), 0) - tet.begin());
      if (centre == 4)
      {
        return;
      }
      // In this order each corner is followed by the others: the one at the marked edge is first.
      const int partner = centre ^ 2;
      this->Triangles.push_back({ { tet[partner], tet[centre ^ 1], tet[partner ^ 1] } });
      this->Size = std::max({ this->Size, 1 + tet[0], 1 + tet[1], 1 + tet[2], 1 + tet[3] });
    }
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->AtEdges[this->GetEdge(t, k)].push_back(static_cast<int>(t));
      }
    }
    this->Marks = marks;
    this->HasAll = std::all_of(this->AtEdges.begin(), this->AtEdges.end(),
      [](const auto& edge) { return edge.second.size() == 2; });
  }

  /// The tetrahedra as a walk finds them that begins in a triangle with its corners in an order;
  /// fewer if it does not reach all.
  std::vector<std::array<int, 4>> Walk(int start, const std::array<int, 3>& order) const
  {
    std::vector<int> numbers(static_cast<std::size_t>(this->Size), 0);
    int next = 1;
    for (const int k : order)
    {
      numbers[this->Triangles[start][k]] = next++;
    }
    std::vector<char> isListed(this->Triangles.size(), 0);
    std::vector<std::pair<int, std::array<int, 3>>> list{ { start, order } };
    isListed[start] = 1;
    std::vector<std::array<int, 4>> tets;
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const auto [t, corners] = list[i];
      const auto& triangle = this->Triangles[t];
      std::array<int, 3> made{};
      for (int k = 0; k < 3; ++k)
      {
        int& number = numbers[triangle[corners[k]]];
        number = number == 0 ? next++ : number;
        made[k] = number;
      }
      if (this->Marks)
      {
        const auto first =
          static_cast<int>(std::find(corners.begin(), corners.end(), 0) - corners.begin());
        std::swap(made[first], made[1]);
        made[0] > made[2] ? std::swap(made[0], made[2]) : void();
      }
      else
      {
        std::sort(made.begin(), made.end());
      }
      tets.push_back({ { 0, made[0], made[1], made[2] } }); // marked edges are 02 and 13
      for (int k = 0; k < 3; ++k)
      {
        const int a = triangle[corners[k]];
        const int b = triangle[corners[(k + 1) % 3]];
        const auto& sides = this->AtEdges.at(std::minmax(a, b));
        const int other = sides[0] == t ? sides[1] : sides[0];
        if (!isListed[other])
        {
          isListed[other] = 1;
          list.emplace_back(other, this->Order(other, a, b));
        }
      }
    }
    return tets;
  }

  std::vector<std::array<int, 3>> Triangles;
  bool HasAll = false;

private:
  std::pair<int, int> GetEdge(std::size_t t, int k) const
  {
    return std::minmax(
      { this->Triangles[t][k], this->Triangles[t][static_cast<std::size_t>((k + 1) % 3)] });
  }
  /// The corners of a triangle: two that are given, and the third.
  std::array<int, 3> Order(int t, int a, int b) const
  {
    const auto& triangle = this->Triangles[t];
    const auto find = [&triangle](int vertex)
    {
      return static_cast<int>(
        std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
    };
    const int first = find(a);
    const int second = find(b);
    return { { first, second, 3 - first - second } };
  }

  std::map<std::pair<int, int>, std::vector<int>> AtEdges;
  int Size = 0;
  bool Marks = false;
};

}

SolidStar OrderStar(const SolidStar& star, bool marks)
{
  const StarWalk walk(star, marks);
  SolidStar least = star;
  bool isFirst = true;
  for (int t = 0; walk.HasAll && t < static_cast<int>(walk.Triangles.size()); ++t)
  {
    std::array<int, 3> order{ { 0, 1, 2 } };
    do
    {
      std::vector<std::array<int, 4>> tets = walk.Walk(t, order);
      if (tets.size() < star.Tets.size())
      {
        return star; // they hang together in the vertex only
      }
      if (isFirst || tets < least.Tets)
      {
        least.Tets = std::move(tets);
        isFirst = false;
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return least;
}

}
