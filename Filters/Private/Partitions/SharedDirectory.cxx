// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedDirectory.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Partitions/Partners.h"

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Shares things out to the partitions that have a mesh, by the first ids of their keys.
class Keepers
{
public:
  Keepers(const SharedKeys& things, Partners& partners)
  {
    vtkIdType last = 0;
    for (std::size_t k = 0; k < things.Keys.size(); k += static_cast<std::size_t>(things.Width))
    {
      last = std::max(last, things.Keys[k]);
    }
    const Ids all = partners.Gather(last);
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
  const SharedKeys& things, int told, const Ids& numbers, int answers, Partners& partners)
  : With(partners)
  , Width(things.Width)
  , Answers(answers)
  , Size(things.Own.size())
{
  const Keepers keepers(things, partners);
  std::map<int, Ids> questions;
  for (const std::size_t i : InTurn(this->Size))
  {
    const auto key = things.Keys.begin() + this->Width * static_cast<std::ptrdiff_t>(i);
    if (*key >= 0)
    {
      const int keeper = keepers.Find(*key);
      Ids& question = questions[keeper];
      question.insert(question.end(), key, key + this->Width);
      question.push_back(things.Own[i]);
      const auto first = numbers.begin() + told * static_cast<std::ptrdiff_t>(i);
      question.insert(question.end(), first, first + told);
      this->Places[keeper].push_back(static_cast<vtkIdType>(i));
    }
  }
  Partners::Messages messages = PackAll(questions);
  partners.Send(messages);
  for (const auto& [from, message] : messages)
  {
    const Ids& ids = this->Arrived[from] = Unpack<vtkIdType>(message);
    const std::size_t size = ids.size() / static_cast<std::size_t>(this->Width + 1 + told);
    Ids& reply = this->Replies[from];
    reply.assign(size * static_cast<std::size_t>(answers), -1);
    const vtkIdType* key = ids.data();
    for (std::size_t i = 0; i < size; ++i, key += this->Width + 1 + told)
    {
      this->Entries.push_back(
        { key, key + this->Width + 1, reply.data() + answers * i, from, key[this->Width] != 0 });
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
  Partners::Messages messages = PackAll(this->Replies);
  this->With.Send(messages);
  Ids answers(this->Size * static_cast<std::size_t>(this->Answers), -1);
  for (const auto& [keeper, message] : messages)
  {
    const Ids answer = Unpack<vtkIdType>(message);
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
