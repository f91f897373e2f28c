# SPDX-License-Identifier: BSD-3-Clause
"""Page on the scheme that keeps the types of cells: eigenvalues, maps and jumps where cells of all types meet."""

import functools
import itertools
import math

import numpy as np
import pages
from contractions import adapted, radius_bounds, without
from hybrid_maps import (FaceLevel, Local, all_triangulations, edge_star, keys, pairs, six_pyramids, surface_star, vertex_star)
from jumps import DEEP, LEVELS, SEEDS, Measured
from measured import COLUMNS, HIDDEN
from measured import row as jump_row
from pages import Page, Row, Table, number, yes
from solid_jumps import jumps_of_powers
from solid_maps import HYBRID, LINEAR, is_smooth, moduli, random_star, subdivide
from solids import degrees
from surface_tools import add, point_array
from surfaces import catmull_clark_value, loop_value

VALUES = ["l1", "l2", "l3", "l4"]
ORIGIN, UP = np.zeros(3), np.array([0, 0, 1 / 2])
FACES = {  # from names to the cells on both sides, and whether quadratic functions are kept
    "hexahedra": ("hexahedron", "hexahedron", True), "wedges, quad": ("wedge, quad", "wedge, quad", True),
    "wedges, triangle": ("wedge, triangle", "wedge, triangle", True),
    "tetrahedra": ("tetrahedron", "tetrahedron", True), "pyramid, tetrahedron": ("pyramid, triangle", "tetrahedron", True),
    "hexahedron, wedge": ("hexahedron", "wedge, quad", False),
    "hexahedron, pyramid": ("hexahedron", "pyramid, base", False),
    "wedge, pyramid": ("wedge, quad", "pyramid, base", False),
    "pyramids, bases": ("pyramid, base", "pyramid, base", False),
    "wedge, tetrahedron": ("wedge, triangle", "tetrahedron", False)}
MIXED = ["hhpP", "hhptP", "hhpttP", "hptP", "hpttP", "huttU", "utU", "pPpP", "aaa", "aaaa", "aaaaa", "aaaaaa"]
COLUMNS_OF_CELLS = ["hhh", "hhhh", "hhhhh", "hhhhhh", "h" * 7, "h" * 8, "www", "wwww", "wwwww", "wwwwww", "w" * 7, "w" * 8,
                    "hhw", "hww", "hhhw", "hwwww"]
VALENCES = (4, 5, 6, 7, 8, 9, 12)
SAMPLES = 25


def texts(values):
    return [number(value) for value in values[:4]] + [yes(is_smooth(values))]


def looked_at(local, place):
    """(moduli, whether the characteristic map is regular, at how many corners), where the condition holds."""
    values = moduli(local.star(place)[0], 12)
    return (values, *(local.map(place) if is_smooth(values) else (None, 0)))


def shown(values, regular, samples):
    return texts(values) + (["-", "-"] if regular is None else [yes(regular), str(samples)])


# ------------------------------------------------------------ across faces


@functools.lru_cache(maxsize=None)
def face_level(one, other):
    return FaceLevel(one, other, False)


def radius(matrices, leading):
    """An upper bound of the joint spectral radius beside leading functions, by products of five."""
    left = without(matrices, leading)[1]
    size = len(left[0])
    square = np.eye(size)
    for _ in range(60):  # how fast the sum of squares of products grows
        square = sum(matrix.T @ square @ matrix for matrix in left)
        growth = np.linalg.norm(square)
        square = square / growth
    return radius_bounds(adapted(left, 1.05 * math.sqrt(growth)), 5)[2]


def face(one, other, twice):
    level = face_level(one, other)
    values = moduli(level.local.star(level.place)[0], 12)
    matrices = level.patch()
    count, jump = FaceLevel(one, other, True).second_jump()
    return texts(values) + [number(values[7]), number(values[8]), number(values[9])] + [
        number(radius(matrices, [1] + 3 * [1 / 2])),
        number(radius(matrices, [1] + 3 * [1 / 2] + 6 * [1 / 4])) if twice else "-", str(count), number(jump)]


