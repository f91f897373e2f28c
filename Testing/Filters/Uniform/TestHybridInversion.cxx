// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridInversion.cxx
 * VolumeScheme = HYBRID turns no cell inside out whose control cell, and the cells around it, are
 * convex enough, where edges and corners of the boundary are sharp.
 */
#include "FeatureTools.h"
#include "FileTools.h"
#include "TypedCellTools.h"

#include <random>

using namespace feature_tools;
using namespace typed_cell_tools;

namespace
{

const Configure Sharp = [](Filter* filter)
{
  filter->SetVolumeSchemeToHybrid();
  filter->DetectFeaturesOn();
  filter->GenerateClassificationOn();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
};

/// Corners with three edges, and the other ends of these, as on a right hand.
const std::vector<std::array<int, 4>>& GetCorners(int type)
{
  static const std::map<int, std::vector<std::array<int, 4>>> corners = {
    { VTK_TETRA, { { 0, 1, 2, 3 }, { 1, 2, 0, 3 }, { 2, 0, 1, 3 }, { 3, 0, 2, 1 } } },
    { VTK_PYRAMID, { { 0, 1, 3, 4 }, { 1, 2, 0, 4 }, { 2, 3, 1, 4 }, { 3, 0, 2, 4 } } },
    { VTK_WEDGE,
      { { 0, 1, 2, 3 }, { 1, 2, 0, 4 }, { 2, 0, 1, 5 }, { 3, 5, 4, 0 }, { 4, 3, 5, 1 },
        { 5, 4, 3, 2 } } },
    { VTK_HEXAHEDRON,
      { { 0, 1, 3, 4 }, { 1, 2, 0, 5 }, { 2, 3, 1, 6 }, { 3, 0, 2, 7 }, { 4, 7, 5, 0 },
        { 5, 4, 6, 1 }, { 6, 5, 7, 2 }, { 7, 6, 4, 3 } } }
  };
  static const std::vector<std::array<int, 4>> none;
  const auto found = corners.find(type);
  return found == corners.end() ? none : found->second;
}

/// The volume that the edges of a corner span, by their lengths.
std::vector<double> GetJacobians(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const Ids ids = GetCell(grid, cell);
  std::vector<double> jacobians;
  for (const auto& corner : GetCorners(grid->GetCellType(cell)))
  {
    const Point at = GetPoint(grid, ids[static_cast<std::size_t>(corner[0])]);
    double edges[3][3];
    double size = 1.;
    for (int e = 0; e < 3; ++e)
    {
      const Point end = GetPoint(grid, ids[static_cast<std::size_t>(corner[e + 1])]);
      double length = 0.;
      for (int c = 0; c < 3; ++c)
      {
        edges[e][c] = end[c] - at[c];
        length += edges[e][c] * edges[e][c];
      }
      size *= std::sqrt(length);
    }
    const double volume = vtkMath::Determinant3x3(edges);
    jacobians.push_back(size > 0. ? volume / size : 0.);
  }
  return jacobians;
}

double GetLeast(const std::vector<double>& jacobians, double sign)
{
  double least = 1.;
  for (const double jacobian : jacobians)
  {
    least = std::min(least, sign * jacobian);
  }
  return least;
}

/// Cells of a control mesh: which are convex enough, all their neighbours too, and which way they
/// are turned.
struct Convexity
{
  Convexity(vtkUnstructuredGrid* control, double enough)
  {
    const vtkIdType size = control->GetNumberOfCells();
    std::vector<bool> isBad(static_cast<std::size_t>(control->GetNumberOfPoints()), false);
    for (vtkIdType c = 0; c < size; ++c)
    {
      const std::vector<double> jacobians = GetJacobians(control, c);
      this->Signs.push_back(
        std::accumulate(jacobians.begin(), jacobians.end(), 0.) < 0. ? -1. : 1.);
      if (GetLeast(jacobians, this->Signs.back()) < enough)
      {
        for (const vtkIdType id : GetCell(control, c))
        {
          isBad[static_cast<std::size_t>(id)] = true;
        }
      }
    }
    for (vtkIdType c = 0; c < size; ++c)
    {
      const Ids ids = GetCell(control, c);
      this->IsGood.push_back(!GetCorners(control->GetCellType(c)).empty() &&
        std::none_of(ids.begin(), ids.end(),
          [&](vtkIdType id) { return isBad[static_cast<std::size_t>(id)]; }));
    }
  }

