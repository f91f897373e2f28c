// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionSmoothness.cxx
 * Where schemes are smooth, and where not: known places of small meshes, agreement with
 * vtkSimplicialComplexTopology on all models, and what arrays of the output say of each other.
 */
#include "FeatureTools.h"
#include "SimplicialComplexTopologyTools.h"

#include "vtkSubdivisionSmoothness.h"

#include "vtkPlatonicSolidSource.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSurfaceSubdivision.h"

using namespace simplicial_complex_topology_tools;

namespace
{

using Filter = vtkSubdivisionSmoothness;
using Setup = std::function<void(Filter*)>;

Grid Examine(vtkDataObject* input, int scheme, const Setup& setup = nullptr)
{
  vtkNew<Filter> filter;
  filter->SetScheme(scheme);
  filter->SampleMapsOn();
  if (setup)
  {
    setup(filter);
  }
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
}

double Get(vtkUnstructuredGrid* grid, const char* name, vtkIdType cell, int component = 0)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  return array ? array->GetComponent(cell, component) : -9.;
}

/// The cell with these points in any order, and this sector; -1: there is none.
vtkIdType Find(vtkUnstructuredGrid* grid, Ids simplex, int sector = -1)
{
  std::sort(simplex.begin(), simplex.end());
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Ids cell = GetCell(grid, c);
    std::sort(cell.begin(), cell.end());
    if (cell == simplex && Get(grid, "Sector", c) == sector)
    {
      return c;
    }
  }
  return -1;
}

/// Condition, Regular, Injective.
V Answers(vtkUnstructuredGrid* grid, const Ids& simplex, int sector = -1)
{
  const vtkIdType cell = Find(grid, simplex, sector);
  V answers;
  for (const char* name : { "Condition", "Regular", "Injective" })
  {
    answers.push_back(cell < 0 ? -9 : static_cast<int>(Get(grid, name, cell)));
  }
  return answers;
}

double Eigenvalue(vtkUnstructuredGrid* grid, const Ids& simplex, int which, int sector = -1)
{
  const vtkIdType cell = Find(grid, simplex, sector);
  return cell < 0 ? -9. : Get(grid, "Eigenvalues", cell, which);
}

const V Smooth{ 1, 1, 1 };
const V Failing{ 0, -1, -1 };
const V Nothing{ -1, -1, -1 };

/// What must be so in any output.
void ExpectConsistent(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  std::vector<int> marks(output->GetNumberOfPoints(), 0);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    SCOPED_TRACE("cell " + std::to_string(c));
    double before = 1. + 1e-9;
    for (int k = 0; k < 6; ++k)
    {
      const double value = Get(output, "Eigenvalues", c, k);
      EXPECT_GE(value, 0.);
      EXPECT_LE(value, before);
      before = value + 1e-12;
    }
    const double first = Get(output, "Eigenvalues", c, 0);
    EXPECT_TRUE(std::abs(first - 1.) < 1e-9 || first == 0.);
    const int condition = static_cast<int>(Get(output, "Condition", c));
    const int regular = static_cast<int>(Get(output, "Regular", c));
    const int injective = static_cast<int>(Get(output, "Injective", c));
    const int rule = static_cast<int>(Get(output, "RuleDimension", c));
    EXPECT_EQ(regular >= 0, injective >= 0);
    EXPECT_EQ(regular >= 0, Get(output, "Samples", c) > 0);
    EXPECT_LE(injective, regular);
    EXPECT_FALSE(regular >= 0 && condition != 1); // there is no map without the condition
    EXPECT_FALSE(condition >= 0 && (rule == 0 || rule == 4));
    const bool fails = condition == 0 || regular == 0 || injective == 0;
    EXPECT_EQ(Get(output, "Failing", c), fails ? 1. : 0.);
    for (const vtkIdType point : GetCell(output, c))
    {
      marks[point] |= fails ? 1 : 0;
    }
  }
  vtkDataArray* failing = output->GetPointData()->GetArray("Failing");
  ASSERT_TRUE(failing);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(failing->GetComponent(p, 0), marks[p]);
  }
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(GetPoint(input, p), GetPoint(output, p));
  }
}

