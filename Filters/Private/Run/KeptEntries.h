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

/// The kept data of one mesh.
struct KeptEntry
{
  virtual ~KeptEntry() = default;
  virtual std::size_t GetMemorySize() const = 0;

  bool Used = true;
};

class KeptEntries
{
public:
  /// Finds an entry of a type that `fits` takes; null if there is none.
  template <typename Entry, typename Fits>
  Entry* Find(const Fits& fits) const
  {
    for (const std::unique_ptr<KeptEntry>& kept : this->Entries)
    {
      auto* const entry = dynamic_cast<Entry*>(kept.get());
      if (entry && fits(*entry))
      {
        return entry;
      }
    }
    return nullptr;
  }
  /// The same among entries that are not used yet. Where each entry serves one input of an update,
  /// two blocks with equal cells each keep one with their own points.
  template <typename Entry, typename Fits>
  Entry* FindUnused(const Fits& fits) const
  {
    return this->Find<Entry>([&fits](const Entry& entry) { return !entry.Used && fits(entry); });
  }
  template <typename Entry>
  Entry* Add(std::unique_ptr<Entry> entry)
  {
    Entry* const added = entry.get();
    this->Entries.push_back(std::move(entry));
    return added;
  }
  void Clear() { this->Entries.clear(); }
  /// Forgets the entries that were not used since the last call.
  void ForgetUnused()
  {
    this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                          [](const std::unique_ptr<KeptEntry>& entry) { return !entry->Used; }),
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
  std::vector<std::unique_ptr<KeptEntry>> Entries;
};

}

#endif
