// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCurvedCells.cxx
 * OutputCells = Quadratic and Lagrange: nodes are the limit at VTK's parameters, cells that touch
 * share them, and VTK's own cells agree on their order.
 */
#include "BezierTools.h"
#include "CurvedTools.h"

#include "vtkPointLocator.h"
#include "vtkSphere.h"
#include "vtkUnsignedCharArray.h"

using namespace curved_tools;
using place_tools::Places;

namespace
{

const std::vector<int> Orders{ 0, 1, 2, 3, 4, 5, 6 };

/// Cells may be repaired: `moved` is how many warnings say so.
Grid MakeCurved(
  vtkDataObject* input, int order, int levels, const Configure& configure, int* moved = nullptr)
{
  vtkNew<Messages> messages;
  const Grid made = Execute(
    input, levels,
    [&](Filter* filter)
    {
      if (configure)
      {
        configure(filter);
      }
      SetOrder(filter, order);
    },
    messages);
  for (const std::string& error : messages->Errors)
  {
    ADD_FAILURE() << error;
  }
  if (moved)
  {
    *moved = messages->CountWarnings("nodes of them went back");
  }
  return made;
}

bool HasPyramids(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == VTK_PYRAMID)
    {
      return true;
    }
  }
  return false;
}

/// A node that was moved is between the limit and its place in the straight cell.
void ExpectBetween(vtkUnstructuredGrid* curved, vtkDataSet* linear, const Places& places,
  vtkIdType i, const Point& limit, const Point& node)
{
  const vtkIdType c = places.Cells->GetValue(i);
  vtkCell* straight = linear->GetCell(c);
  double weights[8];
  straight->InterpolateFunctions(places.Parameters->GetTuple3(i), weights);
  Point way{};
  Point kept{};
  double share = 0.;
  double length = 0.;
  for (int k = 0; k < 3; ++k)
  {
    double from = 0.;
    for (int corner = 0; corner < straight->GetNumberOfPoints(); ++corner)
    {
      from += weights[corner] * GetPoint(curved, GetCell(curved, c)[corner])[k];
    }
    way[k] = limit[k] - from;
    kept[k] = node[k] - from;
    share += way[k] * kept[k];
    length += way[k] * way[k];
  }
  share /= length;
  EXPECT_GE(share, -1e-9);
  EXPECT_LT(share, 1.);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(kept[k], share * way[k], 1e-9) << c;
  }
}

/// All nodes of a grid, and their values, are nodes of another.
void ExpectSubset(vtkUnstructuredGrid* few, vtkUnstructuredGrid* many)
{
  vtkNew<vtkPointLocator> locator;
  locator->SetDataSet(many);
  vtkDataArray* values = few->GetPointData()->GetArray("Scalar");
  vtkDataArray* others = many->GetPointData()->GetArray("Scalar");
  ASSERT_TRUE(values && others);
  for (vtkIdType i = 0; i < few->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(few, i);
    const vtkIdType found = locator->FindClosestPoint(p.data());
    const Point q = GetPoint(many, found);
    ASSERT_LT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-12) << i;
    EXPECT_NEAR(values->GetComponent(i, 0), others->GetComponent(found, 0), 1e-12);
  }
}

/// The nodes of cells that have parameters in common have the same values; and places, unless some
/// were moved.
void ExpectSameNodes(vtkUnstructuredGrid* few, vtkUnstructuredGrid* many, bool areMoved)
{
  ASSERT_EQ(few->GetNumberOfCells(), many->GetNumberOfCells());
  vtkDataArray* values = few->GetPointData()->GetArray("Scalar");
  vtkDataArray* others = many->GetPointData()->GetArray("Scalar");
  const auto list = [](vtkCell* cell)
  {
    std::map<std::array<int, 3>, vtkIdType> nodes;
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      const double* at = cell->GetParametricCoords() + 3 * i;
      nodes[{ static_cast<int>(std::lround(60. * at[0])),
        static_cast<int>(std::lround(60. * at[1])), static_cast<int>(std::lround(60. * at[2])) }] =
        cell->GetPointId(static_cast<int>(i));
    }
    return nodes;
  };
  for (vtkIdType c = 0; c < few->GetNumberOfCells(); ++c)
  {
    const auto own = list(few->GetCell(c));
    const auto all = list(many->GetCell(c));
    for (const auto& [at, node] : own)
    {
      const auto found = all.find(at);
      ASSERT_NE(found, all.end());
      ASSERT_NEAR(values->GetComponent(node, 0), others->GetComponent(found->second, 0), 1e-12);
      const Point p = GetPoint(few, node);
      const Point q = GetPoint(many, found->second);
      ASSERT_TRUE(areMoved || std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-12) << c;
    }
  }
}

