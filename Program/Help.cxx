// SPDX-License-Identifier: BSD-3-Clause
#include "Help.h"
#include "Files.h"
#include "Names.h"
#include "Settings.h"

#include <iostream>
#include <sstream>
#include <string>

namespace subdivide
{
namespace
{

/// Text in lines of 79 columns, each after `indent`; paragraphs stay.
void PrintWrapped(const std::string& text, const std::string& indent)
{
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
  {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;)
    {
      if (!line.empty() && indent.size() + line.size() + 1 + word.size() > 79)
      {
        std::cout << indent << line << "\n";
        line.clear();
      }
      line += (line.empty() ? "" : " ") + word;
    }
    std::cout << (line.empty() ? "" : indent) << line << "\n";
  }
}

/// The words of ParaView's panels and menus, where they are others.
std::string Label(const char* label, const char* name)
{
  return Plain(label) == Plain(name) ? std::string() : "   (" + std::string(label) + ")";
}

void PrintOption(const Option& option)
{
  const std::string value = DescribeValue(option);
  std::cout << "\n  --" << option.Name << (value.empty() ? "" : " ") << value;
  if (*option.ShortName)
  {
    std::cout << ", --" << option.ShortName;
  }
  std::cout << Label(option.Label, option.Name) << "\n";
  PrintWrapped(option.Help, "      ");
}

}

void PrintHelp()
{
  std::cout << R"(usage: subdivide INPUT OUTPUT [OPTION...]
       subdivide OUTPUT --filter model|cage [OPTION...]

Makes a coarse mesh of solids, surfaces and curves smooth and fine, or refines,
deforms and examines it.

  subdivide mesh.vtu smooth.vtu --levels 3 --scheme even
  subdivide bunny.ply fine.ply --filter surface --levels 2
  subdivide mesh.vtu fine.vtu --filter red-green --shape smooth --refine curvature=10
  subdivide ship.vtu --filter model --model ship --filter multi --levels 2
  subdivide measure part.vtu

  --filter NAME     what to do, a beginning of one of the names below;
                    several filters work one after another, each with the
                    options that follow it; a first argument that is such a
                    name, and no file, does the same
  --refine WHAT[=NUMBER]  split where this criterion asks for it, and not where
                    the filter does by default; may be given several times
  --slices FOLDER   with the filter sample: a picture (.png) for each layer and
                    material; with --dither black and white by coverage
  --info            print what would come out (cells, points, memory, time),
                    and whether MaximumNumberOfCells stops the run before;
                    write nothing
  --quiet           no warnings and no progress
  --help            this text; after --filter NAME the options of this filter
  --version         version

Options are named as in ParaView's panels: NumberOfLevels is
--number-of-levels or --NumberOfLevels. --OPTION switches on, --no-OPTION off.

Filters, and sources, which have no input:
)";
  for (const Filter& filter : GetFilters())
  {
    std::cout << "\n  " << filter.Name << Label(filter.Label, filter.Name) << "\n";
    PrintWrapped(filter.ShortHelp, "      ");
  }
  std::cout << "\nReads:\n";
  PrintWrapped(ListReadable(), "  ");
  std::cout << "Reads as tables:\n";
  PrintWrapped(ListReadableTables(), "  ");
  std::cout << "Writes (.obj .ply .stl .vtp: surfaces, also those of solids; .obj .ply "
               ".stl\nwithout arrays):\n";
  PrintWrapped(ListWritable(), "  ");
  std::cout << "Writes of tables:\n";
  PrintWrapped(ListWritableTables(), "  ");
  std::cout << "\nThe exit code is 0, 1 if something failed, or 2 if the command line is wrong.\n";
}

void PrintHelp(const Filter& filter)
{
  std::cout << "usage: subdivide " << (filter.HasInput ? "INPUT " : "") << "OUTPUT --filter "
            << filter.Name << " [OPTION...]\n\n";
  PrintWrapped(filter.Help, "");
  if (!filter.Criteria.empty())
  {
    std::cout << "\n  --refine WHAT[=NUMBER]\n";
    for (const Criterion& criterion : filter.Criteria)
    {
      std::cout << "      " << criterion.Name << (*criterion.Number ? "=N" : "") << "\n";
    }
  }
  for (const Option& option : filter.Options)
  {
    PrintOption(option);
  }
}

}
