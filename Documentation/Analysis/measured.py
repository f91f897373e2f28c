# SPDX-License-Identifier: BSD-3-Clause
"""Page on how first derivatives jump around extraordinary vertices, edges and faces of fine meshes."""

import math

import jumps
import numpy as np
import pages
import plots
import solid_jumps
from jumps import LEVELS, SEEDS
from pages import Page, Row, Table, number
from solid_maps import BOX_SPLINE, TET_OCT
from surface_matrices import FOUR_EIGHT, SQRT_THREE
from surface_tools import CATMULL_CLARK, LOOP
from surfaces import BUTTERFLY, DOO_SABIN, MIDEDGE

from subdivisionobjects import vtkMultiDimensionalSubdivision

SURFACES = {"Loop": LOOP, "Catmull-Clark": CATMULL_CLARK, "Butterfly": BUTTERFLY, "sqrt(3)": SQRT_THREE, "4-8": FOUR_EIGHT,
            "Doo-Sabin": DOO_SABIN, "Midedge": MIDEDGE}
TEXTS = {"sqrt(3)": "A level is two steps.", "4-8": "A level is two steps.",
         "Doo-Sabin": "Around a face of so many corners.", "Midedge": "Around a face of so many corners; a level is two steps."}
KINDS = {"boundary": "boundaries", "crease": "creases", "convex": "convex corners", "concave": "concave corners"}
KIND_TEXTS = {"boundary": "A smooth boundary vertex with so many faces.",
              "crease": "So many faces on each side of a crease; jumps are those on one side, of both the larger.",
              "convex": "A corner of 90 degrees with so many faces.", "concave": "A corner of 270 degrees with so many faces."}
SIDES = {"Loop": LOOP, "Catmull-Clark": CATMULL_CLARK}
SOLIDS = {"Box spline": BOX_SPLINE, "Tet/oct": TET_OCT}
INSIDE = (3, 4, 5, 6, 7, 8, 10, 12, 16, 20)
SECTORS = (3, 4, 5, 6, 7, 8, 10, 12)
ALL = LEVELS + jumps.DEEP
# Rows of pages, by the name of their number.
SHOWN = {"faces": ["6", "20"], "valence": ["4", "20"], "tetrahedra": ["3", "8", "11"]}
COLUMNS = [f"level {level}" for level in ALL] + ["rate", "expected", "off", "half in", "8 below 6", "64 below 32"]
HIDDEN = [f"level {level}" for level in ALL if level != 64] + ["off", "half in", "8 below 6", "64 below 32"]

TEXT = f"""
Where eigenvalues promise a smooth limit, do first derivatives of fine meshes agree? Where the condition holds their jumps fall,
as fast as the eigenvalues say.

**What is measured.** Positions, and one value at each point, are random around a vertex, an edge or a face. Each cell there,
on a fine level, has a gradient of the value by position. The *jump* is the largest difference of two of these gradients, as a
part of the largest one. It falls to 0 where the limit is C^1.

- *Rate* is measured: the factor of the jump for each level, between the two deepest levels, one twice the other, that
  rounding leaves alone.
- *Expected* is derived from the eigenvalues of one step: the first one behind the tangents, divided by the last one of the
  tangents (1/2 along a boundary or crease). Where it is 1 or more the condition fails.
- In the file: *off*, the largest difference of the two; *half in*, how many levels halve a jump at the expected rate.
- *64 below 32*, in the file, counts the meshes whose jump on level 64 is smaller than on level 32, among the meshes that promise
  a smooth limit: the condition holds, and in solids the map, which vtkSubdivisionSmoothness samples, is regular and injective.

Each row is made {SEEDS} times, with other random numbers. Jumps and rates are medians if nothing else is said. Of surfaces all
levels are made, but only the part near the vertex is kept. Levels of **solids** are powers of the matrix of one step. Meshes
check them: of level 8, cut to two rings on the way, around one vertex of each valence and along edges that all mark; along
other edges whole ones of level {solid_jumps.WHOLE}.

**Surfaces.** Inside, the rate is that of the eigenvalues, off by 0.01 at most. Up to 8 faces all {SEEDS} meshes of each
scheme fall from level 6 to 8, and all of any number from 32 to 64. Around 16 and 20 faces some do not fall from level 6
to 8 yet: but for Butterfly and Doo-Sabin the derived rate is slow there, 0.89 to 0.97, so that 6 to 21 levels halve the jump.
At boundaries, creases and corners by the rule of the survey the rate is the derived one, too, off by 0.01 at most.

**Solids.** Of solids whose condition and map promise it, all fall from level 32 to 64. The rate of the table is off by 0.04 at
most around vertices, and by 0.005 along edges; single meshes are not as near on these levels. Across faces the gradients of
both sides are the same.

**Where it fails or is slow.**

- Some eigenvalues behind the tangents have fewer eigenvectors than they should. The jump then falls as a power of the level
  times the expected rate: for Butterfly at 6, midedge at 6, and Doo-Sabin at 5 and more. The rate is larger by 0.04 at most.
- Midedge at 3 corners, where the condition fails, falls as 1 by the level only.
- The plain rule (*ModifiedBoundary* off) at boundaries and creases: of Loop the jump stays from seven triangles on, and at six
  it falls as 1 by the level. Of Catmull-Clark it stays from five quads on, and falls so at four. At corners the plain rule
  fails from three faces on.
- Only convex corners of 8 and more do not all fall from level 32 to 64, where the expected rate is 0.986 and more.
- Of the box spline valence 4 and 5 do not fall, nor do edges of 8 and more that all mark, which agrees with (24). Edges of 11
  of tet/oct do not fall either.
- Along edges of 3 of tet/oct, where [SHW] saw deformations that do not look smooth, the jump falls, but slowly: 7 levels
  halve it."""

