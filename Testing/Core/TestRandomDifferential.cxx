// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRandomDifferential.cxx
 * Random meshes with random options, each run in two ways that have to give the same: filters in a
 * row and one filter, single and double precision, other numbers of points, the mirrored mesh, and
 * limits at several levels.
 *
 * Every run draws anew, for SUBDIVISIONOBJECTS_RANDOM_SECONDS (60 by default, all tests together).
 * A failure names its seed; SUBDIVISIONOBJECTS_RANDOM_SEED=SEED draws that one alone.
 */
#include "FeatureTools.h"
#include "SurfaceTools.h"

#include "vtkIdTypeArray.h"
#include "vtkRedGreenRefinement.h"
#include "vtkStaticPointLocator.h"

#include <chrono>
#include <cstdlib>

using namespace feature_tools;

namespace
{

using Data = vtkSmartPointer<vtkPointSet>;
using Chance = std::mt19937;

int Draw(Chance& chance, int n)
{
  return static_cast<int>(chance() % static_cast<unsigned>(n));
}

double DrawNumber(Chance& chance)
{
  return chance() / 4294967296.;
}

/// Calls test(seed) again and again for a part of the time, or once for the seed that is asked for.
template <typename Test>
void ForSeeds(double part, const Test& test)
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

Data Copy(vtkPointSet* mesh)
{
  auto copy = Data::Take(mesh->NewInstance());
  copy->DeepCopy(mesh);
  return copy;
}

/// Each point by `map`, in `type`.
template <typename Map>
Data WithPoints(vtkPointSet* mesh, int type, const Map& map)
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

Data InType(vtkPointSet* mesh, int type)
{
  return WithPoints(mesh, type, [](const Point& p) { return p; });
}

Data Mirror(vtkPointSet* mesh)
{
  return WithPoints(mesh, VTK_DOUBLE, [](const Point& p) { return Point{ -p[0], p[1], p[2] }; });
}

void MapIds(vtkCellArray* cells, const Ids& map)
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
Data Renumber(vtkPointSet* mesh, const Ids& map)
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

double GetSize(vtkPointSet* mesh)
{
  return std::max(1e-12, mesh->GetLength());
}

void ExpectNear(const Point& a, const Point& b, double tolerance, const std::string& what)
{
  for (int c = 0; c < 3; ++c)
  {
    ASSERT_NEAR(a[c], b[c], tolerance) << what;
  }
}

Point At(vtkPointSet* mesh, vtkIdType point)
{
  Point p;
  mesh->GetPoint(point, p.data());
  return p;
}

/// Point by point.
template <typename Map>
void ExpectSamePoints(
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

Point Same(const Point& p)
{
  return p;
}

/// Whether every point of one mesh is at a point of the other.
void ExpectSamePlaces(vtkPointSet* a, vtkPointSet* b, double tolerance)
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
void ExpectSameCorners(vtkPointSet* a, vtkPointSet* b, double tolerance, bool withSolids)
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

Ids Shuffle(vtkIdType size, Chance& chance)
{
  Ids map(size);
  std::iota(map.begin(), map.end(), 0);
  std::shuffle(map.begin(), map.end(), chance);
  return map;
}

using Run = std::function<Data(vtkPointSet* mesh, int levels)>;

double GetLargestDifference(vtkPointSet* a, vtkPointSet* b)
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
bool IsUndecided(vtkPointSet* mesh, int levels, const Run& run, Chance& chance)
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

void ExpectSameInSinglePrecision(
  vtkPointSet* mesh, int levels, const Run& run, vtkPointSet* output, Chance& chance)
{
  const Data single = run(InType(mesh, VTK_FLOAT), levels);
  const bool isSame = single->GetNumberOfPoints() == output->GetNumberOfPoints() &&
    GetLargestDifference(single, output) <= 1e-5 * GetSize(mesh);
  EXPECT_TRUE(isSame || IsUndecided(mesh, levels, run, chance));
}

/// What every filter has to keep. Coordinates are those of single precision numbers. `keepsOrder`:
/// of cells, whatever numbers points have.
void ExpectTheSame(vtkPointSet* mesh, int levels, const Run& run, Chance& chance,
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

// ------------------------------------------------------------------------------------------------
// Cells of all dimensions

/// With coordinates that single precision can hold.
Grid MakeObject(Chance& chance)
{
  const Grid grid = MakeRandomComplex(chance(), Draw(chance, 4) > 0);
  std::vector<int> sharpness;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    sharpness.push_back(Draw(chance, 4) == 0 ? 1 + Draw(chance, 5) : 0);
  }
  AddCellArray(grid, "Sharpness", sharpness);
  return vtkUnstructuredGrid::SafeDownCast(InType(InType(grid, VTK_FLOAT), VTK_DOUBLE));
}

Configure DrawOptions(Chance& chance, bool& isTetOct)
{
  const Configure basic = RandomOptions(chance());
  isTetOct = Draw(chance, 2) == 0;
  const bool hasSharpness = Draw(chance, 2) == 0;
  return [basic, hasSharpness, hasOctahedra = isTetOct](Filter* filter)
  {
    basic(filter);
    filter->SetVolumeScheme(hasOctahedra ? Filter::TET_OCT : Filter::BOX_SPLINE);
    SetCellArray(filter, 4, hasSharpness ? "Sharpness" : "None");
  };
}

Data RunObject(vtkPointSet* mesh, int levels, const Configure& configure)
{
  vtkNew<Messages> messages; // of inverted cells, which random solids have
  vtkNew<Filter> filter;
  messages->Watch(filter);
  filter->SetInputDataObject(mesh);
  filter->SetNumberOfLevels(levels);
  configure(filter);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  return filter->GetOutput();
}

TEST(RandomDifferential, Objects)
{
  ForSeeds(0.3,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeObject(chance);
      bool isTetOct = false;
      const Configure options = DrawOptions(chance, isTetOct);
      const int levels = 1 + Draw(chance, 2);
      ExpectTheSame(
        grid, levels, [&](vtkPointSet* mesh, int n) { return RunObject(mesh, n, options); }, chance,
        isTetOct);
      Data chained = grid;
      for (int level = 0; level < levels; ++level)
      {
        chained = RunObject(chained, 1, options);
      }
      EXPECT_EQ(Compare(vtkUnstructuredGrid::SafeDownCast(chained),
                  vtkUnstructuredGrid::SafeDownCast(RunObject(grid, levels, options))),
        "");
    });
}

TEST(RandomDifferential, LimitsOfObjects)
{
  ForSeeds(0.2,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeObject(chance);
      bool isTetOct = false;
      const Configure options = DrawOptions(chance, isTetOct);
      const Configure limit = [&options](Filter* filter)
      {
        options(filter);
        filter->SetProjectToLimit(true);
        filter->SetGenerateLimitNormals(true);
      };
      const Data control = RunObject(grid, 0, limit);
      for (int levels = 1; levels <= 2; ++levels)
      {
        SCOPED_TRACE(levels);
        const Data later = RunObject(grid, levels, limit);
        ExpectSamePoints(control, later, grid->GetNumberOfPoints(), 1e-9, Same);
        vtkDataArray* normals = later->GetPointData()->GetArray("LimitNormals");
        EXPECT_EQ(normals, later->GetPointData()->GetNormals());
      }
      const int level = Draw(chance, 2);
      ExpectTheSame(
        grid, level, [&](vtkPointSet* mesh, int n) { return RunObject(mesh, n, limit); }, chance,
        isTetOct);
    });
}

