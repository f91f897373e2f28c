// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/ControlComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/RunSimplices.h"
#include "Private/Control/OpenPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace subdivision
{
namespace
{

/// Splits runs at simplex `at`: `runs` keeps the runs before it. The runs from it on are returned,
/// with cells that count from 0.
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

/// The sharpness of derived simplices of a dimension; empty if all are infinite. `known` has the
/// sharpness of marked ones.
std::vector<double> FindDerivedSharpness(
  const SharpTuples& known, const std::vector<vtkIdType>& tuples, int dimension)
{
  const int size = dimension + 1;
  std::vector<double> sharpness;
  std::map<SimplexKey, double> found;
  for (const std::size_t i : InTurn(known.Sharpness[dimension].size()))
  {
    found.emplace(MakeKey(known.Tuples.Tuples[dimension].data() + size * i, size),
      known.Sharpness[dimension][i]);
  }
  // One that is derived otherwise too stands there twice, and is sharp for ever.
  std::map<SimplexKey, int> counts;
  for (std::size_t i = 0; !found.empty() && i < tuples.size(); i += size)
  {
    ++counts[MakeKey(tuples.data() + i, size)];
  }
  for (std::size_t i = 0; !found.empty() && i < tuples.size(); i += size)
  {
    const SimplexKey key = MakeKey(tuples.data() + i, size);
    const auto mark = found.find(key);
    const bool isSemiSharp = mark != found.end() && counts[key] == 1;
    sharpness.push_back(isSemiSharp ? mark->second : std::numeric_limits<double>::infinity());
  }
  return sharpness;
}

/// Whether each face has a sharpness, by its cell or by marks; empty: none has.
template <typename Id>
std::vector<bool> FindSemiSharpFaces(const ControlMesh& mesh, const ControlComplex<Id>& control)
{
  const SimplicialComplex<Id>& complex = control.Current.Complex;
  const std::vector<double> ofCells = FindSharpness(mesh.Values, complex, control.Runs).Faces;
  std::set<SimplexKey> marked;
  for (const std::size_t i : InTurn(mesh.Derived.Sharpness[2].size()))
  {
    if (!std::isinf(mesh.Derived.Sharpness[2][i]))
    {
      marked.insert(MakeKey(mesh.Derived.Tuples.Tuples[2].data() + 3 * i, 3));
    }
  }
  std::vector<bool> found;
  for (const vtkIdType f :
    InTurn(!ofCells.empty() || !marked.empty() ? vtkIdType(complex.NumberOfFaces) : vtkIdType(0)))
  {
    const Id* ids = complex.FaceVertices.data() + 3 * f;
    const vtkIdType corners[3] = { ids[0], ids[1], ids[2] };
    found.push_back((!ofCells.empty() && ofCells[static_cast<std::size_t>(f)] > 0.) ||
      marked.count(MakeKey(corners, 3)) > 0);
  }
  return found;
}

/// Finds the singular simplices that follow from embedded cells, materials and angles (Mathematics
/// 7). In a stamped mesh an earlier filter derived them, and they are taken over.
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
      FindSemiSharpFaces(mesh, control), derived);
  }
  if (features.DetectFeatures)
  {
    control.Candidates = FindFeatureCandidates(complex);
    for (const FeatureCandidate& candidate : InTurn(control.Candidates))
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
  SharpTuples all;
  for (int dimension = 1; dimension < 3; ++dimension)
  {
    all.Sharpness[dimension] =
      FindDerivedSharpness(mesh.Derived, derived.Tuples[dimension], dimension);
  }
  all.Tuples = std::move(derived);
  return all;
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
  // Lines and triangles with a finite sharpness are no singular ones. Children follow each other.
  std::size_t children[3] = { 0, 0, 0 };
  for (const CellRun& run : traits.DerivedRuns)
  {
    children[run.Dimension] += static_cast<std::size_t>(run.Count);
  }
  std::size_t first = 0;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const std::size_t size = traits.Derived.Sharpness[dimension].size();
    for (std::size_t i = 0; size > 0 && i < children[dimension]; ++i)
    {
      derived[first + i] =
        std::isinf(traits.Derived.GetSharpness(dimension, i / (children[dimension] / size)));
    }
    first += children[dimension];
  }
  FlagSimplices(complex, traits.DerivedRuns, derived.data(), singular);
  return singular;
}

