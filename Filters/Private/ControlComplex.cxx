// SPDX-License-Identifier: BSD-3-Clause
#include "ControlComplex.h"

#include "Core/RefinedCells.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Parts runs at a simplex: those before it stay; those from it on are returned, with places of
/// their own.
std::vector<CellRun> SplitRuns(std::vector<CellRun>& runs, vtkIdType at)
{
  std::vector<CellRun> before;
  std::vector<CellRun> after;
  for (CellRun run : runs)
  {
    const vtkIdType count = std::min(std::max<vtkIdType>(at - run.FirstCell, 0), run.Count);
    CellRun rest = run;
    run.Count = count;
    rest.First += count;
    rest.Count -= count;
    if (run.Count > 0)
    {
      before.push_back(run);
    }
    if (rest.Count > 0)
    {
      after.push_back(rest);
    }
  }
  runs = before;
  return RefineRuns(after, 0);
}

/// The complex; simplices of `derived` count as cells of it that were not read.
template <typename Id>
void BuildComplexWith(
  const SimplexList& simplices, const SimplexTuples& derived, ControlComplex<Id>& control)
{
  control.DerivedRuns.clear();
  if (derived.IsEmpty())
  {
    control.Current.Complex = BuildComplex<Id>(simplices, control.Runs);
    return;
  }
  SimplexList all = simplices;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const auto& tuples = derived.Tuples[dimension];
    all.Connectivity.insert(all.Connectivity.end(), tuples.begin(), tuples.end());
    all.Dimensions.insert(
      all.Dimensions.end(), tuples.size() / (dimension + 1), static_cast<unsigned char>(dimension));
  }
  control.Current.Complex = BuildComplex<Id>(all, control.Runs);
  control.DerivedRuns = SplitRuns(control.Runs, simplices.GetNumberOfSimplices());
}

/// Singular simplices that follow from the mesh (SPEC 7); an earlier filter's are taken over.
template <typename Id>
SimplexTuples Derive(const ControlMesh& mesh, const FeatureOptions& features, const double* points,
  ControlComplex<Id>& control)
{
  if (mesh.IsStamped)
  {
    return mesh.Derived;
  }
  const SimplicialComplex<Id>& complex = control.Current.Complex;
  SimplexTuples derived;
  if (features.Embedded != EmbeddedRule::Follow)
  {
    const bool inside = features.Embedded == EmbeddedRule::SingularInside;
    DeriveEmbedded(complex, control.Runs, inside, derived);
  }
  if (features.PreserveInterfaces)
  {
    DeriveInterfaces(complex, control.Runs, mesh.Values.Material.data(), derived);
  }
  if (features.DetectFeatures)
  {
    control.Candidates = FindFeatureCandidates(complex);
    for (const FeatureCandidate& candidate : control.Candidates)
    {
      control.Features.push_back(IsFeature(candidate, points, features.FeatureAngle));
      if (control.Features.back())
      {
        derived.Tuples[1].insert(derived.Tuples[1].end(), candidate.Ends, candidate.Ends + 2);
      }
    }
  }
  return derived;
}

/// Flagged simplices, `flags` one for each that was read, and derived ones.
template <typename Id>
SingularSimplices CollectSingular(
  const ControlComplex<Id>& control, const std::vector<unsigned char>& flags)
{
  SingularSimplices singular;
  if (!flags.empty())
  {
    FlagSimplices(control.Current.Complex, control.Runs, flags.data(), singular);
  }
  const std::vector<unsigned char> all(CountCells(control.DerivedRuns).Cells, 1);
  FlagSimplices(control.Current.Complex, control.DerivedRuns, all.data(), singular);
  return singular;
}

/// Flags of control simplices, given to their children.
std::vector<unsigned char> RefineFlags(
  const SimplexList& simplices, int levels, const std::vector<unsigned char>& flags)
{
  std::vector<unsigned char> refined;
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    refined.insert(refined.end(), std::size_t(1) << (simplices.Dimensions[i] * levels), flags[i]);
  }
  return refined;
}

template <typename Id>
bool IsWhatWasRead(const SimplexList& read, const ControlComplex<Id>& control)
{
  const CellCounts counts = CountCells(control.Runs);
  if (counts.Cells != read.GetNumberOfSimplices() ||
    control.Current.Complex.NumberOfVertices != read.NumberOfPoints)
  {
    return false;
  }
  Buffer<long long> connectivity(counts.Entries);
  Buffer<long long> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  WriteCells(control.Current.Complex, control.Runs,
    CellStorage<long long>{ connectivity.data(), offsets.data(), types.data() });
  return std::equal(connectivity.begin(), connectivity.end(), read.Connectivity.begin());
}

}

template <typename Id>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const double* points, const WarnFunction& warn, ControlComplex<Id>& control)
{
  const SimplexList& simplices = mesh.GetControl();
  const int made = mesh.MadeLevels;
  control = ControlComplex<Id>();
  BuildComplexWith(simplices, SimplexTuples(), control);
  const SimplexTuples derived = Derive(mesh, features, points, control);
  if (!derived.IsEmpty())
  {
    BuildComplexWith(simplices, derived, control);
  }
  if (!mesh.IsStamped)
  {
    WarnOfContradictions(
      features, mesh.Values, mesh.Cells, control.Current.Complex, control.Runs, warn);
  }
  control.Singular = CollectSingular(control, mesh.Values.Singular);
  control.Current.Strata = BuildStrata(control.Current.Complex, control.Singular,
    MakeStrataOptions(features, mesh.Values, control.Current.Complex, control.Runs));
  if (made == 0)
  {
    return true;
  }
  for (int i = 0; i < made; ++i)
  {
    control.Current = Refine(control.Current, Depth::ForRefinement);
  }
  control.Runs = RefineRuns(control.Runs, made);
  control.DerivedRuns = RefineRuns(control.DerivedRuns, made);
  control.Singular = CollectSingular(control, RefineFlags(simplices, made, mesh.Values.Singular));
  return IsWhatWasRead(mesh.Cells.Simplices, control);
}

template bool BuildControlComplex(const ControlMesh&, const FeatureOptions&, const double*,
  const WarnFunction&, ControlComplex<int>&);
template bool BuildControlComplex(const ControlMesh&, const FeatureOptions&, const double*,
  const WarnFunction&, ControlComplex<long long>&);

}
