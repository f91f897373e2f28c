// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellsToSimplicesLattice.h
 * All triangulations of a cube, and random hybrid meshes that use them.
 */
#ifndef SubdivisionObjects_CellsToSimplicesLattice_h
#define SubdivisionObjects_CellsToSimplicesLattice_h

#include "CellsToSimplicesTools.h"

#include <bitset>

namespace cells_to_simplices_tools
{

inline const std::vector<Point> CubePoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
inline constexpr int CubeFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
  { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
/// A triangulation of the cube.
struct CubeSplit
{
  unsigned Pattern = 0; ///< bit f: face f has the diagonal 1-3
  std::vector<std::array<int, 4>> Tets;
};

/// Every triangulation of the cube, found by trying all sets of tets.
class AllCubeSplits
{
public:
  AllCubeSplits();

  std::vector<CubeSplit> Splits;

private:
  static constexpr int Samples = 1024;
  using Cover = std::bitset<Samples>;

  void AddTet(std::array<int, 4> tet, const std::vector<Point>& samples);
  void Search(std::vector<int>& chosen, const Cover& covered);
  void Keep(const std::vector<int>& chosen);

  std::vector<std::array<int, 4>> Tets;
  std::vector<Cover> Covers;
};

const AllCubeSplits& GetAllCubeSplits();

/// A cube of cubes, each of them a random kind of cell or several cells, with points in random
/// order.
class RandomLattice
{
public:
  RandomLattice(int size, unsigned seed);

  Mesh Result;

private:
  vtkIdType At(int x, int y, int z) const
  {
    const int n = this->Size + 1;
    return this->Number[static_cast<size_t>((z * n + y) * n + x)];
  }

  int Throw(int sides) { return std::uniform_int_distribution<int>(0, sides - 1)(this->Random); }

  /// Cubes with triangles on the outside touch only cubes without.
  void AddCube(int x, int y, int z);

  int Size;
  std::mt19937 Random;
  Ids Number;
};

}

#endif
