// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/ReturnedMemory.h"

#include "Core/Memory/Buffer.h"
#include "Private/Arrays/Arrays.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace subdivision
{
namespace
{

struct Block
{
  std::size_t Owner = 0;
  std::size_t Bytes = 0;
  bool IsAwaited = false;
  bool IsBack = false;
};

/// All blocks that arrays have, and blocks that came back. Arrays may live longer than static
/// objects, so this is never destroyed.
struct Blocks
{
  std::mutex Lock;
  std::map<void*, Block> All;
  std::size_t NumberOfOwners = 0;
};
Blocks& GetBlocks()
{
  static auto* blocks = new Blocks;
  return *blocks;
}

/// VTK calls this when nobody has the memory any more.
void FreeOrKeep(void* memory)
{
  Blocks& blocks = GetBlocks();
  {
    const std::lock_guard<std::mutex> lock(blocks.Lock);
    const auto found = blocks.All.find(memory);
    if (found != blocks.All.end())
    {
      found->second.IsBack = found->second.IsAwaited;
      if (found->second.IsBack)
      {
        return;
      }
      blocks.All.erase(found);
    }
  }
  std::free(memory);
}

}

ReturnedMemory::ReturnedMemory()
  : Owner(
      []
      {
        const std::lock_guard<std::mutex> lock(GetBlocks().Lock);
        return GetBlocks().NumberOfOwners++;
      }())
{
}

ReturnedMemory::~ReturnedMemory()
{
  this->Release();
}

void ReturnedMemory::Await()
{
  const std::lock_guard<std::mutex> lock(GetBlocks().Lock);
  for (auto& [memory, block] : GetBlocks().All)
  {
    block.IsAwaited = block.IsAwaited || block.Owner == this->Owner;
  }
}

void ReturnedMemory::Release()
{
  std::vector<void*> unused; // to free them takes long, so others do not wait for it
  {
    const std::lock_guard<std::mutex> lock(GetBlocks().Lock);
    auto& all = GetBlocks().All;
    for (auto next = all.begin(); next != all.end();)
    {
      const auto at = next++;
      if (at->second.Owner == this->Owner)
      {
        at->second.IsAwaited = false;
        if (at->second.IsBack)
        {
          unused.push_back(at->first);
          all.erase(at);
        }
      }
    }
  }
  std::for_each(unused.begin(), unused.end(), std::free);
}

/// Memory that came back, or null.
void* ReturnedMemory::Take(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(GetBlocks().Lock);
  for (auto& [memory, block] : GetBlocks().All)
  {
    if (block.Owner == this->Owner && block.IsBack && block.Bytes == bytes)
    {
      block.IsBack = block.IsAwaited = false;
      return memory;
    }
  }
  return nullptr;
}

vtkSmartPointer<vtkDataArray> ReturnedMemory::MakeArray(
  int valueType, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(valueType));
  const vtkIdType values = tuples * components;
  const std::size_t bytes = static_cast<std::size_t>(values) * array->GetDataTypeSize();
  if (bytes < LeastBytes)
  {
    Allocate(array, components, tuples);
    return array;
  }
  void* memory = this->Take(bytes);
  if (!memory)
  {
    std::unique_ptr<void, void (*)(void*)> made(AllocateBytes(bytes), std::free);
    const std::lock_guard<std::mutex> lock(GetBlocks().Lock);
    GetBlocks().All[made.get()] = Block{ this->Owner, bytes, false, false };
    memory = made.release();
  }
  array->SetNumberOfComponents(components);
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(FreeOrKeep);
  return array;
}

}
