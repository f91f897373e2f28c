// SPDX-License-Identifier: BSD-3-Clause
#include "HybridTools.h"

#include <random>

namespace hybrid_tools
{

std::vector<Choices> MakeChoices()
{
  std::vector<Choices> all(5);
  all[1].Type1 = all[1].Type2 = all[1].Type3 = JointRule::Sharp;
  all[2].Type1 = JointRule::FollowDimension2;
  all[2].DartEnds = true;
  all[3].Type1 = JointRule::FollowDimension3;
  all[3].Weights = LoopWeights::Loop;
  all[4].ModifiedBoundary = true;
  return all;
}

HybridMesh Take(const hybridtest::Mesh& from)
{
  HybridMesh mesh;
  for (const hybridtest::Point& point : from.Points)
  {
    mesh.AddPoint(point[0], point[1], point[2]);
  }
  for (const hybridtest::Cell& cell : from.Cells)
  {
    mesh.Cells.push_back(
      { static_cast<CellShape>(cell.Shape), { cell.Corners.begin(), cell.Corners.end() } });
  }
  const auto flag = [&mesh](const hybridtest::Ids& ids)
  { mesh.Singular.insert(coretest::Tuple(ids.begin(), ids.end())); };
  std::for_each(from.Singular.begin(), from.Singular.end(), flag);
  for (const auto& [ids, sharpness] : from.Sharpness)
  {
    mesh.Sharpness[coretest::Tuple(ids.begin(), ids.end())] = sharpness;
  }
  const hybridtest::Complex complex(from);
  for (int d = 1; d <= 2; ++d)
  {
    for (const auto& side : complex.GetSides(d))
    {
      const auto cells = complex.CellsAt(side.first, d + 1);
      if (cells.size() == 2 && cells[0].Material != cells[1].Material &&
        (d == 2 || complex.CellsAt(side.first, 3).empty()))
      {
        flag(side.first);
      }
    }
  }
  mesh.Options.DartEnds = from.HasDarts;
  mesh.Options.Weights = from.HasLoopWeights ? LoopWeights::Loop : LoopWeights::Warren;
  if (from.Joint == hybridtest::Joints::Sharp)
  {
    mesh.Options.Type1 = mesh.Options.Type2 = mesh.Options.Type3 = JointRule::Sharp;
  }
  return mesh;
}

HybridMesh Take(const coretest::Mesh& from)
{
  HybridMesh mesh;
  mesh.Points = from.Points;
  mesh.Singular = from.Singular;
  constexpr CellShape shapes[4] = { CellShape::Vertex, CellShape::Line, CellShape::Triangle,
    CellShape::Tet };
  for (const coretest::Tuple& cell : coretest::GetCells(from.Cells))
  {
    mesh.Cells.push_back({ shapes[cell.size() - 1], cell });
  }
  return mesh;
}

void AddSharpness(unsigned int seed, HybridMesh& mesh)
{
  std::mt19937 random(seed);
  for (const Cell& cell : mesh.Cells)
  {
    const auto add = [&](const auto& parts)
    {
      for (const auto& part : parts)
      {
        coretest::Tuple tuple;
        for (const int corner : part)
        {
          tuple.push_back(cell.Corners[corner]);
        }
        if (random() % 12 == 0)
        {
          mesh.Sharpness[coretest::Sorted(tuple)] = .5 * (1 + random() % 5);
        }
      }
    };
    add(GetCellTable(cell.Shape).Edges);
    add(GetCellTable(cell.Shape).Faces);
  }
}

std::vector<std::array<double, 3>> SortPoints(const std::vector<double>& points)
{
  std::vector<std::array<double, 3>> sorted;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    sorted.push_back({ points[i], points[i + 1], points[i + 2] });
  }
  // Equal numbers may differ by rounding. No such number lies at the border of two whole ones.
  const auto round = [](double x) { return std::llround(x * 1e9 * std::sqrt(2.) + 0.123); };
  std::sort(sorted.begin(), sorted.end(),
    [&](const auto& a, const auto& b)
    {
      return std::array<long long, 3>{ round(a[0]), round(a[1]), round(a[2]) } <
        std::array<long long, 3>{ round(b[0]), round(b[1]), round(b[2]) };
    });
  return sorted;
}

void ExpectSamePoints(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  const auto x = SortPoints(a);
  const auto y = SortPoints(b);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(x[i][c], y[i][c], tolerance) << "point " << i << " of the sorted ones";
    }
  }
}

std::vector<double> GetRow(const HybridMesh& mesh, vtkIdType row)
{
  const vtkIdType size = mesh.GetNumberOfPoints();
  std::vector<double> impulses(static_cast<std::size_t>(size * size), 0.);
  for (vtkIdType i = 0; i < size; ++i)
  {
    impulses[static_cast<std::size_t>(i * size + i)] = 1.;
  }
  const std::vector<double> all = ApplyStep(MakeLevel<int>(mesh), impulses, static_cast<int>(size));
  return { all.begin() + row * size, all.begin() + (row + 1) * size };
}

HybridMesh MakeBox(int n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  HybridMesh mesh;
  const int m = n + 1;
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(m * m * m));
  std::iota(numbers.begin(), numbers.end(), vtkIdType(0));
  if (seed > 0)
  {
    std::shuffle(numbers.begin(), numbers.end(), random);
  }
  mesh.Points.resize(3 * numbers.size());
  for (int i = 0; i < m * m * m; ++i)
  {
    const int at[3] = { i % m, i / m % m, i / m / m };
    for (int c = 0; c < 3; ++c)
    {
      mesh.Points[static_cast<std::size_t>(3 * numbers[i] + c)] =
        at[c] + (seed > 0 ? shift(random) : 0.);
    }
  }
  for (int i = 0; i < n * n * n; ++i)
  {
    const int first = i % n + m * (i / n % n) + m * m * (i / n / n);
    Cell cell{ CellShape::Hex, {} };
    for (const int k : { 0, 1, m + 1, m, m * m, m * m + 1, m * m + m + 1, m * m + m })
    {
      cell.Corners.push_back(numbers[static_cast<std::size_t>(first + k)]);
    }
    mesh.Cells.push_back(cell);
  }
  return mesh;
}

HybridMesh MakeColumn(CellShape shape, int n)
{
  HybridMesh mesh;
  const bool ofHexes = shape == CellShape::Hex;
  const vtkIdType ring = ofHexes ? 2 * n : n; // edges' ends, then outer corners
  for (int z = 0; z < 3; ++z)
  {
    mesh.AddPoint(0., 0., z);
  }
  const double step = 2. * Pi / n;
  for (int z = 0; z < 3; ++z)
  {
    for (vtkIdType i = 0; i < ring; ++i)
    {
      const double angle = (i < n ? i : i - n + 0.5) * step;
      mesh.AddPoint(std::cos(angle), std::sin(angle), z);
    }
  }
  const auto at = [&](int z, vtkIdType i) { return 3 + z * ring + i; };
  for (int z = 0; z < 2; ++z)
  {
    for (int i = 0; i < n; ++i)
    {
      const int j = (i + 1) % n;
      mesh.Cells.push_back(ofHexes
          ? Cell{ shape,
              { z, at(z, i), at(z, n + i), at(z, j), z + 1, at(z + 1, i), at(z + 1, n + i),
                at(z + 1, j) } }
          : Cell{ shape, { z, at(z, i), at(z, j), z + 1, at(z + 1, i), at(z + 1, j) } });
    }
  }
  return mesh;
}

}
