// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Memory/Buffer.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace subdivision
{

void FaultPages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
  constexpr std::size_t page = 4096;
  if (!memory || bytes < 16 * page || vtkSMPTools::GetEstimatedNumberOfThreads() > 1)
  {
    return;
  }
  const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  (void)madvise(
    static_cast<char*>(memory) + skipped, (bytes - skipped) / page * page, MADV_POPULATE_WRITE);
#else
  (void)memory;
  (void)bytes;
#endif
}

void AdviseHugePages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  const std::size_t skipped =
    (hugePage - reinterpret_cast<std::uintptr_t>(memory) % hugePage) % hugePage;
  if (bytes >= skipped + hugePage)
  {
    (void)madvise(
      static_cast<char*>(memory) + skipped, (bytes - skipped) / hugePage * hugePage, MADV_HUGEPAGE);
  }
#else
  (void)memory;
  (void)bytes;
#endif
}

void* AllocateBytes(std::size_t bytes)
{
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  // The last page is huge too where at least half of it is used.
  const std::size_t huge = (bytes + hugePage / 2) / hugePage * hugePage;
  void* memory = nullptr;
  if (huge == 0)
  {
    memory = std::malloc(std::max<std::size_t>(bytes, 1));
    FaultPages(memory, bytes);
  }
  else
  {
    const std::size_t rounded = (bytes + hugePage - 1) / hugePage * hugePage;
#ifdef _WIN32
    memory = std::malloc(rounded);
#else
    memory = std::aligned_alloc(hugePage, rounded);
#endif
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (memory)
    {
      (void)madvise(memory, huge, MADV_HUGEPAGE);
    }
#endif
  }
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

}
