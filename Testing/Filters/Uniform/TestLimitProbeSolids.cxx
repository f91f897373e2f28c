// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLimitProbeSolids.cxx
 * Nearest places in solids of both schemes: points inside are found again where they are, and no
 * vertex of a fine level is nearer to points outside.
 */
#include "LimitProbeTools.h"
#include "Turns.h"

#include "vtkSubdivisionModelSource.h"

using namespace limit_probe_tools;

namespace
{

/// For each tetrahedron of a mesh: add(cell).
template <typename Add>
void ForTets(vtkUnstructuredGrid* mesh, const Add& add)
{
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (mesh->GetCellType(cell) == VTK_TETRA)
    {
      add(cell);
    }
  }
}

/// How many places are looked at in each tetrahedron: few at joints, where places take longer.
struct Model
{
  int Number;
  int Places;
};
constexpr Model Models[] = { { vtkSubdivisionModelSource::MIXED_DIMENSIONS, 1 },
  { vtkSubdivisionModelSource::SCREW, 1 }, { vtkSubdivisionModelSource::MATERIAL_BLOCK, 4 },
  { vtkSubdivisionModelSource::CYLINDER, 4 } };

/// Places somewhere in each tetrahedron, no nearer to its faces than `margin`.
place_tools::Places DrawPlaces(vtkUnstructuredGrid* mesh, int count, double margin)
{
  std::mt19937 random(3);
  const auto draw = [&random] { return random() / 4294967296.; };
  place_tools::Places places;
  ForTets(mesh,
    [&](vtkIdType cell)
    {
      for (int i = 0; i < count; ++i)
      {
        std::array<double, 4> cuts{ { 0., draw(), draw(), draw() } };
        std::sort(cuts.begin(), cuts.end());
        Point at{};
        for (int k = 0; k < 3; ++k)
        {
          at[k] = margin + (1. - 4. * margin) * (cuts[k + 1] - cuts[k]);
        }
        turns::IsNextInTurn() ? places.Add(cell, at) : void();
      }
    });
  return places;
}

}

/// Of all models, from beside them to very far away.
TEST(LimitProbeSolids, NoVertexOfAModelIsNearer)
{
  std::mt19937 random(7);
  const auto draw = [&random](double size) { return size * (random() / 2147483648. - 1.); };
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    SCOPED_TRACE(vtkSubdivisionModelSource::GetModelName(model));
    const Grid mesh = MakeModel(model);
    const double size = mesh->GetLength();
    for (const double far : { 0.5, 3., 1e3, 1e6 })
    {
      std::vector<Point> targets;
      for (int i = 0; i < 20; ++i)
      {
        targets.push_back({ draw(far * size), draw(far * size), draw(far * size) });
      }
      if (turns::IsNextInTurn())
      {
        ExpectNoVertexIsNearer(
          mesh, targets, 2, 0.5 * size, 1e-9 * size + 1e-15 * far * size, Plain());
      }
    }
  }
}

/// From far away, where sides of solids are curved.
TEST(SubdivisionLimitProbe, NoVertexOfASolidIsNearerToAPointFarAway)
{
  std::mt19937 random(5);
  const auto draw = [&random](double size) { return size * (random() / 2147483648. - 1.); };
  int count = 0;
  for (int mesh = 0; mesh < 12; ++mesh)
  {
    SCOPED_TRACE(mesh);
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i)
    {
      points.push_back({ draw(1.), draw(1.), draw(1.) });
    }
    std::vector<Point> targets;
    for (int i = 0; i < 40; ++i)
    {
      targets.push_back({ draw(20.), draw(20.), draw(20.) });
    }
    const Grid solid = MakeGrid(points,
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } },
        { VTK_TETRA, { 2, 3, 4, 5 } } });
    count += ExpectNoVertexIsNearer(solid, targets, 4, 0.1);
  }
  EXPECT_EQ(count, 0);
}

TEST(LimitProbeSolids, PointsInsideAreTheirOwnPlaces)
{
  for (const Model& model : Models)
  {
    SCOPED_TRACE(vtkSubdivisionModelSource::GetModelName(model.Number));
    const Grid mesh = MakeModel(model.Number);
    const place_tools::Places places = DrawPlaces(mesh, model.Places, 0.02);
    {
      SCOPED_TRACE("box spline");
      ExpectOwnPlaces(mesh, places, 1e-9, Plain());
    }
    SCOPED_TRACE("tet/oct");
    ExpectOwnPlaces(mesh, places, 1e-9, TetOct());
  }
}

