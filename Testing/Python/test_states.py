# SPDX-License-Identifier: BSD-3-Clause
"""The states of the guide open in ParaView, and each shows a picture."""

import pathlib
import sys
import unittest

import numpy as np
import tools
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Documentation/Guide/states"
SHOWN = 0.03  # of the pixels, at least


def loaded(state):
    simple.ResetSession()
    simple.LoadPlugin(tools.plugin, remote=False, ns=vars(simple))
    simple.LoadState(str(state))
    return simple.GetViews()


def pixels(view):
    view.ViewSize = [300, 200]
    simple.Render(view)
    return vtk_to_numpy(view.CaptureWindow(1).GetPointData().GetScalars())


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

    def test_they_are_the_states_of_the_script(self):
        sys.path.insert(0, str(ROOT / "Examples"))
        import states
        self.assertEqual({build.__name__ for build in states.STATES}, {state.stem for state in FOLDER.glob("*.pvsm")})


if __name__ == "__main__":
    tools.main()
