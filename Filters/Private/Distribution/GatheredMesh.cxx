// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/GatheredMesh.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/Blocks.h"
#include "Private/Distribution/MeshMessage.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/Distribution/PointIds.h"
#include "Private/Distribution/Ranks.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// A number that differs for meshes that differ in points or cells.
vtkIdType Hash(const std::vector<Block>& blocks)
{
  std::uint64_t hash = 14695981039346656037u;
  auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
  for (const Block& block : blocks)
  {
    for (const std::uint64_t part :
      ComputeFingerprint(Contiguous(block.Input->GetPoints()->GetData())))
    {
      add(part);
    }
    std::vector<vtkIdType> ids;
    CellReader(block.Input).GetAllIds(ids);
    for (const vtkIdType id : ids)
    {
      add(static_cast<std::uint64_t>(id));
    }
  }
  return static_cast<vtkIdType>(hash >> 1);
}

/// Whether all ranks have the same blocks.
bool IsAlikeEverywhere(const std::vector<Block>& blocks, Exchange& ranks)
{
  const std::vector<vtkIdType> all = ranks.Gather(Hash(blocks));
  return std::all_of(all.begin(), all.end(), [&](vtkIdType hash) { return hash == all[0]; });
}

/// The parts of all ranks, in the order of ranks.
std::vector<MeshPart> SendToAll(const std::vector<MeshPart>& own, Exchange& ranks)
{
  std::vector<char> message;
  for (const MeshPart& part : own)
  {
    std::vector<vtkIdType> cells;
    for (size_t c = 0; c < part.Cells.size(); ++c)
    {
      if (part.Cells[c] >= 0)
      {
        cells.push_back(static_cast<vtkIdType>(c));
      }
    }
    PackCells(part, cells, message);
  }
  ranks.ShareWithAll(message);
  std::vector<MeshPart> all;
  UnpackCells(message, all);
  return all;
}

}

vtkSmartPointer<vtkPointSet> GatherMesh(vtkDataObject* input, vtkMultiProcessController* controller,
  const std::function<void(const std::string&)>& warn)
{
  PartitionsOfRank ofRank(controller);
  ExchangeOfAll ranks(ofRank);
  auto* single = vtkPointSet::SafeDownCast(input);
  if (single && ranks.GetNumberOfPartitions() == 1)
  {
    return single;
  }
  const std::vector<Block> blocks = GetBlocks(input, false, warn);
  const bool alike = ranks.GetNumberOfPartitions() == 1 || IsAlikeEverywhere(blocks, ranks);
  if (alike && blocks.size() < 2)
  {
    return blocks.empty() ? nullptr : blocks[0].Input;
  }
  std::vector<MeshPart> parts;
  for (const Block& block : blocks)
  {
    parts.push_back({ block.Input, 0, {}, {} });
  }
  PartitionsOfRank one;
  ExchangeOfAll alone(one);
  Exchange& exchange = alike ? alone : ranks;
  IdentifyPoints(parts, exchange, warn);
  const int pointType = FindPointType(parts, exchange);
  if (!alike)
  {
    parts = SendToAll(parts, ranks);
  }
  const vtkSmartPointer<vtkPointSet> mesh = Join(parts, pointType).Mesh;
  mesh->GetCellData()->RemoveArray(BlockName);
  return mesh;
}

}