/// In the limit of the tet/oct scheme, second derivatives jump at planes of octahedra, the smaller
/// the more of them; next to edges and vertices that are not regular each small part has rules of
/// its own, and beside edges of a smooth boundary the limit nearly stands still in one direction.
TEST(LimitProbeSolids, PointsNextToEdgesVerticesAndPlanesOfOctahedra)
{
  constexpr double near = 1e-3;
  constexpr double nearer = 1e-6;
  constexpr double vertex = 5e-3;
  const std::vector<Point> at = { { vertex, vertex, vertex }, { near, near, 0.4 },
    { 0.5 + nearer, 0.2, 0.1 }, { 0.25 + nearer, 0.25, 0.25 }, { 0.2, 0.3, 0.1 + nearer },
    { 1. - 3. * vertex, vertex, vertex }, { 0.3, near, near }, { 0.5 - nearer, 0.2, 0.1 },
    { 0.3, 0.2, 0.2 }, { vertex, vertex, 1. - 3. * vertex }, { 0.3, 0.4, near },
    { 0.25, 0.25, 0.125 + nearer } };
  for (const Model& model : Models)
  {
    SCOPED_TRACE(vtkSubdivisionModelSource::GetModelName(model.Number));
    const Grid mesh = MakeModel(model.Number);
    place_tools::Places places;
    std::size_t next = 0;
    ForTets(mesh,
      [&](vtkIdType cell)
      {
        for (int i = 0; i < model.Places; ++i, ++next)
        {
          turns::IsInTurn(next) ? places.Add(cell, at[next % at.size()]) : void();
        }
      });
    ExpectOwnPlaces(mesh, places, 1e-9, TetOct());
  }
}

/// A corner at which three boundary faces meet smoothly: the limit nearly stands still there in one
/// direction, and steps that do not know it lead along the boundary, or are far too long.
TEST(LimitProbeSolids, PointsNextToVerticesWhereTheLimitStandsStill)
{
  const Grid mesh = MakeModel(vtkSubdivisionModelSource::MATERIAL_BLOCK);
  place_tools::Places places;
  ForTets(mesh, [&](vtkIdType cell) { places.Add(cell, { 0.997, 0.001, 0.001 }); });
  ExpectOwnPlaces(mesh, places, 1e-9, Plain());
  ExpectOwnPlaces(mesh, places, 1e-9, TetOct());
}

/// Of points beside solids of the tet/oct scheme.
TEST(LimitProbeSolids, NoVertexOfAFineLevelOfTetOctIsNearer)
{
  std::mt19937 random(1);
  const auto draw = [&random](double size) { return size * (random() / 2147483648. - 1.); };
  int count = 0;
  for (const int model :
    { vtkSubdivisionModelSource::MATERIAL_BLOCK, vtkSubdivisionModelSource::CYLINDER })
  {
    SCOPED_TRACE(vtkSubdivisionModelSource::GetModelName(model));
    const Grid mesh = MakeModel(model);
    double box[6];
    mesh->GetBounds(box);
    std::vector<Point> targets;
    for (int i = 0; i < 60; ++i)
    {
      Point target{};
      for (int c = 0; c < 3; ++c)
      {
        target[c] = 0.5 * (box[2 * c] + box[2 * c + 1]) + draw(0.8 * (box[2 * c + 1] - box[2 * c]));
      }
      targets.push_back(target);
    }
    count += ExpectNoVertexIsNearer(mesh, targets, 3, 0.2, 1e-9, TetOct());
  }
  EXPECT_EQ(count, 0);
}

/// A place in an output of the filter, which has pieces of octahedra: each of these is a cell.
TEST(LimitProbeSolids, PointsInPiecesOfOctahedra)
{
  const Grid mesh = MakeModel(vtkSubdivisionModelSource::MATERIAL_BLOCK);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToTetOct();
  filter->SetNumberOfLevels(1);
  const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
  place_tools::Places places;
  ForTets(fine, [&](vtkIdType cell)
    { places.Add(cell, { 0.1 + 0.004 * static_cast<double>(cell % 50), 0.3, 0.2 }); });
  EXPECT_GT(places.GetSize(), 100);
  ExpectOwnPlaces(fine, places, 1e-9, TetOct());
}
