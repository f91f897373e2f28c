// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedValues.h"

#include "Core/Memory/Loops.h"

#include <numeric>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Of each thing that is not own, the first partition that has it as own, and which of its things
/// it is there; else -1 twice.
Ids FindOwners(const SharedKeys& things, Exchange& exchange)
{
  Ids places(things.Own.size());
  std::iota(places.begin(), places.end(), vtkIdType(0));
  SharedDirectory directory(things, 1, places, 2, exchange);
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

SharedValues::SharedValues(const SharedKeys& things, Exchange& exchange)
  : SharedValues(FindOwners(things, exchange), exchange)
{
}

SharedValues::SharedValues(const Ids& owners, Exchange& exchange)
  : With(exchange)
{
  for (const std::size_t i : InTurn(owners.size() / 2))
  {
    if (owners[2 * i] >= 0)
    {
      const int owner = static_cast<int>(owners[2 * i]);
      this->In[owner].push_back(static_cast<vtkIdType>(i));
      this->Out[owner].push_back(owners[2 * i + 1]);
    }
  }
  exchange.SendLists(this->Out); // its wishes become the wishes of others
}

}
