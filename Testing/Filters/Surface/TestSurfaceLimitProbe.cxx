// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceLimitProbe.cxx
 * Nearest places on the limits of vtkSurfaceSubdivision: no point of a fine level is nearer, known
 * places are found again, and the places are those of EvaluateLimit.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "PlaceTools.h"
#include "SurfacePlaceTools.h"

#include "vtkCellLocator.h"
#include "vtkSubdivisionLimitProbe.h"

using namespace surfacetools;

namespace
{

using ProbeFilter = vtkSubdivisionLimitProbe;

/// Sets up a probe or a filter of surfaces alike.
struct Rules
{
  bool ModifiedBoundary = true;
  bool HasSharpness = false;

  template <typename FilterPointer>
  void Set(const FilterPointer& filter) const
  {
    filter->SetModifiedBoundary(this->ModifiedBoundary);
    if (this->HasSharpness)
    {
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    }
  }
};

/// The probe's name of a scheme of surfaces.
int GetScheme(int scheme)
{
  return scheme == Filter::LOOP ? ProbeFilter::LOOP : ProbeFilter::CATMULL_CLARK;
}

/// What the probe finds. Places in cells that were not cut have to be those of EvaluateLimit.
vtkSmartPointer<vtkPolyData> Probe(
  vtkDataSet* input, int scheme, const std::vector<Point>& targets, const Rules& rules = Rules())
{
  vtkNew<ProbeFilter> filter;
  filter->SetInputDataObject(input);
  filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
  filter->SetScheme(GetScheme(scheme));
  rules.Set(filter.Get());
  filter->Update();
  const auto found = vtkSmartPointer<vtkPolyData>::New();
  found->ShallowCopy(filter->GetOutput());
  EXPECT_EQ(found->GetNumberOfPoints(), static_cast<vtkIdType>(targets.size()));
  vtkDataArray* cells = found->GetPointData()->GetArray("CellId");
  Places places;
  std::vector<vtkIdType> whole;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    const Point parameters = GetTuple(found, "CellParameters", i);
    if (parameters[0] != -1.)
    {
      places.Add(static_cast<vtkIdType>(cells->GetComponent(i, 0)), parameters);
      whole.push_back(i);
    }
    const Point p = GetPoint(found, i);
    const Point& x = targets[static_cast<std::size_t>(i)];
    EXPECT_NEAR(
      std::hypot(p[0] - x[0], p[1] - x[1], p[2] - x[2]), GetTuple(found, "Distance", i)[0], 1e-12)
      << i;
  }
  vtkNew<Filter> evaluator;
  evaluator->SetInputData(input);
  evaluator->SetScheme(scheme);
  rules.Set(evaluator.Get());
  const auto again = Evaluate(evaluator.Get(), places);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    EXPECT_LT(GetDistance(GetPoint(again, at), GetPoint(found, whole[i])), 1e-12) << whole[i];
    EXPECT_LT(
      GetDistance(GetTuple(again, "DerivativeU", at), GetTuple(found, "DerivativeU", whole[i])),
      1e-12)
      << whole[i];
  }
  return found;
}

/// The polygons of a surface as triangles around their first corners, and its lines.
vtkSmartPointer<vtkPolyData> CutQuads(vtkPolyData* surface)
{
  const auto cut = vtkSmartPointer<vtkPolyData>::New();
  cut->SetPoints(surface->GetPoints());
  cut->SetLines(surface->GetLines());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetPolys()->GetNumberOfCells(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
    {
      triangles->InsertNextCell({ ids->GetId(0), ids->GetId(k - 1), ids->GetId(k) });
    }
  }
  cut->SetPolys(triangles);
  return cut;
}

/// Random points around a surface are compared with its level 7 on the limit, whose triangles are
/// so near to it.
void CheckAgainstFineLevel(
  vtkPolyData* input, int scheme, int size, const Rules& rules = Rules(), int levels = 7)
{
  double bounds[6];
  input->GetBounds(bounds);
  std::mt19937 random(5);
  std::vector<Point> targets;
  for (int i = 0; i < size; ++i)
  {
    Point p;
    for (int c = 0; c < 3; ++c)
    {
      const double at = 1.4 * (random() / 4294967296.) - 0.2;
      p[c] = bounds[2 * c] + at * (bounds[2 * c + 1] - bounds[2 * c]);
    }
    targets.push_back(p);
  }
  const auto found = Probe(input, scheme, targets, rules);
  const auto fine =
    CutQuads(RunFilter(input, scheme, levels, true, [&](Filter* filter) { rules.Set(filter); }));
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(fine);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < size; ++i)
  {
    Point nearest;
    vtkIdType cell = -1;
    int part = 0;
    double distance2 = 0.;
    locator->FindClosestPoint(
      targets[static_cast<std::size_t>(i)].data(), nearest.data(), cell, part, distance2);
    EXPECT_NEAR(GetTuple(found, "Distance", i)[0], std::sqrt(distance2), 2e-4) << i;
  }
}

}

