# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the built-in control meshes, or of a file of yours, and what subdivision makes of them.

    ./dev demo                      all the built-in models, three levels each
    ./dev demo FILE [LEVELS]        a .vtu or .vtp file

`./dev demo` builds the plugin, then runs this script with ParaView's pvpython in build/demo, where
it writes its files: four pictures of each model (control mesh; subdivided; cut open and coloured by a
point array; cut open and coloured by RuleDimension), both meshes as .vtu, and one contact sheet.
After the built-in models it goes on with gallery.py, which shows the features, gallery_surfaces.py,
deformation.py, refinement.py and adaptive_surfaces.py. What these draw is there twice, the small ones in the folder
guide; `./dev pictures` runs guide_pictures.py, too.
By hand:

    SUBDIVISIONOBJECTS_PLUGIN=<folder>/SubdivisionObjects.so pvpython --force-offscreen-rendering demo.py

LEVELS is by default the largest number up to 3 that stays below 20 million cells.
"""

import os
import pathlib
import sys
import time

import adaptive_surfaces
import deformation
import demo_pictures
import gallery
import gallery_surfaces
import picture_files
import refinement
from paraview import servermanager, simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

LEVELS = 3
MAXIMUM_NUMBER_OF_CELLS = 20_000_000

# Where the camera stands, as seen from the model, and the direction from which it is cut open.
VIEWS = {
    "MixedDimensions": ((0.55, -1.0, 0.55), (0.2, -1.0, 0.0)),
    "Screw": ((0.5, -1.0, 0.35), (0.1, -1.0, 0.0)),
    "SpringAndValve": ((0.6, -1.0, 0.25), (0.1, -1.0, 0.0)),
    "Ship": ((0.7, -1.0, 0.5), (0.0, -1.0, 0.0)),
    "MechanicalPart": ((-0.45, -1.0, 0.75), (0.0, -1.0, 0.0)),
    "Character": ((0.35, -1.0, 0.2), (0.1, -1.0, 0.0)),
    "MaterialBlock": ((0.7, -1.0, 0.5), (0.0, -1.0, 0.0)),
    "Cylinder": ((0.6, -1.0, 0.6), (0.15, -1.0, 0.0)),
}
README_MODELS = ("MixedDimensions", "SpringAndValve", "Ship", "MechanicalPart")
DEFAULT_VIEW = ((0.6, -1.0, 0.5), (0.15, -1.0, 0.0))


def load_plugin():
    plugin = os.environ.get("SUBDIVISIONOBJECTS_PLUGIN")
    if not plugin:
        root = pathlib.Path(__file__).resolve().parent.parent
        plugin = next(map(str, root.glob("build/**/SubdivisionObjects.so")), None)
    if not plugin or not os.path.isfile(plugin):
        sys.exit("demo: the plugin is not built; ./dev demo does it, or name it in SUBDIVISIONOBJECTS_PLUGIN")
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))


def open_file(name):
    """The reader of a file, or the end of the program with a message that says what is wrong."""
    readers = {".vtu": simple.XMLUnstructuredGridReader, ".vtp": simple.XMLPolyDataReader}
    reader = readers.get(os.path.splitext(name)[1].lower())
    if not os.path.isfile(name):
        sys.exit(f"demo: there is no file {name}")
    if not reader:
        sys.exit(f"demo: {name} is neither .vtu nor .vtp; open it in ParaView and save it as one of these")
    source = reader(FileName=[name], TimeArray="None")
    source.UpdatePipeline()
    data = source.GetClientSideObject().GetOutputDataObject(0)
    if data is None or data.GetNumberOfCells() == 0:
        reason = ""
        if b"<AppendedData" in pathlib.Path(name).read_bytes():
            reason = ("; it has appended data, which ParaView 5.11 cannot read on an up-to-date Debian 12:"
                      " save it with Data Mode 'Binary' instead of 'Appended'")
        sys.exit(f"demo: {name} has no cells, or is no valid {os.path.splitext(name)[1]} file{reason}")
    return source


def cells_after(grid, levels):
    """How many cells `levels` steps make of a grid, about: of a pyramid they make a half more."""
    counts = demo_pictures.count_by_dimension(grid)
    return sum(count * 2 ** (dimension * levels) for dimension, count in enumerate(counts))


def choose_levels(name, grid):
    levels = LEVELS
    while levels > 0 and cells_after(grid, levels) >= MAXIMUM_NUMBER_OF_CELLS:
        levels -= 1
    reason = "the default"
    if levels < LEVELS:
        more = cells_after(grid, levels + 1)
        reason = f"{levels + 1} would make {more:,} cells, the limit here is {MAXIMUM_NUMBER_OF_CELLS:,}"
    print(f"{name}: {levels} level{'s' * (levels != 1)} ({reason}; another number can be given after the file)")
    return levels


def subdivide(source, levels):
    """The output, and the seconds that the filter took."""
    subdivision = simple.MultidimensionalSubdivision(
        Input=source, NumberOfLevels=levels, GenerateClassification=1)
    start = time.perf_counter()
    subdivision.UpdatePipeline()
    seconds = time.perf_counter() - start
    return subdivision.GetClientSideObject().GetOutputDataObject(0), seconds


def write_grid(grid, file_name):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(file_name)
    writer.SetDataModeToBinary()  # appended data are what ParaView 5.11 cannot read on all systems
    writer.SetCompressorTypeToLZ4()
    if not writer.Write():
        sys.exit(f"demo: cannot write {os.path.abspath(file_name)}")


def show(name, source, levels):
    """Everything for one model. Returns its pictures, as images at half their size and to draw others, and the line
    to print about it."""
    control, _ = subdivide(source, 0)  # the control cells
    if control.GetNumberOfCells() == 0:
        sys.exit(f"demo: {name} has no cell that can be subdivided")
    if levels is None:
        levels = choose_levels(name, control)
    smooth, seconds = subdivide(source, levels)
    if smooth.GetNumberOfCells() == 0:
        sys.exit(f"demo: {name} was not subdivided, see above")
    write_grid(control, f"{name}_control.vtu")
    write_grid(smooth, f"{name}_level{levels}.vtu")
    pictures = demo_pictures.ModelPictures(name, control, smooth, levels, *VIEWS.get(name, DEFAULT_VIEW))
    images = []
    for what, image in pictures.draw():
        picture_files.write_png(image, f"{name}_{what}.png")
        images.append(picture_files.halved(image))
    given = source.GetClientSideObject().GetOutputDataObject(0)
    line = (f"{name:<26} {given.GetNumberOfCells():>9,} cells {given.GetNumberOfPoints():>9,} points"
            f" -> {smooth.GetNumberOfCells():>11,} cells {smooth.GetNumberOfPoints():>10,} points"
            f"  {levels} level{'s' if levels != 1 else ' '}  {seconds:7.3f} s")
    return images, pictures, line


def built_in_models():
    names = simple.SubdivisionModel().GetProperty("Model").Available
    return [(name, simple.SubdivisionModel(Model=name)) for name in names]


def main(arguments):
    if len(arguments) > 2 or "-h" in arguments or "--help" in arguments:
        sys.exit("usage: ./dev demo [FILE [LEVELS]]")
    levels = LEVELS
    if arguments:
        levels = None
        if len(arguments) == 2:
            if not arguments[1].isdecimal() or int(arguments[1]) > 20:
                sys.exit(f"demo: LEVELS is a number from 0 to 20, not {arguments[1]}")
            levels = int(arguments[1])
    load_plugin()
    models = built_in_models()
    if arguments:
        models = [(pathlib.Path(arguments[0]).stem, open_file(arguments[0]))]
    rows, for_readme = [], []
    for name, source in models:
        images, pictures, line = show(name, source, levels)
        print(line, flush=True)
        rows.append(images)
        if name in README_MODELS:
            for_readme.append(pictures)
    sheet = "contact_sheet.png" if not arguments else f"{models[0][0]}_contact_sheet.png"
    picture_files.write_png(picture_files.contact_sheet(rows), sheet)
    if not arguments:
        sheet_for_readme = picture_files.halved(demo_pictures.table_for_readme(for_readme))
        picture_files.write_png(sheet_for_readme, "gallery.png")  # Documentation/gallery.png
    print(f"Pictures and meshes are in {os.getcwd()}; look at {sheet} first.")
    if not arguments:
        gallery.draw()
        gallery_surfaces.draw()
        deformation.draw()
        refinement.draw()
        adaptive_surfaces.draw()


if __name__ == "__main__":
    main(sys.argv[1:])
