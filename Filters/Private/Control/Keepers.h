// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Keepers.h
 * The directory of things that several partitions of a mesh have: it is spread over the partitions.
 */
#ifndef SubdivisionObjects_Keepers_h
#define SubdivisionObjects_Keepers_h

#include "Private/Control/Partners.h"
#include "Private/Control/SharedNumbers.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace subdivision
{

inline std::vector<char> PackIds(const std::vector<vtkIdType>& ids)
{
  return Pack(ids);
}

inline std::vector<vtkIdType> UnpackIds(const std::vector<char>& message)
{
  return Unpack<vtkIdType>(message);
}

/// Which partition keeps the things of a key: it knows who has them.
class Keepers
{
public:
  /// All partitions make theirs together.
  Keepers(const SharedKeys& things, Partners& partners)
  {
    vtkIdType last = 0;
    for (size_t k = 0; k < things.Keys.size(); k += static_cast<size_t>(things.Width))
    {
      last = std::max(last, things.Keys[k]);
    }
    const std::vector<vtkIdType> all = partners.Gather(last);
    for (size_t p = 0; p < all.size(); ++p)
    {
      if (all[p] >= 0)
      {
        this->Partitions.push_back(static_cast<int>(p));
        last = std::max(last, all[p]);
      }
    }
    this->Share = last / static_cast<vtkIdType>(this->Partitions.size()) + 1;
  }
  int Find(vtkIdType firstOfKey) const { return this->Partitions[firstOfKey / this->Share]; }

private:
  vtkIdType Share;
  std::vector<int> Partitions; ///< that have a mesh
};

}

#endif
