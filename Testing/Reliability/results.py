# SPDX-License-Identifier: BSD-3-Clause
"""What commands leave of reliability in BUILD/reliability: a file for each kind of figures.

    results.py fuzz SOURCE BUILD NAME LOG SECONDS    adds a run of libFuzzer, whose output LOG has, to earlier ones
    results.py tests SOURCE BUILD TREE LOG           puts tests that CTest ran in the tree of a sanitizer, with its output in
                                                     LOG, in place of the same tests of earlier runs
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys


def get_commit(source):
    """Hash and date of the commit that is checked out. A copy without its history has none, nor a machine without git."""
    if not shutil.which("git"):
        return "no commit"
    return subprocess.run(["git", "-C", str(source), "log", "-1", "--format=%h of %cs"], stdout=subprocess.PIPE,
                          text=True, check=False).stdout.strip() or "no commit"


def read(build, name):
    path = pathlib.Path(build, "reliability", name + ".json")
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def write(source, build, name, command, figures):
    path = pathlib.Path(build, "reliability", name + ".json")
    path.parent.mkdir(parents=True, exist_ok=True)
    made = {"command": command, "commit": get_commit(source), "figures": figures}
    path.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")


def read_fuzz_log(text):
    """Executions, what they reached of the places where the code branches, and what they found."""
    count = re.findall(r"stat::number_of_executed_units: (\d+)", text) or re.findall(r"^#(\d+)\s", text, re.M) or ["0"]
    covered = re.findall(r"cov: (\d+)", text) or ["0"]
    places = re.findall(r"\((\d+) inline 8-bit counters\)", text) or ["0"]
    faults = re.findall(r"^SUMMARY: (\S+): (\S+)", text, re.M)
    hangs = sum(kind == "libFuzzer" and what == "timeout" for kind, what in faults)
    reports = sum(kind.endswith("Sanitizer") for kind, what in faults)
    return {"executions": int(count[-1]), "covered": int(covered[-1]), "places": int(places[0]), "hangs": hangs,
            "reports": reports, "crashes": len(faults) - hangs - reports}


FAULTS = ("crashes", "hangs", "reports")


def add_fuzz_run(source, build, name, log, seconds):
    """A fault is mended before its fuzzer runs again: those of earlier runs count as mended, and what ran since then counts
    once more. Of places the most counts that one run reached: a later one may end before it has tried all that earlier ones
    kept."""
    run = read_fuzz_log(pathlib.Path(log).read_text(encoding="utf-8", errors="replace"))
    run["seconds"] = int(seconds)
    figures = read(build, "fuzz").get("figures", {})
    before = figures.get(name, {})
    mended = before.get("mended", {})
    since = before.get("since", {})
    if any(before.get(fault, 0) for fault in FAULTS):
        mended = {fault: mended.get(fault, 0) + before[fault] for fault in FAULTS}
        since = {}
    figures[name] = {key: before.get(key, 0) + run[key] for key in ("executions", "seconds")}
    figures[name].update({key: run[key] for key in FAULTS})
    figures[name]["covered"] = max(before.get("covered", 0), run["covered"])
    figures[name]["places"] = run["places"]
    figures[name]["mended"] = {fault: mended.get(fault, 0) for fault in FAULTS}
    figures[name]["since"] = {key: since.get(key, 0) + run[key] for key in ("executions", "seconds")}
    write(source, build, "fuzz", "./dev fuzz SECONDS", figures)


def read_test_log(text):
    """What came of each test, in the word of CTest, and how many reports the sanitizers printed with it."""
    tests = {}
    name = None
    for line in text.split("\n"):
        end = re.match(r"\s*\d+/\d+ Test\s+#\d+: (\S.*?)(?:\s+# .*?)? \.{3,}\s*(?:\*\*\*)?([A-Z]\w*)", line)
        if end:
            name = end.group(1)
            tests[name] = {"result": end.group(2), "reports": 0}
        elif name and re.match(r"SUMMARY: \w+Sanitizer: ", line):
            tests[name]["reports"] += 1
    return tests


def add_test_run(source, build, tree, log):
    """A test counts as it ended last. A run of all tests begins without the file."""
    figures = read(build, tree).get("figures", {})
    figures.update(read_test_log(pathlib.Path(log).read_text(encoding="utf-8", errors="replace")))
    write(source, build, tree, "./dev test --" + tree, figures)


if __name__ == "__main__":
    {"fuzz": add_fuzz_run, "tests": add_test_run}[sys.argv[1]](*sys.argv[2:])