# ------------------------------------------------------------ along edges


@functools.lru_cache(maxsize=None)
def edge_local(sectors):
    return Local(edge_star(sectors), 2)


def closed_form(sectors):
    if set(sectors) == {"h"}:
        return number(catmull_clark_value(len(sectors)))
    return number(loop_value(len(sectors))) if set(sectors) == {"w"} else "-"


def edge(sectors):
    values, regular, samples = looked_at(edge_local(sectors), UP)
    return shown(values, regular, samples) + [closed_form(sectors)]


# ------------------------------------------------------------ around vertices


@functools.lru_cache(maxsize=None)
def links(count):
    return all_triangulations(count)


def hexahedra(count, index):
    """Around a vertex, whose positions do not matter."""
    triangles = links(count)[index]
    directions = np.random.RandomState(3).standard_normal((count, 3))
    return Local(vertex_star(directions, triangles, {frozenset(pair) for pair in pairs(triangles)}, False), 1)


def pyramids_row():
    """Whose tips meet."""
    return ["cube"] + shown(*looked_at(Local(six_pyramids(), 2), ORIGIN))


def hexahedra_row(count, index):
    return [degrees(links(count)[index])] + shown(*looked_at(hexahedra(count, index), ORIGIN))


def counted(locals_, mapped=True):
    """(how many have the condition, of these how many a regular map, the least l3 - l4, the largest l1)."""
    found, held, regular = [], 0, 0
    for local in locals_:
        found.append(moduli(local.star(ORIGIN)[0]))
        if is_smooth(found[-1]):
            held, regular = held + 1, regular + (mapped and local.map(ORIGIN)[0])
    return [f"{held} of {len(found)}", f"{regular} of {held}" if mapped else "-",
            number(min(values[2] - values[3] for values in found)), number(max(values[0] for values in found))]


def all_hexahedra(count):
    return counted((hexahedra(count, index) for index in range(len(links(count)))), count < 10)


def mixed_star(random, valence):
    """A star of directions, with quads or triangles between neighbouring ones, as it comes."""
    points, triangles = random_star(random, valence)
    quads = {frozenset(pair) for pair in pairs(triangles) if random.uniform() < 1 / 2}
    return vertex_star(points, triangles.tolist(), quads)


def mixed_vertices(valence):
    random = np.random.RandomState(500 + valence)
    return counted(Local(mixed_star(random, valence), 1) for _ in range(SAMPLES))


# ------------------------------------------------------------ on surfaces


def cyclic_orders(count):
    """Of quads and triangles, up to turns and mirror images."""
    def least(order):
        turns = [order[i:] + order[:i] for i in range(count)]
        return min(turns + [turn[::-1] for turn in turns])
    return sorted({least("".join(order)) for order in itertools.product("qt", repeat=count)})


def surfaces(count):
    held, regular, least = 0, 0, 1.
    orders = cyclic_orders(count)
    for order in orders:
        local = Local(surface_star(order), 1)
        values = moduli(local.star(ORIGIN)[0])
        least = min(least, values[1] - values[2])
        if values[0] < 1 - 1e-6 and values[1] > values[2] + 1e-6:
            held, regular = held + 1, regular + local.map(ORIGIN)[0]
    return [f"{held} of {len(orders)}", f"{regular} of {held}", number(least)]


# ------------------------------------------------------------ jumps of first derivatives