# ------------------------------------------------------------ rows


def heights(measured, levels, average=np.median):
    """Texts of jumps; levels that were not looked at since nothing was left have none."""
    return [number(average(measured.jumps[level]) if level in measured.jumps else 0., 5) for level in levels]


def first(values):
    return values[0]


def agreement(measured, average=np.median):
    """Texts of the rate, the expected rate, and their largest difference where the limit is smooth."""
    rates, smooth = measured.rates(), measured.smooth
    off = number(abs(rates - measured.expected)[smooth].max(), 3) if smooth.any() else "-"
    return [number(average(rates), 3), number(average(measured.expected), 3), off]


def counts(measured, pairs):
    return [f"{measured.falling(*pair)} of {measured.smooth.sum()}" for pair in pairs]


def half(expected):
    """In how many levels a jump that falls at a rate is halved."""
    return number(math.log(1 / 2) / math.log(expected), 1) if expected < 1 - 1e-6 else "-"


def row(measured, average=np.median):
    return (heights(measured, ALL, average) + agreement(measured, average) + [half(average(measured.expected))]
            + counts(measured, [(8, 6), (64, 32)]))


def both_rules(scheme, k, kind):
    own, plain = (jumps.measure(scheme, k, kind, ModifiedBoundary=modified) for modified in (True, False))
    return (heights(own, (2, 8, 64)) + agreement(own) + counts(own, [(8, 6), (64, 32)]) + heights(plain, (8, 64))
            + agreement(plain)[:2])


# ------------------------------------------------------------ tables

def jump_table(title, text, key, rows, plot):
    return Table(title, text, [key] + COLUMNS, [Row(str(k), compute) for k, compute in rows], f"{plot}.png",
                 f"{title}: jump by level, for each number.", SHOWN[key], HIDDEN)


def surface_table(name, scheme):
    rows = [(k, lambda k=k: row(jumps.measure(scheme, k))) for k in INSIDE]
    return jump_table(name, TEXTS.get(name, ""), "faces", rows,
                      "Jumps" + plots.plain(name))


def side_table(name, scheme, kind):
    columns = ["faces", "level 2", "level 8", "level 64", "rate", "expected", "off", "8 below 6", "64 below 32"] + [
        f"plain: {column}" for column in ("level 8", "level 64", "rate", "expected")]
    drawn = kind == "boundary"
    return Table(f"{name}, {KINDS[kind]}", KIND_TEXTS[kind], columns,
                 [Row(str(k), lambda k=k: both_rules(scheme, k, kind)) for k in SECTORS],
                 f"JumpsBoundary{plots.plain(name)}.png" if drawn else "",
                 f"{name}: jump on level 64 at boundaries, by the rule of the survey and by the plain one." if drawn else "",
                 ["4", "6", "7"] if drawn else [],
                 ["level 2", "level 8", "level 64", "off", "8 below 6", "64 below 32", "plain: level 8"])


def vertex_table(name, scheme):
    rows = [(n, lambda n=n: row(solid_jumps.measure_vertex(scheme, n), first)) for n in (*range(4, 13), 16, 20)]
    return jump_table(name, "Around input vertices of random tetrahedra, other ones each time: jumps, *rate* and "
                      "*expected* are those of the first mesh.", "valence", rows, "Jumps" + plots.plain(name))


