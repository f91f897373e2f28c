# SPDX-License-Identifier: BSD-3-Clause
"""Pages on surface schemes: eigenvalues, conditions and characteristic maps by valence."""

import filter_maps
import numpy as np
import pages
import plots
from contractions import contractivity
from pages import Page, Row, Table, number, yes
from surface_maps import Local
from surface_matrices import is_smooth, quad_matrix, triangle_matrix
from surface_tools import (CATMULL_CLARK, LOOP, add, coordinates, faces_of, fan, flag_corner, mesh, point_array, quad_star, run,
                           spectrum, wheel, with_identity)

from subdivisionobjects import vtkSubdivisionSmoothness, vtkSurfaceSubdivision

BUTTERFLY = vtkSurfaceSubdivision.MODIFIED_BUTTERFLY
DOO_SABIN = vtkSurfaceSubdivision.DOO_SABIN
MIDEDGE = vtkSurfaceSubdivision.MIDEDGE
MAP = ["regular", "injective", "triangles sampled"]
SHOWN = ["3", "4", "6", "50"]  # of rows up to 50
FEW = ["4", "6", "12"]  # of rows up to 12


def loop_value(k):
    return 3 / 8 + np.cos(2 * np.pi / k) / 4


def catmull_clark_value(k):
    c = np.cos(2 * np.pi / k)
    return (5 + c + np.sqrt((c + 9) * (c + 1))) / 16


def sqrt_three_value(k):
    return 4 / 9 * np.cos(np.pi / k) ** 2  # of two steps


def butterfly_value(k):
    return 1 / 2


def midedge_value(k):
    return np.cos(np.pi / k) ** 2  # of two steps


def moduli(values):
    return [number(abs(value)) for value in values[1:4]]


def is_interior(values):
    a, b, c = abs(np.array(values[1:4]))
    return a < 1 - 1e-6 and b > c + 1e-6


def interior(scheme, k, closed_form):
    local = Local(scheme, k, "interior")
    values = local.values()
    regular, injective, count = local.map()
    return moduli(values) + [number(closed_form(k)), yes(is_interior(values)), yes(regular), yes(injective), str(count)]


SPECTRUM = "Moduli of l1 and l3 by the number of faces; the condition holds where the lines keep apart."


def interior_table(scheme, closed_form, name):
    return Table(
        "Inside", "Vertices with *k* faces around them. The condition is 1 > l1 >= l2 > |l3|. The file has the closed form "
        "of l1, too.",
        ["k", "l1", "l2", "l3", "closed form", "condition (23)"] + MAP,
        [Row(str(k), lambda k=k: interior(scheme, k, closed_form)) for k in range(3, 51)],
        f"{name}.png", SPECTRUM, SHOWN, ["closed form", "triangles sampled"])


def sector(scheme, k, kind, **options):
    local = Local(scheme, k, kind, **options)
    values = local.values()
    smooth = is_smooth(np.abs(values), 1 / 2)
    if not smooth:
        return moduli(values) + [yes(smooth), "-", "-", "-"]
    regular, injective, count = local.map()
    return moduli(values) + [yes(smooth), yes(regular), yes(injective), str(count)]


def sector_table(scheme, kind, title, text, first, keys, **options):
    return Table(title, text, ["k", "l1", "l2", "l3", "condition"] + MAP,
                 [Row(str(k), lambda k=k: sector(scheme, k, kind, **options)) for k in range(first, 51)],
                 keys=keys, hidden=["triangles sampled"])


def crease(scheme, k):
    values = Local(scheme, k, "crease").values()
    own = Local(scheme, k, "boundary").values()
    # One value of the curve serves both sides, each side has all others.
    expected = sorted([1, .5] + 2 * [abs(v) for v in own[2:5]], reverse=True)[:6]
    off = 0 if k == 1 else max(abs(abs(np.array(values[:4])) - expected[:4]))
    return [number(abs(value)) for value in values[1:5]] + [yes(abs(values[3]) > abs(values[4]) + 1e-6), number(off, 9)]


