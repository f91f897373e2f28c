// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Partitions/SharedSides.h"

#include "Core/Memory/Loops.h"
#include "Private/Partitions/OtherPartitions.h"

#include <algorithm>
#include <array>
#include <map>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

/// Two parts, each by its partition and its number there, and whether they are oriented
/// differently.
using PartLink = std::array<vtkIdType, 5>;

/// The answer for a part of a partition: 0, 1, or that it is not orientable.
constexpr vtkIdType NotOrientable = 2;

/// The links between parts that have a face in common, found by the keepers of faces.
std::vector<PartLink> FindLinks(
  const FaceSides& sides, const SharedKeys& faces, OtherPartitions& others)
{
  Ids told;
  for (const size_t f : InTurn(faces.Own.size()))
  {
    told.insert(told.end(), { sides.PartOf[f], sides.Turned[f] });
  }
  std::vector<PartLink> links;
  SharedDirectory directory(faces, 2, told, 0, others);
  directory.ForThings(
    [&links](auto first, auto last)
    {
      for (auto other = first + 1; other != last; ++other)
      {
        links.push_back({ first->From, first->Told[0], other->From, other->Told[0],
          first->Told[1] == other->Told[1] ? 0 : 1 });
      }
    });
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

/// The message of a partition on each of its parts: the smallest key, whether the face with it is
/// turned, and whether the part is twisted.
Ids DescribeParts(const FaceSides& sides, const SharedKeys& faces)
{
  const auto width = static_cast<size_t>(faces.Width);
  const auto key = [&](vtkIdType face)
  { return faces.Keys.begin() + static_cast<std::ptrdiff_t>(width) * face; };
  Ids first = sides.First;
  for (const size_t f : InTurn(faces.Own.size()))
  {
    vtkIdType& least = first[sides.PartOf[f]];
    const auto face = static_cast<vtkIdType>(f);
    if (*key(face) >= 0 &&
      std::lexicographical_compare(
        key(face), key(face) + faces.Width, key(least), key(least) + faces.Width))
    {
      least = face;
    }
  }
  Ids told;
  for (size_t part = 0; part < first.size(); ++part)
  {
    told.insert(told.end(), key(first[part]), key(first[part]) + faces.Width);
    told.push_back(sides.Turned[first[part]]);
    told.push_back(sides.Twisted[part]);
  }
  return told;
}

/// The parts of all partitions, joined to parts of the whole.
class AllParts
{
public:
  explicit AllParts(int width)
    : Width(static_cast<size_t>(width))
  {
  }
  void Add(int partition, const Ids& told)
  {
    this->Offsets[partition] = this->Up.size();
    for (size_t at = 0; at < told.size(); at += this->Width + 2)
    {
      const auto key = told.begin() + static_cast<std::ptrdiff_t>(at);
      this->Keys.emplace_back(key, key + static_cast<std::ptrdiff_t>(this->Width));
      this->Turned.push_back(told[at + this->Width] != 0);
      this->Twisted.push_back(told[at + this->Width + 1] != 0);
      this->Up.push_back(this->Up.size());
      this->Against.push_back(0);
    }
  }
  void Join(const PartLink& link)
  {
    const auto [a, turnedA] = this->Find(this->Offsets.at(static_cast<int>(link[0])) + link[1]);
    const auto [b, turnedB] = this->Find(this->Offsets.at(static_cast<int>(link[2])) + link[3]);
    const bool against = turnedA != turnedB ? link[4] == 0 : link[4] != 0;
    if (a == b)
    {
      this->Twisted[a] = this->Twisted[a] || against;
      return;
    }
    const bool isAFirst = this->Keys[a] < this->Keys[b];
    const size_t top = isAFirst ? a : b;
    const size_t other = isAFirst ? b : a;
    this->Up[other] = top;
    this->Against[other] = against;
    this->Twisted[top] = this->Twisted[top] || this->Twisted[other];
  }
  /// Whether each part of a partition has to be turned.
  Ids Answer(int partition, size_t parts)
  {
    Ids answer;
    const size_t offset = this->Offsets.at(partition);
    for (size_t part = offset; part < offset + parts; ++part)
    {
      const auto [top, against] = this->Find(part);
      answer.push_back(this->Twisted[top] ? NotOrientable : against != this->Turned[top] ? 1 : 0);
    }
    return answer;
  }
  size_t CountParts(const Ids& told) const { return told.size() / (this->Width + 2); }

private:
  /// The part at the top, which has the smallest key, and whether the first face of the given one
  /// is against the first of that.
  std::pair<size_t, bool> Find(size_t part)
  {
    size_t top = part;
    bool against = false;
    for (; this->Up[top] != top; top = this->Up[top])
    {
      against = against != (this->Against[top] != 0);
    }
    const bool found = against;
    while (this->Up[part] != top && part != top) // shorter ways for the next time
    {
      const size_t next = this->Up[part];
      const bool step = this->Against[part] != 0;
      this->Up[part] = top;
      this->Against[part] = against;
      against = against != step;
      part = next;
    }
    return { top, found };
  }

  size_t Width;
  std::map<int, size_t> Offsets;
  std::vector<Ids> Keys;
  std::vector<char> Turned; ///< whether the face of the smallest key is
  std::vector<char> Twisted;
  std::vector<size_t> Up;
  std::vector<char> Against; ///< the part above
};

/// The work of the first partition: joins the parts that all have told, and answers each.
Exchange::Lists<vtkIdType> AnswerAll(
  const Exchange::Lists<vtkIdType>& parts, const std::vector<PartLink>& links, int width)
{
  AllParts all(width);
  for (const auto& [from, told] : parts)
  {
    all.Add(from, told);
  }
  for (const PartLink& link : links)
  {
    all.Join(link);
  }
  Exchange::Lists<vtkIdType> answers;
  for (const auto& [from, told] : parts)
  {
    answers[from] = all.Answer(from, all.CountParts(told));
  }
  return answers;
}

}

