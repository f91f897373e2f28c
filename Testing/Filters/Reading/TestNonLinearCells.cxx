// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNonLinearCells.cxx
 * Quadratic, cubic, Lagrange and Bezier cells cut along their nodes. Where the nodes are, and of
 * which corners they are the means, is asked of VTK's own cells.
 */
#include "CellsToSimplicesLattice.h"
#include "CellsToSimplicesTools.h"

#include "Private/Reading/NonLinearCells.h"

#include "vtkGenericCell.h"

using namespace cells_to_simplices_tools;

namespace
{

/// Degrees of Lagrange and Bezier cells; none: VTK takes them from the number of points.
using Degrees = std::array<double, 3>;

void SetDegrees(vtkUnstructuredGrid* grid, const Degrees& degrees)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("degrees");
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(degrees.data());
  grid->GetCellData()->SetHigherOrderDegrees(array);
}

/// Where the nodes of a cell with straight sides are, by VTK.
std::vector<Point> GetPlaces(int type, size_t size, const Degrees* degrees = nullptr)
{
  Mesh mesh;
  mesh.Points.resize(size);
  mesh.Cells = { { type, Range(size) } };
  const auto grid = MakeGrid(mesh);
  if (degrees)
  {
    SetDegrees(grid, *degrees);
  }
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(0, cell);
  const double* places = cell->GetParametricCoords();
  std::vector<Point> points(size);
  for (size_t i = 0; i < size; ++i)
  {
    points[i] = { places[3 * i], places[3 * i + 1], places[3 * i + 2] };
  }
  for (Point& p : points) // VTK gives the places in a cube, which it folds into the pyramid
  {
    p[0] *= type == VTK_QUADRATIC_PYRAMID ? 1 - p[2] : 1;
    p[1] *= type == VTK_QUADRATIC_PYRAMID ? 1 - p[2] : 1;
  }
  if (type == VTK_TRIQUADRATIC_PYRAMID)
  {
    points[18][2] = .6; // the mean of the corners
  }
  if (subdivision::GetCornerCell(type, static_cast<vtkIdType>(size)).Type == VTK_WEDGE)
  {
    for (Point& p : points) // the normal of (0,1,2) points outward
    {
      std::swap(p[0], p[1]);
    }
  }
  return points;
}

struct Expected
{
  int Type;
  size_t Size;
  size_t Pieces;
  double Measure; ///< length, area or volume
};

const std::vector<Expected> FixedCells = { { VTK_QUADRATIC_EDGE, 3, 2, 1 },
  { VTK_CUBIC_LINE, 4, 3, 2 }, { VTK_QUADRATIC_TRIANGLE, 6, 4, .5 },
  { VTK_BIQUADRATIC_TRIANGLE, 7, 6, .5 }, { VTK_QUADRATIC_QUAD, 8, 6, 1 },
  { VTK_BIQUADRATIC_QUAD, 9, 8, 1 }, { VTK_QUADRATIC_LINEAR_QUAD, 6, 4, 1 },
  { VTK_QUADRATIC_TETRA, 10, 8, 1. / 6 }, { VTK_QUADRATIC_HEXAHEDRON, 20, 36, 1 },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 44, 1 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 27, 48, 1 },
  { VTK_QUADRATIC_WEDGE, 15, 26, .5 }, { VTK_QUADRATIC_LINEAR_WEDGE, 12, 12, .5 },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 24, .5 }, { VTK_QUADRATIC_PYRAMID, 13, 22, 1. / 3 },
  { VTK_TRIQUADRATIC_PYRAMID, 19, 32, 1. / 6 }, { VTK_LAGRANGE_TRIANGLE, 7, 6, .5 },
  { VTK_LAGRANGE_TETRAHEDRON, 15, 24, 1. / 6 }, { VTK_LAGRANGE_WEDGE, 21, 36, .5 } };