  std::vector<double> Signs;
  std::vector<bool> IsGood;
};

struct Counts
{
  int Good = 0;     ///< control cells that are convex enough
  int All = 0;      ///< solid control cells
  int Inverted = 0; ///< cells of the output that belong to good ones
};

Counts CountInverted(const Grid& control, int levels, double enough)
{
  const vtkIdType size = control->GetNumberOfCells();
  std::vector<int> numbers(static_cast<std::size_t>(size));
  std::iota(numbers.begin(), numbers.end(), 0);
  AddCellArray<vtkIntArray>(control, "Control", numbers);
  const Convexity convexity(control, enough);
  Counts counts;
  for (vtkIdType c = 0; c < size; ++c)
  {
    counts.Good += convexity.IsGood[static_cast<std::size_t>(c)] ? 1 : 0;
    counts.All += GetCorners(control->GetCellType(c)).empty() ? 0 : 1;
  }
  const Grid output = Execute(control, levels, Sharp, vtkNew<Messages>());
  vtkDataArray* parents = output->GetCellData()->GetArray("Control");
  vtkDataArray* inverted = output->GetCellData()->GetArray("Inverted");
  vtkDataArray* octahedra = output->GetCellData()->GetArray("OctahedronId");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const auto parent = static_cast<std::size_t>(parents->GetComponent(c, 0));
    if (convexity.IsGood[parent])
    {
      // Tetrahedra of an octahedron are turned as their points are sorted.
      const bool isPiece = octahedra && octahedra->GetComponent(c, 0) >= 0.;
      const double least = GetLeast(GetJacobians(output, c), convexity.Signs[parent]);
      counts.Inverted += inverted->GetComponent(c, 0) > 0. || (!isPiece && least <= 0.) ? 1 : 0;
    }
  }
  return counts;
}

/// A box of three cubes in each direction. Some columns are wedges; other cubes are hexahedra or
/// six pyramids, of which two on a square may be four tetrahedra. Points move, but in the box's
/// sides.
class RandomBox
{
public:
  explicit RandomBox(unsigned int seed)
    : Random(seed)
  {
  }

  Grid Make(double shift)
  {
    for (int i = 0; i < 64; ++i)
    {
      this->Points.push_back({ i % 4 * 1., i / 4 % 4 * 1., i / 16 * 1. });
    }
    for (int i = 0; i < 9; ++i)
    {
      const bool isWedge = this->Random() % 4 == 0;
      for (int k = 0; k < 3; ++k)
      {
        this->AddCube(i % 3 + 4 * (i / 3) + 16 * k, isWedge);
      }
    }
    for (const auto& [square, apexes] : this->Pyramids)
    {
      const bool isCut = apexes.size() == 2 && this->Random() % 2 == 0;
      for (const auto& [base, apex] : apexes)
      {
        this->AddPyramid(base, apex, isCut ? square : Ids());
      }
    }
    std::uniform_real_distribution<double> move(-shift, shift);
    for (Point& point : this->Points)
    {
      for (double& x : point)
      {
        x += x > 0. && x < 3. ? move(this->Random) : 0.;
      }
    }
    return MakeGrid(this->Points, this->Cells);
  }

private:
  void AddCube(int first, bool isWedge)
  {
    const vtkIdType o = first;
    const Ids c = { o, o + 1, o + 5, o + 4, o + 16, o + 17, o + 21, o + 20 };
    if (isWedge)
    {
      this->Cells.push_back({ VTK_WEDGE, { c[0], c[1], c[2], c[4], c[5], c[6] } });
      this->Cells.push_back({ VTK_WEDGE, { c[0], c[2], c[3], c[4], c[6], c[7] } });
    }
    else if (this->Random() % 2 == 0)
    {
      this->Cells.push_back({ VTK_HEXAHEDRON, c });
    }
    else
    {
      const vtkIdType apex = static_cast<vtkIdType>(this->Points.size());
      const Point p = this->Points[static_cast<std::size_t>(o)];
      this->Points.push_back({ p[0] + .5, p[1] + .5, p[2] + .5 });
      for (const auto& side : { std::array<int, 4>{ 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 },
             { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 4, 0 } })
      {
        const Ids base = { c[side[0]], c[side[1]], c[side[2]], c[side[3]] };
        this->Pyramids[SolidFaces::Sort(base)].push_back({ base, apex });
      }
    }
  }

