// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSqrtThreeErrorBounds.cxx
 * GenerateErrorBounds with Scheme = SqrtThree, of which two steps cut edges into thirds.
 */
#include "BezierTools.h"
#include "BoundTools.h"
#include "RandomSurfaces.h"
#include "Turns.h"

#include "Private/Bounds/Deviations.h"
#include "Private/Bounds/PartsAsCells.h"
#include "Private/Bounds/Sectors.h"
#include "Private/Bounds/StepFactors.h"
#include "Private/Bounds/ThirdsReader.h"
#include "Private/Surface/SurfaceSubdivision.h"

using namespace bound_tools;
using bezier_tools::MakeSheet;
using subdivision::ApplyFactors;
using subdivision::Buffer;
using subdivision::NestedPieces;
using subdivision::PartsAsCells;
using subdivision::Sectors;

namespace
{

using Surface = vtkSurfaceSubdivision;
using Surfaces = std::function<void(Surface*)>;
using Weights = std::array<double, 4>;

vtkSmartPointer<vtkPolyData> Make(
  vtkUnstructuredGrid* input, int levels, bool projects, const Surfaces& configure)
{
  vtkNew<Surface> filter;
  filter->SetSchemeToSqrtThree();
  filter->ModifiedBoundaryOff();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  if (configure)
  {
    configure(filter);
  }
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(projects);
  return UpdateWithoutErrors<vtkPolyData>(filter.Get(), input);
}

NestedPieces ReadPieces(vtkUnstructuredGrid* input, int levels, const Surfaces& configure)
{
  return std::move(*subdivision::ReadThirds(
    [&](int steps) { return Make(input, levels + steps, false, configure); }));
}

/// The factors of the operator of so many levels that come after the one with so many rows.
class LastFactors
{
public:
  LastFactors(vtkUnstructuredGrid* input, int levels, bool projects, vtkIdType rows,
    const Surfaces& configure = {})
  {
    vtkNew<Surface> filter;
    filter->SetSchemeToSqrtThree();
    filter->ModifiedBoundaryOff();
    if (configure)
    {
      configure(filter);
    }
    filter->SetNumberOfLevels(levels);
    filter->SetProjectToLimit(projects);
    filter->SetInputData(input);
    this->Factors = GetLastFactors(filter.Get(), levels + (projects ? 1 : 0));
    for (const auto& factor : this->Factors)
    {
      this->Step.push_back(&factor);
      if (factor.GetNumberOfRows() == rows)
      {
        this->Step.clear();
      }
    }
  }
  const Sectors::Step& Get() const { return this->Step; }

private:
  std::vector<subdivision::MatrixFactors::Matrix> Factors;
  Sectors::Step Step;
};

PlacedPoints PlaceAll(const NestedPieces& pieces)
{
  PlacedPoints placed;
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    for (std::size_t i = 0; i < pieces.GetLattice(c).Points.size(); ++i)
    {
      placed[c].push_back({ pieces.GetPoint(pieces.GetFirstPlace(c) + static_cast<vtkIdType>(i)),
        pieces.GetLattice(c).Points[i] });
    }
  }
  return placed;
}

/// The points of the pieces of pieces, as points of the cells that these lie in.
PlacedPoints PlaceAll(const NestedPieces& pieces, const NestedPieces& finer)
{
  struct Piece
  {
    vtkIdType Cell;
    Ids Points;
    std::vector<Weights> Corners;
  };
  std::map<Ids, std::vector<Piece>> found; // by ascending points
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    const NestedPieces::Lattice& lattice = pieces.GetLattice(c);
    for (int p = 0; p < lattice.GetNumberOfPieces(); ++p)
    {
      Piece piece{ c, {}, {} };
      for (int k = 0; k < lattice.Corners; ++k)
      {
        const int point = lattice.Pieces[static_cast<std::size_t>(lattice.Corners * p + k)];
        piece.Points.push_back(pieces.GetPoint(pieces.GetFirstPlace(c) + point));
        piece.Corners.push_back(lattice.Points[static_cast<std::size_t>(point)]);
      }
      Ids sorted = piece.Points;
      std::sort(sorted.begin(), sorted.end());
      found[sorted].push_back(piece);
    }
  }
  PlacedPoints placed;
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    placed[c]; // equal cells have none
  }
  for (const auto& [cell, points] : PlaceAll(finer))
  {
    Ids corners;
    for (int k = 0; k < finer.GetNumberOfCorners(cell); ++k)
    {
      corners.push_back(finer.GetCorner(cell, k));
    }
    Ids sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_FALSE(found[sorted].empty());
    if (found[sorted].size() != 1)
    {
      continue; // two cells with the same corners: whose piece is it?
    }
    const Piece& piece = found[sorted][0];
    for (const PlacedPoint& point : points)
    {
      Weights weights{};
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        const auto at = static_cast<std::size_t>(
          std::find(piece.Points.begin(), piece.Points.end(), corners[k]) - piece.Points.begin());
        for (std::size_t i = 0; i < 4; ++i)
        {
          weights[i] += point.Weights[k] * piece.Corners[at][i];
        }
      }
      placed[piece.Cell].push_back({ point.Point, weights });
    }
  }
  return placed;
}

