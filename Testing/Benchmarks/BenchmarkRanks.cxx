// SPDX-License-Identifier: BSD-3-Clause
// What it costs to subdivide a mesh on several ranks. Run under mpirun; prints lines of Markdown
// tables. Not a part of the program with Google Benchmark, which knows one process only.
#include "Private/Distribution/Distribution.h"
#include "Private/Distribution/Layers.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/Distribution/PointIds.h"
#include "Private/Distribution/Ranks.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

using namespace subdivision;

namespace
{

using Index = std::array<vtkIdType, 3>;

/// A lattice of cubes of 6 tetrahedra each; its points are moved a little.
struct Lattice
{
  Index Cubes;

  vtkIdType GetPoint(const Index& at) const
  {
    return (at[0] * (this->Cubes[1] + 1) + at[1]) * (this->Cubes[2] + 1) + at[2];
  }
  vtkIdType GetCube(const Index& at) const
  {
    return (at[0] * this->Cubes[1] + at[1]) * this->Cubes[2] + at[2];
  }
};

double Scatter(vtkIdType point, int axis)
{
  auto bits = static_cast<std::uint64_t>(point * 3 + axis) * 0x9E3779B97F4A7C15ull;
  bits = (bits ^ (bits >> 31)) * 0xBF58476D1CE4E5B9ull;
  return 0.2 * (static_cast<double>((bits ^ (bits >> 29)) & 0xFFFFu) / 65535. - 0.5);
}

void AddTets(
  const Lattice& lattice, const Index& cube, const Index& begin, const Index& size, Block& block)
{
  static const int orders[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  auto* grid = vtkUnstructuredGrid::SafeDownCast(block.Input);
  auto* ids = vtkIdTypeArray::SafeDownCast(grid->GetCellData()->GetGlobalIds());
  for (int order = 0; order < 6; ++order)
  {
    Index corner = cube;
    vtkIdType corners[4];
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = ((corner[0] - begin[0]) * (size[1] + 1) + corner[1] - begin[1]) * (size[2] + 1) +
        corner[2] - begin[2];
      if (k < 3)
      {
        ++corner[static_cast<size_t>(orders[order][k])];
      }
    }
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    ids->InsertNextValue(6 * lattice.GetCube(cube) + order);
  }
}

/// The cubes from `begin` on, as a block that knows its points by global ids.
Block MakeBox(const Lattice& lattice, const Index& begin, const Index& size)
{
  Block block;
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("PointIds");
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType x = begin[0]; x <= begin[0] + size[0]; ++x)
  {
    for (vtkIdType y = begin[1]; y <= begin[1] + size[1]; ++y)
    {
      for (vtkIdType z = begin[2]; z <= begin[2] + size[2]; ++z)
      {
        const vtkIdType id = lattice.GetPoint({ x, y, z });
        ids->InsertNextValue(id);
        values->InsertNextValue(Scatter(id, 1));
        points->InsertNextPoint(static_cast<double>(x) + Scatter(id, 0),
          static_cast<double>(y) + Scatter(id, 1), static_cast<double>(z) + Scatter(id, 2));
      }
    }
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetGlobalIds(ids);
  grid->GetPointData()->AddArray(values);
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("CellIds");
  grid->GetCellData()->SetGlobalIds(cellIds);
  grid->AllocateExact(6 * size[0] * size[1] * size[2], 24 * size[0] * size[1] * size[2]);
  block.Input = grid;
  block.Output = MakeMesh(false);
  for (vtkIdType x = begin[0]; x < begin[0] + size[0]; ++x)
  {
    for (vtkIdType y = begin[1]; y < begin[1] + size[1]; ++y)
    {
      for (vtkIdType z = begin[2]; z < begin[2] + size[2]; ++z)
      {
        AddTets(lattice, { x, y, z }, begin, size, block);
      }
    }
  }
  return block;
}

/// What a phase took on this rank.
struct Cost
{
  double Seconds = 0;
  double Processor = 0;
  vtkIdType Messages = 0;
  vtkIdType Bytes = 0;
};

/// Measures the phases one after the other.
class Watch
{
public:
  explicit Watch(const PartitionsOfRank& partitions)
    : Traffic(partitions)
  {
  }
  Cost Next()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    Cost cost;
    cost.Seconds = std::chrono::duration<double>(now - this->Then).count();
    cost.Processor = static_cast<double>(processor - this->ThenProcessor) / CLOCKS_PER_SEC;
    cost.Messages = this->Traffic.GetNumberOfMessages() - this->Messages;
    cost.Bytes = this->Traffic.GetNumberOfBytes() - this->Bytes;
    this->Then = now;
    this->ThenProcessor = processor;
    this->Messages += cost.Messages;
    this->Bytes += cost.Bytes;
    return cost;
  }

private:
  const PartitionsOfRank& Traffic;
  std::chrono::steady_clock::time_point Then = std::chrono::steady_clock::now();
  std::clock_t ThenProcessor = std::clock();
  vtkIdType Messages = 0;
  vtkIdType Bytes = 0;
};

