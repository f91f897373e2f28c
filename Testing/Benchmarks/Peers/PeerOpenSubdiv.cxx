// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerOpenSubdiv.cxx
 * OpenSubdiv, Far: uniform refinement with the primvar refiner, and stencil tables, also those of
 * limits at places, with derivatives. All in double; points and scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkPlaces.h"
#include "BenchmarkTools.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <memory>

namespace benchmarks
{
namespace
{

namespace Far = OpenSubdiv::Far;

template <int N>
struct Values
{
  double Data[N];
  void Clear(void* = nullptr) { std::fill(this->Data, this->Data + N, 0.); }
  void AddWithWeight(const Values& source, double weight)
  {
    for (int c = 0; c < N; ++c)
    {
      this->Data[c] += weight * source.Data[c];
    }
  }
};

std::unique_ptr<Far::TopologyRefiner> Refine(const FlatMesh& input, int levels, bool last)
{
  const std::vector<int> sizes(input.GetNumberOfCells(), input.Corners);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = input.GetNumberOfPoints();
  descriptor.numFaces = input.GetNumberOfCells();
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = input.Cells.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(descriptor,
    Factory::Options(
      input.HasQuads ? OpenSubdiv::Sdc::SCHEME_CATMARK : OpenSubdiv::Sdc::SCHEME_LOOP)));
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = last;
  refiner->RefineUniform(options);
  return refiner;
}

/// Points and the scalar together: topology is walked through once.
std::vector<Values<4>> Interpolate(
  const Far::TopologyRefiner& refiner, const FlatMesh& input, int levels)
{
  const Far::PrimvarRefinerReal<double> primvars(refiner);
  std::vector<Values<4>> current(input.GetNumberOfPoints());
  for (int i = 0; i < input.GetNumberOfPoints(); ++i)
  {
    std::copy_n(input.Points.data() + 3 * i, 3, current[i].Data);
    current[i].Data[3] = input.Scalar[i];
  }
  for (int level = 1; level <= levels; ++level)
  {
    std::vector<Values<4>> next(refiner.GetLevel(level).GetNumVertices());
    primvars.Interpolate(level, current, next);
    current.swap(next);
  }
  return current;
}

Produced RefineAndInterpolate(Stopwatch& watch, const FlatMesh& input, int levels)
{
  watch.Start();
  const auto refiner = Refine(input, levels, false);
  const auto values = Interpolate(*refiner, input, levels);
  const Far::TopologyLevel& last = refiner->GetLevel(levels);
  std::vector<int> cells(input.Corners * static_cast<std::size_t>(last.GetNumFaces()));
  for (int f = 0; f < last.GetNumFaces(); ++f)
  {
    const Far::ConstIndexArray vertices = last.GetFaceVertices(f);
    std::copy(vertices.begin(), vertices.end(), cells.data() + input.Corners * f);
  }
  watch.Stop();
  return { static_cast<double>(last.GetNumFaces()),
    static_cast<double>(32 * values.size() + 4 * cells.size()) };
}

using Table = Far::StencilTableReal<double>;

std::unique_ptr<const Table> MakeTable(const Far::TopologyRefiner& refiner)
{
  using Factory = Far::StencilTableFactoryReal<double>;
  Factory::Options options;
  options.generateIntermediateLevels = false;
  options.generateOffsets = true;
  return std::unique_ptr<const Table>(Factory::Create(refiner, options));
}

Produced BuildTable(Stopwatch& watch, const FlatMesh& input, int levels)
{
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::unique_ptr<const Table> table;
  watch.Start();
  refiner = Refine(input, levels, false);
  table = MakeTable(*refiner);
  watch.Stop();
  return { static_cast<double>(refiner->GetLevel(levels).GetNumFaces()),
    12. * static_cast<double>(table->GetControlIndices().size()) };
}

/// The ready table on one component, in threads by ranges of its stencils.
Produced EvaluateTable(Stopwatch& watch, const FlatMesh& input, int levels)
{
  static const auto refiner = Refine(input, levels, false);
  static const auto table = MakeTable(*refiner);
  std::vector<Values<1>> in(input.Scalar.size());
  std::copy(input.Scalar.begin(), input.Scalar.end(), in[0].Data);
  std::unique_ptr<Values<1>[]> out;
  watch.Start();
  out.reset(new Values<1>[table->GetNumStencils()]);
  vtkSMPTools::For(0, table->GetNumStencils(),
    [&](vtkIdType begin, vtkIdType end)
    {
      const Values<1>* from = in.data();
      Values<1>* to = out.get(); // of all stencils, not of the range
      table->UpdateValues(from, to, static_cast<int>(begin), static_cast<int>(end));
    });
  watch.Stop();
  return { static_cast<double>(refiner->GetLevel(levels).GetNumFaces()),
    12. * static_cast<double>(table->GetControlIndices().size()) };
}

// ------------------------------------------------------------------------------------------------
// Limits at places

using LimitTable = Far::LimitStencilTableReal<double>;

/// Refinement goes on around extraordinary vertices as far as OpenSubdiv does it.
constexpr int LimitLevels = 10;

std::unique_ptr<const LimitTable> MakeLimitTable(const FlatMesh& input, bool second = false)
{
  using Factory = Far::LimitStencilTableFactoryReal<double>;
  const auto refiner = Refine(input, 0, true);
  refiner->Unrefine();
  Far::PatchTableFactory::Options patches(LimitLevels);
  patches.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
  refiner->RefineAdaptive(patches.GetRefineAdaptiveOptions());
  std::vector<double> u;
  std::vector<double> v;
  for (int i = 0; i < PlacesOfCell; ++i)
  {
    const std::array<double, 2> place = GetPlace(i);
    u.push_back(place[0]);
    v.push_back(place[1]);
  }
  Factory::LocationArrayVec locations(input.GetNumberOfCells());
  for (int face = 0; face < input.GetNumberOfCells(); ++face)
  {
    locations[face].ptexIdx = face;
    locations[face].numLocations = PlacesOfCell;
    locations[face].s = u.data();
    locations[face].t = v.data();
  }
  Factory::Options options; // first derivatives are the default
  options.generate2ndDerivatives = second;
  return std::unique_ptr<const LimitTable>(
    Factory::Create(*refiner, locations, nullptr, nullptr, options));
}

Produced BuildLimitTable(Stopwatch& watch, const FlatMesh& input, bool second)
{
  std::unique_ptr<const LimitTable> table;
  watch.Start();
  table = MakeLimitTable(input, second);
  watch.Stop();
  return { static_cast<double>(table->GetNumStencils()),
    12. * static_cast<double>(table->GetControlIndices().size()) };
}

/// The ready table on points: values and two derivatives, in threads by ranges of its stencils.
Produced EvaluateLimitTable(Stopwatch& watch, const FlatMesh& input)
{
  static const auto table = MakeLimitTable(input);
  std::vector<Values<3>> in(input.GetNumberOfPoints());
  std::copy(input.Points.begin(), input.Points.end(), in[0].Data);
  std::unique_ptr<Values<3>[]> out[3];
  const int size = table->GetNumStencils();
  watch.Start();
  for (auto& part : out)
  {
    part.reset(new Values<3>[size]);
  }
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      const Values<3>* from = in.data();
      const int first = static_cast<int>(begin);
      const int last = static_cast<int>(end);
      Values<3>* value = out[0].get();
      Values<3>* u = out[1].get();
      Values<3>* v = out[2].get();
      table->UpdateValues(from, value, first, last);
      table->UpdateDerivs(from, u, v, first, last);
    });
  watch.Stop();
  return { static_cast<double>(size), 72. * static_cast<double>(size) };
}

