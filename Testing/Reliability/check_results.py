# SPDX-License-Identifier: BSD-3-Clause
"""Whether results.py reads what CTest and libFuzzer print, and write_page.py tells of it."""
import os
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
import results
import write_page

TESTS = """\
      Start   1: Masks.OfCurves
 1/6 Test   #1: Masks.OfCurves .............   Passed    0.31 sec
 2/6 Test #117: Zoo/Schemes.Agree/5 ........***Failed    0.40 sec
[ RUN      ] Zoo/Schemes.Agree/5
SUMMARY: AddressSanitizer: heap-buffer-overflow Filters/Core/A.cxx:12 in f
 3/6 Test #2000: Files.OfOthers/one  # GetParam() = "one.vtp" ...***Skipped   0.10 sec
 4/6 Test   #4: Race.OfTwo .................***Exception: SegFault  0.40 sec
SUMMARY: ThreadSanitizer: data race Filters/Core/A.cxx:12 in f
SUMMARY: ThreadSanitizer: data race Filters/Core/B.cxx:13 in g
 5/6 Test   #5: Long.Run ...................***Timeout 600.01 sec
 6/8 Test   #6: Rows.Agree/8-byte object <00-01> ...   Passed    0.10 sec
 7/8 Test   #7: Rows.Agree/8-byte object <00-02> ...   Passed    0.10 sec
67% tests passed, 3 tests failed out of 6
\t  4 - Race.OfTwo (SEGFAULT)
"""
AGAIN = " 1/1 Test #117: Zoo/Schemes.Agree/5 ........   Passed    0.40 sec\n"
FUZZ = """\
INFO: Loaded 1 modules   (330236 inline 8-bit counters): 330236 [0x1, 0x2),
#512 NEW    cov: 8136 ft: 9000 corp: 4/4b
SUMMARY: libFuzzer: timeout
SUMMARY: UndefinedBehaviorSanitizer: undefined-behavior Filters/Core/A.cxx:12
SUMMARY: libFuzzer: deadly signal
stat::number_of_executed_units: 600
"""
QUIET = "stat::number_of_executed_units: 100\n"


def check(got, wanted):
    if got != wanted:
        sys.exit("%s is not %s" % (got, wanted))


with tempfile.TemporaryDirectory() as build:
    log = pathlib.Path(build, "log")
    log.write_text(TESTS, encoding="utf-8")
    results.add_test_run(".", build, "asan", log)
    figures = results.read(build, "asan")["figures"]
    check(write_page.tell_tests(figures), "3 passed, 3 failed, 1 skipped")
    check(write_page.sum_up(figures, "reports"), 3)
    log.write_text(AGAIN, encoding="utf-8")
    results.add_test_run(".", build, "asan", log)
    figures = results.read(build, "asan")["figures"]
    check(write_page.tell_tests(figures), "4 passed, 2 failed, 1 skipped")
    check(write_page.sum_up(figures, "reports"), 2)
check(results.read_fuzz_log(FUZZ),
      {"executions": 600, "covered": 8136, "places": 330236, "hangs": 1, "reports": 1, "crashes": 1})
with tempfile.TemporaryDirectory() as build:
    log = pathlib.Path(build, "log")
    for text in (FUZZ, QUIET, QUIET):
        log.write_text(text, encoding="utf-8")
        results.add_fuzz_run(".", build, "Files", log, 1800)
    figures = results.read(build, "fuzz")["figures"]
    check([write_page.sum_up(figures, key) for key in ("executions", "seconds", "covered")], [800, 5400, 8136])
    check([write_page.sum_up(figures, fault) for fault in results.FAULTS], [0, 0, 0])
    check(write_page.tell_mended(figures), "crashes 1, hangs 1, reports 1")
    check(write_page.tell_since(figures["Files"]), "200 in 1.0 h")
    log.write_text(FUZZ, encoding="utf-8")
    results.add_fuzz_run(".", build, "Files", log, 1800)
    figures = results.read(build, "fuzz")["figures"]
    check([write_page.sum_up(figures, fault) for fault in results.FAULTS], [1, 1, 1])
    check(write_page.tell_since(figures["Files"]), "800 in 1.5 h")
os.environ["PATH"] = ""
check(results.get_commit("."), "no commit")
print("logs are read")
