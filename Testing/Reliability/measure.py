# SPDX-License-Identifier: BSD-3-Clause
"""Runs what counts inputs, failing allocations and times to stop, and leaves the figures for write_page.py.

    measure.py SOURCE BUILD BINARIES [inputs|memory|abort...]

BINARIES is the tree of plain VTK, BUILD the folder of all trees.
"""
import json
import os
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import results

INPUTS = "InputContract.*:HostileInput.*:WrongStamps*:InputKinds*"


def run_tests(binaries, source, program, filters):
    """Runs GoogleTests. Returns what they printed; ends the script where one fails."""
    environment = {**os.environ, "VTK_SMP_BACKEND_IN_USE": "STDThread", "SUBDIVISIONOBJECTS_DATA": str(source / "Data"),
                   "SUBDIVISIONOBJECTS_SHARED_DATA": str(source.parent / "shared" / "data")}
    made = subprocess.run([str(binaries / "bin" / program), "--gtest_filter=" + filters], env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace", check=False)
    if made.returncode != 0:
        sys.exit(made.stdout[-3000:])
    return made.stdout


def measure_inputs(source, build, binaries):
    text = run_tests(binaries, source, "SubdivisionObjectsTests", INPUTS)
    page = (source / "Documentation" / "Guide" / "InputContract.md").read_text(encoding="utf-8")
    figures = {"rows": sum(keys.count(",") + 1 for keys in re.findall(r"^\| (`[^|]*`) \|", page, re.M)), "tests": len(re.findall(r"\[       OK \]", text))}
    results.write(source, build, "inputs", "./dev reliability inputs", figures)


def measure_memory(source, build, binaries):
    text = run_tests(binaries, source, "SubdivisionObjectsFaultTests", "*Allocations*")
    counts = [int(count) for count in re.findall(r"^(\d+) allocations failed", text, re.M)]
    results.write(source, build, "memory", "./dev reliability memory", {"tried": sum(counts), "runs": len(counts)})


def measure_abort(source, build, binaries):
    package = next(binaries.glob("lib/python3*/**/subdivisionobjects/__init__.py")).parent.parent
    vtk = build / "vtk-dev" / "usr" / "lib" / "python3" / "dist-packages"
    output = binaries / "abort.json"
    subprocess.run(["/usr/bin/python3", str(source / "Testing" / "Reliability" / "abort_latency.py"), str(output)],
                   env={**os.environ, "PYTHONPATH": "%s:%s" % (package, vtk), "PYTHONDONTWRITEBYTECODE": "1",
                        "VTK_SMP_BACKEND_IN_USE": "STDThread"}, check=True)
    results.write(source, build, "abort", "./dev reliability abort", json.loads(output.read_text(encoding="utf-8")))


def main():
    source, build, binaries = (pathlib.Path(path).resolve() for path in sys.argv[1:4])
    steps = {"inputs": measure_inputs, "memory": measure_memory, "abort": measure_abort}
    for name in sys.argv[4:] or steps:
        print("measuring", name, flush=True)
        steps[name](source, build, binaries)


main()
