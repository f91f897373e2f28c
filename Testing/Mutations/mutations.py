# SPDX-License-Identifier: BSD-3-Clause
"""The mutations of a C++ source: each changes one operator, constant or statement in one line.

A line is read as the formatter writes it: operators of two operands have a space on both sides, those of
types and templates have not. Comments, strings, directives and assertions are left alone.
"""
import hashlib
import re

SWAPPED = {
    "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["*"], "<": ["<=", ">="], ">": [">=", "<="],
    "<=": ["<", ">"], ">=": [">", "<"], "==": ["!="], "!=": ["=="], "&&": ["||"], "||": ["&&"],
    "+=": ["-="], "-=": ["+="], "*=": ["/="], "|=": ["&="], "&": ["|"], "|": ["&"], "<<": [">>"], ">>": ["<<"],
}
OPERATOR = re.compile(r"(?<=[\w)\].'] )(%s)(?= \S)" % "|".join(
    re.escape(operator) for operator in sorted(SWAPPED, key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.'])(\d+\.\d*|\d+)(?![\w.'])")
WORD = re.compile(r"(?<!\w)(true|false)(?!\w)")
NOT = re.compile(r"(?<![\w)\]])!(?=[\w(])")
CONDITION = re.compile(r"^(\s*(?:else )?if )\((.*)\)$")
STATEMENT = re.compile(r"^\s*(this->|[a-z]\w*(\.|->|\[|\(|\+\+| [-+*|&]?= )|\+\+|--).*;$")
LEFT_ALONE = re.compile(r"^\s*(#|assert|static_assert|template|using|namespace|friend|case .*:$|[A-Z]\w* = \d+,?\s*$|default:|//|return \{\};$)")
MESSAGE = re.compile(r"std::(cout|cerr|ostringstream)|\bmessage <<|what\(\)|throw ")


class Mutation:
    """One changed line. The key stays the same when lines are added elsewhere in the file."""

    def __init__(self, path, number, old, new, occurrence):
        self.path = path
        self.number = number  # of the line, from 1
        self.old = old
        self.new = new
        text = "\n".join([path, str(occurrence), old.strip(), new.strip()])
        self.key = hashlib.sha1(text.encode()).hexdigest()[:16]

    def apply(self, text):
        lines = text.split("\n")
        assert lines[self.number - 1] == self.old
        lines[self.number - 1] = self.new
        return "\n".join(lines)


def blank(match):
    return " " * len(match.group())


def hide_text(line, is_comment):
    """The line with blanks in place of comments and strings, and whether a comment goes on behind it."""
    if is_comment:
        end = line.find("*/")
        if end < 0:
            return " " * len(line), True
        line = " " * (end + 2) + line[end + 2:]
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', blank, line)
    line = re.sub(r"/\*.*?\*/", blank, line)
    line = re.sub(r"//.*", blank, line)
    begin = line.find("/*")
    if begin >= 0:
        return line[:begin] + " " * (len(line) - begin), True
    return line, False


def change_number(number):
    if "." in number:
        return [str(float(number) + 1.)]
    value = int(number)
    return [str(value + 1)] + ([str(value - 1)] if value > 0 else [])


def change_line(line, code):
    """All changed lines of one; `code` is the line without comments and strings."""
    def put(begin, end, text):
        return line[:begin] + text + line[end:]

    for found in OPERATOR.finditer(code):
        for other in SWAPPED[found[1]]:
            yield put(found.start(1), found.end(1), other)
    for found in NUMBER.finditer(code):
        for other in change_number(found[1]):
            yield put(found.start(1), found.end(1), other)
    for found in WORD.finditer(code):
        yield put(found.start(1), found.end(1), "false" if found[1] == "true" else "true")
    for found in NOT.finditer(code):
        yield put(found.start(), found.end(), "")
    found = CONDITION.match(code)
    is_single = found and len(OPERATOR.findall(found[2])) == 1  # the operator is changed already
    if found and not is_single and found[2].count("(") == found[2].count(")"):
        yield put(found.end(1), len(code.rstrip()), "(!(%s))" % line[found.start(2):found.end(2)])
    if STATEMENT.match(code) and code.count("(") == code.count(")"):
        yield line[:len(line) - len(line.lstrip())] + ";"


def list_mutations(path, text):
    """All mutations of a source, in the order of its lines."""
    mutations = []
    seen = {}
    is_comment = False
    for number, line in enumerate(text.split("\n"), 1):
        code, is_comment = hide_text(line, is_comment)
        occurrence = seen.get(line.strip(), 0)
        seen[line.strip()] = occurrence + 1
        if LEFT_ALONE.match(code) or MESSAGE.search(code):
            continue
        changed = []
        for new in change_line(line, code):
            if new not in changed and new != line:
                changed.append(new)
                mutations.append(Mutation(path, number, line, new, occurrence))
    return mutations


def choose(mutations, most):
    """Always the same ones, spread over all of them."""
    return sorted(sorted(mutations, key=lambda mutation: mutation.key)[:most],
                  key=lambda mutation: (mutation.path, mutation.number, mutation.new))
