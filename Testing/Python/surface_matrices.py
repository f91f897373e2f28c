# SPDX-License-Identifier: BSD-3-Clause
"""What two steps of 4-8 and of sqrt(3) do around a vertex, as matrices; and when eigenvalues are those of a smooth surface."""

import numpy as np
from surface_tools import faces_of, point_array, run, with_identity

from subdivisionobjects import vtkSurfaceSubdivision

FOUR_EIGHT = vtkSurfaceSubdivision.FOUR_EIGHT
SQRT_THREE = vtkSurfaceSubdivision.SQRT_THREE


def ring_of(faces, k):
    """The faces of vertex 0, each beginning there, in order; from one end to the other if there are ends."""
    around = {}
    for face in faces:
        if 0 in face:
            at = face.index(0)
            around[face[(at + 1) % len(face)]] = face[at:] + face[:at]
    ends = set(around) - {face[-1] for face in around.values()}
    at = min(ends or around)
    ring = []
    for _ in range(k):
        ring.append(around[at])
        at = around[at][-1]
    return ring


def find_quads(made, k, closed):
    """Two rings of quads around vertex 0: from (sector, a, b), with a to the sector's first edge, to vertices."""
    faces = [[int(v) for v in face] for face in faces_of(made)]
    near = {}
    for face in faces:
        for i in range(4):
            near.setdefault(frozenset((face[i], face[i - 1])), []).append(face)

    def cross(a, b, here):
        """Of the quad on the other side of an edge from a vertex: the vertices next to a and to b."""
        face, = (f for f in near[frozenset((a, b))] if here not in f)
        at = face.index(a)
        after = face[at - 1] if face[(at + 1) % 4] == b else face[(at + 1) % 4]
        return after, next(v for v in face if v not in (a, b, after))

    found = {}
    for s, (own, first, middle, last) in enumerate(ring_of(faces, k)):
        places = {(0, 0): own, (1, 0): first, (1, 1): middle, (0, 1): last}
        places[2, 0], places[2, 1] = cross(first, middle, own)
        places[0, 2], places[1, 2] = cross(last, middle, own)
        _, places[2, 2] = cross(middle, places[2, 1], first)
        after = (s + 1) % k if closed else s + 1
        for (a, b), vertex in places.items():
            found[(0, 0, 0) if a == b == 0 else (after, b, 0) if a == 0 else (s, a, b)] = vertex
    return found


def quad_matrix(made, k, closed, **options):
    """What two 4-8 steps do to two rings, two steps in, where all else is regular."""
    first = run(made, FOUR_EIGHT, 2, **options)
    second = run(with_identity(first), FOUR_EIGHT, 2, **options)
    here, there = (find_quads(level, k, closed) for level in (first, second))
    places = sorted(here)
    matrix = point_array(second, "e")[np.ix_([there[p] for p in places], [here[p] for p in places])]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)  # nothing from elsewhere
    return places, matrix


def triangle_matrix(made, k, closed, **options):
    """What two sqrt(3) steps do to a vertex and its neighbours."""
    first = run(made, SQRT_THREE, 2, **options)
    second = run(with_identity(first), SQRT_THREE, 2, **options)
    rings = []
    for level in (first, second):
        faces = ring_of([[int(v) for v in face] for face in faces_of(level)], k)
        rings.append([0] + [face[1] for face in faces] + ([] if closed else [faces[-1][2]]))
    matrix = point_array(second, "e")[np.ix_(rings[1], rings[0])]
    np.testing.assert_allclose(matrix.sum(axis=1), 1, atol=1e-12)
    return matrix


def is_smooth(values, along=None):
    """1 > l1 >= l2 > |l3|; on curves with that of the curve as one of the pair: else the surface folds."""
    rest = list(values[1:]) + [0.]
    assert abs(values[0] - 1) < 1e-10 and rest[0] < 1 - 1e-6
    if along is None:
        return rest[1] > rest[2] + 1e-6
    rest.remove(min(rest, key=lambda value: abs(value - along)))
    return min(along, rest[0]) > rest[1] + 1e-6