/// Triangles around point 0, from one side of a straight boundary to the other.
Grid MakeHalfFan(int triangles)
{
  std::vector<Point> points{ { 0., 0., 0. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i <= triangles; ++i)
  {
    const double turn = 3.14159265358979 * static_cast<double>(i) / triangles;
    points.push_back({ std::cos(turn), std::sin(turn), 0. });
    if (i > 0)
    {
      cells.push_back({ VTK_TRIANGLE, { 0, i, i + 1 } });
    }
  }
  return MakeGrid(points, cells);
}

/// Triangles or quads around point 0 in a sector of this angle. Cell array `flags` makes the point
/// a corner, if the angle is not straight.
Grid MakeSector(int faces, double degrees, bool quads)
{
  std::vector<Point> points{ { 0., 0., 0. } };
  std::vector<Cell> cells;
  const auto add = [&](double place, double distance)
  {
    const double turn = vtkMath::RadiansFromDegrees(degrees) * place / faces;
    points.push_back({ distance * std::cos(turn), distance * std::sin(turn), 0. });
  };
  for (vtkIdType i = 0; i <= faces; ++i)
  {
    add(static_cast<double>(i), 1.);
  }
  if (degrees != 180.)
  {
    cells.push_back({ VTK_VERTEX, { 0 } });
  }
  for (vtkIdType i = 0; i < faces; ++i)
  {
    if (quads)
    {
      add(static_cast<double>(i) + 0.5, 1.4);
      cells.push_back({ VTK_QUAD, { 0, i + 1, faces + 2 + i, i + 2 } });
    }
    else
    {
      cells.push_back({ VTK_TRIANGLE, { 0, i + 1, i + 2 } });
    }
  }
  const Grid grid = MakeGrid(points, cells);
  vtkNew<vtkIntArray> flags;
  flags->SetName("flags");
  for (const Cell& cell : cells)
  {
    flags->InsertNextValue(cell.Type == VTK_VERTEX ? 1 : 0);
  }
  grid->GetCellData()->AddArray(flags);
  return grid;
}

/// An inner point with four neighbours.
Grid MakeCutTet()
{
  return MakeGrid(
    { { 0., 0., 0. }, { 1., 1., 1. }, { 1., -1., -1. }, { -1., 1., -1. }, { -1., -1., 1. } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_TETRA, { 0, 1, 3, 4 } },
      { VTK_TETRA, { 0, 2, 3, 4 } } });
}

/// n tetrahedra around a long edge.
Grid MakeSpindle(int n)
{
  std::vector<Point> points{ { 0., 0., -3. }, { 0., 0., 3. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double turn = 2. * 3.14159265358979 * static_cast<double>(i) / n;
    points.push_back({ std::cos(turn), std::sin(turn), 0. });
    cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % n } });
  }
  return MakeGrid(points, cells);
}

}

TEST(SubdivisionSmoothness, AllModelsAgreeWithTheTopology)
{
  for (int model = 0; model < 8; ++model)
  {
    SCOPED_TRACE(model);
    const Grid input = LoadModel(model);
    const Grid topology = Probe(input);
    for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
    {
      const Grid output = Examine(input, scheme, [](Filter* filter) { filter->SampleMapsOff(); });
      ExpectConsistent(input, output);
      std::map<Ids, vtkIdType> cells;
      for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
      {
        if (Get(output, "Sector", c) < 0.)
        {
          Ids ids = GetCell(output, c);
          std::sort(ids.begin(), ids.end());
          EXPECT_TRUE(cells.emplace(ids, c).second);
        }
      }
      EXPECT_EQ(static_cast<vtkIdType>(cells.size()), topology->GetNumberOfCells());
      for (vtkIdType c = 0; c < topology->GetNumberOfCells(); ++c)
      {
        const auto found = cells.find(GetCell(topology, c));
        ASSERT_NE(found, cells.end());
        EXPECT_EQ(Get(output, "Valence", found->second), Get(topology, "Valence", c));
        if (found->first.size() < 3)
        {
          EXPECT_EQ(Get(output, "RuleDimension", found->second), Get(topology, "RuleDimension", c));
        }
      }
    }
  }
}