/// Adds how near bounds are. `isDeep`: looks at 81 times as many places.
void Check(vtkUnstructuredGrid* mesh, int levels, bool projects, const Surfaces& configure,
  bool isDeep, Tightness& tightness)
{
  const Grid input = WithValues(mesh);
  vtkNew<Surface> filter;
  filter->SetSchemeToSqrtThree();
  filter->ModifiedBoundaryOff();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  if (configure)
  {
    configure(filter);
  }
  const auto coarse = UpdateWithBounds(filter.Get(), input, levels, projects);
  const NestedPieces pieces = ReadPieces(input, levels, configure);
  ASSERT_EQ(pieces.GetNumberOfCells(), coarse->GetNumberOfCells());
  const PlacedPoints placed =
    isDeep ? PlaceAll(pieces, ReadPieces(input, levels + 4, configure)) : PlaceAll(pieces);
  const auto fine = Make(input, levels + (isDeep ? 8 : 4), true, configure);
  ExpectBounds(coarse, fine, 0, tightness, 1e-12, &placed);
}

vtkSmartPointer<vtkPointSet> SplitPatch(
  vtkPolyData* patch, int levels, subdivision::MatrixFactors* factors)
{
  subdivision::SurfaceOptions options;
  options.Scheme = subdivision::SurfaceSchemeKind::SqrtThree;
  options.Levels = levels;
  options.Features.ModifiedBoundary = false;
  options.Features.Singular = patch->GetCellData()->GetArray(subdivision::PatchSingularName);
  options.Factors = factors;
  options.Warn = [](const std::string&) {}; // patches of cones over few points may hang
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  const auto made = vtkSmartPointer<vtkPolyData>::New();
  return subdivision::SubdivideSurface(patch, options, made) ? made : nullptr;
}

