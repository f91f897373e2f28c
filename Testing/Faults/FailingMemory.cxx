// SPDX-License-Identifier: BSD-3-Clause
#include "FailingMemory.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include <link.h>
#include <malloc.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_SANITIZER 1 // which has a malloc of its own
#else
#define HAS_SANITIZER 0
#endif

namespace failing_memory
{
namespace
{

/// Bytes. Small things of VTK itself are made by templates of which the library has the first copy,
/// and VTK does not survive their failure.
constexpr std::size_t Least = 256;

std::atomic<long> left{ -1 };
std::atomic<bool> failed{ false };
std::atomic<long> pieces{ 0 };
std::atomic<long> bytesNow{ 0 };
std::atomic<long> mostBytes{ 0 };
long bytesAtStart = 0;
long allowed = 0; ///< calls, by FailAfter
long made = 0;

struct Addresses
{
  std::uintptr_t Begin = 0;
  std::uintptr_t End = 0;
};

int FindLibrary(dl_phdr_info* info, std::size_t, void* found)
{
  if (!std::strstr(info->dlpi_name, "libvtkSubdivisionObjects"))
  {
    return 0;
  }
  auto* addresses = static_cast<Addresses*>(found);
  addresses->Begin = info->dlpi_addr;
  for (int i = 0; i < info->dlpi_phnum; ++i)
  {
    const std::uintptr_t end =
      info->dlpi_addr + info->dlpi_phdr[i].p_vaddr + info->dlpi_phdr[i].p_memsz;
    addresses->End = end > addresses->End ? end : addresses->End;
  }
  return 1;
}

/// Whether the code that asks stands in the library.
bool IsOurs(const void* caller)
{
  static const Addresses library = []
  {
    Addresses found;
    dl_iterate_phdr(FindLibrary, &found);
    return found;
  }();
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  return address >= library.Begin && address < library.End;
}

bool IsToFail(std::size_t bytes, const void* caller)
{
  if (left.load(std::memory_order_relaxed) < 0 || bytes < Least || !IsOurs(caller) ||
    left.fetch_sub(1) != 0)
  {
    return false;
  }
  failed = true;
  return true;
}

void* New(std::size_t bytes, std::size_t alignment, const void* caller)
{
  void* memory = nullptr;
  if (IsToFail(bytes, caller) || posix_memalign(&memory, alignment, bytes) != 0)
  {
    throw std::bad_alloc();
  }
  return memory;
}

constexpr std::size_t Usual = alignof(std::max_align_t);

}

void FailAfter(long calls)
{
  failed = false;
  allowed = calls;
  left = calls;
}

bool Stop()
{
  made = allowed - left.exchange(-1);
  return failed;
}

long GetNumberOfCalls()
{
  return made;
}

long CountPieces()
{
  return pieces;
}

void StartPeak()
{
#if defined(__GLIBC__) && !HAS_SANITIZER
  // An aligned block in a map of its own counts the rest of the map, which nobody touches and which
  // depends on the address.
  mallopt(M_MMAP_MAX, 0);
#endif
  bytesAtStart = bytesNow;
  mostBytes = bytesAtStart;
}

long GetPeak()
{
  return mostBytes - bytesAtStart;
}

}

void* operator new(std::size_t bytes)
{
  return failing_memory::New(bytes, failing_memory::Usual, __builtin_return_address(0));
}

void* operator new[](std::size_t bytes)
{
  return failing_memory::New(bytes, failing_memory::Usual, __builtin_return_address(0));
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
  return failing_memory::New(
    bytes, static_cast<std::size_t>(alignment), __builtin_return_address(0));
}

void* operator new[](std::size_t bytes, std::align_val_t alignment)
{
  return failing_memory::New(
    bytes, static_cast<std::size_t>(alignment), __builtin_return_address(0));
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

#if defined(__GLIBC__) && !HAS_SANITIZER
namespace
{

long GetSize(void* memory)
{
  return static_cast<long>(malloc_usable_size(memory));
}

/// Keeps the peak; that of several threads may miss what others take at the same time.
void AddBytes(long bytes)
{
  const long now = failing_memory::bytesNow.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  if (now > failing_memory::mostBytes.load(std::memory_order_relaxed))
  {
    failing_memory::mostBytes.store(now, std::memory_order_relaxed);
  }
}

void* Counted(void* memory)
{
  if (memory)
  {
    failing_memory::pieces.fetch_add(1, std::memory_order_relaxed);
    AddBytes(GetSize(memory));
  }
  return memory;
}

}

extern "C"
{
  void* __libc_malloc(std::size_t bytes);
  void* __libc_calloc(std::size_t count, std::size_t bytes);
  void* __libc_realloc(void* memory, std::size_t bytes);
  void* __libc_memalign(std::size_t alignment, std::size_t bytes);
  void __libc_free(void* memory);

  void* malloc(std::size_t bytes)
  {
    return failing_memory::IsToFail(bytes, __builtin_return_address(0))
      ? nullptr
      : Counted(__libc_malloc(bytes));
  }

  void* aligned_alloc(std::size_t alignment, std::size_t bytes)
  {
    return failing_memory::IsToFail(bytes, __builtin_return_address(0))
      ? nullptr
      : Counted(__libc_memalign(alignment, bytes));
  }

  void* calloc(std::size_t count, std::size_t bytes)
  {
    return Counted(__libc_calloc(count, bytes));
  }

  void* realloc(void* memory, std::size_t bytes)
  {
    const long before = memory ? GetSize(memory) : 0;
    void* moved = __libc_realloc(memory, bytes);
    if (!memory)
    {
      return Counted(moved);
    }
    if (bytes == 0)
    {
      failing_memory::pieces.fetch_sub(1, std::memory_order_relaxed);
      AddBytes(-before);
    }
    else if (moved)
    {
      AddBytes(GetSize(moved) - before);
    }
    return moved;
  }

  void* memalign(std::size_t alignment, std::size_t bytes)
  {
    return Counted(__libc_memalign(alignment, bytes));
  }

  int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
  {
    *memory = Counted(__libc_memalign(alignment, bytes));
    return *memory ? 0 : ENOMEM;
  }

  void free(void* memory)
  {
    if (memory)
    {
      failing_memory::pieces.fetch_sub(1, std::memory_order_relaxed);
      AddBytes(-GetSize(memory));
    }
    __libc_free(memory);
  }
}
#endif