TEST(SubdivisionSmoothness, AllSchemesOfSurfaces)
{
  const Grid input = LoadModel(vtkSubdivisionModelSource::MECHANICAL_PART);
  for (int scheme = Filter::LOOP; scheme <= Filter::LINEAR; ++scheme)
  {
    SCOPED_TRACE(scheme);
    vtkNew<Filter> filter;
    vtkNew<Messages> messages; // solids are left out
    messages->Watch(filter);
    filter->SetScheme(scheme);
    filter->SetInputDataObject(input);
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    ExpectConsistent(input, filter->GetOutput());
  }
}

TEST(SubdivisionSmoothness, FourNeighboursInASolid)
{
  const Grid mesh = MakeCutTet();
  const Grid box = Examine(mesh, Filter::BOX_SPLINE);
  EXPECT_EQ(Answers(box, { 0 }), Failing);
  EXPECT_NEAR(Eigenvalue(box, { 0 }, 3), 0.1875, 1e-9);
  EXPECT_EQ(Answers(box, { 1 }), Smooth); // of the boundary, three triangles
  EXPECT_NEAR(Eigenvalue(box, { 1 }, 1), 0.25, 1e-9);
  EXPECT_EQ(Answers(box, { 0, 1 }), Smooth);
  EXPECT_EQ(Answers(box, { 0, 1, 2 }), Smooth);
  EXPECT_EQ(Answers(box, { 1, 2, 3 }), Smooth);
  EXPECT_EQ(Get(box, "Valence", Find(box, { 0, 1, 2 })), 2.);
  const Grid oct = Examine(mesh, Filter::TET_OCT);
  EXPECT_EQ(Answers(oct, { 0 }), Smooth);
  EXPECT_NEAR(Eigenvalue(oct, { 0 }, 1), 0.1759, 5e-5);
  // The marks of two edges with three tetrahedra make them fail, too.
  const Grid failing =
    Examine(mesh, Filter::BOX_SPLINE, [](Filter* filter) { filter->FailingOnlyOn(); });
  EXPECT_EQ(GetCells(failing), std::vector<Ids>({ { 0 }, { 0, 3 }, { 0, 4 } }));
  const Grid plain =
    Examine(mesh, Filter::TET_OCT, [](Filter* filter) { filter->SampleMapsOff(); });
  EXPECT_EQ(Answers(plain, { 0 }), V({ 1, -1, -1 }));
  EXPECT_EQ(Answers(plain, { 0, 1 }), V({ 1, -1, -1 }));
  EXPECT_EQ(Answers(plain, { 0, 1, 2 }), V({ 1, -1, -1 }));
}

TEST(SubdivisionSmoothness, EdgesByTheirTetrahedra)
{
  for (const int n : { 3, 7, 8, 10, 11 })
  {
    SCOPED_TRACE(n);
    const Grid box = Examine(MakeSpindle(n), Filter::BOX_SPLINE);
    EXPECT_EQ(Answers(box, { 0, 1 }), n < 8 ? Smooth : Failing);
    const Grid oct = Examine(MakeSpindle(n), Filter::TET_OCT);
    EXPECT_EQ(Answers(oct, { 0, 1 }), n < 11 ? Smooth : Failing);
    EXPECT_EQ(Get(oct, "Valence", Find(oct, { 0, 1 })), n);
    EXPECT_EQ(Answers(oct, { 0, 2 }), Smooth); // on the boundary
  }
}

