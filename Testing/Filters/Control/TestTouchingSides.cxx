// SPDX-License-Identifier: BSD-3-Clause
// JoinSides: pieces of a surface that are closed together share the points where they touch, and
// all others stay as they are.
#include "MultiDimensionalSubdivisionTools.h"

#include "Private/Control/TouchingSides.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSubdivisionOperator.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"

using namespace multi_dimensional_subdivision_tools;
using subdivision::FindTouchingSides;

namespace
{

using Main = vtkMultiDimensionalSubdivision;
using OfSurfaces = vtkSurfaceSubdivision;

struct Mesh
{
  std::vector<Point> Points;
  std::vector<Cell> Cells;
};

/// The mesh with points of their own for faces of different pieces, or, without `pieces`, for each.
Mesh Part(const Mesh& mesh, const std::vector<int>& pieces = {})
{
  Mesh parted;
  std::map<std::pair<std::size_t, vtkIdType>, vtkIdType> ids;
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    Cell cell = mesh.Cells[c];
    const std::size_t piece = pieces.empty() ? c : static_cast<std::size_t>(pieces[c]);
    for (vtkIdType& id : cell.Points)
    {
      const auto next = static_cast<vtkIdType>(parted.Points.size());
      const auto [at, isNew] = ids.emplace(std::pair(piece, id), next);
      if (isNew)
      {
        parted.Points.push_back(mesh.Points[static_cast<std::size_t>(id)]);
      }
      id = at->second;
    }
    parted.Cells.push_back(cell);
  }
  return parted;
}

/// The points of a box in the order in which faces use them, so that joined ones have these ids.
Mesh MakeBox()
{
  return { { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1.5 }, { 1, 0, 1.5 },
             { 1, 1, 1.5 }, { 0, 1, 1.5 } },
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 4, 5, 6, 7 } }, { VTK_QUAD, { 0, 3, 5, 4 } },
      { VTK_QUAD, { 1, 7, 6, 2 } }, { VTK_QUAD, { 0, 4, 7, 1 } }, { VTK_QUAD, { 3, 2, 6, 5 } } } };
}

/// A grid of quads, bent by `height`; of its edges between rows 1 and 2 the first `crack` ones are
/// doubled, and the points between them.
Mesh MakePlate(int size, int crack, double height = 0.)
{
  Mesh plate;
  const int width = size + 1;
  for (int i = 0; i < width * width; ++i)
  {
    plate.Points.push_back({ double(i % width), double(i / width), height * (i % width) });
  }
  const auto lip = static_cast<vtkIdType>(plate.Points.size());
  for (int i = 0; i < (crack == size ? width : crack); ++i)
  {
    plate.Points.push_back(plate.Points[static_cast<std::size_t>(width + i)]);
  }
  for (int q = 0; q < size * size; ++q)
  {
    const vtkIdType i = q / size * width + q % size;
    Cell quad = { VTK_QUAD, { i, i + 1, i + width + 1, i + width } };
    for (vtkIdType& id : quad.Points)
    {
      const vtkIdType copy = lip + id - width;
      const bool isLip =
        q / size == 0 && id >= width && copy < static_cast<vtkIdType>(plate.Points.size());
      id = isLip ? copy : id;
    }
    plate.Cells.push_back(quad);
  }
  return plate;
}

Grid ToGrid(const Mesh& mesh)
{
  return MakeGrid(mesh.Points, mesh.Cells);
}

vtkSmartPointer<vtkPolyData> ToSurface(const Mesh& mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polys;
  for (const Cell& cell : mesh.Cells)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  surface->SetPoints(ToGrid(mesh)->GetPoints());
  surface->SetPolys(polys);
  return surface;
}

/// Adds texture coordinates of which the first one is `value` of the point.
void AddTexture(vtkPointSet* mesh, const std::function<double(vtkIdType)>& value)
{
  vtkNew<vtkDoubleArray> texture;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    texture->InsertNextTuple2(value(i), mesh->GetPoint(i)[1]);
  }
  mesh->GetPointData()->SetTCoords(texture);
}

std::size_t CountPairs(const Mesh& mesh)
{
  return FindTouchingSides(ToGrid(mesh)).size();
}

