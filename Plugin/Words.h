// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Words.h
 * Messages of filters in the words of an interface, which write_labels.py and the program list.
 */
#ifndef SubdivisionObjects_Words_h
#define SubdivisionObjects_Words_h

#include "Private/Run/FilterRun.h"

#include <cctype>
#include <map>
#include <string>
#include <utility>

namespace subdivision
{

/// Words of messages, such as "MergePoints" or "array index 5", and what an interface says instead.
using Words = std::map<std::string, std::string>;

/// The text with other words; where several fit, the longest is meant.
inline std::string Replace(const Words& words, const std::string& text)
{
  const auto isLetter = [](const std::string& in, std::size_t at)
  { return at < in.size() && std::isalnum(static_cast<unsigned char>(in[at])); };
  std::string made;
  for (std::size_t at = 0; at < text.size();)
  {
    std::pair<std::string, std::string> found;
    for (const auto& word : words)
    {
      const std::size_t size = word.first.size();
      if (size > found.first.size() && text.compare(at, size, word.first) == 0 &&
        (at == 0 || !isLetter(text, at - 1)) && !isLetter(text, at + size))
      {
        found = word;
      }
    }
    made += found.first.empty() ? text.substr(at, 1) : found.second;
    at += found.first.empty() ? 1 : found.first.size();
  }
  return made;
}

inline std::map<std::string, Words>& GetWordsOfClasses()
{
  static std::map<std::string, Words> words;
  return words;
}

/// From now on messages of a class of filters have these words.
inline void AddWords(const std::string& className, const Words& words)
{
  GetWordsOfClasses()[className].insert(words.begin(), words.end());
  Translate = [](const std::string& name, const std::string& text)
  { return Replace(GetWordsOfClasses()[name], text); };
}

}

#endif