def jumps_at(control, level, place, seed, seeds, size):
    """(jumps, moduli, whether the map is regular) around a place, at random positions and values. A mesh of two further
    levels has the values that powers of the matrix have."""
    random = np.random.RandomState(seed)
    points = np.array(control.points)[:, None]
    values = np.concatenate([points + random.uniform(-size, size, (len(points), seeds, 3)),
                             random.uniform(-1, 1, (len(points), seeds, 1))], axis=2)
    local = Local(control, level)
    matrix, here = local.star(place)
    grid = control.grid()
    add(grid.GetPointData(), "x", values.reshape(len(points), -1))
    x = point_array(subdivide(grid, HYBRID, level), "x")[here]
    deep = point_array(subdivide(grid, HYBRID, level + 2), "x")
    names = {key: i for i, key in enumerate(keys(point_array(
        subdivide(grid, LINEAR, level + 2, KeepCellTypes=True), "place")))}
    at = [names[key] for key in keys(place + (local.places[0][here] - place) / 4)]
    np.testing.assert_allclose(deep[at], matrix @ matrix @ x, rtol=0, atol=1e-12)
    cells = local.corners(local.incidence.touching([local.point(place)]), here)
    found = moduli(matrix)
    return jumps_of_powers(matrix, x, cells, level), found, is_smooth(found) and local.map(place)[0]


def jumps_row(measured, tangent, average):
    """With an estimate of the Hoelder exponent of first derivatives."""
    rate = average(measured.rates())
    exponent = number(min(1, math.log(rate) / math.log(tangent)), 2) if rate < 1 - 1e-3 else "-"
    return jump_row(measured, average) + [exponent]


def edge_jumps(sectors):
    found, values, smooth = jumps_at(edge_star(sectors), 2, UP, 700 + len(sectors), SEEDS, .1 * min(1, 6 / len(sectors)))
    return jumps_row(Measured(found, np.full(SEEDS, values[3] / values[2]), np.full(SEEDS, smooth)), values[2], np.median)


def face_jumps(one, other):
    level = face_level(one, other)
    found, values, smooth = jumps_at(level.control, 3, level.place, 800, SEEDS, .1)
    return jumps_row(Measured(found, np.full(SEEDS, values[3] / values[2]), np.full(SEEDS, smooth)), values[2], np.median)


def vertex_jumps(make, valence):
    jumps, expected, smooth, tangents = {}, [], [], []
    for seed in range(SEEDS):
        control = make(np.random.RandomState(1000 * seed + 600 + valence), valence)
        found, values, good = jumps_at(control, 1, ORIGIN, seed, 1, .02)
        for level in LEVELS + DEEP:
            jumps.setdefault(level, []).extend(found.get(level, [0.]))
        expected.append(values[3] / values[2])
        tangents.append(values[2])
        smooth.append(good)
    measured = Measured({level: np.array(jump) for level, jump in jumps.items()}, np.array(expected), np.array(smooth))
    return jumps_row(measured, tangents[0], lambda values: values[0])


# ------------------------------------------------------------ sentences that the rows have to show

JUMP_TITLES = ["Jumps across faces", "Jumps around edges", "Jumps around vertices of all types"]
SMOOTH, OTHER = ([name for name, of in FACES.items() if of[2] == twice] for twice in (True, False))


def others(page, title, column, answer="yes"):
    """The keys of rows that say something else."""
    return [key for key, text in pages.column(page, title, column).items() if text != answer]


def is_between(page, title, column, names, low, high):
    found = pages.column(page, title, column)
    return all(low <= float(found[name]) < high for name in names)