def edge_table(title, scheme, marks, last):
    meshes = {8: solid_jumps.cut_mesh} if marks == "marked" else {solid_jumps.WHOLE: solid_jumps.whole_mesh}
    rows = [(n, lambda n=n: row(solid_jumps.measure_edge(scheme, n, solid_jumps.HEIGHTS[marks], meshes)))
            for n in range(3, last + 1)]
    return jump_table(title, "Around the middle of an edge of so many tetrahedra.", "tetrahedra", rows,
                      "Jumps" + plots.plain(title))


EDGES = {"Box spline, edges that all mark": (BOX_SPLINE, "marked", 10),
         "Box spline, edges that none marks": (BOX_SPLINE, "not marked", 10),
         "Tet/oct, edges": (TET_OCT, "tet/oct", 11)}
FACE_TABLE = Table(
    "Across faces", f"Limits and derivatives on both sides of inner faces, in {solid_jumps.FACE_STARS} random stars of "
    "valence 8, by EvaluateLimit of vtkMultiDimensionalSubdivision. All points of the star are moved at random. The value is "
    "how far the limit moves. The linear scheme, which is not C^1, shows how large a jump would be.",
    ["scheme", "places", "largest jump", "largest gap of positions"],
    [Row(name, lambda scheme=scheme: solid_jumps.face_jumps(scheme)) for name, scheme in (
        ("box spline", BOX_SPLINE), ("tet/oct", TET_OCT), ("linear", vtkMultiDimensionalSubdivision.LINEAR))])


def draw_jumps(made):
    for title in [*SURFACES, *SOLIDS, *EDGES]:
        plots.curves("Jumps" + plots.plain(title), [
            (one[0], LEVELS, [max(float(text), 1e-5) for text in one[1:5]]) for one in made[title]],
            "level", "jump of first derivatives")
    for title in SIDES:
        rows = made[f"{title}, boundaries"]
        faces = [int(one[0]) for one in rows]
        plots.curves("JumpsBoundary" + plots.plain(title), [
            (label, faces, [max(float(one[at]), 1e-5) for one in rows])
            for label, at in (("rule of the survey", 3), ("plain rule", 10))], "faces", "jump on level 64")


# ------------------------------------------------------------ sentences that the rows have to show

WITHOUT_VECTOR = {("Butterfly", 6), ("Midedge", 6)} | {("Doo-Sabin", k) for k in INSIDE if k > 4}
SECTOR_TITLES = [f"{name}, {kind}" for name in SIDES for kind in KINDS.values()]


def differences(page, titles, before=""):
    """From titles and keys to how far the rate is from the expected one, where this is below 1."""
    found = {}
    for title in titles:
        rate, expected = (pages.numbers(page, title, before + name) for name in ("rate", "expected"))
        found.update({(title, key): abs(rate[key] - expected[key]) for key in rate if expected[key] < 1})
    return found


def falls(page, titles, name, keys=range(100)):
    """Whether all meshes that have to fall do, in the rows with these keys."""
    return all(pages.is_all(text) for title in titles for key, text in pages.column(page, title, name).items()
               if int(key) in keys)


def some_rise(page, titles, name):
    """Titles and keys of the rows in which some meshes that have to fall do not."""
    return [(title, int(key)) for title in titles for key, text in pages.column(page, title, name).items()
            if not pages.is_all(text)]


def least(page, titles, name, keys):
    return min(pages.numbers(page, title, name)[key] for title in titles for key in keys)


def stays(page, scheme, tie):
    """By the plain rule, at boundaries and creases: less than the tie falls as derived, the tie as 1 by the level, more do
    not fall; by the survey's rule the jumps of these are smaller, and their rate is the derived one."""
    titles = [f"{scheme}, {KINDS[kind]}" for kind in ("boundary", "crease")]
    more = [k for k in SECTORS if k > tie]
    return all(
        differences(page, titles, "plain: ")[title, k] <= .01 for title in titles for k in SECTORS if k < tie) and all(
        abs(pages.numbers(page, title, "plain: rate")[tie] - 2 ** (-1 / 32)) < .003 for title in titles) and least(
        page, titles, "plain: expected", more) > 1 and least(page, titles, "plain: rate", more) > .99 and least(
        page, titles, "plain: level 64", more) > .2 and falls(page, titles, "64 below 32") and all(
        pages.numbers(page, title, "level 64")[k] < pages.numbers(page, title, "plain: level 64")[k] * 2 / 3
        for title in titles for k in more)


