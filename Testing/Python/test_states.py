# SPDX-License-Identifier: BSD-3-Clause
"""The states of the guide open in ParaView, and each shows a picture; also as version 0.1 would have written them."""

import pathlib
import re
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Documentation/Guide/states"
SHOWN = 0.03  # of the pixels, at least
# Properties that version 0.1 did not have, and those of Surface Subdivision that it had in their places: with values, as files
# have them. An angle array has another name and number now, and is not taken.
LATER = {"BezierTolerance", "CellOrder", "CloseHangingNodes", "CornerAngleArray", "GenerateErrorBounds", "JoinSides", "LoopWeights",
         "MergePoints", "MergeTolerance", "MergedValues", "ModifiedBoundary", "NextApply", "OutputCells", "Preset", "SmoothShading",
         "SplitSharpEdges"}
FORMER = {"Adaptive": ["0"], "AngleArray": ["5", "", "", "0", "Angles"], "GenerateNormals": []}


def loaded(state):
    simple.ResetSession()
    simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
    simple.LoadState(str(state))
    return simple.GetViews()


def pixels(view):
    view.ViewSize = [300, 200]
    simple.Render(view)
    return vtk_to_numpy(view.CaptureWindow(1).GetPointData().GetScalars())


def write_as_of_0_1(state):
    """Gives a state the names that version 0.1 had, without the labels that were not there; how many others it had."""
    tree = ElementTree.parse(state)
    changed = 0
    for proxy in tree.iter("Proxy"):
        if "Subdivision" not in proxy.get("type", "") and proxy.get("type") != "RedGreenRefinement":
            continue
        for element in proxy.findall("Property"):
            if element.get("name") in LATER:
                proxy.remove(element)
                changed += 1
            for domain in element.findall("Domain"):
                element.remove(domain)
        for name, values in FORMER.items() if proxy.get("type") == "SurfaceSubdivision" else ():
            former = ElementTree.SubElement(proxy, "Property", name=name, id=f"{proxy.get('id')}.{name}",
                                            number_of_elements=str(len(values)))
            for i, value in enumerate(values):
                ElementTree.SubElement(former, "Element", index=str(i), value=value)
    tree.write(state)
    return changed


def made():
    """What each filter and source of the plugin makes."""
    found = []
    for (name, _), source in sorted(simple.GetSources().items()):
        if not re.search("Subdivision|RedGreen", source.GetXMLName()):
            continue
        source.UpdatePipeline()
        mesh = tools.output(source)
        found.append((name, mesh.GetNumberOfPoints(), mesh.GetNumberOfCells(), mesh.GetBounds()))
    return found


class States(unittest.TestCase):
    def test_each_shows_a_picture(self):
        for state in sorted(FOLDER.glob("*.pvsm")):
            with self.subTest(state.name):
                views = loaded(state)
                self.assertEqual(len(views), 1)
                found = pixels(views[0])
                self.assertGreater(np.mean(np.any(found != 255, axis=1)), SHOWN)
                for source in simple.GetSources().values():
                    source.UpdatePipeline()
                    self.assertGreater(tools.output(source).GetNumberOfCells(), 0)

    def test_states_of_version_0_1_open(self):
        for state in sorted(FOLDER.glob("*.pvsm")):
            with self.subTest(state.name), tempfile.TemporaryDirectory() as folder:
                older = pathlib.Path(folder) / state.name
                loaded(state)
                shapes = [made()]
                simple.SaveState(str(older))  # with all properties
                changed = write_as_of_0_1(older)
                self.assertGreater(changed, 3)
                loaded(older)
                shapes.append(made())
                self.assertEqual(*shapes)

    def test_they_are_the_states_of_the_script(self):
        sys.path.insert(0, str(ROOT / "Examples"))
        import states
        self.assertEqual({build.__name__ for build in states.STATES}, {state.stem for state in FOLDER.glob("*.pvsm")})


if __name__ == "__main__":
    tools.main()
