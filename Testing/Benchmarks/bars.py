# SPDX-License-Identifier: BSD-3-Clause
"""What is to be reached: the table of bars in the report of run.py.

BARS has a row for each figure, with what it is compared with and the bar. Samples have the names of
the program: (family, what, case, levels), and the threads. Rows without a sample say why.
"""
import os

THREADS = (1, 2, 4)

# The time to allocate and write the output, by pages; the other one is shown beside.
PAGES = {"huge": "huge pages", "small": "4 KiB pages"}
OTHER_PAGES = {"huge": "small", "small": "huge"}
FLATNESS = 1.2  # what is slowest beside what is fastest, for each output cell


class NotMeasured(Exception):
    """Why there is no figure."""


class Measured:
    """All samples of a run; the names that the program has, that a quick run has, and that were to run."""

    def __init__(self, samples, memory, shape_memory, known, registered, chosen):
        self.samples = samples
        self.memory = memory  # peak beside output, by (case, levels, threads, cache)
        self.shape_memory = shape_memory  # bytes for each cell, by case
        self.known = known
        self.registered = registered
        self.chosen = chosen

    def find(self, key, threads):
        # Most peers have one thread.
        for count in (threads, 1) if key[0] == "peer" else (threads,):
            if key + (count,) in self.samples:
                return self.samples[key + (count,)]
        raise NotMeasured(self.why(key, threads))

    def why(self, key, threads):
        keys = {key + (threads,), key + (1,)} if key[0] == "peer" else {key + (threads,)}
        for names, reason in ((self.chosen, "it failed"), (self.registered, "left out by --filter"),
                              (self.known, "not with --quick")):
            if keys & names:
                return reason
        if key[0] == "peer":  # the figure beside it has its mesh
            return key[1].split()[0] + " is not installed"
        return "its mesh is not in the folder SUBDIVISIONOBJECTS_SHARED_DATA"


def get_pages(key):
    """"huge" or "small", if it is the key of writing the output; else None."""
    last = key[1].split("-")[-1]
    return last if "limit" in key[0] and last in PAGES else None


def get_key_of_other_pages(key):
    pages = get_pages(key)
    return (key[0], key[1][:-len(pages)] + OTHER_PAGES[pages]) + key[2:]


def milliseconds(sample):
    return "%.3g ms" % (1e3 * sample.median)


class Bar:
    """A row of BARS; subclasses give (figure, beside it, ratio or value, ratio of other pages)."""

    threads = THREADS

    def __init__(self, name, bar):
        self.name = name
        self.bar = bar

    def bar_text(self):
        return "%g" % self.bar

    def measure(self, measured, threads):
        raise NotImplementedError

    def row(self, measured, threads):
        try:
            figure, beside, value, other = self.measure(measured, threads)
            return [figure, beside, "%.2f" % value, other, self.bar_text(), "pass" if value <= self.bar else "fail"]
        except NotMeasured as reason:
            return ["-", "-", "-", "-", self.bar_text(), "not measured: %s" % reason]

    def rows(self, measured):
        rows = [self.row(measured, threads) for threads in self.threads]
        if all(row == rows[0] for row in rows):  # none of them was measured, for one reason
            return [[self.name, ", ".join(map(str, self.threads))] + rows[0]]
        return [[self.name, str(threads)] + row for threads, row in zip(self.threads, rows)]


class Time(Bar):
    """Milliseconds, at most the bar."""

    def __init__(self, name, figure, bar):
        super().__init__(name, bar)
        self.figure = figure

    def bar_text(self):
        return "%g ms" % self.bar

    def measure(self, measured, threads):
        sample = measured.find(self.figure, threads)
        return milliseconds(sample), "-", 1e3 * sample.median, "-"


class Ratio(Bar):
    """The time of one sample beside that of another: a peer, another filter, writing the output."""

    def __init__(self, name, figure, beside, bar):
        super().__init__(name, bar)
        self.figure = figure
        self.beside = beside

    def measure(self, measured, threads):
        sample = measured.find(self.figure, threads)
        beside = measured.find(self.beside, threads)
        pages = get_pages(self.beside)
        text = milliseconds(beside)
        other = "-"
        if pages:
            text += " (%s)" % PAGES[pages]
            other = "%.2f (%s)" % (
                sample.median / measured.find(get_key_of_other_pages(self.beside), threads).median,
                PAGES[OTHER_PAGES[pages]])
        return milliseconds(sample), text, sample.median / beside.median, other


