# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of filters and options of the program: write_options.py FOLDER_OF_OPTIONS.PY OUTPUT FILE.xml..."""

import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import options  # noqa: E402
from options import quoted  # noqa: E402

KINDS = {"bool": "Switch", "enum": "Choice", "int": "Whole", "id": "Whole", "double": "Real", "set": "Choices",
         "strings": "Names", "array": "Array", "function": "Function", "mesh": "Mesh", "selection": "Selection",
         "table": "Table"}
# The largest numbers of the types, as a double holds them exactly.
LIMITS = {"int": "2147483647.", "id": "9007199254740992.", "selection": "9007199254740992."}
TYPES = {"bool": "bool", "enum": "int", "int": "int", "id": "vtkIdType", "double": "double"}


def setter(one, option):
    """What sets a value; nothing for those whose command follows from their kind."""
    target = f"static_cast<{one.cls}*>(filter)"
    if option.kind in TYPES:
        numbers = [f"value.Numbers[{i}]" for i in range(option.count)]
        if option.kind == "bool":
            body = f"{target}->{option.command}({numbers[0]} != 0.);"
        else:
            casts = ", ".join(f"static_cast<{TYPES[option.kind]}>({number})" for number in numbers)
            body = f"{target}->{option.command}({casts});"
    elif option.kind in ("set", "strings"):
        list_, argument = ("Numbers", "static_cast<int>(one)") if option.kind == "set" else ("Names", "one.c_str()")
        body = f"{target}->{option.clean_command}(); for (const auto& one : value.{list_}) {{ " \
               f"{target}->{option.command}({argument}); }}"
    elif option.kind == "function":
        body = f"{target}->{option.command}(value.Function);"
    else:
        return "nullptr"
    return f"[](vtkAlgorithm* filter, const Value& value) {{ {body} }}"


def getter(one, option):
    """What tells the numbers that are set."""
    if option.kind not in TYPES:
        return "nullptr"
    index, element = ("int", "") if option.count == 1 else ("int index", "[index]")
    return f"[](vtkAlgorithm* filter, {index}) {{ return static_cast<double>(static_cast<{one.cls}*>(filter)->Get" \
           f"{option.command[3:]}(){element}); }}"


def default(option):
    if option.kind == "bool":
        return "on" if option.default == ["1"] else "off"
    if option.kind in ("enum", "set"):
        return ",".join(text for text, value in option.entries if str(value) in option.default)
    return ",".join(option.default) if option.kind in TYPES else ""


def short_name(option):
    return "--" + options.split(option.alias or option.name, "-")


def name_in_messages(one):
    return options.split(one.short_name, "-") if isinstance(one, options.Filter) else "--" + options.split(one.name, "-")


def option_lines(one, option):
    entries, spellings = (", ".join(f"{{ {quoted(text)}, {value} }}" for text, value in pairs)
                          for pairs in (option.entries, option.spellings))
    array = f"{option.index}, {option.association}" if option.kind == "array" else "0, 0"
    return f"""  made.Options.push_back({{ {quoted(option.name)}, {quoted(option.label)}, {quoted(options.split(option.name, '-'))},
    {quoted(options.split(option.alias, '-'))}, Kind::{KINDS[option.kind]}, {quoted(one.in_words(option.help, short_name))},
    {quoted(default(option))}, {option.count}, {{ {entries} }}, {{ {spellings} }}, {option.port}, {array},
    {setter(one, option)},
    {getter(one, option)}, {LIMITS.get(option.kind, "std::numeric_limits<double>::max()")} }});
"""


def filter_lines(one, filters):
    found = options.words(one, filters, name_in_messages, {
        cls: f"{label} of ParaView" for cls, label in options.VTK_FILTERS.items()})
    words = ", ".join(f"{{ {quoted(key)}, {quoted(value)} }}" for key, value in found.items())
    criteria = "".join(f"""  made.Criteria.push_back({{ {quoted(options.split(key[len('RefineBy'):], '-'))}, {quoted(key)}, \
{quoted(value or '')} }});
""" for key, value in one.criteria().items())
    help_ = one.in_words("\n\n".join(one.help), short_name)
    return f"""Filter Make{one.name}()
{{
  Filter made{{ {quoted(options.split(one.short_name, '-'))}, {quoted(one.label)}, {quoted(one.short_help)},
    {quoted(help_)},
    {str(one.has_input).lower()}, []() -> vtkAlgorithm* {{ return {one.cls}::New(); }}, {{}}, {{}}, {quoted(one.cls)},
    {{ {words} }} }};
{''.join(option_lines(one, option) for option in one.options)}{criteria}  return made;
}}

"""


def main():
    filters = options.read(sys.argv[3:])
    includes = "\n".join(f'#include "{cls}.h"' for cls in sorted({one.cls for one in filters}))
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(f"""// Made by Program/write_options.py from the files of Plugin. Edit those.
#include "Options.h"

{includes}

#include <limits>

namespace subdivide
{{
namespace
{{

{''.join(filter_lines(one, filters) for one in filters)}}}

const std::vector<Filter>& GetFilters()
{{
  static const std::vector<Filter> filters{{ {', '.join(f'Make{one.name}()' for one in filters)} }};
  return filters;
}}

}}
""")


main()