void RegisterOpenSubdiv()
{
  static const FlatMesh coarse = MakeSphere(4);
  for (int threads : ThreadCounts)
  {
    Register("peer/OpenSubdiv limit stencils apply/sphere/levels:0", threads,
      [](Stopwatch& watch) { return EvaluateLimitTable(watch, coarse); });
  }
  static const FlatMesh coarseQuads = MakeQuadSphere(29);
  for (const bool second : { false, true })
  {
    const std::string make = second ? "peer/OpenSubdiv limit stencils make with second derivatives/"
                                    : "peer/OpenSubdiv limit stencils make/";
    Register(make + "sphere/levels:0", 1,
      [second](Stopwatch& watch) { return BuildLimitTable(watch, coarse, second); });
    Register(make + "sphere of quads/levels:0", 1,
      [second](Stopwatch& watch) { return BuildLimitTable(watch, coarseQuads, second); });
  }
  static const FlatMesh sphere = MakeSphere(5);
  Register("peer/OpenSubdiv Loop/sphere/levels:3", 1,
    [](Stopwatch& watch) { return RefineAndInterpolate(watch, sphere, 3); });
  static const FlatMesh quads = MakeQuadSphere(58);
  Register("peer/OpenSubdiv Catmull-Clark/quads/levels:3", 1,
    [](Stopwatch& watch) { return RefineAndInterpolate(watch, quads, 3); });
  Register("peer/OpenSubdiv stencil table build/sphere/levels:3", 1,
    [](Stopwatch& watch) { return BuildTable(watch, sphere, 3); });
  for (int threads : ThreadCounts)
  {
    Register("peer/OpenSubdiv stencil table evaluate/sphere/levels:3", threads,
      [](Stopwatch& watch) { return EvaluateTable(watch, sphere, 3); });
  }
}

const Registration Registered(RegisterOpenSubdiv);

}
}
