// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OperatorCache.h
 * The data that a filter keeps between executions: the operators of all levels and the output's
 * cells.
 */
#ifndef SubdivisionObjects_OperatorCache_h
#define SubdivisionObjects_OperatorCache_h

#include "Core/Operators/MatrixFactors.h"
#include "Core/Operators/OperatorSequence.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/Skin.h"
#include "Core/Solids/Scheme/ComposedRows.h"
#include "Core/Solids/Strata/Singularities.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/Stamp.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Uniform/OutputNumbers.h"
#include "Private/Uniform/UniformCells.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace subdivision
{

/// The operators that follow the last step: they move points and arrays to the limit, and compute
/// its normals and tangents.
template <typename Id>
struct LimitOperators
{
  SparseRows<Id> Rows; ///< none: points stay where they are
  SkinTangents<Id> Frames;
  bool HasNormals = false;
  bool HasTangents = false; ///< these go to arrays of their own

  /// Finds tangents by the skin (Skin.h) of the level so many steps before the last. False: they
  /// need the last level.
  template <typename Level>
  bool FindFrames(const Level& level, const ControlSolids& solids, int steps);
  /// The same by the last level, of any volume scheme.
  template <typename Level>
  void FindFrames(
    const Level& level, const SemiSharpStages<Id>& creases, const ControlSolids& solids);

  /// `arrays` belong to the last level; `inverted` and `turned` as in ComputeLimitNormals.
  void Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned) const;
  std::size_t GetMemorySize() const
  {
    return this->Rows.GetMemorySize() + this->Frames.GetMemorySize();
  }
};

/// The operators of consecutive steps, for either type of ids. As a sequence it must have a step,
/// and none that is cut.
class KeptSteps : public OperatorSequence
{
public:
  using OperatorSequence::Apply;
  /// `inverted` and `turned` as in ComputeLimitNormals.
  virtual void Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned) const = 0;
  /// The limits of the points before the first step; null where they are not needed.
  virtual const PointOperator* GetControlLimit() const = 0;
  /// Passes the operators that points go through, one after the other.
  virtual void ForEachOperator(const std::function<void(const PointOperator&)>& use) const = 0;
  /// The strata of the vertices and edges on which the last step works. There must be a step.
  virtual const Buffer<Stratum>& GetLastVertices() const = 0;
  virtual const Buffer<Stratum>& GetLastEdges() const = 0;
};

template <typename Id>
class KeptStepsOf : public KeptSteps
{
public:
  /// `colours`: of the points after the step; none where no array has weights.
  void Add(Stencils<Id>&& stencils, std::vector<ColourMask>&& colours)
  {
    this->Steps.push_back(std::move(stencils));
    this->Colours.push_back(std::move(colours));
  }
  /// Sets the rows that copy points to the columns of the last step, where this is cut
  /// (LevelCut.h). As in PointArrays::Take.
  void SetColumns(SparseRows<Id>&& columns, vtkIdType staying)
  {
    this->Columns = std::move(columns);
    this->Staying = staying;
  }
  /// Does the same.
  void TakeColumns(PointArrays& arrays) const
  {
    if (this->Columns.GetNumberOfRows() > 0)
    {
      arrays.Take(
        this->Columns, [this](vtkIdType row) { return this->Columns.Columns[row]; }, this->Staying);
    }
  }
  /// The operators that follow the last step.
  LimitOperators<Id>& GetLimit() { return this->Limit; }
  void SetControlLimit(SparseRows<Id>&& limit) { this->ControlLimit = std::move(limit); }
  const PointOperator* GetControlLimit() const override
  {
    return this->ControlLimit.GetNumberOfRows() > 0 ? &this->ControlLimit : nullptr;
  }
  void Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned) const override
  {
    for (std::size_t i = 0; i < this->Steps.size(); ++i)
    {
      if (i + 1 == this->Steps.size())
      {
        this->TakeColumns(arrays);
      }
      arrays.Advance(this->Steps[i]);
      arrays.KeepColours(this->Colours[i]);
    }
    this->Limit.Apply(arrays, inverted, turned);
  }
  void ForEachOperator(const std::function<void(const PointOperator&)>& use) const override
  {
    for (const Stencils<Id>& step : this->Steps)
    {
      use(step);
    }
    if (this->Limit.Rows.GetNumberOfRows() > 0)
    {
      use(this->Limit.Rows);
    }
  }
  void Apply(const double* values, int components, Buffer<double>& result) const override
  {
    ApplyInSequence(this->Steps, values, components, result);
  }
  SparseRows<int> ComposeWith(const SparseRows<int>& rows) const override
  {
    SparseRows<int> composed;
    for (auto step = this->Steps.rbegin(); step != this->Steps.rend(); ++step)
    {
      composed = Compose(step == this->Steps.rbegin() ? rows : composed, *step);
    }
    return composed;
  }
  const Buffer<Stratum>& GetLastVertices() const override { return this->Steps.back().Vertices; }
  const Buffer<Stratum>& GetLastEdges() const override { return this->Steps.back().Edges; }
  std::size_t GetMemorySize() const override
  {
    std::size_t bytes = this->Limit.GetMemorySize() + this->ControlLimit.GetMemorySize() +
      this->Columns.GetMemorySize();
    for (const Stencils<Id>& step : this->Steps)
    {
      bytes += step.GetMemorySize();
    }
    for (const std::vector<ColourMask>& colours : this->Colours)
    {
      bytes += colours.size() * sizeof(ColourMask);
    }
    return bytes;
  }

