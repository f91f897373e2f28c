// SPDX-License-Identifier: BSD-3-Clause
#include "TextTable.h"
#include "Files.h"
#include "Messages.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace subdivide
{
namespace
{

/// The values of the next row; empty at the end. Quotes may hold separators and ends of lines.
std::vector<std::string> NextRow(std::istream& file, char separator)
{
  std::vector<std::string> values;
  bool isQuoted = false;
  char letter = 0;
  while (file.get(letter) && (isQuoted || letter != '\n'))
  {
    values.resize(std::max<std::size_t>(values.size(), 1));
    isQuoted = isQuoted != (letter == '"');
    if (letter == separator && !isQuoted)
    {
      values.emplace_back();
    }
    else
    {
      values.back() += letter;
    }
  }
  if (values.empty() && file)
  {
    values.emplace_back(); // an empty line
  }
  return values;
}

bool IsEmpty(const std::string& value)
{
  return value.find_first_not_of(" \t\r") == std::string::npos;
}

}

char FindSeparator(const std::string& name)
{
  if (vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) == ".tsv")
  {
    return '\t';
  }
  std::string line;
  vtksys::ifstream file(name.c_str());
  std::getline(file, line);
  const bool hasCommas = line.find(',') != std::string::npos;
  return hasCommas || line.find(';') == std::string::npos ? ',' : ';';
}

void CheckTextTable(const std::string& name)
{
  const char separator = FindSeparator(name);
  vtksys::ifstream file(name.c_str());
  std::vector<std::string> titles = NextRow(file, separator);
  std::transform(titles.begin(), titles.end(), titles.begin(), GetTitle);
  std::set<std::string> known;
  for (const std::string& title : titles)
  {
    if (!known.insert(title).second)
    {
      throw Failure("the table \"" + name + "\" has two columns with the title \"" + title + "\"");
    }
  }
  int row = 0;
  for (std::vector<std::string> values; !(values = NextRow(file, separator)).empty();)
  {
    if (values.size() == 1 && IsEmpty(values.front()))
    {
      continue; // an empty line
    }
    const std::string where =
      "row " + std::to_string(++row) + " of the table \"" + name + "\" has ";
    if (values.size() != titles.size())
    {
      throw Failure(where + std::to_string(values.size()) + " values, but there are " +
        std::to_string(titles.size()) + " titles");
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (IsEmpty(values[i]))
      {
        Tell("warning",
          where + "nothing in the column \"" + titles[i] + "\": a number becomes 0 there");
      }
    }
  }
}

std::string GetTitle(std::string title)
{
  const std::string mark = "\xef\xbb\xbf";
  title.erase(0, title.compare(0, mark.size(), mark) == 0 ? mark.size() : 0);
  title.erase(0, std::min(title.find_first_not_of(" \t\r\""), title.size()));
  return title.erase(title.find_last_not_of(" \t\r\"") + 1);
}

}