CLAIMS = [
    ("Inside, the rate is that of the eigenvalues, off by 0.01 at most.",
     lambda page: all(off <= .01 for place, off in differences(page, SURFACES).items() if place not in WITHOUT_VECTOR)),
    ("The jump then falls as a power of the level times the expected rate: for Butterfly at 6, midedge at 6, and Doo-Sabin at "
     "5 and more. The rate is larger by 0.04 at most.",
     lambda page: all(.01 < differences(page, SURFACES)[place] <= .04 for place in WITHOUT_VECTOR)),
    ("Up to 8 faces all 25 meshes of each scheme fall from level 6 to 8, and all of any number from 32 to 64.",
     lambda page: falls(page, SURFACES, "8 below 6", range(9)) and falls(page, SURFACES, "64 below 32")),
    ("Around 16 and 20 faces some do not fall from level 6 to 8 yet: but for Butterfly and Doo-Sabin the derived rate is slow "
     "there, 0.89 to 0.97, so that 6 to 21 levels halve the jump.",
     lambda page: all(.885 < pages.numbers(page, title, "expected")[k] < .97 and 5.5 < pages.numbers(
         page, title, "half in")[k] < 21.5 for title in SURFACES if title not in ("Butterfly", "Doo-Sabin") for k in (16, 20))
     and len(some_rise(page, SURFACES, "8 below 6")) > 8),
    ("Midedge at 3 corners, where the condition fails, falls as 1 by the level only.",
     lambda page: not pages.numbers(page, "Midedge", "expected")[3] < 1
     and 1.8 < pages.numbers(page, "Midedge", "level 32")[3] / pages.numbers(page, "Midedge", "level 64")[3] < 2.1),
    ("At boundaries, creases and corners by the rule of the survey the rate is the derived one, too, off by 0.01 at most.",
     lambda page: all(off <= .01 for off in differences(page, SECTOR_TITLES).values())),
    ("Only convex corners of 8 and more do not all fall from level 32 to 64, where the expected rate is 0.986 and more.",
     lambda page: {title.partition(", ")[2] for title, _ in some_rise(page, SECTOR_TITLES, "64 below 32")} == {"convex corners"}
     and all(k >= 8 and pages.numbers(page, title, "expected")[k] >= .986
             for title, k in some_rise(page, SECTOR_TITLES, "64 below 32"))),
    ("at boundaries and creases: of Loop the jump stays from seven triangles on, and at six it falls as 1 by the level.",
     lambda page: stays(page, "Loop", 6)),
    ("Of Catmull-Clark it stays from five quads on, and falls so at four.", lambda page: stays(page, "Catmull-Clark", 4)),
    ("At corners the plain rule fails from three faces on.",
     lambda page: all(least(page, [f"{name}, {kind}" for name in SIDES], "plain: expected", SECTORS) >= 1
                      for kind in ("convex corners", "concave corners"))),
    ("Of solids whose condition and map promise it, all fall from level 32 to 64.",
     lambda page: falls(page, [*SOLIDS, *EDGES], "64 below 32")),
    ("The rate of the table is off by 0.04 at most around vertices, and by 0.005 along edges;",
     lambda page: all(off <= .04 for off in differences(page, SOLIDS).values())
     and all(off <= .0051 for off in differences(page, EDGES).values())),
    ("Of the box spline valence 4 and 5 do not fall, nor do edges of 8 and more that all mark, which agrees with (24).",
     lambda page: [pages.column(page, "Box spline", "64 below 32")[key] for key in "45"] == 2 * ["0 of 0"]
     and all(pages.numbers(page, "Box spline", "level 64")[key] > 1 for key in (4, 5))
     and [k for k, rate in pages.numbers(page, [*EDGES][0], "rate").items() if rate > .99] == [8, 9, 10]),
    ("Edges of 11 of tet/oct do not fall either.", lambda page: pages.numbers(page, "Tet/oct, edges", "rate")[11] > 1),
    ("Along edges of 3 of tet/oct, where [SHW] saw deformations that do not look smooth, the jump falls, but slowly: 7 levels "
     "halve it.",
     lambda page: round(pages.numbers(page, "Tet/oct, edges", "half in")[3]) == 7
     and pages.column(page, "Tet/oct, edges", "64 below 32")["3"] == f"{SEEDS} of {SEEDS}"),
    ("Across faces the gradients of both sides are the same.",
     lambda page: list(pages.column(page, "Across faces", "largest jump").values())[:2] == 2 * ["0.00000"]
     and float(pages.column(page, "Across faces", "largest jump")["linear"]) > .1),
]


def make_page():
    tables = [surface_table(name, scheme) for name, scheme in SURFACES.items()]
    tables += [side_table(name, scheme, kind) for name, scheme in SIDES.items() for kind in KINDS]
    tables += [vertex_table(name, scheme) for name, scheme in SOLIDS.items()]
    tables += [edge_table(title, *of) for title, of in EDGES.items()]
    return Page("MeasuredSmoothness", "Smoothness, measured", TEXT, tables + [FACE_TABLE], draw_jumps, CLAIMS)


