// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkLimit.cxx
 * What no program can beat: allocating and writing arrays of the size of the output. And for an
 * execution with another scalar: reading the operator's last level as compressed rows once.
 */
#include "BenchmarkLimit.h"

#include "BenchmarkMeshes.h"

#include "Core/Memory/Buffer.h"

#include <new>

#include <sys/mman.h>

namespace benchmarks
{
namespace
{

/// Memory fresh from the kernel, in pages of 4 KiB or in huge pages.
class Mapping
{
public:
  Mapping(std::size_t bytes, bool huge)
  {
    constexpr std::size_t hugePage = std::size_t(1) << 21;
    this->Bytes = (bytes + hugePage - 1) / hugePage * hugePage + hugePage;
    this->Start =
      mmap(nullptr, this->Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (this->Start == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    (void)madvise(this->Start, this->Bytes, huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
    const auto address = reinterpret_cast<std::size_t>(this->Start);
    this->Aligned = reinterpret_cast<void*>((address + hugePage - 1) / hugePage * hugePage);
  }
  Mapping(Mapping&& other) noexcept
    : Start(std::exchange(other.Start, nullptr))
    , Aligned(other.Aligned)
    , Bytes(other.Bytes)
  {
  }
  ~Mapping()
  {
    if (this->Start)
    {
      munmap(this->Start, this->Bytes);
    }
  }
  template <typename T>
  T* Get() const
  {
    return static_cast<T*>(this->Aligned);
  }

private:
  void* Start;
  void* Aligned;
  std::size_t Bytes;
};

void WriteAll(std::vector<Mapping>& mappings, const std::vector<std::size_t>& arrays)
{
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    long long* words = mappings[a].Get<long long>();
    subdivision::ForRanges(static_cast<vtkIdType>((arrays[a] + 7) / 8),
      [words](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          words[i] = i;
        }
      });
  }
}

}

Produced RunLimit(Stopwatch& watch, const OutputSize& size, Pages pages)
{
  std::vector<Mapping> mappings;
  auto work = [&]()
  {
    if (mappings.empty())
    {
      for (std::size_t bytes : size.Arrays)
      {
        mappings.emplace_back(bytes, pages != Pages::Small);
      }
    }
    WriteAll(mappings, size.Arrays);
    benchmark::ClobberMemory();
  };
  if (pages == Pages::Warm)
  {
    work();
  }
  watch.Time(work);
  return { size.Cells, size.Bytes };
}

namespace
{

void RegisterLimit()
{
  for (const Case& which : GetCases())
  {
    for (int threads : ThreadCounts)
    {
      const std::string end = "/" + which.Name + "/levels:" + std::to_string(which.Levels);
      const struct
      {
        const char* Name;
        Pages Kind;
      } kinds[] = { { "small", Pages::Small }, { "huge", Pages::Huge }, { "warm", Pages::Warm } };
      for (const auto& kind : kinds)
      {
        Register(std::string("limit/") + kind.Name + end, threads, [&which, kind](Stopwatch& watch)
          { return RunLimit(watch, GetOutputSize(which, which.Levels), kind.Kind); });
      }
    }
  }
}

const Registration Registered(RegisterLimit);

}
}
