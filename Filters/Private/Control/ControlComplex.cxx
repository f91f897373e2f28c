// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/ControlComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace subdivision
{
namespace
{

/// Splits runs at simplex `at`: `runs` keeps those before it. Those from it on are returned, with
/// cells that count from 0.
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

/// Builds the complex. Derived simplices are added to the simplices that were read, as cells with
/// runs of their own.
template <typename Id>
SimplicialComplex<Id> BuildComplexWith(const SimplexList& simplices, ControlTraits& traits)
{
  traits.DerivedRuns.clear();
  if (traits.Derived.Tuples.IsEmpty())
  {
    return BuildComplex<Id>(simplices, traits.Runs);
  }
  SimplicialComplex<Id> complex =
    BuildComplex<Id>(AddTuples(simplices, traits.Derived.Tuples), traits.Runs);
  traits.DerivedRuns = SplitRuns(traits.Runs, simplices.GetNumberOfSimplices());
  return complex;
}

/// The sharpness of derived lines; empty if all are infinite. `known` has that of marked ones.
std::vector<double> FindLineSharpness(const SharpTuples& known, const std::vector<vtkIdType>& lines)
{
  std::vector<double> sharpness;
  std::map<SimplexKey, double> found;
  for (std::size_t i = 0; i < known.Sharpness.size(); ++i)
  {
    found.emplace(MakeKey(known.Tuples.Tuples[1].data() + 2 * i, 2), known.Sharpness[i]);
  }
  // A line that is derived otherwise too stands there twice, and is sharp for ever.
  std::map<SimplexKey, int> counts;
  for (std::size_t i = 0; !found.empty() && i < lines.size(); i += 2)
  {
    ++counts[MakeKey(lines.data() + i, 2)];
  }
  for (std::size_t i = 0; !found.empty() && i < lines.size(); i += 2)
  {
    const SimplexKey key = MakeKey(lines.data() + i, 2);
    const auto mark = found.find(key);
    const bool isSemiSharp = mark != found.end() && counts[key] == 1;
    sharpness.push_back(isSemiSharp ? mark->second : std::numeric_limits<double>::infinity());
  }
  return sharpness;
}

/// Finds the singular simplices that follow from embedded cells, materials and angles (Mathematics
/// 7). Those of a stamped mesh were derived by an earlier filter and are taken over.
template <typename Id>
SharpTuples Derive(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, ControlComplex<Id>& control)
{
  if (mesh.IsStamped)
  {
    return mesh.Derived;
  }
  const SimplicialComplex<Id>& complex = control.Current.Complex;
  SimplexTuples derived = mesh.Derived.Tuples;
  if (features.Embedded != EmbeddedRule::Follow)
  {
    const bool inside = features.Embedded == EmbeddedRule::SingularInside;
    DeriveEmbedded(complex, control.Runs, inside, derived);
  }
  if (features.PreserveInterfaces)
  {
    DeriveInterfaces(complex, control.Runs, mesh.Values.Material.data(),
      FindSharpness(mesh.Values, complex, control.Runs).Faces, derived);
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
  // One order, whatever a simplex is derived from, for partitions.
  const bool isMarked = !mesh.Derived.Tuples.IsEmpty();
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    if (isMarked || (dimension == 1 && features.PreserveInterfaces && features.DetectFeatures))
    {
      SortTuples(derived, dimension);
    }
  }
  return { derived, FindLineSharpness(mesh.Derived, derived.Tuples[1]) };
}

}

template <typename Id>
SingularSimplices CollectSingular(const SimplicialComplex<Id>& complex, const ControlTraits& traits,
  const std::vector<unsigned char>& flags)
{
  SingularSimplices singular;
  if (!flags.empty())
  {
    FlagSimplices(complex, traits.Runs, flags.data(), singular);
  }
  std::vector<unsigned char> derived(CountCells(traits.DerivedRuns).Cells, 1);
  // Lines with a finite sharpness are no singular ones.
  vtkIdType children = 0;
  for (const CellRun& run : traits.DerivedRuns)
  {
    children += run.Dimension == 1 ? run.Count : 0;
  }
  const std::size_t lines = traits.Derived.Sharpness.size();
  const std::size_t first = traits.Derived.Tuples.Tuples[0].size();
  for (std::size_t i = 0; lines > 0 && i < static_cast<std::size_t>(children); ++i)
  {
    derived[first + i] =
      std::isinf(traits.Derived.GetSharpness(i / (static_cast<std::size_t>(children) / lines)));
  }
  FlagSimplices(complex, traits.DerivedRuns, derived.data(), singular);
  return singular;
}

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

namespace
{

/// For each tetrahedron of the control complex, the simplex of the control mesh that it is.
template <typename Id>
std::vector<vtkIdType> NumberSolids(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs)
{
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(complex.NumberOfTets));
  for (const CellRun& run : runs)
  {
    for (vtkIdType i = 0; run.Dimension == 3 && !run.Equal && i < run.Count; ++i)
    {
      numbers[run.First + i] = run.FirstCell + i;
    }
  }
  return numbers;
}

/// Adds the sharpness of derived lines to that of edges.
template <typename Id>
void AddDerivedSharpness(const SimplicialComplex<Id>& complex, ControlTraits& control)
{
  if (control.Derived.Sharpness.empty())
  {
    return;
  }
  control.Sharpness.Edges.resize(static_cast<std::size_t>(complex.NumberOfEdges), 0.);
  const auto first = static_cast<vtkIdType>(control.Derived.Tuples.Tuples[0].size());
  for (const CellRun& run : control.DerivedRuns)
  {
    for (vtkIdType i = 0; run.Dimension == 1 && i < run.Count; ++i)
    {
      const double sharpness =
        control.Derived.GetSharpness(static_cast<std::size_t>(run.FirstCell + i - first));
      double& edge =
        control.Sharpness
          .Edges[run.Equal ? static_cast<vtkIdType>(complex.EqualLines.Twins[run.First + i])
                           : run.First + i];
      edge = std::isinf(sharpness) ? edge : std::max(edge, sharpness);
    }
  }
}

/// Builds the control level: complex, singular simplices and strata.
template <typename Id>
bool BuildControlLevel(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, ControlComplex<Id>& control)
{
  control = ControlComplex<Id>();
  SimplicialComplex<Id>& complex = control.Current.Complex;
  complex = BuildComplexWith<Id>(mesh.GetControl(), control);
  control.Derived = Derive(mesh, features, points, control);
  if (!control.Derived.Tuples.IsEmpty())
  {
    const Id edges = complex.NumberOfEdges;
    const Id faces = complex.NumberOfFaces;
    complex = BuildComplexWith<Id>(mesh.GetControl(), control);
    if (complex.NumberOfEdges != edges || complex.NumberOfFaces != faces)
    {
      return false; // the field data name singular simplices that the mesh does not have
    }
  }
  if (!mesh.IsStamped)
  {
    WarnOfContradictions(features, mesh.Values, mesh.Cells, complex, control.Runs, warn);
  }
  control.ManifoldDimensions = FindManifoldDimensions(complex, control.Runs);
  control.Sharpness = FindSharpness(mesh.Values, complex, control.Runs);
  AddDerivedSharpness(complex, control);
  control.Solids = NumberSolids(complex, control.Runs);
  control.Current.Strata =
    BuildStrata(complex, CollectSingular(complex, control, mesh.Values.Singular),
      MakeStrataOptions(features, mesh.Values, complex, control.Runs));
  return true;
}

/// Makes `steps` steps, the last one in the given depth.
template <typename AnyLevel>
AnyLevel RefineTo(AnyLevel level, int steps, Depth depth)
{
  for (int i = 0; i < steps; ++i)
  {
    level = Refine(level, i + 1 == steps ? depth : Depth::ForRefinement);
  }
  return level;
}

/// Builds the control level as if all edges and faces with a larger sharpness than `sharpness` were
/// singular.
template <typename Id>
Level<Id> BuildSharpControl(const ControlMesh& mesh, const FeatureOptions& features,
  const ControlTraits& traits, double sharpness)
{
  ControlTraits control;
  control.Derived = traits.Derived;
  Level<Id> level;
  level.Complex = BuildComplexWith<Id>(mesh.GetControl(), control);
  SingularSimplices singular = CollectSingular(level.Complex, control, mesh.Values.Singular);
  const auto flag = [sharpness](const std::vector<double>& values, Buffer<unsigned char>& flags)
  {
    if (flags.empty())
    {
      flags = Buffer<unsigned char>(static_cast<vtkIdType>(values.size()), 0);
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (values[i] > sharpness)
      {
        flags[static_cast<vtkIdType>(i)] = 1;
      }
    }
  };
  flag(traits.Sharpness.Edges, singular.Edges);
  flag(traits.Sharpness.Faces, singular.Faces);
  level.Strata = BuildStrata(
    level.Complex, singular, MakeStrataOptions(features, mesh.Values, level.Complex, control.Runs));
  return level;
}

/// Builds the level `steps` steps after the current one as if all edges and faces with a larger
/// sharpness than `sharpness` were singular.
template <typename Scheme>
typename Scheme::Level BuildSharpLevel(const ControlMesh& mesh, const FeatureOptions& features,
  const ControlTraits& traits, int steps, double sharpness, Depth depth)
{
  using Id = typename Scheme::Id;
  return RefineTo(Scheme::Start(BuildSharpControl<Id>(mesh, features, traits, sharpness)),
    mesh.MadeLevels + steps, depth);
}

}