double Measure(const std::vector<Point>& points, const Ids& simplex)
{
  if (simplex.size() == 4)
  {
    return Volume(points, simplex);
  }
  if (simplex.size() == 3)
  {
    return TwiceArea(points, simplex)[2] / 2; // all in the plane
  }
  const Point edge = Subtract(points[simplex[1]], points[simplex[0]]);
  return edge[0];
}

/// Each piece is positive, and together they fill the cell. All nodes are in use.
void ExpectCut(const Mesh& mesh, const Expected& expected, const Degrees* degrees = nullptr)
{
  const auto grid = MakeGrid(mesh);
  if (degrees)
  {
    SetDegrees(grid, *degrees);
  }
  const auto result = CellsToSimplices(grid, nullptr);
  ExpectSound(result, 1);
  EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
  const std::vector<Point> points = AddCentres(mesh.Points, result);
  const auto simplices = GetSimplices(result);
  EXPECT_EQ(simplices.size(), expected.Pieces) << "type " << expected.Type;
  double sum = 0;
  std::set<vtkIdType> used;
  for (const Ids& simplex : simplices)
  {
    const double measure = Measure(points, simplex);
    EXPECT_GT(measure, 1e-9) << "type " << expected.Type;
    sum += measure;
    used.insert(simplex.begin(), simplex.end());
  }
  EXPECT_NEAR(sum, expected.Measure, 1e-9) << "type " << expected.Type;
  EXPECT_EQ(used.size(), points.size()) << "type " << expected.Type;
  for (const auto& [face, n] : CountFaces(simplices))
  {
    EXPECT_LE(n, 2) << "type " << expected.Type;
  }
}

}

TEST(NonLinearCells, FixedOnesAreFilledByPositivePieces)
{
  std::mt19937 random(3);
  for (const Expected& expected : FixedCells)
  {
    const std::vector<Point> places = GetPlaces(expected.Type, expected.Size);
    for (int i = 0; i < 20; ++i)
    {
      ExpectCut(Shuffled(expected.Type, places, random), expected);
    }
    // Too few points, or too many, are no such cell.
    Mesh wrong;
    wrong.Points.resize(expected.Size + 1);
    wrong.Cells = { { expected.Type, Range(expected.Size + 1) } };
    const bool isLagrange = expected.Type >= VTK_LAGRANGE_CURVE;
    if (!isLagrange)
    {
      ExpectOneWarning(wrong, { "1 cell", "number of points" }, {});
    }
  }
}

TEST(NonLinearCells, LatticesAreCutIntoTheirCells)
{
  std::mt19937 random(4);
  const std::vector<int> types = { VTK_LAGRANGE_CURVE, VTK_LAGRANGE_TRIANGLE,
    VTK_LAGRANGE_QUADRILATERAL, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON,
    VTK_LAGRANGE_WEDGE };
  const double measures[] = { 1, .5, 1, 1. / 6, 1, .5 };
  const size_t factors[] = { 1, 1, 2, 1, 6, 3 };
  for (size_t t = 0; t < types.size(); ++t)
  {
    for (size_t n = 1; n <= 5; ++n)
    {
      const size_t points[] = { n + 1, (n + 1) * (n + 2) / 2, (n + 1) * (n + 1),
        (n + 1) * (n + 2) * (n + 3) / 6, (n + 1) * (n + 1) * (n + 1),
        (n + 1) * (n + 1) * (n + 2) / 2 };
      const size_t dimension = t == 0 ? 1 : (t < 3 ? 2 : 3);
      const auto pieces =
        factors[t] * static_cast<size_t>(std::lround(std::pow(n, static_cast<double>(dimension))));
      for (const int shift : { 0, VTK_BEZIER_CURVE - VTK_LAGRANGE_CURVE })
      {
        const int type = types[t] + shift;
        const std::vector<Point> places = GetPlaces(type, points[t]);
        ExpectCut(Shuffled(type, places, random), { type, points[t], pieces, measures[t] });
      }
    }
  }
}

