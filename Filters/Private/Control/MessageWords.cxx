// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/MessageWords.h"

#include "vtkObject.h"
#include "vtkSetGet.h"

#include <cctype>
#include <utility>

namespace subdivision
{
namespace
{

std::map<std::string, MessageWords> WordsOfClasses;

bool IsLetter(const std::string& text, std::size_t at)
{
  return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]));
}

std::string Translate(vtkObject* filter, const std::string& text)
{
  const auto words = WordsOfClasses.find(filter->GetClassName());
  return words == WordsOfClasses.end() ? text : Replace(words->second, text);
}

}

void AddMessageWords(const std::string& className, const MessageWords& words)
{
  WordsOfClasses[className].insert(words.begin(), words.end());
}

std::string Replace(const MessageWords& words, const std::string& text)
{
  std::string made;
  for (std::size_t at = 0; at < text.size();)
  {
    std::pair<std::string, std::string> found;
    for (const auto& word : words)
    {
      const std::size_t size = word.first.size();
      const bool begins = at == 0 || !IsLetter(text, at - 1) || !IsLetter(word.first, 0);
      if (begins && size > found.first.size() && text.compare(at, size, word.first) == 0 &&
        !IsLetter(text, at + size))
      {
        found = word;
      }
    }
    made += found.first.empty() ? text.substr(at, 1) : found.second;
    at += found.first.empty() ? 1 : found.first.size();
  }
  return made;
}

void TellWarning(vtkObject* filter, const std::string& text)
{
  vtkWarningWithObjectMacro(filter, << Translate(filter, text));
}

void TellError(vtkObject* filter, const std::string& text)
{
  vtkErrorWithObjectMacro(filter, << Translate(filter, text));
}

}
