// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/SizeChecks.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/SimplexStarts.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace subdivision
{
namespace
{

/// How many processes share the memory of this machine.
thread_local int Sharers = 1;

/// The estimated memory of the work of this thread; negative: there is no estimate.
thread_local double Estimate = -1.;

/// Connectivity and type of a tetrahedron, and its offset.
constexpr double BytesPerTet = 8. * 4. + 8. + 1.;

/// The text of a whole number; of one with more than 15 digits the first three, and its size.
std::string Whole(double value)
{
  std::ostringstream text;
  value < 1e15 ? text << static_cast<vtkIdType>(value) : text << std::setprecision(3) << value;
  return text.str();
}
}

std::string Bytes(double bytes)
{
  static const char* const units[] = { " bytes", " kB", " MB", " GB", " TB", " PB", " EB" };
  int unit = 0;
  for (; bytes >= 999.5 && unit < 6; ++unit)
  {
    bytes /= 1000.;
  }
  std::ostringstream text;
  text << std::setprecision(3) << bytes << units[unit];
  return text.str();
}

std::string CheckNumberOfCells(const SimplexList& simplices, int levels, vtkIdType maximum)
{
  double cells = 0.;
  const std::array<vtkIdType, 4> counts = CountDimensions(simplices);
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    cells += std::ldexp(static_cast<double>(counts[dimension]), dimension * levels);
  }
  return CheckNumberOfCells(cells, cells * BytesPerTet, levels, maximum);
}

std::string CheckNumberOfCells(double cells, double bytes, int levels, vtkIdType maximum)
{
  if (cells <= static_cast<double>(maximum))
  {
    return std::string();
  }
  std::ostringstream message;
  message << "NumberOfLevels = " << levels << " would make " << Whole(cells) << " cells (up to "
          << Bytes(bytes) << " for the cells alone), which is above "
          << "MaximumNumberOfCells = " << maximum << ". Use fewer levels"
          << (bytes < GetAvailableMemory() ? ", or raise MaximumNumberOfCells."
                                           : "; there is not enough memory for so many cells.");
  return message.str();
}

LevelCounts CountSimplices(const SimplexList& cells, const SchemeTraits& scheme)
{
  const std::array<vtkIdType, 4> ofDimensions = CountDimensions(cells);
  const auto count = [&](int dimension) { return static_cast<double>(ofDimensions[dimension]); };
  LevelCounts counts;
  counts.Scheme = &scheme;
  counts.Vertices = static_cast<double>(cells.NumberOfPoints);
  counts.Tets = count(3);
  counts.Faces = count(2) + 4. * counts.Tets;
  counts.Edges = count(1) + 3. * counts.Faces;
  return counts;
}

bool NeedsLargeIds(const SimplexList& control, int levels, const SchemeTraits& scheme)
{
  LevelCounts counts = CountSimplices(control, scheme);
  double largest = std::max(4. * counts.Faces, 4. * counts.Edges);
  for (int i = 0; i < levels; ++i)
  {
    largest = std::max({ largest, 4. * counts.Faces, 4. * counts.Edges, 8. * counts.Tets,
      scheme.EdgeRing * counts.Edges, scheme.VertexRing * counts.Vertices });
    counts = counts.Refine();
    largest = std::max(largest, counts.Vertices);
  }
  return largest > static_cast<double>(LargestSmallId);
}