TEST(SurfaceLimitProbe, RandomPointsAgainstLevelSeven)
{
  for (const int scheme : PlaceSchemes)
  {
    SCOPED_TRACE(scheme);
    CheckAgainstFineLevel(MakeInput(MakeBumpySheet(3, scheme == Filter::LOOP, false)), scheme, 60);
    CheckAgainstFineLevel(
      MakeInput(MakeStar(5, scheme == Filter::LOOP)), scheme, 60, { false, false });
  }
}

TEST(SurfaceLimitProbe, CreasesAgainstLevelSeven)
{
  for (const int scheme : PlaceSchemes)
  {
    SCOPED_TRACE(scheme);
    const Model model = MakeBumpySheet(4, scheme == Filter::LOOP, true);
    CheckAgainstFineLevel(
      MakeCreasedInput(model, "Singular", [](vtkIdType) { return 1.; }), scheme, 50);
    CheckAgainstFineLevel(MakeCreasedInput(model, "Sharpness",
                            [](vtkIdType cell) { return cell % 2 == 0 ? 1.7 : 0.6; }),
      scheme, 50, { true, true });
  }
}

/// Triangles, pentagons and quads beside each other become quads; parts of faces meet at edges.
TEST(SurfaceLimitProbe, PolygonsThatAreNoQuads)
{
  for (const char* name : { "pentagon and triangle", "cube" })
  {
    auto zoo = MakeZoo(false);
    SCOPED_TRACE(name);
    CheckAgainstFineLevel(MakeInput(zoo[name]), Filter::CATMULL_CLARK, 60, Rules(), 6);
  }
  // Triangles of a cut quad have no parameters of their own.
  const auto input = MakeInput(MakeZoo(false)["cube"]);
  const auto found = Probe(input, Filter::LOOP, { { 0.2, 0.3, 2. } });
  EXPECT_EQ(GetTuple(found, "CellParameters", 0), (Point{ -1., -1., -1. }));
}

/// Places that were moved along the normal are found again, also next to extraordinary vertices,
/// edges, boundaries and creases.
TEST(SurfaceLimitProbe, FootPoints)
{
  const std::vector<Point> parameters = { { 0.3, 0.4, 0. }, { 0.003, 0.4, 0. }, { 0.4, 0.003, 0. },
    { 1e-4, 2e-4, 0. }, { 0.5, 0.497, 0. } };
  for (const int scheme : PlaceSchemes)
  {
    for (const int kind : { 0, 1, 2 })
    {
      SCOPED_TRACE(testing::Message() << scheme << " " << kind);
      const bool triangles = scheme == Filter::LOOP;
      const auto input = kind == 2 ? MakeCreasedInput(MakeBumpySheet(5, triangles, true),
                                       "Singular", [](vtkIdType) { return 1.; })
                                   : MakeInput(MakeStar(kind == 0 ? 3 : 6, triangles));
      Places places;
      for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
      {
        for (const Point& p : parameters)
        {
          // Next to irregular vertices of creases derivatives have no meaning.
          const bool isKnown = kind != 2 || p[0] > 1e-3;
          if (isKnown && input->GetCellType(cell) != VTK_LINE)
          {
            places.Add(cell, p);
          }
        }
      }
      const auto at = Evaluate(input, scheme, places);
      std::vector<Point> targets;
      // Next to extraordinary vertices radii of curvature may be small.
      const auto getOffset = [&](vtkIdType i)
      { return places.Parameters->GetComponent(i, 0) < 1e-3 ? 1e-6 : 2e-3; };
      for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
      {
        Point p = GetPoint(at, i);
        const Point normal = GetTuple(at, "LimitNormals", i);
        for (int c = 0; c < 3; ++c)
        {
          p[c] += getOffset(i) * normal[c];
        }
        targets.push_back(p);
      }
      const auto found = Probe(input, scheme, targets);
      for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
      {
        EXPECT_NEAR(GetTuple(found, "Distance", i)[0], getOffset(i), 1e-9) << i;
        EXPECT_LT(GetDistance(GetPoint(found, i), GetPoint(at, i)), 1e-7) << i;
      }
    }
  }
}

