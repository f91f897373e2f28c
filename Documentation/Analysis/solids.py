# SPDX-License-Identifier: BSD-3-Clause
"""Pages on volume schemes: eigenvalues and condition (24) on the lattice, across faces, along edges, around vertices."""

import functools

import numpy as np
import plots
from contractions import radius_bounds, radius_cut
from pages import Page, Row, Table, number, yes
from solid_maps import (BOX_SPLINE, TET_OCT, code, coordinates, edge_matrix, face_matrices, is_smooth, moduli, random_star,
                        solid, star_matrix, subdivide, vertex_matrix)

COUNTS = {4: 1, 5: 1, 6: 2, 7: 5, 8: 14}  # triangulations of the sphere with so many vertices
RANDOM = [*range(4, 21), 24, 28, 32, 36, 40]
SAMPLES = 25
VALUES = ["l1", "l2", "l3", "l4"]


def texts(values):
    return [number(value) for value in values[:4]] + [yes(is_smooth(values))]


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
        same, matrices = face_matrices(random, scheme)
        found.setdefault(same, []).extend(matrices)
    return found


def face(scheme, same):
    matrices = faces(scheme)[same]
    all_values = [moduli(matrix, 12) for matrix in matrices]
    spread = max(abs(np.array(values) - all_values[0]).max() for values in all_values)
    return texts(all_values[0]) + [number(all_values[0][4]), number(all_values[0][9]), str(len(matrices)), number(spread, 6)]


def edge(scheme, n, height):
    return texts(moduli(edge_matrix(n, scheme, height)))


def tet_oct_edge(n):
    values = moduli(edge_matrix(n, TET_OCT, 1.))
    return texts(values) + [number(values[1 if n < 6 else 0], 5)]  # the value along the edge is 1/2


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
    return [degrees(triangles)] + texts(values)


def random_vertices(scheme, valence):
    random = np.random.RandomState(100 + valence)
    found = [moduli(vertex_matrix(*random_star(random, valence), scheme)) for _ in range(SAMPLES)]
    gaps = [values[2] - values[3] for values in found]
    return [f"{sum(map(is_smooth, found))} of {SAMPLES}", number(min(gaps)), number(max(gaps)),
            number(max(values[0] for values in found))]


def random_table(scheme, text, plot):
    return Table("Around vertices, random", text, ["valence", "(24) holds", "least l3 - l4", "largest l3 - l4", "largest l1"],
                 [Row(str(n), lambda n=n: random_vertices(scheme, n), n in (4, 5, 6, 7, 8, 12)) for n in RANDOM],
                 plot, "Largest and least l3 - l4 by valence; the condition holds above zero.")


def triangulation_table(scheme, text):
    names = [f"{valence}.{chr(ord('a') + i)}" for valence, count in COUNTS.items() for i in range(count)]
    return Table("Around vertices, each triangulation", text, ["valence and case", "degrees in the link"] + VALUES + ["(24)"],
                 [Row(name, lambda name=name: triangulation(scheme, name)) for name in names])


LATTICE = Table("The lattice", "Inside a control tetrahedron, where the mesh is a lattice from the first levels on: "
                "1/2 three times and 1/4 six times, as of a C^2 scheme.",
                ["scheme", "l1", "l3", "l4", "l9", "l10"],
                [Row("box spline", lambda: lattice(BOX_SPLINE)), Row("tet/oct", lambda: lattice(TET_OCT))])

RADIUS = 0.1617  # what products of pieces show it to be below
PRODUCTS = f"""The test of [SHW], appendix A. Two triangles of the face, of a tetrahedron and an octahedron on each side, have four
quarters of the same kind. For each there is a matrix of what a step does to the 40 vertices of all solids that touch the
two. All four keep a space of ten functions with the values 1, 1/2 three times and 1/4 six times, and of its quadratic
part as many are odd in the direction across the face as of polynomials. What the matrices do to the rest has to shrink
faster than 1/4 for each step in all products. Of all products of a length, the largest spectral radius bounds the joint one
from below and the largest norm from above, both to the power of 1/length. The norm is that of coordinates in
which products are short (`adapted` in `contractions.py`). *Pieces*: products are lengthened only as long as their norm is
not below {RADIUS} to the power of their length. All end, the longest with the length that is given, so that each long product
consists of such pieces.

The .1367 belongs to vertices one ring farther away than the solids at one vertex of the face, whose values are in the table
above."""


