// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RandomTools.h
 * Random draws for some time, the same mesh in other ways, and comparisons of what a filter makes
 * of them.
 */
#ifndef SubdivisionObjects_RandomTools_h
#define SubdivisionObjects_RandomTools_h

#include "FeatureTools.h"

#include "vtkIdTypeArray.h"
#include "vtkStaticPointLocator.h"

#include <chrono>
#include <cstdlib>

namespace random_tools
{

using namespace feature_tools;

using Data = vtkSmartPointer<vtkPointSet>;
using Chance = std::mt19937;

inline int Draw(Chance& chance, int n)
{
  return static_cast<int>(chance() % static_cast<unsigned>(n));
}

inline double DrawNumber(Chance& chance)
{
  return chance() / 4294967296.;
}

/// Calls test(seed) again and again for a part of the time, or once for the seed that is asked for.
template <typename Test>
inline void ForSeeds(double part, const Test& test)
{
  if (const char* seed = std::getenv("SUBDIVISIONOBJECTS_RANDOM_SEED"))
  {
    test(static_cast<unsigned>(std::strtoul(seed, nullptr, 10)));
    return;
  }
  const char* given = std::getenv("SUBDIVISIONOBJECTS_RANDOM_SECONDS");
  const double seconds = part * (given ? std::atof(given) : 60.);
  const auto start = std::chrono::steady_clock::now();
  const unsigned first = std::random_device()();
  unsigned seed = first;
  auto isOver = [&]
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return passed.count() > seconds;
  };
  do
  {
    SCOPED_TRACE("SUBDIVISIONOBJECTS_RANDOM_SEED=" + std::to_string(seed));
    test(seed++);
  } while (!isOver() && !testing::Test::HasFailure());
  std::cout << "seeds " << first << " to " << seed - 1 << " (" << seed - first << ")\n";
}

// ------------------------------------------------------------------------------------------------
// The same mesh in another way

inline Data Copy(vtkPointSet* mesh)
{
  auto copy = Data::Take(mesh->NewInstance());
  copy->DeepCopy(mesh);
  return copy;
}

/// Each point by `map`, in `type`.
template <typename Map>
inline Data WithPoints(vtkPointSet* mesh, int type, const Map& map)
{
  const Data copy = Copy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point p;
    mesh->GetPoint(i, p.data());
    const Point q = map(p);
    points->InsertNextPoint(q.data());
  }
  copy->SetPoints(points);
  return copy;
}

inline Data InType(vtkPointSet* mesh, int type)
{
  return WithPoints(mesh, type, [](const Point& p) { return p; });
}

inline Data Mirror(vtkPointSet* mesh)
{
  return WithPoints(mesh, VTK_DOUBLE, [](const Point& p) { return Point{ -p[0], p[1], p[2] }; });
}

inline void MapIds(vtkCellArray* cells, const Ids& map)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; cells && c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, map[ids->GetId(i)]);
    }
    cells->ReplaceCellAtId(c, ids);
  }
}

/// Point i becomes map[i]; its global id stays i.
inline Data Renumber(vtkPointSet* mesh, const Ids& map)
{
  const Data copy = Copy(mesh);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalIds");
  ids->SetNumberOfTuples(mesh->GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(map[i], mesh->GetPoint(i));
    ids->SetValue(map[i], i);
  }
  copy->SetPoints(points);
  copy->GetPointData()->SetGlobalIds(ids);
  if (auto* surface = vtkPolyData::SafeDownCast(copy))
  {
    for (vtkCellArray* cells : { surface->GetVerts(), surface->GetLines(), surface->GetPolys() })
    {
      MapIds(cells, map);
    }
  }
  else
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(copy);
    MapIds(grid->GetCells(), map);
  }
  return copy;
}

// ------------------------------------------------------------------------------------------------
// Comparisons

inline double GetSize(vtkPointSet* mesh)
{
  return std::max(1e-12, mesh->GetLength());
}

inline void ExpectNear(const Point& a, const Point& b, double tolerance, const std::string& what)
{
  for (int c = 0; c < 3; ++c)
  {
    ASSERT_NEAR(a[c], b[c], tolerance) << what;
  }
}

inline Point At(vtkPointSet* mesh, vtkIdType point)
{
  Point p;
  mesh->GetPoint(point, p.data());
  return p;
}

