# SPDX-License-Identifier: BSD-3-Clause
"""States for ParaView, NAME.pvsm, and gallery_states.png, the pictures that they show.

    pvpython --force-offscreen-rendering states.py

makes them in the folder states (see demo.py for the environment that it needs); `./dev pictures` runs it after
guide_pictures.py. After a change, look at the picture, and copy the states to Documentation/Guide/states. They hold only
what differs from defaults, so they are short, and need no file: their control meshes are sources of ParaView and of the plugin.
"""

import os
import xml.etree.ElementTree as ElementTree

import demo
import gallery_surfaces
import numpy as np
import picture_files
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = "states"
# What a picture depends on; all else of these is as the client makes it.
KEPT = {"views": ("Representations", "ViewSize", "Camera", "CenterOfRotation", "Background", "UseColorPalette",
                  "OrientationAxesVisibility"),
        "representations": ("Input", "Representation", "ColorArrayName", "LookupTable", "ScalarOpacityFunction", "Position", "AmbientColor",
                            "ScalarOpacityUnitDistance", "InterpolationType", "Shade")}


# ---------------------------------------------------------------- what the states show

def show(source, colour=None, representation="Surface", at=(0, 0, 0)):
    """Shows a source, coloured by a point array, at another place."""
    source.UpdatePipeline()
    display = simple.Show(source, simple.GetActiveViewOrCreate("RenderView"))
    display.SetRepresentationType(representation)
    if colour:
        simple.ColorBy(display, ("POINTS", colour))
        display.RescaleTransferFunctionToDataRange(False, True)
    else:
        display.ColorArrayName = ["POINTS", ""]
    display.Position = at
    return display


def look(direction=(0.3, -1.0, 0.5), zoom=1.2):
    view = simple.GetActiveView()
    view.ViewSize = [1200, 800]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CameraPosition = direction
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)


def model(name):
    return simple.SubdivisionModel(Model=name)


def cut(source, name):
    """A clip of it, as demo.py cuts the model of this name."""
    source.UpdatePipeline()
    clip = simple.Clip(Input=source, ClipType="Plane")
    bounds = source.GetDataInformation().GetBounds()
    clip.ClipType.Origin = [(bounds[i] + bounds[i + 1]) / 2 for i in (0, 2, 4)]
    clip.ClipType.Normal = [-x for x in demo.VIEWS[name][1]]
    clip.Invert = 1
    return clip


def levels():
    """The control mesh, one level, and three."""
    ship = model("Ship")
    show(ship, representation="Surface With Edges")
    for column, count in enumerate((1, 3), 1):
        show(simple.MultidimensionalSubdivision(Input=ship, NumberOfLevels=count), at=(0, 0, -4 * column))
    look()


def cut_open():
    """A value that is smoothed inside, too."""
    name = "MixedDimensions"
    show(cut(simple.MultidimensionalSubdivision(Input=model(name), NumberOfLevels=3), name), "Tension")
    look(demo.VIEWS[name][0])


def volume():
    """Volume rendering of the solids."""
    name = "SpringAndValve"
    solids = simple.MultidimensionalSubdivision(Input=model(name), NumberOfLevels=2, OutputDimensions=["Tetrahedra"])
    show(solids, "Tension", "Volume")
    look(demo.VIEWS[name][0])


def materials():
    """Each material of a smooth object in a colour of its own, in volume rendering, and nothing outside."""
    name = "MaterialBlock"
    image = simple.SampleSmoothObject(Input=model(name), NumberOfSamples=200)
    show_materials(image)
    look((0.6, -1.0, 0.5))


def show_materials(image, colours=((0.45, 0.62, 0.88), (0.98, 0.66, 0.3), (0.45, 0.75, 0.4), (0.85, 0.35, 0.35))):
    """A colour for each value of Material; the least one, of the outside, is transparent. Values between those of two
    materials, which linear interpolation would make, would look like a third: so each pixel has that of the nearest
    sample."""
    display = show(image, "Material", "Volume")
    found = np.unique(vtk_to_numpy(servermanager.Fetch(image).GetPointData().GetArray("Material"))).tolist()
    steps = []
    for value, colour in zip(found, colours[:1] + colours):
        steps += [value - 0.49, *colour, value + 0.49, *colour]
    table = simple.GetColorTransferFunction("Material")
    table.RGBPoints, table.ColorSpace, table.ScalarRangeInitialized = steps, "RGB", 1
    opacity = simple.GetOpacityTransferFunction("Material")
    opacity.Points = [found[0], 0, 0.5, 0, found[0] + 0.4, 0, 0.5, 0, found[0] + 0.6, 1, 0.5, 0, found[-1], 1, 0.5, 0]
    display.LookupTable, display.ScalarOpacityFunction = table, opacity
    display.InterpolationType = "Nearest"
    display.Shade = 1
    display.ScalarOpacityUnitDistance = image.GetDataInformation().DataInformation.GetBounds()[1] / 100
    return display