/// Cells of `linear` are the cells of the input of `evaluated`, or of its pieces.
template <typename FilterPointer>
void ExpectNodesOnLimit(
  vtkUnstructuredGrid* curved, vtkDataSet* linear, FilterPointer evaluated, bool isRepaired = false)
{
  ASSERT_EQ(curved->GetNumberOfCells(), linear->GetNumberOfCells());
  Places places;
  std::vector<vtkIdType> nodes;
  for (vtkIdType c = 0; c < curved->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = curved->GetCell(c);
    EXPECT_EQ(cell->GetCellDimension(), linear->GetCell(c)->GetCellDimension());
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      const double* at = cell->GetParametricCoords() + 3 * i;
      places.Add(c, { at[0], at[1], at[2] });
      nodes.push_back(cell->GetPointId(static_cast<int>(i)));
    }
  }
  const auto limit = place_tools::Evaluate(evaluated, places);
  vtkDataArray* values = limit->GetPointData()->GetArray("Scalar");
  vtkDataArray* given = curved->GetPointData()->GetArray("Scalar");
  int others = 0;
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    Point p;
    limit->GetPoint(i, p.data());
    const Point node = GetPoint(curved, nodes[i]);
    if (std::hypot(p[0] - node[0], p[1] - node[1], p[2] - node[2]) > 2e-12)
    {
      ++others;
      ExpectBetween(curved, linear, places, i, p, node);
    }
    if (values && given)
    {
      ASSERT_NEAR(values->GetComponent(i, 0), given->GetComponent(nodes[i], 0), 1e-12);
    }
  }
  EXPECT_EQ(others > 0, isRepaired);
  EXPECT_LT(others, places.GetSize());
}

/// A mesh, and a scheme in which its cells stay.
struct Case
{
  std::string Name;
  Grid Input;
  Configure Scheme;
};

std::vector<Case> MakeCases()
{
  const Grid solid = MakeUprightMixed();
  const Grid types = MakeAllTypes();
  std::vector<Cell> cells;
  for (vtkIdType c = 0; c < types->GetNumberOfCells(); ++c)
  {
    if (types->GetCellType(c) != VTK_PYRAMID)
    {
      cells.push_back({ types->GetCellType(c), GetCell(types, c) });
    }
  }
  std::vector<Point> points;
  for (vtkIdType i = 0; i < types->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(types, i));
  }
  const auto scheme = [](int number)
  { return [number](Filter* filter) { filter->SetVolumeScheme(number); }; };
  return { { "box spline", solid, scheme(Filter::BOX_SPLINE) },
    { "linear", solid, scheme(Filter::LINEAR) }, { "tet/oct", solid, scheme(Filter::TET_OCT) },
    { "hybrid", types, scheme(Filter::HYBRID) },
    { "automatic", MakeGrid(points, cells), scheme(Filter::AUTOMATIC) } };
}

}

TEST(CurvedCells, NodesAreTheLimitAtTheirParameters)
{
  for (const Case& tried : MakeCases())
  {
    for (const int order : Orders)
    {
      if ((order > 0 && HasPyramids(tried.Input)) || (order > 4 && tried.Name != "box spline"))
      {
        continue;
      }
      // Places take long but by the box spline.
      for (int levels = 0; levels <= (order > 2 && tried.Name != "box spline" ? 0 : 1); ++levels)
      {
        SCOPED_TRACE(
          tried.Name + ", order " + std::to_string(order) + ", levels " + std::to_string(levels));
        int moved = 0;
        const Grid curved = MakeCurved(tried.Input, order, levels, tried.Scheme, &moved);
        const Grid linear = Execute(tried.Input, levels, tried.Scheme);
        vtkNew<Filter> filter;
        tried.Scheme(filter);
        filter->SetInputData(linear);
        ExpectNodesOnLimit(curved, linear, filter.Get(), moved > 0);
        ExpectVtkOrder(curved);
        ExpectConforming(curved);
      }
    }
  }
}