/// What is said of an edge inside a solid is what is said, one level later, of the vertex in its
/// middle, whose star the filter finds in another way.
TEST(SubdivisionSmoothness, EdgesAreVerticesOfTheNextLevel)
{
  for (const Grid& mesh : { MakeCutTet(), MakeSpindle(5), feature_tools::MakeKuhnBox(2, 0.2) })
  {
    for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
    {
      SCOPED_TRACE(scheme);
      vtkNew<vtkMultiDimensionalSubdivision> filter;
      filter->SetVolumeScheme(scheme);
      const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
      const auto withoutMaps = [](Filter* made) { made->SampleMapsOff(); };
      const Grid now = Examine(mesh, scheme, withoutMaps);
      const Grid later = Examine(fine, scheme, withoutMaps);
      vtkIdType middle = mesh->GetNumberOfPoints();
      int inner = 0;
      for (vtkIdType c = 0; c < now->GetNumberOfCells(); ++c)
      {
        if (now->GetCellType(c) != VTK_LINE)
        {
          continue;
        }
        const vtkIdType vertex = Find(later, { middle++ });
        ASSERT_GE(vertex, 0);
        ASSERT_EQ(Get(now, "RuleDimension", c), Get(later, "RuleDimension", vertex));
        EXPECT_EQ(Get(now, "Condition", c), Get(later, "Condition", vertex));
        inner += Get(now, "RuleDimension", c) == 3. ? 1 : 0;
        for (int k = 0; k < 6 && Get(now, "RuleDimension", c) == 3.; ++k)
        {
          EXPECT_NEAR(Get(now, "Eigenvalues", c, k), Get(later, "Eigenvalues", vertex, k), 1e-7);
        }
      }
      EXPECT_GT(inner, 0);
    }
  }
}

TEST(SubdivisionSmoothness, SectorsAtABoundary)
{
  for (const int k : { 1, 2, 5, 6, 7, 9 })
  {
    SCOPED_TRACE(k);
    const Grid fan = MakeHalfFan(k);
    const Grid plain =
      Examine(fan, Filter::BOX_SPLINE, [](Filter* filter) { filter->ModifiedBoundaryOff(); });
    EXPECT_EQ(Answers(plain, { 0 }), V({ 1, -1, -1 })); // of the curve
    EXPECT_NEAR(Eigenvalue(plain, { 0 }, 1), 0.5, 1e-9);
    EXPECT_EQ(Answers(plain, { 0 }, 0), k < 6 ? Smooth : Failing);
    EXPECT_EQ(Get(plain, "Valence", Find(plain, { 0 }, 0)), k);
    EXPECT_EQ(Find(plain, { 0 }, 1), -1);
    const Grid modified = Examine(fan, Filter::BOX_SPLINE);
    EXPECT_EQ(Answers(modified, { 0 }, 0), Smooth);
    EXPECT_EQ(Answers(modified, { 0 }), Answers(plain, { 0 }));
    const Grid unmodified =
      Examine(fan, Filter::LOOP, [](Filter* filter) { filter->ModifiedBoundaryOff(); });
    EXPECT_EQ(Answers(unmodified, { 0 }, 0), k < 6 ? Smooth : Failing);
    EXPECT_EQ(Answers(Examine(fan, Filter::LOOP), { 0 }, 0), Smooth);
    EXPECT_EQ(Answers(Examine(fan, Filter::LINEAR), { 0 }, 0), k < 2 ? Smooth : Failing);
    const auto plainRules = [](Filter* filter) { filter->ModifiedBoundaryOff(); };
    EXPECT_EQ(
      Answers(Examine(fan, Filter::SQRT_THREE, plainRules), { 0 }, 0), k < 6 ? Smooth : Failing);
    EXPECT_EQ(Answers(Examine(fan, Filter::SQRT_THREE), { 0 }, 0), Smooth);
  }
}