// ------------------------------------------------------------------------------------------------
// Surfaces

Data MakeSurface(Chance& chance)
{
  surfacetools::Model model;
  switch (Draw(chance, 3))
  {
    case 0:
    {
      const auto zoo = surfacetools::MakeZoo(Draw(chance, 2) == 0);
      model = std::next(zoo.begin(), Draw(chance, static_cast<int>(zoo.size())))->second;
      break;
    }
    case 1:
    {
      model = surfacetools::MakeGrid(2 + Draw(chance, 4), 2 + Draw(chance, 3), Draw(chance, 2) == 0,
        { 1., 0., 0. }, { 0., 1., 0. });
      surfacetools::Polygons faces;
      for (auto& face : model.Faces)
      {
        if (Draw(chance, 6) == 0)
        {
          std::reverse(face.begin(), face.end());
        }
        if (Draw(chance, 8) > 0)
        {
          faces.push_back(face);
        }
      }
      model.Faces = faces;
      break;
    }
    default:
      model.Points.resize(10);
      for (int i = 3 + Draw(chance, 10); i > 0; --i)
      {
        Ids ids = Shuffle(10, chance);
        ids.resize(3 + Draw(chance, 3));
        model.Faces.push_back(ids);
      }
  }
  const int size = static_cast<int>(model.Points.size());
  for (Point& p : model.Points)
  {
    p = { p[0] + DrawNumber(chance), p[1] + DrawNumber(chance), p[2] + DrawNumber(chance) };
  }
  for (int i = Draw(chance, 4); i > 0; --i)
  {
    const int a = Draw(chance, size);
    model.Lines.push_back({ a, (a + 1 + Draw(chance, size - 1)) % size });
  }
  const auto surface = surfacetools::MakeInput(model);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  const bool isFlagged = Draw(chance, 2) == 0;
  const bool isSharp = Draw(chance, 2) == 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(isFlagged && Draw(chance, 4) == 0);
    sharpness->InsertNextValue(isSharp && Draw(chance, 2) == 0 ? 0.5 * (1 + Draw(chance, 6)) : 0.);
    numbers->InsertNextValue(static_cast<int>(cell));
  }
  surface->GetCellData()->AddArray(flags);
  surface->GetCellData()->AddArray(sharpness);
  surface->GetCellData()->AddArray(numbers);
  return InType(InType(surface, VTK_FLOAT), VTK_DOUBLE);
}

