// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Options.h
 * The table of filters and options, which write_options.py makes of the files of Plugin.
 */
#ifndef SubdivisionObjects_Options_h
#define SubdivisionObjects_Options_h

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkImplicitFunction;

namespace subdivide
{

/// What the value of an option is.
enum class Kind
{
  Switch,
  Choice,
  Whole,
  Real,
  Choices,   ///< some of the entries
  Names,     ///< any names
  Array,     ///< the name of an array
  Function,  ///< a sphere, box, ...
  Mesh,      ///< a file, for another input
  Selection, ///< ids, for another input
  Table      ///< a file, for another input
};

/// A value of one of the kinds.
struct Value
{
  std::vector<double> Numbers;
  std::vector<std::string> Names;
  vtkImplicitFunction* Function = nullptr;
};

struct Option
{
  const char* Property;  ///< as in ParaView's Python, "NumberOfLevels"
  const char* Label;     ///< as in the panel
  const char* Name;      ///< "number-of-levels"
  const char* ShortName; ///< "levels"; most have none
  Kind Type;
  const char* Help;
  const char* Default;
  int Count; ///< of numbers
  std::vector<std::pair<const char*, int>> Entries;
  std::vector<std::pair<const char*, int>> Spellings; ///< more names of entries
  int Port;        ///< of another input, or of that which an array belongs to
  int Index;       ///< of an array
  int Association; ///< of an array, unless the input has it elsewhere
  void (*Set)(vtkAlgorithm*, const Value&);
  double (*Get)(vtkAlgorithm*, int); ///< of a number, by index; null: it has none
  double Limit;                      ///< the largest number that its type holds exactly
};

/// A criterion of local refinement: an option that switches it on, and the number that it takes.
struct Criterion
{
  const char* Name;
  const char* Switch;
  const char* Number; ///< empty: it takes none
};

struct Filter
{
  const char* Name;  ///< "red-green-refinement"
  const char* Label; ///< as in the menu
  const char* ShortHelp;
  const char* Help;
  bool HasInput; ///< else it is a source
  vtkAlgorithm* (*New)();
  std::vector<Option> Options;
  std::vector<Criterion> Criteria;
  const char* Class;
  std::map<std::string, std::string> Words; ///< of messages, and those of the program for them
};

/// All filters and sources, by name.
const std::vector<Filter>& GetFilters();

}

#endif
