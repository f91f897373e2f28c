// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedValues.h"

#include "Core/Memory/Loops.h"
#include "Private/Partitions/Partners.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Of each thing that is not own, the first partition that has it as own, and which of its things
/// it is there; else -1 twice.
Ids FindOwners(const SharedKeys& things, Partners& partners)
{
  Ids places(things.Own.size());
  std::iota(places.begin(), places.end(), vtkIdType(0));
  SharedDirectory directory(things, 1, places, 2, partners);
  directory.ForThings(
    [](auto first, auto last)
    {
      const auto owner = std::find_if(first, last, [](const auto& entry) { return entry.IsOwn; });
      for (; owner != last && first != last; ++first)
      {
        if (!first->IsOwn)
        {
          first->Answer[0] = owner->From;
          first->Answer[1] = *owner->Told;
        }
      }
    });
  return directory.TakeAnswers();
}

}

SharedValues::SharedValues(const SharedKeys& things, Partners& partners)
  : With(partners)
{
  const Ids owners = FindOwners(things, partners);
  Things wanted;
  for (const size_t i : InTurn(things.Own.size()))
  {
    if (owners[2 * i] >= 0)
    {
      const int owner = static_cast<int>(owners[2 * i]);
      this->In[owner].push_back(static_cast<vtkIdType>(i));
      wanted[owner].push_back(owners[2 * i + 1]);
    }
  }
  Partners::Messages messages = PackAll(wanted);
  partners.Send(messages);
  for (const auto& [from, message] : messages)
  {
    this->Out[from] = Unpack<vtkIdType>(message);
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