/// Largest and sum over all ranks.
double Reduce(vtkMultiProcessController& controller, double value, int operation)
{
  double reduced = value;
  controller.AllReduce(&value, &reduced, 1, operation);
  return reduced;
}
double Max(vtkMultiProcessController& controller, double value)
{
  return Reduce(controller, value, vtkCommunicator::MAX_OP);
}
double Sum(vtkMultiProcessController& controller, double value)
{
  return Reduce(controller, value, vtkCommunicator::SUM_OP);
}

FilterWork MakeWork(UniformOptions& options, int levels)
{
  options.Levels = levels;
  options.Warn = [](const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); };
  options.Fail = options.Warn;
  return [&options](vtkPointSet* input, vtkPointSet* output)
  { return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output)); };
}

double Share(double part, double whole)
{
  return whole > 0 ? 100. * part / whole : 0.;
}

enum Phases
{
  Identify,
  Layers,
  Joining,
  Subdivide,
  Take,
  NumberOfPhases
};

/// What subdividing a slab took on this rank.
struct Measured
{
  Cost Costs[NumberOfPhases];
  double Cells = 0;    ///< own
  double AllCells = 0; ///< with those of other ranks
  double Points = 0;   ///< own, of the output
  double AllPoints = 0;
  double Megabytes = 0; ///< the most memory that the process had, beyond that before
};

/// The memory of this process in MB, `name` as in /proc/self/status; 0 where there is none.
double ReadMemory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  double kilobytes = 0.;
  for (std::string word; status >> word;)
  {
    if (word == name + ":")
    {
      status >> kilobytes;
      break;
    }
  }
  return kilobytes / 1024.;
}

/// Does once what RunPartitions does.
Measured MeasureOnce(vtkMPIController& controller, const Block& slab, int levels)
{
  const double before = ReadMemory("VmRSS");
  UniformOptions options;
  const FilterWork work = MakeWork(options, levels);
  std::vector<Block> blocks = { slab };
  blocks[0].Output = MakeMesh(false);
  Measured measured;
  PartitionsOfRank partitions(&controller);
  ExchangeOfAll exchange(partitions);
  controller.Barrier();
  Watch watch(partitions);
  std::vector<MeshPart> parts{ { slab.Input, 0, {}, {} } };
  const int pointType = FindPointType(parts, exchange);
  IdentifyPoints(parts, exchange, options.Warn);
  measured.Costs[Identify] = watch.Next();
  SentLayers sent;
  const bool isShared = partitions.GetNumberOfPartitions() > 1;
  if (isShared)
  {
    sent = AddLayers(parts, DistributionOptions().Layers, exchange);
    ShareArrays(parts, exchange);
  }
  measured.Costs[Layers] = watch.Next();
  const JoinedMesh joined = Join(parts, pointType);
  parts.clear();
  measured.Costs[Joining] = watch.Next();
  ExchangeOfWork others(partitions, 0);
  if (isShared)
  {
    others.Start(joined, sent.OfFirst);
    options.Others = &others;
  }
  const auto whole = MakeMesh(false);
  const bool done = work(joined.Mesh, whole);
  if (isShared)
  {
    others.End(done);
  }
  measured.Costs[Subdivide] = watch.Next();
  TakeOutputs(joined, whole, OutputOptions(), blocks);
  measured.Costs[Take] = watch.Next();
  measured.Cells = static_cast<double>(slab.Input->GetNumberOfCells());
  measured.AllCells = static_cast<double>(joined.Mesh->GetNumberOfCells());
  measured.Points = static_cast<double>(blocks[0].Output->GetNumberOfPoints());
  measured.AllPoints = static_cast<double>(whole->GetNumberOfPoints());
  measured.Megabytes = ReadMemory("VmHWM") - before;
  return measured;
}

/// The least of three times, for one slab of a lattice on each rank.
Measured MeasureSlab(
  vtkMPIController& controller, const std::string& kind, const Index& cubes, int levels)
{
  const int ranks = controller.GetNumberOfProcesses();
  const vtkIdType first = cubes[0] * controller.GetLocalProcessId() / ranks;
  const vtkIdType last = cubes[0] * (controller.GetLocalProcessId() + 1) / ranks;
  const Block slab = MakeBox({ cubes }, { first, 0, 0 }, { last - first, cubes[1], cubes[2] });
  if (kind == "coordinates")
  {
    slab.Input->GetPointData()->SetGlobalIds(nullptr);
    slab.Input->GetCellData()->SetGlobalIds(nullptr);
  }
  Measured least = MeasureOnce(controller, slab, levels);
  for (int repetition = 1; repetition < 3; ++repetition)
  {
    const Measured other = MeasureOnce(controller, slab, levels);
    for (size_t i = 0; i < NumberOfPhases; ++i)
    {
      least.Costs[i].Seconds = std::min(least.Costs[i].Seconds, other.Costs[i].Seconds);
      least.Costs[i].Processor = std::min(least.Costs[i].Processor, other.Costs[i].Processor);
    }
  }
  return least;
}