struct SurfaceOptions
{
  int Scheme;
  int CreaseEnd;
  int Rules[3];
  bool DetectFeatures;
  bool ModifiedBoundary;
  bool Limit = false;

  explicit SurfaceOptions(Chance& chance)
    : Scheme(Draw(chance, 7))
    , CreaseEnd(Draw(chance, 2))
    , Rules{ Draw(chance, 2), Draw(chance, 2), Draw(chance, 2) }
    , DetectFeatures(Draw(chance, 4) == 0)
    , ModifiedBoundary(Draw(chance, 2) == 0)
  {
  }

  std::string Describe() const
  {
    std::ostringstream text;
    text << "scheme " << this->Scheme << " crease end " << this->CreaseEnd << " rules "
         << this->Rules[0] << this->Rules[1] << this->Rules[2] << " features "
         << this->DetectFeatures << " modified " << this->ModifiedBoundary;
    return text.str();
  }

  /// Known: at some joints those of ModifiedButterfly and SqrtThree depend on the level.
  bool HasExactNormals() const
  {
    return this->Scheme == vtkSurfaceSubdivision::LOOP ||
      this->Scheme == vtkSurfaceSubdivision::CATMULL_CLARK;
  }

  Data Run(vtkPointSet* mesh, int levels) const
  {
    vtkNew<Messages> messages;
    vtkNew<vtkSurfaceSubdivision> filter;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->SetScheme(this->Scheme);
    filter->SetNumberOfLevels(levels);
    filter->SetCreaseEnd(this->CreaseEnd);
    filter->SetType1Rule(this->Rules[0]);
    filter->SetType2Rule(this->Rules[1]);
    filter->SetType3Rule(this->Rules[2]);
    filter->SetDetectFeatures(this->DetectFeatures);
    filter->SetModifiedBoundary(this->ModifiedBoundary);
    filter->SetProjectToLimit(this->Limit);
    filter->SetGenerateLimitNormals(this->Limit);
    filter->SetGenerateTangents(this->Limit);
    filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    return filter->GetOutput();
  }
};

void ExpectSameSurface(vtkPointSet* a, vtkPointSet* b)
{
  surfacetools::ExpectSameBits(vtkPolyData::SafeDownCast(a), vtkPolyData::SafeDownCast(b));
  EXPECT_EQ(CompareArrays(a->GetCellData(), b->GetCellData(), "cells"), "");
}

