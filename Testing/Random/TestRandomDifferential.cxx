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
#include "PointTools.h"
#include "RandomTools.h"
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"

using namespace random_tools;
using namespace point_tools;

namespace
{

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

struct ObjectOptions
{
  Configure Basic;
  bool IsTetOct;
  bool HasSharpness;
  bool Limit = false;

  explicit ObjectOptions(Chance& chance)
    : Basic(RandomOptions(chance()))
    , IsTetOct(Draw(chance, 2) == 0)
    , HasSharpness(Draw(chance, 2) == 0)
  {
  }

  Data Run(vtkPointSet* mesh, int levels) const
  {
    vtkNew<Messages> messages; // of inverted cells, which random solids have
    vtkNew<Filter> filter;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->SetNumberOfLevels(levels);
    this->Basic(filter);
    filter->SetVolumeScheme(this->IsTetOct ? Filter::TET_OCT : Filter::BOX_SPLINE);
    SetCellArray(filter, 4, this->HasSharpness ? "Sharpness" : "None");
    filter->SetProjectToLimit(this->Limit);
    filter->SetGenerateLimitNormals(this->Limit);
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    return filter->GetOutput();
  }
};

void ExpectTheSameOf(vtkPointSet* grid, int levels, const ObjectOptions& options, Chance& chance)
{
  ExpectTheSame(
    grid, levels, [&](vtkPointSet* mesh, int n) { return options.Run(mesh, n); }, chance,
    options.IsTetOct);
}

TEST(RandomDifferential, Objects)
{
  ForSeeds(0.25,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeObject(chance);
      const ObjectOptions options(chance);
      const int levels = 1 + Draw(chance, 2);
      ExpectTheSameOf(grid, levels, options, chance);
      Data chained = grid;
      for (int level = 0; level < levels; ++level)
      {
        chained = options.Run(chained, 1);
      }
      EXPECT_EQ(Compare(vtkUnstructuredGrid::SafeDownCast(chained),
                  vtkUnstructuredGrid::SafeDownCast(options.Run(grid, levels))),
        "");
    });
}

TEST(RandomDifferential, LimitsOfObjects)
{
  ForSeeds(0.15,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Grid grid = MakeObject(chance);
      ObjectOptions options(chance);
      options.Limit = true;
      const Data control = options.Run(grid, 0);
      for (int levels = 1; levels <= 2; ++levels)
      {
        SCOPED_TRACE(levels);
        const Data later = options.Run(grid, levels);
        ExpectSamePoints(control, later, grid->GetNumberOfPoints(), 1e-9, Same);
        vtkDataArray* normals = later->GetPointData()->GetArray("LimitNormals");
        EXPECT_NE(normals, nullptr);
        EXPECT_EQ(normals, later->GetPointData()->GetNormals());
      }
      ExpectTheSameOf(grid, Draw(chance, 2), options, chance);
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
      model = surfacetools::MakeSheet(2 + Draw(chance, 4), 2 + Draw(chance, 3),
        Draw(chance, 2) == 0, { 1., 0., 0. }, { 0., 1., 0. });
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
  int LoopWeights;
  bool Limit = false;

  explicit SurfaceOptions(Chance& chance)
    : Scheme(Draw(chance, vtkSurfaceSubdivision::LINEAR + 1))
    , CreaseEnd(Draw(chance, 2))
    , Rules{ Draw(chance, 2), Draw(chance, 2), Draw(chance, 2) }
    , DetectFeatures(Draw(chance, 4) == 0)
    , ModifiedBoundary(Draw(chance, 2) == 0)
    , LoopWeights(Draw(chance, 2))
  {
  }

  std::string Describe() const
  {
    std::ostringstream text;
    text << "scheme " << this->Scheme << " crease end " << this->CreaseEnd << " rules "
         << this->Rules[0] << this->Rules[1] << this->Rules[2] << " features "
         << this->DetectFeatures << " modified " << this->ModifiedBoundary << " weights "
         << this->LoopWeights;
    return text.str();
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
    filter->SetLoopWeights(this->LoopWeights);
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
  ForSeeds(0.2,
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

/// Whether some part of a surface cannot be oriented, like a Moebius band: all of a part can be
/// reached over edges of two faces.
bool IsOneSided(vtkPointSet* surface)
{
  using Edge = std::pair<vtkIdType, vtkIdType>;
  std::map<Edge, std::vector<std::pair<vtkIdType, bool>>> facesAt; // and whether they run forward
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdList* ids = surface->GetCell(cell)->GetPointIds();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds() && ids->GetNumberOfIds() > 2; ++i)
    {
      const vtkIdType a = ids->GetId(i);
      const vtkIdType b = ids->GetId((i + 1) % ids->GetNumberOfIds());
      facesAt[std::minmax(a, b)].emplace_back(cell, a < b);
    }
  }
  std::vector<int> sides(surface->GetNumberOfCells(), 0);
  for (vtkIdType first = 0; first < surface->GetNumberOfCells(); ++first)
  {
    bool isNew = sides[first] == 0;
    sides[first] = isNew ? 1 : sides[first];
    while (isNew) // until nothing more can be reached
    {
      isNew = false;
      for (const auto& entry : facesAt)
      {
        const auto& faces = entry.second;
        for (std::size_t i = 0; i < 2 && faces.size() == 2; ++i)
        {
          const int side = sides[faces[i].first] * (faces[0].second == faces[1].second ? -1 : 1);
          int& other = sides[faces[1 - i].first];
          if (side * other < 0)
          {
            return true;
          }
          isNew = isNew || side != other;
          other = side != 0 ? side : other;
        }
      }
    }
  }
  return false;
}

/// Where there is a tangent plane.
void ExpectSameNormals(vtkPointSet* control, vtkPointSet* later, vtkIdType points, bool hasSides)
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
      const Point normal = GetVector(control, "LimitNormals", i);
      Point other = GetVector(later, "LimitNormals", i);
      if (!hasSides && normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2] < 0.)
      {
        other = { -other[0], -other[1], -other[2] };
      }
      ExpectNear(normal, other, 1e-6, "normal " + std::to_string(i));
    }
  }
}

