# SPDX-License-Identifier: BSD-3-Clause
"""What came of mutations: which survivors are explained, the list of survivors, and counts for the page of reliability."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "Reliability"))
import mutations
import results as reliability


def read_explained(folder):
    """The survivors of the files in a folder: {(path, old, new): reason}."""
    explained = {}
    for file in sorted(folder.glob("*.txt")):
        for block in re.split(r"\n\s*\n", file.read_text(encoding="utf-8")):
            lines = [line.strip() for line in block.strip().split("\n") if not line.startswith("#")]
            if len(lines) >= 4:
                explained[tuple(lines[:3])] = " ".join(lines[3:])
    return explained


def write_report(path, tried, explained):
    counts = {}
    lines = []
    for entry in tried:
        result = entry["result"]
        reason = explained.get((entry["path"], entry["old"], entry["new"]), "")
        result = "explained" if result == "survived" and reason else result
        counts[result] = counts.get(result, 0) + 1
        if result in ("survived", "explained"):
            lines.append("%s:%d %s\n    %s\n    %s\n    %s" % (
                entry["path"], entry["line"], result, entry["old"], entry["new"], reason))
    summary = "%d mutations: %d killed, %d survived, %d survived with a reason, %d are the same, %d do not compile" % (
        len(tried), counts.get("killed", 0), counts.get("survived", 0), counts.get("explained", 0), counts.get("same", 0),
        counts.get("does not compile", 0))
    path.write_text("\n".join([summary, ""] + lines) + "\n", encoding="utf-8")
    return summary, counts


def write_figures(source, build, entries, explained):
    """Leaves the counts of all that was tried, for Documentation/Reliability.md."""
    figures = {"killed": 0, "explained": 0, "survived": 0, "files": {}}
    for path in sorted({entry["path"] for entry in entries}):
        if (source / path).exists():
            there_are = len(mutations.list_mutations(path, (source / path).read_text(encoding="utf-8")))
            tried = sum(entry["path"] == path for entry in entries)
            figures["files"][path.replace("Filters/", "", 1)] = [tried, there_are]
    for entry in entries:
        has_reason = (entry["path"], entry["old"], entry["new"]) in explained
        result = "explained" if entry["result"] == "survived" and has_reason else entry["result"]
        if result in figures:
            figures[result] += 1
    reliability.write(source, build, "mutations", "./dev mutate PLACE", figures)
