// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceSubdivision.h"

#include <algorithm>

namespace subdivision
{

void SurfaceCache::ForgetUnused()
{
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const std::unique_ptr<Kept>& kept) { return !kept->Used; }),
    this->Entries.end());
  for (auto& kept : this->Entries)
  {
    kept->Used = false;
  }
}

std::size_t SurfaceCache::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& kept : this->Entries)
  {
    bytes += kept->GetMemorySize();
  }
  return bytes;
}

}