void CheckLimitsOfSurface(unsigned seed, bool isFourEight)
{
  Chance chance(seed);
  const Data surface = MakeSurface(chance);
  SurfaceOptions options(chance);
  const int schemes[] = { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
    vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, vtkSurfaceSubdivision::SQRT_THREE };
  options.Scheme = schemes[Draw(chance, 4)];
  options.Scheme = isFourEight ? vtkSurfaceSubdivision::FOUR_EIGHT : options.Scheme;
  options.Limit = true;
  SCOPED_TRACE(options.Describe());
  const Data control = options.Run(surface, 0);
  // The faces of sqrt(3) and 4-8 come in another order on each level, and with them the sides of a
  // Moebius band.
  const bool keepsOrder = !isFourEight && options.Scheme != vtkSurfaceSubdivision::SQRT_THREE;
  const bool hasSides = keepsOrder || !IsOneSided(surface);
  for (int levels = 1; levels <= 2; ++levels)
  {
    SCOPED_TRACE(levels);
    const Data later = options.Run(surface, levels);
    const vtkIdType points = surface->GetNumberOfPoints();
    ExpectSamePoints(control, later, points, 1e-9, Same);
    ExpectSameNormals(control, later, points, hasSides);
  }
  const int level = Draw(chance, 2);
  ExpectTheSame(
    surface, level, [&](vtkPointSet* mesh, int n) { return options.Run(mesh, n); }, chance);
}

/// No point of a level is one of the next, but limits do not depend on how a mesh is written down.
TEST(RandomDifferential, LimitsOfDualSurfaces)
{
  ForSeeds(0.05,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Data surface = MakeSurface(chance);
      SurfaceOptions options(chance);
      options.Scheme =
        Draw(chance, 2) == 0 ? vtkSurfaceSubdivision::DOO_SABIN : vtkSurfaceSubdivision::MIDEDGE;
      options.Limit = true;
      SCOPED_TRACE(options.Describe());
      ExpectTheSame(
        surface, Draw(chance, 3), [&](vtkPointSet* mesh, int n) { return options.Run(mesh, n); },
        chance, false, false);
    });
}

