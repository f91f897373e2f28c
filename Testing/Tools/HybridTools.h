// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridTools.h
 * Small meshes of cells of all types, their levels and points.
 */
#ifndef SubdivisionObjects_HybridTools_h
#define SubdivisionObjects_HybridTools_h

#include "CoreZoo.h"
#include "HybridReference.h"

#include "Core/Solids/Hybrid/HybridLevel.h"

namespace hybrid_tools
{

using namespace subdivision;

struct Cell
{
  CellShape Shape;
  std::vector<vtkIdType> Corners;
};

/// The options of strata that are not lists.
struct Choices
{
  JointRule Type1 = JointRule::Blend;
  JointRule Type2 = JointRule::Blend;
  JointRule Type3 = JointRule::Blend;
  bool DartEnds = false;
  LoopWeights Weights = LoopWeights::Warren;
  bool ModifiedBoundary = false;

  StrataOptions Make() const
  {
    StrataOptions options;
    options.Type1 = this->Type1;
    options.Type2 = this->Type2;
    options.Type3 = this->Type3;
    options.DartEnds = this->DartEnds;
    options.Weights = this->Weights;
    options.ModifiedBoundary = this->ModifiedBoundary;
    return options;
  }
};

/// What meshes of simplices are held against the tet/oct scheme with.
std::vector<Choices> MakeChoices();

/// A control mesh, and which parts of it are singular.
struct HybridMesh
{
  std::vector<Cell> Cells;
  std::vector<double> Points; ///< three for each
  std::set<coretest::Tuple> Singular;
  std::map<coretest::Tuple, double> Sharpness; ///< of sorted edges and faces
  Choices Options;

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()) / 3; }
  void AddPoint(double x, double y, double z)
  {
    this->Points.insert(this->Points.end(), { x, y, z });
  }
};

template <typename Id>
HybridLevel<Id> MakeLevel(const HybridMesh& mesh)
{
  CellList<Id> list;
  list.NumberOfPoints = mesh.GetNumberOfPoints();
  const auto size = static_cast<vtkIdType>(mesh.Cells.size());
  list.Shapes = Buffer<CellShape>(size);
  list.Offsets = Buffer<Id>(size + 1, Id(0));
  std::vector<Id> corners;
  for (vtkIdType c = 0; c < size; ++c)
  {
    list.Shapes[c] = mesh.Cells[c].Shape;
    corners.insert(corners.end(), mesh.Cells[c].Corners.begin(), mesh.Cells[c].Corners.end());
    list.Offsets[c + 1] = static_cast<Id>(corners.size());
  }
  list.Corners = Buffer<Id>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), list.Corners.begin());
  HybridLevel<Id> level;
  level.Complex = BuildCellComplex(std::move(list));
  const CellComplex<Id>& complex = level.Complex;
  SingularSimplices singular;
  SolidSharpness sharpness;
  const auto flag =
    [&](Buffer<unsigned char>& flags, std::vector<double>& sharp, Id count, const auto& tuple)
  {
    flags = Buffer<unsigned char>(mesh.Singular.empty() ? 0 : vtkIdType(count));
    for (vtkIdType i = 0; i < flags.size(); ++i)
    {
      flags[i] = mesh.Singular.count(coretest::Sorted(tuple(static_cast<Id>(i)))) ? 1 : 0;
    }
    for (Id i = 0; !mesh.Sharpness.empty() && i < count; ++i)
    {
      const auto found = mesh.Sharpness.find(coretest::Sorted(tuple(i)));
      sharp.push_back(found == mesh.Sharpness.end() ? 0. : found->second);
    }
  };
  std::vector<double> ofVertices;
  flag(singular.Vertices, ofVertices, complex.NumberOfVertices,
    [](Id v) { return coretest::Tuple{ v }; });
  flag(singular.Edges, sharpness.Edges, complex.NumberOfEdges,
    [&](Id e)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(e);
      return coretest::Tuple(ends, ends + 2);
    });
  flag(singular.Faces, sharpness.Faces, complex.NumberOfFaces,
    [&](Id f)
    {
      const Row<Id> vertices = complex.GetVertices(f);
      return coretest::Tuple(vertices.begin(), vertices.end());
    });
  level.Strata = DecideHybridStrata(complex, singular, mesh.Options.Make());
  level.Sharpness =
    DecideHybridSharpness(complex, singular, mesh.Options.Make(), std::move(sharpness));
  return level;
}

template <typename Id>
std::vector<double> ApplyStep(const HybridLevel<Id>& level, const std::vector<double>& points,
  int components = 3, HybridRules rules = HybridRules::Smooth)
{
  const HybridRows<Id> rows(level, rules);
  std::vector<double> next(static_cast<std::size_t>(rows.GetNumberOfRows() * components));
  rows.Apply(points.data(), next.data(), components);
  return next;
}

/// The points after some steps.
template <typename Id = int>
std::vector<double> Subdivide(const HybridMesh& mesh, int levels)
{
  HybridLevel<Id> level = MakeLevel<Id>(mesh);
  std::vector<double> points = mesh.Points;
  for (int i = 0; i < levels; ++i)
  {
    points = ApplyStep(level, points);
    level = RefineHybrid(level, HybridRules::Smooth);
  }
  return points;
}

/// A mesh of the reference for the product; its interfaces of materials become singular sides.
HybridMesh Take(const hybridtest::Mesh& from);
HybridMesh Take(const coretest::Mesh& from);

/// Makes some edges and faces sharp for up to three steps.
void AddSharpness(unsigned int seed, HybridMesh& mesh);

/// Points in an order that does not depend on their numbers.
std::vector<std::array<double, 3>> SortPoints(const std::vector<double>& points);
void ExpectSamePoints(const std::vector<double>& a, const std::vector<double>& b, double tolerance);

/// The row of a point after one step: a weight for each control point.
std::vector<double> GetRow(const HybridMesh& mesh, vtkIdType row);

/// A box of n^3 unit cubes, moved and with other corner numbers by `seed`; 0: a lattice.
HybridMesh MakeBox(int n, unsigned int seed);

/// n hexahedra, or wedges, around the edges 0 1 and 1 2.
HybridMesh MakeColumn(CellShape shape, int n);

}

#endif