/// A double cone over a polygon of n sides, all vertices moved.
Grid MakeCones(int n)
{
  std::mt19937 random(static_cast<unsigned>(n));
  const auto draw = [&] { return 0.3 * (random() / 4294967296. - 0.5); };
  std::vector<Point> points{ { draw(), draw(), 1. }, { draw(), draw(), -1. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / n;
    points.push_back({ std::cos(angle) + draw(), std::sin(angle) + draw(), draw() });
    const vtkIdType next = 2 + (i + 1) % n;
    cells.push_back({ VTK_TRIANGLE, { 0, 2 + i, next } });
    cells.push_back({ VTK_TRIANGLE, { 1, next, 2 + i } });
  }
  return MakeGrid(points, cells);
}

/// A sheet with lines that are creases, and one that goes on beyond it.
Grid MakeCreased(unsigned seed)
{
  const Grid sheet = MakeSheet(3, true, 0.1 * seed);
  std::vector<int> flags(static_cast<std::size_t>(sheet->GetNumberOfCells()), 0);
  sheet->GetPointData()->Initialize();
  const vtkIdType outside = sheet->GetPoints()->InsertNextPoint(-1., -1., 0.5);
  for (const auto& ends :
    std::vector<std::array<vtkIdType, 2>>{ { 5, 6 }, { 6, 10 }, { 0, outside } })
  {
    sheet->InsertNextCell(VTK_LINE, 2, ends.data());
    flags.push_back(1);
  }
  const vtkIdType still = 9;
  sheet->InsertNextCell(VTK_VERTEX, 1, &still);
  flags.push_back(1);
  AddCellArray(sheet, "Singular", flags);
  return sheet;
}

Grid MakeRandom(unsigned seed)
{
  std::mt19937 random(seed);
  const surfacetools::Model model = surfacetools::RandomSurface(seed).Get();
  std::vector<Cell> cells;
  std::transform(model.Faces.begin(), model.Faces.end(), std::back_inserter(cells),
    [](const Ids& face) { return Cell{ VTK_TRIANGLE, face }; });
  std::vector<int> flags(cells.size(), 0);
  for (unsigned i = random() % 4; i > 0; --i)
  {
    const Ids& face = model.Faces[random() % model.Faces.size()];
    cells.push_back({ VTK_LINE, { face[0], face[1] } });
  }
  flags.resize(cells.size(), 1);
  const Grid grid = MakeGrid(model.Points, cells);
  AddCellArray(grid, "Singular", flags);
  return grid;
}

/// Compares the values of the parts of cells with those that they have in the whole mesh. Returns
/// how many points were compared.
vtkIdType CompareParts(vtkUnstructuredGrid* input, const Surfaces& configure)
{
  const NestedPieces pieces = ReadPieces(input, 0, configure);
  const NestedPieces finer = ReadPieces(input, 2, configure);
  const LastFactors last(input, 4, false, pieces.GetNumberOfPoints(2), configure);
  const Sectors sectors(pieces, last.Get());
  const auto getValues = [&](int levels)
  {
    const auto mesh = Make(WithValues(input), levels, false, configure);
    vtkDataArray* array = mesh->GetPointData()->GetArray("Two");
    Buffer<double> values(2 * array->GetNumberOfTuples());
    for (vtkIdType i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetComponent(i / 2, static_cast<int>(i % 2));
    }
    return values;
  };
  const Buffer<double> expected = getValues(6);
  const Buffer<double> before = getValues(4);
  // Where each point of a cell is, by its weights of the corners in the mesh after two levels.
  using Place = std::vector<std::pair<vtkIdType, long>>;
  const auto getPlace = [](const Ids& corners, const Weights& weights)
  {
    Place place;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      place.emplace_back(corners[k], std::lround(9. * weights[k]));
    }
    std::sort(place.begin(), place.end());
    return place;
  };
  const auto getCorners = [](const NestedPieces& of, vtkIdType cell)
  {
    Ids corners;
    for (int k = 0; k < of.GetNumberOfCorners(cell); ++k)
    {
      corners.push_back(of.GetCorner(cell, k));
    }
    return corners;
  };
  std::map<Place, vtkIdType> known;
  for (const auto& [cell, points] : PlaceAll(finer))
  {
    for (const PlacedPoint& point : points)
    {
      known[getPlace(getCorners(finer, cell), point.Weights)] = point.Point;
    }
  }
  vtkIdType compared = 0;
  const auto compare = [&](const PartsAsCells::Part& part)
  {
    const auto deeper =
      subdivision::SplitIntoThirds({ pieces, sectors, last.Get() }, { part }, SplitPatch);
    ASSERT_NE(deeper, nullptr);
    const auto made = deeper->Get();
    const vtkIdType wanted = deeper->GetWanted()[0];
    const Buffer<double> second = deeper->Take(2, before, 2);
    const Buffer<double> third = ApplyFactors(made.Last, second, 2);
    const PlacedPoints placed = PlaceAll(made.Pieces);
    Ids corners; // in the mesh after two levels
    const auto& lattice = pieces.GetLattice(part.Cell);
    for (int k = 0; k < lattice.Corners; ++k)
    {
      const auto& corner = deeper->GetCorners()[made.Pieces.GetCorner(wanted, k)];
      corners.push_back(pieces.GetPoint(pieces.GetFirstPlace(corner.Cell) + corner.Point));
    }
    for (const PlacedPoint& point : placed.at(wanted))
    {
      const auto at = known.find(getPlace(corners, point.Weights));
      ASSERT_NE(at, known.end());
      for (int x = 0; x < 2; ++x)
      {
        ASSERT_NEAR(third[2 * point.Point + x], expected[2 * at->second + x], 1e-11) << part.Cell;
      }
      ++compared;
    }
  };
  for (vtkIdType cell = 0; cell < pieces.GetNumberOfCells(); ++cell)
  {
    for (int child = 0; pieces.GetDimension(cell) > 0 &&
      child < static_cast<int>(pieces.GetLattice(cell).Children.size());
      ++child)
    {
      compare({ cell, child });
    }
  }
  return compared;
}

}