  /// cut: the corners of the square in their order, the first and last of which are a diagonal.
  void AddPyramid(const Ids& base, vtkIdType apex, const Ids& cut)
  {
    if (cut.empty())
    {
      this->Cells.push_back({ VTK_PYRAMID, { base[0], base[1], base[2], base[3], apex } });
      return;
    }
    const bool even = base[0] == cut[0] || base[2] == cut[0];
    const std::size_t s = even ? 0 : 1;
    this->Cells.push_back({ VTK_TETRA, { base[s], base[s + 1], base[(s + 2) % 4], apex } });
    this->Cells.push_back({ VTK_TETRA, { base[s], base[(s + 2) % 4], base[(s + 3) % 4], apex } });
  }

  std::mt19937 Random;
  std::vector<Point> Points;
  std::vector<Cell> Cells;
  std::map<Ids, std::vector<std::pair<Ids, vtkIdType>>> Pyramids;
};

}

TEST(HybridInversion, NoCellOfARandomBox)
{
  Counts sum;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const Counts counts = CountInverted(RandomBox(seed).Make(.3), 2, .1);
    EXPECT_EQ(counts.Inverted, 0);
    sum.Good += counts.Good;
    sum.All += counts.All;
  }
  EXPECT_GT(sum.Good, sum.All / 4);
}

namespace
{

/// A file, and how many of its solids are convex enough.
struct File
{
  const char* Name;
  int Good;
};

const File Files[] = { { "hex_geos_box_hybrid.vtu", 149 },
  { "hex_gmsh_quadtri_torus_4types.vtu", 9620 }, { "hex_mfem_tinyzoo.vtu", 4 },
  { "mix_elmer_shell_on_solid.vtu", 4096 }, { "mix_elmer_wire_pair.vtu", 825 },
  { "mix_geos_cube.vtu", 27 }, { "mix_nastran_isat.vtu", 25 }, { "nat_geos_all_types.vtu", 5 } };

class HybridInversionOfFiles : public testing::TestWithParam<File>
{
};

}

TEST_P(HybridInversionOfFiles, NoCellThatIsConvexEnough)
{
  const std::string path = file_tools::GetSharedFile(GetParam().Name);
  if (!file_tools::WhyNotRead(path).empty())
  {
    GTEST_SKIP() << file_tools::WhyNotRead(path);
  }
  const Grid control = Execute(file_tools::ReadFile(path), 0, Sharp, vtkNew<Messages>());
  const Counts counts = CountInverted(control, 1, .3);
  EXPECT_EQ(counts.Good, GetParam().Good) << "of " << counts.All;
  EXPECT_EQ(counts.Inverted, 0);
}

INSTANTIATE_TEST_SUITE_P(Shared, HybridInversionOfFiles, testing::ValuesIn(Files),
  [](const auto& file)
  {
    const std::string name = file.param.Name;
    return name.substr(0, name.find('.'));
  });
