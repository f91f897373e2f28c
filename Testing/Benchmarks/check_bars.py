# SPDX-License-Identifier: BSD-3-Clause
"""Whether bars.py tells right and wrong of figures that are made up."""
import sys

sys.dont_write_bytecode = True
import bars
from run import Sample

OWN = ("filter", "first", "a", 3)
SMALL = ("limit", "small", "a", 3)
HUGE = ("limit", "huge", "a", 3)
PEER = ("peer", "CGAL Loop", "a", 3)


def make_sample(seconds, cells=1000.):
    sample = Sample()
    sample.times = [seconds, 9. * seconds, 0.5 * seconds]  # the median is the first
    sample.cells = cells
    return sample


def measure(times, known=(), registered=(), chosen=()):
    samples = {key: make_sample(*value) for key, value in times.items()}
    return bars.Measured(samples, {("a", 3, 1, 0): 1.2}, {"a": 300.}, set(known), set(registered), set(chosen))


def check(got, wanted):
    if got != wanted:
        sys.exit("%s is not %s" % (got, wanted))


def get_results(bar, measured):
    return [row[-1] for row in bar.rows(measured)]


LIMITS = {SMALL + (1,): (4e-3,), HUGE + (1,): (2e-3,), SMALL + (2,): (2e-3,), HUGE + (2,): (1e-3,)}
MEASURED = measure({OWN + (1,): (4e-3,), OWN + (2,): (2.5e-3,), PEER + (1,): (40e-3,), **LIMITS})
check(bars.Ratio("", OWN, HUGE, 2.).rows(MEASURED)[0],
      ["", "1", "4 ms", "2 ms (huge pages)", "2.00", "1.00 (4 KiB pages)", "2", "pass"])
check(get_results(bars.Ratio("", OWN, HUGE, 2.), MEASURED)[1], "fail")
check(bars.Ratio("", OWN, HUGE, 2.).rows(MEASURED)[2][-1].split(":")[0], "not measured")
# A peer of one thread stands beside any number of ours.
check(get_results(bars.Ratio("", OWN, PEER, 0.1), MEASURED)[:2], ["pass", "pass"])
check(get_results(bars.Ratio("", OWN, PEER, 0.09), MEASURED)[:2], ["fail", "pass"])
# The limit doubles its speed with two threads, and we take 4 / 2.5 of it.
check(bars.SpeedUp("", OWN, HUGE).rows(MEASURED)[0][2:], ["1.60 x", "2.00 x (huge pages)", "1.25", "1.25 (4 KiB pages)", "1", "fail"])
check(get_results(bars.Time("", OWN, 4.), MEASURED)[:2], ["pass", "pass"])
check(get_results(bars.Time("", OWN, 3.), MEASURED)[:2], ["fail", "pass"])
check(get_results(bars.TimePerCell("", OWN, 4.), MEASURED)[0], "pass")  # 4 ms for 1000 cells
check(get_results(bars.TimePerCell("", OWN, 3.9), MEASURED)[0], "fail")
check(get_results(bars.Memory("", OWN, 1.2), MEASURED)[0], "pass")
check(get_results(bars.Memory("", OWN, 1.15), MEASURED)[0], "fail")
check(get_results(bars.MemoryPerCell("", OWN, 300.), MEASURED), ["pass"])
check(get_results(bars.MemoryPerCell("", OWN, 299.), MEASURED), ["fail"])
SERIES = measure({("filter", "first", "a", level, 1): (seconds, 1000.) for level, seconds in ((2, 1e-3), (3, 1.2e-3))})
check(bars.Flat("", ("filter", "first", "a", None)).rows(SERIES)[0][2:],
      ["1e+03 to 1.2e+03 ns a cell", "levels 2 to 3", "1.20", "-", "1.2", "pass"])
# Why there is no figure.
NONE = [get_results(bars.Ratio("", OWN, PEER, 1.), measure({}, *names)) for names in (
    ([OWN + (1,)], [OWN + (1,)], [OWN + (1,)]), ([OWN + (1,)], [OWN + (1,)]), ([OWN + (1,)],))]
check([results[0] for results in NONE], ["not measured: " + why for why in ("it failed", "left out by --filter", "not with --quick")])
check(get_results(bars.Ratio("", PEER, OWN, 1.), measure({})), ["not measured: CGAL is not installed"])
print("bars are told")
