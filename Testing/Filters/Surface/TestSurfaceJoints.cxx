// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceJoints.cxx
 * Loop subdivision is that of vtkMultiDimensionalSubdivision, also where parts of a surface meet.
 */
#include "SurfaceTools.h"

#include "vtkMultiDimensionalSubdivision.h"

using namespace surfacetools;

namespace
{

/// What both filters can be told.
struct Options
{
  int Joints[3] = { 0, 0, 0 }; ///< 0: blend, 1: sharp, of types 1 to 3
  int CreaseEnd = 0;           ///< 0: a corner, 1: a dart
  int LoopWeights = 0;         ///< 0: Warren's, 1: Loop's
  bool ModifiedBoundary = false;
};

template <typename Filter>
void Run(Filter* filter, vtkPolyData* input, const Options& options, int levels, bool limit = false)
{
  filter->SetInputData(input);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(limit);
  filter->SetType1Rule(options.Joints[0]);
  filter->SetType2Rule(options.Joints[1]);
  filter->SetType3Rule(options.Joints[2]);
  filter->SetCreaseEnd(options.CreaseEnd);
  filter->SetLoopWeights(options.LoopWeights);
  filter->SetModifiedBoundary(options.ModifiedBoundary);
  if (input->GetCellData()->HasArray("Sharpness"))
  {
    filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
  }
  filter->Update();
}

/// A few points, of which each cell takes any: joints of all kinds, borders, lines, unused points.
/// No two faces have the same points, which vtkSurfaceSubdivision counts as two.
Model MakeRandomCells(std::mt19937& random)
{
  Model model;
  const std::size_t size = 6 + random() % 9;
  model.Points = MakeRandomPoints(size, static_cast<unsigned>(random()));
  std::set<std::set<vtkIdType>> taken;
  auto add = [&](Polygons& cells, std::size_t corners)
  {
    std::vector<vtkIdType> cell;
    while (cell.size() < corners)
    {
      const auto point = static_cast<vtkIdType>(random() % size);
      if (std::find(cell.begin(), cell.end(), point) == cell.end())
      {
        cell.push_back(point);
      }
    }
    if (taken.insert({ cell.begin(), cell.end() }).second)
    {
      cells.push_back(cell);
    }
  };
  for (std::size_t count = 3 + random() % (2 * size); count > 0; --count)
  {
    add(model.Faces, 3);
  }
  for (std::size_t count = random() % 6; count > 0; --count)
  {
    add(model.Lines, 2);
  }
  return model;
}

/// The vertices that are inside one part, on a line, or where parts meet.
std::vector<bool> FindOffBorder(const Model& model)
{
  const PolygonMesh<int> mesh = MakeLevel(model.Points.size(), model.Faces, model.Lines).Mesh;
  std::vector<bool> isOff;
  for (const int corner : mesh.VertexCorners)
  {
    isOff.push_back(corner < 0 || VisitFan(mesh, corner, [](const FanStep<int>&) {}));
  }
  return isOff;
}

/// Flags some points, and some lines for ever or for a level. No crease touches the border of a
/// single part: there vtkSurfaceSubdivision counts both alike (Mathematics 12), the main filter
/// only the crease (Mathematics 4). Nor is a sharpness broken, of which each filter takes a part in
/// its own way.
vtkSmartPointer<vtkPolyData> MakeCreasedInput(const Model& model, std::mt19937& random)
{
  const auto input = MakeInput(model);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  auto add = [&](bool isFlagged, double value)
  {
    flags->InsertNextValue(isFlagged);
    sharpness->InsertNextValue(value);
  };
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType v = 0; v < 2; ++v)
  {
    vertices->InsertNextCell(1, &v);
    add(v == 0 && random() % 8 == 0, 0.);
  }
  input->SetVerts(vertices);
  const std::vector<bool> isOffBorder = FindOffBorder(model);
  const bool hasCreases = random() % 2;
  for (const auto& line : model.Lines)
  {
    const bool isFree = hasCreases && isOffBorder[line[0]] && isOffBorder[line[1]];
    const double values[] = { 0., 1., std::numeric_limits<double>::infinity() };
    add(isFree && random() % 2, isFree ? values[random() % 3] : 0.);
  }
  for (std::size_t i = 0; i < model.Faces.size(); ++i)
  {
    add(false, 0.);
  }
  input->GetCellData()->AddArray(flags);
  input->GetCellData()->AddArray(sharpness);
  return input;
}

/// Of the input's points, then of all cells: the filters number new points each in their own way.
std::vector<Point> CollectPoints(vtkPointSet* mesh, vtkIdType inputPoints)
{
  std::vector<Point> points(static_cast<std::size_t>(inputPoints));
  for (vtkIdType i = 0; i < inputPoints; ++i)
  {
    mesh->GetPoint(i, points[i].data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      points.emplace_back();
      mesh->GetPoint(ids->GetId(i), points.back().data());
    }
  }
  return points;
}

void ExpectSameSurfaces(vtkPolyData* input, const Options& options, int levels, bool limit = false)
{
  vtkNew<vtkSurfaceSubdivision> loop;
  Run(loop.Get(), input, options, levels, limit);
  vtkNew<vtkMultiDimensionalSubdivision> main;
  Run(main.Get(), input, options, levels, limit);
  ASSERT_GT(main->GetOutput()->GetNumberOfPoints(), levels > 0 ? input->GetNumberOfPoints() : 0);
  const std::vector<Point> a = CollectPoints(loop->GetOutput(), input->GetNumberOfPoints());
  const std::vector<Point> b = CollectPoints(main->GetOutput(), input->GetNumberOfPoints());
  ASSERT_EQ(a.size(), b.size());
  double difference = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    difference = std::max(difference, GetDistance(a[i], b[i]));
  }
  EXPECT_LT(difference, 1e-12) << "levels " << levels << (limit ? ", limits" : "");
}