TEST(NonLinearCells, OrdersMayDifferAlongAxes)
{
  std::mt19937 random(5);
  const Degrees degrees = { 3, 2, 4 };
  const Degrees ofWedge = { 3, 3, 2 };
  ExpectCut(
    Shuffled(VTK_LAGRANGE_HEXAHEDRON, GetPlaces(VTK_LAGRANGE_HEXAHEDRON, 60, &degrees), random),
    { VTK_LAGRANGE_HEXAHEDRON, 60, 6 * 24, 1 }, &degrees);
  ExpectCut(Shuffled(VTK_LAGRANGE_QUADRILATERAL,
              GetPlaces(VTK_LAGRANGE_QUADRILATERAL, 12, &degrees), random),
    { VTK_LAGRANGE_QUADRILATERAL, 12, 2 * 6, 1 }, &degrees);
  ExpectCut(Shuffled(VTK_LAGRANGE_WEDGE, GetPlaces(VTK_LAGRANGE_WEDGE, 30, &ofWedge), random),
    { VTK_LAGRANGE_WEDGE, 30, 3 * 18, .5 }, &ofWedge);
}

TEST(NonLinearCells, QuadraticPolygonsLoseTheirCorners)
{
  Mesh mesh;
  for (int i = 0; i < 5; ++i)
  {
    mesh.Points.push_back(
      { std::cos(1.2566370614359172 * i), std::sin(1.2566370614359172 * i), 0 });
  }
  double area = 0;
  for (int i = 0; i < 5; ++i)
  {
    const Point& a = mesh.Points[i];
    const Point& b = mesh.Points[(i + 1) % 5];
    mesh.Points.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0 });
    area += (mesh.Points[i][0] * mesh.Points[(i + 1) % 5][1] -
              mesh.Points[i][1] * mesh.Points[(i + 1) % 5][0]) /
      2;
  }
  mesh.Cells = { { VTK_QUADRATIC_POLYGON, Range(10) } };
  ExpectCut(mesh, { VTK_QUADRATIC_POLYGON, 10, 8, area });
}

TEST(NonLinearCells, CornersAreThoseOfTheLinearCell)
{
  for (const Expected& expected : FixedCells)
  {
    const auto corners =
      subdivision::GetCornerCell(expected.Type, static_cast<vtkIdType>(expected.Size));
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(corners.Type));
    EXPECT_EQ(cell->GetNumberOfPoints(), corners.Size);
    const auto places = GetPlaces(expected.Type, expected.Size);
    const auto linear = GetPlaces(corners.Type, static_cast<size_t>(corners.Size));
    const bool hasPlaces =
      expected.Type != VTK_CUBIC_LINE && expected.Type != VTK_TRIQUADRATIC_PYRAMID;
    for (vtkIdType i = 0; i < corners.Size && hasPlaces; ++i)
    {
      const bool turned = corners.Type == VTK_WEDGE;
      EXPECT_EQ(places[i][0], linear[i][turned ? 1 : 0]) << expected.Type;
      EXPECT_EQ(places[i][1], linear[i][turned ? 0 : 1]) << expected.Type;
      EXPECT_EQ(places[i][2], linear[i][2]) << expected.Type;
    }
    EXPECT_TRUE(subdivision::IsNonLinear(expected.Type));
    EXPECT_FALSE(subdivision::IsNonLinear(corners.Type));
  }
}

