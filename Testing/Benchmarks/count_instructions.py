# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of this project's library for each cell of the main cases, by callgrind.

    count_instructions.py PROGRAM COMPILER [--write]

Compares them with instructions.json beside this file: not more than 2 % more or less, so that what
becomes slower is seen on machines whose clocks tell nothing. If they changed on purpose, --write
writes the file. Counts are of one COMPILER, which the file names; with others, or without valgrind,
the script says "skipped" and why.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOLERANCE = 0.02
CASES = ["tetrahedra", "triangles", "polylines", "Loop", "Catmull-Clark", "4-8"]
FILE = pathlib.Path(__file__).with_name("instructions.json")


def count_own(path):
    """Instructions in the library itself: what others take depends on the processor and on versions."""
    names = {}
    is_own = False
    is_of_call = False
    count = 0
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            found = re.match(r"(c?)ob=\((\d+)\)(?: (.*))?$", line)
            if found:
                if found[3]:
                    names[found[2]] = found[3]
                if not found[1]:
                    is_own = "libvtkSubdivisionObjects" in names[found[2]]
            elif line.startswith("calls="):
                is_of_call = True  # the next line has what the function that is called takes
            elif re.match(r"[-+*\d]", line):
                if is_own and not is_of_call:
                    count += int(line.split()[1])
                is_of_call = False
    return count


def measure(program, case):
    """Instructions for each cell of the output."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "counts")
        answer = subprocess.run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=MeasuredWork", "--callgrind-out-file=%s" % out,
             program, case], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
            env={**os.environ, "VTK_SMP_BACKEND_IN_USE": "Sequential"}).stdout
        cells = int(answer.split()[0])
        return round(count_own(out) / cells, 1)


def main():
    program, compiler = sys.argv[1:3]
    if not shutil.which("valgrind"):
        print("skipped: there is no valgrind")
        return 0
    known = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    writes = "--write" in sys.argv
    if not writes and known.get("compiler") != compiler:
        print("skipped: the counts are of %s, this is %s" % (known.get("compiler"), compiler))
        return 0
    counts = {case: measure(program, case) for case in CASES}
    if writes:
        FILE.write_text(json.dumps({"compiler": compiler, "instructions for each cell": counts}, indent=2) + "\n",
                        encoding="utf-8")
        return 0
    failed = 0
    for case, count in counts.items():
        before = known["instructions for each cell"][case]
        is_same = abs(count - before) <= TOLERANCE * before
        print("%-14s %8.1f instructions for each cell, %8.1f in the file%s" % (
            case, count, before, "" if is_same else ": more than 2 % away"))
        failed += not is_same
    if failed:
        print("If this is on purpose: %s PROGRAM COMPILER --write" % __file__)
    return failed


sys.exit(main())
