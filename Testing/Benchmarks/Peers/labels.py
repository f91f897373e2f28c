# SPDX-License-Identifier: BSD-3-Clause
"""Solids from labels beside what else there is: vtkSubdivisionLabelSolid; surfaces of VTK filled by tetgen.

python3 labels.py [SIZE]   # with the package subdivisionobjects; tetgen has to be in the path

Prints a row of a table for each way: tetrahedra, the worst quality (mean ratio, 1 is best), volumes as parts of those
of the voxels, the largest distance between the interfaces and the faces of the voxels (both ways, in voxels), and
seconds of processor time for a million voxels that are no background.
"""

import os
import resource
import subprocess
import sys
import tempfile

import numpy as np
from scipy.ndimage import distance_transform_edt, label
from scipy.spatial import cKDTree
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D

import subdivisionobjects


def scan(n):
    """Soft tissue (1), bone (2) and marrow (3)."""
    z, y, x = (np.indices((n, n, n)) - (n - 1) / 2) / (n / 2)
    tissue = (x / .9) ** 2 + (y / .8) ** 2 + (z / .93) ** 2 < 1
    along = (.3 * x + .2 * y + z) / np.sqrt(1.13)
    radius = np.sqrt(np.maximum(0, x * x + y * y + z * z - along * along))
    wall = .32 + .12 * along ** 2 + .05 * np.cos(6 * along)
    bone = tissue & (radius < wall) & (abs(along) < .7)
    return tissue * 1 + bone + (bone & (radius < wall - .12) & (abs(along) < .6))


def image_of(voxels):
    image = vtkImageData()
    image.SetDimensions(*voxels.shape)
    array = numpy_to_vtk(voxels.astype(np.uint8).ravel(), deep=True)
    array.SetName("Label")
    image.GetPointData().SetScalars(array)
    return image


def seconds():
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def this_filter(voxels, levels):
    solid = subdivisionobjects.vtkSubdivisionLabelSolid()
    solid.SetInputData(image_of(voxels))
    solid.SetNumberOfControlCells(0)
    solid.SetNumberOfLevels(levels)
    solid.Update()
    grid = solid.GetOutput()
    return (vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4),
            vtk_to_numpy(grid.GetCellData().GetArray("Label")).astype(int))


def contours(voxels):
    """The surfaces of all labels, smoothed together."""
    found = vtkDiscreteFlyingEdges3D()
    found.SetInputData(image_of(voxels))
    for i in range(voxels.max()):
        found.SetValue(i, i + 1)
    return smooth(found)


def nets(voxels):
    """Interfaces with corners that stay near their voxels, where VTK has them (9.3)."""
    from vtkmodules.vtkFiltersCore import vtkSurfaceNets3D
    found = vtkSurfaceNets3D()
    found.SetInputData(image_of(voxels))
    for i in range(voxels.max()):
        found.SetValue(i, i + 1)
    found.SetOutputMeshTypeToTriangles()
    found.Update()
    return corners_and_triangles(found.GetOutput())


def smooth(surface):
    clean = vtkCleanPolyData()
    clean.SetInputConnection(surface.GetOutputPort())
    sinc = vtkWindowedSincPolyDataFilter()
    sinc.SetInputConnection(clean.GetOutputPort())
    sinc.SetPassBand(.1)
    sinc.NonManifoldSmoothingOn()
    sinc.NormalizeCoordinatesOn()
    sinc.Update()
    return corners_and_triangles(sinc.GetOutput())


def corners_and_triangles(surface):
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)[1]
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float), triangles[first]