/// Section 4 of the survey asks for condition (23) in each sector: at smooth boundaries, and at
/// convex and concave corners.
TEST(SubdivisionSmoothness, NoSectorFailsWithModifiedBoundaries)
{
  for (const int scheme :
    { Filter::LOOP, Filter::CATMULL_CLARK, Filter::SQRT_THREE, Filter::FOUR_EIGHT })
  {
    const bool hasQuads = scheme == Filter::CATMULL_CLARK || scheme == Filter::FOUR_EIGHT;
    for (const double degrees : { 25., 60., 90., 150., 180., 210., 235., 245., 270., 330. })
    {
      for (int k = degrees < 180. ? 1 : 2; k <= 12; ++k)
      {
        SCOPED_TRACE(std::to_string(scheme) + ": " + std::to_string(k) + " faces, " +
          std::to_string(degrees) + " degrees");
        const Grid modified = Examine(MakeSector(k, degrees, hasQuads), scheme,
          [](Filter* filter)
          {
            filter->SetInputArrayToProcess(
              0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "flags");
          });
        const V answers = Answers(modified, { 0 }, 0);
        EXPECT_EQ(answers[0], 1);
        // Two triangles of 165 degrees each are too wide for sqrt(3).
        EXPECT_EQ(answers == Smooth, scheme != Filter::SQRT_THREE || k > 2 || degrees < 300.);
      }
    }
  }
}

TEST(SubdivisionSmoothness, CornersDartsAndJoints)
{
  // Two tetrahedra that share an edge: a joint. A line at one end of it.
  const Grid joint = MakeGrid({ { 0., 0., 0. }, { 0., 0., 1. }, { 1., 0., 0. }, { 1., 1., 0. },
                                { -1., 0., 0. }, { -1., -1., 0. }, { 0., 0., 3. } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 4, 5 } }, { VTK_LINE, { 1, 6 } } });
  const Grid box = Examine(joint, Filter::BOX_SPLINE);
  EXPECT_EQ(Answers(box, { 0 }), Nothing);
  EXPECT_EQ(Get(box, "RuleDimension", Find(box, { 0 })), 4.);
  EXPECT_GT(Eigenvalue(box, { 0 }, 1), 0.);
  EXPECT_EQ(Answers(box, { 0, 1 }), Nothing);
  EXPECT_EQ(Eigenvalue(box, { 0, 1 }, 0), 0.);
  EXPECT_EQ(Answers(box, { 6 }), Nothing); // the end of a line stays
  EXPECT_EQ(Eigenvalue(box, { 6 }, 0), 1.);
  EXPECT_EQ(Eigenvalue(box, { 6 }, 1), 0.);
  EXPECT_EQ(Answers(box, { 1, 6 }), V({ 1, -1, -1 }));
  EXPECT_EQ(Answers(box, { 2, 3 }), Smooth);

  // A wheel with a crease along one spoke.
  std::vector<Point> points{ { 0., 0., 0. } };
  std::vector<Cell> cells{ { VTK_LINE, { 0, 1 } } };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    points.push_back({ std::cos(1.0472 * i), std::sin(1.0472 * i), 0. });
    cells.push_back({ VTK_TRIANGLE, { 0, 1 + i, 1 + (i + 1) % 6 } });
  }
  const Grid wheel = MakeGrid(points, cells);
  Flag(wheel, { 1, 0, 0, 0, 0, 0, 0 });
  for (const int scheme : { Filter::BOX_SPLINE, Filter::LOOP })
  {
    EXPECT_EQ(Answers(Examine(wheel, scheme), { 0 }), Nothing); // a corner
    const Grid dart = Examine(wheel, scheme, [](Filter* filter) { filter->SetCreaseEndToDart(); });
    EXPECT_EQ(Answers(dart, { 0 }), Smooth);
    EXPECT_NEAR(Eigenvalue(dart, { 0 }, 1), .5, 1e-9);
    EXPECT_NEAR(Eigenvalue(dart, { 0 }, 3), .3384, 5e-5);
  }
}