/// A flat sheet whose corners stay is kept as it is, so that the points of pieces are where their
/// weights say.
TEST(ThirdsReader, FindsPointsWhereTheyLie)
{
  const Grid sheet = MakeSheet(3, true, 0.);
  std::vector<int> flags(static_cast<std::size_t>(sheet->GetNumberOfCells()), 0);
  const vtkIdType last = sheet->GetNumberOfPoints() - 1;
  for (const vtkIdType corner : { vtkIdType(0), vtkIdType(3), last - 3, last })
  {
    sheet->InsertNextCell(VTK_VERTEX, 1, &corner);
    flags.push_back(1);
  }
  AddCellArray(sheet, "Singular", flags);
  for (const int levels : { 0, 2 })
  {
    const auto coarse = Make(sheet, levels, false, {});
    const auto fine = Make(sheet, levels + 4, false, {});
    const PlacedPoints placed = PlaceAll(ReadPieces(sheet, levels, {}));
    ASSERT_EQ(static_cast<vtkIdType>(placed.size()), coarse->GetNumberOfCells());
    for (const auto& [cell, points] : placed)
    {
      vtkNew<vtkIdList> ids;
      coarse->GetCellPoints(cell, ids);
      std::set<vtkIdType> distinct;
      for (const PlacedPoint& point : points)
      {
        distinct.insert(point.Point);
        Point difference = GetPoint(fine, point.Point);
        for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
        {
          const Point corner = GetPoint(coarse, ids->GetId(k));
          for (std::size_t x = 0; x < 3; ++x)
          {
            difference[x] -= point.Weights[static_cast<std::size_t>(k)] * corner[x];
          }
        }
        ASSERT_NEAR(std::hypot(difference[0], difference[1], difference[2]), 0., 1e-14);
      }
      EXPECT_EQ(distinct.size(), ids->GetNumberOfIds() == 3 ? 55U : 1U);
    }
  }
}

/// Also where a limit depends only a little on a point far away.
TEST(SqrtThreeErrorBounds, HoldForOneValueAfterTheLastStep)
{
  const Grid input = MakeCreased(1);
  const NestedPieces pieces = ReadPieces(input, 0, {});
  const vtkIdType points = pieces.GetNumberOfPoints(3);
  const LastFactors last(input, 4, false, pieces.GetNumberOfPoints(2));
  const LastFactors further(input, 8, true, points);
  const Sectors sectors(pieces, last.Get());
  const PlacedPoints placed = PlaceAll(pieces, ReadPieces(input, 4, {}));
  const auto zeros = [&](int step) { return Buffer<double>(pieces.GetNumberOfPoints(step), 0.); };
  const Buffer<double> shown = zeros(0);
  const Buffer<double> second = zeros(2);
  std::vector<vtkIdType> all(static_cast<std::size_t>(pieces.GetNumberOfCells()));
  std::iota(all.begin(), all.end(), vtkIdType(0));
  int small = 0;
  for (vtkIdType point = 0; point < points; point += 3)
  {
    Buffer<double> third = zeros(3);
    third[point] = 1.;
    const subdivision::BoundedValues values{ 1, shown.data(), shown, second, third,
      [&](const Buffer<double>&) { return zeros(3); }, 0. };
    const auto bounds = subdivision::FindBounds(pieces, sectors, values, all);
    const Buffer<double> limits = ApplyFactors(further.Get(), third, 1);
    for (const auto& [cell, there] : placed)
    {
      double most = 0.;
      for (const PlacedPoint& place : there)
      {
        most = std::max(most, limits[place.Point]);
      }
      ASSERT_LE(most, bounds[cell].Largest) << point << " " << cell;
      small += most > 0. && most < 1e-3 ? 1 : 0;
    }
  }
  EXPECT_GT(small, 100);
}

TEST(PartsInThirds, AreThoseOfAMeshThatIsSplitFurther)
{
  EXPECT_EQ(CompareParts(MakeCreased(2), {}), 18 * 9 * 55 + 3 * 3 * 10);
  // Edges and vertices that have no cell of their own.
  const vtkIdType compared = CompareParts(MakeSheet(3, true, 0.4),
    [](Surface* filter)
    {
      filter->DetectFeaturesOn();
      filter->SetFeatureAngle(15.);
    });
  EXPECT_EQ(compared, 18 * 9 * 55);
}

