// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/LabelImage.h"

#include "Core/Memory/Loops.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace subdivision
{
namespace
{

constexpr double LargestLabel = 9007199254740992.; ///< up to which doubles are exact

vtkIdType CountMaterialVoxels(const Buffer<int>& voxels)
{
  return std::count_if(voxels.begin(), voxels.end(), [](int label) { return label > 0; });
}

/// Calls visit(fine voxel) for the voxels of the block of a coarse voxel that the image has.
template <typename Visit>
void VisitBlock(
  const LabelImage& fine, const LabelImage& coarse, int length, vtkIdType voxel, const Visit& visit)
{
  const vtkIdType at[3] = { voxel % coarse.Size[0], voxel / coarse.Size[0] % coarse.Size[1],
    voxel / coarse.Size[0] / coarse.Size[1] };
  vtkIdType end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    end[axis] = std::min((at[axis] + 1) * length, fine.Size[axis]);
  }
  for (vtkIdType k = at[2] * length; k < end[2]; ++k)
  {
    for (vtkIdType j = at[1] * length; j < end[1]; ++j)
    {
      for (vtkIdType i = at[0] * length; i < end[0]; ++i)
      {
        visit(fine.GetId(i, j, k));
      }
    }
  }
}

/// `votes` may be sorted.
int Elect(std::vector<int>& votes)
{
  std::sort(votes.begin(), votes.end());
  int best = 0;
  std::ptrdiff_t most = 0;
  for (auto first = votes.begin(); first != votes.end();)
  {
    const auto last = std::upper_bound(first, votes.end(), *first);
    if (last - first > most || (last - first == most && best == 0))
    {
      best = *first;
      most = last - first;
    }
    first = last;
  }
  return best;
}

bool IsFloating(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

void SetMean(
  vtkDataArray* from, const std::vector<vtkIdType>& tuples, vtkDataArray* to, vtkIdType tuple)
{
  for (int c = 0; c < from->GetNumberOfComponents(); ++c)
  {
    double sum = 0.;
    for (const vtkIdType i : InTurn(tuples))
    {
      sum += from->GetComponent(i, c);
    }
    double mean = sum / static_cast<double>(tuples.size());
    if (!std::isfinite(sum)) // the mean of large values is finite
    {
      mean = 0.;
      for (const vtkIdType i : tuples)
      {
        mean += from->GetComponent(i, c) / static_cast<double>(tuples.size());
      }
    }
    to->SetComponent(tuple, c, mean);
  }
}

}

std::string ReadLabels(vtkDataArray* array, double background,
  const std::function<bool(vtkIdType)>& isHidden, LabelImage& image)
{
  const vtkIdType size = array->GetNumberOfTuples();
  image.Voxels = Buffer<int>(size);
  std::map<double, int> found;
  double last = background; // most voxels have the label of the one before
  int number = 0;
  for (const vtkIdType i : InTurn(size))
  {
    const double label = isHidden(i) ? background : array->GetComponent(i, 0);
    if (!(std::floor(label) == label) || !(std::abs(label) < LargestLabel))
    {
      return "(array index 0) holds values that are no whole numbers below 2^53; the first is "
             "number " +
        std::to_string(i) + ": " + std::to_string(label) + ".";
    }
    if (label != last)
    {
      last = label;
      number = label == background
        ? 0
        : found.emplace(label, static_cast<int>(found.size()) + 1).first->second;
    }
    image.Voxels[i] = number;
  }
  // Numbers in the order of labels.
  std::vector<int> order(found.size() + 1, 0);
  for (const auto& [label, first] : found)
  {
    image.Labels.push_back(label);
    order[first] = static_cast<int>(image.Labels.size());
  }
  ForEach(size, [&](vtkIdType i) { image.Voxels[i] = order[image.Voxels[i]]; });
  image.NumberOfMaterialVoxels = CountMaterialVoxels(image.Voxels);
  return std::string();
}

LabelImage Coarsen(const LabelImage& image, int length)
{
  LabelImage coarse;
  coarse.Labels = image.Labels;
  vtkIdType size = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse.Size[axis] = (image.Size[axis] + length - 1) / length;
    size *= coarse.Size[axis];
  }
  coarse.Voxels = Buffer<int>(size);
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> votes;
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        votes.clear();
        VisitBlock(image, coarse, length, voxel,
          [&](vtkIdType fine) { votes.push_back(image.Voxels[fine]); });
        votes.resize(static_cast<std::size_t>(length) * length * length, 0);
        coarse.Voxels[voxel] = Elect(votes);
      }
    });
  coarse.NumberOfMaterialVoxels = CountMaterialVoxels(coarse.Voxels);
  return coarse;
}

int FindBlockLength(const LabelImage& image, vtkIdType wanted)
{
  const vtkIdType size = image.NumberOfMaterialVoxels;
  if (wanted <= 0 || size <= wanted)
  {
    return 1;
  }
  // Blocks of the border have fewer voxels of materials each, so that there are more of them.
  const vtkIdType longest = *std::max_element(image.Size.begin(), image.Size.end());
  int length = std::max(2, static_cast<int>(std::cbrt(static_cast<double>(size) / wanted)));
  while (length < longest && Coarsen(image, length).NumberOfMaterialVoxels > wanted)
  {
    ++length;
  }
  return length;
}

void CopyVoxelArrays(const LabelImage& fine, const LabelImage& coarse, int length,
  vtkDataSetAttributes* voxels, vtkDataArray* labels, vtkDataSetAttributes* cells,
  const std::function<void(const std::string&)>& warn)
{
  std::vector<vtkIdType> kept; // coarse voxels
  for (const vtkIdType voxel : InTurn(coarse.Voxels.size()))
  {
    if (coarse.Voxels[voxel] > 0)
    {
      kept.push_back(voxel);
    }
  }
  const auto size = static_cast<vtkIdType>(kept.size());
  for (int i = 0; i < voxels->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = voxels->GetAbstractArray(i);
    if (from == labels || from == voxels->GetGlobalIds() || from == voxels->GetPedigreeIds() ||
      (from->GetName() && from->GetName() == std::string(vtkDataSetAttributes::GhostArrayName())))
    {
      continue;
    }
    if (from->GetNumberOfTuples() != fine.Voxels.size())
    {
      warn("The filter leaves out the array \"" +
        std::string(from->GetName() ? from->GetName() : "") +
        "\": it does not have one value for each voxel.");
      continue;
    }
    const auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(size);
    std::vector<vtkIdType> members;
    for (const vtkIdType cell : InTurn(size))
    {
      members.clear();
      VisitBlock(fine, coarse, length, kept[cell],
        [&](vtkIdType voxel)
        {
          if (fine.Voxels[voxel] == coarse.Voxels[kept[cell]])
          {
            members.push_back(voxel);
          }
        });
      to->SetTuple(cell, members.front(), from);
      if (members.size() > 1 && IsFloating(from))
      {
        SetMean(vtkDataArray::SafeDownCast(from), members, vtkDataArray::SafeDownCast(to), cell);
      }
    }
    cells->AddArray(to);
  }
}

}