/// The output, after warnings that go to `messages`.
template <typename FilterClass>
vtkSmartPointer<vtkPointSet> RunOn(vtkDataObject* input, int levels,
  const std::function<void(FilterClass*)>& configure = {}, Messages* messages = nullptr)
{
  vtkNew<FilterClass> filter;
  filter->SetNumberOfLevels(levels);
  if (configure)
  {
    configure(filter);
  }
  UpdateInSilence(filter, input, messages);
  return filter->GetOutput();
}

/// The coordinates of all points, in order.
std::vector<Point> ListPlaces(vtkPointSet* mesh)
{
  std::vector<Point> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    places.push_back(GetPoint(mesh, i));
    for (double& x : places.back())
    {
      x = std::round(x * 1e9) / 1e9 + 0.;
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Expects of a parted mesh what the whole one becomes, by several filters in a row, too.
template <typename FilterClass>
void CheckJoined(vtkDataObject* whole, vtkDataObject* parted,
  const std::function<void(FilterClass*)>& configure = {})
{
  const auto expected = ListPlaces(RunOn<FilterClass>(whole, 2, configure));
  EXPECT_EQ(ListPlaces(RunOn<FilterClass>(parted, 2, configure)), expected);
  const auto first = RunOn<FilterClass>(parted, 1, configure);
  EXPECT_EQ(ListPlaces(RunOn<FilterClass>(first, 1, configure)), expected);
}

}

TEST(TouchingSides, PiecesThatAreClosedTogetherAreOneSurface)
{
  const Mesh box = MakeBox();
  const Mesh sides = Part(box);
  EXPECT_EQ(CountPairs(sides), 24u);
  EXPECT_EQ(CountPairs(Part(box, { 0, 0, 1, 1, 1, 1 })), 16u); // a tube and both ends
  CheckJoined<Main>(ToSurface(box), ToSurface(sides));
  CheckJoined<Main>(ToGrid(box), ToGrid(sides));
  for (int scheme = OfSurfaces::LOOP; scheme <= OfSurfaces::AUTOMATIC; ++scheme)
  {
    SCOPED_TRACE(scheme);
    CheckJoined<OfSurfaces>(ToSurface(box), ToSurface(sides),
      [scheme](OfSurfaces* filter) { filter->SetScheme(scheme); });
  }
}

TEST(TouchingSides, TrianglesThatAreAllApartAreOneSurface)
{
  for (const bool isClosed : { false, true })
  {
    Mesh whole = Part(MakePlate(3, 0, 0.5), std::vector<int>(9)); // in the order of first use
    if (isClosed)
    {
      whole = MakeBox();
      whole.Cells.pop_back();
      whole.Cells.insert(
        whole.Cells.end(), { { VTK_TRIANGLE, { 3, 2, 6 } }, { VTK_TRIANGLE, { 6, 5, 3 } } });
    }
    CheckJoined<Main>(ToSurface(whole), ToSurface(Part(whole)));
    CheckJoined<OfSurfaces>(ToSurface(whole), ToSurface(Part(whole)));
  }
}

TEST(TouchingSides, SourcesOfVtkAreClosed)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(4); // larger polygons are cut, and told
  for (vtkPolyDataAlgorithm* source :
    { static_cast<vtkPolyDataAlgorithm*>(cube), static_cast<vtkPolyDataAlgorithm*>(cylinder) })
  {
    source->Update();
    source->GetOutput()->GetPointData()->SetTCoords(nullptr);
    const auto row = RunOn<Main>(RunOn<Main>(source->GetOutput(), 1), 1);
    const auto at_once = RunOn<Main>(source->GetOutput(), 2);
    EXPECT_EQ(ListPlaces(row), ListPlaces(at_once));
    // Euler's number of a sphere: each edge has two faces.
    vtkNew<vtkIdList> corners;
    vtkIdType edges = 0;
    for (vtkIdType c = 0; c < at_once->GetNumberOfCells(); ++c)
    {
      at_once->GetCellPoints(c, corners);
      edges += corners->GetNumberOfIds();
    }
    EXPECT_EQ(at_once->GetNumberOfPoints() - edges / 2 + at_once->GetNumberOfCells(), 2);
  }
}