TEST(SqrtThreeErrorBounds, HoldAndAreNearTheTruth)
{
  for (const bool projects : { false, true })
  {
    Tightness all;
    for (const int n : { 3, 4, 5, 6, 7, 12 })
    {
      Check(MakeCones(n), 0, projects, {}, true, all);
      Check(MakeCones(n), 1, projects, {}, false, all);
    }
    Check(MakeSheet(4, true, 0.3), 0, projects, {}, true, all);
    Check(MakeSheet(4, true, 0.3), 2, projects, {}, false, all);
    std::cout << all.Samples << " places\n";
    ExpectRatios(all, 300, 2.9);
  }
}

TEST(SqrtThreeErrorBounds, HoldWithCreasesAndBoundaries)
{
  Tightness all;
  for (unsigned seed = 1; seed < 5; ++seed)
  {
    Check(
      MakeCreased(seed), seed % 2 == 0 ? 2 : 0, seed > 2,
      [&](Surface* filter) { filter->SetCreaseEnd(static_cast<int>(seed / 2 % 2)); }, false, all);
  }
  ExpectRatios(all, 300, 2.9);
}

TEST(SqrtThreeErrorBounds, AreNearTheTruthOnRandomSurfaces)
{
  Tightness all;
  for (unsigned seed = 1; seed < 60; ++seed)
  {
    if (turns::IsInTurn(seed))
    {
      Check(MakeRandom(seed), seed % 3 == 0 ? 2 : 0, seed % 2 == 0, {}, false, all);
    }
  }
  ExpectRatios(all, turns::GetShare(3000), 2.9);
}

/// Where a value is 1 at one point only its limit may be nearly linear in cells, also at the points
/// of few further steps.
TEST(SqrtThreeErrorBounds, AreNearTheTruthAroundOnePoint)
{
  Tightness all;
  for (const vtkIdType raised : { 0, 4, 40 })
  {
    const Grid sheet = MakeSheet(8, true, 0.);
    double place[3];
    sheet->GetPoint(raised, place);
    place[2] = 1.;
    sheet->GetPoints()->SetPoint(raised, place);
    Check(sheet, 0, false, {}, false, all);
  }
  // 1/1822 of what is found first, and less, is left as it is.
  ExpectRatios(all, 300, 3.);
}

/// Patches that are looked at again may have more cells than the mesh.
TEST(SqrtThreeErrorBounds, NeedNotMoreCellsThanTheMeshOfFourMoreLevels)
{
  const Grid input = WithValues(MakeSheet(4, true, 0.3));
  vtkNew<Surface> filter;
  filter->SetSchemeToSqrtThree();
  filter->ModifiedBoundaryOff();
  filter->SetMaximumNumberOfCells(81 * input->GetNumberOfCells());
  EXPECT_NE(
    UpdateWithBounds(filter.Get(), input, 0, true)->GetCellData()->GetArray("ErrorBound"), nullptr);
}

TEST(SqrtThreeErrorBounds, SayWhereThereAreNone)
{
  const auto countWarnings = [](vtkUnstructuredGrid* input, int levels, const char* text)
  {
    vtkNew<Surface> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetSchemeToSqrtThree();
    filter->GenerateErrorBoundsOn();
    filter->SetModifiedBoundary(levels % 2 == 0);
    filter->SetNumberOfLevels(levels);
    filter->SetInputData(input);
    filter->Update();
    const auto warnings = messages->CountWarnings(text);
    const bool hasBounds = filter->GetOutput()->GetCellData()->GetArray("ErrorBound");
    EXPECT_EQ(hasBounds, warnings == 0);
    return warnings;
  };
  const Grid sheet = MakeSheet(2, true, 0.1);
  EXPECT_EQ(countWarnings(sheet, 1, "take an even number"), 1);
  // The modified rules at boundaries have no proof; a closed surface has none of these.
  EXPECT_EQ(countWarnings(sheet, 2, "switch ModifiedBoundary off"), 1);
  EXPECT_EQ(countWarnings(MakeCones(5), 2, "GenerateErrorBounds"), 0);
}