TEST(SubdivisionSmoothness, CornersOfSurfacesHaveTheirAngle)
{
  // A flagged corner with three triangles, over an angle of 270 degrees.
  const Grid fan =
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { -1., 0., 0. }, { 0., -1., 0. } },
      { { VTK_VERTEX, { 0 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } },
        { VTK_TRIANGLE, { 0, 3, 4 } } });
  Flag(fan, { 1, 0, 0, 0 });
  const Grid loop = Examine(fan, Filter::LOOP);
  EXPECT_EQ(Answers(loop, { 0 }), Nothing);
  EXPECT_EQ(Answers(loop, { 0 }, 0), Smooth);
  EXPECT_NEAR(Eigenvalue(loop, { 0 }, 3, 0), 0.25, 1e-6); // by flatness
  EXPECT_EQ(Answers(Examine(fan, Filter::BOX_SPLINE), { 0 }, 0), Failing);
}

TEST(SubdivisionSmoothness, PolygonsOfDualSchemesAndOfCatmullClark)
{
  const Grid prism = MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. },
                                { 1., 0., 1. }, { 0., 1., 1. } },
    { { VTK_TRIANGLE, { 0, 2, 1 } }, { VTK_TRIANGLE, { 3, 4, 5 } }, { VTK_QUAD, { 0, 1, 4, 3 } },
      { VTK_QUAD, { 1, 2, 5, 4 } }, { VTK_QUAD, { 2, 0, 3, 5 } } });
  const Grid doo = Examine(prism, Filter::DOO_SABIN);
  EXPECT_EQ(Answers(doo, { 0 }), V({ 1, 1, 1 }));
  EXPECT_NEAR(Eigenvalue(doo, { 0, 1, 2 }, 1), .5, 1e-9);
  EXPECT_EQ(doo->GetCellType(Find(doo, { 0, 1, 3, 4 })), VTK_QUAD);
  const Grid midedge = Examine(prism, Filter::MIDEDGE);
  EXPECT_EQ(Answers(midedge, { 0 }), Failing);
  EXPECT_EQ(Answers(midedge, { 0, 1, 2 }), Failing);
  EXPECT_EQ(Answers(midedge, { 0, 1, 3, 4 }), V({ 1, 1, 1 }));
  EXPECT_EQ(Answers(midedge, { 0, 1 }), V({ 1, 1, 1 }));
  const Grid clark = Examine(prism, Filter::CATMULL_CLARK);
  EXPECT_NEAR(Eigenvalue(clark, { 0, 1, 2 }, 1), .4101, 5e-5); // a vertex of three quads
  EXPECT_NEAR(Eigenvalue(clark, { 0, 1, 3, 4 }, 1), .5, 1e-9);
  EXPECT_EQ(Get(clark, "Valence", Find(clark, { 0, 1, 3, 4 })), 4.);
}

/// Rules and marks of a mesh that a filter made are those of its next level.
TEST(SubdivisionSmoothness, LevelsOfAFilter)
{
  const Grid mesh = MakeSpindle(8);
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetVolumeScheme(scheme);
    const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
    const Grid output = Examine(fine, scheme);
    ExpectConsistent(fine, output);
    EXPECT_FALSE(output->GetFieldData()->GetAbstractArray("Subdivision"));
    int failing = 0;
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      failing += Get(output, "Failing", c) == 1. ? 1 : 0;
    }
    // The vertex in the middle of the edge, and the two halves of the edge.
    EXPECT_EQ(failing, scheme == Filter::BOX_SPLINE ? 3 : 0);
    vtkNew<Filter> other;
    vtkNew<Messages> messages;
    messages->Watch(other);
    other->SetScheme(Filter::TET_OCT - scheme);
    other->SetInputDataObject(fine);
    other->Update();
    EXPECT_EQ(messages->CountWarnings("with another VolumeScheme"), 1);
  }
  const Grid fan = MakeHalfFan(7);
  for (const int scheme : { Filter::LOOP, Filter::DOO_SABIN, Filter::FOUR_EIGHT })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetScheme(scheme - Filter::LOOP);
    filter->SetInputDataObject(fan);
    filter->Update();
    const Grid output = Examine(filter->GetOutput(), scheme);
    EXPECT_GT(output->GetNumberOfCells(), fan->GetNumberOfCells());
  }
}

