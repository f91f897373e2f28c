// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8, 15: limits at places of cells of all types.
#include "Precompiled.h"

#include "HybridTools.h"
#include "HybridZoo.h"

#include "Core/Operators/BoxSpline.h"
#include "Core/Solids/Hybrid/HybridLimits.h"
#include "Core/Solids/Hybrid/HybridPlaces.h"

#include <random>

using namespace hybrid_tools;

namespace
{

using Vector = std::array<double, 3>;

CornerShares Share(CellShape shape, const FramePoint& at)
{
  return ShareCorners(shape, GetFrameCorners(shape), at);
}

HybridPlace MakePlace(vtkIdType cell, const FramePoint& at)
{
  return { cell, at, { { { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 0., 0., 1. } } } } };
}

/// The value and the derivatives of points at each place.
std::vector<std::array<Vector, PlaceParts::Count>> Evaluate(const HybridLevel<int>& level,
  const std::vector<double>& points, const std::vector<HybridPlace>& places)
{
  const PlaceRows<int> rows = HybridPlaceLimits<int>(level).Find(places, PlaceDerivatives::Second);
  std::vector<std::array<Vector, PlaceParts::Count>> values(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      values[i][p] = {};
      for (int k = rows.Offsets[i]; rows.HasPart(p) && k < rows.Offsets[i + 1]; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          values[i][p][c] += rows.Weights[p][k] * points[3 * rows.Columns[k] + c];
        }
      }
    }
  }
  return values;
}

/// The weights of corners at a place: along the axes of hexahedra, quads and wedges multiplied, as
/// linear steps do.
std::array<double, 8> WeighCorners(CellShape shape, const FramePoint& at)
{
  std::array<double, 8> weights{};
  const auto [x, y, z] = at;
  const int corners = GetCellTable(shape).Corners;
  for (int i = 0; i < corners; ++i)
  {
    const FramePoint corner = GetFrameCorners(shape)[i];
    const auto along = [&](int k) { return corner[k] > 0. ? at[k] : 1. - at[k]; };
    const double inTriangle = i % 3 == 0 ? 1. - x - y : i % 3 == 1 ? x : y;
    weights[i] = shape == CellShape::Hex ? along(0) * along(1) * along(2)
      : shape == CellShape::Quad         ? along(0) * along(1)
      : shape == CellShape::Wedge        ? inTriangle * along(2)
                                         : 0.;
    if (weights[i] == 0. && shape == CellShape::Pyramid)
    {
      // x and y go from 0 to 1 - z.
      weights[i] = i == 4 ? z
        : z == 1.
        ? 0.
        : (corner[0] > 0. ? x : 1. - z - x) * (corner[1] > 0. ? y : 1. - z - y) / (1. - z);
    }
  }
  if (*std::max_element(weights.begin(), weights.end()) == 0.)
  {
    weights = Share(shape, at).Values;
  }
  return weights;
}

/// All places with coordinates that are multiples of 1 / n; of 2 / n in octahedra.
std::vector<FramePoint> ListLattice(CellShape shape, int n)
{
  std::vector<FramePoint> all;
  const int dimension = GetCellTable(shape).Dimension;
  const bool isOct = shape == CellShape::Octahedron;
  for (int i = isOct ? -n : 0; i <= n; ++i)
  {
    for (int j = isOct ? -n : 0; j <= (dimension > 1 ? n : 0); ++j)
    {
      for (int k = isOct ? -n : 0; k <= (dimension > 2 ? n : 0); ++k)
      {
        const FramePoint at{ { double(i) / n, double(j) / n, double(k) / n } };
        // Steps make the corners of tetrahedra and octahedra in octahedra.
        if (Share(shape, at).Least >= 0. && (!isOct || (i + j + k + 3 * n) % 2 == n % 2))
        {
          all.push_back(at);
        }
      }
    }
  }
  return all;
}

