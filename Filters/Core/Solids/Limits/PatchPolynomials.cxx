// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchPolynomials.h"

#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Limits/LatticeCorners.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/SharpLattice.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace subdivision
{
namespace
{

/// Coefficients over whole simplices, which are regular, are multiples of 1/24, whose last digits
/// got lost in sums.
double Sharpen(double coefficient)
{
  const double sharp = std::round(24. * coefficient) / 24.;
  return std::abs(sharp - coefficient) < 1e-13 ? sharp : coefficient;
}

/// The number of an edge or face with some corners.
int FindSimplex(
  const SimplicialComplex<int>& complex, int dimension, const std::array<int, 3>& corners)
{
  const int size = dimension + 1;
  const int* listed = dimension == 1 ? complex.EdgeVertices.data() : complex.FaceVertices.data();
  int number = 0;
  while (!std::is_permutation(listed, listed + size, corners.begin()))
  {
    listed += size;
    ++number;
  }
  return number;
}

/// The polynomial that is 1 at a node of the lattice and 0 at all others: integers, divided once.
PatchPolynomial ExpandNode(const PlaceNode& node)
{
  const double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  PatchPolynomial polynomial{};
  polynomial[0] = 1.;
  double divisor = 1.;
  for (int i = 0; i < 3; ++i)
  {
    for (int r = 0; r < node[i]; ++r)
    {
      polynomial = MultiplyByLinear(PatchPowers::Quartic, polynomial,
        LatticeSize * weights[i][0] - r, LatticeSize * weights[i][1], LatticeSize * weights[i][2]);
      divisor *= r + 1;
    }
  }
  for (double& value : polynomial)
  {
    value /= divisor;
  }
  return polynomial;
}

/// The mesh of a key: all cells at its corners.
class SheetMesh
{
public:
  explicit SheetMesh(const SheetKey& key)
  {
    key.Places == SheetPlaces::Curve ? this->AddCurve(key) : this->AddTriangles(key);
  }
  /// The rows of the powers of which the limit over the part is a sum, over the columns of the key.
  /// The sums of nodes that are powers go back as derivatives do (PlaceSum.h), so that they have
  /// the precision of numbers of their own size, however small the part.
  std::vector<double> FindPowers(const SheetKey& key, LoopWeights ofSurfaces) const
  {
    const int dimension = key.Places == SheetPlaces::Face ? 2 : 1;
    LatticeCorners corners{ { { { 1, 0, 0, 0 } }, { { 0, 1, 0, 0 } }, { { 0, 0, 1, 0 } }, {} } };
    int level = 2; // that has the nodes
    for (const int child : ListChildrenTo(key.Part))
    {
      GoToChild(dimension, child, corners);
      ++level;
    }
    const Level<int> control = this->MakeLevel(ofSurfaces);
    const SemiSharpStages<int> noCreases;
    const LevelLattices<Level<int>> lattices(control, noCreases);
    const auto lattice = lattices.Make();
    const std::array<int, 3> own{ { 0, 1, 2 } };
    const int simplex = FindSimplex(control.Complex, dimension, own);
    const int* listed = lattice->GetSmooth().GetCorners(dimension, simplex);
    PlaceSum<LevelLattices<Level<int>>::Lattice, PatchPolynomial> sum(*lattice);
    for (const PlaceNode& node : ListLattice(dimension))
    {
      const LatticeWeights combined = CombineCorners(corners, node);
      LatticeWeights at{};
      for (int k = 0; k <= dimension; ++k)
      {
        at[k] = combined[listed[k]];
      }
      sum.AddLimit(lattice->GetSmooth().Find(dimension, simplex, at), ExpandNode(node));
    }
    sum.StepBack(level);
    const std::size_t columns = this->Equals.size();
    std::vector<double> weights(QuarticPowers * columns, 0.);
    sum.ForColumns(
      [&](int column, const PatchPolynomial& powers)
      {
        for (std::size_t p = 0; p < QuarticPowers; ++p)
        {
          weights[p * columns + static_cast<std::size_t>(column)] = powers[p];
        }
      });
    return weights;
  }
  /// Reads the child off this mesh after a step. All that it depends on is there.
  SheetChild FindChild(int child, LoopWeights ofSurfaces) const
  {
    Level<int> level = this->MakeLevel(ofSurfaces);
    const Level<int> refined = Refine(level, Depth::ForRefinement);
    const auto getMiddle = [&](int a, int b)
    {
      return a == b
        ? a
        : level.Complex.NumberOfVertices + FindSimplex(level.Complex, 1, { { a, b, -1 } });
    };
    std::array<int, 3> corners{};
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = child < 3 ? getMiddle(child, i) : getMiddle(i, (i + 1) % 3);
    }
    SheetChild made;
    SheetPatch<int> patch;
    const int face = FindSimplex(refined.Complex, 2, corners);
    if (!SheetReader<Level<int>>(refined).ReadFace(face, corners, patch))
    {
      return made;
    }
    made.Key = patch.Key;
    const Stencils<int> stencils = TakeStencils(level);
    const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        ExplicitRows<int> entries;
        stencils.AppendRow(patch.Columns[i], 1., entries);
        for (std::size_t k = 0; k < entries.Columns.size(); ++k)
        {
          rows.Add(entries.Columns[k], entries.Weights[k]);
        }
        rows.EndRow();
      }
    };
    made.Rows = BlockOperator<int>(static_cast<vtkIdType>(this->Equals.size()),
      static_cast<vtkIdType>(patch.Columns.size()), append)
                  .Store();
    return made;
  }

