// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundTools.h
 * How far cells are away from the limit, found at many places, and comparisons with bounds.
 */
#ifndef SubdivisionObjects_BoundTools_h
#define SubdivisionObjects_BoundTools_h

#include "FeatureTools.h"

#include "Core/Operators/MatrixFactors.h"

#include "vtkSubdivisionOperator.h"
#include "vtkSurfaceSubdivision.h"

namespace bound_tools
{

using namespace feature_tools;

/// Adds a copy of the points, as `Copy`, and arrays of one and of two components.
Grid WithValues(vtkPointSet* mesh);

/// An output, the same after further steps on the limit, and what was found at the points there.
template <typename FilterClass>
struct Bounded
{
  using Output = std::decay_t<decltype(*std::declval<FilterClass>().GetOutput())>;
  vtkSmartPointer<Output> Coarse;
  vtkSmartPointer<Output> Fine;
  int Steps;
};

/// The output with bounds.
template <typename FilterClass>
auto UpdateWithBounds(FilterClass* filter, vtkDataObject* input, int levels, bool projects)
{
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(projects);
  filter->GenerateErrorBoundsOn();
  return UpdateWithoutErrors<typename Bounded<FilterClass>::Output>(filter, input);
}

template <typename FilterClass>
Bounded<FilterClass> MakeBounded(vtkDataObject* input, int levels, int steps,
  const std::function<void(FilterClass*)>& configure, bool projects)
{
  vtkNew<FilterClass> filter;
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  if (configure)
  {
    configure(filter);
  }
  using Output = typename Bounded<FilterClass>::Output;
  Bounded<FilterClass> bounded;
  bounded.Coarse = UpdateWithBounds(filter.Get(), input, levels, projects);
  filter->GenerateErrorBoundsOff();
  filter->SetNumberOfLevels(levels + steps);
  filter->ProjectToLimitOn();
  bounded.Fine = UpdateWithoutErrors<Output>(filter.Get(), input);
  bounded.Steps = steps;
  return bounded;
}

/// The last factors of the operator of a filter.
template <typename FilterClass>
std::vector<subdivision::MatrixFactors::Matrix> GetLastFactors(FilterClass* filter, int count)
{
  vtkNew<vtkSubdivisionOperator> operation;
  EXPECT_TRUE(filter->ComputeOperator(operation));
  std::vector<subdivision::MatrixFactors::Matrix> factors(static_cast<std::size_t>(count));
  for (int f = 0; f < count; ++f)
  {
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> weights;
    operation->GetFactor(operation->GetNumberOfFactors() - count + f, offsets, ids, weights);
    const auto copy = [](auto* array, auto& buffer)
    {
      buffer = std::decay_t<decltype(buffer)>(array->GetNumberOfValues());
      std::copy(array->GetPointer(0), array->GetPointer(0) + buffer.size(), buffer.data());
    };
    copy(offsets.Get(), factors[f].Offsets);
    copy(ids.Get(), factors[f].Columns);
    copy(weights.Get(), factors[f].Weights);
  }
  return factors;
}

/// How far bounds are from what was found.
struct Tightness
{
  vtkIdType Samples = 0;
  std::vector<double> Ratios; ///< of bounds, where the truth is not rounding
  double GetMedian();
  double GetLargest() const;
};

/// A point of a fine mesh in a cell of a coarse one, by the weights of the cell's corners.
struct PlacedPoint
{
  vtkIdType Point;
  std::array<double, 4> Weights;
};
/// By the cell of the coarse mesh.
using PlacedPoints = std::map<vtkIdType, std::vector<PlacedPoint>>;

/// Expects that bounds hold at all points of the fine mesh, for points and arrays; the ratios are
/// those of all of them. `placed` has the points in cells that are not split into halves.
void ExpectBounds(vtkPointSet* coarse, vtkPointSet* fine, int steps, Tightness& tightness,
  double rounding = 1e-12, const PlacedPoints* placed = nullptr);

template <typename FilterClass>
void ExpectBounds(const Bounded<FilterClass>& bounded, Tightness& tightness)
{
  ExpectBounds(bounded.Coarse, bounded.Fine, bounded.Steps, tightness);
}

/// Options of features and joints, by the remainders of a number.
Configure ChooseFeatures(unsigned bits);

/// Prints the ratios, and expects that there are so many, and 99 of 100 are below a number.
void ExpectRatios(Tightness& tightness, std::size_t count, double of99);

/// Places in cells of an output, and where these are in control cells.
struct PlacesOfParts
{
  Ids Parts;                                  ///< cells of the output
  std::vector<std::array<double, 4>> Weights; ///< of the corners of the parts
  vtkNew<vtkIdTypeArray> Cells;               ///< control cells
  vtkNew<vtkDoubleArray> Parameters;          ///< in these

  PlacesOfParts() { this->Parameters->SetNumberOfComponents(3); }
  void Add(
    vtkIdType part, const std::array<double, 4>& weights, vtkIdType cell, const Point& parameters);
};

/// Random weights with the sum 1.
std::array<double, 4> DrawWeights(std::mt19937& random, int corners);

/// Expects that bounds of points and of `One` hold at places, whose limits the filter evaluates.
void ExpectBoundsAtPlaces(
  vtkMultiDimensionalSubdivision* filter, vtkUnstructuredGrid* output, const PlacesOfParts& places);

}

#endif