def sharp_edges():
    """Creases where the control mesh has an angle above 30 degrees, and the rule of each point."""
    name = "MechanicalPart"
    part = simple.MultidimensionalSubdivision(Input=model(name), NumberOfLevels=3, FeatureAngle=30, GenerateClassification=1)
    show(part, "RuleDimension")
    look(demo.VIEWS[name][0])


def surface_schemes():
    """A box by seven schemes."""
    box = simple.ExtractSurface(Input=simple.UnstructuredCellTypes(CellType="Hex", BlocksDimensions=[1, 1, 1]))
    show(box, representation="Surface With Edges")
    for column, scheme in enumerate(gallery_surfaces.SCHEMES, 1):
        smooth = simple.SurfaceSubdivision(
            Input=box, Scheme=scheme, NumberOfLevels=gallery_surfaces.LEVELS.get(scheme, 4))
        show(smooth, at=(1.4 * (column % 4), 0, -1.4 * (column // 4)))
    look((0.1, -1.0, 0.25))


def refinement():
    """Small cells only where the shape is curved."""
    name = "Screw"
    refined = simple.RedGreenRefinement(
        Input=model(name), Shape="Smooth", RefineByAttributeError=0, RefineByGeometricError=1, MaximumLevel=6)
    show(refined, representation="Surface With Edges")
    look(demo.VIEWS[name][0])


def adaptive_surface():
    """The same for surfaces, by sqrt(3) subdivision."""
    name = "SpringAndValve"
    refined = simple.AdaptiveSurfaceSubdivision(
        Input=simple.ExtractSurface(Input=model(name)), RefineByAttributeError=0, RefineByGeometricError=1, MaximumLevel=20)
    show(refined, representation="Surface With Edges")
    look(demo.VIEWS[name][0])


def deformation():
    """A sphere in a cage that is twisted."""
    ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
    cage = simple.CageAround(Input=ball)
    turned = simple.Calculator(
        Input=cage, CoordinateResults=1,
        Function="coordsX*(1+0.6*coordsZ)*iHat + coordsY*(1-0.6*coordsZ)*jHat + (coordsZ+0.6*coordsX*coordsX)*kHat")
    show(simple.SubdivisionDeformation(Input=ball, RestMesh=cage, DeformedMesh=turned))
    show(turned, representation="Wireframe").AmbientColor = [0.0, 0.0, 0.0]
    look()


STATES = (levels, cut_open, volume, materials, sharp_edges, surface_schemes, refinement, adaptive_surface, deformation)


# ---------------------------------------------------------------- files

def is_kept(live, group, name):
    """Whether a property counts, and has another value than its default or names a proxy."""
    value = live.GetProperty(name)
    counts = value and name.startswith(KEPT.get(group, ""))
    return counts and (value.IsA("vtkSMProxyProperty") or not value.IsValueDefault())


def keep_changes(path):
    """Takes out of a state what has its default, and the proxies that its views do not need."""
    tree = ElementTree.parse(path)
    state = tree.getroot().find("ServerManagerState")
    session = servermanager.ActiveConnection.Session
    proxies = {proxy.get("id"): proxy for proxy in state.findall("Proxy")}
    wanted = [key for key, proxy in proxies.items() if proxy.get("group") == "views"]
    for key in wanted:
        proxy = proxies[key]
        live = session.GetRemoteObject(int(key))
        for element in list(proxy):
            if element.tag != "Property" or not is_kept(live, proxy.get("group"), element.get("name")):
                proxy.remove(element)
                continue
            for domain in element.findall("Domain"):
                element.remove(domain)
            wanted += [used.get("value") for used in element.findall("Proxy")
                       if used.get("value") in proxies and used.get("value") not in wanted]
    for key, proxy in proxies.items():
        if key not in wanted:
            state.remove(proxy)
    for collection in list(state):
        if collection.tag == "ProxyCollection":
            for item in list(collection):
                if item.get("id") not in wanted:
                    collection.remove(item)
        if collection.tag not in ("Proxy", "ProxyCollection") or collection.tag == "ProxyCollection" and not len(collection):
            state.remove(collection)
    ElementTree.indent(tree)
    tree.write(path)


def clear():
    """Deletes the sources and views of the state before."""
    for proxy in list(simple.GetSources().values()) + simple.GetViews():
        simple.Delete(proxy)


def draw():
    os.makedirs(FOLDER, exist_ok=True)
    images = []
    for build in STATES:
        clear()
        build()
        simple.Render()
        images.append(simple.GetActiveView().CaptureWindow(1))
        path = os.path.join(FOLDER, build.__name__ + ".pvsm")
        simple.SaveState(path)
        keep_changes(path)
    picture_files.write_figure(images, "gallery_states", 4)
    print(f"States are in {os.path.abspath(FOLDER)}.")


if __name__ == "__main__":
    demo.load_plugin()
    draw()