std::string CheckMemory(const SizeEstimate& estimate)
{
  LevelCounts last = estimate.Control;
  for (int i = 1; i < estimate.Levels; ++i)
  {
    last = last.Refine();
  }
  const double points = last.Vertices + (estimate.Levels > 0 ? last.Edges + last.Octahedra : 0.);
  double cells = 0.;
  double entries = 0.;
  for (const CellRun& run : estimate.Runs)
  {
    const double children =
      std::ldexp(static_cast<double>(run.Count), run.Dimension * estimate.Levels);
    cells += children;
    entries += children * (run.Dimension + 1);
  }
  double bytes = BytesOfPages + 8. * (entries + cells) + cells +
    estimate.BytesPerPoint * (points + last.Vertices) + estimate.BytesPerCell * cells +
    estimate.BytesPerId * (10. * last.Tets + 18. * last.Octahedra + 13. * last.Edges) +
    (last.Scheme->HasPieces ? 8. * cells : 0.); // OctahedronId
  bytes += 24. * estimate.Frames * points;
  bytes += estimate.KeepsRows ? 9. * estimate.BytesPerId * points : 0.; // simplices of the steps
  if (estimate.Frames > 0 && !estimate.Projects && last.Tets == 0.)
  {
    bytes += (24. + 7. * estimate.BytesPerId) * points; // rings, and points in double
  }
  const auto countLevel = [&]()
  {
    return estimate.BytesPerId *
      (19. * last.Tets + 12. * last.Faces + 24. * last.Edges + last.Scheme->CountMoreIds(last)) +
      estimate.BytesPerPoint * points;
  };
  const auto countRows = [&]()
  {
    return 1.7 * (8. + estimate.BytesPerId) *
      (last.Vertices + 2. * last.Edges + 6. * last.Octahedra);
  };
  if (estimate.ProjectsByRings)
  {
    bytes += countLevel() + 3. * estimate.BytesPerId * points;
    last = last.Refine();
    bytes += estimate.KeepsRows ? 1.3 * countRows() : 0.; // beside the level
  }
  else if (estimate.Projects)
  {
    // Limit rows need the last level in the depth for one more step, and a row of all neighbours
    // for each point, of which some stand twice while blocks are joined.
    last = estimate.Levels > 0 ? last.Refine() : last;
    bytes += countLevel() + countRows();
    if (estimate.Frames > 0)
    {
      bytes += 2.2 * (8. + estimate.BytesPerId) * (last.Vertices + 2. * last.Edges);
    }
  }
  return CheckMemory(cells, points, bytes, estimate.Levels);
}

/// No levels: the filter has no such option.
std::string CheckMemory(double cells, double points, double bytes, int levels)
{
  constexpr double littleMemory = 2. * BytesOfPages; // to ask takes as long as 100 cells
  KeepEstimate(bytes);
  if (bytes * Sharers <= littleMemory)
  {
    return std::string();
  }
  const double available = GetAvailableMemory();
  if (bytes <= available)
  {
    return std::string();
  }
  std::ostringstream message;
  message << (levels > 0 ? "NumberOfLevels = " + std::to_string(levels) : "The output") << " would "
          << (levels > 0 ? "make " : "have ") << Whole(cells) << " cells and " << Whole(points)
          << " points, which takes about " << Bytes(bytes) << "; " << Bytes(available)
          << " are available. Use "
          << (levels > 0 ? "fewer levels, or a part of the input." : "a part of the input.");
  return message.str();
}

void KeepEstimate(double bytes)
{
  Estimate = bytes;
}

void ForgetEstimate()
{
  Estimate = -1.;
}

std::string TellEstimate()
{
  const std::string available = Bytes(GetAvailableMemory()) + " are available.";
  return Estimate < 0. ? available
                       : "About " + Bytes(Estimate) + " were expected to be enough; " + available;
}

double GetAvailableMemory()
{
  vtksys::SystemInformation system;
  const double memory = 1024. * static_cast<double>(system.GetHostMemoryAvailable());
  const double used = 1024. * static_cast<double>(system.GetHostMemoryUsed());
  return memory > 0. ? std::max(0., memory - used) / Sharers
                     : std::numeric_limits<double>::infinity();
}

MemoryShare::MemoryShare(int sharers)
  : Before(Sharers)
{
  Sharers = sharers;
}

MemoryShare::~MemoryShare()
{
  Sharers = this->Before;
}

double GetBytesPerTuple(vtkDataSetAttributes* data)
{
  double bytes = 0.;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    bytes += static_cast<double>(array->GetDataTypeSize()) * array->GetNumberOfComponents();
  }
  return bytes;
}

}