/// The surface filter, with quads, triangles, a pentagon and lines.
TEST(CurvedCells, SurfacesHaveNodesOnTheLimit)
{
  for (const bool triangles : { true, false })
  {
    const auto sheet = bezier_tools::ToSurface(bezier_tools::MakeSheet(3, triangles, 0.2));
    for (const int order : Orders)
    {
      for (const int levels : { 0, 1 })
      {
        SCOPED_TRACE(std::to_string(triangles) + ", order " + std::to_string(order) + ", levels " +
          std::to_string(levels));
        const auto configure = [&](vtkSurfaceSubdivision* filter, int number)
        {
          triangles ? filter->SetSchemeToLoop() : filter->SetSchemeToCatmullClark();
          filter->SetNumberOfLevels(number);
        };
        vtkNew<vtkSurfaceSubdivision> curved;
        configure(curved, levels);
        SetOrder(curved, order);
        UpdateInSilence(curved, sheet);
        ASSERT_EQ(curved->GetOutput(), nullptr);
        vtkNew<vtkSurfaceSubdivision> linear;
        configure(linear, levels);
        UpdateInSilence(linear, sheet);
        vtkNew<vtkSurfaceSubdivision> evaluated;
        configure(evaluated, 0);
        evaluated->SetInputDataObject(
          levels == 0 ? static_cast<vtkDataObject*>(sheet) : linear->GetOutput());
        vtkUnstructuredGrid* grid = curved->GetUnstructuredGridOutput();
        ExpectNodesOnLimit(grid, linear->GetOutput(), evaluated.Get());
        ExpectVtkOrder(grid);
        ExpectConforming(grid);
      }
    }
  }
}

TEST(CurvedCells, FacesThatAreNoQuadsAreSplitOnce)
{
  const Grid pentagon = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, 1, 0.5 }, { 0.5, 1.5, 0 }, { -0.5, 1, 0 }, { 2, 0, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 1, 5, 2 } } });
  const auto surface = bezier_tools::ToSurface(pentagon);
  for (const int levels : { 0, 1 })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetSchemeToCatmullClark();
    filter->SetNumberOfLevels(levels);
    SetOrder(filter, 0);
    UpdateInSilence(filter, surface);
    EXPECT_EQ(filter->GetUnstructuredGridOutput()->GetNumberOfCells(), 8);
    EXPECT_EQ(filter->GetUnstructuredGridOutput()->GetCellType(7), VTK_QUADRATIC_QUAD);
    ExpectConforming(filter->GetUnstructuredGridOutput());
  }
  // These are cut into triangles first.
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::LINEAR })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetScheme(scheme);
    filter->SetNumberOfLevels(0);
    SetOrder(filter, 4);
    UpdateInSilence(filter, surface);
    EXPECT_EQ(filter->GetUnstructuredGridOutput()->GetNumberOfCells(), 4);
    EXPECT_EQ(filter->GetUnstructuredGridOutput()->GetCellType(0), VTK_LAGRANGE_TRIANGLE);
  }
  vtkNew<vtkSurfaceSubdivision> dual;
  dual->SetSchemeToDooSabin();
  SetOrder(dual, 0);
  vtkNew<Messages> messages;
  UpdateInSilence(dual, surface, messages);
  EXPECT_EQ(messages->CountWarnings("Curved cells need Scheme"), 1);
  EXPECT_NE(dual->GetOutput(), nullptr);
}