def crease_table(scheme):
    return Table("Creases", "*k* faces on each side of a crease. One eigenvalue 1/2 belongs to the curve and one to each "
                 "side; the condition is that all others are smaller. The last column is how far the leading eigenvalues are from "
                 "those of two boundaries with *k* faces.",
                 ["k", "l1", "l2", "l3", "l4", "condition", "off two boundaries"],
                 [Row(str(k), lambda k=k: crease(scheme, k)) for k in range(2, 51)], keys=["2", "8", "50"])


SECTORS = """Vertices on a boundary, with *k* faces, by the rule of the survey (*ModifiedBoundary* on). One of l1 and l2 belongs
to the curve and is 1/2. The condition is that both are larger than |l3|."""


def sectors(scheme):
    return [
        sector_table(scheme, "boundary", "Boundaries", SECTORS, 2, ["2", "4", "8", "50"]),
        sector_table(scheme, "boundary", "Boundaries by the plain rule", "The same with *ModifiedBoundary* off. Where the "
                     "condition fails there is no characteristic map.", 2, SHOWN, ModifiedBoundary=False),
        crease_table(scheme),
        sector_table(scheme, "convex", "Convex corners", "Corners of 90 degrees with *k* faces.", 1, []),
        sector_table(scheme, "concave", "Concave corners", "Corners of 270 degrees with *k* faces. Flatness lowers l3 to 1/4.",
                     2, [])]


# ------------------------------------------------------------ schemes whose steps turn the mesh, and dual schemes

def sqrt_three(k):
    values = spectrum(triangle_matrix(wheel(k), k, True))
    a = (4 - 2 * np.cos(2 * np.pi / k)) / 9
    expected = sorted([1, (2 / 3 - a) ** 2] + [4 / 9 * np.cos(np.pi * m / k) ** 2 for m in range(1, k)], reverse=True)
    return moduli(values) + [number(max(abs(np.array(values) - expected)), 6), yes(is_interior(values))] + filter_maps.columns(
        wheel(k), "SQRT_THREE", [0], values[1:3])


def sqrt_three_differences(rings, steps, printed):
    points, differences, norm, radius = contractivity(rings, steps)
    return [str(rings), str(points), str(differences), number(norm), number(radius), yes(norm < 1), printed]


TURNED = {"boundaries": np.pi, "boundaries, plain rule": np.pi, "convex corners": np.pi / 2, "concave corners": 1.5 * np.pi}


KEYS_OF_CORNERS = {"convex corners": [], "concave corners": ["2", "6", "12"]}


def turned_sector(scheme, kind, k):
    """A sector of sqrt(3) or 4-8."""
    options = {"ModifiedBoundary": False} if "plain" in kind else {}
    made = fan(k, TURNED[kind]) if scheme == "SQRT_THREE" else quad_star(k, TURNED[kind], False)
    made = flag_corner(made) if "corners" in kind else made
    matrix, along = (triangle_matrix(made, k, False, **options), 1 / 3) if scheme == "SQRT_THREE" else (
        quad_matrix(made, k, False, **options)[1], 1 / 2)
    values = spectrum(matrix)
    return moduli(values) + [yes(is_smooth(values, along))] + filter_maps.columns(
        made, scheme, [0], values[1:3], 0, **options)


def turned_tables(name, scheme, texts):
    return [Table(f"{name} at {kind}", text, ["k", "l1", "l2", "l3", "condition"] + filter_maps.COLUMNS,
                  [Row(str(k), lambda k=k, kind=kind: turned_sector(scheme, kind, k)) for k in range(2, 13)],
                  keys=KEYS_OF_CORNERS.get(kind, FEW), hidden=["samples"])
            for kind, text in zip(TURNED, texts)]


def four_eight(k):
    made = quad_star(k, 2 * np.pi, True)
    values = spectrum(quad_matrix(made, k, True)[1])
    return moduli(values) + [yes(is_interior(values))] + filter_maps.columns(made, "FOUR_EIGHT", [0], values[1:4])