TEST(NonLinearCells, OctahedraTakeTheirShortestDiagonal)
{
  Mesh mesh;
  mesh.Points = GetPlaces(VTK_QUADRATIC_TETRA, 10);
  for (int axis = 0; axis < 3; ++axis)
  {
    Mesh stretched = mesh;
    for (Point& p : stretched.Points)
    {
      p[axis] *= 9;
    }
    stretched.Cells = { { VTK_QUADRATIC_TETRA, Range(10) } };
    const auto simplices = GetSimplices(Convert(stretched));
    double shortest = 1e9;
    std::array<vtkIdType, 2> wanted{};
    for (const auto& ends : { std::array<vtkIdType, 2>{ 4, 9 }, { 5, 7 }, { 6, 8 } })
    {
      const Point d = Subtract(stretched.Points[ends[0]], stretched.Points[ends[1]]);
      if (Dot(d, d) < shortest)
      {
        shortest = Dot(d, d);
        wanted = ends;
      }
    }
    const auto around = std::count_if(simplices.begin(), simplices.end(),
      [&](const Ids& s)
      {
        return std::count(s.begin(), s.end(), wanted[0]) +
          std::count(s.begin(), s.end(), wanted[1]) ==
          2;
      });
    EXPECT_EQ(around, 4);
  }
}

// ------------------------------------------------------------------------------------------------
// Several cells

namespace
{

/// Makes cells of a mesh quadratic: their nodes are the means of corners, which VTK's places say.
class Elevated
{
public:
  explicit Elevated(const Mesh& mesh)
    : Result(mesh)
  {
    this->Result.Cells.clear();
  }

  void Add(const Cell& cell, int type, size_t size)
  {
    const auto places = GetPlaces(type, size);
    Cell made{ type, cell.Points };
    for (size_t node = cell.Points.size(); node < size; ++node)
    {
      made.Points.push_back(this->FindNode(cell, places, places[node]));
    }
    this->Result.Cells.push_back(made);
  }

  Mesh Result;

private:
  /// The node in the middle of the corners whose mean has a place.
  vtkIdType FindNode(const Cell& cell, const std::vector<Point>& places, const Point& place)
  {
    const size_t corners = cell.Points.size();
    for (unsigned mask = 1; mask < 1u << corners; ++mask)
    {
      Point mean{};
      Point x{};
      Ids members;
      for (size_t i = 0; i < corners; ++i)
      {
        for (int k = 0; (mask >> i & 1) && k < 3; ++k)
        {
          mean[k] += places[i][k];
          x[k] += this->Result.Points[cell.Points[i]][k];
        }
        if (mask >> i & 1)
        {
          members.push_back(cell.Points[i]);
        }
      }
      const double n = static_cast<double>(members.size());
      const auto near = [&](int k) { return std::abs(mean[k] / n - place[k]) < 1e-6; };
      if (near(0) && near(1) && near(2) && this->IsWhole(cell, mask))
      {
        std::sort(members.begin(), members.end());
        const auto [at, isNew] =
          this->Nodes.emplace(members, static_cast<vtkIdType>(this->Result.Points.size()));
        if (isNew)
        {
          this->Result.Points.push_back({ x[0] / n, x[1] / n, x[2] / n });
        }
        return at->second;
      }
    }
    ADD_FAILURE() << "no corners around a node";
    return 0;
  }

  /// Whether the corners are an edge, a face or all of the linear cell.
  bool IsWhole(const Cell& cell, unsigned mask) const
  {
    const auto linear = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(cell.Type));
    for (size_t i = 0; i < cell.Points.size(); ++i)
    {
      linear->GetPointIds()->SetId(static_cast<vtkIdType>(i), static_cast<vtkIdType>(i));
    }
    const auto isIt = [mask](vtkCell* part)
    {
      unsigned other = 0;
      for (const vtkIdType id : *part->GetPointIds())
      {
        other |= 1u << id;
      }
      return other == mask;
    };
    bool found = mask == (1u << cell.Points.size()) - 1;
    for (int e = 0; e < linear->GetNumberOfEdges(); ++e)
    {
      found = found || isIt(linear->GetEdge(e));
    }
    for (int f = 0; f < linear->GetNumberOfFaces(); ++f)
    {
      found = found || isIt(linear->GetFace(f));
    }
    return found;
  }

  std::map<Ids, vtkIdType> Nodes;
};

