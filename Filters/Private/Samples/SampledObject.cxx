// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/SampledObject.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Samples/Distances.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace subdivision
{

void SampledObject::SetLevel(vtkDataObject* level, bool measures)
{
  this->Level = level;
  this->Meshes.clear();
  this->Bounds.Reset();
  this->Bend = this->Cells = 0.;
  this->Deviation = measures ? 0. : -1.;
  for (vtkUnstructuredGrid* mesh : ListGrids(level))
  {
    SampledMesh made;
    made.Mesh = mesh;
    made.Pieces = MakeQuadraticPieces(mesh, measures);
    this->Cells += static_cast<double>(mesh->GetNumberOfCells());
    this->Bend = std::max(this->Bend, made.Pieces.Bend);
    // Halves of pieces deviate by an eighth where the limit is smooth; a quarter is for where it is
    // less so.
    this->Deviation = measures ? std::max(this->Deviation, made.Pieces.CoarserDeviation / 4.) : -1.;
    for (int dimension = 0; dimension <= 3; ++dimension)
    {
      for (const QuadraticPiece& piece : InTurn(made.Pieces.Pieces[dimension]))
      {
        for (int n = 0; n < QuadraticPiece::CountNodes(dimension); ++n)
        {
          this->Bounds.AddPoint(mesh->GetPoint(piece.Nodes[n]));
        }
      }
    }
    this->Meshes.push_back(std::move(made));
  }
}

void SampledObject::Agree(vtkMultiProcessController* controller)
{
  if (!controller)
  {
    return;
  }
  double bounds[6];
  this->Bounds.GetBounds(bounds); // of an empty box: from large to small
  const double own[9] = { -bounds[0], bounds[1], -bounds[2], bounds[3], -bounds[4], bounds[5],
    this->Bend, this->Deviation, this->Cells };
  double all[9];
  controller->AllReduce(own, all, 9, vtkCommunicator::MAX_OP);
  if (-all[0] <= all[1])
  {
    const double together[6] = { -all[0], all[1], -all[2], all[3], -all[4], all[5] };
    this->Bounds.SetBounds(together);
  }
  this->Bend = all[6];
  this->Deviation = all[7];
  this->Cells = all[8];
}

namespace
{

/// Materials of all ranks in their order, each once.
std::vector<double> Unite(std::vector<double> numbers, vtkMultiProcessController* controller)
{
  numbers = controller ? GatherFromRanks(controller, numbers) : numbers;
  std::sort(numbers.begin(), numbers.end(), IsBeforeMaterial);
  const auto areSame = [](double a, double b) { return !IsBeforeMaterial(a, b); };
  numbers.erase(std::unique(numbers.begin(), numbers.end(), areSame), numbers.end());
  return numbers;
}

}

void SampledObject::FindMaterials(vtkMultiProcessController* controller)
{
  this->Materials = Unite(ListMaterials(this->Meshes, 3), controller);
  std::vector<double> all = this->Materials;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const auto more = ListMaterials(this->Meshes, dimension);
    all.insert(all.end(), more.begin(), more.end());
  }
  all = Unite(all, controller);
  all.erase(
    std::find_if(all.begin(), all.end(), [](double x) { return std::isnan(x); }), all.end());
  const bool hasZero = std::binary_search(all.begin(), all.end(), 0.);
  // Below all for the opacity that volume rendering begins with, if the type has such a number.
  const bool isUnsigned = std::any_of(this->Meshes.begin(), this->Meshes.end(),
    [](const SampledMesh& mesh) { return mesh.Material && mesh.Material->GetDataTypeMin() == 0.; });
  const bool isAnyUnsigned = Unite({ isUnsigned ? 1. : 0. }, controller).back() > 0.;
  this->MaterialOutside = !hasZero ? 0. : isAnyUnsigned ? all.back() + 1. : all.front() - 1.;
}