TEST(TouchingSides, CracksOfAnyLengthStay)
{
  for (int crack = 1; crack <= 4; ++crack)
  {
    SCOPED_TRACE(crack);
    EXPECT_EQ(CountPairs(MakePlate(4, crack)), 0u);
  }
  // A crack in one side of a box, which else is closed: no part of it is joined.
  Mesh box = MakeBox();
  const auto inner = static_cast<vtkIdType>(box.Points.size());
  box.Points.insert(box.Points.end(),
    { { .2, .5, 0 }, { .4, .5, 0 }, { .6, .5, 0 }, { .8, .5, 0 }, { .4, .5, 0 }, { .6, .5, 0 } });
  const auto add = [&](const Ids& ids) { box.Cells.push_back({ VTK_POLYGON, ids }); };
  const vtkIdType a = inner;
  box.Cells.erase(box.Cells.begin());
  add({ 1, 2, a + 3, a + 2, a + 1, a });
  add({ 3, 0, a, a + 4, a + 5, a + 3 });
  add({ 0, 1, a });
  add({ 2, 3, a + 3 });
  EXPECT_EQ(CountPairs(Part(box, { 0, 1, 2, 3, 4, 5, 5, 5, 5 })), 0u);
  std::replace(box.Cells[6].Points.begin(), box.Cells[6].Points.end(), a + 4, a + 1);
  std::replace(box.Cells[6].Points.begin(), box.Cells[6].Points.end(), a + 5, a + 2);
  EXPECT_GT(CountPairs(Part(box, { 0, 1, 2, 3, 4, 5, 5, 5, 5 })), 0u);
}

TEST(TouchingSides, AnEdgeOfThreeFacesLeavesTheObjectApart)
{
  Mesh box = MakeBox();
  EXPECT_GT(CountPairs(Part(box)), 0u);
  box.Points.push_back({ -1, -1, 0 });
  box.Cells.push_back({ VTK_TRIANGLE, { 0, 1, 8 } });
  EXPECT_EQ(CountPairs(Part(box)), 0u);
  box.Cells.back().Points = { 0, 7, 8 }; // touches at points only
  EXPECT_EQ(CountPairs(Part(box)), 24u);
}

TEST(TouchingSides, SheetsThatLieOnEachOtherStayApart)
{
  const auto count = [](double height)
  {
    Mesh sheets = MakePlate(2, 0);
    const std::vector<Cell> cells = sheets.Cells;
    sheets.Cells.insert(sheets.Cells.end(), cells.begin(), cells.end());
    Mesh parted = Part(sheets, { 0, 0, 0, 0, 1, 1, 1, 1 });
    for (std::size_t i = 9; i < parted.Points.size(); ++i) // the second sheet
    {
      Point& p = parted.Points[i];
      p[2] = p[0] == 1. && p[1] == 1. ? height : 0.; // in the middle
    }
    return CountPairs(parted);
  };
  EXPECT_EQ(count(0.), 0u);
  EXPECT_EQ(count(0.001), 0u);
  EXPECT_EQ(count(0.5), 16u); // a lens: the edges of the rim
  // The same triangle twice.
  EXPECT_EQ(CountPairs(Part({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
              { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 1 } } } })),
    0u);
}

TEST(TouchingSides, OtherPartsStayApart)
{
  const std::vector<Point> places = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 }, { 2, 2, 2 } };
  const auto countApart = [&](const std::vector<Cell>& cells)
  { return CountPairs(Part({ places, cells })); };
  const Cell a = { VTK_TRIANGLE, { 0, 1, 2 } };
  const Cell b = { VTK_TRIANGLE, { 1, 0, 3 } };
  EXPECT_EQ(countApart({ a, b }), 2u);
  EXPECT_EQ(countApart({ a, b, { VTK_TETRA, { 0, 1, 4, 5 } } }), 0u); // a solid anywhere
  EXPECT_EQ(countApart({ a, { VTK_TRIANGLE, { 0, 3, 5 } } }), 0u);    // they touch at a point
  EXPECT_EQ(countApart({ { VTK_LINE, { 0, 3 } }, { VTK_LINE, { 0, 4 } } }), 0u);
  Mesh near = Part({ places, { a, b } });
  near.Points[0][0] = -0.;
  EXPECT_EQ(CountPairs(near), 2u);
  near.Points[0][0] = 1e-300;
  EXPECT_EQ(CountPairs(near), 0u);
  near.Points[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CountPairs(near), 0u);
  Mesh strip = { places, { { VTK_QUAD, { 0, 4, 1, 2 } }, b } }; // two points of a face in one place
  strip.Points[4] = places[0];
  EXPECT_EQ(CountPairs(Part(strip)), 0u);
  EXPECT_EQ(CountPairs(MakePlate(3, 0)), 0u);
  EXPECT_EQ(CountPairs({}), 0u);
}

