# SPDX-License-Identifier: BSD-3-Clause
"""One source with many mutations in it, of which an environment variable chooses one when a program starts.

So a file is compiled once for all of them. A statement is written once more for each of its mutations, as a
branch or as an operand of ?:. Where that cannot be (constants, tables, heads of functions), the mutation is left
out and has to be compiled alone. What is computed while the code is compiled is not mutated.
"""
import re

import mutations

VARIABLE = "SUBDIVISION_MUTATION"
HEADER = "MutationChoice.h"
HEADER_TEXT = """
#ifndef MutationChoice_h
#define MutationChoice_h
#include <cstdlib>
namespace mutation
{
inline int ReadChoice()
{
  const char* text = std::getenv("%s");
  return text ? std::atoi(text) : 0;
}
inline const int Choice = ReadChoice();
inline bool IsSwitchedOn(int k) // a variable that it initializes is no constant
{
  return k == Choice;
}
constexpr bool IsChosen(int k)
{
  return !__builtin_is_constant_evaluated() && IsSwitchedOn(k);
}
}
#endif
""" % VARIABLE
MOST_LINES = 8  # of a statement
ENDS = re.compile(r"(^|[;{}:]|\belse|^\s*(if|for|while|switch|else if)\b.*\))\s*$")
CONTROL = re.compile(r"^\s*(else )?(if|while|for|switch) \(")
BRANCH = re.compile(r"^(\s*(?:else )?(?:if|while) )\((.*)\)\s*$", re.S)
LOOP = re.compile(r"^(\s*for )\((.*)\)\s*$", re.S)
RETURN = re.compile(r"^\s*return\b.*;\s*$", re.S)
CONSTANT = re.compile(r"^(?:inline |static )?constexpr ([\w:]+(?:<[\w, ]+>)? \w+)( =\s+| ?(?={))(.*);\s*$", re.S)
CONSTANT_BEGIN = re.compile(r"^constexpr (\w+ \w+(?:\[\w*\])*(?: =|\{))")
TABLE_BEGIN = re.compile(r"^constexpr \w+ \w+\[\w*\]")
FUNCTION_BEGIN = re.compile(r"^(\s*(?:static )?)constexpr (?=[^=;{]*\()")
LIST = re.compile(r"^(\s*(?:static |inline )*)(?:(constexpr|const) )?([\w:]+(?:<[\w:, ]+>)? \w+(?:\[\w*\])*(?: = ?)?\{)(.*)(\};\s*)$", re.S)
MEMBER = re.compile(r"^(\s+static )constexpr (\w+ \w+ =\s+)(.*);\s*$", re.S)
ONE_LINE = re.compile(r"^(.*\)(?: const)? \{ )(return .*;)( \})$")
VARIABLE_IN_BRACES = re.compile(r"^\s*(const )?[\w:]+(<.*>)? [*&]?\w+[{(\[;]")
DECLARATION = re.compile(r"^(\s*(?:[\w:<>,*& \[\].\->()]+?[ *&])?(\w+) =\s+)(.*);\s*$", re.S)


def hide(text):
    """The lines of a source with blanks in place of comments, strings and directives."""
    lines = []
    is_comment = False
    for line in text.split("\n"):
        code, is_comment = mutations.hide_text(line, is_comment)
        lines.append("" if re.match(r"\s*#", code) else code)
    return lines


def get_depth(code):
    return sum(code.count(sign) for sign in "([{") - sum(code.count(sign) for sign in ")]}")


def find_statement(lines, place):
    """First line of the statement that has the line `place`, and the line behind it, or None."""
    begin = place
    while begin > 0 and not ENDS.search(lines[begin - 1]):
        begin -= 1
    depth = 0
    for end in range(begin, min(begin + MOST_LINES, len(lines))):
        if end > begin and lines[end].rstrip().endswith("{"):
            return None
        depth += get_depth(lines[end])
        last = lines[end].rstrip()[-1:]
        if depth < 0:
            return None
        if depth == 0 and (last == ";" or last == ")" and CONTROL.match(lines[begin])):
            return (begin, end + 1) if begin <= place <= end else None
        if depth == 0 and ONE_LINE.match(lines[end]) and begin == end:
            return begin, end + 1
    return None


def split_outside(text, sign):
    """Splits where no bracket is open."""
    parts = [""]
    depth = 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == sign and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def split_items(text):
    """The items of a list, also of lists in it, and between them the commas and brackets."""
    parts = [""]
    depth = 0
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter in "{}," and depth == 0:
            parts += [letter, ""]
        else:
            parts[-1] += letter
    return parts


def choose_value(number, changed, rest, ask="IsChosen"):
    return "::mutation::%s(%d) ? (%s) : %s" % (ask, number, changed, rest)


def is_declaration(text):
    """Whether what stands left of = names a type."""
    left = DECLARATION.match(text)
    if not left:
        return False
    bare = left[1].rpartition("=")[0].strip()
    while re.search(r"[\[(<][^\[\](<>)]*[\])>]", bare):
        bare = re.sub(r"[\[(<][^\[\](<>)]*[\])>]", "", bare)
    return " " in bare.strip() and not bare.strip().endswith(("+", "-", "*", "/", "|", "&", "%"))


