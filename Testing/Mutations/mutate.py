# SPDX-License-Identifier: BSD-3-Clause
"""Changes lines of Core one at a time, and sees whether a test fails.

    mutate.py SOURCE BUILD [PLACE...] [--most N] [--again] [--fast] [--together] [--rest SECONDS] [--jobs N]

PLACE is a folder or file under Filters (Core/Rules). SOURCE is not touched: a changed file is compiled beside
it, with the commands of BUILD, into a library and tests that take the place of those of BUILD. Of a header,
those sources are compiled again that include it (the nearest ones, if there are many), and the tests in the
folder of the same name. These tests run first, then the other tests for up to --rest SECONDS, until one fails.

A mutation is killed (a test fails, crashes or does not end), survives, does not compile, or is the same (the
objects have equal bytes). The choice is always the same; what was tried is kept in BUILD/mutations/results.json
until the file changes, so that a run goes on where another one was stopped. --again tries survivors anew;
with --fast only the fast tests of the own folder run, so that a slower run has fewer mutations left; --together
leaves to another run what has to be compiled alone, which costs most of the time.
Survivors that change nothing which could be tested stand in the folder survivors, with the reason. The
script fails where others survive.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import queue
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time

sys.dont_write_bytecode = True
import mutations
import report
import schemata

MOST_OBJECTS = 5  # of a header; they are compiled without optimisation, which takes a third of the time
AT_ONCE = 2
FAST_SHARES = (0.02, 0.15)  # of the time of all tests of a folder: those that take so much together run first
LEFT_OUT = "*Files*:*LongLong*:*AnyNumberOfThreads*"  # takes long, and sees what others see
MOST_KILLERS = 4  # tests that found most mutations of a file: they run before all others
# Whose tests run next, after those of the own folder: folders and files, for all of a folder or for one file.
NEXT_TESTS = {
    "Core/Rules": ["Core/Surfaces", "Core/Solids/Strata", "Core/Solids/TetOct"],
    "Core/Solids/RedGreen": ["Filters/RedGreen/TestRedGreen.cxx", "Filters/RedGreen/TestRedGreenRefinementChaining.cxx"],
    "Core/Solids/Strata": ["Core/Rules", "Filters/Control/TestFeaturesJoints.cxx", "Filters/Control"],
    "Core/Surfaces/Butterfly": ["Filters/Surface/TestSurfaceButterflyMeshes.cxx", "Filters/Surface/TestSurfaceLimits.cxx"],
    "Core/Surfaces/Dual": ["Filters/Surface/TestSurfaceDualSchemes.cxx", "Filters/Surface/TestSurfaceDooSabin.cxx",
                           "Filters/Surface/TestSurfaceMidedge.cxx", "Filters/Surface/TestSurfaceDualLimits.cxx"],
    "Core/Surfaces/FourEight": ["Filters/Surface/TestSurfaceReplacedEdges.cxx", "Filters/Surface/TestSurfaceFourEight.cxx",
                                "Filters/Surface/TestSurfaceFourEightLimits.cxx", "Filters/Surface/TestSurfaceLimits.cxx"],
    "Core/Surfaces/SqrtThree": ["Filters/AdaptiveSurface/TestAdaptiveSqrtThree.cxx",
                                "Filters/Surface/TestSurfaceReplacedEdges.cxx", "Filters/Surface/TestSurfaceSqrtThree.cxx",
                                "Filters/Surface/TestSurfaceLimits.cxx"],
    "Core/Surfaces/SqrtThree/AdaptiveSqrtThree.cxx": ["Filters/AdaptiveSurface/TestAdaptiveSqrtThree.cxx"],
}
for scheme in ("CatmullClark", "Loop", "Scheme"):
    NEXT_TESTS["Core/Surfaces/" + scheme] = ["Filters/Surface/TestSurfaceMasks.cxx", "Filters/Surface/TestSurfaceLimits.cxx",
                                             "Filters/Surface/TestSurfaceSubdivision.cxx"]
TESTS = {"Core": "SubdivisionObjectsCoreTests", "Filters": "SubdivisionObjectsTests"}
LIBRARY = "libvtkSubdivisionObjects.so"
HERE = pathlib.Path(__file__).parent


class Commands:
    """How BUILD compiles and links."""

    def __init__(self, build):
        self.build = build
        self.dependencies = None
        self.objects = {}  # of each source
        cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
        self.compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M).group(1)
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


class Known:
    """What all runners know: how long tests take, and which tests kill mutations of a file."""

    def __init__(self, is_fast):
        self.is_fast = is_fast
        self.lock = threading.Lock()
        self.measuring = threading.Lock()
        self.suites = {}  # of a folder: program, filter of all tests, [(filter, seconds)] of its parts
        self.seconds = {}  # of a test
        self.killers = collections.defaultdict(collections.Counter)  # of a file: (program, test)

    def add_killer(self, path, program, test):
        with self.lock:
            if test in self.seconds:
                self.killers[path][program, test] += 1

    def find_killers(self, path):
        """[(program, filter, seconds)] of those tests that found most, as far as they are fast."""
        chosen = {}
        with self.lock:
            for (program, test), _ in self.killers[path].most_common(MOST_KILLERS):
                chosen.setdefault(program, []).append(test)
            return sorted(((program, ":".join(tests), sum(self.seconds[test] for test in tests))
                           for program, tests in chosen.items()), key=lambda one: one[2])


class Runner:
    """Tries mutations, one after the other, in a folder of its own."""

    def __init__(self, source, build, work, rest, known):
        self.source = source
        self.build = build
        self.rest = rest
        self.known = known
        self.commands = Commands(build)
        self.work = work
        self.use_folder(work / "alone")
        self.together = work.parent / "together"  # a file with many of its mutations in it, for all runners
        self.numbers = {}  # of these, by key

    def use_folder(self, folder):
        self.overlay = folder / "sources"
        self.binaries = folder / "binaries"
        self.binaries.mkdir(parents=True, exist_ok=True)

    # ---- building

    def compile(self, source, changed, options=()):
        """Compiles a source; `changed` is the file that was written. Returns the object, None if it cannot be, and errors."""
        entry = self.commands.objects[str(source)]
        target = self.binaries / (hashlib.sha1(str(source).encode()).hexdigest()[:12] + ".o")
        words = [word for word in shlex.split(entry["command"]) if word != "-MD"]
        del words[:words.index(self.commands.compiler)]  # a launcher, such as a cache of the compiler
        for option in ("-MF", "-MT", "-MQ"):
            while option in words:
                place = words.index(option)
                del words[place:place + 2]
        words[words.index("-o") + 1] = str(target)
        if source == self.source / changed:
            words[words.index("-c") + 1] = str(self.overlay / changed)
        words.insert(1, "-I%s" % (self.overlay / "Filters"))
        # What a mutation leaves unused is no error.
        words += ["-Wno-error", "-w"] + list(options)
        made = subprocess.run(words, cwd=self.build, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        return target if made.returncode == 0 else None, made.stderr

    def link(self, target, objects, output):
        words = shlex.split(self.commands.get_link(target).replace(": && ", ""))
        words = words[:words.index("&&")]  # CMake lists tests then
        own = [str(objects[word]) for word in words if word in objects]
        words = [word for word in words if word not in objects]
        missing = [word for word in words if word.endswith(".o") and not (self.build / word).exists()]
        if missing:  # of a test that is new; nothing could be linked
            sys.exit("%s is not there: build first" % missing[0])
        first = next(i for i, word in enumerate(words) if word.endswith(".o"))
        words[first:first] = own  # of functions that several objects have, the linker takes the first
        if target.startswith("lib/"):
            words.insert(1, "-Wl,-Bsymbolic-functions")  # not the functions of the same name in the tests
        words[words.index("-o") + 1] = str(output)
        return subprocess.run(words, cwd=self.build, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def find_sources(self, path):
        """What to compile for a changed file, nearest first."""
        whole = self.source / path
        if path.endswith(".cxx"):
            return [str(whole)]
        folder = os.path.dirname(path).replace("Filters/", "", 1)
        includers = self.commands.find_includers(whole)
        library = [one for one in includers if one.startswith(str(self.source / "Filters"))]
        names = set(re.findall(r"\b([A-Z]\w+)\(", whole.read_text(encoding="utf-8")))
        distances = {one: self.find_distance(one, whole, names) for one in library}
        if any(distance < 2 for distance in distances.values()):
            library = [one for one in library if distances[one] < 2]
        library.sort(key=lambda one: (distances[one], -len(os.path.commonpath([one, str(whole)])), one))
        tests = [one for one in includers
                 if one.startswith((str(self.source / "Testing" / folder), str(self.find_test_folder(folder))))]
        return library[:MOST_OBJECTS] + sorted(tests)[:MOST_OBJECTS]

    def find_near(self, path):
        """The tests in the folder with the same name that include a header themselves: they see most mutations of it."""
        if path.endswith(".cxx"):
            return []
        line = '#include "%s"' % path.replace("Filters/", "", 1)
        folder = self.source / os.path.dirname(path).replace("Filters/", "Testing/", 1)
        return [str(test) for test in sorted(folder.glob("Test*.cxx")) if line in test.read_text(encoding="utf-8")]

    def find_distance(self, source, header, names):
        """0 if a source calls functions of a header, 1 if a header does that it includes itself, else 2."""
        text = pathlib.Path(source).read_text(encoding="utf-8")
        texts = [text]
        for included in re.findall(r'#include "([^"]+)"', text):
            path = self.source / "Filters" / included
            if path != header and path.exists():
                texts.append(path.read_text(encoding="utf-8"))
        for distance, one in enumerate(["\n".join(texts[:1]), "\n".join(texts)]):
            if names.intersection(re.findall(r"\b([A-Z]\w+)\(", one)):
                return distance
        return 2

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

    def build_changed(self, path, sources, objects):
        """Adds the objects of sources, compiled fast. Returns whether there is a library."""
        for source in sources:
            made, _ = self.compile(pathlib.Path(source), path, ["-O0", "-Wfatal-errors"])
            if made is None:
                return False
            objects[self.commands.objects[source]["output"]] = made
        return self.link_all(objects)

    def is_same(self, path):
        """Whether a changed source has the same object as before."""
        made, _ = self.compile(self.source / path, path)
        original = self.commands.objects[str(self.source / path)]["output"]
        return bool(made) and made.read_bytes() == (self.build / original).read_bytes()

    def link_all(self, objects):
        """Makes the library and the tests, those of which objects have changed."""
        for name in [LIBRARY, *TESTS.values()]:
            (self.binaries / name).unlink(missing_ok=True)
        library = "lib/" + (self.build / "lib" / LIBRARY).resolve().name
        has_own = any("/Filters.dir/" in original for original in objects)
        if has_own and not self.link(library, objects, self.binaries / LIBRARY):
            return False
        return all(self.link("bin/" + name, objects, self.binaries / name) for name in TESTS.values()
                   if any("/%s.dir/" % name in original for original in objects))

    def prepare(self, path, several, sources, jobs):
        """Builds sources with many mutations of a file in it, for all runners. Returns their numbers, by key."""
        self.use_folder(self.together)
        text = (self.source / path).read_text(encoding="utf-8")
        overlay = self.overlay / path
        overlay.parent.mkdir(parents=True, exist_ok=True)
        (self.overlay / "Filters" / schemata.HEADER).write_text(schemata.HEADER_TEXT, encoding="utf-8")
        try:
            for way in schemata.Schemata.list_ways(text):
                made = schemata.Schemata(text, several, *way)
                for _ in range(8):
                    if not made.numbers or not sources:
                        break
                    changed, owners = made.write()
                    overlay.write_text(changed, encoding="utf-8")
                    objects, errors = self.compile_all(sources, path, jobs)
                    if not errors:
                        place = self.find_test_folder(os.path.dirname(path).replace("Filters/", "", 1))
                        if not self.link_all(objects) or self.run_suites(path, place, 0, True):  # pass with none switched on
                            break
                        return made.numbers
                    lines = re.findall(r"%s:(\d+):\d+: (?:fatal )?error" % re.escape(str(overlay)), errors)
                    wrong = {owners[int(line) - 1] for line in lines} - {None}
                    if not wrong:
                        print("%s cannot be compiled with all mutations: %s" % (path, errors[:300]))
                        break
                    for place in wrong:
                        made.drop(place)
        finally:
            overlay.unlink(missing_ok=True)
        return {}

    def compile_all(self, sources, path, jobs):
        """The objects of all sources of a file, and the errors; a source after one with errors is not begun."""
        objects = {}
        errors = []

        def compile_one(source):
            if not errors:
                made, found = self.compile(pathlib.Path(source), path, ["-O1"])
                if not made:
                    errors.append(found or "error")
                objects[self.commands.objects[source]["output"]] = made

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(compile_one, sources))
        return objects, "\n".join(errors)

    # ---- running

    def run(self, name, filters, seconds, own=True, number=0, on_clock=False):
        """Runs tests until one fails. Returns "", the name of the test that failed, or "time". The seconds are those of the
        processor, as on a busy machine the clock tells nothing; unless `on_clock`."""
        program = self.binaries / name if own and (self.binaries / name).exists() else self.work.parent / "programs" / name
        environment = {**os.environ, "GTEST_FAIL_FAST": "1", "GTEST_FILTER": filters, "VTK_SMP_BACKEND_IN_USE": "STDThread",
                       "SUBDIVISIONOBJECTS_DATA": str(self.source / "Data"), "SUBDIVISIONOBJECTS_RANDOM_SECONDS": "2",
                       "SUBDIVISIONOBJECTS_SHARED_DATA": str(self.source.parent / "shared" / "data")}
        if number:
            environment[schemata.VARIABLE] = str(number)
        if own and (self.binaries / LIBRARY).exists():
            environment["LD_PRELOAD"] = str(self.binaries / LIBRARY)
        log = self.work / "tests.log"
        with open(log, "w", encoding="utf-8") as file:
            try:
                code = subprocess.run([str(program)], env=environment, stdout=file, stderr=subprocess.STDOUT, cwd=self.work,
                                      timeout=seconds if on_clock else 60. * (1. + seconds),  # what waits without end
                                      preexec_fn=lambda: limit(3600 if on_clock else int(1. + seconds))).returncode
            except subprocess.TimeoutExpired:
                return "time"
        if code in (-signal.SIGXCPU, -signal.SIGKILL):
            return "time"
        text = log.read_text(encoding="utf-8", errors="replace")
        if code == 0:
            return ""
        failed = re.findall(r"\[  FAILED  \] (\S+)", text) or re.findall(r"\[ RUN      \] (\S+)", text)[-1:]
        return failed[0].rstrip(",") if failed else "crash"

    def find_suites(self, folder):
        """The program of the tests in a folder or file, a filter for all, and [(filter, seconds)] in parts, the fast ones first."""
        if folder not in self.known.suites:
            with self.known.measuring:
                if folder not in self.known.suites:
                    self.known.suites[folder] = self.read_suites(folder) or self.measure_suites(folder)
        return self.known.suites[folder]

    def get_times_file(self, folder):
        """Where the times of a folder's tests stand, as long as their sources do not change."""
        name = str(folder.relative_to(self.source / "Testing")).replace("/", "+")
        texts = "".join(test.read_text(encoding="utf-8") for test in self.list_tests(folder))
        return self.work.parent / ("times+%s+%s.json" % (name, hashlib.sha1(texts.encode()).hexdigest()[:12]))

    @staticmethod
    def list_tests(folder):
        return [folder] if folder.is_file() else sorted(folder.rglob("Test*.cxx"))

    def read_suites(self, folder):
        file = self.get_times_file(folder)
        suite, seconds = json.loads(file.read_text(encoding="utf-8")) if file.exists() else (None, {})
        with self.known.lock:
            self.known.seconds.update(seconds)
        return suite

    def measure_suites(self, folder):
        names = set()
        for test in self.list_tests(folder):
            text = test.read_text(encoding="utf-8")
            names.update(re.findall(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+),", text, re.M))
        which = "Core" if "Core" in folder.parts else "Filters"
        every = ":".join(sorted("%s.*:*/%s.*:%s/*" % (name, name, name) for name in names))
        large = "-" + LEFT_OUT
        failed = self.run(TESTS[which], every + large, 3000, own=False)
        if failed:
            sys.exit("%s fails without a mutation" % failed)
        times = re.findall(r"\[       OK \] (\S+) \((\d+) ms\)", (self.work / "tests.log").read_text(encoding="utf-8"))
        times = sorted((int(time) / 1000., name) for name, time in times)
        seconds = {name: time for time, name in times}
        with self.known.lock:
            self.known.seconds.update(seconds)
        whole = sum(time for time, _ in times)
        parts = []
        fast = []
        for share in FAST_SHARES:
            names = [name for i, (_, name) in enumerate(times) if sum(one for one, _ in times[:i + 1]) < share * whole]
            parts += [(":".join(names[len(fast):]), share * whole)] if len(names) > len(fast) else []
            fast = names
        parts.append((every + large + "".join(":" + name for name in fast), whole))
        suite = [TESTS[which], every, parts]
        self.get_times_file(folder).write_text(json.dumps([suite, seconds]), encoding="utf-8")
        return suite

    def run_suites(self, path, folder, number, is_fast=False):
        program, _, parts = self.find_suites(folder)
        failed = ""
        for part, seconds in parts[:1] if is_fast else parts:
            failed = failed or self.run(program, part, 2. + 3. * seconds, number=number)
        self.known.add_killer(path, program, failed)
        return failed

    def run_killers(self, path, number=0):
        """Runs those tests that found most mutations of the file so far."""
        failed = ""
        for program, filters, seconds in self.known.find_killers(path):
            failed = failed or self.run(program, filters, 3. + 3. * seconds, number=number)
        return failed

    def judge_near(self, mutation, tests, is_explained):
        """As judge, by the tests that include a header; they leave open what they do not see."""
        self.use_folder(self.together)
        number = self.numbers.get(mutation.key)
        if not number:
            return None, ""
        failed = self.run_near(mutation.path, tests, number)
        return "killed" if failed else "survived" if is_explained else None, failed

    def run_near(self, path, tests, number=0):
        failed = self.run_killers(path, number)
        for test in map(pathlib.Path, tests):
            failed = failed or self.run_suites(path, test, number)
        return failed

    def judge(self, mutation, is_explained):
        """Returns what becomes of a mutation, and which test killed it. Tests near by are enough for an explained one."""
        number = self.numbers.get(mutation.key)
        if number:
            self.use_folder(self.together)
            failed = self.run_all(mutation.path, is_explained, number)
            if failed:
                return "killed", failed
        if number and (is_explained or self.known.is_fast or mutation.path.endswith(".h")):
            return "survived", ""
        self.use_folder(self.work / "alone")
        path = self.overlay / mutation.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(mutation.apply((self.source / mutation.path).read_text(encoding="utf-8")), encoding="utf-8")
        try:
            failed = ""
            near = [] if number else self.find_near(mutation.path)
            is_enough = number or near and is_explained
            others = [] if is_enough else [one for one in self.find_sources(mutation.path) if one not in near]
            groups = [near] * bool(near) + [others[i:i + AT_ONCE] for i in range(0, len(others), AT_ONCE)]
            objects = {}
            for group in groups:  # most are killed before all sources are compiled
                if not self.build_changed(mutation.path, group, objects):
                    return "does not compile", ""
                failed = self.run_near(mutation.path, near) if group is near else self.run_all(
                    mutation.path, is_explained or group is not groups[-1])
                if failed:
                    break
            if failed:
                return "killed", failed
            is_same = not is_explained and mutation.path.endswith(".cxx") and self.is_same(mutation.path)
            return "same" if is_same else "survived", ""
        finally:
            path.unlink()

    def run_all(self, path, is_near, number=0):
        """Runs the tests near by, and unless these are enough the others. Returns the one that failed, or ""."""
        failed = self.run_killers(path, number) or self.run_own(path, number)
        return failed or ("" if is_near or self.known.is_fast else self.run_next(path, number) or self.run_rest(path, number))

    def run_own(self, path, number=0):
        """Runs the tests of the folder with the same name. Returns the one that failed, or ""."""
        place = self.find_test_folder(os.path.dirname(path).replace("Filters/", "", 1))
        return self.run_suites(path, place, number, self.known.is_fast)

    def run_next(self, path, number=0):
        """Runs the tests of the folders near it."""
        failed = ""
        place = path.replace("Filters/", "", 1)
        for further in NEXT_TESTS.get(place, NEXT_TESTS.get(os.path.dirname(place), [])):
            failed = failed or self.run_suites(path, self.source / "Testing" / further, number)
        return failed

    def run_rest(self, path, number=0):
        """Runs all other tests, as long as there is time."""
        place = os.path.dirname(path).replace("Filters/", "", 1)
        own, every, _ = self.find_suites(self.find_test_folder(place))
        begin = time.time()
        slow = "Partitions*:*Random*:Fuzz*"
        for name in TESTS.values():
            left = self.rest - (time.time() - begin)
            if left > 1.:
                failed = self.run(name, "-" + slow + ":" + (every if name == own else ""), left, number=number, on_clock=True)
                if failed and failed != "time":  # there was no more time for it
                    return failed
        return ""


def limit(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))  # what never ends fills it soon
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


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("places", nargs="*", default=["Core/Rules"])
    parser.add_argument("--most", type=int, default=100)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--fast", action="store_true")
    parser.add_argument("--together", action="store_true")
    parser.add_argument("--rest", type=float, default=300.)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    source = arguments.source.resolve()
    work = arguments.build.resolve() / "mutations"
    (work / "programs").mkdir(parents=True, exist_ok=True)
    for name in TESTS.values():  # which may be built anew while this runs
        shutil.copy2(arguments.build / "bin" / name, work / "programs" / name)
    known = Known(arguments.fast)
    all_runners = [Runner(source, arguments.build.resolve(), work / str(i), arguments.rest, known) for i in range(arguments.jobs)]
    runners = queue.Queue()
    list(map(runners.put, all_runners))
    explained = report.read_explained(HERE / "survivors")
    all_of_them = []
    digests = {}
    for path in list_files(source, arguments.places or ["Core/Rules"]):
        text = (source / path).read_text(encoding="utf-8")
        digests[path] = hashlib.sha1(text.encode()).hexdigest()
        all_of_them += mutations.list_mutations(path, text)
    for path, old, new in explained:
        if path in digests and not any((one.path, one.old.strip(), one.new.strip()) == (path, old, new) for one in all_of_them):
            sys.exit("survivors explains a mutation of %s that does not exist: %s" % (path, new))
    chosen = mutations.choose(all_of_them, arguments.most)
    print("%d of %d mutations" % (len(chosen), len(all_of_them)))
    file = work / "results.json"
    results = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    keys = {one.key for one in all_of_them}  # lines that are gone take their mutations with them
    results = {key: entry for key, entry in results.items() if key in keys or entry["path"] not in digests}
    lock = threading.Lock()

    def has_reason(mutation):
        return (mutation.path, mutation.old.strip(), mutation.new.strip()) in explained

    def is_open(mutation):
        entry = results.get(mutation.key)
        is_known = entry and entry["file"] == digests[mutation.path]
        return not is_known or arguments.again and entry["result"] == "survived" and not has_reason(mutation)

    def try_one(mutation, near):
        begin = time.time()
        if arguments.together and mutation.key not in all_runners[0].numbers:
            return
        runner = runners.get()
        try:
            result, test = runner.judge_near(mutation, near, has_reason(mutation)) if near else runner.judge(mutation, has_reason(mutation))
        finally:
            runners.put(runner)
        if not result:
            return
        entry = {"path": mutation.path, "line": mutation.number, "old": mutation.old.strip(), "new": mutation.new.strip(),
                 "result": result, "test": test, "seconds": round(time.time() - begin, 1), "file": digests[mutation.path]}
        with lock:
            results[mutation.key] = entry
            file.with_suffix(".new").write_text(json.dumps(results, indent=1), encoding="utf-8")
            file.with_suffix(".new").replace(file)
            print("%s:%d: %s%s\n    %s\n    %s" % (mutation.path, mutation.number, result, " by " + test if test else "",
                                                 entry["old"], entry["new"]), flush=True)

    for path in digests:
        near = all_runners[0].find_near(path)
        for tests in [near, []] if near else [[]]:  # what those near it do not see, others may
            still_open = [one for one in chosen if one.path == path and is_open(one)]
            if not still_open:
                continue
            sources = tests or all_runners[0].find_sources(path)
            numbers = all_runners[0].prepare(path, still_open, sources, arguments.jobs)
            for runner in all_runners:
                runner.numbers = numbers
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                list(pool.map(lambda one, tests=tests: try_one(one, tests), still_open))
    tried = [results[one.key] for one in chosen if one.key in results]
    summary, counts = report.write_report(work / "report.txt", tried, explained)
    print(summary)
    report.write_figures(source, arguments.build.resolve().parent, list(results.values()), explained)
    return 1 if counts.get("survived", 0) else 0


if __name__ == "__main__":
    sys.exit(main())
