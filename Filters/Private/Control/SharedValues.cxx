// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/SharedValues.h"

#include "Core/Memory/Loops.h"
#include "Private/Control/Keepers.h"
#include "Private/Control/Partners.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Finds a number by a key of several ids. Keys are not copied.
class KeyTable
{
public:
  explicit KeyTable(int width)
    : Width(width)
  {
  }
  void Add(const vtkIdType* key, vtkIdType number) { this->Entries.emplace_back(key, number); }
  /// Called after the last Add. Of equal keys the first one that was added counts.
  void Sort()
  {
    std::stable_sort(this->Entries.begin(), this->Entries.end(),
      [this](const Entry& a, const Entry& b) { return this->IsLess(a.first, b.first); });
  }
  /// -1 if there is no such key.
  vtkIdType Find(const vtkIdType* key) const
  {
    const auto found = std::lower_bound(this->Entries.begin(), this->Entries.end(), key,
      [this](const Entry& entry, const vtkIdType* k) { return this->IsLess(entry.first, k); });
    return found == this->Entries.end() || this->IsLess(key, found->first) ? -1 : found->second;
  }

private:
  using Entry = std::pair<const vtkIdType*, vtkIdType>;

  bool IsLess(const vtkIdType* a, const vtkIdType* b) const
  {
    return std::lexicographical_compare(a, a + this->Width, b, b + this->Width);
  }

  int Width;
  std::vector<Entry> Entries;
};

/// The answers of this partition to questions for owners: to each partition for its keys.
Partners::Messages AnswerOwners(const Partners::Messages& questions, size_t width)
{
  KeyTable owners(static_cast<int>(width));
  std::map<int, Ids> asked;
  for (const auto& [from, message] : questions)
  {
    const Ids& ids = asked[from] = UnpackIds(message);
    for (size_t i = 0; i < static_cast<size_t>(ids[0]); ++i)
    {
      owners.Add(ids.data() + 1 + width * i, from);
    }
  }
  owners.Sort();
  Partners::Messages answers;
  for (const auto& [from, ids] : asked)
  {
    Ids answer;
    for (size_t at = 1 + width * static_cast<size_t>(ids[0]); at < ids.size(); at += width)
    {
      answer.push_back(owners.Find(ids.data() + at));
    }
    if (!answer.empty())
    {
      answers[from] = PackIds(answer);
    }
  }
  return answers;
}

/// Of each thing that is not own, the first partition that has it as own; else -1. A question to a
/// keeper has the number of own things, their keys, and the keys of the others.
Ids FindOwners(const SharedKeys& things, Partners& partners)
{
  const Keepers keepers(things, partners);
  const auto width = static_cast<size_t>(things.Width);
  std::map<int, Ids> questions;
  std::map<int, std::vector<size_t>> places;
  for (const bool own : { true, false })
  {
    for (size_t i = 0; i < things.Own.size(); ++i)
    {
      if (static_cast<bool>(things.Own[i]) != own)
      {
        continue;
      }
      const vtkIdType* key = things.Keys.data() + width * i;
      const int keeper = keepers.Find(key[0]);
      Ids& ids = questions[keeper];
      ids.resize(std::max<size_t>(ids.size(), 1), 0);
      ids.insert(ids.end(), key, key + width);
      if (own)
      {
        ++ids[0];
      }
      else
      {
        places[keeper].push_back(i);
      }
    }
  }
  Partners::Messages messages;
  for (const auto& [keeper, ids] : questions)
  {
    messages[keeper] = PackIds(ids);
  }
  partners.Send(messages);
  messages = AnswerOwners(messages, width);
  partners.Send(messages);
  Ids owners(things.Own.size(), -1);
  for (const auto& [keeper, message] : messages)
  {
    const Ids answer = UnpackIds(message);
    for (size_t i = 0; i < answer.size(); ++i)
    {
      owners[places[keeper][i]] = answer[i];
    }
  }
  return owners;
}

}

SharedValues::SharedValues(const SharedKeys& things, Partners& partners)
  : With(partners)
{
  const auto width = static_cast<size_t>(things.Width);
  const Ids owners = FindOwners(things, partners);
  std::map<int, Ids> wanted;
  KeyTable own(things.Width);
  for (const size_t i : InTurn(owners.size()))
  {
    const vtkIdType* key = things.Keys.data() + width * i;
    if (owners[i] >= 0)
    {
      const int owner = static_cast<int>(owners[i]);
      this->In[owner].push_back(static_cast<vtkIdType>(i));
      wanted[owner].insert(wanted[owner].end(), key, key + width);
    }
    else if (things.Own[i])
    {
      own.Add(key, static_cast<vtkIdType>(i));
    }
  }
  own.Sort();
  Partners::Messages messages;
  for (const auto& [owner, keys] : wanted)
  {
    messages[owner] = PackIds(keys);
  }
  partners.Send(messages);
  for (const auto& [from, message] : messages)
  {
    const Ids keys = UnpackIds(message);
    for (size_t at = 0; at < keys.size(); at += width)
    {
      this->Out[from].push_back(own.Find(keys.data() + at));
    }
  }
}

void SharedValues::TakeOthers(double* values, int components)
{
  const size_t size = static_cast<size_t>(components) * sizeof(double);
  Partners::Messages messages;
  for (const auto& [to, things] : this->Out)
  {
    std::vector<char>& message = messages[to];
    message.resize(size * things.size());
    for (size_t i = 0; i < things.size(); ++i)
    {
      std::memcpy(message.data() + size * i, values + components * things[i], size);
    }
  }
  this->With.Send(messages);
  for (const auto& [from, things] : this->In)
  {
    const std::vector<char>& message = messages.at(from);
    for (size_t i = 0; i < things.size(); ++i)
    {
      std::memcpy(values + components * things[i], message.data() + size * i, size);
    }
  }
}

}
