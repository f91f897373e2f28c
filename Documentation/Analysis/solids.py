# SPDX-License-Identifier: BSD-3-Clause
"""Pages on volume schemes: eigenvalues and condition (24) on the lattice, across faces, along edges, around vertices."""

import functools

import filter_maps
import numpy as np
import pages
import plots
from contractions import contracted, radius_bounds, radius_cut
from pages import Page, Row, Table, number, yes
from solid_maps import (BOX_SPLINE, TET_OCT, code, coordinates, edge_matrix, edge_star, face_matrices, is_smooth, moduli,
                        random_star, solid, star_matrix, subdivide, vertex_matrix, vertex_star)

COUNTS = {4: 1, 5: 1, 6: 2, 7: 5, 8: 14}  # triangulations of the sphere with so many vertices
RANDOM = [*range(4, 21), 24, 28, 32, 36, 40]
SAMPLES = 25
MAPS = 5
NAMES = {BOX_SPLINE: "BOX_SPLINE", TET_OCT: "TET_OCT"}
VALUES = ["l1", "l2", "l3", "l4"]
MAP = filter_maps.COLUMNS
SHOWN = ["4", "5", "6", "7", "40"]  # of valences


def texts(values):
    return [number(value) for value in values[:4]] + [yes(is_smooth(values))]


def map_of(made, scheme, corners, values):
    return filter_maps.columns(made, NAMES[scheme], corners, values[:4])