TEST(RandomDifferential, LimitsOfSurfaces)
{
  ForSeeds(0.15, [](unsigned seed) { CheckLimitsOfSurface(seed, false); });
}

TEST(RandomDifferential, LimitsOfFourEight)
{
  ForSeeds(0.05, [](unsigned seed) { CheckLimitsOfSurface(seed, true); });
}

/// Surfaces whose limits or normals once depended on the level: curves of creases that go through
/// joints, one face in a sector of Butterfly, a corner across a quad beside a semi-sharp crease.
TEST(RandomDifferential, LimitsOfSurfacesThatOnceDiffered)
{
  for (const unsigned seed : { 24u, 129u, 153u, 176u, 200u, 245u, 3817636649u })
  {
    SCOPED_TRACE(seed);
    CheckLimitsOfSurface(seed, false);
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

/// Triangles are wanted by level: errors at the edge of a tolerance are not decided by the mesh
/// alone.
TEST(RandomDifferential, AdaptiveSurfaces)
{
  ForSeeds(0.1,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Data surface = MakeSurface(chance);
      vtkNew<vtkIntArray> wanted;
      wanted->SetName("WantedLevel");
      for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
      {
        wanted->InsertNextValue(Draw(chance, 4));
      }
      surface->GetCellData()->AddArray(wanted);
      auto run = [](vtkPointSet* mesh, int levels) -> Data
      {
        vtkNew<Messages> messages;
        vtkNew<vtkAdaptiveSurfaceSubdivision> filter;
        messages->Watch(filter);
        filter->SetInputDataObject(mesh);
        filter->RefineByAttributeErrorOff();
        filter->RefineByGeometricErrorOff();
        filter->RefineByWantedLevelOn();
        filter->SetMaximumLevel(levels);
        filter->Update();
        EXPECT_TRUE(messages->Errors.empty());
        return filter->GetOutput();
      };
      ExpectTheSame(surface, 3, run, chance);
    });
}

// ------------------------------------------------------------------------------------------------
// Deformation

TEST(RandomDifferential, Deformations)
{
  ForSeeds(0.05,
    [](unsigned seed)
    {
      Chance chance(seed);
      const Data rest = MakeKuhnBox(2, 0.3, seed);
      const double bend = 0.4 * DrawNumber(chance);
      auto deform = [bend](vtkPointSet* mesh)
      {
        return WithPoints(mesh, mesh->GetPoints()->GetDataType(), [bend](const Point& p)
          { return Point{ p[0] + bend * p[1] * p[2], p[1] - bend * p[2], p[2] + bend * p[0] }; });
      };
      const Data deformed = deform(rest);
      const Data cloud = deformation_tools::MakeCloud(40, { 0., 0., 0. }, { 1., 1., 1. }, seed);
      const int levels = Draw(chance, 3);
      const int scheme = Draw(chance, 2);
      auto run = [levels, scheme](vtkPointSet* object, vtkPointSet* from, vtkPointSet* to)
      {
        deformation_tools::Deformer deformer;
        deformer->SetNumberOfLevels(levels);
        deformer->SetVolumeScheme(scheme);
        const Data output = deformer.Run(object, from, to);
        EXPECT_TRUE(deformer.GetErrors().empty());
        return output;
      };
      const Data output = run(cloud, rest, deformed);
      const vtkIdType size = output->GetNumberOfPoints();
      EXPECT_EQ(size, 40);
      {
        SCOPED_TRACE("mirrored");
        ExpectSamePoints(output, run(Mirror(cloud), Mirror(rest), Mirror(deformed)), size, 1e-9,
          [](const Point& p) { return Point{ -p[0], p[1], p[2] }; });
      }
      {
        SCOPED_TRACE("other numbers");
        const Ids map = Shuffle(rest->GetNumberOfPoints(), chance);
        ExpectSamePoints(
          output, run(cloud, Renumber(rest, map), Renumber(deformed, map)), size, 1e-9, Same);
      }
      SCOPED_TRACE("single precision");
      ExpectSameInSinglePrecision(
        rest, levels, [&](vtkPointSet* mesh, int) { return run(cloud, mesh, deform(mesh)); },
        output, chance);
    });
}

}