/// Cells have the data of the linear ones, points those of the finer level.
TEST(CurvedCells, ArraysComeAlong)
{
  const Grid input = MakeAllTypes();
  // Straight cells need no repair.
  const Configure ids = [](Filter* filter)
  {
    filter->SetVolumeSchemeToLinear();
    filter->KeepCellTypesOn();
    filter->GenerateOriginalIdsOn();
  };
  const Grid linear = Execute(input, 1, ids);
  const Grid fine = Execute(input, 2, And(ids, [](Filter* filter) { filter->ProjectToLimitOn(); }));
  const Grid curved = MakeCurved(input, 0, 1, ids);
  ASSERT_EQ(curved->GetNumberOfCells(), linear->GetNumberOfCells());
  EXPECT_EQ(curved->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
  EXPECT_NE(curved->GetFieldData()->GetAbstractArray("names"), nullptr);
  EXPECT_EQ(curved->GetCellData()->GetArray("OctahedronId"), nullptr);
  EXPECT_STREQ(curved->GetPointData()->GetScalars()->GetName(), "float");
  vtkCellData* cells = linear->GetCellData();
  for (int a = 0; a < cells->GetNumberOfArrays(); ++a)
  {
    const std::string name = cells->GetAbstractArray(a)->GetName();
    if (name != "OctahedronId")
    {
      ASSERT_NE(curved->GetCellData()->GetAbstractArray(name.c_str()), nullptr) << name;
      EXPECT_EQ(CompareValues(cells->GetAbstractArray(a),
                  curved->GetCellData()->GetAbstractArray(name.c_str())),
        "")
        << name;
    }
  }
  std::map<Point, vtkIdType> places;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    places[GetPoint(fine, i)] = i;
  }
  vtkPointData* points = fine->GetPointData();
  EXPECT_EQ(curved->GetPointData()->GetNumberOfArrays(), points->GetNumberOfArrays());
  for (int a = 0; a < points->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = points->GetAbstractArray(a);
    vtkAbstractArray* taken = curved->GetPointData()->GetAbstractArray(array->GetName());
    ASSERT_NE(taken, nullptr) << array->GetName();
    for (vtkIdType i = 0; i < curved->GetNumberOfPoints(); ++i)
    {
      const auto found = places.find(GetPoint(curved, i));
      ASSERT_NE(found, places.end());
      const vtkIdType n = array->GetNumberOfComponents();
      for (vtkIdType k = 0; k < n; ++k)
      {
        ASSERT_EQ(taken->GetVariantValue(n * i + k).ToString(),
          array->GetVariantValue(n * found->second + k).ToString())
          << array->GetName();
      }
    }
  }
}

TEST(CurvedCells, ThreadsDoNotMatter)
{
  const Grid input = MakeAllTypes();
  MakeInThreads([&] { return MakeCurved(input, 0, 2, Hybrid); });
  const Grid mixed = MakeUprightMixed();
  MakeInThreads([&] { return MakeCurved(mixed, 4, 2, {}); });
}

TEST(CurvedCells, PyramidsOfLagrangeAreAnError)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakeAllTypes());
  SetOrder(filter, 2);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->Update();
  ASSERT_EQ(messages->Errors.size(), 1u);
  EXPECT_NE(
    messages->Errors[0].find("is a pyramid: VTK has no Lagrange pyramids"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

/// Nodes of the orders 3 and 6 that orders have in common are the same limits, and those of 6 that
/// 2 has are points of a level.
TEST(CurvedCells, OrdersShareNodes)
{
  const Grid input = MakeUprightMixed();
  for (const int levels : { 0, 1 })
  {
    // Without repair, which orders need not have alike.
    const Grid six = MakeCurved(input, 6, levels, [](Filter* f) { f->SetVolumeSchemeToLinear(); });
    for (const int order : { 2, 3 })
    {
      const Grid few =
        MakeCurved(input, order, levels, [](Filter* f) { f->SetVolumeSchemeToLinear(); });
      ExpectSubset(few, six);
    }
  }
  for (const bool triangles : { true, false })
  {
    const auto make = [&](int order, const char* name)
    {
      vtkNew<vtkSurfaceSubdivision> filter;
      triangles ? filter->SetSchemeToLoop() : filter->SetSchemeToCatmullClark();
      SetOrder(filter, order);
      UpdateInSilence(filter, bezier_tools::ToSurface(bezier_tools::MakeSheet(3, triangles, 0.2)));
      EXPECT_NE(filter->GetUnstructuredGridOutput()->GetPointData()->GetArray(name), nullptr);
      return Grid(filter->GetUnstructuredGridOutput());
    };
    const Grid six = make(6, "Scalar");
    ExpectSubset(make(2, "Scalar"), six);
    ExpectSubset(make(3, "Scalar"), six);
  }
}

/// Marks, semi-sharp creases and control values of interpolation are those of the level.
TEST(CurvedCells, NodesBetweenLevelsFollowAllRules)
{
  const Grid input = MakeUprightMixed();
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("sharp");
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    sharpness->InsertNextValue(static_cast<double>(c % 3) * 0.7);
  }
  input->GetCellData()->AddArray(sharpness);
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.8);
  const Configure ways[] = { [](Filter* f)
    { f->SetInputArrayToProcess(4, 0, 0, vtkDataObject::CELL, "sharp"); },
    [&](Filter* f)
    {
      f->MarkByFunctionOn();
      f->SetMarkFunction(sphere);
    },
    [](Filter* f)
    {
      f->InterpolatePointsOn();
      f->InterpolateArraysOn();
    },
    [](Filter* f) { f->DetectFeaturesOn(); } };
  for (const Configure& way : ways)
  {
    for (const int levels : { 0, 1 })
    {
      int moved = 0;
      const Grid six = MakeCurved(input, 6, levels, way, &moved);
      int others = 0;
      const Grid two = MakeCurved(input, 2, levels, way, &others);
      ExpectConforming(six);
      ExpectSameNodes(two, six, moved + others > 0);
    }
  }
}