/// Tets are positive and fill the box; faces of one tet alone lie on the outside of the box.
void ExpectConforming(const Mesh& mesh, double size)
{
  const auto result = Convert(mesh);
  EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
  ExpectSound(result, static_cast<vtkIdType>(mesh.Cells.size()));
  ExpectFills(result, mesh.Points, size * size * size);
  const auto points = AddCentres(mesh.Points, result);
  const auto simplices = GetSimplices(result);
  const auto count = CountFaces(simplices);
  for (const Face& face : FacesUsed(count, 1))
  {
    bool isOutside = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double side : { 0., size })
      {
        isOutside = isOutside ||
          std::all_of(face.begin(), face.end(),
            [&](vtkIdType p) { return std::abs(points[p][axis] - side) < 1e-9; });
      }
    }
    EXPECT_TRUE(isOutside) << face[0] << " " << face[1] << " " << face[2];
  }
  for (const Ids& simplex : simplices)
  {
    if (simplex.size() == 3)
    {
      EXPECT_TRUE(count.count(MakeFace(simplex[0], simplex[1], simplex[2])))
        << "a triangle on the solids is a face of them";
    }
  }
}

}

namespace
{

/// A box of n cubes along each axis, in columns of hexahedra or of wedges. Some hexahedra become
/// six pyramids, some wedges three pyramids and two tetrahedra, around a new point.
Mesh MakeMixedBox(int n, unsigned seed)
{
  std::mt19937 random(seed);
  Mesh mesh;
  const auto at = [n](int x, int y, int z)
  { return static_cast<vtkIdType>((z * (n + 1) + y) * (n + 1) + x); };
  for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
  {
    mesh.Points.push_back(
      { i % (n + 1) * 1., i / (n + 1) % (n + 1) * 1., i / ((n + 1) * (n + 1)) * 1. });
  }
  const auto addCone = [&](const Ids& corners, const std::vector<Ids>& faces)
  {
    Point centre{};
    for (const vtkIdType corner : corners)
    {
      for (int k = 0; k < 3; ++k)
      {
        centre[k] += mesh.Points[corner][k] / static_cast<double>(corners.size());
      }
    }
    const auto id = static_cast<vtkIdType>(mesh.Points.size());
    mesh.Points.push_back(centre);
    for (Ids face : faces) // outward, and a pyramid sees its base from inside
    {
      std::reverse(face.begin(), face.end());
      face.push_back(id);
      mesh.Cells.push_back({ face.size() == 4 ? VTK_TETRA : VTK_PYRAMID, face });
    }
  };
  for (int c = 0; c < n * n; ++c)
  {
    const bool isOfWedges = random() % 2 == 0;
    for (int z = 0; z < n; ++z)
    {
      const int x = c % n;
      const int y = c / n;
      const Ids p = { at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z),
        at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1) };
      const bool isCone = random() % 2 == 0;
      if (!isOfWedges)
      {
        std::vector<Ids> faces;
        for (const auto& f : CubeFaces)
        {
          faces.push_back({ p[f[0]], p[f[1]], p[f[2]], p[f[3]] });
        }
        isCone ? addCone(p, faces) : mesh.Cells.push_back({ VTK_HEXAHEDRON, p });
        continue;
      }
      for (const auto& w : { std::array<int, 6>{ 0, 2, 1, 4, 6, 5 }, { 0, 3, 2, 4, 7, 6 } })
      {
        const Ids q = { p[w[0]], p[w[1]], p[w[2]], p[w[3]], p[w[4]], p[w[5]] };
        isCone ? addCone(q,
                   { { q[0], q[1], q[2] }, { q[3], q[5], q[4] }, { q[0], q[3], q[4], q[1] },
                     { q[1], q[4], q[5], q[2] }, { q[2], q[5], q[3], q[0] } })
               : mesh.Cells.push_back({ VTK_WEDGE, q });
      }
    }
    mesh.Cells.push_back({ VTK_QUAD, { at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0) } });
  }
  return mesh;
}

}

