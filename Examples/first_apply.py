# SPDX-License-Identifier: BSD-3-Clause
"""The first picture: what nothing but Apply makes of twelve meshes in the client, beside ParaView's own filters: gallery_first_apply.png.

    pvpython --force-offscreen-rendering first_apply.py [FOLDER]

Sources of ParaView, built-in models, and files of FOLDER. All options have their defaults, and as many
levels as the client begins with; ParaView's filter has as many."""

import os
import pathlib
import sys
import time

import demo_pictures as look
import picture_files
from paraview import simple
from side_by_side import output

SHAPES = [("Sphere", {}), ("Cylinder", {}), ("Box", {}), ("Superquadric", {}), ("Wavelet", {}), ("MechanicalPart", None)]
FILES = ["surf_bunny_full.vtp", "poly_cow_mixed.vtp", "surf_moebius_quads.vtp", "tet_gmsh_coil_crack.vtu", "hex_geos_box_hybrid.vtu",
         "mix_ogs5_fracture_network.vtu"]
PEERS = {"vtkPolyData": "LoopSubdivision", "vtkUnstructuredGrid": None}
OURS = {"vtkPolyData": "SurfaceSubdivision", "vtkUnstructuredGrid": "MultidimensionalSubdivision"}
LEVELS = {"LoopSubdivision": "NumberofSubdivisions", "SurfaceSubdivision": "NumberOfLevels",
          "MultidimensionalSubdivision": "NumberOfLevels"}


def make_source(name, options):
    if options is None:
        return simple.SubdivisionModel(Model=name)
    return getattr(simple, name)(**options)


def inputs(folder):
    """(name, source) of every mesh."""
    for name, options in SHAPES:
        yield name, make_source(name, options)
    for name in FILES:
        path = pathlib.Path(folder or "", name)
        if folder and path.exists():
            reader = simple.XMLPolyDataReader if path.suffix == ".vtp" else simple.XMLUnstructuredGridReader
            yield path.stem, reader(FileName=[os.fspath(path)])


def levels_of(name, source):
    """As many as the client begins with: 2 below a million cells. Cells that keep their types have as many children as
    simplices, so that 8,000 voxels begin with two levels, and with one where they are cut."""
    once = getattr(simple, name)(Input=source, NumberOfLevels=1)
    made = output(once)
    count = sum(2 ** made.GetCell(i).GetCellDimension() for i in range(made.GetNumberOfCells()))
    simple.Delete(once)
    return 2 if 0 < count < 1e6 else 1


def picture(source, caption):
    """As the client shows it after Apply."""
    view = simple.CreateRenderView(ViewSize=[800, 600], OrientationAxesVisibility=0)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    if source:
        simple.Show(source, view)
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(30)
    camera.Elevation(25)
    simple.ResetCamera(view)
    text = simple.Text(Text=caption)
    simple.Show(text, view).Color = list(look.INK)
    simple.Render(view)
    image = view.CaptureWindow(1)
    simple.Delete(text)
    simple.Delete(view)
    return image


def applied(name, source, **options):
    """A filter, and a caption."""
    proxy = getattr(simple, name)(Input=source, **options)
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    return proxy, f"{proxy.GetXMLLabel()}: {output(proxy).GetNumberOfCells():,} cells, {seconds:.2f} s"


def draw(folder=None):
    simple.LoadPlugin(os.environ["SUBDIVISIONOBJECTS_PLUGIN"], remote=False, ns=vars(simple))
    rows = []
    for name, source in inputs(folder):
        data = output(source)
        kind = data.GetClassName()
        rows.append([picture(source, f"{name}: {data.GetNumberOfCells():,} cells")])
        ours = OURS.get(kind, OURS["vtkUnstructuredGrid"])
        levels = levels_of(ours, source)
        for made in (PEERS.get(kind), ours):
            if made:
                rows[-1].append(picture(*applied(made, source, **{LEVELS[made]: levels})))
            else:
                rows[-1].append(picture(None, "ParaView has no filter of its own for it"))
        if name == "surf_bunny_full":
            draw_bunny(source)
    picture_files.write_figure([image for row in rows for image in row], "gallery_first_apply", 6)


def draw_bunny(source):
    """The whole bunny by three levels, in both: gallery_bunny.png."""
    images = [picture(*applied(name, source, **{levels: 3}))
              for name, levels in (("LoopSubdivision", "NumberofSubdivisions"), ("SurfaceSubdivision", "NumberOfLevels"))]
    picture_files.write_figure(images, "gallery_bunny", 2)


if __name__ == "__main__":
    draw(*sys.argv[1:])