TEST(TouchingSides, ASeamNeedsTextureCoordinatesThatDiffer)
{
  // A box whose sides around it are one strip: its first and last edge are in one place.
  Mesh box = MakeBox();
  box.Points.insert(box.Points.end(), { box.Points[0], box.Points[4] });
  box.Cells[2].Points = { 8, 3, 5, 9 };
  const Grid grid = ToGrid(Part(box, { 0, 1, 2, 2, 2, 2 }));
  EXPECT_TRUE(FindTouchingSides(grid).empty());
  AddTexture(grid, [&](vtkIdType) { return 1.; });
  EXPECT_TRUE(FindTouchingSides(grid).empty());
  AddTexture(grid, [&](vtkIdType i) { return static_cast<double>(i); });
  EXPECT_EQ(FindTouchingSides(grid).size(), 18u);
}

TEST(TouchingSides, TextureCoordinatesThatDifferAreToldAndLeftOut)
{
  const auto sides = ToSurface(Part(MakeBox()));
  AddTexture(sides, [](vtkIdType i) { return static_cast<double>(i % 4); });
  vtkNew<Messages> messages;
  // The main filter keeps them, but not with all options: TestTouchingSeams.cxx.
  const auto output =
    RunOn<Main>(sides, 1, [](Main* filter) { filter->SetOutputCellsToQuadratic(); }, messages);
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("JoinSides: points that become one differ in the texture "
                                    "coordinates \"texture\" ("),
    1);
  EXPECT_EQ(messages->CountWarnings("or switch MergePoints on, and set MergedValues to Keep."), 1);
  EXPECT_FALSE(output->GetPointData()->HasArray("texture"));
  // JoinSeams keeps both sides, and the shape is the same.
  const auto choose = [](OfSurfaces* filter) { filter->SetSchemeToCatmullClark(); };
  const auto seams = RunOn<OfSurfaces>(sides, 1, choose);
  EXPECT_TRUE(seams->GetPointData()->HasArray("texture"));
  auto places = ListPlaces(seams);
  EXPECT_EQ(places.size(), 54u);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  EXPECT_EQ(places, ListPlaces(RunOn<OfSurfaces>(ToSurface(MakeBox()), 1, choose)));
}

TEST(TouchingSides, ValuesDoNotDecideAndAreThoseOfTheFirstOrTheMean)
{
  const auto sides = ToSurface(Part(MakeBox()));
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < sides->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i / 4));
  }
  sides->GetPointData()->AddArray(values);
  const auto expectFirst = [&](int rule, double first, int warnings)
  {
    vtkNew<Messages> messages;
    const auto output =
      RunOn<Main>(sides, 0, [rule](Main* filter) { filter->SetMergedValues(rule); }, messages);
    EXPECT_EQ(output->GetNumberOfPoints(), 8);
    EXPECT_EQ(output->GetPointData()->GetArray("values")->GetComponent(0, 0), first);
    EXPECT_EQ(
      messages->CountWarnings("JoinSides: points that become one differ in \"values\""), warnings);
  };
  expectFirst(Main::FIRST_VALUE, 0., 1);
  expectFirst(Main::AVERAGE_VALUE, 2., 0); // of the sides 0, 2 and 4
  expectFirst(Main::KEEP_VALUES, 0., 1);
}