def filled(voxels, surface):
    """By tetgen, with a seed in the middle of each part."""
    points, triangles = surface(voxels)
    seeds = []
    for material in range(1, voxels.max() + 1):
        parts, count = label(voxels == material)
        for part in range(1, count + 1):
            depth = distance_transform_edt(np.pad(parts == part, 1))[1:-1, 1:-1, 1:-1]
            seeds.append((*np.unravel_index(depth.argmax(), depth.shape)[::-1], material))
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "surface")
        with open(name + ".poly", "w", encoding="ascii") as file:
            file.write(f"{len(points)} 3 0 0\n")
            np.savetxt(file, np.c_[np.arange(len(points)), points], "%d %.17g %.17g %.17g")
            file.write(f"{len(triangles)} 0\n")
            np.savetxt(file, triangles, "1\n3 %d %d %d")
            file.write(f"0\n{len(seeds)}\n")
            np.savetxt(file, np.c_[np.arange(len(seeds)), seeds], "%d %g %g %g %d")
        subprocess.run(["tetgen", "-pq1.4AQ", name + ".poly"], check=True, stdout=subprocess.DEVNULL)
        made = np.loadtxt(name + ".1.node", skiprows=1)[:, 1:4]
        cells = np.loadtxt(name + ".1.ele", skiprows=1).astype(int)
    wanted = (cells[:, 5] > 0) & (cells[:, 5] <= voxels.max())  # others are gaps between materials
    return made, cells[wanted][:, 1:5], cells[wanted, 5]


def measure(name, voxels, make):
    start = seconds()
    try:
        points, tets, labels = make()
    except (ImportError, FileNotFoundError, subprocess.CalledProcessError) as reason:
        print(f"| {name} | {reason} |")
        return
    used = seconds() - start
    edges = points[tets][:, 1:] - points[tets][:, :1]
    volumes = np.linalg.det(edges) / 6
    lengths = sum(((points[tets[:, i]] - points[tets[:, j]]) ** 2).sum(1) for i in range(4) for j in range(i))
    quality = (12 * np.cbrt(3 * volumes) ** 2 * np.sign(volumes) / lengths).min()
    shares, distance = [], 0.
    for material in range(1, voxels.max() + 1):
        shares.append(volumes[labels == material].sum() / (voxels == material).sum())
        stairs, faces = stairs_of(voxels == material), faces_of(points, tets[labels == material])
        distance = max(distance, cKDTree(stairs).query(faces)[0].max(), cKDTree(faces).query(stairs)[0].max())
    print(f"| {name} | {len(tets):,} | {quality:.3f} | {' '.join(f'{share:.4f}' for share in shares)} | {distance:.2f} | "
          f"{used / (voxels > 0).sum() * 1e6:.0f} |", flush=True)


def stairs_of(inside):
    """Points on the faces of voxels where a material ends."""
    padded = np.pad(inside, 1)
    steps = np.linspace(-.5, .5, 5)
    found = []
    for axis in range(3):
        at = np.argwhere(np.diff(padded.astype(int), axis=axis)) - 1.
        at[:, axis] += .5
        for u in steps:
            for v in steps:
                found.append(at + np.insert([u, v], axis, 0.))
    return np.concatenate(found)[:, ::-1]


def faces_of(points, tets):
    """Points on the triangles of one cell."""
    faces = np.sort(np.concatenate([np.delete(tets, i, axis=1) for i in range(4)]), axis=1)
    faces, count = np.unique(faces, axis=0, return_counts=True)
    corners = points[faces[count == 1]]
    weights = [(i / 3, j / 3, (3 - i - j) / 3) for i in range(4) for j in range(4 - i)]
    return np.concatenate([np.einsum("c,ncx->nx", weight, corners) for weight in weights])


def main():
    voxels = scan(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
    print("| Way | tetrahedra | worst quality | volumes | distance | s per million voxels |\n|---|---|---|---|---|---|")
    for levels in (0, 1):
        measure(f"vtkSubdivisionLabelSolid, {levels} levels", voxels, lambda: this_filter(voxels, levels))
    measure("vtkSurfaceNets3D, tetgen", voxels, lambda: filled(voxels, nets))
    measure("vtkDiscreteFlyingEdges3D, vtkWindowedSincPolyDataFilter, tetgen", voxels, lambda: filled(voxels, contours))


if __name__ == "__main__":
    main()