private:
  using Corners = std::array<int, 3>;
  void AddCurve(const SheetKey& key)
  {
    const int own[2] = { 0, 1 };
    this->AddCell(own, 2);
    int next = 2;
    for (int end = 0; end < 2; ++end)
    {
      if (key.Fans[end].What == SheetFan::Kind::Open)
      {
        const int line[2] = { end, next++ };
        this->AddCell(line, 2);
      }
      else
      {
        this->Fixed.push_back(end);
      }
    }
    this->Equals.resize(next);
    std::iota(this->Equals.begin(), this->Equals.end(), 0);
  }
  void AddTriangles(const SheetKey& key)
  {
    // The vertices at each corner: those Before, the other two corners, those After.
    std::array<std::vector<int>, 3> fans;
    int next = 3;
    int across[3]
              [2]; // at each corner the vertices across the edges to the next and to the last one
    for (int i = 0; i < 3; ++i)
    {
      const SheetFan& fan = key.Fans[i];
      std::vector<int>& vertices = fans[i];
      const int firstAfter = next;
      next += fan.After;
      for (int k = fan.Before; k > 0; --k)
      {
        vertices.push_back(next + k - 1);
      }
      const bool isClosed = fan.IsClosed();
      across[i][0] = isClosed ? firstAfter + fan.After - 1 : fan.Before > 0 ? next : -1;
      across[i][1] = fan.After > 0 ? firstAfter : -1;
      next += fan.Before;
      vertices.push_back((i + 1) % 3);
      vertices.push_back((i + 2) % 3);
      for (int k = 0; k < fan.After; ++k)
      {
        vertices.push_back(firstAfter + k);
      }
      if (isClosed)
      {
        vertices.push_back((i + 1) % 3);
      }
      if (fan.What == SheetFan::Kind::ClosedCorner || fan.What == SheetFan::Kind::OpenCorner)
      {
        this->Fixed.push_back(i);
      }
    }
    this->Equals.resize(next);
    std::iota(this->Equals.begin(), this->Equals.end(), 0);
    for (int i = 0; i < 3; ++i)
    {
      if (across[i][0] >= 0 && across[(i + 1) % 3][1] >= 0)
      {
        const int a = this->FindFirst(across[i][0]);
        const int b = this->FindFirst(across[(i + 1) % 3][1]);
        this->Equals[std::max(a, b)] = std::min(a, b);
      }
    }
    std::set<Corners> triangles;
    for (int i = 0; i < 3; ++i)
    {
      if (key.Fans[i].What == SheetFan::Kind::Open ||
        key.Fans[i].What == SheetFan::Kind::OpenCorner)
      {
        for (const int end : { fans[i].front(), fans[i].back() })
        {
          this->Creases.insert(
            { std::min(i, this->FindFirst(end)), std::max(i, this->FindFirst(end)) });
        }
      }
      for (std::size_t k = 0; k + 1 < fans[i].size(); ++k)
      {
        Corners corners{ { i, this->FindFirst(fans[i][k]), this->FindFirst(fans[i][k + 1]) } };
        std::sort(corners.begin(), corners.end());
        if (triangles.insert(corners).second)
        {
          this->AddCell(corners.data(), 3);
        }
      }
    }
  }

  void AddCell(const int* corners, int size)
  {
    this->Cells.Dimensions.push_back(static_cast<unsigned char>(size - 1));
    this->Cells.Connectivity.insert(this->Cells.Connectivity.end(), corners, corners + size);
  }
  Level<int> MakeLevel(LoopWeights ofSurfaces) const
  {
    const auto columns = static_cast<int>(this->Equals.size());
    SimplexList cells = this->Cells;
    cells.NumberOfPoints = columns;
    std::vector<CellRun> runs;
    Level<int> level;
    level.Complex = BuildComplex<int>(cells, runs);
    SingularSimplices singular;
    singular.Vertices = Buffer<unsigned char>(columns, 0);
    for (const int vertex : this->Fixed)
    {
      singular.Vertices[vertex] = 1;
    }
    singular.Edges = Buffer<unsigned char>(level.Complex.NumberOfEdges, 0);
    for (vtkIdType e = 0; e < singular.Edges.size(); ++e)
    {
      const auto [a, b] =
        std::minmax({ level.Complex.EdgeVertices[2 * e], level.Complex.EdgeVertices[2 * e + 1] });
      singular.Edges[e] = this->Creases.count({ a, b });
    }
    StrataOptions options;
    options.Weights = ofSurfaces;
    level.Strata = BuildStrata(level.Complex, singular, options);
    return level;
  }

  int FindFirst(int column) const
  {
    while (this->Equals[column] != column)
    {
      column = this->Equals[column];
    }
    return column;
  }

  std::vector<int> Equals; ///< of each column an earlier one that is the same vertex, or itself
  std::vector<int> Fixed;  ///< vertices that are corners
  /// The edges on which the sheet ends. Both sides of a crease may be in the mesh.
  std::set<std::array<int, 2>> Creases;
  SimplexList Cells;
};

}