template <typename Scheme>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, Depth depth,
  ControlComplex<typename Scheme::Id>& control, typename Scheme::Level& current)
{
  if (!BuildControlLevel(mesh, features, points, warn, control))
  {
    return false;
  }
  const int made = mesh.MadeLevels;
  current = RefineTo(Scheme::Start(std::move(control.Current)), made, depth);
  control.Runs = RefineRuns(control.Runs, made);
  control.DerivedRuns = RefineRuns(control.DerivedRuns, made);
  return made == 0 || Scheme::HasCells(current, control.Runs, mesh.Cells.Simplices);
}

template <typename Id>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, Depth depth, ControlComplex<Id>& control)
{
  Level<Id> current;
  const bool built =
    BuildControlComplex<BoxSplineScheme<Id>>(mesh, features, points, warn, depth, control, current);
  control.Current = std::move(current);
  return built;
}

template <typename Scheme>
typename Scheme::Level BuildSharpLevel(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps)
{
  return BuildSharpLevel<Scheme>(mesh, features, traits, steps, steps, Depth::ForOutput);
}

namespace
{

/// What is left after `steps` steps of the sharpness of control simplices, for `size` simplices of
/// a level. The pieces of control simplex i are the 2^shift ones from i 2^shift on.
Buffer<double> GiveToPieces(const std::vector<double>& values, int shift, int steps, vtkIdType size)
{
  Buffer<double> left;
  if (!values.empty())
  {
    left = Buffer<double>(size, 0.);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    std::fill_n(left.data() + (static_cast<vtkIdType>(i) << shift), std::size_t(1) << shift,
      values[i] - steps);
  }
  return left;
}

}