std::vector<unsigned char> RefineFlags(
  const SimplexList& simplices, int levels, const std::vector<unsigned char>& flags)
{
  std::vector<unsigned char> refined;
  for (const std::size_t i : InTurn(flags.size()))
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

/// Adds the sharpness of derived lines and triangles to the sharpness of edges and faces.
template <typename Id>
void AddDerivedSharpness(const SimplicialComplex<Id>& complex, ControlTraits& control)
{
  const SharpTuples& derived = control.Derived;
  const vtkIdType firsts[3] = { 0, static_cast<vtkIdType>(derived.Tuples.Tuples[0].size()),
    static_cast<vtkIdType>(derived.Tuples.Tuples[0].size() + derived.Tuples.Tuples[1].size() / 2) };
  const Id sizes[3] = { 0, complex.NumberOfEdges, complex.NumberOfFaces };
  std::vector<double>* targets[3] = { nullptr, &control.Sharpness.Edges, &control.Sharpness.Faces };
  ForSimplices(complex, control.DerivedRuns,
    [&](vtkIdType place, int d, vtkIdType simplex, bool)
    {
      if (!derived.Sharpness[d].empty())
      {
        targets[d]->resize(static_cast<std::size_t>(sizes[d]), 0.);
        const double sharpness =
          derived.GetSharpness(d, static_cast<std::size_t>(place - firsts[d]));
        double& value = (*targets[d])[static_cast<std::size_t>(simplex)];
        value = std::isinf(sharpness) ? value : std::max(value, sharpness);
      }
    });
}

template <typename Id>
void TellOpenPoints(const ControlMesh& mesh, const FeatureOptions& features,
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, const Coordinates& points,
  const WarnFunction& warn)
{
  OpenPointOptions options{ features.MergesPoints, features.ClosesNodes, features.JoiningCure, {} };
  options.FindCell = [&](int dimension, vtkIdType index)
  {
    vtkIdType simplex = -1;
    for (const CellRun& run : runs)
    {
      const bool isIn = run.Dimension == dimension && !run.Equal && index >= run.First &&
        index < run.First + run.Count;
      simplex = isIn ? run.FirstCell + index - run.First : simplex;
    }
    return simplex < 0 || mesh.Cells.ParentCells.empty() ? simplex
                                                         : mesh.Cells.ParentCells[simplex];
  };
  for (const std::string& warning : DescribeOpenPoints(complex, points, options))
  {
    warn(warning);
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
    TellOpenPoints(mesh, features, complex, control.Runs, points, warn);
  }
  control.ManifoldDimensions = FindManifoldDimensions(complex, control.Runs);
  control.Sharpness = FindSharpness(mesh.Values, complex, control.Runs);
  AddDerivedSharpness(complex, control);
  control.Solids = NumberSolids(complex, control.Runs);
  control.Current.Strata =
    BuildStrata(complex, CollectSingular(complex, control, mesh.Values.Singular),
      MakeStrataOptions(features, mesh.Values, complex, control.Runs));
  complex.EdgeFaces = Rows<Id>(); // only strata need them
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
  level.Complex.EdgeFaces = Rows<Id>();
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

template <typename Id>
void WarnOfOpenPoints(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn)
{
  SimplicesOfCells cells = mesh.Cells;
  cells.TakeIds();
  std::vector<CellRun> runs;
  const auto complex = BuildComplex<Id>(cells.Simplices, runs);
  TellOpenPoints(mesh, features, complex, runs, points, warn);
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

template <typename Scheme>
typename Scheme::Level BuildSharpLevel(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps)
{
  return BuildSharpLevel<Scheme>(mesh, features, traits, steps, steps, Depth::ForOutput);
}

namespace
{

/// The sharpness of control simplices that is left after `steps` steps, for `size` simplices of a
/// level. The pieces of control simplex i are the 2^shift ones from i 2^shift on.
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
    for (double sharpness : InTurn(*values))
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
SUBDIVISION_COMPILE_FUNCTION(WarnOfOpenPoints);
#define SUBDIVISION_SCHEME(Scheme)                                                                 \
  template bool BuildControlComplex<Scheme>(const ControlMesh&, const FeatureOptions&,             \
    const Coordinates&, const WarnFunction&, Depth, ControlComplex<Scheme::Id>&, Scheme::Level&);  \
  template Scheme::Level BuildSharpLevel<Scheme>(                                                  \
    const ControlMesh&, const FeatureOptions&, const ControlTraits&, int);                         \
  template SemiSharpStages<Scheme::Id> BuildSharpStages<Scheme>(                                   \
    const ControlMesh&, const FeatureOptions&, const ControlTraits&, int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_SCHEME);

}