TEST(TouchingSides, CopiesOfPointsAndIdsThatBlocksShareStay)
{
  const auto sides = ToSurface(Part(MakeBox()));
  const auto count = [&](bool joins, bool hasBlocks)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, sides);
    vtkNew<Main> filter;
    filter->SetNumberOfLevels(0);
    filter->SetJoinSides(joins);
    UpdateInSilence(filter, hasBlocks ? static_cast<vtkDataObject*>(blocks) : sides, nullptr,
      { "An earlier filter made copies", "come apart there" });
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    return vtkPointSet::SafeDownCast(made ? made->GetBlock(0) : filter->GetOutputDataObject(0))
      ->GetNumberOfPoints();
  };
  EXPECT_EQ(count(true, false), 8);
  EXPECT_EQ(count(true, true), 8);
  EXPECT_EQ(count(false, false), 24);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("MaterialPointIds");
  for (vtkIdType i = 0; i < 24; ++i)
  {
    ids->InsertNextValue(i);
  }
  sides->GetPointData()->AddArray(ids);
  EXPECT_EQ(count(true, false), 24);
  sides->GetPointData()->RemoveArray("MaterialPointIds");
  ids->SetName("ids");
  sides->GetPointData()->SetGlobalIds(ids);
  EXPECT_EQ(count(true, false), 8);
  EXPECT_EQ(count(true, true), 24);
}

TEST(TouchingSides, BothMeshesOfADeformationKeepTheirPoints)
{
  const auto rest = ToSurface(Part(MakeBox()));
  Mesh apart = Part(MakeBox());
  for (std::size_t i = 0; i < apart.Points.size(); ++i)
  {
    apart.Points[i][0] += static_cast<double>(i / 4);
  }
  vtkNew<vtkSubdivisionDeformation> filter;
  filter->SetInputDataObject(1, rest);
  filter->SetInputDataObject(2, ToSurface(apart));
  UpdateInSilence(filter, rest, nullptr, { "come apart there", "not inside the subdivided rest" });
  auto* moved = vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(moved->GetNumberOfPoints(), 24);
}

TEST(TouchingSides, SwitchedOffTheyComeApartAndAreTold)
{
  vtkNew<Messages> messages;
  const auto apart = RunOn<Main>(
    ToSurface(Part(MakeBox())), 2, [](Main* filter) { filter->JoinSidesOff(); }, messages);
  EXPECT_NE(ListPlaces(apart), ListPlaces(RunOn<Main>(ToSurface(MakeBox()), 2)));
  EXPECT_EQ(messages->CountWarnings("cells that do not share points come apart there"), 1);
}

TEST(TouchingSides, OperatorsHaveTheRowsOfTheOutput)
{
  const auto sides = ToSurface(Part(MakeBox()));
  AddTexture(sides, [](vtkIdType i) { return static_cast<double>(i % 4); });
  const auto check = [&](auto* filter)
  {
    filter->SetInputDataObject(sides);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->Update();
    vtkNew<vtkSubdivisionOperator> found;
    ASSERT_TRUE(filter->ComputeOperator(found));
    EXPECT_EQ(found->GetNumberOfColumns(), sides->GetNumberOfPoints());
    EXPECT_EQ(found->GetNumberOfRows(), filter->GetOutput()->GetNumberOfPoints());
  };
  check(vtkSmartPointer<Main>::New().Get());
  for (const int scheme : { OfSurfaces::LOOP, OfSurfaces::DOO_SABIN })
  {
    vtkNew<OfSurfaces> filter;
    filter->SetScheme(scheme);
    check(filter.Get());
  }
}

TEST(TouchingSides, FiltersOfLocalRefinementJoinToo)
{
  const auto whole = ToSurface(MakeBox());
  const auto sides = ToSurface(Part(MakeBox()));
  const auto refine = [](auto* filter, vtkDataObject* input)
  {
    filter->SetMaximumLevel(2);
    UpdateInSilence(filter, input);
    return ListPlaces(filter->GetOutput());
  };
  const auto check = [&](auto type)
  {
    using Refinement = std::remove_pointer_t<decltype(type)>;
    EXPECT_EQ(refine(vtkSmartPointer<Refinement>::New().Get(), sides),
      refine(vtkSmartPointer<Refinement>::New().Get(), whole));
  };
  check(static_cast<vtkRedGreenRefinement*>(nullptr));
  check(static_cast<vtkAdaptiveSurfaceSubdivision*>(nullptr));
}