class SpeedUp(Bar):
    """How much faster the limit becomes with two threads, beside how much faster we become."""

    threads = ("1 to 2",)

    def __init__(self, name, figure, limit):
        super().__init__("speed-up: " + name, 1.)
        self.figure = figure
        self.limit = limit

    def measure(self, measured, threads):
        def gain(key):
            return measured.find(key, 1).median / measured.find(key, 2).median
        pages = get_pages(self.limit)
        own = gain(self.figure)
        limit = gain(self.limit)
        text = "%.2f x" % limit
        other = "-"
        if pages:
            text += " (%s)" % PAGES[pages]
            other = "%.2f (%s)" % (
                gain(get_key_of_other_pages(self.limit)) / own, PAGES[OTHER_PAGES[pages]])
        return "%.2f x" % own, text, limit / own, other


class TimePerCell(Time):
    """Microseconds for each output cell."""

    def bar_text(self):
        return "%g us a cell" % self.bar

    def measure(self, measured, threads):
        sample = measured.find(self.figure, threads)
        value = 1e-3 * sample.ns_per_cell()
        return milliseconds(sample), "%.3g cells" % sample.cells, value, "-"


class Flat(Bar):
    """The time for each output cell over a series of samples: the largest beside the smallest.

    The series are all levels or all cases of a key whose member is None there.
    """

    def __init__(self, name, key):
        super().__init__("flat: " + name, FLATNESS)
        self.key = key

    def measure(self, measured, threads):
        which = self.key.index(None)
        series = {int(key[which]): sample for key, sample in measured.samples.items()
                  if key[4] == threads
                  and all(mine in (None, its) for mine, its in zip(self.key, key))}
        if len(series) < 2:
            raise NotMeasured("fewer than two of them were measured")
        values = [sample.ns_per_cell() for sample in series.values()]
        return ("%.3g to %.3g ns a cell" % (min(values), max(values)),
                "%s %d to %d" % ("levels" if which == 3 else "control cells", min(series), max(series)),
                max(values) / min(values), "-")


class Memory(Bar):
    """The growth of the peak of memory beside the size of the output."""

    def __init__(self, name, figure, bar):
        super().__init__("peak memory / output: " + name, bar)
        self.figure = figure

    def measure(self, measured, threads):
        value = measured.memory.get(self.figure[2:] + (threads, 0))
        if self.figure[0] == "surface":
            value = measured.memory.get((self.figure[1], self.figure[3], threads, 0))
        if value is None:
            raise NotMeasured(measured.why(self.figure, threads))
        return "-", "-", value, "-"


class MemoryPerCell(Bar):
    """The growth of the peak in bytes for each output cell; it hardly depends on threads."""

    threads = (1,)

    def __init__(self, name, figure, bar):
        super().__init__("memory: " + name, bar)
        self.figure = figure

    def bar_text(self):
        return "%g bytes a cell" % self.bar

    def measure(self, measured, threads):
        if self.figure[2] not in measured.shape_memory:
            raise NotMeasured(measured.why(self.figure, threads))
        return "-", "-", measured.shape_memory[self.figure[2]], "-"


def surface(scheme, mesh, levels):
    return ("surface", scheme, mesh, levels)


def surface_limit(scheme, mesh, levels, pages):
    return ("surfacelimit", "%s-%s" % (scheme, pages), mesh, levels)


CUBE = ("filter", "first", "cube", 3)
SPHERE = ("filter", "first", "sphere", 3)
POLYLINES = ("filter", "first", "polylines", 3)
PERCENT = ("redgreen", "filter", "percent", 1)
CORNER = ("redgreen", "filter", "corner", 4)
HEXAHEDRA = ("filter", "first", "hexahedra", 3)
AGAIN = ("deformation", "again", "million", 3)