SampleGrid MakeSampleGrid(const vtkBoundingBox& box, int samples, double spacing, int margin)
{
  SampleGrid grid{};
  double lengths[3];
  box.GetLengths(lengths);
  const double longest = *std::max_element(lengths, lengths + 3);
  if (spacing == 0.)
  {
    margin = longest > 0. ? std::min(margin, (samples - 2) / 2) : margin;
    spacing = longest / std::max(samples - 1 - 2 * margin, 1);
    spacing = spacing > 0. ? spacing : 1.;
  }
  for (int x = 0; x < 3; ++x)
  {
    // Rounding may make a whole number of steps a little larger.
    const double steps = std::ceil(lengths[x] / spacing * (1. - 1e-12)) + 2. * margin;
    const double middle = (box.GetBound(2 * x) + box.GetBound(2 * x + 1)) / 2.;
    grid.Spacing[x] = spacing;
    grid.Origin[x] = middle - steps / 2. * spacing;
    grid.Extent[2 * x + 1] = static_cast<int>(std::min(steps, double(MostSteps)));
  }
  return grid;
}

double CountSamples(const SampleGrid& grid)
{
  double count = 1.;
  for (int x = 0; x < 3; ++x)
  {
    count *= std::max(grid.Extent[2 * x + 1] - double(grid.Extent[2 * x]) + 1., 0.);
  }
  return count;
}

bool HasMostSteps(const SampleGrid& grid)
{
  const auto& extent = grid.Extent;
  return std::max({ double(extent[1]) - extent[0], double(extent[3]) - extent[2],
           double(extent[5]) - extent[4] }) >= MostSteps;
}

namespace
{

/// The nearest of all ranks; a sample is in a solid if it is so on one.
void JoinDistances(
  float* distances, const SampleOptions& options, vtkMultiProcessController* controller)
{
  const auto& others = *options.Others;
  const auto size = static_cast<vtkIdType>(others.size());
  std::vector<std::array<float, 3>> own(size), least(size); // a sign, and two distances
  ForEach(size, [&](vtkIdType s) { own[s] = { distances[s], std::abs(distances[s]), others[s] }; });
  controller->AllReduce(
    own.data()->data(), least.data()->data(), 3 * size, vtkCommunicator::MIN_OP);
  ForEach(size,
    [&](vtkIdType s)
    {
      const auto& [sign, length, other] = least[s];
      distances[s] = Distances::Unite(std::copysign(length, sign), other);
    });
}

}

void JoinRanks(
  vtkImageData* image, const SampleOptions& options, vtkMultiProcessController* controller)
{
  const std::vector<double>& order = *options.Order;
  vtkPointData* const data = image->GetPointData();
  const vtkIdType size = image->GetNumberOfPoints();
  const int own = controller->GetLocalProcessId();
  std::vector<double> least(size);
  controller->AllReduce(order.data(), least.data(), size, vtkCommunicator::MIN_OP);
  if (options.Outside)
  {
    JoinDistances(static_cast<float*>(data->GetArray(SampledDistanceName)->GetVoidPointer(0)),
      options, controller);
  }
  std::vector<int> ranks(size);
  std::vector<int> first(size);
  ForEach(size, [&](vtkIdType s) { ranks[s] = order[s] <= least[s] ? own : VTK_INT_MAX; });
  controller->AllReduce(ranks.data(), first.data(), size, vtkCommunicator::MIN_OP);
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const array = data->GetArray(a);
    if (options.Outside && std::strcmp(array->GetName(), SampledDistanceName) == 0)
    {
      continue;
    }
    const bool isSum =
      options.HasCoverage && std::strcmp(array->GetName(), SampledCoverageName) == 0;
    ForEach(isSum ? 0 : size,
      [&](vtkIdType s)
      {
        for (int c = 0; first[s] != own && c < array->GetNumberOfComponents(); ++c)
        {
          array->SetComponent(s, c, 0.);
        }
      });
    const auto all = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    all->SetNumberOfComponents(array->GetNumberOfComponents());
    all->SetNumberOfTuples(size);
    controller->AllReduce(array, all, vtkCommunicator::SUM_OP);
    std::memcpy(array->GetVoidPointer(0), all->GetVoidPointer(0),
      static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
  }
}

}