private:
  std::vector<Stencils<Id>> Steps;
  std::vector<std::vector<ColourMask>> Colours;
  SparseRows<Id> Columns;
  vtkIdType Staying = 0;
  LimitOperators<Id> Limit;
  SparseRows<Id> ControlLimit;
};

/// The cells and choices on which the operators depend. Keys are compared by content; feature edges
/// are compared apart from them.
struct TopologyKey
{
  SimplexList Simplices;
  StampScheme Scheme = StampScheme::BoxSpline;
  int MadeLevels = 0;
  vtkIdType NumberOfControlPoints = 0;
  int Levels = 0;
  bool Use32BitIds = false;
  WantedSimplices Wanted;
  /// Options, flags and values that choose rules, in a fixed order.
  std::vector<long long> Choices;
  SharpTuples Derived; ///< marked simplices, or those of an earlier filter

  /// The same cells and steps, whatever the choices are.
  bool HasSameCells(const TopologyKey& other) const
  {
    return this->Scheme == other.Scheme && this->MadeLevels == other.MadeLevels &&
      this->Levels == other.Levels && this->NumberOfControlPoints == other.NumberOfControlPoints &&
      this->Use32BitIds == other.Use32BitIds && this->Wanted == other.Wanted &&
      this->Simplices.NumberOfPoints == other.Simplices.NumberOfPoints &&
      this->Simplices.Dimensions == other.Simplices.Dimensions &&
      this->Simplices.Connectivity == other.Simplices.Connectivity;
  }
  bool operator==(const TopologyKey& other) const
  {
    return this->Choices == other.Choices && this->HasSameCells(other) &&
      std::equal(this->Derived.Tuples.Tuples, this->Derived.Tuples.Tuples + 3,
        other.Derived.Tuples.Tuples) &&
      std::equal(this->Derived.Sharpness, this->Derived.Sharpness + 3, other.Derived.Sharpness);
  }
  std::size_t GetMemorySize() const;
};

/// The factor that adds the centres of split cells behind the points of the input. It copies points
/// where there are no centres.
void AppendCentres(const SimplicesOfCells& cells, MatrixFactors& factors);

struct KeptOperator : KeptEntry
{
  TopologyKey Key;
  std::unique_ptr<KeptSteps> Steps; ///< null for no step and no limit
  UniformCells Cells;
  std::vector<vtkIdType> Parents;           ///< whose values children take, as in UniformRun
  Buffer<Stratum> ControlStrata;            ///< of the vertices, if there are no steps
  Buffer<unsigned char> ManifoldDimensions; ///< of each control simplex
  SharpTuples Derived;                      ///< derived singular simplices: points of the output
  SimplexTuples ControlDerived;             ///< the same: points of the control mesh
  /// The edges that were tested for the feature angle, and which of them exceed it. They are tested
  /// again when points move.
  std::vector<FeatureCandidate> Candidates;
  std::vector<bool> Features;
  FaceSides Sides; ///< of the level that was read, where normals are made
  bool HasNormals = false;
  /// The warnings that building gave.
  std::vector<std::string> Warnings;
  /// Points that went in (a copy), how far interpolation moved them, and points that came out.
  vtkSmartPointer<vtkDataArray> PointsIn;
  double PointsWeight = 0.;
  vtkSmartPointer<vtkDataArray> PointsOut;
  vtkSmartPointer<vtkDataArray> NormalsOut; ///< null: the output has none that the filter made
  bool IsUpright = false;                   ///< with these points no solid is inside out
  SharedArrays HandedCells; ///< Cells, and PointsOut with NormalsOut, which the output has
  SharedArrays HandedPoints;

  /// Sets the arrays that the output has, after nothing else changes it.
  void HandOut(const UniformCells& cells, vtkPointSet* output);
  /// Whether nobody wrote into the output's cells, or its points.
  bool HasCells() const;
  bool HasPoints() const;

  std::size_t GetMemorySize() const override;
};

}

#endif
