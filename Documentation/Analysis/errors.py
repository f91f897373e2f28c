# SPDX-License-Identifier: BSD-3-Clause
"""Errors of curves, surfaces and solids whose limits follow a smooth function, by steps of the control mesh."""

import functools

import numpy as np
from solid_maps import BOX_SPLINE, TET_OCT, add, edge_star, hull, point_array, solid, subdivide, vertex_star
from surface_maps import straight
from surface_matrices import FOUR_EIGHT, SQRT_THREE
from surface_tools import CATMULL_CLARK, LOOP, coordinates, faces_of, lines_of, mesh, quad_star, run, wheel
from surfaces import BUTTERFLY, DOO_SABIN, MIDEDGE

LIMIT = {"InterpolatePoints": True, "ProjectToLimit": True}
OF_QUADS = (CATMULL_CLARK, DOO_SABIN, MIDEDGE, FOUR_EIGHT)
TWO_STEPS = (SQRT_THREE, MIDEDGE, FOUR_EIGHT)
WITHOUT_INTERPOLATION = (MIDEDGE, FOUR_EIGHT)
CORRECTIONS = 2  # instead of it


def wave(x, y):
    return np.sin(1.3 * x + .4) * np.cos(1.1 * y - .3)


def wave_slopes(x, y):
    return np.stack([1.3 * np.cos(1.3 * x + .4) * np.cos(1.1 * y - .3), -1.1 * np.sin(1.3 * x + .4) * np.sin(1.1 * y - .3)])


def bell(x, y):
    return 1 / (1 + x ** 2 + .3 * x + .5 * y ** 2)


def bell_slopes(x, y):
    return -bell(x, y) ** 2 * np.stack([2 * x + .3, y])


FUNCTIONS = {"wave": (wave, wave_slopes), "bell": (bell, bell_slopes)}


def volume_wave(points):
    x, y, z = points.T
    return wave(x, y) * np.cos(.7 * z + .2)


def volume_bell(points):
    x, y, z = points.T
    return 1 / (1 + x ** 2 + .3 * x + .5 * y ** 2 + .7 * z ** 2 - .2 * y * z)


def size(off):
    """The largest error, and the root of the mean square."""
    return off.max(), np.sqrt((off ** 2).mean())


# ------------------------------------------------------------ surfaces and curves


def sampled(made, scheme, levels, function):
    """The control mesh so many levels later whose limit follows a function over the limit of the plane mesh, and the options
    by which a filter makes it."""
    if scheme in WITHOUT_INTERPOLATION:
        finer = run(made, scheme, levels)
        points = coordinates(finer).copy()
        points[:, 2] = function(points[:, 0], points[:, 1])
        for _ in range(CORRECTIONS):
            x, y, z = coordinates(run(mesh(points, faces_of(finer)), scheme, 0, ProjectToLimit=True)).T
            points[:, 2] += function(x, y) - z
        return mesh(points, faces_of(finer)), {"ProjectToLimit": True}
    # Limits of points of the same plane surface at each step: interpolation finds this surface again. Butterfly
    # interpolates by itself, and its points are on the limit.
    finer = run(made, scheme, levels, **({} if scheme == BUTTERFLY else {"ProjectToLimit": True}))
    points = coordinates(finer).copy()
    points[:, 2] = function(points[:, 0], points[:, 1])
    return mesh(points, faces_of(finer)), {} if scheme == BUTTERFLY else LIMIT


def inner(out):
    return np.hypot(*coordinates(out)[:, :2].T) < 1