CLAIMS = [
    ("Second derivatives agree on both sides, and products of five steps shrink what is not quadratic by less than .18 a step.",
     lambda page: is_between(page, "Across faces", "second jump", SMOOTH, 0, .0001)
     and is_between(page, "Across faces", "beside quadratic", SMOOTH, 0, .18)),
    ("**C^1** across all other faces: what is not linear shrinks by less than .35.",
     lambda page: is_between(page, "Across faces", "beside linear", FACES, 0, .35)),
    ("Second derivatives stay bounded, and jump but between bases of pyramids.",
     lambda page: is_between(page, "Across faces", "l4", FACES, .25, .2501)
     and is_between(page, "Across faces", "second jump", set(OTHER) - {"pyramids, bases"}, .1, 1)),
    ("Condition (24) is a tie at 3 wedges and at 8 hexahedra",
     lambda page: others(page, "Along columns", "(24)") == ["hhhhhhhh", "www"]
     and all(pages.column(page, "Along columns", "l3")[key] == pages.column(page, "Along columns", "l4")[key]
             for key in ("hhhhhhhh", "www"))),
    ("At all other edges that were tried (24) holds, and the map is regular.",
     lambda page: not others(page, "Along other edges", "(24)") and not others(page, "Along other edges", "regular")),
    ("Of the 306 links of up to 10 neighbours one fails, a column of 8. Up to 8 neighbours all maps are regular, of 9 46 of 50.",
     lambda page: [text.split(" of ") for text in pages.column(
         page, "Around vertices of hexahedra", "(24) holds").values()] == [
             [n, n] for n in ("1", "1", "2", "5", "14", "50")] + [["232", "233"]]
     and [text for text in pages.column(page, "Around vertices of hexahedra", "regular").values()
          if not pages.is_all(text)] == ["46 of 50", "-"]),
    ("from seven neighbours on (24) holds, and most maps are regular. Of four to six some fail, or have a map that folds",
     lambda page: [int(key) for key, text in pages.column(page, "Around vertices of all types", "(24) holds").items()
                   if not pages.is_all(text)] == [5, 6]
     and pages.column(page, "Around vertices of all types", "regular")["4"] == "9 of 25"
     and all(int(pages.column(page, "Around vertices of all types", "regular")[key].split()[0]) >= 23
             for key in ("7", "8", "9", "12"))),
    ("On surfaces of quads and triangles (23) holds, and the map is regular, for all 79 orders of 3 to 8 faces.",
     lambda page: all(pages.is_all(text) for name in ("(23) holds", "regular")
                      for text in pages.column(page, "On surfaces of quads and triangles", name).values())
     and sum(int(text.split()[0]) for text in pages.column(
         page, "On surfaces of quads and triangles", "(23) holds").values()) == 79),
    ("all jumps fall from level 32 to 64, but those of one vertex of 12 neighbours.",
     lambda page: [(title, key) for title in JUMP_TITLES for key, text in pages.column(
         page, title, "64 below 32").items() if not pages.is_all(text)] == [(JUMP_TITLES[2], "12")]
     and pages.column(page, JUMP_TITLES[2], "64 below 32")["12"] == "23 of 24"),
    ("Across faces they halve with each level.",
     lambda page: is_between(page, JUMP_TITLES[0], "rate", FACES, .495, .505)),
]

# ------------------------------------------------------------ the page

CONDITION = VALUES + ["(24)"]
MAP = ["regular", "corners sampled"]
COUNTS = ["neighbours", "(24) holds", "regular", "least l3 - l4", "largest l1"]
JUMPS = COLUMNS + ["exponent"]


def jump_table(title, text, key, rows, keys):
    return Table(title, text, [key] + JUMPS, [Row(name, compute) for name, compute in rows], keys=keys,
                 hidden=HIDDEN + ["half in"])


TEXT = """
![Cells of four types: cut into tetrahedra, and uncut](../Guide/pictures/gallery_cell_types.png)

You have hexahedra, wedges, pyramids or quads, and you want to know how smooth the limit of *Keep cell types*
(`HYBRID` in C++, [Mathematics 15](../Mathematics.md)) is where cells meet.
Condition (24) is 1 > l1 >= l2 >= l3 > l4. A map is called regular here if all corners of cells that are looked at have one
orientation. Jumps are those of [this page](MeasuredSmoothness.md).

- **C^2** inside cells, and across faces between two hexahedra, wedges or tetrahedra, and of a pyramid to a tetrahedron. Second
  derivatives agree on both sides, and products of five steps shrink what is not quadratic by less than .18 a step.
- **C^1** across all other faces: what is not linear shrinks by less than .35. Second derivatives stay bounded, and jump but
  between bases of pyramids.
- **C^1** along columns, which are edges of any number of hexahedra, or of wedges along their axis: the limit is a surface times
  a curve. Condition (24) is a tie at 3 wedges and at 8 hexahedra, and is not needed there.
- **Not known**: other edges, and vertices of hexahedra. At all other edges that were tried (24) holds, and the map is regular.
  Of the 306 links of up to 10 neighbours one fails, a column of 8. Up to 8 neighbours all maps are regular, of 9 46 of 50.
- **Not always**: vertices where types mix at random. There from seven neighbours on (24) holds, and most maps are regular.
  Of four to six some fail, or have a map that folds.
- On surfaces of quads and triangles (23) holds, and the map is regular, for all 79 orders of 3 to 8 faces.

Where condition and map promise it, all jumps fall from level 32 to 64, but those of one vertex of 12 neighbours. Across faces
they halve with each level."""
FACE_TEXT = """*Beside linear, beside quadratic*: upper bounds of the joint spectral radius, as for [tet/oct](TetOct.md). *Second
jump*: the largest difference of second derivatives of limits that a step divides by four, as a part of the largest one."""
EDGE_TEXT = """Cells by letters: h hexahedra, t tetrahedra, p and P pyramids with their base on one side, u and U wedges with the
edge in a triangle, a pyramids with the edge to their tips, w wedges along their axis."""
LINK_TEXT = "All triangulations of the sphere with so many vertices as links."
MIXED_TEXT = f"""In {SAMPLES} random stars for each number: between two neighbours is a quad or a triangle, as it comes."""
JUMP_TEXT = """*Exponent* estimates the Hoelder exponent of first derivatives: the logarithm of the rate by that of l3, at most 1."""