def products(length):
    count, lower, upper = radius_bounds(length)
    return [str(count), number(lower), number(upper)]


def pieces():
    count, length = radius_cut(RADIUS)
    return [f"{count} of up to {length}", "-", number(RADIUS)]


FACES = VALUES + ["(24)", "l5", "l10", "stars", "spread"]
FACE_TEXT = """Around a vertex inside the face that two control tetrahedra share, of twelve random pairs; the spread is the
largest difference between the stars."""
VERTEX_TEXT = f"""Around input vertices in the middle of {SAMPLES} random stars for each valence: random directions and lengths, all neighbours on their
convex hull, and the vertex well inside."""


def make_pages():
    box = Page("BoxSpline", "Spectra of the box spline for solids", """
Eigenvalues of what one step does around a vertex, along an edge and across a face of control tetrahedra, read off what the
filter makes: see [how](README.md). Condition (24) is 1 > l1 >= l2 >= l3 > l4. It is the paper's, which calls it empirical.

**Different from the paper.** [CQ] says that (24) holds but for very small valences, 4 in particular. Here it fails
for every star of valence 4 and of 5, and for some of 7. [CQ] says that along edges C^1 can be proved as for surfaces.
Here (24) fails along edges of 8 and more tetrahedra, if all of them mark the edge. [CQ] does not treat faces. Where two
tetrahedra mark different edges of their face l1 is .5121, and l4 is larger than the square of l1, so that the object
is not C^2 there.
""", [
        LATTICE,
        Table("Across faces", FACE_TEXT, ["marks"] + FACES,
              [Row("the same edge of the face", lambda: face(BOX_SPLINE, True)),
               Row("different edges", lambda: face(BOX_SPLINE, False))]),
        Table("Along edges that all tetrahedra mark", "Around the middle of a long edge of *n* tetrahedra.",
              ["n"] + VALUES + ["(24)"], [Row(str(n), lambda n=n: edge(BOX_SPLINE, n, 3.)) for n in range(3, 11)]),
        Table("Along edges that no tetrahedron marks", "The same for a short edge.",
              ["n"] + VALUES + ["(24)"], [Row(str(n), lambda n=n: edge(BOX_SPLINE, n, .2)) for n in range(3, 11)]),
        triangulation_table(BOX_SPLINE, "Each triangulation of the sphere with 4 to 8 vertices as the link of the vertex, "
                            "in one position. Marks of edges depend on the position, and eigenvalues on the marks."),
        random_table(BOX_SPLINE, VERTEX_TEXT, "BoxSpline.png")],
        lambda made: plots.gaps("BoxSpline", made["Around vertices, random"]))
    tet_oct = Page("TetOct", "Spectra of the tet/oct scheme", """
As for the [box spline](BoxSpline.md). The condition of the paper along edges and around vertices is that l1, l2 and l3 are
larger than all others, too.

**Different from the paper.** Along an edge of 3 tetrahedra the eigenvalues meet the condition; the paper found no proof there,
and deformations that do not look smooth. The paper looked at 3 to 10 tetrahedra along an edge; from 11 on the condition
fails. Across faces [SHW] prints .238 as the joint spectral radius, which is below 1/4, as C^2 needs. Products of several
steps show that the radius is smaller: it is between .1367 and .1617, so that the limit is C^2 across faces.
""", [
        LATTICE,
        Table("Across faces", FACE_TEXT + " This scheme has no marks; the rows are the same pairs.", ["marks"] + FACES,
              [Row("the same edge of the face", lambda: face(TET_OCT, True)),
               Row("different edges", lambda: face(TET_OCT, False))]),
        Table("Products across faces", PRODUCTS, ["length", "products", "lower bound", "upper bound"],
              [Row(str(length), lambda length=length: products(length)) for length in range(1, 6)] +
              [Row("pieces", pieces)]),
        Table("Along edges", "Around the middle of an edge of *n* tetrahedra. The pair belongs to the plane across the edge.",
              ["n"] + VALUES + ["(24)", "pair"], [Row(str(n), lambda n=n: tet_oct_edge(n)) for n in range(3, 12)]),
        triangulation_table(TET_OCT, "Each triangulation of the sphere with 4 to 8 vertices as the link of the vertex. "
                            "Positions do not matter."),
        random_table(TET_OCT, VERTEX_TEXT, "TetOct.png")],
        lambda made: plots.gaps("TetOct", made["Around vertices, random"]))
    return [box, tet_oct]
