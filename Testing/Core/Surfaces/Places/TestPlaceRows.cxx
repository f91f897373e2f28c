// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPlaceRows.cxx
 * Rows of places do not depend on the order of places, on other places, or on what else is wanted;
 * and inside of a regular surface they are those that every regular face has.
 */
#include "Core/Surfaces/Places/RegularPatch.h"
#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

constexpr SurfaceSchemeKind Kinds[] = { SurfaceSchemeKind::Loop, SurfaceSchemeKind::CatmullClark };
constexpr int PlacesOfFace = 2;

/// Calls act(name, walk) for all models after a step, after which all faces have the size that the
/// scheme has.
template <typename Act>
void ForLevels(const Act& act)
{
  for (const SurfaceSchemeKind kind : Kinds)
  {
    for (const auto& [name, model] : MakeZoo(kind == SurfaceSchemeKind::Loop))
    {
      Walk walk(model, kind);
      walk.Step();
      act(name, walk);
    }
  }
}

/// Some in each face, in random order.
std::vector<SurfacePlace<int>> MakePlaces(const SurfaceLevel<int>& level)
{
  std::vector<SurfacePlace<int>> places;
  std::mt19937 random(4);
  for (int i = 0; i < PlacesOfFace * level.Mesh.NumberOfFaces; ++i)
  {
    const double x = std::generate_canonical<double, 53>(random);
    const double y = std::generate_canonical<double, 53>(random);
    SurfacePlace<int> place;
    place.Dimension = 2;
    place.Part = i / PlacesOfFace;
    place.At = { { 0.9 * x * (1. - y), 0.9 * x * y } };
    place.Directions = { { { { 2., -1. } }, { { 0.5, 3. } } } };
    places.push_back(place);
  }
  std::shuffle(places.begin(), places.end(), random);
  return places;
}

PlaceRows<int> FindRows(const Walk& walk, const std::vector<SurfacePlace<int>>& places,
  PlaceDerivatives derivatives = PlaceDerivatives::Second)
{
  return FindSurfacePlaces(*walk.Scheme, walk.Level, SharpCreases<int>(), places, derivatives);
}

/// By column, without zeros.
std::map<int, double> TakeRow(const PlaceRows<int>& rows, vtkIdType place, int part)
{
  std::map<int, double> row;
  for (int k = rows.Offsets[place]; k < rows.Offsets[place + 1]; ++k)
  {
    if (rows.Weights[part][k] != 0.)
    {
      row[rows.Columns[k]] = rows.Weights[part][k];
    }
  }
  return row;
}

constexpr int PartsOfSurfaces[] = { PlaceParts::Value, PlaceParts::First, PlaceParts::First + 1,
  PlaceParts::Second, PlaceParts::Mixed, PlaceParts::SecondOfSecond };

}

TEST(PlaceRows, DependOnNoOtherPlace)
{
  ForLevels(
    [](const std::string& name, const Walk& walk)
    {
      const std::vector<SurfacePlace<int>> places = MakePlaces(walk.Level);
      const PlaceRows<int> rows = FindRows(walk, places);
      EXPECT_FALSE(rows.HasPart(PlaceParts::First + 2)) << name;
      for (std::size_t i = 0; i < places.size(); i += 7)
      {
        const PlaceRows<int> alone = FindRows(walk, { places[i] });
        for (const int part : PartsOfSurfaces)
        {
          EXPECT_EQ(TakeRow(rows, static_cast<vtkIdType>(i), part), TakeRow(alone, 0, part))
            << name << ", place " << i << ", part " << part;
        }
      }
    });
}

TEST(PlaceRows, AreTheSameWithoutSecondDerivatives)
{
  ForLevels(
    [](const std::string& name, const Walk& walk)
    {
      const std::vector<SurfacePlace<int>> places = MakePlaces(walk.Level);
      const PlaceRows<int> all = FindRows(walk, places);
      const PlaceRows<int> some = FindRows(walk, places, PlaceDerivatives::First);
      for (const int part : PartsOfSurfaces)
      {
        ASSERT_EQ(some.HasPart(part), part < PlaceParts::Second) << name << ", part " << part;
        for (vtkIdType i = 0; i < all.GetNumberOfPlaces() && some.HasPart(part); ++i)
        {
          EXPECT_EQ(TakeRow(some, i, part), TakeRow(all, i, part)) << name << ", place " << i;
        }
      }
    });
}

TEST(PlaceRows, InnerFacesHaveTheControlPointsOfRegularOnes)
{
  const PatchDirections directions{ { { { 2., -1. } }, { { 0.5, 3. } } } };
  int inner = 0;
  ForLevels(
    [&](const std::string& name, Walk& walk)
    {
      walk.Step();
      for (int face = 0; face < walk.Level.Mesh.NumberOfFaces; ++face)
      {
        RegularPatch<int> patch;
        SplineColumns<int> columns;
        if (!patch.FindFace(walk.Level, face))
        {
          continue;
        }
        const int* corners = walk.Level.Mesh.Vertices.data() + walk.Level.Mesh.GetFirst(face);
        const bool isInside = std::all_of(corners, corners + walk.Level.Mesh.GetSize(face),
          [&](int v) { return walk.Level.Tags.Vertices[v] == VertexTag::Smooth; });
        std::set<int> vertices;
        for (const ControlPoint<int>& point : patch.Points)
        {
          vertices.insert(point.begin()->Vertex);
        }
        ASSERT_EQ(patch.TakeColumns(columns), isInside && vertices.size() == patch.Points.size())
          << name;
        if (columns.GetSize() == 0)
        {
          continue;
        }
        ++inner;
        ASSERT_EQ(patch.Points.size(), static_cast<std::size_t>(columns.GetSize())) << name;
        ASSERT_TRUE(std::is_sorted(columns.begin(), columns.end())) << name;
        PatchParts ofPoints;
        WeightControlPoints(
          patch.Domain, { { 0.3, 0.2 } }, directions, PlaceDerivatives::Second, ofPoints);
        std::array<std::array<double, BicubicPoints>, PlaceParts::Count> found;
        PlaceSums sums{};
        for (const int part : PartsOfSurfaces)
        {
          sums[static_cast<std::size_t>(part)] = found[static_cast<std::size_t>(part)].data();
        }
        columns.Weight(0.3, 0.2, directions, sums);
        for (std::size_t j = 0; j < patch.Points.size(); ++j)
        {
          ASSERT_EQ(patch.Points[j].Size, 1) << name;
          const auto* at =
            std::find(columns.begin(), columns.end(), patch.Points[j].begin()->Vertex);
          ASSERT_NE(at, columns.end()) << name;
          for (const auto part : PartsOfSurfaces)
          {
            EXPECT_EQ(
              found[static_cast<std::size_t>(part)][static_cast<std::size_t>(at - columns.begin())],
              ofPoints[static_cast<std::size_t>(part)][j])
              << name << ", face " << face << ", point " << j;
          }
        }
      }
    });
  EXPECT_GE(inner, 100);
}
