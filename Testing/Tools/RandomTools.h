// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RandomTools.h
 * Random draws for some time, the same mesh in other ways, and comparisons of what a filter makes
 * of them.
 */
#ifndef SubdivisionObjects_RandomTools_h
#define SubdivisionObjects_RandomTools_h

#include "FeatureTools.h"

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

void MapIds(vtkCellArray* cells, const Ids& map);

/// Point i becomes map[i]; its global id stays i.
Data Renumber(vtkPointSet* mesh, const Ids& map);

// ------------------------------------------------------------------------------------------------
// Comparisons

inline double GetSize(vtkPointSet* mesh)
{
  return std::max(1e-12, mesh->GetLength());
}

void ExpectNear(const Point& a, const Point& b, double tolerance, const std::string& what);

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
void ExpectSamePlaces(vtkPointSet* a, vtkPointSet* b, double tolerance);

/// Corner by corner: points may have other ids. Not those of tetrahedra that octahedra are cut
/// into: ids tell which of them is the first.
void ExpectSameCorners(vtkPointSet* a, vtkPointSet* b, double tolerance, bool withSolids);

Ids Shuffle(vtkIdType size, Chance& chance);

using Run = std::function<Data(vtkPointSet* mesh, int levels)>;

double GetLargestDifference(vtkPointSet* a, vtkPointSet* b);

/// Whether points that are moved as far as single precision allows for make another object: where
/// two diagonals are as long but for that, or an angle is just the one that decides.
bool IsUndecided(vtkPointSet* mesh, int levels, const Run& run, Chance& chance);

void ExpectSameInSinglePrecision(
  vtkPointSet* mesh, int levels, const Run& run, vtkPointSet* output, Chance& chance);

/// What every filter has to keep. Coordinates are those of single precision numbers. `keepsOrder`:
/// of cells, whatever numbers points have.
void ExpectTheSame(vtkPointSet* mesh, int levels, const Run& run, Chance& chance,
  bool hasOctahedra = false, bool keepsOrder = true);

}

#endif