class Statement:
    """What stands in place of a statement; mutations are added to it one by one."""

    def __init__(self, text):
        self.text = text
        self.changed = []  # (number, changed text)
        self.kind = self.find_kind()

    def find_kind(self):
        if CONSTANT.match(self.text):
            return "constant"
        if MEMBER.match(self.text):
            return "member"
        if LIST.match(self.text):
            return "table" if TABLE_BEGIN.match(self.text) else "list"
        if re.search(r"\b(constexpr|static_assert|using|template|case|default|static)\b", self.text):
            return ""
        if BRANCH.match(self.text):
            inside = BRANCH.match(self.text)[2]
            return "" if ";" in inside or re.search(r"[^=!<>+*/|&-]= ", inside) else "branch"
        if LOOP.match(self.text):
            return "loop" if len(split_outside(LOOP.match(self.text)[2], ";")) == 3 else ""
        if CONTROL.match(self.text):
            return ""
        if RETURN.match(self.text):
            return "statement"
        if ONE_LINE.match(self.text):
            return "one line"
        if not self.text.rstrip().endswith(";") or VARIABLE_IN_BRACES.match(self.text):
            return ""
        if is_declaration(self.text):
            return "" if DECLARATION.match(self.text)[3].lstrip().startswith("{") else "declaration"
        return "statement" if re.match(r"^\s*(this->|\*?[a-z]\w*(::|\.|->|\[|\(|\+\+| [-+*|&]?= )|\+\+|--)", self.text) else ""

    def add(self, number, changed):
        """Returns whether the mutation can be one of several."""
        if re.search(r"[-+*/%&|=<>?:,(]\s*;\s*$", changed):  # the end of a statement of several lines is gone
            return False
        if self.kind == "constant":
            if not CONSTANT.match(changed) or CONSTANT.match(changed)[1] != CONSTANT.match(self.text)[1]:
                return False
        elif self.kind == "member":
            if not MEMBER.match(changed) or MEMBER.match(changed)[2] != MEMBER.match(self.text)[2]:
                return False
        elif self.kind in ("list", "table"):
            if self.find_item(changed) is None:
                return False
        elif self.kind == "declaration":
            mine, other = DECLARATION.match(self.text), DECLARATION.match(changed)
            if not other or mine[1] != other[1]:
                return False
        elif self.kind == "branch":
            if not BRANCH.match(changed) or BRANCH.match(changed)[1] != BRANCH.match(self.text)[1]:
                return False
        elif self.kind == "loop":
            if not LOOP.match(changed) or len(self.find_loop_changes(changed)) != 1:
                return False
        elif self.kind == "one line":
            if not ONE_LINE.match(changed) or ONE_LINE.match(changed)[1] != ONE_LINE.match(self.text)[1]:
                return False
        elif self.kind != "statement":
            return False
        self.changed.append((number, changed))
        return True

    def find_item(self, changed):
        """Which item of a list is changed, or None."""
        mine, other = LIST.match(self.text), LIST.match(changed)
        if not other or mine[3] != other[3]:
            return None
        items = [split_items(one[4]) for one in (mine, other)]
        found = [k for k, (one, two) in enumerate(zip(*items)) if one != two]
        return found[0] if len(items[0]) == len(items[1]) and len(found) == 1 and found[0] % 2 == 0 else None

    def write_list(self):
        """A list with a choice in each changed item; it is no constant, as a choice is none."""
        head, constant, name, inside, tail = LIST.match(self.text).groups()
        items = split_items(inside)
        for number, changed in reversed(self.changed):
            k = self.find_item(changed)
            items[k] = "(%s)" % choose_value(number, split_items(LIST.match(changed)[4])[k], "(%s)" % items[k], "IsSwitchedOn")
        constant = "const " if constant else ""
        if constant and "inline" not in head and ("static" in head or self.kind == "table"):
            head += "inline "
        return "%s%s%s%s%s" % (head, constant, name, "".join(items), tail)

    def find_loop_changes(self, changed):
        mine = split_outside(LOOP.match(self.text)[2], ";")
        other = split_outside(LOOP.match(changed)[2], ";")
        if len(other) != 3:
            return []
        found = [k for k in range(3) if mine[k] != other[k]]
        if found == [0]:
            first, second = DECLARATION.match(mine[0] + ";"), DECLARATION.match(other[0] + ";")
            if not first or not second or first[1] != second[1] or len(split_outside(mine[0], ",")) > 1:
                return []
        return found

    def write_loop(self):
        head, inside = LOOP.match(self.text).groups()
        parts = split_outside(inside, ";")
        first = DECLARATION.match(parts[0] + ";")
        values = [first[3] if first else "", "bool(%s)" % parts[1], "(void)(%s)" % parts[2]]
        for number, changed in reversed(self.changed):
            other = split_outside(LOOP.match(changed)[2], ";")
            k = self.find_loop_changes(changed)[0]
            piece = DECLARATION.match(other[0] + ";")[3] if k == 0 else ("bool(%s)" if k == 1 else "(void)(%s)") % other[k]
            values[k] = choose_value(number, piece, values[k])
        return "%s(%s; %s; %s)" % (head, first[1] + values[0] if first else parts[0], values[1], values[2])

    def write(self):
        if not self.changed:
            return self.text
        if self.kind == "declaration":
            head, _, value = DECLARATION.match(self.text).groups()
            value = "(%s)" % value
            for number, changed in reversed(self.changed):
                value = choose_value(number, DECLARATION.match(changed)[3], value, "IsSwitchedOn")
            return head + value + ";"
        if self.kind == "constant":
            return self.write_constant()
        if self.kind == "branch":
            head, value = BRANCH.match(self.text).groups()
            value = "bool(%s)" % value
            for number, changed in reversed(self.changed):
                value = choose_value(number, "bool(%s)" % BRANCH.match(changed)[2], value)
            return "%s(%s)" % (head, value)
        if self.kind == "loop":
            return self.write_loop()
        if self.kind in ("list", "table"):
            return self.write_list()
        if self.kind == "member":
            head, name, value = MEMBER.match(self.text).groups()
            for number, changed in reversed(self.changed):
                value = choose_value(number, MEMBER.match(changed)[3], value, "IsSwitchedOn")
            return "%sinline const %s%s;" % (head, name, value)
        if self.kind == "one line":
            head, value, tail = ONE_LINE.match(self.text).groups()
            branches = "".join("if (::mutation::IsChosen(%d)) { %s } " % (number, ONE_LINE.match(changed)[2])
                               for number, changed in self.changed)
            return head + branches + value + tail
        branches = "".join("if (::mutation::IsChosen(%d)) { %s } else " % one for one in self.changed)
        return "{ %s{ %s } }" % (branches, self.text)


    def write_constant(self):
        """A constant of a header as a variable: what is computed of it while code is compiled is left out before."""
        name, equals, value = CONSTANT.match(self.text).groups()
        kind = "" if equals.strip() else name.rpartition(" ")[0]  # of what stands in braces without =
        value = kind + value
        for number, changed in reversed(self.changed):
            value = choose_value(number, kind + CONSTANT.match(changed)[3], value, "IsSwitchedOn")
        return "inline const %s = %s;" % (name, value)