/// A small mesh by its seed, with sharp edges and faces for some of them.
HybridMesh Draw(unsigned int seed)
{
  const hybridtest::Mesh drawn = hybridtest::MakeRandomHybrid(seed);
  HybridMesh mesh = drawn.Cells.size() > 20 ? HybridMesh() : Take(drawn);
  mesh.Options.ModifiedBoundary = seed % 3 == 0;
  std::mt19937 random(seed);
  for (const Cell& cell : mesh.Cells)
  {
    for (const auto& edge : GetCellTable(cell.Shape).Edges)
    {
      if (seed % 2 == 0 && random() % 12 == 0)
      {
        mesh.Sharpness[coretest::Sorted(
          coretest::Tuple{ cell.Corners[edge[0]], cell.Corners[edge[1]] })] = .5 * (random() % 6);
      }
    }
  }
  return mesh;
}

FramePoint DrawPlace(std::mt19937& random, CellShape shape)
{
  std::uniform_real_distribution<double> draw(shape == CellShape::Octahedron ? -1. : 0., 1.);
  FramePoint at{};
  do
  {
    for (int k = 0; k < GetCellTable(shape).Dimension; ++k)
    {
      at[k] = random() % 8 == 0 ? double(random() % 2) : draw(random);
    }
  } while (Share(shape, at).Least < 0.);
  return at;
}

}

/// Each corner has the whole share at its place, slopes are differences, and children fill a cell.
TEST(CellFrames, SharesAndChildren)
{
  std::mt19937 random(3);
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    const auto shape = static_cast<CellShape>(s);
    SCOPED_TRACE(s);
    const std::vector<FramePoint> corners = GetFrameCorners(shape);
    ASSERT_EQ(static_cast<int>(corners.size()), GetCellTable(shape).Corners);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const CornerShares shares = Share(shape, corners[i]);
      for (std::size_t j = 0; j < corners.size(); ++j)
      {
        EXPECT_EQ(shares.Values[j], i == j ? 1. : 0.);
      }
    }
    for (int round = 0; round < 50 && shape != CellShape::Vertex; ++round)
    {
      const FramePoint at = DrawPlace(random, shape);
      const CornerShares shares = Share(shape, at);
      FramePoint sum{};
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += shares.Values[i] * corners[i][k];
        }
      }
      double most = -1.;
      for (const CellChild& child : GetCellTable(shape).Children)
      {
        most = std::max(
          most, ShareCorners(child.Shape, GetChildCorners(shape, corners, child), at).Least);
      }
      EXPECT_GE(most, -1e-15);
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(sum[k], at[k], 1e-15);
      }
    }
  }
}

/// Places that are vertices of a level have the limits of these, also where edges are semi-sharp.
TEST(HybridPlaces, OfLatticesAreVertices)
{
  std::set<CellShape> shapes;
  std::mt19937 random(4);
  for (unsigned int seed = 0; seed < 14; ++seed)
  {
    SCOPED_TRACE(seed);
    const HybridMesh mesh = Draw(seed);
    if (mesh.Cells.empty())
    {
      continue;
    }
    const auto control = MakeLevel<int>(mesh);
    auto level = MakeLevel<int>(mesh);
    std::vector<double> limits = mesh.Points;
    std::vector<double> linear = mesh.Points;
    constexpr int levels = 2;
    for (int step = 0; step < levels; ++step)
    {
      linear = ApplyStep(level, linear, 3, HybridRules::Linear);
      limits = ApplyStep(level, limits);
      level = RefineHybrid(level, HybridRules::Smooth);
    }
    const std::vector<double> points = limits;
    MakeLimitOperator(level).Apply(points.data(), limits.data(), 3);
    std::vector<HybridPlace> places;
    std::vector<vtkIdType> vertices;
    for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
    {
      const CellShape shape = mesh.Cells[c].Shape;
      shapes.insert(shape);
      for (const FramePoint& at : ListLattice(shape, 1 << levels))
      {
        const auto weights = WeighCorners(shape, at);
        Vector x{};
        for (std::size_t i = 0; i < mesh.Cells[c].Corners.size(); ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            x[k] += weights[i] * mesh.Points[3 * mesh.Cells[c].Corners[i] + k];
          }
        }
        for (std::size_t v = 0; v < linear.size() / 3; ++v)
        {
          const double* at3 = linear.data() + 3 * v;
          if (std::abs(at3[0] - x[0]) + std::abs(at3[1] - x[1]) + std::abs(at3[2] - x[2]) < 1e-10)
          {
            places.push_back(MakePlace(static_cast<vtkIdType>(c), at));
            vertices.push_back(static_cast<vtkIdType>(v));
            break;
          }
        }
      }
    }
    EXPECT_GT(places.size(), mesh.Cells.size());
    for (; places.size() > 60; places.pop_back(), vertices.pop_back())
    {
      const std::size_t drawn = random() % places.size();
      std::swap(places[drawn], places.back());
      std::swap(vertices[drawn], vertices.back());
    }
    const auto values = Evaluate(control, mesh.Points, places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_NEAR(values[i][0][k], limits[3 * vertices[i] + k], 1e-12)
          << "type " << int(mesh.Cells[places[i].Cell].Shape) << " at " << places[i].At[0] << " "
          << places[i].At[1] << " " << places[i].At[2];
      }
    }
  }
  EXPECT_GE(shapes.size(), 8u);
}

