# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of Documentation/Reliability.md out of what commands left in BUILD/reliability.

    write_page.py SOURCE BUILD     writes it; rows of which no file tells stay as they are
    write_page.py SOURCE --check   tells which rows the page lacks, or has without a figure, command or commit
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import results

MARK = "<!-- figures -->\n"
HEAD = "| What | Figure | Command | Commit |\n|---|---|---|---|\n"
NOT_YET = "not measured yet"


def sum_up(figures, key):
    return sum(one[key] for one in figures.values())


def tell_latency(figures):
    return ", ".join("%s %.0f and %.0f of %.0f" % (name, one["median"], one["worst"], one["whole"])
                     for name, one in figures.items())


def tell_mutations(figures):
    return "%d killed, %d explained, %d survived of %d" % (
        figures["killed"], figures["explained"], figures["survived"], figures["killed"] + figures["explained"] + figures["survived"])


def tell_mutated_files(figures):
    """How many of the mutations of each folder were tried, and of which files all were if some were not; files without any do
    not count."""
    folders = {}
    for path, (tried, there_are) in sorted(figures.get("files", {}).items()):
        folder, name = path.rsplit("/", 1)
        folders.setdefault(folder, []).append((name, tried, there_are))
    told = []
    for folder, files in sorted(folders.items()):
        complete = [name for name, tried, there_are in files if tried == there_are]
        told.append("%s %d of %d%s" % (
            folder, sum(tried for _, tried, _ in files), sum(there_are for _, _, there_are in files),
            "" if len(complete) == len(files) else " (complete: %s)" % (", ".join(complete) or "none")))
    return "; ".join(told)


def tell_of_fuzz(key):
    return lambda figures: "{:,}".format(sum_up(figures, key))


def tell_of_fuzzers(tell):
    """One figure for each fuzzer."""
    return lambda figures: ", ".join("Fuzz%s %s" % (name, tell(one)) for name, one in sorted(figures.items()))


def tell_coverage(one):
    return "{:,} of {:,} ({:.0%})".format(one["covered"], one["places"], one["covered"] / max(1, one["places"]))


def tell_mended(figures):
    return ", ".join("%s %d" % (fault, sum(one["mended"][fault] for one in figures.values())) for fault in results.FAULTS)


def tell_since(one):
    return "{:,} in {:.1f} h".format(one["since"]["executions"], one["since"]["seconds"] / 3600)


def tell_nothing_lost(figures):
    """A lost array and a number that is not finite are faults: the fuzzer ends with a crash."""
    return "{:,}".format(sum_up(figures, "crashes"))


def tell_tests(figures):
    ends = [one["result"] for one in figures.values()]
    passed, skipped = ends.count("Passed"), ends.count("Skipped")
    return "{:,} passed, {:,} failed, {:,} skipped".format(passed, len(ends) - passed - skipped, skipped)


# What, which file of results has it, and how the figure is told.
ROWS = [
    ("Damaged and unlikely inputs, each with its row in the guide", "inputs", lambda f: "%d" % f["rows"]),
    ("Tests of such inputs, all passed", "inputs", lambda f: "%d" % f["tests"]),
    ("Executions fuzzed", "fuzz", tell_of_fuzzers(lambda one: "{:,}".format(one["executions"]))),
    ("Hours fuzzed", "fuzz", tell_of_fuzzers(lambda one: "%.1f" % (one["seconds"] / 3600))),
    ("Branches of the code that the fuzzers reached", "fuzz", tell_of_fuzzers(tell_coverage)),
    ("Faults that the fuzzers found, and that are mended", "fuzz", tell_mended),
    ("Executions fuzzed since the last of them", "fuzz", tell_of_fuzzers(tell_since)),
    ("Crashes", "fuzz", tell_of_fuzz("crashes")),
    ("Hangs (30 s and more)", "fuzz", tell_of_fuzz("hangs")),
    ("Reports of sanitizers", "fuzz", tell_of_fuzz("reports")),
    ("Arrays lost", "fuzz", tell_nothing_lost),
    ("Numbers made that are not finite, from finite input", "fuzz", tell_nothing_lost),
    ("Tests with checks of addresses, leaks and undefined behaviour", "asan", tell_tests),
    ("Reports of these checks", "asan", lambda f: "%d" % sum_up(f, "reports")),
    ("Tests with checks of threads", "tsan", tell_tests),
    ("Reports of the checks of threads", "tsan", lambda f: "%d" % sum_up(f, "reports")),
    ("Time from a click to the stop, median and worst of the whole run, in ms", "abort", tell_latency),
    ("Allocations that failed, one in each run, all survived", "memory", lambda f: "{:,}".format(f["tried"])),
    ("Mutations", "mutations", tell_mutations),
    ("Mutations tried, of those that the files have", "mutations", tell_mutated_files),
]


def read_rows(page):
    """The rows that the page has, by what they tell."""
    rows = {}
    for line in page.split("\n"):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) == 4:
            rows[cells[0]] = cells[1:]
    return rows


def find_faults(page):
    rows = read_rows(page)
    faults = ["there is no row: %s" % what for what, _, _ in ROWS if what not in rows]
    known = {what for what, _, _ in ROWS}
    faults += ["nothing writes the row: %s" % what for what in rows if what not in known | {"What", "---"}]
    for what, cells in rows.items():
        if what in known and cells[0] != NOT_YET and not (
                re.search(r"\d", cells[0]) and "./dev " in cells[1] and re.match(r"\w+ of \d{4}-\d\d-\d\d$", cells[2])):
            faults.append("figure, command and commit are not complete: %s" % what)
    return faults


def write(page, build):
    known = read_rows(page)
    lines = []
    for what, name, tell in ROWS:
        made = results.read(build, name)
        cells = known.get(what, [NOT_YET, "", ""])
        if made:
            cells = [tell(made["figures"]), "`%s`" % made["command"], made["commit"]]
        lines.append("| %s | %s |" % (what, " | ".join(cells)))
    begin, rest = page.split(MARK, 1)
    end = re.sub(r"\A(\|.*\n)*", "", rest)
    return begin + MARK + HEAD + "\n".join(lines) + "\n" + end


def main():
    path = pathlib.Path(sys.argv[1], "Documentation", "Reliability.md")
    page = path.read_text(encoding="utf-8")
    if sys.argv[2] != "--check":
        path.write_text(write(page, sys.argv[2]), encoding="utf-8")
        return 0
    faults = find_faults(page)
    print("\n".join(faults) or "%d rows" % len(ROWS))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
