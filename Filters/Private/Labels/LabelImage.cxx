// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/LabelImage.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

namespace subdivision
{
namespace
{

constexpr int Missing = -1;

vtkIdType CountMaterialVoxels(const Buffer<int>& voxels)
{
  return std::count_if(voxels.begin(), voxels.end(), [](int label) { return label > 0; });
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

/// The voxels of a block that have its label.
void ListMembers(const LabelImage& fine, const LabelImage& coarse, vtkIdType block,
  std::vector<vtkIdType>& members)
{
  members.clear();
  VisitBlock(coarse, block,
    [&](vtkIdType voxel)
    {
      if (fine.Voxels[voxel] == coarse.Voxels[block])
      {
        members.push_back(voxel);
      }
    });
}

/// The entry of Ends for a block.
unsigned char FindEnds(const LabelImage& image, const LabelImage& coarse, vtkIdType block)
{
  const auto at = coarse.GetPlace(block);
  int ends = 0;
  for (int end = 0; end < 6; ++end)
  {
    const int axis = end / 2;
    if (at[axis] == (end % 2 ? coarse.Size[axis] - 1 : 0))
    {
      const vtkIdType layer = end % 2 ? image.Size[axis] - 1 : 0;
      vtkIdType balance = 0;
      VisitBlock(coarse, block,
        [&](vtkIdType voxel)
        {
          if (image.GetPlace(voxel)[axis] == layer)
          {
            balance += image.Voxels[voxel] > 0 ? 1 : -1;
          }
        });
      ends |= balance >= 0 ? 1 << end : 0;
    }
  }
  return static_cast<unsigned char>(ends);
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

vtkVariant FindWholeNumber(vtkDataArray* array, vtkIdType tuple)
{
  const int type = array->GetDataType();
  const vtkVariant value = array->GetVariantValue(tuple * array->GetNumberOfComponents());
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    const bool isLarge = type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
    return isLarge ? vtkVariant(value.ToUnsignedLongLong()) : vtkVariant(value.ToLongLong());
  }
  constexpr double end = 18446744073709551616.; // 2^64
  const double number = value.ToDouble();
  if (!(std::floor(number) == number && number >= -end / 2. && number < end))
  {
    return vtkVariant();
  }
  return number < 0. ? vtkVariant(static_cast<long long>(number))
                     : vtkVariant(static_cast<unsigned long long>(number));
}

std::string ReadLabels(vtkDataArray* array, const vtkVariant& background,
  const std::function<bool(vtkIdType)>& isHidden, LabelImage& image)
{
  const vtkIdType size = array->GetNumberOfTuples();
  image.Voxels = Buffer<int>(size);
  const auto values = Contiguous(array);
  const int bytes = values->GetDataType() == VTK_BIT ? 0 : values->GetDataTypeSize();
  const auto* raw = static_cast<const char*>(values->GetVoidPointer(0));
  std::map<vtkVariant, int> found;
  std::vector<vtkIdType> firsts;
  vtkIdType last = -1; // most voxels have the label of the one before
  int number = 0;
  for (const vtkIdType i : InTurn(size))
  {
    if (isHidden(i))
    {
      image.Voxels[i] = 0;
      continue;
    }
    if (last < 0 || bytes == 0 || std::memcmp(raw + i * bytes, raw + last * bytes, bytes) != 0)
    {
      last = i;
      const vtkVariant label = FindWholeNumber(values, i);
      const double value = values->GetComponent(i, 0);
      if (!label.IsValid() && std::isfinite(value))
      {
        std::ostringstream text;
        text.precision(std::numeric_limits<double>::max_digits10);
        text << value;
        return "(array index 0) holds values that are no whole numbers from -2^63 to 2^64 - 1; the "
               "first is number " +
          std::to_string(i) + ": " + text.str() + ".";
      }
      number = label.IsValid() && !(label == background)
        ? found.emplace(label, static_cast<int>(found.size()) + 1).first->second
        : label.IsValid() ? 0
                          : Missing;
      if (number > static_cast<int>(firsts.size()))
      {
        firsts.push_back(i);
      }
    }
    if (number == Missing)
    {
      image.FirstMissing = image.NumberOfMissing++ == 0 ? i : image.FirstMissing;
    }
    image.Voxels[i] = std::max(number, 0);
  }
  // Numbers in the order of labels.
  std::vector<int> order(found.size() + 1, 0);
  for (const auto& [label, first] : found)
  {
    image.Labels.push_back(label);
    image.FirstVoxels.push_back(firsts[first - 1]);
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
  coarse.FineSize = image.Size;
  coarse.Length = length;
  vtkIdType size = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse.Size[axis] = std::max<vtkIdType>(1, (image.Size[axis] + length / 2) / length);
    size *= coarse.Size[axis];
  }
  coarse.Voxels = Buffer<int>(size);
  coarse.Ends = Buffer<unsigned char>(size);
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> votes;
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        votes.clear();
        VisitBlock(coarse, voxel, [&](vtkIdType fine) { votes.push_back(image.Voxels[fine]); });
        coarse.Voxels[voxel] = Elect(votes);
        coarse.Ends[voxel] = FindEnds(image, coarse, voxel);
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

void CopyVoxelArrays(const LabelImage& fine, const LabelImage& coarse, vtkDataSetAttributes* voxels,
  vtkDataArray* labels, vtkDataSetAttributes* cells,
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
  std::vector<vtkIdType> firsts;
  std::vector<vtkIdType> found;
  for (const vtkIdType block : InTurn(kept))
  {
    ListMembers(fine, coarse, block, found);
    firsts.push_back(found.front());
  }
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
    const auto to = Gather(from, { firsts.data(), firsts.data() + size });
    std::vector<vtkIdType> members;
    for (vtkIdType cell = 0; IsFloating(from) && coarse.Length > 1 && cell < size; ++cell)
    {
      ListMembers(fine, coarse, kept[cell], members);
      SetMean(vtkDataArray::SafeDownCast(from), members, vtkDataArray::SafeDownCast(to), cell);
    }
    cells->AddArray(to);
  }
}

}