/// The limit goes on across faces: both solids tell the same.
TEST(HybridPlaces, OnFacesBothSidesAgree)
{
  std::mt19937 random(5);
  int faces = 0;
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    SCOPED_TRACE(seed);
    const HybridMesh mesh = Draw(seed);
    const auto level = MakeLevel<int>(mesh);
    const CellComplex<int>& complex = level.Complex;
    std::vector<HybridPlace> sides[2];
    for (int f = 0; f < complex.NumberOfFaces; ++f)
    {
      const Row<int> vertices = complex.GetVertices(f);
      const Row<int> solids = complex.FaceSolids[f];
      if (solids.size() != 2)
      {
        continue;
      }
      ++faces;
      std::map<int, double> weights;
      const double u = double(random() % 1000) / 1000.;
      const double v = double(random() % 1000) / 1000.;
      const double ofQuad[4] = { (1. - u) * (1. - v), u * (1. - v), u * v, (1. - u) * v };
      const double ofTriangle[3] = { 1. - std::max(u, v), std::min(u, v), std::abs(u - v) };
      for (vtkIdType i = 0; i < vertices.size(); ++i)
      {
        weights[vertices.begin()[i]] = vertices.size() == 4 ? ofQuad[i] : ofTriangle[i];
      }
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType cell = solids.begin()[side];
        FramePoint at{};
        for (int i = 0; i < complex.Cells.GetTable(cell).Corners; ++i)
        {
          const auto found = weights.find(complex.Cells.GetCorners(cell)[i]);
          const FramePoint corner = GetFrameCorners(complex.Cells.Shapes[cell])[i];
          for (int k = 0; k < 3; ++k)
          {
            at[k] += found == weights.end() ? 0. : found->second * corner[k];
          }
        }
        sides[side].push_back(MakePlace(cell, at));
      }
    }
    const auto a = Evaluate(level, mesh.Points, sides[0]);
    const auto b = Evaluate(level, mesh.Points, sides[1]);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(a[i][0][k], b[i][0][k], 1e-12)
          << int(complex.Cells.Shapes[sides[0][i].Cell]) << " and "
          << int(complex.Cells.Shapes[sides[1][i].Cell]);
      }
    }
  }
  EXPECT_GT(faces, 10);
}

