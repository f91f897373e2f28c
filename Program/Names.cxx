// SPDX-License-Identifier: BSD-3-Clause
#include "Names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace subdivide
{
namespace
{

/// How many letters of `a` have to be changed, left out or put in: to become the beginning of `b`
/// that is the most alike, and to become `b`.
std::pair<std::size_t, std::size_t> Distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ changed, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return { *std::min_element(row.begin(), row.end()), row.back() };
}

bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

}

std::string Plain(const std::string& name)
{
  std::string plain;
  for (char letter : name)
  {
    if (std::isalnum(static_cast<unsigned char>(letter)))
    {
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  return plain;
}

std::string DidYouMean(const std::string& name, const std::vector<std::string>& names)
{
  const std::string wanted = Plain(name);
  std::string nearest;
  // More than every second letter wrong is another word.
  std::pair<std::size_t, std::size_t> least(wanted.size() / 2, 0);
  for (const std::string& known : names)
  {
    auto distance = Distance(wanted, Plain(known));
    if (wanted.size() > 3 && Plain(known).find(wanted) != std::string::npos)
    {
      distance = { 0, Plain(known).size() };
    }
    if (distance < least)
    {
      least = distance;
      nearest = known;
    }
  }
  return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}

const Filter& FindFilter(const std::string& name)
{
  const std::string wanted = Plain(name);
  std::vector<const Filter*> begin;
  std::vector<std::string> names;
  if (wanted.empty())
  {
    throw UsageError("\"" + name + "\" is no name of a filter; --help lists them");
  }
  for (const Filter& filter : GetFilters())
  {
    if (Plain(filter.Name) == wanted || Plain(filter.Label) == wanted)
    {
      return filter;
    }
    if (BeginsWith(Plain(filter.Name), wanted) || BeginsWith(Plain(filter.Label), wanted))
    {
      begin.push_back(&filter);
    }
    names.emplace_back(filter.Name);
  }
  if (begin.size() == 1)
  {
    return *begin.front();
  }
  if (begin.size() > 1)
  {
    std::string which;
    for (const Filter* filter : begin)
    {
      which += std::string(which.empty() ? "" : ", ") + filter->Name;
    }
    throw UsageError("several filters are called \"" + name + "\": " + which);
  }
  throw UsageError(
    "there is no filter \"" + name + "\", --help lists them" + DidYouMean(name, names));
}

const Option* FindOption(const Filter& filter, const std::string& name)
{
  const std::string wanted = Plain(name);
  if (wanted.empty()) // most options have no short name
  {
    return nullptr;
  }
  for (const Option& option : filter.Options)
  {
    if (wanted == Plain(option.Name) || wanted == Plain(option.ShortName))
    {
      return &option;
    }
  }
  const Option* labelled = nullptr;
  int count = 0;
  for (const Option& option : filter.Options)
  {
    if (wanted == Plain(option.Label))
    {
      labelled = &option;
      ++count;
    }
  }
  return count == 1 ? labelled : nullptr;
}

std::vector<std::string> GetOptionNames(const Filter& filter)
{
  std::vector<std::string> names;
  for (const Option& option : filter.Options)
  {
    names.push_back(std::string("--") + option.Name);
    if (*option.ShortName)
    {
      names.push_back(std::string("--") + option.ShortName);
    }
  }
  return names;
}

std::vector<std::string> SplitList(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  if (!text.empty() && text.back() == ',')
  {
    parts.emplace_back();
  }
  return parts;
}

}