def make_page():
    link_rows = [(f"{count}.{chr(ord('a') + i)}", count, i) for count, many in ((4, 1), (5, 1), (6, 2), (7, 5), (8, 14))
                 for i in range(many)]
    return Page("Hybrid", "Spectra where cells keep their types", TEXT, [
        Table("Across faces", FACE_TEXT, ["face"] + CONDITION + ["l8", "l9", "l10", "beside linear", "beside quadratic",
                                                                 "divided by 4", "second jump"],
              [Row(name, lambda of=of: face(*of)) for name, of in FACES.items()],
              hidden=["l1", "l2", "l3", "(24)", "l8", "l10", "divided by 4"]),
        Table("Along columns", "", ["cells"] + CONDITION + MAP + ["closed form"],
              [Row(cells, lambda cells=cells: edge(cells)) for cells in COLUMNS_OF_CELLS], keys=[]),
        Table("Along other edges", EDGE_TEXT, ["cells"] + CONDITION + MAP + ["closed form"],
              [Row(cells, lambda cells=cells: edge(cells)) for cells in MIXED],
              keys=["hhpP", "pPpP", "aaaaaa"], hidden=["(24)", *MAP, "closed form"]),
        Table("Around vertices of hexahedra, each", "", ["link", "degrees"] + CONDITION + MAP,
              [Row(name, lambda count=count, i=i: hexahedra_row(count, i)) for name, count, i in link_rows] +
              [Row("six pyramids", pyramids_row)], keys=[]),
        Table("Around vertices of hexahedra", LINK_TEXT, COUNTS,
              [Row(str(count), lambda count=count: all_hexahedra(count)) for count in range(4, 11)],
              keys=[]),
        Table("Around vertices of all types", MIXED_TEXT, COUNTS,
              [Row(str(count), lambda count=count: mixed_vertices(count)) for count in VALENCES], hidden=["largest l1"]),
        Table("On surfaces of quads and triangles", "", ["faces", "(23) holds", "regular", "least l2 - l3"],
              [Row(str(count), lambda count=count: surfaces(count)) for count in range(3, 9)], keys=[]),
        jump_table(JUMP_TITLES[0], "", "face", [
            (name, lambda of=of: face_jumps(*of[:2])) for name, of in FACES.items()], []),
        jump_table(JUMP_TITLES[1], JUMP_TEXT, "cells", [
            (cells, lambda cells=cells: edge_jumps(cells)) for cells in COLUMNS_OF_CELLS + MIXED],
                   ["hhhhh", "hhpP", "aaaaaa"]),
        jump_table(JUMP_TITLES[2], "", "neighbours", [
            (str(count), lambda count=count: vertex_jumps(mixed_star, count)) for count in VALENCES], []),
    ], None, CLAIMS)