def dual_matrix(scheme, k, steps):
    """What steps do to the corners of a face of k corners, in the middle of a mesh."""
    def middle(made):
        face, = (face for face in faces_of(made) if len(face) == k and np.linalg.norm(
            coordinates(made)[face].mean(axis=0)) < 1e-9) if k != 4 else [min(
                faces_of(made), key=lambda face: np.linalg.norm(coordinates(made)[face].mean(axis=0)))]
        return face

    first = run(quad_star(k, 2 * np.pi, True, 3), scheme, 2)
    here = middle(first)
    columns = np.zeros((first.GetNumberOfPoints(), k))
    columns[here, np.arange(k)] = 1
    add(first.GetPointData(), "e", columns)
    second = run(first, scheme, steps)
    rows = point_array(second, "e")[middle(second)]
    np.testing.assert_allclose(rows.sum(axis=1), 1, atol=1e-12)
    order = rows.argmax(axis=0)  # each new corner reads its own old one most
    assert sorted(order) == list(range(k))
    return rows[order]


def dual_map(scheme, k):
    """What vtkSubdivisionSmoothness says of the characteristic map at a face of k corners."""
    turns = 2 * np.pi * np.arange(k) / k
    probe = vtkSubdivisionSmoothness()
    probe.SetInputData(mesh(np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1), [list(range(k))]))
    probe.SetScheme(vtkSubdivisionSmoothness.LOOP + scheme)
    probe.SetSampleMaps(True)
    probe.Update()
    cells = probe.GetOutput().GetCellData()
    face = probe.GetOutput().GetNumberOfCells() - 1
    regular, injective, count = (int(cells.GetArray(name).GetComponent(face, 0))
                                 for name in ("Regular", "Injective", "Samples"))
    return ["-", "-", "-"] if regular < 0 else [yes(regular), yes(injective), str(count)]


def dual(scheme, k, steps, expected):
    values = spectrum(dual_matrix(scheme, k, steps))
    around = max((values + [0.] * 4)[3], 1 / 4)  # the faces around have second derivatives, which steps quarter
    return [number(value) for value in (values + [0.] * 4)[1:4]] + [
        number(expected(k)), yes(is_interior(values[:3] + [around]))] + dual_map(scheme, k)


DIFFERENCES = """Why sqrt(3) is C^2 on regular meshes, by the appendix of [K]. The matrix *S* of some steps acts on the points
of some rings; *J* takes their third differences along two directions of edges. *S* keeps quadratic polynomials, so that
*J S J^+* takes third differences of a mesh to third differences of the finer one (*J^+* is the pseudo-inverse). Two steps
divide lengths by 3. So the norm of this matrix (its largest singular value), times 9 for each two steps, has to be below 1.
Two steps do not show it, four do: [K] prints 0.78."""
AROUND = """The matrix takes the corners of one face. Second derivatives around the face have the eigenvalue 1/4, whatever
*k* is; the condition takes the larger one of 1/4 and l3."""
OTHERS = """Two schemes whose steps turn the mesh, sqrt(3) and 4-8: eigenvalues belong to **two** steps. Two dual schemes,
Doo-Sabin and midedge: a face repeats from step to step, not a vertex. vtkSubdivisionSmoothness samples the characteristic
maps. With *ModifiedBoundary* it holds in all sectors of 2 to 12 faces. All maps of sqrt(3) and 4-8 are regular and
injective where the condition holds. The numbers are read off what the filter makes: see [how](README.md)."""


def is_up_to(page, title, last):
    """Whether the condition holds in just the rows up to one."""
    return [int(key) for key in pages.holds_for(page, title, "condition")] == list(range(2, last + 1))


def is_all_regular(page, title):
    return all(pages.column(page, title, name)[key] == "yes" for key in pages.holds_for(
        page, title, "condition (23)") for name in ("regular", "injective"))


PLAIN = "Boundaries by the plain rule"


def is_tie(page, k):
    """Whether l2 and l3 of the plain rule are 1/2 for k faces, and the value of the curve is none of the pair for more."""
    second, third = (pages.numbers(page, PLAIN, name) for name in ("l2", "l3"))
    return second[k] == third[k] == 1 / 2 and all(second[more] > 1 / 2 for more in range(k + 1, 51))