TEST(NonLinearCells, MixedQuadraticCellsFitTogether)
{
  const std::map<int, std::pair<int, size_t>> types = { { VTK_TETRA, { VTK_QUADRATIC_TETRA, 10 } },
    { VTK_HEXAHEDRON, { VTK_QUADRATIC_HEXAHEDRON, 20 } },
    { VTK_WEDGE, { VTK_QUADRATIC_WEDGE, 15 } }, { VTK_PYRAMID, { VTK_QUADRATIC_PYRAMID, 13 } },
    { VTK_QUAD, { VTK_QUADRATIC_QUAD, 8 } } };
  const std::map<int, std::pair<int, size_t>> full = { { VTK_TETRA,
                                                         { VTK_LAGRANGE_TETRAHEDRON, 15 } },
    { VTK_HEXAHEDRON, { VTK_TRIQUADRATIC_HEXAHEDRON, 27 } },
    { VTK_WEDGE, { VTK_LAGRANGE_WEDGE, 21 } }, { VTK_PYRAMID, { VTK_TRIQUADRATIC_PYRAMID, 19 } },
    { VTK_QUAD, { VTK_BIQUADRATIC_QUAD, 9 } } };
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    const Mesh linear = MakeMixedBox(2, seed);
    ExpectConforming(linear, 2);
    for (const auto* family : { &types, &full })
    {
      Elevated elevated(linear);
      for (const Cell& cell : linear.Cells)
      {
        const auto& [type, size] = family->at(cell.Type);
        elevated.Add(cell, type, size);
      }
      ExpectConforming(elevated.Result, 2);
    }
  }
}

TEST(NonLinearCells, LinearNeighboursFitWhereTheyShareAllNodes)
{
  // A quadratic tetrahedron, and four linear ones on a quarter of one of its faces each.
  Mesh mesh;
  mesh.Points = GetPlaces(VTK_QUADRATIC_TETRA, 10);
  mesh.Points.push_back({ .3, .3, -1 });
  mesh.Cells = { { VTK_QUADRATIC_TETRA, Range(10) }, { VTK_TETRA, { 0, 6, 4, 10 } },
    { VTK_TETRA, { 4, 5, 1, 10 } }, { VTK_TETRA, { 6, 2, 5, 10 } },
    { VTK_TETRA, { 4, 6, 5, 10 } } };
  const auto result = Convert(mesh);
  const auto count = CountFaces(GetSimplices(result));
  for (const Face& face :
    { MakeFace(0, 4, 6), MakeFace(1, 4, 5), MakeFace(2, 5, 6), MakeFace(4, 5, 6) })
  {
    EXPECT_EQ(count.at(face), 2);
  }
  ExpectFills(result, mesh.Points, 1. / 6 + .5 / 3);
  EXPECT_EQ(result.ParentCells, (Ids{ 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4 }));
}

TEST(NonLinearCells, CollapsedCellsLoseTheirDegeneratePieces)
{
  // A hexahedron of 20 nodes whose edge from 2 to 3 is a point, as meshers make wedges.
  Mesh mesh;
  mesh.Points = GetPlaces(VTK_QUADRATIC_HEXAHEDRON, 20);
  Ids ids = Range(20);
  mesh.Points[9] = { .5, .5, 0 };
  mesh.Points[13] = { .5, .5, 1 };
  for (const auto& [gone, kept] :
    { std::array<vtkIdType, 2>{ 2, 3 }, { 10, 3 }, { 6, 7 }, { 14, 7 }, { 18, 19 } })
  {
    ids[gone] = kept;
  }
  mesh.Cells = { { VTK_QUADRATIC_HEXAHEDRON, ids } };
  const auto result = Convert(mesh);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_TRUE(Has(result.Warnings[0], "repeated point ids"));
  ExpectSound(result, 1);
  double sum = 0;
  const auto points = AddCentres(mesh.Points, result);
  for (const Ids& tet : GetSimplices(result))
  {
    sum += Volume(points, tet);
  }
  EXPECT_NEAR(sum, .5, 1e-9);
}
