# SPDX-License-Identifier: BSD-3-Clause
"""Changes lines of Core one at a time, and sees whether a test fails.

    mutate.py SOURCE BUILD [PLACE...] [--most N] [--again] [--rest SECONDS] [--jobs N]

PLACE is a folder or file under Filters (Core/Rules). SOURCE is not touched: a changed file is compiled beside
it, with the commands of BUILD, into a library and tests that take the place of those of BUILD. Of a header,
those sources are compiled again that include it (the nearest ones, if there are many), and the tests in the
folder of the same name. These tests run first, then the other tests for up to --rest SECONDS, until one fails.

A mutation is killed (a test fails, crashes or does not end), survives, does not compile, or is the same (the
objects have equal bytes). The choice is always the same; what was tried is kept in BUILD/mutations/results.json
until the file changes, so that a run goes on where another one was stopped. --again tries survivors anew.
Survivors that change nothing which could be tested stand in survivors.txt beside this file, with the reason. The
script fails where others survive.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import queue
import re
import resource
import shlex
import subprocess
import sys
import threading
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "Reliability"))
import mutations
import results as reliability

MOST_OBJECTS = 5  # of a header; they are compiled without optimisation, which takes a third of the time
AT_ONCE = 2
# Whose tests run next, after those of the own folder.
NEXT_TESTS = {"Core/Solids/Strata": ["Core/Rules", "Filters/Control"], "Core/Rules": ["Core/Surfaces/Loop", "Filters/Surface"]}
LIBRARY = "libvtkSubdivisionObjects.so"
HERE = pathlib.Path(__file__).parent


def read_explained(path):
    """The survivors of survivors.txt: {(path, old, new): reason}."""
    explained = {}
    for block in re.split(r"\n\s*\n", path.read_text(encoding="utf-8")):
        lines = [line.strip() for line in block.strip().split("\n") if not line.startswith("#")]
        if len(lines) >= 4:
            explained[tuple(lines[:3])] = " ".join(lines[3:])
    return explained


class Commands:
    """How BUILD compiles and links."""

    def __init__(self, build):
        self.build = build
        self.dependencies = None
        self.objects = {}  # of each source
        for entry in json.loads(self.ninja("-t", "compdb")):
            if entry["file"].endswith(".cxx") and entry["output"].endswith(".o"):
                self.objects[os.path.normpath(os.path.join(entry["directory"], entry["file"]))] = entry

    def ninja(self, *arguments):
        return subprocess.run(["ninja", *arguments], cwd=self.build, check=True, text=True, stdout=subprocess.PIPE).stdout

    def get_link(self, target):
        return self.ninja("-t", "commands", "-s", target).strip().split("\n")[-1]

    def find_includers(self, header):
        """The sources that include a header."""
        if self.dependencies is None:
            self.dependencies = {}
            output = None
            for line in self.ninja("-t", "deps").split("\n"):
                if ": #deps" in line:
                    output = line.split(": #deps")[0]
                elif line.startswith("    ") and output:
                    path = os.path.normpath(os.path.join(self.build, line.strip()))
                    self.dependencies.setdefault(path, set()).add(output)
        outputs = self.dependencies.get(str(header), set())
        return [source for source, entry in self.objects.items() if entry["output"] in outputs]


class Runner:
    """Tries mutations, one after the other, in a folder of its own."""

    def __init__(self, source, build, work, rest):
        self.source = source
        self.build = build
        self.rest = rest
        self.commands = Commands(build)
        self.work = work
        self.overlay = self.work / "sources"
        self.binaries = self.work / "binaries"
        self.tests = {"Core": "SubdivisionObjectsCoreTests", "Filters": "SubdivisionObjectsTests"}
        self.seconds = {}
        self.suites = {}
        self.binaries.mkdir(parents=True, exist_ok=True)

    # ---- building

    def compile(self, source, changed):
        """Compiles a source; `changed` is the file that was written. Returns the object, None if it cannot be."""
        entry = self.commands.objects[str(source)]
        target = self.binaries / (hashlib.sha1(str(source).encode()).hexdigest()[:12] + ".o")
        words = [word for word in shlex.split(entry["command"]) if word != "-MD"]
        for option in ("-MF", "-MT", "-MQ"):
            while option in words:
                place = words.index(option)
                del words[place:place + 2]
        words[words.index("-o") + 1] = str(target)
        if source == self.source / changed:
            words[words.index("-c") + 1] = str(self.overlay / changed)
        words.insert(1, "-I%s" % (self.overlay / "Filters"))
        # What a mutation leaves unused is no error.
        words += ["-Wno-error", "-w"] + ([] if changed.endswith(".cxx") else ["-O0"])
        made = subprocess.run(words, cwd=self.build, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return target if made.returncode == 0 else None

    def link(self, target, objects, output):
        command = self.commands.get_link(target)
        for original, own in objects.items():
            command = command.replace(" %s " % original, " %s " % own)
        words = shlex.split(command.replace(": && ", "").replace(" && :", ""))
        words[words.index("-o") + 1] = str(output)
        return subprocess.run(words, cwd=self.build, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def find_sources(self, path):
        """What to compile for a changed file, nearest first, and whether equal objects mean an equal library."""
        whole = self.source / path
        if path.endswith(".cxx"):
            return [str(whole)], True
        folder = os.path.dirname(path).replace("Filters/", "", 1)
        includers = self.commands.find_includers(whole)
        library = [one for one in includers if one.startswith(str(self.source / "Filters"))]
        library.sort(key=lambda one: (-len(os.path.commonpath([one, str(whole)])), one))
        tests = [one for one in includers
                 if one.startswith((str(self.source / "Testing" / folder), str(self.find_test_folder(folder))))]
        return library[:MOST_OBJECTS] + sorted(tests)[:MOST_OBJECTS], False

    def find_test_folder(self, folder):
        """The folder of Testing that has the tests of a folder of Filters."""
        place = self.source / "Testing" / folder
        if folder.startswith("Private/"):
            place = self.source / "Testing" / "Filters" / folder.split("/")[1]
        while not any(place.glob("Test*.cxx")) and place != self.source / "Testing":
            if any(place.rglob("Test*.cxx")):
                break
            place = place.parent
        return place

    def build_changed(self, path, sources, objects, is_whole):
        """Adds the objects of sources. Returns "" where tests can tell more, else "does not compile" or "same"."""
        is_same = is_whole
        for source in sources:
            made = self.compile(pathlib.Path(source), path)
            if made is None:
                return "does not compile"
            original = self.commands.objects[source]["output"]
            objects[original] = made
            is_same = is_same and made.read_bytes() == (self.build / original).read_bytes()
        if is_same:
            return "same"
        for name in self.tests.values():
            (self.binaries / name).unlink(missing_ok=True)
        library = (self.build / "lib" / LIBRARY).resolve()
        if not self.link("lib/" + library.name, objects, self.binaries / LIBRARY):
            return "does not compile"
        for name in self.tests.values():
            if any("/%s.dir/" % name in original for original in objects):
                if not self.link("bin/" + name, objects, self.binaries / name):
                    return "does not compile"
        return ""

    # ---- running

    def run(self, name, filters, seconds, own=True):
        """Runs tests until one fails. Returns "", the name of the test that failed, or "time"."""
        program = self.binaries / name if own and (self.binaries / name).exists() else self.build / "bin" / name
        environment = {**os.environ, "GTEST_FAIL_FAST": "1", "GTEST_FILTER": filters, "VTK_SMP_BACKEND_IN_USE": "STDThread",
                       "SUBDIVISIONOBJECTS_DATA": str(self.source / "Data"), "SUBDIVISIONOBJECTS_RANDOM_SECONDS": "2",
                       "SUBDIVISIONOBJECTS_SHARED_DATA": str(self.source.parent / "shared" / "data")}
        if own:
            environment["LD_PRELOAD"] = str(self.binaries / LIBRARY)
        log = self.work / "tests.log"
        with open(log, "w", encoding="utf-8") as file:
            try:
                code = subprocess.run([str(program)], env=environment, stdout=file, stderr=subprocess.STDOUT, timeout=seconds,
                                      cwd=self.work, preexec_fn=limit_memory).returncode
            except subprocess.TimeoutExpired:
                return "time"
        text = log.read_text(encoding="utf-8", errors="replace")
        if code == 0:
            return ""
        failed = re.findall(r"\[  FAILED  \] (\S+)", text) or re.findall(r"\[ RUN      \] (\S+)", text)[-1:]
        return failed[0] if failed else "crash"

    def find_suites(self, folder):
        """The program and the names of the tests in a folder, and how long they take."""
        if folder not in self.suites:
            names = set()
            for test in folder.rglob("Test*.cxx"):
                text = test.read_text(encoding="utf-8")
                names.update(re.findall(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+),", text, re.M))
            which = "Core" if "Core" in folder.parts else "Filters"
            filters = ":".join(sorted("%s.*:*/%s.*:%s/*" % (name, name, name) for name in names))
            begin = time.time()
            filters += "-*Files*"  # large ones
            failed = self.run(self.tests[which], filters, 3000, own=False)
            if failed:
                sys.exit("%s fails without a mutation" % failed)
            self.seconds[folder] = time.time() - begin
            self.suites[folder] = (self.tests[which], filters)
        return self.suites[folder], self.seconds[folder]

    def judge(self, mutation):
        """Returns what becomes of a mutation, and which test killed it."""
        path = self.overlay / mutation.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(mutation.apply((self.source / mutation.path).read_text(encoding="utf-8")), encoding="utf-8")
        try:
            sources, is_whole = self.find_sources(mutation.path)
            place = os.path.dirname(mutation.path).replace("Filters/", "", 1)
            (name, filters), seconds = self.find_suites(self.find_test_folder(place))
            objects = {}
            failed = ""
            while sources and not failed:  # most are killed before all sources are compiled
                result = self.build_changed(mutation.path, sources[:AT_ONCE], objects, is_whole)
                if result:
                    return result, ""
                failed = self.run(name, filters, 30. + 6. * seconds)
                sources = sources[AT_ONCE:]
            for further in [] if failed else NEXT_TESTS.get(place, []):
                (another, names), seconds = self.find_suites(self.source / "Testing" / further)
                failed = failed or self.run(another, names, 30. + 6. * seconds)
            begin = time.time()
            slow = "Partitions*:*Random*:Fuzz*"
            for other in self.tests.values():
                left = self.rest - (time.time() - begin)
                if not failed and left > 1.:
                    failed = self.run(other, "-" + slow + ":" + (filters.split("-")[0] if other == name else ""), left)
                    failed = "" if failed == "time" else failed  # there was no more time for it
            return ("killed", failed) if failed else ("survived", "")
        finally:
            path.unlink()


def limit_memory():
    size = 6 << 30
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def list_files(source, places):
    files = []
    for place in places:
        whole = source / "Filters" / place
        found = [whole] if whole.is_file() else sorted(whole.rglob("*.cxx")) + sorted(whole.rglob("*.h"))
        if not found:
            sys.exit("no sources in %s" % whole)
        files += [str(file.relative_to(source)) for file in found]
    return files


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
    figures = {"killed": 0, "explained": 0, "survived": 0}
    for entry in entries:
        has_reason = (entry["path"], entry["old"], entry["new"]) in explained
        result = "explained" if entry["result"] == "survived" and has_reason else entry["result"]
        if result in figures:
            figures[result] += 1
    reliability.write(source, build, "mutations", "./dev mutate PLACE", figures)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("places", nargs="*", default=["Core/Rules"])
    parser.add_argument("--most", type=int, default=100)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--rest", type=float, default=300.)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    source = arguments.source.resolve()
    work = arguments.build.resolve() / "mutations"
    runners = queue.Queue()
    for i in range(arguments.jobs):
        runners.put(Runner(source, arguments.build.resolve(), work / str(i), arguments.rest))
    explained = read_explained(HERE / "survivors.txt")
    all_of_them = []
    digests = {}
    for path in list_files(source, arguments.places or ["Core/Rules"]):
        text = (source / path).read_text(encoding="utf-8")
        digests[path] = hashlib.sha1(text.encode()).hexdigest()
        all_of_them += mutations.list_mutations(path, text)
    for path, old, new in explained:
        if path in digests and not any((one.path, one.old.strip(), one.new.strip()) == (path, old, new) for one in all_of_them):
            sys.exit("survivors.txt explains a mutation of %s that does not exist: %s" % (path, new))
    chosen = mutations.choose(all_of_them, arguments.most)
    print("%d of %d mutations" % (len(chosen), len(all_of_them)))
    file = work / "results.json"
    results = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    lock = threading.Lock()

    def try_one(mutation):
        entry = results.get(mutation.key)
        if entry and entry["file"] == digests[mutation.path] and not (arguments.again and entry["result"] == "survived"):
            return entry
        begin = time.time()
        runner = runners.get()
        result, test = runner.judge(mutation)
        runners.put(runner)
        entry = {"path": mutation.path, "line": mutation.number, "old": mutation.old.strip(), "new": mutation.new.strip(),
                 "result": result, "test": test, "seconds": round(time.time() - begin, 1), "file": digests[mutation.path]}
        with lock:
            results[mutation.key] = entry
            file.with_suffix(".new").write_text(json.dumps(results, indent=1), encoding="utf-8")
            file.with_suffix(".new").replace(file)
            print("%s:%d: %s%s\n    %s\n    %s" % (mutation.path, mutation.number, result, " by " + test if test else "",
                                                 entry["old"], entry["new"]), flush=True)
        return entry

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        tried = list(pool.map(try_one, chosen))
    summary, counts = write_report(work / "report.txt", tried, explained)
    print(summary)
    write_figures(source, arguments.build.resolve().parent, results.values(), explained)
    return 1 if counts.get("survived", 0) else 0


if __name__ == "__main__":
    sys.exit(main())