PLAIN_CLAIMS = {
    "Loop": ("The plain rule at boundaries meets it for up to five triangles. Six are a tie at 1/2, and from seven on the limit is not C^1.",
             lambda page: is_up_to(page, PLAIN, 5) and is_tie(page, 6)),
    "CatmullClark": ("The plain rule at boundaries meets it for up to three quads. Four are a tie at 1/2, and from five on the limit is not C^1.",
                     lambda page: is_up_to(page, PLAIN, 3) and is_tie(page, 4)),
}
INSIDE_CLAIM = ("Inside, the condition holds and all maps are regular and injective.",
                lambda page: len(pages.holds_for(page, "Inside", "condition (23)")) == 48 and is_all_regular(page, "Inside"))
SURVEY_CLAIM = ("At boundaries the condition holds for all *k* by the rule of the survey.",
                lambda page: is_up_to(page, "Boundaries", 50))
CORNER_CLAIM = ("At corners of 90 and 270 degrees it holds for all *k*, too; flatness lowers l3 of the latter to 1/4.",
                lambda page: is_up_to(page, "Concave corners", 50)
                and [int(key) for key in pages.holds_for(page, "Convex corners", "condition")] == list(range(1, 51))
                and set(pages.column(page, "Concave corners", "l3").values()) == {"0.2500"})
OTHER_CLAIMS = [
    ("Two steps do not show it, four do: [K] prints 0.78.",
     lambda page: pages.column(page, "sqrt(3), third differences", "below 1") == {"2": "no", "4": "yes"}
     and pages.column(page, "sqrt(3), third differences", "norm")["4"] == "0.7728"),
    ("it holds for up to five triangles.", lambda page: is_up_to(page, "sqrt(3) at boundaries, plain rule", 5)),
    ("The condition holds for two and three faces only.", lambda page: is_up_to(page, "4-8 at boundaries, plain rule", 3)),
    ("With *ModifiedBoundary* it holds in all sectors of 2 to 12 faces.", lambda page: all(
        is_up_to(page, f"{name} at {kind}", 12) for name in ("sqrt(3)", "4-8") for kind in TURNED if "plain" not in kind)),
    ("All maps of sqrt(3) and 4-8 are regular and injective where the condition holds.",
     lambda page: all(is_all_regular(page, title) for title in ("sqrt(3) inside", "4-8 inside")) and all(
         pages.column(page, title, name)[key] == "yes"
         for title in (f"{name} at {kind}" for name in ("sqrt(3)", "4-8") for kind in TURNED)
         for key in pages.holds_for(page, title, "condition") for name in ("regular", "injective"))),
]


def spectrum_plot(title):
    """The file of the plot of a table, and its caption."""
    return f"OtherSurfaces{plots.plain(title)}.png", f"{title}. {SPECTRUM}"


def draw_others(made):
    for title in ("sqrt(3) inside", "4-8 inside", "Doo-Sabin", "Midedge"):
        plots.spectrum(f"OtherSurfaces{plots.plain(title)}", made[title], 1.05 if title == "Midedge" else 0.75)


