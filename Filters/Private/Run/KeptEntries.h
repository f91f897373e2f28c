// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeptEntries.h
 * The memory of a filter between executions: an entry for each mesh that it saw in its last update.
 */
#ifndef SubdivisionObjects_KeptEntries_h
#define SubdivisionObjects_KeptEntries_h

#include "vtkType.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace subdivision
{

/// An entry has a member Used, and a method GetMemorySize.
template <typename Entry>
class KeptEntries
{
public:
  /// Finds an entry that `fits` takes; null if there is none.
  template <typename Fits>
  Entry* Find(const Fits& fits) const
  {
    const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
      [&fits](const std::unique_ptr<Entry>& entry) { return fits(*entry); });
    return found == this->Entries.end() ? nullptr : found->get();
  }
  /// The same among entries that are not used yet. Where each entry serves one input of an update,
  /// two blocks with equal cells each keep one with their own points.
  template <typename Fits>
  Entry* FindUnused(const Fits& fits) const
  {
    return this->Find([&fits](const Entry& entry) { return !entry.Used && fits(entry); });
  }
  Entry* Add(std::unique_ptr<Entry> entry)
  {
    this->Entries.push_back(std::move(entry));
    return this->Entries.back().get();
  }
  void Clear() { this->Entries.clear(); }
  /// Forgets the entries that were not used since the last call.
  void ForgetUnused()
  {
    this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                          [](const std::unique_ptr<Entry>& entry) { return !entry->Used; }),
      this->Entries.end());
    for (const auto& entry : this->Entries)
    {
      entry->Used = false;
    }
  }
  std::size_t GetNumberOfEntries() const { return this->Entries.size(); }
  std::size_t GetMemorySize() const
  {
    std::size_t bytes = 0;
    for (const auto& entry : this->Entries)
    {
      bytes += entry->GetMemorySize();
    }
    return bytes;
  }

  /// How often entries were built.
  vtkIdType NumberOfBuilds = 0;

private:
  std::vector<std::unique_ptr<Entry>> Entries;
};

}

#endif