TEST(CurvedCells, OrdersBetweenLevelsSayWhatTheyCannot)
{
  const auto expect = [](const Configure& configure, const char* text)
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    const Grid input = MakeUprightMixed();
    vtkNew<vtkDoubleArray> materials;
    materials->SetName("MaterialId");
    materials->SetNumberOfTuples(input->GetNumberOfCells());
    materials->Fill(1.);
    input->GetCellData()->AddArray(materials);
    filter->SetInputData(input);
    SetOrder(filter, 3);
    configure(filter);
    filter->Update();
    ASSERT_GE(messages->Errors.size(), 1u) << text;
    EXPECT_NE(messages->Errors[0].find(text), std::string::npos) << messages->Errors[0];
    EXPECT_LE(messages->Errors.size(), 2u); // the pipeline tells, too
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  };
  expect(
    [](Filter* f)
    {
      f->PreserveInterfacesOn();
      f->SetInterfaceValuesToDiscontinuous();
    },
    "CellOrder 3 is for one process and for values that do not jump");
  vtkNew<Messages> messages;
  Execute(
    MakeUprightMixed(), 0,
    [](Filter* f)
    {
      SetOrder(f, 3);
      f->GenerateLimitNormalsOn();
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("Nodes of CellOrder 3, 5 and 6 have no normals"), 1);
}

/// Octahedra of the tet/oct scheme are cut around the same diagonals as in linear cells.
TEST(CurvedCells, OctahedraAreCutAsInLinearCells)
{
  const Grid input = MakeUprightMixed();
  for (const int scheme : { Filter::TET_OCT, Filter::HYBRID })
  {
    const Configure configure = [scheme](Filter* filter)
    {
      filter->SetVolumeScheme(scheme);
      filter->ProjectToLimitOn();
    };
    for (const int order : { 0, 4 })
    {
      const Grid linear = Execute(input, 2, configure);
      const Grid curved = MakeCurved(input, order, 2, configure);
      ASSERT_EQ(curved->GetNumberOfCells(), linear->GetNumberOfCells());
      for (vtkIdType c = 0; c < curved->GetNumberOfCells(); ++c)
      {
        for (vtkIdType i = 0; i < linear->GetCell(c)->GetNumberOfPoints(); ++i)
        {
          const Point a = GetPoint(linear, GetCell(linear, c)[static_cast<std::size_t>(i)]);
          const Point b = GetPoint(curved, GetCell(curved, c)[static_cast<std::size_t>(i)]);
          for (int k = 0; k < 3; ++k)
          {
            ASSERT_NEAR(a[k], b[k], 1e-13) << c;
          }
        }
      }
    }
  }
}

/// Nothing but what is needed is left of the finer level.
TEST(CurvedCells, DimensionsAndPrecision)
{
  const Grid input = MakeUprightMixed();
  const Grid lines = MakeCurved(input, 0, 1,
    [](Filter* filter)
    {
      filter->ClearOutputDimensions();
      filter->AddOutputDimension(1);
      filter->Use32BitIdsOn();
      filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    });
  EXPECT_EQ(lines->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_FALSE(lines->GetCells()->IsStorage64Bit());
  std::set<vtkIdType> used;
  for (vtkIdType c = 0; c < lines->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(lines->GetCellType(c), VTK_QUADRATIC_EDGE);
    const Ids ids = GetCell(lines, c);
    used.insert(ids.begin(), ids.end());
  }
  EXPECT_EQ(static_cast<vtkIdType>(used.size()), lines->GetNumberOfPoints());
}