@functools.lru_cache(maxsize=None)
def surface_errors(scheme, k, name):
    """Errors of values and of slopes around a vertex, or in a face, of k, up to one edge of the first mesh from it, by
    steps (of some schemes two levels each)."""
    made = quad_star(k, 2 * np.pi, True) if scheme in OF_QUADS else straight(wheel(k), k, 2 * np.pi, True)
    function, slopes = FUNCTIONS[name]
    values, gradients = [], []
    for step in range(1, 5 - (scheme == SQRT_THREE)):
        control, options = sampled(made, scheme, step * (2 if scheme in TWO_STEPS else 1), function)
        out = run(control, scheme, 2, GenerateLimitNormals=True, **options)
        at = inner(out)
        normals = point_array(out, "LimitNormals")[at].T
        x, y, z = coordinates(out)[at].T
        gradients.append(size(np.linalg.norm(-normals[:2] / normals[2] - slopes(x, y), axis=0)))
        if scheme == BUTTERFLY:  # whose points of two levels are too near to where it interpolates
            out = run(control, scheme, 4)
            x, y, z = coordinates(out)[inner(out)].T
        values.append(size(abs(z - function(x, y))))
    return values, gradients


@functools.lru_cache(maxsize=None)
def curve_errors(ratio, name):
    """The same of values for a polyline whose lengths alternate by a ratio."""
    x = np.cumsum([-3] + [2 / (1 + ratio) * (ratio if i % 2 else 1) for i in range(6)])
    made = mesh(np.column_stack([x, 0 * x, 0 * x]), [], lines=[range(len(x))])
    found, function = [], FUNCTIONS[name][0]
    for step in range(1, 5):
        finer = run(made, LOOP, step, ProjectToLimit=True)
        points = coordinates(finer).copy()
        points[:, 2] = function(points[:, 0], 0)
        out = coordinates(run(mesh(points, [], lines=lines_of(finer)), LOOP, 2, **LIMIT))
        inside = abs(out[:, 0]) < 1
        found.append(size(abs(out[inside, 2] - function(out[inside, 0], 0))))
    return found


# ------------------------------------------------------------ solids

CORNERS = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
GOLDEN = (1 + np.sqrt(5)) / 2
RINGS = {  # neighbours of a vertex, on a sphere
    4: CORNERS / np.sqrt(3), 6: np.concatenate([np.eye(3), -np.eye(3)]),
    12: np.array([np.roll([0, a, b * GOLDEN], i) for i in range(3) for a in (1, -1) for b in (1, -1)]) / np.hypot(1, GOLDEN)}
HEIGHTS = {BOX_SPLINE: .95, TET_OCT: 1.}  # of edges; those of the box spline are marked


def solid_mesh(scheme, kind, count):
    """(mesh, the first level that is sampled, the distance from the origin up to which it is)."""
    if kind == "lattice":
        return solid(CORNERS * 2, [[0, 1, 3, 2]]), 3, .4
    if kind == "edge":
        return edge_star(count, HEIGHTS[scheme]), 1, .3
    return vertex_star(RINGS[count], hull(RINGS[count])), 1, .3


@functools.lru_cache(maxsize=None)
def solid_errors(scheme, kind, count=0):
    """The errors of two functions; control values are not solved for, but get back what the limit takes from them."""
    made, first, reach = solid_mesh(scheme, kind, count)
    found = [], []
    for level in range(first, first + 4):
        control = subdivide(made, scheme, level)
        here, there = (coordinates(one) for one in (control, subdivide(control, scheme, 0, ProjectToLimit=True)))
        wanted = np.stack([volume_wave(there), volume_bell(there)], axis=1)
        values = np.stack([volume_wave(here), volume_bell(here)], axis=1)
        add(control.GetPointData(), "f", values)
        values = values + wanted - point_array(subdivide(control, scheme, 0, ProjectToLimit=True), "f")
        add(control.GetPointData(), "f", values)
        out = subdivide(control, scheme, 1, ProjectToLimit=True)
        x = coordinates(out)
        inside = np.linalg.norm(x, axis=1) < reach
        for errors, value, function in zip(found, point_array(out, "f").T, (volume_wave, volume_bell)):
            errors.append(size(abs(value - function(x))[inside]))
    return found