def lattice(scheme):
    """Around a vertex deep inside one tetrahedron."""
    made = solid([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
    fine = subdivide(made, scheme, 4)
    vertex = int(np.argmin(np.linalg.norm(coordinates(fine) - 1 / 4, axis=1)))
    values = moduli(star_matrix(fine, vertex, scheme)[0], 12)
    return [number(values[0]), number(values[2]), number(values[3]), number(values[8]), number(values[9])]


@functools.lru_cache(maxsize=None)
def faces(scheme):
    random, found = np.random.RandomState(1), {}
    for _ in range(12):
        same, made, matrices = face_matrices(random, scheme)
        found.setdefault(same, (made, []))[1].extend(matrices)
    return found


def face(scheme, same):
    made, matrices = faces(scheme)[same]
    all_values = [moduli(matrix, 12) for matrix in matrices]
    spread = max(abs(np.array(values) - all_values[0]).max() for values in all_values)
    first = all_values[0]
    return texts(first) + [number(first[4]), number(first[9]), str(len(matrices)), number(spread, 6)] + map_of(
        made, scheme, [0, 1, 2], first)


def edge(scheme, n, height):
    values = moduli(edge_matrix(n, scheme, height))
    return texts(values) + map_of(edge_star(n, height), scheme, [0, 1], values)


def tet_oct_edge(n):
    values = moduli(edge_matrix(n, TET_OCT, 1.))
    return texts(values) + [number(values[1 if n < 6 else 0], 5)] + map_of(
        edge_star(n, 1.), TET_OCT, [0, 1], values)  # the value along the edge is 1/2


@functools.lru_cache(maxsize=None)
def triangulations():
    """A star for each triangulation of the sphere with 4 to 8 vertices, which random hulls reach."""
    random, found = np.random.RandomState(2), {}
    for valence, count in COUNTS.items():
        mine = {}
        while len(mine) < count:
            points, triangles = random_star(random, valence)
            mine.setdefault(code(triangles.tolist()), (points, triangles))
        for i, key in enumerate(sorted(mine)):
            found[f"{valence}.{chr(ord('a') + i)}"] = mine[key]
    return found


def degrees(triangles):
    counts = np.bincount(np.asarray(triangles).ravel())
    return " ".join(str(one) for one in sorted(counts))


def triangulation(scheme, name):
    points, triangles = triangulations()[name]
    values = moduli(vertex_matrix(points, triangles, scheme))
    return [degrees(triangles)] + texts(values) + map_of(vertex_star(points, triangles), scheme, [0], values)


def random_vertices(scheme, valence):
    random = np.random.RandomState(100 + valence)
    stars = [random_star(random, valence) for _ in range(SAMPLES)]
    found = [moduli(vertex_matrix(*star, scheme)) for star in stars]
    maps = [map_of(vertex_star(*star), scheme, [0], values)[:2]
            for star, values in zip(stars[:MAPS], found) if is_smooth(values)]
    gaps = [values[2] - values[3] for values in found]
    return [f"{sum(map(is_smooth, found))} of {SAMPLES}", number(min(gaps)), number(max(gaps)),
            number(max(values[0] for values in found))] + [f"{maps.count(['yes', 'yes'])} of {len(maps)}"]


def random_table(scheme, text, plot):
    columns = ["valence", "(24) holds", "least l3 - l4", "largest l3 - l4", "largest l1", "regular and injective"]
    return Table("Around vertices, random", text, columns,
                 [Row(str(n), lambda n=n: random_vertices(scheme, n)) for n in RANDOM],
                 plot, "Largest and least l3 - l4 by valence; the condition holds above zero.", SHOWN)


def triangulation_table(scheme, text):
    names = [f"{valence}.{chr(ord('a') + i)}" for valence, count in COUNTS.items() for i in range(count)]
    return Table("Around vertices, each triangulation", text,
                 ["valence and case", "degrees in the link"] + VALUES + ["(24)"] + MAP,
                 [Row(name, lambda name=name: triangulation(scheme, name)) for name in names],
                 keys=["4.a", "5.a", "6.a", "6.b", "7.b", "8.g"], hidden=["samples"])


LATTICE = Table("The lattice", "Inside a control tetrahedron, where the mesh is a lattice from the first levels on: "
                "1/2 three times and 1/4 six times, as a C^2 scheme has them.",
                ["scheme", "l1", "l3", "l4", "l9", "l10"],
                [Row("box spline", lambda: lattice(BOX_SPLINE)), Row("tet/oct", lambda: lattice(TET_OCT))])

RADIUS = 0.1617  # what products of pieces show it to be below
PRODUCTS = f"""The test of [SHW], appendix A. Take two triangles of the face, a tetrahedron and an octahedron on each side.
Together they have four quarters of the same kind, and each quarter has a matrix: a step applied to the 40 vertices of all
solids that touch the two triangles. All four matrices keep a space of ten functions with the eigenvalues 1, 1/2 three times
and 1/4 six times; of its quadratic functions as many are odd across the face as of polynomials. On the remaining functions
all products of the matrices have to shrink faster than by 1/4 for each step: their joint spectral radius is below 1/4.

Over all products of one length, the largest spectral radius bounds the joint one from below and the largest norm from above,
both to the power of 1/length. The norm is taken in coordinates in which products are short (`adapted` in `contractions.py`).
*Pieces*: a product is lengthened only while its norm is not below {RADIUS} to the power of its length. All products end, the
longest with the length in the table, so that each long product consists of such pieces."""


def products(length):
    count, lower, upper = radius_bounds(contracted(), length)
    return [str(count), number(lower), number(upper)]


def pieces():
    count, length = radius_cut(contracted(), RADIUS)
    return [f"{count} of up to {length}", "-", number(RADIUS)]


FACES = VALUES + ["(24)", "l5", "l10", "stars", "spread"] + MAP
FACE_TEXT = """Around a vertex inside the face of two control tetrahedra, in twelve random pairs."""
VERTEX_TEXT = f"""Around input vertices in {SAMPLES} random stars for each valence: random directions and lengths, all neighbours on
their convex hull, the vertex well inside. Maps are sampled in the first {MAPS} stars, where (24) holds."""


def without_map(page):
    """The triangulations in which (24) holds, and whose map is not regular or not injective."""
    titles = ("(24)", "regular", "injective")
    found = [pages.column(page, "Around vertices, each triangulation", title) for title in titles]
    return [key for key in found[0] if found[0][key] == "yes" and "no" in (found[1][key], found[2][key])]


def random_maps(page):
    """The valences of the random stars of which one has (24) and no such map."""
    return [int(key) for key, text in pages.column(page, "Around vertices, random", "regular and injective").items()
            if not pages.is_all(text)]


def counts(page, valences):
    held = pages.column(page, "Around vertices, random", "(24) holds")
    return {held[str(valence)] for valence in valences}


BOX_CLAIMS = [
    ("Here it fails for every star of valence 4 and of 5, and for some of 7.",
     lambda page: counts(page, (4, 5)) == {f"0 of {SAMPLES}"} and not pages.is_all(*counts(page, [7]))
     and all(pages.is_all(text) for text in counts(page, set(RANDOM) - {4, 5, 7}))
     and pages.holds_for(page, "Around vertices, each triangulation", "(24)", "no") == ["4.a", "5.a", "7.b"]),
    ("Here (24) fails along edges of 8 and more tetrahedra, if all of them mark the edge.",
     lambda page: pages.holds_for(page, "Along edges that all tetrahedra mark", "(24)", "no") == ["8", "9", "10"]),
    ("Where two tetrahedra mark different edges of their face l1 is .5121, and l4 is larger than the square of l1",
     lambda page: pages.column(page, "Across faces", "l1")["different edges"] == "0.5121"
     and float(pages.column(page, "Across faces", "l4")["different edges"]) > .5121 ** 2),
    ("6.a, 7.a, 7.c, 8.a, 8.b, 8.c, 8.d and 8.g have a characteristic map that is not regular or not injective",
     lambda page: without_map(page) == "6.a 7.a 7.c 8.a 8.b 8.c 8.d 8.g".split()),
    ("Most have .2500 as l4; 6.a has it as l3.",
     lambda page: len(pages.holds_for(page, "Around vertices, each triangulation", "l4", "0.2500")) > 12
     and pages.column(page, "Around vertices, each triangulation", "l3")["6.a"] == "0.2500"),
    ("Of the random stars some of valence 6 have such a map, and none of 8 and more.", lambda page: random_maps(page) == [6]),
]
TET_OCT_CLAIMS = [
    ("Along an edge of 3 tetrahedra the eigenvalues meet the condition",
     lambda page: pages.column(page, "Along edges", "(24)")["3"] == "yes"),
    ("from 11 on the condition fails.",
     lambda page: pages.holds_for(page, "Along edges", "(24)", "no") == ["11"]),
    ("it is between .1367 and .1617, so that the limit is C^2 across faces.",
     lambda page: set(pages.column(page, "Products across faces", "lower bound").values()) == {"0.1367", "-"}
     and pages.column(page, "Products across faces", "upper bound")["pieces"] == "0.1617"),
    ("Here the map of the triangulation 8.g folds, although (24) holds; all other triangulations of up to 8 vertices pass.",
     lambda page: without_map(page) == ["8.g"]
     and pages.holds_for(page, "Around vertices, each triangulation", "(24)", "no") == []),
    ("Of the random stars one of valence 11 has a map that is not regular or not injective.",
     lambda page: random_maps(page) == [11]),
]


def make_pages():
    box = Page("BoxSpline", "Spectra of the box spline for solids", """
Is the limit of the box spline smooth around a vertex, along an edge and across a face of control tetrahedra? The tables have
the eigenvalues of one step there: see [how](README.md). Condition (24) is 1 > l1 >= l2 >= l3 > l4, an empirical one.

**Different from the paper.** [CQ] says that (24) holds but for very small valences, 4 in particular. Here it fails
for every star of valence 4 and of 5, and for some of 7. [CQ] says that along edges C^1 can be proved as for surfaces.
Here (24) fails along edges of 8 and more tetrahedra, if all of them mark the edge. [CQ] does not treat faces. Where two
tetrahedra mark different edges of their face l1 is .5121, and l4 is larger than the square of l1. So the object is not C^2
there.

**The condition is not enough.** Of the triangulations with 6 to 8 vertices, 6.a, 7.a, 7.c, 8.a, 8.b, 8.c, 8.d and 8.g have a
characteristic map that is not regular or not injective, although (24) holds. Most have .2500 as l4; 6.a has it as l3. Of
the random stars some of valence 6 have such a map, and none of 8 and more.
""", [
        LATTICE,
        Table("Across faces", FACE_TEXT, ["marks"] + FACES,
              [Row("the same edge of the face", lambda: face(BOX_SPLINE, True)),
               Row("different edges", lambda: face(BOX_SPLINE, False))], hidden=["l5", "l10", "stars", "spread", "samples"]),
        Table("Along edges that all tetrahedra mark", "Around the middle of a long edge of *n* tetrahedra.",
              ["n"] + VALUES + ["(24)"] + MAP, [Row(str(n), lambda n=n: edge(BOX_SPLINE, n, 3.)) for n in range(3, 11)],
              keys=["3", "4", "7", "8", "10"], hidden=["samples"]),
        Table("Along edges that no tetrahedron marks", "The same for a short edge.",
              ["n"] + VALUES + ["(24)"] + MAP, [Row(str(n), lambda n=n: edge(BOX_SPLINE, n, .2)) for n in range(3, 11)],
              keys=["3", "4", "7", "10"], hidden=["samples"]),
        triangulation_table(BOX_SPLINE, "Each triangulation of the sphere with 4 to 8 vertices as the link of the vertex, "
                            "in one position. Marks of edges depend on the position, and eigenvalues on the marks."),
        random_table(BOX_SPLINE, VERTEX_TEXT, "BoxSpline.png")],
        lambda made: plots.gaps("BoxSpline", made["Around vertices, random"]), BOX_CLAIMS)
    tet_oct = Page("TetOct", "Spectra of the tet/oct scheme", """
The same as for the [box spline](BoxSpline.md), whose page says what the tables have, and has the lattice of both schemes. [SHW]
has the same condition along edges and around vertices: l1, l2 and l3 are larger than all others.

**Different from the paper.** Along an edge of 3 tetrahedra the eigenvalues meet the condition; the paper found no proof there,
and saw deformations that do not look smooth. It looked at 3 to 10 tetrahedra along an edge; from 11 on the condition fails.
Across faces [SHW] prints .238 as the joint spectral radius, which is below 1/4, as C^2 needs. Products of several
steps show that the radius is smaller: it is between .1367 and .1617, so that the limit is C^2 across faces.
[SHW] reports that all stars of 4 to 10 tetrahedra or neighbours pass, with their characteristic maps. Here the map of the
triangulation 8.g folds, although (24) holds; all other triangulations of up to 8 vertices pass. Of the random stars one of
valence 11 has a map that is not regular or not injective.
""", [
        Table("Across faces", "This scheme has no marks; the rows are the pairs of the other page.",
              ["marks"] + FACES,
              [Row("the same edge of the face", lambda: face(TET_OCT, True)),
               Row("different edges", lambda: face(TET_OCT, False))], hidden=["l5", "l10", "stars", "spread", "samples"]),
        Table("Products across faces", PRODUCTS, ["length", "products", "lower bound", "upper bound"],
              [Row(str(length), lambda length=length: products(length)) for length in range(1, 6)] +
              [Row("pieces", pieces)]),
        Table("Along edges", "Around the middle of an edge of *n* tetrahedra. The pair belongs to the plane across the edge.",
              ["n"] + VALUES + ["(24)", "pair"] + MAP, [Row(str(n), lambda n=n: tet_oct_edge(n)) for n in range(3, 12)],
              keys=["3", "4", "7", "10", "11"], hidden=["samples"]),
        triangulation_table(TET_OCT, "Positions do not matter."),
        random_table(TET_OCT, "", "TetOct.png")],
        lambda made: plots.gaps("TetOct", made["Around vertices, random"]), TET_OCT_CLAIMS)
    return [box, tet_oct]