# Figure, writing its output, and the name.
WITH_LIMITS = [
    ("(a) tetrahedra, box spline", CUBE, ("limit", "huge", "cube", 3)),
    ("(b) triangles, main filter", SPHERE, ("limit", "huge", "sphere", 3)),
    ("(e) polylines", POLYLINES, ("limit", "huge", "polylines", 3)),
    ("hexahedra, uncut", HEXAHEDRA, ("limit", "huge", "hexahedra", 3)),
    ("red-green, 1 % of 5 million tetrahedra", PERCENT, ("redgreen-limit", "filter-huge", "percent", 1)),
    ("red-green, corner", CORNER, ("redgreen-limit", "filter-huge", "corner", 4)),
    ("deforming 10^6 points again", AGAIN, ("limit", "deformation-huge", "million", 3)),
]
LIMIT_BARS = [1.6, 2.2, 1.5, 2.5, 2.0, 5.0, 1.3]

# Scheme, mesh, levels, the peer, the bar.
BESIDE_PEERS = [
    ("Loop", "sphere", 3, "OpenSubdiv", 0.25),
    ("Catmull-Clark", "quads", 3, "OpenSubdiv", 0.25),
    ("sqrt3", "sphere", 4, "CGAL", 0.1),
    ("Butterfly", "sphere", 3, "OpenMesh", 0.125),
    ("Doo-Sabin", "quads", 3, "CGAL", 0.125),
]

SURFACES = [row[:3] for row in BESIDE_PEERS] + [("Midedge", "quads", 6), ("4-8", "quads", 6)]

# Meshes that are refined on the limit by curvature; the levels are those of uniform meshes beside.
BY_CURVATURE = [
    ("screw-angle", 5), ("plate-angle", 4), ("nm_ogs5_fracture_surfaces.vtu", 0), ("surf_bunny_3k.vtp", 0),
    ("tet_gmsh_coil_crack.vtu", 0), ("mix_elmer_shell_on_solid.vtu", 0), ("mix_ogs5_fracture_network.vtu", 0),
]

PLACES = [("places", "sphere", "sphere", 0.9), ("places by Loop", "sphere by Loop", "sphere", 0.9),
          ("places by Catmull-Clark", "sphere of quads by CatmullClark", "sphere of quads", 0.8)]

BARS = [Ratio(*row, bar) for row, bar in zip(WITH_LIMITS, LIMIT_BARS)]
BARS += [Ratio(scheme, surface(scheme, "quads", 6), surface_limit(scheme, "quads", 6, "small"), 2.5)
         for scheme in ("4-8", "Midedge")]
# Normals and limits of a finished level are masks over its rings: at most as much again. Surfaces miss it still, Loop by
# 2.9 times the plain instructions with normals, 2.4 with limits: README.md, which says what was tried.
FRAMES = [(scheme, surface(scheme, mesh, levels), ("surfaceframes", scheme + "-%s", mesh, levels))
          for scheme, mesh, levels in SURFACES]
FRAMES += [("tetrahedra, box spline", CUBE, ("filter", "%s", "cube", 3)),
           ("triangles, main filter", SPHERE, ("filter", "%s", "sphere", 3)),
           ("tet/oct", ("filter", "tetoct", "cube", 3), ("filter", "tetoct-%s", "cube", 3))]
BARS += [Ratio("%s, with %s, beside without" % (name, what), (key[0], key[1] % what) + key[2:], plain, 2.)
         for name, plain, key in FRAMES for what in ("normals", "limits")]
BARS += [Ratio("%s beside %s" % (scheme, peer), surface(scheme, mesh, levels),
               ("peer", "%s %s" % (peer, scheme), mesh, levels), bar)
         for scheme, mesh, levels, peer, bar in BESIDE_PEERS]
BARS += [
    Ratio("(b) again with another scalar, beside OpenSubdiv's ready table", ("filter", "again", "sphere", 3),
          ("peer", "OpenSubdiv stencil table evaluate", "sphere", 3), 0.4),
    Ratio("red-green, corner, beside dune-uggrid", CORNER, ("peer", "dune-uggrid local", "corner", 4), 0.1),
    Ratio("screw on the limit, adaptive beside uniform", ("shape", "adaptive", "screw", 4),
          ("shape", "uniform", "screw", 4), 0.5),
]
for case, levels in BY_CURVATURE:
    BARS += [TimePerCell("red-green by curvature, " + case, ("shape", "adaptive", case, levels), 1.),
             MemoryPerCell("red-green by curvature, " + case, ("shape", "adaptive", case, levels), 300.)]