def make_pages():
    rows = range(3, 13)
    loop = Page("Loop", "Spectra of Loop's scheme", "Is a surface of Loop's scheme smooth around a vertex of *k* "
                f"triangles? {INSIDE_CLAIM[0]} {SURVEY_CLAIM[0]} {CORNER_CLAIM[0]} {PLAIN_CLAIMS['Loop'][0]}\n\n"
                "The numbers are eigenvalues of one step around a vertex, with the vertex weights of the filter (Mathematics 5, "
                "12), read off what the filter makes: see [how](README.md).",
                [interior_table(LOOP, loop_value, "Loop")] + sectors(LOOP), lambda made: plots.spectrum("Loop", made["Inside"]),
                [INSIDE_CLAIM, SURVEY_CLAIM, CORNER_CLAIM, PLAIN_CLAIMS["Loop"]])
    catmull_clark = Page("CatmullClark", "Spectra of Catmull-Clark's scheme",
                         "The same as for [Loop](Loop.md), whose page says what the tables have, for quads. "
                         f"{INSIDE_CLAIM[0]} {SURVEY_CLAIM[0]} {CORNER_CLAIM[0]} {PLAIN_CLAIMS['CatmullClark'][0]}",
                         [interior_table(CATMULL_CLARK, catmull_clark_value, "CatmullClark")] + sectors(CATMULL_CLARK),
                         lambda made: plots.spectrum("CatmullClark", made["Inside"]),
                         [INSIDE_CLAIM, SURVEY_CLAIM, CORNER_CLAIM, PLAIN_CLAIMS["CatmullClark"]])
    butterfly = Page("Butterfly", "Spectra of the modified Butterfly scheme",
                     "The same as for [Loop](Loop.md), whose page says what the tables have. The survey's "
                     "rules are made so that l1 = l2 = 1/2 and l3 = 1/4 at every valence.",
                     [interior_table(BUTTERFLY, butterfly_value, "Butterfly"), *sectors(BUTTERFLY)[:1]],
                     lambda made: plots.spectrum("Butterfly", made["Inside"]))
    for table in catmull_clark.tables + butterfly.tables:
        table.text = ""  # Loop's page has it
    others = Page("OtherSurfaces", "Spectra of the other surface schemes", OTHERS, [
        Table("sqrt(3) inside", "Two steps. Kobbelt's equation (4), squared, gives the eigenvalues (2/3 - a)^2 and "
              "4/9 cos^2(pi m/k) for m = 1 to k - 1. No eigenvalue differs from them by more than the column says.",
              ["k", "l1", "l2", "l3", "off equation (4)", "condition (23)"] + filter_maps.COLUMNS,
              [Row(str(k), lambda k=k: sqrt_three(k)) for k in rows], *spectrum_plot("sqrt(3) inside"), FEW, ["samples"]),
        Table("sqrt(3), third differences", DIFFERENCES,
              ["steps", "rings", "points", "differences", "norm", "spectral radius", "below 1", "the paper"],
              [Row("2", lambda: sqrt_three_differences(3, 2, "-")), Row("4", lambda: sqrt_three_differences(6, 4, "0.78"))]),
        *turned_tables("sqrt(3)", "SQRT_THREE", [
            "Two steps; the eigenvalue of the curve is 1/3, and *ModifiedBoundary* makes it that of the sector, too.",
            "Kobbelt states no condition at boundaries; it holds for up to five triangles.",
            "Corners of 90 degrees.", "Corners of 270 degrees. Flatness lowers l3 to 1/9, for two triangles to 0."]),
        Table("4-8 inside", "Two steps.", ["k", "l1", "l2", "l3", "condition (23)"] + filter_maps.COLUMNS,
              [Row(str(k), lambda k=k: four_eight(k)) for k in rows], *spectrum_plot("4-8 inside"), FEW, ["samples"]),
        *turned_tables("4-8", "FOUR_EIGHT", [
            "Two steps; *ModifiedBoundary* makes both eigenvalues 1/2.",
            "The condition holds for two and three faces only.", "Corners of 90 degrees.",
            "Corners of 270 degrees. Flatness moves only the points next to the corner, so that l3 is up to 0.46."]),
        Table("Doo-Sabin", "One step, faces of *k* corners; the weights give l1 = l2 = 1/2 and l3 = 1/4. " + AROUND,
              ["k", "l1", "l2", "l3", "closed form", "condition (23)"] + MAP,
              [Row(str(k), lambda k=k: dual(DOO_SABIN, k, 1,
                                            lambda _: 1 / 2)) for k in range(3, 51)], *spectrum_plot("Doo-Sabin"),
              ["3", "4", "50"], ["closed form", "triangles sampled"]),
        Table("Midedge", "Two steps, faces of *k* corners; l1 is cos^2(pi/k). At *k* = 3 it is no larger than 1/4, "
              "and the condition fails. The matrix is as for Doo-Sabin.",
              ["k", "l1", "l2", "l3", "closed form", "condition (23)"] + MAP,
              [Row(str(k), lambda k=k: dual(MIDEDGE, k, 2,
                                            midedge_value)) for k in range(3, 51)], *spectrum_plot("Midedge"),
              ["3", "4", "6", "50"], ["closed form", "triangles sampled"])],
        draw_others, OTHER_CLAIMS)
    return [loop, catmull_clark, butterfly, others]