template <typename Scheme>
SemiSharpStages<typename Scheme::Id> BuildSharpStages(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps)
{
  SemiSharpStages<typename Scheme::Id> stages;
  std::set<int> ends;
  for (const std::vector<double>* values : { &traits.Sharpness.Edges, &traits.Sharpness.Faces })
  {
    for (double sharpness : *values)
    {
      if (sharpness > steps)
      {
        ends.insert(static_cast<int>(std::ceil(std::min<double>(sharpness - steps, SharpForever))));
      }
    }
  }
  for (int end : ends)
  {
    typename Scheme::Level level =
      BuildSharpLevel<Scheme>(mesh, features, traits, steps, steps + end - 1, Depth::ForRefinement);
    if (stages.Stages.empty())
    {
      const int depth = mesh.MadeLevels + steps;
      stages.Sharpness =
        GiveToPieces(traits.Sharpness.Edges, depth, steps, level.Complex.NumberOfEdges);
      stages.FaceSharpness =
        GiveToPieces(traits.Sharpness.Faces, 2 * depth, steps, level.Complex.NumberOfFaces);
    }
    stages.Stages.push_back({ end, std::move(level.Strata), Scheme::GetSpokes(level) });
  }
  return stages;
}

SUBDIVISION_COMPILE_FUNCTION(CollectSingular);
#define SUBDIVISION_CONTROL(Id)                                                                    \
  template bool BuildControlComplex(const ControlMesh&, const FeatureOptions&, const Coordinates&, \
    const WarnFunction&, Depth, ControlComplex<Id>&)
SUBDIVISION_CONTROL(int);
SUBDIVISION_CONTROL(long long);

#define SUBDIVISION_SCHEME(Scheme)                                                                 \
  template bool BuildControlComplex<Scheme>(const ControlMesh&, const FeatureOptions&,             \
    const Coordinates&, const WarnFunction&, Depth, ControlComplex<Scheme::Id>&, Scheme::Level&);  \
  template Scheme::Level BuildSharpLevel<Scheme>(                                                  \
    const ControlMesh&, const FeatureOptions&, const ControlTraits&, int);                         \
  template SemiSharpStages<Scheme::Id> BuildSharpStages<Scheme>(                                   \
    const ControlMesh&, const FeatureOptions&, const ControlTraits&, int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_SCHEME);

}
