// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesLattice.h"

namespace cells_to_simplices_tools
{

AllCubeSplits::AllCubeSplits()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> samples(Samples);
  for (Point& p : samples)
  {
    p = { coordinate(random), coordinate(random), coordinate(random) };
  }
  for (unsigned mask = 0; mask < 256; ++mask)
  {
    std::array<int, 4> tet{};
    int n = 0;
    for (int i = 0; i < 8 && std::bitset<8>(mask).count() == 4; ++i)
    {
      if (mask >> i & 1)
      {
        tet[n++] = i;
      }
    }
    if (n == 4)
    {
      this->AddTet(tet, samples);
    }
  }
  std::vector<int> chosen;
  this->Search(chosen, {});
}

void AllCubeSplits::AddTet(std::array<int, 4> tet, const std::vector<Point>& samples)
{
  double v = Volume(CubePoints, { tet[0], tet[1], tet[2], tet[3] });
  if (std::abs(v) < 1e-9)
  {
    return;
  }
  if (v < 0)
  {
    std::swap(tet[0], tet[1]);
  }
  Cover cover;
  for (int s = 0; s < Samples; ++s)
  {
    bool inside = true;
    for (int left = 0; left < 4; ++left)
    {
      std::vector<Point> corners = { CubePoints[tet[0]], CubePoints[tet[1]], CubePoints[tet[2]],
        CubePoints[tet[3]] };
      corners[left] = samples[s];
      inside = inside && Volume(corners, { 0, 1, 2, 3 }) > 0;
    }
    cover[s] = inside;
  }
  this->Tets.push_back(tet);
  this->Covers.push_back(cover);
}

void AllCubeSplits::Search(std::vector<int>& chosen, const Cover& covered)
{
  if (covered.all())
  {
    this->Keep(chosen);
    return;
  }
  int next = 0;
  while (covered[next])
  {
    ++next;
  }
  for (int t = 0; t < static_cast<int>(this->Tets.size()); ++t)
  {
    if (this->Covers[t][next] && (this->Covers[t] & covered).none())
    {
      chosen.push_back(t);
      this->Search(chosen, this->Covers[t] | covered);
      chosen.pop_back();
    }
  }
}

void AllCubeSplits::Keep(const std::vector<int>& chosen)
{
  CubeSplit split;
  std::vector<Ids> simplices;
  for (const int t : chosen)
  {
    split.Tets.push_back(this->Tets[t]);
    simplices.emplace_back(this->Tets[t].begin(), this->Tets[t].end());
  }
  const auto outside = FacesUsed(CountFaces(simplices), 1);
  if (outside.size() != 12)
  {
    return; // fills the cube, but not face to face
  }
  for (int f = 0; f < 6; ++f)
  {
    const int* q = CubeFaces[f];
    const bool has0 = outside.count(MakeFace(q[0], q[1], q[2])) != 0;
    const bool has1 = outside.count(MakeFace(q[1], q[2], q[3])) != 0;
    if (has0 == has1)
    {
      return;
    }
    split.Pattern |= has1 ? 1u << f : 0;
  }
  this->Splits.push_back(split);
}

const AllCubeSplits& GetAllCubeSplits()
{
  static const AllCubeSplits splits;
  return splits;
}

RandomLattice::RandomLattice(int size, unsigned seed)
  : Size(size)
  , Random(seed)
{
  const int n = size + 1;
  this->Number.resize(static_cast<size_t>(n) * n * n + static_cast<size_t>(size) * size * size);
  for (size_t i = 0; i < this->Number.size(); ++i)
  {
    this->Number[i] = static_cast<vtkIdType>(i);
  }
  std::shuffle(this->Number.begin(), this->Number.end(), this->Random);
  this->Result.Points.resize(this->Number.size());
  for (int z = 0; z < n; ++z)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        this->Result.Points[this->At(x, y, z)] = { x * 1.0, y * 1.0, z * 1.0 };
      }
    }
  }
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        this->AddCube(x, y, z);
      }
    }
  }
}

void RandomLattice::AddCube(int x, int y, int z)
{
  const Ids c = { this->At(x, y, z), this->At(x + 1, y, z), this->At(x + 1, y + 1, z),
    this->At(x, y + 1, z), this->At(x, y, z + 1), this->At(x + 1, y, z + 1),
    this->At(x + 1, y + 1, z + 1), this->At(x, y + 1, z + 1) };
  auto& cells = this->Result.Cells;
  if ((x + y + z) % 2 == 0)
  {
    switch (this->Throw(3))
    {
      case 0:
        cells.push_back({ VTK_HEXAHEDRON, c });
        break;
      case 1:
        cells.push_back({ VTK_WEDGE, { c[0], c[2], c[1], c[4], c[6], c[5] } });
        cells.push_back({ VTK_WEDGE, { c[0], c[3], c[2], c[4], c[7], c[6] } });
        break;
      default:
        const auto& splits = GetAllCubeSplits().Splits;
        for (const auto& t : splits[this->Throw(static_cast<int>(splits.size()))].Tets)
        {
          cells.push_back({ VTK_TETRA, { c[t[0]], c[t[1]], c[t[2]], c[t[3]] } });
        }
        break;
    }
    return;
  }
  switch (this->Throw(4))
  {
    case 0:
    case 1:
      cells.push_back({ VTK_HEXAHEDRON, c });
      break;
    case 2:
      cells.push_back({ VTK_VOXEL, { c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6] } });
      break;
    default:
      const int n = this->Size;
      const vtkIdType middle =
        this->Number[static_cast<size_t>((n + 1) * (n + 1) * (n + 1) + (z * n + y) * n + x)];
      this->Result.Points[middle] = { x + 0.5, y + 0.5, z + 0.5 };
      for (const auto& f : CubeFaces)
      {
        cells.push_back({ VTK_PYRAMID, { c[f[0]], c[f[3]], c[f[2]], c[f[1]], middle } });
      }
      break;
  }
  const Ids top = { c[4], c[5], c[6], c[7] };
  cells.push_back({ VTK_QUAD, top });
}

}