TEST(SubdivisionSmoothness, LevelsOfClosedSurfaces)
{
  // Steps of these skip levels, and store less of them. All levels are smooth, so that their faces
  // are what the same faces are without a stamp.
  vtkNew<vtkPlatonicSolidSource> source;
  for (int scheme = Filter::LOOP; scheme <= Filter::SQRT_THREE; ++scheme)
  {
    const bool ofQuads = scheme == Filter::CATMULL_CLARK || scheme == Filter::DOO_SABIN ||
      scheme == Filter::MIDEDGE || scheme == Filter::FOUR_EIGHT;
    ofQuads ? source->SetSolidTypeToCube() : source->SetSolidTypeToTetrahedron();
    source->Update();
    for (const int levels : { 1, 2, 3 })
    {
      SCOPED_TRACE(std::to_string(scheme) + ", " + std::to_string(levels) + " levels");
      vtkNew<vtkSurfaceSubdivision> filter;
      filter->SetScheme(scheme - Filter::LOOP);
      filter->SetNumberOfLevels(levels);
      filter->SetInputData(source->GetOutput());
      filter->Update();
      vtkNew<vtkPolyData> plain;
      plain->ShallowCopy(filter->GetOutput());
      plain->GetFieldData()->Initialize();
      const Grid output = Examine(filter->GetOutput(), scheme);
      const Grid expected = Examine(plain.Get(), scheme);
      const auto list = [](const Grid& grid)
      {
        std::vector<double> ofFaces;
        for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
        {
          if (grid->GetCell(c)->GetCellDimension() == 2)
          {
            ofFaces.push_back(Get(grid, "Failing", c));
          }
        }
        return ofFaces;
      };
      EXPECT_EQ(list(output).size(), static_cast<std::size_t>(plain->GetNumberOfCells()));
      EXPECT_EQ(list(output), list(expected));
      if (scheme != Filter::DOO_SABIN && scheme != Filter::MIDEDGE) // whose steps make faces alone
      {
        EXPECT_EQ(output->GetNumberOfCells(), expected->GetNumberOfCells());
      }
    }
  }
}

TEST(SubdivisionSmoothness, FailingPointsCanBeRefined)
{
  const Grid mesh = MakeCutTet();
  const Grid output = Examine(mesh, Filter::BOX_SPLINE);
  mesh->GetPointData()->AddArray(output->GetPointData()->GetArray("Failing"));
  vtkNew<vtkRedGreenRefinement> filter;
  filter->RefineByAttributeErrorOff();
  filter->RefineByArrayRangeOn();
  filter->SetArrayRange(1., 1.);
  filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Failing");
  filter->SetMaximumLevel(1);
  const Grid finer = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
  EXPECT_EQ(finer->GetNumberOfCells(), 8 * mesh->GetNumberOfCells());
}

TEST(SubdivisionSmoothness, ErrorsAndEmptyInputs)
{
  const Grid mesh = MakeCutTet();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  for (const bool isLarge : { false, true })
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(isLarge ? static_cast<vtkDataObject*>(mesh) : blocks);
    filter->SetMaximumNumberOfCells(24); // 5 vertices, 10 edges, 10 triangles
    filter->Update();
    ASSERT_FALSE(messages->Errors.empty());
    EXPECT_NE(messages->Errors[0].find(isLarge ? "25 vertices" : "Merge it"), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  vtkNew<vtkUnstructuredGrid> empty;
  for (int scheme = Filter::BOX_SPLINE; scheme <= Filter::SQRT_THREE; ++scheme)
  {
    EXPECT_EQ(Examine(empty, scheme)->GetNumberOfCells(), 0);
  }
}
