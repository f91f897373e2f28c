// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedDirectory.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Which partition keeps a thing: partitions with a mesh share things by the first ids of keys.
class KeyRanges
{
public:
  KeyRanges(const SharedKeys& things, Exchange& exchange)
  {
    vtkIdType last = 0;
    for (std::size_t k = 0; k < things.Keys.size(); k += static_cast<std::size_t>(things.Width))
    {
      last = std::max(last, things.Keys[k]);
    }
    const Ids all = exchange.Gather(last);
    for (std::size_t p = 0; p < all.size(); ++p)
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
  std::vector<int> Partitions;
};

}

SharedDirectory::SharedDirectory(
  const SharedKeys& things, int told, const Ids& numbers, int answers, Exchange& exchange)
  : With(exchange)
  , Width(things.Width)
  , Answers(answers)
  , Size(things.Own.size())
{
  const KeyRanges ranges(things, exchange);
  for (const std::size_t i : InTurn(this->Size))
  {
    const auto key = things.Keys.begin() + this->Width * static_cast<std::ptrdiff_t>(i);
    if (*key >= 0)
    {
      const int keeper = ranges.Find(*key);
      Ids& question = this->Arrived[keeper];
      question.push_back(things.Own[i] ? *key : -1 - *key);
      question.insert(question.end(), key + 1, key + this->Width);
      const auto first = numbers.begin() + told * static_cast<std::ptrdiff_t>(i);
      question.insert(question.end(), first, first + told);
      this->Places[keeper].push_back(static_cast<vtkIdType>(i));
    }
  }
  exchange.SendLists(this->Arrived);
  for (auto& [from, ids] : this->Arrived)
  {
    const std::size_t size = ids.size() / static_cast<std::size_t>(this->Width + told);
    Ids& reply = this->Replies[from];
    reply.assign(size * static_cast<std::size_t>(answers), -1);
    vtkIdType* key = ids.data();
    for (std::size_t i = 0; i < size; ++i, key += this->Width + told)
    {
      const bool isOwn = *key >= 0;
      *key = isOwn ? *key : -1 - *key;
      this->Entries.push_back({ key, key + this->Width, reply.data() + answers * i, from, isOwn });
    }
  }
  StableSort(this->Entries,
    [this](const Entry& a, const Entry& b)
    {
      return std::lexicographical_compare(a.Key, a.Key + this->Width, b.Key, b.Key + this->Width);
    });
}

Ids SharedDirectory::TakeAnswers()
{
  this->With.SendLists(this->Replies);
  Ids answers(this->Size * static_cast<std::size_t>(this->Answers), -1);
  for (const auto& [keeper, answer] : this->Replies)
  {
    auto from = answer.begin();
    for (const vtkIdType place : InTurn(this->Places.at(keeper)))
    {
      std::copy_n(from, this->Answers, answers.begin() + this->Answers * place);
      from += this->Answers;
    }
  }
  return answers;
}

}