std::vector<char> FindSureVertices(const SimplicesOfCells& cells, const OtherPartitions* others)
{
  if (!others)
  {
    return {};
  }
  std::vector<char> isSure(static_cast<std::size_t>(cells.GetView().NumberOfPoints), 0);
  auto vertex = cells.Simplices.Connectivity.begin();
  for (const std::size_t s : InTurn(cells.Simplices.Dimensions.size()))
  {
    const bool isOwn =
      others->IsOwn(cells.ParentCells.empty() ? static_cast<vtkIdType>(s) : cells.ParentCells[s]);
    for (int k = 0; k <= cells.Simplices.Dimensions[s]; ++k, ++vertex)
    {
      isSure[*vertex] = isSure[*vertex] || isOwn;
    }
  }
  return isSure;
}

Buffer<unsigned char> JoinSides(
  const FaceSides& sides, const SharedKeys& faces, OtherPartitions& others)
{
  if (others.Sum(sides.Contradict ? 1 : 0) == 0)
  {
    return Buffer<unsigned char>();
  }
  std::vector<PartLink> links = FindLinks(sides, faces, others);
  const int first = others.FindFirst();
  Exchange::Lists<vtkIdType> parts{ { first, DescribeParts(sides, faces) } };
  others.SendLists(parts);
  others.BringTo(first, links);
  if (others.GetPartition() == first)
  {
    parts = AnswerAll(parts, links, faces.Width);
  }
  others.SendLists(parts);
  const Ids& answer = parts[first];
  Buffer<unsigned char> turned(static_cast<vtkIdType>(faces.Own.size()));
  for (const vtkIdType f : InTurn(turned.size()))
  {
    const vtkIdType told = answer[sides.PartOf[f]];
    turned[f] =
      static_cast<unsigned char>(told == NotOrientable ? 0 : sides.Turned[f] ^ (told != 0 ? 1 : 0));
  }
  return turned;
}

}