TEST(RandomDifferential, Surfaces)
{
  ForSeeds(0.25,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Data surface = MakeSurface(chance);
      const SurfaceOptions options(chance);
      SCOPED_TRACE(options.Describe());
      const int levels = 1 + Draw(chance, 3);
      ExpectTheSame(
        surface, levels, [&](vtkPointSet* mesh, int n) { return options.Run(mesh, n); }, chance,
        false,
        options.Scheme != vtkSurfaceSubdivision::DOO_SABIN &&
          options.Scheme != vtkSurfaceSubdivision::MIDEDGE);
      Data chained = surface;
      for (int level = 0; level < levels; ++level)
      {
        chained = options.Run(chained, 1);
      }
      ExpectSameSurface(chained, options.Run(surface, levels));
    });
}

Point GetVector(vtkPointSet* mesh, const char* name, vtkIdType point)
{
  Point value;
  mesh->GetPointData()->GetArray(name)->GetTuple(point, value.data());
  return value;
}

double Length(const Point& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

/// Where there is a tangent plane.
void ExpectSameNormals(vtkPointSet* control, vtkPointSet* later, vtkIdType points)
{
  for (vtkIdType i = 0; i < points; ++i)
  {
    const Point a = GetVector(control, "LimitTangent1", i);
    const Point b = GetVector(control, "LimitTangent2", i);
    Point across;
    for (int c = 0; c < 3; ++c)
    {
      across[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
    }
    if (Length(a) == 0. || Length(b) == 0.)
    {
      EXPECT_NEAR(Length(GetVector(control, "LimitNormals", i)), 1., 1e-6) << "for shading: " << i;
    }
    if (Length(across) > 1e-3 * Length(a) * Length(b) && Length(a) > 1e-6 && Length(b) > 1e-6)
    {
      ExpectNear(GetVector(control, "LimitNormals", i), GetVector(later, "LimitNormals", i), 1e-6,
        "normal " + std::to_string(i));
    }
  }
}

void CheckLimitsOfSurface(unsigned seed, bool withNormals)
{
  Chance chance(seed);
  const Data surface = MakeSurface(chance);
  SurfaceOptions options(chance);
  const int schemes[] = { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
    vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, vtkSurfaceSubdivision::SQRT_THREE };
  options.Scheme = schemes[Draw(chance, 4)];
  options.Limit = true;
  SCOPED_TRACE(options.Describe());
  const Data control = options.Run(surface, 0);
  for (int levels = 1; levels <= 2; ++levels)
  {
    SCOPED_TRACE(levels);
    const Data later = options.Run(surface, levels);
    const vtkIdType points = surface->GetNumberOfPoints();
    ExpectSamePoints(control, later, points, 1e-9, Same);
    if (withNormals && options.HasExactNormals())
    {
      ExpectSameNormals(control, later, points);
    }
  }
  const int level = Draw(chance, 2);
  ExpectTheSame(
    surface, level, [&](vtkPointSet* mesh, int n) { return options.Run(mesh, n); }, chance);
}

TEST(RandomDifferential, LimitsOfSurfaces)
{
  ForSeeds(0.15, [](unsigned seed) { CheckLimitsOfSurface(seed, false); });
}

/// Always the same ones. Known: of 40,000 surfaces one had a normal at a curve that was another on
/// the control level (3817636649).
TEST(RandomDifferential, NormalsOfSurfaces)
{
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    SCOPED_TRACE(seed);
    CheckLimitsOfSurface(seed, true);
  }
}

// ------------------------------------------------------------------------------------------------
// Local refinement

TEST(RandomDifferential, RedGreen)
{
  ForSeeds(0.1,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeObject(chance);
      std::vector<int> wanted;
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        wanted.push_back(Draw(chance, 3));
      }
      AddCellArray(grid, "WantedLevel", wanted);
      const bool toLimit = Draw(chance, 2) == 0;
      auto run = [toLimit](vtkPointSet* mesh, int levels) -> Data
      {
        vtkNew<Messages> messages;
        vtkNew<vtkRedGreenRefinement> filter;
        messages->Watch(filter);
        filter->SetInputDataObject(mesh);
        filter->RefineByAttributeErrorOff();
        filter->RefineByWantedLevelOn();
        filter->SetMaximumLevel(levels);
        filter->SetPlacement(
          toLimit ? vtkRedGreenRefinement::LIMIT : vtkRedGreenRefinement::LINEAR);
        filter->Update();
        EXPECT_TRUE(messages->Errors.empty());
        return filter->GetOutput();
      };
      ExpectTheSame(grid, 2, run, chance);
    });
}

}