class Schemata:
    """A source with those of its mutations that can stand beside each other; numbers begin with 1.

    With `constants` these are variables, and with `functions` those that were constexpr are so no more.
    """

    def __init__(self, text, several, constants, functions=False):
        self.lines = text.split("\n")
        hidden = hide(text)
        self.constants = constants and any(CONSTANT_BEGIN.match(line) for line in self.lines)
        self.functions = self.constants and functions
        self.statements = {}  # (begin, end) -> Statement
        self.numbers = {}  # key of a mutation -> number
        self.places = {}  # key -> (begin, end)
        for number, mutation in enumerate(several, 1):
            place = find_statement(hidden, mutation.number - 1)
            if not place or any(place[0] < other[1] and other[0] < place[1] for other in self.statements if other != place):
                continue
            original = "\n".join(self.read_line(hidden, i) for i in range(*place))
            statement = self.statements.setdefault(place, Statement(original))
            if statement.kind in ("constant", "member", "table") and not constants:
                continue
            changed = [self.read_line(hidden, i) for i in range(*place)]
            changed[mutation.number - 1 - place[0]] = self.read_changed(mutation)
            if statement.add(number, "\n".join(changed)):
                self.numbers[mutation.key] = number
                self.places[mutation.key] = place

    def read_line(self, hidden, i):
        """A line without the comment at its end."""
        return self.lines[i][:len(hidden[i].rstrip())] if hidden[i].strip() else ""

    @staticmethod
    def read_changed(mutation):
        code, _ = mutations.hide_text(mutation.new, False)
        return mutation.new[:len(code.rstrip())]

    def write(self):
        """The text, and the statement of each of its lines."""
        lines = ['#include "%s"' % HEADER]
        if self.constants:
            lines[0] += "\n#define static_assert(...)"
        owners = [None] * len(lines[0].split("\n"))
        i = 0
        begins = {place[0]: place for place, statement in self.statements.items() if statement.changed}
        while i < len(self.lines):
            place = begins.get(i)
            made = self.statements[place].write().split("\n") if place else [self.free(self.lines[i])]
            lines += made
            owners += [place] * len(made)
            i = place[1] if place else i + 1
        return "\n".join(lines), owners

    def free(self, line):
        """A constant without mutations, too, may be computed of one that has some."""
        if self.functions:
            line = FUNCTION_BEGIN.sub(r"\1inline ", line)
        return CONSTANT_BEGIN.sub(r"inline const \1", line) if self.constants else line

    @staticmethod
    def list_ways(text):
        """How to call it, the way with most mutations first: (constants, functions)."""
        has_tables = any(TABLE_BEGIN.match(line) for line in text.split("\n"))
        return [(True, True)] * has_tables + [(True, False), (False, False)]

    def drop(self, place):
        """Leaves a statement as it was."""
        self.statements[place].changed = []
        for key in [key for key, other in self.places.items() if other == place]:
            del self.numbers[key]
            del self.places[key]