void PrintRanks(vtkMPIController& controller, const std::string& kind, const Measured& measured)
{
  const int ranks = controller.GetNumberOfProcesses();
  const double cells = Sum(controller, measured.Cells);
  const double allCells = Sum(controller, measured.AllCells);
  const double points = Sum(controller, measured.Points);
  const double allPoints = Sum(controller, measured.AllPoints);
  const double megabytes = Max(controller, measured.Megabytes);
  const double balance = Max(controller, measured.AllCells) * ranks / allCells;
  char text[64];
  double seconds = 0.;
  double processor = 0.;
  std::string phases;
  for (const Cost& cost : measured.Costs)
  {
    seconds += Max(controller, cost.Seconds);
    const double most = Max(controller, cost.Processor);
    processor += most;
    std::snprintf(text, sizeof text, " %.2f |", most);
    phases += text;
  }
  std::string sent;
  for (const int phase : { Identify, Layers })
  {
    std::snprintf(text, sizeof text, " %.0f, %.2f |",
      Sum(controller, static_cast<double>(measured.Costs[phase].Messages)),
      Sum(controller, static_cast<double>(measured.Costs[phase].Bytes)) / 1e6);
    sent += text;
  }
  if (controller.GetLocalProcessId() == 0)
  {
    std::printf("| %s | %d | %.0f | %.1f %% | %.1f %% | %.2f |%s %.2f | %.2f |%s %.0f |\n",
      kind.c_str(), ranks, cells, Share(allCells - cells, cells), Share(allPoints - points, points),
      balance, phases.c_str(), processor, seconds, sent.c_str(), megabytes);
    std::fflush(stdout);
  }
}

/// Boxes of `side` cubes each way: side^3 partitions of size^3 cubes, in this process.
bool MeasureSimulated(vtkIdType side, vtkIdType size, int levels)
{
  const Lattice lattice = { { side * size, side * size, side * size } };
  std::vector<std::vector<Block>> partitions;
  for (vtkIdType x = 0; x < side; ++x)
  {
    for (vtkIdType y = 0; y < side; ++y)
    {
      for (vtkIdType z = 0; z < side; ++z)
      {
        partitions.push_back(
          { MakeBox(lattice, { x * size, y * size, z * size }, { size, size, size }) });
      }
    }
  }
  const auto count = static_cast<double>(partitions.size());
  const double own = 6. * static_cast<double>(size * size * size);
  UniformOptions options;
  const FilterWork subdivide = MakeWork(options, levels);
  double joined = 0.;
  double largest = 0.;
  const auto work = [&](vtkPointSet* input, vtkPointSet* output)
  {
    const auto cells = static_cast<double>(input->GetNumberOfCells());
    joined += cells;
    largest = std::max(largest, cells);
    options.Others = nullptr; // so that no partition waits, and has its memory then
    return subdivide(input, output);
  };
  PartitionsOfRank ofRank(nullptr, static_cast<int>(partitions.size()));
  Watch watch(ofRank);
  const bool done =
    RunPartitions(partitions, ofRank, DistributionOptions(), FilterTraits(), options, work);
  const Cost cost = watch.Next();
  double cells = 0.;
  for (const std::vector<Block>& blocks : partitions)
  {
    cells += static_cast<double>(blocks[0].Output->GetNumberOfCells());
  }
  double factor = own * count;
  for (int level = 0; level < levels; ++level)
  {
    factor *= 8.;
  }
  std::printf("| %.0f | %.0f | %.1f %% | %.2f | %.1f | %.1f | %.1f | %s |\n", count, own,
    Share(joined - own * count, own * count), largest * count / joined,
    static_cast<double>(cost.Messages) / count, static_cast<double>(cost.Bytes) / count / 1e3,
    cost.Seconds, done && cells == factor ? "yes" : "NO");
  return done && cells == factor;
}

}

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  const std::string what = argc > 1 ? argv[1] : "";
  bool done = argc > 3;
  if (done && what == "simulated")
  {
    done = MeasureSimulated(std::atol(argv[2]), std::atol(argv[3]), 1);
  }
  else if (done && (what == "strong" || what == "weak" || what == "coordinates"))
  {
    const vtkIdType side = std::atol(argv[2]);
    const vtkIdType length = what == "weak" ? side * controller->GetNumberOfProcesses() : side;
    PrintRanks(*controller, what,
      MeasureSlab(*controller, what, { length, side, side }, std::atoi(argv[3])));
  }
  else
  {
    std::fprintf(
      stderr, "usage: %s strong|weak|coordinates SIDE LEVELS | simulated SIDE SIZE\n", argv[0]);
    done = false;
  }
  controller->Finalize();
  return done ? 0 : 1;
}