/// Point by point.
template <typename Map>
inline void ExpectSamePoints(
  vtkPointSet* a, vtkPointSet* b, vtkIdType count, double tolerance, const Map& map)
{
  ASSERT_TRUE(count <= a->GetNumberOfPoints() && count <= b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < count; ++i)
  {
    ExpectNear(map(At(a, i)), At(b, i), tolerance, "point " + std::to_string(i));
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}

inline Point Same(const Point& p)
{
  return p;
}

/// Whether every point of one mesh is at a point of the other.
inline void ExpectSamePlaces(vtkPointSet* a, vtkPointSet* b, double tolerance)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(a);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < b->GetNumberOfPoints(); ++i)
  {
    const Point p = At(b, i);
    ExpectNear(
      At(a, locator->FindClosestPoint(p.data())), p, tolerance, "point " + std::to_string(i));
  }
}

/// Corner by corner: points may have other ids. Not those of tetrahedra that octahedra are cut
/// into: ids tell which of them is the first.
inline void ExpectSameCorners(vtkPointSet* a, vtkPointSet* b, double tolerance, bool withSolids)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  vtkNew<vtkIdList> first;
  vtkNew<vtkIdList> second;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    a->GetCellPoints(cell, first);
    b->GetCellPoints(cell, second);
    ASSERT_EQ(first->GetNumberOfIds(), second->GetNumberOfIds());
    if (!withSolids && a->GetCellType(cell) == VTK_TETRA)
    {
      continue;
    }
    for (vtkIdType i = 0; i < first->GetNumberOfIds(); ++i)
    {
      ExpectNear(At(a, first->GetId(i)), At(b, second->GetId(i)), tolerance,
        "cell " + std::to_string(cell) + " corner " + std::to_string(i));
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

inline Ids Shuffle(vtkIdType size, Chance& chance)
{
  Ids map(size);
  std::iota(map.begin(), map.end(), 0);
  std::shuffle(map.begin(), map.end(), chance);
  return map;
}

using Run = std::function<Data(vtkPointSet* mesh, int levels)>;

inline double GetLargestDifference(vtkPointSet* a, vtkPointSet* b)
{
  double largest = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    const Point p = At(a, i);
    const Point q = At(b, i);
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(p[c] - q[c]));
    }
  }
  return largest;
}

/// Whether points that are moved as far as single precision allows for make another object: where
/// two diagonals are as long but for that, or an angle is just the one that decides.
inline bool IsUndecided(vtkPointSet* mesh, int levels, const Run& run, Chance& chance)
{
  const Data output = run(mesh, levels);
  const double size = GetSize(mesh);
  auto move = [&](const Point& p)
  {
    Point q;
    for (int c = 0; c < 3; ++c)
    {
      q[c] = p[c] + 6e-5 * size * (DrawNumber(chance) - 0.5);
    }
    return q;
  };
  for (int trial = 0; trial < 32; ++trial)
  {
    const Data other = run(WithPoints(mesh, VTK_DOUBLE, move), levels);
    if (other->GetNumberOfPoints() != output->GetNumberOfPoints() ||
      GetLargestDifference(other, output) > 3e-3 * size)
    {
      return true;
    }
  }
  return false;
}

inline void ExpectSameInSinglePrecision(
  vtkPointSet* mesh, int levels, const Run& run, vtkPointSet* output, Chance& chance)
{
  const Data single = run(InType(mesh, VTK_FLOAT), levels);
  const bool isSame = single->GetNumberOfPoints() == output->GetNumberOfPoints() &&
    GetLargestDifference(single, output) <= 1e-5 * GetSize(mesh);
  EXPECT_TRUE(isSame || IsUndecided(mesh, levels, run, chance));
}

/// What every filter has to keep. Coordinates are those of single precision numbers. `keepsOrder`:
/// of cells, whatever numbers points have.
inline void ExpectTheSame(vtkPointSet* mesh, int levels, const Run& run, Chance& chance,
  bool hasOctahedra = false, bool keepsOrder = true)
{
  const Data output = run(mesh, levels);
  const double exact = 1e-11 * GetSize(mesh);
  {
    SCOPED_TRACE("mirrored");
    ExpectSamePoints(output, run(Mirror(mesh), levels), output->GetNumberOfPoints(), exact,
      [](const Point& p) { return Point{ -p[0], p[1], p[2] }; });
  }
  {
    SCOPED_TRACE("other numbers");
    const Data other = run(Renumber(mesh, Shuffle(mesh->GetNumberOfPoints(), chance)), levels);
    if (keepsOrder)
    {
      ExpectSameCorners(output, other, exact, !hasOctahedra);
    }
    ExpectSamePlaces(output, other, exact);
  }
  SCOPED_TRACE("single precision");
  ExpectSameInSinglePrecision(mesh, levels, run, output, chance);
}

}

#endif