for case in ("bumpy", "bunny"):
    BARS += [
        Ratio("adaptive sqrt(3), %s, beside red-green on the limit" % case, ("adaptive", "sqrt3", case, 8),
              ("adaptive", "redgreen", case, 8), 1.0),
        Ratio("adaptive sqrt(3), %s, beside uniform sqrt(3) of CGAL" % case, ("adaptive", "sqrt3", case, 8),
              ("peer", "CGAL sqrt3", case, 2), 1.0)]
BARS += [
    Time("first binding of 10^6 points", ("deformation", "first", "million", 3), 150.0),
    Ratio("places, ready rows beside limit stencils of OpenSubdiv", ("places", "apply rows", "sphere", 0),
          ("peer", "OpenSubdiv limit stencils apply", "sphere", 0), 1.0)]
BARS += [Ratio("%s, making rows%s beside OpenSubdiv" % (what, parts), ("places", "make rows" + parts, own, 0),
               ("peer", "OpenSubdiv limit stencils make" + parts, peer, 0), bar)
         for parts in ("", " with second derivatives") for what, own, peer, bar in PLACES]
# A call beside making what it needs; applying that would come on top.
BARS += [Ratio("%s, EvaluateLimit beside OpenSubdiv" % what, ("places", "EvaluateLimit", own, 0),
               ("peer", "OpenSubdiv limit stencils make with second derivatives", peer, 0), 1.0)
         for what, own, peer, _ in PLACES]
BARS += [SpeedUp(*row) for row in WITH_LIMITS]
BARS += [SpeedUp(scheme, surface(scheme, mesh, levels), surface_limit(scheme, mesh, levels, "huge"))
         for scheme, mesh, levels in SURFACES]
BARS += [SpeedUp("adaptive sqrt(3), bumpy", ("adaptive", "sqrt3", "bumpy", 8), ("adaptivelimit", "sqrt3", "bumpy", 8))]
BARS += [Flat("%s, levels" % name, ("filter", "first", case, None))
         for name, case in (("tetrahedra", "cube"), ("triangles", "sphere"), ("polylines", "polylines"))]
BARS += [Flat("%s, control meshes" % kind, ("control", kind, None, levels))
         for kind, levels in (("tetrahedra", 1), ("triangles", 2))]
BARS += [Memory("tetrahedra, box spline", CUBE, 1.15), Memory("triangles, main filter", SPHERE, 1.3),
         Memory("hexahedra, uncut", HEXAHEDRA, 1.2)]
BARS += [Memory(scheme, surface(scheme, mesh, levels), 1.3) for scheme, mesh, levels in SURFACES]


def get_huge_page_mode():
    """The word in brackets of "always [madvise] never"."""
    try:
        with open("/sys/kernel/mm/transparent_hugepage/enabled", encoding="utf-8") as file:
            return file.read().split("[")[1].split("]")[0]
    except (OSError, IndexError):
        return "not known"


def get_heading(loads):
    return [
        "## Bars", "",
        "Threads: %s, of the filters; peers have one, but for OpenSubdiv's ready tables, and take memory from the C library, in pages of 4 KiB unless "
        "the system says always. Pages: a bar on "
        "writing the output says for which it is, and the ratio for the others stands beside it; huge pages "
        "of this system: %s. Load average at the start %.1f, at the end %.1f, on %d processors. A ratio is "
        "that of times and passes if it is at most the bar; that of a speed-up is the limit's beside ours; "
        "that of a flat time for each output cell is the largest beside the smallest."
        % (", ".join(map(str, THREADS)), get_huge_page_mode(), *loads, os.cpu_count()), ""]


def bars_section(measured, loads, table):
    rows = [row for bar in BARS for row in bar.rows(measured)]
    results = [row[-1].split(":")[0] for row in rows]
    return get_heading(loads) + table(
        ["name", "threads", "figure", "beside it", "value", "with other pages", "bar", "result"], rows) + [
            "%d pass, %d fail, %d not measured." % tuple(
                results.count(result) for result in ("pass", "fail", "not measured")), ""]
