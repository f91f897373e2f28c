#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs all benchmarks in one run and writes ratios.

    run.py BUILD_TREE [--quick] [--peers] [--warm] [--repetitions N] [--filter REGEX]

Writes into BUILD_TREE: results*.json (Google Benchmark's own), summary.json, report.md. Each figure
is a median over the repetitions, which all benchmarks take in random order; (min..max) beside it.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True
from bars import Measured, THREADS, bars_section

STANDARD = {"cube": "a", "sphere": "b", "polylines": "e"}
PEER_NOTES = {
    "vtkSubdivideTetra": "12 children per tet, half of them inverted, points not shared; shown, not counted",
    "OpenSubdiv stencil table build": "the table alone, nothing evaluated",
    "OpenSubdiv stencil table evaluate": "ready table, one component; compared with re-execution",
    "OpenSubdiv limit stencils make": "10 places in each face, with first derivatives",
    "OpenSubdiv limit stencils make with second derivatives": "the same with second derivatives",
    "OpenSubdiv limit stencils apply": "ready table of these; points",
    "dune-uggrid local": "no scalar; the same rounds and marks",
    "dune-uggrid": "no scalar; conforming red refinement; with --quick per cell, from 2 levels",
}
# Which peers have which schemes for surfaces, and what they do not carry.
SURFACE_PEERS = {"CGAL": "no scalar", "OpenMesh": "no scalar", "OpenSubdiv": "", "VTK": ""}
SURFACE_SCHEMES = ("Loop", "Butterfly", "Catmull-Clark", "Doo-Sabin", "sqrt3")
PER_CELL = ("vtkSubdivideTetra",)


class Sample:
    """The repetitions of one benchmark, in seconds."""

    def __init__(self):
        self.times = []
        self.cells = 0.0
        self.bytes = 0.0

    @property
    def median(self):
        return statistics.median(self.times)

    def ns_per_cell(self):
        return 1e9 * self.median / self.cells

    def text(self):
        return "%s (%s..%s)" % tuple(
            "%.3g" % (1e3 * t) for t in (self.median, min(self.times), max(self.times)))

    def as_json(self):
        return {"median_s": self.median, "min_s": min(self.times), "max_s": max(self.times),
                "repetitions": len(self.times), "cells": self.cells, "bytes": self.bytes}


def parse_name(name):
    """(family, what, case, levels, threads) of a name of the program."""
    parts = name.split("/")
    options = dict(part.split(":") for part in parts if ":" in part)
    family, what, case = [part for part in parts if ":" not in part and part != "manual_time"]
    return family, what, case, int(options["levels"]), int(options["threads"])


def read_samples(path):
    """Samples by (family, what, case, levels, threads)."""
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    with open(path, encoding="utf-8") as file:
        results = json.load(file)
    samples = {}
    for result in results["benchmarks"]:
        if result.get("run_type") != "iteration" or result.get("error_occurred"):
            continue
        sample = samples.setdefault(parse_name(result["run_name"]), Sample())
        sample.times.append(result["real_time"] * units[result["time_unit"]])
        sample.cells = result["cells"]
        sample.bytes = result["bytes"]
    return samples


def measure_memory(program, cases, repetitions):
    """Growth of the peak over the memory before, divided by the output; fresh processes."""
    ratios = {}
    for case, levels, caches in cases:
        for threads in THREADS:
            for cache in caches:
                values = []
                for _ in range(repetitions):
                    answer = json.loads(subprocess.check_output(
                        [program, "--peak-memory", case, str(levels), str(threads), str(cache)]))
                    values.append(answer["growth"] / answer["output"])
                ratios[case, levels, threads, cache] = statistics.median(values)
    return ratios


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return lines + [""]


def ratio(a, b):
    return "%.2f" % (a.median / b.median) if a and b else "-"


def filter_section(samples, memory):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family != "filter" or what not in ("first", "cached"):
            continue
        limit = samples.get(("limit", "small", case, levels, threads))
        huge = samples.get(("limit", "huge", case, levels, threads))
        if not limit:
            continue
        one = samples.get((family, what, case, levels, 1))
        one_limit = samples.get(("limit", "small", case, levels, 1))
        speed = one.median / sample.median
        limit_speed = one_limit.median / limit.median
        peak = memory.get((case, levels, threads, int(what == "cached")))
        rows.append([case + (" (%s)" % STANDARD[case] if case in STANDARD else " (c)"),
                     "off" if what == "first" else "on", str(threads), sample.text(), limit.text(),
                     ratio(sample, limit), ratio(sample, huge), "%.1f" % sample.ns_per_cell(),
                     "%.2f" % peak if peak else "-",
                     "%.2f of %.2f" % (speed, limit_speed) if threads > 1 else "-"])
    return ["## Whole filter, first execution", ""] + table(
        ["case", "cache", "threads", "ms", "limit, 4 KiB pages, ms", "time / limit",
         "time / limit with huge pages", "ns per output cell", "peak memory / output",
         "speed-up, filter of limit"], rows)


def surface_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family == "surface":
            small = samples.get(("surfacelimit", what + "-small", case, levels, threads))
            huge = samples.get(("surfacelimit", what + "-huge", case, levels, threads))
            rows.append(["%s (%s, %d levels)" % (what, case, levels), str(threads), sample.text(),
                         small.text() if small else "-", ratio(sample, small), ratio(sample, huge),
                         "%.1f" % sample.ns_per_cell()])
    return ["## Surface subdivision, first execution", ""] + table(
        ["scheme", "threads", "ms", "limit, 4 KiB pages, ms", "time / limit",
         "time / limit with huge pages", "ns per output cell"], rows)


def surface_peer_section(samples):
    """One row for each scheme and mesh: the whole filter beside each library that has the scheme."""
    cases = sorted({(what.split(" ", 1)[1], case, levels) for family, what, case, levels, _ in samples
                    if family == "peer" and what.split(" ", 1)[-1] in SURFACE_SCHEMES})
    rows = []
    for scheme, case, levels in cases:
        own = [samples.get(("surface", scheme, case, levels, threads)) for threads in (1, 4)]
        row = ["%s (%s, %d levels)" % (scheme, case, levels)] + [o.text() if o else "-" for o in own]
        least = []
        for name in SURFACE_PEERS:
            peer = samples.get(("peer", "%s %s" % (name, scheme), case, levels, 1))
            row.append("%.3g: %s and %s" % (1e3 * peer.median, ratio(peer, own[0]), ratio(peer, own[1]))
                       if peer else "-")
            if peer and own[1]:
                least.append(peer.median / own[1].median)
        rows.append(row + ["%.1f" % min(least) if least else "-"])
    return ["## Surface subdivision beside other libraries", "",
            "All of them on one thread: ms, and how much faster we are at 1 and at 4 threads. CGAL and "
            "OpenMesh carry no scalar.", ""] + table(
        ["scheme", "we, 1 thread, ms", "we, 4 threads, ms"] + list(SURFACE_PEERS) +
        ["at least, 4 threads"], rows) if rows else []


def again_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family == "filter" and what == "again":
            osd = samples.get(
                ("peer", "OpenSubdiv stencil table evaluate", case, levels, threads))
            first = samples.get(("filter", "cached", case, levels, threads)) or samples.get(
                ("filter", "first", case, levels, threads))
            rows.append([case + (" (d)" if case == "cube" else ""), str(threads), sample.text(), ratio(sample, osd),
                         ratio(first, sample)])
    return ["## Second execution, only the scalar changed", ""] + table(
        ["case", "threads", "ms", "time / OpenSubdiv's ready stencil table", "faster than a first execution"], rows)


def red_green_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family != "redgreen":
            continue
        small = samples.get(("redgreen-limit", what + "-small", case, levels, threads))
        huge = samples.get(("redgreen-limit", what + "-huge", case, levels, threads))
        rows.append([case, what, str(threads), "%.3g" % sample.cells, sample.text(),
                     small.text() if small else "-", ratio(sample, small), ratio(sample, huge)])
    return ["## Red-green refinement", "",
            "corner: 12^3 x 6 tetrahedra, 4 rounds, marked within 0.21 of the corner; percent: 1 % "
            "of 5 million tetrahedra in one place, scattered: anywhere.", ""] + table(
        ["case", "what", "threads", "cells", "ms", "writing the output, 4 KiB pages, ms",
         "time / writing", "time / writing with huge pages"], rows) if rows else []


def measure_shape_memory(program, samples):
    """Growth of the peak of adaptive refinement, in bytes per output cell; fresh processes."""
    growth = {}
    for case in sorted({key[2] for key in samples if key[:2] == ("shape", "adaptive")}):
        answer = json.loads(subprocess.check_output([program, "--peak-memory", case, "0", "1", "0"]))
        growth[case] = answer["growth"] / answer["cells"]
    return growth


def shape_section(samples, memory):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        uniform = samples.get(("shape", "uniform", case, levels, threads))
        if family != "shape" or what != "adaptive":
            continue
        rows.append([case, str(threads), "%.3g" % sample.cells, sample.text(),
                     "%.3g" % uniform.cells if uniform else "-", uniform.text() if uniform else "-",
                     ratio(sample, uniform), "%.2f" % (1e-3 * sample.ns_per_cell()), "%.0f" % memory[case]])
    return ["## Red-green refinement on the limit, by its shape", ""] + table(
        ["case", "threads", "cells", "ms", "uniform cells", "ms", "time / uniform", "us per cell",
         "bytes of peak per cell, 1 thread"], rows) if rows else []


def deformation_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family == "deformation":
            small, huge = (samples.get(("limit", "deformation-" + pages, case, levels, threads))
                           if what == "again" else None for pages in ("small", "huge"))
            rows.append([what, str(threads), sample.text(), small.text() if small else "-",
                         ratio(sample, small), ratio(sample, huge), "%.1f" % sample.ns_per_cell()])
    return ["## Deformation of one million points", ""] + table(
        ["execution", "threads", "ms", "reading rows and operators, writing points, 4 KiB pages, ms",
         "time / that", "time / that with huge pages", "ns per point"], rows) if rows else []


def interpolation_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family == "interpolation":
            plain = samples.get(("projection", what, case, levels, threads))
            rows.append([what, str(threads), sample.text(), plain.text() if plain else "-", ratio(sample, plain)])
    return ["## Interpolation of 103,823 points and a scalar, no level", ""] + table(
        ["execution", "threads", "ms", "without interpolation, ms", "time / that"], rows) if rows else []


def adaptive_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if family == "adaptive":
            limit = samples.get(("adaptivelimit", what, case, levels, threads))
            rows.append([case, what, str(threads), "%.3g" % sample.cells, sample.text(),
                         limit.text() if limit else "-", ratio(sample, limit), "%.1f" % sample.ns_per_cell()])
    return ["## Local refinement of surfaces to a geometric error of 3e-4", ""] + table(
        ["surface", "scheme", "threads", "cells", "ms", "writing the output, huge pages, ms", "time / that",
         "ns per output cell"], rows) if rows else []


def worst_section(samples):
    """Twice the size may take at most 2.5 times as long."""
    rows = []
    cases = sorted({(what, threads) for (family, what, _, _, threads) in samples if family == "worst"})
    for what, threads in cases:
        small, large = sorted(((int(case), sample) for (family, name, case, _, count), sample in samples.items()
                               if (family, name, count) == ("worst", what, threads)), key=lambda pair: pair[0])[:2]
        value = large[1].median / small[1].median
        rows.append([what, str(small[0]), "%.3g ms" % (1e3 * small[1].median), str(large[0]),
                     "%.3g ms" % (1e3 * large[1].median), "%.2f" % value, "pass" if value <= 2.5 else "fail"])
    return ["## Everything at one vertex or in one cell", ""] + table(
        ["case", "size", "time", "size", "time", "ratio", "at most 2.5"], rows) if rows else []


def tetoct_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if (family, what) == ("filter", "tetoct"):
            box = samples.get((family, "first", case, levels, threads))
            rows.append([case + " (a)", str(threads), sample.text(), box.text() if box else "-",
                         ratio(sample, box)])
    return ["## Tet/oct scheme beside the box spline, first execution", ""] + table(
        ["case", "threads", "tet/oct, ms", "box spline, ms", "time / box spline"], rows)


def peer_section(samples):
    rows = []
    for (family, what, case, levels, threads), peer in sorted(samples.items()):
        if family != "peer":
            continue
        mine = "again" if what.endswith("evaluate") else "first"
        cells = []
        for own_threads in (1, 4):
            scheme = what.split(" ", 1)[-1]
            if scheme in SURFACE_SCHEMES[1:]:  # Loop is beside the main filter here
                same = own = samples.get(("surface", scheme, case, levels, own_threads))
            else:
                same = samples.get(("filter", mine, case, levels, own_threads)) or samples.get(
                    ("redgreen", "filter", case, levels, own_threads))
                own = same or samples.get(("filter", mine, case, 3, own_threads))
            if not own:
                cells.append("-")
            elif what in PER_CELL or not same:
                cells.append("%.1f" % (peer.ns_per_cell() / own.ns_per_cell()))
            else:
                cells.append("%.1f" % (peer.median / own.median))
        rows.append([what, "%s, %d levels" % (case, levels), str(threads), peer.text(), "%.1f" % peer.ns_per_cell()] + cells +
                    [PEER_NOTES.get(what, SURFACE_PEERS.get(what.split()[0], ""))])
    return ["## Peers", ""] + table(
        ["peer", "case", "its threads", "ms", "ns per output cell", "we are faster, 1 thread",
         "we are faster, 4 threads", "note"], rows) if rows else []


def scaling_section(samples):
    rows = []
    for (family, what, case, levels, threads), sample in sorted(samples.items()):
        if (family, what, threads) == ("filter", "first", 4) and case in STANDARD:
            base = samples.get((family, what, case, 3, threads))
            rows.append([case, str(levels), "%.3g" % sample.cells, sample.text(),
                         "%.2f" % sample.ns_per_cell(),
                         "%+.0f %%" % (100 * (sample.ns_per_cell() / base.ns_per_cell() - 1))])
    return ["## From level 3 to the largest that fits (4 threads)", ""] + table(
        ["case", "levels", "cells", "ms", "ns per output cell", "against level 3"], rows)


def list_names(command, pattern):
    """The names that a regular expression leaves."""
    names = subprocess.run(command + ["--benchmark_list_tests=true", "--benchmark_filter=" + pattern],
                           check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return {parse_name(name) for name in names if name.count("/") > 3}


def run(arguments):
    program = os.path.join(arguments.build, "bin", "SubdivisionObjectsBenchmarks")
    load = os.getloadavg()[0]
    samples = {}
    known, registered, chosen = set(), set(), set()
    for group in ([], ["--peers"]): # processes of their own: heaps stay apart
        results = os.path.join(arguments.build, "results%s.json" % ("-peers" if group else ""))
        command = [program] + (["--quick"] if arguments.quick else []) + group + (
            ["--warm"] if arguments.warm else [])
        known |= list_names([program] + group, ".")
        registered |= list_names(command, ".")
        chosen |= list_names(command, arguments.filter)
        subprocess.run(command + [
            "--benchmark_repetitions=%d" % arguments.repetitions,
            "--benchmark_enable_random_interleaving=true",
            "--benchmark_filter=" + arguments.filter,
            "--benchmark_out_format=json", "--benchmark_out=" + results],
            check=True, stdout=subprocess.DEVNULL)
        if os.path.getsize(results) > 0:
            samples.update(read_samples(results))
    cases = sorted({(key[2], key[3], (0, 1)) for key in samples
                    if key[:2] == ("filter", "first") and ("limit", "small") + key[2:] in samples})
    cases += sorted({(key[1], key[3], (0,)) for key in samples if key[0] == "surface"})
    memory = measure_memory(program, cases, 1 if arguments.quick else 3)
    shape_memory = measure_shape_memory(program, samples)
    loads = (load, os.getloadavg()[0])

    lines = ["# Benchmarks", "",
             "Medians of %d repetitions in random order, (min..max); load average before %.1f, "
             "after %.1f; %d processors." % (
                 arguments.repetitions, *loads, os.cpu_count()), ""]
    measured = Measured(samples, memory, shape_memory, known, registered, chosen)
    lines += bars_section(measured, loads, table) + worst_section(samples)
    lines += filter_section(samples, memory) + surface_section(samples) + again_section(samples)
    lines += surface_peer_section(samples) + tetoct_section(samples)
    lines += red_green_section(samples)
    lines += shape_section(samples, shape_memory)
    lines += adaptive_section(samples) + deformation_section(samples) + interpolation_section(samples)
    lines += peer_section(samples)
    if not arguments.quick:
        lines += scaling_section(samples)
    with open(os.path.join(arguments.build, "report.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
    with open(os.path.join(arguments.build, "summary.json"), "w", encoding="utf-8") as file:
        json.dump({
            "benchmarks": {"%s/%s/%s/levels:%d/threads:%d" % key: sample.as_json()
                           for key, sample in sorted(samples.items())},
            "peak_memory_over_output": {"%s/levels:%d/threads:%d/cache:%d" % key: value
                                        for key, value in sorted(memory.items())}},
            file, indent=1)
    print("\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", help="build tree of the preset 'bench'")
    parser.add_argument("--quick", action="store_true", help="fewer repetitions, no large levels")
    parser.add_argument("--peers", action="store_true",
                        help="for ./dev bench, which installs the peers; here nothing changes")
    parser.add_argument("--warm", action="store_true", help="memory that repetitions freed is used again")
    parser.add_argument("--repetitions", type=int, default=0)
    parser.add_argument("--filter", default=".", help="regular expression on the benchmarks' names")
    arguments = parser.parse_args()
    if not arguments.repetitions:
        arguments.repetitions = 3 if arguments.quick else 9
    run(arguments)


if __name__ == "__main__":
    sys.exit(main())