/// Of two tangents, which may be missing or parallel: then 0.
Point FindNormal(const Point& a, const Point& b)
{
  Point normal = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const double scale = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
  for (double& value : normal)
  {
    value = length > 1e-9 * scale ? value / length : 0.;
  }
  return normal;
}

/// Of each point of the input, where it is on the limit surface, and the normal there.
std::vector<Point> FindLimits(vtkPolyData* input, const Options& options, int levels)
{
  vtkNew<vtkSurfaceSubdivision> loop;
  loop->GenerateTangentsOn();
  Run(loop.Get(), input, options, levels, true);
  vtkPolyData* output = loop->GetOutput();
  std::vector<Point> limits;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    Point point;
    Point tangents[2];
    output->GetPoint(i, point.data());
    output->GetPointData()->GetArray("LimitTangent1")->GetTuple(i, tangents[0].data());
    output->GetPointData()->GetArray("LimitTangent2")->GetTuple(i, tangents[1].data());
    limits.insert(limits.end(), { point, FindNormal(tangents[0], tangents[1]) });
  }
  return limits;
}

struct RandomCase
{
  explicit RandomCase(unsigned seed)
  {
    std::mt19937 random(seed);
    this->Input = MakeCreasedInput(MakeRandomCells(random), random);
    for (int& rule : this->Rules.Joints)
    {
      rule = static_cast<int>(random() % 2);
    }
    this->Rules.CreaseEnd = static_cast<int>(random() % 2);
    this->Rules.LoopWeights = static_cast<int>(random() % 2);
  }
  vtkSmartPointer<vtkPolyData> Input;
  Options Rules;
};

}

TEST(SurfaceJoints, RandomMeshesAreThoseOfTheMainFilter)
{
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomCase random(seed);
    ExpectSameSurfaces(random.Input, random.Rules, 1);
    ExpectSameSurfaces(random.Input, random.Rules, 2);
    ExpectSameSurfaces(random.Input, random.Rules, 1, true);
  }
}

/// But for equal faces, which the main filter takes as one.
TEST(SurfaceJoints, TheZooIsThatOfTheMainFilter)
{
  auto zoo = MakeZoo(true);
  ASSERT_EQ(zoo.erase("pillow"), 1u);
  for (const auto& [name, model] : zoo)
  {
    for (const int choice : { 0, 1, 2, 3 })
    {
      SCOPED_TRACE(name + ", choice " + std::to_string(choice));
      Options options;
      options.LoopWeights = choice % 2;
      options.ModifiedBoundary = choice / 2 == 1;
      for (const int levels : { 0, 1, 2, 3 })
      {
        ExpectSameSurfaces(MakeInput(model), options, levels, false);
        ExpectSameSurfaces(MakeInput(model), options, levels, true);
      }
    }
  }
}

TEST(SurfaceJoints, LimitsAreThoseOfAllLevels)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomCase random(seed);
    for (const bool modifiedBoundary : { false, true })
    {
      random.Rules.ModifiedBoundary = modifiedBoundary;
      const auto early = FindLimits(random.Input, random.Rules, 0);
      const auto late = FindLimits(random.Input, random.Rules, 2);
      for (std::size_t i = 0; i < early.size(); ++i)
      {
        EXPECT_LT(GetDistance(early[i], late[i]), i % 2 ? 1e-7 : 1e-12) << "of point " << i / 2;
      }
    }
  }
}

TEST(SurfaceJoints, BordersDoNotCountAmongSharpJoints)
{
  // Three triangles at an edge; two of them are closed around point 0, the border of the third ends
  // there: of the two sharp edges of point 0 one is a joint, so that it is a corner.
  Model model;
  model.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0.2, 0 }, { -0.3, 1, 0.1 }, { -0.6, -1, 0.3 } };
  model.Faces = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 }, { 0, 2, 3 } };
  vtkNew<vtkSurfaceSubdivision> loop;
  loop->SetInputData(MakeInput(model));
  loop->ModifiedBoundaryOff();
  loop->SetType2RuleToSharp();
  loop->Update();
  vtkNew<vtkMultiDimensionalSubdivision> main;
  main->SetInputData(MakeInput(model));
  main->ModifiedBoundaryOff();
  main->SetType2RuleToSharp();
  main->Update();
  for (vtkIdType i = 0; i < 5; ++i)
  {
    Point a;
    Point b;
    loop->GetOutput()->GetPoint(i, a.data());
    main->GetOutput()->GetPoint(i, b.data());
    EXPECT_LT(GetDistance(a, b), 1e-14) << "point " << i;
  }
  EXPECT_EQ(loop->GetOutput()->GetPoint(0)[1], 0.);
}

TEST(SurfaceJoints, CreasesGoThroughJointsPastBorders)
{
  // A tetrahedron that touches the corner of a triangle in point 0, where two of its edges are
  // creases: one curve, whatever the triangle's border does.
  Model model;
  model.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0.2, 0 }, { -0.3, 1, 0.1 }, { -0.6, -1, 0.3 },
    { 0.5, -1, 0 } };
  model.Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 }, { 0, 4, 5 } };
  model.Lines = { { 0, 1 }, { 0, 2 } };
  const auto input = MakeInput(model);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(cell < 2);
  }
  input->GetCellData()->AddArray(flags);
  ExpectSameSurfaces(input, Options(), 2);
  const auto output = RunFilter(input, vtkSurfaceSubdivision::LOOP, 1);
  Point moved;
  output->GetPoint(0, moved.data());
  EXPECT_LT(GetDistance(moved, { 0.125, 0.025, 0.125 }), 1e-15);
}
