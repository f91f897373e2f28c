// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitTools.h
 * Rule options for any mesh, by name, semi-sharp creases of a mesh on all levels, and LocalLimit as
 * one operator.
 */
#ifndef SubdivisionObjects_LimitTools_h
#define SubdivisionObjects_LimitTools_h

#include "CoreZoo.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Scheme/SemiSharp.h"

namespace coretest
{

/// Choices of rules that together reach every line of Mathematics 4 and 6, and of weights.
const char* const OptionNames[] = { "Blend", "Dart", "Sharp", "Follow1", "Follow2", "Follow3",
  "FollowPart", "Regional", "LoopWeights", "ModifiedBoundary", "ModifiedDart" };

template <typename Id>
StrataOptions MakeOptions(const std::string& name, const SimplicialComplex<Id>& complex)
{
  StrataOptions options;
  std::mt19937 random(7);
  auto fill = [&random](auto& buffer, vtkIdType size, int choices, int offset)
  {
    buffer = std::decay_t<decltype(buffer)>(size);
    for (auto& value : buffer)
    {
      value =
        static_cast<std::decay_t<decltype(value)>>(offset + static_cast<int>(random() % choices));
    }
  };
  options.DartEnds = name == "Dart" || name == "Regional";
  options.Weights = name == "LoopWeights" ? LoopWeights::Loop : LoopWeights::Warren;
  if (name == "ModifiedBoundary" || name == "ModifiedDart")
  {
    options.ModifiedBoundary = true;
    options.DartEnds = name == "ModifiedDart";
    options.CornerAngles = Buffer<double>(complex.NumberOfVertices);
    const double angles[] = { -1., 0.4, 1.5, 2.5, 4., 5. };
    for (double& angle : options.CornerAngles)
    {
      angle = angles[random() % 6];
    }
  }
  if (name == "Sharp")
  {
    options.Type1 = options.Type2 = options.Type3 = JointRule::Sharp;
  }
  for (int k = 1; k <= 3; ++k)
  {
    if (name == "Follow" + std::to_string(k))
    {
      options.Type1 = static_cast<JointRule>(static_cast<int>(JointRule::FollowDimension1) + k - 1);
      options.Type3 = JointRule::Sharp;
    }
  }
  if (name == "FollowPart")
  {
    options.Type2 = JointRule::FollowPart;
    fill(options.EdgeParts, complex.NumberOfEdges, 2, 0);
    fill(options.FaceParts, complex.NumberOfFaces, 2, 0);
  }
  if (name == "Regional")
  {
    fill(options.VertexChoices, complex.NumberOfVertices, 6, 0);
    fill(options.EdgeChoices, complex.NumberOfEdges, 6, 0);
  }
  return options;
}

template <typename Id>
Subdivided<Id> BuildNamed(const Mesh& mesh, const std::string& options)
{
  Subdivided<Id> built;
  built.Level.Complex = BuildComplex<Id>(mesh.Cells, built.Runs);
  built.Level.Strata = BuildStrata(built.Level.Complex,
    FlagSingular(built.Level.Complex, mesh.Singular), MakeOptions(options, built.Level.Complex));
  return built;
}

/// A mesh whose edges and faces have a sharpness, on any level.
class SemiSharpMesh
{
public:
  /// Sharpness by chance: none, or some number up to 3.5.
  SemiSharpMesh(const Mesh& mesh, std::string options, unsigned int seed);
  /// A level as it is where all edges and faces are singular that are sharper than `sharpness`.
  Level<int> MakeLevel(int steps, double sharpness, Depth depth = Depth::ForRefinement) const;
  Level<int> MakeSmoothLevel(int steps) const { return this->MakeLevel(steps, 1e9); }
  SemiSharpStages<int> MakeStages(int steps) const;
  /// The same without stages, for a level with such a complex.
  SemiSharpStages<int> GiveSharpness(int steps, const SimplicialComplex<int>& complex) const;
  double GetMostSharpness() const;
  Stencils<int> MakeStencils(int steps) const;

  Mesh Control;
  SolidSharpness Sharpness;

private:
  std::string Options;
};

/// A test of each mesh with each choice of rules.
template <typename Test>
void ForEachMeshAndOptions(const Test& test)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      test(mesh, options);
    }
  }
}

inline void ExpectSameStart(const std::vector<double>& a, const std::vector<double>& b)
{
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    ASSERT_NEAR(a[i], b[i], 1e-13) << "value " << i;
  }
}

/// Values that nothing is hidden in.
std::vector<double> MakeValues(vtkIdType size, unsigned int seed);

template <typename Operator>
std::vector<double> ApplyTo(const Operator& rows, const std::vector<double>& values, int components)
{
  std::vector<double> result(rows.GetNumberOfRows() * components);
  rows.Apply(values.data(), result.data(), components);
  return result;
}

/// The weight of a vertex in a row.
template <typename Id>
double GetWeight(const SparseRows<Id>& rows, vtkIdType row, vtkIdType column)
{
  double sum = 0.;
  for (vtkIdType k = rows.Offsets[row]; k < rows.Offsets[row + 1]; ++k)
  {
    sum += rows.Columns[k] == column ? rows.Weights[k] : 0.;
  }
  return sum;
}

/// The rows of a LocalLimit, or of LimitByLevels, over the control vertices, each with one entry
/// for each of these.
template <typename Limit>
auto BuildRows(const Limit& limit)
{
  using Id = std::decay_t<decltype(limit.GetVertices(0)[0])>;
  std::vector<SparseRows<Id>> parts;
  SparseRows<Id> product;
  const SparseRows<Id>* before = nullptr; // the rows of the level before over control values
  for (int level = 0; level < limit.GetNumberOfLevels(); ++level)
  {
    const SparseRows<Id>& own = limit.GetRowsOfLevel(level);
    if (level > 0)
    {
      product = Multiply(own, *before);
    }
    before = level == 0 ? &own : &product;
    parts.push_back(Multiply(limit.GetLimitsOnLevel(level), *before));
  }
  SparseRows<Id> rows;
  rows.NumberOfColumns = limit.GetNumberOfColumns();
  rows.Offsets = Buffer<Id>(limit.GetNumberOfRows() + 1, 0);
  const auto forRows = [&](const auto& act)
  {
    for (int level = 0; level < limit.GetNumberOfLevels(); ++level)
    {
      const Id* offset = parts[level].Offsets.data();
      for (const Id vertex : limit.GetVertices(level))
      {
        act(vertex, parts[level], offset[0], offset[1]);
        ++offset;
      }
    }
  };
  forRows(
    [&](Id row, const SparseRows<Id>&, Id begin, Id end) { rows.Offsets[row] = end - begin; });
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<Id>(rows.Offsets[limit.GetNumberOfRows()]);
  rows.Weights = Buffer<double>(rows.Columns.size());
  forRows(
    [&](Id row, const SparseRows<Id>& part, Id begin, Id end)
    {
      std::copy_n(
        part.Columns.begin() + begin, end - begin, rows.Columns.begin() + rows.Offsets[row]);
      std::copy_n(
        part.Weights.begin() + begin, end - begin, rows.Weights.begin() + rows.Offsets[row]);
    });
  return rows;
}

/// The number of values that it computes on all levels, as a measure of its work.
template <typename Limit>
vtkIdType CountSupportValues(const Limit& limit)
{
  vtkIdType values = 0;
  for (int level = 0; level < limit.GetNumberOfLevels(); ++level)
  {
    values += limit.GetRowsOfLevel(level).GetNumberOfRows();
  }
  return values;
}

}

#endif