/// Lines and vertices are searched; grids keep cell ids.
TEST(SurfaceLimitProbe, LinesVerticesAndGrids)
{
  for (const int scheme : PlaceSchemes)
  {
    SCOPED_TRACE(scheme);
    Model model = MakeBumpySheet(4, scheme == Filter::LOOP, false);
    const auto size = static_cast<vtkIdType>(model.Points.size());
    for (int i = 0; i < 5; ++i)
    {
      model.Points.push_back({ 0.5 * i, 0.3 * i * i, 20. });
    }
    model.Lines = { { size, size + 1 }, { size + 2, size + 1 }, { size + 2, size + 3 } };
    const auto input = MakeInput(model);
    Places places;
    std::vector<Point> targets;
    for (vtkIdType line = 0; line < 3; ++line)
    {
      for (const double t : { 0.1, 0.45, 0.8 })
      {
        places.Add(line, { t, 0., 0. });
      }
    }
    const auto at = Evaluate(input, scheme, places);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      targets.push_back(GetPoint(at, i));
      targets.back()[2] += 0.1;
    }
    const auto found = Probe(input, scheme, targets);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      EXPECT_LT(GetDistance(GetPoint(found, i), GetPoint(at, i)), 1e-8) << i;
      EXPECT_EQ(GetTuple(found, "CellId", i)[0], static_cast<double>(i / 3));
    }
    // The same as a grid in another order, with a vertex.
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(input->GetPoints());
    grid->Allocate();
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = input->GetNumberOfCells(); cell-- > 0;)
    {
      input->GetCellPoints(cell, ids);
      grid->InsertNextCell(input->GetCellType(cell), ids);
    }
    const vtkIdType vertex = size + 4;
    grid->InsertNextCell(VTK_VERTEX, 1, &vertex);
    Point alone;
    grid->GetPoint(vertex, alone.data());
    targets.push_back(alone);
    const auto ofGrid = Probe(grid, scheme, targets);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      EXPECT_EQ(GetTuple(ofGrid, "CellId", i)[0],
        static_cast<double>(input->GetNumberOfCells() - 1) - GetTuple(found, "CellId", i)[0]);
    }
    EXPECT_EQ(GetTuple(ofGrid, "CellId", places.GetSize())[0],
      static_cast<double>(input->GetNumberOfCells()));
    EXPECT_EQ(GetTuple(ofGrid, "Distance", places.GetSize())[0], 0.);
  }
}

/// Seams are crossed, as points follow the mesh in which they are joined.
TEST(SurfaceLimitProbe, SeamsAreCrossed)
{
  for (const int scheme : PlaceSchemes)
  {
    CheckAgainstFineLevel(MakeSeamedSheet(scheme == Filter::LOOP), scheme, 60);
  }
}

TEST(SurfaceLimitProbe, Errors)
{
  const auto input = MakeInput(MakeZoo(false)["cube"]);
  vtkNew<ProbeFilter> filter;
  filter->SetSchemeToCatmullClark();
  filter->SetInputDataObject(input);
  vtkNew<multi_dimensional_subdivision_tools::Messages> messages;
  messages->Watch(filter);
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0., 0., 0.);
  nothing->SetPoints(points);
  filter->SetInputDataObject(nothing);
  filter->SetInputDataObject(3, place_tools::MakeTargets({ { 0., 0., 0. } }));
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("no cells"), std::string::npos) << messages->Errors[0];
}

/// A place that is not finite has no results; all others have those that they have without it.
TEST(SurfaceLimitProbe, MissingPlaces)
{
  const std::vector<Point> known = { { 0.2, 0.3, 2. }, { 1e300, 1e300, 0. }, { -3., 0.1, 0.2 } };
  const std::vector<Point> all = { known[0], { std::nan(""), 0., 0. }, known[1],
    { 0., std::numeric_limits<double>::infinity(), 0. }, known[2] };
  for (const int scheme : { ProbeFilter::LOOP, ProbeFilter::CATMULL_CLARK })
  {
    SCOPED_TRACE(scheme);
    vtkNew<ProbeFilter> filter;
    filter->SetScheme(scheme);
    filter->SetInputDataObject(MakeInput(MakeZoo(false)["cube"]));
    vtkNew<multi_dimensional_subdivision_tools::Messages> messages;
    messages->Watch(filter);
    const auto probe = [&](const std::vector<Point>& targets)
    {
      filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
      filter->Update();
      vtkNew<vtkPolyData> found;
      found->DeepCopy(filter->GetOutput());
      EXPECT_EQ(found->GetNumberOfPoints(), static_cast<vtkIdType>(targets.size()));
      return vtkSmartPointer<vtkPolyData>(found);
    };
    const auto with = probe(all);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(messages->CountWarnings(
                "2 places have coordinates that are not finite; the first is place 1"),
      1);
    const auto without = probe(known);
    for (vtkIdType i = 0; i < 5; ++i)
    {
      EXPECT_EQ(std::isnan(with->GetPoint(i)[0]), i % 2 == 1) << i;
      EXPECT_EQ(with->GetPointData()->GetArray("CellId")->GetComponent(i, 0) < 0., i % 2 == 1) << i;
      for (const char* name : { "Distance", "CellParameters", "DerivativeU", "LimitNormals" })
      {
        const double value = with->GetPointData()->GetArray(name)->GetComponent(i, 0);
        EXPECT_EQ(std::isnan(value), i % 2 == 1) << name << i;
        if (i % 2 == 0)
        {
          EXPECT_EQ(value, without->GetPointData()->GetArray(name)->GetComponent(i / 2, 0))
            << name << i;
        }
      }
    }
    EXPECT_NEAR(
      with->GetPointData()->GetArray("Distance")->GetComponent(2, 0) / 1e300, std::sqrt(2.), 1e-12);
  }
}