const std::vector<double>& PatchPolynomials::Find(const SheetKey& key)
{
  std::vector<double>& found = this->Found[key.Pack()];
  if (found.empty())
  {
    found = SheetMesh(key).FindPowers(key, this->Weights);
    if (key.Part == 1)
    {
      std::transform(found.begin(), found.end(), found.begin(), Sharpen);
    }
  }
  return found;
}

const SparseRows<int>& PatchPolynomials::FindSparse(const SheetKey& key)
{
  const auto [found, isNew] = this->Sparse.try_emplace(key.Pack());
  if (isNew)
  {
    const std::vector<double>& weights = this->Find(key);
    const auto columns = static_cast<vtkIdType>(weights.size()) / QuarticPowers;
    const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
    {
      for (vtkIdType power = begin; power < end; ++power)
      {
        for (vtkIdType k = 0; k < columns; ++k)
        {
          const double weight = weights[power * columns + k];
          weight != 0. ? rows.Add(static_cast<int>(k), weight) : void();
        }
        rows.EndRow();
      }
    };
    found->second = BlockOperator<int>(columns, QuarticPowers, append).Store();
  }
  return found->second;
}

const SheetChild& PatchPolynomials::FindChild(const SheetKey& key, int child)
{
  SheetKey part = key;
  part.Part = static_cast<std::uint16_t>(4 + child);
  const auto [found, isNew] = this->Children.try_emplace(part.Pack());
  if (isNew)
  {
    found->second = SheetMesh(key).FindChild(child, this->Weights);
  }
  return found->second;
}

}