/// Inside of a lattice of cubes the limit is a tricubic B-spline.
TEST(HybridPlaces, LatticesAreTricubic)
{
  HybridMesh box = MakeBox(3, 0);
  const Cell& middle = box.Cells[13];
  std::mt19937 random(1);
  for (double& x : box.Points)
  {
    x = double(random() % 1000) / 500.;
  }
  const auto level = MakeLevel<int>(box);
  std::vector<HybridPlace> places;
  for (int i = 0; i < 20; ++i)
  {
    places.push_back(MakePlace(13, DrawPlace(random, CellShape::Hex)));
  }
  const auto values = Evaluate(level, box.Points, places);
  // Points are numbered along x, then y, then z; the first corner of the middle cube is 1 1 1.
  ASSERT_EQ(middle.Corners[0], 1 + 4 + 16);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::array<PatchParts, 3> along{};
    for (int k = 0; k < 3; ++k)
    {
      WeightCubic(places[i].At[k], { { { { 1., 0. } }, { { 0., 0. } } } }, along[k]);
    }
    for (int part = 0; part < 4; ++part)
    {
      Vector expected{};
      for (int p = 0; p < 64; ++p)
      {
        const int of[3] = { p % 4, p / 4 % 4, p / 16 };
        double weight = 1.;
        for (int k = 0; k < 3; ++k)
        {
          weight *= along[k][part == k + 1 ? PlaceParts::First : PlaceParts::Value][of[k]];
        }
        for (int c = 0; c < 3; ++c)
        {
          expected[c] += weight * box.Points[3 * p + c];
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(values[i][part][c], expected[c], part == 0 ? 1e-14 : 1e-12) << part;
      }
    }
  }
}

/// Derivatives are differences of values, in cells of all types.
TEST(HybridPlaces, DerivativesAreDifferences)
{
  std::mt19937 random(9);
  constexpr double h = 1e-6;
  for (unsigned int seed = 0; seed < 4; ++seed)
  {
    SCOPED_TRACE(seed);
    const HybridMesh mesh = Draw(seed);
    const auto level = MakeLevel<int>(mesh);
    std::vector<HybridPlace> places;
    for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
    {
      const CellShape shape = mesh.Cells[c].Shape;
      FramePoint at{};
      const int corners = GetCellTable(shape).Corners;
      for (int i = 0; i < corners; ++i)
      {
        const FramePoint corner = GetFrameCorners(shape)[i];
        for (int k = 0; k < 3; ++k)
        {
          at[k] += corner[k] * (i + 1.37) * 2. / (corners * (corners + 1.74));
        }
      }
      places.push_back(MakePlace(static_cast<vtkIdType>(c), at));
      for (int k = 0; k < GetCellTable(shape).Dimension; ++k)
      {
        for (const double by : { -h, h })
        {
          FramePoint beside = at;
          beside[k] += by;
          places.push_back(MakePlace(static_cast<vtkIdType>(c), beside));
        }
      }
    }
    const auto values = Evaluate(level, mesh.Points, places);
    for (std::size_t i = 0; i < places.size();)
    {
      const CellShape shape = mesh.Cells[places[i].Cell].Shape;
      const int dimension = GetCellTable(shape).Dimension;
      for (int k = 0; k < dimension; ++k)
      {
        const std::size_t before = i + 1 + 2 * static_cast<std::size_t>(k);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(values[i][PlaceParts::First + k][c],
            (values[before + 1][0][c] - values[before][0][c]) / (2. * h), 1e-4)
            << int(shape);
        }
      }
      i += 1 + 2 * static_cast<std::size_t>(dimension);
    }
  }
}

/// The order in which places are asked for, and threads, do not change a bit.
TEST(HybridPlaces, OneByOneOrTogether)
{
  std::mt19937 random(2);
  HybridMesh mesh = Draw(4);
  for (unsigned int seed = 5; mesh.Cells.empty(); ++seed)
  {
    mesh = Draw(seed);
  }
  const auto level = MakeLevel<int>(mesh);
  std::vector<HybridPlace> places;
  for (int i = 0; i < 16; ++i)
  {
    const auto cell = static_cast<vtkIdType>(random() % mesh.Cells.size());
    places.push_back(MakePlace(cell, DrawPlace(random, mesh.Cells[cell].Shape)));
  }
  const auto together = Evaluate(level, mesh.Points, places);
  for (std::size_t i = places.size(); i-- > 0;)
  {
    EXPECT_EQ(Evaluate(level, mesh.Points, { places[i] })[0], together[i]);
  }
}
