# SPDX-License-Identifier: BSD-3-Clause
"""Jumps of first derivatives around a vertex or a face of fine meshes of surfaces, and how fast they have to fall."""

import dataclasses

import numpy as np
from surface_maps import Local, star, straight
from surface_matrices import FOUR_EIGHT, SQRT_THREE, quad_matrix, triangle_matrix
from surface_tools import add, coordinates, faces_of, mesh, point_array, quad_star, run, spectrum, wheel
from surfaces import DOO_SABIN, MIDEDGE, dual_matrix
from vtkmodules.util.numpy_support import vtk_to_numpy

LEVELS = (2, 4, 6, 8)
DEEP = (16, 32, 64)
SEEDS = 25
RINGS = 5  # of a level that are kept: enough for what the next one has around the vertex
DUAL = (DOO_SABIN, MIDEDGE)
NOISE = 1e-12  # jumps below are rounding
TWO_STEPS = (SQRT_THREE, FOUR_EIGHT, MIDEDGE)  # whose meshes look alike after two steps


@dataclasses.dataclass
class Measured:
    """Of several random meshes: jumps by level, how they have to fall, and of which eigenvalues and maps promise it."""
    jumps: dict
    expected: np.ndarray
    smooth: np.ndarray
    noise: float = NOISE

    def rates(self):
        """The factor for each level between the two deepest levels, one twice the other, that rounding leaves alone."""
        found = np.full(len(self.expected), np.nan)
        for level in sorted(self.jumps):
            if level // 2 in self.jumps:
                here, before = self.jumps[level], self.jumps[level // 2]
                found = np.where(here > self.noise, (here / before) ** (2 / level), found)
        return found

    def falling(self, level, before):
        """How many of those that have to fall do; none that is left, if it is no more than rounding."""
        here, there = (self.jumps.get(one, np.zeros(len(self.smooth))) for one in (level, before))
        return int(((here < there) | (here < self.noise))[self.smooth].sum())


def gradient_jumps(points, values, cells, turn=None, slope=0.):
    """For each of several positions (points, seeds, coordinates) with values (points, seeds): the largest difference
    between gradients of linear functions on cells, by their largest length. Gradients are first turned by a matrix, and lengths
    are those with a slope that was taken from the values."""
    points, values = np.moveaxis(points, 1, 0), np.moveaxis(values, 1, 0)
    edges = points[:, cells[:, 1:]] - points[:, cells[:, :1]]
    rises = values[:, cells[:, 1:]] - values[:, cells[:, :1]]
    gradients = np.linalg.solve(edges, rises[..., None])[..., 0]
    if turn is not None:
        gradients = np.einsum("sij,scj->sci", turn, gradients)
    spread = np.linalg.norm(gradients[:, :, None] - gradients[:, None], axis=3).max(axis=(1, 2))
    return spread / np.linalg.norm(gradients + slope, axis=2).max(axis=1)


# ------------------------------------------------------------ levels of which only what is near is kept


def near(made, middle, rings):
    """The faces up to so many rings around vertices, with the cells on them and all arrays of points."""
    ids = vtk_to_numpy(made.GetPolys().GetConnectivityArray())
    ends = vtk_to_numpy(made.GetPolys().GetOffsetsArray())
    reached = np.zeros(made.GetNumberOfPoints(), dtype=bool)
    reached[middle] = True
    for _ in range(rings):
        at = np.logical_or.reduceat(reached[ids], ends[:-1])
        reached[ids[np.repeat(at, np.diff(ends))]] = True
    kept = np.flatnonzero(reached)
    renamed = np.cumsum(reached) - 1

    def parts(array):
        ids, ends = (vtk_to_numpy(one) for one in (array.GetConnectivityArray(), array.GetOffsetsArray()))
        inside = np.logical_and.reduceat(reached[ids], ends[:-1]) if len(ids) else []
        return [renamed[ids[a:b]].tolist() for a, b, yes in zip(ends, ends[1:], inside) if yes]

    lines, verts = parts(made.GetLines()), parts(made.GetVerts())
    faces = [renamed[ids[a:b]].tolist() for a, b, yes in zip(ends, ends[1:], at) if yes]
    cut = mesh(coordinates(made)[kept], faces, lines, verts)
    if lines or verts:
        add(cut.GetCellData(), "Singular", np.array([1] * len(lines + verts) + [0] * len(faces), dtype=np.int32))
    add(cut.GetPointData(), "x", point_array(made, "x")[kept])
    return cut, renamed[middle]


def middle_of(made, scheme, k):
    """Vertex 0; of dual schemes the corners of the face of k corners in the middle."""
    if scheme not in DUAL:
        return [0]
    return min((face for face in faces_of(made) if len(face) == k),
               key=lambda face: np.linalg.norm(coordinates(made)[face].mean(axis=0)))


def control_mesh(scheme, k, kind):
    if scheme in DUAL or scheme == FOUR_EIGHT:
        return quad_star(k, 2 * np.pi, True, 3)
    return star(scheme, k, kind)[0] if scheme != SQRT_THREE else straight(wheel(k, 3), k, 2 * np.pi, True)


def sides(made, middle, kind):
    """The triangles at corners of faces in the middle; on each side of a crease, which lies on the x axis."""
    triangles = np.array([[vertex, face[(at + 1) % len(face)], face[at - 1]]
                          for face in faces_of(made) for at, vertex in enumerate(face) if vertex in middle])
    if kind != "crease":
        return [triangles]
    above = coordinates(made)[triangles, 1].mean(axis=1) > 0
    return [triangles[above], triangles[~above]]




def jumps_by_level(scheme, k, kind="interior", **options):
    """From levels to the jumps around the middle of random heights over random plane meshes, one for each seed. All are
    arrays of one mesh, which has the angles of corners."""
    made = control_mesh(scheme, k, kind)
    values = np.repeat(coordinates(made)[:, None], SEEDS, axis=1)
    for seed in range(SEEDS):
        random = np.random.RandomState(1000 * seed + k)
        values[:, seed, :2] += random.uniform(-.15, .15, (len(values), 2)) * min(1, 6 / k)
        values[:, seed, 2] = random.uniform(-1, 1, len(values))
    add(made.GetPointData(), "x", values.reshape(len(values), -1))
    found = {}
    for level in range(1, DEEP[-1] + 1):
        made = run(made, scheme, 2 if scheme in TWO_STEPS else 1, **options)
        made, middle = near(made, middle_of(made, scheme, k), RINGS)
        # Around the middle, so that nothing is lost to rounding, and with as large a mesh as before.
        for array in (point_array(made, "x"), coordinates(made)):
            array -= array[middle].mean(axis=0)
        coordinates(made)[:] *= 3 / np.linalg.norm(coordinates(made), axis=1).max()
        if level in LEVELS + DEEP:
            x = point_array(made, "x").reshape(-1, SEEDS, 3)
            found[level] = np.max([gradient_jumps(x[..., :2], x[..., 2], side) for side in sides(made, middle, kind)], axis=0)
            if found[level].max() < NOISE:
                break
    return found


def measure(scheme, k, kind="interior", **options):
    expected = expected_rate(scheme, k, kind, **options)
    return Measured(jumps_by_level(scheme, k, kind, **options), np.full(SEEDS, expected), np.full(SEEDS, expected < 1 - 1e-6))


# ------------------------------------------------------------ how they have to fall


def needed(matrix, first):
    """The eigenvalues, by absolute value, of what a step does to some points and to all that they depend on."""
    at = np.zeros(len(matrix), dtype=bool)
    at[first] = True
    while True:
        more = at | (abs(matrix[at]) > 1e-12).any(axis=0)
        if (more == at).all():
            return spectrum(matrix[np.ix_(at, at)])
        at = more


def behind_tangents(values, along=None):
    """The ratio of the first eigenvalue behind the tangents to the last of the tangents, of which a curve has one."""
    rest = list(values[1:]) + [0., 0.]
    if along is not None:
        rest.remove(min(rest, key=lambda value: abs(value - along)))
        rest.insert(0, along)
    return rest[2] / min(rest[:2])


def expected_rate(scheme, k, kind="interior", **options):
    if scheme in DUAL:  # second derivatives around a face are quartered
        values = dual_matrix(scheme, k, 2 if scheme == MIDEDGE else 1)
        return behind_tangents(spectrum(values)[:3] + [max((spectrum(values) + [0.])[3], 1 / 4)])
    if scheme == SQRT_THREE:
        return behind_tangents(spectrum(triangle_matrix(wheel(k), k, True)))
    if scheme == FOUR_EIGHT:
        places, matrix = quad_matrix(quad_star(k, 2 * np.pi, True), k, True)
        return behind_tangents(needed(matrix, [i for i, place in enumerate(places) if max(place[1:]) < 2]))
    side = "boundary" if kind == "crease" else kind
    local = Local(scheme, k, side, **options)
    ring = {vertex for face in faces_of(local.first) if 0 in face for vertex in face}
    return behind_tangents(needed(local.matrix, np.isin(local.here, list(ring))), None if kind == "interior" else 1 / 2)
